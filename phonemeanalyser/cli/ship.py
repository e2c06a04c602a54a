"""``phonemeanalyser ship``: a preset with the runtime, as sources for programs without Python."""

import argparse
from pathlib import Path

from phonemeanalyser.cli.jobs import say_note
from phonemeanalyser.cli.parser import file_place
from phonemeengine import load_preset, ship
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.shipping.targets import TARGETS, USUAL_TABLES, without_real_time_model

EXAMPLES = (
    "phonemeanalyser ship learned -o mouth --embed",
    "phonemeanalyser ship extended -o sources --table arkit --table vrm",
    "phonemeanalyser ship learned -o page --target web",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is shipped, and where to."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = "targets:\n" + "\n".join(f"  {name:<12}{target.words}" for name, target in TARGETS.items())
    parser.add_argument(
        "preset", type=Path, metavar="PRESET", help="preset (.toml), PhonemeData file, or name of a factory preset"
    )
    parser.add_argument("-o", "--out", type=file_place, required=True, metavar="FOLDER", help="new folder")
    parser.add_argument("--target", choices=TARGETS, default="c", help="program that uses it, see below (default: c)")
    usual = " and ".join(USUAL_TABLES)
    words = f"mouth table (may be repeated): a file, or one of {', '.join(shipped_tables())} (default: {usual})"
    parser.add_argument("--table", action="append", metavar="T", help=words)
    parser.add_argument("--embed", action="store_true", help="write the preset as a C array too (preset.c)")
    parser.add_argument("--overwrite", action="store_true", help="replace changed files too")


def run(options: argparse.Namespace) -> int:
    """Ship; returns the exit code."""
    tables = options.table or USUAL_TABLES
    preset = load_preset(options.preset)
    if note := without_real_time_model(preset):
        say_note(preset.name, note)
    choices = {"tables": tables, "embed": options.embed, "overwrite": options.overwrite}
    written = ship(preset, options.out, options.target, **choices)
    size = sum(path.stat().st_size for path in written)
    print(f"{options.out}: {preset.name!r} in {len(written)} files, {size / 1e6:.2f} MB; see README.md there")
    return 0
