"""``phonemeanalyser ship``: a preset and the ear that hears with it, as sources for programs without Python."""

import argparse
from pathlib import Path

from phonemeanalyser.cli.arguments import file_place
from phonemeanalyser.cli.jobs import say_note
from phonemeengine import load_preset, ship
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.shipping.targets import SMALL_NETWORK_SERVES, TARGETS, USUAL_TABLES


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is shipped, and where to."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = "targets:\n" + "\n".join(f"  {name:<12}{target.words}" for name, target in TARGETS.items())
    parser.add_argument(
        "preset", type=Path, metavar="PRESET", help="preset (.toml) or PhonemeData file, or a factory preset's name"
    )
    parser.add_argument("-o", "--out", type=file_place, required=True, metavar="FOLDER", help="the new folder")
    parser.add_argument("--target", choices=TARGETS, default="c", help="see below (default: c)")
    usual = " and ".join(USUAL_TABLES)
    words = f"mouth table, again for more: a file, or one of {', '.join(shipped_tables())} (default: {usual})"
    parser.add_argument("--table", action="append", metavar="T", help=words)
    parser.add_argument("--overwrite", action="store_true", help="replace files that were changed there, too")


def run(options: argparse.Namespace) -> int:
    """Ship; returns the exit code."""
    tables = options.table or USUAL_TABLES
    preset = load_preset(options.preset)
    if preset.live_encoder is not None:
        say_note(preset.name, SMALL_NETWORK_SERVES)
    written = ship(preset, options.out, options.target, tables=tables, overwrite=options.overwrite)
    size = sum(path.stat().st_size for path in written)
    print(f"{options.out}: {preset.name!r} in {len(written)} files, {size / 1e6:.2f} MB; see README.md there")
    return 0
