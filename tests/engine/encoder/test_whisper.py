"""The speech encoder: the base model's layers with random weights, which the library really runs."""

import sys
from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.audio.resampling import resample_whole
from phonemeengine.encoder.head import load_head, save_head
from phonemeengine.encoder.model_folder import open_whisper
from phonemeengine.encoder.weights import OUTPUT, read_weights
from phonemeengine.encoder.whisper import (
    CUT,
    ENCODER_RATE,
    LAYER,
    MODEL_FILE,
    STRETCH,
    WhisperEncoder,
    log_mel_spectrogram,
    surrounded,
)
from phonemeengine.errors import ModelError
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.storage.paths import data_folder
from tests.fakes.encoder_weights import reference_states
from tests.fakes.whisper_model import encoder_head

NOISE = np.random.default_rng(2).normal(0, 0.1, 31 * SAMPLE_RATE).astype(np.float32)


@pytest.fixture(scope="module")
def model_file(whisper_folder):
    return whisper_folder / MODEL_FILE


@pytest.fixture(scope="module")
def encoder(model_file) -> WhisperEncoder:
    return WhisperEncoder(model_file, n_threads=1)


@pytest.mark.parametrize("layer", [LAYER, OUTPUT])
def test_states_are_those_that_numpy_finds_after_the_layer(model_file, layer):
    sound = NOISE[:SAMPLE_RATE]
    mels = log_mel_spectrogram(surrounded(resample_whole(sound, SAMPLE_RATE, ENCODER_RATE)))
    weights = read_weights(model_file.read_bytes(), layer)
    expected = reference_states(weights, mels, None)[10:60]
    found = WhisperEncoder(model_file, layer=layer, n_threads=1).encode(sound)
    # weights and states have 8 bits on the way
    assert np.corrcoef(found.ravel(), expected.ravel())[0, 1] > 0.997


@pytest.mark.parametrize("seconds", [0.0, 0.001, 0.02, 0.5, 2.345])
def test_there_is_a_state_for_each_20_ms(encoder, seconds):
    states = encoder.encode(NOISE[: round(seconds * SAMPLE_RATE)])
    assert states.shape == (-(-round(seconds * 16_000) // 320), 512)
    assert np.isfinite(states).all()


def test_the_same_sound_has_the_same_states(encoder):
    np.testing.assert_array_equal(encoder.encode(NOISE[:20_000]), encoder.encode(NOISE[:20_000]))


def test_a_long_sound_is_heard_in_stretches_without_a_gap(encoder):
    assert len(encoder.encode(NOISE)) == 31 * 50
    assert len(NOISE) > STRETCH * SAMPLE_RATE / 100


def test_it_is_opened_once(whisper):
    assert open_whisper() is open_whisper()


@pytest.mark.usefixtures("home")
def test_it_is_cut_once_and_again_where_the_cut_is_damaged_or_of_another_model(model_file, tmp_path):
    cut = data_folder() / CUT.format(layer=0)
    WhisperEncoder(model_file, layer=0)
    first = cut.stat()
    WhisperEncoder(model_file, layer=0)
    assert (cut.stat().st_ino, cut.stat().st_mtime_ns) == (first.st_ino, first.st_mtime_ns)
    whole = cut.read_bytes()
    cut.write_bytes(whole[: len(whole) // 2])
    WhisperEncoder(model_file, layer=0)
    assert cut.read_bytes() == whole
    content = model_file.read_bytes()
    for name, part in (("a", content[:1000]), ("b", content[1000:])):
        (tmp_path / name).write_bytes(part)
    WhisperEncoder(tmp_path / "a", tmp_path / "b", layer=0)
    assert len(cut.read_bytes()) == pytest.approx(len(whole), abs=1000)
    assert cut.read_bytes() != whole  # it tells of what it was cut
    assert [path.name for path in cut.parent.iterdir()] == [cut.name]


@pytest.mark.usefixtures("home")
def test_without_a_place_for_the_cut_it_works_too(model_file):
    data_folder().parent.mkdir(parents=True)
    data_folder().write_text("a file, where a folder should be")
    assert len(WhisperEncoder(model_file, layer=0).encode(NOISE[:SAMPLE_RATE])) == 50


def test_a_folder_that_lacks_the_model_is_refused(tmp_path):
    with pytest.raises(
        ModelError, match=r"there is no Whisper model, model\.bin is missing; choose its folder, or f"
    ):
        WhisperEncoder(tmp_path / MODEL_FILE)


def test_a_damaged_model_is_refused(tmp_path, model_file):
    content = model_file.read_bytes()
    (tmp_path / MODEL_FILE).write_bytes(content[: len(content) // 2])
    with pytest.raises(ModelError, match=r"the Whisper model cannot be opened \(it ends too early\); get it anew"):
        WhisperEncoder(tmp_path / MODEL_FILE)


def test_too_little_memory_is_said(model_file):
    with pytest.raises(ModelError, match="needs 250 MB of memory and 100 MB are free; close other programs"):
        WhisperEncoder(model_file, free_memory=1e8)


def test_without_its_library_that_is_said(model_file, monkeypatch):
    monkeypatch.setitem(sys.modules, "onnxruntime", None)
    with pytest.raises(ModelError, match=r"needs onnxruntime, which is not installed; install phonemeanalyser\[enc"):
        WhisperEncoder(model_file)


def test_a_head_gives_probabilities_each_10_ms():
    shares = encoder_head().probabilities(np.random.default_rng(3).normal(0, 1, (20, 512)).astype(np.float16))
    assert shares.shape == (40, 26)
    np.testing.assert_allclose(shares[:, :11].sum(axis=1), 1, atol=1e-5)
    np.testing.assert_allclose(shares[:, 11:].sum(axis=1), 1, atol=1e-5)


def test_a_head_is_read_as_it_was_saved_and_another_is_not_the_same(tmp_path):
    save_head(encoder_head(), tmp_path / "head.npz")
    assert load_head(tmp_path / "head.npz") == encoder_head()
    assert encoder_head(seed=2) != encoder_head()
    assert replace(encoder_head(), layer=OUTPUT) != encoder_head()


def test_a_head_that_tells_no_layer_is_of_the_encoders_output(tmp_path):
    save_head(encoder_head(), tmp_path / "head.npz")
    arrays = dict(np.load(tmp_path / "head.npz"))
    assert arrays.pop("layer") == LAYER
    np.savez(tmp_path / "head.npz", **arrays | {"encoder_format": 1})
    assert load_head(tmp_path / "head.npz") == replace(encoder_head(), layer=OUTPUT)
    np.savez(tmp_path / "head.npz", **arrays | {"layer": 7})
    with pytest.raises(ModelError, match="the head of the encoder is damaged"):
        load_head(tmp_path / "head.npz")


@pytest.mark.parametrize("name", ["mean", "weights", "hidden_weights", "priors"])
def test_a_head_that_does_not_fit_together_is_damaged(tmp_path, name):
    save_head(encoder_head(), tmp_path / "head.npz")
    arrays = dict(np.load(tmp_path / "head.npz"))
    spoilt = arrays[name].copy()
    spoilt[...] = -1 if name == "priors" else np.nan
    for wrong in (spoilt, arrays[name][1:]):
        np.savez(tmp_path / "head.npz", **arrays | {name: wrong})
        with pytest.raises(ModelError, match="the head of the encoder is damaged"):
            load_head(tmp_path / "head.npz")
