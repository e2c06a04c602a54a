"""Files that a user may open by mistake: each function writes one into a folder and returns its path."""

import struct
from collections.abc import Callable
from pathlib import Path

import numpy as np
import soundfile

Writer = Callable[[Path], Path]

RATE = 44_100
HUGE = 0xFFFF_FFFF
FMT = struct.pack("<HHIIHH", 1, 1, RATE, 2 * RATE, 2, 16)


def a_sound(seconds: float = 1.0, rate: int = RATE) -> np.ndarray:
    """Noise, which no codec can make much smaller."""
    return (0.1 * np.random.default_rng(0).standard_normal(round(seconds * rate))).astype(np.float32)


def chunk(name: bytes, content: bytes, size: int | None = None, order: str = "<") -> bytes:
    """A chunk whose header claims `size` bytes, by default the truth."""
    return (
        name + struct.pack(order + "I", len(content) if size is None else size) + content + b"\0" * (len(content) % 2)
    )


def riff(*chunks: bytes, size: int | None = None, magic: bytes = b"RIFF", kind: bytes = b"WAVE") -> bytes:
    """A file of chunks whose header claims `size` bytes, by default the truth."""
    content = kind + b"".join(chunks)
    order = ">" if magic in {b"FORM", b"RIFX"} else "<"
    return magic + struct.pack(order + "I", len(content) if size is None else size) + content


def _bytes(name: str, content: bytes) -> Writer:
    def write(folder: Path) -> Path:
        path = folder / name
        path.write_bytes(content)
        return path

    return write


def _cut(name: str, share: float = 0.6, **options: str) -> Writer:
    """A sound of which only the first part reached the disk."""

    def write(folder: Path) -> Path:
        path = folder / name
        soundfile.write(path, a_sound(3.0), RATE, **options)
        content = path.read_bytes()
        path.write_bytes(content[: int(share * len(content))])
        return path

    return write


def _patched(name: str, old: Callable[[bytes], slice], new: bytes, **options: str) -> Writer:
    """A sound with some bytes of its header replaced."""

    def write(folder: Path) -> Path:
        path = folder / name
        soundfile.write(path, a_sound(), RATE, **options)
        content = bytearray(path.read_bytes())
        content[old(bytes(content))] = new
        path.write_bytes(content)
        return path

    return write


def _after(name: bytes, n: int) -> Callable[[bytes], slice]:
    return lambda content: slice(content.index(name) + len(name), content.index(name) + len(name) + n)


def _with_sample(name: str, value: float) -> Writer:
    def write(folder: Path) -> Path:
        samples = a_sound()
        samples[30_000] = value
        path = folder / name
        soundfile.write(path, samples, RATE, subtype="FLOAT")
        return path

    return write


