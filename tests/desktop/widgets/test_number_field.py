"""Numbers: typed with a point or with a comma, shown with a point, wherever the computer stands."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QAbstractSpinBox

from phonemeanalyser.desktop.analyse.recognition.variable_panel import VariableDialog
from phonemeanalyser.desktop.widgets.fields import NumberField
from tests.desktop.hands import followed, type_number


@pytest.fixture(autouse=True)
def german() -> Iterator[None]:
    """A computer in Germany, before the program starts."""
    before = QLocale()
    QLocale.setDefault(QLocale(QLocale.Language.German))
    yield
    QLocale.setDefault(before)


@pytest.fixture
def window(german, desktop, qtbot):
    return followed(desktop, qtbot, seconds=1.0)


@pytest.mark.parametrize("typed", ["0.75", "0,75"])
def test_a_point_and_a_comma_are_both_understood_and_a_point_is_shown(desktop, window, typed):
    field = window.filters.fields["time_smooth"]
    type_number(field, typed)
    assert desktop.preset.preset.settings.time_smooth == 0.75
    assert field.text() == "0.750"


@pytest.mark.parametrize("typed", ["-1.5", "-1,5"])
def test_a_negative_threshold_can_be_typed(desktop, window, typed):
    type_number(window.analysis.thresholds.rows["sz_s1"].number, typed)
    assert desktop.preset.preset.thresholds.sz_s1 == -1.5
    assert window.analysis.thresholds.rows["sz_s1"].number.text() == "-1.500"


def test_a_whole_number_has_no_decimals(window):
    box = window.analysis.sonagram.low
    type_number(box, "-7,5")
    assert box.text() == "-7 dB"


def test_every_field_of_the_window_is_of_that_kind(desktop, window, qtbot):
    assert window.calibration
    assert window.talk
    dialog = VariableDialog(1000.5, 1500.5, desktop.preset.add_variable, window)
    qtbot.addWidget(dialog)
    fields = window.findChildren(QAbstractSpinBox)
    assert len(fields) > 40
    assert [field for field in fields if not isinstance(field, NumberField)] == []
    assert [field.text() for field in fields if "," in field.text()] == []
    assert (dialog.low.text(), dialog.high.text()) == ("1000.5 Hz", "1500.5 Hz")
