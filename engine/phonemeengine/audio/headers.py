"""Whether the sizes in a sound file's header can be true, found out without any sound library.

libsndfile believes the sizes that it reads, and can loop for ever in a file whose sizes lie. Files made of chunks
(WAV, AIFF, W64, CAF and the like) are therefore walked here first, chunk by chunk; only headers are read.
"""

import io
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import BinaryIO

from phonemeengine.audio.counting import FLAC_TOTAL_AT, counted_mp3, flac_total, id3_size
from phonemeengine.errors import AudioError

MOST_CHUNKS = 10_000
"""More chunks than any honest file has; a walk beyond it would only cost time."""

OUTER_SLACK = 8
"""Bytes by which the outermost size may exceed the file: writers that count their own header do that."""

UNKNOWN_32 = 0xFFFF_FFFF
"""The size that sends a reader of RF64 to the ``ds64`` chunk."""

LARGEST_BELIEVED = 1 << 40
"""Bytes of samples that a header may announce and be believed."""

LARGEST_32 = UNKNOWN_32 - (1 << 16)
"""The most bytes of samples that are read of a file whose header has 32 bits for them and was never finished."""

ADVICE = "open it in an audio editor and export it again"


@dataclass(frozen=True)
class ChunkFormat:
    """How one family of files is cut into chunks.

    Attributes
    ----------
    order : byte order of the sizes, as `struct` writes it.
    first : where the first chunk begins, bytes.
    id_width, size_code : bytes of a chunk's name, and the type of its size, as `struct` writes it.
    counts_header : whether a size includes its own header.
    align : chunks begin at multiples of this many bytes.
    data : names of the chunk that holds the samples.
    outer_at : where the size of the whole stands, bytes; 0 where it is not stated.
    n_before : bytes of the chunk with samples that come before them.
    """

    order: str
    first: int
    id_width: int
    size_code: str
    counts_header: bool
    align: int
    data: tuple[bytes, ...]
    outer_at: int = 4
    n_before: int = 0

    @property
    def header(self) -> int:
        """Bytes before a chunk's content."""
        return self.id_width + struct.calcsize(self.size_code)


RIFF = ChunkFormat("<", 12, 4, "I", False, 2, (b"data",))
RIFX = ChunkFormat(">", 12, 4, "I", False, 2, (b"data",))
FORM = ChunkFormat(">", 12, 4, "I", False, 2, (b"SSND", b"BODY"), n_before=8)
W64 = ChunkFormat("<", 40, 16, "Q", True, 8, (b"data\xf3\xac\xd3\x11\x8c\xd1\x00\xc0O\x8e\xdb\x8a",), outer_at=16)
CAF = ChunkFormat(">", 8, 4, "q", False, 1, (b"data",), outer_at=0, n_before=4)

FAMILIES: dict[bytes, ChunkFormat] = {
    b"RIFF": RIFF,
    b"RF64": RIFF,
    b"BW64": RIFF,
    b"RIFX": RIFX,
    b"FORM": FORM,
    b"riff": W64,
    b"caff": CAF,
}


@dataclass(frozen=True)
class Extent:
    """How much of a file is sound.

    Attributes
    ----------
    end : where the sound ends, bytes; what follows is none of it.
    cut_off : whether the file ends before its header says.
    announced, there : bytes of samples that the header announces, and that there are; equal where the sound is whole.
    corrections : what the header has to say instead, so that it tells what is there: bytes by their places.
    begin, lead : where the file begins, bytes, and what is to be put in front of it.
    is_guess : whether the header does not tell how long the sound is.
    """

    end: int
    cut_off: bool = False
    announced: int = 0
    there: int = 0
    corrections: tuple[tuple[int, bytes], ...] = ()
    begin: int = 0
    lead: bytes = b""
    is_guess: bool = False

    @property
    def share(self) -> float:
        """How much of what is announced is there, 0..1; 0 where what is announced cannot be meant.

        Programs that write to a pipe announce about the largest size there is, with or without a sign.
        """
        is_largest = (
            self.announced + (1 << 16) >= UNKNOWN_32 >> 1 and (self.announced + (1 << 16)) % (1 << 31) < 1 << 17
        )
        believable = self.announced < LARGEST_BELIEVED and not is_largest
        return self.there / max(1, self.announced) if believable else 0.0


@dataclass(frozen=True)
class Chunk:
    """One chunk: its name, where its content begins and how long it claims to be, bytes."""

    name: bytes
    begin: int
    size: int

    @property
    def end(self) -> int:
        """Where the content ends, if the size is true."""
        return self.begin + self.size


class HeaderSizeError(Exception):
    """A size that cannot be true; its text says which."""


