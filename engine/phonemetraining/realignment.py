"""Times people's phones anew, in rounds: networks learn from labels, which networks and teacher then move.

The phones of people's recordings were timed by an aligner that knew little of their voices. What is said, and in
which order, stays; each boundary moves by at most `FARTHEST`, to the likeliest places of all together (dynamic
programming), where teacher and network together recognise a change. Each recording is aligned by a network that was
trained without its speaker. A round is kept if networks that learn from its labels are right more often about people
whom they were trained without, on the frames of which old and new labels say the same.
"""

from collections.abc import Callable, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from phonemeengine.analyser import BLOCK, analyse_blocks
from phonemeengine.arrays import Float64Array, Int64Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES, confusion_of, macro_f1_of
from phonemeengine.calibration.training_examples import N_HEARD
from phonemeengine.labels.label import Label
from phonemeengine.labels.visemes import viseme_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model
from phonemeengine.recognition.scores import scores_in
from phonemeengine.settings import FRAME_PERIOD, HOP
from phonemetraining.examples import INDEX, SoftLabels, key_of, write_examples
from phonemetraining.training import TrainingConfig, TrainingPart, train_parts
from phonemetraining.validation import preset_of

STEP = 0.005
"""Seconds between the places that a boundary may have."""
FARTHEST = 0.06
SPREAD = 0.01
"""Seconds by which the boundaries are taken to be off, standard deviation. Of boundaries of Festival's voices that
were moved at random by 14 ms, this leaves 9 ms on average; 20 ms leaves 10."""
SHORTEST = 0.015
"""Seconds that a phone has at least, unless it was shorter."""
TEACHER_SHARE = 0.3
"""Of the logarithms of the probabilities; the network hears every 10 ms, the teacher every 20."""
VISEME_SHARE = 0.5
"""How much the viseme counts beside the phoneme."""
LEAST_LIKELY = 1e-3


def evidence_of(heard: NDArray[np.float16], network: NDArray[np.floating]) -> Float64Array:
    """Return how likely each phoneme and viseme is every 5 ms, natural logarithms, shape (2 x n_frames, 26).

    Parameters
    ----------
    heard : the teacher's probabilities, shape (n_frames, 26).
    network : the network's, of the phonemes, shape (n_frames, 11).
    """
    n = min(len(heard), len(network))
    logs = np.log(heard[:n].astype(np.float64) + LEAST_LIKELY)
    phonemes = logs[:, : len(Phoneme)]
    phonemes *= TEACHER_SHARE
    phonemes += (1 - TEACHER_SHARE) * np.log(network[:n] + LEAST_LIKELY)
    middles = (np.arange(n) + 0.5) * FRAME_PERIOD
    places = (np.arange(2 * n) + 0.5) * STEP
    return np.stack([np.interp(places, middles, logs[:, k]) for k in range(N_HEARD)], axis=1)


def realigned(labels: Sequence[Label], evidence: Float64Array) -> tuple[Label, ...]:
    """Return the labels with moved boundaries; between sounds that nobody could tell apart they stay.

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
    """What is heard of a phone: columns of the evidence."""

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


ROUNDS = 1
"""Most rounds: each costs as much as a third of a network."""
WIDTH, EPOCHS = 48, 2
"""Of the networks that align: small ones that are soon trained."""


@dataclass(frozen=True)
class Round:
    """What a round did.

    Attributes
    ----------
    moves : of all boundaries of people's labels, seconds, shape (n,).
    macro_f1 : of people who were left out, by networks that learned from the labels before and after this round.
    """

    moves: Float64Array
    macro_f1: tuple[float, float]

    @property
    def gains(self) -> bool:
        """Whether the new labels are the better ones."""
        return self.macro_f1[1] > self.macro_f1[0]


@dataclass(frozen=True)
class _Heard:
    """A recording of a person, and a network's probabilities of the phonemes, shape (n_frames, 11)."""

    utterance: LabelledUtterance
    probabilities: NDArray[np.float16]


