"""``phonemeanalyser record``: a microphone into a file."""

import argparse

from phonemeanalyser.cli.listen import add_input, input_of, record
from phonemeanalyser.cli.parser import file_place
from phonemeengine import load_preset

EXAMPLES = (
    "phonemeanalyser record voice.wav",
    "phonemeanalyser record voice.flac --seconds 5 --phonemes",
    "phonemeanalyser record voice.wav --device Yeti --fill-gaps",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is recorded, and where."""
    parser.add_argument("out", type=file_place, metavar="OUT", help="new .wav or .flac file")
    add_input(parser)
    parser.add_argument("--phonemes", action="store_true", help="write the phonemes too, as OUT.csv")
    parser.add_argument(
        "--fill-gaps",
        action="store_true",
        help="write silence while the microphone is disconnected; gaps are marked anyway",
    )


def run(options: argparse.Namespace) -> int:
    """Record until the time is over, or Ctrl-C."""
    record(
        options.out,
        load_preset(options.preset),
        input_of(options),
        options.seconds,
        with_phonemes=options.phonemes,
        fill_gaps=options.fill_gaps,
    )
    return 0
