"""``phonemeanalyser rules``: find a few rules in labelled recordings, and write them as a preset."""

import argparse
import sys
from dataclasses import replace
from pathlib import Path

from tqdm import tqdm

from phonemeanalyser.cli.arguments import add_map, add_options
from phonemeanalyser.cli.jobs import say_cut_off
from phonemeanalyser.cli.parser import file_place, whole_in
from phonemeengine import CorpusError, PresetError, load_phoneme_map, load_preset, read_recordings, save_preset
from phonemeengine.calibration.fits.fitting import FitReport
from phonemeengine.calibration.fits.rule_finding import MOST_CONDITIONS_IN_ALL, rules_from
from phonemeengine.calibration.fits.rule_search import conditions_in
from phonemeengine.calibration.scores.scoring import Scores
from phonemeengine.presets.preset import rule_lines
from phonemeengine.storage.files import printable
from phonemeengine.storage.replacing import Guard, nothing_is_own

EXAMPLES = (
    "phonemeanalyser rules my-takes -o my-rules.toml",
    "phonemeanalyser rules my-takes -o few.toml --conditions 15",
    "phonemeanalyser rules my-takes -o my-thesis-rules.toml --preset thesis --variables preset",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what rules are found in, and what they may ask for."""
    parser.epilog = (
        "Grows a tree of few rules. Prints the figures of the preset before, of the rules on all recordings, and of "
        "rules that were found without each speaker in turn (without each take, or each quarter, of a single one)."
    )
    parser.add_argument("folders", type=Path, nargs="+", metavar="FOLDER", help="takes or labelled recordings")
    parser.add_argument("-o", "--out", type=file_place, required=True, metavar="PRESET", help="the new preset, .toml")
    parser.add_argument(
        "--conditions",
        type=whole_in(1, 500),
        default=MOST_CONDITIONS_IN_ALL,
        metavar="N",
        help=f"maximum number of conditions in all rules (default: {MOST_CONDITIONS_IN_ALL})",
    )
    parser.add_argument(
        "--variables",
        choices=["bands", "preset"],
        default="bands",
        help="what rules may compare: frequency bands, with filters that suit them, or the preset's variables "
        "(default: bands)",
    )
    add_options(parser, "preset", "channel", "overwrite")
    add_map(parser)


def run(options: argparse.Namespace) -> int:
    """Find rules; returns the exit code."""
    if options.out.suffix.lower() != ".toml":
        raise PresetError(f"{options.out}: a preset with rules is a file that ends in .toml; name it so")
    Guard(nothing_is_own, options.overwrite).check(options.out)
    mapping = load_phoneme_map(options.map) if options.map else None
    utterances = [u for folder in options.folders for u in read_recordings(folder, mapping, channel=options.channel)]
    if not utterances:
        raise CorpusError(
            f"{printable(str(options.folders[0]))}: it holds no labelled recordings; name a folder that does"
        )
    say_cut_off(utterances)
    with tqdm(total=100, unit="%", file=sys.stderr, disable=None, leave=False) as bar:
        report = rules_from(
            utterances,
            load_preset(options.preset),
            lambda share: bool(bar.update(100 * share - bar.n)) or True,
            bands=options.variables == "bands",
            most_conditions=options.conditions,
        )
    notes = f"{_figures(report)}\n"
    save_preset(replace(report.preset, name=options.out.stem, notes=notes), options.out)
    print(f"{options.out}: {notes}")
    print("\n".join(rule_lines(report.preset)))
    return 0


def _figures(report: FitReport) -> str:
    """Return what was found, and how right it is, in words."""
    rules, after = report.preset.rules, report.after
    lines = [
        f"{len(rules)} rules, {conditions_in(rules)} conditions, from {after.minutes:.1f} min of labelled sound."
    ]
    rows = [("before", report.before), ("these rules", after)]
    if report.held_out is not None:
        rows.append((f"{report.left_out}s held out", report.held_out))
    return "\n".join([*lines, *(f"{name}: {_scores(scores)}" for name, scores in rows)])


def _scores(scores: Scores) -> str:
    return (
        f"macro F1 {scores.macro_f1:.3f}, mouth shapes {scores.viseme_accuracy:.3f}, silence found "
        f"{scores.silence_recall:.3f}, false silence {scores.false_silence:.3f}, {scores.changes_per_s:.1f} changes "
        f"a second (labels: {scores.label_changes_per_s:.1f})"
    )
