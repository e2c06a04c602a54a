"""What a recogniser is, and which ones there are."""

from collections.abc import Callable
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from engine.errors import PresetError
from engine.features.measure import Features
from engine.recognition.phoneme_data import Thresholds
from engine.recognition.rules import ThesisRules
from engine.recognition.trace import Trace


class Recogniser(Protocol):
    """Gives every frame of a block a phoneme, and can say why."""

    def recognise(self, features: Features) -> NDArray[np.uint8]:
        """Recognise a block; returns codes of `Phoneme`, shape (n_frames,)."""
        ...

    def explain(self, features: Features, k: int) -> Trace:
        """Say why frame `k` of a block is recognised as it is."""
        ...


RECOGNISERS: dict[str, Callable[[Thresholds], Recogniser]] = {"thesis": ThesisRules}


def recogniser_of(name: str, thresholds: Thresholds) -> Recogniser:
    """Make the recogniser that a preset names; PresetError where there is none of that name."""
    if name not in RECOGNISERS:
        raise PresetError(f"there is no recogniser named {name!r}; known are {', '.join(RECOGNISERS)}")
    return RECOGNISERS[name](thresholds)
