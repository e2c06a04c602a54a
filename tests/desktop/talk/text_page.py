"""What a person does with the text of the page of the head: writes, chooses the language, aligns, points."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.talk.words.text_panel import TextPanel
from phonemeanalyser.desktop.window import MainWindow
from tests.desktop.hands import press

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


def panel(window: MainWindow) -> TextPanel:
    return window.talk.text


def choose(window: MainWindow, language: str) -> None:
    box = panel(window).language
    box.setFocus()
    box.field.selectAll()
    QTest.keyClicks(box.field, language)
    QTest.keyClick(box.field, Qt.Key.Key_Return)


def write(window: MainWindow, text: str) -> None:
    field = panel(window).field
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)


def aligned(window: MainWindow, qtbot: QtBot) -> None:
    write(window, "so oh")
    choose(window, "Engli")  # in German, too
    panel(window).field.setFocus()
    press(window, Qt.Key.Key_Return, CONTROL | SHIFT)
    qtbot.waitUntil(lambda: spoken(window))


def spoken(window: MainWindow) -> bool:
    """Say whether the timeline shows words."""
    return bool(len(window.talk.lanes.line.lanes[0].starts))


def place(window: MainWindow, lane: int, seconds: float) -> QPoint:
    line = window.talk.lanes.line
    return QPoint(round(line.x_of(seconds)), round(line.rows()[lane][0].center().y()))


def lane_named(window: MainWindow, name: str) -> int:
    return [lane.name for lane in window.talk.lanes.line.lanes].index(name)


def middle_of(window: MainWindow, lane: int, span: int) -> QPoint:
    timeline = window.talk.lanes.line
    spans = timeline.lanes[lane]
    x = timeline.x_of(float(spans.starts[span] + spans.ends[span]) / 2)
    return QPoint(round(x), round(timeline.rows()[lane][0].top()) + 8)
