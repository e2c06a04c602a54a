"""The words of the current sound, said or spoken by a voice, and how they are played, gone through and changed."""

from collections import deque
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.session.undo import UndoableEdit
from phonemeanalyser.desktop.talk.words.scripts import WordInSound, found_word
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.batch.work import size_and_time
from phonemeengine.errors import CorpusError
from phonemeengine.labels import utterance_edits
from phonemeengine.labels.table import write_text
from phonemeengine.labels.utterance import UNKNOWN_WORD, LabelUnit, Utterance, Word, spans_of, with_boundary
from phonemeengine.labels.utterance_files import format_utterance
from phonemeengine.performance.track import SpokenFace
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE
from phonemeengine.speech.spooled import KEPT, SentenceTrack, SpooledSpeech
from phonemeengine.speech.voice import SpokenSentence
from phonemeengine.text.lexicon import Lexicon

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


NO_WORDS = tr_noop("No words are known of this sound. Align its text first.")
NOTHING_CHOSEN = tr_noop("No word is selected. Click one in the timeline first.")
LEAST_INSERTED = 0.03
"""Seconds of a pause in which a word can be inserted."""
REACH = 0.5
"""Seconds around a word in which it is found anew, as far as its neighbours."""


class WordEdits(QObject):
    """Acts on the words of the current sound file; each change can be undone.

    Parameters
    ----------
    read_by : gives the language of the words, and the lexicon in use.
    find : finds a word in a part of the sound, in the background.

    Signals
    -------
    changed : another word or phone is chosen.
    name_asked : a name is to be typed for what lies in a `TimeSpan`, in the place of that name; see `name`.
    error, info : a sentence for the user.

    Attributes
    ----------
    chosen : the word or phone that is changed: what it is, and its number; None for none.
    """

    changed = Signal()
    name_asked = Signal(object, str)
    error = Signal(str)
    info = Signal(str)

    def __init__(
        self,
        session: Session,
        words: SoundWords,
        read_by: Callable[[], tuple[str, Lexicon | None]],
        find: Callable[[WordInSound], Word] = found_word,
    ) -> None:
        super().__init__()
        self._session, self._words = session, words
        self._read_by, self.find = read_by, find
        self.chosen: tuple[LabelUnit, int] | None = None
        self._named: tuple[TimeSpan, tuple[LabelUnit, int] | None] = (TimeSpan(0.0, 0.0), None)
        self._looked_at: tuple[Utterance | None, list[Word]] = None, []
        self._work = TaskQueue(self.error.emit)
        words.changed.connect(self._check_chosen)

    @property
    def possible(self) -> bool:
        """Whether words can be changed: there are some, and no voice has set their times."""
        return self._session.source.kind is SourceKind.FILE and self._words.utterance is not None

    @property
    def poor(self) -> list[Word]:
        """The words that should be looked at, in order of time."""
        utterance = self._words.utterance if self.possible else None
        if self._looked_at[0] is not utterance:  # asked at each key that is pressed in the text
            poor = [] if utterance is None else [word for word in utterance.words if fits_badly(word)]
            self._looked_at = utterance, poor
        return self._looked_at[1]

    def play(self, start: float, end: float) -> None:
        """Play a segment of the current sound, in seconds; it stands at the segment's beginning afterwards."""
        self._session.play_stretch(TimeSpan(start, end))

    def show(self, word: Word) -> None:
        """Play a word, and have it seen."""
        self._session.view.reveal(TimeSpan(word.start, word.end))
        self.play(word.start, word.end)

    def show_poor(self, step: int) -> None:
        """Play the next word that fits badly (`step` 1), or the one before (-1); after the last comes the first."""
        poor, here = self.poor, self._session.source.position
        later = [word for word in poor if word.start > here + FRAME_PERIOD]
        earlier = [word for word in poor if word.end < here + FRAME_PERIOD]
        if poor:
            self.show((later or poor)[0] if step > 0 else (earlier or poor)[-1])

    def move_boundary(self, unit: LabelUnit, boundary: int, seconds: float) -> None:
        """Move a boundary; see `with_boundary`."""
        utterance = self._words.utterance
        if not self.possible or utterance is None:
            return
        try:
            moved = with_boundary(utterance, unit, boundary, seconds)
        except CorpusError as error:
            self.error.emit(str(error))
            self._words.changed.emit()  # views move the boundary back to where it is
        else:
            self._words.edit(moved, tr("move of a boundary ({unit})").format(unit=tr(unit.value)), by_hand=True)

    def save(self, path: Path) -> bool:
        """Write the words as a TextGrid; says whether that went well."""
        if self._words.utterance is None:
            self.error.emit(tr("There are no words to save; open an audio file and align its text first."))
            return False
        try:
            write_text(format_utterance(self._words.utterance), path)
        except CorpusError as error:
            self.error.emit(str(error))
            return False
        self._words.note_saved()
        self.info.emit(tr("Saved words and phones as {path}.").format(path=path))
        return True

    # -- changes ------------------------------------------------------------------------------------------

    def choose(self, chosen: tuple[LabelUnit, int] | None) -> None:
        """Choose the word or phone that is changed."""
        if chosen != self.chosen:
            self.chosen = chosen
            self.changed.emit()

    def ask_rename(self) -> None:
        """Have the chosen word or phone named, or the word at the cursor."""
        found = self._in_hand()
        if found is not None:
            utterance, (unit, k) = found
            self.choose((unit, k))
            name = utterance.words[k].text if unit is LabelUnit.WORD else list(utterance.phones)[k].ipa
            self._named = TimeSpan(*spans_of(utterance, unit)[k]), (unit, k)
            self.name_asked.emit(self._named[0], name)

    def ask_insert(self) -> None:
        """Have a word named that is said in the pause at the cursor, or in what is selected."""
        utterance = self._words.utterance
        if not self.possible or utterance is None:
            self.error.emit(tr(NO_WORDS))
            return
        span = self._session.view.selection or TimeSpan(
            *utterance_edits.gap_at(utterance, self._session.source.position)
        )
        if span.seconds < LEAST_INSERTED:
            self.error.emit(tr("There is no pause at the cursor for another word. Go to a pause, or split a word."))
            return
        self.choose(None)
        self._named = span, None
        self.name_asked.emit(span, "")

    def name(self, name: str) -> None:
        """Take the name that was typed: a word as it is written, IPA between slashes, or IPA for a phone."""
        (span, renamed), utterance = self._named, self._words.utterance
        if utterance is None or not self.possible or not name.strip():
            return
        if renamed is None:
            self._find(name, span, utterance_edits.with_inserted, tr("insertion of a word"))
        elif renamed[0] is LabelUnit.WORD:
            k = renamed[1]
            if name.strip() != utterance.words[k].text:
                self._find(
                    name, span, lambda said, word: utterance_edits.with_word(said, k, word), tr("renaming of a word")
                )
        elif name.strip() != list(utterance.phones)[renamed[1]].ipa:
            self._edit(lambda said: utterance_edits.renamed_phone(said, renamed[1], name), tr("renaming of a phone"))

    def delete(self) -> None:
        """Delete the chosen word or phone."""
        found = self._in_hand()
        if found is not None:
            _, (unit, k) = found
            if unit is LabelUnit.WORD:
                self._edit(lambda said: utterance_edits.without_word(said, k), tr("deletion of a word"))
            else:
                self._edit(lambda said: utterance_edits.without_phone(said, k), tr("deletion of a phone"))

    def split(self) -> None:
        """Split the chosen word or phone at the cursor."""
        found, here = self._in_hand(), self._session.source.position
        if found is not None:
            _, (unit, k) = found
            if unit is LabelUnit.WORD:
                self._edit(lambda said: utterance_edits.split_word(said, k, here), tr("splitting of a word"))
            else:
                self._edit(lambda said: utterance_edits.split_phone(said, k, here), tr("splitting of a phone"))

    def realign(self) -> None:
        """Find the chosen word anew, between the one before and the one after it."""
        found = self._in_hand()
        if found is None:
            return
        utterance, (unit, k) = found
        if unit is LabelUnit.PHONE:
            k = _word_of_phone(utterance, k)
        words = utterance.words
        start = words[k - 1].end if k else 0.0
        end = words[k + 1].start if k + 1 < len(words) else utterance.duration
        ipa = ".".join("".join(phone.ipa for phone in syllable.phones) for syllable in words[k].syllables)
        name = f"{words[k].text.replace('/', ' ')}/{ipa}/"
        span = TimeSpan(max(start, words[k].start - REACH), min(end, words[k].end + REACH))
        self._find(name, span, lambda said, word: utterance_edits.with_word(said, k, word), tr("alignment of a word"))

    def close(self) -> None:
        """End all work."""
        self._work.close(CLOSE_TIMEOUT)

    def _find(self, name: str, span: TimeSpan, change: Callable[[Utterance, Word], Utterance], what: str) -> None:
        """Find a word in the sound, and change the words by it, unless these are others by then."""
        session, sound, before = self._session, self._words.sound, self._words.utterance
        if sound is None or before is None:
            return
        language, lexicon = self._read_by()
        asked = WordInSound(
            sound, session.channel, session.preset.in_force, name, language, lexicon, (span.start, span.end)
        )

        def take(word: Word) -> None:
            if self._words.utterance is before:
                self._edit(lambda said: change(said, word), what)

        self._work.submit(lambda _progress: self.find(asked), take)

    def _edit(self, change: Callable[[Utterance], Utterance], what: str) -> None:
        utterance = self._words.utterance
        if utterance is None:
            return
        try:
            changed = change(utterance)
        except CorpusError as error:
            self.error.emit(str(error))
        else:
            self.error.emit("")
            self._words.edit(changed, what, by_hand=True)

    def _in_hand(self) -> tuple[Utterance, tuple[LabelUnit, int]] | None:
        """Return the chosen word or phone; without one the word at the cursor; else say what to do."""
        utterance, here = self._words.utterance, self._session.source.position
        if utterance is not None and self.possible:
            if self.chosen is not None:
                return utterance, self.chosen
            at = (k for k, word in enumerate(utterance.words) if word.start <= here < word.end)
            if (k := next(at, None)) is not None:
                return utterance, (LabelUnit.WORD, k)
        self.error.emit(tr(NO_WORDS if utterance is None else NOTHING_CHOSEN))
        return None

    def _check_chosen(self) -> None:
        """Let go of what is not there any more."""
        utterance = self._words.utterance
        if self.chosen is not None and (
            utterance is None or self.chosen[1] >= len(spans_of(utterance, self.chosen[0]))
        ):
            self.choose(None)


def _word_of_phone(utterance: Utterance, k: int) -> int:
    """Return the number of the word that a phone belongs to."""
    for number, word in enumerate(utterance.words):
        k -= len(word.phones)
        if k < 0:
            return number
    return len(utterance.words) - 1
