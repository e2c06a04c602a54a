"""Feeds 200 000 damaged files to the readers, and keeps those that were not handled in build/fuzz."""

import argparse
import sys
import tempfile
from pathlib import Path

from tqdm import tqdm

from tools.fuzz.kinds import kinds
from tools.fuzz.reading import damaged
from tools.fuzz.running import ROOT, run

N = 200_000
KEPT = ROOT / "build" / "fuzz"


def main() -> int:
    """Run, and print what failed; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m tools.fuzz", description=__doc__)
    parser.add_argument("-n", type=int, default=N, help=f"damaged files (default {N})")
    parser.add_argument("--seed", default="1", help="of all damage")
    options = parser.parse_args()
    with tqdm(total=options.n, unit="file", mininterval=1) as bar:
        failures = run(options.n, options.seed, lambda n: bar.update(n - bar.n) and None)
        bar.update(options.n - bar.n)
    if failures:
        KEPT.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        every = kinds(Path(folder))
        for failure in failures:
            name = f"{options.seed}-{failure.number}"
            (KEPT / name).write_bytes(damaged(every, options.seed, failure.number)[1])
            print(f"{list(every)[failure.number % len(every)]}: {failure.what}; build/fuzz/{name}")
    print(f"{options.n} damaged files, {len(failures)} not handled")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
