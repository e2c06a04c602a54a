"""Expressions beside speech, as the commands take them."""

import csv
from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.cli.main import main
from phonemeengine import ExportOptions, Expression, IdleMotion, export, held_expression, load_preset

DEMO = Path(__file__).resolve().parents[2] / "phonemeanalyser" / "demo" / "demo.flac"


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def exported(target: Path, *words: str) -> list[dict[str, str]]:
    arguments = ["export", str(DEMO), "--format", "livelink-csv", "-o", str(target), "--no-head", "--no-blinks"]
    assert main([*arguments, *words]) == 0
    return rows_of(target)


def column(rows: list[dict[str, str]], name: str) -> np.ndarray:
    return np.array([float(row[name]) for row in rows])


def test_the_command_line_exports_what_the_library_does(tmp_path):
    rows = exported(tmp_path / "a.csv", "--expression", "smile=0.8,browInnerUp=0.3", "--priority", "0.6,0.4")
    smile = Expression((held_expression({"smile": 0.8, "browInnerUp": 0.3}),), 0.6, 0.4)
    idle = IdleMotion(blinks=False, head=False, expression=smile)
    export(DEMO, tmp_path / "b.csv", "livelink-csv", load_preset("learned"), ExportOptions(idle=idle))
    assert rows == rows_of(tmp_path / "b.csv")


def test_an_exported_face_is_the_expression_of_another_one(tmp_path):
    exported(tmp_path / "a.csv", "--expression", "surprise")
    rows = exported(tmp_path / "b.csv", "--expression", str(tmp_path / "a.csv"))
    assert column(rows, "BrowOuterUpLeft")[0] == pytest.approx(0.8, abs=0.02)


def test_speech_holds_an_expression_back_and_it_comes_back(tmp_path):
    smile = column(exported(tmp_path / "a.csv", "--expression", "mouthSmile=1"), "MouthSmileLeft")
    plain = column(exported(tmp_path / "b.csv"), "MouthSmileLeft")
    assert smile[0] == 1
    assert np.min(smile[: len(plain)] - plain) == pytest.approx(0.5, abs=0.05)
    assert smile[-1] == 1


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--expression", "joy=0.5"], "there is no expression 'joy'; choose one of smile"),
        (["--expression", "missing.csv"], "missing.csv"),
        (["--expression", "smile", "--table", "oculus"], "blend shapes of ARKit"),
    ],
)
def test_what_cannot_be_expressed_is_refused_in_one_sentence(tmp_path, capsys, words, sentence):
    assert main(["export", str(DEMO), "--format", "curves-json", "-o", str(tmp_path / "a.json"), *words]) == 1
    said = capsys.readouterr().err.strip()
    assert sentence in said
    assert "\n" not in said
    assert not (tmp_path / "a.json").exists()


def test_a_priority_without_an_expression_is_a_usage_error(tmp_path, capsys):
    with pytest.raises(SystemExit) as ended:
        main(["export", str(DEMO), "--format", "livelink-csv", "-o", str(tmp_path / "a.csv"), "--priority", "1"])
    assert ended.value.code == 2
    assert "--expression" in capsys.readouterr().err


def test_a_file_follows_the_feeling_in_its_voice_as_far_as_is_asked_for(tmp_path):
    rows = exported(tmp_path / "a.csv", "--feeling", "brows=1")
    brows = column(rows, "BrowOuterUpLeft")
    assert 0.01 < brows.max() < 0.6
    assert column(rows, "MouthSmileLeft").max() == column(exported(tmp_path / "b.csv"), "MouthSmileLeft").max()


def test_a_spoken_text_shows_what_it_says_of_feeling_and_refuses_what_it_cannot(tmp_path, capsys):
    words = [
        "speak",
        "--silent",
        "--language",
        "cmn",
        "--format",
        "livelink-csv",
        "--text-feeling",
        "1",
        "--no-blinks",
    ]

    def frown(text: str, name: str) -> float:
        assert main([*words, "--export", str(tmp_path / name), text]) == 0
        return float(column(rows_of(tmp_path / name), "MouthFrownLeft").max())

    plain, sad = frown("我很高兴。", "a.csv"), frown("我很难过。", "b.csv")
    assert sad > plain + 0.1
    assert frown("[sad] 我很高兴。", "c.csv") > frown("[sad 0.4] 我很高兴。", "d.csv") > plain
    assert main([*words, "--export", str(tmp_path / "e.csv"), "[smile] [sad] 我。"]) == 1
    assert "smile and sorrow are asked for at one place" in capsys.readouterr().err
