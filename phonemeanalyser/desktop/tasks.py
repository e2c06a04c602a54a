"""The one way to do work in the background: a queue whose results come back in the thread of the window."""

import threading
from collections import deque
from collections.abc import Callable
from typing import Any, TypeVar

from PySide6.QtCore import QObject, Qt, Signal

from phonemeengine.errors import EngineError
from phonemeengine.execution import Cancelled, Progress

Result = TypeVar("Result")
CLOSE_TIMEOUT = 1.0
"""Seconds after which the end of the program waits no longer for work of which nothing stays."""
STEPS = 100
"""In how many steps the progress of a task is reported."""


class Task:
    """A piece of work: what is done, and what becomes of the result."""

    def __init__(self, act: Callable[[Progress], Any], then: Callable[[Any], object]) -> None:
        self.act = act
        self.then = then
        self.progress = 0.0
        self.cancelled = False
        self.result: Any = None
        self.error: Exception | None = None
        self.thread: threading.Thread | None = None


class TaskQueue(QObject):
    """Does one task after another in the background; its owner has one for each kind of work.

    Result, refusal and progress arrive by queued signals, so in the thread in which the queue was made, while its
    event loop runs. The threads are daemons, unlike those of a pool: the program's end waits for none that hangs.

    Parameters
    ----------
    on_error : given the sentence of what the engine refused; any other exception is raised in the window's thread.

    Signals
    -------
    changed : work was begun, cancelled or done, or is farther by a hundredth.
    idle : a task has ended, and no other is wanted.
    """

    changed = Signal()
    idle = Signal()
    _ended = Signal(object)
    _moved = Signal()

    def __init__(self, on_error: Callable[[str], object]) -> None:
        super().__init__()
        self._on_error = on_error
        self._tasks: deque[Task] = deque()
        self._ended.connect(self._hand_over, Qt.ConnectionType.QueuedConnection)
        self._moved.connect(self.changed, Qt.ConnectionType.QueuedConnection)

    @property
    def busy(self) -> bool:
        """Whether there is work that is wanted."""
        return any(not task.cancelled for task in self._tasks)

    @property
    def progress(self) -> float:
        """How much of the task at hand is done, 0..1."""
        return self._tasks[0].progress if self._tasks else 1.0

    def submit(self, act: Callable[[Progress], Result], then: Callable[[Result], object] = lambda _: None) -> None:
        """Do this when all else is done; `then` is given what came of it."""
        self._tasks.append(Task(act, then))
        self._start_next()
        self.changed.emit()

    def replace(self, act: Callable[[Progress], Result], then: Callable[[Result], object]) -> None:
        """Do this, and cancel whatever else was to be done."""
        self.cancel()
        self.submit(act, then)

    def cancel(self) -> None:
        """End all work; nothing is handed over of it."""
        if self.busy:
            for task in self._tasks:
                task.cancelled = True
            self.changed.emit()

    def finish(self, timeout: float | None = None) -> None:
        """Do all that was submitted, wait for it, and hand nothing over.

        Parameters
        ----------
        timeout : seconds after which each task is left alone; None waits for ever.
        """
        while self._tasks:
            self._start_next()
            if self._tasks and (thread := self._tasks.popleft().thread) is not None:
                thread.join(timeout)

    def close(self, timeout: float | None = None) -> None:
        """End all work, and wait for what cannot be ended on its way.

        Parameters
        ----------
        timeout : seconds after which that is left alone, for work of which nothing stays; None waits for ever.
        """
        self.cancel()
        self.finish(timeout)

    def _start_next(self) -> None:
        while self._tasks and self._tasks[0].thread is None:
            if self._tasks[0].cancelled:
                self._tasks.popleft()
            else:
                task = self._tasks[0]
                task.thread = threading.Thread(target=self._run, args=(task,), daemon=True)
                task.thread.start()

    def _run(self, task: Task) -> None:
        """Work in the task's own thread."""

        def report(share: float) -> bool:
            moved = int(STEPS * share) != int(STEPS * task.progress)
            task.progress = share
            if moved:
                self._moved.emit()
            return not task.cancelled

        try:
            task.result = task.act(report)
        except Exception as error:  # noqa: BLE001 - raised again in the window's thread
            task.error = error
        self._ended.emit(task)

    def _hand_over(self, task: Task) -> None:
        if task not in self._tasks:
            return  # the queue was finished before
        self._tasks.remove(task)
        try:
            self._deliver(task)
        finally:
            self._start_next()
            self.changed.emit()
            if not self.busy:
                self.idle.emit()

    def _deliver(self, task: Task) -> None:
        if task.cancelled or isinstance(task.error, Cancelled):
            return
        if isinstance(task.error, EngineError):
            self._on_error(str(task.error))
        elif task.error is not None:
            raise task.error
        else:
            task.then(task.result)


def tried(act: Callable[[], object], say: Callable[[str], object]) -> bool:
    """Act, and say what is refused, or an empty sentence after it went well; returns whether it did."""
    try:
        act()
    except EngineError as error:
        say(str(error))
        return False
    say("")
    return True
