"""What a recogniser is, and which ones there are."""

from collections.abc import Callable
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from engine.errors import PresetError, RecogniserError
from engine.features.measure import Features
from engine.recognition.phoneme_data import Thresholds
from engine.recognition.plug_ins import PlugIn, package_of, plug_ins
from engine.recognition.rules import ThesisRules
from engine.recognition.trace import Trace


class Recogniser(Protocol):
    """Gives every frame of a block a phoneme, and can say why.

    Blocks come in the order of the sound, cut anywhere, so a recogniser may remember; after a seek a new one is made,
    which hears 0.4 s of the sound unseen. `explain` is asked of another one, which has recognised nothing: it tells
    what can be told from the block alone, and remembers nothing. A plug-in may leave `used_thresholds` out.
    """

    @property
    def used_thresholds(self) -> frozenset[str]:
        """The fields of `Thresholds` that it compares with."""
        ...

    def recognise(self, features: Features) -> NDArray[np.uint8]:
        """Recognise a block; returns codes of `Phoneme`, shape (n_frames,)."""
        ...

    def explain(self, features: Features, k: int) -> Trace:
        """Say why frame `k` of a block is recognised as it is."""
        ...


RECOGNISERS: dict[str, Callable[[Thresholds], Recogniser]] = {"thesis": ThesisRules}
"""The recognisers that come with the program; no other package can take their names."""


def recogniser_names() -> tuple[str, ...]:
    """Give the names of all recognisers, the program's own first; those of other packages are not imported."""
    return (*RECOGNISERS, *(name for name in plug_ins() if name not in RECOGNISERS))


def check_recogniser(name: str) -> None:
    """Refuse a name that is not exactly one recogniser's; nothing is imported.

    Raises
    ------
    PresetError : there is none of that name.
    RecogniserError : several packages offer one of that name.
    """
    if name in RECOGNISERS:
        return
    entries = plug_ins().get(name, ())
    if not entries:
        raise PresetError(
            f"there is no recogniser named {name!r}; known are {', '.join(recogniser_names())}; install the package "
            "that brings it, or choose another preset"
        )
    if len(entries) > 1:
        packages = " and ".join(package_of(entry) for entry in entries)
        raise RecogniserError(f"the recogniser {name!r} is offered twice, by {packages}; uninstall one of them")


def recogniser_of(name: str, thresholds: Thresholds) -> Recogniser:
    """Give the recogniser that a preset names; one of another package is made when it is first asked.

    Raises
    ------
    PresetError : there is none of that name.
    RecogniserError : several packages offer it, or it cannot be imported.
    """
    check_recogniser(name)
    if name in RECOGNISERS:
        return RECOGNISERS[name](thresholds)
    (entry,) = plug_ins()[name]
    return PlugIn(entry, thresholds)
