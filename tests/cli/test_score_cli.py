"""``phonemeanalyser score``: what it prints, its exit codes, and that its figures are those of the corpus scorer."""

import contextlib
import csv
import io
import json
import math
import subprocess
import sys
from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeengine.calibration.scores.scoring import Scores
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset, save_preset
from phonemeengine.settings import SAMPLE_RATE
from tests.conftest import SCORER
from tests.corpora import put, speech, write_corpus, write_manifest
from tests.labelled import OF_THE_SCORER
from tests.tables import Capsys, refused

THESIS, CLEAN = FACTORY / "thesis.toml", FACTORY / "thesis-anti-aliased.toml"
PRESET = load_preset(THESIS)
SHARES = tuple(OF_THE_SCORER.values())
FIGURES = [field.name for field in fields(Scores)]

Said = Callable[..., str]


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """A corpus of three recordings that the thesis preset recognises without a fault."""
    folder = tmp_path / "small"
    folder.mkdir()
    return write_corpus(folder, PRESET)


@pytest.fixture
def printed(capsys: Capsys) -> Said:
    """Runs the command, which succeeds, and gives what it prints."""

    def run(*words: object) -> str:
        assert main(["score", *(str(word) for word in words)]) == 0
        said = capsys.readouterr()
        assert said.err == ""
        return said.out

    return run


def test_right_answers_score_one_in_json(small: Path, printed: Said) -> None:
    document = json.loads(printed(small, "--preset", THESIS, "--format", "json"))
    (preset,) = document["presets"]
    assert (document["corpus"], document["noise"], document["comparison"]) == ("small", None, None)
    assert (preset["name"], preset["recogniser"], preset["look_ahead_ms"]) == (PRESET.name, "thesis", 0)
    for group in (preset["all"], *preset["by_corpus"].values(), *preset["by_speaker"].values()):
        assert [group[name] for name in SHARES] == [1, 1, 1, 1, 1, 1, 0]
        confusion = np.array(group["confusion"])
        assert confusion.sum() == np.trace(confusion) == round(6000 * group["minutes"])
    assert list(preset["by_corpus"]) == ["human", "machine"]
    assert [row["file"] for row in preset["recordings"]] == ["u0.wav", "u1.wav", "u2.wav"]


def test_the_numbers_of_two_presets_stand_beside_what_they_divide(small: Path, printed: Said, tmp_path: Path) -> None:
    out = tmp_path / "numbers.csv"
    said = printed(small, "--preset", THESIS, "--against", CLEAN, "--phoneme-data", out)
    assert "frames whose phoneme is another one with B: " in said
    with out.open(newline="") as file:
        rows = list(csv.DictReader(file))
    own, other = PRESET.phoneme_data, load_preset(CLEAN).phoneme_data
    assert {row["number"]: (float(row["value"]), float(row["other"])) for row in rows} == {
        name: (pytest.approx(value, rel=1e-5), pytest.approx(getattr(other, name), rel=1e-5))
        for name, value in vars(own).items()
    }
    (row,) = [r for r in rows if (r["number"], r["speaker"], r["side"]) == ("szsch_szsch1", "all", "holds")]
    assert (row["variable"], row["sign"], row["sounds"]) == ("m_szsch1", ">", "sz sch")


def test_the_table_is_that_of_the_corpus_scorer(small: Path, printed: Said) -> None:
    lines = printed(small, "--preset", THESIS, "--by", "speaker").splitlines()
    assert lines[0].startswith("small: 3 recordings, 0.1 minutes, 3 speakers, lag 0 ms")
    head = next(k for k, line in enumerate(lines) if line.startswith("lag 0 ms"))
    assert lines[head].split()[3:] == list(FIGURES)
    table = [line.split() for line in lines[head + 1 : head + 5]]
    assert [row[0] for row in table] == ["all", "human/ann", "human/bob", "machine/cyd"]
    assert all(row[1:8] == ["1.000"] * 6 + ["0.000"] for row in table)
    assert len({len(line) for line in lines[head : head + 5]}) == 1
    assert "\nhuman  " in printed(small, "--preset", THESIS)


def test_the_confusion_is_told_in_percent(small: Path, tmp_path: Path, printed: Said) -> None:
    def partly_labelled_m(codes: np.ndarray) -> np.ndarray:
        silent = np.flatnonzero(codes == Phoneme.SILENCE)
        return np.where(np.isin(np.arange(len(codes)), silent[::4]), Phoneme.M, codes)

    folder = tmp_path / "changed"
    folder.mkdir()
    write_corpus(folder, PRESET, ["c/s"], partly_labelled_m)
    text = printed(folder, "--preset", THESIS)
    columns = next(line for line in text.splitlines() if line.startswith("label, %")).split()[3:]
    row = next(line for line in text.splitlines() if line.startswith("m ")).split()[1:]
    assert columns[0] == "silence"
    assert columns[-1] == "frames"
    assert int(row[0]) > 0
    assert sum(int(cell) for cell in row[:-1] if cell != "·") in range(98, 103)


