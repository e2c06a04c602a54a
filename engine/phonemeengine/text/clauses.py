"""Sentences and clauses: how a text is cut, so that a long one need never be held, or be spoken, as a whole."""

import re
from collections.abc import Iterator

LONGEST = 400
"""Characters of a clause at most; a longer one is cut between words, or where there are none, anywhere."""

_WIDE = "。！？；：，、…—"
_ASCII = ".,;:!?"
_HAN = "\u3400-\u9fff"
_CLOSING = "»«”“’‘」』）》\"')\\]"
_WIDE_CLOSING = "”’」』）》\"')\\]"
_MARKS_BEHIND_HAN = rf"(?:(?<=[{_HAN}])[{_ASCII}]+)?"
_PIECE = re.compile(
    rf"\n|(?:[^\s{_WIDE}](?<![{_HAN}](?=[{_ASCII}]))){{0,{LONGEST - 1}}}[^\s{_WIDE}]"
    rf"{_MARKS_BEHIND_HAN}[{_WIDE}]*[{_WIDE_CLOSING}]*|[{_WIDE}]+[{_WIDE_CLOSING}]*"
)
_SENTENCE_END = re.compile(rf"[.!?…。！？][{_CLOSING}]*$")
_CLAUSE_END = re.compile(rf"[.!?…。！？,;:；：，、—–][{_CLOSING}]*$")
_ABBREVIATION = re.compile(r"\W*(?:[^\W_]|\d+|mrs?|ms|dr|prof|st|hr|fr|nr|vs|\w+\.\w+)\.", re.IGNORECASE)
"""What a full stop ends that is no sentence: an initial, an ordinal number, a title."""


def sentences_of(text: str) -> Iterator[str]:
    """Return the sentences of a text, in order; a line ends one, too."""
    return _cut(text, _SENTENCE_END)


def clauses_of(text: str) -> Iterator[str]:
    """Return the clauses of a text, in order: what stands between marks."""
    return _cut(text, _CLAUSE_END)


def tokens_of(clause: str) -> list[str]:
    """Return the words of a clause with the marks around them; marks of full width end one without a space."""
    return [piece for piece in _PIECE.findall(clause) if piece != "\n"]


def _cut(text: str, end: re.Pattern[str]) -> Iterator[str]:
    start = stop = 0
    for piece in _PIECE.finditer(text):
        word = piece.group()
        if word == "\n" or piece.end() - start > LONGEST:
            yield from _filled(text[start:stop])
            start = piece.start()
        stop = piece.end()
        if end.search(word) and not _is_abbreviation(word, text, stop):
            yield from _filled(text[start:stop])
            start = stop
    yield from _filled(text[start:])


def _filled(part: str) -> Iterator[str]:
    if part := part.strip():
        yield part


def _is_abbreviation(word: str, text: str, stop: int) -> bool:
    """Return whether a word's full stop is not the end of a sentence."""
    following = text[stop : stop + 2].strip(" ")
    return bool(following.islower() or _ABBREVIATION.fullmatch(word)) and word.endswith(".") and following != ""
