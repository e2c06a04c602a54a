"""The numbers of a style, each with its limits; the values here are those of the neutral style."""

from dataclasses import dataclass, field, fields, replace
from typing import Any

from phonemeengine.errors import MouthError, check_range


def _number(value: float, low: float, high: float, unit: str = "") -> Any:
    return field(default=value, metadata={"limits": (low, high, unit)})


@dataclass(frozen=True)
class StyleNumbers:
    """Numbers that a style names.

    Raises
    ------
    MouthError : one lies outside its limits.
    """

    def __post_init__(self) -> None:
        for entry in fields(self):
            check_range(entry.name, getattr(self, entry.name), entry.metadata["limits"], MouthError)


@dataclass(frozen=True)
class MovementNumbers(StyleNumbers):
    """How the mouth of a mouth table moves.

    Attributes
    ----------
    reach : how far it goes to shapes at which nothing meets, beside the table; of recorded faces, too.
    vowels, consonants, closures : factors of the times of movements to vowels, to consonants, and to what meets.
    opened, faded, rounded : share of a movement that is over when its sound begins; when silence does, since voices
        fade; and when rounded vowels do, since lips are round early (Benguerel and Cowan 1974, Coarticulation of
        upper lip protrusion in French).
    held : share of a sound for which lips, teeth or tongue stay where they met.
    released : seconds before the end of a sound from which on what has met may move apart.
    quickest : share of its time within which a movement that begins late may be done.
    """

    reach: float = _number(1.0, 0.0, 2.0)
    vowels: float = _number(1.0, 0.25, 4.0)
    consonants: float = _number(1.0, 0.25, 4.0)
    closures: float = _number(1.0, 0.25, 4.0)
    opened: float = _number(0.7, 0.0, 1.0)
    faded: float = _number(0.3, 0.0, 1.0)
    rounded: float = _number(0.8, 0.0, 1.0)
    held: float = _number(0.4, 0.0, 1.0)
    released: float = _number(0.06, 0.0, 0.5, "s")
    quickest: float = _number(0.65, 0.1, 1.0)


@dataclass(frozen=True)
class PoseNumbers(StyleNumbers):
    """How poses come and go over recorded faces.

    Attributes
    ----------
    plateau, place : share of a phone for which its pose holds, and share after which the middle of that comes.
    coming, least_coming, most_coming : standard deviation of the flank before, beside the phone before; its limits,
        seconds.
    leaving, least_leaving, most_leaving : those of the flank after, beside the phone after.
    longest_neighbour : a longer phone beside it counts as so long, seconds.
    full_length : seconds that a phone lasts whose pose is met wholly, unless it is firm.
    """

    plateau: float = _number(0.25, 0.0, 1.0)
    place: float = _number(0.35, 0.0, 1.0)
    coming: float = _number(0.25, 0.0, 1.0)
    least_coming: float = _number(0.015, 0.001, 0.2, "s")
    most_coming: float = _number(0.05, 0.001, 0.2, "s")
    leaving: float = _number(0.18, 0.0, 1.0)
    least_leaving: float = _number(0.012, 0.001, 0.2, "s")
    most_leaving: float = _number(0.04, 0.001, 0.2, "s")
    longest_neighbour: float = _number(0.12, 0.01, 1.0, "s")
    full_length: float = _number(0.07, 0.01, 1.0, "s")


@dataclass(frozen=True)
class FilterNumbers(StyleNumbers):
    """How recorded faces are smoothed, and what loudness does to them.

    Attributes
    ----------
    syllable, word : cut-off frequencies within syllables and words, beside the number of phones a second.
    phrase, above_word : that within the sentence, Hz at least, and beside the one within words.
    gain : by how much the jaw opens farther for 12 dB.
    """

    syllable: float = _number(0.5, 0.05, 5.0)
    word: float = _number(0.7, 0.05, 5.0)
    phrase: float = _number(10.0, 1.0, 30.0, "Hz")
    above_word: float = _number(1.1, 1.0, 5.0)
    gain: float = _number(0.5, 0.0, 2.0)


@dataclass(frozen=True)
class GestureNumbers(StyleNumbers):
    """How the head goes with speech.

    Attributes
    ----------
    rise : degrees that it rises when the pitch lies a semitone above the usual one.
    nod : degrees that it sinks at full loudness.
    sway_yaw, sway_pitch, sway_roll : degrees that it wanders by itself; half of it in silence.
    size : factor of recorded phrases, and of the gestures at key words.
    """

    rise: float = _number(0.5, 0.0, 5.0, "degrees")
    nod: float = _number(2.5, 0.0, 20.0, "degrees")
    sway_yaw: float = _number(1.6, 0.0, 20.0, "degrees")
    sway_pitch: float = _number(1.0, 0.0, 20.0, "degrees")
    sway_roll: float = _number(0.9, 0.0, 20.0, "degrees")
    size: float = _number(1.0, 0.0, 3.0)

    def scaled(self, factor: float) -> "GestureNumbers":
        """Return all of them multiplied by a factor, as far as their limits allow."""
        scaled = {
            entry.name: min(getattr(self, entry.name) * factor, entry.metadata["limits"][1]) for entry in fields(self)
        }
        return self if factor == 1.0 else replace(self, **scaled)
