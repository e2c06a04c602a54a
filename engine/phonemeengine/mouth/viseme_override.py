"""Mouth shapes that a person asks for by key or slider, beside the speech."""

import math
from collections.abc import Mapping
from enum import Enum

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.mouth.percentages import Mode, Percentages
from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import Phoneme

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
        columns = {name: k for k, name in enumerate(table.movestates)}
        self._rows = np.zeros((len(table.shapes), len(columns)), np.float32)
        for row, shape in enumerate(table.shapes.values()):
            for name, percent in shape.items():
                self._rows[row, columns[name]] = percent / 100
        self._at = self._percentages.weights
        self._time = -math.inf

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
        """How far blinks close the eyes meanwhile, 0..1, as `mixed` was last asked."""
        return float(self._at[-1])

    @property
    def phonemes(self) -> dict[Phoneme, float]:
        """The shapes that are asked for now, as the first phonemes that have them; how far, above 0 to 1."""
        first: dict[str, Phoneme] = {}
        for phoneme, shape in self._table.phonemes.items():
            first.setdefault(shape, phoneme)
        return {first[shape]: share for shape, share in self.shares.items() if share > 0 and shape in first}

    def ask(self, shape: str, share: float, mode: Mode) -> None:
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

    def hold(self, shape: str) -> None:
        """Show a shape alone until `release`, as `Mode.RESET` does."""
        self.release()
        self.held, self._before = shape, self._percentages.percentages
        self._percentages.set_percentage(shape, 100, Mode.RESET)

    def release(self) -> None:
        """Let go of the shape that is held: all is as it was before."""
        self.held = ""
        self._percentages.set_percentages(self._before)
        self._before = {}

    def ask_as(self, phonemes: Mapping[Phoneme, float], speech: float) -> None:
        """Ask for nothing but the shapes that the table has for some phonemes, 0..1, beside a share of the speech."""
        self._percentages.reset_all()
        self._percentages.set_percentage(Others.SPEECH, 100 * speech)
        for phoneme, share in phonemes.items():
            shape = self._table.phonemes[phoneme]
            self._percentages.set_percentage(shape, max(100 * share, self._percentages.percentage(shape)))

    def ask_nothing(self) -> None:
        """Leave the face to speech and blinks."""
        self.release()
        self._percentages.reset_all()
        self._percentages.set_percentages(LEFT_TO_SPEECH)

    def mixed(self, spoken: Float32Array, now: float) -> Float32Array:
        """Return the weights of the mouth, shape (n_movestates,): what is asked for, and speech's share of its own.

        They get there smoothly; times never go back.
        """
        passed, self._time = max(now - self._time, 0.0), now
        goal = self._percentages.weights
        self._at = goal + (self._at - goal) * np.float32(math.exp(-passed / TIME_CONSTANT))
        if np.abs(self._at - goal).max() < UNSEEN:
            self._at = goal
        *shares, speech, _ = self._at
        mixed: Float32Array = speech * spoken + np.array(shares, np.float32) @ self._rows
        return mixed
