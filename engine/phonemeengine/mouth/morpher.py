"""The morpher: how a mouth moves from shape to shape, also to those that a person asks for by key or slider.

Each phoneme begins a movement along half a cosine, from wherever the mouth is going to the new shape, laid over the
movements that still go on::

    weights = (1 - e) * (what went on before) + e * shape,    e = (1 - cos(pi (t - start) / duration)) / 2

Neither weights nor their speed jump, however fast phonemes follow each other; no weight leaves the range of the
shapes that it lies between, nor exceeds what the table says; and since every movement is known for all times, it does
not matter how often anybody looks. Each sound has its own time: a movement to its shape takes as long as its attack
says, and one to silence as long as the release of what was said before.

A movement goes to the shape of a phoneme, or to that which the table has for a phone, where one is known.
"""

import math
import random
from collections import deque
from collections.abc import Mapping, Reversible
from dataclasses import dataclass
from enum import Enum, StrEnum
from typing import TypeVar

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.labels.phone_sets import narrowest
from phonemeengine.mouth.blendshape_names import TONGUE
from phonemeengine.mouth.movestate import Mode, Percentages
from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import VOWELS, Phoneme

# Movements along half a cosine, laid over each other: of each mouth that goes from shape to shape.
#
# A movement begins wherever the mouth is going to, so neither the weights nor their speed jump, however fast
# movements follow each other, and no weight leaves the range of the shapes that it lies between.

# Following a value that holds between its changes.


class LowPass:
    """Approaches a target by the exact answer of a low-pass of first order: it does not matter how often one looks.

    Parameters
    ----------
    time_constant : seconds after which 63 % of a change is followed; 0 follows at once.
    value : where it begins.
    """

    def __init__(self, time_constant: float, value: float = 0.0) -> None:
        self._time_constant = time_constant
        self._time, self._value, self._target = 0.0, value, value

    def set_target(self, time: float, target: float) -> None:
        """Set another target from a time on, seconds; times never go back."""
        if target != self._target:
            self._value = self.at(time)
            self._time, self._target = time, target

    def at(self, time: float) -> float:
        """Return the value at a time."""
        if self._time_constant <= 0.0 or self._value == self._target:
            return self._target
        passed = max(time - self._time, 0.0)
        return self._target + (self._value - self._target) * math.exp(-passed / self._time_constant)


@dataclass(slots=True)
class EasedMovement:
    """A movement of the mouth: when it begins, how long it takes, both in seconds, and the number of its shape."""

    start: float
    duration: float
    row: int


M = TypeVar("M", bound=EasedMovement)


def shares_of(movements: Reversible[M], time: float) -> list[tuple[M, float]]:
    """Return the movements that make the mouth at a time, the newest first, each with its share; these sum to 1.

    Parameters
    ----------
    movements : in the order in which they begin; the first one has ended, or the shares sum to less.
    time : seconds.
    """
    mixed, left = [], 1.0
    for movement in reversed(movements):
        progress = (time - movement.start) / movement.duration if movement.duration else 1.0
        if progress <= 0.0:
            continue
        ease = 1.0 if progress >= 1.0 else 0.5 - 0.5 * math.cos(math.pi * progress)
        mixed.append((movement, left * ease))
        left *= 1.0 - ease
        if left <= 0.0:
            break
    return mixed


HALF_OPEN = 0.6
"""How far a mouth of two states opens, as a share of the shape of a."""
_LETTERS = {Phoneme.SZ: "s", Phoneme.SCH: "ʃ"} | {vowel: vowel.label for vowel in VOWELS}
"""The letters of phonemes that show where the tongue is, where no phone is known."""
MOST_MOVEMENTS = 64
"""Movements that are remembered at once: more than fit into the longest one would be forgotten, oldest first."""


class Detail(StrEnum):
    """How much of the speech the mouth follows; far characters need less."""

    PHONEMES = "phonemes"
    LOUDNESS = "loudness"
    TWO_STATES = "two-states"


@dataclass(slots=True)
class _Movement(EasedMovement):
    whole: bool
    """Whether the shape is full whatever the loudness."""
    share: float
    tongue: Float32Array
    """The weights of the tongue, which is where it is whatever the loudness; empty where the table has none."""


