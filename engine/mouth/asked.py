"""Mouth shapes that a person asks for by key or slider: they win over the speech."""

import math
from collections.abc import Mapping

import numpy as np

from engine.mouth.morpher import Weights
from engine.mouth.table import MouthTable
from engine.phonemes import Phoneme

TIME_CONSTANT = 0.04
"""Seconds in which 63 % of a change is followed."""
UNSEEN = 0.001


class AskedVisemes:
    """Holds how far each shape of a table is asked for, and moves the mouth there smoothly.

    Attributes
    ----------
    shares : how far the sliders ask for each shape, 0..1.
    held : the shape that a key holds at the full, or an empty text; the sliders wait meanwhile.
    """

    def __init__(self, table: MouthTable) -> None:
        self._table = table
        self.shares = dict.fromkeys(table.shapes, 0.0)
        self.held = ""
        columns = {name: k for k, name in enumerate(table.movestates)}
        self._rows = np.zeros((len(table.shapes), len(columns)), np.float32)
        for row, shape in enumerate(table.shapes.values()):
            for name, percent in shape.items():
                self._rows[row, columns[name]] = percent / 100
        self._at = np.zeros(len(self.shares) + 1, np.float32)  # the last one is how far they win over the speech
        self._time = -math.inf

    @property
    def any(self) -> bool:
        """Whether any shape is asked for."""
        return bool(self.held) or any(self.shares.values())

    @property
    def wanted(self) -> dict[str, float]:
        """How far each shape is asked for now, 0..1."""
        return {name: float(name == self.held) for name in self.shares} if self.held else dict(self.shares)

    @property
    def phonemes(self) -> dict[Phoneme, float]:
        """The shapes that are asked for now, as the first phonemes that have them; how far, above 0 to 1."""
        first: dict[str, Phoneme] = {}
        for phoneme, shape in self._table.phonemes.items():
            first.setdefault(shape, phoneme)
        return {first[shape]: share for shape, share in self.wanted.items() if share > 0 and shape in first}

    def ask_as(self, phonemes: Mapping[Phoneme, float]) -> None:
        """Ask for nothing but the shapes that the table has for some phonemes, 0..1."""
        self.held = ""
        self.shares = dict.fromkeys(self._table.shapes, 0.0)
        for phoneme, share in phonemes.items():
            shape = self._table.phonemes[phoneme]
            self.shares[shape] = max(share, self.shares[shape])

    def mixed(self, spoken: Weights, now: float) -> Weights:
        """Give the weights of the mouth: those asked for, or those of the speech; shape (n_movestates,).

        Shapes that are asked for with more than 100 % in all shrink alike, as with `Mode.INTERACT`.
        """
        passed, self._time = max(now - self._time, 0.0), now
        if not self.any and self._at[-1] < UNSEEN:
            self._at[:] = 0
            return spoken
        goal = np.array([*self.wanted.values(), float(self.any)], np.float32)
        self._at = goal + (self._at - goal) * np.float32(math.exp(-passed / TIME_CONSTANT))
        shares = self._at[:-1] / max(1.0, float(self._at[:-1].sum()))
        mixed: Weights = (1 - self._at[-1]) * spoken + shares @ self._rows
        return mixed
