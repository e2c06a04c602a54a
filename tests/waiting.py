"""Time in tests: waiting for what another thread or program does, and a clock that a test moves."""

import asyncio
import time
from collections.abc import Callable

PATIENCE = 300.0
"""Seconds that only a hang takes."""
LOOK = 0.001
"""Seconds between two looks."""


def wait_for(truth: Callable[[], object], what: str = "the other thread") -> None:
    """Wait until another thread, or a program, has done its part."""
    end = time.monotonic() + PATIENCE
    while not truth():
        assert time.monotonic() < end, f"waited in vain for {what}"
        time.sleep(LOOK)


async def come_to(truth: Callable[[], object], what: str = "the other task") -> None:
    """Wait until another task has done its part."""
    end = time.monotonic() + PATIENCE
    while not truth():
        assert time.monotonic() < end, f"waited in vain for {what}"
        await asyncio.sleep(LOOK)


def let_pass(seconds: float) -> None:
    """Let real time pass, for what is played or recorded in it by a card, or by a program that stands for one."""
    time.sleep(seconds)


class Clock:
    """A clock that a test moves.

    Attributes
    ----------
    now : what it says, seconds.
    """

    def __init__(self, now: float = 1000.0) -> None:
        self.now = now

    def __call__(self) -> float:
        return self.now
