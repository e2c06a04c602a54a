"""`phonemeanalyser analyse`: files in, tables out."""

import json
import stat
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.features.variables import BUILT_IN_NAMES, SCORES, Kind, Variable
from phonemeengine.presets.files import DEFAULT_PRESET, THESIS_PRESET, load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import HOP, SAMPLE_RATE
from tests.sounds import silence, vowel
from tests.tables import HEADER, Capsys, analysed, gapless, outputs_in, refused, rows_of


def test_one_file_is_printed_as_a_table_that_covers_it(sound: Path, capsys: Capsys) -> None:
    analysed(sound)
    said = capsys.readouterr()
    assert said.err == ""
    assert said.out.splitlines()[0] == HEADER
    gapless(rows_of(said.out), soundfile.info(sound).duration)


def test_silence_is_silence_with_no_intensity(tmp_path: Path, capsys: Capsys) -> None:
    soundfile.write(tmp_path / "silence.wav", silence(0.5), SAMPLE_RATE)
    analysed(tmp_path / "silence.wav")
    (row,) = rows_of(capsys.readouterr().out)
    assert list(row.values())[:4] == ["0.0", "0.5", "silence", "0.0"]
    assert 0.5 < float(row["confidence"]) <= 1


def test_how_sure_it_is_is_an_empty_cell_and_null_where_nobody_measured_it(
    tmp_path: Path, sound: Path, capsys: Capsys
) -> None:
    unmeasured = ["--preset", str(THESIS_PRESET.with_suffix(".phonemedata"))]
    analysed(sound, *unmeasured)
    assert {row["confidence"] for row in rows_of(capsys.readouterr().out)} == {""}
    analysed(sound, *unmeasured, "--format", "json")
    assert {run["confidence"] for run in json.loads(capsys.readouterr().out)["phonemes"]} == {None}
    for _ in range(2):
        analysed(sound, *unmeasured, "-o", tmp_path / "sound.csv")  # the table is known as one of its own


def test_a_sound_that_begins_in_the_middle_begins_there_in_the_table(tmp_path: Path, capsys: Capsys) -> None:
    late = np.concatenate((silence(1.0), vowel((700, 1200, 2500), 1.0)))
    soundfile.write(tmp_path / "late.wav", late, SAMPLE_RATE)
    analysed(tmp_path / "late.wav")
    first = rows_of(capsys.readouterr().out)[0]
    assert first["phoneme"] == "silence"
    assert float(first["end_s"]) == pytest.approx(1.0, abs=0.0232 + 0.02)  # half a window and two frames


@pytest.mark.parametrize("words", [["-o", "out/table.csv"], ["-o", "out"], ["-o", "out/deeper/still"]])
def test_one_file_goes_to_a_file_or_into_a_folder(
    words: list[str], sound: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capsys
) -> None:
    monkeypatch.chdir(tmp_path)
    analysed(sound, *words)
    said = capsys.readouterr()
    target = tmp_path / words[1]
    target = target if target.suffix else target / "speech.csv"
    assert (said.out, said.err) == ("", "")
    assert target.read_text().startswith(HEADER + "\n")
    assert [path for path in (tmp_path / "out").rglob("*") if path.is_file()] == [target]
    assert stat.S_IMODE(target.stat().st_mode) & 0o444 == 0o444
    analysed(sound)
    assert capsys.readouterr().out == target.read_text()


