"""Batches: what becomes of each file, alone and by several processes."""

import os
import signal
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from phonemeengine.batch.record import LOCK, RECORD, FolderLock
from phonemeengine.batch.runner import BatchOptions, BatchProgress, run_batch
from phonemeengine.batch.work import Job, JobState, Outcome
from phonemeengine.errors import BatchError, ExportError
from phonemeengine.execution import Cancelled
from tests.conftest import ROOT
from tests.fakes.batch_works import SECONDS, CopyWork
from tests.waiting import wait_for


def jobs_in(tmp_path: Path, *names: str) -> list[Job]:
    folder = tmp_path / "in"
    folder.mkdir(exist_ok=True)
    for name in names:
        (folder / f"{name}.wav").write_text(f"says {name}")
    return [Job(folder / f"{name}.wav", tmp_path / "out" / f"{name}.txt") for name in names]


def worked(tmp_path: Path, *names: str, n_processes: int = 1, word: str = "copy") -> list[Outcome]:
    options = BatchOptions(n_processes, tmp_path / "out")
    return run_batch(jobs_in(tmp_path, *names), CopyWork(word), options)


def states(outcomes: list[Outcome]) -> dict[str, JobState]:
    return {outcome.job.source.stem: outcome.state for outcome in outcomes}


def made_in(folder: Path) -> dict[str, str]:
    return {path.stem: path.read_text() for path in folder.iterdir() if path.name != RECORD}


@pytest.mark.parametrize("n_processes", [1, 2])
def test_what_fails_stops_nothing(n_processes: int, tmp_path: Path) -> None:
    outcomes = worked(tmp_path, "a", "fails", "noted", "crashes", "z", n_processes=n_processes)
    done, failed = JobState.DONE, JobState.FAILED
    assert states(outcomes) == {"a": done, "fails": failed, "noted": done, "crashes": failed, "z": done}
    assert made_in(tmp_path / "out") == {name: f"copy says {name}" for name in ("a", "noted", "z")}
    by_name = {outcome.job.source.stem: outcome for outcome in outcomes}
    assert by_name["fails"].words == "fails.wav: it is refused"
    assert by_name["crashes"].words.startswith(
        "crashes.wav: the program itself failed at it (ZeroDivisionError: a bug)"
    )
    assert by_name["noted"].notes == (("noted", "it is odd"),)


def test_a_process_that_dies_is_replaced_and_its_files_are_tried_again_alone(tmp_path: Path) -> None:
    deadly = {"dies-each-time", "dies-always"}  # the largest files, which both processes begin with
    outcomes = states(worked(tmp_path, *deadly, "a", "b", "dies-once", "y", "z", n_processes=2))
    assert {name for name, state in outcomes.items() if state is JobState.FAILED} == deadly
    others = outcomes.keys() - deadly  # of which one dies for the first time when it is tried alone
    assert made_in(tmp_path / "out") == {name: f"copy says {name}" for name in others}


def test_what_is_done_and_unchanged_is_not_done_again(tmp_path: Path) -> None:
    assert Counter(states(worked(tmp_path, "a", "b", "fails")).values())[JobState.SKIPPED] == 0
    jobs = _rewritten(tmp_path, "a", "b", "fails")
    again = run_batch(jobs, CopyWork(), BatchOptions(1, tmp_path / "out"))
    assert states(again) == {"a": JobState.SKIPPED, "b": JobState.SKIPPED, "fails": JobState.FAILED}
    assert [outcome.made.duration for outcome in again[:2]] == [SECONDS, SECONDS]


def _rewritten(tmp_path: Path, *names: str) -> list[Job]:
    """Give the same jobs, their files written again with the same content, so that they are younger."""
    for name in names:
        os.utime(tmp_path / "in" / f"{name}.wav", (1, 1))
    return [Job(tmp_path / "in" / f"{name}.wav", tmp_path / "out" / f"{name}.txt") for name in names]


