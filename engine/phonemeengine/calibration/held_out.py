"""Judging a preset by what was kept from learning, and what it may not lose."""

import itertools
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from phonemeengine.arrays import BoolArray, UInt8Array
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, frame_labels_of
from phonemeengine.calibration.scores.evaluation import Predictions, predict
from phonemeengine.calibration.scores.gains import PairedAnswers
from phonemeengine.calibration.scores.scoring import Scores, scores_of
from phonemeengine.calibration.takes.take import TRIMMED
from phonemeengine.labels.label import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD

# What a preset may not lose by knowing a voice better.

MOST_LOSS = 0.01
"""By how much a share may get worse."""
GUARDED = (
    ("mouth-shape accuracy", "viseme_accuracy", 1),
    ("silence recall", "silence_recall", 1),
    ("false silence", "false_silence", -1),
)
"""What is guarded: in words, the figure's name, and whether more of it is better (1) or worse (-1)."""


def loss_of(before: Scores, after: Scores) -> str:
    """Return what gets worse by more than `MOST_LOSS`, such as "silence recall falls from 99.9 % to 39.7 %".

    Empty where nothing does; what the labels do not hold is not asked.
    """
    losses = []
    for words, name, sign in GUARDED:
        old, new = float(getattr(before, name)), float(getattr(after, name))
        if sign * (old - new) > MOST_LOSS:
            losses.append(f"{words} {'falls' if sign > 0 else 'rises'} from {100 * old:.1f} % to {100 * new:.1f} %")
    return " and ".join(losses)


N_PARTS = 4
"""Parts of each recording, each of which is held out once: so it is tried with nearly all that there is to learn."""

NOT_ASKED = 255
"""Stands for the answer about a frame that does not count."""

Utterances = tuple[LabelledUtterance, ...]


def parts_of(utterances: Sequence[LabelledUtterance]) -> Iterator[tuple[Utterances, Utterances]]:
    """Return what is learned from, and what is held out meanwhile, for each quarter of all recordings.

    Both are the whole recordings. What is held out is unidentified in the first; in both, what does not count is
    ``trimmed``.
    """
    for part in range(N_PARTS):
        halves = [_parted(utterance, part) for utterance in utterances]
        yield tuple(learned_from for learned_from, _ in halves), tuple(kept for _, kept in halves)


def predictions_on(cases: Iterable[tuple[Preset, Sequence[LabelledUtterance]]]) -> list[Predictions]:
    """Have presets recognise recordings.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    return [predict(utterance, preset) for preset, utterances in cases for utterance in utterances]


def held_out_scores(predictions: Sequence[Predictions]) -> Scores:
    """Score recordings, all together; labels that are ``trimmed`` do not count, but for the flicker."""
    scores = scores_of([_counted(prediction) for prediction in predictions])
    flicker = scores_of([prediction.answers for prediction in predictions])
    return replace(scores, changes_per_s=flicker.changes_per_s, label_changes_per_s=flicker.label_changes_per_s)


def paired_answers(before: Sequence[Predictions], after: Sequence[Predictions]) -> list[PairedAnswers]:
    """Return of each recording what was said and both answers, of the frames that count in both."""
    learned: dict[object, UInt8Array] = {}
    for prediction in after:
        codes = learned.setdefault(_key(prediction), np.full(len(prediction.phonemes), NOT_ASKED, np.uint8))
        kept = _kept(prediction)
        codes[kept] = prediction.phonemes[kept]
    pairs = []
    for prediction in before:
        codes = learned[_key(prediction)]
        both = _kept(prediction) & (codes != NOT_ASKED)
        pairs.append((prediction.labels.phonemes[both], prediction.phonemes[both], codes[both]))
    return pairs


def counts(labels: Sequence[Label]) -> bool:
    """Return whether anything of these labels counts."""
    return any(label.certainty != TRIMMED for label in labels)


def _counted(prediction: Predictions) -> tuple[FrameLabels, UInt8Array]:
    kept = _kept(prediction)
    return prediction.labels.at(kept), prediction.phonemes[kept]


def _key(prediction: Predictions) -> object:
    return prediction.utterance.path, prediction.utterance.channel


def _kept(prediction: Predictions) -> BoolArray:
    """Return which frames count, shape (n_frames,)."""
    trimmed = tuple(
        replace(label, phoneme=Phoneme.UNIDENTIFIED if label.certainty == TRIMMED else Phoneme.SILENCE)
        for label in prediction.utterance.labels
    )
    kept: BoolArray = frame_labels_of(trimmed).phonemes != Phoneme.UNIDENTIFIED
    return kept


def _parted(utterance: LabelledUtterance, part: int) -> tuple[LabelledUtterance, LabelledUtterance]:
    """Return a recording without a part of what counts in it, and with that part alone."""
    first, last = _borders_of(utterance.labels, part)
    pieces = [piece for label in utterance.labels for piece in _cut(label, first, last)]
    inside = [first <= piece.start < last for piece in pieces]
    hidden = [replace(piece, phoneme=Phoneme.UNIDENTIFIED, certainty=TRIMMED) for piece in pieces]
    learned_from = tuple(h if within else piece for piece, h, within in zip(pieces, hidden, inside, strict=True))
    kept = tuple(
        piece if within else replace(piece, certainty=TRIMMED) for piece, within in zip(pieces, inside, strict=True)
    )
    return replace(utterance, labels=learned_from), replace(utterance, labels=kept)


def _borders_of(labels: tuple[Label, ...], part: int) -> tuple[float, float]:
    """Return between which times a part lies, so that of what counts each has as much."""
    times = [np.arange(x.start, x.end, FRAME_PERIOD) for x in labels if x.certainty != TRIMMED]
    split = np.array_split(np.concatenate([np.zeros(0), *times]), N_PARTS)
    firsts = [float(piece[0]) if len(piece) else labels[-1].end for piece in split]
    edges = [0.0, *firsts[1:], labels[-1].end]
    return edges[part], edges[part + 1]


def _cut(label: Label, *times: float) -> list[Label]:
    borders = [label.start, *(time for time in times if label.start < time < label.end), label.end]
    return [replace(label, start=a, end=b) for a, b in itertools.pairwise(borders)]
