"""Faces as captured: frames at times of their own, some missing, in files of Live Link Face and of the VMC protocol.

Times come from the time code, HH:MM:SS:FF.mmm, not from row numbers: a frame that the telephone dropped is missing.
The file does not say at how many frames a second its time code counts; the numbers that it reaches do.

``oscdump 39539 > NAME.osc`` records what a program sends to port 39539. A line has the time of the packet, as NTP has
it in hexadecimal numbers, the address, the types of the arguments, and the arguments::

    e9f3c5a1.7ae147ae /VMC/Ext/T f 12.500000
    e9f3c5a1.7ae147ae /VMC/Ext/Blend/Val sf "jawOpen" 0.420000
    e9f3c5a1.7ae147ae /VMC/Ext/Blend/Apply

A frame ends with ``/VMC/Ext/Blend/Apply``. Its time is that of ``/VMC/Ext/T``, which no network disturbs, where every
frame has one, else that of the packet. Other messages are passed over.
"""

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import CorpusError
from phonemeengine.mouth.blendshape_names import ARKIT, LIVE_LINK_ANGLES, LIVE_LINK_COLUMNS, SHOULDERS
from phonemeengine.mouth.face_mapping import is_unit, shapes_moved_by
from phonemeengine.storage.files import printable_name, read_text_file

LONGEST_GAP = 0.1
"""Seconds without a frame that are bridged."""
LARGEST_WEIGHT = 10.0
"""Beyond this a blend shape's weight is none: captures reach a little beyond 1."""
LONGEST = 3600.0
"""Seconds of a face's movement at most."""
_SHAPES = {name.lower(): name for name in (*ARKIT, *SHOULDERS)}


@dataclass(frozen=True, eq=False)
class FaceTrack:
    """A face's movement.

    Attributes
    ----------
    times : float64, shape (n_frames,): seconds since the face's beginning, increasing.
    channels : the names of the columns.
    weights : float32, shape (n_frames, n_channels), as in `Performance`.
    notes : what is odd about it, a sentence each.
    """

    times: Float64Array
    channels: tuple[str, ...]
    weights: Float32Array
    notes: tuple[str, ...] = ()

    @property
    def duration(self) -> float:
        """From the beginning to the last frame, seconds."""
        return float(self.times[-1])

    def sampled(self, times: Float64Array) -> Float32Array:
        """Return the weights at some times, between frames on straight lines, beyond them as at the nearest one."""
        columns = (np.interp(times, self.times, column) for column in self.weights.T)
        return np.stack([*columns], axis=1).astype(np.float32)


def captured(times: Float64Array, channels: Sequence[str], weights: Float32Array, file: str) -> FaceTrack:
    """Return frames as a camera gave them: repeated ones are left out, short gaps are bridged, and both are said.

    Parameters
    ----------
    times : seconds of any clock, not decreasing.
    file : what the file is called in a refusal.

    Raises
    ------
    CorpusError : there are fewer than two frames, times go back, a gap is too long, or a weight is none.
    """
    if (back := np.flatnonzero(np.diff(times) < 0)).size:
        raise CorpusError(
            f"{file}, frame {back[0] + 2}: the times of frames must not go back, found {times[back[0] + 1]:.3f} s "
            f"after {times[back[0]]:.3f} s; record it again, or leave it out"
        )
    kept = np.diff(times, prepend=-np.inf) > 0
    times, weights = times[kept] - times[0], weights[kept]
    check_weights(channels, weights, file)
    if len(times) < 2 or times[-1] > LONGEST:
        raise CorpusError(f"{file}: it needs two frames or more within an hour, found {len(times)}; record it again")
    notes = (*_repeated(int(np.sum(~kept))), *_bridged(times, file))
    return FaceTrack(times, tuple(channels), weights, notes)


def shapes_in(names: Sequence[str]) -> dict[str, tuple[int, ...]]:
    """Return the blend shapes that some names stand for, with the places of the names; a shape is the mean of these.

    Names of ARKit and of the shoulders count in any case, and action units such as ``AU12`` for shapes without.
    """
    own: dict[str, tuple[int, ...]] = {}
    for k, name in enumerate(names):
        if (shape := shape_name(name)) is not None:
            own.setdefault(shape, (k,))
    return own | {shape: units for shape, units in shapes_moved_by(names).items() if shape not in own}


def shape_name(name: str) -> str | None:
    """Return a blend shape of ARKit as it spells it, or a shift of the shoulders, in any case; None for others."""
    return _SHAPES.get(name.lower())


def check_weights(channels: Sequence[str], weights: Float32Array, file: str) -> None:
    """Refuse weights that no face has.

    Raises
    ------
    CorpusError : a number is not finite, or a blend shape's is far beyond 0..1.
    """
    shapes = [k for k, name in enumerate(channels) if name in _SHAPES.values()]
    fits = np.isfinite(weights).all(axis=1) & (np.abs(weights[:, shapes]) <= LARGEST_WEIGHT).all(axis=1)
    if not fits.all():
        raise CorpusError(
            f"{file}, frame {fits.argmin() + 1}: a blend shape's weight must lie in 0..1, and angles must be finite, "
            "found others; export it again"
        )


def _repeated(n: int) -> Iterator[str]:
    if n:
        yield f"{n} frames stand there twice; the first of each counts"


