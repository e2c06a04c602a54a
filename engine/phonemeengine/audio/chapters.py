"""Gaps as chapters in the tags of a FLAC file (RFC 9639, section 8.6), which players show.

The names are those of Xiph's chapter extension: ``CHAPTER001=00:00:07.100`` and ``CHAPTER001NAME=...``.
"""

import struct
from collections.abc import Sequence

from phonemeengine.audio.gaps import MOST_MARKED, Gap

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
