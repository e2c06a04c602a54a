"""The waveform of what is seen of a long file, read ahead of the analysis of the whole file."""

from collections.abc import Callable

import numpy as np

from phonemeanalyser.desktop.session.seen_track import SeenTrack
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.waveform_peaks import FINEST, Peaks, WaveformPeaks
from phonemeengine.execution import Progress, report_progress
from phonemeengine.settings import SAMPLE_RATE

MOST_SECONDS = 600.0
"""Of a waveform that is read at once; of more, what the analysis has read is shown."""
AROUND = 10.0
"""Seconds that are read on either side of what is seen, so that little is missing in scrolling."""
BLOCK = 2**18
"""Samples that are read at a time."""


class WaveformTrack(SeenTrack):
    """Reads the outline of the waveform where somebody looks, if the analysis has not come so far yet."""

    def __init__(self) -> None:
        super().__init__()
        self._wanted = 0, 0
        self._first = 0
        self._peaks = WaveformPeaks()

    @property
    def _n_samples(self) -> int:
        return round(self._duration * SAMPLE_RATE)

    def outline_in(self, seen: TimeSpan, known: WaveformPeaks, n_columns: int) -> Peaks:
        """Return the outline of what is seen in so many columns; what nobody knows yet is read in the background.

        `known` is the outline from the beginning of the file as far as the analysis has read it.
        """
        first, last = seen.start * SAMPLE_RATE, seen.end * SAMPLE_RATE
        outline = known.between(first, last, n_columns)
        if known.n_samples >= min(last, self._n_samples) or not 0 < seen.seconds <= MOST_SECONDS:
            return outline
        self._want(int(first), min(self._n_samples, int(np.ceil(last))))
        mine = self._peaks.between(first - self._first, last - self._first, n_columns)
        missing = np.isnan(outline.low)
        return Peaks(*(np.where(missing, a, b) for a, b in zip(mine, outline, strict=True)))

    def _want(self, first: int, last: int) -> None:
        begin, end = self._wanted
        if self._open is not None and (first < begin or last > end):
            around = round(AROUND * SAMPLE_RATE)
            self._read(max(0, first - around) // FINEST * FINEST, min(self._n_samples, last + around), self._open)

    def _read(self, first: int, last: int, open_sound: Callable[[], SoundReader]) -> None:
        self._wanted = first, last

        def read(progress: Progress) -> tuple[int, WaveformPeaks]:
            peaks = WaveformPeaks()
            with open_sound() as reader:
                reader.seek(first)
                while (left := last - first - peaks.n_samples) > 0 and len(
                    block := reader.read_mono(min(BLOCK, left))
                ):
                    peaks.push(block)
                    report_progress(progress, peaks.n_samples / (last - first))
            return first, peaks

        self._work.replace(read, self._take)

    def _take(self, found: tuple[int, WaveformPeaks]) -> None:
        self._first, self._peaks = found
        self.changed.emit()

    def _forget(self) -> None:
        self._wanted, self._first, self._peaks = (0, 0), 0, WaveformPeaks()
        super()._forget()
