"""``phonemeanalyser speak``: a voice says a text: aloud, or into a sound, labels, and a mouth's movement.

A mouth moves also without sound, or in step with a recording; by pinyin, where the text is Chinese.
"""

import argparse
import re
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import phonemeengine
from phonemeanalyser.cli.arguments import MOVED, add_options, format_of, given, refuse_unused
from phonemeanalyser.cli.jobs import say_note
from phonemeanalyser.cli.parser import number
from phonemeengine.audio.output import Output, open_output
from phonemeengine.conversion.driving import DriverChoice, Driving
from phonemeengine.conversion.options import DRIVEN, ConversionOptions
from phonemeengine.conversion.speech_files import SpeechFiles
from phonemeengine.conversion.spoken_texts import say_misfits
from phonemeengine.labels.utterance_files import read_utterance
from phonemeengine.live.player import Player
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.speech.pinyin.timing import FASTEST, SLOWEST, USUAL_RATE
from phonemeengine.speech.silent import ENGLISH
from phonemeengine.speech.spooled import SpooledSpeech
from phonemeengine.speech.voice import SpokenSentence
from phonemeengine.storage.files import printable, read_text_file
from phonemeengine.text import mandarin
from phonemeengine.text.espeak import language_of
from phonemeengine.text.pronunciation import notes_on
from phonemeengine.text.script import LARGEST

LOOK = 0.05
"""Seconds between two looks at what is playing."""
SHOWN = 8
"""Words that are named of those that are not said."""
EXPORTED = ("format", "table", "fps", "minimum", *(name for name in MOVED if name != "seed"))
"""Options of exports alone; the seed varies pinyin, too."""
_KANA = "[\u3040-\u30ff]"

