"""Options of the pinyin mouth, for commands that speak, and what they write of its plan."""

import argparse
from dataclasses import replace
from pathlib import Path

from phonemeanalyser.cli.arguments import number
from phonemeanalyser.cli.output_files import print_whole, write_whole
from phonemeengine import PinyinTable, PinyinTrack, Spring, format_plan, load_pinyin_table
from phonemeengine.speech.pinyin.timing import FASTEST, SLOWEST, USUAL_RATE

STANDARD_OUTPUT = Path("-")


def add_pinyin(parser: argparse.ArgumentParser) -> None:
    """Let the user choose letters, speed and springs of the pinyin mouth, and have its plan."""
    parser.add_argument("--pinyin-table", type=Path, metavar="T", help="a pinyin table (.toml) of yours")
    rate = f"syllables a second without sound, {SLOWEST:g}..{FASTEST:g} ({USUAL_RATE:g})"
    parser.add_argument("--rate", type=number, default=USUAL_RATE, metavar="N", help=rate)
    parser.add_argument("--seed", type=int, metavar="N", help="vary onsets, and make another face (default: neither)")
    parser.add_argument("--spring", metavar="M,K,D", help="a spring moves the mouth: mass, stiffness, damping")
    parser.add_argument("--plan", type=Path, metavar="OUT", help="write syllables and pauses as CSV; - prints it")


def pinyin_table_of(options: argparse.Namespace) -> PinyinTable:
    """Return the table that the command line asks for."""
    table = load_pinyin_table(options.pinyin_table) if options.pinyin_table else load_pinyin_table()
    return table if options.spring is None else replace(table, spring=Spring.of(options.spring))


def write_plan(track: PinyinTrack, target: Path) -> None:
    """Write the plan of a track as CSV, or print it."""
    text = format_plan(track.plan)
    if target == STANDARD_OUTPUT:
        print_whole(lambda file: file.writelines([text]))
    else:
        write_whole(target, lambda file: file.writelines([text]))
