"""Arguments that several commands have, and what reads their numbers."""

import argparse
import math
import re
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any, NoReturn

from typing_extensions import override

from phonemeengine import FORMATS
from phonemeengine.batch.remote import place_of
from phonemeengine.conversion.options import EXPRESSED, OPTIONS, PICTURED, WEIGHTED, ConversionOptions, Number
from phonemeengine.errors import OptionError, meant_by, remedy
from phonemeengine.mouth.exports.formats import formats_for
from phonemeengine.settings import OLD_MODEL_KINDS

HEARD = ("preset", "model", "decoder", "channel")
SAID = ("text", "script", "speaker", "language", "lexicon", "literal", "accept-text")
MOVED = ("anticipation", *WEIGHTED, "no-blinks", "no-head", *EXPRESSED)
"""Options of conversions that commands share: of recognition, the text, a face's movement, and its driver."""
OLD_OPTIONS = {
    "--ear": "--model",
    "--live-model": "--model",
    "--held-back": "--held-out",
    "--room": "--background-noise",
    "--most-streams": "--max-streams",
    "--most-connections": "--max-connections",
    "--most-per-address": "--max-per-address",
    "--most-speed": "--max-speed",
    "--idle": "--idle-timeout",
    "--largest-message": "--max-message",
    "--most-text": "--max-text",
    "--largest-own": "--max-own",
    "--largest-file": "--max-file",
    "--longest-file": "--max-duration",
    "--file-memory": "--max-memory",
    "--most-files": "--max-files",
    "--file-seconds": "--file-timeout",
}
"""Options of the release before, which this one still accepts, and what they are called now."""
MOST_JOBS = 1024


class CommandParser(argparse.ArgumentParser):
    """Reads the arguments of a command, and refuses what is wrong in one sentence, with what may have been meant.

    Attributes
    ----------
    examples : command lines that end its help.
    """

    examples: Sequence[str] = ()

    @override
    def error(self, message: str) -> NoReturn:
        message = message.removeprefix("argument ")
        end = " See" if message.endswith("?") else "; see"
        self.exit(2, f"{self.prog}: {message}{end} {self.prog} --help\n")

    @override
    def parse_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Read the arguments; an unknown option is refused with those that are spelt alike."""
        options, unknown = self.parse_known_args(None if args is None else self._renamed(args), namespace)
        if unknown:
            word = unknown[0].partition("=")[0]
            known = {name.lstrip("-"): name for name in self._option_string_actions}
            meant = [known[name] for name in meant_by(word.lstrip("-"), known)] if word.startswith("-") else []
            self.error(f"{word!r} is unknown" + (f"; did you mean {' or '.join(meant)}?" if meant else ""))
        return options

    def _renamed(self, words: Sequence[str]) -> list[str]:
        """Return a command line with the names of today; each older one is reported on standard error."""
        found: list[str] = []
        for word in words:
            name, equals, value = word.partition("=")
            if OLD_OPTIONS.get(name) in self._option_string_actions:
                name = self._told(name, OLD_OPTIONS[name])
            if name == "--model" and equals and value in OLD_MODEL_KINDS:
                value = self._told(value, OLD_MODEL_KINDS[value])
            follows = bool(found) and found[-1] == "--model"
            if follows and word in OLD_MODEL_KINDS:
                name = self._told(word, OLD_MODEL_KINDS[word])
            found.append(name + equals + value)
        return found

    def _told(self, old: str, new: str) -> str:
        print(f"{self.prog}: {old} is now {new}; the next release accepts the new name alone", file=sys.stderr)
        return new

    @override
    def format_usage(self) -> str:
        """Return how the command is called, without its optional options."""
        formatter = self.formatter_class(prog=f"{self.prog} [OPTIONS]")
        formatter.add_usage(
            self.usage, [each for each in self._actions if each.required or not each.option_strings], []
        )
        return formatter.format_help()

    @override
    def format_help(self) -> str:
        """Return the help: a sentence, the call, the options, and examples."""
        formatter = self._get_formatter()
        for group in self._action_groups:
            formatter.start_section(group.title)
            formatter.add_arguments(group._group_actions)
            formatter.end_section()
        formatter.add_text(self.epilog)
        parts = [f"{self.description}\n", self.format_usage(), formatter.format_help()]
        if self.examples:
            parts.append("\n".join(("examples:", *(f"  {example}" for example in self.examples))) + "\n")
        return "\n".join(parts)

    @override
    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """Refuse a value that is none of an argument's choices."""
        if action.choices is not None and value not in action.choices:
            words = remedy(str(value), map(str, action.choices))
            raise argparse.ArgumentError(action, f"there is no {str(value)!r}; {words}")


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
        if key in defaults:
            words = re.sub(r"default: [^)]*", f"default: {default}", words)
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


def refuse_unused(options: argparse.Namespace, names: Iterable[str], why: str) -> None:
    """Refuse options that were given, and that nothing uses.

    Parameters
    ----------
    names : of the options.
    why : the end of a sentence that begins with the option.

    Raises
    ------
    OptionError : one was given.
    """
    for name in names:
        key = name.replace("-", "_")
        if getattr(options, key) != options.parser.get_default(key):
            raise OptionError(f"--{name} {why}")


def add_sounds(parser: argparse.ArgumentParser) -> None:
    """Have the user name sound files, and where to write what comes of them."""
    parser.add_argument("inputs", type=place, nargs="+", metavar="INPUT", help="audio files, or folders of them")
    parser.add_argument(
        "-o", "--out", type=place, metavar="OUT", help="folder, or file for one audio file (default: print)"
    )


def add_batch(parser: argparse.ArgumentParser) -> None:
    """Let the user say who works through many files."""
    words = "files at a time (default: one for each core, if that is faster)"
    parser.add_argument("--jobs", type=whole_in(1, MOST_JOBS), metavar="N", help=words)
    dask = "use an existing Dask cluster, such as tcp://host:8786"
    parser.add_argument("--dask", metavar="ADDRESS", help=dask)


def add_map(parser: argparse.ArgumentParser) -> None:
    """Let the user say what names in labels stand for."""
    parser.add_argument("--map", type=Path, metavar="FILE", help="phonemes for unknown names in the labels (TOML)")


def add_clip(parser: argparse.ArgumentParser) -> None:
    """Let the user say what clip is made."""
    out = "video (.mp4), .gif, or a folder for .png"
    parser.add_argument("-o", "--out", type=Path, required=True, metavar="OUT", help=out)
    add_options(parser, "fps", *PICTURED)


def add_examples(kinds: Any, examples: Mapping[str, tuple[str, ...]]) -> None:
    """End the help of each thing that a command does with its examples."""
    for name, parser in kinds.choices.items():
        parser.examples = examples[name]


def add_log(parser: argparse.ArgumentParser) -> None:
    """Let the user keep what happens; the option may stand before or after what a command does, as `info`."""
    parts = [a for a in parser._actions if isinstance(a, argparse._SubParsersAction)]
    for each in (parser, *(part for action in parts for part in action.choices.values())):
        # a part's default would replace what stands before it
        default = None if each is parser else argparse.SUPPRESS
        each.add_argument("--log", type=Path, metavar="FILE", default=default, help="append a log to this file")


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
