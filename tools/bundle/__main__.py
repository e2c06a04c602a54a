"""Makes the program that needs no Python: ``make bundle``, or ``python -m tools.bundle -o FOLDER``."""

import argparse
from pathlib import Path

from tools.bundle.making import ROOT, make_bundle


def main() -> None:
    """Make it, and say how large it is."""
    parser = argparse.ArgumentParser(prog="python -m tools.bundle", description=__doc__)
    parser.add_argument("-o", "--out", type=Path, default=ROOT / "build" / "bundle", help="folder (build/bundle)")
    for made in make_bundle(parser.parse_args().out.resolve()):
        print(f"{made}: {_megabytes(made):.0f} MB")


def _megabytes(path: Path) -> float:
    files = [path] if path.is_file() else [file for file in path.rglob("*") if not file.is_symlink()]
    return sum(file.stat().st_size for file in files if file.is_file()) / 1e6


if __name__ == "__main__":
    main()
