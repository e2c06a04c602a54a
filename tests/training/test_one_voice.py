"""What a few seconds of a stranger are worth."""

from pathlib import Path

import numpy as np
import pytest

from phonemeengine.calibration.calibrate import calibrate
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import predict
from phonemeengine.labels.label import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import load_preset
from phonemetraining.validation import MOST_JUDGED, adapted_to_each
from tests.corpora import put
from tests.sounds import noise, vowel

FORMANTS = {Phoneme.A: (750, 1250, 2500), Phoneme.I: (300, 2200, 3000), Phoneme.U: (310, 800, 2300)}


def spoken(folder: Path, speaker: str, number: int, n_rounds: int) -> LabelledUtterance:
    """A recording of a voice that says vowels."""
    parts, labels, at = [], [], 0.0
    for k in range(4 * n_rounds):
        phoneme = (*FORMANTS, Phoneme.SILENCE)[k % 4]
        parts.append(vowel(FORMANTS[phoneme], 0.4, 200 + number) if phoneme in FORMANTS else noise(0.4, 1e-4))
        labels.append(Label(at, at + 0.4, phoneme.label, phoneme))
        at += 0.4
    put(folder, f"{speaker}{number}", np.concatenate(parts), tuple(labels))
    return LabelledUtterance(folder / f"{speaker}{number}.wav", tuple(labels), speaker, "made")


@pytest.mark.parametrize("lengths", [(1, 4, 1), (2, 2, 1)])
def test_one_recording_or_the_first_ones_that_are_as_long_are_learned_and_others_judge(tmp_path: Path, lengths):
    utterances = [spoken(tmp_path, "ann", k, n) for k, n in enumerate(lengths)]
    preset = load_preset("templates")
    read = [utterances[1]] if 4 in lengths else utterances[:2]
    others = [u for u in utterances if u not in read]
    learned = calibrate(preset, read).preset
    found = list(adapted_to_each(preset, utterances))
    assert [a.voice for a in found] == ["made/ann"] * len(others)
    for adapted, other in zip(found, others, strict=True):
        assert (adapted.before[1] == predict(other, preset).phonemes).all()
        assert (adapted.after[1] == predict(other, learned).phonemes).all()


def test_of_who_said_little_or_nothing_else_nothing_is_told_and_of_who_said_much_a_part(tmp_path: Path):
    preset = load_preset("templates")
    little = [spoken(tmp_path, "bob", k, 1) for k in range(3)]
    alone = [spoken(tmp_path, "cat", 0, 4)]
    much = [spoken(tmp_path, "dan", k, 4) for k in range(MOST_JUDGED + 3)]
    assert [a.voice for a in adapted_to_each(preset, [*little, *alone, *much])] == ["made/dan"] * MOST_JUDGED
