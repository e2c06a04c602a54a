"""The box of presets in the tool bar: which one is in use, and all others a click away."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QPushButton, QSizePolicy

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeengine.presets.files import PresetEntry

WIDTH = 150
Sections = dict[str, tuple[PresetEntry, ...]]


class PresetBox(QPushButton):
    """Shows the preset in use, and opens a menu of the others, with a line that says what each is.

    Parameters
    ----------
    preset : the preset in use.
    sections : gives the presets to choose from, by heading; asked whenever the menu opens.

    Signals
    -------
    chosen : path of the preset that the user wants.
    """

    chosen = Signal(Path)

    def __init__(self, preset: PresetModel, sections: Callable[[], Sections]) -> None:
        super().__init__()
        self._preset = preset
        self._sections = sections
        self._commands: list[QAction] = []
        menu = QMenu(self)
        menu.setToolTipsVisible(True)
        menu.aboutToShow.connect(self._fill)
        self.setMenu(menu)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setFixedWidth(WIDTH)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(tr("preset"))
        preset.changed.connect(self._show_preset)
        preset.file_changed.connect(self._show_preset)
        self._show_preset()

    def add_commands(self, *commands: QAction) -> None:
        """Let the menu end with these, such as Save As."""
        self._commands = list(commands)

    def _fill(self) -> None:
        menu = self.menu()
        menu.clear()
        for heading, entries in self._sections().items():
            if entries:
                menu.addSection(heading)
            for entry in entries:
                self._add(menu, entry)
        menu.addSeparator()
        menu.addActions(self._commands)

    def _add(self, menu: QMenu, entry: PresetEntry) -> None:
        text = f"{entry.name}:  {tr(entry.summary)}" if entry.summary else entry.name
        action = menu.addAction(text.replace("&", "&&"), partial(self.chosen.emit, entry.path))
        action.setToolTip(str(entry.path))
        action.setCheckable(True)
        action.setChecked(entry.path == self._preset.path.resolve())

    def _show_preset(self) -> None:
        preset = self._preset.preset
        mark = "*" if self._preset.has_unsaved_changes else ""
        room = WIDTH - 30
        name = self.fontMetrics().elidedText(preset.name + mark, Qt.TextElideMode.ElideMiddle, room)
        self.setText(name.replace("&", "&&"))
        changed = ", " + tr("changed since it was saved") if mark else ""
        self.setToolTip(
            f"<p>{tr('Preset')} <b>{preset.name}</b>{changed}. {tr(preset.summary)}</p><p>{self._preset.path}</p>"
        )
