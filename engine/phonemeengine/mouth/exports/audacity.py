"""Audacity's label track: start, end and name of each mouth shape, with tabs between them."""

from collections.abc import Iterator

from phonemeengine.mouth.exports.export import Export


def write(export: Export) -> Iterator[str]:
    """Write a line for each drawing."""
    for cue in export.drawings:
        yield f"{cue.start:.6f}\t{cue.end:.6f}\t{cue.shape}\n"
