"""The model with which commands recognise files: the best that a preset has, or the one that is asked for."""

import json
import logging
import sys
from contextlib import redirect_stderr
from dataclasses import replace
from pathlib import Path
from urllib.request import urlopen

import numpy as np
import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeanalyser.server.service import ServerSettings
from phonemeengine import Phoneme, Preset, cues, for_files, load_preset, transcribe
from phonemeengine.encoder.live import build_live_encoder
from phonemeengine.presets.files import save_preset
from phonemeengine.presets.model_choice import for_live_use, model_in_words
from phonemeengine.settings import SAMPLE_RATE, AnalysisSettings, ModelKind
from tests.cli.test_progress_bar import Terminal
from tests.fakes.encoder_weights import encoder_weights
from tests.models import centred_model, tone_model
from tests.server.servers import served
from tests.sounds import silence, tone
from tests.tables import rows_of

SOUND = np.concatenate([silence(0.2), tone(700, 0.5, 0.5), silence(0.3), tone(2500, 0.5, 0.5)])


@pytest.fixture
def sound(tmp_path: Path) -> Path:
    soundfile.write(tmp_path / "tones.wav", SOUND, SAMPLE_RATE, subtype="FLOAT")
    return tmp_path / "tones.wav"


@pytest.fixture
def preset(tmp_path: Path) -> Path:
    models = {"model": tone_model({700.0: Phoneme.A, 2500.0: Phoneme.I}), "offline_model": centred_model()}
    plain = AnalysisSettings(statistics=False)
    save_preset(Preset(name="both", recogniser="learned", settings=plain, **models), tmp_path / "both.toml")
    return tmp_path / "both.toml"


def table(capsys, *words: object) -> list[str]:
    assert main(["analyse", *map(str, words)]) == 0
    said = capsys.readouterr()
    assert said.err == ""
    return [row["phoneme"] for row in rows_of(said.out)]


@pytest.mark.parametrize("kind", [None, ModelKind.REAL_TIME, ModelKind.OFFLINE])
def test_the_command_line_recognises_a_file_as_the_api_does(capsys, sound, preset, kind):
    asked = () if kind is None else ("--model", kind)
    found = [run.phoneme.label for run in transcribe(sound, for_files(load_preset(preset), kind)).runs]
    assert table(capsys, sound, "--preset", preset, *asked) == found


def test_tables_tell_the_model(capsys, sound, preset):
    for kind, words in (("offline", "offline, ±0.1 s of context"), ("real-time", "learned, look-ahead 50 ms")):
        assert main(["analyse", str(sound), "--preset", str(preset), "--format", "json", "--model", kind]) == 0
        assert json.loads(capsys.readouterr().out)["model"] == words


def test_exports_are_of_the_same_model(tmp_path, sound, preset):
    out = tmp_path / "tones.json"
    assert main(["export", str(sound), "--format", "rhubarb-json", "-o", str(out), "--preset", str(preset)]) == 0
    found = [cue["start"] for cue in json.loads(out.read_text())["mouthCues"]]
    assert found == [round(cue.start, 2) for cue in cues(sound, load_preset(preset), "rhubarb", anticipation=0.04)]


def test_a_model_that_is_missing_is_told_and_the_real_time_model_serves(capsys, sound, preset):
    live = table(capsys, sound, "--preset", preset, "--model", "real-time")
    preset.with_name("both.files.npz").unlink()
    assert main(["analyse", str(sound), "--preset", str(preset)]) == 0
    said = capsys.readouterr()
    assert [row["phoneme"] for row in rows_of(said.out)] == live
    assert said.err.startswith("phonemeanalyser: both: note: both.files.npz: the model cannot be read")
    assert said.err.count("\n") == 1


@pytest.mark.usefixtures("portaudio")
@pytest.mark.parametrize(
    ("missing", "model", "why"),
    [
        (None, "encoder, look-ahead 20 ms", None),
        ("onnxruntime", "learned, look-ahead 20 ms", "needs onnxruntime, which is not installed; install phonemeana"),
        ("both.encoder.onnx", "learned, look-ahead 20 ms", "both.encoder.onnx: there is no such file"),
    ],
)
def test_api_listen_and_server_say_which_model_recognises_live_sound_and_why_not_the_encoder(
    missing, model, why, preset, caplog, monkeypatch
):
    # bytes of its own, since a model that was opened once stays open
    encoder = build_live_encoder(encoder_weights(n_layers=1, n_channels=64), about={"missing": missing})
    save_preset(replace(load_preset(preset), live_encoder=encoder), preset)
    if missing == "onnxruntime":
        monkeypatch.setitem(sys.modules, missing, None)
    elif missing is not None:
        preset.with_name(missing).unlink()
    live = for_live_use(load_preset(preset))
    assert (model_in_words(live), len(live.warnings)) == (model, why is not None)
    with redirect_stderr(Terminal()) as terminal:
        assert main(["listen", "--preset", str(preset)]) == 1  # there is no microphone
    *notes, named, _no_microphone = terminal.getvalue().splitlines()
    assert named == f"phonemeanalyser: model: {model}"
    assert notes == [f"phonemeanalyser: both: note: {warning}" for warning in live.warnings]
    assert all(why in warning for warning in live.warnings)
    with caplog.at_level(logging.WARNING), served(ServerSettings(presets=[preset], port=0)) as address:
        assert json.load(urlopen(address))["recogniser"] == model
    assert [record.getMessage() for record in caplog.records] == [f"both: {warning}" for warning in live.warnings]


def test_scores_are_of_the_real_time_model_unless_another_is_named(capsys, tmp_path, sound, preset):
    sound.with_suffix(".txt").write_text("0.2\t0.7\ta\n1.0\t1.5\ti\n")
    for kind, words in (((), "learned, look-ahead 50 ms"), (("--model", "offline"), "offline, ±0.1 s of context")):
        assert main(["score", str(tmp_path), "--preset", str(preset), *kind]) == 0
        assert f"model: {words}" in capsys.readouterr().out


def test_the_names_of_the_release_before_still_work_and_the_new_ones_are_told(capsys, sound, preset):
    words = ["analyse", str(sound), "--preset", str(preset)]
    assert main([*words, "--model=real-time"]) == 0
    expected, nothing = capsys.readouterr()
    assert main([*words, "--ear=live"]) == 0
    out, err = capsys.readouterr()
    assert (out, nothing) == (expected, "")
    told = [line.removeprefix("phonemeanalyser analyse: ").partition(";")[0] for line in err.splitlines()]
    assert told == ["--ear is now --model", "live is now real-time"]


def test_a_table_of_an_older_version_is_written_anew(sound, preset, tmp_path):
    words = ["analyse", str(sound), "--preset", str(preset), "--format", "json", "-o", str(tmp_path / "tones.json")]
    assert main(words) == 0
    table = tmp_path / "tones.json"
    of_now = table.read_text(encoding="utf-8")
    table.write_text(of_now.replace('"model": "offline, ±', '"heard_with": "twin, '), encoding="utf-8")
    assert main(words) == 0
    assert table.read_text(encoding="utf-8") == of_now
