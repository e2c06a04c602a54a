"""An existing Dask cluster. The only module that imports distributed.

The scheduler gives out the same chunks of files as the processes of one machine are given, and gives them out again
where a worker dies. Every worker sees the files by the same paths or addresses.
"""

import asyncio
import logging
import platform
import threading
from collections.abc import Iterator, Sequence
from concurrent.futures import CancelledError, Future
from contextlib import contextmanager
from dataclasses import replace
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from phonemeengine import __version__
from phonemeengine.batch.order import Order, act_of, failed, worked_through
from phonemeengine.batch.record import holder_of
from phonemeengine.batch.work import Job, Outcome
from phonemeengine.errors import BatchError, EngineError
from phonemeengine.execution import keep_memory
from phonemeengine.storage.files import printable_name

PACKAGES = ("numpy", "scipy", "soundfile", "soxr")
"""What decides with the program what outputs are, to the last bit."""
CONNECTION_TIMEOUT = 10.0
"""Seconds in which a scheduler, and a first worker, must answer."""
FAREWELL = 2.0
"""Seconds in which a scheduler may answer that this program leaves."""
LEAST_GIVEN = 8
"""Chunks that a cluster has at least, which may grow meanwhile."""
WAITING = 4
"""Chunks that are given out for each thread of a worker."""


class Cluster:
    """A cluster that works through files.

    Parameters
    ----------
    address : of its scheduler, such as ``tcp://host:8786``.
    order : what is done.
    folder : of the outputs, which every worker must see; None where nothing is written.
    token : of the folder's lock.

    Attributes
    ----------
    most_given : chunks that are given out at a time.
    deaths : what a future raises where worker after worker died of it.

    Raises
    ------
    BatchError : there is no such cluster, or its workers are not like this program.
    """

    def __init__(self, address: str, order: Order, folder: Path | None, token: str) -> None:
        distributed = _imported()
        self.deaths: tuple[type[Exception], ...] = (distributed.KilledWorker,)
        self._address, self._folder, self._token = address, folder, token
        self._versions = versions()
        with _told(address):
            asyncio.run(_knock(address))
            self._client = distributed.Client(
                address, timeout=CONNECTION_TIMEOUT, set_as_default=False, direct_to_workers=False
            )
        try:
            self._check_workers()
            self._executor = self._client.get_executor(pure=False)
            # A preset with the real-time model has 17 MB, which are sent once: no reason for Dask to warn.
            with distributed.client.dask.config.set({"distributed.admin.large-graph-warning-threshold": "64MB"}):
                self._order = self._client.submit(_received, order, pure=False)
            threads = sum(self._client.nthreads().values())
        except BaseException:
            self._client.close()
            raise
        self.most_given = max(LEAST_GIVEN, WAITING * threads)

    def give(self, jobs: Sequence[Job]) -> Future[list[Outcome]]:
        """Have some files worked through."""
        with _told(self._address):
            given: Future[list[Outcome]] = self._executor.submit(
                work_through_chunk, self._order, jobs, self._versions, self._folder, self._token
            )
            return given

    def result_of(self, future: Future[list[Outcome]]) -> list[Outcome]:
        """Return what came of files that were given.

        Raises
        ------
        BatchError : the cluster has gone, or a worker cannot see the folder.
        """
        with _told(self._address):
            return future.result()

    def share_of(self, _future: Future[list[Outcome]]) -> float:
        """Return 0: the scheduler tells of nothing but whole chunks."""
        return 0.0

    def restart(self) -> None:
        """Do nothing: the scheduler has replaced who died."""

    def stop(self) -> None:
        """End all work as soon as may be; what is complete stays."""
        self._executor.shutdown(wait=False)

    def close(self) -> None:
        """Leave the cluster."""
        self._client.close(timeout=FAREWELL)

    def _check_workers(self) -> None:
        with _told(self._address):
            try:
                self._client.wait_for_workers(1, timeout=CONNECTION_TIMEOUT)
            except TimeoutError as error:
                raise BatchError(
                    f"{self._address}: the cluster has no workers; start one with: dask worker {self._address} "
                    "--nthreads 1"
                ) from error
            self._client.run(check_versions, self._versions)


