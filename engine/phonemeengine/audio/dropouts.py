"""Samples that a device lost on the way, found by holding their count against a clock.

They are logged here, apart from the modules that the sound system calls back: nothing there may wait for a log.
"""

import logging

WATCHED = 1.0
"""Seconds of which the promptest block tells how far the count is behind."""
LEAST = 0.008
"""The least loss that the phase of two buffers shows, seconds; devices lose whole blocks, of 10 ms
and more."""
SETTLING = 0.5
"""Seconds after the beginning in which cards deliver ahead of time or late, so that no loss can be told."""
FOLLOWED = 0.3
"""Share of a smaller difference that is taken for the drift of the device's clock."""

_log = logging.getLogger(__name__)


class DropoutMeter:
    """Counts lost samples.

    A block may come late, but never early: the promptest block of a second says how far the count lies behind the
    clock. When that moves up by more than a jitter, and is still there in the second after, samples are missing. What
    moves slowly is the drift of two clocks. Samples that were taken for lost and come after all were only late.

    Parameters
    ----------
    rate : sample rate of the device, Hz.

    Attributes
    ----------
    n_samples : samples counted.
    n_lost : samples that never came.
    begun : when the first sample was captured, by the clock, as far as the promptest blocks tell.
    """

    def __init__(self, rate: int) -> None:
        self.n_samples = 0
        self.n_lost = 0
        self.begun = 0.0
        self._rate = rate
        self._promptest = self._suspect = float("inf")
        self._settled = self._ends = 0.0

    def observe(self, time: float, n: int) -> None:
        """Take note that `n` samples were there at a time (seconds of a clock that never jumps)."""
        self.n_samples += n
        offset = time - (self.n_samples + self.n_lost) / self._rate
        if self._ends == 0:
            self._settled, self._ends = time + SETTLING, time + SETTLING + WATCHED
        if time <= self._settled:
            self.begun = offset
            return
        if self.begun - offset > LEAST:
            n_late = min(self.n_lost, round((self.begun - offset) * self._rate))
            self.n_lost -= n_late
            offset += n_late / self._rate
        self._promptest = min(self._promptest, offset)
        self.begun = min(self.begun, offset)
        if time >= self._ends:
            self._judge(self._promptest - self.begun)
            self._promptest, self._ends = float("inf"), time + WATCHED

    def time_of(self, sample: float) -> float:
        """Return when a sample was captured, counted from the first with the lost ones, by the clock."""
        return self.begun + sample / self._rate

    def _judge(self, behind: float) -> None:
        if behind < LEAST:
            self.begun += FOLLOWED * behind
            self._suspect = float("inf")
        elif self._suspect == float("inf"):
            self._suspect = behind
        else:
            self.n_lost += round(min(behind, self._suspect) * self._rate)
            _log.warning("sound was lost by the device, %.3f s so far", self.n_lost / self._rate)
            self._suspect = float("inf")
