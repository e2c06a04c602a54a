"""What is taken for what, over all frames of all recordings."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from phonemeengine.arrays import BoolArray, IndexArray, Int64Array, UInt8Array
from phonemeengine.calibration.scores.corpus import FrameLabels
from phonemeengine.calibration.scores.scoring import Agreement, Scores, confusion_of, scores_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD


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
