"""``phonemeanalyser performance``, as a person types it."""

from pathlib import Path

import pytest

from phonemeanalyser.cli.main import main
from tests.engine.performance.corpora import write_recording


def test_a_table_of_a_synthetic_performer_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder, table = tmp_path / "corpus", tmp_path / "ann.sqlite"
    text = tmp_path / "sentences.txt"
    text.write_text("Good evening, all of you.\n\nThe baker moved the piano.\n", encoding="utf-8")
    assert main(["performance", "make", str(folder), "--minutes", "0.5", "--sentences", str(text)]) == 0
    assert "2 synthetic recordings, 0.1 minutes" in capsys.readouterr().out
    assert main(["performance", "build", str(folder), "-o", str(table), "--name", "Ann"]) == 0
    assert "ann.sqlite: 'Ann', synthetic, 2 recordings, 0.1 minutes" in capsys.readouterr().out
    assert main(["performance", "info", str(table)]) == 0
    said = capsys.readouterr().out.splitlines()
    assert said[1] == "61 channels at 60 frames a second"
    assert [line.split()[0] for line in said[2:4]] == ["word", "syllable"]


def test_what_is_left_out_is_said_and_the_table_is_built(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("good", "bad"):
        write_recording(tmp_path, name)
    (tmp_path / "bad.csv").write_text("nothing", encoding="utf-8")
    assert main(["performance", "build", str(tmp_path), "-o", str(tmp_path / "t.sqlite")]) == 0
    out, err = capsys.readouterr()
    assert "1 recordings" in out
    assert "a recording is left out: bad.csv: this is no recording of Live Link Face" in err


def test_a_table_takes_the_place_of_a_table_only(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_recording(tmp_path)
    table = tmp_path / "t.sqlite"
    build = ["performance", "build", str(tmp_path), "-o", str(table)]
    table.write_text("my notes", encoding="utf-8")
    assert main(build) == 1
    assert "is left alone" in capsys.readouterr().err
    assert table.read_text(encoding="utf-8") == "my notes"
    assert main([*build, "--overwrite"]) == 0
    assert main(build) == 0


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["info", "none.sqlite"], "none.sqlite: it cannot be read"),
        (["build", "none", "-o", "t.sqlite"], "none: this folder cannot be read"),
        (["make", ".", "--minutes", "1"], "there are files in this folder already"),
        (["make", "new", "--language", "xx"], "xx"),
    ],
)
def test_what_cannot_be_done_is_said_in_a_sentence(
    words: list[str], sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").touch()
    assert main(["performance", *words]) == 1
    err = capsys.readouterr().err
    assert sentence in err
    assert err.count("\n") == 1
