"""Kyrgyz: the phones of RHVoice. An f behind a vowel makes it a front one."""

from tools.voices.classes import AFFRICATE, AMBIGUOUS, CORE, PLAIN, SCH, SZ, X, table_of

KYRGYZ = table_of(
    *PLAIN,
    ("z", SZ, CORE, "z"),
    ("ts", SZ, AFFRICATE, "c"),
    ("ʃ", SCH, CORE, "sh sch"),
    ("ʒ", SCH, CORE, "zh"),
    ("tʃ", SCH, AFFRICATE, "ch"),
    ("dʒ", SCH, AFFRICATE, "dzh"),
    ("ŋ", X, CORE, "ng"),
    ("ɑ", "a", CORE, "a aa"),
    ("e", "e", CORE, "e ee"),
    ("i", "i", CORE, "i"),
    ("ɯ", "i", AMBIGUOUS, "y"),
    ("o", "o", CORE, "o oo"),
    ("ø", "o", AMBIGUOUS, "of oof"),
    ("u", "u", CORE, "u uu"),
    ("y", "u", AMBIGUOUS, "uf uuf"),
    ("j", X, CORE, "j"),
    ("t", X, CORE, "t"),
    ("d", X, CORE, "d"),
    ("f", X, CORE, "f"),
    ("v", X, CORE, "v"),
    ("x", X, CORE, "h"),
    ("l", X, CORE, "l"),
    ("r", X, CORE, "r"),
)