EXAMPLES = (
    'phonemeanalyser speak "Hello, how are you?" --language en-us -o hello.wav',
    "phonemeanalyser speak --file speech.txt --language en-us -o spoken.wav --labels spoken.TextGrid",
    "phonemeanalyser speak 你好。 --silent --export face.csv --format livelink-csv",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is spoken, by whom, and what is written of it."""
    said = parser.add_mutually_exclusive_group(required=True)
    said.add_argument("text", nargs="?", metavar="TEXT", help="text to speak")
    said.add_argument("--file", type=Path, metavar="F", help="text file or Word document (.docx) to speak")
    said.add_argument(
        "--recording", type=Path, metavar="SOUND", help="audio file whose .TextGrid has syllables of pinyin"
    )
    _add_voice(parser)
    _add_files(parser)
    add_options(
        parser, "table", "fps", "minimum", *MOVED, *DRIVEN, "performance-sound", "preset", "channel", "overwrite"
    )


def run(options: argparse.Namespace) -> int:
    """Speak as the command line asks."""
    text = _text_of(options)
    asked = given(options, text=text)
    with DriverChoice.of(asked).opened(_language_of(options, text)) as driving:
        driving.say_notes(say_note)
        files = _files_of(options, asked, driving)
        if options.silent or options.recording is not None:
            _check_without_voice(options, files)
            _move_without_voice(options, files, text)
        elif files.nothing:
            play_aloud(driving.spoken(_spoken(options, text, driving), say_note))
        else:
            sentences = driving.spoken(_spoken(options, text, driving), say_note)
            files.write_spoken(sentences, _language_of(options, text), text)
    return 0


def _add_voice(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--voice", default="", metavar="V", help="variant of the voice, such as f2, m3 or klatt")
    rate = f"syllables per second; without sound {SLOWEST:g}..{FASTEST:g} (default: {USUAL_RATE:g})"
    parser.add_argument("--rate", type=number, default=USUAL_RATE, metavar="N", help=rate)
    program = "another voice: a command that writes {text} as the WAV file {output}, and optionally a TextGrid"
    add_options(parser, "language", "lexicon", "literal")
    parser.add_argument("--program", metavar="COMMAND", help=program)
    parser.add_argument("--silent", action="store_true", help="make no sound; Chinese needs no voice then")


def _add_files(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("-o", "--out", type=Path, metavar="OUT", help="write a WAV file (default: play the speech)")
    parser.add_argument("--labels", type=Path, metavar="OUT", help="write words, syllables and phones as a TextGrid")
    parser.add_argument("--export", type=Path, metavar="OUT", help="write facial animation or mouth cues")
    add_options(parser, "format")
    parser.add_argument(
        "--plan", type=Path, metavar="OUT", help="write the syllables with their times as CSV; - prints them"
    )


def _files_of(options: argparse.Namespace, asked: ConversionOptions, driving: Driving) -> SpeechFiles:
    """Return what is written, after checking that it can be."""
    exporter = None
    if options.export is not None:
        exporter = Exporter(asked.format or format_of(options, options.export), asked.written())
    else:
        refuse_unused(options, EXPORTED, "goes with --export; name a file there")
    if options.recording is None:
        refuse_unused(options, ("preset", "channel"), "goes with --recording; name an audio file there")
    return SpeechFiles(
        options.out, options.labels, options.export, options.plan, exporter, driving, say_note, asked.overwrite
    )


def _text_of(options: argparse.Namespace) -> str:
    if options.file is not None:
        return read_text_file(options.file, LARGEST, "a text", phonemeengine.TextError)
    return options.text or ""


def _language_of(options: argparse.Namespace, text: str) -> str:
    """Return the language that is asked for; Chinese characters tell theirs, unless there is Japanese."""
    chinese = re.search(mandarin.HANZI, text) and not re.search(_KANA, text)
    return options.language or ("cmn" if chinese else "")


def _spoken(options: argparse.Namespace, text: str, driving: Driving) -> Iterator[SpokenSentence]:
    """Return what a voice or a program says, and say what of the text it does not."""
    language, lexicon = (
        _language_of(options, text),
        phonemeengine.load_lexicon(options.lexicon) if options.lexicon else phonemeengine.Lexicon(),
    )
    if options.program is None:
        voice = phonemeengine.Voice(language, options.voice, options.rate, lexicon, driving.pinyin)
        sentences = _with_notes(voice.speak(text, literal=options.literal), language)
    else:
        sentence = phonemeengine.speak_by_program(
            options.program, text, language=language, lexicon=lexicon, literal=options.literal
        )
        said = phonemeengine.Utterance(sentence.words, sentence.duration, language, sentence.skipped)
        say_misfits("the sound of the program", said, say_note)
        sentences = iter([sentence])
    for note in notes_on(text, language, literal=options.literal):
        say_note("the text", note)
    return sentences


def _with_notes(sentences: Iterator[SpokenSentence], language: str) -> Iterator[SpokenSentence]:
    """Return sentences as they come, and say once of each word that it is not said, or not as the lexicon has it."""
    told: set[str] = set()
    for sentence in sentences:
        if words := [word for word in dict.fromkeys(sentence.unheeded) if word not in told]:
            note = f"the voice of {language} reads as usual, for want of their sounds: {printable(' '.join(words))}"
            say_note("the lexicon", note)
        if characters := [character for character in dict.fromkeys(sentence.skipped) if character not in told]:
            say_note(
                "the text", f"the pronunciation of these is unknown, so they are left out: {' '.join(characters)}"
            )
        told.update(words, characters)
        yield sentence


def play_aloud(sentences: Iterable[SpokenSentence], open_device: Callable[[int], Output] = open_output) -> None:
    """Play sentences to the end, and print each when it begins; a card that sleeps or goes is waited for.

    Parameters
    ----------
    sentences : as they come.
    open_device : opens the output for a number of channels.

    Raises
    ------
    DeviceError : there is no sound card, or it has gone and does not come back.
    """
    spooled = SpooledSpeech(sentences)
    player = Player(spooled, phonemeengine.load_preset(DEFAULT_PRESET), open_device, waits=True)
    try:
        player.play()
        _follow(player, spooled)
    except phonemeengine.DeviceError as error:
        raise phonemeengine.DeviceError(
            f"{error}; to write the sound into a file instead, name it with -o"
        ) from error
    finally:
        player.close()


def _follow(player: Player, spooled: SpooledSpeech) -> None:
    """Print what is playing, and report when the sound card takes no sound."""
    shown, was_heard = -1.0, False
    while not player.finished:
        player.take_analyses()
        if was_heard and not player.has_card:
            say_note("the sound card", "it takes no sound any more; the speech waits for it, and goes on from there")
        was_heard = player.has_card
        track = spooled.track_at(player.position)
        if was_heard and track is not None and track.start > shown:
            print(track.text, flush=True)
            shown = track.start
        time.sleep(LOOK)
    player.take_analyses()


def _check_without_voice(options: argparse.Namespace, files: SpeechFiles) -> None:
    if options.performance_sound:
        raise phonemeengine.EngineError(
            "without sound no recording speaks; leave --performance-sound, --silent or --recording out"
        )
    if files.nothing:
        raise phonemeengine.EngineError(
            "there is nothing to write; ask for the plan with --plan, or for a file with --export"
        )
    if files.sound is not None or files.labels is not None:
        raise phonemeengine.EngineError(
            "without a voice there are no sound and labels to write; leave --silent or --recording out"
        )
    if options.lexicon is not None and options.recording is not None:
        raise phonemeengine.EngineError(
            "a lexicon is for a text, and says nothing of a recording; leave --lexicon out"
        )


def _move_without_voice(options: argparse.Namespace, files: SpeechFiles, text: str) -> None:
    """Write the mouth of a text without sound, or of a recording with its labels."""
    if options.recording is not None:
        files.write_said(*_labelled(options))
        return
    lexicon = phonemeengine.load_lexicon(options.lexicon) if options.lexicon else phonemeengine.Lexicon()
    silent = phonemeengine.SilentText(
        text, _language_of(options, text), files.driving.pinyin, options.rate, options.seed, lexicon, options.literal
    )
    if skipped := files.write_silent(silent, options.file.name if options.file else "text"):
        named = ", ".join(repr(word[:20]) for word in skipped[:SHOWN]) + (" ..." if len(skipped) > SHOWN else "")
        say_note("the text", f"{named} has no sound that is known, and is left out{_missing(skipped)}")


def _labelled(options: argparse.Namespace) -> tuple[phonemeengine.Utterance, phonemeengine.Transcript]:
    """Return what is said in ``--recording``, as the TextGrid beside it has it, and how loud and high."""
    with phonemeengine.SoundReader(options.recording, options.channel) as reader:
        labels = read_utterance(options.recording.with_suffix(".TextGrid"), reader.duration)
    utterance = replace(labels, language=options.language or "")
    preset = phonemeengine.load_preset(options.preset)
    felt = given(options).feeling is not None
    speech = phonemeengine.transcribe(
        options.recording, preset, channel=options.channel, pitch=True, script=utterance, felt=felt
    )
    return utterance, speech


def _missing(skipped: Sequence[str]) -> str:
    """Return what to install for Latin words that are not spoken in Chinese; empty where there are none, or it is."""
    try:
        if any(word[0].isascii() for word in skipped):
            language_of(ENGLISH)
    except phonemeengine.VoiceError as error:
        return f"; {error}"
    return ""
