"""``phonemeanalyser score``: how right presets are on labelled recordings."""

import argparse
import csv
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from tqdm import tqdm

import phonemeengine
from phonemeanalyser.cli.arguments import HEARD, add_batch, add_map, add_options, refuse_unused
from phonemeanalyser.cli.jobs import file_preset, say_cut_off, share_paths, work_through
from phonemeanalyser.cli.parser import number_in, whole_in
from phonemeanalyser.cli.prediction_work import PredictionWork, words_to_score
from phonemeanalyser.reports.figures import json_of, text_of
from phonemeanalyser.reports.page import page_of
from phonemeanalyser.reports.report import Report, ScoredPreset
from phonemeengine.batch.runner import BatchOptions
from phonemeengine.batch.work import JobState, Outcome
from phonemeengine.calibration.scores.added_noise import HIGHEST_SNR, LOWEST_SNR, AddedNoise, NoiseKind
from phonemeengine.calibration.scores.comparison import compare
from phonemeengine.calibration.scores.evaluation import CorpusScores, corpus_scores_of
from phonemeengine.calibration.scores.scoring import ERROR_COLUMNS, label_errors
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.calibration.workbench.phoneme_data_table import NUMBER_COLUMNS, number_rows, number_table
from phonemeengine.storage.files import printable, printable_name
from phonemeengine.storage.replacing import Guard, guarded_text, nothing_is_own

KINDS = {".html": "html", ".htm": "html", ".json": "json"}
"""The formats that an ending asks for; text is the format of all others."""
MOST_LAG_MS = 1000.0


@dataclass(frozen=True)
class Named:
    """A preset, the title that tells it from another one, and where it came from."""

    title: str
    preset: phonemeengine.Preset


