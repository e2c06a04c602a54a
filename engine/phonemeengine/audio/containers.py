"""Sound in M4A, MP4, MOV, AAC, WebM, Matroska and WMA, also beside pictures: the only module that imports PyAV.

A file is looked through once when it is opened, packet by packet and without decoding, since what such files say of
their length is often rounded. Packets are known again by their places in the file, so that any sample can be gone to.
"""

from array import array
from collections.abc import Iterator
from types import ModuleType
from typing import Any, BinaryIO

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.libsndfile import DecodingError
from phonemeengine.errors import AudioError

CONTAINER_SUFFIXES = frozenset(
    {".m4a", ".m4b", ".mp4", ".m4v", ".mov", ".3gp", ".aac", ".webm", ".mkv", ".mka", ".wma", ".wmv"}
)
"""Endings, in small letters, of the files that are read here."""
WARM_UP_PACKETS = 50
"""Packets before a place that the decoder must have decoded to be right there; half a second and more."""
MOST_PACKETS = 1 << 26
"""More than a week of packets; a file that claims more is refused."""
MOST_CHANNELS = 64
"""Channels that a track may have."""
PROBED = 20
"""Packets by which the samples of each are found out."""
_MAGIC = {b"\x1a\x45\xdf\xa3": "matroska", b"\x30\x26\xb2\x75": "asf"}
_BOXES = {b"ftyp", b"moov", b"mdat", b"wide", b"skip"}
_Block = tuple[int, Float32Array]
"""The number of its first sample, and samples, shape (n, n_channels)."""


def container_format(head: bytes) -> str | None:
    """Return what FFmpeg calls the format of a file that begins so; None where it is no container."""
    if head[4:8] in _BOXES:
        return "mov"
    is_adts = len(head) > 1 and head[0] == 0xFF and head[1] & 0xF6 == 0xF0
    return "aac" if is_adts else _MAGIC.get(head[:4])


def import_av(what: str) -> ModuleType:
    """Import FFmpeg's libraries, which come with several extras.

    Parameters
    ----------
    what : cannot be read without them.

    Raises
    ------
    AudioError : they are not installed.
    """
    try:
        import av  # noqa: PLC0415 - large, and only these formats need it
    except ImportError as error:
        raise AudioError(
            f"{what} needs the package av, which is not installed; install it with: "
            "pip install 'phonemeanalyser[media]'"
        ) from error
    return av


