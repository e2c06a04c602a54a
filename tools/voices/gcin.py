"""A speaker of Mandarin, the recordings 3.ogg of gcin-voice: a syllable each, whose zhuyin is its folder's name.

The recordings 5.ogg are another speaker's, by which recognisers are judged: they are not unpacked.
"""

from collections.abc import Iterator
from pathlib import Path

from phonemeengine.labels.pinyin import FINALS, onset_and_rime
from tools.voices.aligner import PAUSE, aligned
from tools.voices.classes import AFFRICATE, AMBIGUOUS, CORE, DIPHTHONG, SCH, SIL, SZ, X, table_of
from tools.voices.labels import Segment
from tools.voices.packages import RECORDINGS
from tools.voices.recordings import PEOPLE, decoded, is_speech
from tools.voices.voice import Voice
from tools.voices.writing import Speaker, Utterance

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


FOLDER, FILE = "usr/share/gcin-voice/ogg", "3.ogg"
LICENCE = "GPL-3 or LGPL-3 (Edward Der-Hua Liu)"
STOPS = ("p", "pʰ", "t", "tʰ", "k", "kʰ", "tɕ", "tɕʰ", "ʈʂ", "ʈʂʰ", "ts", "tsʰ")
CLOSURE = 0.03  # s for which the mouth is closed at the least before a stop bursts, after a pause without a sound
BURST = 0.02  # s of a pʰ
BREATH = "h"


def voices(cache: Path) -> list[Voice]:
    """The speaker of the recordings 3.ogg."""
    speaker = Speaker("gcin", "3", "zh-TW", "", PEOPLE, LICENCE, RECORDINGS["gcin"], "mandarin")
    return [Voice(speaker, MANDARIN, lambda: _utterances(cache))]


def _utterances(cache: Path) -> Iterator[Utterance]:
    """Syllables with the times of their phones; without any where the name does not tell what is said."""
    paths = sorted((cache / "packages" / RECORDINGS["gcin"] / FOLDER).glob(f"*/{FILE}"))
    read = {path.parent.name: decoded(path) for path in paths}
    known = {name: phones for name in read if (phones := phones_of(name.rstrip("12345"))) and is_speech(*read[name])}
    (sample_rate,) = {read[name][1] for name in known}
    found = aligned([read[name][0] for name in known], sample_rate, [*known.values()])
    segments = dict(zip(known, found, strict=True))
    for name, (sound, its_rate) in read.items():
        if is_speech(sound, its_rate):
            yield Utterance(sound, its_rate, with_closures(segments.get(name, [])), name)


def with_closures(segments: list[Segment]) -> list[Segment]:
    """The segments, with a stop after a pause beginning before its burst; after that of pʰ the lips are open."""
    found = [*segments]
    if len(found) > 1 and found[0].phone == PAUSE and found[1].phone in STOPS:
        start = max(0.0, found[0].end - CLOSURE)
        found[:2] = [found[0]._replace(end=start), found[1]._replace(start=start)]
    for k, (start, end, phone) in enumerate(segments):
        if phone == "pʰ" and end - start > BURST:
            found[k : k + 1] = [Segment(found[k].start, start + BURST, phone), Segment(start + BURST, end, BREATH)]
    return found
