"""What was said in one sound: all that a mouth needs to know of it, recognised or known beforehand."""

import os
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import accumulate, pairwise
from pathlib import Path

import numpy as np

from phonemeengine.alignment.align import align_analyses
from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array, Float64Array, ShortRepr
from phonemeengine.features.feeling import NO_FEELINGS, FeelingEstimator, FeltFrames
from phonemeengine.features.front_end import F0
from phonemeengine.labels.phone_sets import ARTICULATIONS, CLOSURE, letters_of, phone_classes_in
from phonemeengine.labels.utterance import UNKNOWN_WORD, Phone, Utterance, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import Segment, SegmentBuilder
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.text.pronunciation import ScriptWord

NOTHING = np.zeros(0, np.float32)
NUCLEUS = 0.6
"""Share of a diphthong that its first vowel lasts."""

Stretch = tuple[float, float, Phoneme, str]
"""Start and end, seconds; what is said, and its phone."""


@dataclass(frozen=True, eq=False, repr=False)
class Transcript(ShortRepr):
    """What was said in a sound.

    Attributes
    ----------
    name : of the sound's file, for people.
    duration : seconds.
    runs : segments of equal phonemes, or of phones where these are known, without gaps from 0 to the end.
    intensities : float32, shape (n_frames,): 0..1, a frame every 10 ms.
    pitches : float32, shape (n_frames,): fundamental frequency, Hz; 0 where there is none, or it was not measured.
    path : the sound's file, where it is known.
    utterance : its words, syllables and phones with their times, where they are known.
    feelings : how the voice sounds in the frames, see `FeelingEstimator`; none where that was not asked for.
    """

    name: str
    duration: float
    runs: tuple[Segment, ...] = ()
    intensities: Float32Array = field(default_factory=lambda: NOTHING)
    pitches: Float32Array = field(default_factory=lambda: NOTHING)
    path: Path | None = None
    utterance: Utterance | None = None
    feelings: FeltFrames = field(default_factory=lambda: NO_FEELINGS)

    @property
    def words(self) -> tuple[Word, ...]:
        """The words that have a text, in order of time; not those that the script lacks."""
        words = self.utterance.words if self.utterance else ()
        return tuple(word for word in words if word.text not in {"", UNKNOWN_WORD})

    @property
    def times(self) -> Float64Array:
        """When the frames begin, seconds, shape (n_frames,)."""
        return np.arange(len(self.intensities), dtype=float) * FRAME_PERIOD

    def run_at(self, time: float) -> Segment | None:
        """Return what is said at a time, seconds; None after the end."""
        k = bisect_right(self._ends, time)
        return self.runs[k] if k < len(self.runs) else None

    @cached_property
    def _ends(self) -> list[float]:
        return [run.end for run in self.runs]


class Prosody:
    """How loud and high a sound is, from its consecutive analyses, of which nothing else is kept.

    Attributes
    ----------
    first : the number of the first frame that is not forgotten.

    Parameters
    ----------
    felt : whether the feeling in the voice is estimated, too.
    """

    def __init__(self, *, felt: bool = False) -> None:
        self.first = 0
        self._feeling = FeelingEstimator() if felt else None
        self._feelings = [NO_FEELINGS]
        self._intensities, self._pitches = [NOTHING], [NOTHING]

    def add(self, analysis: Analysis) -> None:
        """Take the next one."""
        self._intensities.append(analysis.intensities)
        self._pitches.append(np.array(analysis.features.values[:, F0], np.float32))
        if self._feeling is not None:
            self._feelings.append(self._feeling.follow(analysis.frames.windows))

    def forget(self, frame: int) -> None:
        """Forget all frames before one."""
        n = max(0, frame - self.first)
        self._intensities, self._pitches = [self.intensities[n:]], [self.pitches[n:]]
        self._feelings = [self.feelings[n:]]
        self.first += n

    @property
    def intensities(self) -> Float32Array:
        """Float32, shape (n_frames,); see `Transcript`."""
        return np.concatenate(self._intensities)

    @property
    def pitches(self) -> Float32Array:
        """Float32, shape (n_frames,); see `Transcript`."""
        return np.concatenate(self._pitches)

    @property
    def feelings(self) -> FeltFrames:
        """Float32, shape (n_frames, 4), or no frame; see `Transcript`."""
        return np.concatenate(self._feelings)