def test_small_figures_are_those_of_the_corpus_scorer(small: Path, tmp_path: Path) -> None:
    holds_what_the_scorer_says(small, tmp_path, CLEAN, "-20")


@pytest.mark.long
def test_figures_of_the_whole_corpus_are_those_of_the_corpus_scorer(corpus: Path, tmp_path: Path) -> None:
    holds_what_the_scorer_says(corpus, tmp_path, THESIS, "20")


def holds_what_the_scorer_says(corpus: Path, tmp_path: Path, preset: Path, lag: str) -> None:
    """Score the tables of ``analyse`` with the scorer as a process, and hold ours beside it."""
    assert main(["analyse", str(corpus), "--preset", str(preset), "-o", str(tmp_path / "found")]) == 0
    out = tmp_path / "ours.json"
    assert main(["score", str(corpus), "--preset", str(preset), f"--lag={lag}", "-o", str(out)]) == 0
    (ours,) = json.loads(out.read_text())["presets"]
    for by in ("corpus", "speaker"):
        theirs = tmp_path / f"{by}.json"
        command = [sys.executable, str(SCORER), str(corpus), str(tmp_path / "found"), f"--lag={lag}", "--by", by]
        subprocess.run([*command, "--json", str(theirs)], check=True, capture_output=True)
        groups = json.loads(theirs.read_text())["groups"]
        assert groups.keys() == {"all", *ours[f"by_{by}"]}
        for name, expected in groups.items():
            found = ours["all"] if name == "all" else ours[f"by_{by}"][name]
            for figure, value in expected.items():
                digits = 0.00051 if figure in OF_THE_SCORER else 0.0051
                missing = value is None or math.isnan(value)
                ours_is = found[OF_THE_SCORER.get(figure, figure)]
                assert ours_is == (None if missing else pytest.approx(value, abs=digits)), (name, figure)


def test_two_presets_are_compared(small: Path, printed: Said) -> None:
    words = (small, "--preset", THESIS, "--against", CLEAN)
    document = json.loads(printed(*words, "--format", "json"))
    one, other = document["presets"]
    assert (one["title"], other["title"]) == ("Thesis", "Thesis, anti-aliased")
    gains = document["comparison"]
    for k, phoneme in enumerate(document["phonemes"]):
        both, first = gains["both_right"][phoneme], gains["only_first"][phoneme]
        assert both + first == one["all"]["confusion"][k][k]
        assert both + gains["only_second"][phoneme] == other["all"]["confusion"][k][k]
    assert sum(gains["only_second"].values()) == 0  # the first made the labels
    assert gains["stretches_only_first"][0]["end_s"] > gains["stretches_only_first"][0]["start_s"]
    text = printed(*words)
    assert "What Thesis (A) gets right that Thesis, anti-aliased (B) misses" in text
    assert "the longest segments that only A gets right" in text
    assert "  viseme_accuracy  " in text
    stretch = gains["stretches_only_first"][0]
    assert f"{stretch['label']}, which B calls {stretch['wrong']}" in text


def test_presets_of_the_same_name_are_told_apart(small: Path, tmp_path: Path, printed: Said) -> None:
    (tmp_path / "a").mkdir()
    other = replace(PRESET, settings=replace(PRESET.settings, minimum_hold=0.1))
    for path, preset in (("one.toml", PRESET), ("two.toml", other), ("a/one.toml", other)):
        save_preset(preset, tmp_path / path)
    words = (small, "--format", "json", "--preset", tmp_path / "one.toml", "--against")
    titles = [p["title"] for p in json.loads(printed(*words, tmp_path / "two.toml"))["presets"]]
    assert titles == ["Thesis (one.toml)", "Thesis (two.toml)"]
    titles = [p["title"] for p in json.loads(printed(*words, tmp_path / "a" / "one.toml"))["presets"]]
    assert len(set(titles)) == 2


def test_one_preset_is_not_compared_with_itself(small: Path, tmp_path: Path, capsys: Capsys) -> None:
    (tmp_path / "copy.toml").write_bytes(THESIS.read_bytes())
    said = refused(capsys, "score", small, "--preset", THESIS, "--against", tmp_path / "copy.toml")
    assert said == "thesis.toml and copy.toml hold the same preset; name two that differ"


def test_noise_costs_what_it_costs_again(small: Path, printed: Said) -> None:
    words = (small, "--preset", THESIS, "--format", "json", "--noise", "babble", "--snr", "0")
    text = printed(*words)
    document = json.loads(text)
    assert document["noise"] == {"kind": "babble", "snr_db": 0, "seed": 0}
    assert document["presets"][0]["all"]["macro_f1"] < 0.9
    assert printed(*words) == text
    assert printed(*words, "--seed", "1") != text
    assert "babble noise 0 dB below the speech (seed 0)" in printed(*words[:3], *words[5:])


