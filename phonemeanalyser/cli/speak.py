"""``phonemeanalyser speak``: a voice says a text: aloud, or into a sound, labels, and a mouth's movement.

A Chinese text moves the mouth by pinyin, also without a voice, or in step with a recording.
"""

import argparse
import re
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import BinaryIO

from phonemeanalyser.cli.arguments import add_channel, add_overwrite, add_preset, number
from phonemeanalyser.cli.jobs import say_note
from phonemeanalyser.cli.output_files import Guard, write_whole, write_whole_bytes, write_whole_file
from phonemeanalyser.cli.performing import Performing, add_performance, performing
from phonemeanalyser.cli.pinyin import add_pinyin, pinyin_table_of, say_without_voice, write_plan
from phonemeanalyser.cli.scripts import say_misfits
from phonemeengine import (
    FORMATS,
    SAMPLE_RATE,
    Analyser,
    Analysis,
    Animation,
    EngineError,
    ExportOptions,
    IdleMotion,
    Lexicon,
    PinyinTable,
    SpokenSentence,
    Transcript,
    Utterance,
    Voice,
    Word,
    format_utterance,
    load_lexicon,
    load_preset,
    pinyin_track,
    speak_by_program,
)
from phonemeengine.audio.wav import WavEncoder
from phonemeengine.errors import TextError
from phonemeengine.files import printable, read_text_file
from phonemeengine.labels.utterance import shifted
from phonemeengine.live.player import Player
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.mouth.transcript import transcript_of, transcript_of_utterance
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.speech.spooled import SpooledSpeech
from phonemeengine.text import mandarin
from phonemeengine.text.cleaning import speakable

LARGEST = 64 << 20
"""Bytes of a text."""
SILENCE = "sil"
"""The name of what lies between words, in labels."""
LOOK = 0.05
"""Seconds between two looks at what is heard."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is spoken, by whom, and what is written of it."""
    said = parser.add_mutually_exclusive_group(required=True)
    said.add_argument("text", nargs="?", metavar="TEXT", help="what is said")
    said.add_argument("--file", type=Path, metavar="F", help="a text file (UTF-8) of it")
    said.add_argument(
        "--recording", type=Path, metavar="SOUND", help="a sound; its .TextGrid has syllables of pinyin"
    )
    parser.add_argument("--silent", action="store_true", help="a Chinese text without sound")
    driver = "what moves a face (auto: a table of --performance, pinyin for Chinese, else rules)"
    parser.add_argument("--text-driver", choices=["auto", "pinyin", "table", "rules"], default="auto", help=driver)
    parser.add_argument("--language", metavar="L", help="of the text, such as en-us, de, fr, cmn")
    parser.add_argument("--voice", default="", metavar="V", help="another voice, such as f2, m3 or klatt")
    lexicon = "how words are pronounced, .toml or .csv: the voice says those whose sounds it has"
    parser.add_argument("--lexicon", type=Path, metavar="FILE", help=lexicon)
    add_pinyin(parser)
    add_performance(parser)
    program = "another voice: a command that writes a WAV file {output} of {text}, and may write a TextGrid beside it"
    parser.add_argument("--program", metavar="COMMAND", help=program)
    parser.add_argument("-o", "--out", type=Path, metavar="OUT", help="write the sound as WAV (default: play it)")
    parser.add_argument("--labels", type=Path, metavar="OUT", help="write words, syllables and phones as TextGrid")
    parser.add_argument("--export", type=Path, metavar="OUT", help="write the mouth for another program")
    parser.add_argument("--format", choices=FORMATS, dest="kind", metavar="F", help="as `export` has them")
    parser.add_argument("--fps", type=number, metavar="N", help="frames per second (default: the format's)")
    parser.add_argument("--no-blinks", action="store_true", help="keep the eyes open")
    parser.add_argument("--no-head", action="store_true", help="keep the head still")
    add_preset(parser)
    add_channel(parser)
    add_overwrite(parser)


def run(options: argparse.Namespace) -> int:
    """Speak as the command line asks."""
    text = _text_of(options)
    if options.text_driver == "table" and options.performance is None:
        raise EngineError("--text-driver table needs a table of recorded faces; name it with --performance")
    with performing(options, options.text_driver) as performer:
        if options.silent or options.recording is not None:
            say_without_voice(options, text, performer)
        else:
            _speak(options, text, performer)
    return 0


def _speak(options: argparse.Namespace, text: str, performer: Performing | None) -> None:
    written = _Written.of(options, text, performer)
    for note in speakable(text).notes:
        say_note("the text", note)
    sentences = _spoken(options, text)
    if written.nothing:
        _play(sentences)
    else:
        written.write(sentences)


def _text_of(options: argparse.Namespace) -> str:
    if options.file is not None:
        return read_text_file(options.file, LARGEST, "a text", TextError)
    return options.text or ""


def _language_of(options: argparse.Namespace, text: str) -> str:
    """Return the language that is asked for; Chinese characters tell theirs."""
    return options.language or ("cmn" if re.search(mandarin.HANZI, text) else "")


def _spoken(options: argparse.Namespace, text: str) -> Iterator[SpokenSentence]:
    language, lexicon = _language_of(options, text), load_lexicon(options.lexicon) if options.lexicon else Lexicon()
    if options.program is not None:
        return iter([speak_by_program(options.program, text, language=language, lexicon=lexicon)])
    voice = Voice(language, options.voice, options.rate, lexicon, pinyin_table_of(options))
    return _with_notes(voice.speak(text), language)


