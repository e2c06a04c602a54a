"""What commands hear files with: the best that a preset has, or what is asked for."""

import json
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeengine import Phoneme, Preset, SoundReader, cues, for_files, load_preset, transcribe
from phonemeengine.analyser import analyse_file
from phonemeengine.presets.files import save_preset
from phonemeengine.settings import SAMPLE_RATE, AnalysisSettings, Ear
from tests.models import centred_model, tone_model
from tests.sounds import silence, tone
from tests.tables import rows_of

SOUND = np.concatenate([silence(0.2), tone(700, 0.5, 0.5), silence(0.3), tone(2500, 0.5, 0.5)])


@pytest.fixture
def sound(tmp_path: Path) -> Path:
    soundfile.write(tmp_path / "tones.wav", SOUND, SAMPLE_RATE, subtype="FLOAT")
    return tmp_path / "tones.wav"


@pytest.fixture
def preset(tmp_path: Path) -> Path:
    models = {"model": tone_model({700.0: Phoneme.A, 2500.0: Phoneme.I}), "file_model": centred_model()}
    plain = AnalysisSettings(statistics=False)
    save_preset(Preset(name="both", recogniser="learned", settings=plain, **models), tmp_path / "both.toml")
    return tmp_path / "both.toml"


def table(capsys, *words: object) -> list[str]:
    assert main(["analyse", *map(str, words)]) == 0
    said = capsys.readouterr()
    assert said.err == ""
    return [row["phoneme"] for row in rows_of(said.out)]


@pytest.mark.parametrize("ear", [None, Ear.LIVE, Ear.TWIN])
def test_the_command_line_hears_a_file_as_the_api_does(capsys, sound, preset, ear):
    asked = () if ear is None else ("--ear", ear)
    found = [run.phoneme.label for run in transcribe(sound, for_files(load_preset(preset), ear)).runs]
    assert table(capsys, sound, "--preset", preset, *asked) == found


def test_the_best_ear_is_taken_unless_another_is_asked_for(capsys, sound, preset):
    best, twin, live = (
        table(capsys, sound, "--preset", preset, *ear) for ear in ((), ("--ear", "twin"), ("--ear", "live"))
    )
    assert best == twin != live


def test_tables_tell_what_was_heard_with(capsys, sound, preset):
    for ear, words in (("twin", "twin, 0.1 s each way"), ("live", "learned, 50 ms ahead")):
        assert main(["analyse", str(sound), "--preset", str(preset), "--format", "json", "--ear", ear]) == 0
        assert json.loads(capsys.readouterr().out)["heard_with"] == words


def test_exports_are_of_the_same_ear(tmp_path, sound, preset):
    out = tmp_path / "tones.json"
    assert main(["export", str(sound), "--format", "rhubarb-json", "-o", str(out), "--preset", str(preset)]) == 0
    found = [cue["start"] for cue in json.loads(out.read_text())["mouthCues"]]
    assert found == [round(cue.start, 2) for cue in cues(sound, load_preset(preset), "rhubarb", anticipation=0.04)]


def test_a_model_that_is_missing_is_said_and_the_file_is_heard_live(capsys, sound, preset):
    live = table(capsys, sound, "--preset", preset, "--ear", "live")
    preset.with_name("both.files.npz").unlink()
    assert main(["analyse", str(sound), "--preset", str(preset)]) == 0
    said = capsys.readouterr()
    assert [row["phoneme"] for row in rows_of(said.out)] == live
    assert said.err.startswith("phonemeanalyser: both: note: both.files.npz: the model cannot be read")
    assert said.err.count("\n") == 1


def test_an_ear_that_a_preset_has_not_is_said(capsys, sound):
    assert main(["analyse", str(sound), "--preset", "thesis", "--ear", "twin"]) == 0
    assert "has no other ear for files" in capsys.readouterr().err


def test_figures_are_of_what_hears_live_unless_another_ear_is_named(capsys, tmp_path, sound, preset):
    sound.with_suffix(".txt").write_text("0.2\t0.7\ta\n1.0\t1.5\ti\n")
    for ear, words in (((), "learned, 50 ms ahead"), (("--ear", "twin"), "twin, 0.1 s each way")):
        assert main(["score", str(tmp_path), "--preset", str(preset), *ear]) == 0
        assert f"heard with: {words}" in capsys.readouterr().out


def test_who_analyses_an_open_file_hears_it_the_same(sound, preset):
    with SoundReader(sound) as reader:
        n = sum(len(analysis) for analysis in analyse_file(reader, load_preset(preset)))
    assert n == -(-len(SOUND) // 441)
