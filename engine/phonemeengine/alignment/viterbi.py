"""The cheapest way of a sound through a lattice (A. Viterbi, 1967), a few frames at a time.

Where every sound lasts at least d frames, nothing of the last d - 1 frames matters to the next ones, so d frames are
worked out at once. What a way costs is the sum over its frames of how far they fall short of the best that anybody
could say there (natural logarithms), and the prices of what does not fit.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from phonemeengine.arrays import Float64Array, IndexArray, UInt8Array

# The ways through a text: its sounds in order, with all places where a pause, another word or nothing may be.

Spellings = Sequence[Sequence[int]]
"""The pronunciations of a word, at least one, each the columns of its sounds in a table of scores, at least one."""

NOWHERE = -1


@dataclass(frozen=True, eq=False)
class Lattice:
    """Sounds that lead from junction to junction; word w lies between the junctions w and w + 1.

    Junctions within words have the numbers from `n_words` + 1.

    Attributes
    ----------
    n_words : how many words there are.
    columns : where the scores of each sound stand, shape (n_sounds,).
    words : to which word each sound belongs, shape (n_sounds,).
    before, after : the junctions between which each sound lies, shape (n_sounds,).
    arrivals : the sounds that lead to each junction, by the pronunciation, shape (n_variants, n_junctions), `NOWHERE`
        where there are fewer; the junctions within words have one, in the first row.
    fewest : sounds of the shortest pronunciation of each word, shape (n_words,).
    """

    n_words: int
    columns: IndexArray
    words: IndexArray
    before: IndexArray
    after: IndexArray
    arrivals: IndexArray
    fewest: IndexArray


def lattice_of(words: Sequence[Spellings]) -> Lattice:
    """Lay out words, each with its pronunciations, in the order of the text."""
    rows: list[tuple[int, int, int, int]] = []
    # Junctions between words come first, so that they are one slice; the two ends of a word are shared by all of its
    # pronunciations, which thus compete.
    n_junctions = len(words) + 1
    variants = []
    for w, spellings in enumerate(words):
        for v, spelling in enumerate(spellings):
            junctions = [w, *range(n_junctions, n_junctions + len(spelling) - 1), w + 1]
            n_junctions += len(spelling) - 1
            rows += zip(spelling, [w] * len(spelling), junctions, junctions[1:], strict=False)
            variants += [*[0] * (len(spelling) - 1), v]
    columns, of_words, before, after = np.array(rows, np.intp).reshape(-1, 4).T.copy()
    arrivals = np.full((max(variants, default=0) + 1, n_junctions), NOWHERE)
    arrivals[variants, after] = np.arange(len(after))
    fewest = np.array([min(len(spelling) for spelling in spellings) for spellings in words])
    return Lattice(len(words), columns, of_words, before, after, arrivals, fewest)


SILENT, STRANGE, SKIPPED = 253, 254, 255
"""Whence a junction is reached, besides the numbers of pronunciations."""


@dataclass(frozen=True)
class Prices:
    """What does not fit the text costs so much; infinity forbids it.

    Attributes
    ----------
    silence : of each pause.
    skip, skip_sound : of a word that is left out, and of each of its sounds.
    strange, strange_frame : costs of a section that the text does not hold, and of each of its frames.
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
    silence, strange : a pause, and a section that the text does not hold.
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
    """All states of a text: its sounds, then a pause at every junction, then what it does not hold between words."""

    def __init__(self, shortfalls: Float64Array, lattice: Lattice, prices: Prices, least: LeastFrames) -> None:
        n, n_sounds, n_junctions = len(shortfalls), len(lattice.columns), lattice.arrivals.shape[1]
        self._n, self._lattice = n, lattice
        self._pauses = slice(n_sounds, n_sounds + n_junctions)
        self._between = slice(lattice.n_words + 1)
        counts = (n_sounds, n_junctions, lattice.n_words + 1)
        # Three kinds of states with one recursion: for the sounds the scores are those of their columns, for a pause
        # those of silence, and what the text does not hold costs the same in every frame, a column of its own.
        self._runs = _Runs(
            np.concatenate([lattice.before, np.arange(n_junctions), np.arange(lattice.n_words + 1)]),
            np.concatenate([least.sounds, np.repeat([least.silence, least.strange], counts[1:])]),
            np.repeat([0.0, prices.silence, prices.strange], counts),
            np.concatenate([lattice.columns, np.repeat([0, shortfalls.shape[1]], counts[1:])]),
            np.column_stack([shortfalls, np.full(n, -prices.strange_frame)]),
        )
        self._variants = [(at := np.flatnonzero(row != NOWHERE), row[at]) for row in lattice.arrivals[1:]]
        # the first arrival of each junction is looked up for all of them at once; others, of further pronunciations,
        # are few
        self._unsaid = lattice.arrivals[0] == NOWHERE
        self._may_skip = np.isfinite(prices.skip)
        # the cost of leaving out all words up to each junction
        self._skips = np.concatenate([[0.0], np.cumsum(prices.skip + prices.skip_sound * lattice.fewest)])
        # reached[t, j]: the best score with which frame t - 1 is the last one before junction j. The search is exact,
        # without a beam: sections are short enough to keep every state.
        self._reached = np.full((n + 1, n_junctions), -np.inf)
        self._whence = np.zeros((n + 1, n_junctions), np.uint8)
        # Every state lasts at least as long as a block, so none that begins in a block ends in it:
        # a block depends only on what is known before it, and its frames are computed together.
        self._block = int(min(*least.sounds, least.silence, least.strange))

    def run(self) -> None:
        self._reached[0, 0] = 0.0
        self._skip(slice(0, 1))
        for first in range(1, self._n + 1, self._block):
            self._advance(slice(first, min(first + self._block, self._n + 1)))

    def _advance(self, frames: slice) -> None:
        ended = self._runs.extend(frames, self._reached)
        reached, whence = self._reached[frames], self._whence[frames]
        # Viterbi's recursion: a junction takes the best of all that may end there, and `whence` remembers which.
        np.take(ended, self._lattice.arrivals[0], axis=1, out=reached, mode="wrap")
        reached[:, self._unsaid] = -np.inf
        for variant, (at, arrivals) in enumerate(self._variants, 1):
            better = ended[:, arrivals] > reached[:, at]
            whence[:, at] = np.where(better, variant, whence[:, at])
            reached[:, at] = np.maximum(reached[:, at], ended[:, arrivals])
        _improve(reached, whence, ended[:, self._pauses], SILENT)
        _improve(reached[:, self._between], whence[:, self._between], ended[:, self._pauses.stop :], STRANGE)
        self._skip(frames)

    def _skip(self, frames: slice) -> None:
        """Let words be left out, however many of them follow each other."""
        if self._may_skip:
            reached = self._reached[frames, self._between]
            # best[j] = max over i <= j of reached[i] - (C[j] - C[i]), C the cost of skipping all words before: one
            # running maximum instead of a loop over every number of skipped words.
            best = np.maximum.accumulate(reached + self._skips, axis=1)
            self._whence[frames, self._between][best > reached + self._skips] = SKIPPED
            np.subtract(best, self._skips, out=reached)

    def way(self, *, whole: bool) -> Way | None:
        end = self._lattice.n_words if whole else int(self._reached[-1].argmax())
        cost = -float(self._reached[-1, end])
        return Way(tuple(reversed([*self._steps_back_from(end)])), cost) if np.isfinite(cost) else None

    def _steps_back_from(self, junction: int) -> Iterator[WayStep]:
        lattice, frame = self._lattice, self._n
        # Backwards from the end: each junction knows how it was reached, and each state when it was entered best.
        while frame or junction:
            whence = int(self._whence[frame, junction])
            if whence == SKIPPED:
                junction -= 1
                yield WayStep(frame, frame, SKIPPED, junction)
                continue
            if whence == SILENT:
                state = self._pauses.start + junction
                step = WayStep(self._runs.begin_of(frame, state), frame, SILENT, NOWHERE)
            elif whence == STRANGE:
                state = self._pauses.stop + junction
                step = WayStep(self._runs.begin_of(frame, state), frame, STRANGE, NOWHERE)
            else:
                sound = int(lattice.arrivals[whence, junction])
                step = WayStep(self._runs.begin_of(frame, sound), frame, SOUND, sound)
                junction = int(lattice.before[sound])
            yield step
            frame = step.first


