"""What commands write takes the place of what the same work made, and of nothing else."""

from pathlib import Path

import parselmouth
import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeengine.inspection.analysis_tables import TABLES
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.files.gltf_writing import format_glb
from phonemeengine.mouth.head import load_head
from phonemeengine.settings import SAMPLE_RATE
from tests.conftest import SPEECH
from tests.tables import analysed, contents, refused

LABELS = "start_s,end_s,phone,class,certainty\n0.000000,0.500000,ə,e,ambiguous\n"
"""Somebody's own labels."""

THEIRS: dict[str, tuple[str, ...]] = {
    "rhubarb-tsv": ("0.00\tX\n0.30\tB\n0.85\tX\n",),
    "rhubarb-xml": (
        '<?xml version="1.0" encoding="utf-8"?>\n<rhubarbResult>\n  <metadata>\n'
        "    <soundFile>/home/me/speech.wav</soundFile>\n    <duration>0.85</duration>\n  </metadata>\n",
    ),
    "rhubarb-json": tuple(
        f'{{\n  "metadata": {{\n    "soundFile": "{sound}",\n    "duration": 0.85\n  }},\n  "mouthCues": []\n}}\n'
        for sound in ("/home/me/speech.wav", "C:\\\\me\\\\speech.wav")
    ),
    "moho-dat": ("MohoSwitch1\n1 rest\n9 AI\n",),
    "papagayo-pgo": ("lipsync version 1\nspeech.wav\n24\n20\n1\n\tVoice 1\n\tmine\n\t0\n",),
    "anno": ("audio speech.wav\nphn 0 850 0 x\n",),
    "audacity": ("0.000000\t0.850000\tmine\n",),
    "livelink-csv": (
        ",".join(["Timecode,BlendShapeCount", *(name[0].upper() + name[1:] for name in ARKIT), "HeadYaw,HeadPitch"])
        + "\n14:21:03:11.482,61,"
        + ",".join(["0.0123456789"] * 61)
        + "\n",
    ),
    "openface-csv": ("frame,face_id,timestamp,confidence,success,AU01_r\n1,0,0.000,0.98,1,0.00\n",),
    "oculus-csv": (LABELS, "time,sil,PP\n0,1,0\n"),
    "curves-json": ('{"format": "another"}\n', "[]"),
    "textgrid": ('File type = "ooTextFile"\nObject class = "TextGrid"\n\n0\n1\n<exists>\n0\n',),
}
"""Files of each format that other people or programs made."""


def exported(*words: object) -> int:
    return main(["export", *(str(word) for word in words)])


def faster(sound: Path) -> None:
    """Put another sound in its place."""
    soundfile.write(sound, SPEECH[::-1], SAMPLE_RATE, subtype="FLOAT")


def left_alone(sentence: str, path: Path) -> None:
    assert sentence.startswith(f"{path}: the file that is there was made in another way, so it is left alone")
    assert sentence.endswith("choose another place, or replace it with --overwrite")


