"""Arguments that several commands have, and what reads their numbers."""

import argparse
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, NoReturn

from phonemeanalyser.rendering.clip_options import USUAL_CLIP_RATE, USUAL_CLIP_SIZE
from phonemeengine import FORMATS, Channel, Detail, Ear
from phonemeengine.batch.remote import place_of
from phonemeengine.errors import meant_by, remedy
from phonemeengine.mouth.exports.formats import formats_for
from phonemeengine.presets.ears import WITHOUT_ENCODER
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.settings import MOST_CHANNELS

PRESET = "preset (.toml) or PhonemeData file"
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


def add_preset(
    parser: argparse.ArgumentParser,
    default: Path | None = DEFAULT_PRESET,
    words: str = PRESET,
    metavar: str = "PRESET",
) -> None:
    """Let the user choose what recognises."""
    parser.add_argument("--preset", type=Path, default=default, metavar=metavar, help=words)


def add_ear(parser: argparse.ArgumentParser, default: Ear | None = None) -> None:
    """Let the user choose what sounds are heard with, of what a preset has."""
    words = f"heard with (default: {default or 'the best there is'}); {WITHOUT_ENCODER.replace('%', '%%')}"
    parser.add_argument("--ear", choices=[ear.value for ear in Ear], default=default, help=words)


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


def add_script(parser: argparse.ArgumentParser) -> None:
    """Let the user say what is said in the sounds."""
    known = parser.add_mutually_exclusive_group()
    known.add_argument("--text", metavar="TEXT", help="what is said in the sound: recognition becomes far more exact")
    words = (
        "file with it, table with a line FILE<TAB>TEXT for each sound, .TextGrid or .json with times of words, or "
        "auto: x.TextGrid with words, or x.txt, beside x.wav"
    )
    known.add_argument("--script", type=Path, metavar="FILE", help=words)
    parser.add_argument("--speaker", metavar="NAME", help="whose words, of a .TextGrid or .json of several speakers")
    parser.add_argument("--language", metavar="L", help="the text's, such as en-us or de")
    parser.add_argument("--lexicon", type=Path, metavar="FILE", help="how words are pronounced, .toml or .csv")
    add_literal(parser)
    add_accept_text(parser)


def add_literal(parser: argparse.ArgumentParser) -> None:
    """Let the user have the notation of a script taken as words."""
    notation = "speakers' names, [directions], *emphasis*, <tags> and &entities; of the text are words, too"
    parser.add_argument("--literal", action="store_true", help=notation)


def add_accept_text(parser: argparse.ArgumentParser) -> None:
    """Let the user say that the text is right."""
    parser.add_argument("--accept-text", action="store_true", help="align even where another text seems to be said")


def add_clip(parser: argparse.ArgumentParser) -> None:
    """Let the user say what clip is made."""
    out = ".mp4, .gif or a folder for .png"
    parser.add_argument("-o", "--out", type=Path, required=True, metavar="OUT", help=out)
    usual = USUAL_CLIP_RATE
    parser.add_argument("--fps", type=number, default=usual, metavar="N", help=f"frames per second ({usual:g})")
    size = size_in((SMALLEST_CLIP, SMALLEST_CLIP), (LARGEST_CLIP, LARGEST_CLIP))
    parser.add_argument("--size", type=size, default=USUAL_CLIP_SIZE, metavar="WxH", help="pixels (640x640)")
    add_theme(parser)


def add_theme(parser: argparse.ArgumentParser) -> None:
    """Let the user choose the colours of a picture."""
    parser.add_argument("--theme", choices=["light", "dark"], default="light")


def add_channel(parser: argparse.ArgumentParser, default: Channel | None = Channel.MIX) -> None:
    """Let the user choose what is analysed of a sound that has several channels; None is the choice of last time."""
    usual = "as last time" if default is None else default.value
    words = f"of several channels: mix, left, right, or a number from 1 (default: {usual})"
    parser.add_argument("--channel", type=_channel, default=default, metavar="C", help=words)


def add_mouth(parser: argparse.ArgumentParser) -> None:
    """Let the user choose how closely the mouth follows the speech, and what the face does besides."""
    parser.add_argument("--anticipation", type=number, metavar="S", help="the mouth is ahead so much, 0..0.12 s")
    parser.add_argument(
        "--detail", choices=[d.value for d in Detail], default=Detail.PHONEMES.value, help="what the mouth follows"
    )
    parser.add_argument("--no-blinks", action="store_true", help="keep the eyes open")
    parser.add_argument("--no-head", action="store_true", help="keep the head still")
    parser.add_argument("--seed", type=int, metavar="N", help="another number makes another face, and varies pinyin")


def add_log(parser: argparse.ArgumentParser) -> None:
    """Let the user keep what happens."""
    parser.add_argument("--log", type=Path, metavar="FILE", help="append what happens to a file, to send in")


def add_overwrite(parser: argparse.ArgumentParser) -> None:
    """Let the user have files replaced that were made in another way."""
    parser.add_argument("--overwrite", action="store_true", help="replace files that were made in another way, too")


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


def number(text: str) -> float:
    """Read a finite number."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"must be a number, got {text!r}")
    return value


def number_in(low: float, high: float, unit: str) -> Callable[[str], float]:
    """Return what reads a number within limits."""

    def read(text: str) -> float:
        value = number(text)
        if not low <= value <= high:
            raise argparse.ArgumentTypeError(f"must be a number {_limits(low, high, unit)}, got {text!r}")
        return value

    return read


def whole_in(low: int, high: float = math.inf, unit: str = "") -> Callable[[str], int]:
    """Return what reads a whole number within limits, 0 or more."""

    def read(text: str) -> int:
        if not text.isdecimal() or not low <= int(text) <= high:
            raise argparse.ArgumentTypeError(f"must be a whole number {_limits(low, high, unit)}, got {text!r}")
        return int(text)

    return read


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


def _limits(low: float, high: float, unit: str) -> str:
    return f"of {low:g} {unit} or more" if high == math.inf else f"in {low:g}..{high:g} {unit}"


def _channel(text: str) -> Channel:
    try:
        return Channel(text)
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"must be mix, left, right, or a number in 1..{MOST_CHANNELS}, got {text!r}"
        ) from None
