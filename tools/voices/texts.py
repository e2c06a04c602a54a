"""Endless, reproducible utterances: prose sentences and, every fourth time, a list of words rich in rare sounds."""

import functools
import random
import re
from collections.abc import Iterator
from pathlib import Path

from tools.voices.sources import SOURCES, blocks, word_lines

SHORTEST, LONGEST = 25, 110  # characters of an utterance
SHORTEST_DENSE, LONGEST_DENSE = 8, 45  # of a script that writes syllables or words with one sign
DENSE = frozenset({"ja"})
MOST_WORDS = 40000
HIDDEN_ENGLISH = re.compile(r"\b(the|and|with|from|of|is|you)\b", re.IGNORECASE)
END = re.compile(r"(?<=[.!?。！？।])\s*")


def utterances(language: str, seed: str, cache: Path) -> Iterator[str]:
    """Texts without end; the same seed gives the same texts. The cache holds the unpacked packages."""
    chance = random.Random(f"{language}/{seed}")
    prose = list(_sentences(language, cache))
    words, weights = _words(language, cache)
    chance.shuffle(prose)
    while True:
        for _ in range(3):
            if prose:
                yield prose.pop()
        yield _word_list(language, chance.choices(words, weights, k=chance.randint(4, 8)), chance)


@functools.cache
def _sentences(language: str, cache: Path) -> tuple[str, ...]:
    sentences: dict[str, None] = {}
    for block in blocks(SOURCES[language].prose, cache / "packages"):
        for sentence in END.split(block):
            cleaned = _clean(sentence)
            if is_plain(cleaned, language):
                sentences[cleaned] = None
    return tuple(sentences)


def _clean(sentence: str) -> str:
    sentence = re.sub(r"\s+", " ", sentence.replace("´", "'").replace("’", "'").replace("\u00ad", "")).strip()
    return re.sub(r'^[-–—*"„“»«\s]+|["“”»«\s]+$', "", sentence)


def is_plain(sentence: str, language: str) -> bool:
    """Whether the sentence consists of ordinary words of the language, and is neither short nor long."""
    letters = SOURCES[language].letters
    shortest, longest = (SHORTEST_DENSE, LONGEST_DENSE) if language in DENSE else (SHORTEST, LONGEST)
    if not shortest <= len(sentence) <= longest:
        return False
    if not re.fullmatch(rf"[{letters}{letters.upper()} ,.!?;:'。、！？।-]+", sentence):
        return False
    if re.search(r"[.,:;!?-]{2}|\w[.:]\w", sentence) or (language != "en" and HIDDEN_ENGLISH.search(sentence)):
        return False
    return not any(len(word) > 1 and word.isupper() for word in re.findall(r"\w+", sentence))


@functools.cache
def _words(language: str, cache: Path) -> tuple[list[str], list[int]]:
    """Words of the language, and how often each is to be drawn."""
    source = SOURCES[language]
    lines = list(word_lines(source.words, cache / "packages"))
    if not lines:
        text = " ".join(blocks(source.prose, cache / "packages"))
        lines = sorted(set(re.findall(rf"[{source.letters}]+", text.lower())))
    words = [word for word in lines if re.fullmatch(rf"[{source.letters}]{{3,11}}", word)]
    if len(words) > MOST_WORDS:
        words = random.Random(language).sample(words, MOST_WORDS)
    return words, [1 + 2 * len(re.findall(source.rare, word)) if source.rare else 1 for word in words]


def _word_list(language: str, words: list[str], chance: random.Random) -> str:
    comma, blank, end = ("、", "、", "。") if language in DENSE else (", ", " ", ".")
    text = words[0].capitalize()
    for word in words[1:]:
        text += (comma if chance.random() < 0.4 else blank) + word
    return text + end
