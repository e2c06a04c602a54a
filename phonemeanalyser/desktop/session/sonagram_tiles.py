"""The sonagram as tiles of several scales: of what is in view of a file, and of the last minute of live sound."""

import math
import threading
import time
from collections import OrderedDict
from collections.abc import Iterator
from math import ceil, floor, log2
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt, QTimer, Signal
from typing_extensions import override

from phonemeanalyser.desktop.session.results import CAPACITY, History
from phonemeanalyser.desktop.session.seen_tracks import MOST_SECONDS, KnownFormants, SeenTrack
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.arrays import Float32Array, IndexArray
from phonemeengine.dsp.formants import WINDOW_SECONDS, formants_of
from phonemeengine.dsp.sonagram import LEVELS, SonagramSettings, sonagram_of
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.features.front_end import filtered_sonagram_of
from phonemeengine.presets.preset import PRE_ROLL
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE, WINDOW, AnalysisSettings

FINEST = 0.001
"""Seconds of a column at the finest scale; each further one is twice as coarse."""
COLUMNS = 512
"""Of a tile."""
USUAL_COLOURS = "viridis"
MOST_READ = 20.0
"""Seconds of sound that are read at a time."""
EXCERPT, LONG_COLUMN = 0.08, 0.25
"""Seconds that are measured first of a column of that many seconds or more: of hours, a picture is there at once."""
MOST_EXCERPTS = 1.0
"""Seconds of the processor that excerpts of a tile may take; in some formats each place is far to seek."""
REST = 1.0
"""Seconds between two beginnings of such work: who scrolls on and on wants each tile for a moment only, sees
coarser ones meanwhile, and leaves the processor to others."""


class Tile(NamedTuple):
    """A part of the sonagram.

    Attributes
    ----------
    span : the seconds of it.
    levels : dB below full scale, float16, shape (512, n_rows).
    """

    span: TimeSpan
    levels: NDArray[np.float16]


class Key(NamedTuple):
    """A tile's scale and number: column k begins at (n_columns number + k) times 2 to the scale milliseconds."""

    scale: int
    number: int
    n_columns: int = COLUMNS

    @property
    def period(self) -> float:
        """Seconds of a column."""
        return float(FINEST * 2**self.scale)

    @property
    def span(self) -> TimeSpan:
        """Seconds of the tile."""
        seconds = self.n_columns * self.period
        return TimeSpan(self.number * seconds, (self.number + 1) * seconds)


def keys_for(seen: TimeSpan, n_pixels: int, duration: float, n_columns: int = COLUMNS) -> list[Key]:
    """Return the tiles that cover some seconds with one column a pixel, or up to two; the middle one first.

    Parameters
    ----------
    seen : the seconds.
    n_pixels : in which they are seen.
    duration : of the sound, seconds.
    n_columns : of a tile.
    """
    if seen.seconds <= 0 or n_pixels <= 0 or duration <= 0:
        return []
    scale = max(0, floor(log2(seen.seconds / n_pixels / FINEST) + 1e-9))
    seconds = n_columns * FINEST * 2**scale
    first, last = floor(max(0.0, seen.start) / seconds), ceil(min(seen.end, duration) / seconds)
    middle = (seen.start + seen.end) / 2
    keys = [Key(scale, number, n_columns) for number in range(first, max(first + 1, last))]
    return sorted(keys, key=lambda key: abs((key.span.start + key.span.end) / 2 - middle))


class Samples(Protocol):
    """What is read of a sound: its samples, one after the other from any place on."""

    def seek(self, sample: int) -> None:
        """Go to a sample."""

    def read_mono(self, n: int) -> Float32Array:
        """Return the next samples, fewer at the end of the sound."""


