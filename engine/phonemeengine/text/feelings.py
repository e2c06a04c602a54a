"""What a text says of feeling: directions such as ``[smile]``, emoji and tags, and how good or bad its words are."""

import math
import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import pairwise
from pathlib import Path

from phonemeengine.errors import TextError, remedy
from phonemeengine.storage.strict_table import StrictTable, load_text, parse_toml
from phonemeengine.text.cleaning import sentences_of

FORMAT = "phonemeanalyser feelings 1"
SHIPPED = Path(__file__).resolve().parent / "feelings.toml"
NEUTRAL = "neutral"
EMOJI_SHARE, STYLE_SHARE = 0.6, 0.6
"""How far an emoji, and a tag that says no degree, is shown."""
TURNED, STRONGER, EXCLAIMED, EMPHASISED = -0.7, 1.4, 1.25, 1.4
"""Factors of a word behind a negation, or one that adds to it; of a sentence with an exclamation mark; of a word in
capitals or between stars."""
REACH = 3
"""Words behind a negation that it turns around."""

_BRACKET = re.compile(r"\[\s*([^\[\]\n]{1,60})\]")
_STYLE = re.compile(
    r"<(?P<end>/)?(?:mstts:express-as|express-as|amazon:emotion)\b(?P<about>[^<>]{0,200})>", re.IGNORECASE
)
_ATTRIBUTE = re.compile(r"(style|name|styledegree|intensity)\s*=\s*[\"']([^\"']{1,30})[\"']", re.IGNORECASE)
_INTENSITIES = {"low": 0.3, "medium": 0.6, "high": 1.0}
_ENTRY = re.compile(r"([^\W\d_]+)(?:\s+(\S+))?")
_EMPHASIS = re.compile(r"<emphasis\b(?![^<>]*\b(?:none|reduced)\b)[^<>]{0,60}>", re.IGNORECASE)
_TAG = re.compile(r"<[^<>]{1,200}>")
_WORD = re.compile(r"(?P<mark>[*_]{1,2})?(?P<word>[^\W\d_]+(?:['’][^\W\d_]+)?)")
_HAN = re.compile("[\u3400-\u9fff]+")


@dataclass(frozen=True)
class FeltPassage:
    """A feeling from a place of a text on, up to the next.

    Attributes
    ----------
    offset : the place, characters from the beginning.
    shares : how far expressions are shown, 0..1, by name.
    directed : whether a direction says so, and not the words.
    """

    offset: int
    shares: Mapping[str, float]
    directed: bool = False


@dataclass(frozen=True)
class FeelingWords:
    """The words of a language by what they say of feeling, case-folded.

    Attributes
    ----------
    values : how good, -1..1, what a word names is; a star at its end stands for any ending.
    negations, stronger : words that turn others around, and that add to them.
    """

    values: Mapping[str, float]
    negations: frozenset[str] = frozenset()
    stronger: frozenset[str] = frozenset()

    @cached_property
    def known(self) -> tuple[str, ...]:
        """All words, the longest first."""
        return tuple(sorted({*self.values, *self.negations, *self.stronger}, key=len, reverse=True))

    def value_of(self, word: str) -> float:
        """Return how good what a word names is; 0 for one that is not known."""
        known = self.values.get(word)
        starts = (self.values.get(f"{word[:k]}*") for k in range(len(word), 1, -1))
        return known if known is not None else next((value for value in starts if value is not None), 0.0)


@dataclass(frozen=True)
class FeelingLexicon:
    """What directions, emoji and words say of feeling.

    Attributes
    ----------
    names, emoji : the expressions that they stand for.
    words : by language, as espeak-ng calls it without its region.
    """

    names: Mapping[str, str]
    emoji: Mapping[str, str]
    words: Mapping[str, FeelingWords]


@cache
def shipped_feelings() -> FeelingLexicon:
    """Return the lexicon that ships with the program: English, German and Chinese."""
    return load_feelings(SHIPPED)