class _Runs:
    """States that last: how good they are, and when each was entered best, as the frames go by.

    Parameters
    ----------
    at : the junctions from which they are entered, shape (n_states,).
    least : frames that they last at least, shape (n_states,).
    prices : of entering them, shape (n_states,).
    columns : where the scores of each stand, shape (n_states,).
    scores : in each frame, shape (n_frames, n_columns).
    """

    def __init__(
        self, at: IndexArray, least: IndexArray, prices: Float64Array, columns: IndexArray, scores: Float64Array
    ) -> None:
        self._at, self._least = at, least
        # Prefix sums: the score of any run of frames is the difference of two of them.
        sums = np.zeros((len(scores) + 1, scores.shape[1]))
        np.cumsum(scores, axis=0, out=sums[1:])
        begun = np.maximum(np.arange(len(sums))[:, np.newaxis] - least, 0)
        self._sums = sums[:, columns]
        # A run that begins at frame b and ends before t scores reached[b] - price + S[t] - S[b]. Only reached[b] -
        # S[b] - price depends on b, so its running maximum, d frames late (d: the least duration), is all that is to
        # be kept of every possible beginning.
        self._before = sums[begun, columns] + prices
        self._best = np.full(len(at), -np.inf)
        self._entered = np.zeros((len(sums), len(at)), bool)

    def extend(self, frames: slice, reached: Float64Array) -> Float64Array:
        """Return the scores of those that may end with each frame, shape (n_frames, n_states)."""
        # flat indices into `reached`; beginnings before the sound are clipped, and excluded three lines below
        begun = np.arange(frames.start, frames.stop)[:, np.newaxis] - self._least
        found: Float64Array = reached.take(begun * reached.shape[1] + self._at, mode="clip")
        found -= self._before[frames]
        if frames.start < LONGEST_LEAST:
            found[begun < 0] = -np.inf
        # the only step that goes frame by frame: a running maximum that goes on from the last block
        for best, entered in zip(found, self._entered[frames], strict=True):
            np.greater(best, self._best, out=entered)
            self._best = np.maximum(best, self._best, out=best)
        return found + self._sums[frames]

    def begin_of(self, frame: int, state: int) -> int:
        """Return the frame with which a run begins that ends before `frame`."""
        # the newest frame, at the latest this one, in which the running maximum was renewed; the run began d frames
        # before
        back = int(self._entered[frame::-1, state].argmax())
        return frame - back - int(self._least[state])


def _improve(reached: Float64Array, whence: UInt8Array, scores: Float64Array, kind: int) -> None:
    """Let junctions be reached in another way, where that is better."""
    whence[scores > reached] = kind
    np.maximum(reached, scores, out=reached)
