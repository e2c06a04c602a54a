"""What of a text is spoken: a script's notation, emoji, control characters and the like are left out, with a note."""

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass

from phonemeengine.errors import TextError
from phonemeengine.files import printable
from phonemeengine.text.notation import spoken_part

_EMOJI = re.compile(
    "[\U0001f000-\U0001fbff\u2300-\u23ff\u25a0-\u27bf\u2b00-\u2bff\u20e3]"
    "[\U0001f000-\U0001fbff\u2300-\u23ff\u25a0-\u27bf\u2b00-\u2bff\u20e3\u200d\ufe0e\ufe0f\U000e0020-\U000e007f]*"
)
_SILENT = frozenset("\u00ad\u200b\u2060\ufeff\u200e\u200f\ufe0e\ufe0f")
"""Characters of layout, which nobody misses."""
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
