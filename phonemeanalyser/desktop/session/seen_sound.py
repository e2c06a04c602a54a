"""The sound that is seen on its own time: what is seen and selected of it, and all that is found in it whole."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.seen_tracks import FeelingTrack, FormantTrack, WaveformTrack
from phonemeanalyser.desktop.session.sonagram_tiles import SonagramTiles
from phonemeanalyser.desktop.session.time_view import TimeView
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.audio.files import SoundReader
from phonemeengine.execution import Progress
from phonemeengine.inspection import whole_sound
from phonemeengine.inspection.whole_sound import FrameRange
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, Channel

MOST_AT_ONCE = 1_000_000
"""Frames of a file that the window itself recognises anew: more take longer than a picture may."""


class WholeFile(QObject):
    """Has all of a file analysed with the preset in force; another preset begins anew, and shows the old meanwhile.

    Signals
    -------
    changed : more of it is known, or another file is open.
    error : a sentence for the user.

    Attributes
    ----------
    tracks : what is known of the file; None where there is none.
    preset : with which that is, or will be, found; None where there is none.
    in_view : the frames that are in view, which are found first.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.tracks: whole_sound.SoundTracks | None = None
        self.preset: Preset | None = None
        self.in_view = whole_sound.FrameRange(0, 0)
        self._open: Callable[[], SoundReader] | None = None
        self._complete = False
        self._again: whole_sound.RetunedSound | None = None
        self._work = TaskQueue(self.error.emit)
        self._work.changed.connect(self.changed)

    @property
    def busy(self) -> bool:
        """Whether it is not all known yet."""
        return self._work.busy

    def open(self, reader: SoundReader, preset: Preset) -> None:
        """Analyse another file, whose reader is left where it is."""
        path, channel = reader.path, reader.channel
        self._open = lambda: SoundReader(path, channel)
        self.tracks = whole_sound.tracks_of(reader)
        self._forget()
        self.use_preset(preset)

    def follow(self, other: "WholeFile", preset: Preset) -> None:
        """Analyse the file that another one has open, with a preset of its own."""
        if self._open is not other._open:
            self._open = other._open
            self._forget()
            self.tracks = None if other.tracks is None else whole_sound.SoundTracks(other.tracks.n_frames)
        self.use_preset(preset)

    def leave(self) -> None:
        """Know nothing any more: another source is open."""
        self._work.cancel()
        self._forget()
        self.tracks = self._open = None
        self.changed.emit()

    def use_preset(self, preset: Preset) -> None:
        """Analyse the file with another preset; what is known completely is not found again."""
        tracks, open_sound = self.tracks, self._open
        if tracks is None or open_sound is None or (preset == self.preset and (self._complete or self.busy)):
            return
        if self._complete and not self.busy and self._retuned(tracks, preset):
            return
        self.preset, self._complete, self._again = preset, False, None

        def analyse(progress: Progress) -> None:
            whole_sound.analyse_whole(open_sound, preset, tracks, in_view=lambda: self.in_view, progress=progress)

        self._work.replace(analyse, lambda _: setattr(self, "_complete", True))

    def _forget(self) -> None:
        """Take the current file for unknown."""
        self.preset, self._complete, self._again = None, False, None

    def _retuned(self, tracks: whole_sound.SoundTracks, preset: Preset) -> bool:
        """Recognise a file that is known whole anew without its sound, where the preset measures alike."""
        assert self.preset is not None
        if tracks.n_frames > MOST_AT_ONCE:
            return False
        if self._again is None:
            self._again = whole_sound.RetunedSound(tracks, self.preset)
        if not self._again.retune(preset):
            return False
        self.preset = preset
        self.changed.emit()
        return True

    def exchange(self, other: "WholeFile") -> None:
        """Know what another one knows of the same file, and have it know what this one knew."""
        for one in (self, other):
            one._complete = one._complete and not one.busy
            one._work.cancel()
        self.tracks, other.tracks = other.tracks, self.tracks
        self.preset, other.preset = other.preset, self.preset
        self._complete, other._complete = other._complete, self._complete
        self._again, other._again = other._again, self._again
        self._open = other._open = self._open or other._open
        for one in (self, other):
            if one.preset is not None:
                one.use_preset(one.preset)
            one.changed.emit()

    def close(self) -> None:
        """End all work."""
        self._work.close(CLOSE_TIMEOUT)


