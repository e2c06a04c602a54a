"""The time line: spans are where their times are, and a boundary goes where it is dragged, but no farther."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.theme import LIGHT
from phonemeanalyser.desktop.widgets.timeline import GAP, HEADING, HEIGHT, LEFT, Chapter, Lane, Timeline, TimelineView
from phonemeengine.settings import FRAME_PERIOD

BUTTON = Qt.MouseButton.LeftButton
RED, BLUE, BASE = "#c04040", "#4040c0", LIGHT.base
SCALE = 4.0
"""Pixels of a frame: 400 of a second."""
WORDS, PHONES = 0, 1


def lane(name: str, *spans: tuple[float, float, str, str], movable: bool = False, marked: int | None = None) -> Lane:
    starts, ends, texts, colours = zip(*spans, strict=True)
    codes = np.array([QColor(colour).rgb() for colour in colours], np.uint32)
    marks = frozenset() if marked is None else frozenset({marked})
    return Lane(name, np.array(starts), np.array(ends), texts, codes, marks, movable)


@pytest.fixture
def view(qtbot: QtBot) -> TimelineView:
    """Two words with a pause between them, and their phones, in 2 s."""
    view = TimelineView(Timeline(LIGHT))
    qtbot.addWidget(view)
    words = lane("words", (0.2, 0.5, "how", RED), (0.8, 1.1, "are", RED), marked=1)
    phones = lane("phones", (0.2, 0.3, "h", RED), (0.3, 0.5, "aʊ", BLUE), (0.8, 1.1, "ɑ", RED), movable=True)
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


def drag(view: TimelineView, number: int, begin: float, end: float) -> None:
    QTest.mousePress(view, BUTTON, pos=at(view, begin, number))
    QTest.mouseMove(view, at(view, end, number))
    QTest.mouseRelease(view, BUTTON, pos=at(view, end, number))


def test_spans_have_their_colours_and_pauses_have_none(view: TimelineView) -> None:
    assert colours(view, PHONES, 0.1, 0.25, 0.4, 0.6, 0.9, 1.5) == [BASE, RED, BLUE, BASE, RED, BASE]


def test_a_marked_span_is_hatched_and_another_is_not(view: TimelineView) -> None:
    row = [set(colours(view, WORDS, *np.arange(first + 0.01, first + 0.25, 0.005))) for first in (0.2, 0.8)]
    assert row[0] == {RED}
    assert row[1] == {RED, QColor(LIGHT.bad).name()}


def test_a_click_tells_lane_and_span_and_a_pause_nothing(view: TimelineView) -> None:
    clicked: list[tuple[int, int]] = []
    twice: list[tuple[int, int]] = []
    view.span_clicked.connect(lambda *span: clicked.append(span))
    view.span_double_clicked.connect(lambda *span: twice.append(span))
    for number, seconds in ((WORDS, 0.3), (PHONES, 0.4), (PHONES, 0.6), (PHONES, 1.0)):
        QTest.mouseClick(view, BUTTON, pos=at(view, seconds, number))
    QTest.mouseDClick(view, BUTTON, pos=at(view, 1.0, WORDS))
    assert clicked[:3] == [(WORDS, 0), (PHONES, 1), (PHONES, 2)]
    assert twice == [(WORDS, 1)]


@pytest.mark.parametrize(
    ("begin", "end", "moved"),
    [
        (0.3, 0.35, (PHONES, 2, 0.35)),  # where two touch, it is the start of the second
        (0.5, 0.7, (PHONES, 3, 0.7)),
        (0.5, 1.0, (PHONES, 3, 0.8)),  # no farther than the next span
        (0.3, 0.1, (PHONES, 2, 0.21)),  # a frame is left of the first one
        (0.8, 1.5, (PHONES, 4, 1.09)),
        (1.1, 5.0, (PHONES, 5, 2.0)),  # nor beyond the sound
    ],
)
def test_a_boundary_goes_where_it_is_dragged_but_never_through_its_neighbours(
    view: TimelineView, begin: float, end: float, moved: tuple[int, int, float]
) -> None:
    told: list[tuple[int, int, float]] = []
    view.boundary_moved.connect(lambda *boundary: told.append(boundary))
    drag(view, PHONES, begin, end)
    assert told == [(*moved[:2], pytest.approx(moved[2], abs=1 / SCALE * FRAME_PERIOD))]


def test_a_lane_that_is_not_movable_and_a_boundary_that_is_let_go_at_once_do_not_move(view: TimelineView) -> None:
    told: list[object] = []
    view.boundary_moved.connect(lambda *boundary: told.append(boundary))
    drag(view, WORDS, 0.5, 0.6)
    QTest.mouseClick(view, BUTTON, pos=at(view, 0.5, PHONES))
    assert told == []


def test_the_playhead_is_followed_out_of_what_is_seen(view: TimelineView) -> None:
    view.lanes.scale = 12.0
    view.show_time(0.3)
    view.show_playhead(0.3)
    assert view.lanes.first == 0
    view.show_playhead(1.5)
    assert LEFT <= view.lanes.x_of(1.5) < view.lanes.width()
    assert colours(view, WORDS, 1.5) == [LIGHT.accent]


def test_a_name_is_written_where_it_has_room(view: TimelineView) -> None:
    def letters() -> bool:
        picture, point = view.lanes.grab().toImage(), at(view, 0.35, WORDS)
        white = [
            picture.pixelColor(point.x() + dx, point.y() + dy).lightness()
            for dx in range(-3, 4)
            for dy in range(-4, 5)
        ]
        return max(white) > 200

    assert letters()
    view.lanes.scale = 0.3
    assert not letters()
