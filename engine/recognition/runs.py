"""Stretches of equal phonemes, as time lines and mouth cues need them."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from engine.phonemes import Phoneme
from engine.settings import FRAME_PERIOD


@dataclass(frozen=True)
class Run:
    """A stretch of one phoneme: seconds from the sound's beginning, and its mean intensity 0..1."""

    start: float
    end: float
    phoneme: Phoneme
    intensity: float


def runs_of(blocks: Iterable[tuple[NDArray[np.uint8], NDArray[np.float32]]], duration: float) -> Iterator[Run]:
    """Join equal frames into runs that cover a sound from 0 to its end without gaps.

    Parameters
    ----------
    blocks : phonemes and intensities of consecutive blocks of frames, each of shape (n_frames,).
    duration : seconds of the whole sound, where the last run ends.
    """
    current, first, frame, total = -1, 0, 0, 0.0
    for phonemes, intensities in blocks:
        for code, intensity in zip(phonemes.tolist(), intensities.tolist(), strict=True):
            if code != current and frame > first:
                yield _run(first, frame, current, total)
                first, total = frame, 0.0
            current = code
            total += intensity
            frame += 1
    if frame > first:
        yield Run(first * FRAME_PERIOD, duration, Phoneme(current), total / (frame - first))


def _run(first: int, last: int, code: int, total: float) -> Run:
    return Run(first * FRAME_PERIOD, last * FRAME_PERIOD, Phoneme(code), total / (last - first))
