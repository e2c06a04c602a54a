"""The wheel over a column of numbers is left to the column, and changes none that was not clicked."""

import pytest
from PySide6.QtCore import Qt

from tests.desktop.hands import shown, turn_wheel


@pytest.mark.parametrize("name", ["high_pass_end", "window_function", "look_ahead"])
def test_what_was_not_clicked_keeps_its_value_and_leaves_the_wheel_to_the_column(desktop, qtbot, name):
    window = shown(desktop, qtbot, None)
    before = desktop.preset.preset
    assert not turn_wheel(window.filters.fields[name], -1)
    assert not turn_wheel(window.filters.look_ahead, -1)
    assert desktop.preset.preset == before
    assert window.filters.fields[name].focusPolicy() == Qt.FocusPolicy.StrongFocus  # the wheel gives no focus


def test_what_was_clicked_heeds_the_wheel(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    field = window.filters.fields["high_pass_end"]
    field.setFocus()
    before = field.value()
    assert turn_wheel(field, -1)
    assert field.value() == desktop.preset.preset.settings.high_pass_end == before - 10


def test_thresholds_keep_it_so_after_the_recogniser_changed(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    desktop.preset.set_recogniser("learned")
    before = desktop.preset.preset
    for row in window.analysis.thresholds.rows.values():
        assert not turn_wheel(row.number, -1)
    assert desktop.preset.preset == before
