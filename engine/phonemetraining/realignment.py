"""Times people's phones anew: their boundaries move to where the teacher recognises the change.

The phones of people's recordings were timed by an aligner that knew little of their voices. What is said, and in
which order, stays; each boundary moves by at most `FARTHEST`, to the likeliest places of all together (dynamic
programming). See `phonemetraining.teacher` for the rounds in which that is done.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float64Array, Int64Array
from phonemeengine.calibration.fine_tuning import N_SOFT_LABELS
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES, confusion_of, macro_f1_of
from phonemeengine.labels.utterance import Label
from phonemeengine.labels.visemes import viseme_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD
from phonemetraining.examples import SoftLabels, key_of

STEP = 0.005
"""Seconds between the places that a boundary may have."""
FARTHEST = 0.06
SPREAD = 0.01
"""Seconds by which the boundaries are taken to be off, standard deviation. Of boundaries of Festival's voices that
were moved at random by 14 ms, this leaves 9 ms on average; 20 ms leaves 10."""
SHORTEST = 0.015
"""Seconds that a phone has at least, unless it was shorter."""
VISEME_SHARE = 0.5
"""How much the viseme counts beside the phoneme."""
LEAST_LIKELY = 1e-3


def evidence_of(soft: NDArray[np.floating]) -> Float64Array:
    """Return how likely each phoneme and viseme is every 5 ms, natural logarithms, shape (2 x n_frames, 26).

    Parameters
    ----------
    soft : the teacher's probabilities, shape (n_frames, 26).
    """
    logs = np.log(soft.astype(np.float64) + LEAST_LIKELY)
    middles = (np.arange(len(logs)) + 0.5) * FRAME_PERIOD
    places = (np.arange(2 * len(logs)) + 0.5) * STEP
    return np.stack([np.interp(places, middles, logs[:, k]) for k in range(N_SOFT_LABELS)], axis=1)


def realigned(labels: Sequence[Label], evidence: Float64Array) -> tuple[Label, ...]:
    """Return the labels with moved boundaries; between sounds that cannot be distinguished they stay.

    Parameters
    ----------
    labels : consecutive labels of a recording, in order of time.
    evidence : see `evidence_of`.
    """
    joined = all(a.end == b.start for a, b in pairwise(labels))
    if not joined or len(labels) < 2 or len(evidence) < 2:
        return tuple(labels)
    sounds = [_LabelledSound.of(label) for label in labels]
    choices = _choices(labels, sounds, len(evidence))
    best, ways = np.zeros(len(choices[0])), []
    for k, (label, sound) in enumerate(zip(labels, sounds, strict=True)):
        sums = sound.sums(evidence)
        first, last = choices[k], choices[k + 1]
        least = min(SHORTEST, label.end - label.start) / STEP - 0.5
        gains = np.where(
            last[np.newaxis] - first[:, np.newaxis] >= least, sums[last] - sums[first][:, np.newaxis], -np.inf
        )
        if k + 1 < len(labels):
            gains = gains - ((last * STEP - label.end) / SPREAD) ** 2 / 2
        total = best[:, np.newaxis] + gains
        ways.append(total.argmax(axis=0))
        best = total.max(axis=0)
    if not np.isfinite(best).any():
        return tuple(labels)
    chosen = int(best.argmax())
    ends = []
    for way, places in zip(reversed(ways), reversed(choices[1:]), strict=True):
        ends.append(float(places[chosen]) * STEP)
        chosen = way[chosen]
    ends = [*ends[:0:-1], labels[-1].end]
    starts = [labels[0].start, *ends[:-1]]
    return tuple(replace(label, start=a, end=b) for label, a, b in zip(labels, starts, ends, strict=True))


@dataclass(frozen=True)
class _LabelledSound:
    """The evidence of a phone: columns of the teacher's probabilities."""

    phoneme: int
    viseme: int | None

    @classmethod
    def of(cls, label: Label) -> "_LabelledSound":
        viseme = viseme_of(label.phone, label.phoneme)
        return cls(int(label.phoneme), None if viseme is None else len(Phoneme) + int(viseme))

    def sums(self, evidence: Float64Array) -> Float64Array:
        """Return the sums of the evidence up to each place, shape (n_places + 1,)."""
        other = self.phoneme if self.viseme is None else self.viseme
        likely = evidence[:, self.phoneme] + VISEME_SHARE * evidence[:, other]
        return np.concatenate(([0.0], np.cumsum(likely)))


def _choices(labels: Sequence[Label], sounds: Sequence[_LabelledSound], n_places: int) -> list[Int64Array]:
    """Return for each boundary, and both ends, where it may lie, in steps."""
    found = [np.array([_place(labels[0].start, n_places)])]
    for label, sound, following in zip(labels, sounds, sounds[1:], strict=False):
        reach = 0.0 if sound == following else FARTHEST
        first, last = (_place(label.end + sign * reach, n_places) for sign in (-1, 1))
        found.append(np.arange(first, last + 1))
    return [*found, np.array([_place(labels[-1].end, n_places)])]


def _place(time: float, n_places: int) -> int:
    return min(max(round(time / STEP), 0), n_places)


def moves_of(before: Sequence[Label], after: Sequence[Label]) -> Float64Array:
    """Return by how much each boundary between two labels moved, seconds."""
    return np.array([b.end - a.end for a, b in zip(before[:-1], after[:-1], strict=True)], float)


@dataclass(frozen=True)
class Round:
    """What a round did.

    Attributes
    ----------
    moves : of all boundaries of people's labels, seconds, shape (n,).
    macro_f1 : of people, by heads that did not learn from them but from the labels of others before and after this
        round, on the frames of which both labels say the same.
    """

    moves: Float64Array
    macro_f1: tuple[float, float]

    @property
    def gains(self) -> bool:
        """Whether the new labels are the better ones."""
        return self.macro_f1[1] > self.macro_f1[0]


def realigned_by(utterance: LabelledUtterance, soft: NDArray[np.floating]) -> LabelledUtterance:
    """Return a recording whose boundaries lie where the teacher recognises the change."""
    return replace(utterance, labels=realigned(utterance.labels, evidence_of(soft))) if len(soft) else utterance


def macro_f1_of_both(
    recordings: Iterable[tuple[LabelledUtterance, LabelledUtterance, NDArray[np.floating]]],
) -> float:
    """Score probabilities on the frames of which the labels of two versions of a recording say the same."""
    confusion = np.zeros((len(Phoneme), len(Phoneme)), np.int64)
    for before, after, soft in recordings:
        old, new = (frame_labels_of(version.labels).phonemes for version in (before, after))
        n = min(len(old), len(new), len(soft))
        same = (old[:n] == new[:n]) & (old[:n] != Phoneme.UNIDENTIFIED)
        named = soft[:n, : len(Phoneme)].argmax(axis=1).astype(np.uint8)
        confusion += confusion_of(old[:n][same], named[same])
    return float(macro_f1_of(confusion, SCORED_PHONEMES))


def round_of(
    versions: Sequence[tuple[LabelledUtterance, LabelledUtterance]], before: SoftLabels, after: SoftLabels
) -> Round:
    """Return what a round did.

    Parameters
    ----------
    versions : people's recordings, each with the labels before and after it.
    before, after : what heads say that learned from the labels before and after it.
    """
    figures = [macro_f1_of_both((a, b, soft[key_of(a)]) for a, b in versions) for soft in (before, after)]
    moves = [moves_of(a.labels, b.labels) for a, b in versions]
    return Round(np.concatenate(moves), (figures[0], figures[1]))
