"""The cheapest way of a sound through a lattice (A. Viterbi, 1967), a few frames at a time.

Where every sound lasts at least d frames, nothing of the last d - 1 frames matters to the next ones, so d frames are
worked out at once. What a way costs is the sum over its frames of how far they fall short of the best that anybody
could say there (natural logarithms), and the prices of what does not fit.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from phonemeengine.alignment.lattice import NOWHERE, Lattice
from phonemeengine.arrays import Float64Array, IndexArray, UInt8Array

SILENT, STRANGE, SKIPPED = 253, 254, 255
"""Whence a junction is reached, besides the numbers of pronunciations."""


@dataclass(frozen=True)
class Prices:
    """What does not fit the text costs so much; infinity forbids it.

    Attributes
    ----------
    silence : of each pause.
    skip, skip_sound : of a word that is left out, and of each of its sounds.
    strange, strange_frame : of a stretch that the text does not hold, and of each of its frames.
    """

    silence: float = 0.0
    skip: float = np.inf
    skip_sound: float = 0.0
    strange: float = np.inf
    strange_frame: float = 0.0


@dataclass(frozen=True)
class LeastFrames:
    """What everything lasts at least, frames.

    Attributes
    ----------
    sounds : for each sound of the lattice, shape (n_sounds,).
    silence, strange : a pause, and a stretch that the text does not hold.
    """

    sounds: IndexArray
    silence: int = 4
    strange: int = 10


class Step(NamedTuple):
    """A piece of a way: frames first..last-1.

    `sound` is the number of a sound of the lattice, or `NOWHERE` for silence and what the text does not hold, where
    `kind` tells them apart; a skipped word has no frames, and `sound` is the word.
    """

    first: int
    last: int
    kind: int
    sound: int


LONGEST_LEAST = 64
"""Frames that anything is asked to last at least are fewer than this."""

SOUND = 0
"""The kind of a step that says a sound of the text."""


@dataclass(frozen=True)
class Way:
    """The cheapest way: its steps in order of time, and its cost."""

    steps: tuple[Step, ...]
    cost: float


def cheapest_way(
    shortfalls: Float64Array, lattice: Lattice, prices: Prices, least: LeastFrames, *, whole: bool = True
) -> Way | None:
    """Return the cheapest way through all frames; None where there is none, since the frames are too few.

    Parameters
    ----------
    shortfalls : by how much each sound falls short of the best score, shape (n_frames, n_columns), 0 or less; the
        first column is that of silence.
    lattice : the text.
    prices, least : what is allowed.
    whole : the way ends with the last word, or its price; otherwise wherever it is cheapest.
    """
    search = _Search(shortfalls, lattice, prices, least)
    search.run()
    return search.way(whole=whole)


class _Search:
    def __init__(self, shortfalls: Float64Array, lattice: Lattice, prices: Prices, least: LeastFrames) -> None:
        n, n_junctions = len(shortfalls), lattice.arrivals.shape[1]
        self._n, self._lattice = n, lattice
        self._between = slice(lattice.n_words + 1)
        self._may_skip = np.isfinite(prices.skip)
        self._skips = np.concatenate([[0.0], np.cumsum(prices.skip + prices.skip_sound * lattice.fewest)])
        self._reached = np.full((n + 1, n_junctions), -np.inf)
        self._whence = np.zeros((n + 1, n_junctions), np.uint8)
        strange = np.full((n, 1), -prices.strange_frame)
        self._runs = _Runs(
            (shortfalls[:, lattice.columns], lattice.before, least.sounds, 0.0),
            (shortfalls[:, :1], np.arange(n_junctions), least.silence, prices.silence),
            (strange, np.arange(lattice.n_words + 1), least.strange, prices.strange),
        )
        self._block = int(self._runs.least.min())

    def run(self) -> None:
        self._reached[0, 0] = 0.0
        self._skip(slice(0, 1))
        for first in range(1, self._n + 1, self._block):
            self._advance(slice(first, min(first + self._block, self._n + 1)))

    def _advance(self, frames: slice) -> None:
        said, paused, strayed = self._runs.extend(frames, self._reached)
        reached, whence = self._reached[frames], self._whence[frames]
        first, *others = self._lattice.arrivals
        np.take(said, first, axis=1, out=reached, mode="wrap")
        reached[:, first == NOWHERE] = -np.inf
        for variant, arrivals in enumerate(others, 1):
            at = np.flatnonzero(arrivals != NOWHERE)
            better = said[:, arrivals[at]] > reached[:, at]
            whence[:, at] = np.where(better, variant, whence[:, at])
            reached[:, at] = np.maximum(reached[:, at], said[:, arrivals[at]])
        _improve(reached, whence, paused, SILENT)
        _improve(reached[:, self._between], whence[:, self._between], strayed, STRANGE)
        self._skip(frames)

    def _skip(self, frames: slice) -> None:
        """Let words be left out, however many of them follow each other."""
        if self._may_skip:
            reached = self._reached[frames, self._between]
            best = np.maximum.accumulate(reached + self._skips, axis=1)
            self._whence[frames, self._between][best > reached + self._skips] = SKIPPED
            np.subtract(best, self._skips, out=reached)

    def way(self, *, whole: bool) -> Way | None:
        end = self._lattice.n_words if whole else int(self._reached[-1].argmax())
        cost = -float(self._reached[-1, end])
        return Way(tuple(reversed([*self._steps_back_from(end)])), cost) if np.isfinite(cost) else None

    def _steps_back_from(self, junction: int) -> Iterator[Step]:
        lattice, frame, n_sounds = self._lattice, self._n, len(self._lattice.columns)
        while frame or junction:
            whence = int(self._whence[frame, junction])
            if whence == SKIPPED:
                junction -= 1
                yield Step(frame, frame, SKIPPED, junction)
                continue
            if whence == SILENT:
                step = Step(self._runs.begin_of(frame, n_sounds + junction), frame, SILENT, NOWHERE)
            elif whence == STRANGE:
                n_before = n_sounds + lattice.arrivals.shape[1]
                step = Step(self._runs.begin_of(frame, n_before + junction), frame, STRANGE, NOWHERE)
            else:
                sound = int(lattice.arrivals[whence, junction])
                step = Step(self._runs.begin_of(frame, sound), frame, SOUND, sound)
                junction = int(lattice.before[sound])
            yield step
            frame = step.first


Part = tuple[Float64Array, IndexArray, IndexArray | int, float]
"""States of one sort: their scores in each frame, shape (n_frames, n_states) or (n_frames, 1), the junctions from
which they are entered, how many frames they last at least, and the price of entering one."""


class _Runs:
    """States that last: how good they are, and when each was entered best, as the frames go by."""

    def __init__(self, *parts: Part) -> None:
        ends = np.cumsum([len(at) for _, at, _, _ in parts]).tolist()
        self._parts = [slice(first, end) for first, end in zip([0, *ends], ends, strict=False)]
        self._at = np.concatenate([at for _, at, _, _ in parts])
        self.least = np.concatenate([np.broadcast_to(least, at.shape) for _, at, least, _ in parts])
        prices = np.concatenate([np.full(len(at), price) for _, at, _, price in parts])
        n = len(parts[0][0])
        self._sums = np.zeros((n + 1, len(self._at)))
        np.cumsum(
            np.concatenate([np.broadcast_to(s, (n, len(at))) for s, at, _, _ in parts], axis=1),
            axis=0,
            out=self._sums[1:],
        )
        begun = np.maximum(np.arange(n + 1)[:, np.newaxis] - self.least, 0)
        self._before = np.take_along_axis(self._sums, begun, axis=0) + prices
        self._best = np.full((1, len(self._at)), -np.inf)
        self._entered = np.zeros(self._sums.shape, bool)

    def extend(self, frames: slice, reached: Float64Array) -> list[Float64Array]:
        """Return, for each part, the scores of those that may end with each frame, shape (n_frames, n_states)."""
        begun = np.arange(frames.start, frames.stop)[:, np.newaxis] - self.least
        entering = reached.take(begun * reached.shape[1] + self._at, mode="clip")
        entering -= self._before[frames]
        if frames.start < LONGEST_LEAST:
            entering[begun < 0] = -np.inf
        best = np.concatenate([self._best, entering])
        np.maximum.accumulate(best, axis=0, out=best)
        np.greater(best[1:], best[:-1], out=self._entered[frames])
        self._best = best[-1:]
        ended = best[1:] + self._sums[frames]
        return [ended[:, part] for part in self._parts]

    def begin_of(self, frame: int, state: int) -> int:
        """Return the frame with which a run begins that ends before `frame`."""
        back = int(self._entered[frame::-1, state].argmax())
        return frame - back - int(self.least[state])


def _improve(reached: Float64Array, whence: UInt8Array, scores: Float64Array, kind: int) -> None:
    """Let junctions be reached in another way, where that is better."""
    whence[scores > reached] = kind
    np.maximum(reached, scores, out=reached)
