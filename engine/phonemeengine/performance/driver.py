"""The driver: a sentence is looked up in a table of performances, fitted to its sound, smoothed and posed.

Model visemes are laid over what is looked up, as far as is asked for.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import StrEnum
from itertools import groupby

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import PerformanceError
from phonemeengine.mouth.blendshape_names import ARKIT, SHOULDERS, TONGUE
from phonemeengine.mouth.poses import Pose, PoseTable
from phonemeengine.mouth.style import Style, neutral_style
from phonemeengine.mouth.style_numbers import PoseNumbers
from phonemeengine.performance import smoothing
from phonemeengine.performance.choice import (
    Chosen,
    ExampleChoice,
    Given,
    PlacedUnit,
    chosen_examples,
    notes_on,
    placed_units,
    recorded_strings,
)
from phonemeengine.performance.halves import Recordings, bounds_of
from phonemeengine.performance.keywords import Keywords
from phonemeengine.performance.recording import SILENCE, PerformedPhone
from phonemeengine.performance.table_file import PerformanceTable
from phonemeengine.performance.units import Sentence, UnitKind
from phonemeengine.text.syllables import is_vowel

# The tongue, which no camera sees: a pose for each sound, as the style has them.

TO_REST = 0.1
"""Seconds in which the tongue comes to rest in a pause, and comes from there."""


def tongue_weights(sentence: Sentence, poses: PoseTable, times: Float64Array, frame: float) -> Float32Array:
    """Return the weights of the movestates of `TONGUE`, float32, shape (n_times, 6).

    Poses are mixed as those of the mouth are, with what they leave on the way from each pose to the next one.

    Parameters
    ----------
    sentence : its phones.
    poses : those of the tongue.
    times : seconds.
    frame : how long a picture is shown, seconds; no pose holds for less.
    """
    posed = pose_shares(sentence, poses, times, frame)
    way = _on_the_way(sentence, poses, times)
    if not posed.shapes:
        return way
    shapes = np.stack([_weights_of(shape, poses) for shape in posed.shapes])
    weights: Float32Array = posed.shares @ shapes + (1 - posed.shares.sum(axis=1, keepdims=True)) * way
    return weights


def _weights_of(shape: str, poses: PoseTable) -> Float32Array:
    """Return the weights of a shape; the tongue is a whole, so what a shape does not name is at rest."""
    return np.nan_to_num(poses.weights(shape, TONGUE))


def _on_the_way(sentence: Sentence, poses: PoseTable, times: Float64Array) -> Float32Array:
    """Return a tongue that goes from each pose to the next one along half a cosine."""
    rest = np.zeros(len(TONGUE), np.float32)
    stations: list[tuple[float, Float32Array]] = []
    for phone in sentence:
        pose = pose_in(poses, phone)
        if pose is not None:
            stations.append((phone.start + poses.curve.place * phone.duration, _weights_of(pose.shape, poses)))
        elif phone.name == SILENCE:
            inset = min(TO_REST, phone.duration / 2)
            stations += [(phone.start + inset, rest), (phone.end - inset, rest)]
    at, shapes = np.array([time for time, _ in stations]), np.stack([shape for _, shape in stations])
    places = np.interp(times, at, np.arange(len(at)))
    last = np.minimum(places.astype(np.intp) + 1, len(at) - 1)
    share = (0.5 - 0.5 * np.cos(np.pi * (places % 1))).astype(np.float32)[:, None]
    way: Float32Array = (1 - share) * shapes[places.astype(np.intp)] + share * shapes[last]
    return way


FACE = (*ARKIT, *SHOULDERS, *TONGUE)
"""The movestates of a face that a table moves."""
MOUTH = ("jaw", "mouth", "cheek", "nose", "tongue")
"""What the names of movestates begin with that units move: eyes, brows and the head have their own times."""

MOST_OUT = 0.05
"""How far the tongue may be out in the middle of a vowel."""
_OUT = "tongueOut"
_TONGUE = slice(len(FACE) - len(TONGUE), None)


class PerformancePart(StrEnum):
    """What is done to a sentence after its units are joined, or besides; each can be left out."""

    POSES = "poses"
    FILTERS = "filters"
    ENERGY = "energy"
    WINDOW = "window"
    HEAD = "head"


@dataclass(frozen=True)
class PerformanceOptions:
    """How sentences are performed.

    Attributes
    ----------
    choice : among the examples of a unit.
    seed : of what is left to chance.
    without : what is left out.
    style : how mouth and tongue are posed, smoothed and moved, and how the head goes along.
    keywords : words with gestures, and conjunctions; those that ship, where it is None.
    given : tells the units of a sentence that are chosen already, as its sound is made of them; see `OwnSound`.
    """

    choice: ExampleChoice = ExampleChoice.VITERBI
    seed: int = 0
    without: frozenset[PerformancePart] = frozenset()
    style: Style = field(default_factory=neutral_style)
    keywords: Keywords | None = None
    given: Given | None = None


@dataclass(frozen=True)
class UsedUnit:
    """A unit of a sentence, and the recording that it is from.

    Attributes
    ----------
    start, end : in the sentence, seconds.
    kind, names : the set and the phones of the example.
    recording : its name.
    source_start, source_end : in the recording, seconds.
    """

    start: float
    end: float
    kind: UnitKind
    names: tuple[str, ...]
    recording: str
    source_start: float
    source_end: float


class PerformanceDriver:
    """Has the performer of a table say sentences, with the mouth; see `MOUTH`.

    The tongue, which no camera sees, goes from pose to pose.

    Parameters
    ----------
    table : recorded performances; it stays open as long as this is used.
    options : how they are performed.

    Raises
    ------
    PerformanceError : no channel of the table is a blend shape of a mouth.
    """

    def __init__(self, table: PerformanceTable, options: PerformanceOptions | None = None) -> None:
        self.options = options or PerformanceOptions()
        names = table.about.channels
        columns = [k for k, name in enumerate(names) if name in ARKIT and name.startswith(MOUTH)]
        if not columns:
            raise PerformanceError(
                f"{table.about.name}: no channel of this table is a blend shape of a mouth as ARKit names them, such "
                "as jawOpen; build it of recordings that have them"
            )
        self._table, self._recordings = table, Recordings(table, np.array(columns))
        self._inventory = {kind: table.names(kind) for kind in UnitKind}
        style = self.options.style
        self._poses, self._tongue_poses, self._filters = style.posed_mouth(), style.posed_tongue(), style.filtered()
        self._moved = moved = tuple(names[k] for k in columns)
        self._places = np.array([ARKIT.index(name) for name in moved])
        self._loose = style.loose_gains(moved)
        self._loud = [k for k, name in enumerate(moved) if name in smoothing.ENERGY_CHANNELS]

    def notes(self, sentence: Sentence) -> tuple[str, ...]:
        """Return what the table lacks for a sentence, a sentence each."""
        return tuple(notes_on(sentence, self._inventory))

    def units(self, sentence: Sentence, number: int) -> tuple[UsedUnit, ...]:
        """Return the units of a sentence in order of time; see `weights`."""
        return tuple(_used(*self._looked_up(sentence, number)))

    def weights(self, sentence: Sentence, number: int, times: Float64Array, frame: float) -> Float32Array:
        """Return the weights of the movestates of `FACE` at some times, float32, shape (n_times, 60).

        Parameters
        ----------
        sentence : its phones.
        number : of the sentence in its text: equal sentences of other numbers may move otherwise.
        times : seconds, evenly spaced, from the beginning of the sentence on.
        frame : how long a picture is shown, seconds; closures last for one at least.

        Raises
        ------
        PerformanceError : the table is damaged.
        """
        moved = self._finished(smoothing.fitted(*self._looked_up(sentence, number), times), sentence, times, frame)
        weights = np.zeros((len(times), len(FACE)), np.float32)
        weights[:, self._places] = moved
        if PerformancePart.POSES not in self.options.without:
            weights[:, _TONGUE] = tongue_weights(sentence, self._tongue_poses, times, frame)
        return weights

    def _looked_up(
        self, sentence: Sentence, number: int
    ) -> tuple[tuple[PlacedUnit, ...], list[Chosen], Float64Array]:
        """Return the units of a sentence, their examples, and when its halves begin and end."""
        given = None if self.options.given is None else self.options.given(sentence)
        if given is not None:
            chosen = [(self._recordings[example.recording], example) for example in given.examples]
            return given.placed, chosen, given.bounds_in(sentence)
        placed = placed_units(sentence, self._inventory, recorded_strings(sentence, self._table))
        seed = (abs(self.options.seed), int(self.options.seed < 0), number)
        chosen = chosen_examples(placed, sentence, self._table, self._recordings, self.options.choice, seed)
        return placed, chosen, bounds_of(sentence)

    def _finished(self, weights: Float32Array, sentence: Sentence, times: Float64Array, frame: float) -> Float32Array:
        """Filter before posing, since a filter would open closed lips; the loudness spares these."""
        without = self.options.without
        if PerformancePart.FILTERS not in without:
            weights = smoothing.smoothed(smoothing.without_outliers(weights), sentence, times, self._filters)
        weights = smoothing.bounded(weights * self._loose)
        shares = pose_shares(sentence, self._poses, times, frame)
        if PerformancePart.POSES not in without:
            weights = posed_weights(weights, shares, self._poses, self._moved)
            weights = self._behind_teeth(weights, sentence, times)
        if PerformancePart.ENERGY not in without:
            louder = 1 + (smoothing.gains_of(sentence, times, self._filters.gain) - 1) * (1 - shares.firm)
            weights[:, self._loud] *= louder[:, None]
        if PerformancePart.WINDOW not in without:
            weights = smoothing.brought_to_rest(weights, sentence, times)
        return smoothing.bounded(weights)

    def _behind_teeth(self, weights: Float32Array, sentence: Sentence, times: Float64Array) -> Float32Array:
        """Have the tongue be back in the mouth in the middle of each vowel, however short that is."""
        if _OUT not in self._moved:
            return weights
        out = weights[:, self._moved.index(_OUT)]
        for phone in sentence:
            if is_vowel(phone.name):
                inside = (phone.start < times) & (times < phone.end)
                most = float(out[inside].max(initial=0.0))
                way = 0.25 * phone.duration  # a quarter back, half behind the teeth, a quarter out again
                from_ends = np.minimum(times[inside] - phone.start, phone.end - times[inside])
                middle = 0.5 - 0.5 * np.cos(np.pi * np.clip(from_ends / way, 0.0, 1.0))
                out[inside] *= 1 - middle * (1 - MOST_OUT / max(most, MOST_OUT))
        return weights


def _used(placed: tuple[PlacedUnit, ...], chosen: list[Chosen], bounds: Float64Array) -> Iterator[UsedUnit]:
    for unit, (halves, example) in zip(placed, chosen, strict=True):
        yield UsedUnit(
            float(bounds[unit.unit.first]),
            float(bounds[unit.unit.last]),
            unit.kind,
            unit.names,
            halves.name,
            float(halves.bounds[example.first]),
            float(halves.bounds[example.last]),
        )


@dataclass(frozen=True, eq=False)
class PoseShares:
    """How far a face takes which poses.

    Attributes
    ----------
    shares : float32, shape (n_frames, n_posed), 0..1; those of a frame sum to 1 at most.
    shapes : the names of the shapes, one for each.
    firm : float32, shape (n_frames,): how far lips or teeth meet.
    """

    shares: Float32Array
    shapes: tuple[str, ...]
    firm: Float32Array


def pose_in(poses: PoseTable, phone: PerformedPhone) -> Pose | None:
    """Return the pose of a phone; None for none, and in silence."""
    return poses.pose_of("" if phone.name == SILENCE else phone.name)


def pose_shares(sentence: Sentence, poses: PoseTable, times: Float64Array, frame: float) -> PoseShares:
    """Return the shares of all poses of a sentence at some times.

    Parameters
    ----------
    sentence : its phones.
    times : seconds.
    frame : how long a picture is shown, seconds: no pose holds for less.
    """
    posed = [(k, pose) for k, phone in enumerate(sentence) if (pose := pose_in(poses, phone)) is not None]
    curves = np.zeros((len(posed), len(times)))
    for row, (k, pose) in zip(curves, posed, strict=True):
        row[:] = _curve(sentence, k, pose, poses.curve, times, frame)
    _share_out(curves, [pose.priority for _, pose in posed])
    firm = sum((row for row, (_, pose) in zip(curves, posed, strict=True) if pose.firm), np.zeros(len(times)))
    return PoseShares(curves.T.astype(np.float32), tuple(pose.shape for _, pose in posed), firm.astype(np.float32))


def posed_weights(
    weights: Float32Array, shares: PoseShares, poses: PoseTable, channels: tuple[str, ...]
) -> Float32Array:
    """Lay poses over weights, shape (n_frames, n_channels), of these channels: what they take, the weights lose."""
    if not shares.shapes:
        return weights
    shapes = np.stack([poses.weights(shape, channels) for shape in shares.shapes])
    decides = np.isfinite(shapes)
    taken = shares.shares @ decides.astype(np.float32)
    laid: Float32Array = shares.shares @ np.where(decides, shapes, 0.0) + (1 - taken) * weights
    return laid


def _curve(
    sentence: Sentence, k: int, pose: Pose, numbers: PoseNumbers, times: Float64Array, frame: float
) -> Float64Array:
    """Return how far the pose of a phone is taken: a plateau with two flanks, each half a Gaussian."""
    phone = sentence[k]
    plateau = max(frame, numbers.plateau * phone.duration * pose.width)
    begin = phone.start + numbers.place * phone.duration - plateau / 2
    distance = np.where(times < begin, begin - times, np.maximum(times - begin - plateau, 0.0))
    before = sentence[k - 1].duration if k else 0.0
    after = sentence[k + 1].duration if k + 1 < len(sentence) else 0.0
    longest = numbers.longest_neighbour
    coming = np.clip(numbers.coming * min(before, longest), numbers.least_coming, numbers.most_coming)
    leaving = np.clip(numbers.leaving * min(after, longest), numbers.least_leaving, numbers.most_leaving)
    width = np.where(times < begin, coming, leaving) * pose.width
    height = 1.0 if pose.firm else min(1.0, phone.duration / numbers.full_length)
    curve: Float64Array = height * np.exp(-0.5 * (distance / width) ** 2)
    return curve


def _share_out(curves: Float64Array, priorities: list[float]) -> None:
    """Make curves, shape (n, n_times), sum to 1 at most: the lower priorities get what the higher ones leave."""
    left = np.ones(curves.shape[1])
    order = sorted(range(len(curves)), key=lambda k: -priorities[k])
    for _, rows in groupby(order, key=priorities.__getitem__):
        equal = [*rows]
        total = curves[equal].sum(axis=0)
        curves[equal] *= np.minimum(1.0, left / np.maximum(total, 1e-12))
        left = np.maximum(left - curves[equal].sum(axis=0), 0.0)