def _with_notes(sentences: Iterator[SpokenSentence], language: str) -> Iterator[SpokenSentence]:
    """Return sentences as they come, and say once of each word that it is not said as the lexicon has it."""
    told: set[str] = set()
    for sentence in sentences:
        if words := [word for word in dict.fromkeys(sentence.unheeded) if word not in told]:
            note = f"the voice of {language} reads as usual, for want of their sounds: {printable(' '.join(words))}"
            say_note("the lexicon", note)
            told.update(words)
        yield sentence


def _play(sentences: Iterator[SpokenSentence]) -> None:
    """Let the sentences be heard, and print each when it begins."""
    spooled = SpooledSpeech(sentences)
    player = Player(spooled, load_preset(DEFAULT_PRESET))
    shown = -1.0
    try:
        player.play()
        while not player.finished:
            player.take_analyses()
            track = spooled.track_at(player.position)
            if track is not None and track.start > shown:
                print(track.text, flush=True)
                shown = track.start
            time.sleep(LOOK)
        player.take_analyses()
    finally:
        player.close()


@dataclass(frozen=True)
class _Written:
    """What is written of speech; None where it is not asked for."""

    sound: Path | None
    labels: Path | None
    export: Path | None
    plan: Path | None
    exporter: Exporter | None
    language: str
    text: str
    letters: PinyinTable | None
    seed: int | None
    performer: Performing | None
    overwrite: bool

    @classmethod
    def of(cls, options: argparse.Namespace, text: str, performer: Performing | None) -> "_Written":
        """Check what the command line asks for, before anything is spoken."""
        if (options.export is None) != (options.kind is None):
            raise EngineError("--export and --format go together; name both")
        if options.plan is not None and (performer is not None or options.text_driver == "rules"):
            raise EngineError("--plan tells of the pinyin mouth; leave --text-driver rules and --performance out")
        idle = IdleMotion(not options.no_blinks, not options.no_head, options.seed or 0)
        exporter = Exporter(options.kind, ExportOptions(rate=options.fps, idle=idle)) if options.kind else None
        language = _language_of(options, text)
        chinese = language in {*mandarin.TAGS, mandarin.PINYIN_TAG}
        auto = options.text_driver == "auto" and performer is None
        by_letters = options.text_driver == "pinyin" or (auto and chinese)
        written = cls(
            options.out, options.labels, options.export, options.plan, exporter, language, text,
            pinyin_table_of(options) if by_letters or options.plan else None, options.seed, performer,
            options.overwrite,
        )  # fmt: skip
        for target in (written.sound, written.labels, written.export):
            written._guard.check(target)
        return written

    @property
    def nothing(self) -> bool:
        """Whether nothing is written, so that the speech is played."""
        units = self.performer and self.performer.units
        return not any((self.sound, self.labels, self.export, self.plan, units))

    def write(self, sentences: Iterator[SpokenSentence]) -> None:
        """Write what was asked for."""
        said = _Said(loud=self.exporter is not None or self.performer is not None)
        if self.sound is None:
            said.take(sentences, None)
        else:
            write_whole_file(self.sound, lambda file: said.take(sentences, file), self._guard)
        utterance = said.utterance(self.language)
        say_misfits("the sound of the program", utterance)
        if self.labels is not None:
            write_whole(
                self.labels, lambda file: file.writelines([format_utterance(utterance, SILENCE)]), self._guard
            )
        track = (
            None if self.letters is None else pinyin_track(utterance, self.letters, text=self.text, seed=self.seed)
        )
        if self.performer is not None:
            speech = said.transcript(utterance, self.sound)
            self._write_export(speech, self.performer.movement(utterance, speech, self.exporter))
        elif self.exporter is not None:
            speech, moves = said.transcript(utterance, self.sound), self.exporter.format.moves_head
            movement = track.animation(speech, self.exporter.rate, self.exporter.idle) if track and moves else None
            self._write_export(speech, movement)
        if self.plan is not None and track is not None:
            write_plan(track, self.plan)

    def _write_export(self, speech: Transcript, movement: Animation | None) -> None:
        if self.export is not None and self.exporter is not None:
            write_whole_bytes(self.export, self.exporter.chunks_of(speech, movement), self._guard)

    @property
    def _guard(self) -> Guard:
        """What leaves every file alone that is there, as no voice says a text twice in the same way."""
        return Guard(lambda _content: False, self.overwrite)


@dataclass
class _Said:
    """What has been said, and if it is wanted, how loud and high."""

    loud: bool
    words: list[Word] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)
    analyses: list[Analysis] = field(default_factory=list)
    n_samples: int = 0

    def take(self, sentences: Iterator[SpokenSentence], file: BinaryIO | None) -> None:
        """Take sentences as they are spoken; write their sound as WAV."""
        analyser = Analyser(load_preset(DEFAULT_PRESET), pitch=True) if self.loud else None
        encoder = None if file is None else WavEncoder(file, SAMPLE_RATE, 1)
        for sentence in sentences:
            if encoder is not None:
                encoder.write(sentence.samples[:, None])
            if analyser is not None:
                self.analyses.append(analyser.push(sentence.samples))
            self.words += (shifted(word, self.n_samples / SAMPLE_RATE) for word in sentence.words)
            self.skipped += sentence.skipped
            self.n_samples += len(sentence.samples)
        if analyser is not None:
            self.analyses.append(analyser.finish())
        if encoder is not None:
            encoder.close()

    def utterance(self, language: str) -> Utterance:
        """Return all that was said."""
        return Utterance(tuple(self.words), self.n_samples / SAMPLE_RATE, language, tuple(self.skipped))

    def transcript(self, utterance: Utterance, path: Path | None) -> Transcript:
        """Return it as a mouth needs it."""
        name = "text" if path is None else path.name
        heard = transcript_of(self.analyses, name, utterance.duration)
        return transcript_of_utterance(utterance, heard.intensities, heard.pitches, name, path)
