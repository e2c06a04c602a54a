"""One analysis buffer in, a phoneme and an intensity out at once: the call of the thesis."""

import numpy as np
import pytest

from phonemeengine import Phoneme, SettingsError, SoundReader, load_preset, recognise_window
from phonemeengine.analyser import analyse_blocks
from phonemeengine.dsp.framing import LEAD
from phonemeengine.presets.files import FACTORY_PRESETS
from phonemeengine.settings import HOP, WINDOW
from tests.conftest import ROOT
from tests.sounds import silence, vowel

DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"


def agreement_with_a_stream(name: str) -> float:
    """The share of the demo's frames in which a window says the same as the stream that it was cut from."""
    preset = load_preset(name)
    with SoundReader(DEMO) as reader:
        sound = np.concatenate(list(reader.blocks(reader.n_samples)))
    stream = np.concatenate([analysis.phonemes for analysis in analyse_blocks([sound], preset)])
    padded = np.pad(sound, (LEAD, 2 * WINDOW))
    frames = range(0, len(stream), 10)
    alone = [recognise_window(padded[k * HOP :][:WINDOW], preset).phoneme for k in frames]
    return float(np.mean([int(phoneme) == stream[k] for phoneme, k in zip(alone, frames, strict=True)]))


@pytest.mark.parametrize("path", FACTORY_PRESETS, ids=lambda path: path.stem)
def test_silence_is_silence_and_a_loud_vowel_is_none(path: object) -> None:
    preset = load_preset(path)
    assert recognise_window(silence(WINDOW / 44_100), preset)[:2] == (Phoneme.SILENCE, 0.0)
    phoneme, intensity, confidence = recognise_window(0.5 * vowel((700, 1200, 2500), 0.1)[:WINDOW], preset)
    assert phoneme is not Phoneme.SILENCE
    assert 0.3 < intensity <= 1
    assert 0 < confidence <= 1


@pytest.mark.parametrize(
    ("name", "least"), [("thesis", 0.7), ("extended", 0.75), ("templates", 0.85), ("learned", 0.5)]
)
def test_a_window_says_mostly_what_the_stream_says(name: str, least: float) -> None:
    assert agreement_with_a_stream(name) > least


def test_a_window_is_forgotten_at_once() -> None:
    preset = load_preset("learned")
    loud = vowel((700, 1200, 2500), 0.1)[:WINDOW]
    first = recognise_window(loud, preset)
    recognise_window(silence(WINDOW / 44_100), preset)
    assert recognise_window(loud, preset) == first


@pytest.mark.parametrize("shape", [(0,), (WINDOW - 1,), (WINDOW + 1,), (WINDOW, 1), (1, WINDOW)])
def test_a_buffer_of_another_shape_is_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(SettingsError, match=r"shape \(2048,\), got \("):
        recognise_window(np.zeros(shape, np.float32), load_preset("thesis"))
