"""The text below the head, as a user meets it: typed, aligned, said, clicked and dragged."""

from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QSettings, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.session import SoundSource
from phonemeanalyser.desktop.talk.text_model import TextTools
from phonemeanalyser.desktop.talk.text_panel import NO_LANGUAGE, TextPanel
from phonemeanalyser.desktop.widgets.timeline import HEADING
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.labels.boundaries import LabelUnit, spans_of
from phonemeengine.labels.utterance import Utterance
from phonemeengine.labels.utterance_files import format_utterance
from tests.desktop.hands import LEFT, edits, press, shown, wav
from tests.desktop.stage import AN_A
from tests.desktop.talk.voices import LANGUAGES, FakeAligner, FakeVoice, word
from tests.desktop.test_window_sizes import SMALLEST, fits

DURATION = len(AN_A) / 44100
SAID = Utterance((word("so", 0.2, 0.6, 0.1), word("oh", 0.6, 1.1, 3.0)), DURATION, "en-us")
CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def voice() -> FakeVoice:
    return FakeVoice()


@pytest.fixture
def aligner() -> FakeAligner:
    return FakeAligner(SAID)


@pytest.fixture
def window(desktop: Desktop, qtbot: QtBot, tmp_path: Path, voice: FakeVoice, aligner: FakeAligner) -> MainWindow:
    """The page of the head, on a sound without labels."""
    desktop.talking.text.tools = TextTools(aligner.align, voice.speak, lambda: LANGUAGES)
    window = shown(desktop, qtbot, wav(tmp_path, AN_A, "said.wav"))
    window.show_page(2)
    qtbot.waitUntil(lambda: window.talk.text.language.count() == len(LANGUAGES) + 1)
    return window


def panel(window: MainWindow) -> TextPanel:
    return window.talk.text


def choose(window: MainWindow, language: str) -> None:
    box = panel(window).language
    box.setFocus()
    QTest.keyClicks(box, language)


def write(window: MainWindow, text: str) -> None:
    field = panel(window).field
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)


def aligned(window: MainWindow, qtbot: QtBot) -> None:
    write(window, "so oh")
    choose(window, "English")
    panel(window).field.setFocus()
    press(window, Qt.Key.Key_Return, CONTROL | SHIFT)
    qtbot.waitUntil(panel(window).lanes.isVisible)


def place(window: MainWindow, lane: int, seconds: float) -> QPoint:
    lanes = panel(window).lanes.lanes
    return lanes.mapTo(panel(window).lanes, QPoint(round(lanes.x_of(seconds)), HEADING + 10 + 22 * lane))


def test_what_is_typed_is_said_by_ctrl_return_in_the_language_that_is_chosen(window, voice, qtbot):
    write(window, "hello")
    choose(window, "German")
    panel(window).field.setFocus()
    press(window, Qt.Key.Key_Return, CONTROL)
    qtbot.waitUntil(lambda: window.transport.source.currentData() == SoundSource.TEXT)
    assert voice.asked == [("hello", "de")]
    qtbot.waitUntil(panel(window).lanes.isVisible)
    assert not panel(window).align.isEnabled()


def test_escape_stops_the_voice_while_the_text_has_the_focus(window, desktop, qtbot):
    write(window, "hello")
    choose(window, "German")
    panel(window).field.setFocus()
    press(window, Qt.Key.Key_Return, CONTROL)
    qtbot.waitUntil(lambda: desktop.session.playing)
    press(window, Qt.Key.Key_Escape)
    assert not desktop.session.playing


def test_letters_and_space_that_are_typed_hold_no_mouth_shape_and_play_nothing(window, desktop):
    write(window, "a house")
    assert panel(window).field.toPlainText() == "a house"
    assert not desktop.session.playing
    assert not desktop.talking.visemes.phonemes


def test_without_a_language_a_sentence_says_what_to_do(window):
    write(window, "so oh")
    assert panel(window).language.currentText() == NO_LANGUAGE
    panel(window).align.click()
    assert "choose it below the text" in window.banner.findChild(QLabel).text()


def test_the_lanes_are_words_syllables_and_phones_and_poor_words_are_marked(window, qtbot):
    aligned(window, qtbot)
    lanes = panel(window).lanes.lanes.lanes
    assert [(lane.name, list(lane.texts)) for lane in lanes] == [
        ("words", ["so", "oh"]), ("syllables", ["so", "so"]), ("phones", ["s", "o", "s", "o"]),
    ]  # fmt: skip
    assert lanes[0].marked == {1}


def test_a_click_on_a_word_plays_it(window, desktop, qtbot):
    aligned(window, qtbot)
    QTest.mouseClick(panel(window).lanes, LEFT, pos=place(window, 0, 0.8))
    assert desktop.session.playing
    qtbot.waitUntil(lambda: not desktop.session.playing)
    assert desktop.session.position >= 1.1


def test_a_boundary_is_dragged_and_undone_by_the_menu(window, desktop, qtbot):
    aligned(window, qtbot)
    lanes = panel(window).lanes
    QTest.mousePress(lanes, LEFT, pos=place(window, 0, 0.6))
    for seconds in (0.65, 0.7):
        QTest.mouseMove(lanes, place(window, 0, seconds))
    QTest.mouseRelease(lanes, LEFT, pos=place(window, 0, 0.7))
    assert spans_of(desktop.talking.text.utterance, LabelUnit.WORD)[1] == pytest.approx((0.7, 1.1), abs=0.01)
    assert "Undo boundary of a word" in edits(window)
    window.talk.head.setFocus()
    press(window, Qt.Key.Key_Z, CONTROL)
    assert desktop.talking.text.utterance is SAID


def test_labels_beside_the_sound_are_shown_at_once(window, desktop, qtbot, tmp_path):
    other = wav(tmp_path, AN_A, "other.wav")
    other.with_suffix(".TextGrid").write_text(format_utterance(SAID), encoding="utf-8")
    assert not panel(window).lanes.isVisible()
    window.dialogs.open_sound(other)
    qtbot.waitUntil(panel(window).lanes.isVisible)
    assert window.talk.save.isEnabled()


def test_the_page_fits_on_a_small_screen_with_lanes_and_a_sentence(window, qtbot):
    aligned(window, qtbot)
    window.banner.show_error("There is no text; write what is said into the field below the head.")
    qtbot.waitUntil(lambda: fits(window))
    window.resize(*SMALLEST)
    qtbot.waitUntil(lambda: (window.width(), window.height()) == SMALLEST)
    qtbot.wait(20)
    assert window.talk.head.height() > 100
    for part in (panel(window).field, panel(window).language, panel(window).say, panel(window).lanes):
        assert window.rect().contains(part.mapTo(window, part.rect().bottomRight()))


def test_text_language_and_lexicon_are_there_again_at_the_next_start(
    window, desktop, qapp, settings: QSettings, no_microphone, tmp_path, qtbot
):
    (tmp_path / "mine.csv").write_text("word,ipa\nso,soʊ\n", encoding="utf-8")
    write(window, "so oh")
    choose(window, "German")
    desktop.talking.text.set_lexicon(tmp_path / "mine.csv")
    qtbot.waitUntil(lambda: desktop.talking.text.lexicon_path is not None)
    desktop.save()
    again = Desktop(qapp, settings, microphone=no_microphone)
    texts = again.talking.text
    qtbot.waitUntil(lambda: texts.lexicon_path == tmp_path / "mine.csv")
    assert (texts.text, texts.language) == ("so oh", "de")
    again.close()
