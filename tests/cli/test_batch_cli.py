"""Folders of sounds, from the command line: whole outputs, nothing twice, and what was wrong in a report."""

import csv
import shutil
from pathlib import Path

import pytest

from phonemeanalyser.cli.main import main
from phonemeanalyser.reports.page import PAGE, TABLE
from phonemeengine.batch.record import RECORD
from tests.tables import Capsys, contents, outputs_in

EXPORT = ("export", "--format", "rhubarb-json")


@pytest.fixture
def sounds(sound: Path, tmp_path: Path) -> Path:
    folder = tmp_path / "sounds"
    (folder / "deep").mkdir(parents=True)
    for name in ("a.wav", "b.wav", "deep/c.wav"):
        shutil.copy(sound, folder / name)
    return folder


def test_two_processes_write_the_bytes_of_one_by_one(sounds: Path, tmp_path: Path) -> None:
    assert main([*EXPORT, str(sounds), "-o", str(tmp_path / "two"), "--jobs", "2"]) == 0
    single = tmp_path / "single"
    for path in ("a.wav", "b.wav", "deep/c.wav"):
        assert main([*EXPORT, str(sounds / path), "-o", str((single / path).parent)]) == 0
    assert contents(tmp_path / "two") == contents(single)
    assert len(contents(single)) == 3


def test_what_is_done_is_not_touched_again(sounds: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    words = ["analyse", str(sounds), "-o", str(out)]
    assert main(words) == 0
    before = {name: (out / name).stat().st_mtime_ns for name in outputs_in(out)}
    (sounds / "d.wav").write_bytes((sounds / "a.wav").read_bytes())
    assert main(words) == 0
    after = {name: (out / name).stat().st_mtime_ns for name in outputs_in(out)}
    assert after.keys() - before.keys() == {"d.csv"}
    assert before.items() <= after.items()
    assert main([*words, "--preset", "thesis"]) == 1
    assert {name: (out / name).stat().st_mtime_ns for name in outputs_in(out) if name in after} == after
    assert main([*words, "--preset", "thesis", "--overwrite"]) == 0
    last = {name: (out / name).stat().st_mtime_ns for name in outputs_in(out)}
    assert not last.items() & before.items()


def test_another_text_is_another_order(sounds: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    words = ["analyse", str(sounds), "-o", str(out), "--script", "auto", "--language", "en-us"]
    (sounds / "a.txt").write_text("one two")
    assert main(words) == 0
    before = {name: (out / name).stat().st_mtime_ns for name in outputs_in(out)}
    (sounds / "a.txt").write_text("one three")
    assert main(words) == 1
    assert {name: (out / name).stat().st_mtime_ns for name in before} == before
    assert main([*words, "--overwrite"]) == 0
    after = {name: (out / name).stat().st_mtime_ns for name in outputs_in(out)}
    assert {name for name in after if after[name] != before[name]} == {"a.csv"}


def test_what_was_wrong_stands_in_a_table_and_on_a_page(sounds: Path, tmp_path: Path, capsys: Capsys) -> None:
    (sounds / "b.wav").write_bytes(b"no sound <at> all")
    out = tmp_path / "out"
    (sounds / "a.txt").write_text("one two three four five six seven")
    words = ["export", str(sounds), "--format", "textgrid", "-o", str(out), "--script", "auto", "--language", "en-us"]
    assert main(words) == 1
    with (out / TABLE).open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert Path(rows[0]["file"]).name == "b.wav"
    assert (rows[0]["state"], rows[0]["duration_s"]) == ("failed", "")
    assert rows[0]["what was wrong"].startswith("b.wav: this is not an audio file")
    told = next(row for row in rows if row["file"].endswith("a.wav"))
    assert (told["state"], told["language"]) == ("note", "en-us")
    assert float(told["duration_s"]) > 0
    page = (out / PAGE).read_text(encoding="ascii")
    assert "What was wrong in out" in page
    assert "3 files: 2 done, 1 failed" in page
    assert "b.wav" in capsys.readouterr().err
    (sounds / "b.wav").write_bytes((sounds / "a.wav").read_bytes())
    (sounds / "a.txt").unlink()
    assert main([*words[:6], "--overwrite"]) == 0
    assert not (out / TABLE).exists()
    assert not (out / PAGE).exists()


def test_a_single_sound_leaves_no_record(sound: Path, tmp_path: Path) -> None:
    assert main(["analyse", str(sound), "-o", str(tmp_path / "out")]) == 0
    assert not (tmp_path / "out" / RECORD).exists()


def test_a_score_by_two_processes_and_one_that_was_kept_is_that_of_one(
    corpus: Path, tmp_path: Path, capsys: Capsys
) -> None:
    with (corpus / "manifest.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))[::45]
    for row in rows:
        for name in (row["wav"], row["labels"]):
            (tmp_path / "some" / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(corpus / name, tmp_path / "some" / name)
    with (tmp_path / "some" / "manifest.csv").open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, list(rows[0]))
        table.writeheader()
        table.writerows(rows)
    words = [
        "score",
        str(tmp_path / "some"),
        "--preset",
        "thesis",
        "--format",
        "json",
        "--noise",
        "pink",
        "--snr",
        "10",
    ]
    assert main(words) == 0
    alone = capsys.readouterr().out
    assert main([*words, "--jobs", "2"]) == 0
    assert capsys.readouterr().out == alone
    for _ in range(2):
        assert main([*words, "--keep", str(tmp_path / "kept")]) == 0
        assert capsys.readouterr().out == alone
    assert len(outputs_in(tmp_path / "kept")) == len(rows)
