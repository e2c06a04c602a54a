"""What a game asks for every 10 or 20 ms."""

from typing import NamedTuple

from phonemeengine.analyser import Analysis
from phonemeengine.phonemes import Phoneme


class Reading(NamedTuple):
    """The phoneme that is heard now, and how loud it is, 0..1."""

    phoneme: Phoneme = Phoneme.SILENCE
    intensity: float = 0.0


def latest_reading(newest: Analysis | None) -> Reading:
    """Return the last frame of a block; silence where there is none yet."""
    if newest is None or len(newest) == 0:
        return Reading()
    return Reading(Phoneme(int(newest.phonemes[-1])), float(newest.intensities[-1]))
