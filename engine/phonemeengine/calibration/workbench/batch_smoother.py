"""The statistics step over whole recordings at once, for what must be new while a threshold is dragged.

It says exactly what `Statistics` says frame by frame. For each change of phoneme it is known beforehand where the
next one is, so it leaps from change to change.
"""

from collections.abc import Mapping

import numpy as np

from phonemeengine.arrays import BoolArray, IndexArray, Int64Array, UInt8Array
from phonemeengine.calibration.scores.scoring import N_CODES, SCORED_PHONEMES
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

# Count the table of successors: what a frame truly is where the rules say nothing, after each phoneme.

PRIOR = 50
"""The table begins as if this many frames had been seen after each phoneme, spread as all unidentified frames are; so
a phoneme after which few were seen gets what is likeliest after any."""


def last_identified(answers: UInt8Array, first: BoolArray) -> UInt8Array:
    """Return for each frame the newest phoneme that the rules named, itself included.

    Parameters
    ----------
    answers : codes of `Phoneme`, shape (n_frames,), with unidentified frames.
    first : bool, shape (n_frames,): where a recording begins; before it was silence.
    """
    named = answers != Phoneme.UNIDENTIFIED
    settled = named | first
    settled[:1] = True
    places = np.flatnonzero(settled)
    newest = np.where(named[places], answers[places], np.uint8(Phoneme.SILENCE))
    return np.repeat(newest, np.diff(places, append=len(answers)))


def counted_table(last: UInt8Array, truth: Int64Array, totals: Int64Array) -> UInt8Array:
    """Choose for each phoneme the successor that finds the largest share of its own class's frames.

    A share of the class, not a count of frames, since a macro F1 weighs all classes alike.

    Parameters
    ----------
    last : the last identified phoneme before each unidentified frame, shape (n_unidentified,).
    truth : the labels of these frames.
    totals : how many frames of each class there are at all, shape (11,).
    """
    counts = np.bincount(last * np.int64(N_CODES) + truth, minlength=N_CODES**2).reshape(N_CODES, N_CODES)
    anywhere = counts.sum(axis=0) + 1e-3 * totals
    seen = counts + PRIOR * anywhere / max(anywhere.sum(), 1e-9)
    shares = np.where(np.isin(np.arange(N_CODES), SCORED_PHONEMES), seen / np.maximum(totals, 1), -1)
    table: UInt8Array = shares.argmax(axis=1).astype(np.uint8)
    return table


def successors_of(table: UInt8Array) -> dict[Phoneme, Phoneme]:
    """Write a table as presets have it."""
    return {Phoneme(p): Phoneme(q) for p, q in enumerate(table.tolist())}


STRETCH = 64
"""Frames that are leaped through at once."""


