"""Whether other answers on the same speech are better by more than chance."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float64Array, Int64Array, UInt8Array
from phonemeengine.calibration.scores.scoring import MOUTH_CODES, N_CODES, SCORED_PHONEMES, macro_f1_of
from phonemeengine.phonemes import Phoneme

PairedAnswers = tuple[UInt8Array, UInt8Array, UInt8Array]
"""What was said in the frames of a recording, and the answers before and after, codes, each of shape (n_frames,)."""
N_DRAWS = 2000
CHANCE = 0.025
"""How often chance alone may look like a gain: one end of an interval of 95 %."""
MOST_PARTS = 1000
"""Parts of the speech that are drawn at most: of long recordings neighbouring phones are drawn together."""


@dataclass(frozen=True)
class Gain:
    """By how much a figure rose, with the interval of 95 % that chance would give; shares, -1..1."""

    difference: float
    low: float
    high: float

    @property
    def is_clear(self) -> bool:
        """Whether chance alone hardly explains a difference of this size."""
        return self.low > 0 or self.high < 0


NO_GAIN = Gain(0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Gains:
    """What other answers gain on the same speech: macro F1, and the share of right mouth shapes."""

    macro_f1: Gain = NO_GAIN
    viseme_accuracy: Gain = NO_GAIN

    @property
    def are_clear(self) -> bool:
        """Whether both rose by more than chance."""
        return self.macro_f1.low > 0 and self.viseme_accuracy.low > 0


def gains_of(recordings: Sequence[PairedAnswers], *, seed: int = 0) -> Gains:
    """Return by how much macro F1 and the share of right mouth shapes rose, with the range of chance.

    Paired bootstrap (B. Efron, R. Tibshirani, An Introduction to the Bootstrap, 1993, section 13.3): phones, whose
    frames are alike, are drawn anew, as many as there are, and both figures are compared on the same ones.
    """
    phones = [phone for recording in recordings if len(phone := _phones_in(recording[0]))]
    if not phones:
        return Gains()
    said, before, after = (np.concatenate(codes) for codes in zip(*recordings, strict=True))
    firsts = np.cumsum([0, *(phone[-1] + 1 for phone in phones[:-1])])
    phone_of = np.concatenate([first + phone for first, phone in zip(firsts, phones, strict=True)])
    n_phones = int(phone_of[-1]) + 1
    n = min(n_phones, MOST_PARTS)
    parts = phone_of * n // n_phones
    counts = [_counts(parts, n, said, answers) for answers in (before, after)]
    mouths = np.stack([_mouths_gained(parts, n, said, before, after), np.bincount(parts, minlength=n)])
    draws = np.random.default_rng(seed).multinomial(n, np.full(n, 1 / n), N_DRAWS).astype(float)

    def gained(weights: Float64Array) -> tuple[Float64Array, Float64Array]:
        one, other = (_macro_f1s(weights @ each) for each in counts)
        more, of = weights @ mouths[0], weights @ mouths[1]
        return other - one, more / np.maximum(of, 1)

    pairs = zip(gained(np.ones((1, n))), gained(draws), strict=True)
    return Gains(*(_gain(float(whole[0]), drawn) for whole, drawn in pairs))


def _gain(difference: float, drawn: Float64Array) -> Gain:
    low = float(np.quantile(drawn, CHANCE, method="lower"))
    return Gain(difference, low, float(np.quantile(drawn, 1 - CHANCE, method="higher")))


def _phones_in(said: UInt8Array) -> Int64Array:
    """Return the number of the phone of each frame, from 0; what is said changes from one to the next."""
    return np.cumsum(np.diff(said, prepend=said[:1]) != 0)


def _counts(parts: Int64Array, n: int, said: UInt8Array, answers: UInt8Array) -> Float64Array:
    """Return the confusion matrix of each part, as macro F1 counts it, flat, shape (n, 121)."""
    known = said != Phoneme.UNIDENTIFIED
    cells = (parts[known] * N_CODES + said[known]) * N_CODES + answers[known]
    return np.bincount(cells, minlength=n * N_CODES**2).reshape(n, -1).astype(float)


def _mouths_gained(
    parts: Int64Array, n: int, said: UInt8Array, before: UInt8Array, after: UInt8Array
) -> Float64Array:
    """Return in how many frames more of each part the mouth shape is right afterwards."""
    truth = MOUTH_CODES[said]
    gained = (MOUTH_CODES[after] == truth).astype(float) - (MOUTH_CODES[before] == truth)
    return np.bincount(parts, gained, minlength=n).astype(float)


def _macro_f1s(counts: Float64Array) -> Float64Array:
    """Return the macro F1 of each row of flat confusion matrices; 0 where it has none of the ten classes."""
    whole = counts.astype(np.int64).reshape(-1, N_CODES, N_CODES)
    return np.nan_to_num(macro_f1_of(whole, SCORED_PHONEMES))
