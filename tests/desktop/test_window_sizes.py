"""Nothing is clipped: every text has room at the sizes that people use."""

import pytest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QComboBox,
    QDoubleSpinBox,
    QLabel,
    QStyle,
    QStyleOptionComboBox,
    QToolButton,
    QWidget,
)

from tests.desktop.hands import click, followed, shown

SIZES = [(1280, 800), (1920, 1080)]


@pytest.fixture(params=SIZES, ids=lambda size: f"{size[0]}x{size[1]}")
def window(request, desktop, qtbot):
    window = followed(desktop, qtbot, seconds=1.0)
    window.resize(*request.param)
    qtbot.wait(50)
    assert (window.width(), window.height()) == request.param
    return window


def room_and_need(widget: QWidget) -> tuple[int, int]:
    """The pixels that a widget has for its text, and the pixels that the longest text it may show needs."""
    advance = widget.fontMetrics().horizontalAdvance
    if isinstance(widget, QComboBox):
        option = QStyleOptionComboBox()
        widget.initStyleOption(option)
        part = QStyle.SubControl.SC_ComboBoxEditField
        room = widget.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, part, widget).width()
        return room, max(advance(widget.itemText(k)) for k in range(widget.count()))
    if isinstance(widget, QAbstractSpinBox):
        return widget.lineEdit().width(), advance(widget.text()) + 3
    if isinstance(widget, QToolButton) and widget.text() == "↺":
        return widget.width(), advance("↺") + 4  # the arrow alone, without the frame that it shows under the mouse
    return widget.width(), widget.sizeHint().width()


def texts(window) -> list[QWidget]:
    kinds = QLabel | QAbstractButton | QComboBox | QAbstractSpinBox
    return [w for w in window.findChildren(QWidget) if isinstance(w, kinds) and w.isVisible()]


def test_every_text_has_room(window):
    assert len(texts(window)) > 100
    clipped = {name_of(w): room_and_need(w) for w in texts(window) if room_and_need(w)[0] < room_and_need(w)[1]}
    assert clipped == {}


def name_of(widget: QWidget) -> str:
    text = widget.currentText() if isinstance(widget, QComboBox) else widget.text()
    return f"{type(widget).__name__} {text or widget.toolTip()}"


def test_everything_lies_inside_its_parent(window):
    outside = [name_of(w) for w in texts(window) if not w.parentWidget().rect().contains(w.geometry())]
    assert outside == []


def test_nothing_lies_on_anything_else(window):
    for parent in {w.parentWidget() for w in texts(window)}:
        children = [w for w in texts(window) if w.parentWidget() is parent]
        for k, one in enumerate(children):
            covering = [name_of(o) for o in children[k + 1 :] if o.geometry().intersects(one.geometry())]
            assert covering == [], name_of(one)


def test_the_largest_values_have_room_too(window):
    window.filters.fields["high_pass_end"].setValue(22_050)
    window.filters.fields["low_pass_end"].setValue(22_050)
    window.filters.fields["intensity_low"].setValue(-120)
    window.thresholds.rows["silence_zero_crossings"].number.setValue(2047)
    window.thresholds.rows["p_energy_n"].number.setValue(256)
    boxes = [w for w in texts(window) if isinstance(w, QDoubleSpinBox)]
    assert {name_of(w): room_and_need(w) for w in boxes if room_and_need(w)[0] < room_and_need(w)[1]} == {}


def test_the_window_fits_on_a_small_screen_even_with_a_banner_and_curves(desktop, qtbot, tmp_path):
    window = followed(desktop, qtbot, seconds=1.0)
    window.dialogs.open_sound(tmp_path / "there is no such file.wav")
    for k in range(3):
        desktop.session.averages.save(tmp_path / f"speaker {k}.csv")
    click(window.analysis.averaged.measure)
    window.drawing.refresh_all()
    qtbot.wait(50)
    assert (window.width(), window.height()) == (1280, 800)
    assert window.minimumSizeHint().width() <= 1280
    assert window.minimumSizeHint().height() <= 720


def test_every_dialog_and_dock_can_be_seen_at_once(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    for view in (
        window.transport,
        window.analysis.spectrum,
        window.analysis.averaged,
        window.analysis.waveform,
        window.analysis.time_view,
        window.filters,
        window.phoneme,
        window.thresholds,
    ):
        assert view.isVisible()
        assert view.width() >= 200
        assert view.height() >= 30
    assert window.analysis.waveform.graphics.height() >= 90
    assert window.analysis.spectrum.graphics.height() >= 120
