"""Sounds and outputs at addresses: fetched, worked on, and sent back whole."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from upath import UPath

from phonemeanalyser.cli.main import main
from phonemeengine.batch.record import RECORD
from phonemeengine.batch.remote import place_of
from phonemeengine.batch.runner import BatchOptions, run_batch
from phonemeengine.batch.work import Job, JobState
from phonemeengine.errors import BatchError
from tests.engine.batch.test_batch import states
from tests.fakes.batch_works import CopyWork
from tests.fakes.dask_cluster import DaskCluster
from tests.tables import contents


@pytest.fixture
def bucket(request: pytest.FixtureRequest) -> Iterator[UPath]:
    place = UPath(f"memory://{request.node.name}")
    (place / "in" / "deep").mkdir(parents=True, exist_ok=True)
    yield place
    place.fs.rm(place.path, recursive=True)


def test_outputs_are_sent_where_they_belong_and_made_once(bucket: UPath) -> None:
    for name in ("a", "fails", "z"):
        (bucket / "in" / f"{name}.wav").write_text(f"says {name}")
    jobs = [Job(bucket / "in" / f"{name}.wav", bucket / "out" / f"{name}.txt") for name in ("a", "fails", "z")]
    options = BatchOptions(1, bucket / "out")
    done, failed, skipped = JobState.DONE, JobState.FAILED, JobState.SKIPPED
    assert states(run_batch(jobs, CopyWork(), options)) == {"a": done, "fails": failed, "z": done}
    assert (bucket / "out" / "z.txt").read_text() == "copy says z"
    assert states(run_batch(jobs, CopyWork(), options)) == {"a": skipped, "fails": failed, "z": skipped}
    (bucket / "in" / "a.wav").write_text("says A")
    assert states(run_batch(jobs, CopyWork(), options)) == {"a": done, "fails": failed, "z": skipped}
    assert (bucket / "out" / "a.txt").read_text() == "copy says A"


def test_a_folder_at_an_address_becomes_what_a_folder_here_does(bucket: UPath, sound: Path, tmp_path: Path) -> None:
    for name in ("a.wav", "deep/b.wav"):
        (bucket / "in" / name).write_bytes(sound.read_bytes())
        (tmp_path / "in" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "in" / name).write_bytes(sound.read_bytes())
    assert main(["analyse", str(bucket / "in"), "-o", str(bucket / "out"), "--format", "json"]) == 0
    assert main(["analyse", str(tmp_path / "in"), "-o", str(tmp_path / "out"), "--format", "json"]) == 0
    here = contents(tmp_path / "out")
    assert sorted(here) == ["a.json", "deep/b.json"]
    assert {name: (bucket / "out" / name).read_bytes() for name in here} == here
    assert (bucket / "out" / RECORD).exists()


def test_a_file_of_somebody_else_at_an_address_is_left_alone(
    bucket: UPath, sound: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (bucket / "in" / "a.wav").write_bytes(sound.read_bytes())
    (bucket / "out").mkdir()
    (bucket / "out" / "a.csv").write_text("of somebody else")
    assert main(["analyse", str(bucket / "in"), "-o", str(bucket / "out")]) == 1
    assert "is left alone" in capsys.readouterr().err
    assert (bucket / "out" / "a.csv").read_text() == "of somebody else"


def test_an_address_that_nobody_knows_is_refused() -> None:
    with pytest.raises(BatchError, match=r"nowhere://x: addresses need packages that cannot be loaded"):
        place_of("nowhere://x")


@pytest.fixture
def s3(monkeypatch: pytest.MonkeyPatch) -> Iterator[UPath]:
    """Give a bucket of a server of the protocol of S3, on this machine."""
    from moto.server import ThreadedMotoServer

    server = ThreadedMotoServer(port=0)
    server.start()
    monkeypatch.setenv("AWS_ACCESS_KEY_ID", "a")
    monkeypatch.setenv("AWS_SECRET_ACCESS_KEY", "b")
    monkeypatch.setenv("AWS_ENDPOINT_URL", "http://{}:{}".format(*server.get_host_and_port()))
    monkeypatch.setenv("AWS_DEFAULT_REGION", "us-east-1")
    bucket = UPath("s3://sounds")
    bucket.mkdir()
    yield bucket
    server.stop()


@pytest.mark.long
@pytest.mark.filterwarnings("ignore")
def test_a_bucket_of_s3_is_a_folder_for_processes_and_for_a_cluster(s3: UPath, sound: Path, tmp_path: Path) -> None:
    folder = tmp_path / "in"
    folder.mkdir()
    for name in ("a.wav", "b.wav"):
        (folder / name).write_bytes(sound.read_bytes())
        (s3 / "in" / name).write_bytes(sound.read_bytes())
    (tmp_path / "dask").mkdir()
    assert main(["analyse", str(folder), "-o", str(tmp_path / "here")]) == 0
    here = contents(tmp_path / "here")
    with DaskCluster(tmp_path / "dask", 2) as cluster:
        for name, way in {"1": ["--jobs", "1"], "2": ["--jobs", "2"], "dask": ["--dask", cluster.address]}.items():
            for _again in range(2):
                assert main(["analyse", "s3://sounds/in", "-o", f"s3://sounds/{name}", *way]) == 0
            assert {n: (s3 / name / n).read_bytes() for n in here} == here
