"""The text below the head, as a user meets it: typed, aligned, said, clicked and dragged."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QSettings, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.preset import PresetDocument
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.talk.drivers.driver_model import OTHER_PRESET
from phonemeanalyser.desktop.talk.words.text_model import TextTools
from phonemeanalyser.desktop.talk.words.text_panel import NO_LANGUAGE
from phonemeanalyser.desktop.talk.words.voice_model import VoiceChoice
from phonemeanalyser.desktop.talk.words.voice_panel import OWN_PROGRAM, OWN_SOUND, OWN_VOICE, VoicePanel
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.analyser import Analysis
from phonemeengine.labels.utterance import LabelUnit, Utterance, spans_of
from phonemeengine.labels.utterance_files import format_utterance, read_utterance
from phonemeengine.mouth.animation import FaceDriver
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.table_file import write_table
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.settings import FRAME_PERIOD
from tests.desktop.conftest import begin, settings_in
from tests.desktop.hands import LEFT, FileAnswers, answer, edits, press, settle, shown, type_number, wav
from tests.desktop.lent_window import WindowLender
from tests.desktop.stage import AN_A
from tests.desktop.talk.text_page import CONTROL, aligned, choose, lane_named, middle_of, panel, place, spoken, write
from tests.desktop.talk.voices import INSTALLED, LANGUAGES, FakeAligner, FakeVoice, word
from tests.desktop.test_window_sizes import SMALLEST, fits
from tests.engine.performance.test_track import recorded

DURATION = len(AN_A) / 44100
SAID = Utterance((word("so", 0.2, 0.6, 0.1), word("oh", 0.6, 1.1, 3.0)), DURATION, "en-us")


@pytest.fixture(scope="module")
def lender(qapp: QApplication, tmp_path_factory: pytest.TempPathFactory) -> Iterator[WindowLender]:
    """Lends a window with voices of its own."""
    folder = tmp_path_factory.mktemp("spoken")

    def make(settings: QSettings, microphone: Microphone) -> Desktop:
        desktop = knowing(begin(qapp, settings, microphone))
        desktop.window.talk.head.grab()  # which finds no OpenGL
        return desktop

    lender = WindowLender(make, settings_in(folder), folder, whole=True)
    yield lender
    lender.close()


def knowing(desktop: Desktop) -> Desktop:
    """Have a program know the voices of these tests, before it looks for others."""
    voice = desktop.talking.text.voice
    voice.look, voice.warm_up = lambda: INSTALLED, lambda: None
    return desktop


@pytest.fixture(autouse=True)
def seldom_drawn(request: pytest.FixtureRequest) -> None:
    """Have the head drawn where a test needs `graphics` only."""
    if "graphics" not in request.fixturenames:
        request.getfixturevalue("no_opengl")


@pytest.fixture
def voice() -> FakeVoice:
    return FakeVoice()


@pytest.fixture
def aligner() -> FakeAligner:
    return FakeAligner(SAID)


@pytest.fixture
def window(desktop: Desktop, qtbot: QtBot, tmp_path: Path, voice: FakeVoice, aligner: FakeAligner) -> MainWindow:
    """The page of the head, on a sound without labels."""
    knowing(desktop).talking.text.tools = TextTools(aligner.align, voice.speak)
    window = shown(desktop, qtbot, wav(tmp_path, AN_A, "said.wav"))
    window.show_page(2)
    qtbot.waitUntil(lambda: window.talk.text.language.count() == len(LANGUAGES) + 1)
    return window


def test_what_is_typed_is_said_by_ctrl_return_in_the_language_that_is_chosen_and_saved(
    window, desktop, voice, qtbot, tmp_path
):
    box, texts = panel(window).language, desktop.talking.text
    write(window, "hello")
    assert panel(window).field.toPlainText() == "hello"
    assert not desktop.session.source.playing
    assert not desktop.talking.visemes.phonemes
    assert box.currentText() == NO_LANGUAGE
    panel(window).act.click()
    assert "choose it beside the text" in window.banner.findChild(QLabel).text()
    panel(window).field.setPlainText("Guten Morgen, das ist ein schöner Tag, und wir gehen nicht nach Hause.")
    assert box.field.text() == "German (guessed)"
    for typed in ("britain", "klingon"):  # any part of a name finds a language, and what is none is forgotten
        choose(window, typed)
        panel(window).field.setFocus()
        assert texts.written.language == "en-gb"
        assert box.field.text() == "English (Great Britain)"
    assert box.itemData(1) == "en-gb"  # chosen last
    write(window, "hello")
    choose(window, "German")
    panel(window).field.setFocus()
    press(window, Qt.Key.Key_Return, CONTROL)
    qtbot.waitUntil(lambda: window.transport.source.currentData() == SourceKind.TEXT)
    assert voice.asked == [("hello", "de")]
    qtbot.waitUntil(lambda: spoken(window))
    assert panel(window).act.text() == "Speak"
    assert not window.talk.save_words.isEnabled()
    assert window.talk.save_speech.isEnabled()
    assert "fixed by the voice" in window.talk.lanes.summary.text()
    window.files.show = FileAnswers(tmp_path / "spoken")
    window.talk.save_speech.click()
    qtbot.waitUntil(lambda: "spoken.wav" in window.banner.label.text())
    write(window, ". ".join(["hello"] * 40))  # far more than is said until Escape
    press(window, Qt.Key.Key_Return, CONTROL)
    qtbot.waitUntil(lambda: desktop.session.source.playing)
    press(window, Qt.Key.Key_Escape)
    assert not desktop.session.source.playing


def test_a_spoken_text_is_opened_from_the_banner_and_labels_beside_a_sound_are_shown_at_once(
    window, desktop, qtbot, tmp_path
):
    write(window, "hello")
    choose(window, "German")
    window.files.show = FileAnswers(tmp_path / "spoken")
    window.talk.save_speech.click()
    qtbot.waitUntil(lambda: "spoken.wav" in window.banner.label.text())
    window.banner.action.click()
    assert desktop.session.path == tmp_path / "spoken.wav"
    qtbot.waitUntil(lambda: spoken(window))
    bare = wav(tmp_path, AN_A, "bare.wav")
    window.dialogs.open_sound(bare)
    qtbot.waitUntil(lambda: not spoken(window))
    other = wav(tmp_path, AN_A, "other.wav")
    other.with_suffix(".TextGrid").write_text(format_utterance(SAID), encoding="utf-8")
    window.dialogs.open_sound(other)
    qtbot.waitUntil(lambda: spoken(window))
    assert window.talk.save_words.isEnabled()


def test_the_tour_points_at_what_is_there_by_keyboard_and_is_left_by_escape(window, desktop, settings, qtbot):
    talk, tour = window.talk, window.talk.tour
    assert not tour.isVisible()
    window.menus.actions["Tour of Talk"].trigger()
    pointed_at = []
    while tour.isVisible():
        stop = tour.stops[tour.stop]
        pointed_at.append(stop.control)
        assert stop.control.isVisible()
        assert window.rect().contains(tour.geometry().translated(talk.mapTo(window, QPoint(0, 0))))
        assert QApplication.focusWidget() is tour.onward
        press(window, Qt.Key.Key_Return)
    assert pointed_at[0] is talk.text.field
    assert pointed_at[-1] is talk.export
    window.talk_parts.dialogs.show_tour()
    tour.onward.click()
    tour.back.click()
    assert tour.stop == 0
    press(window, Qt.Key.Key_Escape)
    assert not tour.isVisible()
    window.talk_parts.dialogs.show_first_tour()  # it was shown before
    assert not tour.isVisible()
    settings.remove("talk/toured")
    window.talk_parts.dialogs.show_first_tour()
    assert tour.isVisible()
    window.show_page(0)
    assert not tour.isVisible()


def test_the_lanes_are_words_syllables_and_phones_that_are_played_moved_and_undone_on_a_small_screen_too(
    window, desktop, qtbot
):
    aligned(window, qtbot)
    lanes = window.talk.lanes.line.lanes
    assert [(lane.name, list(lane.texts)) for lane in lanes] == [
        ("Words", ["so", "oh"]),
        ("Syllables", ["so", "so"]),
        ("Phones", ["s", "o", "s", "o"]),
        ("Feeling", []),
    ]
    assert lanes[0].marked == {1}  # a poor word
    QTest.mouseClick(window.talk.lanes.line, LEFT, pos=place(window, 0, 0.8))
    assert desktop.session.source.playing
    window.talk.text.refresh()
    (mark,) = window.talk.text.field.extraSelections()
    assert mark.cursor.selectedText() == "oh"
    heard: list[Analysis] = []
    desktop.session.analysed.connect(heard.extend)
    qtbot.waitUntil(lambda: not desktop.session.source.playing)
    assert heard[0].start == 60
    assert heard[-1].start + len(heard[-1]) == 110
    assert desktop.session.source.position == 0.6
    window.talk.text.refresh()
    assert not window.talk.text.field.extraSelections()
    drag_boundary(window)
    assert spans_of(desktop.talking.text.utterance, LabelUnit.WORD)[1] == pytest.approx((0.7, 1.1), abs=0.01)
    assert "Undo move of a boundary (word)" in edits(window)
    window.talk.head.setFocus()
    press(window, Qt.Key.Key_Z, CONTROL)
    assert desktop.talking.text.utterance is SAID
    window.banner.show_error("There is no text; type it into the field below the head.")
    qtbot.waitUntil(lambda: fits(window))
    window.resize(*SMALLEST)
    qtbot.waitUntil(lambda: (window.width(), window.height()) == SMALLEST)
    settle()
    assert window.talk.head.height() > 100
    for part in (panel(window).field, panel(window).language, panel(window).act, window.talk.lanes):
        assert window.rect().contains(part.mapTo(window, part.rect().bottomRight()))
    assert window.talk_parts.dialogs.may_leave_words()  # nothing is asked


def test_a_right_click_on_a_word_offers_what_changes_it(window, desktop, qtbot):
    aligned(window, qtbot)
    menu = window.talk.lanes.line.menu
    menu.open_at(place(window, 0, 0.8))
    menu.actions()[1].trigger()
    menu.close()
    assert [word.text for word in desktop.talking.text.utterance.words] == ["so"]
    menu.open_at(QPoint(1, 1))
    assert [action.isEnabled() for action in menu.actions()[:3]] == [False] * 3
    menu.close()


def test_after_a_click_on_align_space_is_not_typed_into_the_text(window, qtbot):
    aligned(window, qtbot)
    assert window.focusWidget() is panel(window).field
    panel(window).act.click()
    assert window.focusWidget() is not panel(window).field


def drag_boundary(window: MainWindow) -> None:
    """Drag the end of the first word from 0.6 s to 0.7 s."""
    lanes = window.talk.lanes.line
    QTest.mousePress(lanes, LEFT, pos=place(window, 0, 0.6))
    for seconds in (0.65, 0.7):
        QTest.mouseMove(lanes, place(window, 0, seconds))
    QTest.mouseRelease(lanes, LEFT, pos=place(window, 0, 0.7))


def test_who_moved_a_boundary_is_asked_before_another_sound_is_opened_and_when_he_quits(
    window, desktop, qtbot, tmp_path
):
    for button, gone in (("Cancel", False), ("Discard", True)):
        if not gone:
            aligned(window, qtbot)
            drag_boundary(window)
        told = answer(button)
        assert window.dialogs.open_sound(wav(tmp_path, AN_A, "other.wav")) is gone
        assert told == ["Save the boundaries that you moved in said.wav?"]
        assert (desktop.talking.text.utterance is None) is gone
    aligned(window, qtbot)
    drag_boundary(window)
    answer("Cancel")
    assert not window.close()
    target = tmp_path / "said.TextGrid"
    window.files.show = FileAnswers(target)
    answer("Save")
    assert window.talk_parts.dialogs.may_leave_words()
    assert spans_of(read_utterance(target, DURATION), LabelUnit.WORD)[0][1] == pytest.approx(0.7, abs=0.01)


# -- the voice ----------------------------------------------------------------------------------------


popping_up = pytest.mark.qt_log_ignore("does not support", extend=True)
"""Without a display nothing can be raised above the rest, nor take the keyboard from it."""


def opened(window: MainWindow, qtbot: QtBot) -> VoicePanel:
    """Open the panel of the voice by the keyboard."""
    panel(window).voice.setFocus()
    press(window, Qt.Key.Key_Space)
    below = panel(window).voice.panel
    qtbot.waitUntil(below.isVisible)
    return below


@popping_up
def test_voice_rate_mouth_and_a_program_of_ones_own_are_chosen_by_the_keyboard(window, desktop, qtbot):
    below = opened(window, qtbot)
    names = [below.name.itemText(k) for k in range(below.name.count())]  # women go before men, a program is the last
    assert names[2:-1] == ["f1 (female)", "f2 (female)", "m1 (male)", "croak", "klatt", "Reed"]
    assert (*names[:2], names[-1]) == (OWN_VOICE, OWN_SOUND, OWN_PROGRAM)
    QTest.keyClicks(below.name, "f2")
    QTest.keyClick(below.name, Qt.Key.Key_Return)
    type_number(below.rate, "5.5")
    below.driver.setFocus()
    QTest.keyClick(below.driver, Qt.Key.Key_End)
    texts = desktop.talking.text
    assert (texts.voice.choice.name, texts.voice.choice.rate) == ("f2", 5.5)
    assert texts.drivers.chosen is FaceDriver.RULES
    assert "f2, 5.5 syllables/s" in panel(window).voice.toolTip()
    assert not below.program.isVisible()
    below.name.setFocus()
    QTest.keyClick(below.name, Qt.Key.Key_End)
    assert below.program.isVisible()
    assert not below.rate.isEnabled()
    QTest.keyClicks(below.program, "mine {output}")
    QTest.keyClick(below.program, Qt.Key.Key_Return)
    assert (texts.voice.choice.by_program, texts.voice.choice.program) == (True, "mine {output}")
    QTest.keyClick(below, Qt.Key.Key_Escape)
    assert not below.isVisible()


def test_a_text_whose_place_a_script_has_taken_comes_back_by_undo(window, qtbot, tmp_path):
    write(window, "what I wrote")
    other = wav(tmp_path, AN_A, "other.wav")
    other.with_suffix(".txt").write_text("so oh", encoding="utf-8")
    window.dialogs.open_sound(other)
    qtbot.waitUntil(lambda: panel(window).field.toPlainText() == "so oh")
    panel(window).field.setFocus()
    press(window, Qt.Key.Key_Z, CONTROL)
    assert panel(window).field.toPlainText() == "what I wrote"


def test_text_voice_and_tables_are_there_again_at_the_next_start_unless_they_are_gone(
    window, desktop, qapp, settings: QSettings, no_microphone, tmp_path, qtbot, table
):
    (tmp_path / "mine.csv").write_text("word,ipa\nso,soʊ\n", encoding="utf-8")
    write(window, "so oh")
    choose(window, "German")
    chosen, texts = VoiceChoice("f2", 5.5, "mine {output} {text}", True), desktop.talking.text
    texts.voice.choose(**vars(chosen))
    texts.set_lexicon(tmp_path / "mine.csv")
    qtbot.waitUntil(lambda: texts.lexicon_path is not None)
    performance = texts.drivers.performance
    write_table(tmp_path / "ben.sqlite", [recorded("so")])
    for path in (tmp_path / "ben.sqlite", table):
        performance.open(path)
        qtbot.waitUntil(lambda path=path: performance.chosen == path)
    performance.set_choice(ExampleChoice.NEAREST)
    texts.drivers.choose(FaceDriver.RULES)
    texts.drivers.compare(FaceDriver.PINYIN)
    desktop.save()
    (tmp_path / "ben.sqlite").unlink()
    again = Desktop(qapp, settings, microphone=no_microphone)
    texts = again.talking.text
    restored = texts.drivers.performance
    assert restored.opened == ((tmp_path / "ben.sqlite", table), table)
    restored.wake()
    qtbot.waitUntil(lambda: restored.chosen == table)
    assert list(restored.known) == [table]
    assert restored.choice is ExampleChoice.NEAREST
    qtbot.waitUntil(lambda: texts.lexicon_path == tmp_path / "mine.csv")
    assert again.session.open(tmp_path / "said.wav")
    qtbot.waitUntil(lambda: texts.text == "so oh")
    assert texts.written.language == "de"
    assert texts.written.recent == ["de"]
    assert texts.voice.choice == chosen
    assert texts.drivers.chosen is FaceDriver.RULES
    assert again.window.talk.isEnabled()  # it is made when it is first asked for
    assert texts.drivers.compared is FaceDriver.PINYIN
    again.close()


# -- recorded faces -----------------------------------------------------------------------------------


@pytest.fixture
def table(tmp_path: Path, own_desktop: Desktop) -> Path:
    """A table of a synthetic performer who says "so"; a window knows it until it is closed."""
    write_table(tmp_path / "ann.sqlite", [replace(recorded("so so.so"), synthetic=True)])
    return tmp_path / "ann.sqlite"


def performed(window: MainWindow, desktop: Desktop, table: Path, qtbot: QtBot) -> None:
    """Have a face that is looked up."""
    desktop.talking.text.drivers.performance.open(table)
    aligned(window, qtbot)
    qtbot.waitUntil(lambda: bool(desktop.talking.text.drivers.performance.units))


@popping_up
def test_a_table_of_a_synthetic_performer_is_named_so_wherever_it_is_chosen_compared_and_played(
    window, desktop, voice, qtbot, table
):
    performance, original = desktop.talking.text.drivers.performance, desktop.talking.text.original
    actions = {action.data(): action for action in window.talk.comparisons.actions()}
    assert not actions[FaceDriver.TABLE].isEnabled()
    window.files.show = FileAnswers(table)
    aligned(window, qtbot)
    below = opened(window, qtbot)
    assert not below.choice.isVisible()
    below.table.setFocus()
    QTest.keyClick(below.table, Qt.Key.Key_End)
    qtbot.waitUntil(lambda: performance.chosen == table)
    assert not below.isVisible()
    qtbot.waitUntil(lambda: bool(performance.units))
    assert actions[FaceDriver.TABLE].isEnabled()
    told = list[str]()
    original.changed.connect(lambda: told.append(original.caption))  # it may be over before a slow machine looks
    units = lane_named(window, "Units")
    tips = window.talk.lanes.line.lanes[units].tips
    words = next(k for k, of in enumerate(tips) if "[s o s o] from so so.so, " in of)
    QTest.mouseClick(window.talk.lanes.line, LEFT, pos=middle_of(window, units, words))
    qtbot.waitUntil(lambda: bool(told))
    assert "so so.so, original recording" in told[0]
    press(window, Qt.Key.Key_Space)
    assert original.face is None
    panel(window).voice.click()
    assert below.table.currentText() == "ann (synthetic performer)"
    assert below.choice.isVisible()
    assert "ann (synthetic performer)" in panel(window).voice.toolTip()
    qtbot.waitUntil(lambda: window.talk.heads.main.caption.text() == "ann (synthetic performer)")
    below.choice.setFocus()
    QTest.keyClicks(below.choice, "random w")
    assert performance.choice is ExampleChoice.BAND
    QTest.keyClicks(below.name, "own")
    desktop.talking.text.say()
    qtbot.waitUntil(lambda: bool(voice.choices))
    assert voice.choices[0].recordings.table is performance.table
    below.table.setFocus()
    QTest.keyClick(below.table, Qt.Key.Key_Home)
    assert performance.chosen is None
    assert not window.talk.heads.main.caption.isVisible()


@pytest.mark.usefixtures("graphics")
def test_two_heads_are_compared_and_looked_at_alike(window, desktop, qtbot, table):
    performed(window, desktop, table, qtbot)
    actions = {action.text(): action for action in window.talk.comparisons.actions()}
    actions["With Phonemes (Rules)"].trigger()
    heads = window.talk.heads
    assert heads.beside.isVisible()
    assert heads.beside.caption.text() == "Phonemes (rules)"
    bar, comparison = window.talk.differences, desktop.talking.comparison
    qtbot.waitUntil(lambda: comparison.found is not None)
    assert bar.isVisible()
    assert bar.summary.text().startswith("Difference (RMS): 0.")
    bar.list.aboutToShow.emit()
    places = comparison.places
    assert bar.list.actions()[0].text().startswith(f"{places[0].time:.2f} s: ")
    bar.list.actions()[0].trigger()
    assert desktop.session.source.position == pytest.approx(places[0].time, abs=0.01)
    assert bar.next.isEnabled() == (len(places) > 1)
    qtbot.waitUntil(lambda: heads.beside.view.camera is not None)
    heads.beside.view.look(wireframe=True)
    assert heads.main.view.wireframe
    heads.main.view.move_light(0.3)
    assert heads.beside.view.light == heads.main.view.light
    window.resize(*SMALLEST)
    qtbot.waitUntil(lambda: fits(window))
    assert heads.main.view.width() > 100
    actions["No Comparison"].trigger()
    assert not heads.beside.isVisible()
    assert not bar.isVisible()


def test_a_second_head_moves_by_what_the_second_preset_recognises(window, desktop, qtbot):
    action = next(action for action in window.talk.comparisons.actions() if action.data() == OTHER_PRESET)
    assert not action.isEnabled()
    desktop.preset.set_other(PresetDocument.read(DEFAULT_PRESET))
    window.talk.comparisons.aboutToShow.emit()
    assert action.text() == f"With Preset B: {desktop.preset.other.preset.name}"
    action.trigger()
    comparison, beside = desktop.talking.comparison, desktop.talking.beside
    qtbot.waitUntil(lambda: comparison.found is not None and comparison.known is not None)
    assert beside.caption == f"B: {desktop.preset.other.preset.name}"
    assert desktop.talking.head.caption == desktop.preset.title
    second, said = desktop.session.second.whole.tracks, comparison.known
    heard = [said.run_at((k + 0.5) * FRAME_PERIOD).phoneme for k in range(second.n_frames)]
    assert heard == [Phoneme(code) for code in second.phonemes.tolist()]
    assert np.any(second.phonemes != desktop.session.whole.tracks.phonemes)
    desktop.preset.set_other(None)
    assert not desktop.talking.comparing
