"""A batch: every file that is to be made is made, by this process, by several, or by a cluster."""

import logging
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from contextlib import ExitStack, closing
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Protocol

from phonemeengine.batch.order import Pool, failed, n_cores, order_of, worked_through
from phonemeengine.batch.record import BatchRecord, FolderLock, sweep
from phonemeengine.batch.work import Act, Job, JobState, Outcome, Work, fingerprint_of
from phonemeengine.errors import BatchError
from phonemeengine.execution import Cancelled
from phonemeengine.storage.files import printable, printable_name

WORTH_A_POOL = 16 << 20
"""Bytes of sound from which on processes are started, unless their number is given."""
CHUNK_BYTES, CHUNK_FILES = 4 << 20, 32
"""What a process is given at a time at most, unless a single file is larger."""
CHUNKS_EACH = 4
"""How often a process is given something at least, so that all of them end at the same time."""
TICK = 0.2
"""Seconds after which progress is reported, at most."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class BatchOptions:
    """How a batch is worked through.

    Attributes
    ----------
    jobs : processes at a time; None for all cores, where the work is long enough.
    folder : where all outputs go, in which it is noted what was done, so that it is not done twice; None notes
        nothing.
    cluster : the address of the scheduler of a Dask cluster, which works in place of this machine.
    """

    jobs: int | None = None
    folder: Path | None = None
    cluster: str | None = None


@dataclass
class BatchProgress:
    """How far a batch is.

    Attributes
    ----------
    n_files, n_bytes : all that was asked for, but what was done before.
    n_done, n_skipped, n_failed : files that were made, were made before, and could not be.
    done_bytes : of the sounds that were worked through; of those at hand, the part that was.
    analysed : seconds of sound in files that were made.
    elapsed : seconds since the beginning.
    at_hand : files that are worked on now, as far as that is known.
    """

    n_files: int = 0
    n_bytes: int = 0
    n_done: int = 0
    n_skipped: int = 0
    n_failed: int = 0
    done_bytes: float = 0.0
    analysed: float = 0.0
    elapsed: float = 0.0
    at_hand: tuple[Job, ...] = ()

    @property
    def speed(self) -> float:
        """How many times as fast as the sound lasts."""
        return self.analysed / max(self.elapsed, 1e-9)

    @property
    def share(self) -> float:
        """How much is done, 0..1."""
        return min(1.0, self.done_bytes / self.n_bytes) if self.n_bytes else 1.0


class Crew(Protocol):
    """Who works: processes of this machine, or a cluster; see `Pool`."""

    most_given: int
    deaths: tuple[type[Exception], ...]

    def give(self, jobs: Sequence[Job]) -> Future[list[Outcome]]: ...  # noqa: D102
    def result_of(self, future: Future[list[Outcome]]) -> list[Outcome]: ...  # noqa: D102
    def share_of(self, future: Future[list[Outcome]]) -> float: ...  # noqa: D102
    def restart(self) -> None: ...  # noqa: D102
    def stop(self) -> None: ...  # noqa: D102
    def close(self) -> None: ...  # noqa: D102


def run_batch(
    jobs: Iterable[Job],
    work: Work,
    options: BatchOptions | None = None,
    *,
    on_outcome: Callable[[Outcome], object] = lambda _: None,
    on_progress: Callable[[BatchProgress], bool] = lambda _: True,
) -> list[Outcome]:
    """Make the outputs of all files; return what became of each, in their order.

    A file that fails stops no other. Of each output, there is the whole or what was there before. A process that
    dies is replaced, and what it worked on is tried again, each file alone. A script that uses several processes
    starts below ``if __name__ == "__main__":``, as `multiprocessing` requires.

    Parameters
    ----------
    jobs : the files.
    work : what is done to them.
    options : how.
    on_outcome : told of each file, as soon as something became of it.
    on_progress : told how far it is, a few times a second, and whether to go on is its answer.

    Raises
    ------
    BatchError : another batch is at work in the folder, its disk is full, or the cluster cannot be used.
    EngineError : what the work needs cannot be opened.
    Cancelled : `on_progress` did not want to go on; what is complete stays, and is noted.
    """
    options = options or BatchOptions()
    with ExitStack() as stack:
        lock = None if options.folder is None else stack.enter_context(FolderLock(options.folder))
        record = None if options.folder is None else stack.enter_context(BatchRecord(options.folder))
        if record is not None:
            record.tidy()
        batch = _Batch([*jobs], work, options, on_outcome, on_progress, record)
        batch.plan()
        batch.work_through("" if lock is None else lock.token)
    return [batch.outcomes[k] for k in sorted(batch.outcomes)]


@dataclass
class _Batch:
    """A batch on its way."""

    jobs: list[Job]
    work: Work
    options: BatchOptions
    on_outcome: Callable[[Outcome], object]
    on_progress: Callable[[BatchProgress], bool]
    record: BatchRecord | None
    outcomes: dict[int, Outcome] = field(default_factory=dict)
    progress: BatchProgress = field(default_factory=BatchProgress)

    def __post_init__(self) -> None:
        self._began = time.monotonic()
        self._fingerprint = "" if self.record is None else self.work.fingerprint()
        self._numbers = {job: number for number, job in reversed([*enumerate(self.jobs)])}
        self._sizes: dict[Job, int] = {}
        self._todo: list[Job] = []

    # -- what is to be done -------------------------------------------------------------------------------

    def plan(self) -> None:
        """Find what is to be done, and tell what need not be, or cannot."""
        taken: dict[Path, Path] = {}
        for number, job in enumerate(self.jobs):
            key = "" if self.record is None else _key_of(job, self.work, self._fingerprint)
            outcome = _collision(job, taken) or (self.record and self.record.found(job, key))
            if outcome:
                self._take(number, outcome)
            else:
                earlier = None if self.record is None else self.record.made_earlier(job, key)
                self._todo.append(replace(job, earlier=earlier))
                self._sizes[job] = _size_of(job.source)
        self.progress.n_files, self.progress.n_bytes = len(self._todo), sum(self._sizes.values())
        self._sweep()

    def _sweep(self) -> None:
        """Remove what was left half by who died."""
        if self.record is not None:
            sweep({job.target for job in self.jobs if job.target is not None})

    # -- doing it -----------------------------------------------------------------------------------------

    def work_through(self, token: str) -> None:
        """Do all that is to be done."""
        self._tell()
        n_processes = self._n_processes()
        if not self._todo:
            return
        if self.options.cluster is None and n_processes == 1:
            self._work_alone()
            return
        if self.options.cluster is None:
            crew: Crew = Pool(n_processes, order_of(self.work), recorded=self.record is not None)
        else:
            from phonemeengine.batch.cluster import Cluster  # noqa: PLC0415 - an extra of its own

            crew = Cluster(self.options.cluster, order_of(self.work), self.options.folder, token)
        with closing(crew):
            _Shift(self, crew).work_through(self._chunks(crew.most_given))
        self._sweep()

    def _n_processes(self) -> int:
        asked = self.options.jobs
        if asked is None:
            asked = n_cores() if self.progress.n_bytes >= WORTH_A_POOL else 1
        return max(1, min(asked, len(self._todo)))

    def _work_alone(self) -> None:
        with self.work.opened() as act:
            for job in self._todo:
                self._work_on(act, job)

    def _work_on(self, act: Act, job: Job) -> None:
        before = self.progress.done_bytes

        def tell(share: float) -> bool:
            return self._tell(before + share * self._sizes[job], job)

        found = worked_through(act, [job], lambda _number: tell, recorded=self.record is not None)
        if not found:
            raise Cancelled
        self.take(found)

    def _chunks(self, most_given: int) -> Iterator[tuple[Job, ...]]:
        """Give files as processes are given them: the largest first, small ones together."""
        most = min(CHUNK_FILES, max(1, len(self._todo) // (CHUNKS_EACH * most_given)))
        chunk: list[Job] = []
        n_bytes = 0
        for job in sorted(self._todo, key=lambda job: -self._sizes[job]):
            if chunk and (len(chunk) >= most or n_bytes + self._sizes[job] > CHUNK_BYTES):
                yield tuple(chunk)
                chunk, n_bytes = [], 0
            chunk.append(job)
            n_bytes += self._sizes[job]
        yield tuple(chunk)

    # -- what came of it ----------------------------------------------------------------------------------

    def take(self, outcomes: Sequence[Outcome]) -> None:
        """Note and tell what became of files.

        Raises
        ------
        BatchError : nothing more can be written.
        Cancelled : it shall not go on.
        """
        self.note(outcomes)
        fatal = next((outcome for outcome in outcomes if outcome.is_fatal), None)
        if fatal is not None:
            if len(self.jobs) == 1:
                raise BatchError(fatal.words)
            raise BatchError(
                f"{fatal.words}; the disk is full, so the batch ends here: free some space, and start it again, "
                "which goes on where it was"
            )
        if not self._tell():
            raise Cancelled

    def note(self, outcomes: Sequence[Outcome]) -> None:
        """Note what became of files."""
        if self.record is not None:
            done = [o for o in outcomes if o.state is JobState.DONE and o.job.target is not None]
            self.record.add((outcome, _key_of(outcome.job, self.work, self._fingerprint)) for outcome in done)
        for outcome in outcomes:
            self.progress.done_bytes += self._sizes[outcome.job]
            self._take(self._numbers[outcome.job], outcome)

    def _take(self, number: int, outcome: Outcome) -> None:
        self.outcomes[number] = outcome
        progress = self.progress
        progress.n_done += outcome.state is JobState.DONE
        progress.n_skipped += outcome.state is JobState.SKIPPED
        progress.n_failed += outcome.state is JobState.FAILED
        if outcome.state is JobState.DONE:
            progress.analysed += outcome.made.duration
        if outcome.words:
            _log.warning("%s", outcome.words)
        self.on_outcome(outcome)

    def tell(self, futures: dict[Future[list[Outcome]], tuple[Job, ...]], crew: Crew) -> bool:
        """Tell how far it is, with what is at hand."""
        done, at_hand = self.progress.done_bytes, []
        for future, chunk in futures.items():
            n_done = crew.share_of(future)
            whole = int(n_done)
            done += sum(self._sizes[job] for job in chunk[:whole])
            if whole < n_done < len(chunk):
                done += (n_done - whole) * self._sizes[chunk[whole]]
                at_hand.append(chunk[whole])
        return self._tell(done, *at_hand)

    def _tell(self, done_bytes: float | None = None, *at_hand: Job) -> bool:
        self.progress.elapsed = time.monotonic() - self._began
        shown = self.progress.done_bytes if done_bytes is None else done_bytes
        return self.on_progress(replace(self.progress, done_bytes=shown, at_hand=at_hand))


class _Shift:
    """A crew works through the chunks of a batch."""

    def __init__(self, batch: _Batch, crew: Crew) -> None:
        self._batch, self._crew = batch, crew
        self._given: dict[Future[list[Outcome]], tuple[Job, ...]] = {}
        self._suspects: list[tuple[Job, ...]] = []

    def work_through(self, chunks: Iterator[tuple[Job, ...]]) -> None:
        """Give out all chunks, and take what comes of them."""
        try:
            self._give_out(chunks, self._crew.most_given)
            while self._given or self._suspects:
                if self._given:
                    self._wait()
                if self._suspects and not self._given:
                    self._try_again()
                self._give_out(chunks, self._crew.most_given)
        except BaseException:
            self._end()
            raise

    def _give_out(self, chunks: Iterator[tuple[Job, ...]], most: int) -> None:
        while not self._suspects and len(self._given) < most and (chunk := next(chunks, None)):
            try:
                self._given[self._crew.give(chunk)] = chunk
            except self._crew.deaths:
                self._suspects.append(chunk)

    def _wait(self) -> None:
        """Wait until something is done, or for a moment; take what is."""
        done, _ = wait(self._given, TICK, FIRST_COMPLETED)
        for future in done:
            chunk = self._given.pop(future)
            try:
                self._batch.take(self._crew.result_of(future))
            except self._crew.deaths:
                self._suspects.append(chunk)
        if not self._batch.tell(self._given, self._crew):
            raise Cancelled

    def _try_again(self) -> None:
        """Work on what was at hand when a process died, one by one, so that it shows which file it is."""
        suspects, self._suspects = self._suspects, []
        self._crew.restart()
        for job in (job for chunk in suspects for job in chunk):
            # Twice, as the first death may have been another file's.
            if not (self._survives(job) or self._survives(job)):
                name = printable_name(job.source)
                words = f"{name}: the process that worked on it died, twice; try it alone, or leave it out"
                self._batch.take([failed(job, words)])

    def _survives(self, job: Job) -> bool:
        """Return whether the process that works on nothing but a file lives on; what came of the file is taken."""
        sweep({job.target} if job.target is not None else set())
        future = self._crew.give((job,))
        self._given[future] = (job,)
        while future in self._given:
            self._wait()
        if not self._suspects:
            return True
        self._suspects.clear()
        self._crew.restart()
        sweep({job.target} if job.target is not None else set())
        return False

    def _end(self) -> None:
        """End all work; note what is complete."""
        self._crew.stop()
        while pending := [future for future in self._given if not future.done()]:  # `wait` knows no cancelled ones
            wait(pending, TICK)
        for future in self._given:
            if not future.cancelled() and future.exception() is None:
                self._batch.note(future.result())


def in_the_way(jobs: Iterable[Job], work: Work, folder: Path | None) -> list[Job]:
    """Return those whose target is there already, and is not known to be what the same work made.

    Parameters
    ----------
    folder : where it is noted what was done; None where it is not.
    """
    record = None if folder is None else BatchRecord(folder)
    there = [job for job in jobs if job.target is not None and job.target.is_file()]
    if record is None or not there:
        return there
    fingerprint = work.fingerprint()
    return [job for job in there if not record.made_earlier(job, _key_of(job, work, fingerprint))]


def _key_of(job: Job, work: Work, fingerprint: str) -> str:
    """Return what tells what is asked of a file; its name, which outputs may hold, goes into it."""
    return fingerprint_of(fingerprint, job.source.name, work.known_of(job))


def _collision(job: Job, taken: dict[Path, Path]) -> Outcome | None:
    """Return that the output of a job is that of another one already; else remember it."""
    if job.target is None:
        return None
    if job.target in taken:
        words = f"its file {job.target.name} is already that of {taken[job.target].name}; rename one of them"
        return failed(job, f"{printable(job.source.name)}: {printable(words)}")
    taken[job.target] = job.source
    return None


def _size_of(path: Path) -> int:
    try:
        return max(1, path.stat().st_size)
    except (OSError, ValueError):
        return 1
