"""Sound as whole numbers of 24 bits, and bytes on their way to the disk."""

from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array

FULL_SCALE = 1 << 23
"""The whole number that stands for 1.0; the largest that fits is one less."""


def to_integers(block: Float32Array) -> NDArray[np.int32]:
    """Return samples of 24 bits, so that k / 2**23 becomes exactly k; beyond ±1 is ±1, and NaN is silence.

    libsndfile's own conversion multiplies by 2**23 - 1 and would change every sample of a 16-bit sound card.
    """
    scaled = np.rint(np.nan_to_num(block, nan=0.0, posinf=1.0, neginf=-1.0) * np.float32(FULL_SCALE))
    return np.asarray(np.clip(scaled, -FULL_SCALE, FULL_SCALE - 1), np.int32)


def to_int24_bytes(numbers: NDArray[np.int32]) -> bytes:
    """Return whole numbers as three bytes each, the smallest first."""
    return numbers.astype("<i4").view(np.uint8).reshape(-1, 4)[:, :3].tobytes()


def write_all(file: BinaryIO, content: bytes) -> None:
    """Write all of it to an unbuffered file, which may take it in parts.

    Raises
    ------
    OSError : the disk refuses; a part may have been written.
    """
    rest = memoryview(content)
    while rest:
        rest = rest[file.write(rest) or 0 :]