def test_a_terminal_with_few_characters_is_no_fault(small: Path) -> None:
    words = ["score", str(small), "--preset", str(THESIS), "--against", str(CLEAN), "--format"]
    shown = io.BytesIO()
    with contextlib.redirect_stdout(io.TextIOWrapper(shown, "ascii")):
        assert [main([*words, kind]) for kind in ("text", "html")] == [0, 0]
        assert shown.getvalue().isascii()
        assert b"</html>" in shown.getvalue()


@pytest.mark.parametrize(
    ("name", "begins"),
    [("r.html", "<!DOCTYPE html>"), ("r.json", "{"), ("r.txt", "small: "), ("deep/er/r", "small: ")],
)
def test_the_ending_of_the_file_says_the_format(
    small: Path, tmp_path: Path, printed: Said, name: str, begins: str
) -> None:
    assert printed(small, "--preset", THESIS, "-o", tmp_path / name) == ""
    assert (tmp_path / name).read_text(encoding="utf-8").startswith(begins)


def test_the_format_that_is_asked_for_goes_before_the_ending(small: Path, tmp_path: Path, printed: Said) -> None:
    printed(small, "--preset", THESIS, "-o", tmp_path / "r.html", "--format", "json")
    json.loads((tmp_path / "r.html").read_text())


def test_a_file_that_cannot_be_written_is_one_sentence(small: Path, tmp_path: Path, capsys: Capsys) -> None:
    (tmp_path / "file").write_text("")
    said = refused(capsys, "score", small, "--preset", THESIS, "-o", tmp_path / "file" / "r.html")
    assert "cannot be written" in said


def test_a_sound_that_cannot_be_read_is_said_and_the_others_are_scored(small: Path, capsys: Capsys) -> None:
    (small / "u1.wav").write_bytes(b"RIFF nonsense")
    assert main(["score", str(small), "--preset", str(THESIS), "--against", str(CLEAN), "--format", "json"]) == 1
    said = capsys.readouterr()
    (line,) = said.err.splitlines()
    assert line.startswith("phonemeanalyser: u1.wav: ")
    document = json.loads(said.out)
    assert [preset["all"]["recordings"] for preset in document["presets"]] == [2, 2]
    assert document["left_out"] == [line.removeprefix("phonemeanalyser: ")]


def test_a_sound_that_breaks_in_the_middle_is_said_once(small: Path, capsys: Capsys) -> None:
    sound = speech()
    sound[20_000] = np.nan
    soundfile.write(small / "u1.wav", sound, SAMPLE_RATE, subtype="FLOAT")
    assert main(["score", str(small), "--preset", str(THESIS), "--against", str(CLEAN)]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert "NaN" in line


def test_nothing_that_can_be_read_is_nothing_to_score(small: Path, capsys: Capsys) -> None:
    for k in range(3):
        (small / f"u{k}.wav").write_bytes(b"")
    assert main(["score", str(small)]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    assert len(said.err.splitlines()) == 4
    assert "no labelled sound that can be scored" in said.err.splitlines()[-1]


def test_a_folder_that_is_not_there_or_holds_nothing_is_refused(tmp_path: Path, capsys: Capsys) -> None:
    assert "there is no such folder" in refused(capsys, "score", tmp_path / "gone")
    assert "no labelled sound was found here" in refused(capsys, "score", tmp_path)
    write_manifest(tmp_path, [])
    assert "no row under the header; add one" in refused(capsys, "score", tmp_path)


def test_names_that_nobody_knows_are_mapped(tmp_path: Path, capsys: Capsys, printed: Said) -> None:
    put(tmp_path, "u", speech(), (Label(0, 1, "a", Phoneme.A),))
    (tmp_path / "u.csv").unlink()
    (tmp_path / "u.txt").write_text("0.0\t0.2\tstill\n0.2\t1.2\tgrrr\n")
    said = refused(capsys, "score", tmp_path, "--preset", THESIS)
    assert "'grrr' (1 x)" in said
    assert "--map" in said
    (tmp_path / "map.toml").write_text('[phonemes]\ngrrr = "a"\nstill = "silence"\n')
    text = printed(tmp_path, "--preset", THESIS, "--map", tmp_path / "map.toml", "--format", "json")
    counted = np.array(json.loads(text)["presets"][0]["all"]["confusion"]).sum(axis=1)
    assert (counted[Phoneme.SILENCE], counted[Phoneme.A], counted.sum()) == (20, 100, 120)
    assert "gone.toml" in refused(capsys, "score", tmp_path, "--map", tmp_path / "gone.toml")


def test_a_preset_that_is_not_there_is_refused(small: Path, capsys: Capsys) -> None:
    assert "gone.toml" in refused(capsys, "score", small, "--preset", "gone.toml")
    assert "gone.toml" in refused(capsys, "score", small, "--against", "gone.toml")
