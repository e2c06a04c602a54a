"""What was said in one sound: all that a mouth needs to know of an analysis."""

import os
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.features.front_end import F0
from phonemeengine.labels.utterance import Phone, Utterance
from phonemeengine.phonemes import Phoneme
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


def transcript_of_utterance(
    utterance: Utterance,
    intensities: Float32Array,
    pitches: Float32Array,
    name: str,
    path: str | os.PathLike[str] | None = None,
) -> Transcript:
    """Return what is known of a sound as a mouth needs it; what lies between phones is silence.

    Parameters
    ----------
    utterance : what is said, and when.
    intensities, pitches : of the sound's frames; see `Transcript`.
    name, path : of the sound's file, for people; and the file, where there is one.
    """
    runs, at = [], 0.0
    end = Phone(utterance.duration, utterance.duration, "", Phoneme.SILENCE)
    for phone in (*utterance.phones, end):
        for first, last, phoneme in ((at, phone.start, Phoneme.SILENCE), (phone.start, phone.end, phone.phoneme)):
            if last > first:
                part = intensities[round(first / FRAME_PERIOD) : max(round(last / FRAME_PERIOD), 1)]
                loud = 0.0 if phoneme is Phoneme.SILENCE or not len(part) else float(part.mean())
                runs.append(Segment(first, last, phoneme, loud))
        at = phone.end
    return Transcript(
        name, utterance.duration, tuple(runs), intensities, pitches, None if path is None else Path(path)
    )
