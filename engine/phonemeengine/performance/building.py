"""Building a table of a folder of recordings: one recording after the other, and whole or not at all."""

import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from phonemeengine.errors import AudioError, CorpusError, PerformanceError
from phonemeengine.performance.corpus import Corpus, find_recordings, read_performance
from phonemeengine.performance.recording import Performance
from phonemeengine.performance.table_file import TableAbout, check_fits, write_table
from phonemeengine.progress import Progress, no_progress, report_progress

MOST_NOTES = 1000
"""Sentences that are kept."""


@dataclass(frozen=True)
class BuiltTable:
    """A table that was built.

    Attributes
    ----------
    about : what it holds.
    left_out : why recordings were left out, a sentence for each.
    notes : what is odd about the others, a sentence each.
    """

    about: TableAbout
    left_out: tuple[str, ...]
    notes: tuple[str, ...]


def build_table(
    folder: str | os.PathLike[str], path: str | os.PathLike[str], *, name: str | None = None,
    progress: Progress = no_progress,
) -> BuiltTable:  # fmt: skip
    """Build a table of a folder of recordings; see `find_recordings` for what it holds.

    A recording that cannot be used is left out. It takes no more memory than its largest recording does.

    Parameters
    ----------
    path : the table; what is there stays until the new one is complete.
    name : what the table is called; as the folder, where it is None.

    Raises
    ------
    CorpusError : there is no recording in the folder.
    PerformanceError : no recording can be used, or the table cannot be written.
    Cancelled : it was not wanted any more; nothing has changed.
    """
    corpus = find_recordings(Path(folder))
    reading = _CorpusReading(corpus, progress)
    about = write_table(path, reading.performances(), name=name or corpus.name, folder=folder)
    return BuiltTable(about, tuple(reading.left_out), (*corpus.notes, *reading.notes))


class _CorpusReading:
    """Reads the recordings of a corpus, and remembers what is to be said of them."""

    def __init__(self, corpus: Corpus, progress: Progress) -> None:
        self.left_out: list[str] = []
        self.notes: list[str] = []
        self._corpus, self._progress = corpus, progress

    def performances(self) -> Iterator[Performance]:
        """Return those that can be read, one after the other.

        Raises
        ------
        PerformanceError : none can.
        """
        first: Performance | None = None
        for k, recording in enumerate(self._corpus.recordings):
            report_progress(self._progress, k / len(self._corpus.recordings))
            try:
                performance, notes = read_performance(recording, synthetic=self._corpus.synthetic)
                first = first or performance
                check_fits(performance, first)
            except (AudioError, CorpusError, PerformanceError) as error:
                self.left_out.append(str(error))
                continue
            self.notes += notes[: MOST_NOTES - len(self.notes)]
            yield performance
        if first is None:
            raise PerformanceError(f"no recording can be used; of the first one: {self.left_out[0]}")
        report_progress(self._progress, 1.0)
