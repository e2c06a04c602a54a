"""WAV files of 24 bits that are playable at any moment while they grow, and turn to RF64 beyond 4 GB.

libsndfile can do that too, but writes WAVE_FORMAT_EXTENSIBLE, which Python's `wave` before 3.12 refuses, and only
through a part of soundfile that is private.
"""

import struct
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import AudioError
from phonemeengine.storage.files import printable_name

# Places of a recording where sound is missing, since the microphone was away.

MOST_MARKED = 250
"""Gaps that a sound file marks at most: the room for them is set aside before the sound."""


@dataclass(frozen=True)
class Gap:
    """A place where sound is missing.

    Attributes
    ----------
    sample : the first sample after the gap, counted in the file.
    seconds : how long the gap is.
    n_silent : samples of silence that stand for it.
    """

    sample: int
    seconds: float
    n_silent: int = 0

    @property
    def label(self) -> str:
        """What is written at its place."""
        return f"gap of {self.seconds:.2f} s"


def gaps_in_words(gaps: Sequence[Gap], seconds: float, rate: int) -> str:
    """Return how long the gaps of a recording of some seconds were, and what stands for them; nothing without any."""
    if not gaps:
        return ""
    lasted = f"{sum(gap.seconds for gap in gaps):.2f} s"
    several = f"{len(gaps)} gaps of {lasted} in all" if len(gaps) > 1 else f"1 gap of {lasted}"
    only = f" (the first {MOST_MARKED} of them)" if len(gaps) > MOST_MARKED else ""
    silent = sum(gap.n_silent for gap in gaps) / rate
    filled = f": {seconds - silent:.2f} s of sound, {silent:.2f} s of silence" if silent else ""
    return f"with {several} marked in it{only}{filled}"


# Sound as whole numbers of 24 bits, and bytes on their way to the disk.

FULL_SCALE = 1 << 23
"""The whole number that stands for 1.0; the largest that fits is one less."""


def to_integers(block: Float32Array) -> NDArray[np.int32]:
    """Return samples of 24 bits, so that k / 2**23 becomes exactly k; beyond ±1 is ±1, and NaN is silence.

    libsndfile's own conversion multiplies by 2**23 - 1 and would change every sample of a 16-bit sound card.
    """
    scaled = np.rint(np.nan_to_num(block, nan=0.0, posinf=1.0, neginf=-1.0) * np.float32(FULL_SCALE))
    return np.asarray(np.clip(scaled, -FULL_SCALE, FULL_SCALE - 1), np.int32)


def to_int24_bytes(numbers: NDArray[np.int32]) -> bytes:
    """Return whole numbers as three bytes each, the smallest first."""
    return numbers.astype("<i4").view(np.uint8).reshape(-1, 4)[:, :3].tobytes()


def write_all(file: BinaryIO, content: bytes) -> None:
    """Write all of it to an unbuffered file, which may take it in parts.

    Raises
    ------
    OSError : the disk refuses; a part may have been written.
    """
    rest = memoryview(content)
    while rest:
        rest = rest[file.write(rest) or 0 :]


WIDTH = 3
"""Bytes of a sample."""

HEADER = 1 << 14
"""Bytes before the samples; `MOST_MARKED` gaps find room there."""

MOST_IN_RIFF = 0xFFFF_FFFF
"""The largest size that RIFF can state; in RF64 it says that the size stands in ``ds64`` (EBU Tech 3306).
A cue point cannot lie beyond this many samples."""


ENDINGS = frozenset({".wav", ".wave", ""})


def check_wav_name(path: Path) -> None:
    """Refuse a name whose ending promises another format.

    Raises
    ------
    AudioError : it does.
    """
    if path.suffix.lower() not in ENDINGS and any(map(str.isalpha, path.suffix)):
        raise AudioError(
            f"{printable_name(path)}: sounds are written as .wav here, not as {path.suffix}; let the name end in .wav"
        )


