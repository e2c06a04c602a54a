"""``phonemeanalyser adapt``: a preset learns one voice and one room, whatever recognises."""

import argparse
from dataclasses import replace
from pathlib import Path

from phonemeanalyser.cli.arguments import add_channel, add_map, add_preset
from phonemeanalyser.cli.jobs import say_cut_off
from phonemeengine import (
    CalibrationResult,
    Channel,
    LabelledUtterance,
    PhonemeMap,
    Preset,
    PresetError,
    SoundReader,
    TakeError,
    calibrate,
    load_phoneme_map,
    load_preset,
    read_recordings,
    save_preset,
)
from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.takes.room_noise import measure_room
from phonemeengine.settings import SAMPLE_RATE

MOST_ROOM = 60
"""Seconds of a room's sound that are read."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is learned from, and what is made of it."""
    parser.epilog = (
        "The learned recogniser is adapted, rules get thresholds, templates become those of the voice. What gets "
        "worse than before by more than 0.01 (mouth shapes, silence) on what is held back is refused."
    )
    parser.add_argument("folders", type=Path, nargs="*", metavar="FOLDER", help="takes, or labelled recordings")
    parser.add_argument("-o", "--out", type=Path, required=True, metavar="PRESET", help="the new preset, .toml")
    add_preset(parser, words="preset to begin with (default: learned)")
    parser.add_argument(
        "--held-back", type=Path, nargs="+", default=[], metavar="FILE",
        help="labelled recordings of the voice to judge by, never learned from (default: quarters of the others)",
    )  # fmt: skip
    parser.add_argument(
        "--room", type=Path, metavar="SOUND", help="seconds of the room in which nobody speaks (default: the takes')"
    )
    add_map(parser)
    add_channel(parser)


def run(options: argparse.Namespace) -> int:
    """Calibrate; returns the exit code."""
    if options.out.suffix.lower() != ".toml":
        raise PresetError(f"{options.out}: an adapted preset's file ends in .toml; name it so")
    if not options.folders and options.room is None:
        options.parser.error("give a FOLDER of takes, or --room with the sound of a room")
    preset = load_preset(options.preset)
    room = _sound_of(options.room, options.channel) if options.room else None
    if options.folders:
        found = _calibrated(preset, room, options)
    else:
        assert room is not None
        found = _with_silence(preset, room, options)
    save_preset(replace(found, name=options.out.stem), options.out)
    return 0


def _calibrated(preset: Preset, room: Float32Array | None, options: argparse.Namespace) -> Preset:
    mapping = load_phoneme_map(options.map) if options.map else PhonemeMap()
    takes, held_back = (_read(sources, mapping, options.channel) for sources in (options.folders, options.held_back))
    say_cut_off([*takes, *held_back])
    result = calibrate(preset, takes, held_back=held_back, room=room)
    seconds = sum(utterance.labels[-1].end for utterance in takes if utterance.labels)
    print(f"{options.out}: {len(takes)} recordings, {seconds:.0f} s; {_gain_in_words(result)}")
    for sentence in (result.refusal, f"{result.silence_accuracy}." if result.silence_accuracy else ""):
        if sentence:
            print(sentence)
    return result.preset


def _with_silence(preset: Preset, room: Float32Array, options: argparse.Namespace) -> Preset:
    measured = measure_room(room, preset)
    if measured.notes:
        raise TakeError(f"{options.room.name}: {measured.notes[0]}")
    found = measured.set_silence(preset)
    print(f"{options.out}: a room of {measured}; {measured.silence_accuracy(found)}.")
    return found


def _gain_in_words(result: CalibrationResult) -> str:
    """Return what was gained, and on what that was measured."""
    one, other = result.before, result.after
    where = "quarters held back in turn" if result.cross_validated else "what was held back"
    on = f"on {where}, {result.seconds:.0f} s"
    if not result.gains:
        return f"nothing better was found {on} (macro F1 {one.macro_f1:.1%}); unchanged"
    return (
        f"{on}: macro F1 {one.macro_f1:.1%} -> {other.macro_f1:.1%}, mouth shapes {one.viseme_accuracy:.1%} -> "
        f"{other.viseme_accuracy:.1%}, silence found {one.silence_recall:.1%} -> {other.silence_recall:.1%}, "
        f"speech called silence {one.false_silence:.1%} -> {other.false_silence:.1%}"
    )


def _read(sources: list[Path], mapping: PhonemeMap, channel: Channel) -> list[LabelledUtterance]:
    return [utterance for source in sources for utterance in read_recordings(source, mapping, channel=channel)]


def _sound_of(path: Path, channel: Channel) -> Float32Array:
    with SoundReader(path, channel) as reader:
        return reader.read_mono(MOST_ROOM * SAMPLE_RATE)
