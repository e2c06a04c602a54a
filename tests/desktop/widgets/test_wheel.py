"""The wheel over a column of numbers is left to the column, and changes none that was not clicked."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication, QWidget

from tests.desktop.hands import shown


def turned(widget: QWidget) -> bool:
    """Turn the wheel by one notch over a widget's middle; return whether it took the turn for itself."""
    middle = QPointF(widget.rect().center())
    event = QWheelEvent(
        middle,
        widget.mapToGlobal(middle),
        QPoint(),
        QPoint(0, -120),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)
    return event.isAccepted()


@pytest.mark.parametrize("name", ["high_pass_end", "window_function", "look_ahead"])
def test_what_was_not_clicked_keeps_its_value_and_leaves_the_wheel_to_the_column(desktop, qtbot, name):
    window = shown(desktop, qtbot, None)
    before = desktop.preset.preset
    assert not turned(window.filters.fields[name])
    assert not turned(window.filters.look_ahead)
    assert desktop.preset.preset == before
    assert window.filters.fields[name].focusPolicy() == Qt.FocusPolicy.StrongFocus  # the wheel gives no focus


def test_what_was_clicked_heeds_the_wheel(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    field = window.filters.fields["high_pass_end"]
    field.setFocus()
    before = field.value()
    assert turned(field)
    assert field.value() == desktop.preset.preset.settings.high_pass_end == before - 10


def test_thresholds_keep_it_so_after_the_recogniser_changed(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    desktop.preset.set_recogniser("learned")
    before = desktop.preset.preset
    for row in window.analysis.thresholds.rows.values():
        assert not turned(row.number)
    assert desktop.preset.preset == before
