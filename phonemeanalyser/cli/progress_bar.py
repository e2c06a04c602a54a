"""The one bar of progress over all files: how fast they are heard, and when all will be done."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from tqdm import tqdm

from phonemeengine.batch.runner import BatchProgress

FORM = "{percentage:3.0f}%|{bar}| {desc} [{elapsed}<{remaining}]"
DELAY = 1.0
"""Seconds of work before a bar is shown for a single file."""


@contextmanager
def batch_bar(n_files: int) -> Iterator[Callable[[BatchProgress], bool]]:
    """Show a bar at terminals; of a single file only where the work is long."""
    delay = DELAY if n_files == 1 else 0.0
    with tqdm(total=1.0, bar_format=FORM, delay=delay, leave=n_files > 1, disable=None, file=sys.stderr) as bar:

        def show(progress: BatchProgress) -> bool:
            bar.set_description_str(_words_of(progress), refresh=False)
            bar.update(progress.share - bar.n)
            return True

        yield show


def _words_of(progress: BatchProgress) -> str:
    over = progress.n_done + progress.n_failed
    parts = [f"{over}/{progress.n_files} files"]
    if progress.heard:
        parts.append(f"{progress.speed:.0f} x real time")
    if progress.n_failed:
        parts.append(f"{progress.n_failed} failed")
    return ", ".join(parts)
