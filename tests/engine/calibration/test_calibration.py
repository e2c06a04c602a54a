"""Labelled recordings: what they say at a time, how answers are scored, and what was fitted to them."""

import itertools
from dataclasses import astuple, replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import Analyser, analyse_blocks
from phonemeengine.calibration.scores.corpus import FrameLabels, frame_labels_of, read_corpus, read_labels
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES, confusion_of, scores_of
from phonemeengine.errors import CorpusError
from phonemeengine.features.variables import Features
from phonemeengine.labels.visemes import NO_VISEME, Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import CONDITIONS, ThesisRules
from phonemeengine.recognition.segments import SUCCESSORS
from phonemeengine.settings import SAMPLE_RATE, Decimation
from tests.conftest import ROOT
from tests.sounds import noise, silence, vowel
from tools.fit import thesis as fit_thesis

DEMO = ROOT / "phonemeanalyser" / "demo"
LABELS = "start_s,end_s,phone,class,certainty\n"


def codes(*phonemes: Phoneme) -> np.ndarray:
    return np.array(phonemes, np.uint8)


def certain(*phonemes: Phoneme) -> FrameLabels:
    return FrameLabels(codes(*phonemes), np.ones(len(phonemes), bool), np.full(len(phonemes), NO_VISEME, np.uint8))


def write_corpus(folder: Path, n_speakers: int = 3) -> Path:
    """Write a small corpus: silence, a vowel a, hiss as s, and silence, by several speakers."""
    rows = ["corpus,speaker,wav,labels"]
    for k in range(n_speakers):
        loud = 0.3 + 0.2 * k
        parts = [silence(0.2), vowel((750, 1250), 0.3, 100 + 40 * k, loud), noise(0.3, loud / 4, k), silence(0.2)]
        soundfile.write(folder / f"u{k}.wav", np.concatenate(parts), SAMPLE_RATE, subtype="FLOAT")
        times = (("0", "0.2", "pau", "silence"), ("0.2", "0.5", "a", "a"), ("0.5", "0.8", "s", "sz"))
        lines = [",".join((*row, "core")) for row in (*times, ("0.8", "1.0", "pau", "silence"))]
        (folder / f"u{k}.csv").write_text(LABELS + "\n".join(lines) + "\n")
        rows.append(f"small,speaker{k},u{k}.wav,u{k}.csv")
    (folder / "manifest.csv").write_text("\n".join(rows) + "\n")
    return folder


def test_a_frame_is_what_is_said_in_its_middle(tmp_path):
    path = tmp_path / "x.csv"
    path.write_text(LABELS + "0,0.014,pau,silence,core\n0.014,0.0351,a,a,ambiguous\n")
    labels = frame_labels_of(read_labels(path))
    assert labels.phonemes.tolist() == [Phoneme.SILENCE, Phoneme.A, Phoneme.A, Phoneme.A]
    assert labels.certain.tolist() == [True, False, False, False]


def test_a_corpus_tells_who_said_what(tmp_path):
    utterances = read_corpus(write_corpus(tmp_path))
    assert [u.speaker for u in utterances] == ["speaker0", "speaker1", "speaker2"]
    assert utterances[0].path == tmp_path / "u0.wav"
    assert [label.phoneme for label in utterances[0].labels][1:3] == [Phoneme.A, Phoneme.SZ]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "lacks the column start_s"),
        (LABELS, "no row"),
        (LABELS + "0,1,x,q7,core\n", r"unknown .* 'q7' \(1 x\)"),
        (LABELS + "0,1,x,,core\n", "line 2: the class must be a phoneme"),
        (LABELS + "0,1,x,a,core\n1,no,x,a,core\n", "line 3: start_s and end_s must be seconds"),
        (LABELS + "1,0.5,x,a,core\n", r"line 2: .* found 1\.\.0\.5 s"),
        (LABELS + "0,inf,x,a,core\n", "line 2"),
    ],
)
def test_a_broken_label_file_is_refused_with_the_place(tmp_path, text, message):
    path = tmp_path / "broken.csv"
    path.write_text(text)
    with pytest.raises(CorpusError, match=rf"broken\.csv.*{message}"):
        read_labels(path)


def test_a_folder_without_a_manifest_is_no_corpus(tmp_path):
    with pytest.raises(CorpusError, match=r"manifest\.csv"):
        read_corpus(tmp_path)


