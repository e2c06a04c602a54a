"""An open mouth while it is loud: the smallest recogniser that remembers.

It opens above one energy and shuts below half of it, so a voice that hovers between the two does not make it flutter.
"""

import numpy as np

from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.trace import RuleComparison, Trace


class Loudness:
    """Names every frame a or silence; made with the preset's thresholds, and then given block after block."""

    used_thresholds = ("silence_energy",)  # the window shows their sliders

    def __init__(self, thresholds):
        self.opens = thresholds.silence_energy
        self.shuts = thresholds.silence_energy / 2
        self.is_open = False  # what it remembers from frame to frame, and so from block to block

    def recognise(self, windows, features):
        """Give a code of `Phoneme` for each frame: uint8, shape (n_frames,)."""
        codes = np.zeros(len(features.values), np.uint8)
        for k, energy in enumerate(features["energy"]):
            self.is_open = bool(energy > (self.shuts if self.is_open else self.opens))
            codes[k] = Phoneme.A if self.is_open else Phoneme.SILENCE
        return codes

    def explain(self, features, k):
        """Say why; what is not known here is what went before the block, so both limits are shown."""
        energy = float(features["energy"][k])
        comparisons = tuple(
            RuleComparison(rule, "energy", energy, ">", "silence_energy", limit, energy - limit)
            for rule, limit in (("opens", self.opens), ("stays", self.shuts))
        )
        loud = energy > self.opens
        return Trace(Phoneme.A if loud else Phoneme.SILENCE, "opens" if loud else "stays", comparisons)
