"""What a listener hears goes to a file as it came, and its phonemes into a table beside it."""

import csv
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import Analyser, Analysis
from phonemeengine.live.recorder import Recorder
from phonemeengine.recognition.segments import segments_of
from phonemeengine.settings import HOP, SAMPLE_RATE
from phonemeengine.storage.files import free_path
from tests.fakes.microphones import HandDrivenMicrophone, Hear, frames_in, offline
from tests.fakes.players import PRESET, SPEECH
from tests.fakes.recorders import recorder_to, samples_in, samples_of_16_bits
from tests.sounds import noise
from tests.waiting import wait_for


@pytest.fixture
def names(tmp_path: Path) -> Callable[[], Path]:
    """Names take.wav, take (2).wav, ..."""
    return lambda: free_path(tmp_path / "take.wav")


def rows_beside(path: Path) -> list[tuple[float, float, str, float]]:
    with path.with_suffix(".csv").open(newline="") as table:
        return [
            (float(row["start_s"]), float(row["end_s"]), row["phoneme"], float(row["intensity"]))
            for row in csv.DictReader(table)
        ]


def rows_of(analysis: Analysis, duration: float) -> list[Any]:
    return [tuple(run.row().values()) for run in segments_of([(analysis.phonemes, analysis.intensities)], duration)]


def same(found: list[Any], wanted: list[Any]) -> None:
    assert [row[2] for row in found] == [row[2] for row in wanted]
    numbers = [np.array([[row[0], row[1], row[3]] for row in rows]) for rows in (found, wanted)]
    np.testing.assert_allclose(*numbers, atol=2e-3)


def record(
    tape: Recorder, samples: np.ndarray, *, n: int = HOP, began: float = 0.0, gap: float | None = None
) -> None:
    """Hear samples at 44.1 kHz as a listener does, after a gap of some seconds."""
    analyser = Analyser(PRESET, start=round(began * 100))
    for k in range(0, len(samples), n):
        block = samples[k : k + n]
        tape.write(block[:, np.newaxis], SAMPLE_RATE, began + k / SAMPLE_RATE, None if k else gap)
        analysis = analyser.push(block)
        if len(analysis):
            tape.add_analysis(analysis)


def test_what_is_heard_is_on_the_tape_and_its_phonemes_beside_it(
    hear: Hear, names: Callable[[], Path], tmp_path: Path
) -> None:
    tape = recorder_to(names, tmp_path, with_phonemes=True)
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone, recorder=tape)
    sound = np.round(SPEECH * 2**23) / np.float32(2**23)
    microphone.give(sound)
    hearing.wait_samples(len(sound))
    hearing.listener.record(None)
    tape.close()
    assert (tape.paths, tape.path, tape.failure, tape.notes) == ([tmp_path / "take.wav"], tape.paths[0], None, ())
    assert tape.seconds == len(sound) / SAMPLE_RATE
    np.testing.assert_array_equal(samples_in(tape.paths[0])[:, 0], sound.clip(-1, 1 - 2**-23))
    heard = offline(sound).part(slice(frames_in(len(sound))))
    same(rows_beside(tape.paths[0]), rows_of(heard, len(sound) / SAMPLE_RATE))


def test_a_recording_that_begins_in_the_midst_of_listening_has_its_own_beginning(
    hear: Hear, names: Callable[[], Path], tmp_path: Path
) -> None:
    tape = recorder_to(names, tmp_path, with_phonemes=True)
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone)
    first = 40 * HOP
    microphone.give(SPEECH[:first])
    hearing.wait(frames_in(first))
    hearing.listener.record(tape)
    microphone.give(SPEECH[first:])
    hearing.wait_samples(len(SPEECH))
    hearing.listener.record(None)
    tape.close()
    assert len(samples_in(tape.paths[0])) == len(SPEECH) - first
    same(
        rows_beside(tape.paths[0]),
        rows_of(offline(SPEECH).part(slice(40, frames_in(len(SPEECH)))), (len(SPEECH) - first) / SAMPLE_RATE),
    )


@pytest.mark.parametrize("n", [100, 441, 5000])
def test_the_length_that_was_asked_for_is_kept_to_the_sample(
    names: Callable[[], Path], tmp_path: Path, n: int
) -> None:
    tape = recorder_to(names, tmp_path, with_phonemes=True, seconds=1.0)
    record(tape, SPEECH, n=n)
    tape.close()
    assert tape.seconds == 1.0
    assert len(samples_in(tape.paths[0])) == SAMPLE_RATE
    rows = rows_beside(tape.paths[0])
    same(rows, rows_of(offline(SPEECH).part(slice(100)), 1.0))
    assert rows[-1][1] == 1.0


def test_another_rate_or_number_of_channels_begins_another_file(names: Callable[[], Path], tmp_path: Path) -> None:
    tape = recorder_to(names, tmp_path, with_phonemes=True)
    shapes = ((44_100, 1), (48_000, 1), (48_000, 2))
    for k, (rate, n_channels) in enumerate(shapes):
        for part in range(3):
            tape.write(samples_of_16_bits(100 * part, 100, n_channels), rate, k + 100 * part / rate)
    tape.close()
    wait_for(lambda: not [t for t in threading.enumerate() if t.name == "recording ends"], "the old files")
    assert [path.name for path in tape.paths] == ["take.wav", "take (2).wav", "take (3).wav"]
    for path, (rate, n_channels) in zip(tape.paths, shapes, strict=True):
        assert soundfile.info(path).samplerate == rate
        np.testing.assert_array_equal(samples_in(path), samples_of_16_bits(0, 300, n_channels))
        assert rows_beside(path) == []


