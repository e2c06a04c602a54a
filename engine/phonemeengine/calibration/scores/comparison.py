"""Two presets on the same recordings: what each gets right that the other misses, and whether that is chance."""

import heapq
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float64Array, Int64Array, UInt8Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import CorpusScores, Predictions
from phonemeengine.calibration.scores.scoring import MOUTH_CODES, N_CODES, SCORED_PHONEMES, confusion_of, macro_f1_of
from phonemeengine.errors import CorpusError
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

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


MOST_SEGMENTS = 20
"""Segments that are listed for each preset."""


@dataclass(frozen=True)
class DifferingSegment:
    """A segment of one label in which one preset is right and the other always gives the same wrong answer.

    Attributes
    ----------
    utterance : the recording.
    start, end : seconds.
    label : what was said, and what the preset that is right answered.
    wrong : what the other one answered.
    """

    utterance: LabelledUtterance
    start: float
    end: float
    label: Phoneme
    wrong: Phoneme


@dataclass(frozen=True)
class Difference:
    """How two presets differ in one recording, counted in frames that are labelled as one of the ten classes.

    Attributes
    ----------
    utterance : the recording.
    n_frames : frames that count.
    n_both, n_one, n_other : how many both get right, only the first, and only the second.
    """

    utterance: LabelledUtterance
    n_frames: int
    n_both: int
    n_one: int
    n_other: int


@dataclass(frozen=True)
class PresetComparison:
    """What two presets get right.

    Attributes
    ----------
    one, other : the presets' scores.
    changed : int64, shape (11, 11): frames by what the first answers (row) and what the other answers (column).
    both, only_one, only_other, neither : int64, shape (11,): frames that they get right, by the label's code.
    differences : those of all recordings, the greatest first.
    gains : what the other one gains, with the range that chance would give.
    segments_one, segments_other : what only the first gets right, and only the second: the longest of the ten
        classes, the longest first.
    """

    one: CorpusScores
    other: CorpusScores
    changed: Int64Array
    both: Int64Array
    only_one: Int64Array
    only_other: Int64Array
    neither: Int64Array
    differences: tuple[Difference, ...]
    gains: Gains
    segments_one: tuple[DifferingSegment, ...]
    segments_other: tuple[DifferingSegment, ...]


def compare(one: CorpusScores, other: CorpusScores, *, most: int = MOST_SEGMENTS) -> PresetComparison:
    """Compare two presets on the same recordings; `most` segments are listed for each preset.

    Raises
    ------
    CorpusError : they were not scored on the same recordings.
    """
    if [_key(a) for a in one.predictions] != [_key(a) for a in other.predictions]:
        raise CorpusError(
            f"{one.preset.name} and {other.preset.name} were not scored on the same recordings; score them together"
        )
    pairs = list(zip(one.predictions, other.predictions, strict=True))
    truth = np.concatenate([a.labels.phonemes for a in one.predictions])
    first, second = (np.concatenate([a.right for a in scores.predictions]) for scores in (one, other))
    differences = sorted((_difference(a, b) for a, b in pairs), key=lambda d: -abs(d.n_one - d.n_other))
    return PresetComparison(
        one=one,
        other=other,
        changed=confusion_of(*(np.concatenate([a.phonemes for a in s.predictions]) for s in (one, other))),
        both=_counted(truth[first & second]),
        only_one=_counted(truth[first & ~second]),
        only_other=_counted(truth[second & ~first]),
        neither=_counted(truth[~first & ~second]),
        differences=tuple(differences),
        gains=gains_of([(a.labels.phonemes, a.phonemes, b.phonemes) for a, b in pairs]),
        segments_one=_longest((s for a, b in pairs for s in _stretches(a, b)), most),
        segments_other=_longest((s for a, b in pairs for s in _stretches(b, a)), most),
    )


def _key(answers: Predictions) -> object:
    return answers.utterance.path, len(answers.phonemes)


def _counted(codes: UInt8Array) -> Int64Array:
    return np.bincount(codes, minlength=N_CODES)


def _difference(one: Predictions, other: Predictions) -> Difference:
    counts = np.isin(one.labels.phonemes, SCORED_PHONEMES)
    first, second = one.right[counts], other.right[counts]
    return Difference(
        utterance=one.utterance,
        n_frames=len(first),
        n_both=int(np.sum(first & second)),
        n_one=int(np.sum(first & ~second)),
        n_other=int(np.sum(second & ~first)),
    )


def _stretches(right: Predictions, wrong: Predictions) -> Iterator[DifferingSegment]:
    """Return the segments of the ten classes in which the first is right and the second is not."""
    truth = right.labels.phonemes
    gained = right.right & ~wrong.right & np.isin(truth, SCORED_PHONEMES)
    kinds = np.where(gained, truth.astype(int) * N_CODES + wrong.phonemes + 1, 0)
    borders = np.flatnonzero(np.diff(kinds, prepend=0, append=0))
    for first, last in zip(borders[:-1].tolist(), borders[1:].tolist(), strict=True):
        if kinds[first]:
            label, answer = divmod(int(kinds[first]) - 1, N_CODES)
            start, end = first * FRAME_PERIOD, last * FRAME_PERIOD
            yield DifferingSegment(right.utterance, start, end, Phoneme(label), Phoneme(answer))


def _longest(stretches: Iterator[DifferingSegment], most: int) -> tuple[DifferingSegment, ...]:
    return tuple(heapq.nlargest(most, stretches, key=lambda s: round((s.end - s.start) / FRAME_PERIOD)))
