"""What each channel of a face belongs to: the speech, the expression, or both by a share."""

import os
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError
from phonemeengine.files import printable_name, read_text_file
from phonemeengine.mouth.blendshape_names import ARKIT, both_sides
from phonemeengine.strict_table import StrictTable, parse_toml, shown

FORMAT = "phonemeanalyser expression channels 1"
SHIPPED = Path(__file__).resolve().parent / "channels.toml"
LARGEST_FILE = 1 << 20


@dataclass(frozen=True, eq=False)
class ExpressionChannels:
    """The channels on which speech and expressions meet.

    Attributes
    ----------
    names : the movestates, in the order of all weights.
    speech : the class weight of speech cS of each, 0..1, float32, shape (n_channels,); that of expressions is 1 - cS.
    reductions : how much of an expression goes while somebody speaks, 0..1, shape (n_channels,).
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
    path = Path(path)
    text = read_text_file(path, LARGEST_FILE, "expression channels (.toml)", MouthError)
    try:
        return _channels_in(parse_toml(text, "a file of expression channels", FORMAT, MouthError))
    except MouthError as error:
        raise MouthError(f"{printable_name(path)}: {error}") from error


def _channels_in(top: StrictTable) -> ExpressionChannels:
    top.check_keys(("classes",), ("notes",))
    classes = top.table("classes")
    speech, reductions = np.full(len(ARKIT), np.nan, np.float32), np.zeros(len(ARKIT), np.float32)
    for name in classes.entries:
        entry = classes.table(name)
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

    Raises
    ------
    MouthError : there is none of this name.
    """
    found = [ARKIT.index(side) for side in (str(name), *both_sides(str(name))) if side in ARKIT]
    if not found:
        raise MouthError(f"ARKit has no blend shape {shown(name)}; name one such as mouthSmile or mouthSmileLeft")
    return found