def transcript_of(
    analyses: Iterable[Analysis], name: str, duration: float, path: Path | None = None, *, felt: bool = False
) -> Transcript:
    """Collect what was said from the consecutive analyses of a sound of `duration` seconds; `path` is its file.

    With `felt` the feeling in the voice is estimated, too.
    """
    joiner, runs, prosody = SegmentBuilder(), [], Prosody(felt=felt)
    for analysis in analyses:
        runs += joiner.extend(analysis.phonemes, analysis.intensities, analysis.viseme_phones, analysis.confidences)
        prosody.add(analysis)
    runs += joiner.finish(duration)
    loud, high, feelings = prosody.intensities, prosody.pitches, prosody.feelings
    return Transcript(name, duration, tuple(runs), loud, high, path, feelings=feelings)


def transcript_of_utterance(
    utterance: Utterance,
    intensities: Float32Array,
    pitches: Float32Array,
    name: str,
    path: str | os.PathLike[str] | None = None,
    feelings: FeltFrames = NO_FEELINGS,
) -> Transcript:
    """Return what is known of a sound as a mouth needs it.

    What lies between phones is silence. A phone that is made of two sounds, such as a diphthong, is one after the
    other.

    Parameters
    ----------
    utterance : what is said, and when.
    intensities, pitches : of the sound's frames; see `Transcript`.
    name, path : of the sound's file, for people; and the file, where there is one.
    feelings : of the sound's frames, where they were estimated.
    """
    runs = tuple(
        Segment(start, end, phoneme, _loudness(intensities, start, end), phone)
        for start, end, phoneme, phone in _stretches(utterance)
        if end > start
    )
    place = None if path is None else Path(path)
    return Transcript(name, utterance.duration, runs, intensities, pitches, place, utterance, feelings)


def _stretches(utterance: Utterance) -> Iterator[Stretch]:
    at = 0.0
    for phone in utterance.phones:
        start, end = max(phone.start, at), min(max(phone.end, at), utterance.duration)
        yield at, start, Phoneme.SILENCE, ""
        yield from _sounds_of(phone, start, end)
        at = end
    yield at, utterance.duration, Phoneme.SILENCE, ""


def _sounds_of(phone: Phone, start: float, end: float) -> Iterator[Stretch]:
    """Return the sounds of a phone that lasts from one time to another."""
    if phone.phoneme is Phoneme.SILENCE:
        yield start, end, phone.phoneme, ""
        return
    letters = letters_of(phone.ipa)
    if len(letters) < 2:
        yield start, end, phone.phoneme, phone.ipa
        return
    first = NUCLEUS if letters[0] in ARTICULATIONS["vowel"] else CLOSURE
    shares = [first] + [(1 - first) / (len(letters) - 1)] * (len(letters) - 1)
    borders = [start + (end - start) * share for share in accumulate(shares, initial=0.0)]
    borders[-1] = end
    for letter, (begin, stop) in zip(letters, pairwise(borders), strict=True):
        phone_class = phone_classes_in(letter)[1]
        yield begin, stop, phone_class.phoneme if phone_class else phone.phoneme, letter


def _loudness(intensities: Float32Array, start: float, end: float) -> float:
    """Return the mean intensity from one time to another; 0 where it was not measured."""
    first = round(start / FRAME_PERIOD)
    part = intensities[first : max(round(end / FRAME_PERIOD), first + 1)]
    return float(part.mean()) if len(part) else 0.0


# What is said in a sound whose words are known: aligned, and as mouths need it.

Script = Sequence[ScriptWord] | Utterance
"""The words of a sound with their pronunciations, or all that is said in it with times, as label files have it."""


def scripted_transcript_of(
    analyses: Iterable[Analysis],
    script: Script,
    name: str,
    duration: float,
    path: Path | None = None,
    *,
    accept_text: bool = False,
    felt: bool = False,
) -> tuple[Utterance, Transcript]:
    """Return what is said in a sound of `duration` seconds, from its consecutive analyses; `path` is its file.

    With `accept_text` words are aligned even where another text seems to be said; with `felt` the feeling in the
    voice is estimated, too.

    Raises
    ------
    CorpusError : there is no word in the script.
    """
    prosody = Prosody(felt=felt)

    def kept() -> Iterator[Analysis]:
        for analysis in analyses:
            prosody.add(analysis)
            yield analysis

    if isinstance(script, Utterance):
        utterance = script
        for _ in kept():
            pass
    else:
        utterance = align_analyses(kept(), script, duration, accept_text=accept_text)
    loud, high, feelings = prosody.intensities, prosody.pitches, prosody.feelings
    return utterance, transcript_of_utterance(utterance, loud, high, name, path, feelings)
