"""``phonemeanalyser [FILE]``: the window."""

import argparse
import gc
import os
import sys
from pathlib import Path

from phonemeanalyser.cli.parser import add_declared
from phonemeanalyser.cli.requirements import load_desktop, why_no_window
from phonemeanalyser.licences import licences_text
from phonemeengine import __version__
from phonemeengine.conversion.option import RECOGNITION

DEMO = Path(__file__).parents[1] / "demo" / "demo.flac"
NO_DISPLAY = 3
"""Exit code where there is no display."""

EXAMPLES = ("phonemeanalyser", "phonemeanalyser speech.wav --preset my-voice.toml", "phonemeanalyser --licences")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the window is opened with."""
    parser.add_argument(
        "file",
        type=Path,
        nargs="?",
        metavar="FILE",
        help="audio file, preset or face to open (default: the last one, or a demo)",
    )
    add_declared(parser, RECOGNITION, "preset", "channel", preset=None, channel=None)
    parser.add_argument("--version", action="version", version=f"%(prog)s {__version__}")
    parser.add_argument("--licences", action="store_true", help="print the licences of all parts")


def run(options: argparse.Namespace) -> int:
    """Open the window; returns when it is closed."""
    if options.licences:
        print(licences_text())
        return 0
    if reason := why_no_window(os.environ):
        print(f"phonemeanalyser: {reason}", file=sys.stderr)
        return NO_DISPLAY
    gc.disable()  # nothing is garbage yet, and looking for it takes 5 % of the start; the window collects by itself
    return int(load_desktop().run(options.file, DEMO, options.preset, options.channel))
