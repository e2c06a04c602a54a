"""Fields: for a number, for a share, and for a choice from a list that is searched by typing part of a name."""

from collections.abc import Callable

from PySide6.QtCore import QLocale, Qt
from PySide6.QtGui import QMouseEvent, QValidator
from PySide6.QtWidgets import QComboBox, QCompleter, QDoubleSpinBox, QLineEdit, QSlider
from typing_extensions import override

from phonemeanalyser.desktop.widgets.builders import label, leave_wheel, named, silent
from phonemeanalyser.desktop.widgets.keyboard import NumberFieldKeys

PERCENT_WIDTH = 40
"""Of the label beside a slider, pixels."""


class NumberField(QDoubleSpinBox):
    """Shows a decimal point, and takes a comma for one; keys that write no number stay the window's.

    Parameters
    ----------
    low, high : the range.
    decimals : digits behind the point.
    step : how far an arrow key goes.
    unit : what stands behind the number.
    waits : tell a number once it is typed, and not with each digit.
    """

    def __init__(
        self,
        low: float = 0.0,
        high: float = 99.99,
        *,
        decimals: int = 0,
        step: float = 1.0,
        unit: str = "",
        waits: bool = False,
    ) -> None:
        super().__init__()
        self.setLocale(QLocale.c())
        self.setDecimals(decimals)
        self.setRange(low, high)
        self.setSingleStep(step)
        self.setSuffix(unit)
        self.setKeyboardTracking(not waits)
        self.installEventFilter(NumberFieldKeys(self))

    @override
    def validate(self, text: str, place: int) -> tuple[QValidator.State, str, int]:
        """Judge what was typed, with a point for a comma; gives state, text and place of the cursor."""
        return super().validate(text.replace(",", "."), place)


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


class PercentSlider(QSlider):
    """A slider from 0 to 100 %.

    Parameters
    ----------
    act : given the share, 0..1, that the user chooses.

    Attributes
    ----------
    percent : the label that tells the share.
    """

    def __init__(self, name: str, tip: str, act: Callable[[float], object]) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        named(self, name, tip)
        self.percent = named(label(width=PERCENT_WIDTH), tip=tip)
        self.setRange(0, 100)
        self.setPageStep(10)
        self.setMinimumWidth(44)
        leave_wheel(self)  # many come later than the page that holds them
        self.valueChanged.connect(lambda value: act(value / 100))

    def show_share(self, share: float) -> None:
        """Show a share, 0..1, that was not chosen here."""
        with silent(self):
            self.setValue(round(100 * share))
        self.percent.setText(f"{100 * share:.0f} %")
