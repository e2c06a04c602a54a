"""Weights as lines of numbers, fast: columns that never move cost nothing."""

from collections.abc import Iterator

import numpy as np

from phonemeengine.arrays import Float32Array

ROWS = 4096
"""Rows that are numbers of Python at a time, each of which takes eight times the memory."""


def number_lines(weights: Float32Array, separator: str = ",", digits: int = 5) -> Iterator[str]:
    """Return each row of weights, shape (n, n_columns), as text with a fixed number of digits."""
    moving = np.any(weights, axis=0)
    pattern = separator.join(f"%.{digits}f" if moves else f"{0:.{digits}f}" for moves in moving.tolist())
    for first in range(0, len(weights), ROWS):
        for row in weights[first : first + ROWS, moving].tolist():
            yield pattern % tuple(row)