def load_feelings(path: str | os.PathLike[str]) -> FeelingLexicon:
    """Read a lexicon of feelings from a TOML file; see ``feelings.toml`` for an example.

    Raises
    ------
    TextError : the file cannot be read, or has nonsense in it; the message names the file.
    """
    return load_text(path, "feelings (.toml)", TextError, _lexicon_in)


def _lexicon_in(text: str) -> FeelingLexicon:
    top = parse_toml(text, "a file of feelings", FORMAT, TextError)
    top.check_keys(("names", "emoji", "words"), ("notes",))
    names, emoji = (
        {part: name for name in table.entries for part in split(table.value(name, str))}
        for table, split in ((top.table("names"), str.split), (top.table("emoji"), list))
    )
    return FeelingLexicon(
        names, emoji, {name: _words_in(table) for name, table in top.table("words").tables_by_name()}
    )


def _words_in(table: StrictTable) -> FeelingWords:
    values: dict[str, float] = {}
    for key in table.entries:
        if key in {"negations", "stronger"}:
            continue
        try:
            value = float(key)
        except ValueError:
            value = math.nan
        if not -1 <= value <= 1:
            raise TextError(f"words are good or bad by -1..1, found {key[:20]!r}; correct it")
        for word in table.value(key, str).casefold().split():
            if values.setdefault(word, value) * value < 0:
                raise TextError(f"{word[:30]!r} is called both good and bad; name it once")
    negations, stronger = (
        frozenset(table.value(key, str).casefold().split()) if key in table.entries else frozenset()
        for key in ("negations", "stronger")
    )
    return FeelingWords(values, negations, stronger)


def passages_of(text: str, language: str, lexicon: FeelingLexicon | None = None) -> list[FeltPassage]:
    """Return what a text says of feeling, in order.

    A direction stays up to the next one, ``[neutral]``, the end of its tag or the end of its line; where there is
    none, each sentence shows how good or bad its words are.

    Parameters
    ----------
    language : of the words, such as ``en-us``; one that the lexicon lacks has directions alone.

    Raises
    ------
    TextError : a direction names no feeling or no share that there is, or two at one place contradict each other.
    """
    lexicon = lexicon or shipped_feelings()
    directions = _checked([*_directions_in(text, lexicon)], text)
    words = lexicon.words.get(language.partition("-")[0].lower(), FeelingWords({}))
    found, at = [], 0
    for sentence in sentences_of(text) if words.values else ():
        at = max(text.find(sentence, at), at)
        if not _direction_at(directions, at, text):
            found.append(FeltPassage(at, _shares_of(_value_of(sentence, words))))
        at += len(sentence)
    return sorted([*found, *directions], key=lambda passage: passage.offset)


def _direction_at(directions: list[FeltPassage], place: int, text: str) -> bool:
    before = [passage for passage in directions if passage.offset <= place + 1]
    return bool(before) and bool(before[-1].shares) and "\n" not in text[before[-1].offset : place].rstrip()


def _directions_in(text: str, lexicon: FeelingLexicon) -> Iterator[FeltPassage]:
    for bracket in _BRACKET.finditer(text):
        if (shares := _shares_in(bracket[1], lexicon)) is not None:
            yield from _up_to_line_end(bracket.start(), shares, text)
    for place, character in enumerate(text):
        if character in lexicon.emoji:
            yield from _up_to_line_end(place, {lexicon.emoji[character]: EMOJI_SHARE}, text)
    for tag in _STYLE.finditer(text):
        yield FeltPassage(tag.start(), {} if tag["end"] else _style_of(tag["about"], lexicon), True)


def _up_to_line_end(start: int, shares: Mapping[str, float], text: str) -> Iterator[FeltPassage]:
    yield FeltPassage(start, shares, True)
    if shares and (end := text.find("\n", start)) >= 0:
        yield FeltPassage(end, {}, True)


