"""People's phone times anew, in rounds: networks learn from the labels, the labels are moved by networks and teacher.

Each recording is aligned by a network that did not hear its speaker. A round is kept if networks that learn from its
labels are right more often about people whom they did not hear, on the frames of which old and new labels say the
same.
"""

from collections.abc import Callable, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from phonemeengine.analyser import BLOCK, analyse_blocks
from phonemeengine.arrays import Float64Array
from phonemeengine.calibration.learning.example_cache import INDEX, write_examples
from phonemeengine.calibration.learning.parallel_training import TrainingPart, train_parts
from phonemeengine.calibration.learning.realignment import evidence_of, moves_of, realigned
from phonemeengine.calibration.learning.soft_labels import SoftLabels, key_of
from phonemeengine.calibration.learning.training import TrainingConfig
from phonemeengine.calibration.learning.validation import preset_of
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES, confusion_of, macro_f1_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model
from phonemeengine.recognition.scores import scores_in
from phonemeengine.settings import HOP

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
        ]  # fmt: skip
        found = train_parts(
            parts, folder, weights, partial(_hear, people), lambda share: on_progress((number + share) / (ROUNDS + 1))
        )  # fmt: skip
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
