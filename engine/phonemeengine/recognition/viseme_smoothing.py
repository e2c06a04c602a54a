"""Visemes that do not flicker: one stays while its phoneme does, and as long as no other is far likelier."""

import numpy as np

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.visemes import ALLOWED, usual_visemes

MARGIN = 0.2
"""By how much another viseme of the same phoneme must be likelier to follow."""


class VisemeSmoother:
    """Follows a stream of phonemes with the visemes that are heard; looks only back."""

    def __init__(self) -> None:
        self._phoneme = self._viseme = -1

    def follow(self, phonemes: UInt8Array, probabilities: Float32Array | None) -> UInt8Array:
        """Return the visemes of the next phonemes, uint8, shape (n_frames,).

        Parameters
        ----------
        phonemes : codes of `Phoneme`, after all smoothing, shape (n_frames,).
        probabilities : of the visemes, shape (n_frames, 15); None where nobody hears them.
        """
        if probabilities is None:
            return usual_visemes(phonemes)
        allowed = np.where(ALLOWED[phonemes], probabilities, np.float32(-1))
        visemes = []
        for phoneme, viseme, row in zip(phonemes.tolist(), allowed.argmax(axis=1).tolist(), allowed, strict=True):
            if phoneme != self._phoneme or row[viseme] > row[self._viseme] + MARGIN:
                self._phoneme, self._viseme = phoneme, viseme
            visemes.append(self._viseme)
        return np.array(visemes, np.uint8)
