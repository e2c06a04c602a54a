"""``phonemeanalyser speak``: a mouth says a Chinese text, without sound or in step with a recording of it."""

import argparse
import sys
from dataclasses import replace
from pathlib import Path

from phonemeanalyser.cli.arguments import add_channel, add_overwrite, add_preset, number
from phonemeanalyser.cli.output_files import Guard, write_whole_bytes
from phonemeanalyser.cli.pinyin import add_pinyin, pinyin_table_of, write_plan
from phonemeengine import (
    FORMATS,
    EngineError,
    ExportOptions,
    IdleMotion,
    PinyinTrack,
    SoundReader,
    Transcript,
    load_preset,
    pinyin_track,
    read_syllables,
    transcribe,
)
from phonemeengine.files import read_text_file
from phonemeengine.mouth.exports.exporter import Exporter

LARGEST_TEXT = 16 << 20
"""Bytes of a text."""
SHOWN = 8
"""Words that are named of those that are not said."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is spoken, how, and what is written of it."""
    said = parser.add_mutually_exclusive_group(required=True)
    said.add_argument("text", nargs="?", metavar="TEXT", help="a Chinese text")
    said.add_argument("--file", type=Path, metavar="F", help="a file of it, UTF-8")
    said.add_argument("--recording", type=Path, metavar="SOUND", help="a sound; its .TextGrid has the syllables")
    parser.add_argument("--silent", action="store_true", help="without sound")
    parser.add_argument(
        "--text-driver", choices=["auto", "pinyin", "rules"], default="auto", help="what moves a face (auto: pinyin)"
    )
    add_pinyin(parser)
    parser.add_argument("--export", type=Path, metavar="OUT", help="write the mouth for another program")
    parser.add_argument("--format", choices=FORMATS, dest="kind", metavar="F", help="as `export` has them")
    parser.add_argument("--fps", type=number, metavar="N", help="frames per second (default: the format's)")
    parser.add_argument("--no-blinks", action="store_true", help="keep the eyes open")
    parser.add_argument("--no-head", action="store_true", help="keep the head still")
    add_preset(parser)
    add_channel(parser)
    add_overwrite(parser)


def run(options: argparse.Namespace) -> int:
    """Write what the command line asks for."""
    _check(options)
    exporter = _exporter_of(options) if options.export else None
    track, speech = _said(options)
    if track.utterance.skipped:
        print(_skipped(track.utterance.skipped), file=sys.stderr)
    if exporter is not None:
        _export(options, exporter, track, speech)
    if options.plan is not None:
        write_plan(track, options.plan)
    return 0


def _check(options: argparse.Namespace) -> None:
    if options.plan is None and options.export is None:
        raise EngineError("there is nothing to write; ask for the plan with --plan, or for a file with --export")
    if (options.export is None) != (options.kind is None):
        raise EngineError("--export and --format go together; name both")
    if options.recording is None and not options.silent:
        raise EngineError("a text has no voice here; have it said without sound, with --silent")


def _exporter_of(options: argparse.Namespace) -> Exporter:
    idle = IdleMotion(not options.no_blinks, not options.no_head, options.seed or 0)
    exporter = Exporter(options.kind, ExportOptions(rate=options.fps, idle=idle))
    Guard(exporter.format.owns, options.overwrite).check(options.export)
    return exporter


def _said(options: argparse.Namespace) -> tuple[PinyinTrack, Transcript]:
    """Return what is said, and how loud and high."""
    table = pinyin_table_of(options)
    if options.recording is None:
        text = options.text if options.file is None else _read(options.file)
        track = pinyin_track(text, table, rate=options.rate, seed=options.seed)
        return track, track.silent_transcript(options.file.name if options.file else "text")
    with SoundReader(options.recording, options.channel) as reader:
        duration = reader.duration
    said = read_syllables(options.recording.with_suffix(".TextGrid"), duration)
    track = pinyin_track(said, table, seed=options.seed)
    heard = transcribe(options.recording, load_preset(options.preset), channel=options.channel, pitch=True)
    return track, replace(heard, runs=track.runs(heard.duration))


def _read(path: Path) -> str:
    return read_text_file(path, LARGEST_TEXT, "a text", EngineError)


def _export(options: argparse.Namespace, exporter: Exporter, track: PinyinTrack, speech: Transcript) -> None:
    """Write a movement by the letters, or drawings and other movestates by the phones."""
    by_letters = exporter.format.moves_head and options.text_driver != "rules"
    if options.text_driver == "pinyin" and not by_letters:
        print(f"phonemeanalyser: {exporter.name} has shapes of its own, which follow the phones", file=sys.stderr)
    movement = track.animation(speech, exporter.rate, exporter.idle) if by_letters else None
    guard = Guard(exporter.format.owns, options.overwrite)
    write_whole_bytes(options.export, exporter.chunks_of(speech, movement), guard)


def _skipped(words: tuple[str, ...]) -> str:
    named = ", ".join(repr(word[:20]) for word in words[:SHOWN]) + (" ..." if len(words) > SHOWN else "")
    return f"phonemeanalyser: {named} is no Chinese, and so not said without a voice"
