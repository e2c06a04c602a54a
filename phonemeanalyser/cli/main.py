"""The command line: its commands, and what each of them ends with."""

import importlib
import os
import sys
from argparse import RawDescriptionHelpFormatter
from collections.abc import Sequence
from types import ModuleType

from phonemeanalyser.cli.parser import CommandParser, add_log
from phonemeanalyser.cli.requirements import module_that_draws
from phonemeanalyser.logs import logged_to
from phonemeengine import EngineError
from phonemeengine.errors import OptionError, meant_by
from phonemeengine.storage.files import printable, reason_of

COMMANDS = {
    "adapt": "Calibrate a preset to takes or recordings of one voice, or to the background noise alone.",
    "align": "Align audio files with a script, and find the best take of each line.",
    "analyse": "Recognise the phonemes of audio files, and write tables or labels.",
    "explain": "Print the rules of a preset, and why a phoneme was recognised at a time.",
    "export": "Convert audio files to mouth cues or facial animation for other programs.",
    "listen": "Recognise phonemes from a microphone, and print a line at each change, until Ctrl-C.",
    "measure": "Measure a part of an audio file: level, pitch, formants, variables and shares of phonemes.",
    "movestates": "Make, inspect and convert files of movestates (blend shapes).",
    "performance": "Make and inspect tables of recorded faces, and make synthetic recordings.",
    "preview": "Render a video of a head that speaks an audio file.",
    "record": "Record a microphone to a file, until Ctrl-C.",
    "rules": "Learn a few rules from labelled recordings, and write them as a preset.",
    "score": "Measure the accuracy of one or two presets on labelled recordings.",
    "screenshot": "Take a picture of the window, without a display.",
    "serve": "Recognise streams and audio files for other programs, over WebSocket and HTTP, until Ctrl-C.",
    "ship": "Write a preset and the runtime that recognises with it, for programs without Python.",
    "speak": "Speak a text aloud, or write it as audio, labels and facial animation.",
    "spectra": "Average the spectra of speakers or phonemes in labelled recordings, and compare them.",
    "takes": "List the takes in a folder, and remove deleted takes permanently.",
    "train": "Train the learned recogniser on folders of labelled speech.",
    "whisper": "Show, choose or download the Whisper model, the most accurate model for files.",
}
"""Every command, each a module of this package with `add_arguments` and `run`, and what it does."""
_TABLES, _TABLE = "--performance", ".sqlite"


SPELLINGS = {"analyze": "analyse"}
"""Commands as others spell them."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the program; returns the exit code: 0, 1 something failed, 2 wrong usage, 3 no display."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    try:
        command, rest = _command_in(words)
        module, parser = _module_of(command), _parser_of(command)
        parser.set_defaults(parser=parser)
        parser.examples = module.EXAMPLES
        module.add_arguments(parser)
        add_log(parser)
        options = parser.parse_args(_with_each_table(rest))
        with logged_to(options.log):
            return int(module.run(options))
    except OptionError as error:
        parser.error(str(error))
    except EngineError as error:
        print(f"phonemeanalyser: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("phonemeanalyser: stopped", file=sys.stderr)
        return 130
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # the pipe is closed: nothing to flush to
        return 0
    except OSError as error:  # a name that the system cannot ask for, a folder that goes meanwhile, a disk that fails
        where = f"{printable(str(error.filename))}: " if error.filename else ""
        print(
            f"phonemeanalyser: {where:.300}{reason_of(error)}; check the name, its folder and the disk",
            file=sys.stderr,
        )
        return 1


def _with_each_table(words: Sequence[str]) -> list[str]:
    """Return a command line in which each table has its option: ``--performance a.sqlite b.sqlite`` names two.

    What else follows, such as a text or a sound, is none of them, so argparse cannot read them as a list.
    """
    found: list[str] = []
    listing = False
    for word in words:
        follows = bool(found) and found[-1] == _TABLES
        if listing and not follows and word.endswith(_TABLE):
            found.append(_TABLES)
        listing = follows or (listing and word.endswith(_TABLE))
        found.append(word)
    return found


def _command_in(words: list[str]) -> tuple[str, list[str]]:
    """Return the command of a command line, and what follows it; what is no command is a file for the window.

    Raises
    ------
    SystemExit : it is neither, but a command may have been meant.
    """
    first = SPELLINGS.get(words[0], words[0]) if words else ""
    if first in COMMANDS:
        return first, words[1:]
    is_word = first.replace("-", "").isalpha() and not first.startswith("-") and not os.path.lexists(first)
    if is_word and (meant := meant_by(first, COMMANDS)):
        print(f"phonemeanalyser: there is no command {first!r}; did you mean {' or '.join(meant)}?", file=sys.stderr)
        raise SystemExit(2)
    return "window", words


def _module_of(command: str) -> ModuleType:
    """Import the module of a command, and no other, since imports take time."""
    if command == "preview":
        return module_that_draws(command)
    return importlib.import_module(f"phonemeanalyser.cli.{command}")


def _parser_of(command: str) -> CommandParser:
    if command in COMMANDS:
        return CommandParser(prog=f"phonemeanalyser {command}", description=COMMANDS[command])
    lines = "\n".join(f"  {name:<12}{words}" for name, words in COMMANDS.items())
    return CommandParser(
        prog="phonemeanalyser",
        description="Calibrate real-time phoneme recognition for lip sync, in a window or by commands.",
        epilog=f"commands:\n{lines}\n\nFor each: phonemeanalyser COMMAND --help",
        formatter_class=RawDescriptionHelpFormatter,
    )
