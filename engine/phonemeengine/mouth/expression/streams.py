"""What a face expresses over time, from presets, sliders or recordings, and what each of its channels belongs to."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from pathlib import Path
from typing import Protocol

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import MouthError, remedy
from phonemeengine.mouth.blendshape_names import ARKIT, both_sides
from phonemeengine.mouth.face_mapping import shapes_moved_by
from phonemeengine.storage.strict_table import load_text, parse_toml, shown

CHANNELS_FORMAT = "phonemeanalyser expression channels 1"
SHIPPED_CHANNELS = Path(__file__).resolve().parent / "channels.toml"


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
    return load_channels(SHIPPED_CHANNELS)


def load_channels(path: str | os.PathLike[str]) -> ExpressionChannels:
    """Read the classes of the 52 blend shapes of ARKit from a TOML file; see ``channels.toml`` for an example.

    Raises
    ------
    MouthError : the file cannot be read, or does not put each of them into one class.
    """
    return load_text(path, "expression channels (.toml)", MouthError, _channels_in)


def _channels_in(text: str) -> ExpressionChannels:
    top = parse_toml(text, "a file of expression channels", CHANNELS_FORMAT, MouthError)
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
    found = _columns_of_names(str(name))
    if not found:
        raise MouthError(f"ARKit has no blend shape {shown(name)}; name one such as mouthSmile or mouthSmileLeft")
    return found


@lru_cache(1024)
def _columns_of_names(name: str) -> list[int]:
    sides = (name, *both_sides(name))
    return [ARKIT.index(shape) for shape in (*sides, *shapes_moved_by([name])) if shape in ARKIT]


FORMAT = "phonemeanalyser expressions 1"
SHIPPED = Path(__file__).resolve().parent / "presets.toml"


class ExpressionStream(Protocol):
    """Weights of the 52 blend shapes of `ARKIT` over time: whatever it is made by."""

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, seconds, float32, shape (52,), 0..1."""


@dataclass(frozen=True, eq=False)
class HeldExpression:
    """An expression that stays.

    Attributes
    ----------
    held : float32, shape (52,), 0..1.
    """

    held: Float32Array

    def weights(self, _time: float) -> Float32Array:
        """Return the weights, the same at any time."""
        return self.held


@dataclass(frozen=True, eq=False)
class RecordedExpression:
    """An expression that was recorded; before and after, its first and its last frame stay.

    Attributes
    ----------
    times : of the frames, seconds, rising, shape (n_frames,); at least one.
    frames : float32, shape (n_frames, 52), 0..1.
    """

    times: Float64Array
    frames: Float32Array

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, on the straight line between two frames."""
        after = int(np.searchsorted(self.times, time))
        if after == 0 or after == len(self.times):
            frame: Float32Array = self.frames[min(after, len(self.times) - 1)]
            return frame
        share = np.float32((time - self.times[after - 1]) / (self.times[after] - self.times[after - 1]))
        between: Float32Array = (1 - share) * self.frames[after - 1] + share * self.frames[after]
        return between


def recorded_expression(times: Float64Array, channels: Sequence[str], weights: Float32Array) -> ExpressionStream:
    """Return a recording of some channels as an expression; what is no blend shape of `ARKIT` is left out.

    Parameters
    ----------
    times : of the frames, seconds, rising, shape (n_frames,).
    channels : the names of the columns.
    weights : shape (n_frames, n_channels), 0..1.
    """
    frames = np.zeros((len(times), len(ARKIT)), np.float32)
    for column, name in enumerate(channels):
        if name in ARKIT:
            frames[:, ARKIT.index(name)] = np.clip(weights[:, column], 0, 1)
    return RecordedExpression(times, frames)


def held_expression(shares: Mapping[str, float]) -> ExpressionStream:
    """Return an expression that stays.

    Parameters
    ----------
    shares : how far, 0..1, of presets such as ``smile`` and of blend shapes such as ``browInnerUp``; they add up, to
        1 at most.

    Raises
    ------
    MouthError : there is no such preset or blend shape, or a share is out of range.
    """
    held = np.zeros(len(ARKIT), np.float32)
    known = expression_presets()
    for name, share in shares.items():
        if not 0 <= share <= 1:
            raise MouthError(f"an expression is shown by 0..1, found {share:g} for {name}; correct it")
        if name in known:
            held += np.float32(share) * known[name]
        else:
            held[_columns_named(name, known)] += np.float32(share)
    return HeldExpression(np.minimum(held, np.float32(1)))


@cache
def expression_presets() -> Mapping[str, Float32Array]:
    """Return the expressions that ship with the program by name, each float32, shape (52,), 0..1."""
    return load_expressions(SHIPPED)


def load_expressions(path: str | os.PathLike[str]) -> Mapping[str, Float32Array]:
    """Read expressions from a TOML file: names with percentages of blend shapes; see ``presets.toml``.

    Raises
    ------
    MouthError : the file cannot be read, or says something impossible; the message names the file.
    """
    return load_text(path, "expressions (.toml)", MouthError, _expressions_in)


def _expressions_in(text: str) -> Mapping[str, Float32Array]:
    top = parse_toml(text, "a file of expressions", FORMAT, MouthError)
    top.check_keys(("expressions",), ("notes",))
    found = {}
    for name, shape in top.table("expressions").tables_by_name():
        weights = np.zeros(len(ARKIT), np.float32)
        for channel in shape.entries:
            weights[columns_of(channel)] = shape.limited(channel, 0, 100, "percent, 0..100") / 100
        found[name] = weights
    return found


def _columns_named(name: str, known: Mapping[str, Float32Array]) -> list[int]:
    try:
        return columns_of(name)
    except MouthError:
        raise MouthError(
            f"there is no expression {name[:40]!r}; "
            + remedy(name, known, "choose one of {}, or a shape such as mouthSmile")
        ) from None