def _bridged(times: Float64Array, file: str) -> Iterator[str]:
    """Tell of frames that are missing; refuse a gap that is too long."""
    steps = np.diff(times)
    longest = int(steps.argmax())
    if steps[longest] > LONGEST_GAP:
        raise CorpusError(
            f"{file}: frames may be missing for {LONGEST_GAP:g} s at most, found {steps[longest]:.2f} s without one "
            f"after {times[longest]:.2f} s; record it again, or leave it out"
        )
    n_gaps = int(np.sum(steps > 1.5 * np.median(steps)))
    if n_gaps:
        yield f"frames are missing at {n_gaps} places, for {steps.max():.3f} s at most; they are bridged"


LARGEST_OF_LIVELINK = 32 << 20
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
    return parse_livelink(
        read_text_file(path, LARGEST_OF_LIVELINK, "a recording of a face", CorpusError), printable_name(path)
    )


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


LARGEST_OF_VMC = 64 << 20
"""Bytes of a file at most."""
MOST_FRAMES = 1 << 18
"""Of a file: more than an hour at 60 a second."""
TIME_ADDRESS, VALUE, APPLY = "/VMC/Ext/T", "/VMC/Ext/Blend/Val", "/VMC/Ext/Blend/Apply"
_LINE = re.compile(r"([0-9a-f]{8})\.([0-9a-f]{8}) (/\S*)(?: (\S*)(?: (.*))?)?", re.ASCII)
_VALUE = re.compile(r'"([^"]*)" (\S+)')


@dataclass(frozen=True)
class _Frame:
    """The blend shapes at a moment, by name; and its time by the packet and by the sender, seconds."""

    packet: float
    sender: float | None
    weights: dict[str, float]


def read_vmc(path: Path) -> FaceTrack:
    """Read what ``oscdump`` recorded; see `parse_vmc`.

    Raises
    ------
    CorpusError : it cannot be read, or says something impossible.
    """
    return parse_vmc(
        read_text_file(path, LARGEST_OF_VMC, "a recording of VMC messages", CorpusError), printable_name(path)
    )


def parse_vmc(text: str, file: str) -> FaceTrack:
    """Read the text of a recording of VMC messages; `file` is what it is called in a refusal.

    Blend shapes that are not sent anew stay as they are. ARKit's, the shoulders', and action units such as ``AU12``
    for shapes that are not sent count; others are passed over.

    Raises
    ------
    CorpusError : it is no such recording, it moves no blend shape of ARKit, or the times have gaps.
    """
    frames = [*_frames_of(text.split("\n"), file)]
    names = [*dict.fromkeys(name for frame in frames for name in frame.weights)]
    shapes = shapes_in(names)
    if not shapes:
        raise CorpusError(
            f"{file}: there is no blend shape of ARKit, such as jawOpen, in it, followed by {APPLY}; record VMC "
            "messages with oscdump, from a program that sends ARKit's names"
        )
    senders = [frame.sender for frame in frames if frame.sender is not None]
    times = senders if len(senders) == len(frames) else [frame.packet for frame in frames]
    sent = np.array([[frame.weights.get(name, 0.0) for name in names] for frame in frames], np.float32)
    weights = np.stack([sent[:, list(some)].mean(axis=1) for some in shapes.values()], axis=1)
    return captured(np.array(times, float), [*shapes], weights, file)


def _frames_of(lines: Iterable[str], file: str) -> Iterator[_Frame]:
    weights: dict[str, float] = {}
    sender: float | None = None
    n_frames = 0
    for number, line in enumerate(lines, 1):
        packet, address, arguments = _message_of(line, number, file)
        if address == TIME_ADDRESS:
            sender = _number_of(arguments, number, file)
        elif address == VALUE:
            weights |= _weight_of(arguments, number, file)
        elif address == APPLY:
            n_frames += 1
            if n_frames > MOST_FRAMES:
                raise CorpusError(f"{file}: a recording has at most {MOST_FRAMES} frames; cut it into sentences")
            yield _Frame(packet, sender, dict(weights))
            sender = None


def _message_of(line: str, number: int, file: str) -> tuple[float, str, str]:
    """Return a message's time, address and arguments; an empty address for an empty line."""
    if not line.strip():
        return 0.0, "", ""
    found = _LINE.fullmatch(line.rstrip())
    if found is None:
        raise CorpusError(
            f"{file}, line {number}: a message that oscdump wrote begins like 'e9f3c5a1.7ae147ae /VMC/Ext/T f', "
            f"found {line[:30]!r}; record it again with oscdump"
        )
    seconds, fraction, address, _types, arguments = found.groups()
    return int(seconds, 16) + int(fraction, 16) / 2**32, address, arguments or ""


def _weight_of(arguments: str, number: int, file: str) -> dict[str, float]:
    found = _VALUE.fullmatch(arguments)
    if found is None:
        raise CorpusError(
            f'{file}, line {number}: a blend shape is like "jawOpen" 0.42, found {arguments[:30]!r}; record it again'
        )
    name = _counted(found[1])
    return {name: _number_of(found[2], number, file)} if name else {}


@lru_cache(1024)
def _counted(name: str) -> str:
    """Return what a blend shape is called here, or an action unit; an empty text for others."""
    return shape_name(name) or (name if is_unit(name) else "")


def _number_of(word: str, number: int, file: str) -> float:
    try:
        value = float(word)
    except ValueError:
        value = math.nan
    if not abs(value) < 1e9:  # false for NaN
        raise CorpusError(f"{file}, line {number}: this must be a number, found {word[:20]!r}; record it again")
    return value
