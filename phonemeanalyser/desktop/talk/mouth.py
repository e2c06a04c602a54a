"""The mouth in step with the sound: what is known early moves it early, and loudness moves it on time."""

import math
from collections import deque
from dataclasses import dataclass

from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array
from phonemeengine.features.front_end import F0
from phonemeengine.mouth.cues import MINIMUM, MOST_ANTICIPATION, leads_of
from phonemeengine.mouth.head_motion import HeadMotion, HeadPose
from phonemeengine.mouth.morpher import Detail, Morpher
from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

REMEMBERED = 100
"""Frames that are told again to a mouth that takes another's place: one second."""


@dataclass(frozen=True)
class Frames:
    """Frames in a row: codes of `Phoneme`, intensities 0..1, and fundamental frequencies in Hz, 0 for none."""

    codes: list[int]
    intensities: list[float]
    pitches: list[float]

    @classmethod
    def of(cls, analysis: Analysis) -> "Frames":
        """Return what a mouth wants to know of an analysis."""
        pitches = analysis.features.values[:, F0].tolist()
        return cls(analysis.phonemes.tolist(), analysis.intensities.tolist(), pitches)


@dataclass(frozen=True, slots=True)
class TimedFrame:
    """A frame: when it is heard on the clock, seconds, and what it says; `f0` in Hz."""

    time: float
    code: int
    intensity: float
    f0: float


class TalkMouth:
    """Follows frames, of which some are known before they are heard.

    Parameters
    ----------
    table : the mouth shapes, and how the mouth moves between them.
    detail : how much of the speech it follows.
    """

    def __init__(self, table: MouthTable, detail: Detail = Detail.PHONEMES) -> None:
        self._table = table
        self._detail = detail
        self._motion = HeadMotion()
        self._posed = self._now = -math.inf
        self._told: deque[TimedFrame] = deque(maxlen=REMEMBERED)
        self._begin_anew()

    def hear(self, frames: Frames, end: float) -> None:
        """Take the next frames, of which the last one ends at a time on the clock, seconds."""
        start = end - len(frames.codes) * FRAME_PERIOD
        for k, (code, loud, f0) in enumerate(zip(frames.codes, frames.intensities, frames.pitches, strict=True)):
            self._hear(TimedFrame(start + k * FRAME_PERIOD, code, loud, f0))

    def hush(self, now: float) -> None:
        """Close the mouth; what was known of the future does not come."""
        self._coming.clear()
        if self._code != Phoneme.SILENCE or self._loud:
            self._hear(TimedFrame(now, Phoneme.SILENCE, 0.0, 0.0))

    def hold(self, now: float, code: int) -> None:
        """Hold the shape of the phoneme that was heard last; what was known of the future does not come yet."""
        self._coming.clear()
        if code != self._code:
            self._begin(TimedFrame(now, code, self._loud, 0.0))

    def forget_coming(self) -> None:
        """Forget the loudness of what was known of the future, since the sound goes on elsewhere."""
        self._coming.clear()

    def stand(self, frames: Frames, now: float) -> None:
        """Stand at once as somebody does who has just said this."""
        self._told.clear()
        self._begin_anew()
        self.hear(frames, now)

    def use(self, table: MouthTable, detail: Detail) -> None:
        """Go on with another table or another detail, from where such a mouth would be."""
        self._table, self._detail = table, detail
        told = list(self._told)
        self._told.clear()
        self._begin_anew()
        for frame in told:
            self._hear(frame)

    def weights(self, now: float) -> Float32Array:
        """Return the weights of the table's movestates, float32, shape (n_movestates,); times never go back."""
        self._let_sound(now)
        self._now = max(now, self._now)
        return self._morpher.weights(self._now)

    def pose(self, now: float) -> HeadPose:
        """Return the pose of the head; times never go back."""
        self._let_sound(now)
        self._posed = max(now, self._posed)
        return self._motion.pose(self._posed)

    def _begin_anew(self) -> None:
        self._morpher = Morpher(self._table, detail=self._detail)
        self._ahead = leads_of(self._table, MOST_ANTICIPATION)
        self._coming: deque[TimedFrame] = deque()
        self._code, self._loud, self._since = int(Phoneme.SILENCE), 0.0, -math.inf
        self._begun = self._sounded = self._now = -math.inf

    def _hear(self, frame: TimedFrame) -> None:
        self._told.append(frame)
        self._coming.append(frame)
        self._loud = frame.intensity
        if frame.code != self._code:
            self._begin(frame)

    def _begin(self, frame: TimedFrame) -> None:
        """Begin vowels, and lips that meet, early at the cost of what comes before, as `cues_of` does."""
        before = frame.time - self._since
        spare = min(self._ahead.get(Phoneme(frame.code), 0.0), before / 2, max(before - MINIMUM, 0.0))
        self._begun = max(frame.time - spare, self._begun, self._now)
        self._morpher.hear_phoneme(self._begun, frame.code)
        self._code, self._since = frame.code, frame.time

    def _let_sound(self, now: float) -> None:
        """Tell the loudness of what has been heard by now."""
        while self._coming and self._coming[0].time <= now:
            frame = self._coming.popleft()
            self._sounded = max(frame.time, self._sounded)
            self._morpher.hear_loudness(self._sounded, frame.intensity)
            self._motion.hear(max(frame.time, self._posed), frame.intensity, frame.f0)
