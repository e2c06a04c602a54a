"""The words of the sound in hand: from labels beside it, from a script that is aligned with it, or from a voice."""

import re
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand

from phonemeanalyser.desktop.session.session import Session, SoundSource
from phonemeanalyser.desktop.talk.scripts import FoundWords, ScriptedSound, aligned, spoken, words_beside
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.alignment.align import is_other_text
from phonemeengine.errors import CorpusError, TextError
from phonemeengine.files import printable
from phonemeengine.labels.boundaries import LabelUnit, with_boundary
from phonemeengine.labels.text_io import write_text
from phonemeengine.labels.utterance import UNKNOWN_WORD, Utterance, Word
from phonemeengine.labels.utterance_files import format_utterance
from phonemeengine.mouth.transcript import NOTHING, Transcript, transcript_of_utterance
from phonemeengine.progress import Progress
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.pinyin.track import PinyinTrack, pinyin_track
from phonemeengine.speech.spooled import KEPT, SentenceTrack, SpooledSpeech
from phonemeengine.speech.voice import SpokenSentence
from phonemeengine.text import mandarin
from phonemeengine.text.espeak import Language, languages
from phonemeengine.text.lexicon import Lexicon, load_lexicon

POOR = 1.2
"""A word whose score is above it fits badly: of those that are said as they are written, one in ten."""
SHOWN_WORDS = 8
ROUNDING = 1e-6
"""Seconds by which the end of a sentence and the start of the next one may differ."""


def fits_badly(word: Word) -> bool:
    """Return whether a word should be looked at: it fits the sound badly, or stands in no script."""
    return word.text == UNKNOWN_WORD or (word.score is not None and word.score > POOR)


@dataclass(frozen=True)
class TextTools:
    """What does the work.

    Attributes
    ----------
    align : finds the words of a text in a sound.
    speak : has a voice speak a text of a language.
    languages : tells of all languages.
    """

    align: Callable[[ScriptedSound, Progress], Utterance] = aligned
    speak: Callable[[str, str], Iterator[SpokenSentence]] = spoken
    languages: Callable[[], tuple[Language, ...]] = languages


class UtteranceEdit(QUndoCommand):
    """Other words, or times, of a sound; of no use once another sound is in hand.

    Parameters
    ----------
    what : the change in words, for the Edit menu.
    """

    def __init__(
        self, texts: "TextModel", sound: Path, before: Utterance | None, after: Utterance, what: str
    ) -> None:
        super().__init__(what)
        self._texts, self._sound = texts, sound
        self._before, self._after = before, after

    def redo(self) -> None:
        """Do it."""
        self._put(self._after)

    def undo(self) -> None:
        """Take it back."""
        self._put(self._before)

    def _put(self, utterance: Utterance | None) -> None:
        if not self._texts.put_back(self._sound, utterance):
            self.setObsolete(True)


