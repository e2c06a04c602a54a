"""What was found in the sound so far: the last minute, extremes since Clear, the averaged spectrum, and why."""

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.session.curves import RunningAverage
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.analyser import Analysis, analyse_range
from phonemeengine.arrays import BoolArray, Float32Array, IndexArray
from phonemeengine.audio.files import SoundReader
from phonemeengine.dsp.framing import LEAD
from phonemeengine.errors import EngineError
from phonemeengine.execution import Progress
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import NO_PHONEME
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import Trace
from phonemeengine.recognition.segments import count_changes
from phonemeengine.settings import FRAME_PERIOD, HOP, WINDOW, Channel

CAPACITY = 6000
"""Columns that are remembered: one minute."""
GAP = 10
"""Empty columns where the sound does not go on: after a seek, a loop or a loss."""
NOWHERE = -10
"""The frame of an empty column; none follows it."""


class History:
    """The last minute, frame by frame, and the extremes of every variable since Clear.

    Column c (counted from Clear) lies at index ``c % CAPACITY`` of the arrays. Where a frame does not follow the one
    before it, `GAP` empty columns lie between the two.

    The extremes are those of all frames since Clear, however long ago, each as it was measured last;
    frames that are only shown, as after a seek, do not count.

    Attributes
    ----------
    n : columns since Clear.
    samples : float32, shape (CAPACITY, 441): the sound of the columns, before all filters.
    frames : int64, shape (CAPACITY,): the column's frame in the file, or `NOWHERE`.
    phonemes, recognised : uint8, shape (CAPACITY,): with and without the statistics; `NO_PHONEME` in empty columns.
    intensities : float32, shape (CAPACITY,).
    """

    def __init__(self) -> None:
        self.n = 0
        self.samples = np.zeros((CAPACITY, HOP), np.float32)
        self.frames = np.full(CAPACITY, NOWHERE, np.int64)
        self.phonemes = np.full(CAPACITY, NO_PHONEME, np.uint8)
        self.recognised = np.full(CAPACITY, NO_PHONEME, np.uint8)
        self.intensities = np.zeros(CAPACITY, np.float32)
        self.newest: Analysis | None = None
        self._heard = np.zeros(CAPACITY, bool)
        self._oldest = 0  # column that is still remembered
        self._names: tuple[str, ...] = ()
        self._values = np.full((CAPACITY, 0), np.nan, np.float32)
        self._forget_extremes()

    def clear(self) -> None:
        """Forget everything."""
        self.n = self._oldest = 0
        self._heard[:] = False
        self.newest = None
        self._forget_extremes()

    def take_back_unheard(self) -> int:
        """Forget the newest columns that were not played, and the gap before them; return how many are left."""
        heard = np.flatnonzero(self._heard[self.indices(0, self.n)])
        self.n = self._oldest + (int(heard[-1]) + 1 if len(heard) else 0)
        self.newest = None
        return self.n

    def newest_run(self, most: int) -> tuple[int, int]:
        """Return the frames first..last-1 of the file that the newest columns hold in a row, `most` at the most."""
        if self.n == 0:
            return 0, 0
        frames = self.frames[self.indices(self.n - most, self.n)]
        breaks = np.flatnonzero(np.diff(frames) != 1)
        return int(frames[breaks[-1] + 1 if len(breaks) else 0]), int(frames[-1]) + 1

    def indices_of(self, first: int, last: int) -> IndexArray:
        """Return where the frames first..last-1 of the file are, of those still remembered; of each the newest."""
        at = self.indices(0, self.n)[::-1]
        frames, places = np.unique(self.frames[at], return_index=True)
        return at[places[(frames >= first) & (frames < last)]]

    def append(self, analysis: Analysis, *, heard: bool = True) -> None:
        """Take in a block of frames, at most CAPACITY - GAP; after a gap, where it does not follow the newest."""
        if self.n and analysis.start != self.frames[(self.n - 1) % CAPACITY] + 1:
            self._leave_gap()
        at = self._room_for(len(analysis))
        self._write(at, analysis)
        self._heard[at] = heard
        self.newest = analysis

    def rewrite(self, column: int, analysis: Analysis) -> None:
        """Write frames anew that are in the history already, from a column on."""
        self._write(np.arange(column, column + len(analysis)) % CAPACITY, analysis)
        if column + len(analysis) == self.n and self.newest is not None:
            self.newest = analysis

    @property
    def names(self) -> tuple[str, ...]:
        """The measured variables."""
        return self._names

    def indices(self, first: int, last: int) -> IndexArray:
        """Return the indices of columns first..last-1, as far as they are still remembered."""
        first = max(first, self._oldest)
        return np.arange(first, max(first, min(last, self.n))) % CAPACITY

    def columns_with_sound(self, columns: IndexArray) -> BoolArray:
        """Return which columns hold a frame that is still remembered, shape (n,)."""
        known = (columns >= self._oldest) & (columns < self.n)
        return np.asarray(known & (self.frames[columns % CAPACITY] != NOWHERE))

    def sound_between(self, first: int, last: int) -> Float32Array:
        """Return samples first..last-1, counted from Clear: silence in gaps, and beyond what is known.

        That reaches beyond the newest column, as far as the window of its frame does.
        """
        begin, end = first // HOP, -(-last // HOP)
        sound = np.zeros(((end - begin), HOP), np.float32)
        known = np.arange(max(begin, self._oldest), max(begin, self._oldest, min(end, self.n)))
        sound[known - begin] = self.samples[known % CAPACITY]
        found = sound.ravel()[first - begin * HOP : last - begin * HOP]
        if self.newest is not None and len(self.newest) and last > self.n * HOP:
            ahead = self.newest.frames.windows[-1][LEAD + HOP :]
            at = self.n * HOP - first
            if at >= 0:
                found[at : at + len(ahead)] = ahead[: max(0, len(found) - at)]
        return found

    @property
    def n_samples(self) -> int:
        """Samples that are known, counted from Clear."""
        has_more = self.newest is not None and len(self.newest) > 0
        return self.n * HOP + (WINDOW - LEAD - HOP if has_more else 0)

    def features(self, indices: IndexArray) -> Features:
        """Return the variables at these indices; NaN where one was not measured."""
        return Features(self._names, self._values[indices])

    def extremes(self, name: str) -> tuple[float, float, float] | None:
        """Return maximum, mean and minimum of a variable since Clear, or None before the first frame."""
        if not self.n_measured(name):
            return None
        n, total, highest, lowest = self._extremes_of(self._names.index(name))
        return highest, total / n, lowest

    def n_measured(self, name: str) -> int:
        """Return over how many frames the extremes of a variable are taken."""
        return self._extremes_of(self._names.index(name))[0] if name in self._names else 0

    def phoneme_lasted(self) -> float:
        """Return how long the newest phoneme has been shown, seconds; at most what is remembered."""
        codes = self.phonemes[self.indices(0, self.n)]
        others = np.flatnonzero(codes != codes[-1:])
        return (len(codes) - 1 - int(others[-1]) if len(others) else len(codes)) * FRAME_PERIOD

    def changes_per_s(self, seconds: float) -> float | None:
        """Return how often the phoneme changed in a second, over the newest seconds; None before there are any."""
        codes = self.phonemes[self.indices(self.n - round(seconds / FRAME_PERIOD), self.n)]
        codes = codes[codes != NO_PHONEME]
        if len(codes) < 2:
            return None
        return count_changes(codes) / (len(codes) * FRAME_PERIOD)

    def _room_for(self, n: int) -> IndexArray:
        """Make the next `n` columns, and give their indices; what they push out is counted before."""
        at = np.arange(self.n, self.n + n) % CAPACITY
        self.n += n
        oldest = max(self._oldest, self.n - CAPACITY)
        self._count_out(np.arange(self._oldest, oldest) % CAPACITY)
        self._oldest = oldest
        return at

    def _leave_gap(self) -> None:
        at = self._room_for(GAP)
        self.samples[at] = 0
        self.frames[at] = NOWHERE
        self.phonemes[at] = self.recognised[at] = NO_PHONEME
        self.intensities[at] = 0
        self._values[at] = np.nan
        self._heard[at] = False

    def _write(self, at: IndexArray, analysis: Analysis) -> None:
        if analysis.features.names != self._names:
            self._rename(analysis.features.names)
        self.samples[at] = analysis.frames.windows[:, LEAD : LEAD + HOP]
        self.frames[at] = analysis.start + np.arange(len(analysis))
        self.phonemes[at] = analysis.phonemes
        self.recognised[at] = analysis.recognised
        self.intensities[at] = analysis.intensities
        self._values[at] = analysis.features.values

    def _rename(self, names: tuple[str, ...]) -> None:
        """Take up other variables; those that stay keep their values and extremes."""
        before = self._measured
        stayed = [(names.index(name), k) for k, name in enumerate(self._names) if name in names]
        self._names, self._values = names, np.full((CAPACITY, len(names)), np.nan, np.float32)
        self._forget_extremes()
        for old, new in zip(before, self._measured, strict=True):
            for k_new, k_old in stayed:
                new[..., k_new] = old[..., k_old]

    # -- extremes: those of the columns that are forgotten, and those of the columns that are remembered -----

    @property
    def _measured(self) -> tuple[NDArray[Any], ...]:
        """Everything whose last axis is the variable."""
        return self._values, self._n_out, self._sum_out, self._highest_out, self._lowest_out

    def _forget_extremes(self) -> None:
        n = len(self._names)
        self._n_out = np.zeros(n, np.int64)
        self._sum_out = np.zeros(n)
        self._highest_out = np.full(n, -np.inf)
        self._lowest_out = np.full(n, np.inf)

    def _count_out(self, at: IndexArray) -> None:
        values = self._values[at[self._heard[at]]]
        if len(values):
            self._n_out += np.count_nonzero(~np.isnan(values), axis=0)
            self._sum_out += np.nansum(values, axis=0, dtype=float)
            np.fmax(self._highest_out, np.fmax.reduce(values), out=self._highest_out)
            np.fmin(self._lowest_out, np.fmin.reduce(values), out=self._lowest_out)

    def _extremes_of(self, k: int) -> tuple[int, float, float, float]:
        """Return number, sum, maximum and minimum of the values of a variable, those that are forgotten included."""
        values = self._values[:, k][self._heard]
        values = values[~np.isnan(values)]
        return (
            int(self._n_out[k]) + len(values),
            float(self._sum_out[k] + values.sum(dtype=float)),
            float(values.max(initial=self._highest_out[k])),
            float(values.min(initial=self._lowest_out[k])),
        )