def extent_of(file: BinaryIO, name: str) -> Extent:
    """Check the sizes in a file's header, and say how much of it is sound.

    A file of chunks that ends before its header says is cut off; what there is of its samples is its sound.

    Parameters
    ----------
    file : open for reading; its place is lost.
    name : what the user calls the file.

    Raises
    ------
    AudioError : a size contradicts the file's length, and not because it was cut off among its samples or later.
    """
    length = file.seek(0, io.SEEK_END)
    start = after_id3(file)
    magic = _bytes_at(file, start, 4)
    try:
        if magic in {b".snd", b"dns."}:
            _check_au(file, ">" if magic == b".snd" else "<", start, length)
        if magic == b"OggS":
            _check_ogg(file, length)
        if magic == b"fLaC":
            return _flac_extent(file, start, length)
        if magic[:1] == b"\xff":
            return _mp3_extent(file, start, length)
        family = FAMILIES.get(magic)
        return Extent(length) if family is None else _walk(file, family, magic, start, length)
    except HeaderSizeError as lie:
        raise AudioError(f"{name}: the sizes in its header do not match the file ({lie}), so {ADVICE}") from None


def _mp3_extent(file: BinaryIO, start: int, length: int) -> Extent:
    count = counted_mp3(file, start, length)
    if count is None:
        return Extent(length)
    return Extent(length, begin=count.begin, lead=count.lead, is_guess=not count.exact)


def _flac_extent(file: BinaryIO, start: int, length: int) -> Extent:
    total = flac_total(file, start, length)
    if total is None:
        return Extent(length)
    return Extent(length, True, UNKNOWN_32, corrections=((start + FLAC_TOTAL_AT, total),))


def _walk(file: BinaryIO, family: ChunkFormat, magic: bytes, start: int, length: int) -> Extent:
    sizes = _sizes_of_ds64(file, start) if magic in {b"RF64", b"BW64"} else None
    claimed = start + _outer_size(file, family, start, length, sizes)
    unfinished = _never_finished(file, family, start, claimed, length, sizes)
    if unfinished is not None:
        return unfinished
    end = min(claimed, length)
    samples: Chunk | None = None
    block = 1
    for chunk in _chunks(file, family, start + family.first, end, sizes):
        if samples and not chunk.name.strip(b"\0"):
            return Extent(chunk.begin - family.header)  # zeros that fill up the file
        is_samples = chunk.name in family.data
        if chunk.end > length and (samples or is_samples):
            whole = chunk.begin - family.header if samples else length
            return _cut_off(family, start, samples or chunk, whole, block, wide=sizes is not None)
        block = _block_in(file, family, chunk) or block
        _check(file, family, chunk, end)
        if is_samples:
            samples = chunk
    if samples is None:
        raise HeaderSizeError("there is no chunk with samples")
    if claimed > length + OUTER_SLACK:
        return _cut_off(family, start, samples, end, block, wide=sizes is not None)
    return Extent(end)


def _check(file: BinaryIO, family: ChunkFormat, chunk: Chunk, end: int) -> None:
    if chunk.end > end:
        raise HeaderSizeError(
            f"{_shown(chunk.name)} claims {chunk.size} bytes, {max(end - chunk.begin, 0)} are there"
        )
    if chunk.name == b"LIST":
        _check_list(file, family, chunk)


def _never_finished(
    file: BinaryIO, family: ChunkFormat, start: int, claimed: int, length: int, sizes: tuple[int, int] | None
) -> Extent | None:
    """Return how much of a file is sound whose sizes were to be written at the end, and never were.

    What it claims ends before its samples do, or it claims none, though bytes follow that it does not speak of.
    """
    block = 1
    for chunk in _chunks(file, family, start + family.first, length, sizes):
        if chunk.name not in family.data:
            if chunk.end > length:
                return None
            block = _block_in(file, family, chunk) or block
            continue
        is_empty, behind = chunk.size <= family.n_before, chunk.begin + family.n_before
        if is_empty:
            is_true = length <= behind or (
                claimed > behind and _are_chunks(file, family, chunk.end, min(claimed, length))
            )
        else:
            is_true = claimed >= min(chunk.end, length)
        if is_true:
            return None
        unknown = Chunk(chunk.name, chunk.begin, max(UNKNOWN_32, length))
        end = length if is_empty else min(chunk.end, length)
        return _cut_off(family, start, unknown, end, block, wide=sizes is not None)
    return None


def _are_chunks(file: BinaryIO, family: ChunkFormat, begin: int, end: int) -> bool:
    """Return whether named chunks fill a part of a file."""
    try:
        return all(x.end <= end and x.name.strip(b"\0") for x in _chunks(file, family, begin, end))
    except HeaderSizeError:
        return False


def _block_in(file: BinaryIO, family: ChunkFormat, chunk: Chunk) -> int:
    """Return the bytes of samples that cannot be parted, where a chunk tells the format; else 0."""
    return _number_at(file, chunk.begin + 12, family.order + "H") if chunk.name.startswith(b"fmt ") else 0


