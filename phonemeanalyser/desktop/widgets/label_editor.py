"""The field in which a label is named, in its place."""

from typing import Any

from PySide6.QtCore import QEvent, QRect, QRectF, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent
from PySide6.QtWidgets import QLineEdit, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.builders import named

LEAST_WIDTH = 90
"""Pixels in which a name can be read while it is typed, however short the label is."""
_KEYS = {int(Qt.Key.Key_Return): 0, int(Qt.Key.Key_Enter): 0, int(Qt.Key.Key_Tab): 1, int(Qt.Key.Key_Backtab): -1}
"""Keys that end the typing, and the number of labels from it to the one that is named next; 0 for none."""


class LabelEditor(QLineEdit):
    """Lies over a label while its name is typed. Return takes the name, Tab names the next label, Escape cancels.

    Signals
    -------
    typed : the name, and how many labels further on another one is to be named.
    """

    typed = Signal(str, int)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._view = parent
        named(self, tr("Name of the label"))
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)  # over a label that is narrower than the field
        self.hide()

    def open_over(self, box: QRectF, name: str, *, begun: bool) -> None:
        """Ask for a name over a box; one that is `begun` is typed on, another one is selected, to be replaced."""
        place = QRect(0, 0, max(LEAST_WIDTH, round(box.width())), self.sizeHint().height())
        place.moveCenter(box.center().toPoint())
        room = self._view.rect()
        place.moveLeft(max(0, min(place.left(), room.right() - place.width())))
        place.moveTop(max(0, min(place.top(), room.bottom() - place.height())))
        self.setGeometry(place)
        self.setText(name)
        self.show()
        self.raise_()
        self.setFocus()
        if not begun:
            self.selectAll()

    @override
    def event(self, event: QEvent) -> bool:
        """Take the keys that end the typing before shortcuts and the change of focus do."""
        if isinstance(event, QKeyEvent) and event.key() in {*_KEYS, int(Qt.Key.Key_Escape)}:
            if event.type() == QEvent.Type.KeyPress:
                self._end(_KEYS.get(event.key()))
            event.accept()
            return True
        return super().event(event)

    @override
    def focusOutEvent(self, event: QFocusEvent) -> Any:
        """Take the name where the user goes on elsewhere, but not because of a menu of its own."""
        super().focusOutEvent(event)
        if self.isVisible() and event.reason() != Qt.FocusReason.PopupFocusReason:
            self._end(0)

    def _end(self, step: int | None) -> None:
        if not self.isVisible():
            return
        had_focus, name = self.hasFocus(), self.text()
        self.hide()
        if had_focus:
            self._view.setFocus()
        if step is not None:
            self.typed.emit(name, step)
