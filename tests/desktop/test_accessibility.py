"""For who does not see well, or not at all, or has no mouse: names, the way of Tab, and contrast."""

from itertools import pairwise, product

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QDialog, QWidget

from phonemeanalyser.desktop.analyse.lanes.label_dialogs import TiersDialog
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.theme import DARK, LIGHT, PHONEME_COLOURS, Theme
from tests.desktop.accessible import controls_of, spoken_name
from tests.desktop.hands import CARDS, shown

TEXT, LARGE = 4.5, 3.0
"""The least contrast by WCAG 2.2, level AA: of text, and of large text and of what marks a control."""


def test_every_control_of_every_page_and_dialog_has_a_name_for_screen_readers_whatever_is_heard(desktop, qtbot):
    window = shown(desktop, qtbot)
    for source, page in product(SourceKind, range(3)):
        desktop.session.set_source(source)
        window.show_page(page)
        told = [f"{type(w).__name__} in {type(w.parentWidget()).__name__}: {w.toolTip()}" for w in nameless(window)]
        assert told == [], (source, page)
    desktop.session.set_source(SourceKind.FILE)
    window.show_page(0)
    for show in (
        lambda: window.dialogs.show_export([CARDS]),
        lambda: TiersDialog(desktop.session.labels, window).show(),
        window.show_manual,
        window.show_shortcuts,
        window.welcome.show_cards,
    ):
        show()
        shows = [d for d in window.findChildren(QDialog) if d.isVisible()] or [window]
        for dialog in shows:
            assert controls_of(dialog)
            assert nameless(dialog) == []
            dialog.hide()


def nameless(place: QWidget) -> list[QWidget]:
    return [w for w in controls_of(place) if not any(letter.isalnum() for letter in spoken_name(w))]


@pytest.mark.parametrize("page", range(3))
def test_tab_reaches_every_control_from_the_top_down(desktop, qtbot, page):
    window = shown(desktop, qtbot)
    window.show_page(page)
    window.activateWindow()
    wanted = {
        w
        for w in controls_of(window)
        if w.isEnabled() and w.focusPolicy() & Qt.FocusPolicy.TabFocus and not grouped(w)
    }
    reached = []
    for _ in range(400):
        QTest.keyClick(window.focusWidget() or window, Qt.Key.Key_Tab)
        now = QApplication.focusWidget() or window.focusWidget()
        if now in reached:
            break
        reached.append(now)
    missed = [f"{type(w).__name__}: {spoken_name(w)}" for w in wanted - {*reached}]
    assert missed == []
    assert [type(w).__name__ for w in reached if not spoken_name(w)] == []
    backwards = [
        f"{spoken_name(one)} before {spoken_name(other)}"
        for one, other in pairwise(reached)
        if one.parentWidget() is other.parentWidget() and lies_before(other, one)
    ]
    assert backwards == []


def test_tab_goes_from_the_bar_to_the_left_the_middle_and_the_right(desktop, qtbot):
    window = shown(desktop, qtbot)
    window.activateWindow()
    window.switch.buttons[0].setFocus()
    parts = (window.transport, window.filters, window.analysis, window.recogniser, window.analysis.thresholds)
    met = []
    for _ in range(400):
        QTest.keyClick(window.focusWidget(), Qt.Key.Key_Tab)
        now = next((k for k, part in enumerate(parts) if part.isAncestorOf(window.focusWidget())), None)
        if now == 0 and len(met) > 1:
            break
        if now is not None and met[-1:] != [now]:
            met.append(now)
    assert met == [0, 1, 2, 3, 4]


def lies_before(one: QWidget, other: QWidget) -> bool:
    """Say whether somebody who reads a column from the top down, and then the next one, comes to one first."""
    first, second = one.geometry(), other.geometry()
    if first.bottom() < second.top():
        return first.left() < second.right()
    return first.top() < second.bottom() and second.top() < first.bottom() and first.right() <= second.left()


def grouped(widget: QWidget) -> bool:
    """Say whether arrow keys, not Tab, reach a button, since another one of its group is down."""
    group = widget.group() if isinstance(widget, QAbstractButton) else None
    return group is not None and group.exclusive() and group.checkedButton() not in {None, widget}


def contrast(first: str, second: str) -> float:
    """The contrast ratio of two colours by WCAG 2.2."""

    def luminance(colour: str) -> float:
        shares = (QColor(colour).redF(), QColor(colour).greenF(), QColor(colour).blueF())
        red, green, blue = (s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4 for s in shares)
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue

    lighter, darker = sorted((luminance(first), luminance(second)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda theme: theme.name)
def test_text_stands_out_from_what_it_stands_on(theme: Theme):
    for background in (theme.window, theme.base, theme.field, theme.raised):
        for colour in (theme.text, theme.faint, theme.good, theme.bad):
            assert contrast(colour, background) >= TEXT, (colour, background)
    for background in (theme.accent, theme.bad):
        assert contrast(theme.on_colour, background) >= TEXT, background
    assert contrast(theme.signal, theme.base) >= LARGE
    assert contrast(theme.accent, theme.window) >= LARGE


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda theme: theme.name)
def test_letters_in_the_lane_can_be_read_on_their_colours(theme: Theme):
    for phoneme, colour in PHONEME_COLOURS.items():
        assert max(contrast("#ffffff", colour), contrast("#000000", colour)) >= TEXT, phoneme
