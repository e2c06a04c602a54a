"""Mouth cues: which shape the mouth has from when to when, cleaned for animators.

A cue that is too short would flicker. What is done about it depends on what it is: lips that meet are seen even when
brief, so m and p take the time that they lack from their neighbours, as phones do of which the table says that they
are firm; everything else gives its time to them.
"""

import heapq
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

from phonemeengine.errors import MouthError, check_range
from phonemeengine.labels.phone_sets import narrowest
from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import VOWELS, Phoneme
from phonemeengine.recognition.segments import Segment

MINIMUM = 0.06
"""Seconds that a cue lasts at least, unless told otherwise."""
LONGEST_MINIMUM = 1.0
ROUNDING = 1e-9
"""Seconds by which a cue may fall short of the minimum, since differences of times are rounded."""
MOST_ANTICIPATION = 0.12
"""Seconds that the mouth may be ahead of the sound at most."""


@dataclass(frozen=True, slots=True)
class Cue:
    """An interval of one mouth shape.

    Attributes
    ----------
    start, end : seconds.
    phoneme : what is said.
    shape : the mouth shape that the table has for it.
    intensity : mean intensity, 0..1.
    phone : its symbol in the International Phonetic Alphabet; of several, that of the longest. Empty where only the
        phoneme is known.
    """

    start: float
    end: float
    phoneme: Phoneme
    shape: str
    intensity: float
    phone: str = ""

    @property
    def duration(self) -> float:
        """Its length, seconds."""
        return self.end - self.start


def cues_of(
    runs: Iterable[Segment], table: MouthTable, *, minimum: float = MINIMUM, anticipation: float = 0.0
) -> tuple[Cue, ...]:
    """Make cues of the runs of a sound; they cover it from its beginning to its end, without gaps.

    Parameters
    ----------
    runs : what was said, without gaps; see `segments_of`.
    table : the mouth shapes.
    minimum : least duration of a cue, seconds; a sound that is shorter is one cue.
    anticipation : by how much the mouth is ahead of vowels, seconds; it is ahead of lips that meet by the time that
        they take to close at most, so that they are shut when m and p sound. What comes before is shortened by it
        to half at most, and not below the minimum.

    Raises
    ------
    MouthError : a time lies outside its range.
    """
    check_seconds("minimum", minimum, LONGEST_MINIMUM)
    check_seconds("anticipation", anticipation, MOST_ANTICIPATION)
    cues = _joined(
        _Chain(joined_runs((run for run in runs if run.end > run.start), table), minimum, table).cleaned(), _alike
    )
    begins = _begins_of(cues, table, anticipation, minimum)
    ends = [*begins[1:], *(cue.end for cue in cues[-1:])]
    return tuple(replace(cue, start=start, end=end) for cue, start, end in zip(cues, begins, ends, strict=True))


def joined_runs(runs: Iterable[Segment], table: MouthTable) -> list[Cue]:
    """Make cues of runs, however short, of which neighbours of one phoneme and shape are one."""
    return _joined((_cue_of(run, table) for run in runs), _alike)


def _begins_of(cues: Sequence[Cue], table: MouthTable, anticipation: float, minimum: float) -> list[float]:
    """Return when each cue begins: vowels, and lips that meet, early; see `cues_of`."""
    begins = [cue.start for cue in cues[:1]]
    for before, cue in pairwise(cues):
        lead = _lead_of(cue, table, anticipation)
        begins.append(cue.start - min(lead, before.duration / 2, max(before.duration - minimum, 0.0)))
    return begins


def joined_by_shape(cues: Iterable[Cue]) -> tuple[Cue, ...]:
    """Join neighbours of one shape, for programs that show drawings: a drawing that stays is one cue."""
    return tuple(_joined(cues, lambda one, other: one.shape == other.shape))


def check_seconds(name: str, value: float, most: float) -> None:
    """Refuse a time that lies outside 0..`most`, seconds.

    Raises
    ------
    MouthError : it does.
    """
    check_range(name, value, (0, most, "s"), MouthError)


def _cue_of(run: Segment, table: MouthTable) -> Cue:
    shape = table.shape_of(run.phoneme, run.phone)
    return Cue(run.start, run.end, run.phoneme, shape, run.intensity, run.phone)