def _shares_in(words: str, lexicon: FeelingLexicon) -> Mapping[str, float] | None:
    """Return what a remark in brackets directs; None where it is another stage direction."""
    shares: dict[str, float] = {}
    for part in words.split(","):
        entry = _ENTRY.fullmatch(part.strip())
        name = lexicon.names.get(entry[1].casefold()) if entry else None
        if entry is None or (name is None and not _is_number(entry[2] or "")):
            return None
        if name is None:
            raise TextError(f"[{words}]: there is no feeling {entry[1]!r}; {remedy(entry[1], lexicon.names)}")
        share = float(entry[2]) if _is_number(entry[2] or "") else 1.0 if entry[2] is None else math.nan
        if not 0 <= share <= 1:
            raise TextError(f"[{words}]: a feeling is shown by 0..1, found {entry[2]}; correct it")
        if shares.setdefault(name, share) != share:
            raise TextError(f"[{words}]: {name} is asked for by {shares[name]:g} and by {share:g}; keep one")
    if NEUTRAL in shares and len(shares) > 1:
        raise TextError(f"[{words}]: neutral goes with no other feeling; leave one of them out")
    return {name: share for name, share in shares.items() if name != NEUTRAL}


def _style_of(about: str, lexicon: FeelingLexicon) -> Mapping[str, float]:
    told = {key.lower(): value for key, value in _ATTRIBUTE.findall(about)}
    style = told.get("style", told.get("name", "")).casefold()
    if style not in lexicon.names:
        raise TextError(f"a tag asks for the feeling {style[:30]!r}; {remedy(style, lexicon.names)}")
    degree = told.get("styledegree", "")
    share = (
        min(float(degree) / 2, 1.0)
        if _is_number(degree)
        else _INTENSITIES.get(told.get("intensity", ""), STYLE_SHARE)
    )
    return {lexicon.names[style]: max(share, 0.0)} if lexicon.names[style] != NEUTRAL else {}


def _checked(directions: list[FeltPassage], text: str) -> list[FeltPassage]:
    """Return directions in order; of several at one place the last counts, and contradictions are refused."""
    directions.sort(key=lambda passage: passage.offset)
    for one, other in pairwise(directions):
        between = _BRACKET.sub(" ", text[one.offset : other.offset])
        names = (sorted(one.shares), sorted(other.shares))
        if one.shares and other.shares and names[0] != names[1] and not any(map(str.isalnum, between)):
            first, second = (", ".join(each) for each in names)
            raise TextError(
                f"{first} and {second} are asked for at one place; keep one, or write [{first} 0.5, {second} 0.5]"
            )
    return directions


def _value_of(sentence: str, words: FeelingWords) -> float:
    spoken = _TAG.sub(" ", _EMPHASIS.sub("*", _BRACKET.sub(" ", sentence)))
    tokens = [*_tokens_of(spoken, words)]
    total, turned, more = 0.0, 0, 1.0
    for mark, word in tokens:
        folded = word.casefold()
        value = words.value_of(folded) if folded not in words.negations else 0.0
        if value:
            strength = EMPHASISED if mark or (word.isupper() and len(word) > 2) else 1.0
            total += value * strength * more * (TURNED if turned > 0 else 1.0)
        turned = REACH if folded in words.negations else turned - 1
        more = STRONGER if folded in words.stronger else 1.0
    if "!" in spoken or "！" in spoken:
        total *= EXCLAIMED
    return math.tanh(total)


def _tokens_of(sentence: str, words: FeelingWords) -> Iterator[tuple[str, str]]:
    """Return the words of a sentence with the marks of emphasis before them; Chinese ones are the longest known."""
    for found in _WORD.finditer(sentence):
        word = found["word"].replace("’", "'")
        if not _HAN.match(word):
            yield found["mark"] or "", word
            continue
        k = 0
        while k < len(word):
            best = next((entry for entry in words.known if word.startswith(entry, k)), word[k])
            yield found["mark"] or "", best
            k += len(best)


def _shares_of(value: float) -> Mapping[str, float]:
    """Return how far a face shows how good or bad something is."""
    return {"smile": value} if value > 0 else {"sorrow": -value} if value < 0 else {}


def _is_number(words: str) -> bool:
    return re.fullmatch(r"-?\d+(?:\.\d+)?", words) is not None
