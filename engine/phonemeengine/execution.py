"""How work runs: its progress, its end before time, what is closed after it, and the processes that share it."""

import ctypes
import os
import threading
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Self

Progress = Callable[[float], bool]
"""Told how much of the work is done, 0..1; answers whether to go on."""
LARGEST_BLOCK = 32 << 20
"""Bytes of an array whose memory is kept."""
_M_TRIM_THRESHOLD, _M_MMAP_THRESHOLD = -1, -3  # malloc.h
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
"""What libraries of matrices ask for how many threads they have."""


class Cancelled(Exception):  # noqa: N818 - no error: the user asked for it
    """The work was ended before its end; nothing has changed."""


def no_progress(_share: float) -> bool:
    """Let work go on to its end."""
    return True


def report_progress(progress: Progress, share: float) -> None:
    """Tell how much is done.

    Raises
    ------
    Cancelled : the answer is not to go on.
    """
    if not progress(share):
        raise Cancelled


def subrange(progress: Progress, first: float, last: float) -> Progress:
    """Return what a part of the work heeds, which is the whole from `first` to `last`."""
    return lambda share: progress(first + share * (last - first))


class Closing(ABC):
    """Is closed at the end of a ``with`` block."""

    @abstractmethod
    def close(self) -> None:
        """Let go of everything."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        self.close()


def threads_allowed() -> int:
    """Return how many threads work on something here: as many as there are cores, unless each has its process."""
    asked = os.environ.get(THREADS[0], "")
    return int(asked) if asked.isdecimal() and int(asked) else os.cpu_count() or 1


def keep_memory() -> None:
    """Have the system's library keep the memory of arrays that are gone, for the next ones.

    Dask has it given back at once (``MALLOC_TRIM_THRESHOLD_``), which makes blocks of a sound take twice as long. Of
    libraries other than glibc, nothing is asked.
    """
    with suppress(OSError, AttributeError, TypeError):
        library = ctypes.CDLL(None)
        library.mallopt(_M_MMAP_THRESHOLD, LARGEST_BLOCK)
        library.mallopt(_M_TRIM_THRESHOLD, 2 * LARGEST_BLOCK)


def end_with_parent() -> None:
    """Have this process end as soon as the one that started it ended, also where that was killed.

    It does nothing in a process that `multiprocessing` did not start.
    """
    import multiprocessing  # noqa: PLC0415 - a process with a parent has loaded it already

    parent = multiprocessing.parent_process()
    if parent is not None:
        _end_after(parent.join)


def end_with_input() -> None:
    """Have this process end as soon as its standard input does: the other end is held by the process it works for."""

    def wait() -> None:
        with suppress(OSError):
            while os.read(0, 1):  # `sys.stdin` would keep a lock that the end of a program wants
                pass

    _end_after(wait)


def _end_after(wait: Callable[[], object]) -> None:
    def end() -> None:
        wait()
        os._exit(1)

    threading.Thread(target=end, name="ends with its parent", daemon=True).start()


@contextmanager
def single_threaded() -> Iterator[None]:
    """Let processes that are started have one thread each for their matrices: there is one for every core."""
    before = {name: os.environ.get(name) for name in THREADS}
    os.environ.update(dict.fromkeys(THREADS, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
