"""Work as it goes to other processes on the cores of this machine, and how a file is worked on there."""

import copyreg
import errno
import io
import logging
import multiprocessing
import os
import pickle
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

from typing_extensions import override

from phonemeengine.audio.files import SoundReader
from phonemeengine.batch.remote import fetched, is_remote
from phonemeengine.batch.work import Act, Job, JobState, Made, Outcome, Work
from phonemeengine.errors import EngineError
from phonemeengine.execution import Cancelled, Progress, end_with_parent, single_threaded
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import ModelKind
from phonemeengine.storage.files import is_portable, printable_name, reason_of

FULL = frozenset({errno.ENOSPC, getattr(errno, "EDQUOT", errno.ENOSPC)})
"""Why nothing else can be written either."""

_log = logging.getLogger(__name__)

copyreg.pickle(MappingProxyType, lambda mapping: (MappingProxyType, (dict(mapping),)))  # presets have some


@dataclass(frozen=True)
class Order:
    """Work, pickled once; two orders are the same if their fingerprints are.

    Attributes
    ----------
    digest : the fingerprint.
    content : the pickle; may be left out where it is known already.
    """

    digest: str
    content: bytes = field(default=b"", compare=False, repr=False)


def order_of(work: Work) -> Order:
    """Return work as it is sent."""
    content = io.BytesIO()
    _WorkPickler(content).dump(work)
    return Order(work.fingerprint(), content.getvalue())


class _WorkPickler(pickle.Pickler):
    """Pickles work; presets go without a real-time model where other models recognise, since it has 11 MB."""

    @override
    def reducer_override(self, value: Any) -> Any:
        """Return how a preset that has a model too many is made again."""
        if not isinstance(value, Preset) or value.live_encoder is None:
            return NotImplemented
        if ModelKind.ENCODER in {value.model_kind, value.file_model}:
            return NotImplemented
        return replace(value, live_encoder=None).__reduce_ex__(pickle.DEFAULT_PROTOCOL)


def act_of(order: Order) -> Act:
    """Open the work of an order, and keep it open as long as this process has no other.

    Raises
    ------
    EngineError : what it needs cannot be opened.
    """
    return _opened(order)[1]


@lru_cache(maxsize=1)
def _opened(order: Order) -> tuple[AbstractContextManager[Act], Act]:
    work: Work = pickle.loads(order.content)  # noqa: S301 - from the process that started this one, or its cluster
    manager = work.opened()
    return manager, manager.__enter__()


def worked_through(
    act: Act, jobs: Sequence[Job], progress_of: Callable[[int], Progress], *, recorded: bool
) -> list[Outcome]:
    """Do what is to be done to some files; ends before the end where it is cancelled.

    Parameters
    ----------
    progress_of : told of the share that is done of the file of this number.
    recorded : whether it is asked what the files are, so that they can be told from others later.
    """
    found: list[Outcome] = []
    for number, job in enumerate(jobs):
        progress = progress_of(number)
        if not progress(0.0):
            break
        try:
            found.append(worked_on(act, job, progress, recorded=recorded))
        except Cancelled:
            break
        if found[-1].is_fatal:
            break
    return found


def worked_on(act: Act, job: Job, progress: Progress, *, recorded: bool) -> Outcome:
    """Do what is to be done to one file, and tell what came of it.

    Raises
    ------
    Cancelled : `progress` did not want to go on.
    BrokenPipeError : the reader of the output has gone.
    """
    notes: list[tuple[str, str]] = []
    try:
        with fetched(job) as here:
            made = act(here.job, lambda name, note: notes.append((name, note)), progress)
            here.send()
            states = here.states() if recorded else ()
        if recorded and not is_portable((job.target or job.source).name):
            words = "not every system can write this name; rename the sound before its files go to others"
            notes.append((printable_name(job.source), words))
        return Outcome(job, JobState.DONE, made, tuple(notes), "", False, *states)
    except (Cancelled, BrokenPipeError):  # who read what is printed has gone
        raise
    except EngineError as error:
        return failed(job, str(error), tuple(notes), is_fatal=_is_full(error))
    except OSError as error:  # of a name that this system cannot even ask for, such as one that is too long
        words = f"its file cannot be written ({reason_of(error)}); rename the sound, or choose another folder"
        return failed(job, f"{printable_name(job.source)}: {words}", tuple(notes), is_fatal=_is_full(error))
    except Exception as error:
        if not recorded:
            raise
        _log.exception("a file crashed: %s", printable_name(job.source))
        kind = f"{type(error).__name__}: {error}".splitlines()[0][:200]
        words = f"{printable_name(job.source)}: the program itself failed at it ({kind}); send it in with --log FILE"
        return failed(job, words, tuple(notes), is_fatal=_is_full(error))


def failed(job: Job, words: str, notes: tuple[tuple[str, str], ...] = (), *, is_fatal: bool = False) -> Outcome:
    """Return what is known of a job that could not be done."""
    return Outcome(job, JobState.FAILED, Made(_duration_of(job.source)), notes, words, is_fatal)


def _duration_of(path: Path) -> float:
    """Return the length of a sound, seconds; 0 where it cannot be read."""
    if is_remote(path):
        return 0.0
    with suppress(EngineError), SoundReader(path) as reader:
        return reader.duration
    return 0.0


def _is_full(error: BaseException | None) -> bool:
    while error is not None:
        if isinstance(error, OSError) and error.errno in FULL:
            return True
        error = error.__cause__
    return False


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
