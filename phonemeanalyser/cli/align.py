"""``phonemeanalyser align``: how well sounds say their lines, and which take of each line is the best."""

import argparse
import csv
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from phonemeanalyser.cli.arguments import HEARD, SAID, add_options, add_sounds, given
from phonemeanalyser.cli.jobs import file_preset, jobs_of, n_failed, say_note, work_through
from phonemeengine import Channel, EngineError, Preset
from phonemeengine.alignment.align import ScoredTake, best_marked, scored_take
from phonemeengine.analyser import analyse_file
from phonemeengine.batch.work import Act, Job, Made, Say, fingerprint_of
from phonemeengine.conversion.spoken_texts import SpokenTexts, made_of, open_sound
from phonemeengine.execution import Progress
from phonemeengine.storage.files import begins_like
from phonemeengine.storage.replacing import Guard, guarded_text

COLUMNS = ("file", "text", "score", "skipped", "unknown", "best")
OTHER_TEXT = "another text"

EXAMPLES = (
    "phonemeanalyser align speech.wav --script speech.txt --language en-us",
    "phonemeanalyser align recordings --script script.tsv --language en-us -o scores.csv",
    "phonemeanalyser align recordings --script auto --language en-us --model real-time",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is aligned, and with which words."""
    parser.epilog = (
        "Writes a CSV: file, text, score (0 is best), words not spoken, segments of unknown speech, best take."
    )
    add_sounds(parser)
    add_options(parser, *SAID, *HEARD, "overwrite")


def run(options: argparse.Namespace) -> int:
    """Align sound files with their texts; 1 where one could not be."""
    if options.text is None and options.script is None:
        options.parser.error("there is no text to align; give it with --text or --script")
    preset = file_preset(options)
    guard = Guard(begins_like(",".join(COLUMNS).encode() + b"\n"), options.overwrite)
    guard.check(options.out)
    jobs = jobs_of(options.inputs, Path(), "")
    texts = SpokenTexts.of(given(options), [job.source for job in jobs], say_note, with_labels=False)
    for labels in texts.labels.values():
        raise EngineError(
            f"{labels.name}: its words have times already, so there is nothing to align; name a script of text"
        )
    outcomes = work_through(jobs, AlignmentWork(preset, options.channel, texts))
    takes = [take for outcome in outcomes for take in outcome.made.value or ()]
    if takes:
        _write(best_marked(takes), options.out, guard)
    return 1 if n_failed(outcomes) or not takes else 0


@dataclass(frozen=True)
class AlignmentWork:
    """Finds how well sounds say their lines.

    Attributes
    ----------
    preset, channel : what is recognised with, and of what.
    texts : what is said in the sounds.
    """

    preset: Preset
    channel: Channel
    texts: SpokenTexts

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        return fingerprint_of("align", self.preset, self.channel)

    def known_of(self, job: Job) -> str:
        """Return what is said in a sound."""
        return self.texts.known_of(job.sound)

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Give what aligns one file."""
        yield self._align

    def _align(self, job: Job, say: Say, progress: Progress) -> Made:
        """Return how well a sound says its line; nothing where it has none."""
        with open_sound(job.source, self.channel, say) as reader:
            analyses = analyse_file(reader, self.preset, progress=progress)
            found = self.texts.aligned(reader, job.sound, analyses, say)
            takes = [] if found is None else [scored_take(job.source, self.texts.texts[job.sound], found[0])]
            return replace(made_of(reader, found and found[0]), value=takes)


def _write(takes: Sequence[ScoredTake], out: Path | None, guard: Guard) -> None:
    with guarded_text(out, guard) as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(COLUMNS)
        rows.writerows(_row(take) for take in takes)


def _row(take: ScoredTake) -> tuple[str, ...]:
    skipped = OTHER_TEXT if take.is_other else " ".join(take.skipped)
    score = "" if take.score is None or take.is_other else f"{take.score:.3f}"
    text = " ".join(take.text.split())
    return take.path.as_posix(), text, score, skipped, str(take.n_unknown), "best" if take.is_best else ""
