"""A sound that arrives in chunks, such as over a network, as mono samples at 44.1 kHz, however its bytes are cut."""

import functools
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.containers import import_av
from phonemeengine.audio.files import mono_of
from phonemeengine.audio.resampling import HIGHEST_RATE, LOUDEST, LOWEST_RATE, Resampler
from phonemeengine.errors import AudioError, check_range
from phonemeengine.settings import SAMPLE_RATE, Channel

MOST_STREAM_CHANNELS = 8
FULL_SCALE = np.float32(1 << 15)
"""The integer that stands for 1.0."""
PIECE = 0.2
"""Seconds of sound that are given at once at the most."""


class Encoding(StrEnum):
    """How samples stand in bytes: little-endian integers of 16 bits, floats of 32 bits ±1, or Opus in Ogg pages."""

    S16 = "s16"
    F32 = "f32"
    OPUS = "opus"


_TYPES: dict[Encoding, np.dtype[Any]] = {Encoding.S16: np.dtype("<i2"), Encoding.F32: np.dtype("<f4")}


@dataclass(frozen=True)
class StreamFormat:
    """The format of a sound that arrives in chunks.

    Attributes
    ----------
    encoding : how samples stand in them.
    rate : samples per second, 1000..768000; Opus says it itself, and is decoded at 48000.
    n_channels : samples at each time, interleaved, 1..8, of which the mean is analysed; Opus states it itself.

    Raises
    ------
    AudioError : a number lies outside its range.
    """

    encoding: Encoding = Encoding.S16
    rate: int = SAMPLE_RATE
    n_channels: int = 1

    def __post_init__(self) -> None:
        check_range("the sample rate", self.rate, (LOWEST_RATE, HIGHEST_RATE, "Hz"), AudioError)
        if not 1 <= self.n_channels <= MOST_STREAM_CHANNELS:
            raise AudioError(
                f"a stream has 1..{MOST_STREAM_CHANNELS} channels, got {self.n_channels}; send fewer, or mix them"
            )

    @property
    def decoded_rate(self) -> int:
        """Samples per second once it is decoded."""
        return OPUS_RATE if self.encoding is Encoding.OPUS else self.rate


class IncomingSound:
    """Follows one sound: takes its bytes as they come, gives its samples.

    Parameters
    ----------
    form : what the bytes are.

    Attributes
    ----------
    n_silenced : values that were NaN or infinite, and were taken as 0, as the runtime in C does.

    Raises
    ------
    AudioError : Opus is asked for, and what decodes it is not installed.
    """

    def __init__(self, form: StreamFormat) -> None:
        self._rate = form.decoded_rate
        is_opus = form.encoding is Encoding.OPUS
        self._decoder = OggOpusDecoder() if is_opus else PcmDecoder(_TYPES[form.encoding], form)
        self._resampler = Resampler(self._rate, 1, steady=True) if self._rate != SAMPLE_RATE else None
        self._n_frames = self._n_given = self.n_silenced = 0

    @property
    def seconds(self) -> float:
        """How much has come."""
        return self._n_frames / self._rate

    @property
    def delay(self) -> float:
        """Delay of the resampler, seconds, as soon as it runs."""
        return _steady_delay(self._rate) if self._resampler is not None else 0.0

    def pieces(self, data: bytes | bytearray) -> Iterator[Float32Array]:
        """Take the next bytes; give the samples that they complete, float32, shape (n,), 44.1 kHz, ±1.

        What comes is decoded when it is asked for, at most 0.2 s at once: bytes of a few may hold hours.

        Raises
        ------
        AudioError : they are not what the format says, or hold samples far beyond ±1.
        """
        for coded in self._decoder.blocks(data):
            block = self._checked(coded)
            self._n_frames += len(block)
            mono = mono_of(block, Channel.MIX)
            if self._resampler is not None:
                mono = self._resampler.resample(mono[:, np.newaxis])[:, 0]
            self._n_given += len(mono)
            yield mono

    def finish(self) -> Float32Array:
        """Return the samples that the resampler still holds, since the sound has ended.

        Raises
        ------
        AudioError : it ends in the midst of a sample or a page.
        """
        if not self._decoder.is_whole:
            raise AudioError(
                f"the sound is cut off after {self.seconds:.3f} s, in the midst of a sample or a page; send all of it"
            )
        n_missing = max(0, round(self.seconds * SAMPLE_RATE) - self._n_given)
        if self._resampler is None or not n_missing:
            return np.zeros(0, np.float32)
        rest = self._resampler.resample(np.zeros((0, 1), np.float32), last=True)[:n_missing, 0]
        return np.pad(rest, (0, n_missing - len(rest)))

    def _checked(self, block: Float32Array) -> Float32Array:
        """Return a block with 0 for what is no number; refuse what is far too loud."""
        if (np.abs(block) <= LOUDEST).all():  # NaN is not
            return block
        finite = np.isfinite(block)
        self.n_silenced += int(np.count_nonzero(~finite))
        block = np.where(finite, block, np.float32(0))
        loud = np.abs(block) > LOUDEST
        if loud.any():
            first = int(loud.any(axis=1).argmax())
            when, value = self.seconds + first / self._rate, block[first][loud[first]][0]
            raise AudioError(
                f"samples must lie within ±1, found {value:g} at {when:.3f} s; check the format, or repair the sound"
            )
        return block


@functools.cache
def _steady_delay(rate: int) -> float:
    """Measure how much the steady resampler holds back, seconds."""
    resampler = Resampler(rate, 1, steady=True)
    resampler.resample(np.zeros((rate // 4, 1), np.float32))
    return resampler.delay


class PcmDecoder:
    """Reads samples out of bytes that are cut anywhere.

    Parameters
    ----------
    kind : of the numbers.
    form : how many there are.
    """

    def __init__(self, kind: np.dtype[Any], form: StreamFormat) -> None:
        self._kind, self._n_channels = kind, form.n_channels
        self._n_bytes = kind.itemsize * form.n_channels
        self._most = max(1, int(form.rate * PIECE)) * self._n_bytes
        self._rest = b""

    @property
    def is_whole(self) -> bool:
        """Whether the sound may end here."""
        return not self._rest

    def blocks(self, data: bytes | bytearray) -> Iterator[Float32Array]:
        """Take the next bytes; give the samples in them, shape (n, n_channels), a fifth of a second at most."""
        held = self._rest + data
        end = len(held) // self._n_bytes * self._n_bytes
        self._rest = bytes(held[end:])
        for first in range(0, end, self._most):
            part = held[first : min(first + self._most, end)]
            samples = np.frombuffer(part, self._kind).reshape(-1, self._n_channels)
            yield np.asarray(samples / FULL_SCALE if self._kind.kind == "i" else samples, np.float32)


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
    """Decodes Opus in Ogg (RFC 7845) as it comes, cut anywhere; streams may follow each other, as in joined files.

    libsndfile reads Ogg Opus, too, but looks for the length at the end of the file before it gives a sample.

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
