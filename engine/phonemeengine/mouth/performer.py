"""The one driver of a face: phonemes and their times go in, the mouth, blinks and the pose of the head come out.

Window, clips, exports and network use the same object. What is known of the speech
beforehand moves the mouth early (see `phonemeengine.mouth.cues`); what comes live moves it when it sounds.
The mouth follows the loudness with a low-pass, and gets it earlier by the delay of that, where it is known.

What comes out depends on what was said to it and when, never on how often anybody looked.
"""

import math
import threading
from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol

from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array
from phonemeengine.features.feeling import Feeling, FeltFrames
from phonemeengine.features.front_end import F0
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.cues import MOST_ANTICIPATION, Cue, PlannedMovement, joined_runs, planned_movements
from phonemeengine.mouth.expression.composer import Composer, Expression, Inhibition
from phonemeengine.mouth.idle_motion import Blinker, HeadMotion, HeadPose
from phonemeengine.mouth.key_layer import NO_KEYS, KeyLayer
from phonemeengine.mouth.morpher import Detail, Morpher, VisemeOverride
from phonemeengine.mouth.style_numbers import GestureNumbers
from phonemeengine.mouth.table import MouthTable
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import Segment
from phonemeengine.settings import FRAME_PERIOD

REMEMBERED = 100
"""Frames that are replayed when another table takes over: one second."""
CLOSE_AFTER = 0.3
"""Seconds without a frame after which the mouth closes."""
STILL = HeadPose()


@dataclass(frozen=True)
class IdleMotion:
    """What a face does besides speaking, and which of all faces it is.

    Attributes
    ----------
    blinks, head : whether it blinks, and whether its head moves.
    seed : equal seeds make equal faces.
    detail : how much of the speech its mouth follows.
    expression : what it expresses meanwhile, on tables with the movestates of ARKit; None for nothing.
    gestures : how its head goes with speech.
    """

    blinks: bool = True
    head: bool = True
    seed: int = 0
    detail: Detail = Detail.PHONEMES
    expression: Expression | None = None
    gestures: GestureNumbers = field(default_factory=GestureNumbers)

    @property
    def feels(self) -> bool:
        """Whether the face follows the feeling in the voice."""
        return self.expression is not None and bool(self.expression.feeling)


MOUTH_ALONE = IdleMotion(blinks=False, head=False)
"""For those who have eyes and a neck of their own, such as avatars on the network."""


class TimedFrame(NamedTuple):
    """A frame of 10 ms: when it begins on the clock, and what it holds.

    Attributes
    ----------
    time : seconds.
    phoneme, intensity : what is said, and how loud, 0..1.
    f0 : fundamental frequency, Hz; 0 for none.
    phone : the symbol in the International Phonetic Alphabet; empty where only the phoneme is known.
    """

    time: float
    phoneme: Phoneme
    intensity: float
    f0: float = 0.0
    phone: str = ""


class FaceState(NamedTuple):
    """A face at one time.

    Attributes
    ----------
    table : whose movestates move.
    weights : of these, float32, shape (n_movestates,), 1 for the whole movement.
    blink : how far a blink has closed the lids, 0..1.
    head : how the head is turned.
    """

    table: MouthTable
    weights: Float32Array
    blink: float
    head: HeadPose


