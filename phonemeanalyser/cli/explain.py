"""``phonemeanalyser explain``: the rules of a preset as text, and why a phoneme was recognised at a time."""

import argparse
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from phonemeanalyser.cli.arguments import HEARD, add_options
from phonemeanalyser.cli.jobs import file_preset
from phonemeanalyser.cli.parser import number_in
from phonemeengine import Preset, SoundReader
from phonemeengine.analyser import Analysis, analyse_file, analyse_range
from phonemeengine.errors import AudioError, OptionError
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import rule_lines, rules_of, trace_lines
from phonemeengine.recognition.spec import recogniser_of
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.storage.files import printable_name
from phonemeengine.storage.replacing import guarded_text

MOST_SECONDS = 86_400.0

EXAMPLES = (
    "phonemeanalyser explain --preset extended",
    "phonemeanalyser explain speech.wav --preset thesis --at 0.5 0.8",
    "phonemeanalyser explain speech.wav --preset extended --at 1 -o why.txt",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is explained."""
    parser.add_argument(
        "sound",
        type=Path,
        nargs="?",
        metavar="SOUND",
        help="audio file, to find rules that never or always hold in it",
    )
    parser.add_argument(
        "--at",
        type=number_in(0, MOST_SECONDS, "s"),
        nargs="+",
        default=[],
        metavar="S",
        help="times in the sound, seconds: print why the phoneme there was recognised",
    )
    parser.add_argument("-o", "--out", type=Path, metavar="OUT", help="text to write (default: print)")
    add_options(parser, *HEARD, "overwrite")


def run(options: argparse.Namespace) -> int:
    """Explain; returns the exit code."""
    if options.at and options.sound is None:
        raise OptionError("--at goes with an audio file; give SOUND")
    preset = file_preset(options)
    lines = list(_lines_of(preset, options))
    with guarded_text(options.out) as file:
        file.writelines(f"{line}\n" for line in lines)
    return 0


def _lines_of(preset: Preset, options: argparse.Namespace) -> Iterator[str]:
    if options.at:
        for at in options.at:
            yield from _why(options, at, preset)
        return
    features = None
    if options.sound is not None and rules_of(preset):
        with SoundReader(options.sound, options.channel) as reader:
            features = _joined([analysis.features for analysis in analyse_file(reader, preset)])
    yield from rule_lines(preset, features)


def _why(options: argparse.Namespace, at: float, preset: Preset) -> Iterator[str]:
    """Yield what was recognised in the frame at a time, and why."""
    first = round(at / FRAME_PERIOD)
    with SoundReader(options.sound, options.channel) as reader:
        found = list(analyse_range(reader, first, first + 1, preset, pitch=True))
    if not found:
        raise AudioError(f"{printable_name(options.sound)}: it ends before {at:g} s; name an earlier time")
    analysis = found[0]
    yield f"{at:.2f} s: {_named(analysis)}"
    recogniser = recogniser_of(preset.recogniser, preset.config)
    yield from (f"  {line}" for line in trace_lines(recogniser.explain(analysis.features, 0), preset.variables))


def _named(analysis: Analysis) -> str:
    shown, recognised = (Phoneme(int(codes[0])).label for codes in (analysis.phonemes, analysis.recognised))
    return shown if shown == recognised else f"{recognised}, and {shown} after smoothing"


def _joined(parts: Sequence[Features]) -> Features | None:
    return Features(parts[0].names, np.concatenate([part.values for part in parts])) if parts else None
