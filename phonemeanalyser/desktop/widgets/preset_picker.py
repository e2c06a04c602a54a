"""The list of presets, the same wherever one is chosen: one line for each, searched by typing."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from PySide6 import QtWidgets
from PySide6.QtCore import QEvent, QObject, QPoint, QSize, Qt, Signal
from PySide6.QtGui import QAction, QKeyEvent
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.widgets.builders import column, named, row, tab_buttons, tool_button
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeengine.presets.files import PRESET_SUFFIXES, PresetEntry

WIDTH, LEAST_HEIGHT, MOST_HEIGHT = 940, 220, 460
"""Of the list, pixels, where the screen has room."""
LEAST_WIDTH = 150
OPEN = "open"
"""Stands for a file that the user chooses."""
_VALUE = Qt.ItemDataRole.UserRole
_MOVING = {Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown}
_TAKING = {Qt.Key.Key_Return, Qt.Key.Key_Enter}
CURRENT = tr_noop("{preset} (current settings)")

Sections = Mapping[str, Sequence[PresetEntry]]


class PresetList(QtWidgets.QFrame):
    """A window with all presets below a field in which one types what is searched.

    Return, or a click, chooses the marked line; Ctrl+Return chooses it as the other one of A and B; Escape closes.

    Signals
    -------
    chosen : what a line stands for, and whether it is to be the other one of A and B.

    Attributes
    ----------
    search, entries : the field and the lines.
    as_other : a button that does what Ctrl+Return does.
    for_other : whether Return means the other one of A and B, too.
    """

    chosen = Signal(object, bool)

    def __init__(self, owner: QtWidgets.QWidget) -> None:
        super().__init__(owner, Qt.WindowType.Popup)
        self.setFrameShape(QtWidgets.QFrame.Shape.StyledPanel)
        self.for_other = False
        self._groups: list[tuple[QtWidgets.QTreeWidgetItem | None, list[QtWidgets.QTreeWidgetItem]]] = []
        self.search = named(QtWidgets.QLineEdit(), tr("Search presets"))
        self.search.setPlaceholderText(tr("Search presets"))
        self.search.setClearButtonEnabled(True)
        self.entries = named(QtWidgets.QTreeWidget(), tr("Presets"))
        self.entries.setColumnCount(3)
        self.entries.setHeaderHidden(True)
        self.entries.setRootIsDecorated(False)
        self.entries.setIndentation(0)
        self.entries.setUniformRowHeights(True)
        self.entries.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.entries.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.entries.setSelectionMode(QtWidgets.QAbstractItemView.SelectionMode.SingleSelection)
        header = self.entries.header()
        header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        self.as_other = tool_button("", act=lambda: self._take(self.entries.currentItem(), other=True))
        self._buttons = row(self.as_other, 1, spacing=4)
        column(self.search, (self.entries, 1), self._buttons, on=self, margins=(8, 8, 8, 8), spacing=6)
        tab_buttons(self.as_other)
        self.search.textChanged.connect(self._filter)
        self.search.installEventFilter(self)
        self.entries.itemClicked.connect(lambda item, _column: self._take(item, other=self.for_other))

    def add_commands(self, commands: Sequence[QAction]) -> None:
        """End with buttons for these."""
        for command in commands:
            button = QtWidgets.QToolButton()
            button.setDefaultAction(command)
            button.setText(command.text())  # with its ellipsis, which Qt leaves out
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            button.clicked.connect(self.hide)
            self._buttons.addWidget(button)

    def fill(self, sections: Sections, marks: Mapping[Path, str], first: str = "") -> None:
        """List presets under their headings, those in use with a mark; `first` is a line for the current settings."""
        self.entries.clear()
        self._groups = []
        if first:
            self._add_group("", [_line("" if marks else "✓", first, "", (None,))])
        for heading, entries in sections.items():
            self._add_group(
                heading,
                [
                    _line(marks.get(e.path.resolve(), ""), e.name, tr_engine(e.summary), (e.path,), str(e.path))
                    for e in entries
                ],
            )
        any_file = tr("A preset or PhonemeData file of any folder")
        self._add_group("", [_line("", tr("Open File…"), any_file, (OPEN,))])
        self.search.clear()
        self._filter("")

    def show_below(self, button: QtWidgets.QWidget) -> None:
        """Open below a button, within its window and the screen, ready to type."""
        screen, frame = button.screen().availableGeometry(), button.window().geometry()
        height = self.entries.topLevelItemCount() * (self.entries.sizeHintForRow(0) + 1) + 90
        size = QSize(WIDTH, min(max(height, LEAST_HEIGHT), MOST_HEIGHT))
        self.resize(size.boundedTo(screen.size()))
        place = button.mapToGlobal(QPoint(0, button.height())) if button.isVisible() else frame.topLeft()
        x = min(place.x(), max(frame.right(), place.x() + button.width()) + 1 - self.width())
        y = min(place.y(), screen.bottom() + 1 - self.height())
        self.move(min(max(x, screen.left()), screen.right() + 1 - self.width()), max(y, screen.top()))
        self.show()
        self.search.setFocus()

    @override
    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Have the keys that move in the list, choose and close work while one types."""
        if isinstance(event, QKeyEvent) and event.key() in {*_MOVING, *_TAKING, Qt.Key.Key_Escape}:
            if event.type() == QEvent.Type.ShortcutOverride:
                event.accept()
                return True
            if event.type() == QEvent.Type.KeyPress:
                self._press(event)
                return True
        return super().eventFilter(watched, event)

    def lines(self) -> list[QtWidgets.QTreeWidgetItem]:
        """Return the lines that can be chosen and are seen, from above."""
        return [line for _, lines in self._groups for line in lines if not line.isHidden()]

    def _press(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.hide()
        elif event.key() in _TAKING:
            with_control = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
            other = (with_control and not self.as_other.isHidden()) or self.for_other
            self._take(self.entries.currentItem(), other=other)
        else:
            lines = self.lines()
            step = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1, Qt.Key.Key_PageUp: -8}.get(Qt.Key(event.key()), 8)
            here = next((k for k, line in enumerate(lines) if line is self.entries.currentItem()), 0)
            self._mark(lines[min(max(here + step, 0), len(lines) - 1)])

    def _take(self, line: QtWidgets.QTreeWidgetItem | None, *, other: bool) -> None:
        value = None if line is None else line.data(0, _VALUE)
        if value is not None:
            self.hide()
            self.chosen.emit(value[0], other)

    def _add_group(self, heading: str, lines: list[QtWidgets.QTreeWidgetItem]) -> None:
        """Add lines, below a heading that can't be chosen where it has words."""
        if not lines:
            return
        above = None
        if heading:
            above = QtWidgets.QTreeWidgetItem(self.entries, [heading])
            above.setFlags(Qt.ItemFlag.NoItemFlags)
            above.setFirstColumnSpanned(True)
            font = above.font(0)
            font.setBold(True)
            above.setFont(0, font)
        self.entries.addTopLevelItems(lines)
        self._groups.append((above, lines))

    def _filter(self, text: str) -> None:
        """Show the lines with all of the words, and mark the first one; without words, the one in use.

        A name that begins with what is typed goes before others that contain it.
        """
        typed = text.casefold().strip()
        words = typed.split()
        for heading, lines in self._groups:
            for line in lines:
                said = f"{line.text(1)} {line.text(2)}".casefold()
                line.setHidden(not all(word in said for word in words) and line.data(0, _VALUE) != (OPEN,))
            if heading is not None:
                heading.setHidden(all(line.isHidden() for line in lines))
        found = self.lines()
        in_use = [] if words else [line for line in found if line.text(0)]
        self._mark((in_use or sorted(found, key=lambda line: not line.text(1).casefold().startswith(typed)))[0])

    def _mark(self, line: QtWidgets.QTreeWidgetItem) -> None:
        self.entries.setCurrentItem(line)
        self.entries.scrollToItem(line)


