"""How well recognised phonemes agree with labels, frame by frame, and what is taken for what.

Accuracy and F1 are averaged so that no figure hides a rare class: a macro F1 is the mean over those classes that
the labels hold.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from phonemeengine.arrays import BoolArray, Float64Array, IndexArray, Int64Array, UInt8Array
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
    fine_viseme_accuracy : share of right answers on frames whose viseme, of fifteen, is undisputed.
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


@dataclass(frozen=True, eq=False)
class Agreement:
    """How often which label has which answer, and the figures that follow; agreements of recordings add up.

    Attributes
    ----------
    counts : int64, shape (11, 11): frames by label (row) and answer (column), both by the code of `Phoneme`.
    changes, label_changes : how often the answer, and the label, becomes another within a recording.
    """

    counts: Int64Array
    changes: int
    label_changes: int

    def __add__(self, other: "Agreement") -> "Agreement":
        """Return the agreement in the frames of both."""
        return Agreement(
            self.counts + other.counts, self.changes + other.changes, self.label_changes + other.label_changes
        )

    @property
    def seconds(self) -> float:
        """How much was labelled."""
        return float(self.counts.sum() * FRAME_PERIOD)

    @property
    def classes(self) -> tuple[Phoneme, ...]:
        """Those of the ten classes that the labels hold: macro F1 is of these."""
        return tuple(p for p in SCORED_PHONEMES if self.counts[p].any())

    @property
    def accuracy(self) -> float:
        """Share of right answers on frames labelled as one of the ten classes; NaN where there is none."""
        return _ratio(self._known.trace(), self._known.sum())

    @property
    def macro_f1(self) -> float:
        """Mean F1 of those of the ten classes that the labels hold; NaN where they hold none."""
        return float(macro_f1_of(self._known, SCORED_PHONEMES))

    def f1_of(self, phoneme: Phoneme) -> float:
        """Return the F1 of one class; NaN where it is not labelled, or is none of the ten."""
        return float(macro_f1_of(self._known, (phoneme,)))

    @property
    def viseme_accuracy(self) -> float:
        """Share of frames with the right one of six mouths; NaN where there is no frame."""
        return _ratio(self.mouth_counts.trace(), self.counts.sum())

    @property
    def silence_recall(self) -> float:
        """Share of silent frames called silence; NaN where none is silent."""
        return _ratio(self.counts[Phoneme.SILENCE, Phoneme.SILENCE], self.counts[Phoneme.SILENCE].sum())

    @property
    def false_silence(self) -> float:
        """Share of spoken frames called silence; NaN where nothing is spoken."""
        spoken = np.delete(self.counts, Phoneme.SILENCE, axis=0)
        return _ratio(spoken[:, Phoneme.SILENCE].sum(), spoken.sum())

    @property
    def changes_per_s(self) -> float:
        """Changes of the answer in a second; NaN where there is no frame."""
        return _ratio(self.changes, self.seconds)

    @property
    def label_changes_per_s(self) -> float:
        """Changes of the label in a second; NaN where there is no frame."""
        return _ratio(self.label_changes, self.seconds)

    @property
    def mouth_counts(self) -> Int64Array:
        """The counts by mouth in place of phoneme, shape (6, 6)."""
        of_mouths = (MOUTH_CODES[:, None] == np.arange(len(_MOUTHS))).astype(np.int64)
        return np.asarray(of_mouths.T @ self.counts @ of_mouths, np.int64)

    def gains_over(self, before: "Agreement") -> dict[Phoneme, float]:
        """Return by how much the F1 of each class has risen (above 0) or fallen, the greatest gain first."""
        gains = {p: self.f1_of(p) - before.f1_of(p) for p in self.classes if before.counts[p].any()}
        return dict(sorted(gains.items(), key=lambda gain: -gain[1]))

    def worst_confusions(self, most: int) -> list[tuple[Phoneme, Phoneme, int]]:
        """Return which label has which wrong answer in the most frames, and in how many, the worst first."""
        wrong = self._known.copy()
        np.fill_diagonal(wrong, 0)
        worst = np.argsort(-wrong, axis=None, kind="stable")[:most].tolist()
        pairs = [divmod(place, N_CODES) for place in worst]
        return [(Phoneme(p), Phoneme(q), int(wrong[p, q])) for p, q in pairs if wrong[p, q]]

    @property
    def _known(self) -> Int64Array:
        """What counts for accuracy and F1: frames labelled as one of the ten classes."""
        known = self.counts.copy()
        known[Phoneme.UNIDENTIFIED] = 0
        return known


def agreement_of(truth: UInt8Array, guess: UInt8Array) -> Agreement:
    """Count the answers in one recording against its labels; both are codes of `Phoneme`, shape (n_frames,)."""
    return Agreement(confusion_of(truth, guess), count_changes(guess), count_changes(truth))


NOTHING_SCORED = Agreement(np.zeros((N_CODES, N_CODES), np.int64), 0, 0)


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
    agreement = sum((agreement_of(labels.phonemes, codes) for labels, codes in parts), NOTHING_SCORED)
    return Scores(
        accuracy=agreement.accuracy,
        macro_f1=agreement.macro_f1,
        vowel_accuracy=_share((truth == guess)[np.isin(truth, VOWELS) & certain]),
        viseme_accuracy=agreement.viseme_accuracy,
        viseme_f1=float(macro_f1_of(agreement.mouth_counts, range(len(_MOUTHS)))),
        silence_recall=agreement.silence_recall,
        false_silence=agreement.false_silence,
        changes_per_s=agreement.changes_per_s,
        label_changes_per_s=agreement.label_changes_per_s,
        minutes=agreement.seconds / 60,
        fine_viseme_accuracy=_share((shown == visemes)[shown != NO_VISEME]),
    )


def confusion_of(truth: UInt8Array, guess: UInt8Array) -> Int64Array:
    """Count frames by label (row) and answer (column), shape (11, 11)."""
    pairs = np.bincount(truth * np.uint8(N_CODES) + guess, minlength=N_CODES**2)  # 120 at most, which bytes hold
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
    return float(hits.mean()) if len(hits) else math.nan


def _ratio(part: float, whole: float) -> float:
    return float(part / whole) if whole else math.nan


@dataclass(frozen=True)
class ConfusedSegment:
    """A segment of a recording.

    Attributes
    ----------
    recording : number of the recording, from 0.
    start, end : seconds.
    """

    recording: int
    start: float
    end: float


@dataclass(frozen=True, eq=False)
class Confusion:
    """The answers to labelled recordings beside the labels, and how often which is taken for which.

    Attributes
    ----------
    counts : int64, shape (11, 11): frames by label (row) and answer (column), both by the code of `Phoneme`.
    labels : what was said in all recordings, one after the other.
    predicted : uint8, shape (n_frames,): what was recognised, after the statistics.
    edges : shape (n_recordings + 1,): the first frame of each recording, and the number of all frames.
    """

    counts: Int64Array
    labels: FrameLabels
    predicted: UInt8Array
    edges: IndexArray

    @cached_property
    def agreement(self) -> Agreement:
        """The figures of all recordings that follow from the counts."""
        return Agreement(self.counts, self._changes_of(self.predicted), self._changes_of(self.labels.phonemes))

    @property
    def n_recordings(self) -> int:
        """How many recordings there are."""
        return len(self.edges) - 1

    def line(self, recording: int) -> UInt8Array:
        """Return the answers in one recording: codes of `Phoneme`, one for each 10 ms; uint8, shape (n_frames,)."""
        return self.predicted[self._frames_of(recording)]

    def label_line(self, recording: int) -> UInt8Array:
        """Return the labels of one recording: codes of `Phoneme`, one for each 10 ms; uint8, shape (n_frames,)."""
        return self.labels.phonemes[self._frames_of(recording)]

    def scores(self, recordings: tuple[int, ...] | None = None) -> Scores:
        """Return all figures of agreement, of all recordings or of some; NaN where there is nothing to count."""
        chosen = range(self.n_recordings) if recordings is None else recordings
        spans = [self._frames_of(k) for k in chosen]
        return scores_of((self.labels.at(s), self.predicted[s]) for s in spans)

    def frames_in(self, truth: Phoneme, answer: Phoneme) -> tuple[ConfusedSegment, ...]:
        """Return where what was labelled `truth` was recognised as `answer`: the frames of a cell, in order."""
        inside = (self.labels.phonemes == truth) & (self.predicted == answer)
        found = np.flatnonzero(inside)
        first = self._is_first[found]
        begins = found[~inside[found - 1] | first]
        after = np.append(inside[1:], False)[found]
        ends = found[~after | np.append(self._is_first[1:], True)[found]] + 1
        recordings = np.searchsorted(self.edges, begins, side="right") - 1
        offsets = self.edges[recordings]
        return tuple(
            ConfusedSegment(recording, start * FRAME_PERIOD, end * FRAME_PERIOD)
            for recording, start, end in zip(
                recordings.tolist(), (begins - offsets).tolist(), (ends - offsets).tolist(), strict=True
            )
        )

    @cached_property
    def _is_first(self) -> BoolArray:
        first = np.zeros(len(self.predicted), bool)
        first[self.edges[:-1][self.edges[:-1] < len(first)]] = True
        return first

    def _frames_of(self, recording: int) -> slice:
        return slice(int(self.edges[recording]), int(self.edges[recording + 1]))

    def _changes_of(self, codes: UInt8Array) -> int:
        return int(np.count_nonzero((codes[1:] != codes[:-1]) & ~self._is_first[1:]))


def confusion_between(labels: FrameLabels, answers: UInt8Array, edges: IndexArray) -> Confusion:
    """Count answers against labels; the parameters are the attributes of `Confusion`."""
    return Confusion(confusion_of(labels.phonemes, answers), labels, answers, edges)


# Where something else was recognised than the labels say.

LEAST = 0.03
"""Seconds that an error lasts: labels are no more precise than that."""
ERROR_COLUMNS = ("start_s", "end_s", "said", "recognised")


@dataclass(frozen=True)
class LabelError:
    """A segment in which something else was recognised than was said.

    Attributes
    ----------
    start, end : seconds.
    said : what the labels say, in most of its frames.
    recognised : what was recognised, in most of its frames.
    seen_at : the end of the first frame in which just that was recognised, seconds: a view of all that lies before a
        time shows it last.
    """

    start: float
    end: float
    said: Phoneme
    recognised: Phoneme
    seen_at: float

    def row(self) -> tuple[str, str, str, str]:
        """Return it as a row of a table, as `ERROR_COLUMNS`."""
        return (f"{self.start:.3f}", f"{self.end:.3f}", self.said.label, self.recognised.label)


def label_errors(said: FrameLabels, recognised: UInt8Array, *, least: float = LEAST) -> list[LabelError]:
    """Return where something else was recognised than the labels surely say; see `error_spans` for the parameters."""
    return [
        _error(first, said.phonemes[first:last], recognised[first:last])
        for first, last in error_spans(said, recognised, least=least).tolist()
    ]


def error_spans(said: FrameLabels, recognised: UInt8Array, *, least: float = LEAST) -> IndexArray:
    """Return the frames of `label_errors`, shape (n_errors, 2): the first one, and the one after the last.

    Frames whose label is not a core one, or names an unidentified sound, are no errors, as in `score`; nor are those
    that no label covers.

    Parameters
    ----------
    said : what the labels say in each frame.
    recognised : codes of `Phoneme`, uint8, shape (n_frames,).
    least : seconds; what is shorter lies at the edge of a label, and is no error.
    """
    n = min(len(said.phonemes), len(recognised))
    asked = said.certain[:n] & (said.phonemes[:n] != Phoneme.UNIDENTIFIED)
    wrong = np.concatenate(([False], asked & (said.phonemes[:n] != recognised[:n]), [False]))
    edges = np.flatnonzero(wrong[1:] != wrong[:-1])
    spans = edges.reshape(-1, 2)
    return np.asarray(spans[(spans[:, 1] - spans[:, 0]) * FRAME_PERIOD >= least - 1e-9])


def _error(first: int, said: UInt8Array, recognised: UInt8Array) -> LabelError:
    """Return an error that begins with a frame, of what was said and recognised in its frames."""
    mostly, start = _most(recognised), first * FRAME_PERIOD
    seen = first + int((recognised == mostly).argmax()) + 1
    end = (first + len(said)) * FRAME_PERIOD
    return LabelError(start, end, _most(said), mostly, seen * FRAME_PERIOD)


def _most(codes: UInt8Array) -> Phoneme:
    return Phoneme(int(np.bincount(codes).argmax()))
