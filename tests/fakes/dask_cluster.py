"""A Dask cluster of processes of this machine: a scheduler, and workers that may be killed."""

import os
import signal
import socket
import subprocess
import sys
from pathlib import Path
from typing import Self

from tests.conftest import ROOT
from tests.waiting import wait_for

SECONDS = 60.0
"""For a process to come up, which only a hang reaches."""
NO_RETRY = {"DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "0"}
"""Have the scheduler give up a task as soon as one worker died of it."""


class DaskCluster:
    """A scheduler and some workers, of one thread each.

    Attributes
    ----------
    address : of the scheduler.
    """

    def __init__(self, folder: Path, n_workers: int, **environment: str) -> None:
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self._port = free.getsockname()[1]
        self.address = f"tcp://127.0.0.1:{self._port}"
        self._folder, self._n_workers = folder, n_workers
        self._environment = os.environ | environment
        self._environment["PYTHONPATH"] = os.pathsep.join([str(ROOT), str(ROOT / "engine")])
        self._processes: list[subprocess.Popen[bytes]] = []
        self._n_begun = 0

    def __enter__(self) -> Self:
        self.begin()
        return self

    def __exit__(self, *_error: object) -> None:
        self.kill()

    def begin(self) -> None:
        """Start the scheduler and the workers."""
        log = self._start("dask_scheduler", "--host", "127.0.0.1", "--port", str(self._port), "--no-dashboard")
        _wait_for(log, "Scheduler at:")
        for _ in range(self._n_workers):
            log = self._start("dask_worker", self.address, "--nthreads", "1", "--no-dashboard", "--host", "127.0.0.1")
            _wait_for(log, "Registered to:")

    def kill_scheduler(self) -> None:
        """Let the scheduler die at once."""
        _kill(self._processes[0])

    def kill_worker(self, number: int) -> None:
        """Let a worker die at once, and the nanny that would start it again."""
        _kill(self._processes[1 + number])

    def kill(self) -> None:
        """Let all die."""
        for process in self._processes:
            _kill(process)
        self._processes.clear()

    def _start(self, module: str, *words: str) -> Path:
        self._n_begun += 1
        log = self._folder / f"{module}-{self._n_begun}.log"
        with log.open("wb") as file:
            self._processes.append(
                subprocess.Popen(
                    [sys.executable, "-m", f"distributed.cli.{module}", *words, "--local-directory", self._folder]
                    if module == "dask_worker"
                    else [sys.executable, "-m", f"distributed.cli.{module}", *words],
                    stdout=file,
                    stderr=file,
                    env=self._environment,
                    cwd=self._folder,
                    start_new_session=True,
                )
            )
        return log


def _kill(process: "subprocess.Popen[bytes]") -> None:
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        return
    process.wait(SECONDS)


def _wait_for(log: Path, words: str) -> None:
    wait_for(lambda: words in log.read_text(encoding="utf-8", errors="replace"), words)
