"""Halves of phones as numbers: how they are spoken, and what a recorded face shows where they meet."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from weakref import WeakKeyDictionary

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, IndexArray
from phonemeengine.labels.phone_sets import articulations_of, letters_of
from phonemeengine.performance.recording import SILENCE, Performance, PerformedPhone
from phonemeengine.performance.table_file import PerformanceTable

TRAITS = (
    "duration",
    "energy",
    "pitch",
    "stress",
    "word",
    "syllable",
    "lips beside",
    "rounding beside",
    "opening beside",
    "spreading beside",
)
"""What `traits_of` tells of a half: the natural logarithm of its duration; how loud and high its phone is beside the
sentence, in steps of 12 dB and of an octave; whether its syllable bears stress; where its phone stands in word and
syllable, 0 at the first and 1 at the last one; and what the mouth does at the phone beside it, each 0..1."""
SHORTEST = 0.005
"""Seconds; what is shorter counts as so long."""
STEP = 12.0
"""Decibels."""
PITCH_HEARD = 2.0
"""What an octave counts where sounds meet; a step of the level counts 1."""
FARTHEST = 100.0
"""What differs by more counts as so much."""
SPEED = 0.03
"""Seconds of a movement's speed that count as much as its place where two meet."""


def bounds_of(phones: Sequence[PerformedPhone]) -> Float64Array:
    """Return when each half begins, and last when the last one ends, seconds, shape (2 n_phones + 1,)."""
    return np.array([*(time for phone in phones for time in (phone.start, phone.middle)), phones[-1].end])


def traits_of(phones: Sequence[PerformedPhone]) -> Float32Array:
    """Return what is known of each half without a face, float32, shape (2 n_phones, n_traits); see `TRAITS`."""
    spoken = [phone for phone in phones if phone.name != SILENCE]
    mean = float(np.mean([phone.energy for phone in spoken])) if spoken else 0.0
    pitch = float(np.median(voiced)) if (voiced := [phone.pitch for phone in spoken if phone.pitch > 0]) else 1.0
    own = np.array(
        [
            (
                (phone.energy - mean) / STEP if phone.name != SILENCE else 0.0,
                np.log2(phone.pitch / pitch) if phone.pitch > 0 else 0.0,
                float(phone.stress > 0),
            )
            for phone in phones
        ]
    )
    places = np.stack([_places([p.word for p in phones]), _places([p.syllable for p in phones])], axis=1)
    mouths = np.array([_mouth_at(SILENCE), *(_mouth_at(phone.name) for phone in phones), _mouth_at(SILENCE)])
    lasting = np.log(np.maximum(np.diff(bounds_of(phones)), SHORTEST))
    beside = np.stack([mouths[:-2], mouths[2:]], axis=1).reshape(2 * len(phones), -1)
    phone_traits = np.repeat(np.hstack([own, places]), 2, axis=0)
    traits: Float32Array = np.hstack([lasting[:, None], phone_traits, beside]).clip(-FARTHEST, FARTHEST)
    return traits.astype(np.float32)


@dataclass(frozen=True, eq=False)
class RecordedHalves:
    """The halves of a recording.

    Attributes
    ----------
    name : of the recording.
    rate : frames a second.
    weights : float32, shape (n_frames, n_channels), of the channels that are looked up.
    bounds : seconds; see `bounds_of`.
    traits : see `traits_of`.
    joints : weights at each bound, and their speeds times `SPEED`, float32, shape (n_halves + 1, 2 n_channels).
    """

    name: str
    rate: float
    weights: Float32Array
    bounds: Float64Array
    traits: Float32Array
    joints: Float32Array

    def __len__(self) -> int:
        return len(self.traits)

    def at(self, times: Float64Array) -> Float32Array:
        """Return the weights at some times, seconds, on straight lines between frames; outside as at the ends."""
        return weights_at(self.weights, times * self.rate)


class Recordings:
    """The recordings of a table, with what is known of their halves as long as the table keeps them in memory.

    Parameters
    ----------
    table : where they are.
    columns : the numbers of the channels that are looked up.
    audible : whether pitch and level count at the joints, too.
    """

    def __init__(self, table: PerformanceTable, columns: IndexArray, *, audible: bool = False) -> None:
        self._table, self._columns, self._audible = table, columns, audible
        self._halves: WeakKeyDictionary[Performance, RecordedHalves] = WeakKeyDictionary()

    def __getitem__(self, number: int) -> RecordedHalves:
        performance = self._table.recording(number)
        if performance not in self._halves:
            self._halves[performance] = _halves_of(performance, self._columns, audible=self._audible)
        return self._halves[performance]


def weights_at(weights: Float32Array, frames: Float64Array) -> Float32Array:
    """Return weights between frames, shape (n, n_channels), on straight lines; outside as at the ends."""
    places = np.clip(frames, 0.0, len(weights) - 1.0)
    below = places.astype(np.intp)
    share = (places - below).astype(np.float32)[:, None]
    first = weights[below]
    return first + share * (weights[np.minimum(below + 1, len(weights) - 1)] - first)


def _halves_of(performance: Performance, columns: IndexArray, *, audible: bool) -> RecordedHalves:
    weights, bounds = performance.weights[:, columns], bounds_of(performance.phones)
    frames = bounds * performance.rate
    after, before = weights_at(weights, frames + 1), weights_at(weights, frames - 1)
    joints = np.hstack([weights_at(weights, frames), (after - before) * (SPEED * performance.rate / 2)])
    if audible:
        joints = np.hstack([joints, _voice_at_bounds(performance.phones)])
    return RecordedHalves(
        performance.name, performance.rate, weights, bounds, traits_of(performance.phones), joints.astype(np.float32)
    )


def _voice_at_bounds(phones: Sequence[PerformedPhone]) -> Float64Array:
    """Return how high and loud the voice is at each bound, by how audible jumps are; shape (2 n_phones + 1, 2)."""
    voiced = [phone.pitch for phone in phones if phone.pitch > 0]
    usual = float(np.median(voiced)) if voiced else 1.0
    own = [(PITCH_HEARD * np.log2((phone.pitch or usual) / 100), phone.energy / STEP) for phone in phones]
    return np.repeat(np.array([*own, own[-1]]), 2, axis=0)[:-1]


def _places(numbers: Sequence[int]) -> Float64Array:
    """Return where each phone stands in the run of its number, 0..1; 0.5 in a run of one."""
    changes = [0, *(k for k, (a, b) in enumerate(pairwise(numbers), 1) if a != b), len(numbers)]
    return np.concatenate([np.linspace(0, 1, b - a) if b > a + 1 else np.array([0.5]) for a, b in pairwise(changes)])


def _mouth_at(name: str) -> tuple[float, ...]:
    """Return how far the lips of a phone are shut, rounded, open and spread."""
    letters = letters_of(name)[:1] if name != SILENCE else ()
    classes = {c for letter in letters for c in articulations_of(letter)}
    height = next((h for c, h in (("open vowel", 1.0), ("mid vowel", 0.6), ("vowel", 0.3)) if c in classes), 0.2)
    shut = bool(classes & {"bilabial", "labiodental"})
    rounded = bool(classes & {"rounded vowel", "labiovelar", "postalveolar", "rhotic"})
    spread = bool(classes & {"front vowel", "sibilant", "palatal"}) and not rounded
    return float(shut), float(rounded), 0.0 if shut or name == SILENCE else height, float(spread)
