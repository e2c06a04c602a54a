"""Pictures one after the other, as a film with sound (.mp4), as a .gif, or as a folder of .png files."""

import importlib
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import Any, BinaryIO

import numpy as np
from PIL import Image

from phonemeanalyser.rendering import RenderingError
from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.storage.files import reason_of

QUALITY = "18"
"""The constant rate factor of H.264: smaller is better, 18 looks like the original."""
SOUND_BIT_RATE = 160_000
FASTEST_GIF = 50.0
"""Frames per second: programs show faster ones slowly."""
ROUNDS = 2
"""In which the 256 colours of a .gif are brought nearer to those of the picture; without, blue eyes would be grey."""
COLOURS, HALF = 256, 128
"""Of a .gif, of which one is transparent if any is; and how opaque something must be to be seen in it, of 255."""
CLEARED: dict[str, Any] = {"transparency": COLOURS - 1, "disposal": 2}
"""How a transparent .gif is saved: each picture in place of the one before."""
LONGEST_GIF = 1800
"""Frames of a .gif, which is held in memory."""

_NUMBERED = re.compile(r"\d{6,}\.png")
"""What the pictures of a folder are called."""

Blocks = Iterable[Float32Array]


@dataclass(frozen=True)
class SoundTrack:
    """The sound of a film.

    Attributes
    ----------
    rate : samples per second.
    n_channels : 1 or 2.
    blocks : float32, each of shape (n, n_channels), ±1.
    """

    rate: int
    n_channels: int
    blocks: Blocks


def why_no_film(size: tuple[int, int], *, transparent: bool = False) -> str:
    """Return in a sentence why no .mp4 of this size can be written; empty if it can."""
    if transparent:
        return "an .mp4 cannot have a transparent background; name a .gif, or a folder for .png"
    if size[0] % 2 or size[1] % 2:
        return f"an .mp4 has an even width and height, got {size[0]}x{size[1]}; choose another size"
    try:
        _av()
    except ImportError as error:
        return (
            f"an .mp4 needs the package av, which cannot be loaded ({error}); install it with: pip install "
            "'phonemeanalyser[preview]', or name a .gif or a folder"
        )
    return ""


def why_no_gif(n_frames: int, rate: float) -> str:
    """Return in a sentence why no .gif with this many frames can be written; empty if it can."""
    if rate > FASTEST_GIF:
        return f"a .gif shows at most {FASTEST_GIF:g} frames per second, got {rate:g}; choose fewer, or an .mp4"
    if n_frames > LONGEST_GIF:
        return f"a .gif holds at most {LONGEST_GIF} frames, this would have {n_frames}; choose fewer, or an .mp4"
    return ""


def write_film(
    file: BinaryIO, pictures: Iterable[UInt8Array], size: tuple[int, int], rate: float, sound: SoundTrack | None
) -> None:
    """Write H.264, and AAC where there is a sound, as .mp4.

    Raises
    ------
    RenderingError : the encoders refuse it.
    """
    av = _av()
    try:
        with av.open(file, "w", format="mp4") as film:
            seen = _picture_stream(film, size, rate)
            sound_stream = None if sound is None else _sound_stream(film, sound)
            for packet in _packets(av, seen, sound_stream, pictures, sound):
                film.mux(packet)
    except av.error.FFmpegError as error:
        raise RenderingError(
            f"the film cannot be encoded ({reason_of(error)}); write a folder of pictures"
        ) from error


def write_gif(file: BinaryIO, pictures: Iterable[UInt8Array], n_frames: int, rate: float) -> None:
    """Write a .gif that goes on and on; it has no sound."""
    coverage = Image.Quantize.MAXCOVERAGE  # small things of their own colour keep it, such as eyes
    images = (_indexed(Image.fromarray(picture), coverage) for picture in pictures)
    ends = np.round(np.arange(n_frames + 1) / rate * 100).astype(int)
    durations = (np.diff(ends) * 10).tolist()
    first = next(images)
    cleared = CLEARED if "transparency" in first.info else {}
    first.save(file, "GIF", save_all=True, append_images=images, duration=durations, loop=0, **cleared)