def _cut_opus(folder: Path) -> Path:
    path = folder / "truncated.opus"
    soundfile.write(path, a_sound(3.0, 48_000), 48_000, format="OGG", subtype="OPUS")
    content = path.read_bytes()
    path.write_bytes(content[: len(content) // 2])
    return path


def _missing(folder: Path) -> Path:
    return folder / "missing.wav"


def _directory(folder: Path) -> Path:
    path = folder / "directory.wav"
    path.mkdir()
    return path


def _zero_length(folder: Path) -> Path:
    path = folder / "zero_length.wav"
    soundfile.write(path, a_sound(0.0), RATE)
    return path


def _one_hertz(folder: Path) -> Path:
    path = folder / "one_hertz.wav"
    soundfile.write(path, a_sound(), 1)
    return path


def _a_megahertz(folder: Path) -> Path:
    path = folder / "a_megahertz.wav"
    soundfile.write(path, a_sound(), 1_000_000)
    return path


SAMPLES = a_sound(0.1).tobytes()
LIST_THAT_HANGS = chunk(b"LIST", b"INFO" + chunk(b"XXXX", b"abcdabcdabcd", 0xFFFF_FFF8))

HOSTILE: dict[str, Writer] = {
    "list_that_hangs": _bytes(
        "list_that_hangs.wav", riff(chunk(b"fmt ", FMT), LIST_THAT_HANGS, chunk(b"data", SAMPLES))
    ),
    "list_that_hangs_behind": _bytes(
        "behind.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES), LIST_THAT_HANGS)
    ),
    "list_that_hangs_after_id3": _bytes(
        "tagged.wav", b"ID3\3\0\0\0\0\0\4abcd" + riff(chunk(b"fmt ", FMT), LIST_THAT_HANGS, chunk(b"data", SAMPLES))
    ),
    "endless_chunks": _bytes("endless_chunks.wav", riff(chunk(b"fmt ", FMT), chunk(b"junk", b"") * 200_000)),
    "endless_list": _bytes(
        "endless_list.wav", riff(chunk(b"fmt ", FMT), chunk(b"LIST", b"INFO" + chunk(b"junk", b"") * 200_000))
    ),
    "fmt_wraps": _bytes("fmt_wraps.wav", riff(chunk(b"fmt ", FMT, HUGE), chunk(b"data", SAMPLES))),
}
"""RIFF files made to keep a reader busy for ever."""

LYING: dict[str, Writer] = {
    "rifx_size_lies": _bytes("rifx.wav", riff(chunk(b"fmt ", FMT, 1 << 20, ">"), magic=b"RIFX")),
    "no_data_chunk": _bytes("no_data_chunk.wav", riff(chunk(b"fmt ", FMT))),
    "only_a_magic": _bytes("only_a_magic.wav", b"RIFF"),
    "header_cut_off": _bytes("header_cut_off.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES))[:30]),
    "rf64_without_ds64": _bytes(
        "rf64.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES), size=HUGE, magic=b"RF64")
    ),
    "au_lies": _patched("au_lies.au", lambda content: slice(8, 12), b"\x7f\0\0\0"),
    "truncated_au": _cut("truncated.au"),
    "truncated_ogg": _cut("truncated.ogg"),
    "truncated_opus": _cut_opus,
}
"""Files whose header claims more than there is, or nothing."""

NEVER_FINISHED: dict[str, Writer] = {
    "riff_size_too_small": _bytes("too_small.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES), size=100)),
    "riff_size_zero": _bytes("zero.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES), size=0)),
    "riff_size_of_the_header": _bytes("header.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES), size=36)),
    "streamed_zero": _bytes("streamed_zero.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES, 0), size=36)),
    "streamed_all_zero": _bytes(
        "streamed_all_zero.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES, 0), size=0)
    ),
    "data_size_zero": _bytes("data_zero.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES, 0), size=HUGE)),
    "streamed_largest": _bytes(
        "largest.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES, 0x7FFF_F000), size=0x7FFF_F024)
    ),
    "rifx_zero": _patched("rifx_zero.wav", lambda content: slice(40, 44), bytes(4), endian="BIG"),
    "rf64_zero": _patched("rf64_zero.rf64", _after(b"ds64\x1c\0\0\0", 16), bytes(16), format="RF64"),
    "aiff_zero": _patched("aiff_zero.aiff", _after(b"SSND", 4), bytes(4)),
    "aiff_form_zero": _patched("aiff_form_zero.aiff", _after(b"FORM", 4), bytes(4)),
    "w64_zero": _patched("w64_zero.w64", lambda content: slice(16, 24), bytes(8)),
    "flac_of_unknown_length": _patched("unknown_length.flac", lambda content: slice(21, 26), b"\xf0\0\0\0\0"),
}
"""Files whose sizes were to be written at the end and never were; all of their sound is there."""

WITH_A_NOTE = riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES), chunk(b"note", b"x" * 400))

CUT_OFF: dict[str, Writer] = {
    "data_size_lies": _bytes("data_size_lies.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES, 1 << 30))),
    "riff_size_lies": _bytes("riff_size_lies.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES), size=1 << 30)),
    "streamed_all_ones": _bytes("streamed.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES, HUGE), size=HUGE)),
    "rf64_lies": _patched("rf64_lies.rf64", _after(b"ds64\x1c\0\0\0", 16), b"\x7f" * 16, format="RF64"),
    "aiff_size_lies": _patched("aiff_size_lies.aiff", _after(b"SSND", 4), b"\x7f\0\0\0"),
    "aiff_form_lies": _patched("aiff_form_lies.aiff", _after(b"FORM", 4), b"\x7f\0\0\0"),
    "w64_lies": _patched("w64_lies.w64", lambda content: slice(16, 24), b"\x7f" * 8),
    "caf_lies": _patched("caf_lies.caf", _after(b"data", 8), b"\x7f" * 8),
    "truncated_wav": _cut("truncated.wav"),
    "truncated_aiff": _cut("truncated.aiff"),
    "truncated_w64": _cut("truncated.w64"),
    "truncated_caf": _cut("truncated.caf"),
    "cut_in_a_chunk_behind": _bytes("cut_behind.wav", WITH_A_NOTE[:-99]),
    "cut_in_the_header_behind": _bytes("cut_header.wav", WITH_A_NOTE[:-405]),
    "cut_and_tagged": _bytes(
        "tagged.wav",
        b"ID3\3\0\0\0\0\0\4abcd" + riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES + SAMPLES))[: -len(SAMPLES)],
    ),
    "cut_rf64": _cut("cut.rf64", format="RF64"),
    "cut_rifx": _cut("cut_rifx.wav", endian="BIG"),
    "cut_floats": _cut("cut_floats.wav", subtype="FLOAT"),
    "cut_24_bits": _cut("cut_24_bits.wav", format="WAVEX", subtype="PCM_24"),
    "cut_ulaw": _cut("cut_ulaw.wav", subtype="ULAW"),
    "cut_adpcm": _cut("cut_adpcm.wav", subtype="IMA_ADPCM"),
}
"""Files that end before their header says, and are read as far as they go."""

DAMAGED: dict[str, Writer] = {
    "truncated_flac": _cut("truncated.flac"),
    "truncated_mp3": _cut("truncated.mp3"),
    "not_a_number": _with_sample("not_a_number.wav", np.nan),
    "infinite": _with_sample("infinite.wav", -np.inf),
}
"""Files that open, and show what is wrong with them when they are read."""

BAD_FILES: dict[str, Writer] = {
    "missing": _missing,
    "directory": _directory,
    "empty": _bytes("empty.wav", b""),
    "not_a_sound": _bytes("not_a_sound.wav", b"Dear diary, today I recorded nothing.\n" * 50),
    "bytes_called_raw": _bytes("bytes.raw", SAMPLES),
    "bytes_called_au": _bytes("bytes.au", SAMPLES),
    "name_with_a_line_break": _bytes("line\nbreak.wav", b"no sound"),
    "zero_length": _zero_length,
    "one_hertz": _one_hertz,
    "a_megahertz": _a_megahertz,
    **HOSTILE,
    **LYING,
    **DAMAGED,
}
"""Every file that must be refused with one sentence."""


def _odd(name: str, samples: np.ndarray, rate: int = RATE) -> Writer:
    def write(folder: Path) -> Path:
        path = folder / name
        soundfile.write(path, samples, rate)
        return path

    return write


ODD_FILES: dict[str, Writer] = {
    "one_sample": _odd("one_sample.wav", a_sound()[:1]),
    "two_hundred_channels": _odd("two_hundred_channels.wav", np.repeat(a_sound(0.5)[:, np.newaxis], 200, axis=1)),
    "fast": _odd("fast.wav", a_sound(0.5, 768_000), 768_000),
    "slow": _odd("slow.wav", a_sound(2.0, 1_000), 1_000),
    "trailing_junk": _bytes("junk.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES)) + LIST_THAT_HANGS),
    "pad_byte_missing": _bytes(
        "pad.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES), chunk(b"note", b"odd"))[:-1]
    ),
    "filled_with_zeros": _bytes("zeros.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES), bytes(400))),
    "size_counts_its_header": _bytes(
        "counted.wav", riff(chunk(b"fmt ", FMT), chunk(b"data", SAMPLES), size=len(SAMPLES) + 44)
    ),
    "texts_without_padding": _bytes(
        "texts.wav",
        riff(
            chunk(b"fmt ", FMT),
            chunk(b"LIST", b"INFO" + b"INAM\3\0\0\0odd" + b"IART\1\0\0\0x"),
            chunk(b"data", SAMPLES),
        ),
    ),
}
"""Unusual files that are sounds all the same, and must be read."""
