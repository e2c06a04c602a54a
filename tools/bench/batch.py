"""Batches: two cores against one, a cluster against two cores, short files, nothing to do, and a very long file."""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import soundfile

from phonemeengine.batch.runner import BatchOptions, run_batch
from phonemeengine.batch.work import Job, JobState, Work
from phonemeengine.conversion.work import ConversionWork
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.batch_works import CopyWork
from tests.fakes.dask_cluster import DaskCluster
from tools.bench.figures import ROOT, Absolute, Figure, answer_of, child_environment, speech

N_LONG, LONG_MINUTES = 8, 75
"""Files of a folder of ten hours that is worked through by one core, by two, and by a cluster of two."""
N_SHORT, SHORT_SECONDS = 2000, 2
N_DONE = 10_000
HOURS, CHUNK_MINUTES = 10, 10
MOST_MB = 400.0
LEAST_GAIN, LEAST_PER_SECOND, LEAST_OF_CLUSTER, MOST_SECONDS = 1.8, 100.0, 0.9, 10.0
KIND = "rhubarb-json"
KINDS = (KIND, "livelink-csv")


def figures() -> list[Figure]:
    """Measure in a process of its own, which starts others that import no more than it."""
    a = answer_of("batch")
    long = f"{N_LONG} files of {LONG_MINUTES} min"
    gain, cluster = a["one"] / a["two"], a["two"] / a["cluster"]
    per_second = N_SHORT / a["short"]
    return [
        Figure(
            f"{long}, two cores against one",
            f"{gain:.2f} x",
            f"{LEAST_GAIN} x ({a['one']:.1f} s on one)",
            LEAST_GAIN / gain,
            limit=1.0,
        ),
        Figure(
            f"{long}, Dask with two workers against two cores",
            f"{cluster:.2f} of their speed",
            f"{LEAST_OF_CLUSTER} ({a['two']:.1f} s)",
            LEAST_OF_CLUSTER / cluster,
            limit=1.0,
        ),
        Figure(
            f"{N_SHORT} files of {SHORT_SECONDS} s on two cores",
            f"{per_second:.0f} files/s",
            f"{LEAST_PER_SECOND:g} files/s",
            LEAST_PER_SECOND / per_second,
            limit=1.0,
            absolute=Absolute.TIME,
        ),
        Figure(
            f"nothing to do, {N_DONE} files done before",
            f"{a['nothing']:.2f} s",
            f"{MOST_SECONDS:g} s",
            a["nothing"] / MOST_SECONDS,
            limit=1.0,
            absolute=Absolute.TIME,
        ),
    ]


def memory_figures() -> list[Figure]:
    """Measure the memory of a process that exports a very long file."""
    with tempfile.TemporaryDirectory() as name:
        measured = _measured_memory(Path(name))
    return [
        Figure(
            f"memory of one process, a file of {HOURS} h as {kind}",
            f"{megabytes:.0f} MB",
            f"{MOST_MB:g} MB",
            megabytes / MOST_MB,
            limit=1.0,
        )
        for kind, megabytes in measured.items()
    ]


def main() -> None:
    """Measure, and print all as JSON; with a sound, output and kind, export it and print the memory that takes."""
    if len(sys.argv) > 2:
        work = ConversionWork(sys.argv[3], load_preset(DEFAULT_PRESET))
        run_batch([Job(Path(sys.argv[1]), Path(sys.argv[2]))], work, BatchOptions(1))
        lines = Path("/proc/self/status").read_text().splitlines()  # `getrusage` counts the parent's memory as well
        print(next(int(line.split()[1]) for line in lines if line.startswith("VmHWM")) / 1024)
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        answer = {"short": _measured_short(folder), "nothing": _measured_nothing(folder)}
        print(json.dumps(_measured_long(folder) | answer))


def _work() -> ConversionWork:
    return ConversionWork(KIND, load_preset(DEFAULT_PRESET))


def _measured_long(folder: Path) -> dict[str, float]:
    """Give the seconds that one core, two cores and a cluster of two take."""
    sounds = _sounds(folder / "long", N_LONG, 60 * LONG_MINUTES)
    (folder / "dask").mkdir()
    with DaskCluster(folder / "dask", 2) as cluster:
        ways = {"one": BatchOptions(1), "two": BatchOptions(2), "cluster": BatchOptions(cluster=cluster.address)}
        return {name: _seconds(sounds, folder / name, _work(), way) for name, way in ways.items()}


def _measured_short(folder: Path) -> float:
    return _seconds(_sounds(folder / "short", N_SHORT, SHORT_SECONDS), folder / "made", _work(), BatchOptions(2))


def _measured_nothing(folder: Path) -> float:
    (folder / "done").mkdir()
    sounds = [folder / "done" / f"{k:05d}.wav" for k in range(N_DONE)]
    for sound in sounds:
        sound.write_text(sound.stem)
    _seconds(sounds, folder / "copied", CopyWork(), BatchOptions(1))
    return _seconds(sounds, folder / "copied", CopyWork(), BatchOptions(1), JobState.SKIPPED)


def _measured_memory(folder: Path) -> dict[str, float]:
    """Give the most memory of a process that exports a very long file, MB, by the kind of export."""
    path, minutes = folder / "very-long.wav", np.asarray(speech(60 * CHUNK_MINUTES) * 32767, np.int16)
    with soundfile.SoundFile(path, "w", SAMPLE_RATE, 1, "PCM_16") as file:
        for _ in range(60 * HOURS // CHUNK_MINUTES):
            file.write(minutes)
    found = {}
    for kind in KINDS:
        words = [sys.executable, "-m", "tools.bench.batch", str(path), str(folder / f"very-long-{kind}"), kind]
        done = subprocess.run(words, env=child_environment(), cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
        found[kind] = float(done.stdout)
    return found


def _seconds(
    sounds: list[Path], out: Path, work: Work, options: BatchOptions, state: JobState = JobState.DONE
) -> float:
    """Give how long a batch takes with all that belongs to it."""
    jobs = [Job(sound, out / f"{sound.stem}.json") for sound in sounds]
    began = time.perf_counter()
    outcomes = run_batch(jobs, work, BatchOptions(options.jobs, out, options.cluster))
    seconds = time.perf_counter() - began
    assert {outcome.state for outcome in outcomes} == {state}
    return seconds


def _sounds(folder: Path, n: int, seconds: float) -> list[Path]:
    """Make sounds, all of them different."""
    folder.mkdir()
    sound = np.asarray(speech(seconds) * 32767, np.int16)
    paths = [folder / f"{k:05d}.wav" for k in range(n)]
    for k, path in enumerate(paths):
        soundfile.write(path, np.roll(sound, 9973 * k), SAMPLE_RATE)
    return paths


if __name__ == "__main__":
    main()