def test_a_folder_is_walked_and_its_tree_is_mirrored(sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    corpus = tmp_path / "corpus"
    samples, rate = soundfile.read(sound)
    for name in ("top.wav", "x/y.flac", "x/deep/z.ogg", "other/loud.WAV"):
        (corpus / name).parent.mkdir(parents=True, exist_ok=True)
        soundfile.write(corpus / name, samples, rate)
    (corpus / "x" / "notes.txt").write_text("no sound, and no reason to speak")
    analysed(corpus, "-o", tmp_path / "out")
    capsys.readouterr()
    assert outputs_in(tmp_path / "out") == ["other/loud.csv", "top.csv", "x/deep/z.csv", "x/y.csv"]
    one, other = (rows_of((tmp_path / "out" / name).read_text()) for name in ("x/y.csv", "top.csv"))
    assert [row | {"confidence": ""} for row in one] == [row | {"confidence": ""} for row in other]


def test_several_files_go_into_a_folder(sound: Path, stereo: Path, tmp_path: Path) -> None:
    analysed(sound, stereo, "-o", tmp_path / "out")
    assert outputs_in(tmp_path / "out") == ["speech.csv", "stereo.csv"]


def test_json_says_the_same_as_csv(sound: Path, capsys: Capsys) -> None:
    analysed(sound)
    rows = rows_of(capsys.readouterr().out)
    analysed(sound, "--format", "json")
    document = json.loads(capsys.readouterr().out)
    assert document["file"] == "speech.wav"
    assert document["preset"] == load_preset(DEFAULT_PRESET).name
    assert document["duration_s"] == pytest.approx(soundfile.info(sound).duration, abs=1e-6)
    assert [{key: str(value) for key, value in run.items()} for run in document["phonemes"]] == rows


def test_json_goes_to_a_json_file(sound: Path, tmp_path: Path) -> None:
    analysed(sound, "--format", "json", "-o", tmp_path / "table.json")
    analysed(sound, "--format", "json", "-o", tmp_path / "out")
    assert (tmp_path / "table.json").read_text() == (tmp_path / "out" / "speech.json").read_text()


def test_features_are_every_ten_milliseconds_with_every_variable(sound: Path, capsys: Capsys) -> None:
    analysed(sound, "--features")
    rows = rows_of(capsys.readouterr().out)
    n_samples = soundfile.info(sound).frames
    assert list(rows[0]) == [*HEADER.split(","), *BUILT_IN_NAMES, *SCORES]
    assert len(rows) == -(-n_samples // HOP)
    assert [float(row["start_s"]) for row in rows] == [round(k * 0.01, 6) for k in range(len(rows))]
    assert float(rows[-1]["end_s"]) == pytest.approx(n_samples / SAMPLE_RATE, abs=1e-6)
    assert all(one["end_s"] == other["start_s"] for one, other in pairwise(rows))


def test_features_hold_a_variable_of_the_users_own(sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    preset = replace(load_preset(DEFAULT_PRESET), variables=(Variable("mine", 0, 22_050, Kind.MAX),), name="my own")
    save_preset(preset, tmp_path / "mine.toml")
    analysed(sound, "--features", "--preset", tmp_path / "mine.toml", "--format", "json")
    document = json.loads(capsys.readouterr().out)
    assert document["preset"] == "my own"
    assert list(document["frames"][0]) == [*HEADER.split(","), *BUILT_IN_NAMES, "mine", *SCORES]
    assert max(frame["mine"] for frame in document["frames"]) == 1.0  # the normalised spectrum's largest amplitude


@pytest.mark.parametrize("name", ["phoneme", "energy"])
def test_no_variable_takes_the_name_of_another_column(name: str, sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    save_preset(Preset(variables=(Variable("mine", 100, 200),)), tmp_path / "mine.toml")
    (tmp_path / "mine.toml").write_text((tmp_path / "mine.toml").read_text().replace('"mine"', f'"{name}"'))
    assert f"{name} exists already" in refused(
        capsys, "analyse", sound, "--features", "--preset", tmp_path / "mine.toml"
    )


def test_a_preset_decides_what_is_recognised(sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    thresholds = replace(Preset().thresholds, silence_zero_crossings=1e6, silence_energy=1e6)
    thresholds = replace(thresholds, silence_max_energy=1e6, silence_szsch1=1e6)
    for name in ("deaf.toml", "deaf.phonemedata"):
        save_preset(Preset(thresholds=thresholds), tmp_path / name)
        analysed(sound, "--preset", tmp_path / name)
        assert {row["phoneme"] for row in rows_of(capsys.readouterr().out)} == {"silence"}


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("short.phonemedata", b"1,2,3"),
        ("other.toml", b"format = 'another'"),
        ("missing.toml", None),
        ("folder.toml", "folder"),
    ],
)
def test_a_broken_preset_is_refused_in_one_sentence(
    name: str, content: bytes | str | None, sound: Path, tmp_path: Path, capsys: Capsys
) -> None:
    if isinstance(content, bytes):
        (tmp_path / name).write_bytes(content)
    elif content:
        (tmp_path / name).mkdir()
    sentence = refused(capsys, "analyse", sound, "--preset", tmp_path / name, "-o", tmp_path / "out")
    assert sentence.startswith(f"{name}: ")
    assert not (tmp_path / "out").exists()
