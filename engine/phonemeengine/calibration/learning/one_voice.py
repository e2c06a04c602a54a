"""How much better a network does on a speaker whom it had not heard, once it knows a few seconds of him."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from phonemeengine.calibration.calibrate import calibrate
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import predict
from phonemeengine.calibration.scores.scoring import Answers
from phonemeengine.presets.preset import Preset

LEAST_READ, MOST_READ = 5.0, 10.0
"""Seconds that are learned: of one recording, or of the first ones that are as long together."""
MOST_JUDGED = 12
"""Further recordings of each speaker that are recognised before and after."""


class Adapted(NamedTuple):
    """What was answered in a recording of a speaker, before and after others of his were learned."""

    voice: str
    before: Answers
    after: Answers


def adapted_to_each(preset: Preset, utterances: Sequence[LabelledUtterance]) -> Iterator[Adapted]:
    """Have a preset learn some seconds of each speaker, as `calibrate` does, and recognise others of his recordings.

    Speakers of whom there is too little are left out.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    by_voice: dict[str, list[LabelledUtterance]] = {}
    for utterance in utterances:
        by_voice.setdefault(utterance.voice, []).append(utterance)
    for voice, said in by_voice.items():
        read = _some_seconds_of(said)
        others = [utterance for utterance in said if utterance not in read][:MOST_JUDGED]
        if not read or not others:
            continue
        learned = calibrate(preset, read).preset
        for other in others:
            yield Adapted(voice, predict(other, preset).answers, predict(other, learned).answers)


def _some_seconds_of(utterances: Sequence[LabelledUtterance]) -> list[LabelledUtterance]:
    for utterance in utterances:
        if LEAST_READ <= _seconds(utterance) <= MOST_READ:
            return [utterance]
    found: list[LabelledUtterance] = []
    for utterance in utterances:
        found.append(utterance)
        if sum(map(_seconds, found)) >= LEAST_READ:
            return found if sum(map(_seconds, found)) <= MOST_READ else []
    return []


def _seconds(utterance: LabelledUtterance) -> float:
    return utterance.labels[-1].end if utterance.labels else 0.0
