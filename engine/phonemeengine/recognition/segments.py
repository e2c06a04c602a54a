"""Segments of equal phonemes, as timelines and mouth cues need them."""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.labels.label import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

# How strongly a phoneme is spoken, from the loudness of its frame.

ONE = np.ones((), np.float32)


def intensities_of(levels: Float32Array, low: float, high: float) -> Float32Array:
    """Map peak levels (0..1) to intensities: 0 at `low` dB below full scale, 1 at `high`, linear in dB."""
    gain, slope = line_of(low, high)
    # the greater of level and limit comes before the logarithm, so silence has no logarithm of 0
    intensities: Float32Array = np.minimum(np.log10(np.maximum(levels * gain, ONE)) * slope, ONE)
    return intensities


@lru_cache(maxsize=8)
def line_of(low: float, high: float) -> tuple[Float32Array, Float32Array]:
    """Return what a level is multiplied with, and what its logarithm is, so that 1 is `high` dB below full scale."""
    # level x gain is 1 at `low`, where its logarithm is 0; 20 log10 makes decibels, and 1 / (high - low) the line
    gain, slope = 10 ** (-low / 20), 20 / max(high - low, 1e-6)
    return np.array(gain, np.float32), np.array(slope, np.float32)


SEGMENT_COLUMNS = ("start_s", "end_s", "phoneme", "intensity", "confidence")
"""The columns of a table of segments."""


@dataclass(frozen=True, slots=True)  # ten hours have half a million
class Segment:
    """A segment of one phoneme.

    Attributes
    ----------
    start, end : seconds from the sound's beginning.
    phoneme : what is said.
    intensity : mean intensity, 0..1.
    phone : its symbol in the International Phonetic Alphabet; empty where only the phoneme is known.
    confidence : the mean share of such answers that are right, 0..1; 1 where it was not recognised, None where it is
        not known.
    """

    start: float
    end: float
    phoneme: Phoneme
    intensity: float
    phone: str = ""
    confidence: float | None = 1.0

    def row(self) -> dict[str, Any]:
        """Return it as a row of a table, in seconds to the microsecond."""
        loudness, sure = round(self.intensity, 3), None if self.confidence is None else round(self.confidence, 3)
        values = (round(self.start, 6), round(self.end, 6), self.phoneme.label, loudness, sure)
        return dict(zip(SEGMENT_COLUMNS, values, strict=True))


class SegmentBuilder:
    """Joins equal frames into segments, as the frames come."""

    def __init__(self) -> None:
        self._code, self._phone, self._first, self._frame = -1, "", 0, 0
        self._intensity = self._confidence = 0.0

    def extend(
        self,
        phonemes: UInt8Array,
        intensities: Float32Array,
        phones: Sequence[str] | None = None,
        confidences: Float32Array | None = None,
    ) -> list[Segment]:
        """Take the next frames, all of shape (n_frames,), and give the segments that ended.

        Parameters
        ----------
        phones : what is known of each frame besides its phoneme; segments of one phoneme are parted by them.
        confidences : of each frame, 0..1; 1 where none are given.
        """
        ended = []
        phones = [""] * len(phonemes) if phones is None else phones
        sure = [1.0] * len(phonemes) if confidences is None else confidences.tolist()
        frames = zip(phonemes.tolist(), phones, intensities.tolist(), sure, strict=True)
        for code, phone, intensity, confidence in frames:
            if (code != self._code or phone != self._phone) and self._frame > self._first:
                ended.append(self._segment(self._frame * FRAME_PERIOD))
                self._first, self._intensity, self._confidence = self._frame, 0.0, 0.0
            self._code, self._phone = code, phone
            self._intensity += intensity
            self._confidence += confidence
            self._frame += 1
        return ended

    def finish(self, duration: float) -> list[Segment]:
        """Return the segment that is still open, which ends where the sound does, at `duration` seconds."""
        return [self._segment(duration)] if self._frame > self._first else []

    def _segment(self, end: float) -> Segment:
        # running sums, not lists of frames: a sound of ten hours is joined in constant memory
        n = self._frame - self._first
        sure = None if math.isnan(self._confidence) else self._confidence / n
        return Segment(self._first * FRAME_PERIOD, end, Phoneme(self._code), self._intensity / n, self._phone, sure)


Frames = tuple[UInt8Array, Float32Array] | tuple[UInt8Array, Float32Array, Float32Array]
"""Phonemes, intensities and maybe confidences of consecutive frames, each of shape (n_frames,)."""


def segments_of(blocks: Iterable[Frames], duration: float) -> Iterator[Segment]:
    """Join equal frames into segments that cover a sound from 0 to its end without gaps.

    Parameters
    ----------
    blocks : consecutive blocks of frames.
    duration : seconds of the whole sound, where the last one ends.
    """
    builder = SegmentBuilder()
    for phonemes, intensities, *confidences in blocks:
        yield from builder.extend(phonemes, intensities, None, *confidences)
    yield from builder.finish(duration)


def labels_of_segments(segments: Iterable[Segment]) -> tuple[Label, ...]:
    """Return segments of recognised phonemes, in order of time, as labels."""
    return tuple(Label(s.start, s.end, s.phoneme.label, s.phoneme) for s in segments)


def count_changes(phonemes: UInt8Array) -> int:
    """Count how often the phoneme is another than in the frame before."""
    return int(np.count_nonzero(phonemes[1:] != phonemes[:-1]))
