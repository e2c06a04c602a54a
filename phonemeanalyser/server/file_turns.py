"""Whose file is exported: addresses take turns, and a file that takes long gives its place to those that wait."""

import asyncio
import time
from collections import Counter
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field

LONG = 2.0
"""Seconds after which a file takes long: it goes on with the lowest priority, and another one may begin."""
AT_ONCE = 4
"""Files that may have begun for each that is exported at a time: those that take long keep their memory."""


@dataclass(eq=False)
class FileTurn:
    """One file's turn.

    Attributes
    ----------
    address : whose file it is.
    give_way : has its work go on with the lowest priority; what does the work puts it in.
    """

    address: str
    give_way: Callable[[], object] = lambda: None
    begins: asyncio.Event = field(default_factory=asyncio.Event)
    began: float = 0.0
    is_long: bool = False


class FileTurns:
    """Gives files their turns.

    Parameters
    ----------
    most : files at a time, besides those that take long.
    clock : gives seconds.
    """

    def __init__(self, most: int, clock: Callable[[], float] = time.monotonic) -> None:
        self._most, self._clock = most, clock
        self._waiting: list[FileTurn] = []
        self._begun: list[FileTurn] = []
        self._timer: asyncio.TimerHandle | None = None

    @property
    def n_begun(self) -> int:
        """How many files have their turn."""
        return len(self._begun)

    @asynccontextmanager
    async def turn(self, address: str) -> AsyncIterator[FileTurn]:
        """Wait for the turn of a file, which lasts as long as the block."""
        turn = FileTurn(address)
        self._waiting.append(turn)
        self.share()
        try:
            await turn.begins.wait()
            yield turn
        finally:
            (self._begun if turn in self._begun else self._waiting).remove(turn)
            self.share()

    def share(self) -> None:
        """Let files begin for which there is room, those of addresses with the fewest first; do so again soon."""
        if self._waiting:
            self._make_room()
        while (turn := self._next()) is not None:
            self._waiting.remove(turn)
            self._begun.append(turn)
            turn.began = self._clock()
            turn.begins.set()
        if self._timer is not None:
            self._timer.cancel()
        self._timer = asyncio.get_running_loop().call_later(LONG, self.share) if self._waiting else None

    def _make_room(self) -> None:
        for turn in self._begun:
            if not turn.is_long and self._clock() - turn.began >= LONG:
                turn.is_long = True
                turn.give_way()

    def _next(self) -> FileTurn | None:
        """Return the file that begins now; none where there is no room, or who waits has a whole share."""
        n_short = sum(not turn.is_long for turn in self._begun)
        if n_short >= self._most or len(self._begun) >= AT_ONCE * self._most:
            return None
        n_of = Counter(turn.address for turn in self._begun)
        share = (AT_ONCE - 1) * self._most  # so that there is always room for another address
        allowed = [turn for turn in self._waiting if n_of[turn.address] < share]
        return min(allowed, key=lambda turn: n_of[turn.address], default=None)
