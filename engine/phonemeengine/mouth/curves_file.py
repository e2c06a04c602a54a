"""Curves JSON, read back: what another program, or this one, does with the file that `exports.curves` writes."""

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError
from phonemeengine.mouth.cues import Cue
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.files import MEGABYTE
from phonemeengine.storage.strict_table import StrictTable, load_text, shown

FORMAT = "phonemeanalyser curves 1"
HEAD = ("yaw", "pitch", "roll")
"""The angles of the head, degrees."""
LARGEST = 256 * MEGABYTE
LONGEST = 1e6
"""Seconds that a cue may be away from the beginning, and frames a second at most."""
_CUE: dict[str, type] = {
    "start": float,
    "end": float,
    "phoneme": Phoneme,
    "shape": str,
    "intensity": float,
    "phone": str,
}
_WORD: dict[str, type] = {"start": float, "end": float, "word": str}
_TOP = ("sound", "duration", "rate", "table", "cues", "curves", "head")


@dataclass(frozen=True, eq=False)
class ExportedCurves:
    """What a file of curves holds.

    Attributes
    ----------
    sound : the sound's file name.
    duration : of the sound, seconds.
    rate : frames per second; frame k shows the time k / rate.
    table : the name of the mouth table.
    cues : which shape from when to when.
    words : start and end, seconds, and text of each word, where they are known.
    movestates : the names of those that move.
    weights : float32, shape (n_frames, n_movestates), 1 for the whole movement.
    head : float32, shape (n_frames, 3): yaw, pitch and roll, degrees; zeros where the head does not move.
    """

    sound: str
    duration: float
    rate: float
    table: str
    cues: tuple[Cue, ...]
    words: tuple[tuple[float, float, str], ...]
    movestates: tuple[str, ...]
    weights: Float32Array
    head: Float32Array


def read_curves(path: str | os.PathLike[str]) -> ExportedCurves:
    """Read a file of curves JSON; see `parse_curves`.

    Raises
    ------
    MouthError : it cannot be read, or says something impossible; the message begins with the file's name.
    """
    return load_text(path, "a file of curves (.curves.json)", MouthError, parse_curves, LARGEST)


def parse_curves(text: str) -> ExportedCurves:
    """Read the text of a file of curves.

    Raises
    ------
    MouthError : it is no JSON or not of this format, an entry is missing or unknown, or a number is out of range.
    """
    top = _top_of(text)
    rate = top.limited("rate", 1 / LONGEST, LONGEST, "a number of frames a second above 0")
    duration = top.limited("duration", 0, LONGEST, f"a number of seconds in 0..{LONGEST:g}")
    movestates, weights = _columns_of(top, "curves")
    head = _head_of(top, len(weights) if movestates else None)
    if not movestates:
        weights = np.zeros((len(head), 0), np.float32)
    cues = tuple(_cue_of(table) for table in top.tables("cues"))
    if early := [cue for before, cue in pairwise(cues) if cue.start < before.end]:
        raise MouthError(f"a cue begins at {early[0].start:g} s, before the last one ends; export the curves again")
    words = tuple(_word_of(table) for table in top.tables("words"))
    return ExportedCurves(
        top.value("sound", str), duration, rate, top.value("table", str), cues, words, movestates, weights, head
    )


def _top_of(text: str) -> StrictTable:
    try:
        document = json.loads(text)
    except (ValueError, RecursionError) as cause:
        raise MouthError(f"this is no JSON ({cause!s:.80}); export the curves again") from cause
    form = document.get("format") if isinstance(document, dict) else None
    if form != FORMAT:
        raise MouthError(f"a file of curves has the format {FORMAT!r}, found {shown(form)}; choose another file")
    entries = {key: value for key, value in document.items() if key != "format"}
    top = StrictTable(entries, "a file of curves", MouthError)
    top.check_keys(_TOP, optional=("words",))
    return top


def _head_of(top: StrictTable, n_frames: int | None) -> Float32Array:
    """Return the head's angles, shape (n_frames, 3); as many as there are, where no number of frames is known."""
    names, columns = _columns_of(top, "head")
    if strange := [name for name in names if name not in HEAD]:
        raise MouthError(f"head knows no angle {shown(strange[0])}; export the curves again")
    if names and n_frames not in {None, len(columns)}:
        raise MouthError(f"head has {len(columns)} values and curves {n_frames}; export the curves again")
    head = np.zeros((len(columns) if n_frames is None else n_frames, len(HEAD)), np.float32)
    for name, column in zip(names, columns.T, strict=True):
        head[:, HEAD.index(name)] = column
    return head


def _columns_of(top: StrictTable, key: str) -> tuple[tuple[str, ...], Float32Array]:
    """Return the names of some curves, and their values, shape (n_frames, n_curves)."""
    tables = top.tables(key)
    for table in tables:
        table.check_keys(("name", "values"))
    names = tuple(table.value("name", str) for table in tables)
    columns = [table.numbers("values") for table in tables]
    _check_columns(names, columns, key)
    return names, np.array(columns, np.float32).reshape(len(columns), len(columns[0]) if columns else 0).T


def _check_columns(names: Sequence[str], columns: Sequence[Sequence[float]], key: str) -> None:
    if twice := [name for name in names if names.count(name) > 1]:
        raise MouthError(f"{key} names {shown(twice[0])} twice; export the curves again")
    for name, column in zip(names, columns, strict=True):
        if len(column) != len(columns[0]):
            raise MouthError(
                f"{key} has {len(columns[0])} values of {names[0]!r:.60} and {len(column)} of {name!r:.60}; "
                "export the curves again"
            )


def _word_of(table: StrictTable) -> tuple[float, float, str]:
    start, end, word = table.read(_WORD).values()
    if not 0 <= start <= end <= LONGEST:
        raise MouthError(
            f"a word begins before it ends, within {LONGEST:g} s, found {start:g}..{end:g} s; export the curves again"
        )
    return start, end, word


def _cue_of(table: StrictTable) -> Cue:
    cue = Cue(**table.read(_CUE, optional=("phone",)))
    if not (0 <= cue.start <= cue.end <= LONGEST and 0 <= cue.intensity <= 1):
        raise MouthError(
            f"a cue begins before it ends, within {LONGEST:g} s, and its intensity lies in 0..1, found "
            f"{cue.start:g}..{cue.end:g} s, {cue.intensity:g}; export the curves again"
        )
    return cue
