"""Sound files of every kind, opened and decoded, and FLAC, encoded: the only module that imports soundfile."""

import io
import struct
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
import soundfile
from typing_extensions import override

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.wav import MOST_MARKED, Gap, to_integers, write_all
from phonemeengine.errors import AudioError
from phonemeengine.storage.files import is_folder, why_unreadable


def open_checked(path: Path, name: str) -> BinaryIO:
    """Open a file for reading, and speak of it as `name`.

    Raises
    ------
    AudioError : it is missing, a folder, a device, or not permitted.
    """
    try:
        if path.exists() and not path.is_file() and not is_folder(path):
            raise AudioError(f"{name}: this is a device, not an audio file; choose a file")
        file = path.open("rb")
    except (OSError, ValueError) as error:
        raise AudioError(f"{name}: {why_unreadable(path, error)}") from error
    return file


class FileSlice(io.RawIOBase):
    """A part of a file as a file of its own; it has no name whose ending could mislead libsndfile.

    Parameters
    ----------
    file : open for reading.
    end : where the part ends, bytes.
    corrections : bytes that stand in it instead of the file's, by their places in the part.
    begin : where the part begins, bytes.
    lead : bytes that are put in front of it.
    """

    def __init__(
        self,
        file: BinaryIO,
        end: int,
        corrections: Sequence[tuple[int, bytes]] = (),
        begin: int = 0,
        lead: bytes = b"",
    ) -> None:
        self._file = file
        self._begin, self._lead = begin, lead
        self._end = end - begin + len(lead)
        self._corrections = corrections
        self._at = 0

    @override
    def readable(self) -> bool:
        return True

    @override
    def seekable(self) -> bool:
        return True

    @override
    def tell(self) -> int:
        return self._at

    @override
    def seek(self, offset: int, whence: int = io.SEEK_SET) -> int:
        """Go to a place, which may lie beyond the end."""
        base = {io.SEEK_SET: 0, io.SEEK_CUR: self._at, io.SEEK_END: self._end}[whence]
        self._at = max(0, base + offset)
        return self._at

    @override
    def readinto(self, buffer: Any) -> int:
        view = memoryview(buffer).cast("B")[: max(0, self._end - self._at)]
        if not len(view):  # the place may be one that no file has
            return 0
        lead = self._lead[self._at : self._at + len(view)]
        view[: len(lead)] = lead
        self._file.seek(self._begin + max(0, self._at - len(self._lead)))
        n = len(lead) + int(self._file.readinto(view[len(lead) :]))  # type: ignore[attr-defined]
        for place, content in self._corrections:
            for k in range(max(place, self._at), min(place + len(content), self._at + n)):
                view[k - self._at] = content[k - place]
        self._at += n
        return n


# Gaps as chapters in the tags of a FLAC file (RFC 9639, section 8.6), which players show.
#
# The names are those of Xiph's chapter extension: ``CHAPTER001=00:00:07.100`` and ``CHAPTER001NAME=...``.

ROOM = 1 << 14
"""Bytes of the tags, with what fills them up, so that they can be written anew while the sound after them grows."""

TAGS_AT = 42
"""Where the tags begin: after the magic word and STREAMINFO."""

TAGS, PADDING, LAST = 4, 1, 0x80
"""Types of metadata blocks, and the flag of the last one."""


def is_tags(block: bytes) -> bool:
    """Return whether bytes are a metadata block of tags."""
    return len(block) >= 8 and block[0] & ~LAST == TAGS


def with_chapters(tags: bytes, gaps: Sequence[Gap], rate: int) -> bytes:
    """Return a last metadata block of tags without comments anew, with chapters and filled up to `ROOM` bytes."""
    (n_vendor,) = struct.unpack_from("<I", tags, 4)
    comments = [comment for k, gap in enumerate(gaps[:MOST_MARKED]) for comment in _comments(k + 1, gap, rate)]
    content = tags[4 : 8 + n_vendor] + struct.pack("<I", len(comments))
    content += b"".join(struct.pack("<I", len(comment)) + comment for comment in comments)
    block = struct.pack(">I", TAGS << 24 | len(content)) + content
    n_filling = ROOM - len(block) - 4
    return block + struct.pack(">I", (LAST | PADDING) << 24 | n_filling) + bytes(n_filling)


def _comments(number: int, gap: Gap, rate: int) -> tuple[bytes, bytes]:
    minutes, milliseconds = divmod(round(1000 * gap.sample / rate), 60_000)
    place = f"{minutes // 60:02}:{minutes % 60:02}:{milliseconds / 1000:06.3f}"
    return f"CHAPTER{number:03}={place}".encode(), f"CHAPTER{number:03}NAME={gap.label}".encode()


DecodingError = soundfile.SoundFileError
"""What a `FileDecoder` raises where a file is damaged, or is no sound."""

LOWEST_FLAC_RATE, HIGHEST_FLAC_RATE = 4_000, 655_350
"""Rates at which FLAC is written, Hz: the format's own limit, and one below which a block would last too long."""

MOST_FLAC_CHANNELS = 8
"""Channels that FLAC can hold."""

SHORT_BLOCKS_BELOW = 16_000
"""Rate below which FLAC is written in blocks of 1152 rather than 4096 samples, so that none waits for long, Hz."""

SYNC = b"\xff\xf8"
"""What a FLAC frame begins with if all blocks are equally long."""

BLOCK_SIZE_AT, LENGTH_AT = 8, 21
"""Where STREAMINFO keeps the block size (2 bytes) and the 36 bits of the length (5 bytes), in a FLAC file."""


