"""`phonemeanalyser speak`: a Chinese text, or a recording of one, as a plan and as files of other programs."""

import csv
import json
import tracemalloc
from itertools import pairwise
from pathlib import Path

import pytest

from phonemeanalyser.cli.main import main
from phonemeanalyser.cli.window import DEMO
from phonemeengine.speech.pinyin.table import USUAL_PINYIN_TABLE
from tests.tables import Capsys


def spoken(*words: object) -> None:
    assert main(["speak", *(str(word) for word in words)]) == 0


def jaw(path: Path) -> list[float]:
    with path.open(encoding="utf-8", newline="") as file:
        return [float(row["JawOpen"]) for row in csv.DictReader(file)]


def test_the_plan_of_a_text_is_printed_or_written_alike(tmp_path: Path, capsys: Capsys) -> None:
    spoken("你好，吗。", "--silent", "--plan", "-")
    printed = capsys.readouterr().out
    assert printed.splitlines()[1] == "0.000,0.075,0.250,syllable,你,ni2,di"
    (tmp_path / "text.txt").write_text("你好，吗。", encoding="utf-8")
    spoken("--file", tmp_path / "text.txt", "--silent", "--plan", tmp_path / "plan.csv")
    assert (tmp_path / "plan.csv").read_text(encoding="utf-8") == printed


def test_a_rate_a_table_of_ones_own_and_a_spring_change_the_mouth(tmp_path: Path) -> None:
    table = tmp_path / "mine.toml"
    table.write_text(USUAL_PINYIN_TABLE.read_text(encoding="utf-8").replace("reach = 0.5", "reach = 1"), "utf-8")
    changes = {"": [], "slow": ["--rate", 2], "mine": ["--pinyin-table", table], "spring": ["--spring", "1,400,40"]}
    for name, change in changes.items():
        spoken("妈妈。", "--silent", *change, "--export", tmp_path / f"{name}.csv", "--format", "livelink-csv")
    opened = {name: jaw(tmp_path / f"{name}.csv") for name in changes}
    assert len({tuple(weights) for weights in opened.values()}) == 4
    assert len(opened["slow"]) > 1.7 * len(opened[""])
    assert max(opened[""]) == pytest.approx(0.66)


def test_drawings_are_made_of_the_phones(tmp_path: Path) -> None:
    spoken("妈，风。", "--silent", "--export", tmp_path / "a.json", "--format", "rhubarb-json")
    cues = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))["mouthCues"]
    assert {"A", "D", "X"} <= {cue["value"] for cue in cues}


def test_rules_move_a_face_by_its_phones_and_other_movestates_always(tmp_path: Path, capsys: Capsys) -> None:
    for driver in ("pinyin", "rules"):
        export = ["--export", tmp_path / f"{driver}.csv", "--format", "livelink-csv"]
        spoken("妈妈。", "--silent", "--text-driver", driver, *export)
    assert jaw(tmp_path / "pinyin.csv") != jaw(tmp_path / "rules.csv")
    assert capsys.readouterr().err == ""
    export = ["--export", tmp_path / "o.csv", "--format", "oculus-csv"]
    spoken("妈妈。", "--silent", "--text-driver", "pinyin", *export)
    assert (
        capsys.readouterr().err
        == "phonemeanalyser: oculus-csv: note: it has shapes of its own, which follow the phones\n"
    )


def test_a_recording_is_said_when_its_labels_say(tmp_path: Path) -> None:
    sound = tmp_path / "talk.flac"
    sound.write_bytes(DEMO.read_bytes())
    tier = '"IntervalTier"\n"syllables"\n0\n2\n3\n0\n0.5\n""\n0.5\n0.8\n"ma1"\n0.8\n2\n""\n'
    grid = f'File type = "ooTextFile"\nObject class = "TextGrid"\n\n0\n2\n<exists>\n1\n{tier}'
    (tmp_path / "talk.TextGrid").write_text(grid, encoding="utf-8")
    export = ["--export", tmp_path / "a.csv", "--format", "livelink-csv"]
    spoken("--recording", sound, "--plan", tmp_path / "p.csv", *export)
    rows = (tmp_path / "p.csv").read_text(encoding="utf-8").splitlines()
    assert rows[1:3] == ["0.000,0.000,0.500,pause,,,&", "0.500,0.590,0.800,syllable,ma1,ma1,ba"]
    opened = jaw(tmp_path / "a.csv")
    assert opened[48] == pytest.approx(0.66)
    assert opened[30] == opened[70] == 0


