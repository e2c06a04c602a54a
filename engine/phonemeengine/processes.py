"""Processes that share the cores of a machine."""

import os
from collections.abc import Iterator
from contextlib import contextmanager

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
"""What libraries of matrices ask for how many threads they have."""


def threads_allowed() -> int:
    """Return how many threads work on something here: as many as there are cores, unless each has its process."""
    asked = os.environ.get(THREADS[0], "")
    return int(asked) if asked.isdecimal() and int(asked) else os.cpu_count() or 1


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
