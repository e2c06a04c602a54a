"""A voice: who speaks, the table of its phones, and its speech without end."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

from tools.voices.classes import Phone
from tools.voices.writing import Speaker, Utterance


class Voice(NamedTuple):
    """A voice of a synthesizer."""

    speaker: Speaker
    table: dict[str, Phone]
    utterances: Callable[[], Iterator[Utterance]]
    shift: float = 0.0  # s by which the labels of the synthesizer are corrected, as measured
