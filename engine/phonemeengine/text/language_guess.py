"""In which language a text probably is: by its script, and by the most frequent short words of each language."""

import re
import tomllib
from collections import Counter
from functools import cache, lru_cache
from pathlib import Path

SCRIPTS = {
    "ja": r"[\u3040-\u30ff]",
    "ko": r"[\uac00-\ud7af]",
    "cmn": r"[\u3400-\u9fff]",
    "el": r"[\u0370-\u03ff]",
    "he": r"[\u0590-\u05ff]",
    "ar": r"[\u0600-\u06ff]",
    "hi": r"[\u0900-\u097f]",
    "th": r"[\u0e00-\u0e7f]",
    "uk": r"[іїєґІЇЄҐ]",
    "ru": r"[\u0400-\u04ff]",
}
"""Letters that tell a language, in the order in which they are looked for: Japanese has Chinese characters, too."""
LOOKED_AT = 4000
"""Characters of a text that are looked at."""
LEAST_WORDS, LEAST_LEAD = 2, 1.25
"""Different frequent words that a language needs, and how many times as many as the next language has."""


def guess_language(text: str) -> str:
    """Return the tag of the language that a text is probably written in; empty where nothing tells it.

    A guess is shown to the user before it is used: languages as near as Danish and Norwegian are not told apart, and
    short texts tell nothing.
    """
    return _guessed(text[:LOOKED_AT])


@lru_cache(1)  # at each key that is pressed, most often behind what is looked at
def _guessed(part: str) -> str:
    words = Counter(re.findall(r"[^\W\d_]+", part.lower()))
    n_letters = sum(n * len(word) for word, n in words.items())
    for tag, letters in () if part.isascii() else SCRIPTS.items():
        if 5 * len(re.findall(letters, part)) > n_letters:
            return tag
    found = {tag: [words[word] for word in frequent if word in words] for tag, frequent in _frequent().items()}
    counts = Counter({tag: sum(each) for tag, each in found.items() if len(each) >= LEAST_WORDS})
    if not counts:
        return ""
    (best, most), *others = counts.most_common(2)
    return best if not others or most >= LEAST_LEAD * others[0][1] else ""


@cache
def _frequent() -> dict[str, frozenset[str]]:
    path = Path(__file__).with_name("language_words.toml")
    table = tomllib.loads(path.read_text(encoding="utf-8"))
    return {tag: frozenset(words.split()) for tag, words in table["words"].items()}
