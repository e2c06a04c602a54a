"""The text that is said, and its language; and what is remembered of both for each sound."""

import re
from collections import Counter
from functools import lru_cache
from itertools import pairwise
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr_noop
from phonemeanalyser.desktop.settings import in_program
from phonemeengine.labels.utterance import Utterance
from phonemeengine.text.pronunciation import MARKS
from phonemeengine.text.script import guess_language

MOST_SOUNDS, MOST_LANGUAGES = 50, 5
"""Sounds whose texts are remembered, and languages that are offered first, because they were chosen last."""
MOST_REMEMBERED = 200_000
"""Characters of all texts that are remembered."""
ALIGN_AGAIN = tr_noop("The text has changed since these words were aligned. Align again.")
SPEAK_AGAIN = tr_noop("The text has changed since these words were spoken. Speak again.")
_DIRECTION = re.compile(r"\[[^\[\]\n]*\]")


class WrittenText(QObject):
    """Holds the text of the current sound, or what a voice is to say, and remembers those of other sounds.

    Signals
    -------
    changed : another text, or another language.

    Attributes
    ----------
    text : as it is written.
    language : that was chosen; empty where none is.
    guess : the language that the text is probably in; empty where it tells none.
    recent : the languages that were chosen last, the newest first.
    remembered : text and language by the path of the sound, the newest last; those of no sound by an empty path.
    sound : whose script the text is; None where it is none's.
    waiting : whether the text of the current sound is still looked for.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.text = self.language = self.guess = ""
        self.recent: list[str] = []
        self.remembered: dict[str, tuple[str, str]] = {}
        self._in_file, self.waiting = "", False
        self.sound: Path | None = None
        self._script = "", ""  # of the sound, and its language, as it was found or aligned last
        self._typed_without = False

    @property
    def spoken_in(self) -> str:
        """The language that is chosen; without one, that which is guessed."""
        return self.language or self.guess

    @property
    def has_unsaved_changes(self) -> bool:
        """Whether the text of a sound would be lost: its file has another one, or it is too long to be remembered."""
        too_long = len(self.text) > MOST_REMEMBERED and self.text != self._in_file
        return self.sound is not None and (too_long or (bool(self._in_file) and self.text != self._in_file))

    def set_text(self, text: str, *, is_script: bool = False) -> None:
        """Take another text; `is_script` where it is known to be what is said in the current sound."""
        if text != self.text:
            self._typed_without, self.waiting = self.sound is None, False
            self._put(text, self.language)
        if is_script:
            self.note_script()

    def set_language(self, tag: str) -> None:
        """Take the text to be of another language; of an empty one, it is guessed."""
        if tag:
            self.recent = [tag, *(other for other in self.recent if other != tag)][:MOST_LANGUAGES]
        if tag != self.language:
            self._put(self.text, tag)

    def leave(self, sound: Path | None, *, waiting: bool = False) -> None:
        """Remember the text of the current sound, since another one, or none, is current now."""
        self.remember()
        self.sound, self.waiting = sound, waiting

    def note_script(self) -> None:
        """Take note that the text is what is said in the current sound."""
        self._script = self.text, self.language

    def note_spoken(self) -> None:
        """Take note that a voice says the text: unless it is much like the sound's script, it is no sound's."""
        self._typed_without = False
        if self.sound is not None and not _much_alike(self.text, self._script[0]):
            spoken = self.text, self.language
            self.text, self.language = self._script
            self.leave(None)
            self.text, self.language = spoken

    def remember(self) -> None:
        """Remember the text of the current sound, once it is known."""
        if self.waiting:
            return
        key = str(self.sound or "")
        self.remembered.pop(key, None)
        if self.text.strip():
            self.remembered[key] = self.text, self.language
        while (
            len(self.remembered) > MOST_SOUNDS
            or sum(len(text) for text, _ in self.remembered.values()) > MOST_REMEMBERED
        ):
            del self.remembered[next(iter(self.remembered))]

    def take(self, found: str, known: Utterance | None) -> None:
        """Take the text of the current sound: from a file, from memory, from its words; else there is none.

        What was typed before any sound was open stays, since it waited for this one. The text of the demo is where to
        begin, and no file of the user's: what was typed in its place is remembered, and never saved there.
        """
        text, language = self.remembered.get(str(self.sound or ""), ("", ""))
        if self.sound is not None and in_program(self.sound):
            found, text, self._in_file = "", text or found, ""
        else:
            self._in_file = found
        if not (found or text) and known is not None:
            text = said_in(known)
        elif not (found or text) and self._typed_without:
            text, language = self.text, self.language
        self._typed_without = self.waiting = False
        if found and found != text:
            text = found
        self._put(text, language)
        self.note_script()

    def note_saved(self) -> None:
        """Take note that the file beside the sound has this text now."""
        self._in_file = self.text

    def _put(self, text: str, language: str) -> None:
        if text != self.text:
            self.guess = guess_language(text)
        if (text, language) != (self.text, self.language):
            self.text, self.language = text, language
            self.changed.emit()


def said_in(utterance: Utterance) -> str:
    """Return the words of an utterance, as they are written."""
    return " ".join(word.text for word in utterance.words if word.text)


@lru_cache(4)  # asked several times for each key that is typed, of texts of hours
def same_words(one: str, other: str) -> bool:
    """Return whether two texts have the same words, whatever their marks, capitals and directions in brackets."""
    spoken = (_DIRECTION.sub(" ", text).casefold() for text in (one, other))
    first, second = ([w for word in text.split() if (w := word.strip(MARKS))] for text in spoken)
    return first == second


def _much_alike(one: str, other: str) -> bool:
    """Return whether two texts share half of their pairs of neighbouring characters; that needs no words."""
    first, second = (Counter(pairwise(text.casefold())) for text in (one, other))
    return 2 * (first & second).total() >= max(first.total(), second.total(), 1)


def places_of(utterance: Utterance, text: str, reach: int = 200) -> list[tuple[int, int]]:
    """Return where each word stands in a text, start and end; both are 0 where it does not.

    Parameters
    ----------
    reach : characters after the word before in which a word is looked for.
    """
    places, at = [], 0
    for word in utterance.words:
        found = text.find(word.text, at, at + reach) if word.text else -1
        places.append((found, found + len(word.text)) if found >= 0 else (0, 0))
        at = max(at, places[-1][1])
    return places
