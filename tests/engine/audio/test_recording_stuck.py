"""A disk that does not answer, or answers late."""

import io
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from phonemeengine.audio import recording as recording_room
from phonemeengine.audio.wav import HEADER
from tests.fakes.recorders import begun, check_kept, check_sentence, samples_of_16_bits
from tests.waiting import wait_for

SUFFIXES = [".wav", ".flac"]
RATE = 16_000


class Gate:
    """A file on a disk that takes nothing while the gate is shut, as a network disk without its network."""

    def __init__(self) -> None:
        self.opened = threading.Event()
        self.opened.set()
        self.seconds_per_write = 0.0

    def made(self, path: Path) -> io.FileIO:
        gate = self

        class Gated(io.FileIO):
            def write(self, content: object) -> int:  # type: ignore[override]
                gate.opened.wait()
                time.sleep(gate.seconds_per_write)
                return super().write(content)  # type: ignore[arg-type]

        return Gated(path, "x+b")


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> Iterator[Gate]:
    gate = Gate()
    monkeypatch.setattr("phonemeengine.audio.recording_file._made", gate.made)
    yield gate
    gate.opened.set()


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_disk_that_is_a_minute_behind_stops_the_recording_and_the_minute_is_written_late(
    suffix: str, gate: Gate, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(recording_room, "CLOSE_TIMEOUT", 60)
    recording = begun(tmp_path / f"take{suffix}", RATE)
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


def test_closing_does_not_wait_for_a_disk_that_takes_nothing(
    gate: Gate, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(recording_room, "CLOSE_TIMEOUT", 0.2)
    recording = begun(tmp_path / "take.wav", RATE)
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
    recording = begun(tmp_path / "take.wav", RATE)
    gate.seconds_per_write = 0.01
    gate.opened.clear()
    for second in range(50):
        recording.write(samples_of_16_bits(second * RATE, RATE))
    looks: list[float] = []

    def until_it_took_something(patience: float) -> None:
        looks.append(patience)
        before = recording.n_samples
        gate.opened.set()
        wait_for(lambda: recording.n_samples > before or not recording._thread.is_alive())

    recording._thread.join = until_it_took_something  # type: ignore[method-assign]
    recording.close()
    assert len(looks) > 1
    assert recording.failure is None
    check_kept(recording.path, 50 * RATE)
