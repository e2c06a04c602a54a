"""The weights of the fifteen visemes of Oculus Lipsync as CSV: a row a frame, its time in seconds first."""

from collections.abc import Iterator

from phonemeengine.mouth.blendshape_names import OCULUS
from phonemeengine.mouth.exports.export import Export, number_lines
from phonemeengine.storage.files import begins_like

HEADER = ",".join(["time_s", *OCULUS]) + "\n"

owns = begins_like(HEADER.encode())


def write(export: Export) -> Iterator[str]:
    """Write the header and a row for each frame."""
    yield HEADER
    frame = 0
    for block in export.animation_blocks():
        for line in number_lines(block.weights):
            yield f"{frame / block.rate:.6f},{line}\n"
            frame += 1
