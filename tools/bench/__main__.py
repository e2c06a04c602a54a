"""Measures how fast the machine is, then all figures or those that are named, and prints them as one table."""

import argparse
from collections.abc import Callable

from tools.bench import (
    alignment,
    batch,
    bundle,
    card,
    coarticulation,
    dragging,
    ear_builds,
    ear_in_c,
    head,
    learned,
    long_speech,
    memory,
    microphone,
    mouth,
    movestates,
    one_frame,
    opened_file,
    performance,
    performance_table,
    playing,
    real_time,
    recording,
    serving,
    speed,
    start,
    talking,
    voice,
    wasm,
    whole_file,
)
from tools.bench.figures import Figure, table_of

FIGURES: dict[str, Callable[[], list[Figure]]] = {
    "whole-file": whole_file.figures,
    "one-frame": one_frame.figures,
    "playing": playing.figures,
    "microphone": microphone.figures,
    "recording": recording.figures,
    "card": card.figures,
    "start": start.figures,
    "bundle": bundle.figures,
    "memory": memory.figures,
    "dragging": dragging.figures,
    "opened-file": opened_file.figures,
    "head": head.figures,
    "talking": talking.figures,
    "learned": learned.figures,
    "real-time": real_time.figures,
    "ear-in-c": ear_in_c.figures,
    "ear-builds": ear_builds.figures,
    "wasm": wasm.figures,
    "serving": serving.figures,
    "mouth": mouth.figures,
    "coarticulation": coarticulation.figures,
    "movestates": movestates.figures,
    "voice": voice.figures,
    "alignment": alignment.figures,
    "long-speech": long_speech.figures,
    "performance": performance.figures,
    "performance-table": performance_table.figures,
    "batch": batch.figures,
    "very-long-file": batch.memory_figures,
}


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
        found += [figure.here(speed.slowness(here)) for figure in FIGURES[name]()]
    print("", *table_of(found), sep="\n")
    if options.detail:
        print(
            "", "Imports of the start, slowest first (with what they import themselves):", *start.detail(), sep="\n"
        )


if __name__ == "__main__":
    main()
