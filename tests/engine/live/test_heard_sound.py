"""What a microphone heard since Clear, kept on disk."""

import tempfile
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import SoundReader
from phonemeengine.live import heard_sound
from phonemeengine.live.heard_sound import HeardSound
from phonemeengine.settings import SAMPLE_RATE
from tests.disks import refused
from tests.sounds import noise


def samples_of(path: Path | None) -> np.ndarray:
    assert path is not None
    with SoundReader(path) as reader:
        return np.concatenate(list(reader.blocks(4096)))


def test_what_comes_is_found_again_while_more_comes() -> None:
    sound = noise(0.5).astype(np.float32)
    with HeardSound() as heard:
        assert heard.snapshot() is None
        heard.add_samples(np.repeat(sound[:, np.newaxis], 2, axis=1), SAMPLE_RATE)
        first = heard.snapshot()
        np.testing.assert_allclose(samples_of(first), sound, atol=2e-7)
        heard.add_samples(sound[:, np.newaxis], SAMPLE_RATE)
        assert heard.snapshot() == first
        assert len(samples_of(first)) == 2 * len(sound)
    assert first is not None
    assert not first.exists()


def test_other_rates_are_brought_to_ours() -> None:
    with HeardSound() as heard:
        for _ in range(10):
            heard.add_samples(np.zeros((4800, 1), np.float32), 48_000)
        assert len(samples_of(heard.snapshot())) == pytest.approx(SAMPLE_RATE, abs=3000)


def test_clear_begins_anew() -> None:
    with HeardSound() as heard:
        heard.add_samples(np.ones((100, 1), np.float32), SAMPLE_RATE)
        before = heard.snapshot()
        heard.clear()
        assert heard.snapshot() is None
        assert before is not None
        assert not before.exists()
        heard.add_samples(np.zeros((50, 1), np.float32), SAMPLE_RATE)
        assert len(samples_of(heard.snapshot())) == 50


def test_a_full_disk_is_said_and_nobody_waits() -> None:
    with refused(Path(tempfile.gettempdir()), events={"tempfile.mkdtemp"}), HeardSound() as heard:
        heard.add_samples(np.zeros((100, 1), np.float32), SAMPLE_RATE)
        assert heard.snapshot() is None
        assert heard.failure is not None
        assert "free some space" in heard.failure
        heard.add_samples(np.zeros((100, 1), np.float32), SAMPLE_RATE)


def test_memory_stays_as_it_is_when_the_disk_is_stuck() -> None:
    heard = HeardSound()
    heard.close()  # nobody takes any more
    for _ in range(heard_sound.MOST_WAITING + 100):
        heard.add_samples(np.zeros((10, 1), np.float32), SAMPLE_RATE)
    assert heard._orders.qsize() == heard_sound.MOST_WAITING
