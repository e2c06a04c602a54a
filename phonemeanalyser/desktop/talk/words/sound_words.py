"""What is said: the words of the current sound file, and those of a text while a voice speaks it."""

from collections import deque
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from phonemeanalyser.desktop.session.undo import UndoableEdit
from phonemeengine.batch.work import size_and_time
from phonemeengine.labels.utterance import UNKNOWN_WORD, Utterance, Word
from phonemeengine.performance.track import SpokenFace
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.spooled import KEPT, SentenceTrack, SpooledSpeech
from phonemeengine.speech.voice import SpokenSentence

POOR = 1.2
"""A word whose score is above it fits badly: of those that are said as they are written, one in ten."""


def fits_badly(word: Word) -> bool:
    """Return whether a word should be looked at: it fits the sound badly, or stands in no script."""
    return word.text == UNKNOWN_WORD or (word.score is not None and word.score > POOR)


@dataclass(frozen=True)
class KnownWords:
    """What is known of a sound.

    Attributes
    ----------
    utterance : what is said when; None where it is unknown.
    by_hand : whether the user moved anything in it.
    text : as its words are written, with their marks; empty where that is not known.
    """

    utterance: Utterance | None = None
    by_hand: bool = False
    text: str = ""


def _state_of(sound: Path | None) -> tuple[int, int] | None:
    with suppress(OSError):
        return None if sound is None else size_and_time(sound)
    return None


class SoundWords(QObject):
    """Holds the words of one sound at a time; changes can be undone.

    Parameters
    ----------
    undo_stack : of the whole program.

    Signals
    -------
    changed : other words, or times.

    Attributes
    ----------
    sound : whose words they are; None where there is none.
    known : what is known of it.
    """

    changed = Signal()

    def __init__(self, undo_stack: QUndoStack) -> None:
        super().__init__()
        self.sound: Path | None = None
        self.known = KnownWords()
        self._undo_stack = undo_stack
        self._saved: Utterance | None = None
        self._state: tuple[int, int] | None = None  # of the file

    @property
    def utterance(self) -> Utterance | None:
        """What is said in the sound; None where it is unknown."""
        return self.known.utterance

    @property
    def has_unsaved_changes(self) -> bool:
        """Whether the user moved anything that is in no file."""
        return self.known.by_hand and self.utterance is not self._saved

    def is_of(self, sound: Path | None, duration: float) -> bool:
        """Return whether they are known, and those of a sound of a given length, in any of its channels.

        A file that was written to meanwhile is another sound, however long it is.
        """
        if sound != self.sound or self.utterance is None or _state_of(sound) != self._state:
            return False
        return abs(self.utterance.duration - duration) < 1 / SAMPLE_RATE

    def follow(self, sound: Path | None) -> None:
        """Forget all words, since another sound is open."""
        self.sound, self.known, self._state = sound, KnownWords(), _state_of(sound)

    def put(self, known: KnownWords) -> None:
        """Say this of the sound; that cannot be undone."""
        self.known = known
        self.changed.emit()

    def edit(self, utterance: Utterance, what: str, *, by_hand: bool, text: str | None = None) -> None:
        """Say this of the sound from now on, until that is undone; without a text, it stays what it was."""
        known = KnownWords(utterance, by_hand, self.known.text if text is None else text)
        self._undo_stack.push(UndoableEdit(what, self.put, self.known, known, lambda: self.sound))

    def note_saved(self) -> None:
        """Take note that what is known is in a file now."""
        self._saved = self.utterance


ROUNDING = 1e-6
"""Seconds by which the end of a sentence and the start of the next one may differ."""


class RunningSpeech:
    """Follows speech that is still being made, and forgets what was played long ago.

    Parameters
    ----------
    sentences : as a voice speaks them.
    face : looks them up meanwhile; None where nothing does.
    language, script : of the text, and that itself.

    Attributes
    ----------
    face, language, script : what looks the text up, its language, and all that is to be spoken.
    speech : the sound; its player closes it.
    utterance : what is said by now and not forgotten; None where nothing is known of it.
    """

    def __init__(
        self, sentences: Iterator[SpokenSentence], face: SpokenFace | None, language: str, script: str
    ) -> None:
        self.face = face
        self.speech = SpooledSpeech(sentences)
        self.utterance: Utterance | None = None
        self.language, self.script = language, script
        self._tracks: deque[SentenceTrack] = deque()

    @property
    def text(self) -> str:
        """As it is written, what `utterance` holds."""
        return "".join(track.text for track in self._tracks)

    def follow(self, position: float) -> bool:
        """Take what was spoken meanwhile; says whether that is anything.

        Parameters
        ----------
        position : seconds of the sound that were played.
        """
        n = len(self._tracks)
        while track := self.speech.track_at(self._tracks[-1].end + ROUNDING if self._tracks else 0.0):
            self._tracks.append(track)
        if len(self._tracks) == n:
            return False
        while self._tracks[0].end < position - KEPT / SAMPLE_RATE:
            self._tracks.popleft()
        words = tuple(word for track in self._tracks for word in track.words)
        self.utterance = Utterance(words, self._tracks[-1].end, self.language) if words else None
        return True
