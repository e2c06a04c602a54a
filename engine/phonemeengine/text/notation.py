"""The notation of scripts, which is not spoken: emphasis, tags, entities, speakers' names, stage directions."""

import html
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from pathlib import Path

from phonemeengine.errors import TextError
from phonemeengine.storage.strict_table import load_text, parse_toml

FORMAT = "phonemeanalyser notation 1"
SHIPPED = Path(__file__).resolve().parent / "notation.toml"
"""The words by which notation is known, by language."""
EVERYWHERE = "en"
"""The language whose words count in all others, too."""

_ALIAS = re.compile(
    r"<sub\s[^<>]{0,200}?\balias\s*=\s*[\"']([^\"'<>]{1,200})[\"'][^<>]{0,200}>[^<>]{0,200}</sub\s*>", re.IGNORECASE
)
_PARTING_TAG = re.compile(r"</?(?:br|p|s|li|div|break|speak|audio|mark)\b[^<>]{0,400}>", re.IGNORECASE)
_TAG = re.compile(r"<!--.{0,2000}?-->|</?[^\W\d_][^<>]{0,400}>|<[?!][^<>]{0,400}>", re.DOTALL)
_ENTITY = re.compile(r"&(?:#\d{1,7}|#[xX][0-9a-fA-F]{1,6}|[A-Za-z][A-Za-z0-9]{1,31});")
_EMPHASIS = (
    re.compile(r"(?<![\d*\\])(\*{1,3})(?=[^\s*])([^*\n]{1,1000})(?<=[^\s*])\1(?![\d*])"),
    re.compile(r"(?<![\w\\])(_{1,3})(?=[^\s_])([^_\n]{1,1000})(?<=[^\s_])\1(?!\w)"),
    re.compile(r"(?<![\w~])(~~|`)(?=[^\s~`])([^~`\n]{1,1000})(?<=[^\s~`])\1(?![\w~])"),
)
_BULLET = re.compile(r"^[ ]{0,8}(?:[*•>]|#{1,6})[ ]+", re.MULTILINE)
_SQUARE = re.compile(r"(?<!\[)\[[^\[\]\n]{1,400}\](?!\])|［[^［］\n]{1,400}］")
_ROUND = re.compile(r"[(（]([^()（）\n]{1,400})[)）]")
_NAME = re.compile(
    r"^[ ]*(?P<name>[^\W\d_][^\s:：()（）.!?;,\"„“«»]{0,30}\.?(?:[ ][^\s:：()（）.!?;,\"„“«»]{1,30}\.?){0,3})"
    r"[ ]*(?:[(（][^()（）\n]{1,100}[)）][ ]*)?(?::(?=\s|$)|：)[ ]*(?:[(（][^()（）\n]{1,200}[)）])?",
    re.MULTILINE,
)


@dataclass(frozen=True)
class Notation:
    """By which words the notation of a language's scripts is known.

    Attributes
    ----------
    directions : what begins or ends a stage direction in round brackets, case-folded.
    spoken : what is no speaker's name before a colon, case-folded.
    particles : words within names that are written small.
    """

    directions: frozenset[str]
    spoken: frozenset[str]
    particles: frozenset[str]


@dataclass(frozen=True)
class SpokenPart:
    """What of a script is spoken.

    Attributes
    ----------
    text : without notation.
    unspoken : the names and directions that were left out.
    """

    text: str
    unspoken: tuple[str, ...] = ()


def spoken_part(text: str, language: str = "") -> SpokenPart:
    """Return what of a script is spoken, line by line.

    Parameters
    ----------
    text : its lines end with ``\\n``.
    language : the voice of espeak-ng that reads it, such as ``en-us``; empty where it is not known.
    """
    notation = _notation_of(language.partition("-")[0].lower())
    text = _TAG.sub("", _PARTING_TAG.sub(" ", _ALIAS.sub(r"\1", text)))
    unspoken = [*_SQUARE.finditer(text)]
    text = _BULLET.sub("", _without(text, unspoken))
    for mark in _EMPHASIS:
        text = mark.sub(r"\2", text)
    names = _names_in(text, notation)
    text = _without(text, names)
    directions = [found for found in _ROUND.finditer(text) if _is_direction(found[1], notation)]
    text = _without(text, directions)
    left_out = (found[0].strip(" :：") for found in (*names, *unspoken, *directions))
    return SpokenPart(_ENTITY.sub(lambda entity: html.unescape(entity[0]), text), tuple(left_out))


def _without(text: str, parts: Sequence[re.Match[str]]) -> str:
    """Return a text without some parts of it, each of which leaves a space."""
    kept, end = [], 0
    for part in parts:
        kept.append(text[end : part.start()])
        end = part.end()
    return " ".join([*kept, text[end:]])


def _names_in(text: str, notation: Notation) -> list[re.Match[str]]:
    """Return the speakers' names that begin the lines of a text, with the directions that follow them."""
    lines = [line for line in text.split("\n") if line.strip()]
    is_dialogue = len(lines) > 1 and all(map(_NAME.match, lines))
    return [found for found in _NAME.finditer(text) if _is_name(found["name"], notation, is_dialogue=is_dialogue)]


def _is_name(words: str, notation: Notation, *, is_dialogue: bool) -> bool:
    """Return whether words before a colon name a speaker; where there are no capitals, only in a dialogue."""
    first, *others = words.split()
    if {first.casefold().rstrip("."), words.casefold()} & notation.spoken:
        return False
    if first.lower() == first.upper():
        return is_dialogue
    return first[0].isupper() and all(
        not word[0].isalpha() or word[0].isupper() or word in notation.particles for word in others
    )


def _is_direction(remark: str, notation: Notation) -> bool:
    """Return whether a remark in round brackets is a stage direction."""
    words = [word.strip(".,;:!?… ").casefold() for word in remark.split()]
    return bool(words) and bool({words[0], words[-1], " ".join(words)} & notation.directions)


@lru_cache(maxsize=16)
def _notation_of(language: str) -> Notation:
    parse = partial(parse_toml, name="notation", form=FORMAT, error=TextError)
    top = load_text(SHIPPED, "notation (.toml)", TextError, parse)
    tables = [top.table(name).entries for name in dict.fromkeys((EVERYWHERE, language)) if name in top]
    directions, spoken = (
        frozenset(word for table in tables for word in table[key]) for key in ("directions", "spoken")
    )
    return Notation(directions, spoken, frozenset(top.value("particles", list)))
