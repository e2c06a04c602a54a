"""The words of the current sound: from labels beside it, from a script that is aligned with it, or from a voice."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.exports import TextToSay
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind, SpokenSource
from phonemeanalyser.desktop.session.time_view import TimeSpan, TimeView
from phonemeanalyser.desktop.talk.drivers.driver_model import DriverModel
from phonemeanalyser.desktop.talk.drivers.original_model import OriginalModel
from phonemeanalyser.desktop.talk.drivers.performance_model import MeasuredSound
from phonemeanalyser.desktop.talk.words import scripts
from phonemeanalyser.desktop.talk.words.sound_words import KnownWords, RunningSpeech, SoundWords, WordEdits
from phonemeanalyser.desktop.talk.words.voice_model import VoiceChoice, VoiceModel
from phonemeanalyser.desktop.talk.words.written_text import ALIGN_AGAIN, SPEAK_AGAIN, WrittenText, said_in, same_words
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.alignment.align import is_other_text
from phonemeengine.dsp.waveform_peaks import Peaks, WaveformPeaks
from phonemeengine.execution import Progress
from phonemeengine.labels.timed_words import TimedWord
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.transcript import NOTHING, Transcript, transcript_of_utterance
from phonemeengine.performance.track import SpokenFace
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.spooled import SpooledSpeech
from phonemeengine.speech.voice import SpokenSentence
from phonemeengine.storage.files import printable
from phonemeengine.text.lexicon import Lexicon, load_lexicon

SHOWN_WORDS = 8


@dataclass(frozen=True)
class TextTools:
    """What does the work.

    Attributes
    ----------
    align : finds the words of a text in a sound.
    speak : has a voice speak a text of a language.
    """

    align: Callable[[scripts.ScriptedSound, Progress], Utterance] = scripts.aligned
    speak: Callable[[str, str, VoiceChoice], Iterator[SpokenSentence]] = scripts.spoken


class TextModel(QObject):
    """Knows what is said in the current sound, and has texts aligned and spoken; `tick` follows what is spoken.

    Signals
    -------
    changed : the words, the lexicon, the voice, what moves the mouth, or what is going on.
    text_changed : the text or its language.
    known_changed : `known` is another one; while a voice speaks, it grows without that.
    speech_saved : the path of a sound file to which a text was spoken.
    error, info : a sentence for the user; an empty error takes the one before away.

    Attributes
    ----------
    tools : what does the work.
    voice : who speaks.
    drivers : by what the mouth moves.
    original : plays what a unit of a recorded face is from.
    words : of the current sound file.
    edits : changes them, and goes from one to another.
    speech_view : which seconds are seen of what a voice speaks.
    known : what is said in the current sound; None where that is not known.
    written : the script of the current sound, or what is to be spoken, and its language.
    lexicon_path : goes before the language's voice; None for none.
    speakers : the speakers of the script of the current sound.
    speaker : the one whose words are taken; empty where none is chosen.
    literal : whether the notation of scripts is taken as words, too.
    refused : what was not aligned, since another text seems to be said; None where there is nothing.
    """

    changed = Signal()
    text_changed = Signal()
    known_changed = Signal()
    speech_saved = Signal(str)
    error = Signal(str)
    info = Signal(str)

    def __init__(
        self,
        session: Session,
        tools: TextTools | None = None,
        voice: VoiceModel | None = None,
        drivers: DriverModel | None = None,
    ) -> None:
        super().__init__()
        self._session = session
        self.tools = tools or TextTools()
        self.voice = voice or VoiceModel()
        self.drivers = drivers or DriverModel()
        self.original = OriginalModel(session, self.drivers.performance)
        self.words = SoundWords(session.preset.undo_stack)
        self.edits = WordEdits(session, self.words, lambda: (self._language_of_text, self._lexicon))
        self.speech_view = TimeView()
        self.known: Transcript | None = None
        self.written = WrittenText()
        self.lexicon_path: Path | None = None
        self.literal = False
        self.refused: scripts.ScriptedSound | None = None
        self._lexicon: Lexicon | None = None
        self.speakers: tuple[str, ...] = ()
        self.speaker = ""
        self._script: Path | None = None  # the file that tells the speakers apart
        self._timed: tuple[TimedWord, ...] = ()
        self._timed_text = ""  # the text that they are the words of
        self._speech: RunningSpeech | None = None
        self._work, self._looking, self._saving = (TaskQueue(self.error.emit) for _ in range(3))
        for part in (self._work, self._saving):
            part.changed.connect(self.changed)
        drivers = self.drivers
        for model in (self.voice, drivers, drivers.performance, drivers.network, self.original):
            model.changed.connect(self.changed)
        for error in (drivers.error, self.original.error, self.edits.error):
            error.connect(self.error)
        for info in (drivers.info, self.edits.info):
            info.connect(self.info)
        self.words.changed.connect(self._take_words)
        self.written.changed.connect(self._take_text)
        session.say = self.say

    # -- what is known ------------------------------------------------------------------------------------

    @property
    def utterance(self) -> Utterance | None:
        """What is said in the current sound; None where nothing is known of it."""
        if self.editable:
            return self.words.utterance
        return None if self._speech is None else self._speech.utterance

    @property
    def view(self) -> TimeView:
        """Which seconds of the current sound are seen."""
        return self._session.view if self.editable else self.speech_view

    def outline_in(self, seen: TimeSpan, n_columns: int) -> Peaks | None:
        """Return the waveform of a part of the current sound, a point for each column, as far as it is known."""
        peaks: WaveformPeaks | None = None
        if self.editable and self._session.whole.tracks is not None:
            peaks = self._session.whole.tracks.peaks
        elif not self.editable and self._speech is not None:
            peaks = self._speech.speech.peaks
        return None if peaks is None else peaks.between(seen.start * SAMPLE_RATE, seen.end * SAMPLE_RATE, n_columns)

    @property
    def editable(self) -> bool:
        """Whether boundaries can be moved.

        Those of a voice cannot: sound and times come from one call, so that moving one could only put the mouth out
        of step.
        """
        return self._session.source.kind is SourceKind.FILE

    @property
    def busy(self) -> bool:
        """Whether a text is being aligned, or a voice is being asked."""
        return self._work.busy

    @property
    def progress(self) -> str:
        """How far the work is, in words; nothing where there is none."""
        if self.busy:
            return f"{self._work.progress:.0%}"
        return tr("Saving spoken text…") if self._saving.busy else self.drivers.progress

    @property
    def to_say(self) -> TextToSay | None:
        """The text, where a voice says it and no sound file is open."""
        if self._session.source.kind is not SourceKind.TEXT or not self.text.strip():
            return None
        text, language, voice = self.text, self._language_of_text, self._voice
        given = None if voice.recordings is None else voice.recordings.units_of
        return TextToSay(text, language, lambda: self.tools.speak(text, language, voice), given)

    # -- what is chosen -----------------------------------------------------------------------------------

    @property
    def text(self) -> str:
        """The script of the current sound, or what is to be spoken."""
        return self.written.text

    @property
    def text_before(self) -> str:
        """The text that was aligned or spoken; empty where that is not known."""
        return self.words.known.text if self.edits.possible else self._speech.script if self._speech else ""

    @property
    def stale(self) -> str:
        """What to do where the text has other words now than those that were aligned or spoken; empty otherwise."""
        again = tr(ALIGN_AGAIN) if self.editable else tr(SPEAK_AGAIN)
        return again if self.text_before and not same_words(self.text_before, self.text) else ""

    @property
    def text_of_words(self) -> str:
        """The text of the words: as it is now, unless it has other words."""
        return self.text_before if self.stale else self.text

    def set_text(self, text: str) -> None:
        """Take another text."""
        self.written.set_text(text)

    def set_language(self, tag: str) -> None:
        """Take the text to be of another language; of an empty one, it is guessed."""
        self.written.set_language(tag)

    def set_literal(self, on: bool) -> None:
        """Take the notation of scripts, such as speakers' names and directions, as words, or not."""
        if on != self.literal:
            self.literal, self.refused = on, None
            self.changed.emit()

    def set_lexicon(self, path: Path | None) -> None:
        """Have words pronounced as a lexicon says; None leaves that to the language's voice."""
        if path is None:
            self._take_lexicon(None, None)
        else:
            self._looking.submit(
                lambda _progress: load_lexicon(path), lambda lexicon: self._take_lexicon(path, lexicon)
            )

    def open_script(self, path: Path, speaker: str | None = None) -> None:
        """Take the text, or the words with their times, of a script for the current sound; in the background."""
        sound, duration = self._session.source.path, self._session.source.duration
        if sound is None:
            self.error.emit(tr("No audio file is open; open the recording of this script first, then the script."))
            return
        self._looking.replace(
            lambda _progress: scripts.words_in(path, sound, duration, speaker),
            lambda found: self._take_script(sound, replace(found, script=path)),
        )

    def choose_speaker(self, name: str) -> None:
        """Take the words of one of the `speakers`."""
        if self._script is not None:
            self.speaker = name
            self.open_script(self._script, name)

    # -- what is done -------------------------------------------------------------------------------------

    def align(self, *, accepted: bool = False) -> None:
        """Find the words of the text in the current sound, in the background; or end that.

        Parameters
        ----------
        accepted : whether that is done even where another text seems to be said.
        """
        session, sound = self._session, self._session.source.path
        if self.busy:
            self._work.cancel()
        elif sound is None:
            self.error.emit(tr("No audio file is open; open the recording of this text first, then align."))
        elif self._may_read():
            self._align(
                scripts.ScriptedSound(
                    sound,
                    session.channel,
                    session.preset.in_force,
                    self.text,
                    self._language_of_text,
                    self._lexicon,
                    self.literal,
                    accepted,
                    self._timed if self.text == self._timed_text else (),
                )
            )

    def align_anyway(self) -> None:
        """Find the words of the text in the sound, though another one seems to be said; of what was refused first."""
        if self.refused is not None and not self.busy:
            self.error.emit("")
            self._align(replace(self.refused, accepted=True))
        elif not self.busy:
            self.align(accepted=True)

    def say(self) -> None:
        """Have the voice speak the text, as soon as it can."""
        if self._may_read(by_voice=True):
            text, language, voice = self.text, self._language_of_text, self._voice
            look_up = self.drivers.wants_table
            self._work.replace(
                lambda _progress: self._spoken(text, language, voice, look_up=look_up),
                lambda spoken: self._take_speech(RunningSpeech(*spoken, language, text), voice),
            )

    def save_speech(self, path: Path) -> None:
        """Have the voice speak the text into a WAV file, with words and phones beside it; does not wait."""
        if self._may_read(by_voice=True):
            text, language, voice = self.text, self._language_of_text, self._voice
            self._saving.submit(
                lambda _progress: scripts.write_speech(self.tools.speak(text, language, voice), language, path),
                lambda _: self.speech_saved.emit(str(path)),
            )

    def follow_sound(self) -> None:
        """Look what is known of the current sound, since another one is open now."""
        session = self._session
        if session.source.kind is not SourceKind.TEXT:
            self._speech = None
            self.speech_view.open(0.0)
        path, is_known = session.path, self.words.is_of(session.path, session.source.duration)
        another = path != self.words.sound or path != self.written.sound  # which a spoken text leaves
        if self.editable and (another or not is_known):
            if not another and path is not None and self.words.utterance is not None:
                words = tr("{file} has changed on the disk; its words are taken from the files beside it again.")
                self.info.emit(words.format(file=path.name))
            self.refused = None
            if not is_known:
                self.words.follow(path)
            self._work.cancel()
            if another:
                self.written.leave(path, waiting=True)
                self.speakers, self.speaker, self._script = (), "", None
            self._look_beside(with_script=self.written.waiting)
        self._tell()

    def tick(self) -> None:
        """Follow what is spoken and looked up."""
        self._follow_speech()
        if self.drivers.performance.face is not None:
            self.drivers.performance.tick(self._session.source.position)
        self.original.tick()

    def close(self) -> None:
        """Save what is to be saved, and end all other work."""
        self._saving.finish()
        for part in (self.voice, self.edits, self.original, self.drivers):
            part.close()
        for work in (self._work, self._looking):
            work.close(CLOSE_TIMEOUT)

    # -- inside -------------------------------------------------------------------------------------------

    def _align(self, script: scripts.ScriptedSound) -> None:
        self.refused = None
        self._work.submit(
            lambda progress: self.tools.align(script, progress), lambda found: self._take_aligned(script, found)
        )
        self.changed.emit()

    @property
    def _language_of_text(self) -> str:
        """The language that is chosen, or that the text tells."""
        return self.written.spoken_in

    def _may_read(self, *, by_voice: bool = False) -> bool:
        """Return whether there is a text and its language; say so if not."""
        if not self.text.strip():
            self.error.emit(tr("There is no text; type it into the field below the head."))
        elif not self._language_of_text and not (by_voice and self.voice.choice.by_program):
            self.error.emit(tr("The language isn’t set, and it isn’t detected; choose it beside the text."))
        else:
            self.error.emit("")  # what was wrong before is right now
            return True
        return False

    def _look_beside(self, *, with_script: bool) -> None:
        sound, duration = self._session.path, self._session.source.duration
        if sound is not None:
            self._looking.replace(
                lambda _progress: scripts.words_beside(sound, duration),
                lambda found: self._take_beside(sound, found, with_script=with_script),
            )
        elif with_script:
            self.written.take("", None)

    def _take_beside(self, sound: Path, found: scripts.FoundWords, *, with_script: bool) -> None:
        if sound == self.words.sound:
            if with_script:
                self.written.take(found.text, found.utterance)
            self._take_found(sound, replace(found, text=found.text if found.text == self.text else ""))

    def _take_found(self, sound: Path, found: scripts.FoundWords) -> None:
        if sound != self.words.sound:
            return
        if found.script != self._script:
            self.speaker = ""
        self.speakers, self._script = found.speakers, found.script
        if len(found.speakers) > 1 and not self.speaker:
            self.info.emit(tr("These labels have several speakers; choose one beside the text."))
        if found.text:
            self._timed, self._timed_text = found.timed, found.text
            self.written.set_text(found.text, is_script=True)
        if found.utterance is not None and self.words.utterance is None:
            self.words.put(KnownWords(found.utterance, text=self.text or said_in(found.utterance)))

    def _take_script(self, sound: Path, found: scripts.FoundWords) -> None:
        """Take what a script says that the user has opened, instead of what was known before."""
        if sound != self.words.sound:
            return
        self.error.emit("")
        if (utterance := found.utterance) is not None:
            found = replace(found, text=found.text or said_in(utterance))
            self.words.edit(utterance, tr("loading of a script"), by_hand=False, text=found.text)
        self._take_found(sound, found)
        self.changed.emit()

    def _take_aligned(self, script: scripts.ScriptedSound, found: Utterance) -> None:
        if script.sound != self.words.sound:
            return
        if is_other_text(found) and not script.accepted:
            self.refused = script
            sentence = tr("The recording doesn’t match this text; check the text and its language, or align anyway.")
            self.error.emit(sentence)
            self.changed.emit()
            return
        if found.skipped:
            words = " ".join(printable(word) for word in found.skipped[:SHOWN_WORDS])
            more = len(found.skipped) - SHOWN_WORDS
            told = (
                tr("Not spoken in the recording: {words} and {n} more words.")
                if more > 0
                else tr("Not spoken in the recording: {words}.")
            )
            self.info.emit(told.format(words=words, n=more))
        self.written.note_script()
        self.words.edit(found, tr("alignment"), by_hand=False, text=script.text)

    @property
    def _voice(self) -> VoiceChoice:
        own = self.drivers.performance.own_sound() if self.voice.choice.own_sound else None
        return replace(self.voice.choice, lexicon=self._lexicon, literal=self.literal, recordings=own)

    def _spoken(
        self, text: str, language: str, voice: VoiceChoice, *, look_up: bool
    ) -> tuple[Iterator[SpokenSentence], SpokenFace | None]:
        """Return a text as a voice speaks it, and what its face is looked up by, where it is."""
        sentences = self.tools.speak(text, language, voice)
        face = self.drivers.performance.spoken_face(language, voice.recordings) if look_up else None
        return (sentences, None) if face is None else (face.follow(sentences), face)

    def _take_speech(self, speech: RunningSpeech, voice: VoiceChoice) -> None:
        session, self._speech = self._session, speech
        self.written.note_spoken()
        self.speech_view.open(0.0)

        def speak_again() -> SpooledSpeech:
            return SpooledSpeech(self.tools.speak(speech.script, speech.language, voice))

        sound = speech.speech, speak_again, voice.words
        session.take(lambda: SpokenSource(session.preset.in_force, session.playback, *sound))
        session.play()

    def _follow_speech(self) -> None:
        """Take what is newly spoken."""
        speech = self._speech
        if speech is not None:
            before = speech.utterance
            if speech.follow(self._session.source.position):
                self.speech_view.grow(0.0 if speech.utterance is None else speech.utterance.duration)
                self._tell(grown=before is not None)

    def _take_text(self) -> None:
        self.refused = None
        self.drivers.performance.set_language(self._language_of_text)
        self.text_changed.emit()

    def _take_words(self) -> None:
        if self.editable:
            self._tell()

    def _take_lexicon(self, path: Path | None, lexicon: Lexicon | None) -> None:
        self.lexicon_path, self._lexicon = path, lexicon
        self.changed.emit()

    def _tell(self, *, grown: bool = False) -> None:
        utterance, speech = self.utterance, self._speech
        if utterance is None or speech is None:
            self.drivers.follow(*self._known_of_file(utterance))
        else:
            self.drivers.follow(utterance, speech.text, spoken=speech.face)
        name, path = self._session.source.name, self.words.sound if self.editable else None
        self.known = None if utterance is None else transcript_of_utterance(utterance, NOTHING, NOTHING, name, path)
        if not grown:
            self.known_changed.emit()
        self.changed.emit()

    def _known_of_file(self, utterance: Utterance | None) -> tuple[Utterance | None, str, MeasuredSound | None]:
        """Return what is said in the current sound file, how it is written, and the file."""
        session, path = self._session, self.words.sound
        sound = None if path is None else MeasuredSound(path, session.channel, session.preset.in_force)
        if utterance is None or path is None:
            return None, "", sound
        return replace(utterance, language=self._language_of_text or utterance.language), self.text, sound