def test_a_voice_that_speaks_chinese_moves_the_mouth_by_letters(tmp_path: Path) -> None:
    for driver in ("auto", "rules"):
        export = ["--export", tmp_path / f"{driver}.csv", "--format", "livelink-csv"]
        spoken("妈妈好。", "--text-driver", driver, *export, *(["--plan", tmp_path / "p.csv"] * (driver == "auto")))
    with (tmp_path / "p.csv").open(encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["kind"] == "syllable"]
    assert [(row["sound"], row["letters"]) for row in rows] == [("ma1", "ba"), ("ma1", "ba"), ("hao3", "ga")]
    assert max(jaw(tmp_path / "auto.csv")) > 0.5
    assert jaw(tmp_path / "auto.csv") != jaw(tmp_path / "rules.csv")


def test_what_is_not_said_is_told(capsys: Capsys) -> None:
    spoken("我🙂。", "--silent", "--plan", "-")
    assert "note: '🙂' has no sound that is known, and is left out\n" in capsys.readouterr().err


def test_every_language_is_planned_without_a_sound_by_every_driver(tmp_path: Path, capsys: Capsys) -> None:
    plans = set()
    for driver in ("auto", "rules"):
        spoken("Guten Tag, Welt.", "--language", "de", "--silent", "--text-driver", driver, "--plan", "-")
        plans.add(capsys.readouterr().out)
    (plan,) = plans
    rows = [*csv.DictReader(plan.splitlines())]
    assert list(dict.fromkeys(row["text"] for row in rows)) == ["Guten", "Tag", ",", "Welt", "."]
    assert all(a["end_s"] == b["start_s"] for a, b in pairwise(rows))
    assert [round(float(r["end_s"]) - float(r["start_s"]), 3) for r in rows if r["kind"] == "pause"] == [0.3, 0.6]
    spoken("Guten Tag", "--language", "de", "--silent", "--export", tmp_path / "m.csv", "--format", "livelink-csv")
    assert max(jaw(tmp_path / "m.csv")) > 0.2


def test_a_voice_of_any_language_has_a_plan(capsys: Capsys, tmp_path: Path) -> None:
    for language, text, marks in (("en-us", "Hello there. Yes!", [".", "!"]), ("cmn", "你好，吗。", ["，", "。"])):
        spoken(text, "--language", language, "--text-driver", "rules", "--plan", tmp_path / f"{language}.csv")
        with (tmp_path / f"{language}.csv").open(encoding="utf-8", newline="") as file:
            rows = [*csv.DictReader(file)]
        assert [row["text"] for row in rows if row["kind"] == "pause"] == marks


def test_the_memory_of_a_silent_text_does_not_grow_with_it(tmp_path: Path) -> None:
    peaks = []
    for n in (500, 3_000):
        (tmp_path / "t.txt").write_text("我" * n, encoding="utf-8")
        tracemalloc.start()
        spoken("--file", tmp_path / "t.txt", "--silent", "--plan", tmp_path / "p.csv", "--overwrite")
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
        assert len((tmp_path / "p.csv").read_bytes().splitlines()) == n + 1
    assert peaks[1] < peaks[0] + 2_500 * 50  # the text itself, a few times; a row takes more than 1000 bytes


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["。", "--language", "cmn", "--silent", "--plan", "-"], "there is no Chinese syllable in the text; write"),
        (["\n.", "--language", "de", "--silent", "--plan", "-"], "there is no word to speak in '\\n.'; write some"),
        (["你好", "--silent"], "there is nothing to write; ask for the plan with --plan"),
        (
            ["你好", "--silent", "--plan", "-", "-o", "a.wav"],
            "without a voice there are no sound and labels to write",
        ),
        (
            ["--recording", str(DEMO), "--plan", "-", "--lexicon", "l.csv"],
            "a lexicon is for a text, and says nothing",
        ),
        (["你好", "--silent", "--plan", "-", "--rate", "11"], "the rate must lie in 0.5..10 syllables per second"),
        (["你好", "--silent", "--plan", "-", "--spring", "1,2"], "a spring is MASS,STIFFNESS,DAMPING, such as"),
        (["你好", "--silent", "--plan", "-", "--pinyin-table", "none.toml"], "none.toml: there is no such file"),
        (["--recording", str(DEMO), "--plan", "-"], "demo.TextGrid: there is no such file"),
    ],
)
def test_what_cannot_be_spoken_is_refused_in_one_sentence(words: list[str], sentence: str, capsys: Capsys) -> None:
    assert main(["speak", *words]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith(f"phonemeanalyser: {sentence}")
    assert said.err.count("\n") == 1


def test_an_export_whose_ending_several_formats_have_needs_one(capsys: Capsys) -> None:
    with pytest.raises(SystemExit) as end:
        main(["speak", "你好", "--silent", "--export", "a.csv"])
    assert end.value.code == 2
    assert "several formats end as 'a.csv' does; choose one of livelink-csv, oculus-csv" in capsys.readouterr().err
