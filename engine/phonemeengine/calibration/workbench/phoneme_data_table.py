"""The 21 numbers of PhonemeData beside what they divide: least, mean and greatest values, speaker by speaker."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import chain

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.controls import CONDITION_OF
from phonemeengine.recognition.rules import LAYOUT, RULES, Condition, PhonemeData

ALL_SPEAKERS = "all"
"""What the frames of all speakers together are called, where there are several."""


@dataclass(frozen=True)
class ValueRange:
    """How far a variable reaches.

    Attributes
    ----------
    n : frames.
    least, mean, greatest : of their values.
    """

    n: int
    least: float
    mean: float
    greatest: float


@dataclass(frozen=True)
class Sides:
    """A variable in the sounds that a comparison divides; None where there are no frames of a side.

    Attributes
    ----------
    holds : where the comparison ought to hold.
    fails : where it ought to fail.
    """

    holds: ValueRange | None
    fails: ValueRange | None


@dataclass(frozen=True)
class NumberRow:
    """A number of PhonemeData, and what it divides.

    Attributes
    ----------
    name : the number's.
    variable, sign : what is compared with it, and how; empty for the numbers of the filters.
    holds, fails : the sounds for which the comparison ought to hold, and those that it keeps off.
    by_speaker : the variable's values, in all speakers together first if there are several.
    """

    name: str
    variable: str = ""
    sign: str = ""
    holds: tuple[Phoneme, ...] = ()
    fails: tuple[Phoneme, ...] = ()
    by_speaker: Mapping[str, Sides] | None = None


def sounds_divided(condition: Condition) -> tuple[tuple[Phoneme, ...], tuple[Phoneme, ...]]:
    """Return the sounds for which a comparison of the thesis rules ought to hold, and those that it keeps off.

    The latter are what the rules after it may still name where all else of the rule holds. Where none comes after it,
    they are the sounds of the earlier rules that compare the same variable the other way round.
    """
    holds = [rule for rule in RULES if condition in rule.conditions]
    first = holds[0]
    others = set(first.conditions) - {condition}
    fails = []
    for rule in RULES[RULES.index(first) + 1 :]:
        if condition in rule.conditions:
            continue
        fails.append(rule)
        if set(rule.conditions) <= others:
            break  # it fires wherever the others hold, so no rule after it is asked
    opposite = condition.variable, "<" if condition.sign == ">" else ">"
    fails = fails or [rule for rule in RULES if opposite in {(c.variable, c.sign) for c in rule.conditions}]
    return tuple(dict.fromkeys(r.phoneme for r in holds)), tuple(dict.fromkeys(r.phoneme for r in fails))


def number_rows(labelled: LabelledFeatures | None) -> tuple[NumberRow, ...]:
    """Return a row for each of the 21 numbers, in the order of a PhonemeData file.

    Parameters
    ----------
    labelled : the recordings; frames whose label is not certain are left out. Without them the rows have no values.
    """
    speakers = {} if labelled is None else _frames_by_speaker(labelled)
    return tuple(_row(name, labelled, speakers) for name in chain.from_iterable(LAYOUT))


def _row(name: str, labelled: LabelledFeatures | None, speakers: Mapping[str, BoolArray]) -> NumberRow:
    condition = CONDITION_OF.get(name)
    if condition is None:
        return NumberRow(name, by_speaker={})
    holds, fails = sounds_divided(condition)
    found = {}
    if labelled is not None:
        values, phonemes = labelled.values(condition.variable), labelled.labels.phonemes
        sides = [np.isin(phonemes, side) for side in (holds, fails)]
        found = {
            speaker: Sides(*(_range_of(values[frames & side]) for side in sides))
            for speaker, frames in speakers.items()
        }
    return NumberRow(name, condition.variable, condition.sign, holds, fails, found)


def _frames_by_speaker(labelled: LabelledFeatures) -> dict[str, BoolArray]:
    """Return which certain frames are whose."""
    certain = labelled.labels.certain
    of_recordings = np.array([u.speaker for u in labelled.utterances], object)
    of_frames = np.repeat(of_recordings, np.diff(labelled.edges))
    names = list(dict.fromkeys(of_recordings.tolist()))
    everyone = {ALL_SPEAKERS: certain} if len(names) > 1 else {}
    return everyone | {name: certain & (of_frames == name) for name in names}


def _range_of(values: Float32Array) -> ValueRange | None:
    if not len(values):
        return None
    return ValueRange(len(values), float(values.min()), float(values.mean(dtype=float)), float(values.max()))


# The same as rows of a file.

NUMBER_COLUMNS = (
    "number", "value", "other", "variable", "sign",
    "speaker", "side", "sounds", "frames", "least", "mean", "greatest",
)  # fmt: skip
"""`other` is the number of the preset that is compared with; `side` says whether the comparison ought to hold."""


def number_table(
    rows: tuple[NumberRow, ...], data: PhonemeData, other: PhonemeData | None = None
) -> Iterator[tuple[str, ...]]:
    """Yield the rows as text, as `NUMBER_COLUMNS`: one for each number, speaker and side."""
    for row in rows:
        numbers = ["" if of is None else _written(getattr(of, row.name)) for of in (data, other)]
        head = (row.name, *numbers, row.variable, row.sign)
        if not row.by_speaker:
            yield (*head, *[""] * 7)
        for speaker, sides in (row.by_speaker or {}).items():
            for side, sounds, found in (("holds", row.holds, sides.holds), ("fails", row.fails, sides.fails)):
                labels = " ".join(sound.label for sound in sounds)
                reach = ("0", "", "", "") if found is None else _cells(found)
                yield (*head, speaker, side, labels, *reach)


def _cells(found: ValueRange) -> tuple[str, ...]:
    return (str(found.n), *(_written(value) for value in (found.least, found.mean, found.greatest)))


def _written(value: float) -> str:
    return f"{value:.6g}"
