"""What of a text is spoken, and in which clauses; notation, emoji and the like are left out, with a note.

Notation is emphasis, tags, entities, speakers' names and stage directions.
"""

import html
import re
import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from pathlib import Path

from phonemeengine.errors import TextError
from phonemeengine.storage.files import printable
from phonemeengine.storage.strict_table import load_text, parse_toml

# Sentences and clauses: how a text is cut, so that a long one need never be held, or be spoken, as a whole.

LONGEST = 400
"""Characters of a clause at most; a longer one is cut between words, or where there are none, anywhere."""

_WIDE = "。！？；：，、…—"
_ASCII = ".,;:!?"
_HAN = "\u3400-\u9fff"
_CLOSING = "»«”“’‘」』）》\"')\\]"
_WIDE_CLOSING = "”’」』）》\"')\\]"
_MARKS_BEHIND_HAN = rf"(?:(?<=[{_HAN}])[{_ASCII}]+)?"
# Texts, which are compiled when a text is first cut: that takes longer than all else in this module.
_PIECE = (
    rf"\n|(?:[^\s{_WIDE}](?<![{_HAN}](?=[{_ASCII}]))){{0,{LONGEST - 1}}}[^\s{_WIDE}]"
    rf"{_MARKS_BEHIND_HAN}[{_WIDE}]*[{_WIDE_CLOSING}]*|[{_WIDE}]+[{_WIDE_CLOSING}]*"
)
_SENTENCE_END = rf"[.!?…。！？][{_CLOSING}]*$"
_CLAUSE_END = rf"[.!?…。！？,;:；：，、—–][{_CLOSING}]*$"
_ABBREVIATION = r"(?i)\W*(?:[^\W_]|\d+|mrs?|ms|dr|prof|st|hr|fr|nr|vs|\w+\.\w+)\."
"""What a full stop ends that is no sentence: an initial, an ordinal number, a title."""


def sentences_of(text: str) -> Iterator[str]:
    """Return the sentences of a text, in order; a line ends one, too."""
    return _cut(text, _SENTENCE_END)


def clauses_of(text: str) -> Iterator[str]:
    """Return the clauses of a text, in order: what stands between marks."""
    return _cut(text, _CLAUSE_END)


def tokens_of(clause: str) -> list[str]:
    """Return the words of a clause with the marks around them; marks of full width end one without a space."""
    return [piece for piece in re.findall(_PIECE, clause) if piece != "\n"]


def _cut(text: str, end: str) -> Iterator[str]:
    start = stop = 0
    for piece in re.finditer(_PIECE, text):
        word = piece.group()
        if word == "\n" or piece.end() - start > LONGEST:
            yield from _filled(text[start:stop])
            start = piece.start()
        stop = piece.end()
        if re.search(end, word) and not _is_abbreviation(word, text, stop):
            yield from _filled(text[start:stop])
            start = stop
    yield from _filled(text[start:])


def _filled(part: str) -> Iterator[str]:
    if part := part.strip():
        yield part


def _is_abbreviation(word: str, text: str, stop: int) -> bool:
    """Return whether a word's full stop is not the end of a sentence."""
    following = text[stop : stop + 2].strip(" ")
    return bool(following.islower() or re.fullmatch(_ABBREVIATION, word)) and word.endswith(".") and following != ""


_EMOJI = re.compile(
    "[\U0001f000-\U0001fbff\u2300-\u23ff\u25a0-\u27bf\u2b00-\u2bff\u20e3]"
    "[\U0001f000-\U0001fbff\u2300-\u23ff\u25a0-\u27bf\u2b00-\u2bff\u20e3\u200d\ufe0e\ufe0f\U000e0020-\U000e007f]*"
)
_SILENT = frozenset("\u00ad\u200b\u2060\ufeff\u200e\u200f\ufe0e\ufe0f")
"""Characters of layout, which change nothing that is spoken."""
_UNSPEAKABLE = frozenset({"Cc", "Cf", "Cs", "Co", "Cn"})
_JOINERS = frozenset("\u200c\u200d")
"""Of Persian and the scripts of India."""
_SAMPLE = 40
_SHOWN = 4
_LONGEST_SHOWN = 30


@dataclass(frozen=True)
class SpeakableText:
    """A text that a voice can speak.

    Attributes
    ----------
    text : what is left.
    notes : remarks for the user on what was taken out, a sentence each; mostly none.
    """

    text: str
    notes: tuple[str, ...] = ()


