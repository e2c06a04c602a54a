"""Recorded faces as CSV: of Live Link Face, or action units as OpenFace writes them.

OpenFace has a row a frame: ``timestamp`` (seconds), ``success`` (1 where a face was found), turns of the head in
radians (``pose_Rx``, ``pose_Ry``, ``pose_Rz``) and the intensity of action units, 0..5 (``AU12_r``). Its camera looks
along z, and y points downwards. Other columns are passed over.
"""

import os
from pathlib import Path

import numpy as np

from phonemeengine.errors import CorpusError
from phonemeengine.mouth.blendshape_names import OPENFACE_POSE, STRONGEST_UNIT
from phonemeengine.mouth.exports.openface import head_turns
from phonemeengine.mouth.expression.streams import ExpressionStream, recorded_expression
from phonemeengine.mouth.face_mapping import shapes_moved_by
from phonemeengine.performance.face_track import FaceTrack, captured, numbers_of, parse_livelink
from phonemeengine.performance.recording import HEAD
from phonemeengine.storage.files import printable, printable_name, read_text_file

LARGEST = 128 << 20
"""Bytes of a file at most: OpenFace writes all landmarks, too."""
TIME, FOUND, INTENSITY = "timestamp", "success", "_r"


def read_face_csv(path: Path) -> FaceTrack:
    """Read a recording of Live Link Face or of OpenFace, whichever its header says.

    Raises
    ------
    CorpusError : it cannot be read, or says something impossible.
    """
    text, file = read_text_file(path, LARGEST, "a recording of a face", CorpusError), printable_name(path)
    header = [cell.strip() for cell in text.partition("\n")[0].split(",")]
    return parse_openface(text, file) if TIME in header else parse_livelink(text, file)


def read_expression(path: str | os.PathLike[str]) -> ExpressionStream:
    """Return a recording of Live Link Face or OpenFace as an expression, with the times of its frames from 0 on.

    Raises
    ------
    CorpusError : it cannot be read, or says something impossible.
    """
    face = read_face_csv(Path(path))
    return recorded_expression(face.times, face.channels, face.weights)


def parse_openface(text: str, file: str) -> FaceTrack:
    """Read the text of a recording of OpenFace; `file` is what it is called in a refusal.

    Returns
    -------
    The track: blend shapes of ARKit, both sides of a unit alike, and turns of the head in degrees, if there are any.

    Raises
    ------
    CorpusError : there is no action unit in it or no face, a number is none, or the times have gaps.
    """
    header, *rows = [line for line in text.split("\n") if line.strip()] or [""]
    columns = [cell.strip() for cell in header.split(",")]
    units = {name.removesuffix(INTENSITY): k for k, name in enumerate(columns) if name.endswith(INTENSITY)}
    shapes = shapes_moved_by([*units])
    if TIME not in columns or not shapes:
        raise CorpusError(
            f"{file}: a recording of OpenFace has the column {TIME} and action units such as AU12_r, and this lacks "
            "them; record it again with -aus"
        )
    turned = [name for name in OPENFACE_POSE if name in columns]
    wanted = [TIME, *([FOUND] if FOUND in columns else []), *turned]
    places = [*map(columns.index, wanted), *units.values()]
    numbers = numbers_of(rows, len(columns), places, file).astype(np.float64) if rows else np.zeros((0, len(places)))
    if not np.isfinite(numbers).all():
        raise CorpusError(f"{file}: all its numbers must be finite, and one is none; record it again")
    if FOUND in columns:
        numbers = numbers[numbers[:, 1] != 0]
    if not len(numbers):
        raise CorpusError(f"{file}: there is no frame with a face in it; record it again")
    moved = numbers[:, len(wanted) :] / STRONGEST_UNIT
    weights = [moved[:, list(some)].mean(axis=1) for some in shapes.values()]
    channels = [*shapes]
    if len(turned) == len(OPENFACE_POSE):
        channels += HEAD
        weights += [*head_turns(numbers[:, len(wanted) - len(turned) : len(wanted)]).T]
    track = captured(numbers[:, 0], channels, np.stack(weights, axis=1).astype(np.float32), file)
    used = {k for some in shapes.values() for k in some}
    return _with_note(track, [name for k, name in enumerate(units) if k not in used])


def _with_note(track: FaceTrack, unknown: list[str]) -> FaceTrack:
    if not unknown:
        return track
    names = ", ".join(printable(name[:20]) for name in unknown[:8])
    note = f"no blend shape of ARKit is moved by {names}, which is left out"
    return FaceTrack(track.times, track.channels, track.weights, (*track.notes, note))
