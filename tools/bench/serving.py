"""Fifty live streams against `phonemeanalyser serve` on two cores: the latency of phonemes, and the cost."""

import shutil

import numpy as np

from tools.bench.figures import Absolute, Figure
from tools.bench.stream_load import MOST_LATE, loaded

N_STREAMS, SECONDS = 50, 20.0
SHARE = {"learned": 1.6, "extended": 0.8}
"""Of a core that the streams may take, by the preset."""


def figures() -> list[Figure]:
    """Measure with a server in a process of its own."""
    if shutil.which("taskset") is None:
        print("  left out: it needs taskset, which keeps a process on two cores")
        return []
    return [figure for preset, share in SHARE.items() for figure in _figures(preset, share)]


def _figures(preset: str, most: float) -> list[Figure]:
    load = loaded(N_STREAMS, SECONDS, preset)
    middle, high, late = (float(np.quantile(load.late, q)) for q in (0.5, 0.99, 1.0))
    name, shown = f"{N_STREAMS} streams, {preset}", f"median {1000 * middle:.0f} ms, p99 {1000 * high:.0f} ms"
    return [
        Figure(
            f"{name}: the latest frame",
            f"{1000 * late:.0f} ms",
            f"{1000 * MOST_LATE:.0f} ms; {shown}",
            late / MOST_LATE,
            1.0,
            absolute=Absolute.TIME,
        ),
        Figure(f"{name}: frames not told", str(load.n_missing), "none", float(load.n_missing), limit=0.0),
        Figure(
            f"{name}: the server",
            f"{load.share:.1%} of a core",
            f"{most:.0%}",
            load.share / most,
            1.0,
            absolute=Absolute.WORK,
        ),
    ]
