"""Nothing is clipped: every text has room at the sizes that people use."""

from itertools import product

import pytest
from PySide6 import QtWidgets
from PySide6.QtCore import Qt

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.calibrate.guide.guide_model import Phase
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeengine.audio.output import ClockOutput
from phonemeengine.audio.tone import Tone, ToneKind
from phonemeengine.presets.files import FACTORY
from tests.desktop.hands import click, followed, lies_behind, settle, shown

SMALLEST = (1016, 660)
"""What window managers leave of a screen of 1024x700."""


@pytest.fixture
def window(desktop, qtbot):
    return shown(desktop, qtbot, None)


def room_and_need(widget: QtWidgets.QWidget) -> tuple[int, int]:
    """The pixels that a widget has for its text, and the pixels that the longest text it may show needs."""
    advance = widget.fontMetrics().horizontalAdvance
    if isinstance(widget, QtWidgets.QComboBox):
        option = QtWidgets.QStyleOptionComboBox()
        widget.initStyleOption(option)
        part = QtWidgets.QStyle.SubControl.SC_ComboBoxEditField
        room = (
            widget.style().subControlRect(QtWidgets.QStyle.ComplexControl.CC_ComboBox, option, part, widget).width()
        )
        return room, max(advance(widget.itemText(k)) for k in range(widget.count()))
    if isinstance(widget, QtWidgets.QLabel) and widget.wordWrap():
        return widget.height(), widget.heightForWidth(widget.width())  # it takes lines, and no certain width
    if isinstance(widget, QtWidgets.QAbstractSpinBox):
        return widget.lineEdit().width(), advance(widget.text()) + 3
    if isinstance(widget, QtWidgets.QToolButton) and widget.text() == "↺":
        return widget.width(), advance("↺") + 4  # the arrow alone, without the frame that it shows under the mouse
    return widget.width(), widget.sizeHint().width()


def texts(window) -> list[QtWidgets.QWidget]:
    kinds = QtWidgets.QLabel | QtWidgets.QAbstractButton | QtWidgets.QComboBox | QtWidgets.QAbstractSpinBox
    return [
        w
        for w in window.findChildren(QtWidgets.QWidget)
        if isinstance(w, kinds) and w.isVisible() and not lies_behind(w)
    ]


def clipped(widgets: list[QtWidgets.QWidget]) -> dict[str, tuple[int, int]]:
    """Give what has less room than it needs."""
    return {name_of(w): (room, need) for w in widgets for room, need in (room_and_need(w),) if room < need}


def name_of(widget: QtWidgets.QWidget) -> str:
    text = widget.currentText() if isinstance(widget, QtWidgets.QComboBox) else widget.text()
    return f"{type(widget).__name__} {text or widget.toolTip()}"


def test_every_text_has_room_lies_inside_its_parent_and_on_nothing_else(desktop, qtbot):
    window = followed(desktop, qtbot, seconds=0.3)
    for size in (SMALLEST, (1920, 1080)):
        window.resize(*size)
        settle()
        assert (window.width(), window.height()) == size
        seen = texts(window)
        assert len(seen) > 100
        assert clipped(seen) == {}
        assert [name_of(w) for w in seen if not w.parentWidget().rect().contains(w.geometry())] == []
        for parent in {w.parentWidget() for w in seen}:
            children = [w for w in seen if w.parentWidget() is parent]
            for k, one in enumerate(children):
                covering = [name_of(o) for o in children[k + 1 :] if o.geometry().intersects(one.geometry())]
                assert covering == [], name_of(one)
        # the largest values have room too
        window.filters.fields["high_pass_end"].setValue(22_050)
        window.filters.fields["low_pass_end"].setValue(22_050)
        window.filters.fields["intensity_low"].setValue(-120)
        window.analysis.thresholds.rows["silence_zero_crossings"].number.setValue(2047)
        window.analysis.thresholds.rows["p_energy_n"].number.setValue(256)
        assert clipped([w for w in texts(window) if isinstance(w, QtWidgets.QDoubleSpinBox)]) == {}


