"""The page of ``phonemeanalyser score``: whole in itself, well-formed, and what it shows is what was scored."""

import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from phonemeanalyser.cli.main import main
from phonemeanalyser.colours import PHONEME_COLOURS
from phonemeanalyser.reports.page import page_of
from phonemeanalyser.reports.report import Report, ScoredPreset, clock, signed, written
from phonemeengine.calibration.scores.comparison import compare
from phonemeengine.calibration.scores.corpus import read_corpus
from phonemeengine.calibration.scores.evaluation import score
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.presets.preset import rule_lines
from phonemeengine.recognition.rules import Condition, Rule
from tests.corpora import put, speech, write_corpus, write_manifest
from tests.tables import Capsys

THESIS, CLEAN = (load_preset(FACTORY / name) for name in ("thesis.toml", "thesis-anti-aliased.toml"))
HOSTILE = "<b>\"&amp;'\x07"


def report_on(folder: Path, *, two: bool, left_out: tuple[str, ...] = ()) -> Report:
    utterances = read_corpus(folder)
    presets = (THESIS, CLEAN)[: 1 + two]
    scored = tuple(ScoredPreset(p.name, score(p, utterances)) for p in presets)
    comparison = compare(scored[0].scores, scored[1].scores) if two else None
    return Report(folder, scored, comparison, left_out=left_out)


def parsed(page: str) -> ElementTree.Element:
    assert page.startswith("<!DOCTYPE html>\n")
    return ElementTree.fromstring(page.removeprefix("<!DOCTYPE html>\n"))


def words_of(element: ElementTree.Element) -> str:
    return " ".join(" ".join(element.itertext()).split())


def test_the_page_is_well_formed_and_asks_the_network_for_nothing(tmp_path: Path) -> None:
    page = page_of(report_on(write_corpus(tmp_path, THESIS), two=True))
    root = parsed(page)
    assert not re.search(r"https?:|url\(|src=|href=|@import|<script", page, re.IGNORECASE)
    assert len(root.findall(".//svg")) >= 4
    assert "prefers-color-scheme:dark" in page
    assert "@media print" in page
    for variable in re.findall(r"var\(--(\w+)\)", page):
        assert f"--{variable}:" in page


def test_the_figures_of_the_page_are_those_that_were_scored(tmp_path: Path) -> None:
    report = report_on(write_corpus(tmp_path, THESIS), two=True)
    root = parsed(page_of(report))
    tiles = [words_of(tile) for tile in root.findall(".//div[@class='tile']")]
    one, other = (preset.scores.overall for preset in report.presets)
    assert tiles[0] == f"Macro F1 {one.scores.macro_f1:.3f} {other.scores.macro_f1:.3f}" != "Macro F1 1.000 1.000"
    assert tiles[5].startswith(f"Changes per second {one.scores.changes_per_s:.1f} {other.scores.changes_per_s:.1f}")
    said = words_of(root)
    for name in (
        "Thesis against Thesis, anti-aliased",
        "3 recordings",
        "human/ann",
        "machine/cyd",
        "look-ahead 0 ms",
    ):
        assert name in said
    first = report.comparison.segments_one[0]
    assert f"{clock(first.start)}–{clock(first.end)} {first.label.label} {first.wrong.label}" in said


def test_the_cells_of_a_heat_map_add_up_to_all_frames(tmp_path: Path) -> None:
    report = report_on(write_corpus(tmp_path, THESIS), two=False)
    root = parsed(page_of(report))
    (heat,) = (svg for svg in root.iter("svg") if svg.get("aria-label", "").startswith("Confusion"))
    tips = [title.text or "" for title in heat.iter("title")]
    assert len(tips) == 121
    assert sum(int(tip.split(": ")[1].split()[0]) for tip in tips) == report.first.overall.confusion.sum()


def test_time_lines_have_the_phonemes_colours_and_no_gap(tmp_path: Path) -> None:
    report = report_on(write_corpus(tmp_path, THESIS, ["c/s"]), two=False)
    root = parsed(page_of(report))
    (line,) = (svg for svg in root.iter("svg") if re.match(r"\d:\d\d", svg.get("aria-label", "")))
    boxes = [r for r in line.iter("rect") if r.find("title") is not None]
    lanes = {y: [r for r in boxes if r.get("y") == y] for y in {r.get("y") for r in boxes}}
    assert len(lanes) == 2
    (heard,) = report.first.predictions
    n_runs = np.count_nonzero(np.diff(heard.phonemes)) + 1
    for lane in lanes.values():
        assert len(lane) == n_runs
        ends = [float(r.get("x")) + float(r.get("width")) for r in lane]
        assert [float(r.get("x")) for r in lane[1:]] == pytest.approx(ends[:-1], abs=0.11)
        names = [r.find("title").text.split(",")[0] for r in lane]
        assert [r.get("fill") for r in lane] == [PHONEME_COLOURS[Phoneme[name.upper()]] for name in names]
    assert not [r for r in line.iter("rect") if r.get("class") == "wrong"]


