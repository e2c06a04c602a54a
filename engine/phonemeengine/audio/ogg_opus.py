"""Opus in Ogg as it comes, a page at a time (RFC 7845).

libsndfile reads Ogg Opus, too, but wants the whole file: it looks for the length at the end before it gives a sample.
"""

import struct
from collections.abc import Iterator
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.containers import import_av
from phonemeengine.errors import AudioError

OPUS_RATE = 48_000
"""Hz; Opus is decoded at this rate whatever was encoded."""
MOST_CHANNELS = 2
"""Channels without a table of their own (mapping family 0)."""
LARGEST_PACKET = 1 << 16
"""Bytes; an Opus packet has at most 61 440 where it holds 48 frames of 1275 bytes, and comments are not kept."""
NOT_OGG = "this is not Ogg Opus; send the stream from its first page on, or name another format"
DAMAGED = "the Ogg Opus stream is damaged; encode it again"

_HEADER = struct.Struct("<4sBBqIIIB")
_HEAD = struct.Struct("<8sBBHIhB")
_CONTINUED, _FIRST, _LAST = 1, 2, 4
_UNFINISHED = 255
"""A segment of this many bytes continues in the next one."""
_Page = tuple[int, int, bytes, bytes]
"""Flags, position in samples, lengths of the segments, and their bytes."""


class OggOpusDecoder:
    """Decodes Ogg pages as they come, cut anywhere; streams may follow each other, as in files that are joined.

    Raises
    ------
    AudioError : FFmpeg's libraries are not installed.
    """

    def __init__(self) -> None:
        self._av = import_av("a stream of Ogg Opus")
        self._bytes = bytearray()
        self._serial: int | None = None
        self._begin()

    @property
    def is_whole(self) -> bool:
        """Whether the stream may end here: with a page that says so, or at least with a whole one."""
        return not self._bytes and not self._packet

    def blocks(self, data: bytes | bytearray) -> Iterator[Float32Array]:
        """Take the next bytes; give the sound of each packet in them, shape (n, n_channels), 48 kHz.

        Raises
        ------
        AudioError : they are not Ogg Opus, or are damaged, or hold more than two channels.
        """
        self._bytes += data
        while (page := self._next_page()) is not None:
            serial, page_of_packets = page
            if serial == self._serial:
                yield from self._blocks_of(*page_of_packets)

    def _begin(self) -> None:
        """Wait for the first page of a stream."""
        self._decoder: Any = None
        self._n_packets = 0
        self._packet = bytearray()
        self._n_skip = self._n_given = 0

    def _next_page(self) -> tuple[int, _Page] | None:
        """Return the next page and the number of the stream that it belongs to, if all of it is there.

        Its checksum is left alone: what is damaged on the way TCP has noticed, and the decoder notices the rest.
        """
        held = self._bytes
        if not b"OggS".startswith(held[:4]):
            raise AudioError(NOT_OGG if self._decoder is None else DAMAGED)
        if len(held) < _HEADER.size:
            return None
        _, version, flags, position, serial, _, _, n = _HEADER.unpack_from(held)
        if version:
            raise AudioError(NOT_OGG)
        body = _HEADER.size + n
        lengths = bytes(held[_HEADER.size : body])
        end = body + sum(lengths)
        if len(held) < end:
            return None
        content = bytes(held[body:end])
        del held[:end]
        if flags & _FIRST and self._serial is None:
            self._serial = serial
        return serial, (flags, position, lengths, content)

    def _blocks_of(self, flags: int, position: int, lengths: bytes, content: bytes) -> Iterator[Float32Array]:
        if not flags & _CONTINUED:
            self._packet.clear()
        at = 0
        last = flags & _LAST
        for length in lengths:
            self._packet += content[at : at + length]
            at += length
            if len(self._packet) > LARGEST_PACKET and self._n_packets != 1:
                raise AudioError(DAMAGED)
            if length < _UNFINISHED:
                packet = bytes(self._packet)
                self._packet.clear()
                yield from self._decoded(packet, position - self._n_skip if last else None)
        if last:
            self._serial = None
            self._begin()

    def _decoded(self, packet: bytes, most: int | None) -> Iterator[Float32Array]:
        """Return the sound of a packet, which ends with sample `most` of the stream where that is known."""
        number, self._n_packets = self._n_packets, self._n_packets + 1
        if number == 0:
            self._open(packet)
        elif number == 1:
            if not packet.startswith(b"OpusTags"):
                raise AudioError(DAMAGED)
        elif packet:
            block = self._samples_of(packet)
            if most is not None:
                block = block[: max(0, most - self._n_given)]
            self._n_given += len(block)
            if len(block):
                yield block

    def _open(self, head: bytes) -> None:
        if len(head) < _HEAD.size or not head.startswith(b"OpusHead"):
            raise AudioError(NOT_OGG)
        _, _, n_channels, self._n_skip, _, _, family = _HEAD.unpack_from(head)
        if family or not 1 <= n_channels <= MOST_CHANNELS:
            raise AudioError(f"the Opus stream has {n_channels} channels; send one of 1 or {MOST_CHANNELS}")
        self._decoder = self._av.CodecContext.create("opus", "r")
        self._decoder.extradata = head  # from it the decoder knows the gain, and what it must leave out first
        self._decoder.sample_rate = OPUS_RATE
        self._decoder.layout = ("mono", "stereo")[n_channels - 1]

    def _samples_of(self, packet: bytes) -> Float32Array:
        try:
            frames = self._decoder.decode(self._av.Packet(packet))
        except (self._av.error.FFmpegError, ValueError) as error:
            raise AudioError(DAMAGED) from error
        parts = [frame.to_ndarray().T for frame in frames]
        return np.concatenate(parts) if parts else np.zeros((0, 1), np.float32)