def test_the_window_fits_on_a_small_screen_even_with_a_banner_and_curves(desktop, qtbot, tmp_path):
    window = followed(desktop, qtbot, seconds=1.0)
    window.dialogs.open_sound(tmp_path / "there is no such file.wav")
    for k in range(3):
        desktop.session.analyse_until(0.3 + k / 10)
        desktop.session.curves.add([desktop.session.averages.save(tmp_path / f"speaker {k}.csv")])
    click(window.analysis.averaged.measure)
    window.redraw.refresh_all()
    settle()
    assert (window.width(), window.height()) == (1280, 800)
    assert fits(window)


def fits(window) -> bool:
    """Say whether the window can be as small as a small screen is."""
    least = window.minimumSizeHint()
    return least.width() <= SMALLEST[0] and least.height() <= SMALLEST[1]


def test_every_page_fits_on_a_small_screen_whatever_is_heard(window, desktop, qtbot):
    bar = window.transport
    for page, kind in ((2, None), *((0, kind) for kind in ToneKind), (1, None)):
        window.resize(1280, 800)
        if kind is not None:
            desktop.session.set_source(SourceKind.TONE)
            desktop.session.playback.set_tone(Tone(kind=kind))
            bar.tone.show_tone(desktop.session.playback.tone)
        window.show_page(page)
        qtbot.waitUntil(lambda: fits(window))
        window.resize(*SMALLEST)
        qtbot.waitUntil(lambda: (window.width(), window.height()) == SMALLEST)
        settle()
        assert not bar.visibleRegion().isEmpty()
        in_bar = [
            w for w in bar.findChildren(QtWidgets.QWidget) if w.isVisible() and w.parentWidget() in (bar, bar.tone)
        ]
        assert [w for w in in_bar if not w.parentWidget().rect().contains(w.geometry())] == [], kind
        assert clipped(texts(bar)) == {}, kind
    # tabs of the calibration can be scrolled where they are narrow
    tabs = window.calibration.workbench.tabs
    for number in range(1, tabs.count()):
        tabs.setCurrentIndex(number)
        settle()
        scrolled = tabs.widget(number)
        view = scrolled.widget()
        hidden = view.width() - scrolled.viewport().width()
        assert view.width() >= view.minimumSizeHint().width()
        assert scrolled.horizontalScrollBar().maximum() == max(0, hidden)
    page = window.calibration
    page.right.setCurrentWidget(page.guide)
    for phase in Phase:
        desktop.calibration.guide._show(phase)
        qtbot.waitUntil(lambda: fits(window))


def is_seen(area: QtWidgets.QScrollArea) -> bool:
    """Say whether something of it is on the screen: it lies behind no other dock."""
    return any(not widget.visibleRegion().isEmpty() for widget in (area, *area.findChildren(QtWidgets.QWidget)))


@pytest.mark.usefixtures("own_desktop")
@pytest.mark.parametrize("language", [pytest.param("en", marks=pytest.mark.long), "de"])  # whose words are longer
def test_nothing_scrolls_sideways_at_any_size_with_any_recogniser(settings, request, qtbot, language):
    settings.setValue("language", language)
    window = shown(request.getfixturevalue("desktop"), qtbot)
    for preset, size, page in product(("learned", "thesis"), (SMALLEST, (1272, 800)), range(3)):
        if (size, page) == (SMALLEST, 0):
            window.dialogs.presets.load(FACTORY / f"{preset}.toml")
        window.show_page(page)
        window.resize(*size)
        settle()
        seen = [area for area in window.findChildren(QtWidgets.QScrollArea) if is_seen(area)]
        assert seen
        for area in seen:
            assert area.widget().width() <= area.viewport().width(), (preset, size, page, area.accessibleName())
    for column in (window.filters, window.analysis.thresholds):
        needed = column.widget().minimumSizeHint().width() + column.verticalScrollBar().sizeHint().width()
        assert column.minimumWidth() >= needed
    around_visemes = [a for a in window.findChildren(QtWidgets.QScrollArea) if a.isAncestorOf(window.talk.visemes)]
    assert len(around_visemes) == 2


