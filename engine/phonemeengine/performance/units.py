"""The units of a sentence: words, syllables, triphones, diphones and halves of phones.

Every phone has a left half, from its start to its middle, and a right half. Half 2k is the left one of phone k, half
2k + 1 its right one. A unit spans consecutive halves, and is looked up by the names of the phones that it touches.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum

from phonemeengine.performance.recording import PerformedPhone


class UnitKind(StrEnum):
    """The nine sets of units, the longest first."""

    WORD = "word"
    SYLLABLE = "syllable"
    VOWEL_TRIPHONE = "vowel-triphone"
    CONSONANT_TRIPHONE = "consonant-triphone"
    BOUNDARY_TRIPHONE = "boundary-triphone"
    DIPHONE = "diphone"
    BOUNDARY_DIPHONE = "boundary-diphone"
    RIGHT_HALF = "right-half"
    LEFT_HALF = "left-half"


@dataclass(frozen=True)
class Unit:
    """A unit of a sentence.

    Attributes
    ----------
    kind : its set.
    names : of the phones that it touches, in order.
    first, last : its halves; `last` is not of it.
    """

    kind: UnitKind
    names: tuple[str, ...]
    first: int
    last: int


def units_of(phones: Sequence[PerformedPhone]) -> Iterator[Unit]:
    """Return all units of a sentence, the sets in their order, each in order of time.

    Parameters
    ----------
    phones : in order of time; the first and the last are silence.
    """
    raise NotImplementedError
