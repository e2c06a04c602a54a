"""Whisper's encoder as people install it: the real model, of the two packages that hold it in halves."""

import os
import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import Phoneme, SoundReader, find_whisper, for_files, load_preset
from phonemeengine.analyser import analyse_blocks, concatenate_analyses
from phonemeengine.calibration.scores.corpus import read_corpus
from phonemeengine.calibration.scores.evaluation import score
from phonemeengine.encoder.model_folder import PACKAGES, open_whisper
from phonemeengine.settings import SAMPLE_RATE, ModelKind
from tests.conftest import CORPUS

INSTALLED = all(map(find_spec, PACKAGES))
pytestmark = pytest.mark.skipif(
    not (INSTALLED or "CI" in os.environ), reason=f"not installed: {', '.join(PACKAGES)} (133 MB)"
)


@pytest.fixture
def model(home: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of the model, in a home without one."""
    for package in PACKAGES:
        monkeypatch.delitem(sys.modules, package)
    return find_whisper().path


def test_the_model_of_the_two_packages_opens_and_tells_speech_from_silence(model):
    assert model.is_dir()
    with SoundReader(CORPUS / "espeak_de" / "de" / "de_00.flac") as reader:
        speech = reader.read_mono()
    spoken, silent = (open_whisper().encode(sound).astype(float) for sound in (speech, 0 * speech))
    assert spoken.shape == silent.shape == (-(-len(speech) * 50 // 44_100), 512)
    # medians, since a few states of each stretch are ten times as large as all others
    between, within = (np.median(np.linalg.norm(d, axis=1)) for d in (spoken - silent, np.diff(silent, axis=0)))
    assert between > within


def test_digital_silence_and_music_are_silence(model):
    times = np.arange(10 * SAMPLE_RATE) / SAMPLE_RATE
    chord = sum(np.sin(2 * np.pi * f * times) for f in (220, 277.2, 329.6)) * np.exp(-4 * (times % 0.5))
    preset = for_files(load_preset("learned"))
    for sound in (0 * times, 0.08 * chord):
        analysis = concatenate_analyses(list(analyse_blocks([sound.astype(np.float32)], preset)))
        assert np.mean(analysis.recognised == Phoneme.SILENCE) > 0.95


def test_a_preset_is_right_more_often_with_it_than_live(model):
    preset, corpus = load_preset("learned"), read_corpus(CORPUS)[::16]
    heard = for_files(preset)
    assert (heard.model_kind, heard.warnings) == (ModelKind.WHISPER, ())
    assert score(heard, corpus).overall.scores.macro_f1 > score(preset, corpus).overall.scores.macro_f1 + 0.02