def _lead_of(cue: Cue, table: MouthTable, anticipation: float) -> float:
    """Return by how much the mouth would be ahead of a cue, seconds."""
    if cue.phoneme != Phoneme.SILENCE and table.closes(cue.phoneme, cue.phone):
        return min(anticipation, table.times_of(cue.phoneme, cue.phone).to_shape)
    return anticipation if cue.phoneme in VOWELS else 0.0


def _alike(one: Cue, other: Cue) -> bool:
    return one.phoneme == other.phoneme and one.shape == other.shape


def _joined(cues: Iterable[Cue], same: Callable[[Cue, Cue], bool]) -> list[Cue]:
    joined: list[Cue] = []
    for cue in cues:
        if joined and same(joined[-1], cue):
            joined[-1] = _union(joined[-1], cue)
        else:
            joined.append(cue)
    return joined


def _union(one: Cue, other: Cue) -> Cue:
    longer = one if one.duration >= other.duration else other
    total = one.duration + other.duration
    mean = (one.intensity * one.duration + other.intensity * other.duration) / total if total else one.intensity
    silent = longer.phoneme == Phoneme.SILENCE
    return replace(longer, start=one.start, end=other.end, intensity=0.0 if silent else mean)


class _Chain:
    """Cues of which each knows its neighbours, so that the shortest can be dealt with first."""

    def __init__(self, cues: list[Cue], minimum: float, table: MouthTable) -> None:
        self._cues: list[Cue | None] = list(cues)
        self._before = list(range(-1, len(cues) - 1))
        self._after = [*range(1, len(cues)), -1]
        self._minimum = minimum
        self._least = minimum - ROUNDING
        self._table = table
        self._shortest: list[tuple[float, int]] = []

    def cleaned(self) -> list[Cue]:
        """Deal with every cue that is too short, the shortest first."""
        for k in range(len(self._cues)):
            self._watch(k)
        while self._shortest:
            duration, k = heapq.heappop(self._shortest)
            cue = self._cues[k]
            if cue is not None and cue.duration == duration and not self._lengthened(k, cue):
                self._dissolve(k, cue)
        return [cue for cue in self._cues if cue is not None]

    def _watch(self, k: int) -> None:
        cue = self._cues[k]
        if cue is not None and cue.duration < self._least:
            heapq.heappush(self._shortest, (cue.duration, k))

    def _at(self, k: int) -> Cue | None:
        return self._cues[k] if k >= 0 else None

    def _lengthened(self, k: int, cue: Cue) -> bool:
        """Have lips that meet take what they lack from neighbours that can spare it."""
        lack = self._minimum - cue.duration
        before, after = self._at(self._before[k]), self._at(self._after[k])
        spares = [max(other.duration - self._minimum, 0.0) if other else 0.0 for other in (before, after)]
        if not self._table.closes(cue.phoneme, cue.phone) or sum(spares) < lack:
            return False
        first = min(spares[0], max(lack / 2, lack - spares[1]))
        self._cues[k] = replace(cue, start=cue.start - first, end=cue.end + lack - first)
        if before and first:
            self._cues[self._before[k]] = replace(before, end=before.end - first)
        if after and lack > first:
            self._cues[self._after[k]] = replace(after, start=after.start + lack - first)
        return True

    def _dissolve(self, k: int, cue: Cue) -> None:
        """Give the time of a cue to a neighbour that is too short as well, else half of it to each."""
        b, a = self._before[k], self._after[k]
        before, after = self._at(b), self._at(a)
        if before is None and after is None:
            return
        self._cues[k] = None
        if before is not None:
            self._after[b] = a
        if after is not None:
            self._before[a] = b
        border = self._border(cue, before, after)
        if before is not None:
            self._cues[b] = replace(before, end=border)
        if after is not None:
            self._cues[a] = replace(after, start=border)
        self._unite(b, a)

    def _border(self, cue: Cue, before: Cue | None, after: Cue | None) -> float:
        if before is None or after is None:
            return cue.start if before is None else cue.end
        short = [other.duration < self._least for other in (before, after)]
        if short[0] != short[1]:
            return cue.end if short[0] else cue.start
        return (cue.start + cue.end) / 2

    def _unite(self, b: int, a: int) -> None:
        """Join the neighbours of a cue that went, where they are alike; else look at each again."""
        before, after = self._at(b), self._at(a)
        if before is not None and after is not None and _alike(before, after):
            self._cues[b], self._cues[a] = _union(before, after), None
            self._after[b] = self._after[a]
            if self._after[a] >= 0:
                self._before[self._after[a]] = b
            self._watch(b)
            return
        for k in (b, a):
            if k >= 0:
                self._watch(k)


