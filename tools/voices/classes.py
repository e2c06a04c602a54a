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


Row = tuple[str, str, str, str]
"""IPA, class, certainty, and the phones' names with blanks between."""

PLAIN: tuple[Row, ...] = (
    ("", SIL, CORE, "pau"),
    ("s", SZ, CORE, "s"),
    ("m", "m", CORE, "m"),
    ("p", "p", CORE, "p"),
    ("b", "p", CORE, "b"),
    ("n", X, CORE, "n"),
    ("k", X, CORE, "k"),
    ("g", X, CORE, "g"),
)
"""What every voice calls alike: with these a table begins."""


def table_of(*rows: Row) -> dict[str, Phone]:
    """Table phone -> Phone."""
    table = {}
    for ipa, class_name, certainty, names in rows:
        for name in names.split():
            if name in table:
                raise ValueError(f"{name} stands twice in a table of phones: give it one row")
            table[name] = Phone(ipa, class_name, certainty)
    return table
