"""Analyse files without a window: each sound file becomes a table of its phonemes, or of every frame's variables."""

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from phonemeanalyser.cli.arguments import HEARD, SAID, add_batch, add_options, add_sounds, given
from phonemeanalyser.cli.jobs import file_preset, finish_jobs, is_single, jobs_of, say_note, share_paths
from phonemeengine import Channel, EngineError, Preset, difference
from phonemeengine.batch.work import Act, Job, Made, Say, fingerprint_of
from phonemeengine.conversion.spoken_texts import open_sound
from phonemeengine.conversion.work import ConversionWork
from phonemeengine.execution import Progress
from phonemeengine.inspection.analysis_tables import TABLES
from phonemeengine.inspection.whole_sound import DIFFERENCE_COLUMNS, format_difference
from phonemeengine.storage.files import begins_like, printable_name
from phonemeengine.storage.replacing import Guard, guarded_text

EXAMPLES = (
    "phonemeanalyser analyse speech.wav",
    "phonemeanalyser analyse recordings -o labels --format textgrid",
    "phonemeanalyser analyse speech.wav -o frames.csv --features --preset extended",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is analysed, and how that is written."""
    add_sounds(parser)
    add_options(parser, *SAID, *HEARD, "overwrite")
    parser.add_argument(
        "--format", choices=list(TABLES), dest="kind", help="file format (default: from the ending of OUT, else csv)"
    )
    words = "second preset: write the segments that it recognises differently, as start_s,end_s,first,second"
    parser.add_argument("--against", type=Path, metavar="B", help=words)
    parser.add_argument("--features", action="store_true", help="write every 10 ms frame with all variables")
    add_batch(parser)


def run(options: argparse.Namespace) -> int:
    """Analyse sound files as the command line asks; 1 where one could not be."""
    share_paths(options)
    if options.against is not None:
        return _compare(options)
    table = options.kind or kind_for(options.inputs, options.out)
    if options.features and TABLES[table].write_frames is None:
        raise EngineError(
            f"a file of labels ({TABLES[table].ending}) has no place for the variables of every frame; leave out "
            "--features, or write them with --format csv or json"
        )
    asked, kind = given(options), f"frames-{table}" if options.features else f"phonemes-{table}"
    preset = file_preset(options)
    jobs = jobs_of(options.inputs, options.out, TABLES[table].ending)
    if options.features and (asked.text, asked.script) != (None, None):
        options.parser.error("--features are of frames, and --text or --script give words; leave one of them out")
    work = ConversionWork.of(asked, kind, preset, [job.source for job in jobs], say_note)
    return finish_jobs(jobs, work, options)


def _compare(options: argparse.Namespace) -> int:
    """Write where two presets differ; return 1 where a sound could not be analysed."""
    if options.kind not in {None, "csv"} or options.features or options.text or options.script:
        options.parser.error("--against writes a table of its own; leave --format, --features and texts out")
    first, second = (file_preset(options, path) for path in (options.preset, options.against))
    work = DifferenceWork(first, second, options.channel, options.overwrite)
    jobs = jobs_of(options.inputs, options.out, ".csv")
    return finish_jobs(jobs, work, options)


@dataclass(frozen=True)
class DifferenceWork:
    """Writes where two presets differ.

    Attributes
    ----------
    first, second : the presets.
    channel : which channel is analysed.
    overwrite : whether whatever is there is replaced.
    """

    first: Preset
    second: Preset
    channel: Channel
    overwrite: bool

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        return fingerprint_of("difference", self.first, self.second, self.channel)

    def known_of(self, _job: Job) -> str:
        """Return an empty string: nothing is known of a file besides."""
        return ""

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Give what compares one file."""

        def act(job: Job, say: Say, progress: Progress) -> Made:
            guard = Guard(begins_like(",".join(DIFFERENCE_COLUMNS).encode()), self.overwrite, job.earlier)
            guard.check(job.target)
            with open_sound(job.source, self.channel, say) as reader:
                duration = reader.duration
            found = difference(job.source, self.first, self.second, channel=self.channel, progress=progress)
            say(printable_name(job.source), f"the presets differ in {100 * found.share:.1f} % of the frames")
            with guarded_text(job.target, guard) as file:
                file.write(format_difference(found))
            return Made(duration)

        yield act


def kind_for(inputs: list[Path], out: Path | None) -> str:
    """Return the format that the name of a single table asks for; ``csv`` where it asks for none."""
    if out is None or not is_single(inputs, out):
        return "csv"
    return {form.ending.lower(): kind for kind, form in TABLES.items()}.get(out.suffix.lower(), "csv")