class SonagramTiles(SeenTrack):
    """Measures what is looked at, and remembers it; how that is measured and drawn goes for live sound, too.

    Attributes
    ----------
    settings : how it is measured.
    filters : through which it is measured; None for the sound itself.
    level_range : the levels, dB, that are drawn darkest and brightest, the same for every sound.
    colour_map : the name of their colours.
    overlays : which of ``formants``, ``pitch`` and ``level`` are its overlays; ``words``: what is said below.
    """

    _kept = Signal()

    most_tiles = 96
    """That are kept, the newest: 25 MB of 256 rows."""

    def __init__(self) -> None:
        super().__init__()
        self.settings = SonagramSettings()
        self.filters: AnalysisSettings | None = None
        self.level_range = LEVELS
        self.colour_map = USUAL_COLOURS
        self.overlays: frozenset[str] = frozenset()
        self._lock = threading.Lock()
        self._generation = 0
        self._tiles: OrderedDict[Key, Tile] = OrderedDict()
        self._of_excerpts: set[Key] = set()
        self._wanted: tuple[Key, ...] = ()
        self._kept.connect(self.changed, Qt.ConnectionType.QueuedConnection)
        self._began = -math.inf
        self._resting = QTimer(self, singleShot=True)
        self._resting.timeout.connect(self._measure)

    @property
    @override
    def busy(self) -> bool:
        return super().busy or self._resting.isActive()

    def use(self, settings: SonagramSettings) -> None:
        """Measure it otherwise."""
        if settings != self.settings:
            self.settings = settings
            self._forget()

    def show_levels(self, low: float, high: float) -> None:
        """Draw other levels darkest and brightest, dB."""
        self.level_range = (low, high)
        self.changed.emit()

    def show_colours(self, name: str) -> None:
        """Draw the levels in other colours."""
        self.colour_map = name
        self.changed.emit()

    def show_over(self, name: str, *, on: bool) -> None:
        """Draw something over the sonagram or below it, or not."""
        self.overlays = self.overlays | {name} if on else self.overlays - {name}
        self.changed.emit()

    def show_filtered(self, filters: AnalysisSettings | None) -> None:
        """Measure what is left after the filters of a recogniser; None for the sound itself."""
        kept = None if self.filters is None else self.filters.front_end()
        if kept != (None if filters is None else filters.front_end()):
            self.filters = filters
            self._forget()

    def tiles_for(self, seen: TimeSpan, n_pixels: int) -> list[Tile]:
        """Return what is known of some seconds that are seen in a number of pixels, coarse tiles first.

        What is missing is measured in the background, and `changed` tells when it is there.
        """
        keys = keys_for(seen, n_pixels, self._duration)
        with self._lock:
            missing = tuple(key for key in keys if key not in self._tiles or key in self._of_excerpts)
            known = {key for wanted in keys for key in self._nearest_known(wanted)}
            for key in known:
                self._tiles.move_to_end(key)
            found = [self._tiles[key] for key in sorted(known, reverse=True)]
        if missing and not set(missing) <= set(self._wanted):
            self._wanted = missing
            rest = self._began + REST - time.monotonic()
            if rest <= 0:
                self._measure()
            elif not self._resting.isActive():
                self._resting.start(round(1000 * rest))
        return found

    def _nearest_known(self, key: Key) -> Iterator[Key]:
        """Give the tile, or the least coarse one that covers it, if any."""
        while key.span.start > 0 or key.span.seconds < 2 * self._duration:
            if key in self._tiles:
                yield key
                return
            key = Key(key.scale + 1, key.number // 2)
        if key in self._tiles:
            yield key

    def _measure(self) -> None:
        """Measure what is wanted now: who scrolls on and on wants each tile for a moment only."""
        open_sound, generation, keys = self._open, self._generation, self._wanted
        settings, filters = self.settings, self.filters
        if open_sound is None:
            return
        self._began = time.monotonic()

        def measure(progress: Progress) -> None:
            with open_sound() as reader:
                for key in keys:
                    if key.period >= LONG_COLUMN and key not in self._tiles:
                        self._keep(
                            key, excerpts_of(reader, settings, filters, key, progress), generation, whole=False
                        )
                for k, key in enumerate(keys):
                    part = subrange(progress, k / len(keys), (k + 1) / len(keys))
                    levels = levels_of(reader, settings, filters, key.span.start, key.period, key.n_columns, part)
                    self._keep(key, levels, generation)
            report_progress(progress, 1.0)

        self._work.replace(measure, lambda _: None)

    def _keep(self, key: Key, levels: Float32Array, generation: int, *, whole: bool = True) -> None:
        """Remember a tile, in the thread that measured it; one that is outdated meanwhile is not wanted."""
        with self._lock:
            if generation != self._generation:
                return
            self._of_excerpts = self._of_excerpts - {key} if whole else self._of_excerpts | {key}
            self._tiles[key] = Tile(key.span, levels.astype(np.float16))
            while len(self._tiles) > self.most_tiles:
                self._tiles.popitem(last=False)
        self._kept.emit()

    @override
    def _forget(self) -> None:
        self._resting.stop()
        self._began = -math.inf
        with self._lock:
            self._generation += 1
            self._tiles, self._of_excerpts = OrderedDict(), set()
        self._wanted = ()
        super()._forget()


def levels_of(
    reader: Samples,
    settings: SonagramSettings,
    filters: AnalysisSettings | None,
    start: float,
    period: float,
    n_columns: int,
    progress: Progress = no_progress,
    most_read: float = MOST_READ,
) -> Float32Array:
    """Return the levels of columns of a sonagram, dB, float32, shape (n_columns, n_rows).

    Parameters
    ----------
    reader : the sound.
    settings : how it is measured.
    filters : through which; None for the sound itself.
    start : seconds at which the first column begins.
    period : seconds of a column.
    n_columns : how many.
    progress : called with the share that is done.
    most_read : seconds of sound that are read at a time.
    """
    n_samples = period * SAMPLE_RATE
    at_once = max(1, int(most_read / period))
    parts = []
    for column in range(0, n_columns, at_once):
        report_progress(progress, column / n_columns)
        n = min(at_once, n_columns - column)
        first = start * SAMPLE_RATE + column * n_samples
        margin = settings.n_samples if filters is None else PRE_ROLL * HOP
        begin = max(0, int((first - margin) // HOP)) * HOP
        reader.seek(begin)
        samples = reader.read_mono(int(first + n * n_samples) + WINDOW - begin)
        if filters is None:
            parts.append(sonagram_of(samples, settings, first - begin, n, n_samples))
        else:
            parts.append(filtered_sonagram_of(samples, filters, settings, first - begin, n, n_samples))
    return np.concatenate(parts)


def excerpts_of(
    reader: Samples, settings: SonagramSettings, filters: AnalysisSettings | None, key: Key, progress: Progress
) -> Float32Array:
    """Return a tile of which only the middle of each column is measured; NaN where that took too long.

    Shape (n_columns, n_rows), see `levels_of`.
    """
    levels = np.full((key.n_columns, settings.n_rows), np.nan, np.float32)
    began = time.thread_time()
    for column in range(key.n_columns):
        if time.thread_time() - began > MOST_EXCERPTS:
            break
        report_progress(progress, 0.0)
        start = key.span.start + (column + 0.5) * key.period - EXCERPT / 2
        levels[column] = levels_of(reader, settings, filters, start, EXCERPT, 1)[0]
    return levels


LIVE_COLUMNS = 128
"""Of a tile: few, since the newest one is coloured anew with every picture."""
MOST_LIVE_TILES = 64
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
        keys = keys_for(seen, n_pixels, self._history.n * FRAME_PERIOD, LIVE_COLUMNS)
        tiles = [self._tile(key) for key in keys]
        while len(self._known) > max(MOST_LIVE_TILES, len(keys)):
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
