"""A label whose text changes all the time."""

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QLabel


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

    def setText(self, text: str) -> None:
        """Write a text; one that is there already costs nothing."""
        if text == self.text():
            return
        super().setText(text)
        needed = self.sizeHint().expandedTo(self._least)
        if needed != self.minimumSize():
            self.setFixedSize(needed)