@pytest.mark.usefixtures("own_desktop")
def test_a_window_opens_within_the_screen_and_a_narrow_one_has_the_filters_behind_the_thresholds(desktop, qtbot):
    window, available = desktop.window, desktop.window.screen().availableSize()
    assert available.width() < 1280  # else this says nothing
    assert window.width() < available.width()
    assert window.height() < available.height()
    window.resize(1016, 700)
    window.show()
    qtbot.waitExposed(window)
    filters, thresholds = (window.findChild(QtWidgets.QDockWidget, name) for name in ("Filters", "Thresholds"))
    assert filters in window.tabifiedDockWidgets(thresholds)
    qtbot.waitUntil(lambda: not thresholds.visibleRegion().isEmpty())
    window.show_page(1)
    window.show_page(0)
    qtbot.waitUntil(lambda: not thresholds.visibleRegion().isEmpty())
    assert window.analysis.thresholds.width() >= window.analysis.thresholds.minimumWidth()
    assert window.analysis.thresholds.parentWidget().width() <= thresholds.width()


def test_all_docks_are_seen_give_way_when_the_window_becomes_narrow_and_come_back_as_wide(window, qtbot):
    page = window.analysis
    for view in (
        window.transport,
        page.spectrum,
        page.averaged,
        page.waveform,
        page.scroll_view,
        window.filters,
        page.phoneme,
        page.thresholds,
    ):
        assert view.isVisible()
        assert view.width() >= 200
        assert view.height() >= 30
    assert page.waveform.graphics.height() >= 90
    assert page.spectrum.graphics.height() >= 120
    filters, thresholds = (window.findChild(QtWidgets.QDockWidget, name) for name in ("Filters", "Thresholds"))
    assert filters not in window.tabifiedDockWidgets(thresholds)
    width = filters.width()
    window.resize(1016, 700)
    qtbot.waitUntil(lambda: filters in window.tabifiedDockWidgets(thresholds))
    window.show_page(1)
    window.resize(1280, 800)
    window.show_page(0)
    assert filters not in window.tabifiedDockWidgets(thresholds)
    qtbot.waitUntil(lambda: filters.width() == width)
    assert window.dockWidgetArea(filters) is Qt.DockWidgetArea.LeftDockWidgetArea


@pytest.mark.usefixtures("own_desktop")
@pytest.mark.parametrize(("width", "moved"), [(1280, True), pytest.param(1016, False, marks=pytest.mark.long)])
def test_a_layout_of_a_wide_window_is_changed_for_a_narrow_one_and_that_of_a_narrow_one_is_kept(
    desktop, qapp, settings, qtbot, width, moved
):
    first = desktop.window
    first.resize(width, 700)
    first.show()
    qtbot.waitExposed(first)
    first.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, first.findChild(QtWidgets.QDockWidget, "Filters"))
    settle()
    assert first.close()
    again = Desktop(qapp, settings, lambda _n: ClockOutput())
    again.window.resize(1016, 700)
    again.window.show()
    qtbot.waitExposed(again.window)
    filters, thresholds = (again.window.findChild(QtWidgets.QDockWidget, name) for name in ("Filters", "Thresholds"))
    assert (filters in again.window.tabifiedDockWidgets(thresholds)) is moved
    again.window.resize(1020, 690)  # the tab bars that Qt made before the layout was restored stay where they were
    qtbot.waitUntil(lambda: len(dock_tabs(again.window)) == 2)
    phoneme = again.window.findChild(QtWidgets.QDockWidget, "Phoneme").geometry()
    places = {(tabs.x(), tabs.y(), tabs.width()) for tabs in dock_tabs(again.window)}
    assert (phoneme.x(), phoneme.bottom() + 1, phoneme.width()) in places
    again.close()


def dock_tabs(window: QtWidgets.QWidget) -> list[QtWidgets.QTabBar]:
    """The tab bars of docks that are seen."""
    direct = Qt.FindChildOption.FindDirectChildrenOnly
    return [tabs for tabs in window.findChildren(QtWidgets.QTabBar, "DockTabs", direct) if tabs.isVisible()]
