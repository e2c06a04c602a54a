"""Where sounds begin and end, finer than frames: where one suits as well as the next, and where speech has faded."""

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np

from phonemeengine.alignment.evidence import Evidence, spoken_in
from phonemeengine.alignment.passage import Passage
from phonemeengine.alignment.viterbi import SILENT, SKIPPED, SOUND, WayStep
from phonemeengine.arrays import Float32Array, Float64Array

FADED = 28.0
"""A sound before a pause ends where it is so many dB below loud speech: synthesizers' own ends lie at 14 to 39."""
ABOVE_PAUSE = 8.0
"""Or where it is so little above the pause, dB, if that is louder."""
LONGEST_FADING = 12
"""Frames for which a sound may fade after the recogniser hears silence."""
LOUD = 90
"""Percentile of the level of speech that is loud."""


def edges_of(
    steps: Sequence[WayStep], passage: Passage, shortfalls: Float64Array, evidence: Evidence
) -> Mapping[int, float]:
    """Return where the edges between the steps of a way are, in frames, by the number of the frame after each."""
    levels, spoken = evidence.levels[:, 0], spoken_in(evidence)
    quiet = float(np.percentile(levels[spoken], LOUD)) - FADED if spoken.any() else np.inf
    edges: dict[int, float] = {}
    lasting = [step for step in steps if step.kind != SKIPPED]
    for step, following in pairwise(lasting):
        edge = step.last
        if step.kind == SOUND and following.kind == SILENT and not passage.closes(following, lasting):
            edges[edge] = _faded(levels, step, following, quiet)
        else:
            columns = [passage.column_of(part) for part in (step, following)]
            if None not in columns:
                edges[edge] = _crossing(shortfalls[:, columns[0]] - shortfalls[:, columns[1]], edge)
    return edges


def _crossing(lead: Float64Array, edge: int) -> float:
    """Return where the lead of one sound over the next ends; frames are measured at their middle."""
    before, after = float(lead[edge - 1]), float(lead[edge])
    return edge - 0.5 + before / (before - after) if before > 0 > after else float(edge)


def _faded(levels: Float32Array, step: WayStep, pause: WayStep, quiet: float) -> float:
    """Return where a sound before a pause has faded, at the earliest where the recogniser hears silence."""
    limit = max(quiet, float(levels[pause.first : pause.last].min()) + ABOVE_PAUSE)
    last = min(step.last + LONGEST_FADING, (pause.first + pause.last) // 2)
    frame = step.last - 1
    if levels[frame] < limit:
        return float(step.last)
    while frame + 1 < last and levels[frame + 1] >= limit:
        frame += 1
    if frame + 1 >= len(levels) or levels[frame + 1] >= limit:
        return float(max(step.last, last))
    return max(step.last - 0.5, frame + 0.5 + float((levels[frame] - limit) / (levels[frame] - levels[frame + 1])))