def _line(
    mark: str, name: str, summary: str, value: tuple[Path | str | None], tip: str = ""
) -> QtWidgets.QTreeWidgetItem:
    line = QtWidgets.QTreeWidgetItem([mark, name, summary])
    line.setData(0, _VALUE, value)
    for k, words in enumerate(("", tip, summary)):
        line.setToolTip(k, words)
    return line


class PresetPicker(QtWidgets.QPushButton):
    """A button that shows a preset, and opens the list of all.

    Parameters
    ----------
    sections : gives the presets to choose from, by heading; asked whenever the list opens.
    files : asks for any other file.

    Signals
    -------
    chosen : path of the preset that the user wants.
    other_chosen : path of the preset that is to be the other one of A and B.

    Attributes
    ----------
    list : the window that opens.
    """

    chosen = Signal(Path)
    other_chosen = Signal(Path)

    def __init__(self, sections: Callable[[], Sections], files: FileAsker) -> None:
        super().__init__()
        self._sections, self._files = sections, files
        self._name = ""
        self.list = PresetList(self)
        self.list.as_other.hide()
        self.list.chosen.connect(self._take)
        self.setAutoDefault(False)
        self.setMinimumWidth(LEAST_WIDTH)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAccessibleName(tr("Preset"))
        self.clicked.connect(lambda _checked: self.open_list())

    def open_list(self, *, for_other: bool = False) -> None:
        """Show all presets; what is chosen becomes the other one of A and B where that is wanted."""
        self.list.for_other = for_other
        self.list.fill(self._sections(), self._marks(), self._first())
        self.list.show_below(self)

    def choose_other(self) -> None:
        """Show all presets, of which one becomes the other one of A and B."""
        self.open_list(for_other=True)

    def show_name(self, name: str) -> None:
        """Show the name of a preset, elided where there is too little room."""
        self._name = name
        shown = self.fontMetrics().elidedText(name, Qt.TextElideMode.ElideMiddle, self.width() - 34)
        self.setText(f"{shown} ▾".replace("&", "&&"))

    @override
    def resizeEvent(self, event: Any) -> None:
        super().resizeEvent(event)
        self.show_name(self._name)

    def _marks(self) -> dict[Path, str]:
        """Return what stands before the lines of the presets in use, by their files."""
        return {}

    def _first(self) -> str:
        """Return the line for the current settings; empty where there is none."""
        return ""

    def _take(self, value: Path | str | None, other: bool) -> None:
        if value == OPEN:
            value = self._files.ask_file(tr("Load Preset or PhonemeData"), preset_filter(), "preset")
        if isinstance(value, Path):
            (self.other_chosen if other else self.chosen).emit(value)


