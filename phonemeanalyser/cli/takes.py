"""``phonemeanalyser takes``: what a folder of takes holds, and what has been deleted from it."""

import argparse
import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path

from phonemeengine import TakeError
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.calibration.takes.take import LIST

EXAMPLES = (
    "phonemeanalyser takes my-takes",
    "phonemeanalyser takes my-takes --empty-deleted",
    "phonemeanalyser takes my-takes --empty-deleted --yes",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say which folder, and whether it is cleared up."""
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="folder of takes, as the window makes it")
    parser.add_argument("--empty-deleted", action="store_true", help="remove deleted takes permanently, after asking")
    parser.add_argument("--yes", action="store_true", help="do not ask")


def run(options: argparse.Namespace) -> int:
    """Say what there is; 1 where deleted takes should have been removed, and the user did not want it after all."""
    if not (options.folder / LIST).is_file():
        raise TakeError(f"{options.folder}: there is no {LIST} in it, so these are no takes; name another folder")
    with TakeProject(options.folder) as project:
        for note in project.notes:
            print(f"phonemeanalyser: note: {note}", file=sys.stderr)
        for phoneme, n in sorted(Counter(take.phoneme for take in project.takes).items()):
            print(f"{phoneme.label:<12}  {n:4}")
        size = sum(project.path_of(take).stat().st_size for take in project.deleted)
        print(f"{len(project.takes)} takes, and {len(project.deleted)} deleted ones of {size / 1e6:.1f} MB")
        return empty_deleted(project, asks=not options.yes) if options.empty_deleted and project.deleted else 0


def empty_deleted(project: TakeProject, *, asks: bool, ask: Callable[[str], str] = input) -> int:
    """Remove the deleted takes for ever, once the user agrees where it asks; returns the exit status."""
    if asks and ask("Remove the deleted takes permanently? [y/N] ").strip().lower() not in {"y", "yes"}:
        return 1
    print(f"{project.empty_deleted()} deleted takes are removed")
    return 0