# When a mouth begins to move to each sound that is known beforehand.
#
# A movement takes about as long as a short sound. One that began with its sound would be over when the sound is:
# vowels would be widest during the consonant after them. So each movement begins before its sound, and most of it is
# done when the sound begins, as in people (anticipatory coarticulation). Lips, teeth or tongue that meet have met by
# then, and stay so for a part of the sound; what comes after moves them apart before it ends.

APART = 0.005
"""Seconds between the beginnings of two movements at least."""


class PlannedMovement(NamedTuple):
    """A movement of the mouth to a sound.

    Attributes
    ----------
    begin : when it begins, seconds.
    time_share : how long it takes, as a share of the time that the table has for it.
    cue : the sound.
    end : when it is over, seconds.
    """

    begin: float
    time_share: float
    cue: Cue
    end: float


def planned_movements(
    cues: Sequence[Cue],
    table: MouthTable,
    begun: float,
    anticipation: float = MOST_ANTICIPATION,
    *,
    rate: float = 0.0,
) -> list[PlannedMovement]:
    """Plan when the mouth begins to move to each sound but the first, in order.

    Parameters
    ----------
    cues : the sounds without gaps, each from when it sounds; the mouth moves to the first of them already.
    table : the mouth shapes, and how the mouth moves between them.
    begun : when the movement to the first sound was to begin, seconds; no other one begins before.
    anticipation : by how much a movement may begin before its sound at most, seconds.
    rate : pictures per second that are taken of the mouth; 0 where that is not known. Lips, teeth or tongue that meet
        between two pictures stay so until the next one.
    """
    planned: list[PlannedMovement] = []
    for before, cue in pairwise(cues):
        time = _time_to(cue, before, table)
        lead = min(_share_before(cue, table) * time, anticipation)
        if rate and _closes(cue, table):
            lead = max(lead, cue.start - _picture_in(cue, rate) + time)
        wanted = cue.start - lead
        begin = max(wanted, begun + APART, _held_until(before, cue, table, rate))
        hurried = max(1.0 - (begin - wanted) / time, table.movement.quickest) if time else 1.0
        planned.append(PlannedMovement(begin, hurried, cue, begin + hurried * time))
        begun = begin
    return planned


def _time_to(cue: Cue, before: Cue, table: MouthTable) -> float:
    """Return how long the movement to a sound takes, seconds."""
    if cue.phoneme is not Phoneme.SILENCE:
        return table.times_of(cue.phoneme, cue.phone).to_shape
    return 0.0 if before.phoneme is Phoneme.SILENCE else table.times_of(before.phoneme, before.phone).to_rest


def _share_before(cue: Cue, table: MouthTable) -> float:
    if cue.phoneme is Phoneme.SILENCE:
        return table.movement.faded
    if _closes(cue, table):
        return 1.0
    return table.movement.rounded if cue.phoneme in (Phoneme.O, Phoneme.U) else table.movement.opened


def _closes(cue: Cue, table: MouthTable) -> bool:
    return cue.phoneme is not Phoneme.SILENCE and table.closes(cue.phoneme, cue.phone)


def _held_until(cue: Cue, after: Cue, table: MouthTable, rate: float) -> float:
    """Return until when nothing moves apart what has met, seconds.

    Of two closures side by side, one of higher priority takes all its time, one of lower priority gives way.
    """
    if not _closes(cue, table):
        return -math.inf
    width = narrowest(table.widths, cue.phone or cue.phoneme.label, 1.0)
    share = min(table.movement.held * width, 1.0)
    held = max(cue.start + share * cue.duration, cue.end - table.movement.released / width)
    if table.priorities and _closes(after, table):
        mine, other = (narrowest(table.priorities, one.phone or one.phoneme.label, 0.0) for one in (cue, after))
        held = cue.end if mine > other else cue.start if mine < other else held
    return max(held, _picture_in(cue, rate)) if rate else held


def _picture_in(cue: Cue, rate: float) -> float:
    """Return when the first picture of a sound is taken; the one nearest to it where there is none, seconds."""
    first = math.ceil(cue.start * rate - ROUNDING) / rate
    return first if first <= cue.end else math.floor((cue.start + cue.end) / 2 * rate + 0.5) / rate
