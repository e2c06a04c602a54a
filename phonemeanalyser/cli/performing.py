"""Faces that are looked up in tables of recorded performances, for commands that move a face."""

import argparse
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from phonemeanalyser.cli.output_files import write_whole
from phonemeengine import (
    EngineError,
    PerformanceOptions,
    PerformanceTable,
    PerformanceTrack,
    SoundReader,
    Transcript,
    Utterance,
    load_preset,
    transcribe,
)
from phonemeengine.batch.work import Say
from phonemeengine.labels.utterance_files import read_utterance
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.driver import PerformancePart
from phonemeengine.performance.keywords import load_keywords
from phonemeengine.performance.track import format_units, owns
from phonemeengine.replacing import Guard

PARTS = ",".join(PerformancePart)
CHOICES = [choice.value for choice in ExampleChoice]


def add_performance(parser: argparse.ArgumentParser) -> None:
    """Let the user have recorded faces say what is said, and choose how they are looked up."""
    table = "a table of recorded faces moves the face, or several, of which --use chooses one"
    parser.add_argument("--performance", type=Path, action="append", metavar="T.sqlite", help=table)
    parser.add_argument("--use", metavar="NAME", help="the name of the table that is used")
    parser.add_argument("--choice", choices=CHOICES, help=f"among examples of a unit (default: {CHOICES[0]})")
    parser.add_argument("--without", type=_parts, metavar="PARTS", help=f"leave out any of {PARTS}")
    words = "your own words with gestures, and conjunctions (TOML)"
    parser.add_argument("--keywords", type=Path, action="append", metavar="F", help=words)
    parser.add_argument("--units", type=Path, metavar="OUT.csv", help="write what was taken from which recording")


@dataclass(frozen=True)
class Performing:
    """How faces are looked up.

    Attributes
    ----------
    table : what they are looked up in.
    options : how.
    units : where the units are written that were used, if they are.
    guard : leaves alone whatever is there.
    """

    table: PerformanceTable
    options: PerformanceOptions
    units: Path | None
    guard: Guard

    def track(self, utterance: Utterance, speech: Transcript, say: Say) -> PerformanceTrack:
        """Return what the performer says; say what the table lacks for it, and write its units.

        Parameters
        ----------
        utterance, speech : what is said, and how loud and high.
        say : told what the table lacks.
        """
        track = PerformanceTrack(utterance, speech, self.table, self.options)
        for note in track.notes:
            say(self.table.about.name, note)
        if self.units is not None:
            write_whole(self.units, lambda file: file.writelines([format_units(track.units())]), self.guard)
        return track


@contextmanager
def performing(options: argparse.Namespace, say: Say) -> Iterator[Performing | None]:
    """Open the table that a command line asks for, and say if no person, but a model of one, moved in it.

    Where none is named, there is None.

    Raises
    ------
    EngineError : a table cannot be used, or it is not known which; or somebody's file is where the units go.
    """
    if options.performance is None:
        _check_unused(options)
        yield None
        return
    guard = Guard(owns, getattr(options, "overwrite", False))
    guard.check(options.units)
    choice, without = ExampleChoice(options.choice or CHOICES[0]), options.without or frozenset()
    keywords = load_keywords(*options.keywords or ())
    looked_up = PerformanceOptions(choice, options.seed or 0, without, keywords=keywords)
    with ExitStack() as stack:
        tables = [stack.enter_context(PerformanceTable.open(path)) for path in options.performance]
        yield Performing(_chosen(tables, options.use, say), looked_up, options.units, guard)


def _check_unused(options: argparse.Namespace) -> None:
    for name in ("use", "choice", "without", "keywords", "units"):
        if getattr(options, name) is not None:
            raise EngineError(f"--{name} goes with --performance; name a table of recorded faces")


def _chosen(tables: list[PerformanceTable], name: str | None, say: Say) -> PerformanceTable:
    named = [table for table in tables if name in {None, table.about.name}]
    if len(named) != 1:
        names = ", ".join(repr(table.about.name) for table in tables)
        raise EngineError(f"one table moves a face, and there are {names}; name one of them with --use")
    if named[0].about.synthetic:
        say(named[0].about.name, "the performer is synthetic: no person moved, but a model of one")
    return named[0]


def labelled(options: argparse.Namespace) -> tuple[Utterance, Transcript]:
    """Return what is said in ``--recording``, as the TextGrid beside it has it, and how loud and high."""
    with SoundReader(options.recording, options.channel) as reader:
        labels = read_utterance(options.recording.with_suffix(".TextGrid"), reader.duration)
    utterance = replace(labels, language=options.language or "")
    preset = load_preset(options.preset)
    return utterance, transcribe(options.recording, preset, channel=options.channel, pitch=True, script=utterance)


def _parts(text: str) -> frozenset[PerformancePart]:
    """Read the parts that are left out."""
    try:
        return frozenset(PerformancePart(part.strip()) for part in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"must be any of {PARTS}, with commas between, got {text!r}") from None
