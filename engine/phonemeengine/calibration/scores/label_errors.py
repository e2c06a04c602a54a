"""Where something else was recognised than the labels say."""

from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import UInt8Array
from phonemeengine.calibration.scores.corpus import FrameLabels
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

LEAST = 0.03
"""Seconds that an error lasts: labels are no more exact than that."""
ERROR_COLUMNS = ("start_s", "end_s", "said", "recognised")


@dataclass(frozen=True)
class LabelError:
    """A stretch in which something else was recognised than was said.

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
    """Return where something else was recognised than the labels surely say.

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
    return [
        _error(first, said.phonemes[first:last], recognised[first:last])
        for first, last in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)
        if (last - first) * FRAME_PERIOD >= least - 1e-9
    ]


def _error(first: int, said: UInt8Array, recognised: UInt8Array) -> LabelError:
    """Return an error that begins with a frame, of what was said and recognised in its frames."""
    mostly, start = _most(recognised), first * FRAME_PERIOD
    seen = first + int((recognised == mostly).argmax()) + 1
    end = (first + len(said)) * FRAME_PERIOD
    return LabelError(start, end, _most(said), mostly, seen * FRAME_PERIOD)


def _most(codes: UInt8Array) -> Phoneme:
    return Phoneme(int(np.bincount(codes).argmax()))
