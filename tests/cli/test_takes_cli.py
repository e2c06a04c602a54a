"""Takes from the command line: what there is, and deleted ones removed for ever."""

from pathlib import Path

import pytest

from phonemeanalyser.cli import takes
from phonemeanalyser.cli.main import main
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.phonemes import Phoneme
from tests.sounds import vowel
from tests.tables import Capsys, refused

SOUND = vowel((750, 1250), 0.3)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A project of three takes, of which one is deleted."""
    with TakeProject(tmp_path / "takes of Ada") as project:
        for phoneme in (Phoneme.A, Phoneme.A, Phoneme.O):
            project.add(SOUND, "Ada", phoneme)
        project.delete(project.takes[0])
        return project.folder


def sounds_in(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*.flac"))


def test_what_there_is_is_counted_by_phoneme(folder: Path, capsys: Capsys) -> None:
    assert main(["takes", str(folder)]) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert lines[:2] == [["a", "1"], ["o", "1"]]
    assert lines[2][:5] == ["2", "takes,", "and", "1", "deleted"]
    assert len(sounds_in(folder)) == 3


@pytest.mark.parametrize(("answer", "code", "left"), [("y", 0, 2), ("YES", 0, 2), ("", 1, 3), ("no", 1, 3)])
def test_deleted_takes_go_for_ever_if_the_user_says_yes(folder: Path, answer: str, code: int, left: int) -> None:
    with TakeProject(folder) as project:
        assert takes.empty_deleted(project, asks=True, ask=lambda _question: answer) == code
    assert len(sounds_in(folder)) == left
    with TakeProject(folder) as project:
        assert len(project.deleted) == left - 2
        assert [take.name for take in project.takes] == ["a-2", "o-3"]


def test_nobody_is_asked_where_the_answer_was_given(folder: Path, capsys: Capsys) -> None:
    assert main(["takes", str(folder), "--empty-deleted", "--yes"]) == 0
    assert sounds_in(folder) == ["takes/Ada/a-2.flac", "takes/Ada/o-3.flac"]
    assert main(["takes", str(folder), "--empty-deleted"]) == 0
    assert "0 deleted" in capsys.readouterr().out.splitlines()[-1]


def test_a_folder_without_takes_is_refused_and_left_alone(tmp_path: Path, capsys: Capsys) -> None:
    assert "no takes.json in it" in refused(capsys, "takes", tmp_path)
    assert "no takes.json in it" in refused(capsys, "takes", tmp_path / "nowhere")
    assert list(tmp_path.iterdir()) == []