def test_other_content_another_output_and_other_options_are_done_again(tmp_path: Path) -> None:
    worked(tmp_path, "a", "b", "c")
    (tmp_path / "in" / "a.wav").write_text("says A")
    (tmp_path / "out" / "b.txt").write_text("changed by hand")
    jobs = [Job(tmp_path / "in" / f"{name}.wav", tmp_path / "out" / f"{name}.txt") for name in "abc"]
    again = run_batch(jobs, CopyWork(), BatchOptions(1, tmp_path / "out"))
    assert states(again) == {"a": JobState.DONE, "b": JobState.DONE, "c": JobState.SKIPPED}
    assert made_in(tmp_path / "out") == {"a": "copy says A", "b": "copy says b", "c": "copy says c"}
    other = run_batch(jobs, CopyWork("other"), BatchOptions(1, tmp_path / "out"))
    assert {*states(other).values()} == {JobState.DONE}


def test_a_record_that_was_cut_off_counts_as_far_as_it_goes(tmp_path: Path) -> None:
    worked(tmp_path, "a", "b")
    record = tmp_path / "out" / RECORD
    record.write_bytes(record.read_bytes()[:-20])
    assert states(worked(tmp_path, "a", "b")) == {"a": JobState.SKIPPED, "b": JobState.DONE}
    jobs = [Job(tmp_path / "in" / f"{n}.wav", tmp_path / "out" / f"{n}.txt") for n in "ab"]
    assert {*states(run_batch(jobs, CopyWork(), BatchOptions(1, tmp_path / "out"))).values()} == {JobState.SKIPPED}


def test_a_full_disk_ends_the_batch_and_what_was_finished_stays(tmp_path: Path) -> None:
    with pytest.raises(
        BatchError, match=r"full\.wav: .*the disk is full, so the batch ends here: free some space, and"
    ):
        worked(tmp_path, "a", "full", "z", n_processes=2)
    assert {*made_in(tmp_path / "out")} <= {"a", "z"}
    (tmp_path / "in" / "full.wav").rename(tmp_path / "in" / "b.wav")
    jobs = [Job(tmp_path / "in" / f"{n}.wav", tmp_path / "out" / f"{n}.txt") for n in "abz"]
    again = states(run_batch(jobs, CopyWork(), BatchOptions(1, tmp_path / "out")))
    assert again["b"] is JobState.DONE


def test_a_folder_takes_one_batch_at_a_time(tmp_path: Path) -> None:
    with (
        FolderLock(tmp_path / "out"),
        pytest.raises(
            BatchError, match=rf"out: another batch \(process {os.getpid()} on .*; wait until it has ended"
        ),
    ):
        worked(tmp_path, "a")
    worked(tmp_path, "a")
    assert not (tmp_path / "out" / LOCK).exists()


def test_a_batch_that_is_cancelled_leaves_whole_files(tmp_path: Path) -> None:
    jobs = jobs_in(tmp_path, "a", "waits", "waits-too", "z")
    options = BatchOptions(2, tmp_path / "out")

    def go_on(_progress: BatchProgress) -> bool:
        return not [*(tmp_path / "in").glob("*.waiting")]

    with pytest.raises(Cancelled):
        run_batch(jobs, CopyWork(), options, on_progress=go_on)
    found = made_in(tmp_path / "out")
    assert {*found} <= {"a", "z"}
    assert all(content == f"copy says {name}" for name, content in found.items())
    rest = [job for job in jobs if "waits" not in job.source.name]
    assert all(s in JobState for s in states(run_batch(rest, CopyWork(), options)).values())


def batch_of(tmp_path: Path, *names: str, **options: Any) -> "subprocess.Popen[str]":
    """Start a program that works through files by two processes."""
    jobs_in(tmp_path, *names)
    code = (
        "from pathlib import Path\n"
        "from phonemeengine.batch.runner import BatchOptions, run_batch\n"
        "from phonemeengine.batch.work import Job\n"
        "from tests.fakes.batch_works import CopyWork\n"
        "if __name__ == '__main__':\n"
        f"    jobs = [Job(Path('in', f'{{n}}.wav'), Path('out', f'{{n}}.txt')) for n in {names}]\n"
        "    run_batch(jobs, CopyWork(), BatchOptions(2, Path('out')))\n"
    )
    (tmp_path / "batch.py").write_text(code)
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(ROOT), str(ROOT / "engine")])}
    return subprocess.Popen([sys.executable, "batch.py"], cwd=tmp_path, env=environment, text=True, **options)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no process groups that a signal reaches")
