"""The waveform of what is seen of a long file, read ahead of the analysis of the whole file."""

import time
from collections.abc import Callable

import numpy as np
from PySide6.QtCore import Qt, Signal
from typing_extensions import override

from phonemeanalyser.desktop.session.seen_track import SeenTrack
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.waveform_peaks import FINEST, Peaks, WaveformPeaks, zero_crossing_near
from phonemeengine.execution import Progress, report_progress
from phonemeengine.settings import SAMPLE_RATE

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
BLOCK = 2**18
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
                    block := reader.read_mono(min(BLOCK, left))
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