def realign_people(
    utterances: Sequence[LabelledUtterance],
    people: AbstractSet[str],
    weights: dict[str, float],
    groups: Sequence[AbstractSet[str]],
    soft_labels: SoftLabels,
    config: TrainingConfig,
    work: Path,
    on_progress: Callable[[float], object],
) -> tuple[list[LabelledUtterance], list[Round]]:
    """Return the recordings with moved labels where that helps, and what each round did.

    Parameters
    ----------
    utterances : of all speakers.
    people : the names of those whose labels are moved.
    weights : of all speakers by their names.
    groups : names of speakers, each group left out of one training.
    soft_labels : what the teacher heard.
    config : how the real networks are trained; those that align are smaller.
    work : a folder for what is done so far.
    on_progress : is told of the share that is done.
    """
    kept, rounds = list(utterances), []
    small = replace(config, width=WIDTH, n_epochs=EPOCHS)

    def listen(labelled: list[LabelledUtterance], number: int) -> list[_Heard]:
        folder = work / f"labels-{number}"
        folder.mkdir(exist_ok=True)
        if not (folder / INDEX).is_file():
            write_examples(folder, labelled, 0, config.seed, soft_labels)
        parts = [
            TrainingPart(f"without-{k}", small, tuple(u for u in labelled if u.labels and u.voice in group))
            for k, group in enumerate(groups)
        ]
        found = train_parts(
            parts, folder, weights, partial(_hear, people), lambda share: on_progress((number + share) / (ROUNDS + 1))
        )
        return [heard for _, answers in found for heard in answers]

    before = listen(kept, 0)
    for number in range(1, ROUNDS + 1):
        moved = {key_of(h.utterance): _moved(h, soft_labels) for h in before}
        tried = [moved.get(key_of(u), u) for u in kept]
        after = listen(tried, number)
        figures = tuple(_macro_f1(heard, before, after) for heard in (before, after))
        moves = [moves_of(h.utterance.labels, moved[key_of(h.utterance)].labels) for h in before]
        rounds.append(Round(np.concatenate(moves), (figures[0], figures[1])))
        if not rounds[-1].gains:
            break
        kept, before = tried, after
    return kept, rounds


def _hear(people: AbstractSet[str], model: Model, utterances: Sequence[LabelledUtterance]) -> list[_Heard]:
    """Recognise those of the recordings that are of people."""
    preset = preset_of(model)
    found = []
    for utterance in (u for u in utterances if u.voice in people):
        with utterance.opened() as reader:
            parts = [scores_in(a.features) for a in analyse_blocks(reader.blocks(BLOCK * HOP), preset)]
        known = [part.astype(np.float16) for part in parts if part is not None]
        nothing = np.zeros((0, len(Phoneme)), np.float16)
        found.append(_Heard(utterance, np.concatenate([nothing, *known])))
    return found


def _moved(heard: _Heard, soft_labels: SoftLabels) -> LabelledUtterance:
    utterance = heard.utterance
    taught = soft_labels.get(key_of(utterance))
    if taught is None:
        return utterance
    return replace(utterance, labels=realigned(utterance.labels, evidence_of(taught, heard.probabilities)))


def _macro_f1(heard: Sequence[_Heard], before: Sequence[_Heard], after: Sequence[_Heard]) -> float:
    """Score what was heard on the frames of which both labels say the same."""
    confusion = np.zeros((len(Phoneme), len(Phoneme)), np.int64)
    for h, b, a in zip(heard, before, after, strict=True):
        old, new = (frame_labels_of(x.utterance.labels).phonemes for x in (b, a))
        n = min(len(old), len(new), len(h.probabilities))
        same = (old[:n] == new[:n]) & (old[:n] != Phoneme.UNIDENTIFIED)
        confusion += confusion_of(old[:n][same], h.probabilities[:n].argmax(axis=1).astype(np.uint8)[same])
    return float(macro_f1_of(confusion, SCORED_PHONEMES))