class BatchSmoother:
    """Calms the phonemes of recordings that follow one another; nothing is remembered from one to the next.

    Parameters
    ----------
    edges : shape (n_recordings + 1,): the first frame of each recording, and the number of all frames.
    """

    def __init__(self, edges: IndexArray) -> None:
        not_empty = edges[1:] > edges[:-1]
        self._n = int(edges[-1])
        self._firsts, self._ends = edges[:-1][not_empty], edges[1:][not_empty]
        self._first = np.zeros(self._n, bool)
        self._first[self._firsts] = True

    def hysteresis(self, codes: UInt8Array, may_stay: BoolArray) -> UInt8Array:
        """Let each phoneme stay while it may.

        Parameters
        ----------
        codes : of `Phoneme`, shape (n_frames,).
        may_stay : where a phoneme falls short by no more than the hysteresis, shape (n_phonemes, n_frames).
        """
        starts, ends = self._runs_of(codes)
        named = codes[starts]
        following = np.empty(len(starts), np.intp)
        for phoneme in Phoneme:
            own = named == phoneme
            following[own] = self._leaving(may_stay[phoneme], ends[own])
        begun = self._leaving(may_stay[Phoneme.SILENCE], self._firsts)
        return self._drawn(codes, begun, np.repeat(following, ends - starts))

    def fill_unidentified(self, codes: UInt8Array, successors: Mapping[Phoneme, Phoneme]) -> UInt8Array:
        """Replace what is unidentified by the successor of what was identified last."""
        table = np.array([successors.get(p, p) for p in Phoneme], np.uint8)
        unidentified = np.flatnonzero(codes == Phoneme.UNIDENTIFIED)
        filled = codes.copy()
        filled[unidentified] = table[last_identified(codes, self._first)[unidentified]]
        return filled

    def minimum_hold(self, codes: UInt8Array, minimum_hold: float) -> UInt8Array:
        """Let each phoneme stay at least this many seconds before another follows."""
        least = max(1, round(minimum_hold / FRAME_PERIOD))
        if least == 1 or not self._n:
            return codes
        starts, ends = self._runs_of(codes)
        run_ends = np.repeat(ends, ends - starts)
        # a phoneme that comes at k may be followed from k + least on, by another one
        n_followed = max(0, self._n - least)
        again = codes[least:] == codes[:n_followed]
        following = np.full(self._n, self._n, np.intp)
        following[:n_followed] = np.where(again, run_ends[least:], np.arange(n_followed) + least)
        silent = codes[self._firsts] == Phoneme.SILENCE
        return self._drawn(codes, np.where(silent, run_ends[self._firsts], self._firsts), following)

    def _runs_of(self, codes: UInt8Array) -> tuple[IndexArray, IndexArray]:
        """Return where runs of equal codes start and end; none goes beyond its recording."""
        changes = self._first.copy()
        changes[1:] |= codes[1:] != codes[:-1]
        starts = np.flatnonzero(changes)
        return starts, np.append(starts[1:], self._n)

    def _leaving(self, may_stay: BoolArray, frames: IndexArray) -> IndexArray:
        """Return for each frame the first one from it on, in which a phoneme must give way to what is named there.

        While it is named itself it is replaced by none, so it matters only where its run has ended.
        """
        leaves = np.zeros(self._n + 1, bool)
        leaves[:-1] = ~may_stay
        leaves[-1] = True
        begins = np.flatnonzero(leaves[1:] & ~leaves[:-1]) + 1
        later = np.append(begins, self._n)[np.searchsorted(begins, frames)]
        return np.where(leaves[frames], frames, later)

    def _drawn(self, codes: UInt8Array, begun: IndexArray, following: IndexArray) -> UInt8Array:
        """Let each recording begin with silence, and take the code of every frame in which the phoneme changes.

        Parameters
        ----------
        codes : what is taken, shape (n_frames,).
        begun : where each recording's first change is.
        following : where the next change is, if there was one in this frame, shape (n_frames,).
        """
        changed = _leapt(begun, self._ends, following)
        places = np.flatnonzero(changed | self._first)
        shown = np.where(changed[places], codes[places], np.uint8(Phoneme.SILENCE))
        return np.repeat(shown, np.diff(places, append=self._n))


def _leapt(begun: IndexArray, ends: IndexArray, following: IndexArray) -> BoolArray:
    """Return where the changes of all recordings are, shape (n_frames,).

    Leaps that begin at different frames soon meet. So from the start of each run all leaps are made at once, and
    then only those one by one that lead from one run into the leaps of the next.
    """
    n = len(following)
    met, left = _leapt_through(following)
    joined = np.full(len(left), n, np.intp)  # from where on a run's leaps count
    changes = []
    is_met, next_one, next_stretch = met.data, following.data, left.data
    for place, end in zip(begun.tolist(), ends.tolist(), strict=True):
        while place < end:
            stretch = place // STRETCH
            if is_met[place] and (stretch + 1) * STRETCH <= end:
                joined[stretch] = place
                place = next_stretch[stretch]  # noqa: PLW2901 - it leaps
            else:
                changes.append(place)
                place = next_one[place]  # noqa: PLW2901
    met &= np.arange(n) >= np.repeat(joined, STRETCH)[:n]
    met[changes] = True
    return met


def _leapt_through(following: IndexArray) -> tuple[BoolArray, IndexArray]:
    """Leap through every run from its first frame; return the frames that are met, and where each is left."""
    n = len(following)
    places = np.arange(0, n, STRETCH)
    ends = np.minimum(places + STRETCH, n)
    met = np.zeros(n, bool)
    inside = np.arange(len(places))
    while len(inside):
        here = places[inside]
        met[here] = True
        there = following[here]
        places[inside] = there
        inside = inside[there < ends[inside]]
    return met, places