def test_right_answers_score_one():
    labels = certain(*Phoneme)
    scores = scores_of([(labels, labels.phonemes)])
    assert astuple(scores)[:7] == (1, 1, 1, 1, 1, 1, 0)
    assert scores.changes_per_s == scores.label_changes_per_s == pytest.approx(10 / 0.11)


def test_visemes_are_right_where_they_are_undisputed():
    phonemes = (Phoneme.UNIDENTIFIED, Phoneme.UNIDENTIFIED, Phoneme.UNIDENTIFIED, Phoneme.M)
    seen = np.array([Viseme.FF, Viseme.NN, NO_VISEME, Viseme.PP], np.uint8)
    labels = replace(certain(*phonemes), visemes=seen)
    heard = np.array([Viseme.FF, Viseme.KK, Viseme.KK, Viseme.PP], np.uint8)
    assert scores_of([(labels, labels.phonemes, heard)]).fine_viseme_accuracy == pytest.approx(2 / 3)
    assert scores_of([(labels, labels.phonemes)]).fine_viseme_accuracy == pytest.approx(1 / 3)  # m alone tells


def test_figures_are_those_that_one_counts_by_hand():
    truth = (Phoneme.SILENCE, Phoneme.SILENCE, Phoneme.A, Phoneme.E, Phoneme.UNIDENTIFIED, Phoneme.M)
    guess = (Phoneme.SILENCE, Phoneme.A, Phoneme.A, Phoneme.I, Phoneme.A, Phoneme.SILENCE)
    scores = scores_of([(certain(*truth), codes(*guess))])
    assert scores.accuracy == pytest.approx(2 / 5)
    assert scores.macro_f1 == pytest.approx((1 / 2 + 2 / 3 + 0 + 0) / 4)  # silence, a, e, m
    assert scores.vowel_accuracy == pytest.approx(1 / 2)
    assert scores.viseme_accuracy == pytest.approx(3 / 6)  # e and i are one mouth
    assert scores.viseme_f1 == pytest.approx((1 / 2 + 1 / 2 + 1 + 0 + 0) / 5)
    assert (scores.silence_recall, scores.false_silence) == (1 / 2, 1 / 4)


def test_what_was_not_recognised_counts_as_silence():
    scores = scores_of([(certain(Phoneme.A, Phoneme.SILENCE), codes(Phoneme.A))])
    assert scores.accuracy == 1


def test_changes_are_not_counted_between_recordings():
    one, other = certain(Phoneme.A, Phoneme.A), certain(Phoneme.E, Phoneme.E)
    scores = scores_of([(one, one.phonemes), (other, other.phonemes)])
    assert scores.changes_per_s == 0


def test_a_fit_to_a_small_corpus_recognises_it_and_writes_presets(tmp_path, capsys):
    words = [str(write_corpus(tmp_path)), "-o", str(tmp_path / "out"), "--starts", "2", "--seed", "3", "--plain"]
    assert fit_thesis.main(words) == 0
    preset = load_preset(tmp_path / "out" / "thesis.toml")
    assert "seed 3" in preset.notes
    table = ", ".join(f"{p.label} {q.label}" for p, q in preset.successors.items())
    assert f"successors: {table}" in capsys.readouterr().out
    pairs = []
    for utterance in read_corpus(tmp_path):
        sound, _ = soundfile.read(utterance.path, dtype="float32")
        found = np.concatenate([a.phonemes for a in analyse_blocks([sound], preset)])
        pairs.append((frame_labels_of(utterance.labels), found))
    assert scores_of(pairs).macro_f1 > 0.8
    assert (tmp_path / "out" / "thesis.phonemedata").exists()
    assert "Thesis, anti-aliased" in (tmp_path / "out" / "thesis-anti-aliased.toml").read_text()


def test_a_fit_refuses_a_folder_that_is_no_corpus_in_one_sentence(tmp_path, capsys):
    assert fit_thesis.main([str(tmp_path), "-o", str(tmp_path / "out")]) == 1
    assert "manifest.csv" in capsys.readouterr().err


def test_the_factory_presets_are_what_they_say():
    thesis = load_preset(FACTORY / "thesis.toml")
    clean = load_preset(FACTORY / "thesis-anti-aliased.toml")
    assert (thesis.settings.decimation, thesis.settings.step) == (Decimation.PLAIN, 4)
    assert (clean.settings.decimation, clean.settings.step) == (Decimation.ANTI_ALIASED, 4)
    assert "left out" in thesis.notes
    assert "left out" in clean.notes


