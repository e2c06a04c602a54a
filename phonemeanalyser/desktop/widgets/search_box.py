"""A list to choose from in which one searches by typing any part of a name."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QComboBox, QCompleter, QLineEdit
from typing_extensions import override

from phonemeanalyser.desktop.widgets.builders import named


class SearchField(QLineEdit):
    """Has all of its text selected at the first click, so that what is typed begins a search."""

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        begins = not self.hasFocus() or not self.isModified()
        super().mousePressEvent(event)
        if begins:
            self.selectAll()


class SearchBox(QComboBox):
    """Lists what contains the typed text; Return takes the first of it, and what is none of the list is forgotten.

    Attributes
    ----------
    field : what is typed into.
    """

    def __init__(self, name: str, tip: str) -> None:
        super().__init__()
        self.field = named(SearchField(), name, tip)
        self.setLineEdit(self.field)
        self.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
        named(self, name, tip)
        self._found = QCompleter(self.model(), self)
        self._found.setFilterMode(Qt.MatchFlag.MatchContains)
        self._found.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        self._found.setMaxVisibleItems(self.maxVisibleItems())
        self.setCompleter(self._found)
        self.field.returnPressed.connect(self._take_first)
        self.field.editingFinished.connect(self._forget_typed)

    def _take_first(self) -> None:
        """Choose the first name that contains what is typed."""
        typed = self.field.text()
        if typed.strip() and self.findText(typed, Qt.MatchFlag.MatchExactly) < 0:
            self._found.setCompletionPrefix(typed)
            number = self.findText(self._found.currentCompletion(), Qt.MatchFlag.MatchExactly)
            if number >= 0:
                self.setCurrentIndex(number)
                self.activated.emit(number)

    def _forget_typed(self) -> None:
        self.setEditText(self.itemText(self.currentIndex()))
        self.field.setCursorPosition(0)
