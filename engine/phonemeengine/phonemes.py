"""The vocabulary: eleven phonemes."""

from enum import IntEnum


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
