"""Has fifty live streams, with weights and probabilities, run against a server on two cores, beside bad clients."""

import argparse
import statistics
import sys
from collections.abc import Iterator

import numpy as np

from tools.bench.stream_load import MOST_LATE, Load, loaded
from tools.soak.__main__ import Row, print_rows

GROWTH = 8.0
"""MB that the memory may grow: clients come and go, each with buffers."""


def main() -> None:
    """Print the table; exit with 1 if something is wrong."""
    parser = argparse.ArgumentParser(prog="python -m tools.soak.serving", description=__doc__)
    parser.add_argument("--minutes", type=float, default=10.0, help="how long (default: 10)")
    parser.add_argument("--streams", type=int, default=50, help="how many (default: 50)")
    parser.add_argument("--preset", default="learned")
    parser.add_argument("--table", default="arkit", help="mouth table; an empty name leaves weights and scores out")
    options = parser.parse_args()
    load = loaded(options.streams, 60 * options.minutes, options.preset, table=options.table, disturbed=True)
    sys.exit(print_rows(_rows(load)))


def _rows(load: Load) -> Iterator[Row]:
    middle, high, most = (1000 * float(np.quantile(load.late, q)) for q in (0.5, 0.99, 1.0))
    yield Row("frames", f"{len(load.late)} told, {load.n_missing} missing", load.n_missing == 0)
    yield Row("late", f"median {middle:.0f} ms, p99 {high:.0f} ms, most {most:.0f} ms", most < 1000 * MOST_LATE)
    yield Row(
        "later than 100 ms", f"{load.n_late}; the client itself was held up {1000 * load.held_up:.0f} ms at most"
    )
    yield Row("recognised", load.shares)
    settled = load.megabytes[len(load.megabytes) // 3 :]
    third = max(1, len(settled) // 3)
    growth = statistics.median(settled[-third:]) - statistics.median(settled[:third])
    span = f"{min(settled):.0f} to {max(settled):.0f} MB, grown by {growth:.1f} MB"
    yield Row("memory", span, growth < GROWTH)
    yield Row("processor of the server", f"{load.share:.1%} of a core")


if __name__ == "__main__":
    main()
