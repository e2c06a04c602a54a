"""What every table of the command line must be, and how it is asked for."""

import csv
from itertools import pairwise
from pathlib import Path

import pytest

from phonemeanalyser.cli.main import main
from phonemeengine.phonemes import Phoneme

NOTES = (".phonemeanalyser-batch", "phonemeanalyser-report.")
"""How the files begin in which a batch notes what it did, and what was wrong."""
LABELS = {phoneme.label for phoneme in Phoneme}
HEADER = "start_s,end_s,phoneme,intensity,confidence"

Capsys = pytest.CaptureFixture[str]
"""What a command says, as pytest catches it."""


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(text.splitlines()))


def outputs_in(folder: Path) -> list[str]:
    """Give what was made in a folder, but for the notes about that."""
    files = [path for path in folder.rglob("*") if path.is_file() and not path.name.startswith(NOTES)]
    return sorted(path.relative_to(folder).as_posix() for path in files)


def contents(folder: Path) -> dict[str, bytes]:
    """Give what was made in a folder, by name."""
    return {name: (folder / name).read_bytes() for name in outputs_in(folder)}


def gapless(rows: list[dict[str, str]], duration: float) -> None:
    assert float(rows[0]["start_s"]) == 0
    assert float(rows[-1]["end_s"]) == pytest.approx(duration, abs=2e-6)
    assert all(one["end_s"] == other["start_s"] for one, other in pairwise(rows))
    assert all(one["phoneme"] != other["phoneme"] for one, other in pairwise(rows))
    assert all(float(row["start_s"]) < float(row["end_s"]) for row in rows)
    assert {row["phoneme"] for row in rows} <= LABELS
    assert all(0 <= float(row[name]) <= 1 for row in rows for name in ("intensity", "confidence"))


def refused(capsys: Capsys, *words: object) -> str:
    """Run it, and give the one sentence with which it fails."""
    assert main([str(word) for word in words]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    (line,) = said.err.splitlines()
    assert line.startswith("phonemeanalyser: ")
    assert line.isprintable()
    return line.removeprefix("phonemeanalyser: ")


def analysed(*words: object) -> None:
    assert main(["analyse", *(str(word) for word in words)]) == 0
