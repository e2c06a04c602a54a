"""A disk that does not answer, or answers late."""

import io
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from phonemeengine.audio.recording import Recording, RecordingFile
from phonemeengine.audio.wav import HEADER
from tests.fakes.recorders import check_kept, check_sentence, samples_of_16_bits
from tests.waiting import wait_for

SUFFIXES = [".wav", ".flac"]
RATE = 16_000


class Gate:
    """A disk that takes nothing while the gate is shut, as a network disk without its network."""

    def __init__(self) -> None:
        self.opened, self.turns, self.slow = threading.Event(), threading.Semaphore(0), False
        self.opened.set()


class GatedFile(io.FileIO):
    """A file on that disk."""

    gate: Gate

    def write(self, content: object) -> int:  # type: ignore[override]
        self.gate.opened.wait()
        if self.gate.slow:
            self.gate.turns.acquire()
        return super().write(content)  # type: ignore[arg-type]


class GatedRecording(Recording):
    """A recording to that disk."""

    def __init__(self, path: Path, gate: Gate, close_timeout: float = 60.0) -> None:
        self.gate, self.close_timeout = gate, close_timeout
        super().__init__(path, RATE, 1, journal=path.parent / "journal", rescue=path.parent / "rescue")

    def _make_file(self, path: Path) -> RecordingFile:
        file = super()._make_file(path)
        file.raw.close()
        file.raw = GatedFile(path, "r+b")
        file.raw.gate = self.gate
        return file


@pytest.fixture
def gate() -> Iterator[Gate]:
    gate = Gate()
    yield gate
    gate.opened.set()


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_disk_that_is_a_minute_behind_stops_the_recording_and_the_minute_is_written_late(
    suffix: str, gate: Gate, tmp_path: Path
) -> None:
    recording = GatedRecording(tmp_path / f"take{suffix}", gate)
    recording.write(samples_of_16_bits(0, 2 * RATE))
    wait_for(lambda: recording.n_samples > RATE)
    gate.opened.clear()
    for second in range(2, 70):
        recording.write(samples_of_16_bits(second * RATE, RATE))  # returns at once
    assert "the disk is 60 s behind, so the recording stopped after" in check_sentence(recording, f"take{suffix}")
    gate.opened.set()
    recording.close()
    assert 60 <= recording.seconds <= 65
    check_kept(recording.path, recording.n_samples)


def test_closing_does_not_wait_for_a_disk_that_takes_nothing(gate: Gate, tmp_path: Path) -> None:
    recording = GatedRecording(tmp_path / "take.wav", gate, 0.2)
    recording.write(samples_of_16_bits(0, RATE))
    wait_for(lambda: int.from_bytes(recording.path.read_bytes()[HEADER - 4 : HEADER], "little") == 3 * RATE)
    gate.opened.clear()
    recording.write(samples_of_16_bits(RATE, RATE))
    recording.close()
    assert "the disk has taken nothing for 0 s" in check_sentence(recording, "take.wav")
    check_kept(tmp_path / "take.wav", RATE)
    gate.opened.set()
    wait_for(lambda: not list((tmp_path / "journal").iterdir()))
    check_kept(tmp_path / "take.wav", 2 * RATE)


def test_a_slow_disk_gets_the_time_it_needs_at_the_end(gate: Gate, tmp_path: Path) -> None:
    """Whoever closes looks again and again, and each time the disk has taken something meanwhile."""
    recording = GatedRecording(tmp_path / "take.wav", gate)
    gate.slow = True
    gate.opened.clear()
    for second in range(50):
        recording.write(samples_of_16_bits(second * RATE, RATE))
    looks: list[float] = []

    def until_it_took_something(patience: float) -> None:
        looks.append(patience)
        before = recording.n_samples
        gate.opened.set()
        wait_for(lambda: gate.turns.release() or recording.n_samples > before or not recording._thread.is_alive())

    recording._thread.join = until_it_took_something  # type: ignore[method-assign]
    recording.close()
    assert len(looks) > 1
    assert recording.failure is None
    check_kept(recording.path, 50 * RATE)
