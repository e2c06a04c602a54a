"""A second preset in memory: it hears the file in hand too, and takes the place of the first at a key."""

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.whole_file import WholeFile
from phonemeengine.errors import EngineError
from phonemeengine.inspection.preset_difference import difference_in
from phonemeengine.inspection.whole_sound import FrameRange
from phonemeengine.presets.files import load_preset
from phonemeengine.presets.preset import Preset

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
