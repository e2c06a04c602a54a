"""What can move a face, its movement through a whole sound, frame by frame, and how much two of them differ."""

import math
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import islice

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, ShortRepr
from phonemeengine.errors import MouthError, check_range
from phonemeengine.mouth.blendshape_names import EYELIDS
from phonemeengine.mouth.cues import MOST_ANTICIPATION, check_seconds
from phonemeengine.mouth.key_layer import KeyLayer
from phonemeengine.mouth.performer import FaceState, IdleMotion, MouthTrack, Performer
from phonemeengine.mouth.table import LIMITS, MouthTable
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD


class FaceDriver(StrEnum):
    """What moves a face by what is said; `AUTO` is whatever `usual_driver` chooses."""

    AUTO = "auto"
    PINYIN = "pinyin"
    TABLE = "table"
    NETWORK = "network"
    RULES = "rules"

    @property
    def caption(self) -> str:
        """What it is called below a face."""
        return _CAPTIONS[self]


_CAPTIONS = {
    FaceDriver.AUTO: "Automatic",
    FaceDriver.PINYIN: "Pinyin letters",
    FaceDriver.TABLE: "Recorded faces",
    FaceDriver.NETWORK: "Sound alone (network)",
    FaceDriver.RULES: "Phonemes (rules)",
}


NEEDS_FILE = (FaceDriver.TABLE, FaceDriver.NETWORK)
"""What moves a face by a file that is learned from recorded faces."""


def usual_driver(*, has_table: bool, has_letters: bool, has_network: bool = False) -> FaceDriver:
    """Return what moves a face unless another is chosen: what recorded faces taught, letters of pinyin, else rules.

    Parameters
    ----------
    has_table : whether there is a table of recorded faces, and it is known what is said.
    has_network : whether there is a network that learned from recorded faces.
    has_letters : whether Chinese is said, and letters can move the face.
    """
    if has_table:
        return FaceDriver.TABLE
    if has_network:
        return FaceDriver.NETWORK
    return FaceDriver.PINYIN if has_letters else FaceDriver.RULES


LOWEST_RATE, HIGHEST_RATE = 1.0, 240.0
"""Frames per second."""
BLOCK = 4096
"""Frames that are animated at once."""
AFTERWARDS = 0.2
"""Seconds for which an expression is shown once it has come back after the last sound."""


@dataclass(frozen=True, repr=False)
class Animation(ShortRepr):
    """The weights of a face's movestates at a frame rate.

    Attributes
    ----------
    rate : frames per second; frame k shows the time k / rate.
    movestates : the names of the columns.
    weights : float32, shape (n_frames, n_movestates), 1 for the whole movement.
    head : float32, shape (n_frames, 3): yaw, pitch and roll, degrees; zeros where the head does not move.
    """

    rate: float
    movestates: tuple[str, ...]
    weights: Float32Array
    head: Float32Array

    @property
    def times(self) -> Float64Array:
        """The time of each frame, seconds, shape (n_frames,)."""
        return np.arange(len(self.weights)) / self.rate

    def of_movestates(self, movestates: tuple[str, ...]) -> "Animation":
        """Return the animation of some of its movestates, in their order."""
        columns = [self.movestates.index(name) for name in movestates]
        return replace(self, movestates=movestates, weights=self.weights[:, columns])

    def edited(self, keys: KeyLayer, first: int = 0) -> "Animation":
        """Return the animation with an animator's edits; its first frame is that of this number in the sound."""
        times = (first + np.arange(len(self.weights))) / self.rate
        return replace(self, weights=keys.over(self.weights, self.movestates, times)) if keys else self

    def on_face(self, table: MouthTable) -> "Animation":
        """Return the animation of the shapes of a face, where a table has its names."""
        if not table.targets:
            return self
        return replace(self, movestates=table.face_names, weights=table.on_face(self.weights, self.movestates))

    def held(self, n_frames: int) -> "Animation":
        """Return the animation with this many frames, no fewer than it has: the last one stays."""
        rows = np.minimum(np.arange(n_frames), len(self.weights) - 1)
        return replace(self, weights=self.weights[rows], head=self.head[rows])


def animation_of(
    speech: Transcript,
    table: MouthTable,
    rate: float,
    idle: IdleMotion | None = None,
    *,
    anticipation: float = MOST_ANTICIPATION,
) -> Animation:
    """Animate a face: its mouth moves along what is said with the loudness of the sound.

    Parameters
    ----------
    speech : what was said.
    table : the mouth shapes.
    rate : frames per second, 1..240.
    idle : what else the face does; blinks and a moving head, where it is None.
    anticipation : by how much a movement may begin before its sound at most, 0..0.12 s.

    Raises
    ------
    MouthError : the rate or the anticipation lies outside its range.
    """
    return animation_by(performer_of(speech, table, rate, idle, anticipation), speech, rate)


def performer_of(
    speech: Transcript, table: MouthTable, rate: float, idle: IdleMotion | None, anticipation: float
) -> Performer:
    """Return a performer that knows all that is said in a sound, and is looked at at a rate; see `animation_of`."""
    check_rate(rate)
    check_seconds("anticipation", anticipation, MOST_ANTICIPATION)
    performer = Performer(table, idle, rate=rate)
    performer.follow(speech.runs, anticipation)
    return performer


