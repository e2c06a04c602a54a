"""The marker voice: a copy of an HTS voice that marks which phone it speaks, in every frame.

RHVoice and Open JTalk give no phone times. A voice file holds trees that say, of a phone in its context, how long it
lasts and how it sounds. The marker keeps the durations and replaces the sounds: a steady pulse train whose loudness
and tilt (mel cepstrum 0 and 1) are a code of the phone. So the phones of the original's sound, of the same text, can
be read off frame by frame, and the boundaries found are those which the synthesizer itself used.
"""

import re
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tools.voices.labels import Segment

LEVELS, TILTS = 8, 7
CALM = 1e-4  # variance of every value, as no value moves
CLOSE = 0.6  # how far a frame may lie from its phone's code: 1 is 1 dB, or 0.05 of the tilt's measure


class Geometry(NamedTuple):
    """A voice's rate in hertz, its frame and the marker's pulse period in samples, and its mel cepstrum's alpha.

    A frame must hold whole periods.
    """

    sample_rate: int
    frame: int
    period: int
    warping: float


RHVOICE = Geometry(sample_rate=24000, frame=120, period=40, warping=0.466)


def code_of(index: int) -> tuple[float, float]:
    """Mel cepstrum 0 and 1 that stand for a phone's number; there is room for 56 phones."""
    if index >= LEVELS * TILTS:
        raise ValueError(f"a marker voice has room for {LEVELS * TILTS} phones, got phone number {index}")
    return 7.6 - 0.6 * (index % LEVELS), -1.2 + 0.4 * (index // LEVELS)


def marker_file(voice: bytes, phones: Sequence[str], geometry: Geometry = RHVOICE) -> bytes:
    """The voice file of the marker, out of that of the voice.

    Its third stream is the noise in the excitation (BAP, band levels in dB) or a filter of the pulses (LPF, taps).
    """
    head, data = voice.split(b"[DATA]\n", 1)
    text = head.decode()
    sizes = {stream: int(size) for stream, size in re.findall(r"VECTOR_LENGTH\[(\w+)\]:(\d+)", text)}
    parts = {name: data[first : last + 1] for name, first, last in _positions(text) if name.startswith("DURATION")}
    parts |= {f"STREAM_WIN[{stream}]": b"1 1.0\n" for stream in sizes}
    codes = [_steady(code_of(index), sizes["MCP"]) for index in range(len(phones))]
    parts["STREAM_PDF[MCP]"] = _distributions([_steady((0.0,), sizes["MCP"]), *codes])
    parts["STREAM_PDF[LF0]"] = _distributions([[np.log(geometry.sample_rate / geometry.period), CALM, 1.0]] * 2)
    (third,) = set(sizes) - {"MCP", "LF0"}
    pure = [-60.0] * sizes[third] if third == "BAP" else np.eye(sizes[third])[sizes[third] // 2]
    parts[f"STREAM_PDF[{third}]"] = _distributions([_steady(pure, sizes[third])] * 2)
    parts |= {f"STREAM_TREE[{s}]": _tree(s.lower(), phones if s == "MCP" else phones[:1]) for s in sizes}
    still = re.sub(r"(NUM_WINDOWS\[\w+\]):\d", r"\1:1", text.split("[POSITION]")[0])
    return _joined(re.sub(r"(USE_GV\[\w+\]):\d", r"\1:0", still), parts)


def _positions(head: str) -> list[tuple[str, int, int]]:
    return [
        (name, int(first), int(last)) for name, first, last in re.findall(r"^(\S+):(\d+)-(\d+)$", head, re.MULTILINE)
    ]


def _steady(values: Sequence[float], size: int) -> list[float]:
    """Means (the values, then zeros) and variances of one distribution."""
    return [*values, *[0.0] * (size - len(values)), *[CALM] * size]


def _distributions(rows: Sequence[Sequence[float]]) -> bytes:
    """The same distributions for each of five states."""
    packed = b"".join(struct.pack(f"<{len(row)}f", *row) for row in rows)
    return struct.pack("<5i", *[len(rows)] * 5) + packed * 5


def _tree(stream: str, phones: Sequence[str]) -> bytes:
    """Five trees, alike, that ask for one phone after the other; leaf 1 is the answer to none."""
    lines = [f'QS is=={phone} {{ "*-{phone}+*" }}' for phone in phones]
    for state in range(2, 7):
        lines += [f"{{*}}[{state}]", "{"]
        for index, phone in enumerate(phones):
            other = -(index + 1) if index + 1 < len(phones) else f'"{stream}_s{state}_1"'
            lines.append(f' {-index} is=={phone} {other} "{stream}_s{state}_{index + 2}"')
        lines += ["}", ""]
    return "\n".join([*lines, ""]).encode()


def _joined(head: str, parts: dict[str, bytes]) -> bytes:
    lines, position = [head + "[POSITION]"], 0
    for name, part in parts.items():
        lines.append(f"{name}:{position}-{position + len(part) - 1}")
        position += len(part)
    return "\n".join([*lines, "[DATA]\n"]).encode() + b"".join(parts.values())


def phones_of(language: Path) -> list[str]:
    """Names of a language's phones, from its folder in the data of RHVoice."""
    return re.findall(r'<phoneme name="([^"]+)"', (language / "phonemes.xml").read_text(encoding="utf-8"))


def segments_marked(
    sound: np.ndarray, phones: Sequence[str], first: str = "pau", geometry: Geometry = RHVOICE
) -> list[Segment]:
    """Phones and times from the marker's sound, spoken at the voice's own pitch.

    A phone begins with the frame in which the sound moves towards its code. The first phone's level
    sets the scale.

    Parameters
    ----------
    sound : (n,) samples, -32768..32767.
    first : the phone that every utterance begins with.

    Raises
    ------
    ValueError
        If an interval fits no phone.
    """
    nearest, distance = _nearest(sound, phones, first, geometry)
    settled = _settled(nearest, distance < CLOSE)
    changes = np.flatnonzero(np.diff(nearest[settled], prepend=-1))
    starts = [0, *(int(settled[change - 1]) + 1 for change in changes[1:])]
    names = [phones[nearest[settled[change]]] for change in changes]
    ends = [*starts[1:], len(nearest)]
    if np.max(np.diff(settled), initial=0) > 3:
        raise ValueError("a marker's sound has stretches that fit no phone: the voice can't be labelled")
    seconds = geometry.frame / geometry.sample_rate
    return [Segment(a * seconds, b * seconds, name) for a, b, name in zip(starts, ends, names, strict=True)]


def _settled(nearest: np.ndarray, close: np.ndarray) -> np.ndarray:
    """Numbers of the frames that lie close to a code together with a neighbour: a passing frame may hit one, too."""
    same = (nearest[1:] == nearest[:-1]) & close[1:] & close[:-1]
    return np.flatnonzero(np.append(same, False) | np.insert(same, 0, False))


def _nearest(
    sound: np.ndarray, phones: Sequence[str], first: str, geometry: Geometry
) -> tuple[np.ndarray, np.ndarray]:
    """Of each frame: number of the phone with the nearest code, and the distance to it."""
    frames = sound[: len(sound) // geometry.frame * geometry.frame].astype(float).reshape(-1, geometry.frame)
    measured = _measures(frames)
    codes = _measures(np.array([pulses(*code_of(index), geometry) for index in range(len(phones))]))
    measured[:, 0] += codes[list(phones).index(first), 0] - measured[2, 0]
    distances = np.abs((measured[:, None] - codes[None]) / (1.0, 0.05)).max(axis=2)
    return distances.argmin(axis=1), distances.min(axis=1)


def _measures(frames: np.ndarray) -> np.ndarray:
    """Level in dB and tilt (correlation of neighbouring samples, -1..1) of each frame: (n_frames, 2).

    The frames hold whole periods, so the last sample's neighbour is the first.
    """
    power = (frames**2).mean(axis=1) + 1e-9
    return np.stack([10 * np.log10(power), (frames * np.roll(frames, 1, axis=1)).mean(axis=1) / power], axis=1)


def pulses(level: float, tilt: float, geometry: Geometry) -> np.ndarray:
    """One frame of the pulse train through the filter of this mel cepstrum; its scale is not the synthesizer's."""
    frequency = 2 * np.pi * np.arange(geometry.frame // 2 + 1) / geometry.frame
    bend = np.arctan2(geometry.warping * np.sin(frequency), 1 - geometry.warping * np.cos(frequency))
    spectrum = np.exp(level + tilt * np.exp(-1j * (frequency + 2 * bend)))
    spectrum[np.arange(len(spectrum)) % (geometry.frame // geometry.period) != 0] = 0
    return np.fft.irfft(spectrum, geometry.frame)
