"""Mouth shapes that a person asks for by key or slider, beside the speech."""

from collections.abc import Mapping
from enum import Enum

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.mouth.morpher import LowPass
from phonemeengine.mouth.movestate import Mode, Percentages
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
