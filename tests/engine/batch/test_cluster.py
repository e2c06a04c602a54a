"""A Dask cluster writes what this machine would, and dies in one sentence."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from phonemeanalyser.cli.main import main
from phonemeengine.batch.cluster import check_versions, versions, work_through_chunk
from phonemeengine.batch.order import order_of
from phonemeengine.batch.runner import BatchOptions, run_batch
from phonemeengine.batch.work import JobState
from phonemeengine.errors import BatchError
from tests.engine.batch.test_batch import jobs_in, made_in, states
from tests.fakes.batch_works import CopyWork
from tests.fakes.dask_cluster import NO_RETRY, DaskCluster
from tests.tables import contents

pytestmark = pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::DeprecationWarning")


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DaskCluster]:
    with DaskCluster(tmp_path_factory.mktemp("dask"), 1, **NO_RETRY) as cluster:
        yield cluster


def test_a_cluster_writes_the_same_bytes(cluster: DaskCluster, sound: Path, tmp_path: Path) -> None:
    folder = tmp_path / "in"
    folder.mkdir()
    for name in ("a", "b", "c"):
        (folder / f"{name}.wav").write_bytes(sound.read_bytes())
    (folder / "a.txt").write_text("one two")
    words = ["export", str(folder), "--format", "textgrid", "--script", "auto", "--language", "en-us"]
    assert main([*words, "-o", str(tmp_path / "far"), "--dask", cluster.address]) == 0
    assert main([*words, "-o", str(tmp_path / "near")]) == 0
    assert contents(tmp_path / "far") == contents(tmp_path / "near")
    assert len(contents(tmp_path / "far")) == 3


def test_a_worker_that_dies_costs_the_file_that_killed_it(cluster: DaskCluster, tmp_path: Path) -> None:
    options = BatchOptions(None, tmp_path / "out", cluster.address)
    found = states(run_batch(jobs_in(tmp_path, "a", "b", "dies", "fails", "z"), CopyWork(), options))
    assert {name for name, state in found.items() if state is JobState.FAILED} == {"dies", "fails"}
    found = states(run_batch(jobs_in(tmp_path, "dies-once"), CopyWork(), options))  # which no other death is laid to
    assert found == {"dies-once": JobState.DONE}
    assert made_in(tmp_path / "out") == {name: f"copy says {name}" for name in ("a", "b", "dies-once", "z")}


@pytest.mark.parametrize("address", ["nowhere", "tls://"])
def test_an_address_that_is_none_is_refused(address: str, tmp_path: Path) -> None:
    options = BatchOptions(None, tmp_path / "out", address)
    with pytest.raises(BatchError, match="no cluster answers there"):
        run_batch(jobs_in(tmp_path, "a"), CopyWork(), options)


def test_another_version_is_refused_with_both_named() -> None:
    theirs = versions() | {"numpy": "0.1"}
    with pytest.raises(
        BatchError, match=rf"has numpy {versions()['numpy']}, and this program 0\.1; install the same"
    ):
        check_versions(theirs)
    check_versions(versions())


def test_a_worker_that_sees_another_folder_says_so(tmp_path: Path) -> None:
    order, jobs = order_of(CopyWork()), jobs_in(tmp_path, "a")
    with pytest.raises(BatchError, match="does not see this folder; share it with all workers by the same path"):
        work_through_chunk(order, jobs, versions(), tmp_path / "elsewhere", "the token")
    jobs[0].source.unlink()
    (outcome,) = work_through_chunk(order, jobs, versions(), None, "")
    assert outcome.words.startswith("a.wav: the worker on ")
    assert outcome.words.endswith(" cannot see it; share its folder by the same path")