def test_without_the_phonemes_there_is_no_table(names: Callable[[], Path], tmp_path: Path) -> None:
    tape = recorder_to(names, tmp_path)
    record(tape, SPEECH)
    tape.close()
    assert list(tmp_path.glob("*.csv")) == []


def test_a_tape_on_which_nothing_was_recorded_leaves_nothing(names: Callable[[], Path], tmp_path: Path) -> None:
    tape = recorder_to(names, tmp_path, with_phonemes=True)
    assert (tape.path, tape.paths, tape.seconds, tape.notes, tape.failure) == (None, [], 0.0, (), None)
    tape.close()
    tape.write(np.zeros((441, 1), np.float32), SAMPLE_RATE, 0.0)  # the listening thread may come late
    assert (tape.path, list(tmp_path.iterdir())) == (None, [])


def test_a_table_that_is_there_stays_and_the_new_one_gets_a_number(names: Callable[[], Path], tmp_path: Path) -> None:
    (tmp_path / "take.csv").write_text("mine")
    tape = recorder_to(names, tmp_path, with_phonemes=True)
    record(tape, SPEECH)
    tape.close()
    assert tape.failure is None
    assert (tmp_path / "take.csv").read_text() == "mine"
    assert (tmp_path / "take (2).csv").read_text().startswith("start_s,")
    assert (tmp_path / "take.wav").exists()


def test_a_folder_that_is_missing_is_said_once_and_not_tried_with_every_block(tmp_path: Path) -> None:
    asked: list[Path] = []

    def nowhere() -> Path:
        asked.append(tmp_path / "gone" / "take.wav")
        return asked[-1]

    tape = recorder_to(nowhere, tmp_path)
    record(tape, SPEECH)
    tape.close()
    assert tape.failure is not None
    assert tape.failure.startswith("take.wav: there is no folder ")
    assert len(asked) == 1


def test_a_folder_that_vanishes_ends_the_recording_with_a_sentence(names: Callable[[], Path], tmp_path: Path) -> None:
    folder = tmp_path / "stick"
    folder.mkdir()
    tape = recorder_to(lambda: folder / "take.wav", tmp_path)
    block = noise(0.1)
    tape.write(block[:, np.newaxis], SAMPLE_RATE, 0.0)
    wait_for(lambda: tape.seconds == 0.1, "the disk")
    folder.rename(tmp_path / "pulled out")
    wait_for(lambda: tape.failure is not None, "the sentence")
    assert tape.failure is not None
    assert "its folder or the file itself has gone" in tape.failure
    tape.write(block[:, np.newaxis], SAMPLE_RATE, 0.1)
    tape.close()
    assert len(samples_in(tmp_path / "rescue" / "take.wav")) == 4410


@pytest.mark.parametrize("k", range(10))
def test_closing_while_the_listening_thread_writes_trips_nobody_and_leaves_a_whole_file(
    names: Callable[[], Path], tmp_path: Path, k: int
) -> None:
    tape = recorder_to(names, tmp_path, with_phonemes=True)
    failed: list[Exception] = []

    def listen() -> None:
        try:
            record(tape, SPEECH)
        except Exception as error:  # noqa: BLE001 - the test looks at it
            failed.append(error)

    thread = threading.Thread(target=listen)
    thread.start()
    wait_for(lambda: k == 0 or tape._n_given > 10 * k * HOP or not thread.is_alive(), "some blocks")
    tape.close()
    length = tape.seconds
    thread.join()
    assert (failed, tape.failure, tape.seconds) == ([], None, length)
    if length:
        assert len(samples_in(tmp_path / "take.wav")) == round(length * SAMPLE_RATE)
        rows = rows_beside(tmp_path / "take.wav")
        assert [row[1] for row in rows[:-1]] == [row[0] for row in rows[1:]]
        assert not rows or rows[-1][1] == pytest.approx(length, abs=1e-6)
    assert not [t for t in threading.enumerate() if t.name == "recording"]


def test_one_path_names_the_first_file_and_with_a_number_those_after_it(tmp_path: Path) -> None:
    with recorder_to(str(tmp_path / "take.wav"), tmp_path) as recorder:
        for rate in (44_100, 48_000, 44_100):
            recorder.write(np.zeros((4800, 1), np.float32), rate, 0.0)
    assert [path.name for path in recorder.paths] == ["take.wav", "take (2).wav", "take (3).wav"]
    assert all(path.exists() for path in recorder.paths)


def test_a_file_that_is_there_already_is_not_recorded_over(tmp_path: Path) -> None:
    (tmp_path / "take.wav").write_text("mine")
    with recorder_to(tmp_path / "take.wav", tmp_path) as recorder:
        recorder.write(np.zeros((4800, 1), np.float32), 48_000, 0.0)
    assert recorder.failure is not None
    assert (tmp_path / "take.wav").read_text() == "mine"
