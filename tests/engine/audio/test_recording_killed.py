"""A process that is killed while it records loses nothing that was on the disk."""

import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.journal import interrupted_recordings
from phonemeengine.errors import AudioError
from tests.fakes.recorders import samples_in, samples_of_16_bits
from tests.waiting import let_pass

RATES = {"a.wav": (44_100, 2), "b.flac": (44_100, 1), "c.wav": (16_000, 1), "d.flac": (8_000, 2)}
"""What each process records at the same time: rate in Hz, and channels."""

RECORD = """
import sys
from pathlib import Path
from tests.waiting import let_pass
from tests.engine.audio.test_recording_killed import RATES
from tests.fakes.recorders import begun, samples_of_16_bits
folder = Path(sys.argv[1])
recordings = {name: begun(folder / name, *form) for name, form in RATES.items()}
print("begun", flush=True)
n_blocks = 0
while True:
    for name, (rate, n_channels) in RATES.items():
        recordings[name].write(samples_of_16_bits(n_blocks * rate // 100, rate // 100, n_channels))
    n_blocks += 1
    print(*(recording.n_samples for recording in recordings.values()), flush=True)
    let_pass(0.01)
"""

TAKES = """
import sys
from pathlib import Path
from tests.waiting import let_pass
from tests.fakes.recorders import begun, samples_of_16_bits
folder = Path(sys.argv[1])
print("begun", flush=True)
for number in range(1000):
    recording = begun(folder / f"{number}{'.wav' if number % 2 else '.flac'}", 16_000)
    for block in range(10):
        recording.write(samples_of_16_bits(block * 800, 800))
        let_pass(0.002)
    recording.close()
    print(recording.path.name, flush=True)
"""


@contextmanager
def running(program: str, folders: list[Path]) -> Iterator[list["subprocess.Popen[str]"]]:
    """Run a program in several processes, until each has begun."""
    with ExitStack() as at_end:
        processes = []
        for folder in folders:
            folder.mkdir()
            command = [sys.executable, "-c", program, str(folder)]
            process = at_end.enter_context(subprocess.Popen(command, stdout=subprocess.PIPE, text=True))
            at_end.callback(process.kill)
            processes.append(process)
        for process in processes:
            assert process.stdout is not None
            assert process.stdout.readline() == "begun\n"
        yield processes


def last_words(process: "subprocess.Popen[str]") -> list[str]:
    """Kill a process, and give the whole lines that it has still written."""
    process.kill()
    assert process.stdout is not None
    return [line.strip() for line in process.stdout if line.endswith("\n")]


def kill_after(process: "subprocess.Popen[str]", seconds: float) -> list[int]:
    """Kill a process once it says that so much of each recording is on the disk; give what it said last, samples."""
    assert process.stdout is not None
    said = [0]
    while min(n / rate for n, (rate, _) in zip(said, RATES.values(), strict=False)) < seconds:
        said = [int(n) for n in process.stdout.readline().split()]
    for line in last_words(process):
        said = [int(n) for n in line.split()]
    return said


@pytest.mark.parametrize("batch", [0, *(pytest.param(k, marks=pytest.mark.long) for k in range(1, 5))])
def test_a_killed_process_leaves_all_that_it_said_to_be_on_the_disk(batch: int, tmp_path: Path) -> None:
    lengths = np.random.default_rng(batch).uniform(0.0, 1.0, 2)
    folders = [tmp_path / str(number) for number in range(2)]
    with running(RECORD, folders) as processes:
        said = [kill_after(process, length) for process, length in zip(processes, lengths, strict=True)]
    for folder, numbers in zip(folders, said, strict=True):
        offered = {recording.path: recording.seconds for recording in interrupted_recordings(folder / "journal")}
        for (name, (rate, n_channels)), n_samples in zip(RATES.items(), numbers, strict=True):
            with SoundReader(folder / name) as reader:
                assert reader.duration >= n_samples / rate > 0
                assert offered[folder / name] == reader.duration
                assert sum(len(block) for block in reader.blocks(10_000)) == reader.n_samples
            found = samples_in(folder / name)
            assert len(found) / rate == offered[folder / name]
            np.testing.assert_array_equal(found, samples_of_16_bits(0, len(found), n_channels))


def test_killing_at_a_beginning_or_an_end_spoils_no_other_recording(tmp_path: Path) -> None:
    moments = sorted(np.random.default_rng(5).uniform(0.0, 1.0, 4))
    folders = [tmp_path / str(number) for number in range(4)]
    n_unfinished = 0
    with running(TAKES, folders) as processes:
        start, said = time.monotonic(), []
        for process, moment in zip(processes, moments, strict=True):
            let_pass(max(0.0, start + moment - time.monotonic()))
            said.append(last_words(process))
    for folder, finished in zip(folders, said, strict=True):
        for name in finished:
            np.testing.assert_array_equal(samples_in(folder / name), samples_of_16_bits(0, 8000))
        offered = [recording.path.name for recording in interrupted_recordings(folder / "journal")]
        others = {path.name for path in folder.iterdir() if path.is_file()} - set(finished)
        assert len(others) <= 1
        assert set(offered) <= others | set(finished[-1:])
        for name in others:
            n_unfinished += 1
            try:
                with SoundReader(folder / name) as reader:
                    assert sum(len(block) for block in reader.blocks(10_000)) == reader.n_samples
            except AudioError:
                assert name not in offered  # no sample was on the disk yet
    assert n_unfinished > 0
