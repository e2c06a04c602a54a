"""What is said in a sound, as the engine finds it: in files beside it, by its script, or as a voice speaks it."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.settings import outside_program
from phonemeanalyser.desktop.talk.words.voice_model import VoiceChoice
from phonemeengine.alignment.align import align_analyses, align_word
from phonemeengine.analyser import Analysis, analyse_file
from phonemeengine.audio.files import SoundReader
from phonemeengine.conversion.speech_files import SILENCE
from phonemeengine.errors import AudioError, EngineError, VoiceError
from phonemeengine.execution import Progress, report_progress
from phonemeengine.labels import textgrid
from phonemeengine.labels.table import write_text
from phonemeengine.labels.timed_words import TimedWord, read_timed_words, speakers_in
from phonemeengine.labels.utterance import Utterance, Word
from phonemeengine.labels.utterance_files import format_utterance, read_utterance, tells_sounds
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, Channel
from phonemeengine.speech.program import speak_by_program
from phonemeengine.speech.spoken_text import spoken_text
from phonemeengine.speech.voice import SpokenSentence, Voice
from phonemeengine.storage.files import atomic_write, is_own, printable_name, reason_of
from phonemeengine.text.lexicon import Lexicon, spoken_syllables
from phonemeengine.text.pronunciation import Pronunciation, ScriptWord, timed_words_of, words_of
from phonemeengine.text.script import is_timed, load_script, script_beside

LABELS = ".TextGrid"


@dataclass(frozen=True)
class ScriptedSound:
    """A sound and its text.

    Attributes
    ----------
    sound : the file.
    channel : which channel of it is analysed.
    preset : what to recognise with.
    text, language : what is said in it; the language as `languages` has it.
    lexicon : goes before the language's voice, where there is one.
    literal : whether the notation of scripts is words, too.
    accepted : whether the text is aligned even where another one seems to be said.
    timed : the words of the text with their times, where these are known.
    """

    sound: Path
    channel: Channel
    preset: Preset
    text: str
    language: str
    lexicon: Lexicon | None = None
    literal: bool = False
    accepted: bool = False
    timed: tuple[TimedWord, ...] = ()


@dataclass(frozen=True)
class FoundWords:
    """What lies beside a sound.

    Attributes
    ----------
    utterance : what is said when; None where there are no labels.
    text : what is said; empty where there is no script.
    timed : the words of the text with their times, where labels tell these.
    speakers : whom the labels tell apart.
    script : the file of the labels.
    """

    utterance: Utterance | None = None
    text: str = ""
    timed: tuple[TimedWord, ...] = ()
    speakers: tuple[str, ...] = ()
    script: Path | None = None


def aligned(script: ScriptedSound, progress: Progress) -> Utterance:
    """Return where the words of a text are in its sound.

    Raises
    ------
    EngineError : the sound cannot be read, or there is nothing to say in the text.
    Cancelled : it is not wanted any more.
    """
    if script.timed:
        words = timed_words_of(script.timed, script.language, script.lexicon)
    else:
        words = words_of(script.text, script.language, script.lexicon, literal=script.literal)
    with SoundReader(script.sound, script.channel) as reader:

        def analyses() -> Iterator[Analysis]:
            for analysis in analyse_file(reader, script.preset):
                end = (analysis.start + len(analysis)) * FRAME_PERIOD
                report_progress(progress, min(1.0, end / max(reader.duration, FRAME_PERIOD)))
                yield analysis

        return align_analyses(analyses(), words, reader.duration, script.language, accept_text=script.accepted)


@dataclass(frozen=True)
class WordInSound:
    """A word that is to be found in a part of a sound.

    Attributes
    ----------
    sound, channel, preset : as those of a `ScriptedSound`.
    name : as the user wrote it: a word, IPA between slashes, or both.
    language, lexicon : how it is pronounced.
    span : where it is said, start and end, seconds.
    """

    sound: Path
    channel: Channel
    preset: Preset
    name: str
    language: str
    lexicon: Lexicon | None
    span: tuple[float, float]


IPA = re.compile(r"(?P<word>[^/]*)/(?P<ipa>[^/]+)/")


def found_word(asked: WordInSound) -> Word:
    """Return a word with its phones where they fit the sound best within its span.

    Raises
    ------
    EngineError : it cannot be pronounced, or the sound cannot be read.
    """
    name = asked.name.strip()
    if written := IPA.fullmatch(name):
        ipa, text = written["ipa"].strip(), written["word"].strip() or written["ipa"].strip()
        word = ScriptWord(text, (Pronunciation(spoken_syllables(ipa, text, tr("word"))),))
    else:
        words = words_of(name, asked.language, asked.lexicon, literal=True)
        syllables = tuple(syllable for word in words for syllable in word.pronunciations[0].syllables)
        variants = words[0].pronunciations if len(words) == 1 else (Pronunciation(syllables),)
        word = ScriptWord(name, variants)
    return align_word(asked.sound, word, asked.span, asked.preset, channel=asked.channel)


def spoken(text: str, language: str, voice: VoiceChoice) -> Iterator[SpokenSentence]:
    """Return a text as a voice of espeak-ng or recordings speak it, sentence by sentence, or whole as a program does.

    Raises
    ------
    EngineError : it cannot be spoken; before anything is.
    """
    if voice.by_program:
        lexicon, literal = voice.lexicon, voice.literal
        return iter([speak_by_program(voice.program, text, language=language, lexicon=lexicon, literal=literal)])
    if voice.own_sound and voice.recordings is None:
        raise VoiceError(tr("No table of recorded faces is open that could speak; open one, or choose a voice."))
    sentences = Voice(language, voice.name, voice.rate, voice.lexicon or Lexicon()).speak(text, literal=voice.literal)
    return sentences if voice.recordings is None else voice.recordings.follow(sentences)


def write_speech(sentences: Iterable[SpokenSentence], language: str, path: Path) -> None:
    """Write what is spoken as WAV, and what is said in it as a TextGrid beside it; the first, or both, or nothing.

    Raises
    ------
    EngineError : it cannot be spoken, or not be written, or a TextGrid is there that is not of the sound's file.
    """
    labels = path.with_suffix(LABELS)
    if labels.is_file() and not (path.is_file() and is_own(labels, textgrid.owns)):
        words = tr(
            "{labels}: this file exists beside the audio file and would be overwritten; choose another "
            "name for the audio file"
        )
        raise AudioError(words.format(labels=printable_name(labels)))
    try:
        with atomic_write(path) as file:
            said = spoken_text(sentences, language=language, sound=file, path=path, measured=False).utterance
    except EngineError:
        raise
    except (OSError, ValueError) as error:
        raise AudioError(
            tr("{path}: cannot be written ({reason_of}); choose another folder").format(
                path=printable_name(path), reason_of=reason_of(error)
            )
        ) from error
    write_text(format_utterance(said, SILENCE), labels)  # as the command `speak` writes them


def words_beside(sound: Path, duration: float) -> FoundWords:
    """Return what is known of a sound of `duration` seconds: ``x.TextGrid`` and ``x.txt`` beside ``x.wav``.

    Of labels without phones, or syllables of pinyin, the words are the script, and have times.

    Raises
    ------
    EngineError : a file there cannot be read, or its labels are of no use.
    """
    script, labels = script_beside(sound), outside_program(sound).with_suffix(LABELS)
    text = script.text if script is not None else ""
    if not labels.is_file():
        return FoundWords(None, text)
    found = words_in(labels, sound, duration)
    return replace(found, text=found.text or text)


def words_in(path: Path, sound: Path, duration: float, speaker: str | None = None) -> FoundWords:
    """Return what a script says of a sound of `duration` seconds: a text, words with times, or phones too.

    Where it tells speakers apart and none is chosen, it is only told who they are.

    Raises
    ------
    EngineError : it cannot be read, or is of no use.
    """
    if not is_timed(path):
        return FoundWords(None, load_script(path).texts_of([sound])[0][sound])
    speakers = speakers_in(path)
    if speaker is None and len(speakers) > 1:
        return FoundWords(speakers=speakers, script=path)
    if path.suffix.lower() == LABELS.lower() and tells_sounds(path, speaker):
        said = read_utterance(path, duration, speaker=speaker)
        return FoundWords(said, speakers=speakers, script=path)
    timed = read_timed_words(path, duration, speaker)
    return FoundWords(None, " ".join(word.text for word in timed), timed, speakers, path)
