"""What reads a command line, and what reads its numbers and places."""

import argparse
import math
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NoReturn

from typing_extensions import override

from phonemeengine.batch.remote import place_of
from phonemeengine.conversion.option import Number, Option
from phonemeengine.errors import OptionError, meant_by, remedy
from phonemeengine.settings import OLD_MODEL_KINDS

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


def add_declared(
    parser: argparse.ArgumentParser, declared: Mapping[str, Option], *names: str, **defaults: Any
) -> None:
    """Let the user give options, as the engine declares them.

    Parameters
    ----------
    declared : all options, by name.
    names : of those that are given.
    defaults : those that are others in this command.
    """
    for name in names:
        option, key = declared[name], name.replace("-", "_")
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


def add_log(parser: argparse.ArgumentParser) -> None:
    """Let the user keep what happens; the option may stand before or after what a command does, as `info`."""
    parts = [a for a in parser._actions if isinstance(a, argparse._SubParsersAction)]
    for each in (parser, *(part for action in parts for part in action.choices.values())):
        # a part's default would replace what stands before it
        default = None if each is parser else argparse.SUPPRESS
        each.add_argument("--log", type=Path, metavar="FILE", default=default, help="append a log to this file")


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
