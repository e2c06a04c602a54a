"""A style fitted to recorded performances: how far, how fast and with which closures a person speaks.

The rules say what was said in the recordings, in styles that differ in one number each, and the style whose face is
the nearest to the recorded ones counts: least squares of the blend shapes of the mouth.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import PerformanceError
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.labels.phone_sets import phone_classes_in
from phonemeengine.mouth.animation import animation_of
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.performer import MOUTH_ALONE
from phonemeengine.mouth.style import LEFT_BEHIND, Style, firm_shapes
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.performance.driver import MOUTH
from phonemeengine.performance.recording import SILENCE, Performance, PerformedPhone
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import Segment
from phonemeengine.settings import FRAME_PERIOD

MOST_SECONDS = 60.0
"""Of recordings that are fitted to; more say nothing new, and take longer."""
LONGEST_SAID = 20.0
"""Seconds of a recording that count at most."""
SILENT_LEVEL, LOUD_LEVEL = -45.0, -3.0
"""Levels of a phone, dB beside full scale, at which its intensity is 0 and 1."""
FACTORS = 0.4, 2.5
"""Least and greatest factors of times and widths that are tried."""
SPREADS, STEPS = (2.5, 1.4, 1.15), 7
"""How far from the best factors so far others are tried, in turn, and how many each time."""
MOST_REACH = 2.0
DIGITS = 3
"""Behind the point, that are kept of what was fitted."""
CLOSURES = ("p", "b", "m", "labiodental")
_SIDED = tuple(
    (f"{name}Left", f"{name}Right")
    for name in ("mouthStretch", "mouthSmile", "mouthLowerDown", "mouthUpperUp", "mouthDimple")
)


@dataclass(frozen=True)
class FittedStyle:
    """A style that was fitted.

    Attributes
    ----------
    style : the style.
    speed : factor of the rules' times.
    width : factor of the time for which lips and teeth stay closed.
    before, after : root mean square difference of the mouth's weights, 0..1, in the neutral style and in this one.
    seconds : of the recordings that were used.
    """

    style: Style
    speed: float
    width: float
    before: float
    after: float
    seconds: float


def fit_style(performances: Iterable[Performance], name: str, progress: Progress = no_progress) -> FittedStyle:
    """Fit reach, speed, closures and asymmetry to recordings, of which the first minute counts.

    Parameters
    ----------
    performances : at least one with speech, and with blend shapes of ARKit for both sides of a mouth.
    name : of the style.

    Raises
    ------
    PerformanceError : no recording has speech and a mouth that moves.
    Cancelled : `progress` did not want to go on.
    """
    takes = [*_takes_of(performances)]
    fit = _StyleFit(takes)
    if not fit.moves:
        raise PerformanceError("no recording has both speech and a mouth that moves; choose others")
    speed = width = 1.0
    for k, spread in enumerate(SPREADS):
        report_progress(progress, k / len(SPREADS))
        speed = _lowest(partial(fit.residual, width=width), speed, spread)
        width = _lowest(partial(fit.residual, speed, closing=True), width, spread)
    report_progress(progress, 1.0)
    speed, width = round(speed, DIGITS), round(width, DIGITS)
    style = _style_with(round(min(fit.reach(speed, width), MOST_REACH), DIGITS), speed, width)
    style = replace(style, name=name, asymmetry=_asymmetry_of(takes))
    seconds = sum(take.said.duration for take in takes)
    return FittedStyle(style, speed, width, fit.difference(Style()), fit.difference(style), seconds)


def _lowest(difference: Callable[[float], float], around: float, spread: float) -> float:
    """Return the factor about another one at which a difference is least, on a parabola through the least three."""
    low, high = (min(max(around * factor, FACTORS[0]), FACTORS[1]) for factor in (1 / spread, spread))
    factors = np.geomspace(low, high, STEPS)
    found = np.array([difference(factor) for factor in factors.tolist()])
    k = min(max(int(found.argmin()), 1), STEPS - 2)
    before, least, after = found[k - 1 : k + 2].tolist()
    bend = before - 2 * least + after
    shift = (before - after) / (2 * bend) if bend > 0 else 0.0
    return float(factors[k] * (factors[1] / factors[0]) ** min(max(shift, -1.0), 1.0))


def _asymmetry_of(takes: list["_RecordedTake"]) -> float:
    """Return how far the right half of the mouth stays behind the left one, as an amount."""
    left, right = (
        np.concatenate([take.weights[:, [ARKIT.index(name) for name in names]].ravel() for take in takes])
        for names in zip(*_SIDED, strict=True)
    )
    share = float(np.sqrt((right**2).sum() / (left**2).sum())) if left.any() else 1.0  # noise moves both alike
    return round(min(max((1 - share) / LEFT_BEHIND, 0.0), 1.0), DIGITS)


@dataclass(frozen=True, eq=False)
class _RecordedTake:
    """A recording as the rules need it, and what its mouth did at the rate of its frames."""

    said: Transcript
    rate: float
    weights: Float32Array
    closing: Float64Array


def _takes_of(performances: Iterable[Performance]) -> Iterator[_RecordedTake]:
    seconds = 0.0
    for performance in performances:
        names = [name for name in ARKIT if name.startswith(MOUTH) and name in performance.channels]
        phones = [phone for phone in performance.phones if phone.start < LONGEST_SAID]
        if not names or all(phone.name == SILENCE for phone in phones):
            continue
        duration = min(performance.duration, phones[-1].end)
        n = min(len(performance.weights), int(duration * performance.rate))
        weights = np.zeros((n, len(ARKIT)), np.float32)
        for channel in names:
            weights[:, ARKIT.index(channel)] = performance.weights[:n, performance.channels.index(channel)]
        yield _RecordedTake(_said(phones, duration), performance.rate, weights, _closing(phones, n, performance.rate))
        seconds += duration
        if seconds >= MOST_SECONDS:
            return


def _said(phones: Sequence[PerformedPhone], duration: float) -> Transcript:
    """Return what is said as the rules take it, with the loudness of each phone."""
    runs = tuple(_run_of(phone) for phone in phones)
    times = (np.arange(round(duration / FRAME_PERIOD)) + 0.5) * FRAME_PERIOD
    places = np.minimum(np.searchsorted([run.end for run in runs], times), len(runs) - 1)
    loud = np.array([run.intensity for run in runs], np.float32)[places]
    return Transcript("", duration, runs, loud, np.zeros(len(loud), np.float32))


def _run_of(phone: PerformedPhone) -> Segment:
    if phone.name == SILENCE:
        return Segment(phone.start, phone.end, Phoneme.SILENCE, 0.0)
    known = phone_classes_in(phone.name)[1]
    phoneme = Phoneme.UNIDENTIFIED if known is None else known.phoneme
    loud = (phone.energy - SILENT_LEVEL) / (LOUD_LEVEL - SILENT_LEVEL)
    return Segment(phone.start, phone.end, phoneme, min(max(loud, 0.0), 1.0), phone.name)


def _closing(phones: Sequence[PerformedPhone], n: int, rate: float) -> Float64Array:
    """Return which frames lie in or beside a closure of the lips, shape (n_frames,), 0 or 1."""
    times, inside = np.arange(n) / rate, np.zeros(n)
    for phone in phones:
        if phone.name in {"p", "b", "m"}:
            inside[(times > phone.start - phone.duration / 2) & (times < phone.end + phone.duration / 2)] = 1.0
    return inside


def _style_with(reach: float, speed: float, width: float) -> Style:
    style = Style()
    movement = replace(style.movement, reach=reach, vowels=speed, consonants=speed, closures=speed)
    poses = style.closures.phones
    phones = {key: replace(pose, width=width) if key in CLOSURES else pose for key, pose in poses.items()}
    return replace(style, movement=movement, closures=replace(style.closures, phones=phones))


class _StyleFit:
    """Has the rules say all recordings in a style, and compares."""

    def __init__(self, takes: list[_RecordedTake]) -> None:
        self._takes, self._table = takes, load_table(USUAL_TABLE).with_motion(1.0, 1.0, random=False)
        self._made_with, self._made = (0.0, 0.0), list[tuple[Float64Array, ...]]()
        moved = [any(np.ptp(take.weights[:, k]) > 0 for take in takes) for k in range(len(ARKIT))]
        self._columns = [k for k, name in enumerate(ARKIT) if moved[k] and not name.endswith("Right")]
        self.moves = bool(self._columns)

    def difference(self, style: Style) -> float:
        """Return the root mean square difference of the mouth's weights, of the left half and the middle."""
        table = style.on_table(self._table)
        parts = [(self._by_rules(take, table)[:, self._columns] - seen).ravel() for take, seen in self._seen()]
        return float(np.sqrt(np.mean(np.concatenate(parts) ** 2)))

    def reach(self, speed: float, width: float) -> float:
        """Return how far the mouth goes beside the rules where nothing meets, by least squares."""
        pairs = [*self._parts(speed, width)]
        met, loose, seen = (np.concatenate([pair[k] for pair in pairs]) for k in range(3))
        return max(float((loose * (seen - met)).sum() / max((loose * loose).sum(), 1e-9)), 0.0)

    def residual(self, speed: float, width: float, *, closing: bool = False) -> float:
        """Return what is left of the recordings by the best reach: about closures alone, or in all frames."""
        reach, total = self.reach(speed, width), 0.0
        for (met, loose, seen), take in zip(self._parts(speed, width), self._takes, strict=True):
            counts = take.closing if closing else 1.0
            total += float((np.square(met + reach * loose - seen).sum(axis=1) * counts).sum())
        return total

    def _seen(self) -> Iterator[tuple[_RecordedTake, Float32Array]]:
        return ((take, take.weights[:, self._columns]) for take in self._takes)

    def _parts(self, speed: float, width: float) -> list[tuple[Float64Array, ...]]:
        """Return of each recording what the rules make of closures, and of all else, and what it is."""
        if (speed, width) != self._made_with:
            table, firm = _style_with(1.0, speed, width).on_table(self._table), firm_shapes(self._table)
            shapes = {
                name: shape if name in firm else {_loose(state): percent for state, percent in shape.items()}
                for name, shape in table.shapes.items()
            }
            parted = replace(table, movestates=(*ARKIT, *map(_loose, ARKIT)), shapes=shapes)
            self._made_with, self._made = (speed, width), []
            for take, seen in self._seen():
                both = self._by_rules(take, parted).astype(np.float64)
                parts = (both[:, : len(ARKIT)], both[:, len(ARKIT) :])
                self._made.append((*(part[:, self._columns] for part in parts), seen.astype(np.float64)))
        return self._made

    @staticmethod
    def _by_rules(take: _RecordedTake, table: MouthTable) -> Float32Array:
        return animation_of(take.said, table, take.rate, MOUTH_ALONE).weights[: len(take.weights)]


def _loose(movestate: str) -> str:
    """Return what a movestate is called where nothing meets."""
    return f"{movestate} loose"