def _cut_off(family: ChunkFormat, start: int, samples: Chunk, end: int, block: int, *, wide: bool) -> Extent:
    """Tell of a file that was cut off among its samples or behind them: what is whole of it ends at `end`.

    `block` is how many bytes of samples cannot be parted; `wide` says that its sizes stand in a ``ds64`` chunk.
    """
    there = samples.size
    if end < samples.end:
        most = LARGEST_32 if family.size_code == "I" and not wide else end
        there = (min(end - samples.begin, most) - family.n_before) // block * block + family.n_before
        end = samples.begin + there
    whole = end - start - (0 if family.counts_header else 8)
    form = family.order + family.size_code
    corrections: tuple[tuple[int, bytes], ...] = ()
    if wide:
        unknown = struct.pack(form, UNKNOWN_32)
        corrections = ((start + 20, struct.pack("<QQ", whole, there)), (samples.begin - len(unknown), unknown))
    else:
        size = struct.pack(form, there + (family.header if family.counts_header else 0))
        outer = (start + family.outer_at, struct.pack(form, whole))
        corrections = ((samples.begin - len(size), size), *([outer] if family.outer_at else []))
    return Extent(end, True, samples.size, there, corrections)


def _outer_size(file: BinaryIO, family: ChunkFormat, start: int, length: int, sizes: tuple[int, int] | None) -> int:
    """Return the bytes that the whole claims to have."""
    if not family.outer_at:
        return length - start
    if sizes:
        return 8 + sizes[0]
    claimed = _number_at(file, start + family.outer_at, family.order + family.size_code)
    return claimed + (0 if family.counts_header else 8)


def _sizes_of_ds64(file: BinaryIO, start: int) -> tuple[int, int]:
    """Return the sizes of the whole and of the samples, which RF64 keeps apart because 32 bits are too few."""
    if _bytes_at(file, start + 12, 4) != b"ds64":
        raise HeaderSizeError("its ds64 chunk is missing")
    return _number_at(file, start + 20, "<Q"), _number_at(file, start + 28, "<Q")


def _chunks(
    file: BinaryIO, family: ChunkFormat, at: int, end: int, sizes: tuple[int, int] | None = None
) -> Iterator[Chunk]:
    """Follow the chunks between two places; a rest too short for a chunk's header is passed over."""
    base = at
    for _ in range(MOST_CHUNKS):
        if at + family.header > end:
            return
        name = _bytes_at(file, at, family.id_width)
        size = _number_at(file, at + family.id_width, family.order + family.size_code)
        begin = at + family.header
        if family is CAF and size == -1 and name in family.data:
            size = end - begin  # the last chunk of a recording, which reaches to the end
        if sizes and size == UNKNOWN_32 and name in family.data:
            size = sizes[1]
        size -= family.header if family.counts_header else 0
        if size < 0 and name in family.data:
            size = 0  # never written
        if size < 0:
            raise HeaderSizeError(f"{_shown(name)} claims {size} bytes")
        yield Chunk(name, begin, size)
        at = begin + size
        at += -(at - base) % family.align
    raise HeaderSizeError(f"it has more than {MOST_CHUNKS} chunks")


def _check_list(file: BinaryIO, family: ChunkFormat, chunk: Chunk) -> None:
    """Check the sizes inside a list of texts; some writers forget to fill its odd texts up to even ones."""
    unpadded = ChunkFormat(family.order, 0, 4, "I", False, 1, ())
    if not any(_tiles(file, layout, chunk) for layout in (family, unpadded)):
        raise HeaderSizeError("a text in its LIST chunk claims more bytes than the list has")


def _tiles(file: BinaryIO, family: ChunkFormat, chunk: Chunk) -> bool:
    return all(part.end <= chunk.end for part in _chunks(file, family, chunk.begin + 4, chunk.end))


def _check_au(file: BinaryIO, order: str, start: int, length: int) -> None:
    offset = _number_at(file, start + 4, order + "I")
    size = _number_at(file, start + 8, order + "I")
    claimed = offset + (0 if size == UNKNOWN_32 else size)
    if start + claimed > length:
        raise HeaderSizeError(f"it claims {claimed} bytes, {length - start} are there")


def _check_ogg(file: BinaryIO, length: int) -> None:
    """Check that the last page is whole; a page has at most 65 307 bytes, and lists the sizes of its segments."""
    tail = _bytes_at(file, max(0, length - 2 * 65_307), 2 * 65_307)
    page = tail[tail.rfind(b"OggS") :]
    n_segments = page[26] if len(page) > 26 else 0
    claimed = 27 + n_segments + sum(page[27 : 27 + n_segments])
    if claimed > len(page):
        raise HeaderSizeError(f"its last page claims {claimed} bytes, {len(page)} are there")


def after_id3(file: BinaryIO) -> int:
    """Return where the file begins after an ID3v2 tag, which may precede anything."""
    head = _bytes_at(file, 0, 10)
    return 10 + id3_size(head) if len(head) == 10 and head.startswith(b"ID3") else 0


def _bytes_at(file: BinaryIO, at: int, n: int) -> bytes:
    file.seek(at)
    return file.read(n)


def _number_at(file: BinaryIO, at: int, code: str) -> int:
    content = _bytes_at(file, at, struct.calcsize(code))
    if len(content) < struct.calcsize(code):
        raise HeaderSizeError("it ends within its header")
    return int(struct.unpack(code, content)[0])


def _shown(name: bytes) -> str:
    text = name[:4].decode("ascii", "replace")
    return f"its {text} chunk" if text.isascii() and text.isprintable() else "an unnamed chunk"