EXAMPLES = (
    "phonemeanalyser score corpus",
    "phonemeanalyser score corpus --preset extended --against thesis -o report.html",
    "phonemeanalyser score corpus --noise pink --snr 10 --errors errors.csv",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what is scored, and how that is reported."""
    parser.add_argument(
        "corpus", type=Path, metavar="CORPUS", help="folder with manifest.csv, or with sounds beside label files"
    )
    add_options(parser, *HEARD, model=phonemeengine.ModelKind.REAL_TIME)
    parser.add_argument("--against", type=Path, metavar="B", help="second preset to compare with")
    parser.add_argument(
        "--format",
        choices=["text", "json", "html"],
        dest="kind",
        help="file format (default: from the ending of OUT, else text)",
    )
    parser.add_argument("-o", "--out", type=Path, metavar="OUT", help="report to write (default: print)")
    parser.add_argument(
        "--by", choices=["corpus", "speaker"], default="corpus", help="rows of the text report (default: corpus)"
    )
    lag = number_in(-MOST_LAG_MS, MOST_LAG_MS, "ms")
    parser.add_argument("--lag", type=lag, default=0.0, metavar="MS", help="delay of the answers against the labels")
    add_map(parser)
    texts = "score the alignment of the texts: the manifest's column text, or --script"
    parser.add_argument("--texts", action="store_true", help=texts)
    parser.add_argument("--script", type=Path, metavar="FILE", help="table with a line FILE<TAB>TEXT for each file")
    add_options(parser, "language", "lexicon", "literal", "overwrite")
    where = "write the segments of 30 ms or more that differ from the labels"
    parser.add_argument("--errors", type=Path, metavar="CSV", help=where)
    where = "write the 21 numbers of PhonemeData, with the values that they divide by speaker"
    parser.add_argument("--phoneme-data", type=Path, metavar="CSV", help=where)
    parser.add_argument("--noise", choices=[k.value for k in NoiseKind], help="add noise before the analysis")
    snr = number_in(LOWEST_SNR, HIGHEST_SNR, "dB")
    parser.add_argument("--snr", type=snr, metavar="DB", help="signal-to-noise ratio")
    parser.add_argument("--seed", type=whole_in(0), default=0, metavar="N", help="seed of the noise (default: 0)")
    add_batch(parser)
    keep = "keep recognised phonemes here, so that an interrupted run can continue"
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help=keep)


def run(options: argparse.Namespace) -> int:
    """Score presets as the command line asks; 1 where a sound could not be read."""
    share_paths(options)
    if (options.noise is None) != (options.snr is None):
        options.parser.error("--noise and --snr go together; give both")
    if not (options.texts or options.script):
        refuse_unused(options, ("language", "lexicon", "literal"), "goes with --texts or --script; give one of them")
    for out in (options.out, options.errors, options.phoneme_data):
        Guard(nothing_is_own, options.overwrite).check(out)
    presets = _presets_of(options)
    noise = None if options.noise is None else AddedNoise(NoiseKind(options.noise), options.snr, options.seed)
    mapping = None if options.map is None else phonemeengine.load_phoneme_map(options.map)
    troubles: list[str] = []
    utterances = _recordings_in(options.corpus, mapping, options.channel, troubles)
    words = words_to_score(options, utterances)
    scored: list[ScoredPreset] = []
    for letter, named in zip("ab", presets, strict=False):
        work = PredictionWork(named.preset, utterances, options.lag / 1000, noise, words)
        found = _scored(work, options.keep and options.keep / letter, options, troubles)
        scored.append(ScoredPreset(f"{named.title} with texts" if words else named.title, found))
        utterances = tuple(p.utterance for p in scored[-1].scores.predictions)
    if options.errors is not None:
        _write_errors(scored, options.errors)
    if options.phoneme_data is not None:
        _write_numbers(presets, utterances, options.phoneme_data)
    comparison = compare(*(preset.scores for preset in scored)) if len(scored) > 1 else None
    report = Report(options.corpus, tuple(scored), comparison, noise, tuple(troubles))
    _write(report, options.kind or KINDS.get((options.out or Path()).suffix.lower(), "text"), options.by, options.out)
    return 1 if troubles else 0


def _write_errors(scored: Sequence[ScoredPreset], path: Path) -> None:
    """Write the errors of each preset, recording by recording."""
    with guarded_text(path) as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(("preset", "sound", *ERROR_COLUMNS))
        for preset in scored:
            for p in preset.scores.predictions:
                rows.writerows(
                    (preset.title, p.utterance.path, *found.row()) for found in label_errors(p.labels, p.phonemes)
                )


def _write_numbers(
    presets: Sequence[Named], utterances: Sequence[phonemeengine.LabelledUtterance], path: Path
) -> None:
    """Write the numbers of the first preset, those of the second beside them, and what they divide."""
    data = [named.preset.phoneme_data for named in presets]
    rows = number_rows(LabelledFeatures(utterances, presets[0].preset))
    with guarded_text(path) as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(NUMBER_COLUMNS)
        table.writerows(number_table(rows, *data))


def _recordings_in(
    folder: Path, mapping: phonemeengine.PhonemeMap | None, channel: phonemeengine.Channel, troubles: list[str]
) -> tuple[phonemeengine.LabelledUtterance, ...]:
    def refuse(error: phonemeengine.AudioError) -> None:
        troubles.append(str(error))
        tqdm.write(f"phonemeanalyser: {error}", file=sys.stderr)

    utterances = phonemeengine.read_recordings(folder, mapping, channel=channel, on_skipped=refuse)
    say_cut_off(utterances)
    return utterances


def _scored(
    work: PredictionWork, keep: Path | None, options: argparse.Namespace, troubles: list[str]
) -> CorpusScores:
    """Recognise all recordings, and compare the answers with the labels."""

    def take(outcome: Outcome) -> None:
        if outcome.state is JobState.FAILED:
            troubles.append(outcome.words)
        elif isinstance(outcome.made.value, phonemeengine.EngineError):
            raise outcome.made.value

    how = BatchOptions(options.jobs, keep, options.dask)
    outcomes = work_through(work.jobs(keep), work, how, take)
    predictions = [work.predictions_of(outcome) for outcome in outcomes if outcome.state is not JobState.FAILED]
    return corpus_scores_of(work.preset, predictions, work.delay)


def _presets_of(options: argparse.Namespace) -> list[Named]:
    first, against = options.preset, options.against
    one = file_preset(options)
    if against is None:
        return [Named(printable(one.name), one)]
    other = file_preset(options, against)
    if one == other:
        raise phonemeengine.PresetError(
            f"{printable_name(first)} and {printable_name(against)} hold the same preset; name two that differ"
        )
    titles = [one.name, other.name]
    if one.name == other.name:
        same_file = first.name == against.name
        titles = [f"{one.name} ({path if same_file else path.name})" for path in (first, against)]
    return [Named(printable(title), preset) for title, preset in zip(titles, (one, other), strict=True)]


def _write(report: Report, kind: str, by: str, out: Path | None) -> None:
    parts = _parts_of(report, kind, by)
    with guarded_text(out) as file:
        file.writelines(parts)


def _parts_of(report: Report, kind: str, by: str) -> Iterator[str]:
    if kind == "html":
        yield page_of(report)
    elif kind == "json":
        yield json_of(report)
    else:
        yield text_of(report, by)
