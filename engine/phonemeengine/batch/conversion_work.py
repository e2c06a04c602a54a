"""Many sounds that are converted alike."""

import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from phonemeengine.audio.files import SoundReader
from phonemeengine.batch.fingerprint import fingerprint_of
from phonemeengine.batch.runner import BatchOptions, run_batch
from phonemeengine.batch.work import Act, Job, JobState, Made, Say
from phonemeengine.conversion import CONVERSIONS, check_options, convert, targets_of
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.table import load_table
from phonemeengine.presets.ears import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.progress import Progress, no_progress
from phonemeengine.settings import Channel


@dataclass(frozen=True)
class ConversionWork:
    """Turns sounds into files of a kind, as `convert` does; work for `run_batch`.

    Attributes
    ----------
    kind : see `CONVERSIONS`.
    preset : what is recognised with.
    options : how mouth cues are written.
    channel : what is recognised of files of several channels.
    overwrite : whether to replace whatever is there; files that the same work made, as noted, are replaced anyway.

    Raises
    ------
    ExportError, MouthError : there is no such kind, or it cannot do what the options say.
    """

    kind: str
    preset: Preset
    options: ExportOptions | None = None
    channel: Channel = Channel.MIX
    overwrite: bool = False

    def __post_init__(self) -> None:
        check_options(self.kind, self.options)

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        options = self.options or ExportOptions()
        table = load_table(options.table or FORMATS[self.kind].table) if CONVERSIONS[self.kind].moves_mouth else None
        mesh = None if options.mesh is None else Path(options.mesh)
        written = replace(options, table=None, mesh=mesh)
        return fingerprint_of("convert", self.kind, table, written, for_files(self.preset), self.channel)

    def known_of(self, _job: Job) -> str:
        """Return nothing: nothing is known of a file besides."""
        return ""

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Give what converts one file."""
        yield self._convert

    def _convert(self, job: Job, say: Say, progress: Progress) -> Made:
        assert job.target is not None
        with SoundReader(job.source, self.channel) as reader:
            duration = reader.duration
            for note in reader.notes:
                say(job.source.name, note)
        convert(
            job.source, job.target, self.kind, self.preset, self.options, channel=self.channel,
            overwrite=self.overwrite, earlier=job.earlier, progress=progress,
        )  # fmt: skip
        return Made(duration)


def convert_all(
    sounds: Iterable[str | os.PathLike[str]], folder: str | os.PathLike[str], kind: str, preset: Preset,
    options: ExportOptions | None = None, *, channel: Channel = Channel.MIX, overwrite: bool = False,
    processes: int | None = None, cluster: str | None = None, progress: Progress = no_progress,
) -> dict[Path, str]:  # fmt: skip
    """Turn sound files into files in a folder; return what was wrong with those that failed, a sentence each.

    What fails stops nothing, and what was done before and is unchanged is not done again. A script that has several
    processes work begins below ``if __name__ == "__main__":``, as `multiprocessing` wants it.

    Parameters
    ----------
    sounds : the files; a number tells the outputs of equal names apart.
    folder : where the new files go, and what was done is noted.
    kind, preset, options, channel, overwrite : as in `convert`.
    processes : files at a time; None for as many as there are cores, where that is worth it.
    cluster : the address of a Dask cluster's scheduler, which works in place of this machine.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    ExportError, MouthError : there is no such kind, or it cannot do what the options say.
    BatchError : another batch is at work in the folder, the disk is full, or the cluster cannot be used.
    Cancelled : `progress` did not want to go on; what is complete stays.
    """
    work, folder = ConversionWork(kind, preset, options, channel, overwrite), Path(folder)
    targets = targets_of([*map(Path, sounds)], folder, CONVERSIONS[kind].ending)
    jobs = [Job(source, target) for source, target in targets.items()]
    how = BatchOptions(processes, folder, cluster)
    outcomes = run_batch(jobs, work, how, on_progress=lambda found: progress(found.share))
    return {outcome.job.source: outcome.words for outcome in outcomes if outcome.state is JobState.FAILED}
