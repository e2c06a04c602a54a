"""The sound that is seen on its own time: what is seen and selected of it, and all that is found in it whole."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.seen_tracks import FeelingTrack, FormantTrack, WaveformTrack
from phonemeanalyser.desktop.session.sonagram_tiles import SonagramTiles
from phonemeanalyser.desktop.session.time_view import TimeView
from phonemeanalyser.desktop.session.whole_file import SecondPreset, WholeFile
from phonemeengine.audio.files import SoundReader
from phonemeengine.inspection.whole_sound import FrameRange
from phonemeengine.settings import FRAME_PERIOD, Channel


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
