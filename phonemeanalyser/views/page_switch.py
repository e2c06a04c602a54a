"""Which page of the window is seen: one button for each, side by side."""

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QHBoxLayout, QStackedWidget, QToolButton, QWidget


class PageStack(QStackedWidget):
    """Pages of which one is seen, and needs room."""

    def __init__(self) -> None:
        super().__init__()
        self.currentChanged.connect(lambda _number: self.updateGeometry())

    def sizeHint(self) -> QSize:
        """Ask for what the page that is seen would like."""
        seen = self.currentWidget()
        return seen.sizeHint() if seen else super().sizeHint()

    def minimumSizeHint(self) -> QSize:
        """Ask for what the page that is seen needs."""
        seen = self.currentWidget()
        return seen.minimumSizeHint().expandedTo(seen.minimumSize()) if seen else super().minimumSizeHint()


class PageSwitch(QWidget):
    """Shows which page is seen, and lets another be chosen.

    Signals
    -------
    chosen : number of the page that the user wants, from 0.
    """

    chosen = Signal(int)

    def __init__(self, names: tuple[str, ...]) -> None:
        super().__init__()
        self.buttons = [QToolButton() for _ in names]
        self._group = QButtonGroup(self)
        row = QHBoxLayout(self)
        self.setStyleSheet("QToolButton[checkable=true] { padding: 0px 8px }")
        row.setContentsMargins(4, 0, 8, 0)
        row.setSpacing(2)
        for number, (button, name) in enumerate(zip(self.buttons, names, strict=True)):
            button.setText(name)
            button.setCheckable(True)
            button.setToolTip(f"The page {name} (Ctrl+{number + 1})")
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            self._group.addButton(button, number)
            row.addWidget(button)
        self._group.idClicked.connect(self.chosen)

    def show_page(self, number: int) -> None:
        """Show which page is seen."""
        self.buttons[number].setChecked(True)