class MouthTrack(Protocol):
    """A mouth, and maybe a head, whose movement is known beforehand."""

    @property
    def movestates(self) -> tuple[str, ...]:
        """The names of the movestates, in the order of the weights."""

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, seconds, float32, shape (n_movestates,), 1 for the whole movement."""

    def head(self, time: float) -> HeadPose | None:
        """Return how the head is turned at a time, seconds; None where it follows the sound."""


SILENT = TimedFrame(-math.inf, Phoneme.SILENCE, 0.0)


def timed_frames(analysis: Analysis, end: float, known: Transcript | None = None) -> list[TimedFrame]:
    """Return the frames of an analysis of which the last one ends at a time on the clock, seconds.

    Parameters
    ----------
    known : what is said in the same sound, where that is known better than by recognition; see
        `transcript_of_utterance`.
    """
    start = end - len(analysis) * FRAME_PERIOD
    columns = (analysis.phonemes, analysis.intensities, analysis.features.values[:, F0])
    rows = zip(*(column.tolist() for column in columns), analysis.viseme_phones, strict=True)
    frames = [TimedFrame(start + k * FRAME_PERIOD, Phoneme(row[0]), *row[1:]) for k, row in enumerate(rows)]
    return frames if known is None else known_frames(frames, analysis.start, known)


def known_frames(frames: Sequence[TimedFrame], first: int, known: Transcript) -> list[TimedFrame]:
    """Return frames, of which the first has this number in its sound, with what is known of that.

    Where the loudness was not measured before, it is that of the frames.
    """
    return [_known_frame(frame, number, known) for number, frame in enumerate(frames, first)]


def _known_frame(frame: TimedFrame, number: int, known: Transcript) -> TimedFrame:
    run = known.run_at((number + 0.5) * FRAME_PERIOD)
    if run is None:
        return frame
    loud = float(known.intensities[number]) if number < len(known.intensities) else frame.intensity
    return frame._replace(phoneme=run.phoneme, intensity=loud, phone=run.phone)


class Performer:
    """Performs speech with a face: takes what is said as early as it is known, and shows the face at any time.

    Times are seconds of one clock, and those that are looked at never go back. One thread may speak to it while
    another one looks.

    Parameters
    ----------
    table : the mouth shapes, and how the mouth moves between them.
    idle : what else the face does; blinks and a moving head, where it is None.
    rate : pictures per second that are taken of it from time 0 on, where that is known; 0 where it is not.

    Attributes
    ----------
    visemes : the shapes that a person asks for; one thread alone may change them, the one that looks.
    """

    def __init__(self, table: MouthTable, idle: IdleMotion | None = None, *, rate: float = 0.0) -> None:
        self.table, self.idle = table, idle or IdleMotion()
        self.visemes, self._rate = VisemeOverride(table), rate
        self._lock = threading.RLock()
        self._blinker, self._head = Blinker(self.idle.seed), HeadMotion(self.idle.seed, self.idle.gestures)
        self._latest: deque[TimedFrame] = deque([SILENT], maxlen=REMEMBERED)
        self._coming: deque[TimedFrame] = deque()
        self._loudnesses: deque[tuple[float, float]] = deque()  # from when the mouth goes by which
        self._changes: deque[TimedFrame] = deque(maxlen=REMEMBERED)
        self._runs: list[TimedFrame] = []  # the first frame of each run of a sound, from the one that is shown on
        self._movements: deque[tuple[float, PlannedMovement]] = deque()  # each with when it begins, once it is known
        self._closes_at, self._rests_from = math.inf, -math.inf
        self._track: MouthTrack | None = None
        self._track_start = 0.0
        self._keys, self._keys_start = NO_KEYS, 0.0
        self._express(None)
        self._columns: list[int] = []  # where the movestates of the table are in those of the track
        self._restart()

    def configure(self, table: MouthTable, idle: IdleMotion) -> None:
        """Go on with another table, or with other motion, from where such a face would be."""
        with self._lock:
            if table.shapes.keys() != self.table.shapes.keys():
                self.visemes = VisemeOverride(table)
            elif table.shapes is not self.table.shapes or table.movestates != self.table.movestates:
                self.visemes.reshape(table)
            self._head.gestures = idle.gestures
            again = (table, idle.detail, idle.seed) != (self.table, self.idle.detail, self.idle.seed)
            before, self.table, self.idle = self.idle, table, idle
            if idle.expression is not before.expression:
                self._express(before.expression)
            self._columns = self._columns_of_track()
            if again:
                self._restart()

    # -- what is said to it -------------------------------------------------------------------------------

    def add(self, frames: Sequence[TimedFrame], now: float = -math.inf, *, live: bool = False) -> None:
        """Take the next frames.

        Parameters
        ----------
        frames : they follow those that were given before.
        now : since when they are known: the mouth is not ahead of that. All along, unless told otherwise.
        live : whether the mouth closes where nothing follows in time.
        """
        with self._lock:
            self._advance(now)
            self._closes_at = now + CLOSE_AFTER if live else math.inf
            self._coming.extend(frames)
            self._loudnesses.extend((max(self._shown_from(frame), now), frame.intensity) for frame in frames)
            if self._add_runs(frames):
                self._plan(min(now, frames[0].time))

    def follow(self, runs: Iterable[Segment], anticipation: float = MOST_ANTICIPATION) -> None:
        """Take all that is said in a whole sound; see `planned_movements`."""
        with self._lock:
            silent = Segment(-math.inf, 0.0, Phoneme.SILENCE, 0.0)
            said = [run for run in runs if run.end > run.start]
            after = [Segment(run.end, math.inf, Phoneme.SILENCE, 0.0) for run in said[-1:]]
            cues = joined_runs((silent, *said, *after), self.table)
            planned = planned_movements(cues, self.table, -math.inf, anticipation, rate=self._rate)
            self._rests_from = max((movement.end for movement in planned[-1:]), default=-math.inf)
            self._movements.extend((movement.begin, movement) for movement in planned)

    def play(self, track: MouthTrack | None, start: float = 0.0) -> None:
        """Have a track move the mouth, whose time 0 is at `start`, whatever sounds; None lets the sound move it.

        Blinks and the shapes that are asked for stay, and so does the head, unless the track turns it. A table with
        movestates that the track does not have follow the sound, too.
        """
        with self._lock:
            if track is not self._track:
                self._track = track
                self._columns = self._columns_of_track()
            self._track_start = start

    def edit(self, keys: KeyLayer, start: float = 0.0) -> None:
        """Show an animator's edits over all that moves the face; time 0 of the keys is at `start`."""
        with self._lock:
            self._keys, self._keys_start = keys, start

    def expect_loudness(self, time: float, intensity: float) -> None:
        """Take how loud a frame is that will begin at a time, 0..1; given early, since the mouth lags."""
        self._loudnesses.append((time - self.table.motion.loudness, intensity))

    def add_voice(self, time: float, intensity: float, f0: float) -> None:
        """Take the loudness, 0..1, and the fundamental frequency, Hz, of a frame that begins at a time.

        Head and expressions go by these; the mouth goes by what `expect_loudness` has told.
        """
        self._coming.append(self._runs[-1]._replace(time=time, intensity=intensity, f0=f0))

    def feel(self, feelings: FeltFrames, end: float) -> None:
        """Take the feeling in the voice in the next frames, of which the last one ends at a time, seconds."""
        start = end - len(feelings) * FRAME_PERIOD
        with self._lock:
            felt = None if self._composer is None else self._composer.felt
            if felt is None:
                return
            for k, row in enumerate(feelings.tolist()):
                felt.add(start + k * FRAME_PERIOD, Feeling(*row))

    def expect_speech(self, speech: Iterable[tuple[float, float]]) -> None:
        """Take the intervals of speech to come, start and end of each in order, so that expressions give way."""
        self._inhibition.expect(speech)

    def forget_coming(self, now: float) -> None:
        """Forget what was known of the future, since the sound stops or goes on elsewhere."""
        with self._lock:
            self._advance(now)
            self._closes_at = math.inf
            self._coming.clear()
            self._loudnesses.clear()
            self._movements.clear()
            self._inhibition.add(now, speaks=False)  # unless the sound goes on
            current = self._runs[0]  # the mouth may be ahead of it
            self._runs = [current._replace(time=min(current.time, now))]

    def close_mouth(self, now: float) -> None:
        """Close the mouth; what was known of the future does not come."""
        with self._lock:
            self.forget_coming(now)
            self.add([TimedFrame(now, Phoneme.SILENCE, 0.0)], now)

    def hold(self, now: float, phoneme: Phoneme, phone: str = "") -> None:
        """Hold the shape of a sound, at the loudness that there is; what was known of the future does not come."""
        with self._lock:
            self.forget_coming(now)
            if self._add_runs([TimedFrame(now, phoneme, 0.0, phone=phone)]):
                self._plan(now)

    def jump_to(self, frames: Sequence[TimedFrame], now: float) -> None:
        """Take at once the pose at the end of these frames."""
        with self._lock:
            self.forget_coming(now)
            self._latest.clear()
            self._latest.extend(frames)
            self._head.add(now, frames[-1].intensity)
            self._restart()

    def set_phonemes(self, phonemes: Mapping[Phoneme, float], speech: float) -> None:
        """Show the shapes of these phonemes, 0..1, beside a share of the speech; of none, the speech alone."""
        with self._lock:
            self.visemes.set_phonemes(phonemes, speech)

    # -- what it shows ------------------------------------------------------------------------------------

    def at(self, time: float) -> FaceState:
        """Return the face at a time."""
        with self._lock:
            self._advance(time)
            weights = self._expressed(self.visemes.apply(self._spoken(time), time), time)
            weights = self._keys.over_one(weights, self.table.movestates, time - self._keys_start)
            blink = self.visemes.blinks * self._blinker.closure(time) if self.idle.blinks else 0.0
            return FaceState(self.table, weights, blink, self._pose(time) if self.idle.head else STILL)

    def pop_said(self) -> list[tuple[Phoneme, float, str]]:
        """Return each phoneme since the last call, and last the current one.

        With each come its intensity, and its phone where that is known. Of shapes that are asked for, the one that is
        asked for the most.
        """
        with self._lock:
            asked, frames = self.visemes.phonemes, [*self._changes, self._latest[-1]]
            self._changes.clear()
            if asked:
                return [(*max(asked.items(), key=lambda entry: entry[1]), "")]
            return [(frame.phoneme, frame.intensity, frame.phone) for frame in frames]

    @property
    def rests_from(self) -> float:
        """When the mouth has come to rest after all that it follows, seconds; minus infinity without that."""
        return self._rests_from

    @property
    def feels(self) -> bool:
        """Whether the face follows the feeling in the voice, see `feel`."""
        return self._composer is not None and self._composer.felt is not None

    @property
    def inhibition(self) -> float:
        """By what share speech reduces expressions, 0..1, at the last look."""
        return self._reduction

    # -- inside -------------------------------------------------------------------------------------------

    def _express(self, before: Expression | None) -> None:
        """Express something else; the reduction by speech goes on unless it has other times."""
        expression = self.idle.expression
        self._composer = None if expression is None else Composer(expression)
        if before is None or expression is None or before.times != expression.times:
            self._inhibition, self._reduction = Inhibition(expression.times if expression else None), 0.0

    def _expressed(self, weights: Float32Array, time: float) -> Float32Array:
        if self._composer is None or self.table.movestates[: len(ARKIT)] != ARKIT:
            return weights
        self._reduction = self._inhibition.at(time)
        shown = weights.copy()
        shown[: len(ARKIT)] = self._composer.composed(weights[: len(ARKIT)], time, self._reduction)
        return shown

    def _restart(self) -> None:
        """Have a new mouth say what was taken."""
        self._morpher = Morpher(self.table, detail=self.idle.detail, seed=self.idle.seed)
        self._runs = [SILENT]
        self._movements.clear()
        self._begun = -math.inf  # when the last movement was to begin
        self._add_runs([*self._latest, *self._coming])
        self._plan(-math.inf)
        for frame in self._latest:
            self._morpher.set_loudness(self._shown_from(frame), frame.intensity)
        self._loudnesses = deque((self._shown_from(frame), frame.intensity) for frame in self._coming)

    def _shown_from(self, frame: TimedFrame) -> float:
        """Return from when the mouth goes by the loudness of a frame: before it, by the delay of its low-pass."""
        return frame.time - self.table.motion.loudness

    def _add_runs(self, frames: Iterable[TimedFrame]) -> bool:
        """Note when which phoneme or shape begins; says whether any does."""
        n_runs = len(self._runs)
        for frame in frames:
            if not self._alike(frame, self._runs[-1]):
                self._runs.append(frame)
        return len(self._runs) > n_runs

    def _alike(self, one: TimedFrame, other: TimedFrame) -> bool:
        """Return whether two frames are of one phoneme, and look the same."""
        if one.phoneme != other.phoneme or one.phone == other.phone:
            return one.phoneme == other.phoneme
        shapes = (self.table.shape_of(frame.phoneme, frame.phone) for frame in (one, other))
        return next(shapes) == next(shapes)

    def _plan(self, earliest: float) -> None:
        """Plan the movements to what is known after the run that the mouth moves to already, from a time on."""
        runs = zip(self._runs, self._run_ends(), strict=True)
        segments = (Segment(run.time, end, run.phoneme, run.intensity, run.phone) for run, end in runs)
        cues = joined_runs(segments, self.table)
        planned = planned_movements(cues, self.table, self._begun, rate=self._rate)
        self._movements = deque((max(movement.begin, earliest), movement) for movement in planned)

    def _spoken(self, time: float) -> Float32Array:
        if self._track is not None and self._columns:
            return self._track.weights(time - self._track_start)[self._columns]
        return self._morpher.weights(time)

    def _pose(self, time: float) -> HeadPose:
        turned = None if self._track is None else self._track.head(time - self._track_start)
        pose = self._head.pose(time) if turned is None else turned
        felt = None if self._composer is None or turned is not None else self._composer.felt
        return pose if felt is None else felt.turned(pose, time)

    def _columns_of_track(self) -> list[int]:
        """Return where the table's movestates are in those of the track; none where one is missing there."""
        places = {name: k for k, name in enumerate(() if self._track is None else self._track.movestates)}
        known = [places[name] for name in self.table.movestates if name in places]
        return known if len(known) == len(self.table.movestates) else []

    def _run_ends(self) -> list[float]:
        return [*(run.time for run in self._runs[1:]), math.inf]

    def _advance(self, time: float) -> None:
        """Have the mouth move, and the head, by what begins until a time."""
        if self._closes_at <= time:
            closes_at, self._closes_at = self._closes_at, math.inf
            self.close_mouth(closes_at)
        while self._coming and self._coming[0].time <= time:
            frame = self._coming.popleft()
            if not self._alike(frame, self._latest[-1]):
                self._changes.append(frame)
            self._latest.append(frame)
            self._inhibition.add(frame.time, speaks=frame.phoneme is not Phoneme.SILENCE)
            if self.idle.head:
                self._head.add(frame.time, frame.intensity, frame.f0)
        while self._loudnesses and self._loudnesses[0][0] <= time:
            self._morpher.set_loudness(*self._loudnesses.popleft())
        while self._movements and self._movements[0][0] <= time:
            self._begin(*self._movements.popleft())

    def _begin(self, begin: float, movement: PlannedMovement) -> None:
        """Begin a movement: it is not taken back any more, and the runs before it are over."""
        self._begun, onset = movement.begin, _onset_of(movement.cue)
        share = movement.time_share if begin <= movement.begin else 1.0
        self._morpher.set_phoneme(begin, onset.phoneme, onset.phone, time_share=share)
        runs = zip(self._runs, self._run_ends(), strict=True)
        same = (self._alike(run, onset) and end > onset.time for run, end in runs)
        past = next((k for k, found in enumerate(same) if found), 0)
        self._runs[: past + 1] = [onset]


def _onset_of(cue: Cue) -> TimedFrame:
    return TimedFrame(cue.start, cue.phoneme, cue.intensity, phone=cue.phone)