class PresetChoice(PresetPicker):
    """Chooses a preset in a dialog: the current settings, unless another one is chosen.

    Signals
    -------
    changed : another one is chosen.

    Attributes
    ----------
    path : file of the chosen one; None for the current settings.
    """

    changed = Signal()

    def __init__(self, current: str, sections: Callable[[], Sections], files: FileAsker) -> None:
        super().__init__(sections, files)
        self.path: Path | None = None
        self._current = tr(CURRENT).format(preset=current)
        self.show_name(self._current)
        self.chosen.connect(self.choose)

    def choose(self, path: Path | None) -> None:
        """Choose a preset's file, or the current settings."""
        self.path = path
        entries = [entry for section in self._sections().values() for entry in section if entry.path == path]
        self.show_name(self._current if path is None else entries[0].name if entries else path.stem)
        self.setToolTip("" if path is None else str(path))
        self.changed.emit()

    @override
    def _first(self) -> str:
        return self._current

    @override
    def _marks(self) -> dict[Path, str]:
        return {} if self.path is None else {self.path.resolve(): "✓"}

    @override
    def _take(self, value: Path | str | None, other: bool) -> None:
        if value is None:
            self.choose(None)
        super()._take(value, other)


def preset_filter() -> str:
    """Return what a dialog that asks for a preset shows."""
    return tr("Presets ({endings})").format(endings=" ".join("*" + suffix for suffix in PRESET_SUFFIXES))
