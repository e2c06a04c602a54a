"""How well recognised phonemes agree with labels, frame by frame.

Accuracy and F1 are averaged so that no figure hides a rare class: a macro F1 is the mean over those classes that
the labels hold.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import BoolArray, Float64Array, Int64Array, UInt8Array
from phonemeengine.calibration.scores.corpus import FrameLabels
from phonemeengine.labels.visemes import NO_VISEME, STANDARD_VISEMES
from phonemeengine.phonemes import VOWELS, Phoneme
from phonemeengine.recognition.segments import count_changes
from phonemeengine.settings import FRAME_PERIOD

N_CODES = len(Phoneme)
SCORED_PHONEMES = tuple(p for p in Phoneme if p is not Phoneme.UNIDENTIFIED)
"""The classes that are scored."""


_MOUTHS: tuple[tuple[Phoneme, ...], ...] = (
    (Phoneme.SILENCE,),
    (Phoneme.A,),
    (Phoneme.E, Phoneme.I),
    (Phoneme.O, Phoneme.U),
    (Phoneme.M, Phoneme.P),
    (Phoneme.SZ, Phoneme.SCH, Phoneme.UNIDENTIFIED),
)
MOUTH_CODES = np.array([next(k for k, shape in enumerate(_MOUTHS) if p in shape) for p in Phoneme], np.uint8)
"""Which of six mouths (rest, open, wide, round, closed, slight) each phoneme has, by its code."""


@dataclass(frozen=True)
class Scores:
    """Figures of agreement; NaN where the labels hold nothing to count.

    Attributes
    ----------
    accuracy, macro_f1 : accuracy and macro F1 over the ten classes, on frames labelled as one of them.
    vowel_accuracy : share of right answers on frames labelled as a clear a, e, i, o or u.
    viseme_accuracy, viseme_f1 : accuracy and macro F1 over six mouths (silence apart from closed), on all frames.
    silence_recall : share of silent frames called silence.
    false_silence : share of spoken frames called silence.
    changes_per_s, label_changes_per_s : changes of the phoneme in a second, recognised and labelled.
    minutes : how much was scored.
    fine_viseme_accuracy : share of right answers on frames of which nobody doubts which of fifteen visemes they show.
    """

    accuracy: float
    macro_f1: float
    vowel_accuracy: float
    viseme_accuracy: float
    viseme_f1: float
    silence_recall: float
    false_silence: float
    changes_per_s: float
    label_changes_per_s: float
    minutes: float
    fine_viseme_accuracy: float


Answers = tuple[FrameLabels, UInt8Array] | tuple[FrameLabels, UInt8Array, UInt8Array]
"""The labels of an utterance, the recognised codes, and maybe the visemes, each of shape (n_frames,)."""


def scores_of(answers: Iterable[Answers]) -> Scores:
    """Score utterances.

    A frame that was not recognised, at the end of a sound shorter than its labels, counts as silence.
    """
    usual = STANDARD_VISEMES.usual_visemes
    given = [(labels, guess, visemes[0] if visemes else usual(guess)) for labels, guess, *visemes in answers]
    parts = [(labels, _fitted(guess, len(labels.phonemes))) for labels, guess, _ in given]
    visemes = np.concatenate([_fitted(seen, len(labels.phonemes)) for labels, _, seen in given])
    shown = np.concatenate([labels.visemes for labels, _ in parts])
    truth = np.concatenate([labels.phonemes for labels, _ in parts])
    guess = np.concatenate([codes for _, codes in parts])
    certain = np.concatenate([labels.certain for labels, _ in parts])
    known, silent = truth != Phoneme.UNIDENTIFIED, truth == Phoneme.SILENCE
    right = truth == guess
    mouths, guessed_mouths = MOUTH_CODES[truth], MOUTH_CODES[guess]
    seconds = len(truth) * FRAME_PERIOD
    return Scores(
        accuracy=_share(right[known]),
        macro_f1=float(macro_f1_of(confusion_of(truth[known], guess[known]), SCORED_PHONEMES)),
        vowel_accuracy=_share(right[np.isin(truth, VOWELS) & certain]),
        viseme_accuracy=_share(mouths == guessed_mouths),
        viseme_f1=float(macro_f1_of(confusion_of(mouths, guessed_mouths), range(len(_MOUTHS)))),
        silence_recall=_share(guess[silent] == Phoneme.SILENCE),
        false_silence=_share(guess[~silent] == Phoneme.SILENCE),
        changes_per_s=sum(count_changes(codes) for _, codes in parts) / seconds,
        label_changes_per_s=sum(count_changes(labels.phonemes) for labels, _ in parts) / seconds,
        minutes=seconds / 60,
        fine_viseme_accuracy=_share((shown == visemes)[shown != NO_VISEME]),
    )


def confusion_of(truth: UInt8Array, guess: UInt8Array) -> Int64Array:
    """Count frames by label (row) and answer (column), shape (11, 11)."""
    pairs = np.bincount(truth.astype(np.int64) * N_CODES + guess, minlength=N_CODES**2)
    return pairs.reshape(N_CODES, N_CODES)


def macro_f1_of(confusion: Int64Array, classes: Iterable[int]) -> Float64Array:
    """Return the mean F1 over those classes that the labels hold.

    Parameters
    ----------
    confusion : shape (..., n, n), as from `confusion_of`; leading axes are kept.
    classes : the codes that count; NaN comes where the labels hold none of them.
    """
    chosen = list(classes)
    hits = np.diagonal(confusion, axis1=-2, axis2=-1)[..., chosen]
    labelled = confusion.sum(axis=-1)[..., chosen]
    totals = labelled + confusion.sum(axis=-2)[..., chosen]
    f1 = np.where(labelled > 0, 2 * hits / np.maximum(totals, 1), 0)
    n_present = (labelled > 0).sum(axis=-1)
    return np.where(n_present > 0, f1.sum(axis=-1) / np.maximum(n_present, 1), np.nan)


def _fitted(codes: UInt8Array, n: int) -> UInt8Array:
    missing = max(0, n - len(codes))
    return np.concatenate((codes[:n], np.full(missing, Phoneme.SILENCE, np.uint8)))


def _share(hits: BoolArray) -> float:
    return float(hits.mean()) if len(hits) else float("nan")
