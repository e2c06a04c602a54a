"""Sound to record whose every sample is known, and what a file holds of it."""

import hashlib
from pathlib import Path
from typing import Any

import numpy as np
import soundfile

from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.recording import Recording
from phonemeengine.live.recorder import Recorder
from phonemeengine.settings import HOP


def samples_of_16_bits(first: int, n: int, n_channels: int = 1) -> np.ndarray:
    """Samples k / 32768 of an endless noise that is known everywhere, shape (n, n_channels)."""
    places = np.arange(first * n_channels, (first + n) * n_channels, dtype=np.uint64)
    whole = (places * np.uint64(6364136223846793005) >> np.uint64(40)) & np.uint64(0xFFFF)
    return ((whole.astype(np.float64) - 32768) / 32768).astype(np.float32).reshape(n, n_channels)


def hops_of_16_bits(first: int, n: int) -> np.ndarray:
    """The same for some hops, in one channel."""
    return samples_of_16_bits(first * HOP, n * HOP)


def samples_in(path: Path) -> np.ndarray:
    """All samples of a file, float32 of shape (n, n_channels), read by soundfile."""
    samples, _ = soundfile.read(path, dtype="float32", always_2d=True)
    return samples


def begun(path: Path, rate: int = 44_100, n_channels: int = 1, **folders: Path) -> Recording:
    """A recording with its journal and its rescue folder beside it."""
    chosen: dict[str, Any] = {"journal": path.parent / "journal", "rescue": path.parent / "rescue"} | folders
    return Recording(path, rate, n_channels, **chosen)


def recorder_to(target: Any, folder: Path, **options: Any) -> Recorder:
    """A recorder with its journal and its rescue folder in a folder."""
    recorder = Recorder(target, **options)
    recorder.journal, recorder.rescue = folder / "journal", folder / "rescue"
    return recorder


def digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def check_sentence(recording: Recording, name: str) -> str:
    sentence = recording.failure
    assert sentence is not None
    assert sentence.startswith(f"{name}: ")
    assert sentence.isprintable()
    assert ". " not in sentence
    assert not sentence.endswith(".")
    return sentence


def check_kept(path: Path, n_samples: int, n_channels: int = 1) -> None:
    """The file holds the first samples of the known sound, and its header says how many they are."""
    found = samples_in(path)
    assert len(found) == n_samples
    np.testing.assert_array_equal(found, samples_of_16_bits(0, n_samples, n_channels))
    with SoundReader(path) as reader:
        assert reader.duration == n_samples / soundfile.info(path).samplerate
        assert sum(len(block) for block in reader.blocks(10_000)) == reader.n_samples
