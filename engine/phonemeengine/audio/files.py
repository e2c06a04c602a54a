"""Sound files, read from disk as a stream at 44.1 kHz."""

import functools
import io
import math
import os
import sys
import threading
from collections.abc import Iterable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import BinaryIO

import numpy as np
from typing_extensions import override

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.containers import CONTAINER_SUFFIXES, ContainerDecoder, container_format
from phonemeengine.audio.headers import ADVICE, Extent, after_id3, extent_of
from phonemeengine.audio.libsndfile import DecodingError, FileDecoder, FileSlice, open_checked
from phonemeengine.audio.mixing import PLAIN, Mix, measured_mix
from phonemeengine.audio.resampling import HIGHEST_RATE, LOWEST_RATE, Resampler
from phonemeengine.errors import AudioError
from phonemeengine.execution import Closing
from phonemeengine.settings import SAMPLE_RATE, WINDOW, Channel
from phonemeengine.storage.files import printable_name

SUFFIXES = frozenset(
    {".wav", ".wave", ".bwf", ".rf64", ".w64", ".aif", ".aiff", ".aifc", ".flac", ".ogg", ".oga", ".opus", ".mp3"}
    | {".au", ".snd", ".caf", ".sph", ".nist", ".voc"}
    | CONTAINER_SUFFIXES
)
"""Endings, in small letters, of sound files; films count for the sound in them."""

READ_SECONDS = 0.2
"""Sound that is read from the disk at once, seconds."""

READ_VALUES = 1 << 18
"""Most numbers that are read from the disk at once, over all channels."""

WARM_UP = 0.05
"""Sound before a place that the resampler needs to be right there, seconds."""

DECODER_WARM_UP = 1.0
"""The same for decoders of MP3 and Opus, whose frames lean on those before them, seconds."""

MP3_SLACK = 0.1
"""An MP3 file may lack this much of the length it announces, seconds: encoders count their padding differently."""