class Morpher:
    """Follows phonemes as they come, and gives the weights of the movestates at any time after.

    Parameters
    ----------
    table : the shapes, and how the mouth moves between them.
    detail : how much of the speech it follows.
    seed : of the randomness; equal seeds make equal mouths.
    """

    def __init__(self, table: MouthTable, *, detail: Detail = Detail.PHONEMES, seed: int = 0) -> None:
        self.table = table
        self._motion = table.motion
        self._detail = detail
        self._random = random.Random(seed)  # noqa: S311 - nothing secret depends on it
        self._rows = _rows_of(table, detail, self._random)
        self._row_of_shape = {shape: len(Phoneme) + k for k, shape in enumerate(table.shapes)}
        self._closed = {*table.closed_phonemes, Phoneme.SILENCE}
        self._tongue = [k for k, name in enumerate(table.movestates) if table.tongue and name in TONGUE]
        resting = _Movement(-math.inf, 0.0, Phoneme.SILENCE, True, 1.0, np.zeros(len(self._tongue), np.float32))
        self._movements = deque([resting], maxlen=MOST_MOVEMENTS)
        self._said, self._row = (Phoneme.SILENCE, ""), int(Phoneme.SILENCE)
        self._loudness = LowPass(self._motion.loudness)

    @property
    def movestates(self) -> tuple[str, ...]:
        """The names of the movestates, in the order of the weights."""
        return self.table.movestates

    def add(self, time: float, phoneme: int, intensity: float, phone: str = "") -> None:
        """Take what sounds from a time on; times, seconds, never go back.

        Parameters
        ----------
        time : when it begins, seconds.
        phoneme : its code, as `Phoneme`.
        intensity : 0..1.
        phone : its symbol in the International Phonetic Alphabet, where it is known.
        """
        self.set_loudness(time, intensity)
        self.set_phoneme(time, phoneme, phone)

    def set_phoneme(self, time: float, phoneme: int, phone: str = "", *, time_share: float = 1.0) -> None:
        """Take a phoneme alone from a time on, and its phone where it is known: the loudness goes on.

        The movement takes `time_share` of the time that the table has for it.
        """
        said = _followed(phoneme, phone, self._detail, self._closed)
        if said == self._said:
            return
        row = self._row_of(*said)
        if row != self._row or (self._tongue and said[1] != self._said[1]):
            self._movements.append(self._movement(time, row, *said, time_share))
        self._said, self._row = said, row

    def set_loudness(self, time: float, intensity: float) -> None:
        """Take the loudness alone, 0..1, from a time on: the phoneme goes on."""
        self._loudness.set_target(time, min(max(intensity, 0.0), 1.0))

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, float32, shape (n_movestates,), 1 for the whole movement.

        Movements that have ended by this time are forgotten: times may be looked at in order only.
        """
        movements, gain = self._movements, self._gain(time)
        shares, rows, mixed = [], [], shares_of(movements, time)
        for movement, share in mixed:
            shares.append(share * (movement.share if movement.whole else movement.share * gain))
            rows.append(movement.row)
        while rows and movements[0] is not movement:
            movements.popleft()
        weights: Float32Array = np.array(shares, np.float32) @ self._rows[rows]
        if self._tongue:
            weights[self._tongue] = sum(share * movement.tongue for movement, share in mixed)
        return weights

    def _row_of(self, phoneme: Phoneme, phone: str) -> int:
        """Return where the weights stand: those of the phoneme, or of the shape that the table has for the phone."""
        shape = self.table.shape_of(phoneme, phone)
        return int(phoneme) if shape == self.table.phonemes[phoneme] else self._row_of_shape[shape]

    def _movement(self, time: float, row: int, phoneme: Phoneme, phone: str, time_share: float) -> _Movement:
        table, spread = self.table, self._motion.randomness
        silent = phoneme is Phoneme.SILENCE
        closes = silent or table.closes(phoneme, phone)
        duration = table.times_of(*self._said).to_rest if silent else table.times_of(phoneme, phone).to_shape
        vary_time, vary_shape = self._random.uniform(-spread, spread), self._random.uniform(-2 * spread, 0.0)
        if not closes:
            duration *= 1 + vary_time
        whole = closes or self._detail is Detail.TWO_STATES
        share = 1.0 if closes else 1.0 + vary_shape
        return _Movement(time, duration * time_share, row, whole, share, self._tongue_in(phoneme, phone))

    def _tongue_in(self, phoneme: Phoneme, phone: str) -> Float32Array:
        """Return where the tongue goes; it stays where it went before in sounds of lips and glottis."""
        before = self._movements[-1].tongue
        if not self._tongue or phoneme is Phoneme.SILENCE:
            return np.zeros_like(before)
        pose = narrowest(self.table.tongue, phone or _LETTERS.get(phoneme, ""), None)
        if pose is None:
            return before
        return np.array([pose.get(self.table.movestates[k], 0.0) / 100 for k in self._tongue], np.float32)

    def _gain(self, time: float) -> float:
        least = 0.0 if self._detail is Detail.LOUDNESS else self._motion.minimum_opening
        return least + (1.0 - least) * self._loudness.at(time)


def _followed(phoneme: int, phone: str, detail: Detail, closed_phonemes: set[Phoneme]) -> tuple[Phoneme, str]:
    """Return the phoneme that the mouth shows, and its phone."""
    if detail is Detail.PHONEMES:
        return Phoneme(phoneme), phone
    closed = phoneme == Phoneme.SILENCE or (detail is Detail.TWO_STATES and phoneme in closed_phonemes)
    return Phoneme.SILENCE if closed else Phoneme.A, ""


def _rows_of(table: MouthTable, detail: Detail, chance: random.Random) -> Float32Array:
    """Return the weights of every phoneme, and of every shape, with the habits of one mouth.

    Lips that meet do so in every mouth.
    """
    rows, spread = np.concatenate((table.weights(), table.shape_weights())), table.motion.randomness
    own = (table.tongue and name in TONGUE for name in table.movestates)  # lips are the same without a tongue
    habits = np.array([0.0 if tongue else chance.uniform(-spread, 0.0) for tongue in own], np.float32)
    firm = {table.phones[name] for name in table.closed_phones}
    loose = [int(p) for p in Phoneme if p not in {*table.closed_phonemes, Phoneme.SILENCE}]
    loose += [len(Phoneme) + k for k, shape in enumerate(table.shapes) if shape not in firm]
    rows[loose] *= 1 + _alike_on_both_sides(habits, table.movestates)
    if detail is Detail.TWO_STATES:
        rows[Phoneme.A] *= HALF_OPEN
    return rows


def _alike_on_both_sides(habits: Float32Array, movestates: tuple[str, ...]) -> Float32Array:
    """Draw the right half of a face towards its left one: a habit is no paralysis."""
    columns = {name: k for k, name in enumerate(movestates)}
    for name, k in columns.items():
        left = columns.get(f"{name.removesuffix('Right')}Left") if name.endswith("Right") else None
        if left is not None:
            habits[k] = habits[left] + (habits[k] - habits[left]) / 4
    return habits


TIME_CONSTANT = 0.04
"""Seconds in which 63 % of a change is followed."""
UNSEEN = 0.001


class Others(Enum):
    """What moves a face beside the shapes that are asked for: the speech gives way to them, blinks do not."""

    SPEECH = "speech"
    BLINKS = "blinks"


LEFT_TO_SPEECH: dict[str | Others, float] = dict.fromkeys(Others, 100.0)


class VisemeOverride:
    """Holds how far each shape of a table is asked for, beside the speech and the blinks, and moves the mouth there.

    As long as no shape is asked for, speech and blinks are whole.

    Attributes
    ----------
    held : the shape that a key holds, or an empty text.
    """

    def __init__(self, table: MouthTable) -> None:
        self._table = table
        interactable: dict[str | Others, bool] = dict.fromkeys(table.shapes, True)
        self._percentages = Percentages(interactable | {Others.SPEECH: True, Others.BLINKS: False})
        self._percentages.set_percentages(LEFT_TO_SPEECH)
        self._before: dict[str | Others, float] = {}
        self.held = ""
        self._named: dict[str, Phoneme] = {}
        for phoneme, shape in table.phonemes.items():
            self._named.setdefault(shape, phoneme)
        self._rows = table.shape_weights()
        self._target = self._at = self._percentages.weights
        self._smooth, self._looked = [LowPass(TIME_CONSTANT, share) for share in self._at.tolist()], 0.0
        self._settled = self._left_to_speech = True

    def reshape(self, table: MouthTable) -> None:
        """Go on with a table whose shapes have the same names, as another style moves them."""
        self._table, self._rows = table, table.shape_weights()

    @property
    def shares(self) -> dict[str, float]:
        """How far each shape is asked for now, 0..1."""
        return {shape: self._percentages.percentage(shape) / 100 for shape in self._table.shapes}

    @property
    def speech(self) -> float:
        """How far the speech moves the mouth meanwhile, 0..1."""
        return self._percentages.percentage(Others.SPEECH) / 100

    @property
    def blinks(self) -> float:
        """How far blinks close the eyes meanwhile, 0..1, as `apply` was last called."""
        return float(self._at[-1])

    @property
    def phonemes(self) -> dict[Phoneme, float]:
        """The shapes that are asked for now, as phonemes that have them; how far, above 0 to 1."""
        named = self._named
        return {named[shape]: share for shape, share in self.shares.items() if share > 0 and shape in named}

    def set(self, shape: str, share: float, mode: Mode) -> None:
        """Ask for a shape, 0..1; the mode says what becomes of the others, of the speech and of the blinks.

        With `Mode.INTERACT` the speech has what the shapes leave, before they have to shrink.
        """
        self.release()
        if mode == Mode.INTERACT:
            asked = sum((self.shares | {shape: share}).values())
            self._percentages.set_percentage(Others.SPEECH, 100 * max(0.0, 1 - asked))
        self._percentages.set_percentage(shape, 100 * share, mode)
        if not any(self.shares.values()):
            self._percentages.set_percentages(LEFT_TO_SPEECH)
        self._aim()

    def hold(self, shape: str) -> None:
        """Show a shape alone until `release`, as `Mode.RESET` does."""
        self.release()
        self.held, self._before = shape, self._percentages.percentages
        self._percentages.set_percentage(shape, 100, Mode.RESET)
        self._aim()

    def release(self) -> None:
        """Let go of the shape that is held: all is as it was before."""
        self.held = ""
        self._percentages.set_percentages(self._before)
        self._before = {}
        self._aim()

    def set_phonemes(self, phonemes: Mapping[Phoneme, float], speech: float) -> None:
        """Ask for the shapes that the table has for these phonemes alone, 0..1, beside a share of the speech.

        Of none, the speech is left to itself.
        """
        self.clear()
        for phoneme, share in phonemes.items():
            shape = self._table.phonemes[phoneme]
            if 100 * share > self._percentages.percentage(shape):
                self._percentages.set_percentage(shape, 100 * share)
                self._named[shape] = phoneme
        if phonemes:
            self._percentages.set_percentage(Others.SPEECH, 100 * speech)
        self._aim()

    def clear(self) -> None:
        """Leave the face to speech and blinks."""
        self.release()
        self._percentages.reset_all()
        self._percentages.set_percentages(LEFT_TO_SPEECH)
        self._aim()

    def apply(self, spoken: Float32Array, now: float) -> Float32Array:
        """Return the weights of the mouth, shape (n_movestates,): what is asked for, and speech's share of its own.

        They get there smoothly; times never go back.
        """
        self._looked = now
        if not self._settled:
            self._at = np.array([share.at(now) for share in self._smooth], np.float32)
            self._settled = bool(np.abs(self._at - self._target).max() < UNSEEN)
            self._at = self._target if self._settled else self._at
        elif self._left_to_speech:
            return spoken
        *shares, speech, _ = self._at
        mixed: Float32Array = speech * spoken + np.array(shares, np.float32) @ self._rows
        return mixed

    def _aim(self) -> None:
        """Go to what is asked for now, from the last look on."""
        target = self._percentages.weights
        if not np.array_equal(target, self._target):
            self._target, self._settled = target, False
            self._left_to_speech = not any(self.shares.values())
            for share, wanted in zip(self._smooth, target.tolist(), strict=True):
                share.set_target(self._looked, wanted)
