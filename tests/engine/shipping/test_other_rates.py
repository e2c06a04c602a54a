"""Sound of other rates: the ear in C resamples it as well as the engine does."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine import Analyser, SoundReader, analyse_blocks, load_preset
from phonemeengine.analyser import concatenate_analyses
from phonemeengine.audio.resampling import resample_whole
from phonemeengine.presets.model_choice import with_small_network
from phonemeengine.recognition.scores import scores_in
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.shipping.targets import format_ear
from tests.compiled_ears import CEar, CModel, EarLibrary
from tests.engine.shipping.test_same_results import speech

WIDE = (22_050, 44_101, 48_000, 192_000)
"""Rates of sounds that hold all that the network hears, up to 8 kHz."""
NARROW = (8_000, 16_000)
"""Where the edge of what there is lies within that, and so the edges of both low passes."""


def heard_both_ways(library: EarLibrary, rate: int, folder: Path) -> tuple[np.ndarray, ...]:
    """Give phonemes and scores of speech at a rate, in C and in the engine, which reads it from a file."""
    preset, sound = load_preset("learned"), resample_whole(speech(), SAMPLE_RATE, rate)
    soundfile.write(folder / "speech.wav", sound, rate, subtype="FLOAT")
    with SoundReader(folder / "speech.wav") as reader:
        analysis = concatenate_analyses(list(analyse_blocks(reader.blocks(SAMPLE_RATE), with_small_network(preset))))
    frames = CEar(CModel(library, format_ear(preset, ())), rate).hear(sound, range(0, len(sound), rate // 7))
    n = min(len(frames), len(analysis))
    assert abs(len(frames) - len(analysis)) <= 1  # a sound of a fraction of a sample more or less
    scores = scores_in(analysis.features)
    assert scores is not None
    return frames["phoneme"][:n], analysis.phonemes[:n], frames["scores"][:n], scores[:n]


@pytest.mark.parametrize("rate", WIDE)
def test_speech_of_a_high_rate_is_the_same_in_c(library: EarLibrary, rate: int, tmp_path: Path) -> None:
    phonemes, expected, scores, expected_scores = heard_both_ways(library, rate, tmp_path)
    assert (phonemes == expected).mean() >= 0.999
    assert np.abs(scores - expected_scores).max() < 1e-3


@pytest.mark.parametrize("rate", NARROW)
def test_speech_of_a_low_rate_is_nearly_the_same_in_c(library: EarLibrary, rate: int, tmp_path: Path) -> None:
    phonemes, expected, scores, expected_scores = heard_both_ways(library, rate, tmp_path)
    assert (phonemes == expected).mean() >= 0.995
    assert np.abs(scores - expected_scores).max() < 0.03


@pytest.mark.parametrize("rate", [16_000, 48_000])
def test_a_live_analyser_with_the_small_network_says_what_c_says(library: EarLibrary, rate: int) -> None:
    preset, sound = load_preset("learned"), resample_whole(speech(), SAMPLE_RATE, rate)
    analyser = Analyser(with_small_network(preset), rate=rate, live=True)
    found = np.concatenate([analyser.push(sound).phonemes, analyser.finish().phonemes])
    expected = CEar(CModel(library, format_ear(preset, ())), rate).hear(sound)["phoneme"]
    n = min(len(found), len(expected))
    assert abs(len(found) - len(expected)) <= 1
    assert (found[:n] == expected[:n]).mean() >= 0.99


@pytest.mark.parametrize("rate", [8_000, 44_101])
def test_the_frames_are_the_same_however_sound_of_another_rate_is_cut(library: EarLibrary, rate: int) -> None:
    model, sound = CModel(library, format_ear(load_preset("thesis"), ())), resample_whole(speech(), SAMPLE_RATE, rate)
    whole = CEar(model, rate).hear(sound)
    cuts = np.sort(np.random.default_rng(rate).integers(0, len(sound), 60))
    assert (CEar(model, rate).hear(sound, cuts) == whole).all()
    assert (CEar(model, rate).hear(sound, range(1, min(len(sound), 300))) == whole).all()


@pytest.mark.parametrize("rate", [1_000, 48_000, 768_000])
def test_a_tone_keeps_its_level_at_any_rate(library: EarLibrary, rate: int) -> None:
    base = load_preset("thesis")
    settings = replace(base.settings, intensity_low=-60.0, intensity_high=0.0, statistics=False)
    model = CModel(library, format_ear(replace(base, settings=settings), ()))
    time = np.arange(rate) / rate
    frames = CEar(model, rate).hear((0.1 * np.sin(2 * np.pi * 300 * time)).astype(np.float32))
    assert len(frames) == 100
    assert np.allclose(frames["intensity"][10:90], 1 - 20 / 60, atol=1e-3)


def test_the_latency_is_that_of_the_window_the_look_ahead_and_the_low_pass(library: EarLibrary) -> None:
    model = CModel(library, format_ear(load_preset("learned"), ()))
    at_once = 1024 / 44_100 + 0.005 + 0.01
    assert CEar(model).latency == pytest.approx(at_once, abs=1e-4)
    assert CEar(model, 48_000).latency == pytest.approx(at_once + 70 / 48_000, abs=1e-4)
