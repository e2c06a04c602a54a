"""Arguments that several commands have, and what reads their numbers."""

import argparse
import math
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any, NoReturn

from phonemeanalyser.rendering.clip_options import USUAL_CLIP_SIZE
from phonemeengine import FORMATS
from phonemeengine.batch.remote import place_of
from phonemeengine.conversion.options import OPTIONS, ConversionOptions, Number
from phonemeengine.errors import OptionError, meant_by, remedy
from phonemeengine.mouth.exports.formats import formats_for

HEARD = ("preset", "ear", "channel")
SAID = ("text", "script", "speaker", "language", "lexicon", "literal", "accept-text")
MOVED = (
    "anticipation",
    "detail",
    "attack",
    "release",
    "steady",
    "no-blinks",
    "no-head",
    "seed",
    "expression",
    "priority",
)
DRIVEN = ("text-driver", "pinyin-table", "spring", "performance", "use", "choice", "without", "keywords", "units")
"""Options of conversions that commands share: of what is heard, what is said, how a face moves, and by what."""
MOST_JOBS = 1024
SMALLEST_CLIP, LARGEST_CLIP = 16, 4096
"""Pixels along an edge of its pictures."""


class CommandParser(argparse.ArgumentParser):
    """Reads the arguments of a command, and refuses what is wrong in one sentence, with what may have been meant."""

    def error(self, message: str) -> NoReturn:
        """End the program, with a sentence about what is wrong."""
        end = " See" if message.endswith("?") else "; see"
        self.exit(2, f"{self.prog}: {message}{end} {self.prog} --help\n")

    def parse_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Read the arguments; an unknown option is refused with those that are spelt alike."""
        options, unknown = self.parse_known_args(args, namespace)
        if unknown:
            word = unknown[0].partition("=")[0]
            known = {name.lstrip("-"): name for name in self._option_string_actions}
            meant = [known[name] for name in meant_by(word.lstrip("-"), known)] if word.startswith("-") else []
            self.error(f"{word!r} is unknown" + (f"; did you mean {' or '.join(meant)}?" if meant else ""))
        return options

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """Refuse a value that is none of an argument's choices."""
        if action.choices is not None and value not in action.choices:
            words = remedy(str(value), map(str, action.choices))
            raise argparse.ArgumentError(action, f"there is no {value!r}; {words}")


def add_options(parser: argparse.ArgumentParser, *names: str, **defaults: Any) -> None:
    """Let the user give options of conversions, as the engine declares them.

    Parameters
    ----------
    names : of the options.
    defaults : those that are others in this command.
    """
    for name in names:
        option, key = OPTIONS[name], name.replace("-", "_")
        words = option.words.replace("%", "%%")
        if not option.value:
            parser.add_argument(f"--{name}", action="store_true", help=words)
            continue
        default = defaults.get(key, option.default)
        parser.add_argument(
            f"--{name}",
            type=reading(option.read),
            default=None if option.several else default,
            metavar=option.value,
            action="append" if option.several else "store",
            help=words,
        )


def given(options: argparse.Namespace, **values: Any) -> ConversionOptions:
    """Return the options of conversions that a command line gives.

    Parameters
    ----------
    values : of those that it names otherwise.

    Raises
    ------
    OptionError : one goes with another one that is not there.
    """
    found = {each.name: getattr(options, each.name) for each in fields(ConversionOptions) if each.name in options}
    several = {name: tuple(found[name] or ()) for name, option in OPTIONS.items() if option.several and name in found}
    return ConversionOptions(**found | several | values)


def add_sounds(parser: argparse.ArgumentParser) -> None:
    """Have the user name sound files, and where to write what comes of them."""
    parser.add_argument("inputs", type=place, nargs="+", metavar="INPUT", help="sound files, or folders of them")
    parser.add_argument("-o", "--out", type=place, help="folder, or a file for one sound (default: print)")


def add_batch(parser: argparse.ArgumentParser) -> None:
    """Let the user say who works through many files."""
    words = "files at a time (default: as many as there are cores, where that is worth it)"
    parser.add_argument("--jobs", type=whole_in(1, MOST_JOBS), metavar="N", help=words)
    dask = "have an existing Dask cluster work, such as tcp://host:8786"
    parser.add_argument("--dask", metavar="ADDRESS", help=dask)


def add_map(parser: argparse.ArgumentParser) -> None:
    """Let the user say what names in labels stand for."""
    parser.add_argument("--map", type=Path, metavar="FILE", help="what unknown names in the labels stand for")


def add_clip(parser: argparse.ArgumentParser) -> None:
    """Let the user say what clip is made."""
    out = ".mp4, .gif or a folder for .png"
    parser.add_argument("-o", "--out", type=Path, required=True, metavar="OUT", help=out)
    add_options(parser, "fps")
    size = size_in((SMALLEST_CLIP, SMALLEST_CLIP), (LARGEST_CLIP, LARGEST_CLIP))
    parser.add_argument("--size", type=size, default=USUAL_CLIP_SIZE, metavar="WxH", help="pixels (640x640)")
    add_theme(parser)


def add_theme(parser: argparse.ArgumentParser) -> None:
    """Let the user choose the colours of a picture."""
    parser.add_argument("--theme", choices=["light", "dark"], default="light")


def add_log(parser: argparse.ArgumentParser) -> None:
    """Let the user keep what happens."""
    parser.add_argument("--log", type=Path, metavar="FILE", help="append what happens to a file, to send in")


def format_of(options: argparse.Namespace, out: Path | None) -> str:
    """Return the format of an export that was named by no --format, as its file ends.

    Parameters
    ----------
    out : the file; None where there is none, or a folder.
    """
    found = [] if out is None else formats_for(out.name)
    if len(found) != 1:
        several = f"several formats end as {out.name!r} does" if out is not None and found else "--format is missing"
        options.parser.error(f"{several}; choose one of {', '.join(found or FORMATS)}")
    return found[0]


def place(text: str) -> Path:
    """Read a path, or an address such as ``s3://bucket/folder``."""
    return place_of(text)


def file_place(text: str) -> Path:
    """Read a path of a command that prints nothing of what it writes."""
    if text == "-":
        raise argparse.ArgumentTypeError("this command does not write to standard output; name a file or folder")
    return Path(text)


def reading(read: Callable[[str], Any]) -> Callable[[str], Any]:
    """Return what reads an argument as an option of conversions is read."""

    def typed(text: str) -> Any:
        try:
            return read(text)
        except OptionError as error:
            raise argparse.ArgumentTypeError(str(error)) from None

    return typed


number = reading(Number())


def number_in(low: float, high: float, unit: str) -> Callable[[str], float]:
    """Return what reads a number within limits."""
    return reading(Number(low, high, unit))


def whole_in(low: int, high: float = math.inf, unit: str = "") -> Callable[[str], int]:
    """Return what reads a whole number within limits."""
    return reading(Number(low, high, unit, whole=True))


def size_in(least: tuple[int, int], most: tuple[int, int]) -> Callable[[str], tuple[int, int]]:
    """Return what reads width and height of a picture, within limits, pixels."""

    def read(text: str) -> tuple[int, int]:
        try:
            width, height = (int(part) for part in text.lower().split("x"))
        except ValueError:
            raise argparse.ArgumentTypeError(f"must be like {least[0]}x{least[1]}, got {text!r}") from None
        if not (least[0] <= width <= most[0] and least[1] <= height <= most[1]):
            limits = "..".join(f"{w}x{h}" for w, h in (least, most))
            raise argparse.ArgumentTypeError(f"must lie in {limits}, got {text!r}")
        return width, height

    return read
