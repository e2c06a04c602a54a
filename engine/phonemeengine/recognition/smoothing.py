"""The statistics step: a phoneme stays a minimum time, and an unidentified frame takes the likeliest successor."""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.labels.visemes import STANDARD_VISEMES, VisemeSet
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

SUCCESSORS: Mapping[Phoneme, Phoneme] = MappingProxyType(
    {
        Phoneme.SILENCE: Phoneme.U,
        Phoneme.UNIDENTIFIED: Phoneme.O,
        Phoneme.SZ: Phoneme.SZ,
        Phoneme.SCH: Phoneme.I,
        Phoneme.M: Phoneme.O,
        Phoneme.P: Phoneme.O,
        Phoneme.I: Phoneme.O,
        Phoneme.A: Phoneme.M,
        Phoneme.E: Phoneme.O,
        Phoneme.U: Phoneme.U,
        Phoneme.O: Phoneme.U,
    }
)
"""What a frame is likeliest to be where the rules say nothing, by the phoneme that they named last.

Counted on labelled speech by `tools.fit.thesis`, with the thresholds of the preset Thesis: the
class of which the largest share is found there. The rules say nothing mostly where the band of the second formant is
neither strong (a, e) nor weak (u, o, i, m), hence the many o. The entry of unidentified is what is
likeliest after anything.
"""

UNREPLACED: Mapping[Phoneme, Phoneme] = MappingProxyType(dict.fromkeys(Phoneme, Phoneme.UNIDENTIFIED))
"""The table that leaves unidentified frames alone, for recognisers who know what is another sound."""


def frames_held(minimum_hold: float) -> int:
    """Return for how many frames a phoneme stays at least."""
    return max(1, round(minimum_hold / FRAME_PERIOD))


class PhonemeSmoother:
    """Calms a stream of phonemes; looks only back.

    Parameters
    ----------
    minimum_hold : seconds that a phoneme stays at least before another may follow.
    successors : what replaces an unidentified frame, by the phoneme that was identified last.
    hysteresis : a phoneme stays while it falls short of being named by no more than this.
    """

    def __init__(
        self, minimum_hold: float, successors: Mapping[Phoneme, Phoneme] = SUCCESSORS, hysteresis: float = 0.0
    ) -> None:
        self.hysteresis = hysteresis
        self._least = frames_held(minimum_hold)
        self._successors = [int(successors.get(p, p)) for p in Phoneme]
        self._current = self._identified = int(Phoneme.SILENCE)
        self._steady = int(Phoneme.SILENCE)
        self._held = self._least

    def has_change(self, phonemes: UInt8Array) -> bool:
        """Return whether hysteresis has anything to decide about the next phonemes: mostly none changes."""
        return self.hysteresis > 0 and bool((phonemes != self._steady).any())

    def smooth(self, phonemes: UInt8Array, deficits: Float32Array | None = None) -> UInt8Array:
        """Take the next phonemes, shape (n_frames,), and give the calmed ones.

        `deficits` says by how much each phoneme falls short of being named, shape (n_frames, n_phonemes); without
        them there is no hysteresis, which is all the same where the phonemes do not waver.
        """
        if deficits is not None:
            phonemes = self._apply_hysteresis(phonemes.tolist(), (deficits <= self.hysteresis).tolist())
        return self._apply_minimum_hold(phonemes)

    def _apply_hysteresis(self, phonemes: list[int], may_stay: list[list[bool]]) -> UInt8Array:
        steady, out = self._steady, []
        # Hysteresis: the phoneme that stands stays while it is nearly as good as the one that is named, so frames on
        # the border of two do not flicker. It compares with what stood, not with what was shown.
        for raw, stays in zip(phonemes, may_stay, strict=True):
            steady = steady if stays[steady] else raw
            out.append(steady)
        self._steady = steady
        return np.array(out, np.uint8)

    def _apply_minimum_hold(self, phonemes: UInt8Array) -> UInt8Array:
        current, held, identified = self._current, self._held, self._identified
        unidentified = int(Phoneme.UNIDENTIFIED)
        out = []
        # Plain integers and no arrays: each step depends on the one before, and NumPy scalars are several times
        # slower. An unidentified frame becomes what likely follows the last identified one; after a change no other
        # may follow for the minimum duration, however often the wish changes in between.
        for raw in phonemes.tolist():
            identified = identified if raw == unidentified else raw
            wanted = self._successors[identified] if raw == unidentified else raw
            if wanted != current and held >= self._least:
                current, held = wanted, 0
            held += 1
            out.append(current)
        self._current, self._held, self._identified = current, held, identified
        return np.array(out, np.uint8)


# Visemes that do not flicker: one stays while its phoneme does, and as long as no other is far likelier.

MARGIN = 0.2
"""By how much another viseme of the same phoneme must be likelier to follow."""


class VisemeSmoother:
    """Follows a stream of phonemes with the recognised visemes; uses only the past."""

    def __init__(self) -> None:
        self._phoneme = self._viseme = -1

    def follow(
        self, phonemes: UInt8Array, probabilities: Float32Array | None, viseme_set: VisemeSet = STANDARD_VISEMES
    ) -> UInt8Array:
        """Return the visemes of the next phonemes, uint8, shape (n_frames,).

        Parameters
        ----------
        phonemes : codes of `Phoneme`, after all smoothing, shape (n_frames,).
        probabilities : of the visemes of the set, shape (n_frames, n_visemes); None where they are not recognised.
        viseme_set : what they are.
        """
        if probabilities is None:
            return viseme_set.usual_visemes(phonemes)
        # visemes of other phonemes can never win, since probabilities are 0 or more
        allowed = np.where(viseme_set.allowed[phonemes], probabilities, np.float32(-1))
        visemes = []
        for phoneme, viseme, row in zip(phonemes.tolist(), allowed.argmax(axis=1).tolist(), allowed, strict=True):
            # a new phoneme starts anew; within one, the margin is the hysteresis
            if phoneme != self._phoneme or (viseme != self._viseme and row[viseme] > row[self._viseme] + MARGIN):
                self._phoneme, self._viseme = phoneme, viseme
            visemes.append(self._viseme)
        return np.array(visemes, np.uint8)