def animation_by(performer: Performer, speech: Transcript, rate: float, *, rests_from: float = 0.0) -> Animation:
    """Animate a face by a performer that knows how the mouth moves; the sound moves its head, and its eyes blink.

    Parameters
    ----------
    performer : it has not been looked at.
    speech : what was said.
    rate : frames per second, 1..240.
    rests_from : when a mouth that a track moves has come to rest, seconds; the animation lasts so long at least.

    Raises
    ------
    MouthError : the rate lies outside its range.
    """
    blocks = [*animation_blocks(performer, speech, rate, rests_from=rests_from)]
    weights, head = (np.concatenate([getattr(block, name) for block in blocks]) for name in ("weights", "head"))
    return Animation(rate, performer.table.movestates, weights, head)


def animation_blocks(
    performer: Performer, speech: Transcript, rate: float, *, rests_from: float = 0.0, block: int = BLOCK
) -> Iterator[Animation]:
    """Animate a face as `animation_by` does, some frames at a time: hours of it need not be held in memory.

    Raises
    ------
    MouthError : the rate lies outside its range.
    """
    check_rate(rate)
    spoken = [(run.start, run.end) for run in speech.runs if run.phoneme is not Phoneme.SILENCE]
    performer.expect_speech(spoken)
    movestates = performer.table.movestates
    eyelids = [k for k, name in enumerate(movestates) if name in EYELIDS]
    n_frames = math.floor(speech.duration * rate + 1e-6) + 1
    n_frames = max(n_frames, math.ceil(max(_end_of(performer, spoken), rests_from) * rate - 1e-6) + 1)
    faces = _faces(performer, speech, np.arange(n_frames) / rate)
    for first in range(0, n_frames, block):
        n = min(block, n_frames - first)
        weights, head = np.zeros((n, len(movestates)), np.float32), np.zeros((n, 3), np.float32)
        for frame, face in enumerate(islice(faces, n)):
            weights[frame], head[frame] = face.weights, face.head
            for column in eyelids:
                weights[frame, column] = max(weights[frame, column], face.blink)
        yield Animation(rate, movestates, weights, head)


def _end_of(performer: Performer, spoken: Sequence[tuple[float, float]]) -> float:
    """Return when the mouth is at rest, and what is expressed after the last sound has come back, seconds."""
    expression, rests = performer.idle.expression, max(performer.rests_from, 0.0)
    if expression is None or not spoken:
        return rests
    return max(rests, spoken[-1][1] + expression.times.release + AFTERWARDS)


class MovementTrack(ABC):
    """How a face moves through all that is said: a performer plays its mouth, or it becomes an animation.

    Attributes
    ----------
    head_follows : whether the head goes with the sound where the mouth's track does not turn it.
    """

    head_follows = True

    @property
    def rests_from(self) -> float:
        """When the mouth has come to rest, seconds; an animation lasts so long at least."""
        return 0.0

    @property
    @abstractmethod
    def face(self) -> MouthTable:
        """The mouth table whose movestates move."""

    @abstractmethod
    def mouth(self) -> MouthTrack:
        """Return a mouth that says it, for a performer to play."""

    def mouth_at(self, _rate: float) -> MouthTrack:
        """Return the same for a number of pictures a second."""
        return self.mouth()

    def animation(self, speech: Transcript, rate: float, idle: IdleMotion | None = None) -> Animation:
        """Animate a face: the track moves the mouth, it blinks, and its head moves.

        Parameters
        ----------
        speech : how long the animation is, and how loud and high the voice.
        rate : frames per second, 1..240.
        idle : what else the face does; blinks and a moving head, where it is None.

        Raises
        ------
        MouthError : the rate lies outside its range.
        PerformanceError : a table of recorded faces is damaged.
        """
        check_rate(rate)
        idle = idle or IdleMotion()
        performer = Performer(self.face, idle if self.head_follows else replace(idle, head=False))
        performer.play(self.mouth_at(rate))
        return animation_by(performer, speech, rate, rests_from=self.rests_from)


def check_rate(rate: float) -> None:
    """Refuse a frame rate that is out of range.

    Raises
    ------
    MouthError : it is.
    """
    check_range("the frame rate", rate, (LOWEST_RATE, HIGHEST_RATE, "frames per second"), MouthError)


def _faces(performer: Performer, speech: Transcript, times: Float64Array) -> Iterator[FaceState]:
    """Give a performer the speech as it goes on, and look at it at some times."""
    expected = _rows(speech.times, speech.intensities)
    frames = _rows(speech.times, speech.intensities, speech.pitches)
    known, coming = next(expected, None), next(frames, None)
    n_felt = 0
    for (time,) in _rows(times):
        while known is not None and known[0] <= time + LIMITS["loudness"][1]:
            performer.expect_loudness(*known)
            known = next(expected, None)
        while coming is not None and coming[0] <= time:
            performer.add_voice(*coming)
            coming = next(frames, None)
        felt = speech.feelings[n_felt : math.floor(time / FRAME_PERIOD + 1e-6) + 1]
        n_felt += len(felt)
        performer.feel(felt, n_felt * FRAME_PERIOD)
        yield performer.at(time)


