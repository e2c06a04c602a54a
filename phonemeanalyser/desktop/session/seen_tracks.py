"""What is measured of a sound in the background, as far as it is in view."""

import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal
from typing_extensions import override

from phonemeanalyser.desktop.session.results import CAPACITY, History
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.formants import CEILING, WINDOW_SECONDS, formants_of
from phonemeengine.dsp.framing import LEAD, Framer, frame_count
from phonemeengine.dsp.waveform_peaks import FINEST, Peaks, WaveformPeaks, zero_crossing_near
from phonemeengine.execution import Progress, report_progress
from phonemeengine.features.feeling import Feeling, FeelingEstimator, FeltFrames
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE, WINDOW


class SeenTrack(QObject):
    """Measures something of a sound; subclasses say what, and forget what they know in `_forget`.

    Signals
    -------
    changed : more of it is measured, or another sound is there.
    error : a sentence for the user.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._open: Callable[[], SoundReader] | None = None
        self._duration = 0.0
        self._work = TaskQueue(self.error.emit)

    @property
    def busy(self) -> bool:
        """Whether more is being measured."""
        return self._work.busy

    def open(self, open_sound: Callable[[], SoundReader], duration: float) -> None:
        """Measure another sound, of this many seconds."""
        self._open, self._duration = open_sound, duration
        self._forget()

    def leave(self) -> None:
        """Know nothing any more."""
        self._open, self._duration = None, 0.0
        self._forget()

    def close(self) -> None:
        """End all work."""
        self._work.close(CLOSE_TIMEOUT)

    def _forget(self) -> None:
        """Measure everything anew."""
        self._work.cancel()
        self.changed.emit()


MOST_SECONDS = 60.0
"""Of formants that are measured at once; in more they could not be told apart."""
SHARE_AROUND = 0.5
"""Share of what is seen that is measured on either side of it, so that little is missing in scrolling."""


class KnownFormants(NamedTuple):
    """Formants from a frame on: frequencies, float32, shape (n_frames, 5), Hz; NaN where there are none."""

    first: int
    frequencies: Float32Array


class FormantTrack(SeenTrack):
    """Measures the formants that are in view, once they are wanted.

    Attributes
    ----------
    ceiling : Hz below which they are looked for.
    """

    def __init__(self) -> None:
        super().__init__()
        self.ceiling = CEILING
        self._known: KnownFormants | None = None
        self._wanted: tuple[int, int] = (0, 0)

    def formants_in(self, seen: TimeSpan) -> KnownFormants | None:
        """Return what is known, which may be less than is seen; what is missing is measured in the background."""
        if not 0 < seen.seconds <= MOST_SECONDS or self._open is None:
            return None
        first = max(0, int(seen.start / FRAME_PERIOD))
        n_frames = int(np.ceil(self._duration / FRAME_PERIOD))
        last = min(n_frames, int(np.ceil(seen.end / FRAME_PERIOD)))
        begin, end = self._wanted
        if first < begin or last > end:
            around = int(SHARE_AROUND * (last - first))
            self._measure(max(0, first - around), min(n_frames, last + around))
        return self._known

    def _measure(self, first: int, last: int) -> None:
        open_sound, ceiling, self._wanted = self._open, self.ceiling, (first, last)
        assert open_sound is not None
        margin = int(WINDOW_SECONDS / FRAME_PERIOD)

        def measure(_progress: Progress) -> KnownFormants:
            begin = max(0, first - margin)
            with open_sound() as reader:
                reader.seek(begin * HOP)
                samples = reader.read_mono((last + margin - begin) * HOP)
            found = formants_of(samples, first_frame=first - begin, n_frames=last - first, ceiling=ceiling)
            return KnownFormants(first, found.frequencies)

        self._work.replace(measure, self._take)

    def _take(self, known: KnownFormants) -> None:
        self._known = known
        self.changed.emit()

    @override
    def _forget(self) -> None:
        self._known, self._wanted = None, (0, 0)
        super()._forget()


LONG = 600.0
"""Seconds of sound from which on its outline is shown while it is still being read."""
SHOWN_EVERY = 0.2
"""Seconds between two pictures of an outline that is being read."""
MOST_SAMPLED = 12.0
"""Of which each sample is known, for a view of single ones, and for zero crossings."""
AROUND = 10.0
"""Seconds that are read on either side of what is seen, so that little is missing in scrolling."""
MOST_KEPT = round((MOST_SAMPLED + 2 * AROUND + 1) * SAMPLE_RATE)
"""Samples that are read at once, of which each is kept; of more, only the outline."""
SAMPLES_AT_ONCE = 2**18
"""Samples that are read at a time."""


class WaveformTrack(SeenTrack):
    """Reads the waveform that is in view: each sample of a short view, else its outline.

    The outline is read if the analysis has not come so far yet.
    """

    _grown = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._grown.connect(self.changed, Qt.ConnectionType.QueuedConnection)
        self._wanted = 0, 0
        self._first = 0
        self._peaks = WaveformPeaks()
        self._samples: Float32Array = np.zeros(0, np.float32)

    @property
    def _n_samples(self) -> int:
        return round(self._duration * SAMPLE_RATE)

    def outline_in(self, seen: TimeSpan, known: WaveformPeaks, n_columns: int) -> Peaks:
        """Return the outline of what is seen, a point for each column; what is unknown is read in the background.

        `known` is the outline from the beginning of the file as far as the analysis has read it.
        """
        first, last = seen.start * SAMPLE_RATE, seen.end * SAMPLE_RATE
        if self.samples_in(seen) is not None:
            return self._peaks.between(first - self._first, last - self._first, n_columns)
        outline = known.between(first, last, n_columns)
        if known.n_samples >= min(last, self._n_samples) or seen.seconds <= 0:
            return outline
        self._want(int(first), min(self._n_samples, int(np.ceil(last))))
        mine = self._peaks.between(first - self._first, last - self._first, n_columns)
        missing = np.isnan(outline.low)
        return Peaks(*(np.where(missing, a, b) for a, b in zip(mine, outline, strict=True)))

    def samples_in(self, seen: TimeSpan) -> tuple[int, Float32Array] | None:
        """Return the number of the first sample that is seen, and these; None for a long view, or until known."""
        if not 0 < seen.seconds <= MOST_SAMPLED:
            return None
        first = int(seen.start * SAMPLE_RATE)
        last = min(self._n_samples, int(np.ceil(seen.end * SAMPLE_RATE)) + 1)
        self._want(first, last, sampled=True)
        begin, end = first - self._first, last - self._first
        return (first, self._samples[begin:end]) if 0 <= begin < end <= len(self._samples) else None

    def crossing_near(self, seen: TimeSpan, time: float, reach: float) -> float | None:
        """Return where the waveform crosses zero nearest to a time, within some seconds; None where it is unknown."""
        known = self.samples_in(seen)
        if known is None:
            return None
        found = zero_crossing_near(known[1], time * SAMPLE_RATE - known[0], reach * SAMPLE_RATE)
        return None if found is None else (known[0] + found) / SAMPLE_RATE

    def _want(self, first: int, last: int, *, sampled: bool = False) -> None:
        begin, end = self._wanted
        is_outline = end - begin > MOST_KEPT
        if self._open is not None and (first < begin or last > end or (sampled and is_outline)):
            around = round(AROUND * SAMPLE_RATE)
            self._read(max(0, first - around) // FINEST * FINEST, min(self._n_samples, last + around), self._open)

    def _read(self, first: int, last: int, open_sound: Callable[[], SoundReader]) -> None:
        self._wanted = first, last
        sampled, long = last - first <= MOST_KEPT, last - first > LONG * SAMPLE_RATE
        peaks = WaveformPeaks(1 if sampled else FINEST)
        if long:
            self._first, self._peaks, self._samples = first, peaks, np.zeros(0, np.float32)

        def read(progress: Progress) -> tuple[int, WaveformPeaks, Float32Array]:
            samples, shown = [np.zeros(0, np.float32)], time.monotonic()
            with open_sound() as reader:
                reader.seek(first)
                while (left := last - first - peaks.n_samples) > 0 and len(
                    block := reader.read_mono(min(SAMPLES_AT_ONCE, left))
                ):
                    peaks.push(block)
                    if sampled:
                        samples.append(block.copy())
                    report_progress(progress, peaks.n_samples / (last - first))
                    if long and time.monotonic() > shown + SHOWN_EVERY:
                        shown = time.monotonic()
                        self._grown.emit()
            return first, peaks, np.concatenate(samples)

        self._work.replace(read, self._take)

    def _take(self, found: tuple[int, WaveformPeaks, Float32Array]) -> None:
        self._first, self._peaks, self._samples = found
        self.changed.emit()

    @override
    def _forget(self) -> None:
        self._wanted, self._first, self._peaks = (0, 0), 0, WaveformPeaks()
        self._samples = np.zeros(0, np.float32)
        super()._forget()


FRAMES_AT_ONCE = 500
"""Frames of a file that are estimated at a time."""
BLOCKS_A_PICTURE = 20
"""Blocks of a file after which what is known is drawn."""
COLUMNS_AT_ONCE = 100
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
                for k, samples in enumerate(reader.blocks(FRAMES_AT_ONCE * HOP), 1):
                    new = estimator.follow(framer.cut_frames(samples))[: len(felt) - n]
                    felt[n : n + len(new)] = new
                    n += len(new)
                    report_progress(progress, min(1.0, n / len(felt)))
                    if k % BLOCKS_A_PICTURE == 0:
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
        first, last = max(self._n, oldest), min(self._history.n, max(self._n, oldest) + COLUMNS_AT_ONCE)
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
