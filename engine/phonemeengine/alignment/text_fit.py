"""How badly a text fits a sound, and from when on another text was said.

What counts are sounds, not frames: in a text that is said most sounds fit well and a few do not, since they are said
or heard otherwise; in another text many of them do not fit. So no sound counts more than `WORST_SOUND`. Silence does
not count, however long it is.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from phonemeengine.alignment.passage import Passage
from phonemeengine.alignment.viterbi import SKIPPED, SOUND, STRANGE, WayStep
from phonemeengine.arrays import BoolArray, Float64Array

WORST_SOUND = 3.0
"""The most that a sound falls short of the best one, in the mean over its frames; more of it tells nothing."""
STRANGE_SOUND = 2.0
"""What a sound counts that is said and does not stand in the text."""
FRAMES_OF_A_SOUND = 8
"""What is said besides the text has a sound in each so many frames."""
WORST_FIT = 1.38
"""Another text was said where its sounds count more in the mean."""


@dataclass(frozen=True)
class TextFit:
    """How badly a text fits a sound.

    Attributes
    ----------
    misfit : of all sounds, natural logarithms.
    n_sounds : how many there are, of the text and besides it.
    """

    misfit: float = 0.0
    n_sounds: float = 0.0

    @property
    def mean(self) -> float:
        """How badly a sound fits in the mean, 0..`WORST_SOUND`."""
        return self.misfit / self.n_sounds if self.n_sounds else 0.0

    @property
    def is_wrong(self) -> bool:
        """Whether another text was said."""
        return self.mean > WORST_FIT

    def __add__(self, other: "TextFit") -> "TextFit":
        return TextFit(self.misfit + other.misfit, self.n_sounds + other.n_sounds)

    def __lt__(self, other: "TextFit") -> bool:
        return self.mean < other.mean


def fit_of(steps: Sequence[WayStep], passage: Passage, shortfalls: Float64Array, spoken: BoolArray) -> TextFit:
    """Return how badly a way through a passage fits.

    Parameters
    ----------
    steps : of the way.
    passage : the text.
    shortfalls : by which it was found, shape (n_frames, n_kinds).
    spoken : in which frames there is speech, shape (n_frames,).
    """
    fit = TextFit()
    for step in steps:
        frames = slice(step.first, step.last)
        if step.kind == SOUND:
            kind = passage.lattice.columns[step.sound]
            fit += TextFit(_of_a_sound(shortfalls[frames, kind]), 1.0)
        elif step.kind == SKIPPED:
            n_skipped = float(passage.lattice.fewest[step.sound])
            fit += TextFit(WORST_SOUND * n_skipped, n_skipped)
        elif spoken[frames].any():
            n_besides = np.count_nonzero(spoken[frames]) / FRAMES_OF_A_SOUND
            quiet = shortfalls[frames, 0][spoken[frames]]
            fit += TextFit(n_besides * (STRANGE_SOUND if step.kind == STRANGE else _of_a_sound(quiet)), n_besides)
    return fit


def _of_a_sound(shortfalls: Float64Array) -> float:
    return min(-float(shortfalls.mean()), WORST_SOUND)
