"""The weights of the fifteen visemes of Oculus Lipsync as CSV: a row a frame, its time in seconds first."""

from collections.abc import Iterator

from engine.mouth.exports.export import Export
from engine.mouth.exports.rows import lines_of
from engine.mouth.names import OCULUS
from engine.own_files import begins_like

HEADER = ",".join(["time_s", *OCULUS]) + "\n"

owns = begins_like(HEADER.encode())


def write(export: Export) -> Iterator[str]:
    """Write the header and a row for each frame."""
    animation = export.animation
    yield HEADER
    for time, line in zip(animation.times.tolist(), lines_of(animation.weights), strict=True):
        yield f"{time:.6f},{line}\n"
