"""When a mouth begins to move to each sound that is known before it is heard.

A movement takes about as long as a short sound. One that began with its sound would be over when the sound is:
vowels would be widest during the consonant after them. So each movement begins before its sound, and most of it is
done when the sound begins, as in people (anticipatory coarticulation). Lips, teeth or tongue that meet have met by
then, and stay so for a part of the sound; what comes after moves them apart before it ends.
"""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

from phonemeengine.mouth.cues import MOST_ANTICIPATION, ROUNDING, Cue
from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import Phoneme

OPENED, FADED = 0.7, 0.3
"""Share of a movement that is over when its sound begins; and when a silence does, since voices fade."""
ROUNDED = 0.8
"""The same of rounded vowels: lips are round early (Benguerel and Cowan 1974, Coarticulation of upper lip protrusion
in French)."""
HELD = 0.4
"""Share of a sound for which lips, teeth or tongue stay where they met."""
RELEASED = 0.06
"""Seconds before the end of a sound from which on what has met may move apart."""
QUICKEST = 0.65
"""Share of its time within which a movement that begins late may be done."""
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
    cues : the sounds without gaps, each from when it is heard; the mouth moves to the first of them already.
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
        begin = max(wanted, begun + APART, _held_until(before, table, rate))
        hurried = max(1.0 - (begin - wanted) / time, QUICKEST) if time else 1.0
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
        return FADED
    if _closes(cue, table):
        return 1.0
    return ROUNDED if cue.phoneme in (Phoneme.O, Phoneme.U) else OPENED


def _closes(cue: Cue, table: MouthTable) -> bool:
    return cue.phoneme is not Phoneme.SILENCE and table.closes(cue.phoneme, cue.phone)


def _held_until(cue: Cue, table: MouthTable, rate: float) -> float:
    """Return until when nothing moves apart what has met, seconds."""
    if not _closes(cue, table):
        return -math.inf
    held = max(cue.start + HELD * cue.duration, cue.end - RELEASED)
    return max(held, _picture_in(cue, rate)) if rate else held


def _picture_in(cue: Cue, rate: float) -> float:
    """Return when the first picture of a sound is taken; the one nearest to it where there is none, seconds."""
    first = math.ceil(cue.start * rate - ROUNDING) / rate
    return first if first <= cue.end else math.floor((cue.start + cue.end) / 2 * rate + 0.5) / rate
