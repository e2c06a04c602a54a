"""`phonemeanalyser align` and `score --texts`: how well sounds say their lines, from the command line."""

import csv
import json
import shutil
from pathlib import Path

import pytest

from phonemeanalyser.cli.main import main
from tests.conftest import ROOT
from tests.tables import Capsys

DEVELOPMENT = ROOT / "tests" / "data" / "corpus"
PERSON = "human_pocketsphinx/cards"
LINE = "Meine Mama mag Musik, und mein Papa backt am Samstag Pizza."


@pytest.fixture
def takes(tmp_path: Path) -> Path:
    folder = tmp_path / "takes"
    folder.mkdir()
    for number in (0, 1):
        shutil.copy(DEVELOPMENT / f"espeak_de/de/de_0{number}.flac", folder / f"take{number}.flac")
    return folder


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_the_take_that_says_its_line_is_the_best_and_another_text_is_told(takes: Path, tmp_path: Path) -> None:
    table = tmp_path / "script.tsv"
    table.write_text(f"take0.flac\t{LINE}\ntake1.flac\t{LINE}\n", encoding="utf-8")
    words = ["align", str(takes), "--script", str(table), "--language", "de", "-o", str(tmp_path / "takes.csv")]
    assert main(words) == 0
    right, wrong = rows_of(tmp_path / "takes.csv")
    assert (right["best"], right["skipped"], right["unknown"]) == ("best", "", "0")
    assert float(right["score"]) < 0.65
    assert (wrong["best"], wrong["skipped"], wrong["score"]) == ("", "another text", "")


def test_without_words_there_is_nothing_to_align(takes: Path, capsys: Capsys) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["align", str(takes)])
    assert ended.value.code == 2
    assert "there is no text to align; give it with --text or --script" in capsys.readouterr().err


def test_scores_with_the_texts_of_the_manifest_are_better(tmp_path: Path) -> None:
    corpus = tmp_path / "corpus"
    (corpus / PERSON).mkdir(parents=True)
    lines = (DEVELOPMENT / "manifest.csv").read_text(encoding="utf-8").splitlines()
    kept = [lines[0], *(line for line in lines if f",{PERSON}/" in line)][:4]
    (corpus / "manifest.csv").write_text("\n".join(kept) + "\n", encoding="utf-8")
    for file in (DEVELOPMENT / PERSON).iterdir():
        shutil.copy(file, corpus / PERSON)
    found = {}
    for name, more in {"free": [], "words": ["--texts"]}.items():
        assert main(["score", str(corpus), *more, "-o", str(tmp_path / f"{name}.json")]) == 0
        found[name] = json.loads((tmp_path / f"{name}.json").read_text(encoding="utf-8"))
    free, words = (found[name]["presets"][0] for name in ("free", "words"))
    assert words["title"] == f"{free['title']} with texts"
    assert words["all"]["macro_f1"] > free["all"]["macro_f1"]
