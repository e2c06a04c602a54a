"""What explains the program from within: the manual, What Is This?, and the cards of the first start."""

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt, QUrl
from PySide6.QtGui import QHelpEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWhatsThis, QWidget

from phonemeanalyser.desktop.help import (
    PAGES,
    PASSAGES,
    ManualDialog,
    docs_folder,
    explanation_of,
    heading_at,
    page_text,
    passage,
    passage_for,
    slug_of,
    title_of,
)
from phonemeanalyser.desktop.language import use_language
from phonemeanalyser.desktop.session.sources import SourceKind
from tests.conftest import ROOT
from tests.desktop.accessible import controls_of
from tests.desktop.hands import CARDS, LEFT, shown


@pytest.fixture
def window(desktop, qtbot):
    return shown(desktop, qtbot)


def test_the_manual_has_a_passage_for_each_part_of_the_window():
    assert [kind for kind, place in PASSAGES.items() if len(passage(*place)) <= 40] == []


def test_the_pages_are_those_of_the_documentation():
    assert docs_folder() == ROOT / "docs"
    for page in PAGES:
        assert title_of(page)
        assert "](../screenshots" not in page_text(page)


def test_everything_that_one_can_use_or_read_explains_itself(window):
    for page in range(3):
        window.show_page(page)
        controls = {w: f"{type(w).__name__} {w.accessibleName()}" for w in controls_of(window)}
        assert [name for w, name in controls.items() if not explanation_of(w) or passage_for(w) is None] == []


def test_a_click_asks_and_the_answer_leads_into_the_manual(window):
    window.menus.actions["What Is This?"].trigger()
    assert QWhatsThis.inWhatsThisMode()
    QWhatsThis.leaveWhatsThisMode()
    box = window.preset_box
    QApplication.sendEvent(box, QHelpEvent(QEvent.Type.WhatsThis, QPoint(2, 2), box.mapToGlobal(QPoint(2, 2))))
    assert [w for w in QApplication.topLevelWidgets() if w.inherits("QWhatsThat") and w.isVisible()]
    QWhatsThis.hideText()
    text = explanation_of(box)
    assert "Presets" in text
    assert 'href="manual.md"' in text


def dialogs(window) -> list[ManualDialog]:
    return [w for w in window.findChildren(ManualDialog) if w.isVisible()]


def test_the_manual_opens_follows_links_and_finds_words(window, qtbot):
    window.menus.actions["Manual"].trigger()
    (dialog,) = dialogs(window)
    assert dialog.pages.currentItem().text() == title_of("manual")
    dialog.show_page("calibrating.md#on-the-command-line")
    assert dialog.pages.currentItem().text() == "Calibrate a preset"
    assert dialog.text.verticalScrollBar().value() > 0
    dialog.field.setText("mel bank")
    QTest.keyClick(dialog.field, Qt.Key.Key_Return)
    assert dialog.text.textCursor().selectedText().casefold() == "mel bank"
    assert dialog.field.hasFocus() or not dialog.isActiveWindow()
    dialog.reject()
    assert dialogs(window) == []


@pytest.fixture
def german(qapp):
    use_language(qapp, "de")
    yield
    use_language(qapp, "en")


def test_the_manual_of_a_german_window_has_german_pages(german, qtbot):
    dialog = ManualDialog(None)
    qtbot.addWidget(dialog)
    assert dialog.pages.currentItem().text() == "Das Fenster"
    for link, page in (
        ("presets.md#phonemedata-dateien", "Preset-Dateien"),
        ("../blender.md#mouth-table", "In Blender"),
        ("manual.md#die-ganze-datei", "Das Fenster"),
    ):
        dialog.text.anchorClicked.emit(QUrl(link))
        assert dialog.pages.currentItem().text() == page
    assert heading_at("manual", "the-whole-file") == heading_at("manual", "die-ganze-datei") == "Die ganze Datei"
    assert heading_at("manual", "nowhere") == ""


def test_what_is_this_answers_in_german(german):
    assert passage("manual", "Thresholds").startswith("**Schwellen**")
    assert passage("manual", "#The whole file").startswith("Eine geöffnete Datei")


def test_anchors_are_those_that_links_have():
    assert slug_of("The whole file") == "the-whole-file"
    assert slug_of("Files are heard better") == "files-are-heard-better"


def test_the_cards_come_once_and_lead_to_demo_microphone_and_calibration(desktop, window, qtbot):
    assert not window.welcome.isVisible()
    desktop.greet()
    assert window.welcome.isVisible()
    window.welcome.hide()
    assert QApplication.focusWidget() is window.analysis.main_view  # so that Space plays
    window.welcome.show_cards()
    assert all(card.isVisible() for card in window.welcome.cards)
    QTest.mouseClick(window.welcome.cards[1], LEFT)
    assert not window.welcome.isVisible()
    assert desktop.session.source.kind is SourceKind.MICROPHONE
    desktop.greet()
    assert not window.welcome.isVisible()
    window.menus.actions["First Steps…"].trigger()
    assert window.welcome.isVisible()
    desktop.demo = CARDS
    QTest.mouseClick(window.welcome.cards[0], LEFT)
    assert desktop.session.path == CARDS
    assert desktop.session.source.playing
    desktop.session.stop()
    window.welcome.show_cards()
    QTest.mouseClick(window.welcome.cards[2], LEFT)
    assert window.calibration.guide.isVisible()
    desktop.demo = None
    window.welcome.show_cards()
    QTest.mouseClick(window.welcome.cards[3], LEFT)  # which asks for no file, since one is open
    assert window.talk.tour.isVisible()


def test_the_cards_fit_into_a_small_window_and_go_at_escape_with_the_page_and_whatever_is_done(desktop, window):
    for act in (lambda: window.show_page(1), lambda: desktop.session.seek(0.5)):
        window.show_page(0)
        window.welcome.show_cards()
        act()
        assert not window.welcome.isVisible()
    window.resize(1024, 700)
    window.welcome.show_cards()
    QApplication.processEvents()
    page: QWidget = window.pages
    inside = page.rect().translated(page.mapTo(window, QPoint(0, 0)))
    assert inside.contains(window.welcome.geometry())
    QTest.keyClick(window.welcome, Qt.Key.Key_Escape)
    assert not window.welcome.isVisible()
