"""Japanese: the phones of Open JTalk. Capital vowels are devoiced, cl is the closure of a long consonant."""

from tools.voices.classes import AFFRICATE, AMBIGUOUS, CORE, PLAIN, SCH, SIL, SZ, X, table_of

JAPANESE = table_of(
    *PLAIN,
    ("", SIL, CORE, "sil"),
    ("z", SZ, CORE, "z"),
    ("ts", SZ, AFFRICATE, "ts"),
    ("ɕ", SCH, AMBIGUOUS, "sh"),
    ("dʑ", SCH, AFFRICATE, "j"),
    ("tɕ", SCH, AFFRICATE, "ch"),
    ("m", "m", CORE, "my"),
    ("n", X, CORE, "ny"),
    ("ɴ", X, AMBIGUOUS, "N"),
    ("p", "p", CORE, "py"),
    ("b", "p", CORE, "by"),
    ("a", "a", CORE, "a"),
    ("e", "e", CORE, "e"),
    ("i", "i", CORE, "i"),
    ("o", "o", CORE, "o"),
    ("ɯ", "u", CORE, "u"),
    ("ḁ", "a", AMBIGUOUS, "A"),
    ("e̥", "e", AMBIGUOUS, "E"),
    ("i̥", "i", AMBIGUOUS, "I"),
    ("o̥", "o", AMBIGUOUS, "O"),
    ("ɯ̥", "u", AMBIGUOUS, "U"),
    ("ʔ", X, CORE, "cl"),
    ("j", X, CORE, "y"),
    ("w", X, CORE, "w"),
    ("ɾ", X, CORE, "r ry"),
    ("h", X, CORE, "h hy"),
    ("ɸ", X, CORE, "f"),
    ("t", X, CORE, "t ty"),
    ("d", X, CORE, "d dy"),
    ("k", X, CORE, "ky kw"),
    ("g", X, CORE, "gy gw"),
    ("v", X, CORE, "v"),
)
# N before m, p and b is said as m: labelled so, but as ambiguous.
JAPANESE |= table_of(("m", "m", AMBIGUOUS, "N_m"))
LABIAL = frozenset({"m", "my", "p", "py", "b", "by"})