class ContainerDecoder:
    """The sound of a container; it is read as a `FileDecoder` is.

    Parameters
    ----------
    file : open for reading; it stays open.
    form : see `container_format`.

    Attributes
    ----------
    samplerate, channels : of the sound.
    frames : its length, samples.
    subtype : the codec, as FFmpeg calls it.
    n_tracks : tracks of sound in the file, of which the main one is read.

    Raises
    ------
    DecodingError : there is no sound in it, or it is damaged.
    AudioError : FFmpeg's libraries are not installed.
    """

    def __init__(self, file: BinaryIO, form: str) -> None:
        self._av = import_av("this kind of file")
        self._errors = (self._av.error.FFmpegError, ValueError, OSError)
        self._file, self._form = file, form
        self._container: Any = None
        self._rest: Float32Array = np.zeros((0, 0), np.float32)
        self.samplerate = self.channels = self.frames = 0
        try:
            self._open()
            self.subtype = str(self._track.codec_context.name)
            self._look_through()
            self._measure()
            self.seek(0)
        except BaseException:
            self.close()
            raise

    def read(self, n: int, dtype: str = "float32", always_2d: bool = False) -> Float32Array:
        """Return the next samples, fewer than `n` only at the end; shape (m, channels), or (m,) of one channel.

        Raises
        ------
        DecodingError : it is damaged.
        """
        assert dtype == "float32"
        parts, n_held = [self._rest], len(self._rest)
        while n_held < n and (found := next(self._blocks, None)) is not None:
            parts.append(found[1])
            n_held += len(found[1])
        whole = np.concatenate(parts)
        self._rest = whole[n:]
        return whole[:n] if always_2d or self.channels > 1 else whole[:n, 0]

    def seek(self, frame: int) -> int:
        """Go to a sample, and return its number.

        Raises
        ------
        DecodingError : it is damaged before that.
        """
        self._begin((frame + self._n_skipped) // self._n_each - WARM_UP_PACKETS if self._n_each else 0)
        self._rest = np.zeros((0, self.channels), np.float32)
        for first, block in self._blocks:
            if first + len(block) > frame:
                self._rest = block[max(0, frame - first) :]
                break
        return frame

    def close(self) -> None:
        """Let go of what was opened here."""
        if self._container is not None:
            self._container.close()

    def _open(self) -> None:
        """Open the container, at its beginning."""
        self.close()
        self._file.seek(0)
        try:
            self._container = self._av.open(self._file, format=self._form, metadata_errors="replace")
        except self._errors as error:
            raise DecodingError("it cannot be opened") from error
        tracks = self._container.streams.audio
        if not tracks:
            raise DecodingError("there is no sound in it")
        self.n_tracks = len(tracks)
        self._track = self._container.streams.best("audio") or tracks[0]
        for stream in self._container.streams:
            if stream is not self._track and hasattr(stream, "discard"):
                stream.discard = type(stream.discard)["all"]
        if self._track.codec_context is None:
            raise DecodingError("its codec is not known")

    def _packets(self) -> Iterator[Any]:
        """Return the next packets of the track, and an empty one at the end."""
        try:
            yield from self._container.demux(self._track)
        except self._errors as error:
            raise DecodingError("it is damaged") from error

    def _look_through(self) -> None:
        """Note where each packet is in the file, and when its sound is."""
        self._places, self._times, self._lengths = array("q"), array("q"), array("q")
        for packet in self._packets():
            if packet.size == 0:
                continue
            if len(self._places) >= MOST_PACKETS:
                raise DecodingError("it has too many packets")
            self._places.append(-1 if packet.pos is None else packet.pos)
            self._times.append(0 if packet.pts is None else packet.pts)
            self._lengths.append(packet.duration or 0)

    def _measure(self) -> None:
        """Find out how many samples a packet has, how many are left out at the beginning, and how many there are."""
        self._n_each = self._n_skipped = 0
        self._numbers: dict[int, int] = {}
        sizes = []
        self._begin(0)
        for _, block in self._blocks:
            sizes.append(len(block))
            if len(sizes) == PROBED:
                break
        if not self.channels:
            raise DecodingError("there are no samples in it")
        if len(sizes) == PROBED and self._is_regular(sizes[-1]):
            self._n_each, self._n_skipped = sizes[-1], PROBED * sizes[-1] - sum(sizes)
            self._numbers = {place: k for k, place in enumerate(self._places)}
        self._begin(len(self._places) - 2 if self._n_each else 0)
        for first, block in self._blocks:
            self.frames = max(self.frames, first + len(block) if len(block) else 0)

    def _is_regular(self, n_each: int) -> bool:
        """Return whether each packet but the last has this many samples, and can be found again by its place."""
        places, lengths = np.frombuffer(self._places, np.int64), np.frombuffer(self._lengths, np.int64)
        ticks = n_each / self.samplerate / float(self._track.time_base or 1)
        found = (places >= 0).all() and len(np.unique(places)) == len(places)
        return bool(n_each and found and (np.abs(lengths[:-1] - ticks) <= 1.0).all())

    def _begin(self, number: int) -> None:
        """Go to a packet, or one before it; the decoder knows nothing of those before that."""
        self._blocks = self._blocks_from(max(0, number))

    def _blocks_from(self, number: int) -> Iterator[_Block]:
        """Return the sound of each packet from one on; a packet in which nothing is left has an empty block."""
        packets = self._packets_from(number)
        known, packet = next(packets, (0, None))
        n_before = 0
        while packet is not None:
            block = self._decoded(packet, is_last=known >= len(self._places) - 1)
            first = n_before
            if self._n_each:
                skipped = known * self._n_each < self._n_skipped
                first = (known + 1) * self._n_each - len(block) if skipped else known * self._n_each
                first -= self._n_skipped
            n_before += len(block)
            yield first, block
            known, packet = next(packets, (0, None))

    def _packets_from(self, number: int) -> Iterator[tuple[int, Any]]:
        if number > 0:
            with_place = self._sought(number)
            if with_place is not None:
                yield from with_place
                return
        self._open()
        yield from enumerate(self._packets())

    def _sought(self, number: int) -> Iterator[tuple[int, Any]] | None:
        """Go to a packet that is no later than one asked for; None where it cannot be found."""
        try:
            self._container.seek(self._times[number], stream=self._track, backward=True)
        except self._errors:
            return None
        packets = self._packets()
        first = next(packets, None)
        found = None if first is None else self._numbers.get(first.pos)
        if found is None or found > number:
            return None
        return _numbered(found, first, packets)

    def _decoded(self, packet: Any, *, is_last: bool) -> Float32Array:
        """Return the sound of a packet, shape (n, n_channels); nothing of a last one that is not whole."""
        try:
            frames = packet.decode()
        except self._errors as error:
            if not is_last:
                raise DecodingError("it is damaged") from error
            frames = []
        parts = [self._samples_of(frame) for frame in frames if frame.samples]
        return np.concatenate(parts) if parts else np.zeros((0, self.channels), np.float32)

    def _samples_of(self, frame: Any) -> Float32Array:
        n_channels = len(frame.layout.channels)
        if not self.channels:
            self.samplerate, self.channels = frame.sample_rate, n_channels
        if (frame.sample_rate, n_channels) != (self.samplerate, self.channels) or not 0 < n_channels <= MOST_CHANNELS:
            raise DecodingError("its channels or its sample rate change")
        values = frame.to_ndarray()
        samples = values.T if frame.format.is_planar else values.reshape(-1, n_channels)
        if samples.dtype.kind == "f":
            return np.ascontiguousarray(samples, np.float32)
        bias, scale = (128, 128) if samples.dtype == np.uint8 else (0, 1 << (8 * samples.dtype.itemsize - 1))
        return np.ascontiguousarray((samples.astype(np.float64) - bias) / scale, np.float32)


def _numbered(number: int, first: Any, packets: Iterator[Any]) -> Iterator[tuple[int, Any]]:
    yield number, first
    yield from enumerate(packets, number + 1)
