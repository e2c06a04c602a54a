"""The wheel over a number, choice, slider or tab that has not the focus changes nothing, on all pages."""

from PySide6.QtWidgets import QAbstractSpinBox, QComboBox, QSlider, QTabBar, QWidget

from tests.desktop.hands import shown, turn_wheel

KINDS = QAbstractSpinBox, QComboBox, QSlider, QTabBar


def value_of(field: QWidget) -> object:
    return field.currentIndex() if isinstance(field, QComboBox | QTabBar) else field.value()


def test_the_wheel_over_any_field_of_any_page_changes_nothing(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    wholes = window, window.calibration, window.talk
    desktop.talking.set_table("five")  # whose sliders come later than the page
    fields = [field for kind in KINDS for whole in wholes for field in whole.findChildren(kind)]
    assert len(fields) > 100
    for field in (field for field in fields if not field.hasFocus()):
        before = value_of(field)
        turn_wheel(field, -1)
        turn_wheel(field, 2)
        assert value_of(field) == before, field.accessibleName()
