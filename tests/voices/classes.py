"""The classes of the labels, and how a table of phones is written."""

from typing import NamedTuple

CLASSES = ("silence", "sz", "sch", "m", "p", "a", "e", "i", "o", "u", "unidentified")
VOWELS = "aeiou"
SIL, SZ, SCH, X = "silence", "sz", "sch", "unidentified"
CORE, AMBIGUOUS, DIPHTHONG, AFFRICATE = "core", "ambiguous", "diphthong", "affricate"


class Phone(NamedTuple):
    """What a phone is: its IPA, its class, and how surely it belongs there."""

    ipa: str
    class_name: str
    certainty: str


def table_of(*rows: tuple[str, str, str, str]) -> dict[str, Phone]:
    """Table phone -> Phone, from rows of IPA, class, certainty and the phones' names with blanks between."""
    table = {}
    for ipa, class_name, certainty, names in rows:
        for name in names.split():
            if name in table:
                raise ValueError(f"{name} stands twice in a table of phones: give it one row")
            table[name] = Phone(ipa, class_name, certainty)
    return table
