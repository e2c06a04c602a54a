"""The timeline: spans are where their times are, and a click tells which one it was."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetrics
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.theme import LIGHT, shortened
from phonemeanalyser.desktop.widgets.lanes import BoundaryDrag, Lane, TimeAxis, lane_of_frames, wave_pixels
from phonemeanalyser.desktop.widgets.timeline import GAP, HEADING, HEIGHT, LEFT, Chapter, Timeline, TimelineView
from phonemeengine.dsp.waveform_peaks import Peaks
from phonemeengine.settings import FRAME_PERIOD
from tests.desktop.hands import turn_wheel

BUTTON = Qt.MouseButton.LeftButton
RED, BLUE, BASE = "#c04040", "#4040c0", LIGHT.base
SCALE = 4.0
"""Pixels of a frame: 400 of a second."""
WORDS, PHONES = 0, 1


def lane(name: str, *spans: tuple[float, float, str, str], marked: int | None = None) -> Lane:
    starts, ends, texts, colours = zip(*spans, strict=True)
    codes = np.array([QColor(colour).rgb() for colour in colours], np.uint32)
    marks = frozenset() if marked is None else frozenset({marked})
    return Lane(name, np.array(starts), np.array(ends), texts, codes, marks)


@pytest.fixture
def view(qtbot: QtBot) -> TimelineView:
    """Two words with a pause between them, and their phones, in 2 s."""
    view = TimelineView(Timeline(LIGHT))
    qtbot.addWidget(view)
    words = lane("words", (0.2, 0.5, "how", RED), (0.8, 1.1, "are", RED), marked=1)
    phones = lane("phones", (0.2, 0.3, "h", RED), (0.3, 0.5, "aʊ", BLUE), (0.8, 1.1, "ɑ", RED))
    view.lanes.scale = SCALE
    view.resize(LEFT + 800, 90)
    view.show_lanes((words, phones), 2.0, (Chapter(0.0, "take 1"),))
    view.show()
    return view


def at(view: TimelineView, seconds: float, number: int) -> QPoint:
    return QPoint(round(view.lanes.x_of(seconds)), HEADING + number * (HEIGHT + GAP) + HEIGHT // 2)


def colours(view: TimelineView, number: int, *times: float) -> list[str]:
    """The colours near the upper edge of a lane, where no letters stand."""
    picture = view.lanes.grab().toImage()
    points = [at(view, time, number) for time in times]
    return [picture.pixelColor(point.x(), point.y() - HEIGHT // 2 + 1).name() for point in points]


def test_spans_have_their_colours_and_pauses_have_none(view: TimelineView) -> None:
    assert colours(view, PHONES, 0.1, 0.25, 0.4, 0.6, 0.9, 1.5) == [BASE, RED, BLUE, BASE, RED, BASE]


def test_a_marked_span_is_hatched_and_another_is_not(view: TimelineView) -> None:
    row = [set(colours(view, WORDS, *np.arange(first + 0.01, first + 0.25, 0.005))) for first in (0.2, 0.8)]
    assert row[0] == {RED}
    assert row[1] == {RED, QColor(LIGHT.bad).name()}


def test_a_click_tells_lane_and_span_and_a_pause_nothing(view: TimelineView) -> None:
    clicked: list[tuple[int, int]] = []
    view.span_clicked.connect(lambda *span: clicked.append(span))
    for number, seconds in ((WORDS, 0.3), (PHONES, 0.4), (PHONES, 0.6), (PHONES, 1.0)):
        QTest.mouseClick(view, BUTTON, pos=at(view, seconds, number))
    assert clicked == [(WORDS, 0), (PHONES, 1), (PHONES, 2)]


def test_a_name_is_shortened_and_vanishes_only_where_a_letter_has_no_room(view: TimelineView) -> None:
    def letters() -> int:
        """Return how many columns of the first word have letters."""
        picture, y = view.lanes.grab().toImage(), at(view, 0.35, WORDS).y()
        left, right = (round(view.lanes.x_of(seconds)) for seconds in (0.2, 0.5))
        rows = range(y - 6, y + 7)
        return sum(max(picture.pixelColor(x, dy).lightness() for dy in rows) > 200 for x in range(left, right))

    columns = []
    for scale in (4.0, 0.5, 0.1):
        view.lanes.scale = scale
        columns.append(letters())
    assert columns[0] > columns[1] > 0
    assert columns[2] == 0


def test_frames_in_a_row_that_have_one_code_are_a_span_but_for_breaks() -> None:
    codes = np.array([0, 0, 1, 1, 1, 0])
    lane = lane_of_frames("said", codes, ["a", "u"], np.array([7, 8], np.uint32), first=10, breaks=[4])
    assert lane.starts.tolist() == pytest.approx([0.10, 0.12, 0.14, 0.15])
    assert lane.ends.tolist() == pytest.approx([0.12, 0.14, 0.15, 0.16])
    assert list(lane.texts) == ["a", "u", "u", "a"]
    assert lane.colours.tolist() == [7, 8, 8, 7]
    assert len(lane_of_frames("said", codes[:0], ["a"], np.zeros(1, np.uint32)).starts) == 0


def test_a_waveform_is_painted_from_its_lowest_to_its_highest_sample_in_colours_of_columns() -> None:
    peaks = Peaks(np.array([-1.0, 0.0, np.nan], np.float32), np.array([1.0, 0.5, np.nan], np.float32))
    painted = wave_pixels(peaks, 1.0, 9, 7, 0) == 7
    assert painted.sum(axis=0).tolist() == [9, 3, 0]
    assert painted[4, 1]
    assert not painted[5:, 1].any()
    by_column = wave_pixels(peaks, 1.0, 9, np.array([7, 8, 9], np.uint32), 0)
    assert by_column[4].tolist() == [7, 8, 0]


def test_a_span_keeps_what_its_lane_says_at_least() -> None:
    lane = Lane("", np.array([1.0]), np.array([2.0]), movable=True, least=0.25)
    axis, drag = TimeAxis(0, 300, 0.0, 3.0), BoundaryDrag()
    assert drag.press([(QRectF(0, 0, 300, 20), lane)], axis, QPointF(102, 5), 3.0) == (0, 0, 1.0)
    assert drag.move(1.9) == (0, 0, 1.75)
    assert drag.release() == (0, 0, 1.75)
    assert drag.press([(QRectF(0, 0, 300, 20), lane)], axis, QPointF(150, 5), 3.0) is None


def test_the_wheel_zooms_at_the_pointer_a_drag_scrolls_and_all_is_seen_in_any_width(view: TimelineView) -> None:
    view.lanes.scale = 10.0
    view.show_time(0.5)
    place = QPointF(LEFT + 200, 40)
    under = view.lanes.axis.time_at(place.x())
    turn_wheel(view, 1, place)
    assert view.lanes.scale == pytest.approx(12.0)
    assert view.lanes.axis.time_at(place.x()) == pytest.approx(under, abs=FRAME_PERIOD)
    first = view.lanes.first
    QTest.mousePress(view, BUTTON, pos=QPoint(LEFT + 300, 5))
    QTest.mouseMove(view, QPoint(LEFT + 240, 5))
    QTest.mouseRelease(view, BUTTON, pos=QPoint(LEFT + 240, 5))
    assert view.lanes.first == pytest.approx(first + 5)
    view.show_whole()
    for width in (LEFT + 800, LEFT + 300):
        view.resize(width, 90)
        assert (view.lanes.axis.start, view.lanes.axis.end) == pytest.approx((0.0, 2.0))


def test_a_letter_is_written_where_all_of_it_has_room(qapp: QApplication) -> None:
    metrics = QFontMetrics(qapp.font())
    for text in ("p", "m"):
        room = metrics.horizontalAdvance(text)
        assert [shortened(metrics, text, width) for width in (0, room - 1, room)] == ["", "", text]
