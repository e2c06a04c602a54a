"""The statistics step: a phoneme stays a minimum time, and an unidentified frame takes the likeliest successor."""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from engine.phonemes import Phoneme
from engine.settings import FRAME_PERIOD

SUCCESSORS: Mapping[Phoneme, Phoneme] = MappingProxyType(
    {
        Phoneme.SILENCE: Phoneme.P,
        Phoneme.UNIDENTIFIED: Phoneme.O,
        Phoneme.SZ: Phoneme.SZ,
        Phoneme.SCH: Phoneme.E,
        Phoneme.M: Phoneme.O,
        Phoneme.P: Phoneme.I,
        Phoneme.I: Phoneme.O,
        Phoneme.A: Phoneme.M,
        Phoneme.E: Phoneme.O,
        Phoneme.U: Phoneme.U,
        Phoneme.O: Phoneme.O,
    }
)
"""What a frame is likeliest to be where the rules say nothing, by the phoneme that they named last.

Counted on labelled speech by `engine.calibration.fit_thesis`, with the thresholds of the preset Thesis: the class of
which the largest share is found there. The rules say nothing mostly where the band of the second formant is neither
strong (a, e) nor weak (u, o, i, m), hence the many o. The entry of unidentified is what is likeliest after anything.
"""


class Statistics:
    """Calms a stream of phonemes; looks only back.

    Parameters
    ----------
    minimum_hold : seconds that a phoneme stays at least before another may follow.
    successors : what replaces an unidentified frame, by the phoneme that was identified last.
    """

    def __init__(self, minimum_hold: float, successors: Mapping[Phoneme, Phoneme] = SUCCESSORS) -> None:
        self._least = max(1, round(minimum_hold / FRAME_PERIOD))
        self._successors = [int(successors.get(p, p)) for p in Phoneme]
        self._current = self._identified = int(Phoneme.SILENCE)
        self._held = self._least

    def push(self, phonemes: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Take the next phonemes, shape (n_frames,), and give the calmed ones."""
        current, held, identified = self._current, self._held, self._identified
        unidentified = int(Phoneme.UNIDENTIFIED)
        out = []
        for raw in phonemes.tolist():
            identified = identified if raw == unidentified else raw
            wanted = self._successors[identified] if raw == unidentified else raw
            if wanted != current and held >= self._least:
                current, held = wanted, 0
            held += 1
            out.append(current)
        self._current, self._held, self._identified = current, held, identified
        return np.array(out, np.uint8)