def speakable(text: str, language: str | None = None, *, literal: bool = False) -> SpeakableText:
    """Return what of a text is spoken; line ends become ``\\n``.

    Parameters
    ----------
    text : of any length.
    language : by which the notation of scripts is known, such as ``de``; see `spoken_part`.
    literal : take the notation of scripts as words, too.

    Raises
    ------
    TextError : nothing is left.
    """
    lines = text.replace("\r\n", "\n").replace("\r", "\n").replace("\t", " ")
    unspoken: tuple[str, ...] = ()
    if not literal:
        part = spoken_part(lines, language or "")
        lines, unspoken = part.text, part.unspoken
    without_emoji, n_emoji = _EMOJI.subn(" ", lines)
    unspeakable, kept = _unspeakable_in(without_emoji), without_controls(without_emoji)
    n_others = sum(map(without_emoji.count, unspeakable - _SILENT))
    n_brackets = kept.count("[[")
    kept = re.sub(r"\[{2,}", "[", kept)
    if not any(c.isalnum() for c in kept):
        raise TextError(f"there is no word to speak in {_shown(text)}; write some")
    remarks = (
        (n_emoji, "emoji have no sound and are left out"),
        (n_others, "control characters and the like have no sound and are left out"),
        (n_brackets, "[[ would ask for phonemes and is read as ["),
    )
    notes = [f"{words} ({n} x)" for n, words in remarks if n]
    if unspoken:
        notes.insert(0, f"names and directions of the script are not spoken: {_listed(unspoken)}")
    return SpeakableText(kept, tuple(notes))


def _listed(parts: Sequence[str]) -> str:
    different = list(dict.fromkeys(parts))
    more = f" and {len(different) - _SHOWN} more" if len(different) > _SHOWN else ""
    return ", ".join(printable(part[:_LONGEST_SHOWN]) for part in different[:_SHOWN]) + more


def without_controls(text: str) -> str:
    """Return a text without control characters and those of layout; what stood beside them stands side by side."""
    return text.translate(dict.fromkeys(map(ord, _unspeakable_in(text))))


def _unspeakable_in(text: str) -> set[str]:
    return set(filter(_is_unspeakable, set(text)))  # each character once: a text may be long


def _is_unspeakable(character: str) -> bool:
    if character in _SILENT:
        return True
    return unicodedata.category(character) in _UNSPEAKABLE and character not in _JOINERS and character != "\n"


def _shown(text: str) -> str:
    if not text.strip():
        return "an empty text"
    return repr(text[:_SAMPLE]) + ("…" if len(text) > _SAMPLE else "")


FORMAT = "phonemeanalyser notation 1"
SHIPPED = Path(__file__).resolve().parent / "notation.toml"
"""The words by which notation is known, by language."""
EVERYWHERE = "en"
"""The language whose words count in all others, too."""

_ALIAS = r"(?i)<sub\s[^<>]{0,200}?\balias\s*=\s*[\"']([^\"'<>]{1,200})[\"'][^<>]{0,200}>[^<>]{0,200}</sub\s*>"
_PARTING_TAG = r"(?i)</?(?:br|p|s|li|div|break|speak|audio|mark)\b[^<>]{0,400}>"
_TAG = r"(?s)<!--.{0,2000}?-->|</?[^\W\d_][^<>]{0,400}>|<[?!][^<>]{0,400}>"
_ENTITY = r"&(?:#\d{1,7}|#[xX][0-9a-fA-F]{1,6}|[A-Za-z][A-Za-z0-9]{1,31});"
_EMPHASIS = (
    r"(?<![\d*\\])(\*{1,3})(?=[^\s*])([^*\n]{1,1000})(?<=[^\s*])\1(?![\d*])",
    r"(?<![\w\\])(_{1,3})(?=[^\s_])([^_\n]{1,1000})(?<=[^\s_])\1(?!\w)",
    r"(?<![\w~])(~~|`)(?=[^\s~`])([^~`\n]{1,1000})(?<=[^\s~`])\1(?![\w~])",
)
_BULLET = r"(?m)^[ ]{0,8}(?:[*•>]|#{1,6})[ ]+"
_SQUARE = r"(?<!\[)\[[^\[\]\n]{1,400}\](?!\])|［[^［］\n]{1,400}］"
_ROUND = r"[(（]([^()（）\n]{1,400})[)）]"
_NAME = (
    r"(?m)^[ ]*(?P<name>[^\W\d_][^\s:：()（）.!?;,\"„“«»]{0,30}\.?(?:[ ][^\s:：()（）.!?;,\"„“«»]{1,30}\.?){0,3})"
    r"[ ]*(?:[(（][^()（）\n]{1,100}[)）][ ]*)?(?::(?=\s|$)|：)[ ]*(?:[(（][^()（）\n]{1,200}[)）])?"
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
    text = re.sub(_TAG, "", re.sub(_PARTING_TAG, " ", re.sub(_ALIAS, r"\1", text)))
    unspoken = [*re.finditer(_SQUARE, text)]
    text = re.sub(_BULLET, "", _without(text, unspoken))
    for mark in _EMPHASIS:
        text = re.sub(mark, r"\2", text)
    names = _names_in(text, notation)
    text = _without(text, names)
    directions = [found for found in re.finditer(_ROUND, text) if _is_direction(found[1], notation)]
    text = _without(text, directions)
    left_out = (found[0].strip(" :：") for found in (*names, *unspoken, *directions))
    return SpokenPart(re.sub(_ENTITY, lambda entity: html.unescape(entity[0]), text), tuple(left_out))


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
    is_dialogue = len(lines) > 1 and all(re.match(_NAME, line) for line in lines)
    return [found for found in re.finditer(_NAME, text) if _is_name(found["name"], notation, is_dialogue=is_dialogue)]


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
