"""``phonemeanalyser screenshot``: a picture of the window, without a display."""

import argparse
import math
import os
from pathlib import Path

import phonemeanalyser
from phonemeanalyser.cli.arguments import add_options
from phonemeanalyser.cli.parser import file_place, number_in, reading
from phonemeanalyser.cli.requirements import load_desktop
from phonemeengine.conversion.option import PictureSize

EXAMPLES = (
    "phonemeanalyser screenshot speech.wav -o window.png",
    "phonemeanalyser screenshot speech.wav -o window.png --at 1.5 --theme dark",
    "phonemeanalyser screenshot speech.wav -o fenster.png --language de --size 1920x1080",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is to be seen."""
    parser.add_argument("file", type=Path, metavar="FILE", help="audio file")
    parser.add_argument("-o", "--out", type=file_place, required=True, metavar="PNG", help="picture to write")
    seconds = number_in(0, math.inf, "s")
    parser.add_argument("--at", type=seconds, metavar="S", help="position, seconds (default: the end)")
    parser.add_argument(
        "--size",
        type=reading(PictureSize((640, 480), (7680, 4320))),
        default=(1280, 800),
        metavar="WxH",
        help="(default: 1280x800)",
    )
    parser.add_argument(
        "--language", choices=["en", *translated()], default="en", help="language of the window (default: en)"
    )
    add_options(parser, "theme", "preset", "channel", preset=None)


def translated() -> list[str]:
    """Return the codes of the languages into which the window is translated, found without importing Qt."""
    files = (Path(phonemeanalyser.__file__).parent / "desktop" / "translations").glob("*.ts")
    return sorted(path.stem.partition("_")[2] for path in files)


def run(options: argparse.Namespace) -> int:
    """Take the picture."""
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    load_desktop().screenshot(
        options.file,
        options.out,
        at=options.at,
        size=options.size,
        theme=options.theme,
        language=options.language,
        preset=options.preset,
        channel=options.channel,
    )
    return 0
