"""Batches as a studio has them: workers and schedulers that die, and very many files."""

import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine import load_preset
from phonemeengine.batch.runner import BatchOptions, BatchProgress, run_batch
from phonemeengine.batch.work import Job, JobState
from phonemeengine.conversion.work import ConversionWork
from phonemeengine.errors import BatchError
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.dask_cluster import DaskCluster
from tests.sounds import vowel
from tests.tables import contents, outputs_in

pytestmark = [pytest.mark.long, pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::DeprecationWarning")]
WORK = ConversionWork("phonemes-csv", load_preset("learned"))


def jobs_of(folder: Path, out: Path, n: int) -> list[Job]:
    """Make short sounds, all of them different."""
    folder.mkdir()
    sound = vowel((700, 1200), 3.0)
    for k in range(n):
        soundfile.write(folder / f"{k:05d}.wav", np.roll(sound, 997 * k)[: 2 * SAMPLE_RATE], SAMPLE_RATE)
    return [Job(path, out / f"{path.stem}.csv") for path in sorted(folder.iterdir())]


def after(shares: dict[float, Callable[[], None]]) -> Callable[[BatchProgress], bool]:
    """Do something as soon as so much is done."""
    waiting = dict(shares)

    def watch(progress: BatchProgress) -> bool:
        for share in [share for share in waiting if progress.share > share]:
            waiting.pop(share)()
        return True

    return watch


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[DaskCluster]:
    (tmp_path / "dask").mkdir()
    with DaskCluster(tmp_path / "dask", 4) as cluster:
        yield cluster


def test_workers_and_the_scheduler_die_and_all_files_are_made_once(cluster: DaskCluster, tmp_path: Path) -> None:
    jobs = jobs_of(tmp_path / "in", tmp_path / "far", 600)
    options = BatchOptions(None, tmp_path / "far", cluster.address)
    killing = {0.1: lambda: cluster.kill_worker(0), 0.2: lambda: cluster.kill_worker(1), 0.5: cluster.kill_scheduler}
    with pytest.raises(BatchError, match="the cluster has gone"):
        run_batch(jobs, WORK, options, on_progress=after(killing))
    n_before = len(outputs_in(tmp_path / "far"))
    assert 0 < n_before < len(jobs)
    cluster.kill()
    cluster.begin()
    outcomes = run_batch(jobs, WORK, options)
    assert {outcome.state for outcome in outcomes} == {JobState.DONE, JobState.SKIPPED}
    assert not [*(tmp_path / "far").glob("*.part")]
    near = [Job(job.source, tmp_path / "near" / f"{job.source.stem}.csv") for job in jobs]
    run_batch(near, WORK, BatchOptions(2, tmp_path / "near"))
    assert contents(tmp_path / "far") == contents(tmp_path / "near")
    assert len(outputs_in(tmp_path / "far")) == len(jobs)


def test_ten_thousand_short_files_are_made_and_never_again(tmp_path: Path) -> None:
    jobs = jobs_of(tmp_path / "in", tmp_path / "out", 10_000)
    options = BatchOptions(2, tmp_path / "out")
    began = time.monotonic()
    assert {outcome.state for outcome in run_batch(jobs, WORK, options)} == {JobState.DONE}
    made = time.monotonic()
    assert {outcome.state for outcome in run_batch(jobs, WORK, options)} == {JobState.SKIPPED}
    print(f"{len(jobs) / (made - began):.0f} files a second, and {time.monotonic() - made:.1f} s for nothing to do")
    assert len(outputs_in(tmp_path / "out")) == len(jobs)
