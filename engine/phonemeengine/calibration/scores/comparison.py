"""Two presets on the same recordings: what each gets right that the other misses."""

import heapq
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Int64Array, UInt8Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import CorpusScores, Predictions
from phonemeengine.calibration.scores.gains import Gains, gains_of
from phonemeengine.calibration.scores.scoring import N_CODES, SCORED_PHONEMES, confusion_of
from phonemeengine.errors import CorpusError
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

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
