"""What a voice's takes make of each recogniser's preset."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from engine.calibration.scores.corpus import Utterance
from engine.calibration.takes.check import check_take
from engine.calibration.takes.project import TakeProject
from engine.calibration.takes.room_noise import measure_room
from engine.errors import CorpusError, PresetError
from engine.presets.files import FACTORY, load_preset
from phonemeanalyser.models.calibration_guide import STEPS
from phonemeanalyser.models.calibration_of import calibration_of, outcome_of
from tests.desktop.calibrating import ROOM, in_room, said
from tests.sounds import silence


@pytest.fixture(scope="module")
def takes(tmp_path_factory: pytest.TempPathFactory) -> tuple[Utterance, ...]:
    """A take of each sound by one voice."""
    with TakeProject(tmp_path_factory.mktemp("project")) as project:
        for step in STEPS:
            sound = in_room(np.concatenate((silence(0.2), said(step.phoneme, 1.4))))
            project.add(sound, "Ann", step.phoneme, report=check_take(sound, ROOM, step.phoneme))
        return tuple(Utterance(project.path_of(t), t.to_labels(), t.speaker, "takes") for t in project.takes)


@pytest.mark.parametrize("name", ["thesis", "templates"])
def test_a_voice_is_recognised_better_after_its_takes(takes: tuple[Utterance, ...], name: str):
    preset = load_preset(FACTORY / f"{name}.toml")
    outcome = outcome_of(preset, takes)
    assert outcome.gains
    assert outcome.after.ten_f1 > outcome.before.ten_f1 + 0.05
    assert (outcome.preset.recogniser, outcome.preset.settings) == (preset.recogniser, preset.settings)


def test_the_room_sets_the_silence_of_rules(takes: tuple[Utterance, ...]):
    preset = load_preset(FACTORY / "thesis.toml")
    room = measure_room(in_room(silence(2.0)), preset)
    found = calibration_of(preset, takes, room)
    assert found.settings.denoise_threshold == room.thresholds(preset).settings.denoise_threshold


def test_what_gains_nothing_leaves_the_preset_as_it_was(takes: tuple[Utterance, ...]):
    preset = outcome_of(load_preset(FACTORY / "templates.toml"), takes).preset
    outcome = outcome_of(preset, takes)
    assert outcome.preset is preset
    assert not outcome.gains


def test_what_cannot_learn_says_so(takes: tuple[Utterance, ...]):
    preset = load_preset(FACTORY / "learned.toml")
    with pytest.raises(PresetError, match="no learned model"):
        calibration_of(replace(preset, model=None), takes)
    with pytest.raises(CorpusError, match="no take to calibrate with"):
        outcome_of(preset, ())


def test_files_of_takes_stay_as_they_are(takes: tuple[Utterance, ...]):
    before = [Path(u.path).read_bytes() for u in takes]
    outcome_of(load_preset(FACTORY / "templates.toml"), takes)
    assert [Path(u.path).read_bytes() for u in takes] == before
