"""What is analysed and not heard yet."""

import logging
import threading
from collections import deque

from phonemeengine.analyser import Analysis
from phonemeengine.settings import SAMPLE_RATE

MOST_WAITING = 1500
"""Blocks that wait at most; older ones are dropped and counted."""

_log = logging.getLogger(__name__)


class PlaybackQueue:
    """Holds blocks until they are heard: one thread puts them in, another takes them out.

    Attributes
    ----------
    n_dropped : frames that nobody took in time.
    lock : keeps everything as it is while it is held.
    """

    def __init__(self) -> None:
        self.n_dropped = 0
        self.lock = threading.RLock()
        self._blocks: deque[tuple[int, Analysis]] = deque()

    def __bool__(self) -> bool:
        return bool(self._blocks)

    @property
    def next_frame(self) -> int | None:
        """The first frame that waits, or None."""
        return self._blocks[0][1].start if self._blocks else None

    def append(self, due: int, analysis: Analysis) -> None:
        """Have a block wait until so many samples are heard."""
        with self.lock:
            self._blocks.append((due, analysis))
            if len(self._blocks) > MOST_WAITING and self.n_dropped == 0:
                _log.warning("frames are dropped, since nobody takes them")
            while len(self._blocks) > MOST_WAITING:
                self.n_dropped += len(self._blocks.popleft()[1])

    def pop_due(self, heard: float) -> list[Analysis]:
        """Return what is due when so many samples are heard, oldest first."""
        taken = []
        with self.lock:
            while self._blocks and self._blocks[0][0] <= heard:
                taken.append(self._blocks.popleft()[1])
        return taken

    def upcoming(self, heard: float) -> list[tuple[float, Analysis]]:
        """Return all blocks, each with the seconds until it is due."""
        with self.lock:
            return [((due - heard) / SAMPLE_RATE, analysis) for due, analysis in self._blocks]

    def clear(self) -> None:
        """Forget them."""
        with self.lock:
            self._blocks.clear()
