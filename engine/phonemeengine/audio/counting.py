"""How long MP3 and FLAC files are whose headers do not say it, counted without decoding them."""

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import BinaryIO

CHUNK = 1 << 20
"""Bytes that are read at once."""
MOST_BEFORE = 1 << 16
"""Bytes in which the first frame of an MP3 file is looked for."""
TAGS_BEHIND = (b"TAG", b"APETAGEX", b"LYRICSBEGIN", b"\0\0\0\0")
"""What may follow the last frame of an MP3 file."""
SLACK = 4096
"""Bytes by which an MP3 file may be longer than its header counts, beside the tags at its end."""

_KBITS = {
    3: (0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320),
    2: (0, 8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160),
}
_RATES = {3: (44_100, 48_000, 32_000), 2: (22_050, 24_000, 16_000), 0: (11_025, 12_000, 8_000)}
_LEAD_BITS = 0x90
"""The bit rate of a frame that has room for a count: 128 kbit/s in MPEG 1, 80 in MPEG 2."""


@dataclass(frozen=True)
class Mp3Count:
    """The frames of an MP3 file, counted.

    Attributes
    ----------
    begin : where the first frame with sound begins, bytes.
    lead : a frame without sound that states how many there are ("Xing"), to be put in front of them.
    exact : whether there was nothing but frames; else the number in the lead is an upper limit.
    """

    begin: int
    lead: bytes
    exact: bool


