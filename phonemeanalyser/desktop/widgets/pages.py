"""Which page of the window is seen: one button for each, side by side."""

from collections.abc import Callable
from typing import Generic, TypeVar

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QStackedWidget, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.builders import Scrolled, row, toggle_button

Page = TypeVar("Page", bound=QWidget)


class PageStack(QStackedWidget):
    """Pages of which one is seen, and needs room."""

    def __init__(self) -> None:
        super().__init__()
        self.currentChanged.connect(lambda _number: self.updateGeometry())

    @override
    def sizeHint(self) -> QSize:
        seen = self.currentWidget()
        return seen.sizeHint() if seen else super().sizeHint()

    @override
    def minimumSizeHint(self) -> QSize:
        seen = self.currentWidget()
        return seen.minimumSizeHint().expandedTo(seen.minimumSize()) if seen else super().minimumSizeHint()


class LazyPage(Generic[Page]):
    """A page that is made when it is first asked for, so that the first picture of the window need not wait for it.

    Where the window is too small for it, it scrolls.

    Parameters
    ----------
    stack : gets a place for the page at its end.
    make : makes the page.

    Attributes
    ----------
    made : the page, or None before it is first shown.
    """

    def __init__(self, stack: PageStack, make: Callable[[], Page]) -> None:
        self.made: Page | None = None
        self._stack = stack
        self._make = make
        self._place = QWidget()
        stack.addWidget(self._place)

    def get(self) -> Page:
        """Return the page."""
        if self.made is None:
            self.made = self._make()
            self._stack.insertWidget(self._stack.indexOf(self._place), Scrolled(self.made))
            self._stack.removeWidget(self._place)
            self._place.deleteLater()
        return self.made


class PageSwitch(QWidget):
    """Shows which page is seen, and lets another be chosen.

    Signals
    -------
    chosen : number of the page that the user wants, from 0.
    """

    chosen = Signal(int)

    def __init__(self, names: tuple[str, ...]) -> None:
        super().__init__()
        tip = tr("Show the {name} page (Ctrl+{number})")
        self.buttons = [toggle_button(name, tip.format(name=name, number=k)) for k, name in enumerate(names, 1)]
        self._group = QButtonGroup(self)
        self.setStyleSheet("QToolButton[checkable=true] { padding: 0px 8px }")
        for number, button in enumerate(self.buttons):
            self._group.addButton(button, number)
        row(*self.buttons, on=self, margins=(4, 0, 8, 0), spacing=2)
        self._group.idClicked.connect(self.chosen)

    def show_page(self, number: int) -> None:
        """Show which page is seen."""
        self.buttons[number].setChecked(True)
        for k, button in enumerate(self.buttons):  # Tab goes to the one that is down, arrow keys to the others
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus if k == number else Qt.FocusPolicy.NoFocus)
