"""Where work is done that would hold up the window: one piece after another, each with its progress."""

import threading
from collections import deque
from collections.abc import Callable
from typing import Any, TypeVar

from phonemeanalyser.desktop.threads import start_thread
from phonemeengine.errors import EngineError
from phonemeengine.progress import Cancelled, Progress

Result = TypeVar("Result")


class Task:
    """A piece of work: what is done, and what becomes of the result."""

    def __init__(self, act: Callable[[Progress], Any], then: Callable[[Any], object]) -> None:
        self.share = 0.0
        self.cancelled = False
        self.then = then
        self.result: Any = None
        self.error: Exception | None = None
        self._act = act
        self.thread: threading.Thread | None = None

    def run(self) -> None:
        """Run the work, and keep its result or its error."""
        try:
            self.result = self._act(self._progress)
        except Exception as error:  # noqa: BLE001 - `see` raises it where it is seen
            self.error = error

    def _progress(self, share: float) -> bool:
        self.share = share
        return not self.cancelled


class TaskQueue:
    """Does one piece of work after another in the background; `see` hands over what came of it.

    Parameters
    ----------
    failed : told the sentence of what the engine refused.
    """

    def __init__(self, failed: Callable[[str], object]) -> None:
        self._failed = failed
        self._pieces: deque[Task] = deque()

    @property
    def busy(self) -> bool:
        """Whether there is work that is wanted."""
        return any(not piece.cancelled for piece in self._pieces)

    @property
    def share(self) -> float:
        """How much of the work at hand is done, 0..1."""
        return self._pieces[0].share if self._pieces else 1.0

    def do(self, act: Callable[[Progress], Result], then: Callable[[Result], object]) -> None:
        """Do this when all else is done; `then` is given what came of it, when `see` is called."""
        self._pieces.append(Task(act, then))
        self._go_on()

    def instead(self, act: Callable[[Progress], Result], then: Callable[[Result], object]) -> None:
        """Do this, and end whatever else was to be done."""
        self.cancel()
        self.do(act, then)

    def cancel(self) -> None:
        """End all work; nothing is handed over of it."""
        for piece in self._pieces:
            piece.cancelled = True

    def see(self) -> bool:
        """Hand over what is done; says whether anything was. What is no refusal of the engine is raised."""
        seen = False
        while self._pieces and self._pieces[0].thread is not None and not self._pieces[0].thread.is_alive():
            piece = self._pieces.popleft()
            seen = True
            try:
                self._hand_over(piece)
            finally:
                self._go_on()
        return seen

    def close(self) -> None:
        """Wait until what was begun is done; work that tells its progress ends early."""
        while self._pieces:
            thread = self._pieces.popleft().thread
            if thread is not None:
                thread.join()
            self._go_on()

    def _hand_over(self, piece: Task) -> None:
        if piece.cancelled or isinstance(piece.error, Cancelled):
            return
        if isinstance(piece.error, EngineError):
            self._failed(str(piece.error))
        elif piece.error is not None:
            raise piece.error
        else:
            piece.then(piece.result)

    def _go_on(self) -> None:
        while self._pieces and self._pieces[0].thread is None:
            if self._pieces[0].cancelled:
                self._pieces.popleft()
            else:
                self._pieces[0].thread = start_thread(self._pieces[0].run)