class SecondPreset(QObject):
    """What the one of A and B that is not in use recognises in the file.

    Signals
    -------
    changed : there is another one, or none; or the two changed places.
    """

    changed = Signal()

    def __init__(self, preset: PresetModel, whole: WholeFile) -> None:
        super().__init__()
        self.whole = WholeFile()
        self._preset, self._used = preset, whole
        self._letter = preset.letter
        preset.sides_changed.connect(self._follow_sides)

    @property
    def is_there(self) -> bool:
        """Whether there is a second preset."""
        return self._preset.other is not None

    @property
    def names(self) -> tuple[str, ...]:
        """The letters and names of both presets, A first."""
        return tuple(f"{letter}: {preset.name}" for letter, preset in self._preset.sides.items())

    def follow(self) -> None:
        """Analyse the current file with the one that is not in use."""
        if self._preset.other is None:
            self.whole.leave()
        else:
            self.whole.in_view = self._used.in_view
            self.whole.follow(self._used, self._preset.other.preset)

    def share_of_difference(self, frames: whole_sound.FrameRange) -> float | None:
        """Return the share of some frames in which the two differ; None without a second preset."""
        one, other = self._used.tracks, self.whole.tracks
        if not self.is_there or one is None or other is None:
            return None
        return whole_sound.difference_in(one, other, frames).share

    def close(self) -> None:
        """End all work."""
        self.whole.close()

    def _follow_sides(self) -> None:
        if self._letter != self._preset.letter and self.is_there:
            self._used.exchange(self.whole)
        self._letter = self._preset.letter
        self.follow()
        self.changed.emit()


class SeenSound(QObject):
    """Has a file, or a microphone's recording so far, measured in the background for the views.

    Signals
    -------
    looked_back : the microphone's recording is looked at, or no longer.
    error : a sentence for the user.

    Attributes
    ----------
    sound : the file, and which channel of it; None where there is none.
    looks_back : whether that is the microphone's recording.
    view : what is seen and selected.
    whole : what is recognised in it.
    second : what the one of A and B that is not in use recognises.
    sonagram, formants, waveform, feelings : what is drawn of it.
    sonagram_is_filtered : whether the sonagram is drawn as it is after the filters that are on.
    """

    looked_back = Signal()
    error = Signal(str)

    def __init__(self, preset: PresetModel) -> None:
        super().__init__()
        self.sound: tuple[Path, Channel] | None = None
        self.looks_back = self.sonagram_is_filtered = False
        self.view, self.whole = TimeView(), WholeFile()
        self.sonagram, self.formants, self.waveform = SonagramTiles(), FormantTrack(), WaveformTrack()
        self.second = SecondPreset(preset, self.whole)
        self.feelings = FeelingTrack()
        self._preset = preset
        self._tracks = self.sonagram, self.formants, self.waveform, self.feelings
        for model in (self.whole, self.second.whole, *self._tracks):
            model.error.connect(self.error)
        self.view.moved.connect(self._look)

    @property
    def busy(self) -> bool:
        """Whether more is being found or measured."""
        return any(model.busy for model in (self.whole, self.second.whole, *self._tracks))

    def open(self, sound: SoundReader, *, looks_back: bool = False) -> None:
        """Have another sound seen, whose reader is left where it is."""
        self.sound, self.looks_back = (sound.path, sound.channel), looks_back
        self.view.open(sound.duration)
        for track in self._tracks:
            track.open(partial(SoundReader, *self.sound), sound.duration)
        self.whole.open(sound, self._preset.in_force)
        self.second.follow()
        self._look()
        if looks_back:
            self.view.show_end()
            self.looked_back.emit()

    def leave(self) -> None:
        """Have nothing seen any more."""
        looked_back, self.looks_back, self.sound = self.looks_back, False, None
        for model in (self.whole, self.second.whole, *self._tracks):
            model.leave()
        self.view.open(0.0)
        if looked_back:
            self.looked_back.emit()

    def show_filtered(self, on: bool) -> None:
        """Show the sonagram as it is after the filters that are on, or as it is in the file."""
        self.sonagram_is_filtered = on
        self.sonagram.show_filtered(self._preset.in_force.settings if on else None)

    def use_preset(self) -> None:
        """Find everything with the preset that is in force now."""
        self.whole.use_preset(self._preset.in_force)
        self.second.follow()
        self.show_filtered(self.sonagram_is_filtered)

    def close(self) -> None:
        """End all work."""
        for model in (self.whole, self.second, *self._tracks):
            model.close()

    def _look(self) -> None:
        """Have what is seen found first."""
        start, end = (round(time / FRAME_PERIOD) for time in self.view.seen)
        self.whole.in_view = self.second.whole.in_view = FrameRange(start, end)
