"""What commands write takes the place of what the same work made, and of nothing else."""

from pathlib import Path

import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeengine.inspection.analysis_tables import TABLES
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.settings import SAMPLE_RATE
from tests.conftest import SPEECH
from tests.tables import Capsys, analysed, contents, refused

LABELS = "start_s,end_s,phone,class,certainty\n0.000000,0.500000,ə,e,ambiguous\n"
"""Somebody's own labels."""


def exported(*words: object) -> int:
    return main(["export", *(str(word) for word in words)])


def faster(sound: Path) -> None:
    """Put another sound in its place."""
    soundfile.write(sound, SPEECH[::-1], SAMPLE_RATE, subtype="FLOAT")


def left_alone(sentence: str, path: Path) -> None:
    assert sentence.startswith(f"{path}: the file that is there was made in another way, so it is left alone")
    assert sentence.endswith("choose another place, or replace it with --overwrite")


@pytest.mark.parametrize("words", [["textgrid"], ["csv", "--features"]])
def test_a_table_gives_way_to_the_same_only(words: list[str], sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    for _ in range(2):
        analysed(sound, "-o", tmp_path / "out", "--format", *words)
    (table,) = (tmp_path / "out").iterdir()
    before = table.read_text(encoding="utf-8")
    faster(sound)
    capsys.readouterr()
    left_alone(refused(capsys, "analyse", sound, "-o", tmp_path / "out", "--format", *words), table)
    assert table.read_text(encoding="utf-8") == before
    analysed(sound, "-o", tmp_path / "out", "--format", *words, "--overwrite")
    assert table.read_text(encoding="utf-8") != before


def test_a_table_of_phonemes_does_not_give_way_to_one_of_every_frame(
    sound: Path, tmp_path: Path, capsys: Capsys
) -> None:
    analysed(sound, "-o", tmp_path)
    left_alone(refused(capsys, "analyse", sound, "-o", tmp_path, "--features"), tmp_path / "speech.csv")
    assert (tmp_path / "speech.csv").read_text().startswith("start_s,end_s,phoneme,intensity,confidence\n")


def test_in_a_folder_the_same_work_is_done_anew_and_other_work_leaves_it_alone(
    sound: Path, tmp_path: Path, capsys: Capsys
) -> None:
    inputs, out = tmp_path / "in", tmp_path / "out"
    inputs.mkdir()
    for name in ("a", "b"):
        (inputs / f"{name}.wav").write_bytes(sound.read_bytes())
    words = [inputs, "-o", out, "--format", "livelink-csv"]
    assert exported(*words) == 0
    first = contents(out)
    faster(inputs / "a.wav")
    assert exported(*words) == 0
    second = contents(out)
    assert [name for name in first if first[name] != second[name]] == ["a.livelink.csv"]
    capsys.readouterr()
    assert exported(*words, "--preset", "thesis") == 1
    sentences = [line for line in capsys.readouterr().err.splitlines() if "left alone" in line]
    assert len(sentences) == 2
    assert contents(out) == second
    assert exported(*words, "--preset", "thesis", "--overwrite") == 0
    assert all(second[name] != content for name, content in contents(out).items())


def test_what_somebody_changed_in_a_folder_stays_when_the_sound_changes(
    sound: Path, tmp_path: Path, capsys: Capsys
) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "in" / "a.wav").write_bytes(sound.read_bytes())
    words = [tmp_path / "in", "-o", tmp_path / "out", "--format", "oculus-csv"]
    assert exported(*words) == 0
    target = tmp_path / "out" / "a.oculus.csv"
    target.write_text(target.read_text().replace("0.0", "0.1"))
    changed = target.read_text()
    faster(tmp_path / "in" / "a.wav")
    capsys.readouterr()
    assert exported(*words) == 1
    assert "is left alone" in capsys.readouterr().err
    assert target.read_text() == changed


@pytest.mark.parametrize(
    ("words", "name"),
    [
        (["adapt", "--background-noise", "{sound}", "-o", "{out}"], "mine.toml"),
        (["score", "{folder}", "-o", "{out}"], "mine.html"),
        (["score", "{folder}", "--errors", "{out}"], "mine.csv"),
        (["movestates", "export", "head", "-o", "{out}"], "mine.3dma"),
        (["movestates", "convert", "head", "{out}"], "mine.3dma"),
        (["preview", "{sound}", "-o", "{out}", "--size", "32x32", "--fps", "2"], "mine.gif"),
        (["performance", "build", "{folder}", "-o", "{out}"], "mine.sqlite"),
        (["speak", "Hello.", "--language", "en", "-o", "{out}"], "mine.wav"),
        (["measure", "{sound}", "--sound-out", "{out}"], "mine.wav"),
    ],
)
def test_no_command_replaces_a_file_unasked(
    words: list[str], name: str, sound: Path, tmp_path: Path, capsys: Capsys
) -> None:
    out = tmp_path / name
    out.write_text("a diary")
    known = {"sound": sound, "folder": tmp_path, "out": out}
    left_alone(refused(capsys, *(word.format(**known) for word in words)), out)
    assert out.read_text() == "a diary"


def test_the_others_of_a_folder_go_on(sound: Path, tmp_path: Path, capsys: Capsys) -> None:
    folder = tmp_path / "corpus"
    folder.mkdir()
    for name in ("a", "b", "c"):
        (folder / f"{name}.wav").write_bytes(sound.read_bytes())
    (folder / "b.csv").write_text(LABELS, encoding="utf-8")
    assert main(["analyse", str(folder), "-o", str(folder)]) == 1
    sentences = [line for line in capsys.readouterr().err.splitlines() if line.startswith("phonemeanalyser: ")]
    assert len(sentences) == 1
    left_alone(sentences[0].removeprefix("phonemeanalyser: "), folder / "b.csv")
    assert (folder / "b.csv").read_text(encoding="utf-8") == LABELS
    assert (folder / "a.csv").read_text() == (folder / "c.csv").read_text() != ""


def test_all_formats_lie_side_by_side_in_one_folder_with_the_tables(sound: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    for kind in TABLES:
        analysed(sound, "--format", kind, "-o", out)
    for name in FORMATS:
        assert exported(sound, "--format", name, "-o", out) == 0
    assert {path.name for path in out.iterdir()} == {
        "speech.csv",
        "speech.json",
        "speech.TextGrid",
        "speech.txt",
        "speech.rhubarb.tsv",
        "speech.rhubarb.xml",
        "speech.rhubarb.json",
        "speech.moho.dat",
        "speech.pgo",
        "speech.anno",
        "speech.mouth.TextGrid",
        "speech.mouth.txt",
        "speech.livelink.csv",
        "speech.openface.csv",
        "speech.oculus.csv",
        "speech.glb",
        "speech.curves.json",
        "speech.azure.json",
        "speech.marks",
    }


def test_an_export_gives_way_to_the_same_only(  # each format: tests/engine/test_conversion.py
    sound: Path, tmp_path: Path, capsys: Capsys
) -> None:
    target = tmp_path / "mine.glb"
    for _ in range(2):
        assert exported(sound, "--format", "gltf", "-o", target) == 0
    before = target.read_bytes()
    faster(sound)
    capsys.readouterr()
    left_alone(refused(capsys, "export", sound, "--format", "gltf", "-o", target), target)
    assert target.read_bytes() == before
    assert exported(sound, "--format", "gltf", "-o", target, "--overwrite") == 0
    assert target.read_bytes() != before
