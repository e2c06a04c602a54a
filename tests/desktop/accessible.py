"""What somebody who does not see the window, or has no mouse, meets in it."""

from collections.abc import Iterator

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
    QScrollBar,
    QWidget,
)

KINDS = (QAbstractButton, QAbstractItemView, QAbstractSlider, QAbstractSpinBox, QComboBox, QLineEdit, QPlainTextEdit)

PARTS = (QComboBox, QAbstractSpinBox, QAbstractItemView)
"""Whose own parts speak for nothing."""


def controls_of(window: QWidget) -> Iterator[QWidget]:
    """Return what can be used or has a name, and is seen."""
    for widget in window.findChildren(QWidget):
        if not widget.isVisibleTo(window) or isinstance(widget, QScrollBar) or widget.objectName().startswith("qt_"):
            continue
        if inside_of(widget, PARTS, window) or widget.window() is not window:
            continue
        if isinstance(widget, KINDS) or (widget.accessibleName() and widget.focusPolicy() != Qt.FocusPolicy.NoFocus):
            yield widget


def inside_of(widget: QWidget, kinds: tuple[type[QWidget], ...], window: QWidget) -> bool:
    """Say whether a widget is a part of another one of these kinds."""
    parent = widget.parentWidget()
    while parent is not None and parent is not window:
        if isinstance(parent, kinds):
            return True
        parent = parent.parentWidget()
    return False


def spoken_name(widget: QWidget) -> str:
    """Return what a screen reader says: the accessible name, or what is written on it."""
    if widget.accessibleName():
        return widget.accessibleName()
    return widget.text() if isinstance(widget, QAbstractButton) else ""
