"""The sonagram and the formants of live sound, measured at once from the last minute, as those of a file are."""

from collections import OrderedDict
from math import ceil, floor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from phonemeanalyser.desktop.session.history import CAPACITY, History
from phonemeanalyser.desktop.session.seen_tracks import MOST_SECONDS, KnownFormants
from phonemeanalyser.desktop.session.sonagram_tiles import Key, SonagramTiles, Tile, keys_for, levels_of
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.arrays import Float32Array, IndexArray
from phonemeengine.dsp.formants import WINDOW_SECONDS, formants_of
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE

COLUMNS = 128
"""Of a tile: few, since the newest one is coloured anew with every picture."""
MOST_TILES = 64
"""That are kept: 4 MB of 256 rows."""
AT_ONCE, AT_LEAST = 50, 8
"""Frames of formants that are measured for a picture at most, and at least, unless all are known."""
N_FORMANTS = 5


class _Past:
    """The sound since Clear, read as a file is."""

    def __init__(self, history: History) -> None:
        self._history, self._next = history, 0

    def seek(self, sample: int) -> None:
        """Go to a sample."""
        self._next = sample

    def read_mono(self, n: int) -> Float32Array:
        """Return the next samples; silence beyond the newest one."""
        first, self._next = self._next, self._next + n
        return self._history.sound_between(first, self._next)


class _Known(NamedTuple):
    """A tile, the columns of the history when it was measured, and how many of its own change no more."""

    tile: Tile
    n: int
    n_final: int


class LiveSonagram:
    """Measures what is looked at of live sound, with what the sonagram of files is measured with.

    Times are seconds since Clear. A tile is NaN where there is no sound, or it is not remembered any more.

    Parameters
    ----------
    history : of what was found lately.
    tiles : the sonagram of files, which says how it is measured.
    """

    def __init__(self, history: History, tiles: SonagramTiles) -> None:
        self._history, self._of_files = history, tiles
        self._measured_with: object = None
        self._known: OrderedDict[Key, _Known] = OrderedDict()
        self._formants = np.full((CAPACITY, N_FORMANTS), np.nan, np.float32)
        self._first = self._last = 0

    def tiles_for(self, seen: TimeSpan, n_pixels: int) -> list[Tile]:
        """Return what is known of some seconds that are seen in a number of pixels."""
        measured_with = self._of_files.settings, self._of_files.filters
        if measured_with != self._measured_with:
            self._measured_with, self._known = measured_with, OrderedDict()
        keys = keys_for(seen, n_pixels, self._history.n * FRAME_PERIOD, COLUMNS)
        tiles = [self._tile(key) for key in keys]
        while len(self._known) > max(MOST_TILES, len(keys)):
            self._known.popitem(last=False)
        return tiles

    def levels_of(self, columns: IndexArray) -> Float32Array:
        """Return the levels of columns of the history, dB, float32, shape (n_columns, n_rows)."""
        settings, filters = self._of_files.settings, self._of_files.filters
        if not len(columns):
            return np.zeros((0, settings.n_rows), np.float32)
        first, last = int(columns[0]), int(columns[-1]) + 1
        start, n = first * FRAME_PERIOD, last - first
        return levels_of(_Past(self._history), settings, filters, start, FRAME_PERIOD, n)[columns - first]

    def formants_in(self, seen: TimeSpan, ceiling: float) -> KnownFormants | None:
        """Return what is known, which may be less than is seen; the newest of what is missing is measured first.

        Parameters
        ----------
        seen : the seconds; of more than `MOST_SECONDS` nothing is known.
        ceiling : Hz below which formants are looked for.
        """
        if not 0 < seen.seconds <= MOST_SECONDS:
            return None
        margin = ceil(WINDOW_SECONDS / 2 / FRAME_PERIOD)
        oldest = self._history.n - len(self._history.indices(0, self._history.n))
        first = max(0, oldest, int(seen.start / FRAME_PERIOD))
        last = min(self._history.n - margin, ceil(seen.end / FRAME_PERIOD))
        if last <= first:
            return None
        if self._first == self._last or last < self._first or first > self._last:
            self._first = self._last = last
        self._first = max(self._first, oldest)
        newer, older = last - self._last, self._first - first
        if newer >= AT_LEAST:
            begin = max(self._last, last - AT_ONCE)
            if begin > self._last:  # more came than is measured at once: what is older is missing again
                self._first = begin
            self._measure(begin, last, ceiling)
            self._last = last
        elif older > 0:
            begin = max(first, self._first - AT_ONCE)
            self._measure(begin, self._first, ceiling)
            self._first = begin
        begin, end = max(first, self._first), min(last, self._last)
        return KnownFormants(begin, self._formants[np.arange(begin, max(begin, end)) % CAPACITY])

    def forget(self, column: int = 0) -> None:
        """Measure the columns of the history from this one on anew."""
        time = column * FRAME_PERIOD
        self._known = OrderedDict((key, of) for key, of in self._known.items() if key.span.end <= time)
        self._last = max(0, min(self._last, column))
        self._first = min(self._first, self._last)

    def _measure(self, first: int, last: int, ceiling: float) -> None:
        margin = ceil(WINDOW_SECONDS / FRAME_PERIOD)
        begin = max(0, first - margin)
        samples = self._history.sound_between(begin * HOP, (last + margin) * HOP)
        found = formants_of(samples, first_frame=first - begin, n_frames=last - first, ceiling=ceiling)
        columns = np.arange(first, last)
        there = self._history.columns_with_sound(columns)[:, np.newaxis]
        self._formants[columns % CAPACITY] = np.where(there, found.frequencies, np.float32(np.nan))

    def _tile(self, key: Key) -> Tile:
        known, history, settings = self._known.get(key), self._history, self._of_files.settings
        if known is not None and (known.n == history.n or known.n_final == key.n_columns):
            self._known.move_to_end(key)
            return known.tile
        start, n_final = key.span.start, 0 if known is None else known.n_final
        n_begun = min(key.n_columns, max(0, ceil((history.n * FRAME_PERIOD - start) / key.period - 1e-6)))
        levels: NDArray[np.float16] = np.full((key.n_columns, settings.n_rows), np.nan, np.float16)
        if known is not None:
            levels[:n_final] = known.tile.levels[:n_final]
        if n_begun > n_final:
            new = levels_of(
                _Past(history),
                settings,
                self._of_files.filters,
                start + n_final * key.period,
                key.period,
                n_begun - n_final,
            )
            middles = start + (np.arange(n_final, n_begun) + 0.5) * key.period
            there = history.columns_with_sound(np.minimum((middles / FRAME_PERIOD).astype(np.int64), history.n - 1))
            levels[n_final:n_begun] = np.where(there[:, np.newaxis], new, np.nan)
        known_until = min(history.n * HOP, history.n_samples - settings.n_samples / 2) / SAMPLE_RATE
        n_known = min(key.n_columns, max(n_final, floor((known_until - start) / key.period)))
        tile = Tile(key.span, levels)
        self._known[key] = _Known(tile, history.n, n_known)
        self._known.move_to_end(key)
        return tile
