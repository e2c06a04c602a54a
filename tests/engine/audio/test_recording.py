"""What is recorded is on the disk, to the bit."""

import os
import threading
import tracemalloc
import wave
from pathlib import Path

import numpy as np
import pytest
import soundfile
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.wav import HEADER, WavEncoder, to_integers
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.recorders import begun, digest, samples_in, samples_of_16_bits
from tests.waiting import wait_for

FORMS = [
    (suffix, n, rate) for suffix in (".wav", ".flac") for n in (1, 2) for rate in (44_100, 48_000, 16_000, 8_000)
]


@pytest.mark.parametrize(("suffix", "n_channels", "rate"), FORMS)
def test_a_recording_of_16_bits_is_exact(suffix: str, n_channels: int, rate: int, tmp_path: Path) -> None:
    sound = samples_of_16_bits(0, 3 * rate + 7, n_channels)
    path = tmp_path / f"take{suffix}"
    recording = begun(path, rate, n_channels)
    for start in range(0, len(sound), rate // 100):
        recording.write(sound[start : start + rate // 100])
    recording.close()
    assert recording.failure is None
    assert recording.notes == ()
    assert recording.path == path
    assert (recording.n_samples, recording.seconds) == (len(sound), len(sound) / rate)
    assert soundfile.info(path).samplerate == rate
    np.testing.assert_array_equal(samples_in(path), sound)
    with SoundReader(path) as reader:
        assert (reader.n_channels, reader.duration) == (n_channels, recording.seconds)
        if rate == SAMPLE_RATE:
            np.testing.assert_array_equal(reader.read(reader.n_samples), sound)


@pytest.mark.parametrize("suffix", [".wav", ".flac"])
def test_all_numbers_of_24_bits_are_exact_and_louder_ones_are_cut_off(suffix: str, tmp_path: Path) -> None:
    whole = np.random.default_rng(0).integers(-(1 << 23), 1 << 23, 50_000)
    whole[:2] = -(1 << 23), (1 << 23) - 1
    loud = np.array([1.0, 1.5, -1.5, np.inf, -np.inf, np.nan], np.float32)
    recording = begun(tmp_path / f"take{suffix}")
    recording.write((whole / (1 << 23)).astype(np.float32)[:, np.newaxis])
    recording.write(loud[:, np.newaxis])
    recording.close()
    most = 1 - 2.0**-23
    found = samples_in(recording.path)[:, 0] * (1 << 23)
    np.testing.assert_array_equal(found[: len(whole)], whole)
    np.testing.assert_array_equal(found[len(whole) :] / (1 << 23), [most, most, -1, most, -1, 0])


@given(st.lists(st.floats(-2, 2, width=32), min_size=1, max_size=50))
def test_a_sample_is_rounded_to_the_nearest_number(values: list[float]) -> None:
    found = to_integers(np.array(values, np.float32)) / (1 << 23)
    assert np.abs(found - np.clip(values, -1, 1)).max() <= 2.0**-23


def test_an_ordinary_wav_file_is_read_by_pythons_own_reader(tmp_path: Path) -> None:
    recording = begun(tmp_path / "take.wav", 48_000, 1)
    recording.write(samples_of_16_bits(0, 12_345))
    recording.close()
    with wave.open(str(recording.path)) as file:
        assert (file.getnchannels(), file.getsampwidth(), file.getframerate()) == (1, 3, 48_000)
        content = np.frombuffer(file.readframes(20_000), np.uint8).reshape(-1, 3)
    whole = content @ np.array([1, 1 << 8, 1 << 16])
    expected = np.round(samples_of_16_bits(0, 12_345)[:, 0].astype(float) * (1 << 23)).astype(int) % (1 << 24)
    np.testing.assert_array_equal(whole, expected)
    content = recording.path.read_bytes()
    assert content[:4] == b"RIFF"
    assert int.from_bytes(content[4:8], "little") == len(content) - 8
    assert len(content) % 2 == 0


@pytest.mark.parametrize("big", [False, True])
def test_a_wav_file_turns_to_rf64_beyond_4_gb(big: bool, tmp_path: Path) -> None:
    """Most of the file is a hole, which takes no room on the disk."""
    path = tmp_path / "large.wav"
    last = samples_of_16_bits(0, 1000, 2)
    n_samples = (1 << 32) // 6 + (1000 if big else -100 - HEADER // 6)
    with path.open("x+b", buffering=0) as file:
        encoder = WavEncoder(file, SAMPLE_RATE, 2)
        encoder.n_samples = n_samples - len(last)
        encoder.write(last)
        encoder.close()
    with path.open("rb") as file:
        head = file.read(HEADER)
    size = path.stat().st_size
    assert size == HEADER + 6 * n_samples
    if big:
        assert (head[:4], head[4:8], head[12:16]) == (b"RF64", b"\xff" * 4, b"ds64")
        sizes = [int.from_bytes(head[at : at + 8], "little") for at in (20, 28, 36)]
        assert sizes == [size - 8, 6 * n_samples, n_samples]
    else:
        assert head[:4] == b"RIFF"
        assert int.from_bytes(head[4:8], "little") == size - 8
        with wave.open(str(path)) as file:
            assert file.getnframes() == n_samples
    assert (soundfile.info(path).frames, soundfile.info(path).format) == (n_samples, "RF64" if big else "WAV")
    with SoundReader(path) as reader:
        assert reader.n_samples == n_samples
        reader.seek(n_samples - len(last))
        np.testing.assert_array_equal(reader.read(5000), last)


@pytest.mark.long
def test_a_recording_of_more_than_4_gb_is_whole(tmp_path: Path) -> None:
    rate, n_channels, seconds = 192_000, 8, 1000
    recording = begun(tmp_path / "large.wav", rate, n_channels)
    block = samples_of_16_bits(0, rate, n_channels)
    for second in range(seconds):
        recording.write(block)
        wait_for(lambda s=second: recording.seconds >= s - 10 or recording.failure)
    recording.close()
    assert recording.failure is None
    with SoundReader(recording.path) as reader:
        assert (reader.duration, reader.n_file_channels) == (seconds, n_channels)
    with soundfile.SoundFile(recording.path) as file:
        for second in (0, 500, 999):
            file.seek(second * rate)
            np.testing.assert_array_equal(file.read(rate, dtype="float32"), block)


@pytest.mark.parametrize("suffix", [".wav", ".flac"])
def test_the_file_is_playable_while_it_grows(suffix: str, tmp_path: Path) -> None:
    rate = 16_000
    recording = begun(tmp_path / f"take{suffix}", rate, 2)
    for second in range(3):
        recording.write(samples_of_16_bits(second * rate, rate, 2))
        wait_for(lambda s=second: recording.seconds >= s + 0.5)
        n_samples = recording.n_samples
        with SoundReader(recording.path) as reader:
            assert reader.duration >= n_samples / rate >= second + 0.5
        found = samples_in(recording.path)
        assert len(found) >= n_samples
        np.testing.assert_array_equal(found, samples_of_16_bits(0, len(found), 2))
    recording.close()
    assert recording.seconds == 3


def test_writing_does_not_wait_for_the_disk_and_keeps_what_it_was_given(tmp_path: Path) -> None:
    recording = begun(tmp_path / "take.wav", n_channels=2)
    block = np.full((441, 2), 0.25, np.float32)
    recording.write(block)
    block[:] = 0.75  # the caller may use its block again
    recording.write(block)
    recording.close()
    recording.write(block)  # too late
    assert samples_in(recording.path)[:, 0].tolist() == [0.25] * 441 + [0.75] * 441


def test_a_recording_may_be_closed_twice_and_by_several_threads(tmp_path: Path) -> None:
    recording = begun(tmp_path / "take.flac")
    recording.write(samples_of_16_bits(0, 10_000))
    threads = [threading.Thread(target=recording.close) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    content = digest(recording.path)
    recording.close()
    assert recording.n_samples == 10_000
    assert digest(recording.path) == content


@pytest.mark.parametrize("suffix", [".wav", ".flac"])
def test_a_recording_without_a_sample_leaves_no_file(suffix: str, tmp_path: Path) -> None:
    recording = begun(tmp_path / f"take{suffix}")
    recording.close()
    assert recording.failure is None
    assert not recording.path.exists()


def test_twenty_minutes_of_waiting_sound_take_no_more_memory_than_a_minute(tmp_path: Path) -> None:
    rate = 8000
    recording = begun(tmp_path / "take.wav", rate)
    block = np.zeros((rate, 1), np.float32)
    tracemalloc.start()
    try:
        for second in range(1200):
            recording.write(block)
            wait_for(lambda s=second: recording.seconds >= s - 50 or recording.failure)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
        recording.close()
    assert (recording.failure, recording.seconds) == (None, 1200)
    assert peak < 4 * 60 * rate * 2


def test_a_hundred_recordings_leave_no_threads_and_no_open_files(tmp_path: Path) -> None:
    def n_open() -> int:
        return len(os.listdir("/proc/self/fd")) if Path("/proc/self/fd").exists() else 0  # noqa: PTH208

    begun(tmp_path / "first.flac").close()
    before = threading.active_count(), n_open()
    for number in range(100):
        recording = begun(tmp_path / f"{number}{'.wav' if number % 2 else '.flac'}")
        recording.write(samples_of_16_bits(0, 5000))
        recording.close()
        assert recording.n_samples == 5000
    assert (threading.active_count(), n_open()) == before
    assert list((tmp_path / "journal").iterdir()) == []
