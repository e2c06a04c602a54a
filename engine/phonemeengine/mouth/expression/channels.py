"""What each channel of a face belongs to: the speech, the expression, or both by a share."""

import os
from dataclasses import dataclass
from functools import cache, lru_cache
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError
from phonemeengine.mouth.blendshape_names import ARKIT, both_sides
from phonemeengine.mouth.face_mapping import shapes_moved_by
from phonemeengine.storage.strict_table import load_text, parse_toml, shown

FORMAT = "phonemeanalyser expression channels 1"
SHIPPED = Path(__file__).resolve().parent / "channels.toml"


@dataclass(frozen=True, eq=False)
class ExpressionChannels:
    """The channels on which speech and expressions meet.

    Attributes
    ----------
    names : the movestates, in the order of all weights.
    speech : the class weight of speech cS of each, 0..1, float32, shape (n_channels,); that of expressions is 1 - cS.
    reductions : how much of an expression goes during speech, 0..1, shape (n_channels,).
    """

    names: tuple[str, ...]
    speech: Float32Array
    reductions: Float32Array


@cache
def shipped_channels() -> ExpressionChannels:
    """Return the classes of the 52 blend shapes of ARKit that ship with the program."""
    return load_channels(SHIPPED)


def load_channels(path: str | os.PathLike[str]) -> ExpressionChannels:
    """Read the classes of the 52 blend shapes of ARKit from a TOML file; see ``channels.toml`` for an example.

    Raises
    ------
    MouthError : the file cannot be read, or does not put each of them into one class.
    """
    return load_text(path, "expression channels (.toml)", MouthError, _channels_in)


def _channels_in(text: str) -> ExpressionChannels:
    top = parse_toml(text, "a file of expression channels", FORMAT, MouthError)
    top.check_keys(("classes",), ("notes",))
    speech, reductions = np.full(len(ARKIT), np.nan, np.float32), np.zeros(len(ARKIT), np.float32)
    for _, entry in top.table("classes").tables_by_name():
        entry.check_keys(("speech", "reduction", "channels"))
        share, reduction = (entry.limited(key, 0, 1, "a number in 0..1") for key in ("speech", "reduction"))
        for column in [k for channel in entry.value("channels", list) for k in columns_of(channel)]:
            if not np.isnan(speech[column]):
                raise MouthError(f"[classes] has {ARKIT[column]} twice; name it once")
            speech[column], reductions[column] = share, reduction
    if missing := [name for name, share in zip(ARKIT, speech, strict=True) if np.isnan(share)]:
        raise MouthError(f"[classes] lacks {', '.join(missing[:4])}; put each blend shape into a class")
    return ExpressionChannels(ARKIT, speech, reductions)


def columns_of(name: object) -> list[int]:
    """Return the numbers of the blend shapes in `ARKIT` that a name stands for: without a side, those of both.

    Names of action units, such as ``AU12`` or ``AU12L``, stand for the shapes that they move.

    Raises
    ------
    MouthError : there is none of this name.
    """
    found = _columns_named(str(name))
    if not found:
        raise MouthError(f"ARKit has no blend shape {shown(name)}; name one such as mouthSmile or mouthSmileLeft")
    return found


@lru_cache(1024)
def _columns_named(name: str) -> list[int]:
    sides = (name, *both_sides(name))
    return [ARKIT.index(shape) for shape in (*sides, *shapes_moved_by([name])) if shape in ARKIT]
