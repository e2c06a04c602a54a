"""``phonemeanalyser spectra``: the averaged spectra of speakers and phonemes, as a table, curves and a picture."""

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

from tqdm import tqdm

from phonemeanalyser.cli.arguments import add_map, add_options
from phonemeanalyser.reports.spectra_plot import plot_of
from phonemeengine import AudioError, load_preset
from phonemeengine.errors import remedy
from phonemeengine.execution import subrange
from phonemeengine.inspection import averaged_spectrum
from phonemeengine.inspection.speaker_spectra import VOWELS, Grouping, Groups, average_parts, groups_in
from phonemeengine.labels.phone_sets import load_phoneme_map
from phonemeengine.phonemes import PHONEMES_BY_LABEL, Phoneme
from phonemeengine.settings import AnalysisSettings
from phonemeengine.storage.files import begins_like, portable_name
from phonemeengine.storage.replacing import Guard, guarded_text, nothing_is_own

VOWELS_WORD = "vowels"
PHONEMES = {label: (phoneme,) for label, phoneme in PHONEMES_BY_LABEL.items()} | {VOWELS_WORD: VOWELS}
"""What `--phoneme` takes, and which phonemes that names."""

EXAMPLES = (
    "phonemeanalyser spectra corpus --by speaker --phoneme vowels -o vowels.csv",
    "phonemeanalyser spectra corpus --by phoneme --plot phonemes.svg -o phonemes.csv",
    "phonemeanalyser spectra corpus --differences differences.csv --curves curves -o speakers.csv",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is averaged, and where that goes."""
    words = "folder of labelled recordings, or a labelled audio file; without labels, each folder in it is a speaker"
    parser.add_argument("source", type=Path, metavar="FOLDER", help=words)
    parser.add_argument(
        "--by", choices=[by.value for by in Grouping], default="speaker", help="a curve for each (default: speaker)"
    )
    parser.add_argument(
        "--phoneme",
        type=_phonemes,
        action="append",
        default=[],
        metavar="P",
        help=f"only this phoneme, such as a, sz or {VOWELS_WORD}; repeatable (default: all but silence)",
    )
    parser.add_argument("-o", "--out", type=Path, metavar="CSV", help="levels and spread in dB (default: print)")
    parser.add_argument("--differences", type=Path, metavar="CSV", help="write the differences of all pairs, dB")
    parser.add_argument("--plot", type=Path, metavar="SVG", help="write a picture of the curves")
    parser.add_argument("--curves", type=Path, metavar="FOLDER", help="write each curve as a file for the window")
    add_map(parser)
    add_options(parser, "preset", "channel", "overwrite")
    add_options(parser, "theme")


def run(options: argparse.Namespace) -> int:
    """Average; returns the exit code: 1 where a sound could not be read."""
    guards = {
        "out": Guard(begins_like(b"frequency_hz,"), options.overwrite),
        "differences": Guard(begins_like(b"difference_db,"), options.overwrite),
        "plot": Guard(nothing_is_own, options.overwrite),
    }
    for name, guard in guards.items():
        guard.check(getattr(options, name))
    mapping = None if options.map is None else load_phoneme_map(options.map)
    phonemes = [phoneme for named in options.phoneme for phoneme in named]
    troubles: list[AudioError] = []
    groups = groups_in(
        options.source,
        Grouping(options.by),
        phonemes,
        mapping=mapping,
        channel=options.channel,
        on_skipped=troubles.append,
    )
    curves = _averaged(groups, load_preset(options.preset).settings)
    written: dict[str, Callable[[], str]] = {
        "out": lambda: averaged_spectrum.format_spectra(curves),
        "differences": lambda: averaged_spectrum.format_distances(curves),
        "plot": lambda: plot_of(curves, options.theme),
    }
    for name, text in written.items():
        if name == "out" or getattr(options, name) is not None:
            with guarded_text(getattr(options, name), guards[name]) as file:
                file.write(text())
    if options.curves is not None:
        _write_curves(
            curves, options.curves, Guard(begins_like(f"# {averaged_spectrum.FORMAT}".encode()), options.overwrite)
        )
    for trouble in troubles:
        print(f"phonemeanalyser: {trouble}", file=sys.stderr)
    return 1 if troubles else 0


def _averaged(groups: Groups, settings: AnalysisSettings) -> list[averaged_spectrum.AveragedSpectrum]:
    """Average each group, with a progress bar at terminals."""
    curves: list[averaged_spectrum.AveragedSpectrum] = []
    with tqdm(total=100, unit="%", file=sys.stderr, disable=None, leave=False) as bar:

        def show(share: float) -> bool:
            bar.update(100 * share - bar.n)
            return True

        for k, (name, parts) in enumerate(groups.items()):
            bar.set_description_str(name)
            share = subrange(show, k / len(groups), (k + 1) / len(groups))
            curves.append(average_parts(parts, settings, name, progress=share))
    return curves


def _write_curves(curves: list[averaged_spectrum.AveragedSpectrum], folder: Path, guard: Guard) -> None:
    for curve in curves:
        with guarded_text(folder / f"{portable_name(curve.name)}.csv", guard) as file:
            file.write(averaged_spectrum.format_averaged_spectrum(curve))


def _phonemes(text: str) -> tuple[Phoneme, ...]:
    if text not in PHONEMES:
        raise argparse.ArgumentTypeError(f"there is no phoneme {text!r}; {remedy(text, PHONEMES)}")
    return PHONEMES[text]
