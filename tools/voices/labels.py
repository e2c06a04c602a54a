"""Labels: gapless intervals of one phone each, with affricates cut into closure and friction."""

from typing import NamedTuple

import numpy as np

from tools.voices.classes import AFFRICATE, CORE, SCH, SIL, SZ, Phone, X

SHORTEST = 1e-4  # s, what is shorter is no label
FRAME = 0.002  # s, of the search for an affricate's friction
FRICTION_ABOVE = 2500.0  # Hz
DROP = 8.0  # dB below the loudest frame, where friction begins


class Segment(NamedTuple):
    """A phone and its time in seconds."""

    start: float
    end: float
    phone: str


class Label(NamedTuple):
    """One line of a label file."""

    start: float
    end: float
    phone: str
    class_name: str
    certainty: str


def segments_from_ends(pairs: list[tuple[str, float]]) -> list[Segment]:
    """Segments from phones and the times at which they end; the first begins at 0."""
    starts = [0.0, *(end for _, end in pairs[:-1])]
    return [Segment(start, end, phone) for start, (phone, end) in zip(starts, pairs, strict=True)]


def labels_of(
    segments: list[Segment], table: dict[str, Phone], sound: np.ndarray, sample_rate: int, shift: float = 0.0
) -> list[Label]:
    """Labels without gaps from 0 to the sound's end.

    Parameters
    ----------
    segments : in order of time, each beginning where the one before it ended.
    sound : (n,) samples, at which affricates are cut.
    shift : seconds by which every inner boundary is moved, the measured error of a voice.
    """
    duration = len(sound) / sample_rate
    labels: list[Label] = []
    for segment in _spanning(segments, duration, shift):
        labels += _labels_of_segment(segment, table[segment.phone], sound, sample_rate)
    if labels and labels[-1].end < duration - SHORTEST:
        labels.append(Label(labels[-1].end, duration, "pau", SIL, CORE))
    return labels


def _spanning(segments: list[Segment], duration: float, shift: float) -> list[Segment]:
    """The segments moved by the shift, cut to the sound; the first begins at 0."""
    moved, start = [], 0.0
    for segment in segments:
        end = min(duration, segment.end + shift)
        if end - start > SHORTEST:
            moved.append(Segment(start, end, segment.phone))
            start = end
    return moved


def _labels_of_segment(segment: Segment, phone: Phone, sound: np.ndarray, sample_rate: int) -> list[Label]:
    start, end, name = segment
    if phone.certainty != AFFRICATE or phone.class_name not in (SZ, SCH):
        return [Label(start, end, name, phone.class_name, phone.certainty)]
    cut = friction_start(sound, sample_rate, start, end)
    return [Label(start, cut, name + "_cl", X, AFFRICATE), Label(cut, end, name + "_fr", phone.class_name, AFFRICATE)]


def friction_start(sound: np.ndarray, sample_rate: int, start: float, end: float) -> float:
    """Time in seconds at which an affricate becomes friction, or 45 % of it where this is not clear.

    It is the first 2 ms frame whose energy above 2.5 kHz comes within 8 dB of the loudest one. A result outside 15
    to 85 % of the segment counts as not clear.
    """
    unclear = start + 0.45 * (end - start)
    times, level = _high_level(sound, sample_rate, start, end)
    inside = (times >= start) & (times < end)
    if inside.sum() < 5:
        return unclear
    onset = float(times[np.flatnonzero(inside & (level > level[inside].max() - DROP))[0]])
    return onset if 0.15 <= (onset - start) / (end - start) <= 0.85 else unclear


def _high_level(sound: np.ndarray, sample_rate: int, start: float, end: float) -> tuple[np.ndarray, np.ndarray]:
    """Times and levels in dB, frame by frame, of the sound above 2.5 kHz."""
    first = max(0, int((start - 0.02) * sample_rate))
    part = sound[first : int(end * sample_rate)]
    size = int(FRAME * sample_rate)
    n_frames = len(part) // size
    if n_frames < 10:
        return np.empty(0), np.empty(0)
    from scipy.signal import butter, sosfilt  # it takes a second, and all read this file who test the voices

    high = sosfilt(butter(4, FRICTION_ABOVE / (sample_rate / 2), "high", output="sos"), part)
    power = (high[: n_frames * size].reshape(n_frames, size) ** 2).mean(axis=1)
    return (first + np.arange(n_frames) * size) / sample_rate, 10 * np.log10(power + 1e-12)
