"""Noise that is added to a corpus: its level, its colour, and that the same recording always gets the same."""

from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.calibration.scores.added_noise import AddedNoise, NoiseAdder, NoiseKind, speech_level_of
from phonemeengine.calibration.scores.corpus import LabelledUtterance, read_corpus
from phonemeengine.calibration.scores.evaluation import score
from phonemeengine.errors import CorpusError, SettingsError
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.settings import SAMPLE_RATE
from tests.corpora import write_corpus
from tests.sounds import silence, tone

THESIS = load_preset(FACTORY / "thesis.toml")
SECONDS = 8.0
TONES = {"ann": 500, "bob": 1000, "cyd": 2000}


@pytest.fixture
def utterances(tmp_path: Path) -> tuple[LabelledUtterance, ...]:
    """Three who whistle a note each: two seconds of silence, then sound of RMS 0.1."""
    found = []
    for name, frequency in TONES.items():
        sound = np.concatenate((silence(2), tone(frequency, SECONDS - 2, 0.1 * np.sqrt(2))))
        soundfile.write(tmp_path / f"{name}.wav", sound, SAMPLE_RATE, subtype="FLOAT")
        labels = (Label(0, 2, "sil", Phoneme.SILENCE), Label(2, SECONDS, "u", Phoneme.U))
        found.append(LabelledUtterance(tmp_path / f"{name}.wav", labels, name, "notes"))
    return tuple(found)


def noise_in(adder: NoiseAdder, utterance: LabelledUtterance, n: int = 5000) -> np.ndarray:
    clean, _ = soundfile.read(utterance.path, dtype="float32")
    return np.concatenate(list(adder.blocks(utterance, n))) - clean


def spectrum_of(sound: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.fft.rfftfreq(len(sound), 1 / SAMPLE_RATE), np.abs(np.fft.rfft(sound)) ** 2


def test_the_level_of_speech_is_that_of_what_is_labelled_as_speech(utterances: tuple[LabelledUtterance, ...]) -> None:
    assert speech_level_of(utterances[0]) == pytest.approx(0.1, rel=1e-3)


@pytest.mark.parametrize("kind", NoiseKind)
@pytest.mark.parametrize("snr", [pytest.param(20.0, marks=pytest.mark.long), -10.0])
def test_noise_is_as_far_below_the_speech_as_was_asked(
    utterances: tuple[LabelledUtterance, ...], kind: NoiseKind, snr: float
) -> None:
    added = noise_in(NoiseAdder(AddedNoise(kind, snr), utterances), utterances[0])
    assert len(added) == SECONDS * SAMPLE_RATE
    assert 20 * np.log10(0.1 / np.sqrt(np.mean(added**2))) == pytest.approx(snr, abs=0.5)


def test_music_goes_on_without_a_seam_and_is_another_one_with_another_seed(
    utterances: tuple[LabelledUtterance, ...],
) -> None:
    one, other = (NoiseAdder(AddedNoise(NoiseKind.MUSIC, 0.0, seed), utterances)._period("") for seed in (0, 1))
    assert abs(np.corrcoef(one, other)[0, 1]) < 0.3
    steps = np.abs(np.diff(np.concatenate((one[-200:], one[:200]))))
    assert steps[199] < 10 * np.median(np.abs(np.diff(one)))


@pytest.mark.parametrize(("kind", "per_octave"), [(NoiseKind.WHITE, 2.0), (NoiseKind.PINK, 1.0)])
def test_noise_has_its_colour(utterances: tuple[LabelledUtterance, ...], kind: NoiseKind, per_octave: float) -> None:
    frequencies, power = spectrum_of(noise_in(NoiseAdder(AddedNoise(kind, 0.0), utterances), utterances[0]))
    octaves = [power[(frequencies >= low) & (frequencies < 2 * low)].sum() for low in (250, 500, 1000, 2000, 4000)]
    ratios = np.array(octaves[1:]) / octaves[:-1]
    assert ratios == pytest.approx([per_octave] * 4, rel=0.15)


def test_babble_is_made_of_all_others_and_not_of_oneself(utterances: tuple[LabelledUtterance, ...]) -> None:
    frequencies, power = spectrum_of(
        noise_in(NoiseAdder(AddedNoise(NoiseKind.BABBLE, 0.0), utterances), utterances[0])
    )
    shares = [power[np.abs(frequencies - f) < 20].sum() / power.sum() for f in (500, 1000, 2000)]
    assert shares == pytest.approx([0, 0.5, 0.5], abs=0.1)


def test_one_speaker_alone_does_not_babble(utterances: tuple[LabelledUtterance, ...]) -> None:
    adder = NoiseAdder(AddedNoise(NoiseKind.BABBLE, 0.0), utterances[:1])
    with pytest.raises(CorpusError, match="none but ann; add one, or choose white or pink noise"):
        score(THESIS, utterances[:1], noise=adder)


@pytest.mark.parametrize("kind", [NoiseKind.PINK, NoiseKind.BABBLE])
def test_the_same_recording_gets_the_same_noise_however_it_is_cut(
    utterances: tuple[LabelledUtterance, ...], kind: NoiseKind
) -> None:
    first = noise_in(NoiseAdder(AddedNoise(kind, 10.0, seed=7), utterances), utterances[1])
    again = NoiseAdder(AddedNoise(kind, 10.0, seed=7), utterances)
    noise_in(again, utterances[0])
    assert np.array_equal(first, noise_in(again, utterances[1], 44_100))
    other = noise_in(NoiseAdder(AddedNoise(kind, 10.0, seed=8), utterances), utterances[1])
    assert not np.allclose(first, other, atol=1e-3)


def test_a_recording_without_speech_stays_as_it_is(tmp_path: Path) -> None:
    soundfile.write(tmp_path / "u.wav", tone(440, 0.5), SAMPLE_RATE, subtype="FLOAT")
    quiet = LabelledUtterance(tmp_path / "u.wav", (Label(0, 0.5, "sil", Phoneme.SILENCE),), "s", "c")
    assert not noise_in(NoiseAdder(AddedNoise(NoiseKind.WHITE, 0.0), [quiet]), quiet).any()


def test_much_noise_costs_much(tmp_path: Path) -> None:
    utterances = read_corpus(write_corpus(tmp_path, THESIS))
    found = [
        score(
            THESIS, utterances, noise=NoiseAdder(AddedNoise(NoiseKind.WHITE, snr), utterances)
        ).overall.scores.accuracy
        for snr in (70.0, 0.0)
    ]
    assert found[0] > 0.9
    assert found[1] < 0.6


@pytest.mark.parametrize(("snr", "seed"), [(-31.0, 0), (float("nan"), 0), (10.0, -1)])
def test_impossible_noise_is_refused(snr: float, seed: int) -> None:
    with pytest.raises(SettingsError, match="got"):
        AddedNoise(NoiseKind.PINK, snr, seed)
