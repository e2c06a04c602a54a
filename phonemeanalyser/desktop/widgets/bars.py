"""The bars at the top of the window."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMainWindow, QToolBar, QWidget


def add_bar(window: QMainWindow, title: str, view: QWidget) -> QToolBar:
    """Add a bar with one view, in a row of its own."""
    bar = QToolBar(title)
    bar.setObjectName(title)
    bar.setMovable(False)
    bar.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
    bar.addWidget(view)
    window.addToolBar(bar)
    window.insertToolBarBreak(bar)
    return bar
