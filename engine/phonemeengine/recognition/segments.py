"""Segments of equal phonemes, and the statistics step before them, in which a phoneme stays a minimum time."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.labels.utterance import Label
from phonemeengine.labels.visemes import STANDARD_VISEMES, VisemeSet
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

SUCCESSORS: Mapping[Phoneme, Phoneme] = MappingProxyType(
    {
        Phoneme.SILENCE: Phoneme.U,
        Phoneme.UNIDENTIFIED: Phoneme.O,
        Phoneme.SZ: Phoneme.SZ,
        Phoneme.SCH: Phoneme.I,
        Phoneme.M: Phoneme.O,
        Phoneme.P: Phoneme.O,
        Phoneme.I: Phoneme.O,
        Phoneme.A: Phoneme.M,
        Phoneme.E: Phoneme.O,
        Phoneme.U: Phoneme.U,
        Phoneme.O: Phoneme.U,
    }
)
"""What a frame is likeliest to be where the rules say nothing, by the phoneme that they named last.

Counted on labelled speech by `tools.fit.thesis`, with the thresholds of the preset Thesis: the
class of which the largest share is found there. The rules say nothing mostly where the band of the second formant is
neither strong (a, e) nor weak (u, o, i, m), hence the many o. The entry of unidentified is what is
likeliest after anything.
"""

UNREPLACED: Mapping[Phoneme, Phoneme] = MappingProxyType(dict.fromkeys(Phoneme, Phoneme.UNIDENTIFIED))
"""The table that leaves unidentified frames alone, for recognisers who know what is another sound."""


def frames_held(minimum_hold: float) -> int:
    """Return for how many frames a phoneme stays at least."""
    return max(1, round(minimum_hold / FRAME_PERIOD))


class PhonemeSmoother:
    """Calms a stream of phonemes; looks only back.

    Parameters
    ----------
    minimum_hold : seconds that a phoneme stays at least before another may follow.
    successors : what replaces an unidentified frame, by the phoneme that was identified last.
    hysteresis : a phoneme stays while it falls short of being named by no more than this.
    """

    def __init__(
        self, minimum_hold: float, successors: Mapping[Phoneme, Phoneme] = SUCCESSORS, hysteresis: float = 0.0
    ) -> None:
        self.hysteresis = hysteresis
        self._least = frames_held(minimum_hold)
        self._successors = [int(successors.get(p, p)) for p in Phoneme]
        self._current = self._identified = int(Phoneme.SILENCE)
        self._steady = int(Phoneme.SILENCE)
        self._held = self._least

    def has_change(self, phonemes: UInt8Array) -> bool:
        """Return whether hysteresis has anything to decide about the next phonemes: mostly none changes."""
        return self.hysteresis > 0 and bool((phonemes != self._steady).any())

    def smooth(self, phonemes: UInt8Array, deficits: Float32Array | None = None) -> UInt8Array:
        """Take the next phonemes, shape (n_frames,), and give the calmed ones.

        `deficits` says by how much each phoneme falls short of being named, shape (n_frames, n_phonemes); without
        them there is no hysteresis, which is all the same where the phonemes do not waver.
        """
        if deficits is not None:
            phonemes = self._apply_hysteresis(phonemes.tolist(), (deficits <= self.hysteresis).tolist())
        return self._apply_minimum_hold(phonemes)

    def _apply_hysteresis(self, phonemes: list[int], may_stay: list[list[bool]]) -> UInt8Array:
        steady, out = self._steady, []
        # Hysteresis: the phoneme that stands stays while it is nearly as good as the one that is named, so frames on
        # the border of two do not flicker. It compares with what stood, not with what was shown.
        for raw, stays in zip(phonemes, may_stay, strict=True):
            steady = steady if stays[steady] else raw
            out.append(steady)
        self._steady = steady
        return np.array(out, np.uint8)

    def _apply_minimum_hold(self, phonemes: UInt8Array) -> UInt8Array:
        current, held, identified = self._current, self._held, self._identified
        unidentified = int(Phoneme.UNIDENTIFIED)
        out = []
        # Plain integers and no arrays: each step depends on the one before, and NumPy scalars are several times
        # slower. An unidentified frame becomes what likely follows the last identified one; after a change no other
        # may follow for the minimum duration, however often the wish changes in between.
        for raw in phonemes.tolist():
            identified = identified if raw == unidentified else raw
            wanted = self._successors[identified] if raw == unidentified else raw
            if wanted != current and held >= self._least:
                current, held = wanted, 0
            held += 1
            out.append(current)
        self._current, self._held, self._identified = current, held, identified
        return np.array(out, np.uint8)


# Visemes that do not flicker: one stays while its phoneme does, and as long as no other is far likelier.

MARGIN = 0.2
"""By how much another viseme of the same phoneme must be likelier to follow."""


class VisemeSmoother:
    """Follows a stream of phonemes with the recognised visemes; uses only the past."""

    def __init__(self) -> None:
        self._phoneme = self._viseme = -1

    def follow(
        self, phonemes: UInt8Array, probabilities: Float32Array | None, viseme_set: VisemeSet = STANDARD_VISEMES
    ) -> UInt8Array:
        """Return the visemes of the next phonemes, uint8, shape (n_frames,).

        Parameters
        ----------
        phonemes : codes of `Phoneme`, after all smoothing, shape (n_frames,).
        probabilities : of the visemes of the set, shape (n_frames, n_visemes); None where they are not recognised.
        viseme_set : what they are.
        """
        if probabilities is None:
            return viseme_set.usual_visemes(phonemes)
        # visemes of other phonemes can never win, since probabilities are 0 or more
        allowed = np.where(viseme_set.allowed[phonemes], probabilities, np.float32(-1))
        visemes = []
        for phoneme, viseme, row in zip(phonemes.tolist(), allowed.argmax(axis=1).tolist(), allowed, strict=True):
            # a new phoneme starts anew; within one, the margin is the hysteresis
            if phoneme != self._phoneme or (viseme != self._viseme and row[viseme] > row[self._viseme] + MARGIN):
                self._phoneme, self._viseme = phoneme, viseme
            visemes.append(self._viseme)
        return np.array(visemes, np.uint8)


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
