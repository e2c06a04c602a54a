"""Pitch-synchronous overlap-add: sounds are cut into grains at pitch marks, and put together again.

A grain reaches from the mark before it to the mark after it, and fades in and out along half cosines. Placed at other
distances, grains change the pitch; left out or repeated, the duration; taken from two sounds around a join, they
cross-fade these in phase. E. Moulines, F. Charpentier, Pitch-synchronous waveform processing techniques for
text-to-speech synthesis using diphones, Speech Communication 9 (1990).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, IndexArray
from phonemeengine.settings import HOP, SAMPLE_RATE

UNVOICED = 220
"""Samples between marks where there is no pitch: 5 ms."""
FADE = 0.012 * SAMPLE_RATE
"""Samples before and after a join over which both sounds are mixed, as far as they are so long."""
EDGE = 220
"""Samples over which the whole begins and ends."""
NARROW, WIDE = 0.8, 1.25
"""A period's length beside that of the frame's pitch."""
LEAST_COVER = 0.1
"""Where grains hardly reach, at both ends, they are not amplified beyond that."""


@dataclass(frozen=True, eq=False)
class SoundPiece:
    """A part of a sound that is to be joined with others.

    Attributes
    ----------
    samples : float32, shape (n,), with some sound before and after the part.
    marks : numbers of the samples at which grains are centred, in order; see `pitch_marks`.
    start, end : the part, samples.
    stretch : how long it shall be, as a multiple.
    pitch : the factors of its pitch at its start and its end.
    gain : those of its amplitude.
    """

    samples: Float32Array
    marks: IndexArray
    start: float
    end: float
    stretch: float = 1.0
    pitch: tuple[float, float] = (1.0, 1.0)
    gain: tuple[float, float] = (1.0, 1.0)

    @property
    def length(self) -> float:
        """Samples that it shall last."""
        return (self.end - self.start) * self.stretch


def pitch_marks(samples: Float32Array, pitches: Float32Array) -> IndexArray:
    """Return the samples at which grains are centred: one a period, at equal phases, or every 5 ms without pitch.

    Parameters
    ----------
    samples : float32, shape (n,), at 44.1 kHz.
    pitches : float32, shape (n_frames,), Hz for each 10 ms; 0 where there is none.
    """
    marks, at, voiced = [0], 0, False
    while at < len(samples) - 1:
        pitch = float(pitches[min(at // HOP, len(pitches) - 1)]) if len(pitches) else 0.0
        if not pitch:
            at, voiced = at + UNVOICED, False
        elif voiced:
            at += _lag(samples, at, samples, at, SAMPLE_RATE / pitch, NARROW, WIDE)
        else:
            period = round(SAMPLE_RATE / pitch)
            first = at + round(NARROW * period)
            at = first + (int(samples[first : first + period].argmax()) if first < len(samples) else 0)
            voiced = True
        marks.append(at)
    return np.array([mark for mark in marks if mark < len(samples)])


def joined_pieces(pieces: Sequence[SoundPiece]) -> Float32Array:
    """Return pieces as one sound, float32, as long as they shall be; its ends fade in and out within 5 ms."""
    pieces = _in_phase(pieces)
    borders = np.cumsum([0.0, *(piece.length for piece in pieces)])
    fades = [min(FADE, a.length / 2, b.length / 2) for a, b in pairwise(pieces)]
    n = round(float(borders[-1]))
    sound, cover = np.zeros(n), np.zeros(n)
    at, k = float(pieces[0].marks[_nearest(pieces[0], pieces[0].start)] - pieces[0].start), 0
    while at < n + UNVOICED and pieces:
        while k + 1 < len(pieces) and at >= borders[k + 1] + fades[k]:
            k += 1
        shares = [(k, 1.0)]
        if k + 1 < len(pieces) and at > borders[k + 1] - fades[k]:
            share = 0.5 - 0.5 * float(np.cos(np.pi * (at - borders[k + 1] + fades[k]) / (2 * fades[k])))
            shares = [(k, 1 - share), (k + 1, share)]
        step = 0.0
        for number, share in shares:
            step += share * _place(pieces[number], at, float(borders[number]), share, sound, cover)
        at += step
    sound /= np.maximum(cover, LEAST_COVER)
    edge = np.sin(np.linspace(0, np.pi / 2, min(EDGE, n // 2))) ** 2
    sound[: len(edge)] *= edge
    sound[n - len(edge) :] *= edge[::-1]
    return sound.astype(np.float32)


def _place(
    piece: SoundPiece, at: float, begin: float, share: float, sound: Float64Array, cover: Float64Array
) -> float:
    """Add the grain that belongs at a sample, and return after how many samples the next one follows."""
    source = piece.start + (at - begin) / piece.stretch
    mark = _nearest(piece, source)
    before, centre, after = (int(sample) for sample in piece.marks[mark - 1 : mark + 2])
    window = np.concatenate([_rising(centre - before), _rising(after - centre)[::-1]]) * share
    way = min(max((source - piece.start) / max(piece.end - piece.start, 1.0), 0.0), 1.0)
    gain = piece.gain[0] ** (1 - way) * piece.gain[1] ** way
    first = round(at) - (centre - before)
    skipped, last = max(-first, 0), min(first + len(window), len(sound))
    if last > first + skipped:
        inside = slice(skipped, last - first)
        sound[first + skipped : last] += gain * window[inside] * piece.samples[before:after][inside]
        cover[first + skipped : last] += window[inside]
    factor: float = piece.pitch[0] ** (1 - way) * piece.pitch[1] ** way
    return (after - centre) / factor


def _rising(n: int) -> Float64Array:
    window: Float64Array = 0.5 - 0.5 * np.cos(np.pi * np.arange(n) / n)
    return window


def _nearest(piece: SoundPiece, sample: float) -> int:
    """Return the number of the mark nearest to a sample that has a mark on either side."""
    k = int(np.searchsorted(piece.marks, sample))
    k -= k > 0 and (k == len(piece.marks) or sample - piece.marks[k - 1] < piece.marks[k] - sample)
    return min(max(k, 1), len(piece.marks) - 2)


def _in_phase(pieces: Sequence[SoundPiece]) -> list[SoundPiece]:
    """Return pieces with the marks of each moved to where its sound is the most like that of the one before it."""
    found = [*pieces[:1]]
    for piece in pieces[1:]:
        own, before = _nearest(piece, piece.start), _nearest(found[-1], found[-1].end)
        here, there = int(piece.marks[own]), int(found[-1].marks[before])
        period = int(min(piece.marks[own + 1] - here, found[-1].marks[before + 1] - there))
        moved = piece.marks + _lag(found[-1].samples, there, piece.samples, here, period, -0.5, 0.5)
        found.append(replace(piece, marks=moved[(moved >= 0) & (moved < len(piece.samples))]))
    return found


def _lag(one: Float32Array, at: int, other: Float32Array, there: int, period: float, low: float, high: float) -> int:
    """Return by how many samples the other sound is the most like the one, low..high periods after a sample."""
    half, first, last = round(period / 2), round(low * period), round(high * period)
    begin, end = there + first - half, there + last + half
    pattern = one[max(at - half, 0) : at + half]
    if at < half or begin < 0 or end > len(other) or len(pattern) < 2 * half:
        return max(round(period), 1) if low > 0 else 0
    seen = other[begin:end].astype(np.float64)
    energies = np.convolve(seen**2, np.ones(2 * half), "valid")
    likeness = np.correlate(seen, pattern, "valid") / np.sqrt(np.maximum(energies, 1e-9))
    return first + int(likeness[: last - first + 1].argmax())
