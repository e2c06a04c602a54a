"""Measures how fast the machine is, then all figures or those that are named, and prints them as one table."""

import argparse
from pathlib import Path
from pkgutil import resolve_name

from tools.bench import speed, start
from tools.bench.figures import Figure, table_of

FIGURES = {
    path.stem.replace("_", "-"): f"tools.bench.{path.stem}:figures"
    for path in sorted(Path(__file__).parent.glob("*.py"))
    if "\ndef figures(" in path.read_text("utf-8")
} | {"very-long-file": "tools.bench.batch:memory_figures"}
"""What measures each."""


def main() -> None:
    """Print the table; a figure over its limit is no failure, since timings are no tests."""
    parser = argparse.ArgumentParser(prog="python -m tools.bench", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="FIGURE", help=f"any of {', '.join(FIGURES)} (default: all)")
    parser.add_argument("--detail", action="store_true", help="say which imports the start spends its time on")
    options = parser.parse_args()
    if unknown := set(options.names) - set(FIGURES):
        parser.error(f"there is no figure {', '.join(sorted(unknown))}; known are {', '.join(FIGURES)}")
    here = speed.bare_transform()
    print(speed.in_words(here), flush=True)
    found: list[Figure] = []
    for name in options.names or FIGURES:
        print(f"measuring {name} ...", flush=True)
        found += [figure.here(speed.slowness(here)) for figure in resolve_name(FIGURES[name])()]
    print("", *table_of(found), sep="\n")
    if options.detail:
        print(
            "", "Imports of the start, slowest first (with what they import themselves):", *start.detail(), sep="\n"
        )


if __name__ == "__main__":
    main()
