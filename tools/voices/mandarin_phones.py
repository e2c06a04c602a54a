"""Mandarin: the phones of syllables written in zhuyin, as letters of the International Phonetic Alphabet."""

from phonemeengine.labels.pinyin import FINALS, onset_and_rime
from tools.voices.classes import AFFRICATE, AMBIGUOUS, CORE, DIPHTHONG, SCH, SIL, SZ, X, table_of

MANDARIN = table_of(
    ("", SIL, CORE, "pau"),
    ("p", "p", CORE, "p pʰ"),
    ("m", "m", CORE, "m"),
    ("f", X, CORE, "f"),
    ("t", X, CORE, "t tʰ"),
    ("n", X, CORE, "n"),
    ("l", X, CORE, "l"),
    ("k", X, CORE, "k kʰ"),
    ("x", X, CORE, "x"),
    ("h", X, AMBIGUOUS, "h"),
    ("ŋ", X, CORE, "ŋ"),
    ("tɕ", SCH, AFFRICATE, "tɕ tɕʰ"),
    ("ɕ", SCH, CORE, "ɕ"),
    ("ʈʂ", SCH, AFFRICATE, "ʈʂ ʈʂʰ"),
    ("ʂ", SCH, CORE, "ʂ"),
    ("ʐ", SCH, AMBIGUOUS, "ʐ"),
    ("ts", SZ, AFFRICATE, "ts tsʰ"),
    ("s", SZ, CORE, "s"),
    ("j", X, AMBIGUOUS, "j"),
    ("w", X, AMBIGUOUS, "w"),
    ("ɥ", X, AMBIGUOUS, "ɥ"),
    ("a", "a", CORE, "a"),
    ("aɪ", "a", DIPHTHONG, "aɪ"),
    ("aʊ", "a", DIPHTHONG, "aʊ"),
    ("ɛ", "e", CORE, "ɛ"),
    ("eɪ", "e", DIPHTHONG, "eɪ"),
    ("ə", "e", AMBIGUOUS, "ə ɚ ɤ"),
    ("i", "i", CORE, "i"),
    ("ɨ", "i", AMBIGUOUS, "ɨ"),
    ("o", "o", CORE, "o"),
    ("oʊ", "o", DIPHTHONG, "oʊ"),
    ("u", "u", CORE, "u"),
    ("ʊ", "u", AMBIGUOUS, "ʊ"),
    ("y", "u", AMBIGUOUS, "y"),
)
INITIALS = {
    **dict(zip("ㄅㄆㄇㄈㄉㄊㄋㄌㄍㄎㄏ", ("p", "pʰ", "m", "f", "t", "tʰ", "n", "l", "k", "kʰ", "x"), strict=True)),
    **dict(zip("ㄐㄑㄒㄓㄔㄕㄖㄗㄘㄙ", ("tɕ", "tɕʰ", "ɕ", "ʈʂ", "ʈʂʰ", "ʂ", "ʐ", "ts", "tsʰ", "s"), strict=True)),
}
"""By a letter of zhuyin, the phone of an initial."""
SYLLABIC = frozenset("ㄓㄔㄕㄖㄗㄘㄙ")
"""Initials that are syllables of their own, with the vowel of *zi* and *shi*."""
SIMPLE = {
    **dict(zip("ㄚㄛㄜㄝㄞㄟㄠㄡ", ("a", "o", "e", "ê", "ai", "ei", "ao", "ou"), strict=True)),
    **dict(zip("ㄢㄣㄤㄥㄦㄧㄨㄩ", ("an", "en", "ang", "eng", "er", "i", "u", "ü"), strict=True)),
}
RIMES = {
    **SIMPLE,
    **{medial + vowel: SIMPLE[medial] + SIMPLE[vowel] for medial in "ㄧㄨㄩ" for vowel in "ㄚㄛㄞㄟㄠㄡㄢㄣㄤㄥ"},
    "ㄧㄝ": "ie",
    "ㄩㄝ": "üe",
    "ㄧㄣ": "in",
    "ㄧㄥ": "ing",
    "ㄨㄥ": "ong",
    "ㄩㄣ": "ün",
    "ㄩㄥ": "iong",
}
"""By letters of zhuyin, a final in full pinyin."""


def phones_of(zhuyin: str) -> tuple[str, ...]:
    """Return the phones of a syllable in zhuyin without its tone; none of what is no syllable, such as a lone ㄅ."""
    initial = zhuyin[0] if zhuyin[0] in INITIALS else ""
    rime = zhuyin.removeprefix(initial)
    if not rime:
        return (INITIALS[initial], "ɨ") if initial in SYLLABIC else ()
    final = "ueng" if zhuyin == "ㄨㄥ" else RIMES.get(rime)
    if final not in FINALS:
        return ()
    onset, vowel = onset_and_rime(final)
    return (*([INITIALS[initial]] if initial else []), *onset, *vowel)