class TextModel(QObject):
    """Knows what is said in the sound in hand, and has texts aligned and spoken; `tick` follows what is spoken.

    Signals
    -------
    changed : the words, the text, the language, the lexicon, or what is going on.
    known_changed : what is said in the sound in hand, as a `Transcript`, or None where that is not known.
    known_grew : the same, where there is more of it than before.
    error, info : a sentence for the user; an empty error takes the one before away.

    Attributes
    ----------
    tools : what does the work.
    text : the script of the sound in hand, or what is to be spoken.
    language : of the text; empty where none is chosen.
    lexicon_path : goes before the language's voice; None for none.
    languages : all that there are, once they are known.
    no_voice : why there are none, as a sentence; empty where there are.
    letters : how the mouth says Chinese; None for other languages.
    """

    changed = Signal()
    known_changed = Signal(object)
    known_grew = Signal(object)
    error = Signal(str)
    info = Signal(str)

    def __init__(self, session: Session, tools: TextTools | None = None) -> None:
        super().__init__()
        self._session = session
        self.tools = tools or TextTools()
        self.text = self.language = ""
        self.lexicon_path: Path | None = None
        self.languages: tuple[Language, ...] = ()
        self.no_voice = ""
        self.letters: PinyinTrack | None = None
        self._lexicon: Lexicon | None = None
        self._sound: Path | None = None
        self._of_sound: Utterance | None = None
        self._speech: SpooledSpeech | None = None
        self._tracks: deque[SentenceTrack] = deque()
        self._of_speech: Utterance | None = None
        self._until: float | None = None
        self._awake = False
        self._work, self._looking = TaskQueue(self.error.emit), TaskQueue(self.error.emit)
        self._saving, self._waking = TaskQueue(self.error.emit), TaskQueue(self._lack_voice)
        self._work.changed.connect(self.changed)
        session.speech_asked.connect(self.say)

    # -- what is known ------------------------------------------------------------------------------------

    @property
    def utterance(self) -> Utterance | None:
        """What is said in the sound in hand; None where nothing is known of it."""
        if self._session.source is SoundSource.FILE:
            return self._of_sound
        return self._of_speech if self._session.source is SoundSource.TEXT else None

    @property
    def editable(self) -> bool:
        """Whether boundaries can be moved: a voice knows when it says what."""
        return self._session.source is SoundSource.FILE

    @property
    def busy(self) -> bool:
        """Whether a text is being aligned."""
        return self._work.busy

    @property
    def progress(self) -> str:
        """How far the work is, in words; nothing where there is none."""
        return f"{self._work.progress:.0%}" if self.busy else ""

    @property
    def summary(self) -> str:
        """What is known, in words."""
        utterance = self.utterance
        if utterance is None:
            return ""
        n, n_bad = len(utterance.words), sum(map(fits_badly, utterance.words))
        said = f"{n} word{'s' * (n != 1)}"
        return f"{said}, {n_bad} fit{'s' * (n_bad == 1)} badly" if n_bad else said

    # -- what is chosen -----------------------------------------------------------------------------------

    def wake(self) -> None:
        """Learn the languages, in the background."""
        if not self._awake:
            self._awake = True
            self._waking.submit(lambda _progress: self.tools.languages(), self._take_languages)

    def set_text(self, text: str) -> None:
        """Take another text."""
        if text != self.text:
            self.text = text
            self.changed.emit()

    def set_language(self, tag: str) -> None:
        """Take the text to be of another language; of an empty one, it is not known."""
        if tag != self.language:
            self.language = tag
            self.changed.emit()

    def set_lexicon(self, path: Path | None) -> None:
        """Have words pronounced as a lexicon says; None leaves that to the language's voice."""
        if path is None:
            self._take_lexicon(None, None)
        else:
            self._looking.submit(
                lambda _progress: load_lexicon(path), lambda lexicon: self._take_lexicon(path, lexicon)
            )

    def set_utterance(self, utterance: Utterance, what: str = "") -> None:
        """Say this of the sound in hand, until another one is opened; a change that has a name can be undone."""
        session = self._session
        if session.source is SoundSource.FILE and self._sound is not None:
            if what:
                edit = UtteranceEdit(self, self._sound, self._of_sound, utterance, what)
                session.preset.undo_stack.push(edit)
            else:
                self.put_back(self._sound, utterance)

    def put_back(self, sound: Path, utterance: Utterance | None) -> bool:
        """Say this of a sound; says whether it is the one in hand."""
        if sound != self._sound:
            return False
        self._of_sound = utterance
        if self._session.source is SoundSource.FILE:
            self._tell()
        return True

    # -- what is done -------------------------------------------------------------------------------------

    def align(self) -> None:
        """Find the words of the text in the sound in hand, in the background; or end that."""
        session = self._session
        if self.busy:
            self._work.cancel()
        elif session.source is not SoundSource.FILE or session.path is None:
            self.error.emit("There is no sound file in hand; open the recording of this text, then align.")
        elif self._may_read():
            script = ScriptedSound(
                session.path, session.channel, session.preset.in_force, self.text, self.language, self._lexicon
            )
            self._work.submit(
                lambda progress: self.tools.align(script, progress), lambda found: self._take_aligned(script, found)
            )

    def say(self) -> None:
        """Have a voice speak the text, as soon as it can."""
        if self._may_read():
            text, language = self.text, self._language_of_text
            self._work.replace(lambda _progress: self.tools.speak(text, language), self._take_speech)

    def move_boundary(self, unit: LabelUnit, boundary: int, seconds: float) -> None:
        """Move a boundary; see `with_boundary`."""
        if self.utterance is None or not self.editable:
            return
        try:
            moved = with_boundary(self.utterance, unit, boundary, seconds)
        except CorpusError as error:
            self.error.emit(str(error))
            self.changed.emit()  # whoever shows the boundary elsewhere shows it where it is
        else:
            self.set_utterance(moved, f"boundary of a {unit}")

    def play(self, start: float, end: float) -> None:
        """Play a stretch of the sound in hand, in seconds."""
        session = self._session
        session.pause()
        session.seek(start)
        session.play()
        self._until = end

    def save(self, path: Path) -> None:
        """Write the words as a TextGrid, which exports take; does not wait."""
        utterance = self.utterance
        if utterance is None:
            self.error.emit("There are no words to save; align a text, or have it said.")
            return
        self._saving.submit(
            lambda _progress: write_text(format_utterance(utterance), path),
            lambda _: self.info.emit(f"Saved words, phones and phonemes as {path}."),
        )

    def follow_sound(self) -> None:
        """Look what is known of the sound in hand, since another one is in hand now."""
        session = self._session
        self._until = None
        self._tracks.clear()
        self._of_speech = None
        if session.source is not SoundSource.TEXT:
            self._speech = None
        if session.source is SoundSource.FILE and not self._still_fits():
            another = session.path != self._sound
            self._sound, self._of_sound = session.path, None
            self._work.cancel()
            self._look_beside(with_script=another)
        self._tell()

    def tick(self) -> None:
        """Follow what is spoken, and end what has lasted long enough."""
        self._follow_speech()
        if self._until is not None:
            if not self._session.playing:
                self._until = None
            elif self._session.position >= self._until:
                self._until = None
                self._session.pause()

    def close(self) -> None:
        """Save what is to be saved, and end all other work."""
        self._saving.finish()
        for work in (self._work, self._looking, self._waking):
            work.close()

    # -- inside -------------------------------------------------------------------------------------------

    @property
    def _language_of_text(self) -> str:
        """The language that is chosen; Chinese characters tell theirs."""
        return self.language or ("cmn" if re.search(mandarin.HANZI, self.text) else "")

    def _may_read(self) -> bool:
        """Return whether there is a text and its language; say so if not."""
        if not self.text.strip():
            self.error.emit("There is no text; write what is said into the field below the head.")
        elif not self._language_of_text:
            self.error.emit("The language of a text is not guessed; choose it below the text.")
        else:
            self.error.emit("")  # what was wrong before is right now
            return True
        return False

    def _still_fits(self) -> bool:
        """Return whether the file in hand is the one whose words are known, in another channel perhaps."""
        session, known = self._session, self._of_sound
        if session.path != self._sound or known is None:
            return False
        return abs(known.duration - session.duration) < 1 / SAMPLE_RATE

    def _look_beside(self, *, with_script: bool) -> None:
        sound, duration = self._session.path, self._session.duration
        if sound is not None:
            self._looking.replace(
                lambda _progress: words_beside(sound, duration),
                lambda found: self._take_found(sound, found if with_script else replace(found, text="")),
            )

    def _take_found(self, sound: Path, found: FoundWords) -> None:
        if sound != self._sound:
            return
        if found.text:
            self.set_text(found.text)
        if found.utterance is not None and self._of_sound is None:
            self.put_back(sound, found.utterance)

    def _take_aligned(self, script: ScriptedSound, found: Utterance) -> None:
        if script.sound != self._sound:
            return
        if is_other_text(found):
            self.error.emit("Another text is said in this sound; check the text and its language.")
            return
        if found.skipped:
            words = " ".join(printable(word) for word in found.skipped[:SHOWN_WORDS])
            more = len(found.skipped) - SHOWN_WORDS
            self.info.emit(f"Nobody says: {words}{f' and {more} more words' if more > 0 else ''}.")
        self.set_utterance(found, "alignment")

    def _take_speech(self, sentences: Iterator[SpokenSentence]) -> None:
        self._speech = SpooledSpeech(sentences)
        self._session.speak(self._speech)

    def _follow_speech(self) -> None:
        """Take what is newly spoken, and forget what was heard long ago."""
        if self._speech is None or self._session.source is not SoundSource.TEXT:
            return
        n = len(self._tracks)
        while track := self._speech.track_at(self._tracks[-1].end + ROUNDING if self._tracks else 0.0):
            self._tracks.append(track)
        if len(self._tracks) == n:
            return
        while self._tracks[0].end < self._session.position - KEPT / SAMPLE_RATE:
            self._tracks.popleft()
        words = tuple(word for track in self._tracks for word in track.words)
        self._of_speech = Utterance(words, self._tracks[-1].end, self._language_of_text)
        self._tell(grown=n > 0)

    def _take_languages(self, known: tuple[Language, ...]) -> None:
        by_voice = {language.identifier: language for language in reversed(known)}  # of several tags, the first one
        self.languages = tuple(by_voice.values())
        self.changed.emit()

    def _lack_voice(self, sentence: str) -> None:
        self.no_voice = sentence
        self.changed.emit()

    def _take_lexicon(self, path: Path | None, lexicon: Lexicon | None) -> None:
        self.lexicon_path, self._lexicon = path, lexicon
        self.changed.emit()

    def _tell(self, *, grown: bool = False) -> None:
        utterance = self.utterance
        self.letters = None if utterance is None else self._letters_of(utterance)
        (self.known_grew if grown else self.known_changed).emit(utterance and self._transcript_of(utterance))
        self.changed.emit()

    def _letters_of(self, utterance: Utterance) -> PinyinTrack | None:
        """Return how the mouth says Chinese; None for other languages."""
        if not any(syllable.text for word in utterance.words for syllable in word.syllables):
            return None
        text = "".join(track.text for track in self._tracks) or self.text
        try:
            return pinyin_track(utterance, text=text)
        except TextError:
            return None

    def _transcript_of(self, utterance: Utterance) -> Transcript:
        path = self._sound if self._session.source is SoundSource.FILE else None
        return transcript_of_utterance(utterance, NOTHING, NOTHING, self._session.name, path)
