"""What was said in one sound: all that a mouth needs to know of an analysis."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.features.front_end import F0
from phonemeengine.recognition.segments import Segment, SegmentBuilder
from phonemeengine.settings import FRAME_PERIOD

NOTHING = np.zeros(0, np.float32)


@dataclass(frozen=True, eq=False)
class Transcript:
    """What was said in a sound.

    Attributes
    ----------
    name : of the sound's file, for people.
    duration : seconds.
    runs : stretches of equal phonemes, without gaps from 0 to the end.
    intensities : float32, shape (n_frames,): 0..1, a frame every 10 ms.
    pitches : float32, shape (n_frames,): fundamental frequency, Hz; 0 where there is none, or it was not measured.
    path : the sound's file, where it is known.
    """

    name: str
    duration: float
    runs: tuple[Segment, ...] = ()
    intensities: Float32Array = field(default_factory=lambda: NOTHING)
    pitches: Float32Array = field(default_factory=lambda: NOTHING)
    path: Path | None = None

    @property
    def times(self) -> Float64Array:
        """When the frames begin, seconds, shape (n_frames,)."""
        return np.arange(len(self.intensities), dtype=float) * FRAME_PERIOD


def transcript_of(analyses: Iterable[Analysis], name: str, duration: float, path: Path | None = None) -> Transcript:
    """Collect what was said from the consecutive analyses of a sound of `duration` seconds; `path` is its file."""
    joiner, runs = SegmentBuilder(), []
    loud, pitches = [NOTHING], [NOTHING]
    for analysis in analyses:
        runs += joiner.extend(analysis.phonemes, analysis.intensities)
        loud.append(analysis.intensities)
        pitches.append(np.array(analysis.features.values[:, F0], np.float32))
    runs += joiner.finish(duration)
    return Transcript(name, duration, tuple(runs), np.concatenate(loud), np.concatenate(pitches), path)
