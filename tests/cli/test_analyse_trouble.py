"""`phonemeanalyser analyse` with what cannot be read or written: one sentence each, and the rest goes on."""

import re
import shutil
from pathlib import Path

import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeengine.settings import SAMPLE_RATE
from tests.bad_files import BAD_FILES, HOSTILE
from tests.sounds import vowel
from tests.tables import Capsys, analysed, gapless, outputs_in, refused, rows_of


def test_each_bad_file_is_named_in_one_sentence_and_the_others_go_on(
    sound: Path, tmp_path: Path, capsys: Capsys
) -> None:
    bad = []
    for name in (name for name in BAD_FILES if name not in HOSTILE):
        (tmp_path / name).mkdir()
        path = BAD_FILES[name](tmp_path / name)
        taken = Path(path.name).stem in {Path(other).stem for other in bad}  # their tables would have one name
        bad.append(str(path.rename(path.with_stem(name)) if taken else path))
    another, out = shutil.copy(sound, tmp_path / "another.wav"), tmp_path / "out"
    assert main(["analyse", str(sound), *bad, str(another), "-o", str(out)]) == 1
    lines = [line for line in capsys.readouterr().err.splitlines() if line.startswith("phonemeanalyser: ")]
    assert len(lines) == len(bad) > 20
    for line, path in zip(lines, bad, strict=True):
        assert line.startswith(f"phonemeanalyser: {Path(path).name}: ".replace("\n", "?"))
    assert outputs_in(out) == ["another.csv", "speech.csv"]
    gapless(rows_of((out / "another.csv").read_text()), soundfile.info(another).duration)


@pytest.mark.parametrize("words", [[], ["--features", "--format", "json"]])
def test_nothing_is_printed_or_left_of_a_file_that_breaks_in_the_middle(
    words: list[str], tmp_path: Path, capsys: Capsys
) -> None:
    bad = BAD_FILES["not_a_number"](tmp_path)
    refused(capsys, "analyse", bad, *words)
    refused(capsys, "analyse", bad, *words, "-o", tmp_path / "out")
    assert not list((tmp_path / "out").iterdir())


def test_hostile_files_in_a_folder_are_passed_over(sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    (tmp_path / "all").mkdir()
    bad = [write(tmp_path / "all").name for write in HOSTILE.values()]
    sound.rename(tmp_path / "all" / "speech.wav")
    assert main(["analyse", str(tmp_path / "all"), "-o", str(tmp_path / "out")]) == 1
    lines = [line for line in capsys.readouterr().err.splitlines() if line.startswith("phonemeanalyser: ")]
    assert sorted(line.split(": ")[1] for line in lines) == sorted(bad)
    assert outputs_in(tmp_path / "out") == ["speech.csv"]


def test_a_folder_without_sounds_is_refused(tmp_path: Path, capsys: Capsys) -> None:
    (tmp_path / "empty").mkdir()
    sentence = refused(capsys, "analyse", tmp_path / "empty", "-o", tmp_path / "out")
    assert sentence == "empty: there is no sound file in this folder; name another"


def test_the_folder_one_stands_in_may_be_named(
    sound: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capsys
) -> None:
    monkeypatch.chdir(tmp_path)
    analysed(".", "-o", "out")
    assert (tmp_path / "out" / "speech.csv").exists()
    (tmp_path / "empty").mkdir()
    monkeypatch.chdir(tmp_path / "empty")
    assert "no sound file in this folder" in refused(capsys, "analyse", ".", "-o", "out")


def test_a_name_that_no_file_can_have_is_refused(tmp_path: Path, capsys: Capsys) -> None:
    assert refused(capsys, "analyse", tmp_path / ("x" * 300 + ".wav")).startswith("xxx")


def test_two_files_that_would_share_a_table_are_told_apart(sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    soundfile.write(tmp_path / "speech.flac", vowel((700, 1200), 0.2), SAMPLE_RATE)
    sentence = refused(capsys, "analyse", sound, tmp_path / "speech.flac", "-o", tmp_path / "out")
    assert sentence == ("speech.flac: its file speech.csv is already that of speech.wav; rename one of them")
    gapless(rows_of((tmp_path / "out" / "speech.csv").read_text()), soundfile.info(sound).duration)


def test_several_files_need_a_folder(sound: Path, stereo: Path, tmp_path: Path, capsys: Capsys):
    assert "name one with -o" in refused(capsys, "analyse", sound, stereo)
    assert "name one with -o" in refused(capsys, "analyse", tmp_path)


def test_a_place_that_cannot_be_written_is_refused(sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    (tmp_path / "file").write_text("in the way")
    sentence = refused(capsys, "analyse", sound, "-o", tmp_path / "file")
    assert re.search(r"cannot be written \(.+\); choose another place$", sentence)
    (tmp_path / "taken.csv" / "inside").mkdir(parents=True)
    (tmp_path / "taken.csv" / "speech.csv").mkdir()
    refused(capsys, "analyse", sound, "-o", tmp_path / "taken.csv")
    assert not [path for path in tmp_path.rglob("*") if path.suffix == ".part"]