AGAIN = 1000
"""Frames that are analysed anew at most when the preset changes while nothing plays: ten seconds."""


class AnalysisResults(QObject):
    """Gathers analyses.

    Signals
    -------
    cleared : everything was forgotten.
    rewritten : the columns of the history from this one on are others now.
    error : a sentence for the user.
    """

    cleared = Signal()
    rewritten = Signal(int)
    error = Signal(str)

    def __init__(self, preset: PresetModel) -> None:
        super().__init__()
        self.history = History()
        self.averages = RunningAverage()
        self._preset = preset
        self._work = TaskQueue(self.error.emit)
        self._work.idle.connect(self._begin_wanted)
        self._wanted: Callable[[], None] | None = None
        self._unexplained: Preset | None = None  # its recogniser could not say why, which was told

    def add(self, analysis: Analysis) -> None:
        """Take in a block of analysed frames."""
        self.history.append(analysis)
        self.averages.add(analysis)

    @property
    def busy(self) -> bool:
        """Whether what was played last is being analysed anew."""
        return self._work.busy

    def clear(self, cause: str, sound: str) -> None:
        """Forget everything, since another sound begins, or the user asked for it; see `RunningAverage.begin`."""
        self.averages.begin(cause, sound)
        self._wanted = None
        self._work.cancel()
        self.history.clear()
        self.cleared.emit()

    def add_file_start(self, path: Path, channel: Channel, n_frames: int) -> None:
        """Gather the first frames of a file."""
        for analysis in _analyses(path, channel, (0, n_frames), self._preset.in_force):
            self.add(analysis)

    def analyse_again(self, path: Path, channel: Channel) -> None:
        """Analyse what was played last of a file anew with the preset in force, in the background.

        While that lasts, a newer preset waits, so that something is shown while a slider moves on.
        """
        self._wanted = partial(self._begin_again, path, channel)
        if not self._work.busy:
            self._begin_wanted()

    def _begin_wanted(self) -> None:
        if self._wanted is not None:
            self._wanted()

    def _begin_again(self, path: Path, channel: Channel) -> None:
        self._wanted = None
        preset, n, run = self._preset.in_force, self.history.n, self.history.newest_run(AGAIN)

        def analyse(_progress: Progress) -> list[Analysis]:
            return [*_analyses(path, channel, run, preset)]

        def show(found: list[Analysis]) -> None:
            if (self.history.n, self.history.newest_run(AGAIN)) == (n, run):  # else the sound has gone on
                column = n - (run[1] - run[0])
                for analysis in found:
                    self.history.rewrite(column, analysis)
                    column += len(analysis)
                self.rewritten.emit(n - (run[1] - run[0]))

        if run[0] < run[1]:
            self._work.submit(analyse, show)

    def close(self) -> None:
        """End all work."""
        self._wanted = None
        self._work.close(CLOSE_TIMEOUT)

    def show_before(self, path: Path, channel: Channel, seconds: float) -> None:
        """Show the seconds of a file before a time after what was played, from which a gap parts them.

        They are not played, so they do not count, and they give way to those before the next place that is sought.
        """
        column, last = self.history.take_back_unheard(), round(seconds / FRAME_PERIOD)
        for analysis in self._told_analyses(path, channel, max(0, last - AGAIN), last):
            self.history.append(analysis, heard=False)
        self.rewritten.emit(column)

    def explain(self) -> Trace | None:
        """Return why the newest frame was recognised as it was."""
        newest = self.history.newest
        if newest is None:
            return None
        try:
            return self._preset.recogniser.explain(newest.features, len(newest) - 1)
        except EngineError as error:
            if self._preset.preset is not self._unexplained:
                self._unexplained = self._preset.preset
                self.error.emit(str(error))
            return None

    def _told_analyses(self, path: Path, channel: Channel, first: int, last: int) -> Iterator[Analysis]:
        """Analyse frames that are not played; a damaged file is reported."""
        try:
            yield from _analyses(path, channel, (first, last), self._preset.in_force)
        except EngineError as error:
            self.error.emit(str(error))


def _analyses(path: Path, channel: Channel, run: tuple[int, int], preset: Preset) -> Iterator[Analysis]:
    """Analyse the frames of a file from one to before another."""
    with SoundReader(path, channel) as reader:
        yield from analyse_range(reader, *run, preset, pitch=True)
