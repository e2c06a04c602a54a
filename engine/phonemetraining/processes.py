"""Work on many recordings, in as many processes as there are cores."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from os import cpu_count
from typing import Any, TypeVar

from phonemeengine.execution import single_threaded

FEW = 16
"""Up to this number of recordings, no other process is started: until it has imported PyTorch, they are done."""
Result = TypeVar("Result")


def in_processes(
    work: Callable[..., Result], columns: Sequence[Sequence[Any]], begin: Callable[..., None], given: Iterable[Any]
) -> Iterator[Result]:
    """Yield what a function makes of recordings, in their order.

    Parameters
    ----------
    work : the function, of a module.
    columns : its arguments, each for all recordings.
    begin : called once in each process beforehand, with what is `given`.
    given : what all recordings share.
    """
    if len(columns[0]) <= FEW:
        begin(*given)
        yield from map(work, *columns)
        return
    with single_threaded(), ProcessPoolExecutor(cpu_count(), get_context("spawn"), begin, tuple(given)) as pool:
        yield from pool.map(work, *columns, chunksize=4)
