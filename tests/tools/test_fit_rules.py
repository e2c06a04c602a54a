"""Extended rules and templates, fitted to labelled speech from the command line."""

from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import analyse_blocks
from phonemeengine.calibration.fits.rule_finding import candidates
from phonemeengine.calibration.fits.rule_search import MOST_CONDITIONS
from phonemeengine.calibration.scores.corpus import Label, LabelledUtterance, frame_labels_of, read_corpus
from phonemeengine.calibration.scores.scoring import Scores, scores_of
from phonemeengine.features.variables import check_user_variables
from phonemeengine.labels.utterance import CORE
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.presets.preset import Preset
from tests.corpora import put, speech, write_manifest
from tools.fit import rules as fit_rules
from tools.fit import templates as fit_templates
from tools.fit.rules import voice_of

TIMES = (0.0, 0.2, 0.5, 0.7, 1.0, 1.3, 1.5)
SAID = (Phoneme.SILENCE, Phoneme.A, Phoneme.SZ, Phoneme.I, Phoneme.U, Phoneme.SILENCE)
LABELS = tuple(Label(a, b, p.label, p, CORE) for a, b, p in zip(TIMES[:-1], TIMES[1:], SAID, strict=True))


@pytest.fixture
def small_corpus(tmp_path: Path) -> Path:
    """Four speakers who say the same."""
    for k in range(4):
        put(tmp_path, f"u{k}", speech(100.0 + 30 * k, k), LABELS)
    write_manifest(tmp_path, [("human_small", f"speaker{k}", f"u{k}.wav", f"u{k}.csv") for k in range(4)])
    return tmp_path


def scores_on(folder: Path, preset: Preset) -> Scores:
    pairs = []
    for utterance in read_corpus(folder):
        sound, _ = soundfile.read(utterance.path, dtype="float32")
        found = np.concatenate([a.phonemes for a in analyse_blocks([sound], preset)])
        pairs.append((frame_labels_of(utterance.labels), found))
    return scores_of(pairs)


@pytest.mark.long
def test_rules_grown_from_a_small_corpus_recognise_it(small_corpus, capsys):
    out = small_corpus / "out"
    assert fit_rules.main([str(small_corpus), "-o", str(out), "--more", str(small_corpus)]) == 0
    preset = load_preset(out / "extended.toml")
    assert preset.notes in capsys.readouterr().out
    assert preset.recogniser == "rules"
    assert {c.variable for rule in preset.rules for c in rule.conditions}.isdisjoint({"f0"})
    scores = scores_on(small_corpus, preset)
    assert scores.macro_f1 > 0.8
    assert scores.changes_per_s <= 2 * scores.label_changes_per_s


def test_templates_of_a_small_corpus_recognise_it(small_corpus, capsys):
    assert fit_templates.main([str(small_corpus), "-o", str(small_corpus / "out")]) == 0
    preset = load_preset(small_corpus / "out" / "templates.toml")
    assert "Mean cepstra of 4 speakers" in capsys.readouterr().out
    assert scores_on(small_corpus, preset).macro_f1 > 0.8


@pytest.mark.parametrize("module", [fit_rules, fit_templates])
def test_a_folder_that_is_no_corpus_is_refused_in_one_sentence(module, tmp_path, capsys):
    assert module.main([str(tmp_path), "-o", str(tmp_path / "out")]) == 1
    assert "manifest.csv" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("corpus", "speaker", "voice"),
    [
        ("espeak_de", "de_f1", "f1"),
        ("espeak_en", "en_us_f1", "f1"),
        ("espeak_en", "en_us_klatt3", "klatt"),
        ("espeak_de", "de", "de"),
        ("human_fillets", "cs_big", "cs_big"),
    ],
)
def test_a_formant_voice_is_the_same_in_every_language(corpus: str, speaker: str, voice: str):
    assert voice_of(LabelledUtterance(Path("a.wav"), (), speaker, corpus)) == voice


def test_the_candidates_are_variables_that_a_preset_takes():
    check_user_variables(candidates())


def test_the_shipped_rules_can_be_read():
    preset = load_preset(FACTORY / "extended.toml")
    assert len(preset.rules) <= fit_rules.MOST_RULES
    assert max(len(rule.conditions) for rule in preset.rules) <= MOST_CONDITIONS
    assert {rule.phoneme for rule in preset.rules} == set(Phoneme) - {Phoneme.UNIDENTIFIED}
    assert "left out" in preset.notes