def test_ctrl_c_leaves_whole_files(tmp_path: Path) -> None:
    batch = batch_of(tmp_path, "a", "waits", stderr=subprocess.PIPE, start_new_session=True)
    signs = tmp_path / "in" / "waits.waiting", tmp_path / "out" / "a.txt"
    wait_for(lambda: batch.poll() is not None or all(sign.exists() for sign in signs))
    assert batch.poll() is None
    os.killpg(batch.pid, signal.SIGINT)
    said = batch.communicate(timeout=60)[1]
    assert said.splitlines()[-1] == "KeyboardInterrupt"
    assert "SpawnProcess" not in said
    assert made_in(tmp_path / "out") == {"a": "copy says a"}


def test_processes_end_with_the_program_that_is_killed(tmp_path: Path) -> None:
    names = ("holds-a", "holds-b")
    batch = batch_of(tmp_path, *names, stdout=subprocess.PIPE)
    assert batch.stdout is not None
    assert {batch.stdout.readline().strip() for _ in names} == set(names)
    batch.kill()
    assert batch.communicate(timeout=120)[0] == ""  # ends when the last process has let it go


def test_a_program_that_works_for_another_one_ends_with_its_input() -> None:
    code = "import threading, phonemeengine.execution as p; p.end_with_input(); threading.Event().wait()"
    environment = os.environ | {"PYTHONPATH": str(ROOT / "engine")}
    process = subprocess.Popen([sys.executable, "-c", code], env=environment, stdin=subprocess.PIPE)
    assert process.stdin is not None
    process.stdin.close()
    assert process.wait(timeout=120) == 1


def test_progress_counts_files_and_sound(tmp_path: Path) -> None:
    seen: list[BatchProgress] = []

    def show(progress: BatchProgress) -> bool:
        seen.append(progress)
        return True

    run_batch(jobs_in(tmp_path, "a", "b", "fails"), CopyWork(), BatchOptions(1, tmp_path / "out"), on_progress=show)
    assert (seen[0].n_files, seen[0].share) == (3, 0.0)
    assert (seen[-1].n_done, seen[-1].n_failed, seen[-1].analysed, seen[-1].share) == (2, 1, 2 * SECONDS, 1.0)
    shares = [progress.share for progress in seen]
    assert shares == sorted(shares)
    assert seen[-1].speed == pytest.approx(2 * SECONDS / seen[-1].elapsed)


def test_what_a_dead_process_left_is_swept_away(tmp_path: Path) -> None:
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "a.txt.0123abcd.part").write_text("half")
    (tmp_path / "out" / "mine.txt.0123abcd.part").write_text("of somebody else")
    worked(tmp_path, "a")
    assert sorted(path.name for path in (tmp_path / "out").glob("*.part")) == ["mine.txt.0123abcd.part"]


def test_work_that_cannot_be_opened_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ExportError, match="what is needed cannot be opened"):
        worked(tmp_path, "a", "b", n_processes=2, word="closed")


def test_two_files_that_would_be_one_are_told_apart(tmp_path: Path) -> None:
    jobs = jobs_in(tmp_path, "a", "b")
    outcomes = run_batch([jobs[0], Job(jobs[1].source, jobs[0].target)], CopyWork())
    assert [outcome.state for outcome in outcomes] == [JobState.DONE, JobState.FAILED]
    assert outcomes[1].words == "b.wav: its file a.txt is already that of a.wav; rename one of them"


@pytest.mark.skipif(sys.platform == "win32", reason="Windows cannot write the name of the sound")
def test_a_name_that_cannot_be_written_is_told_and_the_others_go_on(tmp_path: Path) -> None:
    jobs = jobs_in(tmp_path, "a", "why?", "z" * 245)
    jobs[2] = Job(jobs[2].source, tmp_path / "out" / ("z" * 300))
    why, long = run_batch(jobs, CopyWork(), BatchOptions(1, tmp_path / "out"))[1:]
    assert (why.state, long.state) == (JobState.DONE, JobState.FAILED)
    assert why.notes[0][1].startswith("not every system can write this name; rename the sound before")
    assert "its file cannot be written (" in long.words
