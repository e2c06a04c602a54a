"""Templates: mean cepstra, the nearest of which names the phoneme; silence is told by its level."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import Analyser
from phonemeengine.calibration.fits.templates import log_mels_by_phoneme, templates_from, templates_of
from phonemeengine.calibration.scores.corpus import Label, LabelledUtterance
from phonemeengine.dsp.mel import N_BANDS, N_CEPSTRA, cepstra_of
from phonemeengine.errors import CorpusError, EngineError, PresetError, SettingsError
from phonemeengine.labels.utterance import CORE
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.document import preset_from_toml, preset_to_toml
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import SCORES
from phonemeengine.recognition.spec import RecogniserConfig, recogniser_of
from phonemeengine.recognition.templates import Templates
from phonemeengine.settings import SAMPLE_RATE
from tests.sounds import Sound, silence, vowel
from tools.fit.templates import preset_of

FORMANTS = {Phoneme.A: (750.0, 1250.0, 2500.0), Phoneme.I: (280.0, 2300.0, 3000.0), Phoneme.U: (300.0, 700.0, 2300.0)}
ROW = (1.0,) * N_CEPSTRA


def spoken(f0: float = 120.0, amplitude: float = 0.5) -> Sound:
    """Silence, then each vowel for 0.6 s, with silence after each."""
    vowels = [np.concatenate([vowel(f, 0.6, f0, amplitude), silence(0.6)]) for f in FORMANTS.values()]
    return np.concatenate([silence(0.6), *vowels])


LABELS = tuple(
    Label(0.6 * k, 0.6 * (k + 1), phoneme.label, phoneme, CORE)
    for k, phoneme in enumerate((Phoneme.SILENCE, Phoneme.A, Phoneme.SILENCE, Phoneme.I, Phoneme.SILENCE, Phoneme.U))
)


@pytest.fixture
def utterance(tmp_path: Path) -> LabelledUtterance:
    path = tmp_path / "vowels.wav"
    soundfile.write(path, spoken(), SAMPLE_RATE)
    return LabelledUtterance(path, LABELS, "anna", "takes")


@pytest.mark.parametrize(("f0", "amplitude"), [(120.0, 0.5), (135.0, 0.1)])
def test_the_vowels_of_the_takes_are_recognised_at_other_pitch_and_level(
    utterance: LabelledUtterance, f0: float, amplitude: float
):
    analysis = Analyser(preset_of(templates_of([utterance]))).push(spoken(f0, amplitude))
    middles = [round(100 * (label.start + label.end) / 2) for label in LABELS]
    assert [Phoneme(int(p)) for p in analysis.phonemes[middles]] == [label.phoneme for label in LABELS]


def test_the_scores_of_a_frame_add_up_to_one_and_the_nearest_is_explained(utterance: LabelledUtterance):
    analyser = Analyser(preset_of(templates_of([utterance])))
    analysis = analyser.push(spoken())
    scores = np.array([analysis.features[name] for name in SCORES])
    np.testing.assert_allclose(scores.sum(axis=0), 1, atol=1e-5)
    trace = analyser.recogniser.explain(analysis.features, 90)
    assert trace.phoneme is Phoneme.A
    assert trace.comparisons[0].variable == "p_a"
    assert trace.comparisons[0].margin > 0


def test_a_louder_sound_has_the_same_cepstra():
    log_mels = np.random.default_rng(1).normal(-5, 1, (3, N_BANDS)).astype(np.float32)
    np.testing.assert_allclose(cepstra_of(log_mels + np.float32(2)), cepstra_of(log_mels), atol=1e-4)


def test_a_ripple_over_the_bands_is_one_cepstrum():
    bands = (np.arange(N_BANDS) + 0.5) / N_BANDS
    cepstra = cepstra_of(np.cos(3 * np.pi * bands)[np.newaxis].astype(np.float32))[0]
    assert cepstra[2] == pytest.approx(np.sqrt(N_BANDS / 2), rel=1e-4)
    assert np.abs(np.delete(cepstra, 2)).max() < 1e-4


def test_speakers_count_alike_however_much_they_say(utterance: LabelledUtterance):
    voice = log_mels_by_phoneme([utterance])["takes/anna"]
    far = replace(voice, cepstra={p: frames[:5] + 4 for p, frames in voice.cepstra.items()})
    means = templates_from({"a": voice, "b": far}).means
    for phoneme, frames in voice.cepstra.items():
        expected = (frames.mean(axis=0) + frames[:5].mean(axis=0) + 4) / 2
        np.testing.assert_allclose(means[phoneme], expected, atol=1e-3)


def test_phonemes_that_were_not_taken_keep_their_templates(utterance: LabelledUtterance):
    base = Templates(dict.fromkeys((Phoneme.A, Phoneme.O), ROW), ROW)
    templates = templates_of([utterance], base)
    assert templates.means[Phoneme.O] == ROW
    assert templates.means[Phoneme.A] != ROW


def test_silence_alone_makes_no_template(tmp_path: Path):
    soundfile.write(tmp_path / "quiet.wav", silence(0.6), SAMPLE_RATE)
    with pytest.raises(CorpusError, match="no phoneme has enough speech"):
        templates_of([LabelledUtterance(tmp_path / "quiet.wav", LABELS[:1], "anna", "takes")])


def test_a_preset_file_keeps_the_templates(utterance: LabelledUtterance):
    preset = preset_of(templates_of([utterance]))
    assert preset_from_toml(preset_to_toml(preset), Path()) == preset


@pytest.mark.parametrize(
    ("found", "put", "words"),
    [
        ("silence_below = -50.0", "silence_below = nan", "silence_below must be a number"),
        ("silence_below = -50.0", "silence_below = 3.0", "silence_below must lie in"),
        ("silence_below = -50.0", 'silence_below = "low"', ".templates. silence_below must be a number"),
        ("silence_below = -50.0", "", "lacks silence_below"),
        ("a = [\n    1.0,", "a = [\n", "a must have 12 numbers in templates, got 11"),
        ("a = [\n    1.0,", "a = [\n    inf,", ".templates. a must be a list of numbers within"),
        ("a = [\n    1.0,", "a = [\n    true,", ".templates. a must be a list of numbers"),
        ("a = [\n    1.0,", f"a = [\n    1{400 * '0'},", ".templates. a must be a list of numbers within"),
        ("a = [\n    1.0,", "silence = [\n    1.0,", "cannot have an entry 'silence'"),
        ("spread = [\n    1.0,", "spread = [\n    0.0,", "the spread must be above 0"),
    ],
)
def test_a_damaged_template_is_refused_in_one_sentence(found: str, put: str, words: str):
    good = preset_to_toml(Preset(recogniser="templates", templates=Templates({Phoneme.A: ROW}, ROW)))
    assert found in good
    with pytest.raises(PresetError, match=words):
        preset_from_toml(good.replace(found, put, 1), Path())


def test_no_template_at_all_is_refused():
    with pytest.raises(SettingsError, match="at least one template"):
        Templates({}, ROW)


def test_templates_are_needed_to_recognise_by_them():
    with pytest.raises(EngineError, match=r"begin with the preset templates\.toml"):
        recogniser_of("templates", RecogniserConfig())
