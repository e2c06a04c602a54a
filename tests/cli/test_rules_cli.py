"""``phonemeanalyser rules`` and ``explain``: few rules from recordings, and what rules say as text."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeanalyser.cli.main import main
from phonemeengine.calibration.fits.rule_finding import rules_from
from phonemeengine.calibration.scores.corpus import read_corpus
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset, save_preset
from phonemeengine.recognition.rules import Condition, Rule
from tests.corpora import write_corpus
from tests.sounds import noise, silence

THESIS = load_preset(FACTORY / "thesis.toml")
RULES = (
    Rule(Phoneme.SILENCE, (Condition("volume", "<", limit=0.05),)),
    Rule(Phoneme.A, (Condition("volume", ">", limit=3.0),)),
    Rule(
        Phoneme.SZ, (Condition("zero_crossings", ">", limit=5.0), Condition("volume", "<", limit=1.0, enabled=False))
    ),
    Rule(Phoneme.O, (), enabled=False),
)


@pytest.fixture
def preset(tmp_path: Path) -> Path:
    path = tmp_path / "own.toml"
    save_preset(replace(THESIS, recogniser="rules", rules=RULES), path)
    return path


@pytest.fixture
def sound(tmp_path: Path) -> Path:
    """Half a second of silence, and half a second of hiss."""
    path = tmp_path / "hiss.wav"
    soundfile.write(path, np.concatenate([silence(0.5), noise(0.5, 0.2)]), 44_100, subtype="FLOAT")
    return path


def test_rules_are_found_in_a_folder_written_and_said(tmp_path, capsys):
    corpus = tmp_path / "corpus"
    corpus.mkdir()
    write_corpus(corpus, THESIS, ("made/ann", "made/bob"))
    out = tmp_path / "few.toml"
    assert main(["rules", str(corpus), "-o", str(out), "--conditions", "9"]) == 0
    said, preset = capsys.readouterr().out, load_preset(out)
    assert preset.recogniser == "rules"
    assert preset.name == "few"
    assert sum(len(rule.conditions) for rule in preset.rules) <= 9
    assert re.search(r"speakers held out: macro F1 [01]\.\d+, mouth shapes", said)
    assert said.removeprefix(f"{out}: ").startswith(preset.notes)
    from_program = rules_from(read_corpus(corpus), load_preset("thesis"), most_conditions=9)
    assert preset.rules == from_program.preset.rules
    assert main(["rules", str(corpus), "-o", str(out)]) == 1
    assert "left alone" in capsys.readouterr().err


def test_rules_are_text_with_what_is_off_and_what_is_of_no_use(preset, sound, capsys):
    assert main(["explain", str(sound), "--preset", str(preset)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines == [
        "  1  silence       if volume (peak level) < 0.05",
        "  2  a             if volume (peak level) > 3  (never holds in the loaded sound)",
        "  3  sz            if zero crossings (zero_crossings) > 5",
        "                   [off: volume (peak level) < 1]",
        "  4  o             [off]",
        "                   always",
    ]


def test_the_thesis_rules_are_shown_with_the_names_of_their_numbers(capsys):
    assert main(["explain", "--preset", "thesis"]) == 0
    assert "sz  " in (said := capsys.readouterr().out)
    assert f"(m_szsch1) > {THESIS.thresholds.szsch_szsch1:g}  [szsch_szsch1]" in said


def test_a_time_is_explained_by_all_comparisons_down_to_the_rule_that_fired(preset, sound, capsys):
    assert main(["explain", str(sound), "--preset", str(preset), "--at", "0.2", "0.8"]) == 0
    quiet, hiss = re.split(r"(?=0\.80 s)", capsys.readouterr().out)
    assert quiet.splitlines()[:2] == ["0.20 s: silence", "  silence: volume (peak level) 0 < 0.05 holds by 0.05"]
    assert hiss.startswith("0.80 s: sz\n  silence: volume (peak level) ")
    assert "  sz: zero crossings (zero_crossings) " in hiss


def test_a_preset_without_rules_and_a_time_without_sound_are_refused(capsys):
    assert main(["explain", "--preset", "templates"]) == 1
    assert "has no rules; choose a preset with rules" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["explain", "--at", "1"])
    assert "--at goes with an audio file" in capsys.readouterr().err


def test_a_time_behind_the_end_is_refused(preset, sound, capsys):
    assert main(["explain", str(sound), "--preset", str(preset), "--at", "9"]) == 1
    assert "ends before 9 s" in capsys.readouterr().err
