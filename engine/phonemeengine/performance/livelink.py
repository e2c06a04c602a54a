"""Faces as Live Link Face records them: CSV with a time code, 52 blend shapes of ARKit and nine angles a row.

Times come from the time code, HH:MM:SS:FF.mmm, not from row numbers: a frame that the telephone dropped is missing.
The file does not say at how many frames a second its time code counts; the numbers that it reaches do.
"""

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import CorpusError
from phonemeengine.mouth.blendshape_names import LIVE_LINK_ANGLES, LIVE_LINK_COLUMNS
from phonemeengine.performance.face_track import FaceTrack, captured, shape_name
from phonemeengine.storage.files import printable_name, read_text_file

LARGEST = 32 << 20
"""Bytes of a file at most: more than half an hour."""
RATES = (24, 25, 30, 48, 50, 60, 100, 120, 240)
"""Frames a second at which time codes count."""
USUAL_RATE = 60
DAY = 86_400
CHANNELS = tuple(name[0].lower() + name[1:] for name in LIVE_LINK_COLUMNS[2:])
"""The channels of a recording: blend shapes as ARKit has them, and angles in degrees such as ``headYaw``."""
_TIMECODE = re.compile(r"(\d\d?):(\d\d):(\d\d)[:;](\d{1,3}(?:\.\d{1,6})?)", re.ASCII)
_ANGLES = {name.lower(): name[0].lower() + name[1:] for name in LIVE_LINK_ANGLES}


def read_livelink(path: Path) -> FaceTrack:
    """Read a recording of Live Link Face; see `parse_livelink`.

    Raises
    ------
    CorpusError : it cannot be read, or says something impossible.
    """
    return parse_livelink(read_text_file(path, LARGEST, "a recording of a face", CorpusError), printable_name(path))


def parse_livelink(text: str, file: str) -> FaceTrack:
    """Read the text of a recording of Live Link Face; `file` is what it is called in a refusal.

    Returns
    -------
    The track, its channels in the order of `CHANNELS`; angles in degrees.

    Raises
    ------
    CorpusError : a column is missing or unknown, a time code or a number is none, or the times have gaps.
    """
    header, *rows = [line for line in text.split("\n") if line.strip()] or [""]
    columns = _columns_of(header, file)
    if not rows:
        raise CorpusError(f"{file}: there is no frame under the header; record it again")
    numbers = numbers_of(rows, len(columns) + 2, range(2, len(columns) + 2), file)
    weights = numbers[:, [columns.index(name) for name in CHANNELS]]
    angles = [k for k, name in enumerate(CHANNELS) if name.lower() in _ANGLES]
    weights[:, angles] = np.degrees(weights[:, angles])
    return captured(_times_of(rows, file), CHANNELS, weights, file)


def _columns_of(header: str, file: str) -> list[str]:
    """Return the channels in the order in which a header names them."""
    cells = [cell.strip() for cell in header.split(",")]
    if [cell.lower() for cell in cells[:2]] != [name.lower() for name in LIVE_LINK_COLUMNS[:2]]:
        raise CorpusError(
            f"{file}: this is no recording of Live Link Face, whose header begins with "
            f"{','.join(LIVE_LINK_COLUMNS[:2])}; choose another file"
        )
    names = [shape_name(cell) or _ANGLES.get(cell.lower(), cell) for cell in cells[2:]]
    missing, others = (
        [name for name in CHANNELS if name not in names],
        [name for name in names if name not in CHANNELS],
    )
    if missing or others or len(names) != len(CHANNELS):
        fault = f"lacks {missing[0]}" if missing else f"has {(others or ['one twice'])[0][:40]!r}"
        raise CorpusError(
            f"{file}: a recording has the {len(CHANNELS)} channels of Live Link Face, and this {fault}; "
            "record it with ARKit, and with all channels"
        )
    return names


def numbers_of(rows: Sequence[str], n_columns: int, places: Sequence[int], file: str) -> Float32Array:
    """Return the numbers in some columns of lines, float32, shape (n_rows, n_places).

    Raises
    ------
    CorpusError : a line has more or fewer columns, or no number where one must be.
    """
    for k, row in enumerate(rows):
        if row.count(",") + 1 != n_columns:
            raise CorpusError(
                f"{file}, line {k + 2}: a row has {n_columns} cells, found {row.count(',') + 1}; the file is cut off "
                "or damaged, so export it again"
            )
    try:
        cells = np.loadtxt(rows, np.float32, delimiter=",", usecols=places, comments=None)
    except (ValueError, IndexError) as error:
        raise CorpusError(f"{file}: there must be a number in each cell ({error!s:.80}); export it again") from error
    return cells.reshape(-1, len(places))


def _times_of(rows: Sequence[str], file: str) -> Float64Array:
    codes = [_timecode_of(row.split(",", 1)[0], k + 2, file) for k, row in enumerate(rows)]
    seconds, frames = (np.array(part, float) for part in zip(*codes, strict=True))
    times = seconds + frames / _rate_of(seconds, frames, file)
    midnights = np.cumsum(np.diff(times, prepend=times[:1]) < -DAY / 2)
    return times + DAY * midnights


def _timecode_of(cell: str, line: int, file: str) -> tuple[int, float]:
    """Return a time code's whole seconds, and its frames within the second."""
    found = _TIMECODE.fullmatch(cell.strip())
    if found is None:
        raise CorpusError(
            f"{file}, line {line}: a time code is like 12:27:47:31.169, found {cell.strip()[:20]!r}; export it again"
        )
    hours, minutes, seconds = (int(group) for group in found.groups()[:3])
    return 3600 * hours + 60 * minutes + seconds, float(found[4])


def _rate_of(seconds: Float64Array, frames: Float64Array, file: str) -> int:
    """Return at how many frames a second a time code counts: the lowest usual rate that its numbers stay below."""
    most = int(frames.max())
    rate = next((rate for rate in RATES if most < rate), None)
    if rate is None:
        raise CorpusError(
            f"{file}: a time code counts up to {RATES[-1]} frames a second, found {most}; export it again"
        )
    # Within less than a second it cannot be decided: the numbers may not have reached the end of one.
    return max(rate, USUAL_RATE) if np.ptp(seconds) < 2 else rate
