"""Following a value that holds between its changes."""

import math


class LowPass:
    """Approaches a target by the exact answer of a low-pass of first order: it does not matter how often one looks.

    Parameters
    ----------
    time_constant : seconds after which 63 % of a change is followed; 0 follows at once.
    value : where it begins.
    """

    def __init__(self, time_constant: float, value: float = 0.0) -> None:
        self._time_constant = time_constant
        self._time, self._value, self._target = 0.0, value, value

    def set_target(self, time: float, target: float) -> None:
        """Set another target from a time on, seconds; times never go back."""
        if target != self._target:
            self._value = self.at(time)
            self._time, self._target = time, target

    def at(self, time: float) -> float:
        """Return the value at a time."""
        if self._time_constant <= 0.0 or self._value == self._target:
            return self._target
        passed = max(time - self._time, 0.0)
        return self._target + (self._value - self._target) * math.exp(-passed / self._time_constant)
