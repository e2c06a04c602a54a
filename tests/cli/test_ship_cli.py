"""``phonemeanalyser ship``, as a person types it."""

from pathlib import Path

from phonemeanalyser.cli.main import main
from tests.tables import Capsys


def test_a_preset_is_shipped_with_the_tables_that_are_asked_for(tmp_path: Path, capsys: Capsys) -> None:
    folder = tmp_path / "game"
    words = ["ship", "thesis", "-o", str(folder), "--target", "c", "--table", "five", "--table", "vrm"]
    assert main(words) == 0
    assert capsys.readouterr().out.startswith(f"{folder}: 'Thesis' in 12 files, ")
    content = (folder / "preset.ear").read_bytes()
    assert content.startswith(b"EAR\x1a")
    assert content.count(b"MOUT") == 2
    assert b"rhubarb" not in content


def test_changed_files_are_replaced_only_where_that_is_asked_for(tmp_path: Path, capsys: Capsys) -> None:
    assert main(["ship", "thesis", "-o", str(tmp_path)]) == 0
    (tmp_path / "Makefile").write_text("all:\n", encoding="utf-8")
    assert main(["ship", "thesis", "-o", str(tmp_path)]) == 1
    assert "Makefile: another file is there, or it was changed" in capsys.readouterr().err
    assert main(["ship", "thesis", "-o", str(tmp_path), "--overwrite"]) == 0


def test_a_preset_that_is_not_there_is_refused(tmp_path: Path, capsys: Capsys) -> None:
    assert main(["ship", "nothing", "-o", str(tmp_path / "x")]) == 1
    assert "nothing: there is no such preset" in capsys.readouterr().err
    assert not (tmp_path / "x").exists()
