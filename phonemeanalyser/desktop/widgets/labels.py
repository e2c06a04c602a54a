"""Labels: one that gives way where it has no room, and one whose text changes all the time."""

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel
from typing_extensions import override


class ElidedLabel(QLabel):
    """A label that shows as much of its text as there is room for, and makes no window wider.

    Parameters
    ----------
    text : what it says.
    asks : whether it asks for the room of its text where there is enough.
    """

    def __init__(self, text: str = "", *, asks: bool = False) -> None:
        super().__init__(text)
        self._asks = asks

    @override
    def minimumSizeHint(self) -> QSize:
        return QSize(0, super().minimumSizeHint().height())

    @override
    def sizeHint(self) -> QSize:
        """Ask for no width, or for that of the text."""
        wanted = super().sizeHint()
        return wanted if self._asks else QSize(0, wanted.height())

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        room = self.contentsRect()
        text = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, room.width())
        QPainter(self).drawText(room, self.alignment(), text)


class StillLabel(QLabel):
    """A label that has the window laid out anew only where its text needs another size.

    Any other label asks for that with each text, and Qt asks for the size of everything around it then; a label of
    fixed size does not.

    Parameters
    ----------
    least_width : as wide it is at least, pixels.
    """

    def __init__(self, least_width: int = 0) -> None:
        super().__init__()
        self._least = QSize(least_width, 0)

    @override
    def setText(self, text: str) -> None:
        """Write a text; one that is there already costs nothing."""
        if text == self.text():
            return
        super().setText(text)
        needed = self.sizeHint().expandedTo(self._least)
        if needed != self.minimumSize():
            self.setFixedSize(needed)
