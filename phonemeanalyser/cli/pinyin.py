"""The pinyin mouth, for commands that speak: its options, its plan, and what it says without a voice."""

import argparse
import sys
from dataclasses import replace
from pathlib import Path

from phonemeanalyser.cli.arguments import number
from phonemeanalyser.cli.output_files import Guard, print_whole, write_whole, write_whole_bytes
from phonemeanalyser.cli.performing import Performing, labelled
from phonemeengine import (
    Animation,
    EngineError,
    ExportOptions,
    IdleMotion,
    PinyinTable,
    PinyinTrack,
    SoundReader,
    Spring,
    Transcript,
    format_plan,
    load_pinyin_table,
    load_preset,
    pinyin_track,
    read_utterance,
    transcribe,
)
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.speech.pinyin.timing import FASTEST, SLOWEST, USUAL_RATE

STANDARD_OUTPUT = Path("-")
SHOWN = 8
"""Words that are named of those that are not said."""


def add_pinyin(parser: argparse.ArgumentParser) -> None:
    """Let the user choose letters, speed and springs of the pinyin mouth, and have its plan."""
    parser.add_argument("--pinyin-table", type=Path, metavar="T", help="a pinyin table (.toml) of yours")
    rate = f"syllables a second without sound, {SLOWEST:g}..{FASTEST:g} ({USUAL_RATE:g})"
    parser.add_argument("--rate", type=number, default=USUAL_RATE, metavar="N", help=rate)
    parser.add_argument("--seed", type=int, metavar="N", help="vary onsets, and make another face (default: neither)")
    parser.add_argument("--spring", metavar="M,K,D", help="a spring moves the mouth: mass, stiffness, damping")
    parser.add_argument("--plan", type=Path, metavar="OUT", help="write syllables and pauses as CSV; - prints it")


def pinyin_table_of(options: argparse.Namespace) -> PinyinTable:
    """Return the table that the command line asks for."""
    table = load_pinyin_table(options.pinyin_table) if options.pinyin_table else load_pinyin_table()
    return table if options.spring is None else replace(table, spring=Spring.of(options.spring))


def write_plan(track: PinyinTrack, target: Path) -> None:
    """Write the plan of a track as CSV, or print it."""
    text = format_plan(track.plan)
    if target == STANDARD_OUTPUT:
        print_whole(lambda file: file.writelines([text]))
    else:
        write_whole(target, lambda file: file.writelines([text]))


def say_without_voice(options: argparse.Namespace, text: str, performer: Performing | None) -> None:
    """Write what the command line asks for of a text without sound, or of a recording with its labels.

    Parameters
    ----------
    performer : how a table of recorded faces moves the face, if one does.
    """
    _check(options, performer)
    exporter = _exporter_of(options) if options.export else None
    if performer is not None and options.recording is not None:
        utterance, speech = labelled(options)
        _write(options, exporter, speech, performer.movement(utterance, speech, exporter))
        return
    track, speech = _said(options, text)
    if track.utterance.skipped:
        print(_skipped(track.utterance.skipped), file=sys.stderr)
    if performer is not None:
        _write(options, exporter, speech, performer.movement(track.utterance, speech, exporter))
    elif exporter is not None:
        _export(options, exporter, track, speech)
    if options.plan is not None:
        write_plan(track, options.plan)


def _check(options: argparse.Namespace, performer: Performing | None) -> None:
    if options.plan is not None and performer is not None:
        raise EngineError("--plan tells of the pinyin mouth; leave --performance out")
    if options.plan is None and options.export is None and (performer is None or performer.units is None):
        raise EngineError("there is nothing to write; ask for the plan with --plan, or for a file with --export")
    if (options.export is None) != (options.kind is None):
        raise EngineError("--export and --format go together; name both")
    if options.out is not None or options.labels is not None:
        raise EngineError("without a voice there are no sound and labels to write; leave --silent or --recording out")
    if options.lexicon is not None:
        raise EngineError("a lexicon is for a voice, and without one it says nothing; leave --lexicon out")


def _exporter_of(options: argparse.Namespace) -> Exporter:
    idle = IdleMotion(not options.no_blinks, not options.no_head, options.seed or 0)
    exporter = Exporter(options.kind, ExportOptions(rate=options.fps, idle=idle))
    Guard(exporter.format.owns, options.overwrite).check(options.export)
    return exporter


def _said(options: argparse.Namespace, text: str) -> tuple[PinyinTrack, Transcript]:
    """Return what is said, and how loud and high."""
    table = pinyin_table_of(options)
    if options.recording is None:
        track = pinyin_track(text, table, rate=options.rate, seed=options.seed)
        return track, track.silent_transcript(options.file.name if options.file else "text")
    with SoundReader(options.recording, options.channel) as reader:
        duration = reader.duration
    said = read_utterance(options.recording.with_suffix(".TextGrid"), duration)
    track = pinyin_track(said, table, seed=options.seed)
    heard = transcribe(options.recording, load_preset(options.preset), channel=options.channel, pitch=True)
    return track, replace(heard, runs=track.runs(heard.duration))


def _export(options: argparse.Namespace, exporter: Exporter, track: PinyinTrack, speech: Transcript) -> None:
    """Write a movement by the letters, or drawings and other movestates by the phones."""
    by_letters = exporter.format.moves_head and options.text_driver != "rules"
    if options.text_driver == "pinyin" and not by_letters:
        print(f"phonemeanalyser: {exporter.name} has shapes of its own, which follow the phones", file=sys.stderr)
    movement = track.animation(speech, exporter.rate, exporter.idle) if by_letters else None
    _write(options, exporter, speech, movement)


def _write(
    options: argparse.Namespace, exporter: Exporter | None, speech: Transcript, movement: Animation | None
) -> None:  # fmt: skip
    if exporter is not None:
        guard = Guard(exporter.format.owns, options.overwrite)
        write_whole_bytes(options.export, exporter.chunks_of(speech, movement), guard)


def _skipped(words: tuple[str, ...]) -> str:
    named = ", ".join(repr(word[:20]) for word in words[:SHOWN]) + (" ..." if len(words) > SHOWN else "")
    return f"phonemeanalyser: {named} is no Chinese, and so not said without a voice"