def counted_mp3(file: BinaryIO, start: int, end: int) -> Mp3Count | None:
    """Count the frames of an MP3 file (ISO 11172-3, layer III) whose header does not, or counts too few.

    A decoder would otherwise guess its length by the bit rate of the first frame.

    Parameters
    ----------
    file : open for reading; its place is lost.
    start, end : where the file begins behind its tags, and where it ends, bytes.

    Returns
    -------
    None where the header states the length, or there are no such frames.
    """
    file.seek(start)
    head = file.read(MOST_BEFORE)
    at = _first_frame(head)
    if at is None:
        return None
    first = head[at : at + 4]
    stated = _stated_bytes(head[at : at + _frame_size(first)])
    if stated is not None and stated + SLACK >= end - start - at - _tags_behind(file, end):
        return None
    begin = start + at + (_frame_size(first) if stated is not None else 0)
    n, smallest, exact = _count_frames(file, begin, end)
    return Mp3Count(begin, _lead(first, n if exact else n + (end - begin) // max(24, smallest)), exact)


def _first_frame(head: bytes) -> int | None:
    """Return where a frame begins that another one follows."""
    at = head.find(b"\xff")
    while 0 <= at < len(head) - 4:
        size = _frame_size(head[at : at + 4])
        if size and (at + size + 4 > len(head) or _frame_size(head[at + size : at + size + 4])):
            return at
        at = head.find(b"\xff", at + 1)
    return None


def _frame_size(head: bytes) -> int:
    """Return the bytes of a frame, by its first four; 0 where they begin none of layer III."""
    if len(head) < 4 or head[0] != 0xFF or head[1] & 0xE6 != 0xE2:
        return 0
    version, bits, rate = head[1] >> 3 & 3, head[2] >> 4, head[2] >> 2 & 3
    if version == 1 or bits in {0, 15} or rate == 3:
        return 0
    kbits = _KBITS[3 if version == 3 else 2][bits]
    return (144_000 if version == 3 else 72_000) * kbits // _RATES[version][rate] + (head[2] >> 1 & 1)


def _side_end(head: bytes) -> int:
    """Return where a frame's side information ends, behind which a count stands."""
    mono = head[3] >> 6 == 3
    return (21 if mono else 36) if head[1] >> 3 & 3 == 3 else (13 if mono else 21)


def _stated_bytes(frame: bytes) -> int | None:
    """Return the bytes of the file as its first frame counts them: 0 where it gives no number; None without one.

    A header that does not say how many bytes it counts is believed.
    """
    for tag in (b"Xing", b"Info"):
        at = frame.find(tag)
        if at >= 0:
            flags = frame[at + 7] if len(frame) > at + 7 else 0
            place = at + 8 + 4 * (flags & 1)
            return int.from_bytes(frame[place : place + 4]) if flags & 2 else 1 << 62
    at = frame.find(b"VBRI")
    return int.from_bytes(frame[at + 10 : at + 14]) if at >= 0 else None


def _tags_behind(file: BinaryIO, end: int) -> int:
    """Return the bytes of tags at the end of a file."""
    file.seek(max(0, end - 160))
    tail = file.read(160)
    n = 128 if tail[-128:].startswith(b"TAG") else 0
    at = tail.rfind(b"APETAGEX")
    return n + (32 + int.from_bytes(tail[at + 12 : at + 16], "little") if at >= 0 else 0)


def _count_frames(file: BinaryIO, begin: int, end: int) -> tuple[int, int, bool]:
    """Return how many frames follow each other, the bytes of the smallest, and whether nothing else follows."""
    n, smallest, at, held, base = 0, 1 << 16, begin, b"", begin
    while at + 4 <= end:
        if at + 16 > base + len(held):
            file.seek(at)
            base, held = at, file.read(min(CHUNK, end - at))
        head = held[at - base : at - base + 16]
        size = _frame_size(head)
        if size:
            n, smallest = n + (at + size <= end), min(size, smallest)
        elif head.startswith(b"ID3") and len(head) >= 10:
            size = 10 + id3_size(head)
        else:
            return n, smallest, head.startswith(TAGS_BEHIND)
        at += size
    return n, smallest, True


def id3_size(head: bytes) -> int:
    """Return the bytes of an ID3v2 tag behind its ten first, which have 7 bits of its size each."""
    a, b, c, d = (byte & 0x7F for byte in head[6:10])
    return a << 21 | b << 14 | c << 7 | d


def _lead(first: bytes, n_frames: int) -> bytes:
    head = bytes([0xFF, first[1] | 1, first[2] & 0x0C | _LEAD_BITS, first[3]])
    count = struct.pack(">4sII", b"Xing", 1, n_frames)
    return (head + bytes(_side_end(head) - 4) + count).ljust(_frame_size(head), b"\0")


FLAC_TOTAL_AT = 21
"""Where the number of samples stands in a FLAC file: its lowest 36 bits are in 5 bytes."""
LARGEST_FRAME = 1 << 20
"""Bytes at the end of a FLAC file in which its last frames are looked for."""
_BLOCKS = {1: 192, **{k: 576 << (k - 2) for k in range(2, 6)}, **{k: 256 << (k - 8) for k in range(8, 16)}}


def flac_total(file: BinaryIO, start: int, end: int) -> bytes | None:
    """Return the five bytes that state the length of a FLAC file (RFC 9639) that was never finished.

    A frame that is cut off is not counted.

    Parameters
    ----------
    file : open for reading; its place is lost.
    start, end : where ``fLaC`` stands, and where the file ends, bytes.

    Returns
    -------
    None where its header states a length, or no frame is there.
    """
    file.seek(start)
    head = file.read(FLAC_TOTAL_AT + 5)
    total = int.from_bytes(head[FLAC_TOTAL_AT:])
    if len(head) < FLAC_TOTAL_AT + 5 or total & 0xF_FFFF_FFFF:
        return None
    tail_at = max(start + FLAC_TOTAL_AT, end - LARGEST_FRAME)
    file.seek(tail_at)
    tail = file.read(end - tail_at)
    frames = list(_flac_frames(tail, int.from_bytes(head[8:10])))
    for k in range(len(frames) - 1, -1, -1):
        at, first, n = frames[k]
        if first == 0 or any(before + m == first for _, before, m in frames[max(0, k - 64) : k]):
            whole = _crc16(tail[at:]) == 0
            n_samples = first + (n if whole else 0)
            return (total | n_samples).to_bytes(5) if 0 < n_samples < 1 << 36 else None
    return None


def _flac_frames(tail: bytes, block: int) -> Iterator[tuple[int, int, int]]:
    """Return where frames seem to begin, the numbers of their first samples, and how many samples each has."""
    at = tail.find(b"\xff")
    while 0 <= at < len(tail) - 6:
        found = _flac_frame(tail[at : at + 18], block)
        if found is not None:
            yield at, *found
        at = tail.find(b"\xff", at + 1)


def _flac_frame(head: bytes, block: int) -> tuple[int, int] | None:
    """Return the first sample of a frame and how many it has, where bytes begin a frame."""
    if head[1] not in {0xF8, 0xF9} or head[3] & 1 or head[3] >> 4 > 10 or head[2] >> 4 == 0 or head[2] & 15 == 15:
        return None
    ones = 8 - (head[4] ^ 0xFF).bit_length()
    width = max(1, ones)
    if ones == 1 or ones > 7 or len(head) < 4 + width + 5:
        return None
    number = head[4] & (0xFF >> (ones + 1)) if ones else head[4]
    for byte in head[5 : 4 + width]:
        number = number << 6 | byte & 0x3F
    at, code = 4 + width, head[2] >> 4
    n_size = {6: 1, 7: 2}.get(code, 0)
    n = int.from_bytes(head[at : at + n_size]) + 1 if n_size else _BLOCKS[code]
    at += n_size + {12: 1, 13: 2, 14: 2}.get(head[2] & 15, 0)
    if at >= len(head) or _crc8(head[:at]) != head[at]:
        return None
    return (number if head[1] & 1 else number * block), n


def _crc8(content: bytes) -> int:
    crc = 0
    for byte in content:
        crc ^= byte
        for _ in range(8):
            crc = crc << 1 & 0xFF ^ (0x07 if crc & 0x80 else 0)
    return crc


def _crc16(content: bytes) -> int:
    crc = 0
    for byte in content:
        crc = crc << 8 & 0xFFFF ^ _CRC16[crc >> 8 ^ byte]
    return crc


def _crc16_table() -> tuple[int, ...]:
    table = []
    for value in range(256):
        crc = value << 8
        for _ in range(8):
            crc = crc << 1 & 0xFFFF ^ (0x8005 if crc & 0x8000 else 0)
        table.append(crc)
    return tuple(table)


_CRC16 = _crc16_table()
