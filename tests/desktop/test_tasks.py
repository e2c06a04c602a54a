"""Work in the background: in turn, told in the thread of the window, ended when nobody wants it."""

import threading
from collections.abc import Callable, Iterator

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.errors import EngineError
from phonemeengine.execution import Progress, report_progress
from tests.desktop.hands import settle

HANG = 60


class Gate:
    """Work that goes on, or ends, when a test says so; it tells its progress until then."""

    def __init__(self, result: object = None, *, progress: float = 0.0) -> None:
        self.begun, self.opened = threading.Event(), threading.Event()
        self.ended = False
        self._result, self._progress = result, progress

    def __call__(self, progress: Progress) -> object:
        self.begun.set()
        while not self.opened.wait(0.005):
            report_progress(progress, self._progress)
        self.ended = True
        return self._result


class Told:
    """What a queue handed over, and in which threads."""

    def __init__(self) -> None:
        self.results: list[object] = []
        self.refusals: list[str] = []
        self.threads: set[int] = set()
        self.queue = TaskQueue(self.refuse)

    def take(self, result: object) -> None:
        self.results.append(result)
        self.threads.add(threading.get_ident())

    def refuse(self, sentence: str) -> None:
        self.refusals.append(sentence)
        self.threads.add(threading.get_ident())


@pytest.fixture
def told(qapp: QApplication) -> Iterator[Told]:
    told = Told()
    yield told
    told.queue.close()


def refused(_progress: Progress) -> None:
    raise EngineError("too loud")


def thread_of(_progress: Progress) -> int:
    return threading.get_ident()


def test_work_is_done_elsewhere_and_told_here(told: Told, qtbot: QtBot) -> None:
    told.queue.submit(thread_of, told.take)
    told.queue.submit(refused, told.take)
    assert told.queue.busy
    assert (told.results, told.refusals) == ([], [])
    qtbot.waitUntil(lambda: not told.queue.busy)
    assert told.results != [threading.get_ident()]
    assert told.refusals == ["too loud"]
    assert told.threads == {threading.get_ident()}


def test_one_task_follows_the_other(told: Told, qtbot: QtBot) -> None:
    first, second = Gate(1), Gate(2)
    second.opened.set()
    told.queue.submit(first, told.take)
    told.queue.submit(second, told.take)
    assert first.begun.wait(HANG)
    assert not second.begun.is_set()
    first.opened.set()
    qtbot.waitUntil(lambda: told.results == [1, 2])


def test_the_newest_takes_the_place_of_all_others(told: Told, qtbot: QtBot) -> None:
    old, never, new = Gate(1), Gate(2), Gate(3)
    new.opened.set()
    told.queue.submit(old, told.take)
    told.queue.submit(never, told.take)
    assert old.begun.wait(HANG)
    told.queue.replace(new, told.take)
    qtbot.waitUntil(lambda: not told.queue.busy)
    assert told.results == [3]
    assert (old.ended, never.begun.is_set()) == (False, False)


def test_nothing_is_told_of_what_was_cancelled(told: Told, qtbot: QtBot) -> None:
    gate = Gate(1)
    told.queue.submit(gate, told.take)
    assert gate.begun.wait(HANG)
    told.queue.cancel()
    assert not told.queue.busy
    gate.opened.set()
    told.queue.submit(lambda _progress: 2, told.take)
    qtbot.waitUntil(lambda: told.results == [2])


def test_progress_and_end_are_told_as_they_come(told: Told, qtbot: QtBot) -> None:
    gate, seen = Gate(progress=0.4), []
    told.queue.changed.connect(lambda: seen.append((told.queue.busy, told.queue.progress)))
    told.queue.idle.connect(lambda: seen.append("idle"))
    told.queue.submit(gate, told.take)
    qtbot.waitUntil(lambda: len(seen) == 2)
    assert seen[0] in {(True, 0.0), (True, 0.4)}  # the thread may be as far when its beginning is told
    assert seen[1] == (True, 0.4)
    gate.opened.set()
    qtbot.waitUntil(lambda: seen[2:] == [(False, 1.0), "idle"])


def test_what_is_no_refusal_is_raised_in_the_window(told: Told, qtbot: QtBot) -> None:
    with qtbot.captureExceptions() as raised:
        told.queue.submit(lambda _progress: 1 / 0, told.take)
        told.queue.submit(lambda _progress: 2, told.take)
        qtbot.waitUntil(lambda: told.results == [2])  # the next one is done all the same
    assert [kind for kind, *_ in raised] == [ZeroDivisionError]


def test_finishing_waits_for_all_that_was_submitted_and_tells_nothing(told: Told, qtbot: QtBot) -> None:
    written: list[int] = []
    told.queue.submit(lambda _progress: written.append(1), told.take)
    told.queue.submit(lambda _progress: written.append(2), told.take)
    told.queue.finish()
    assert written == [1, 2]
    settle()  # what the threads sent lies in the event loop
    assert told.results == []


def test_closing_ends_what_tells_its_progress(told: Told) -> None:
    gate, never = Gate(), Gate()
    told.queue.submit(gate, told.take)
    told.queue.submit(never, told.take)
    told.queue.close()
    assert (gate.ended, never.begun.is_set()) == (False, False)


@pytest.fixture
def stuck() -> Iterator[Callable[[Progress], None]]:
    released = threading.Event()
    yield lambda _progress: released.wait(HANG) and None
    released.set()


def test_work_that_hangs_is_left_alone_after_a_while(told: Told, stuck: Callable[[Progress], None]) -> None:
    told.queue.submit(stuck, told.take)
    told.queue.finish(timeout=0.01)
    assert not told.queue.busy
