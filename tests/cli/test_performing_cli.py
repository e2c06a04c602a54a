"""Recorded faces that say what is said, as a person asks for them: the jaw of the recording opens steadily."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.cli.main import main
from phonemeengine import SoundReader
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.performance.corpus import build_table, pitches_of
from tests.engine.performance.corpora import TONE, write_recording
from tests.tables import Capsys

JAW = 2 + ARKIT.index("jawOpen")
PLAIN = ["--without", "poses,filters,energy,window"]


@pytest.fixture
def recorded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the recording "mami", and a table of it."""
    monkeypatch.chdir(tmp_path)
    write_recording(tmp_path)
    build_table(tmp_path, tmp_path / "ann.sqlite", name="Ann")
    return tmp_path


def jaws_in(path: Path) -> list[float]:
    with path.open(encoding="utf-8", newline="") as file:
        return [float(row[JAW]) for row in [*csv.reader(file)][1:]]


def test_a_recording_that_is_said_again_moves_as_it_did(recorded: Path) -> None:
    words = ["mami.wav", "--performance", "ann.sqlite", "--format", "livelink-csv", "-o", "out.csv"]
    assert main(["export", *words, "--script", "mami.TextGrid", "--units", "units.csv", *PLAIN]) == 0
    jaws = jaws_in(recorded / "out.csv")
    assert jaws[:61] == pytest.approx(np.linspace(0, 1, 61).tolist(), abs=0.01)
    assert jaws[61:] == pytest.approx([1.0] * len(jaws[61:]), abs=0.01)  # without a window, nothing leads to rest
    units = (recorded / "units.csv").read_text(encoding="utf-8").splitlines()
    assert "0.100,0.900,sentence,sil m a m i sil,mami,0.100,0.900" in units
    assert main(["speak", "--recording", "mami.wav", "--performance", "ann.sqlite", "--units", "again.csv"]) == 0
    assert (recorded / "again.csv").read_text(encoding="utf-8").splitlines() == units


def test_lips_meet_in_an_export_unless_poses_are_left_out(recorded: Path) -> None:
    words = ["export", "mami.wav", "--performance", "ann.sqlite", "--format", "livelink-csv", "--script"]
    assert main([*words, "mami.TextGrid", "-o", "out.csv"]) == 0
    second_m = jaws_in(recorded / "out.csv")[30:37]  # from 0.5 to 0.6 s
    assert min(second_m) < 0.06


def test_a_text_is_said_by_the_table_without_sound_too(recorded: Path, capsys: Capsys) -> None:
    words = ["妈咪", "--silent", "--performance", "ann.sqlite", "--export", "out.csv", "--format", "livelink-csv"]
    assert main(["speak", *words]) == 0
    assert max(jaws_in(recorded / "out.csv")) > 0.3
    assert main(["speak", "妈八", *words[1:], "--overwrite"]) == 0
    assert "Ann: note: the recordings have no [p], so it looks like [m]" in capsys.readouterr().err


def test_the_recordings_speak_in_place_of_the_voice(recorded: Path, capsys: Capsys) -> None:
    words = ["speak", "mummy", "--language", "en-us", "--performance", "ann.sqlite", "--performance-sound"]
    assert main([*words, "-o", "own.wav", "--units", "units.csv"]) == 0
    assert "Ann: note: the recordings have no [ʌ], so it sounds like" in capsys.readouterr().err
    with SoundReader(recorded / "own.wav") as reader:
        heard = pitches_of(reader.read_mono())
    assert np.median(heard[heard > 0]) == pytest.approx(TONE, rel=0.03)  # which is all that is heard in the recording
    (recorded / "mami.wav").unlink()
    assert main([*words, "-o", "again.wav"]) == 1
    assert "the sound of the recording 'mami' is not in the folder '.'" in capsys.readouterr().err
    assert not (recorded / "again.wav").exists()


def _head_in(folder: Path) -> dict[str, list[float]]:
    curves = json.loads((folder / "out.json").read_text(encoding="utf-8"))
    return {curve["name"]: curve["values"] for curve in (*curves["head"], *curves["curves"])}


