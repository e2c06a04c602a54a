"""Vocal tracts: the one with which the network is sure counts, and a speaker with another one is heard."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.analyser import analyse_blocks
from phonemeengine.dsp.mel import N_BANDS, log_mels, mel_powers, warped_mel_bank
from phonemeengine.errors import ModelError
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.learned import VtlnMixer, mixed
from phonemeengine.recognition.model import load_model, save_model
from phonemeengine.settings import WINDOW, AnalysisSettings
from tests.models import tone_model
from tests.sounds import noise, tone

N = len(Phoneme)


def shares_of(*names: tuple[Phoneme, float], n: int = 1) -> np.ndarray:
    """What each tract says in n frames: a phoneme, and how sure it is; the rest is shared by the others."""
    rows = [np.full(N, (1 - sure) / (N - 1)) for _, sure in names]
    for row, (phoneme, sure) in zip(rows, names, strict=True):
        row[phoneme] = sure
    return np.tile(np.array(rows, np.float32), (n, 1, 1))


def combined(judge: VtlnMixer, shares: np.ndarray) -> np.ndarray:
    return mixed(shares, judge.weigh(shares))


def test_what_a_sure_tract_says_counts_more_and_more():
    judge = VtlnMixer(2)
    found = combined(judge, shares_of((Phoneme.A, 0.9), (Phoneme.E, 0.6), n=300))
    assert found[0, Phoneme.A] < 0.6
    assert found[-1, Phoneme.A] > 0.85
    np.testing.assert_allclose(found.sum(axis=1), 1, rtol=1e-5)


def test_silence_tells_nothing_about_a_speaker():
    judge = VtlnMixer(2)
    combined(judge, shares_of((Phoneme.SILENCE, 0.99), (Phoneme.SILENCE, 0.6), n=500))
    found = combined(judge, shares_of((Phoneme.A, 0.9), (Phoneme.E, 0.9)))
    assert found[0, Phoneme.A] == pytest.approx(found[0, Phoneme.E], rel=1e-4)


def test_another_speaker_is_noticed_within_ten_seconds():
    judge = VtlnMixer(2)
    combined(judge, shares_of((Phoneme.A, 0.9), (Phoneme.E, 0.6), n=6000))
    found = combined(judge, shares_of((Phoneme.A, 0.6), (Phoneme.E, 0.9), n=1000))
    assert found[0].argmax() == Phoneme.A
    assert found[-1].argmax() == Phoneme.E


def test_what_is_mixed_does_not_depend_on_how_frames_come():
    shares = np.random.default_rng(1).dirichlet(np.ones(N), (200, 3)).astype(np.float32)
    whole, parts = VtlnMixer(3), VtlnMixer(3)
    pieces = [combined(parts, piece) for piece in np.split(shares, [1, 2, 50, 51, 120])]
    np.testing.assert_array_equal(np.concatenate(pieces), combined(whole, shares))


def test_one_tract_is_believed():
    shares = shares_of((Phoneme.A, 0.9), n=3)
    np.testing.assert_array_equal(combined(VtlnMixer(1), shares), shares[:, 0])


def test_a_voice_that_lies_higher_is_recognised_with_a_shorter_tract():
    model = tone_model({700.0: Phoneme.A})
    settings = AnalysisSettings(statistics=False)
    sound = tone(700 * 1.2, 1.0, 0.01)  # so faint that the band of 700 Hz hears nothing of it
    for warps, expected in (((1.0,), Phoneme.SILENCE), ((0.8, 1.0, 1.2), Phoneme.A)):
        preset = Preset(recogniser="learned", model=replace(model, warps=warps), settings=settings)
        codes = np.concatenate([analysis.phonemes for analysis in analyse_blocks([sound], preset)])
        assert set(codes[10:-10]) == {expected}


def test_the_bands_of_several_warps_lie_side_by_side():
    windows = noise(3 * WINDOW / 44_100, 0.1, seed=3).reshape(3, WINDOW)
    heard = log_mels(windows, (0.8, 1.0)).reshape(3, 2, N_BANDS)
    np.testing.assert_allclose(heard[:, 1], log_mels(windows), atol=1e-5)
    alone = np.log10(mel_powers(windows, warped_mel_bank(0.8)) + 1e-11)
    np.testing.assert_allclose(heard[:, 0], alone, atol=1e-5)


def test_warps_survive_the_file(tmp_path: Path):
    model = replace(tone_model({700.0: Phoneme.A}), warps=(0.8, 1.0, 1.2))
    save_model(model, tmp_path / "m.npz")
    assert load_model(tmp_path / "m.npz").warps == model.warps


@pytest.mark.parametrize("warps", [(), (1.0,) * 9, (0.1,), (float("nan"),)])
def test_warps_that_nobody_has_are_refused(tmp_path: Path, warps):
    save_model(replace(tone_model({700.0: Phoneme.A}), warps=warps), tmp_path / "m.npz")
    with pytest.raises(ModelError, match=r"m\.npz: a model has 1\.\.8 warps of 0\.5\.\.2; get it anew"):
        load_model(tmp_path / "m.npz")