class _NonSeekingFile(soundfile.SoundFile):  # type: ignore[misc]
    """A sound file in which soundfile does not seek by itself before and after everything."""

    @override
    def seekable(self) -> bool:
        return False


class FileDecoder(_NonSeekingFile):
    """A sound file whose `read` only reads.

    soundfile seeks after every reading of a seekable file, and a seek makes an MP3 decoder forget the bits that
    its next frame borrows: the sound would be wrong after every block.
    """


class FlacEncoder:
    """Writes FLAC of 24 bits; after every block the header states the length of the whole frames that are there.

    Parameters
    ----------
    file : a new, empty file, which stays open; unbuffered where others read it meanwhile.
    rate : 4000..655350 Hz.
    n_channels : 1..8.
    marks : leave room for `mark` before the sound.

    Attributes
    ----------
    n_samples : samples per channel that a reader of the file finds now.
    """

    def __init__(self, file: BinaryIO, rate: int, n_channels: int, *, marks: bool = True) -> None:
        self.n_samples = 0
        self._n_given = 0
        self._rate = rate
        self._gaps: list[Gap] = []
        self._disk = file
        self._sink = _Sink(file, self._with_chapters if marks else None)
        level = {"compression_level": 0.25} if rate < SHORT_BLOCKS_BELOW else {}
        self._file = _NonSeekingFile(self._sink, "w", rate, n_channels, "PCM_24", format="FLAC", **level)

    def write(self, block: Float32Array) -> None:
        """Append a block, shape (n, n_channels), ±1.

        Raises
        ------
        OSError : the disk refuses; the frames that fit are in the file.
        """
        with self._sink.refusals():
            self._file.write(to_integers(block) << 8)
            self._n_given += len(block)
        self._state_length()
        self._sink.raise_refusal()

    def mark(self, seconds: float) -> None:
        """Mark that this many seconds are missing after what was written; only where there is space for marks.

        Raises
        ------
        OSError : the disk refuses.
        """
        self._gaps.append(Gap(self._n_given, seconds))
        if self._sink.tags:  # else they are written with the first block
            place = self._disk.tell()
            self._disk.seek(TAGS_AT)
            write_all(self._disk, self._with_chapters(self._sink.tags))
            self._disk.seek(place)

    def close(self) -> None:
        """Write the last frame and the final header; may be called twice.

        Raises
        ------
        OSError : the disk refuses; the frames that fit are in the file.
        """
        if self._file.closed:
            return
        with self._sink.refusals():
            self._file.close()
        if self._sink.refusal is None:
            self.n_samples = self._n_given
        else:
            self._state_length()
        self._sink.raise_refusal()

    def _with_chapters(self, tags: bytes) -> bytes:
        return with_chapters(tags, self._gaps, self._rate)

    def _state_length(self) -> None:
        if self._sink.n_frames == 0:
            return
        place = self._disk.tell()
        self._disk.seek(BLOCK_SIZE_AT)
        n_samples = self._sink.n_frames * int.from_bytes(self._disk.read(2), "big")
        self._disk.seek(LENGTH_AT)
        other_bits = self._disk.read(1)[0] & 0xF0
        self._disk.seek(LENGTH_AT)
        write_all(self._disk, (other_bits << 32 | n_samples).to_bytes(5, "big"))
        self._disk.seek(place)
        self.n_samples = n_samples


class _Sink:
    """What libsndfile writes to: passes bytes on, counts frames, and remembers why the disk refused.

    An error cannot travel through libsndfile, which only learns that nothing was written. The encoder hands over
    each frame in one piece; one that does not fit is taken off again. `rewrite` gives what takes the place of tags.
    """

    def __init__(self, file: BinaryIO, rewrite: Callable[[bytes], bytes] | None) -> None:
        self.n_frames = 0
        self.tags = b""
        self.refusal: OSError | None = None
        self._rewrite = rewrite
        self._file = file
        self._end = 0

    def write(self, content: bytes) -> int:
        if self.refusal is not None:
            return 0
        begin = self._file.tell()
        try:
            write_all(self._file, self._rewritten(content) if begin == TAGS_AT else content)
        except OSError as error:
            self.refusal = error
            if begin == self._end:
                with suppress(OSError):
                    self._file.truncate(begin)
            return 0
        self.n_frames += begin == self._end and content.startswith(SYNC)
        self._end = max(self._end, self._file.tell())
        return len(content)

    def _rewritten(self, content: bytes) -> bytes:
        if self._rewrite is None or not is_tags(content):
            return content
        self.tags = content
        return self._rewrite(content)

    def seek(self, offset: int, whence: int) -> int:
        return self._file.seek(offset, whence)

    def tell(self) -> int:
        return self._file.tell()

    @contextmanager
    def refusals(self) -> Iterator[None]:
        """Let soundfile's complaint pass where the disk's refusal is its cause; `raise_refusal` tells it better."""
        try:
            yield
        except (soundfile.SoundFileError, AssertionError):
            if self.refusal is None:
                raise

    def raise_refusal(self) -> None:
        if self.refusal is not None:
            raise self.refusal


def through_codec(samples: Float32Array, rate: int, container: str, kind: str, compression: float) -> Float32Array:
    """Return a mono sound, compressed and unpacked again.

    Parameters
    ----------
    samples : float32, shape (n,), ±1.
    rate : Hz, one that the codec knows.
    container, kind : as soundfile names them, such as OGG and OPUS.
    compression : 0..1, 1 the most.
    """
    file = io.BytesIO()
    soundfile.write(file, samples, rate, format=container, subtype=kind, compression_level=compression)
    file.seek(0)
    unpacked, _ = soundfile.read(file, dtype="float32")
    return np.asarray(unpacked, np.float32)
