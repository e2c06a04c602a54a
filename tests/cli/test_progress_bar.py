"""The bar over all files, as a terminal shows it."""

import io
from contextlib import redirect_stderr

from phonemeanalyser.cli.jobs import batch_bar
from phonemeengine.batch.runner import BatchProgress


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def shown(n_files: int, *steps: BatchProgress) -> str:
    with redirect_stderr(Terminal()) as terminal, batch_bar(n_files) as show:
        assert all(show(step) for step in steps)
    return terminal.getvalue()


def test_it_tells_files_speed_and_the_time_that_is_left() -> None:
    half = BatchProgress(10, 1000, n_done=4, n_failed=1, done_bytes=500.0, analysed=600.0, elapsed=2.0)
    end = BatchProgress(10, 1000, n_done=9, n_failed=1, done_bytes=1000.0, analysed=1200.0, elapsed=4.0)
    said = shown(10, half, end)
    assert "100%" in said
    assert "10/10 files, 300 x real time, 1 failed" in said
    assert "<00:00]" in said


def test_a_single_short_file_needs_none() -> None:
    assert shown(1, BatchProgress(1, 10, n_done=1, done_bytes=10.0, analysed=1.0, elapsed=0.1)) == ""
