"""The file in hand, analysed whole in the background while it may be played; by a second preset, too."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import EngineError
from phonemeengine.execution import Progress
from phonemeengine.inspection.whole_sound import (
    FrameRange,
    RetunedSound,
    SoundTracks,
    analyse_whole,
    difference_in,
    tracks_of,
)
from phonemeengine.presets.files import load_preset
from phonemeengine.presets.preset import Preset

MOST_AT_ONCE = 1_000_000
"""Frames of a file that the window itself recognises anew: more take longer than a picture may."""


class WholeFile(QObject):
    """Has all of a file analysed with the preset in force; another preset begins anew, and shows the old meanwhile.

    Signals
    -------
    changed : more of it is known, or another file is in hand.
    error : a sentence for the user.

    Attributes
    ----------
    tracks : what is known of the file; None where there is none.
    preset : with which that is, or will be, found; None where there is none.
    in_view : the frames that somebody looks at, which are found first.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.tracks: SoundTracks | None = None
        self.preset: Preset | None = None
        self.in_view = FrameRange(0, 0)
        self._open: Callable[[], SoundReader] | None = None
        self._complete = False
        self._again: RetunedSound | None = None
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
        self.tracks = tracks_of(reader)
        self._forget()
        self.use_preset(preset)

    def follow(self, other: "WholeFile", preset: Preset) -> None:
        """Analyse the file that another one has in hand, with a preset of its own."""
        if self._open is not other._open:
            self._open = other._open
            self._forget()
            self.tracks = None if other.tracks is None else SoundTracks(other.tracks.n_frames)
        self.use_preset(preset)

    def leave(self) -> None:
        """Know nothing any more: another source is in hand."""
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
            analyse_whole(open_sound, preset, tracks, in_view=lambda: self.in_view, progress=progress)

        self._work.replace(analyse, lambda _: setattr(self, "_complete", True))

    def _forget(self) -> None:
        """Take what is in hand for unknown."""
        self.preset, self._complete, self._again = None, False, None

    def _retuned(self, tracks: SoundTracks, preset: Preset) -> bool:
        """Recognise a file that is known whole anew without its sound, where the preset measures alike."""
        assert self.preset is not None
        if tracks.n_frames > MOST_AT_ONCE:
            return False
        if self._again is None:
            self._again = RetunedSound(tracks, self.preset)
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


NO_SECOND = tr_noop("There is no second preset yet; choose one by Analysis > Second Preset.")


class SecondPreset(QObject):
    """Holds a preset beside the one in use, and what it hears in the file.

    Signals
    -------
    changed : another preset, or none; or the two changed places.
    error : a sentence for the user.

    Attributes
    ----------
    preset : the second one; None for none.
    is_in_force : whether it is heard in place of the first.
    whole : what the one of the two that is not in force hears in the file.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, first: PresetModel, whole: WholeFile) -> None:
        super().__init__()
        self.preset: Preset | None = None
        self.is_in_force = False
        self.whole = WholeFile()
        self._first, self._heard = first, whole
        first.loaded.connect(self._end)
        self.whole.error.connect(self.error)

    @property
    def names(self) -> tuple[str, str]:
        """The names of the preset that is heard and of the other one; empty without a second."""
        if self.preset is None:
            return "", ""
        first, second = self._first.preset.name, self.preset.name
        return (second, first) if self.is_in_force else (first, second)

    def load(self, path: Path) -> None:
        """Take a preset's file as the second one; one that cannot be read leaves all as it was."""
        try:
            self.take(load_preset(path))
        except EngineError as error:
            self.error.emit(str(error))

    def take(self, preset: Preset | None) -> None:
        """Take a preset as the second one; None for none."""
        self._end()
        self.preset = preset
        self.follow()
        self.changed.emit()

    def switch(self, on: bool) -> None:
        """Hear with the second preset, or with the first again."""
        if self.preset is None:
            if on:
                self.error.emit(tr(NO_SECOND))
            self.changed.emit()
        elif on is not self.is_in_force:
            self.is_in_force = on
            self._heard.exchange(self.whole)
            self._first.try_out(self.preset if on else None)
            self.changed.emit()

    def follow(self) -> None:
        """Hear the file in hand with the one that is not in force."""
        other = self._first.preset if self.is_in_force else self.preset
        if other is None:
            self.whole.leave()
        else:
            self.whole.in_view = self._heard.in_view
            self.whole.follow(self._heard, other)

    def share_of_difference(self, frames: FrameRange) -> float | None:
        """Return the share of some frames in which the two hear two things; None without a second preset."""
        one, other = self._heard.tracks, self.whole.tracks
        if self.preset is None or one is None or other is None:
            return None
        return difference_in(one, other, frames).share

    def close(self) -> None:
        """End all work."""
        self.whole.close()

    def _end(self) -> None:
        """Hear with the first preset again."""
        if self.is_in_force:
            self.switch(False)
