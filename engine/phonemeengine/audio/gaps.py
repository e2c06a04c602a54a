"""Places of a recording where sound is missing, since the microphone was away."""

from collections.abc import Sequence
from dataclasses import dataclass

MOST_MARKED = 250
"""Gaps that a sound file marks at most: the room for them is set aside before the sound."""


@dataclass(frozen=True)
class Gap:
    """A place where sound is missing.

    Attributes
    ----------
    sample : the first sample after what was heard before it, counted in the file.
    seconds : how long nothing could be heard.
    n_silent : samples of silence that stand for it.
    """

    sample: int
    seconds: float
    n_silent: int = 0

    @property
    def label(self) -> str:
        """What is written at its place."""
        return f"gap of {self.seconds:.2f} s"


def gaps_in_words(gaps: Sequence[Gap], seconds: float, rate: int) -> str:
    """Return how long the gaps of a recording of some seconds were, and what stands for them; nothing without any."""
    if not gaps:
        return ""
    lasted = f"{sum(gap.seconds for gap in gaps):.2f} s"
    several = f"{len(gaps)} gaps of {lasted} in all" if len(gaps) > 1 else f"1 gap of {lasted}"
    only = f" (the first {MOST_MARKED} of them)" if len(gaps) > MOST_MARKED else ""
    silent = sum(gap.n_silent for gap in gaps) / rate
    filled = f": {seconds - silent:.2f} s of sound, {silent:.2f} s of silence" if silent else ""
    return f"with {several} marked in it{only}{filled}"
