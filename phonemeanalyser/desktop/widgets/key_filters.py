"""Which keys belong to the widget that has the focus, and which to the window's menus."""

from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QAbstractButton, QApplication

_MOVING = frozenset({Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Home, Qt.Key.Key_End})
_EDITING = frozenset({Qt.Key.Key_Backspace, Qt.Key.Key_Delete, *_MOVING})
_CLIPBOARD = frozenset({Qt.Key.Key_A, Qt.Key.Key_C, Qt.Key.Key_V, Qt.Key.Key_X})


class NumberFieldKeys(QObject):
    """Leaves to a field of numbers the keys that write a number; Space, letters and undo stay the window's."""

    def eventFilter(self, _watched: QObject, event: Any) -> bool:
        """Refuse keys that the field would swallow, so that the window's shortcuts see them."""
        if event.type() != QEvent.Type.ShortcutOverride or _writes_a_number(event):
            return False
        event.ignore()
        return True


class ButtonKeys(QObject):
    """Leaves Space to a button that was reached with Tab, where it would else be a shortcut of the window."""

    def eventFilter(self, _watched: QObject, event: Any) -> bool:
        """Claim Space while a button has the focus."""
        if event.type() != QEvent.Type.ShortcutOverride or event.key() != Qt.Key.Key_Space:
            return False
        claimed = isinstance(QApplication.focusWidget(), QAbstractButton)
        event.setAccepted(claimed)
        return claimed


def _writes_a_number(event: Any) -> bool:
    control = event.modifiers() & Qt.KeyboardModifier.ControlModifier
    if control:
        return event.key() in _CLIPBOARD
    return event.key() in _EDITING or (bool(event.text()) and event.text() in "0123456789.,-+")