class WavEncoder:
    """Writes WAV; after every block the header is true.

    Parameters
    ----------
    file : a new, empty, unbuffered file, which stays open.
    rate : Hz.
    n_channels : channels of each block.

    Attributes
    ----------
    n_samples : samples per channel that a reader of the file finds now.
    """

    def __init__(self, file: BinaryIO, rate: int, n_channels: int) -> None:
        self.n_samples = 0
        self._file = file
        self._rate = rate
        self._n_channels = n_channels
        self._frame = WIDTH * n_channels
        self._gaps: list[Gap] = []
        self._state_length(0)

    def write(self, block: Float32Array) -> None:
        """Append a block, shape (n, n_channels), ±1.

        Raises
        ------
        OSError : the disk refuses; as much of the block as fits is in the file.
        """
        begin = self._file.seek(self._end)
        try:
            write_all(self._file, to_int24_bytes(to_integers(block)))
        finally:
            n_samples = self.n_samples + (self._file.tell() - begin) // self._frame
            self._state_length(n_samples)
            self.n_samples = n_samples

    def mark(self, seconds: float) -> None:
        """Mark that this many seconds are missing after what was written, as a cue point with a label.

        Raises
        ------
        OSError : the disk refuses.
        """
        self._gaps.append(Gap(self.n_samples, seconds))
        self._state_length(self.n_samples)

    def close(self) -> None:
        """Cut off what is no whole frame, and end at an even byte, as RIFF wants it; may be called twice.

        Raises
        ------
        OSError : the disk refuses.
        """
        self._file.truncate(self._end)
        self._file.seek(self._end)
        with suppress(OSError):  # every reader does without it
            write_all(self._file, b"\0" * (self._end % 2))
        self._state_length(self.n_samples)

    @property
    def _end(self) -> int:
        return HEADER + self.n_samples * self._frame

    def _state_length(self, n_samples: int) -> None:
        self._file.seek(0)
        write_all(self._file, wav_header(self._rate, self._n_channels, n_samples, self._gaps))


def wav_header(rate: int, n_channels: int, n_samples: int, gaps: Sequence[Gap] = ()) -> bytes:
    """Return the bytes before the samples, RIFF if its size field can hold the length, else RF64; with cue points."""
    frame = WIDTH * n_channels
    n_bytes = n_samples * frame
    whole = HEADER - 8 + n_bytes + n_bytes % 2
    sizes = struct.pack("<QQQI", whole, n_bytes, n_samples, 0)
    big = whole > MOST_IN_RIFF
    head = b"".join(
        (
            struct.pack("<4sI4s", b"RF64" if big else b"RIFF", min(whole, MOST_IN_RIFF), b"WAVE"),
            struct.pack("<4sI28s", b"ds64" if big else b"JUNK", len(sizes), sizes if big else b""),
            struct.pack("<4sIHHIIHH", b"fmt ", 16, 1, n_channels, rate, rate * frame, frame, 8 * WIDTH),
            _cue_points([gap for gap in gaps[:MOST_MARKED] if gap.sample <= MOST_IN_RIFF]),
        )
    )
    data = struct.pack("<4sI", b"data", MOST_IN_RIFF if big else n_bytes)
    n_filling = HEADER - len(head) - 8 - len(data)
    return head + _chunk(b"JUNK", bytes(n_filling)) + data


def _cue_points(gaps: Sequence[Gap]) -> bytes:
    """Return the chunks that mark gaps and label them; nothing where there are none."""
    if not gaps:
        return b""
    points = [struct.pack("<II4sIII", k + 1, x.sample, b"data", 0, 0, x.sample) for k, x in enumerate(gaps)]
    labels = [_chunk(b"labl", struct.pack("<I", k + 1) + x.label.encode() + b"\0") for k, x in enumerate(gaps)]
    listed = b"adtl" + b"".join(labels)
    return _chunk(b"cue ", struct.pack("<I", len(points)) + b"".join(points)) + _chunk(b"LIST", listed)


def _chunk(name: bytes, content: bytes) -> bytes:
    """Return a chunk, filled up to an even number of bytes."""
    return struct.pack("<4sI", name, len(content)) + content + bytes(len(content) % 2)
