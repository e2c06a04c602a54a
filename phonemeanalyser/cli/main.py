"""The command line: its commands, and what each of them ends with."""

import importlib
import os
import sys
from argparse import RawDescriptionHelpFormatter
from collections.abc import Sequence
from types import ModuleType

from phonemeanalyser.cli.arguments import CommandParser, add_log
from phonemeanalyser.cli.extras import module_that_draws
from phonemeanalyser.logs import logged_to
from phonemeengine import EngineError
from phonemeengine.errors import OptionError, meant_by

COMMANDS = {
    "adapt": "Calibrate a preset to the takes or labelled recordings of one voice, or to a room alone.",
    "align": "Tell where a script is said in sound files, and which take of each line is the best.",
    "analyse": "Write the phonemes of sound files as tables.",
    "export": "Write what sound files say as mouth cues and movements for other programs.",
    "listen": "Recognise what a microphone hears, and print a line at each change; Ctrl-C ends it.",
    "measure": "Measure a stretch of a sound: level, pitch, formants, variables and the shares of the phonemes.",
    "movestates": "Make, look at and convert files of movestates.",
    "performance": "Make tables of recorded faces, look at them, and make synthetic recordings.",
    "preview": "Make a clip in which a head says a sound file.",
    "record": "Record a microphone to a file; Ctrl-C ends it.",
    "score": "Recognise labelled recordings with one or two presets, and tell how right the answers are.",
    "screenshot": "Take a picture of the window, without a display.",
    "serve": "Serve streams of speech and sound files to other programs, over WebSocket and HTTP; Ctrl-C ends it.",
    "ship": "Write a preset and the ear that hears with it, as sources for programs without Python.",
    "speak": "Have a voice say a text, aloud or into a sound, labels and a mouth's movement.",
    "takes": "Say what a folder of takes holds, and remove deleted takes for ever.",
    "train": "Train the learned recogniser on folders of labelled speech.",
    "whisper": "Say where the speech encoder's model is that helps to hear files, choose it, or fetch it.",
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
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # whoever read has gone: nothing to flush to
        return 0


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
    """Import the module of a command, and no other: nobody should wait for them."""
    if command == "preview":
        return module_that_draws(command)
    return importlib.import_module(f"phonemeanalyser.cli.{command}")


def _parser_of(command: str) -> CommandParser:
    if command in COMMANDS:
        return CommandParser(prog=f"phonemeanalyser {command}", description=COMMANDS[command])
    lines = "\n".join(f"  {name:<12}{words}" for name, words in COMMANDS.items())
    return CommandParser(
        prog="phonemeanalyser",
        description="Calibrate real-time phoneme recognition for lip sync; without a command, in a window.",
        epilog=f"commands:\n{lines}\n\nFor each: phonemeanalyser COMMAND --help",
        formatter_class=RawDescriptionHelpFormatter,
    )