def test_what_is_wrong_is_marked_as_long_as_it_is(tmp_path: Path) -> None:
    put(tmp_path, "u", speech(), (Label(0, 0.2, "sil", Phoneme.SILENCE), Label(0.2, 1.2, "m", Phoneme.M)))
    write_manifest(tmp_path, [("c", "s", "u.wav", "u.csv")])
    report = report_on(tmp_path, two=False)
    (heard,) = report.first.predictions
    wide = sum(float(r.get("width")) for r in parsed(page_of(report)).iter("rect") if r.get("class") == "wrong")
    assert wide / 160 == pytest.approx(np.sum(~heard.right) / 100, abs=0.02)
    assert wide > 0


def test_the_rules_of_each_preset_are_listed_and_a_network_has_none(tmp_path: Path) -> None:
    own = replace(
        THESIS, name="own", recogniser="rules", rules=(Rule(Phoneme.A, (Condition("f0", ">", limit=90.5),)),)
    )
    utterances = read_corpus(write_corpus(tmp_path, THESIS))
    learned = load_preset(FACTORY / "learned.toml")
    presets = tuple(ScoredPreset(p.name, score(p, utterances)) for p in (own, THESIS))
    root = parsed(page_of(Report(tmp_path, presets, compare(*(p.scores for p in presets)))))
    section = next(s for s in root.iter("section") if s.findtext("h2") == "Rules")
    assert [title.text for title in section.iter("h3")] == ["own", "Thesis"]
    first, second = ("".join(lines.itertext()).strip("\n").splitlines() for lines in section.iter("pre"))
    assert first == rule_lines(own)
    assert "pitch (f0) > 90.5" in first[0]
    assert second == rule_lines(THESIS)
    alone = page_of(Report(tmp_path, (ScoredPreset("learned", score(learned, utterances)),), None))
    assert all(s.findtext("h2") != "Rules" for s in parsed(alone).iter("section"))


def test_hostile_names_are_only_words(tmp_path: Path) -> None:
    put(tmp_path, "u", speech(), (Label(0, 1.2, "a", Phoneme.A),))
    put(tmp_path, "v&amp;_x", speech(), (Label(0, 1.2, "a", Phoneme.A),))
    rows = [(HOSTILE, HOSTILE, "u.wav", "u.csv"), ("c", "s", "v&amp;_x.wav", "v&amp;_x.csv")]
    write_manifest(tmp_path, rows)
    report = report_on(tmp_path, two=True, left_out=(HOSTILE,))
    hostile = tuple(replace(preset, title=f"%s {HOSTILE}") for preset in report.presets)
    page = page_of(replace(report, presets=hostile))
    root = parsed(page)
    assert "\x07" not in page
    said = words_of(root)
    assert "v&amp;_ x.wav" in said
    assert f"A is %s {HOSTILE[:-1]}?, B is" in said
    assert f"{HOSTILE[:-1]}?/{HOSTILE[:-1]}?" in said
    assert '<b>"' not in page


def test_what_was_left_out_is_said(tmp_path: Path, capsys: Capsys) -> None:
    write_corpus(tmp_path, THESIS)
    (tmp_path / "u0.wav").write_bytes(b"none")
    out = tmp_path / "r.html"
    assert main(["score", str(tmp_path), "--preset", str(FACTORY / "thesis.toml"), "-o", str(out)]) == 1
    sentence = capsys.readouterr().err.strip().removeprefix("phonemeanalyser: ")
    (note,) = parsed(out.read_text(encoding="utf-8")).findall(".//p[@class='note']")
    assert note.text == sentence


def test_where_there_is_nothing_to_count_stands_a_dash(tmp_path: Path) -> None:
    put(tmp_path, "u", speech(), (Label(0, 1.2, "t", Phoneme.UNIDENTIFIED),))
    write_manifest(tmp_path, [("c", "s", "u.wav", "u.csv")])
    for two in (False, True):
        report = report_on(tmp_path, two=two)
        tile = parsed(page_of(report)).find(".//div[@class='tile']")
        assert words_of(tile) == "Macro F1 " + " ".join("–" * (1 + two))


def test_a_long_recording_is_drawn_as_far_as_it_says(tmp_path: Path) -> None:
    long = np.tile(speech(), 25)
    put(tmp_path, "u", long, (Label(0, len(long) / 44100, "a", Phoneme.A),))
    write_manifest(tmp_path, [("c", "s", "u.wav", "u.csv")])
    root = parsed(page_of(report_on(tmp_path, two=False)))
    lines = [svg.get("aria-label") for svg in root.iter("svg") if re.match(r"\d:\d\d", svg.get("aria-label", ""))]
    assert lines[0] == "0:00.00 to 0:06.00"
    assert lines[-1] == "0:24.00 to 0:30.00"
    assert "The first 30 s of 37.5 s" in words_of(root)


def test_who_asks_for_no_page_does_not_wait_for_templates(tmp_path: Path) -> None:
    words = ["score", str(write_corpus(tmp_path, THESIS, ["c/s"])), "--preset", str(FACTORY / "thesis.toml")]
    code = "import sys; from phonemeanalyser.cli.main import main; main(sys.argv[1:]); print('jinja2' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code, *words], capture_output=True, text=True, check=True)
    assert done.stdout.endswith("False\n")


def test_figures_are_written_as_people_read_them() -> None:
    assert (written(0.12345), written(2.0, 1), written(float("nan"))) == ("0.123", "2.0", "–")
    assert (signed(3), signed(-3), signed(0.2)) == ("+3", "−3", "0")
    assert (clock(0.014), clock(59.999), clock(61.5)) == ("0:00.01", "1:00.00", "1:01.50")
