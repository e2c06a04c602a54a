"""The preset in the tool bar: which one is in use, A or B, and all others a click or a key away."""

from collections.abc import Callable
from html import escape
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QSizePolicy
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeanalyser.desktop.widgets.preset_picker import PresetPicker, Sections
from phonemeengine.presets.files import PresetEntry
from phonemeengine.recognition.spec import BUILT_IN, recogniser_names

WIDTH = 170
_RECOGNISER = Path("recogniser")
"""Stands before the name of a recogniser of another package, as if that were a file."""


class PresetBox(PresetPicker):
    """Shows the preset in use, and lists the others, and the recognisers that other packages bring.

    Parameters
    ----------
    preset : the presets A and B.
    sections, files : as of `PresetPicker`.

    Signals
    -------
    recogniser_chosen : name of the recogniser of another package that the user wants.
    """

    recogniser_chosen = Signal(str)

    def __init__(self, preset: PresetModel, sections: Callable[[], Sections], files: FileAsker) -> None:
        super().__init__(lambda: {**sections(), tr("Recognisers of other packages"): _of_packages()}, files)
        self._preset = preset
        self.setFixedWidth(WIDTH)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.list.as_other.show()
        for signal in (preset.changed, preset.file_changed, preset.sides_changed):
            signal.connect(self._show_preset)
        self._show_preset()

    @override
    def _marks(self) -> dict[Path, str]:
        here, other = self._preset.document, self._preset.other
        if other is None:
            return {here.path.resolve(): "✓"}
        marks = {other.path.resolve(): self._preset.other_letter}
        mine = marks.get(here.path.resolve(), "")
        return {**marks, here.path.resolve(): "".join(sorted(f"{mine}{self._preset.letter}"))}

    @override
    def _take(self, value: Path | str | None, other: bool) -> None:
        if isinstance(value, Path) and value.parent == _RECOGNISER:
            self.recogniser_chosen.emit(value.name)
        else:
            super()._take(value, other)

    def _show_preset(self) -> None:
        preset, other = self._preset.preset, self._preset.other
        mark = "*" if self._preset.has_unsaved_changes else ""
        self.show_name(f"{self._preset.title}{mark}")
        changed = ", " + tr("unsaved changes") if mark else ""
        told = [
            f"{tr('Preset')} <b>{escape(self._preset.title)}</b>{changed}. {escape(tr_engine(preset.summary))}",
            escape(str(self._preset.path)),
        ]
        if other is not None:
            words = tr("{letter}: {preset}; X uses it")
            told.append(escape(words.format(letter=self._preset.other_letter, preset=other.preset.name)))
        self.setToolTip("".join(f"<p>{words}</p>" for words in told))
        as_other = tr("Set as {letter}").format(letter=self._preset.other_letter)
        self.list.as_other.setText(as_other)
        self.list.as_other.setToolTip(tr("Compare the marked preset with the one in use (Ctrl+Return)"))


def _of_packages() -> tuple[PresetEntry, ...]:
    names = (name for name in recogniser_names() if name not in BUILT_IN)
    return tuple(PresetEntry(_RECOGNISER / name, name, "") for name in names)
