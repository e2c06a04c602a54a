"""The mouse wheel over a column that scrolls: it scrolls, and sets no number on the way."""

from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QAbstractSpinBox, QComboBox, QSlider, QWidget

_SET_BY_WHEEL = (QAbstractSpinBox, QComboBox, QSlider)


class _OnlyWithFocus(QObject):
    def eventFilter(self, watched: QObject, event: Any) -> bool:
        """Leave the wheel to what is behind a widget that has not the focus."""
        if event.type() != QEvent.Type.Wheel or not isinstance(watched, QWidget) or watched.hasFocus():
            return False
        event.ignore()
        return True


def leave_wheel(body: QWidget) -> None:
    """Have the numbers, choices and sliders in a scrolled widget heed the wheel only once they were clicked."""
    for kind in _SET_BY_WHEEL:
        for widget in body.findChildren(kind):
            widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # the wheel itself gives no focus
            widget.installEventFilter(_OnlyWithFocus(widget))