def test_the_head_makes_the_gestures_of_key_words_unless_it_is_left_out(recorded: Path) -> None:
    own = 'format = "phonemeanalyser keywords 1"\n[gestures.bow]\nshortest = 0.5\n'
    own += 'channels = { headPitch = [-20] }\n[languages.en]\nbow = ["mami"]\n'
    (recorded / "own.toml").write_text(own, encoding="utf-8")
    words = ["export", "mami.wav", "--performance", "ann.sqlite", "--format", "curves-json", "-o", "out.json"]
    words += ["--script", "mami.TextGrid", "--language", "en-us", "--overwrite"]
    assert main(words) == 0
    assert min(_head_in(recorded).get("pitch", [0])) > -3
    assert main([*words, "--keywords", "own.toml"]) == 0
    moved = _head_in(recorded)
    assert min(moved["pitch"]) < -14
    assert "tongueMidDorsalPalate" in moved
    assert main([*words, "--keywords", "own.toml", "--without", "head"]) == 0
    assert "pitch" not in _head_in(recorded)


def test_formats_with_shapes_of_their_own_follow_the_phones(recorded: Path, capsys: Capsys) -> None:
    words = ["mami.wav", "--performance", "ann.sqlite", "--format", "rhubarb-tsv", "--script", "mami.TextGrid"]
    assert main(["export", *words]) == 0
    said = capsys.readouterr()
    assert "rhubarb-tsv: note: it has shapes of its own, which follow the phones" in said.err
    assert said.out.startswith("0.00\t")


def test_several_tables_may_follow_one_option_wherever_the_text_stands(recorded: Path) -> None:
    build_table(recorded, recorded / "bob.sqlite", name="Bob")
    tables = ["--performance", "ann.sqlite", "bob.sqlite"]
    for words in ([*tables, "mami.wav", "--use", "Bob"], ["mami.wav", "--use", "Ann", *tables]):
        script = ["--script", "mami.TextGrid", "--format", "livelink-csv", "-o", "out.csv"]
        assert main(["export", *words, *script]) == 0
        assert max(jaws_in(recorded / "out.csv")) > 0.5


TABLES = ["--performance", "ann.sqlite", "--performance", "ann.sqlite"]
EXPORT = ["export", "mami.wav", "--format", "livelink-csv", "-o", "out.csv"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ([*EXPORT, *TABLES], "one table moves a face, and there are 'Ann', 'Ann'; name one of them with --use"),
        ([*EXPORT, "--performance", "ann.sqlite", "--use", "Bob"], "there is no such table 'Bob', but 'Ann'"),
        ([*EXPORT, *TABLES, "--person", "Bob"], "there is no table of 'Bob', as none says who speaks in it"),
        ([*EXPORT, "--performance", "ann.sqlite", "--keywords", "mami.csv"], "mami.csv: this is no TOML file"),
        ([*EXPORT, "--performance", "ann.sqlite", "--units", "mami.csv"], "mami.csv: the file that is there"),
        (
            ["speak", "hi", "--silent", "--plan", "-", "--performance", "ann.sqlite", "--performance-sound"],
            "without sound no recording speaks; leave --performance-sound, --silent or --recording out",
        ),
    ],
)
def test_what_cannot_be_done_is_said_in_a_sentence(
    recorded: Path, words: list[str], sentence: str, capsys: Capsys
) -> None:
    assert main(words) == 1
    err = capsys.readouterr().err
    assert sentence in err
    assert err.count("\n") == 1


@pytest.mark.parametrize("words", [["--use", "Ann"], ["--keywords", "own.toml"], ["--choice", "band"]])
def test_what_only_recorded_faces_use_is_wrong_usage_without_them(words: list[str], capsys: Capsys) -> None:
    with pytest.raises(SystemExit, match="2"):
        main([*EXPORT, *words])
    assert f"{words[0]} goes with --performance: name a table" in capsys.readouterr().err
