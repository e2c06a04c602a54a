"""Samples as programs have them: of any rate, as integers, of several channels, with holes; and short ways around."""

import sys

import numpy as np
import pytest

from phonemeengine import Analyser, Phoneme, analyse_blocks, load_head, load_preset, load_table, transcribe
from phonemeengine.audio.resampling import resample_whole
from phonemeengine.audio.stream import InputChoice
from phonemeengine.errors import AudioError, RecogniserError
from phonemeengine.live.listener import Listener
from phonemeengine.presets.model_choice import for_live_use, with_small_network
from phonemeengine.settings import SAMPLE_RATE
from tests.reading import DEMO, english_read

LEARNED = load_preset("learned")
SPEECH = english_read()[0][: 3 * SAMPLE_RATE]


def phonemes_of(samples: np.ndarray, n_cuts: int = 1, **options: object) -> np.ndarray:
    analyser = Analyser(LEARNED, **options)  # type: ignore[arg-type]
    parts = [analyser.push(part).phonemes for part in np.array_split(samples, n_cuts)]
    return np.concatenate([*parts, analyser.finish().phonemes])


@pytest.mark.parametrize("rate", [16_000, 96_000])
@pytest.mark.parametrize("live", [False, True])
def test_another_rate_is_heard_as_the_sound_is_at_44_1_khz(rate: int, live: bool) -> None:
    expected = phonemes_of(SPEECH, live=live)
    found = phonemes_of(resample_whole(SPEECH, SAMPLE_RATE, rate), rate=rate, live=live)
    assert abs(len(found) - len(expected)) <= 1
    n = min(len(found), len(expected))
    assert (found[:n] == expected[:n]).mean() > (0.9 if rate < 20_000 else 0.97)


def test_sound_of_another_rate_may_be_cut_anywhere() -> None:
    sound = resample_whole(SPEECH, SAMPLE_RATE, 48_000)
    np.testing.assert_array_equal(
        phonemes_of(sound, 97, rate=48_000, live=True), phonemes_of(sound, rate=48_000, live=True)
    )


def test_live_looks_ahead_as_far_as_a_microphone_does() -> None:
    small = with_small_network(LEARNED)
    live, file = Analyser(small, live=True), Analyser(LEARNED)
    assert live.recogniser.look_ahead == Analyser(for_live_use(small)).recogniser.look_ahead == 1
    assert file.recogniser.look_ahead == 5
    assert len(live.push(SPEECH[:SAMPLE_RATE])) == len(file.push(SPEECH[:SAMPLE_RATE])) + 4
    live.set_preset(with_small_network(load_preset("learned")))
    assert live.recogniser.look_ahead == 1


def test_integers_are_scaled() -> None:
    whole = np.rint(SPEECH * 32_767).astype(np.int16)
    np.testing.assert_array_equal(phonemes_of(whole), phonemes_of(whole / np.float32(32_768)))
    np.testing.assert_array_equal(phonemes_of(whole.astype(np.int32) << 16), phonemes_of(whole))


def test_several_channels_are_mixed() -> None:
    stereo = np.stack([SPEECH + 0.1, SPEECH - 0.1], axis=1)
    np.testing.assert_array_equal(phonemes_of(stereo), phonemes_of(stereo.mean(axis=1)))


def test_nan_and_infinity_are_silence_and_are_counted() -> None:
    holed, zeroed = SPEECH.copy(), SPEECH.copy()
    holed[1000:1003], zeroed[1000:1003] = (np.nan, np.inf, -np.inf), 0
    analyser = Analyser(LEARNED)
    np.testing.assert_array_equal(
        np.concatenate([analyser.push(holed).phonemes, analyser.finish().phonemes]), phonemes_of(zeroed)
    )
    assert analyser.n_replaced == 3


@pytest.mark.parametrize(
    ("samples", "words"),
    [
        (SPEECH * 32_768, "samples lie within ±1, found"),
        (np.zeros(10, np.int64), "got int64"),
        (np.zeros((2, 1000), np.float32), r"got \(2, 1000\)"),
        (np.zeros((1, 2, 3), np.float32), r"got \(1, 2, 3\)"),
    ],
)
def test_what_is_no_sound_is_refused_in_a_sentence(samples: np.ndarray, words: str) -> None:
    with pytest.raises(AudioError, match=words):
        Analyser(LEARNED).push(samples)


@pytest.mark.parametrize("rate", [0, 999, 768_001])
def test_a_rate_that_no_sound_has_is_refused(rate: int) -> None:
    with pytest.raises(AudioError, match=r"the sample rate must lie in 1000\.\.768000 Hz"):
        Analyser(LEARNED, rate=rate)


class Loud:
    """The shortest recogniser there can be."""

    def recognise(self, _windows, features):  # type: ignore[no-untyped-def]
        return np.where(features["volume"] > -30, Phoneme.A, Phoneme.SILENCE).astype(np.uint8)


class Wrong:
    def recognise(self, _windows, _features):  # type: ignore[no-untyped-def]
        return [1, 2, 3]


def test_an_object_with_recognise_alone_is_a_recogniser() -> None:
    for found in analyse_blocks([SPEECH], load_preset("thesis"), recogniser=Loud()):
        loud = found.features["volume"] > -30
        np.testing.assert_array_equal(found.recognised == Phoneme.A, loud)


def test_an_object_that_answers_wrongly_is_refused_in_a_sentence() -> None:
    with pytest.raises(RecogniserError, match="the recogniser 'Wrong'"):
        Analyser(load_preset("thesis"), recogniser=Wrong()).push(SPEECH)


def test_values_of_many_numbers_are_shown_in_a_line() -> None:
    head, preset = load_head(), load_preset("templates")
    analysis = Analyser(LEARNED).push(SPEECH)
    said = transcribe(DEMO, load_preset("thesis"))
    values = [LEARNED, LEARNED.model, preset.templates, analysis, analysis.frames, analysis.features]
    for value in [*values, load_table("arkit"), head, head.mesh, said]:
        assert repr(value).startswith(f"{type(value).__name__}(")
        assert len(repr(value)) < 700
    assert repr(LEARNED).startswith("Preset(name='Learned'")


def test_a_listener_without_sounddevice_says_so_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "sounddevice", None)
    with Listener(LEARNED, InputChoice()) as listener:
        assert "the package sounddevice is missing; install it with pip install sounddevice" in listener.status.words
