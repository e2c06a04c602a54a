"""The command line: open the window, analyse files, listen, record, score presets, make a picture."""

import argparse
import importlib
import math
import os
import sys
from collections.abc import Callable, Sequence
from importlib.metadata import version
from pathlib import Path
from types import ModuleType

from phonemeanalyser.cli.arguments import add_channel
from phonemeanalyser.cli.display import why_no_qt, why_no_window
from phonemeanalyser.cli.listen import list_devices, listen, record
from phonemeengine.audio.devices import InputChoice
from phonemeengine.audio.files import HIGHEST_RATE, LOWEST_RATE
from phonemeengine.errors import EngineError
from phonemeengine.mouth.osc import OscAddress, OscSettings
from phonemeengine.mouth.table import USUAL_TABLE, load_table
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import Channel

DEMO = Path(__file__).parents[1] / "demo" / "demo.flac"
NO_DISPLAY = 3
"""Exit code where there is no display."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the program; returns the exit code: 0, 1 something failed, 2 wrong usage, 3 no display."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    try:
        if words and words[0] in COMMANDS:
            return COMMANDS[words[0]](words[1:])
        return _window(words)
    except EngineError as error:
        print(f"phonemeanalyser: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("phonemeanalyser: stopped", file=sys.stderr)
        return 130
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # whoever read has gone: nothing to flush to
        return 0


def _window(words: list[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="phonemeanalyser",
        description="Calibrate real-time phoneme recognition for lip sync.",
        epilog=f"Commands: {', '.join(COMMANDS)}; for each, phonemeanalyser COMMAND --help",
    )
    parser.add_argument("file", type=Path, nargs="?", help="sound file to open (default: the last, or a demo)")
    parser.add_argument("--preset", type=Path, help="preset (.toml) or PhonemeData file to begin with")
    add_channel(parser, None)
    parser.add_argument("--version", action="version", version=f"%(prog)s {version('phonemeanalyser')}")
    options = parser.parse_args(words)
    if reason := why_no_window(os.environ):
        print(f"phonemeanalyser: {reason}", file=sys.stderr)
        return NO_DISPLAY
    return int(_app().run(options.file, DEMO, options.preset, options.channel))


def _listen(words: list[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="phonemeanalyser listen",
        description="Recognise what a microphone hears, and print a line at each change; Ctrl-C ends it.",
    )
    _add_input(parser)
    parser.add_argument("--format", choices=["text", "json"], default="text", dest="kind")
    parser.add_argument("--list-devices", action="store_true", help="print the microphones and end")
    parser.add_argument("--osc", metavar="HOST:PORT", help="send phonemes and the mouth as OSC and VMC messages")
    table = f"mouth table of --osc: {USUAL_TABLE} as the head's, vrm, oculus, ... or a file (default: {USUAL_TABLE})"
    parser.add_argument("--table", default=USUAL_TABLE, metavar="T", help=table)
    options = parser.parse_args(words)
    if options.list_devices:
        list_devices()
    else:
        osc = None if options.osc is None else OscSettings(OscAddress.of(options.osc), load_table(options.table))
        listen(load_preset(options.preset), _choice_of(options), options.seconds, options.kind, osc)
    return 0


def _record(words: list[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="phonemeanalyser record", description="Record a microphone to a file; Ctrl-C ends it."
    )
    parser.add_argument("out", type=Path, metavar="OUT", help="a new .wav or .flac file")
    _add_input(parser)
    parser.add_argument("--phonemes", action="store_true", help="write the phonemes beside it, as OUT.csv")
    parser.add_argument(
        "--fill-gaps", action="store_true", help="silence for the time the microphone was away, besides the mark"
    )
    options = parser.parse_args(words)
    preset, choice = load_preset(options.preset), _choice_of(options)
    record(options.out, preset, choice, options.seconds, with_phonemes=options.phonemes, fill_gaps=options.fill_gaps)
    return 0


def _add_input(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--device", default="", metavar="NAME", help="microphone, by name or a part of it")
    add_channel(parser, Channel.LEFT)
    parser.add_argument("--rate", type=_rate, default=0, metavar="HZ", help="sample rate (default: 44100 if it can)")
    parser.add_argument("--preset", type=Path, default=DEFAULT_PRESET, help="preset (.toml) or PhonemeData file")
    parser.add_argument("--seconds", type=_seconds, metavar="S", help="end after so long")


def _choice_of(options: argparse.Namespace) -> InputChoice:
    return InputChoice(options.device, options.channel.number, options.rate)


def _screenshot(words: list[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="phonemeanalyser screenshot", description="Take a picture of the window, without a display."
    )
    parser.add_argument("file", type=Path, metavar="FILE", help="sound file")
    parser.add_argument("-o", "--out", type=Path, required=True, metavar="PNG")
    parser.add_argument("--at", type=_seconds, metavar="SECONDS", help="analysed up to here (default: the end)")
    parser.add_argument("--size", type=_size, default=(1280, 800), metavar="WxH")
    parser.add_argument("--theme", choices=["light", "dark"], default="light")
    parser.add_argument("--preset", type=Path, help="preset (.toml) or PhonemeData file")
    add_channel(parser)
    options = parser.parse_args(words)
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    _app().screenshot(
        options.file, options.out, at=options.at, size=options.size, theme=options.theme, preset=options.preset,
        channel=options.channel,
    )  # fmt: skip
    return 0


def _preview(words: list[str]) -> int:
    try:
        module = importlib.import_module("phonemeanalyser.cli.preview")
    except ImportError as error:
        raise EngineError(
            f"previews need packages that cannot be loaded ({error}); install them with: pip install "
            "'phonemeanalyser[preview]'"
        ) from error
    return int(module.preview(words))


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"must be a number of seconds, got {text!r}") from None
    if not 0 <= seconds < math.inf:
        raise argparse.ArgumentTypeError(f"must be 0 s or later, got {text!r}")
    return seconds


def _rate(text: str) -> int:
    if not text.isdecimal() or not LOWEST_RATE <= int(text) <= HIGHEST_RATE:
        raise argparse.ArgumentTypeError(f"must lie in {LOWEST_RATE}..{HIGHEST_RATE} Hz, got {text!r}")
    return int(text)


def _size(text: str) -> tuple[int, int]:
    try:
        width, height = (int(part) for part in text.lower().split("x"))
    except ValueError:
        raise argparse.ArgumentTypeError(f"must be like 1280x800, got {text!r}") from None
    if not (640 <= width <= 7680 and 480 <= height <= 4320):
        raise argparse.ArgumentTypeError(f"must lie in 640x480..7680x4320, got {text!r}")
    return width, height


def _app() -> ModuleType:
    """Import the desktop, which needs Qt; analysing files does not."""
    try:
        return importlib.import_module("phonemeanalyser.desktop.app")
    except ImportError as error:
        raise EngineError(why_no_qt(error)) from error


def _of(module: str, name: str) -> Callable[[list[str]], int]:
    """Return a command whose module is imported when it runs, since nobody should wait for the others."""
    return lambda words: int(getattr(importlib.import_module(f"phonemeanalyser.cli.{module}"), name)(words))


COMMANDS: dict[str, Callable[[list[str]], int]] = {
    "adapt": _of("adapt", "adapt"),
    "analyse": _of("analyse", "analyse"),
    "export": _of("export", "export"),
    "listen": _listen,
    "movestates": _of("movestates", "movestates"),
    "preview": _preview,
    "record": _record,
    "score": _of("score", "score"),
    "screenshot": _screenshot,
    "train": _of("train", "train"),
}
"""Every command, and what runs it."""
