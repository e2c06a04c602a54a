"""The window with the head at 60 frames a second while it talks, drawn by the processor: all threads together.

The page of the head, and the dock beside the analysis.
"""

import json
import statistics
import tempfile
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDockWidget, QPlainTextEdit

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.talk.head.head_view import HeadView
from phonemeanalyser.desktop.window import ANALYSE, TALK
from phonemeengine.settings import FRAME_PERIOD
from tools.bench.desktop import live_for, shown_desktop, written_speech
from tools.bench.figures import Absolute, Figure, answer_of

WARM_UP, MEASURED = 3.0, 8.0
"""Seconds."""
LIMIT = 1.0
"""Of one core."""
LONGEST_TICK = 0.0003
LONGEST_KEY, N_KEYS = 0.016, 60
"""Seconds that a key may take in a long script, so that each picture of the window has what was typed; and keys."""
PICTURE, N_MOVES = 1 / 60, 40
"""Seconds in which a dragged key is seen in curve and head; and by how many moves of the mouse it is dragged."""
SCRIPT = "She sells sea shells, maybe, on the shore near my house. " * 160
"""About ten minutes of speech."""
UNDECIDED = 3
"""Frames between what the clock says and what has been shown."""


@dataclass(frozen=True)
class Cost:
    """What some seconds took: share of a core, heads drawn a second, frames never shown, and the model's tick."""

    share: float
    pictures: float
    missed: int
    tick: float


def figures() -> list[Figure]:
    """Measure page and dock, in a process of its own."""
    answer = answer_of("talking")
    keys, moves = answer.pop("keys"), answer.pop("moves")
    costs = {name: Cost(**cost) for name, cost in answer.items()}
    found = [
        Figure(
            f"window with the head, {name}",
            f"{cost.share:.0%} of a core, head {cost.pictures:.0f} fps",
            "one busy core",
            cost.share,
            limit=LIMIT,
            absolute=Absolute.WORK,
        )
        for name, cost in costs.items()
    ]
    missed, tick = sum(cost.missed for cost in costs.values()), max(cost.tick for cost in costs.values())
    return [
        *found,
        Figure(
            "the head's model, one tick",
            f"{1000 * tick:.2f} ms",
            "0.3 ms",
            tick / LONGEST_TICK,
            1.0,
            absolute=Absolute.TIME,
        ),
        Figure(
            "a key in a script of ten minutes",
            f"{1000 * statistics.median(keys):.1f} ms, slowest {1000 * max(keys):.0f} ms",
            f"{1000 * LONGEST_KEY:.0f} ms",
            statistics.median(keys) / LONGEST_KEY,
            1.0,
            absolute=Absolute.WORK,
        ),
        Figure(
            "a key of a blend shape dragged, until its curve and the head are painted",
            f"{1000 * statistics.median(moves):.1f} ms",
            f"{1000 * PICTURE:.1f} ms",
            statistics.median(moves) / PICTURE,
            1.0,
            absolute=Absolute.WORK,
        ),
        Figure("analyses missed with the head", f"{missed} frames", "none", float(missed), limit=0.0),
    ]


def main() -> None:
    """Measure, and print the costs as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        desktop = shown_desktop(Path(folder))
        window = desktop.window
        window.dialogs.open_sound(written_speech(Path(folder), 2 * (WARM_UP + MEASURED) + 10))
        window.show_page(TALK)
        page = _measured(desktop, window.talk.head)
        window.show_page(ANALYSE)
        next(d for d in window.findChildren(QDockWidget) if d.objectName() == "Head").show()
        dock = _measured(desktop, window.talk_parts.heads.by_name["dock"])
        window.show_page(TALK)
        moves, keys = _dragged(desktop), _typed(window.talk.text.field)
        desktop.close()
    print(json.dumps({"full page": asdict(page), "dock": asdict(dock), "keys": keys, "moves": moves}))


def _typed(field: QPlainTextEdit) -> list[float]:
    """Type at the beginning of a long script; returns the processor time of each key, seconds."""
    field.setPlainText(SCRIPT)
    seconds = []
    for key in "Papa may I have " * (N_KEYS // 16):
        live_for(0.05)
        began = time.process_time()
        QTest.keyClicks(field, key)
        field.repaint()
        seconds.append(time.process_time() - began)
    return seconds


def _dragged(desktop: Desktop) -> list[float]:
    """Drag a key of the jaw up and down; returns the processor time of each move until it is seen, seconds."""
    page, keys = desktop.window.talk, desktop.talking.keys
    lanes, surface = page.key_panel.lanes, page.head.surface
    assert surface is not None, page.head.trouble
    keys.set_open(True)
    while (curve := keys.curve_of("jawOpen")) is None:
        live_for(0.1)
    held = float(curve.points(0.5)[1])
    desktop.session.seek(held)
    live_for(1.0)
    row, place = lanes.rows()["jawOpen"], lanes.place_of("jawOpen", held).toPoint()
    QTest.mousePress(lanes, Qt.MouseButton.LeftButton, pos=place)
    seconds: list[float] = []
    for k in range(N_MOVES):
        live_for(0.05)
        while surface.due > time.monotonic():
            live_for(0.01)
        n_before, began = surface.n_drawn, time.process_time()
        QTest.mouseMove(lanes, QPoint(place.x(), round(row.top()) + 8 + k % 10 * 4))
        desktop.window.redraw.tick()
        lanes.repaint()
        surface.repaint()
        if surface.n_drawn > n_before:  # else the key was at an end of its lane before
            seconds.append(time.process_time() - began)
    QTest.mouseRelease(lanes, Qt.MouseButton.LeftButton, pos=place)
    return seconds


def _measured(desktop: Desktop, head: HeadView) -> Cost:
    session, ticks = desktop.session, _Ticks(desktop.talking.tick)
    desktop.talking.tick = ticks  # type: ignore[method-assign]
    session.play()
    live_for(WARM_UP)
    assert head.surface is not None, head.trouble
    n_frames, position, n_drawn = session.history.n, session.source.position, head.surface.n_drawn
    ticks.seconds.clear()
    wall, processor = time.perf_counter(), time.process_time()
    live_for(MEASURED)
    processor, wall = time.process_time() - processor, time.perf_counter() - wall
    session.poll()
    due = round((session.source.position - position) / FRAME_PERIOD)
    late = due - (session.history.n - n_frames)
    session.pause()
    pictures = (head.surface.n_drawn - n_drawn) / wall
    missed = session.source.player.n_dropped + max(0, late - UNDECIDED)
    return Cost(processor / wall, pictures, missed, statistics.median(ticks.seconds))


class _Ticks:
    """Times what it does."""

    def __init__(self, act: Callable[[], None]) -> None:
        self.seconds: list[float] = []
        self._act = act

    def __call__(self) -> None:
        began = time.perf_counter()
        self._act()
        self.seconds.append(time.perf_counter() - began)


if __name__ == "__main__":
    main()