def test_the_phoneme_data_file_is_the_twin_of_the_thesis_preset():
    thesis = load_preset(FACTORY / "thesis.toml")
    twin = load_preset(FACTORY / "thesis.phonemedata")
    for name, value in vars(thesis.phoneme_data).items():
        assert np.float32(getattr(twin.phoneme_data, name)) == np.float32(value), name
    assert twin.successors == thesis.successors == SUCCESSORS
    assert (twin.settings.filters, twin.settings.statistics) == (thesis.settings.filters, thesis.settings.statistics)
    assert twin.settings.minimum_hold == thesis.settings.minimum_hold


def test_the_twins_hear_the_same_in_the_demo():
    sound, _ = soundfile.read(DEMO / "demo.flac", dtype="float32")
    presets = [load_preset(FACTORY / name) for name in ("thesis.toml", "thesis.phonemedata")]
    found = [
        np.concatenate(
            [a.phonemes for a in analyse_blocks([sound], replace(p, settings=replace(p.settings, hysteresis=0.0)))]
        )
        for p in presets  # a PhonemeData file knows no hysteresis
    ]
    assert np.mean(found[0] == found[1]) > 0.999


@pytest.mark.parametrize("name", ["thesis.toml", pytest.param("thesis-anti-aliased.toml", marks=pytest.mark.long)])
def test_each_rule_and_each_threshold_of_the_factory_presets_bears_on_speech_in_a_room(name, corpus):
    preset = load_preset(FACTORY / name)
    thresholds = preset.thresholds
    assert thresholds.u_o1 > thresholds.o_o1 > thresholds.i_o1
    features, truth = _measured_on(corpus, preset)
    answers = ThesisRules(thresholds).phonemes_of(features)
    hits = confusion_of(truth, answers).diagonal()
    assert min(hits[list(SCORED_PHONEMES)]) > 50
    for c in CONDITIONS:
        never_in_the_way = replace(thresholds, **{c.threshold: -1e9 if c.sign == ">" else 1e9})
        assert np.any(ThesisRules(never_in_the_way).phonemes_of(features) != answers), c.threshold


def _measured_on(corpus: Path, preset: Preset) -> tuple[Features, np.ndarray]:
    """Measure each recording as it is and in a room of -65 dB, as the fit hears them."""
    values, truth = [], []
    for seed, utterance in enumerate(read_corpus(corpus)):
        sound, _ = soundfile.read(utterance.path, dtype="float32")
        room = np.random.default_rng(seed).normal(0, 10 ** (-65 / 20), len(sound)).astype(np.float32)
        for heard in (sound, sound + room):
            found = np.concatenate([a.features.values for a in analyse_blocks([heard], preset)])
            labels = frame_labels_of(utterance.labels).phonemes[: len(found)]
            values.append(found[: len(labels)])
            truth.append(labels)
    return Features(Analyser(preset).push(sound).features.names, np.concatenate(values)), np.concatenate(truth)


def test_the_demo_holds_all_ten_sounds_to_its_end():
    labels = read_labels(DEMO / "demo.csv")
    info = soundfile.info(DEMO / "demo.flac")
    assert {label.phoneme for label in labels} >= set(SCORED_PHONEMES)
    assert (info.samplerate, info.channels, info.subtype) == (SAMPLE_RATE, 1, "PCM_16")
    assert labels[-1].end == pytest.approx(info.duration, abs=0.001)
    assert all(a.end == pytest.approx(b.start, abs=1e-4) for a, b in itertools.pairwise(labels))


def test_the_demo_has_no_digital_silence():
    sound, _ = soundfile.read(DEMO / "demo.flac", dtype="int16")
    quiet = sound[: int(0.25 * SAMPLE_RATE)]
    assert 2 < np.std(quiet.astype(float)) < 10


def test_speech_opens_the_mouth_nearly_fully():
    sound, _ = soundfile.read(DEMO / "demo.flac", dtype="float32")
    analyses = list(analyse_blocks([sound], load_preset(FACTORY / "thesis.toml")))
    intensities = np.concatenate([a.intensities for a in analyses])
    labels = frame_labels_of(read_labels(DEMO / "demo.csv")).phonemes
    assert np.quantile(intensities[: len(labels)][labels == Phoneme.A], 0.9) > 0.75
    assert intensities[:20].max() == 0
