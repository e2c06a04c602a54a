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


class WayStep(NamedTuple):
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

    steps: tuple[WayStep, ...]
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
        self._sounds = _Runs(shortfalls[:, lattice.columns], lattice.before, least.sounds, 0.0)
        self._pauses = _Runs(shortfalls[:, :1], np.arange(n_junctions), np.array([least.silence]), prices.silence)
        self._strays = _Runs(strange, np.arange(lattice.n_words + 1), np.array([least.strange]), prices.strange)
        self._block = int(min(*least.sounds, least.silence, least.strange))

    def run(self) -> None:
        self._reached[0, 0] = 0.0
        self._skip(slice(0, 1))
        for first in range(1, self._n + 1, self._block):
            self._advance(slice(first, min(first + self._block, self._n + 1)))

    def _advance(self, frames: slice) -> None:
        said, paused, strayed = (
            runs.extend(frames, self._reached) for runs in (self._sounds, self._pauses, self._strays)
        )
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

    def _steps_back_from(self, junction: int) -> Iterator[WayStep]:
        lattice, frame = self._lattice, self._n
        while frame or junction:
            whence = int(self._whence[frame, junction])
            if whence == SKIPPED:
                junction -= 1
                yield WayStep(frame, frame, SKIPPED, junction)
                continue
            if whence == SILENT:
                step = WayStep(self._pauses.begin_of(frame, junction), frame, SILENT, NOWHERE)
            elif whence == STRANGE:
                step = WayStep(self._strays.begin_of(frame, junction), frame, STRANGE, NOWHERE)
            else:
                sound = int(lattice.arrivals[whence, junction])
                step = WayStep(self._sounds.begin_of(frame, sound), frame, SOUND, sound)
                junction = int(lattice.before[sound])
            yield step
            frame = step.first


class _Runs:
    """States of one sort that last: how good they are, and when each was entered best, as the frames go by.

    Parameters
    ----------
    scores : in each frame, shape (n_frames, n_states), or (n_frames, 1) where all have the same.
    at : the junctions from which they are entered, shape (n_states,).
    least : frames that they last at least, shape (n_states,), or (1,) where all have the same.
    price : of entering one.
    """

    def __init__(self, scores: Float64Array, at: IndexArray, least: IndexArray, price: float) -> None:
        self._at, self._least = at, least
        self._sums = np.zeros((len(scores) + 1, scores.shape[1]))
        np.cumsum(scores, axis=0, out=self._sums[1:])
        begun = np.maximum(np.arange(len(self._sums))[:, np.newaxis] - least, 0)
        self._before = np.take_along_axis(self._sums, begun, axis=0) + price
        self._best = np.full((1, len(at)), -np.inf)
        self._entered = np.zeros((len(self._sums), len(at)), bool)

    def extend(self, frames: slice, reached: Float64Array) -> Float64Array:
        """Return the scores of those that may end with each frame, shape (n_frames, n_states)."""
        begun = np.arange(frames.start, frames.stop)[:, np.newaxis] - self._least
        best = np.empty((len(begun) + 1, len(self._at)))
        best[:1] = self._best
        np.subtract(
            reached.take(begun * reached.shape[1] + self._at, mode="clip"), self._before[frames], out=best[1:]
        )
        if frames.start < LONGEST_LEAST:
            best[1:][np.broadcast_to(begun < 0, best[1:].shape)] = -np.inf
        np.maximum.accumulate(best, axis=0, out=best)
        np.greater(best[1:], best[:-1], out=self._entered[frames])
        self._best = best[-1:]
        ended: Float64Array = best[1:] + self._sums[frames]
        return ended

    def begin_of(self, frame: int, state: int) -> int:
        """Return the frame with which a run begins that ends before `frame`."""
        back = int(self._entered[frame::-1, state].argmax())
        return frame - back - int(self._least[state % len(self._least)])


def _improve(reached: Float64Array, whence: UInt8Array, scores: Float64Array, kind: int) -> None:
    """Let junctions be reached in another way, where that is better."""
    whence[scores > reached] = kind
    np.maximum(reached, scores, out=reached)
