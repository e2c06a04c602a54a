"""The cores of this machine: processes that work through files."""

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import Any

from phonemeengine.batch.order import Order, act_of, worked_through
from phonemeengine.batch.work import Job, Outcome
from phonemeengine.execution import Progress, end_with_parent, single_threaded

WAITING = 2
"""Chunks that are given out for each process, so that none waits for the next."""
_STOP = 0
"""The place among the shares that says whether to stop."""


def n_cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class Pool:
    """Processes, started anew where one of them died.

    Parameters
    ----------
    n_processes : how many.
    order : what they do.
    recorded : whether it is asked what files are.

    Attributes
    ----------
    most_given : chunks that are given out at a time.
    deaths : what a future raises whose process died.
    """

    deaths: tuple[type[Exception], ...] = (BrokenProcessPool,)

    def __init__(self, n_processes: int, order: Order, *, recorded: bool) -> None:
        self.most_given = WAITING * n_processes
        self._n_processes, self._order, self._recorded = n_processes, order, recorded
        self._context = multiprocessing.get_context("spawn")
        self._begin()

    def give(self, jobs: Sequence[Job]) -> Future[list[Outcome]]:
        """Have some files worked through."""
        for future in [future for future in self._places if future.done()]:
            self._free.append(self._places.pop(future))
        place = self._free.pop()
        self._shares[place] = 0.0
        with _inherited():
            future = self._executor.submit(_work_through, Order(self._order.digest), jobs, place, self._recorded)
        self._places[future] = place
        return future

    def result_of(self, future: Future[list[Outcome]]) -> list[Outcome]:
        """Return what came of files that were given."""
        return future.result()

    def share_of(self, future: Future[list[Outcome]]) -> float:
        """Return how many files of what was given are done, and how much of the one at hand."""
        place = self._places.get(future)
        return 0.0 if place is None else float(self._shares[place])

    def restart(self) -> None:
        """Begin with new processes, after one of them died."""
        self._executor.shutdown()
        self._begin()

    def stop(self) -> None:
        """End all work as soon as may be; what is complete stays."""
        self._shares[_STOP] = 1.0
        self._executor.shutdown(wait=False, cancel_futures=True)

    def close(self) -> None:
        """Wait for the end of what was given, and end the processes."""
        self._executor.shutdown(cancel_futures=True)

    def _begin(self) -> None:
        self._shares: Any = self._context.RawArray("d", 1 + self.most_given)  # no lock: who dies would not let go
        self._free = list(range(1, 1 + self.most_given))
        self._places: dict[Future[list[Outcome]], int] = {}
        self._executor = ProcessPoolExecutor(
            self._n_processes, self._context, _begin_process, (self._order, self._shares)
        )


@contextmanager
def _inherited() -> Iterator[None]:
    """Have processes that are started leave Ctrl-C to this one, and have one thread each for their matrices."""
    if threading.current_thread() is not threading.main_thread():
        with single_threaded():
            yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with single_threaded():
            yield
    finally:
        signal.signal(signal.SIGINT, before)


_shares: Any = None
"""How far each chunk is, shared by the processes."""


def _begin_process(order: Order, shares: Any) -> None:
    global _shares, _order
    end_with_parent()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _shares, _order = shares, order


_order = Order("")
"""What this process does."""


def _work_through(order: Order, jobs: Sequence[Job], place: int, recorded: bool) -> list[Outcome]:
    assert order == _order

    def progress_of(number: int) -> Progress:
        def report(share: float) -> bool:
            _shares[place] = number + share
            return bool(_shares[_STOP] == 0)

        return report

    return worked_through(act_of(_order), jobs, progress_of, recorded=recorded)
