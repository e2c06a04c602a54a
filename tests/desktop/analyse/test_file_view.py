"""The file on its own time: what is painted where, and what wheel, mouse and keys do."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest

from phonemeanalyser.desktop.analyse.lanes.file_layout import LANE_HEIGHT, LEFT
from phonemeanalyser.desktop.analyse.lanes.file_view import FileView
from phonemeanalyser.desktop.session.label_tiers import ChosenLabel, LabelState
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.talk.words.sound_words import KnownWords
from phonemeanalyser.desktop.theme import PHONEME_COLOURS
from phonemeengine.dsp.sonagram import FrequencyAxis
from phonemeengine.labels.textgrid import Tier
from phonemeengine.labels.utterance import Phone, RawLabel, Syllable, Utterance, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD
from tests.desktop.hands import CARDS, click, press, shown, turn_wheel


@pytest.fixture
def panel(desktop, qtbot):
    window = shown(desktop, qtbot)
    qtbot.waitUntil(lambda: not desktop.session.whole.busy)
    panel = window.analysis.file
    qtbot.waitUntil(lambda: bool(desktop.session.sonagram.tiles_for(desktop.session.view.seen, 400)))
    return panel


def turn(view: FileView, x: float, notches: int, modifiers=Qt.KeyboardModifier.NoModifier) -> None:
    turn_wheel(view, notches, QPointF(x, 20), modifiers)


def drag(view: FileView, begin: float, end: float, modifiers=Qt.KeyboardModifier.NoModifier) -> None:
    left = Qt.MouseButton.LeftButton
    QTest.mousePress(view, left, modifiers, QPoint(round(begin), 20))
    for x in np.linspace(begin, end, 4)[1:]:
        QTest.mouseMove(view, QPoint(round(x), 20))
    QTest.mouseRelease(view, left, modifiers, QPoint(round(end), 20))


def test_an_opened_file_is_painted_at_once_and_a_microphone_scrolls_by(desktop, panel):
    view, tracks, seen = panel.view, desktop.session.whole.tracks, desktop.session.view.seen
    page, picture = desktop.window.analysis, view.grab().toImage()
    assert page.over_time.currentWidget() is panel
    lane = view.file_layout.rows()[1]
    y = round(lane.top()) + 2
    for share in (0.11, 0.35, 0.52, 0.77):
        time = seen.start + share * seen.seconds
        around = tracks.phonemes[round(time / FRAME_PERIOD) - 3 : round(time / FRAME_PERIOD) + 3]
        if len(set(around.tolist())) == 1:
            expected = QColor(PHONEME_COLOURS[Phoneme(int(around[0]))])
            assert QColor(picture.pixel(round(view.file_layout.x_of(time)), y)) == expected
    assert lane.height() == LANE_HEIGHT
    for k, least in ((0, 50), (2, 2), (3, 2)):  # sonagram, waveform and course
        row = view.file_layout.rows()[k]
        ys = range(round(row.top()) + 1, round(row.bottom()) - 1, 2)
        found = {picture.pixel(x, y) for x in range(LEFT + 2, LEFT + view.file_layout.width - 2, 3) for y in ys}
        assert len(found) >= least, k
    desktop.session.set_source(SourceKind.TONE)
    assert page.over_time.currentWidget() is page.scroll_view
    desktop.session.set_source(SourceKind.FILE)
    assert page.over_time.currentWidget() is panel


def test_wheel_arrows_and_buttons_scroll_and_zoom_and_the_page_turns_with_what_is_heard(desktop, panel):
    view, time, session = panel.view, desktop.session.view, desktop.session
    seen, x = time.seen, LEFT + 0.3 * panel.view.file_layout.width
    under = view.file_layout.time_at(x)
    turn(view, x, 3)
    assert time.seen.seconds == pytest.approx(seen.seconds * 0.8**3)
    assert view.file_layout.time_at(x) == pytest.approx(under)
    before = time.seen
    turn(view, x, -1, Qt.KeyboardModifier.ShiftModifier)
    assert time.seen.start > before.start
    assert time.seen.seconds == pytest.approx(before.seconds)
    assert not panel.selection.isEnabled()
    expected = sorted((view.file_layout.time_at(LEFT + 150), view.file_layout.time_at(LEFT + 60)))
    drag(view, LEFT + 150, LEFT + 60, Qt.KeyboardModifier.ShiftModifier)
    assert time.selection == pytest.approx(expected)
    click(panel.selection)
    assert time.seen == pytest.approx(expected)
    click(panel.whole)
    assert time.seen == TimeSpan(0, session.source.duration)
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, pos=QPoint(LEFT + 50, 20))
    assert time.selection is None
    time.show(TimeSpan(1.0, 2.0))
    view.setFocus()
    for key, span in ((Qt.Key.Key_Right, (1.5, 2.5)), (Qt.Key.Key_Up, (1.6, 2.4)), (Qt.Key.Key_Down, (1.5, 2.5))):
        QTest.keyClick(view, key)
        assert time.seen == pytest.approx(span)
    press(desktop.window, Qt.Key.Key_End)
    assert session.source.position == pytest.approx(session.source.duration, abs=0.02)
    press(desktop.window, Qt.Key.Key_Home)
    assert session.source.position == 0
    assert time.seen.start == 0
    time.show(TimeSpan(0.0, 0.5))
    session.seek(2.0)
    assert time.seen.start < 2.0 < time.seen.end
    click(panel.follow)
    assert not time.follows
    session.seek(0.1)
    assert time.seen.start > 0.1


def test_a_drag_scrolls_and_a_click_goes_there(desktop, panel, qtbot):
    time = desktop.session.view
    time.show(TimeSpan(1.0, 2.0))
    drag(panel.view, LEFT + 200, LEFT + 100)
    assert time.seen.start == pytest.approx(1 + 100 / panel.view.file_layout.width, abs=0.02)
    assert desktop.session.source.position == 0
    at = panel.view.file_layout.time_at(LEFT + 50)
    QTest.mouseClick(panel.view, Qt.MouseButton.LeftButton, pos=QPoint(LEFT + 50, 20))
    assert desktop.session.source.position == pytest.approx(at, abs=0.02)
    panel.view.grab()  # asks for what is seen now
    qtbot.waitUntil(lambda: not desktop.session.busy)
    kept = panel.view.grab().toImage()
    desktop.session.labels.changed.emit()
    assert panel.view.grab().toImage() == kept  # all is painted anew


def test_another_axis_is_measured_anew_and_another_variable_drawn(desktop, panel, qtbot):
    before = panel.view.grab().toImage()
    desktop.window.analysis.sonagram.axis.setCurrentIndex(1)
    assert desktop.session.sonagram.settings.axis is FrequencyAxis.MEL
    sonagram, width = desktop.session.sonagram, panel.view.file_layout.width
    qtbot.waitUntil(lambda: bool(sonagram.tiles_for(desktop.session.view.seen, width)))
    qtbot.waitUntil(lambda: panel.view.grab().toImage() != before)
    before = panel.view.grab().toImage()
    desktop.window.analysis.courses.choose("volume")
    assert list(panel.view.course_rows()) == ["volume"]
    assert panel.view.grab().toImage() != before


def test_what_is_drawn_over_the_sonagram_is_seen_read_out_and_switched_off(desktop, panel, qtbot):
    view, sonagram = panel.view, panel.view.file_layout.rows()[0]
    loud = int(desktop.session.whole.tracks.intensities.argmax())
    desktop.session.view.show(TimeSpan(loud * FRAME_PERIOD - 0.3, loud * FRAME_PERIOD + 0.3))
    tiles, width = desktop.session.sonagram, view.file_layout.width
    qtbot.waitUntil(lambda: len(tiles.tiles_for(desktop.session.view.seen, width)) > 0)
    for x in (LEFT + 5, round(view.file_layout.x_of(loud * FRAME_PERIOD))):
        QTest.mouseMove(view, QPoint(x, round(sonagram.center().y())))
    before, words = view.grab(sonagram.toRect()).toImage(), view.reading()
    assert "Hz" in words
    for name, told in (("formants", "F1 "), ("pitch", "f0 "), ("level", "level "), ("feeling", "Activation ")):
        desktop.window.analysis.sonagram.overlays[name].trigger()
        qtbot.waitUntil(lambda told=told: told in view.reading())
        assert told not in words
        assert view.grab(sonagram.toRect()).toImage() != before
        desktop.window.analysis.sonagram.overlays[name].trigger()
        assert told not in view.reading()


def test_without_a_file_nothing_is_painted_and_nothing_breaks(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    view = window.analysis.file.view
    view.resize(600, 300)
    view.grab()
    turn(view, 100, 2)
    drag(view, 100, 200)
    assert CARDS.exists()


def test_words_and_phones_lie_on_the_same_time(desktop, qtbot):
    window = shown(desktop, qtbot)
    view = window.analysis.file.view
    phones = (Phone(0.5, 1.0, "a", Phoneme.A), Phone(1.0, 1.5, "o", Phoneme.O))
    word = Word("hallo", (Syllable(phones),))
    desktop.talking.text.words.put(KnownWords(Utterance((word,), desktop.session.source.duration)))
    lanes = {lane.name: (row, lane) for row, lane in view.file_layout.spoken_rows()}
    assert list(lanes) == ["Words", "Syllables"]  # the labels have phones
    row, lane = lanes["Words"]
    assert lane.texts == ["hallo"]
    rows = view.file_layout.rows()
    assert rows[1].bottom() < row.top() < row.bottom() < rows[2].top()

    def is_read() -> bool:
        under = {lane.name: row for row, lane in view.file_layout.spoken_rows()}["Words"]  # it may move meanwhile
        QTest.mouseMove(view, QPointF(view.file_layout.x_of(1.2), under.center().y()).toPoint())
        return "Words: hallo" in view.reading()

    qtbot.waitUntil(is_read)
    desktop.talking.text.words.put(
        KnownWords(Utterance((Word("", (Syllable(phones),)),), desktop.session.source.duration))
    )
    assert view.file_layout.spoken_rows() == []  # a file of phones names no words, and none are made up
    tier = Tier("words", (RawLabel(0.5, 1.5, "hallo", ""),))
    desktop.session.labels.put(LabelState((tier,), (0,), 0))
    assert [lane.name for _, lane in view.file_layout.spoken_rows()] == ["Phones"]
    window.analysis.sonagram.overlays["words"].setChecked(False)
    assert view.file_layout.spoken_rows() == []


def test_a_point_of_a_tier_has_its_name_from_there_to_the_next_and_cannot_be_dragged(desktop, qtbot):
    layout = shown(desktop, qtbot).analysis.file.view.file_layout
    marks = Tier("marks", (RawLabel(0.5, 0.5, "breath", ""), RawLabel(1.5, 1.5, "click", "")), points=True)
    words = Tier("words", (RawLabel(0.5, 1.0, "hallo", ""),))
    desktop.session.labels.put(LabelState((marks, words), (0, 1), 1))
    (_, points), (_, spans) = layout.label_lanes()
    assert (points.starts.tolist(), points.ends.tolist()) == ([0.5, 1.5], [1.5, desktop.session.labels.duration])
    assert (points.are_points, points.movable) == (True, False)
    assert (spans.are_points, spans.movable) == (False, True)
    assert layout.label_lanes()[1][1] is spans
    desktop.session.labels.choose(ChosenLabel(1, 0))
    assert layout.label_lanes()[1][1].colours.tolist() != spans.colours.tolist()


def test_the_fields_of_the_sonagram_are_reached_by_keys_and_the_wheel_changes_none(desktop, panel):
    choices = desktop.window.analysis.sonagram
    menu = choices.axis.window()
    menu.popup(QPoint())
    keys = Qt.Key.Key_Down, Qt.Key.Key_Tab, Qt.Key.Key_Tab, Qt.Key.Key_Tab, Qt.Key.Key_Backtab
    for key, field in zip(
        keys, (choices.axis, choices.top, choices.window_length, choices.low, choices.window_length), strict=True
    ):
        QTest.keyClick(menu.focusWidget() or menu, key)
        assert menu.focusWidget() is field
    assert not turn_wheel(choices.top, -1)
    menu.close()
    menu.popup(QPoint())
    assert menu.focusWidget() is None  # else Down would change a field
    menu.close()