def versions() -> dict[str, str]:
    """Return the versions of whatever decides what outputs are."""
    known = {"PhonemeAnalyser": __version__, "Python": ".".join(platform.python_version_tuple()[:2])}
    for name in PACKAGES:
        try:
            known[name] = version(name)
        except PackageNotFoundError:
            known[name] = "none"
    return known


def check_versions(theirs: dict[str, str]) -> None:
    """Refuse a worker whose versions differ from those of the sender of the work.

    Raises
    ------
    BatchError : there is one.
    """
    ours = versions()
    for name, other in theirs.items():
        if ours.get(name) != other:
            raise BatchError(
                f"the worker on {platform.node()} has {name} {ours.get(name)}, and this program {other}; install the "
                "same version on both"
            )


_working = threading.Lock()


def work_through_chunk(
    order: Order, jobs: Sequence[Job], theirs: dict[str, str], folder: Path | None, token: str
) -> list[Outcome]:
    """Work through some files, on a worker, one at a time however many threads it has.

    Raises
    ------
    BatchError : the worker has another version than the sender of the work, or another folder at that path.
    """
    check_versions(theirs)
    if folder is not None and holder_of(folder) != token:
        raise BatchError(
            f"{folder}: the worker on {platform.node()} does not see this folder; share it with all workers by the "
            "same path, or name an address such as s3://bucket/folder"
        )
    with _working:
        keep_memory()
        act = act_of(order)
        found = []
        for job in jobs:
            if _is_seen(job.source):
                found += worked_through(act, [job], lambda _: lambda _share: True, recorded=folder is not None)
            else:
                words = f"the worker on {platform.node()} cannot see it; share its folder by the same path"
                found.append(failed(job, f"{printable_name(job.source)}: {words}"))
            if found[-1].is_fatal:
                break
        return found


def _is_seen(source: Path) -> bool:
    try:
        return source.exists()
    except (OSError, ValueError):
        return False


def _received(order: Order) -> Order:
    """Give an order to the workers that need it; the scheduler has it done again where they die."""
    return replace(order)


async def _knock(address: str) -> None:
    """Reach a scheduler, before there is a client: one that reached none may hang when its memory is freed."""
    comm = await _imported().comm.connect(address, timeout=CONNECTION_TIMEOUT)
    await comm.close()


def _imported() -> Any:
    try:
        import distributed  # noqa: PLC0415 - an extra, which takes half a second
    except ImportError as error:
        raise BatchError(
            f"a cluster needs packages that cannot be loaded ({error}); install them with: pip install "
            "'phonemeanalyser[cluster]'"
        ) from error
    for name in [name for name in logging.root.manager.loggerDict if name.startswith("distributed")]:
        logging.getLogger(name).setLevel(logging.CRITICAL)  # what goes wrong is said in one sentence
    return distributed


@contextmanager
def _told(address: str) -> Iterator[None]:
    """Tell in one sentence that a cluster is not there, or has gone."""
    try:
        yield
    except EngineError:
        raise
    except CancelledError as error:
        raise BatchError(
            f"{address}: the cluster has gone; start it and the batch again, which goes on where it was"
        ) from error
    except ModuleNotFoundError as error:
        raise BatchError(
            f"{address}: a worker lacks the program ({error}); install phonemeanalyser {__version__} there"
        ) from error
    except (OSError, ValueError, RuntimeError, TypeError, AssertionError) as error:  # as distributed raises them
        reason = str(error).partition("\n")[0] or type(error).__name__
        raise BatchError(
            f"{address}: no cluster answers there ({reason}); start one, or correct the address"
        ) from error
