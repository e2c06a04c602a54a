"""`phonemeanalyser analyse` for Praat and Audacity: labels that say what the tables say."""

import json
from pathlib import Path

import parselmouth
import pytest
import soundfile
from parselmouth.praat import call

from phonemeanalyser.cli.window import DEMO
from phonemeengine.labels.files import read_labels
from tests.bad_files import ODD_FILES
from tests.tables import HEADER, Capsys, analysed, outputs_in, refused, rows_of

SUFFIXES = {"textgrid": ".TextGrid", "audacity": ".txt"}


def runs_in(csv: str) -> list[tuple[float, float, str]]:
    return [(float(row["start_s"]), float(row["end_s"]), row["phoneme"]) for row in rows_of(csv)]


def labels_in(path: Path) -> list[tuple[float, float, str]]:
    return [(label.start, label.end, label.phoneme.label) for label in read_labels(path)]


@pytest.mark.parametrize("kind", SUFFIXES)
def test_labels_read_back_are_the_runs_of_the_table(kind: str, tmp_path: Path, capsys: Capsys) -> None:
    analysed(DEMO)
    runs = runs_in(capsys.readouterr().out)
    assert len({phoneme for *_, phoneme in runs}) > 5
    analysed(DEMO, "--format", kind, "-o", tmp_path)
    assert labels_in(tmp_path / f"demo{SUFFIXES[kind]}") == runs
    analysed(DEMO, "--format", kind)
    assert capsys.readouterr().out == (tmp_path / f"demo{SUFFIXES[kind]}").read_text(encoding="utf-8")


def test_praat_finds_a_textgrid_as_long_as_the_sound(sound: Path, tmp_path: Path) -> None:
    analysed(sound, "-o", tmp_path / "speech.TextGrid")
    grid = parselmouth.read(str(tmp_path / "speech.TextGrid"))
    assert call(grid, "Get total duration") == pytest.approx(soundfile.info(sound).duration, abs=1e-6)
    assert call(grid, "Get tier name", 1) == "phonemes"
    assert call(grid, "Get number of intervals", 1) == len(read_labels(tmp_path / "speech.TextGrid"))


@pytest.mark.parametrize("name", ODD_FILES)
def test_an_unusual_file_has_labels_too(name: str, tmp_path: Path, capsys: Capsys) -> None:
    path = ODD_FILES[name](tmp_path)
    analysed(path)
    runs = runs_in(capsys.readouterr().out)
    analysed(path, "--format", "textgrid", "-o", tmp_path / "out")
    assert labels_in(tmp_path / "out" / f"{path.stem}.TextGrid") == runs


def test_the_ending_of_a_single_table_says_its_format(sound: Path, tmp_path: Path) -> None:
    begin = {
        "a.csv": HEADER,
        "a.dat": HEADER,
        "a.json": "{",
        "a.JSON": "{",
        "a.txt": "0.000000\t",
        "a.TextGrid": "File type",
        "a.textgrid": "File type",
    }
    for name, start in begin.items():
        analysed(sound, "-o", tmp_path / name)
        assert (tmp_path / name).read_text(encoding="utf-8").startswith(start), name


def test_the_format_that_is_asked_for_goes_before_the_ending(sound: Path, tmp_path: Path) -> None:
    analysed(sound, "--format", "csv", "-o", tmp_path / "a.json")
    assert (tmp_path / "a.json").read_text(encoding="utf-8").startswith(HEADER)
    analysed(sound, "--format", "json", "-o", tmp_path / "a.txt")
    assert json.loads((tmp_path / "a.txt").read_text(encoding="utf-8"))["file"] == "speech.wav"


def test_the_ending_of_a_folder_says_nothing(sound: Path, stereo: Path, tmp_path: Path) -> None:
    analysed(sound, stereo, "-o", tmp_path / "v1.json")
    assert outputs_in(tmp_path / "v1.json") == ["speech.csv", "stereo.csv"]


@pytest.mark.parametrize("words", [["--format", "audacity"], ["-o", "a.TextGrid"]])
def test_labels_have_no_place_for_variables(
    words: list[str], sound: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capsys
) -> None:
    monkeypatch.chdir(tmp_path)
    before = set(tmp_path.iterdir())
    assert "write them with --format csv or json" in refused(capsys, "analyse", sound, "--features", *words)
    assert set(tmp_path.iterdir()) == before