def _indexed(image: Image.Image, method: Image.Quantize) -> Image.Image:
    """Return a picture in 256 colours at most, of which one stands for what is transparent."""
    if image.mode != "RGBA":
        return image.quantize(method=method, kmeans=ROUNDS, dither=Image.Dither.NONE)
    clear = image.getchannel("A").point(lambda opaque: 255 if opaque < HALF else 0)
    found = image.convert("RGB").quantize(COLOURS - 1, method, ROUNDS, dither=Image.Dither.NONE)
    found.paste(COLOURS - 1, mask=clear)
    found.info["transparency"] = COLOURS - 1
    return found


def write_pictures(folder: Path, pictures: Iterable[UInt8Array], *, overwrite: bool = False) -> None:
    """Write ``000000.png`` and so on into a folder, which is made if need be.

    Parameters
    ----------
    overwrite : whether pictures of these names that are there go, also those that are not written anew.

    Raises
    ------
    RenderingError : there are such pictures that stay or other things in the folder, or it cannot be written to.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        earlier = list(folder.iterdir())
        if not all(_NUMBERED.fullmatch(path.name) for path in earlier):
            raise RenderingError(f"{folder}: this folder is not empty; name another one for the pictures")
        if earlier and not overwrite:
            raise RenderingError(
                f"{folder}: there are pictures already; name another folder, or replace them with --overwrite"
            )
        for path in earlier:
            path.unlink()
        for number, picture in enumerate(pictures):
            Image.fromarray(picture).save(folder / f"{number:06d}.png", compress_level=4)
    except OSError as error:
        raise RenderingError(f"{folder}: cannot be written ({reason_of(error)}); choose another folder") from error


def _av() -> ModuleType:
    """Import FFmpeg's libraries, which only films need."""
    return importlib.import_module("av")


def _picture_stream(film: Any, size: tuple[int, int], rate: float) -> Any:
    stream = film.add_stream("libx264", rate=Fraction(rate).limit_denominator(1001))
    stream.width, stream.height = size
    stream.pix_fmt = "yuv420p"
    stream.options = {"crf": QUALITY, "preset": "veryfast"}
    return stream


def _sound_stream(film: Any, sound: SoundTrack) -> Any:
    stream = film.add_stream("aac", rate=sound.rate, layout=("mono", "stereo")[sound.n_channels - 1])
    stream.bit_rate = SOUND_BIT_RATE
    return stream


def _packets(
    av: ModuleType, seen: Any, sound_stream: Any, pictures: Iterable[UInt8Array], sound: SoundTrack | None
) -> Iterator[Any]:
    """Encode pictures and sound, where there is one, always what comes next."""
    blocks = iter(()) if sound is None else _frames_of_sound(av, sound)
    rate = float(seen.codec_context.framerate)
    time = 0.0
    for number, picture in enumerate(pictures):
        yield from seen.encode(av.VideoFrame.from_ndarray(np.ascontiguousarray(picture), format="rgb24"))
        while time <= number / rate and (frame := next(blocks, None)) is not None:
            time += frame.samples / frame.sample_rate
            yield from sound_stream.encode(frame)
    for frame in blocks:
        yield from sound_stream.encode(frame)
    yield from seen.encode()
    if sound_stream is not None:
        yield from sound_stream.encode()


def _frames_of_sound(av: ModuleType, sound: SoundTrack) -> Iterator[Any]:
    start = 0
    for block in sound.blocks:
        layout = ("mono", "stereo")[sound.n_channels - 1]
        frame = av.AudioFrame.from_ndarray(np.ascontiguousarray(block.T), format="fltp", layout=layout)
        frame.sample_rate, frame.pts, frame.time_base = sound.rate, start, Fraction(1, sound.rate)
        start += len(block)
        yield frame
