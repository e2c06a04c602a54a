"""What a recogniser gives for a block of frames."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Recognition:
    """The phonemes of a block.

    Attributes
    ----------
    phonemes : uint8, shape (n_frames,): codes of `Phoneme`.
    scores : float32, shape (n_frames, n_scores): the columns that the recogniser's `scores` names, or None where it
        names none.
    """

    phonemes: NDArray[np.uint8]
    scores: NDArray[np.float32] | None = None