@pytest.mark.parametrize("kind", TABLES)
def test_a_file_of_labels_that_lies_there_is_left_alone(
    kind: str, sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    theirs = tmp_path / f"speech{TABLES[kind].ending}"
    theirs.write_text(LABELS, encoding="utf-8")
    left_alone(refused(capsys, "analyse", sound, "--format", kind, "-o", tmp_path), theirs)
    left_alone(refused(capsys, "analyse", sound, "--format", kind, "-o", theirs), theirs)
    assert theirs.read_text(encoding="utf-8") == LABELS
    analysed(sound, "--format", kind, "-o", tmp_path, "--overwrite")
    assert theirs.read_text(encoding="utf-8") != LABELS


@pytest.mark.parametrize("words", [["csv"], ["json"], ["textgrid"], ["csv", "--features"], ["json", "--features"]])
def test_a_table_gives_way_to_the_same_only(
    words: list[str], sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
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
    sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    analysed(sound, "-o", tmp_path)
    left_alone(refused(capsys, "analyse", sound, "-o", tmp_path, "--features"), tmp_path / "speech.csv")
    assert (tmp_path / "speech.csv").read_text().startswith("start_s,end_s,phoneme,intensity,confidence\n")


def test_in_a_folder_the_same_work_is_done_anew_and_other_work_leaves_it_alone(
    sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
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
    sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
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
    words: list[str], name: str, sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / name
    out.write_text("a diary")
    known = {"sound": sound, "folder": tmp_path, "out": out}
    left_alone(refused(capsys, *(word.format(**known) for word in words)), out)
    assert out.read_text() == "a diary"


@pytest.mark.parametrize(
    "theirs",
    [
        "start_s,end_s,phoneme,intensity,remark\n0.0,0.5,a,0.5,mine\n",
        "start_s,end_s,phoneme,intensity\n0.0,0.5,schwa,0.5\n",
        "start_s,end_s,phoneme,intensity\n0.0,0.5,a,0.5\nwrong here?\n",
        "start_s;end_s;phoneme;intensity\n0,0;0,5;a;0,5\n",
        "",
    ],
)
def test_a_table_to_which_somebody_added_is_no_output_any_more(
    theirs: str, sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = tmp_path / "speech.csv"
    table.write_text(theirs)
    left_alone(refused(capsys, "analyse", sound, "-o", tmp_path), table)
    assert table.read_text() == theirs


def test_labels_that_were_corrected_in_praat_are_left_alone(
    sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    labels = tmp_path / "speech.TextGrid"
    analysed(sound, "-o", labels)
    parselmouth.read(str(labels)).save(str(labels))
    saved = labels.read_bytes()
    left_alone(refused(capsys, "analyse", sound, "-o", labels), labels)
    assert labels.read_bytes() == saved


def test_labels_of_audacity_give_way_to_the_same_only(
    sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    labels = tmp_path / "speech.txt"
    analysed(sound, "-o", labels)
    analysed(sound, "-o", labels)
    corrected = labels.read_text().replace("silence", "m")
    labels.write_text(corrected)
    left_alone(refused(capsys, "analyse", sound, "-o", labels), labels)
    assert labels.read_text() == corrected
    assert sorted(path.name for path in tmp_path.iterdir()) == ["speech.txt", "speech.wav"]


def test_the_others_of_a_folder_go_on(sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
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


@pytest.mark.parametrize("name", ["rhubarb-json", "gltf"])  # each format: tests/engine/test_conversion.py
def test_an_export_gives_way_to_the_same_only(
    name: str, sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / f"mine{FORMATS[name].ending}"
    for _ in range(2):
        assert exported(sound, "--format", name, "-o", target) == 0
    before = target.read_bytes()
    faster(sound)
    capsys.readouterr()
    left_alone(refused(capsys, "export", sound, "--format", name, "-o", target), target)
    assert target.read_bytes() == before
    assert exported(sound, "--format", name, "-o", target, "--overwrite") == 0
    assert target.read_bytes() != before


@pytest.mark.parametrize(("name", "theirs"), [(name, text) for name, texts in THEIRS.items() for text in texts])
def test_a_file_of_another_program_is_left_alone(
    name: str, theirs: str, sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / f"speech{FORMATS[name].full_ending}"
    target.write_text(theirs, encoding="utf-8")
    left_alone(refused(capsys, "export", sound, "--format", name, "-o", tmp_path), target)
    assert target.read_text(encoding="utf-8") == theirs
    assert exported(sound, "--format", name, "-o", tmp_path, "--overwrite") == 0
    assert target.read_text(encoding="utf-8") != theirs


def test_a_face_is_not_replaced_by_itself_talking(
    sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    face = tmp_path / "speech.glb"
    face.write_bytes(format_glb(load_head()))
    before = face.read_bytes()
    left_alone(refused(capsys, "export", sound, "--format", "gltf", "--mesh", face, "-o", tmp_path), face)
    assert face.read_bytes() == before


def test_one_format_does_not_take_the_place_of_another(
    sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "curves.csv"
    assert exported(sound, "--format", "livelink-csv", "-o", target) == 0
    capsys.readouterr()
    left_alone(refused(capsys, "export", sound, "--format", "oculus-csv", "-o", target), target)
    left_alone(refused(capsys, "analyse", sound, "-o", target), target)
