"""What an encoder and the network find together: the weighted mean of their log-probabilities."""

import numpy as np
import pytest

from phonemeengine.dsp.framing import Framer
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.learned import (
    ENCODER_SHARE,
    OVERLAP,
    STRETCH,
    WEAKENED,
    EncodedRecogniser,
    LearnedRecogniser,
)
from phonemeengine.recognition.scores import Recognition, Sensitivity
from phonemeengine.settings import HOP
from tests.models import centred_model

MODEL = centred_model()
N = 2 * STRETCH + 345
SOUND = np.random.default_rng(4).normal(0, 0.1, N * HOP).astype(np.float32)
PRIORS = np.random.default_rng(5).uniform(0.1, 1, 26).astype(np.float32)


def hear(samples: np.ndarray) -> np.ndarray:
    """Say something that depends on the loudness of each frame alone, as much as the encoder gives."""
    n = len(samples) // HOP
    loud = np.abs(samples[: n * HOP].reshape(n, HOP)).mean(axis=1, keepdims=True) * 50
    sums = np.sin(loud * np.arange(1, 27))
    shares = np.exp(sums)
    for part in (slice(11), slice(11, 26)):
        shares[:, part] /= shares[:, part].sum(axis=1, keepdims=True)
    return np.pad(shares, ((0, n % 2), (0, 0)), mode="edge").astype(np.float32)


def recogniser(sensitivities: dict[Phoneme, float] | None = None) -> EncodedRecogniser:
    return EncodedRecogniser(LearnedRecogniser(MODEL, 0.0), hear, PRIORS, Sensitivity(sensitivities or {}))


def answers(found: EncodedRecogniser, n_frames: int, sound: np.ndarray = SOUND) -> tuple[Recognition, list[int]]:
    """All that it says, and how much at once."""
    framer = Framer()
    windows = np.concatenate([framer.cut_frames(sound), framer.finish()])
    parts = [found.recognise(windows[k : k + n_frames], None) for k in range(0, len(windows), n_frames)]
    parts.append(found.finish())
    joined = (np.concatenate([getattr(p, name) for p in parts]) for name in ("phonemes", "scores", "visemes"))
    return Recognition(*joined), [len(p.phonemes) for p in parts]


@pytest.fixture(scope="module")
def whole() -> Recognition:
    return answers(recogniser(), 512)[0]


def network() -> tuple[np.ndarray, np.ndarray]:
    """What the network alone finds in the whole sound."""
    alone, framer = LearnedRecogniser(MODEL, 0.0), Framer()
    windows = np.concatenate([framer.cut_frames(SOUND), framer.finish(), np.zeros((alone.look_ahead, 2048), "f")])
    shares, visemes = alone.probabilities(windows)
    assert visemes is not None
    return shares, visemes


def test_both_count_by_their_logarithms_and_frequent_classes_count_less(whole):
    heard, alone = hear(SOUND)[:N], np.concatenate(network(), axis=1)
    logs = ENCODER_SHARE * np.log(heard) + (1 - ENCODER_SHARE) * np.log(np.maximum(alone, 1e-6))
    shares = np.exp(logs - WEAKENED * np.log(PRIORS))
    for found, part in ((whole.scores, slice(11)), (whole.visemes, slice(11, 26))):
        wanted = shares[:, part] / shares[:, part].sum(axis=1, keepdims=True)
        np.testing.assert_allclose(found, wanted, atol=1e-4)
    np.testing.assert_array_equal(whole.phonemes, whole.scores.argmax(axis=1))


@pytest.mark.parametrize("n_frames", [7, 100, N])
def test_it_does_not_matter_how_the_frames_come(whole, n_frames):
    found, lengths = answers(recogniser(), n_frames)
    np.testing.assert_allclose(found.scores, whole.scores, atol=1e-4)
    assert sum(lengths) == N
    assert lengths[-1] <= STRETCH + OVERLAP
    assert all(length % STRETCH == 0 for length in lengths[:-1])


@pytest.mark.parametrize("n", [0, 1, 2, 3])
def test_a_short_sound_has_an_answer_for_each_frame(n):
    found, _ = answers(recogniser(), 512, SOUND[: n * HOP])
    assert len(found.phonemes) == n


def test_sensitivities_act_on_what_both_found(whole):
    found, _ = answers(recogniser({Phoneme.A: 10.0}), 512)
    odds = whole.scores[:, Phoneme.A] * np.exp(10.0) / (1 - whole.scores[:, Phoneme.A])
    np.testing.assert_allclose(found.scores[:, Phoneme.A], odds / (1 + odds), atol=1e-3)
