"""An open mouth while it is loud: the smallest recogniser that remembers.

It opens above one energy and shuts below half of it, so a voice that hovers between the two does not make it flutter.
Once this folder is installed beside the program, presets name it, and the window lists it::

    pip install examples/own_recogniser

As a program it says what it makes of a sound, and why::

    python examples/own_recogniser/phonemeanalyser_loudness.py SOUND
"""

import sys

import numpy as np

from phonemeengine import EngineError, Phoneme, RuleComparison, SoundReader, Trace, analyse_blocks, load_preset


class Loudness:
    """Names every frame a or silence; made with the preset's thresholds, and then given block after block."""

    used_thresholds = ("silence_energy",)  # the window shows their sliders

    def __init__(self, thresholds):
        self.opens = thresholds.silence_energy
        self.shuts = thresholds.silence_energy / 2
        self.is_open = False  # what it remembers from frame to frame, and so from block to block

    def recognise(self, _windows, features):
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


def main(sound):
    """Print each opening and closing of the mouth, and the comparison that made it."""
    preset, last = load_preset("thesis"), -1
    own = Loudness(preset.thresholds)
    with SoundReader(sound) as reader:
        for analysis in analyse_blocks(reader.blocks(44_100), preset):
            for k, code in enumerate(own.recognise(analysis.waveforms, analysis.features)):
                if code != last:
                    why = own.explain(analysis.features, k).comparisons[0]
                    print(f"{analysis.times[k]:6.2f} s  {Phoneme(code).label:<8} {why.value:.5f} {why.limit:.5f}")
                last = code


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except EngineError as error:
        sys.exit(str(error))
