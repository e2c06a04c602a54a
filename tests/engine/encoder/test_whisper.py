"""The speech encoder: a model that the library really runs, small and of random weights."""

import shutil
import sys

import numpy as np
import pytest

from phonemeengine.encoder.head import load_head, save_head
from phonemeengine.encoder.model_folder import open_whisper
from phonemeengine.encoder.whisper import STRETCH, WhisperEncoder
from phonemeengine.errors import ModelError
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.whisper_model import encoder_head

NOISE = np.random.default_rng(2).normal(0, 0.1, 31 * SAMPLE_RATE).astype(np.float32)


@pytest.fixture(scope="module")
def encoder(whisper_folder) -> WhisperEncoder:
    return WhisperEncoder(whisper_folder, n_threads=1)


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


def test_a_folder_that_lacks_a_file_is_refused(tmp_path):
    (tmp_path / "config.json").touch()
    with pytest.raises(ModelError, match=r"there is no Whisper model, model\.bin is missing; choose its folder"):
        WhisperEncoder(tmp_path)


def test_a_damaged_model_is_refused(tmp_path, whisper_folder):
    shutil.copytree(whisper_folder, tmp_path / "copy")
    content = (tmp_path / "copy" / "model.bin").read_bytes()
    (tmp_path / "copy" / "model.bin").write_bytes(content[: len(content) // 2])
    with pytest.raises(
        ModelError, match=r"the Whisper model cannot be opened \(.*invalid payload size\); get it anew"
    ):
        WhisperEncoder(tmp_path / "copy")


def test_too_little_memory_is_said(whisper_folder):
    with pytest.raises(ModelError, match="needs 400 MB of memory and 100 MB are free; close other programs"):
        WhisperEncoder(whisper_folder, free_memory=1e8)


def test_without_its_library_that_is_said(whisper_folder, monkeypatch):
    monkeypatch.setitem(sys.modules, "ctranslate2", None)
    with pytest.raises(ModelError, match=r"needs ctranslate2, which is not installed; install phonemeanalyser\[whi"):
        WhisperEncoder(whisper_folder)


def test_a_head_gives_probabilities_each_10_ms():
    shares = encoder_head().probabilities(np.random.default_rng(3).normal(0, 1, (20, 512)).astype(np.float16))
    assert shares.shape == (40, 26)
    np.testing.assert_allclose(shares[:, :11].sum(axis=1), 1, atol=1e-5)
    np.testing.assert_allclose(shares[:, 11:].sum(axis=1), 1, atol=1e-5)


def test_a_head_is_read_as_it_was_saved_and_another_is_not_the_same(tmp_path):
    save_head(encoder_head(), tmp_path / "head.npz")
    assert load_head(tmp_path / "head.npz") == encoder_head()
    assert encoder_head(seed=2) != encoder_head()


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
