"""What a microphone recorded since Clear, kept on disk."""

import tempfile
from pathlib import Path

import numpy as np
import pytest

from phonemeengine import SoundReader
from phonemeengine.live.recorder import MOST_WAITING, RecordedSound
from phonemeengine.settings import SAMPLE_RATE
from tests.disks import refused
from tests.sounds import noise


def samples_of(path: Path | None) -> np.ndarray:
    assert path is not None
    with SoundReader(path) as reader:
        return np.concatenate(list(reader.blocks(4096)))


def test_what_comes_is_found_again_while_more_comes() -> None:
    sound = noise(0.5).astype(np.float32)
    with RecordedSound() as recorded:
        assert recorded.snapshot() is None
        recorded.add_samples(np.repeat(sound[:, np.newaxis], 2, axis=1), SAMPLE_RATE)
        first = recorded.snapshot()
        np.testing.assert_allclose(samples_of(first), sound, atol=2e-7)
        recorded.add_samples(sound[:, np.newaxis], SAMPLE_RATE)
        assert recorded.snapshot() == first
        assert len(samples_of(first)) == 2 * len(sound)
    assert first is not None
    assert not first.exists()


def test_other_rates_are_brought_to_ours() -> None:
    with RecordedSound() as recorded:
        for _ in range(10):
            recorded.add_samples(np.zeros((4800, 1), np.float32), 48_000)
        assert len(samples_of(recorded.snapshot())) == pytest.approx(SAMPLE_RATE, abs=3000)


def test_clear_begins_anew() -> None:
    with RecordedSound() as recorded:
        recorded.add_samples(np.ones((100, 1), np.float32), SAMPLE_RATE)
        before = recorded.snapshot()
        recorded.clear()
        assert recorded.snapshot() is None
        assert before is not None
        assert not before.exists()
        recorded.add_samples(np.zeros((50, 1), np.float32), SAMPLE_RATE)
        assert len(samples_of(recorded.snapshot())) == 50


def test_a_full_disk_is_said_and_nobody_waits() -> None:
    with refused(Path(tempfile.gettempdir()), events={"tempfile.mkdtemp"}), RecordedSound() as recorded:
        recorded.add_samples(np.zeros((100, 1), np.float32), SAMPLE_RATE)
        assert recorded.snapshot() is None
        assert recorded.failure is not None
        assert "free some space" in recorded.failure
        recorded.add_samples(np.zeros((100, 1), np.float32), SAMPLE_RATE)


def test_memory_stays_as_it_is_when_the_disk_is_stuck() -> None:
    recorded = RecordedSound()
    recorded.close()  # takes no more frames
    for _ in range(MOST_WAITING + 100):
        recorded.add_samples(np.zeros((10, 1), np.float32), SAMPLE_RATE)
    assert recorded._orders.qsize() == MOST_WAITING
