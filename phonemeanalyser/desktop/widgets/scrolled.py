"""A frame for a view that may get less room than it needs."""

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QFrame, QScrollArea, QWidget

LEAST = QSize(160, 68)
"""Pixels in which a view can still be used by scrolling."""


class Scrolled(QScrollArea):
    """Shows a view as it is where there is room, and by scroll bars where there is too little."""

    def __init__(self, view: QWidget) -> None:
        super().__init__()
        self._view = view
        self.setWidget(view)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)

    def sizeHint(self) -> QSize:
        """Ask for what the view would like."""
        return self._view.sizeHint()

    def minimumSizeHint(self) -> QSize:
        """Ask for little."""
        return LEAST.boundedTo(self._view.minimumSizeHint())