class SoundReader(Closing):
    """Reads a sound file as a stream at 44.1 kHz; never holds the whole file.

    A file of one or two channels keeps them. One of more is reduced to a single channel: the mean of all, or one.
    `blocks` and `read_mono` give what is recognised: silent channels are left out, channels that cancel each other
    are turned over, and a very quiet sound is amplified. That is measured before the first of it is given; see `mix`.

    Parameters
    ----------
    path : the file.
    channel : see `choose`.
    as_it_is : give all as it is in the file, such as a room whose loudness counts.

    Attributes
    ----------
    path : the file.
    channel : what is analysed of a sound that has several.
    file_rate : sample rate of the file, Hz.
    n_file_channels : channels of the file.
    n_channels : channels that `read` gives, 1 or 2.
    n_samples : length at 44.1 kHz, samples; at least 1.
    position : the next sample that `read` gives.

    Raises
    ------
    AudioError : the file cannot be read, or is no sound, or says something impossible about itself, or lacks the
        channel.
    """

    def __init__(
        self, path: str | os.PathLike[str], channel: Channel = Channel.MIX, *, as_it_is: bool = False
    ) -> None:
        self.path = Path(path)
        self._mix: Mix | None = PLAIN if as_it_is else None
        self._name = printable_name(self.path)
        self._raw = open_checked(self.path, self._name)
        with ExitStack() as unless_read:
            unless_read.callback(self._raw.close)
            self._extent = _extent(self._raw, self._name)
            self._file = _decoder(self._raw, self._extent, self._name)
            self._n_frames = _checked_length(self._file, self._extent, self._name)
            self.n_file_channels = int(self._file.channels)
            self.choose(channel)
            unless_read.pop_all()
        self.file_rate = int(self._file.samplerate)
        self.n_channels = 2 if self.n_file_channels == 2 else 1
        self.n_samples = max(1, round(self._n_frames * SAMPLE_RATE / self.file_rate))
        self._is_mp3 = _is_mp3(self._file)
        self._is_vorbis = self._file.subtype == "VORBIS"
        self._leans_back = self._is_mp3 or self._file.subtype == "OPUS"
        self._read_frames = max(1, min(int(self.file_rate * READ_SECONDS), READ_VALUES // self.n_file_channels))
        self.position = self._frame = 0
        self._rest: Float32Array = np.zeros((0, self.n_channels), np.float32)
        self._start_at(0)

    @property
    def duration(self) -> float:
        """Length of the sound in the file, seconds."""
        return self._n_frames / self.file_rate

    @property
    def notes(self) -> tuple[str, ...]:
        """Remarks for the user, a sentence each; mostly none. Asking for them measures the sound, see `mix`."""
        assert self.mix is not None
        return self.known_notes

    @property
    def known_notes(self) -> tuple[str, ...]:
        """Those that are known by now."""
        known = self._mix or self._known.mix
        measured = () if known is None else known.notes
        cut_off = [self.cut_off] if self.cut_off else []
        n_tracks = self._file.n_tracks if isinstance(self._file, ContainerDecoder) else 1
        tracks = [f"it has {n_tracks} sound tracks, of which the main one is used"] if n_tracks > 1 else []
        return (*cut_off, *tracks, *_notes(self, is_plain=known is None or not known.weights), *measured)

    @property
    def mix(self) -> Mix:
        """How its channels are mixed and amplified to be recognised.

        It is measured when it is first asked for: an ordinary sound takes no time, and one that is very quiet or in
        which a channel is silent is read once to its end.

        Raises
        ------
        AudioError : the file is damaged.
        """
        if self._mix is None:
            with self._known.lock:
                if self._known.mix is None:
                    self._known.mix = measured_mix(self._file_blocks(), self.file_rate, self.channel)
                self._mix = self._known.mix
        return self._mix

    @property
    def cut_off(self) -> str:
        """What is missing of a file that ends before its header says, as a sentence; empty where it is whole."""
        extent, there = self._extent, f"the file contains {self.duration:.3f} s"
        if not extent.cut_off:
            return ""
        if extent.there == extent.announced:
            return "the file is truncated after the audio, which is complete"
        if not extent.share:
            return f"the header gives no duration; {there}"
        announced = self.duration / extent.share
        return f"the file is truncated; its header announces {announced:.3f} s, but it contains {self.duration:.3f} s"

    def choose(self, channel: Channel) -> None:
        """Analyse another channel; not to be done once something was read.

        Raises
        ------
        AudioError : the file does not have it.
        """
        if channel.number > self.n_file_channels:
            n = self.n_file_channels
            has = "only one channel" if n == 1 else f"{n} channels"
            choice = "the mix" if n == 1 else f"one of 1 to {n}, or the mix"
            raise AudioError(f"{self._name}: it has {has} and so no channel {channel.number}; choose {choice}")
        self.channel = channel
        about = os.fstat(self._raw.fileno())
        self._known = _known_mix(str(self.path.absolute()), about.st_size, about.st_mtime_ns, channel)

    def read(self, n: int) -> Float32Array:
        """Return the next samples, fewer than `n` only at the end of the sound and none after it.

        Returns
        -------
        float32, shape (m, n_channels), C-contiguous, m <= n, ±1.

        Raises
        ------
        AudioError : the file is cut off or damaged, or holds NaN or infinity.
        """
        n = max(0, min(n, self.n_samples - self.position))
        parts, have = [self._rest], len(self._rest)
        while have < n:
            parts.append(self._next_part())
            have += len(parts[-1])
        whole = np.concatenate(parts) if len(parts) > 1 else parts[0]
        self._rest = whole[n:]
        self.position += n
        return whole[:n]

    def seek(self, sample: int) -> None:
        """Go to a sample (44.1 kHz; beyond the ends means the ends), so that `read` goes on from there.

        The resampler starts anew a little earlier, at a frame that falls exactly on a sample, so what follows is
        what an uninterrupted reading gives, but for the resampler's rounding.

        Raises
        ------
        AudioError : the place cannot be reached.
        """
        sample = min(max(sample, 0), self.n_samples)
        step = self.file_rate // math.gcd(self.file_rate, SAMPLE_RATE)
        earliest = sample * self.file_rate // SAMPLE_RATE - int(self._warm_up * self.file_rate)
        frame = min(max(earliest, 0), self._n_frames) // step * step
        self._start_at(frame)
        while self.position < sample:
            self.read(min(sample - self.position, SAMPLE_RATE // 4))

    def blocks(self, n: int) -> Iterator[Float32Array]:
        """Return what is analysed, from the position to the end: float32 blocks of shape (m,), m <= n."""
        while len(block := self.read(n)):
            yield self.mono(block)

    def read_mono(self, n: int = sys.maxsize) -> Float32Array:
        """Return the next samples of what is analysed, or all that are left; shape (m,), m <= n."""
        return self.mono(self.read(n))

    def mono(self, block: Float32Array) -> Float32Array:
        """Return what is recognised, shape (n,), of a block that `read` gave.

        Raises
        ------
        AudioError : the file is damaged, which its measuring found out.
        """
        mix = self.mix
        is_mixed = self.n_channels == 2 and mix.weights
        return mix.amplified(mix.channels_mixed(block) if is_mixed else mono_of(block, self.channel))

    @override
    def close(self) -> None:
        self._file.close()
        self._raw.close()

    @property
    def _warm_up(self) -> float:
        return (DECODER_WARM_UP if self._leans_back else 0.0) + (WARM_UP if self._resampler else 0.0)

    def _start_at(self, frame: int) -> None:
        try:
            if self._is_vorbis:
                self._decode_up_to(frame)
            else:
                self._file.seek(frame)
        except DecodingError as error:
            raise AudioError(f"{self._name}: it can only be read from its beginning; {ADVICE} as WAV") from error
        self._frame = frame
        self._ended = False
        self._rest = np.zeros((0, self.n_channels), np.float32)
        self.position = frame * SAMPLE_RATE // self.file_rate
        rate = self.file_rate
        self._resampler = Resampler(rate, self.n_channels) if rate != SAMPLE_RATE else None

    def _decode_up_to(self, frame: int) -> None:
        """Reach a frame by decoding all before it: libsndfile seeks in Vorbis up to a block beside it (issue 885)."""
        if frame < self._frame:
            self._frame = self._file.seek(0)
        while n := len(self._file.read(min(frame - self._frame, READ_VALUES), dtype="float32")):
            self._frame += n

    def _next_part(self) -> Float32Array:
        """Read on in the file and give what the resampler makes of it; silence once there is nothing left."""
        if self._ended:
            return np.zeros((self.n_samples - self.position, self.n_channels), np.float32)
        block = self._reduced(self._next_frames())
        self._ended = self._frame >= self._n_frames
        if self._resampler is None:
            return block
        return self._resampler.resample(block, last=self._ended)

    def _next_frames(self) -> Float32Array:
        """Read the next frames, shape (n, n_file_channels), n > 0 while there are any."""
        n = min(self._read_frames, self._n_frames - self._frame)
        try:
            block: Float32Array = self._file.read(n, dtype="float32", always_2d=True)
        except DecodingError as error:
            raise AudioError(
                f"{self._name}: it is damaged after {self._seconds(0)}; copy or export it again"
            ) from error
        if len(block) < n:
            block = self._filled_up(block)
        bad = ~np.isfinite(block).all(axis=1)
        if bad.any():
            when = self._seconds(int(bad.argmax()))
            raise AudioError(
                f"{self._name}: samples must be finite numbers, found NaN or infinity at {when}; repair it in an "
                "audio editor and export it again"
            )
        self._frame += len(block)
        return block

    def _filled_up(self, block: Float32Array) -> Float32Array:
        """Replace by silence the little that an MP3 file may lack at its end; refuse a file that is cut off."""
        missing = self._n_frames - self._frame - len(block)
        if not (self._is_mp3 and missing < MP3_SLACK * self.file_rate):
            raise AudioError(
                f"{self._name}: it is cut off after {self._seconds(len(block))} of the {self.duration:.3f} s that "
                "its header announces; copy or export it again"
            )
        return np.concatenate([block, np.zeros((missing, self.n_file_channels), np.float32)])

    def _reduced(self, block: Float32Array) -> Float32Array:
        if self.n_file_channels <= 2:
            return block
        mix = self.mix
        mono = mix.channels_mixed(block) if mix.weights else mono_of(block, self.channel)
        return mono[:, np.newaxis]

    def _file_blocks(self) -> Iterator[Float32Array]:
        """Return the sound as it is in the file, from its beginning, shape (n, n_file_channels); up to damage."""
        decoder = _decoder(self._raw, self._extent, self._name)
        left, most = self._n_frames, max(1, min(self.file_rate // 2, READ_VALUES // self.n_file_channels))
        try:
            while left > 0 and len(block := decoder.read(min(most, left), dtype="float32", always_2d=True)):
                left -= len(block)
                yield np.nan_to_num(block, nan=0.0, posinf=0.0, neginf=0.0)
        except DecodingError:  # reported when reading continues
            return
        finally:
            decoder.close()

    def _seconds(self, n_frames: int) -> str:
        return f"{(self._frame + n_frames) / self.file_rate:.3f} s"


class _KnownMix:
    """How a file is mixed, as soon as one of its readers has measured it; the others wait for that."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.mix: Mix | None = None


@functools.lru_cache(maxsize=64)
def _known_mix(_path: str, _size: int, _changed: int, _channel: Channel) -> _KnownMix:
    return _KnownMix()


def is_sound(path: Path) -> bool:
    """Return whether a file is a sound by its name; what macOS lays beside files (``._x.wav``) is none."""
    return path.suffix.lower() in SUFFIXES and not path.name.startswith("._") and "__MACOSX" not in path.parts


def once_each(sounds: Iterable[Path]) -> tuple[list[Path], dict[Path, Path]]:
    """Return the sounds of a folder, each recording once, and the copies in other formats, each with what it copies.

    Files that differ in their endings alone are one recording: ``x.wav`` counts, before ``x.flac``, before others.
    """
    groups: dict[str, list[Path]] = {}
    for sound in sounds:
        groups.setdefault(str(sound.with_suffix("")), []).append(sound)
    order = {".wav": 0, ".flac": 1}
    kept = {
        name: min(group, key=lambda x: (order.get(x.suffix.lower(), 2), x.name)) for name, group in groups.items()
    }
    copies = {sound: kept[name] for name, group in groups.items() for sound in group if sound != kept[name]}
    return list(kept.values()), copies


def sounds_under(folder: str | os.PathLike[str]) -> list[Path]:
    """Return the sound files in a folder, however deep, in order."""
    place: Path = Path(folder) if isinstance(folder, str) else folder  # type: ignore[assignment]
    return [path for path in sorted(place.rglob("*")) if is_sound(path) and path.is_file()]


def mono_of(block: Float32Array, channel: Channel) -> Float32Array:
    """Reduce a block of shape (m, n_channels) to shape (m,): the mean of all channels, or one of them.

    What has one channel is given as it is.

    Raises
    ------
    AudioError : there are several channels, and fewer than that.
    """
    n = block.shape[1]
    if n == 1:
        return np.ascontiguousarray(block[:, 0])
    if channel is Channel.MIX:
        return np.asarray(block.mean(axis=1), np.float32)
    if channel.number > n:
        raise AudioError(f"there are {n} channels here and so no channel {channel.number}; choose another")
    return np.ascontiguousarray(block[:, channel.number - 1])


def _extent(raw: BinaryIO, name: str) -> Extent:
    if raw.seek(0, io.SEEK_END) == 0:
        raise AudioError(f"{name}: the file is empty (0 bytes); copy or record it again")
    return extent_of(raw, name)


def _decoder(raw: BinaryIO, extent: Extent, name: str) -> FileDecoder | ContainerDecoder:
    part = FileSlice(raw, extent.end, extent.corrections, extent.begin, extent.lead)
    raw.seek(after_id3(raw))
    form = container_format(raw.read(8))
    try:
        return FileDecoder(part) if form is None else ContainerDecoder(io.BufferedReader(part), form)
    except (DecodingError, TypeError) as error:
        reason = "" if form is None else f" ({error})"
        raise AudioError(
            f"{name}: this is not an audio file that can be read{reason}; choose a WAV, AIFF, FLAC, OGG, MP3 or M4A "
            "file"
        ) from error
    except AudioError as error:
        raise AudioError(f"{name}: {error}") from error


def _checked_length(file: FileDecoder | ContainerDecoder, extent: Extent, name: str) -> int:
    """Return the number of frames, after the refusals that concern the file as a whole."""
    rate, n_frames = int(file.samplerate), int(file.frames)
    if not LOWEST_RATE <= rate <= HIGHEST_RATE:
        fault = "low to hold speech" if rate < LOWEST_RATE else "high"
        raise AudioError(
            f"{name}: its sample rate of {rate} Hz is too {fault}; it must lie in {LOWEST_RATE}..{HIGHEST_RATE} Hz, "
            f"so export it again at {SAMPLE_RATE} Hz"
        )
    if n_frames >= 1 << 62:  # what libsndfile gives where the header names none
        raise AudioError(f"{name}: its header does not say how long the sound is; {ADVICE}")
    if n_frames > 0 and (extent.cut_off or extent.is_guess):
        n_frames = _frames_there(file, n_frames)
    if n_frames <= 0:
        raise AudioError(f"{name}: there are no samples in it; record or export it again")
    return n_frames


def _frames_there(file: FileDecoder | ContainerDecoder, most: int) -> int:
    """Count the frames of a file whose length is only guessed, by looking where it ends."""
    here, beyond = -1, most
    probe = most - 1
    while here < beyond - 1:
        if _has_frame(file, probe):
            here = probe
        else:
            beyond = probe
        probe = (here + beyond) // 2
    return beyond


def _has_frame(file: FileDecoder | ContainerDecoder, frame: int) -> bool:
    try:
        file.seek(frame)
        return len(file.read(1)) > 0
    except DecodingError:
        return False


def _is_mp3(file: FileDecoder | ContainerDecoder) -> bool:
    return str(file.subtype).startswith("MPEG_LAYER")


def _notes(reader: SoundReader, *, is_plain: bool) -> Iterator[str]:
    n_file_channels, n_samples, channel = reader.n_file_channels, reader.n_samples, reader.channel
    if n_file_channels > 2 and channel is Channel.MIX and is_plain:
        yield f"{n_file_channels} channels are mixed to one"
    elif n_file_channels > 2 and channel is not Channel.MIX:
        yield f"only channel {channel.number} of {n_file_channels} is used"
    if n_samples < WINDOW:
        yield f"shorter than one window ({1000 * WINDOW / SAMPLE_RATE:.0f} ms), padded with silence"
