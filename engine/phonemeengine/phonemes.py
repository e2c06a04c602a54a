"""The vocabulary: eleven phonemes and the five mouth shapes they need."""

from enum import IntEnum, StrEnum


class Phoneme(IntEnum):
    """What a frame can be recognised as; the number is the code used in arrays (uint8)."""

    SILENCE = 0
    UNIDENTIFIED = 1
    SZ = 2
    SCH = 3
    M = 4
    P = 5
    I = 6  # noqa: E741 - the phoneme's name
    A = 7
    E = 8
    U = 9
    O = 10  # noqa: E741 - the phoneme's name

    @property
    def label(self) -> str:
        """The name used in files, such as ``sch``; the window calls sz and sch as people write them."""
        return self.name.lower()


PHONEMES_BY_LABEL: dict[str, Phoneme] = {phoneme.label: phoneme for phoneme in Phoneme}
VOWELS = (Phoneme.A, Phoneme.E, Phoneme.I, Phoneme.O, Phoneme.U)


NO_PHONEME = len(Phoneme)
"""The code of a frame of which nothing is known."""


class MouthShape(StrEnum):
    """The smallest useful set of visemes."""

    OPEN = "open"
    WIDE = "wide"
    ROUND = "round"
    CLOSED = "closed"
    SLIGHT = "slightly open"


MOUTH_SHAPES: dict[Phoneme, MouthShape] = {
    Phoneme.A: MouthShape.OPEN,
    Phoneme.E: MouthShape.WIDE,
    Phoneme.I: MouthShape.WIDE,
    Phoneme.O: MouthShape.ROUND,
    Phoneme.U: MouthShape.ROUND,
    Phoneme.M: MouthShape.CLOSED,
    Phoneme.P: MouthShape.CLOSED,
    Phoneme.SILENCE: MouthShape.CLOSED,
    Phoneme.SZ: MouthShape.SLIGHT,
    Phoneme.SCH: MouthShape.SLIGHT,
    Phoneme.UNIDENTIFIED: MouthShape.SLIGHT,
}
