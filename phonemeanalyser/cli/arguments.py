"""Arguments that several commands have."""

import argparse
import math
from pathlib import Path

from phonemeengine.mouth.cues import MINIMUM
from phonemeengine.mouth.morpher import Detail
from phonemeengine.settings import MOST_CHANNELS, Channel


def add_channel(parser: argparse.ArgumentParser, default: Channel | None = Channel.MIX) -> None:
    """Let the user choose what is analysed of a sound that has several channels; None is the choice of last time."""
    usual = "as last time" if default is None else default.value
    words = f"of several channels: mix, left, right, or a number from 1 (default: {usual})"
    parser.add_argument("--channel", type=_channel, default=default, metavar="C", help=words)


def add_mouth(parser: argparse.ArgumentParser) -> None:
    """Let the user choose how closely the mouth follows the speech."""
    parser.add_argument("--minimum", type=number, default=MINIMUM, metavar="S", help=f"shortest cue ({MINIMUM} s)")
    parser.add_argument("--anticipation", type=number, metavar="S", help="the mouth is ahead so much, 0..0.12 s")
    parser.add_argument(
        "--detail", choices=[d.value for d in Detail], default=Detail.PHONEMES.value, help="what the mouth follows"
    )


def add_log(parser: argparse.ArgumentParser) -> None:
    """Let the user keep what happens."""
    parser.add_argument("--log", type=Path, metavar="FILE", help="append what happens to a file, to send in")


def add_overwrite(parser: argparse.ArgumentParser) -> None:
    """Let the user give up files that are in the way."""
    parser.add_argument("--overwrite", action="store_true", help="replace files that are not this program's, too")


def number(text: str) -> float:
    """Read a finite number."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"must be a number, got {text!r}")
    return value


def _channel(text: str) -> Channel:
    try:
        return Channel(text)
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"must be mix, left, right, or a number in 1..{MOST_CHANNELS}, got {text!r}"
        ) from None