def _rows(*columns: Float64Array | Float32Array) -> Iterator[tuple[float, ...]]:
    """Return the rows of columns of equal length, of which a block at a time is numbers of Python."""
    for first in range(0, len(columns[0]), BLOCK):
        yield from zip(*(column[first : first + BLOCK].tolist() for column in columns), strict=True)


WINDOW = 0.2
"""Seconds of a place: about a syllable."""
LEAST = 0.05
"""Of a weight: a smaller difference is hardly seen, and makes no place."""
MOST_PLACES, MOST_SHAPES = 20, 3


@dataclass(frozen=True)
class ShapeDifference:
    """How much a movestate differs.

    Attributes
    ----------
    name : of the movestate.
    mean, greatest : absolute difference of its weights, 0..1.
    """

    name: str
    mean: float
    greatest: float


@dataclass(frozen=True)
class DifferentPlace:
    """A place in a sound where two movements differ.

    Attributes
    ----------
    start, end : of the place, seconds.
    time : of the frame in it that differs most, seconds.
    rms : of the differences of all movestates in it.
    shapes : those movestates that differ most there, at most `MOST_SHAPES`, the first one most.
    """

    start: float
    end: float
    time: float
    rms: float
    shapes: tuple[ShapeDifference, ...]


@dataclass(frozen=True)
class MovementDifference:
    """How much two movements differ.

    Attributes
    ----------
    rms : root of the mean squared difference of weights, over all frames and movestates.
    shapes : all movestates that differ at all, the first one most.
    places : where the movements differ most, the first one most; they do not overlap.
    """

    rms: float
    shapes: tuple[ShapeDifference, ...]
    places: tuple[DifferentPlace, ...]


def movement_difference(one: Animation, other: Animation, most: int = MOST_PLACES) -> MovementDifference:
    """Return how much two movements of the same sound differ in the movestates that both have.

    Parameters
    ----------
    one, other : at the same rate; the shorter one is taken to stay as it ends.
    most : places that are listed.

    Raises
    ------
    MouthError : they have different rates, no movestate in common, or no frames.
    """
    names = tuple(name for name in one.movestates if name in other.movestates)
    if one.rate != other.rate or not names or not (len(one.weights) and len(other.weights)):
        raise MouthError(
            "two movements can be compared if both have frames, the same frame rate and movestates in common; make "
            "both with the same options"
        )
    n = max(len(one.weights), len(other.weights))
    first, second = (made.held(n).of_movestates(names).weights for made in (one, other))
    apart = np.abs(first - second)
    shapes = _shapes_of(apart, names)
    rms = float(np.sqrt(np.mean(np.square(apart, dtype=np.float64))))
    return MovementDifference(rms, shapes, tuple(_places_of(apart, names, one.rate, most)))


def _shapes_of(apart: Float32Array, names: tuple[str, ...]) -> tuple[ShapeDifference, ...]:
    means, greatest = apart.mean(axis=0, dtype=np.float64), apart.max(axis=0)
    order = [k for k in np.argsort(-means, kind="stable").tolist() if greatest[k] > 0]
    return tuple(ShapeDifference(names[k], float(means[k]), float(greatest[k])) for k in order)


def _places_of(apart: Float32Array, names: tuple[str, ...], rate: float, most: int) -> list[DifferentPlace]:
    """Return windows that do not overlap, of which each differs most among what those before it left."""
    n, width = len(apart), max(1, min(len(apart), round(WINDOW * rate)))
    powers = np.mean(np.square(apart, dtype=np.float64), axis=1)
    sums = np.concatenate(([0.0], np.cumsum(powers)))
    left: Float64Array = np.maximum(sums[width:] - sums[:-width], 0.0) / width  # of the window from each frame on
    places: list[DifferentPlace] = []
    while len(places) < most and left.max(initial=0.0) > 0:
        first = int(np.argmax(left))
        window, power = apart[first : first + width], float(left[first])
        left[max(0, first - width + 1) : first + width] = 0.0
        if window.max() < LEAST:
            continue
        time = (first + int(np.argmax(powers[first : first + width]))) / rate
        end = min(first + width, n - 1) / rate
        shapes = _shapes_of(window, names)[:MOST_SHAPES]
        places.append(DifferentPlace(first / rate, end, time, power**0.5, shapes))
    return places


def difference_in_words(found: MovementDifference, most: int = 3) -> str:
    """Return in words how much two movements differ, and the places where they do most."""
    if not found.places:
        return f"both heads move alike (RMS of the weights {found.rms:.3f})"
    places = (
        f"{place.time:.2f} s ({', '.join(f'{shape.name} {shape.greatest:.2f}' for shape in place.shapes)})"
        for place in found.places[:most]
    )
    return f"the heads differ by {found.rms:.3f} (RMS of the weights), most at {', '.join(places)}"
