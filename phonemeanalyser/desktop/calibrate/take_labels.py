"""The labels of all takes of a project, written for other programs."""

from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.calibration.takes.take import TAKES
from phonemeengine.errors import TakeError


def write_labels_of(project: TakeProject | None, suffix: str, program: str) -> str:
    """Write label files beside all takes, and say how many.

    Raises
    ------
    TakeError : there are no takes.
    """
    if project is None or not project.takes:
        raise TakeError("There are no takes yet whose labels could be written; record one first.")
    aside, n = project.write_copies(suffix), len(project.takes)
    files = f"{n} label file{'s' if n > 1 else ''} for {program} {'lie' if n > 1 else 'lies'} beside the takes"
    kept = f"; what else was there is kept, such as {aside[0].name}" if aside else ""
    return f"{files} in {project.folder / TAKES}{kept}."
