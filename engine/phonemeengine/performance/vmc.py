"""Faces as messages of the VMC protocol that ``oscdump`` of liblo wrote into a file, a line a message.

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
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from phonemeengine.errors import CorpusError
from phonemeengine.mouth.face_mapping import is_unit
from phonemeengine.performance.face_track import FaceTrack, captured, shape_name, shapes_in
from phonemeengine.storage.files import printable_name, read_text_file

LARGEST = 64 << 20
"""Bytes of a file at most."""
MOST_FRAMES = 1 << 18
"""Of a file: more than an hour at 60 a second."""
TIME, VALUE, APPLY = "/VMC/Ext/T", "/VMC/Ext/Blend/Val", "/VMC/Ext/Blend/Apply"
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
    return parse_vmc(read_text_file(path, LARGEST, "a recording of VMC messages", CorpusError), printable_name(path))


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
        if address == TIME:
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
