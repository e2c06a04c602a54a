"""Expressions that were recorded: the CSV of Live Link Face."""

import os
from pathlib import Path

from phonemeengine.mouth.expression.streams import ExpressionStream, recorded_expression
from phonemeengine.performance.livelink import read_livelink


def read_expression(path: str | os.PathLike[str]) -> ExpressionStream:
    """Return a recording of Live Link Face as an expression, with the times of its time code from 0 on.

    Raises
    ------
    CorpusError : it cannot be read, or says something impossible.
    """
    face = read_livelink(Path(path))
    return recorded_expression(face.times, face.channels, face.weights)
