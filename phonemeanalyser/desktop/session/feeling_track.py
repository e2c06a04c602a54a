"""How a voice sounds over time: activation and pleasantness of a whole file, and of live sound."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import Qt, Signal
from typing_extensions import override

from phonemeanalyser.desktop.session.history import CAPACITY, History
from phonemeanalyser.desktop.session.seen_track import SeenTrack
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.framing import LEAD, Framer, frame_count
from phonemeengine.execution import Progress, report_progress
from phonemeengine.features.feeling import Feeling, FeelingEstimator, FeltFrames
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE, WINDOW

BLOCK = 500
"""Frames of a file that are estimated at a time."""
SHOWN_EVERY = 20
"""Blocks of a file after which what is known is drawn."""
AT_ONCE = 100
"""Columns of live sound that are estimated for a picture at most."""


class KnownFeelings(NamedTuple):
    """Feelings from a frame on: shape (n_frames, 4), as `Feeling` names the columns; NaN where nothing is known."""

    first: int
    felt: FeltFrames

    def at(self, frame: int) -> Feeling | None:
        """Return what is known of a frame."""
        k = frame - self.first
        known = 0 <= k < len(self.felt) and not np.isnan(self.felt[k, 0])
        return Feeling(*self.felt[k].tolist()) if known else None


class FeelingTrack(SeenTrack):
    """Estimates a file from its beginning, once that is wanted: habits of the speaker are those of all that came."""

    _grown = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._grown.connect(self.changed, Qt.ConnectionType.QueuedConnection)
        self._felt: FeltFrames | None = None

    def feelings_in(self, seen: TimeSpan) -> KnownFeelings:
        """Return what is known of some seconds; the rest is estimated in the background."""
        if self._felt is None and self._open is not None:
            self._felt = np.full((frame_count(round(self._duration * SAMPLE_RATE)), 4), np.nan, np.float32)
            self._estimate(self._open, self._felt)
        first = max(0, int(seen.start / FRAME_PERIOD))
        felt = np.zeros((0, 4), np.float32) if self._felt is None else self._felt
        return KnownFeelings(first, felt[first : int(seen.end / FRAME_PERIOD) + 1])

    def _estimate(self, open_sound: Callable[[], SoundReader], felt: FeltFrames) -> None:
        def estimate(progress: Progress) -> None:
            framer, estimator, n = Framer(), FeelingEstimator(), 0
            with open_sound() as reader:
                for k, samples in enumerate(reader.blocks(BLOCK * HOP), 1):
                    new = estimator.follow(framer.cut_frames(samples))[: len(felt) - n]
                    felt[n : n + len(new)] = new
                    n += len(new)
                    report_progress(progress, min(1.0, n / len(felt)))
                    if k % SHOWN_EVERY == 0:
                        self._grown.emit()
            felt[n:] = estimator.follow(framer.finish())[: len(felt) - n]

        self._work.replace(estimate, lambda _: self.changed.emit())

    @override
    def _forget(self) -> None:
        self._felt = None
        super()._forget()


class LiveFeelings:
    """Estimates live sound as far as it is looked at; times are seconds since Clear.

    Parameters
    ----------
    history : of what was found lately.
    """

    def __init__(self, history: History) -> None:
        self._history, self._felt = history, np.full((CAPACITY, 4), np.nan, np.float32)
        self.forget()

    def forget(self, _column: int = 0) -> None:
        """Estimate all that is remembered anew."""
        self._n, self._estimator = 0, FeelingEstimator()

    def feelings_in(self, seen: TimeSpan) -> KnownFeelings:
        """Return what is known of some seconds, after estimating what is new, oldest first."""
        oldest = self._history.n - len(self._history.indices(0, self._history.n))
        first, last = max(self._n, oldest), min(self._history.n, max(self._n, oldest) + AT_ONCE)
        if last > first:
            sound = self._history.sound_between(first * HOP - LEAD, (last - 1) * HOP - LEAD + WINDOW)
            new = self._estimator.follow(np.lib.stride_tricks.sliding_window_view(sound, WINDOW)[::HOP])
            columns = np.arange(first, last)
            there = self._history.columns_with_sound(columns)[:, np.newaxis]
            self._felt[columns % CAPACITY] = np.where(there, new, np.float32(np.nan))
            self._n = last
        begin = max(0, oldest, int(seen.start / FRAME_PERIOD))
        wanted = np.arange(begin, max(begin, min(self._n, int(seen.end / FRAME_PERIOD) + 1)))
        return KnownFeelings(begin, self._felt[wanted % CAPACITY])
