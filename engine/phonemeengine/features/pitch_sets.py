"""Which set of PhonemeData fits the voice: chosen by its pitch, frame by frame, with the filters of each set.

The pitch of a voice is the median of its fundamental frequency over the last second in which it was voiced. What it
says of a frame depends on the frames before it alone, so live sound and files are measured alike, however they are
cut.
"""

from bisect import bisect_left, insort
from collections import deque
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array
from phonemeengine.features.front_end import FrameBlock, FrontEnd
from phonemeengine.features.measure import Features
from phonemeengine.features.variables import PITCH, PITCH_SET_COLUMNS, Variable
from phonemeengine.settings import AnalysisSettings

MOST_VOICED = 100
"""Voiced frames over which the median is taken."""
LEAST_VOICED = 30
"""Voiced frames before the pitch of a voice is known."""
STAY = 2 ** (1 / 12)
"""A set stays while the pitch lies within its range widened by this factor at both ends, a semitone."""

PitchRange = tuple[float, float]
"""From which pitch, and up to which, Hz; the upper end does not belong to it."""


class PitchSetChooser:
    """Follows the pitch of a voice, and chooses the set in whose range it lies.

    Parameters
    ----------
    ranges : of the sets, in their order; of several that hold the pitch, the first is chosen.
    """

    def __init__(self, ranges: Sequence[PitchRange]) -> None:
        self._ranges = tuple(ranges)
        self._newest: deque[float] = deque()
        self._sorted: list[float] = []
        self._chosen = 0

    def choose(self, f0: Float32Array) -> Float32Array:
        """Return the pitch of the voice (Hz, 0 until it is known) and the number of the set, shape (n_frames, 2).

        Sets count from 1; 0 stands for none: the pitch is not known yet, or no range holds it.

        Parameters
        ----------
        f0 : the fundamental frequency of the next frames, Hz; 0 where there is none.
        """
        return np.array([self._follow(value) for value in f0.tolist()], np.float32).reshape(-1, 2)

    def _follow(self, f0: float) -> tuple[float, int]:
        if f0 > 0:
            self._newest.append(f0)
            insort(self._sorted, f0)  # kept in order: a median of each frame anew would sort a hundred each time
            if len(self._newest) > MOST_VOICED:
                del self._sorted[bisect_left(self._sorted, self._newest.popleft())]
        if len(self._sorted) < LEAST_VOICED:
            return 0.0, 0
        pitch = self._sorted[len(self._sorted) // 2]
        if not (self._chosen and self._holds(self._chosen, pitch, STAY)):
            numbers = range(1, len(self._ranges) + 1)
            self._chosen = next((k for k in numbers if self._holds(k, pitch)), 0)
        return pitch, self._chosen

    def _holds(self, number: int, pitch: float, widened: float = 1.0) -> bool:
        low, high = self._ranges[number - 1]
        return low / widened <= pitch < high * widened


class PitchSetFrontEnd:
    """The front ends of several sets as one, which measures each frame with the filters of the set that is chosen.

    Two more columns, `PITCH_SET_COLUMNS`, tell the pitch of the voice and the number of the set.

    Parameters
    ----------
    settings : where no set is chosen, and then those of each set; all give spectra of one size.
    ranges : of the sets.
    variables : the user's own variables.
    """

    def __init__(
        self, settings: Sequence[AnalysisSettings], ranges: Sequence[PitchRange], variables: tuple[Variable, ...]
    ) -> None:
        self._settings = tuple(settings)
        self._front_ends = {s: FrontEnd(s, variables, pitch=True) for s in dict.fromkeys(settings)}
        self._ranges = tuple(ranges)
        self._chooser = PitchSetChooser(ranges)
        self.names = (*self._front_ends[self._settings[0]].names, *PITCH_SET_COLUMNS)

    def nothing(self) -> FrameBlock:
        """Return a block without frames."""
        nothing = self._front_ends[self._settings[0]].nothing()
        return nothing.with_columns(PITCH_SET_COLUMNS, self._chooser.choose(nothing.features[PITCH.name]))

    def measure(self, frames: Float32Array) -> FrameBlock:
        """Measure raw frames, shape (n, 2048), at least one."""
        # all of them each time, since time smoothing needs the frames before, whichever set they were of
        measured = {s: front_end.measure(frames) for s, front_end in self._front_ends.items()}
        own = measured[self._settings[0]]
        chosen = self._chooser.choose(own.features[PITCH.name])
        for settings in list(measured)[1:]:
            numbers = [k for k, s in enumerate(self._settings) if s == settings]
            own = _joined(own, measured[settings], np.isin(chosen[:, 1], numbers)[:, np.newaxis])
        return own.with_columns(PITCH_SET_COLUMNS, chosen)

    def resume(self, other: object) -> None:
        """Have time smoothing and choice go on from where another front end stopped."""
        others = other._front_ends if isinstance(other, PitchSetFrontEnd) else {}
        for settings, front_end in self._front_ends.items():
            front_end.resume(others.get(settings, next(iter(others.values()), other)))
        if isinstance(other, PitchSetFrontEnd) and self._ranges == other._ranges:
            self._chooser = other._chooser


def _joined(one: FrameBlock, other: FrameBlock, from_other: BoolArray) -> FrameBlock:
    """Return the frames of one block, but those of another where `from_other` is true, shape (n_frames, 1)."""
    mel = None if one.mel is None or other.mel is None else np.where(from_other, other.mel, one.mel)
    values = np.where(from_other, other.features.values, one.features.values)
    return replace(
        one,
        spectra=np.where(from_other, other.spectra, one.spectra),
        mel=mel,
        features=Features(one.features.names, values),
    )
