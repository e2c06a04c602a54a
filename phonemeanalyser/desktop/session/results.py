"""What was found in the sound so far: the last minute, the averaged spectrum, and why the newest frame is so."""

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.session.curves import RunningAverage
from phonemeanalyser.desktop.session.history import History
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.analyser import Analysis, analyse_range
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import EngineError
from phonemeengine.execution import Progress
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import Trace
from phonemeengine.settings import FRAME_PERIOD, Channel

AGAIN = 1000
"""Frames that are analysed anew at most when the preset changes while nothing plays: ten seconds."""


class AnalysisResults(QObject):
    """Gathers analyses.

    Signals
    -------
    cleared : everything was forgotten.
    rewritten : the columns of the history from this one on are others now.
    error : a sentence for the user.
    """

    cleared = Signal()
    rewritten = Signal(int)
    error = Signal(str)

    def __init__(self, preset: PresetModel) -> None:
        super().__init__()
        self.history = History()
        self.averages = RunningAverage()
        self._preset = preset
        self._work = TaskQueue(self.error.emit)
        self._work.idle.connect(self._begin_wanted)
        self._wanted: Callable[[], None] | None = None
        self._unexplained: Preset | None = None  # its recogniser could not say why, which was told

    def add(self, analysis: Analysis) -> None:
        """Take in a block of analysed frames."""
        self.history.append(analysis)
        self.averages.add(analysis)

    @property
    def busy(self) -> bool:
        """Whether what was played last is being analysed anew."""
        return self._work.busy

    def clear(self, cause: str, sound: str) -> None:
        """Forget everything, since another sound begins, or the user asked for it; see `RunningAverage.begin`."""
        self.averages.begin(cause, sound)
        self._wanted = None
        self._work.cancel()
        self.history.clear()
        self.cleared.emit()

    def add_file_start(self, path: Path, channel: Channel, n_frames: int) -> None:
        """Gather the first frames of a file."""
        for analysis in _analyses(path, channel, (0, n_frames), self._preset.in_force):
            self.add(analysis)

    def analyse_again(self, path: Path, channel: Channel) -> None:
        """Analyse what was played last of a file anew with the preset in force, in the background.

        While that lasts, a newer preset waits, so that something is shown while a slider moves on.
        """
        self._wanted = partial(self._begin_again, path, channel)
        if not self._work.busy:
            self._begin_wanted()

    def _begin_wanted(self) -> None:
        if self._wanted is not None:
            self._wanted()

    def _begin_again(self, path: Path, channel: Channel) -> None:
        self._wanted = None
        preset, n, run = self._preset.in_force, self.history.n, self.history.newest_run(AGAIN)

        def analyse(_progress: Progress) -> list[Analysis]:
            return [*_analyses(path, channel, run, preset)]

        def show(found: list[Analysis]) -> None:
            if (self.history.n, self.history.newest_run(AGAIN)) == (n, run):  # else the sound has gone on
                column = n - (run[1] - run[0])
                for analysis in found:
                    self.history.rewrite(column, analysis)
                    column += len(analysis)
                self.rewritten.emit(n - (run[1] - run[0]))

        if run[0] < run[1]:
            self._work.submit(analyse, show)

    def close(self) -> None:
        """End all work."""
        self._wanted = None
        self._work.close(CLOSE_TIMEOUT)

    def show_before(self, path: Path, channel: Channel, seconds: float) -> None:
        """Show the seconds of a file before a time after what was played, from which a gap parts them.

        They are not played, so they do not count, and they give way to those before the next place that is sought.
        """
        column, last = self.history.take_back_unheard(), round(seconds / FRAME_PERIOD)
        for analysis in self._told_analyses(path, channel, max(0, last - AGAIN), last):
            self.history.append(analysis, heard=False)
        self.rewritten.emit(column)

    def explain(self) -> Trace | None:
        """Return why the newest frame was recognised as it was."""
        newest = self.history.newest
        if newest is None:
            return None
        try:
            return self._preset.recogniser.explain(newest.features, len(newest) - 1)
        except EngineError as error:
            if self._preset.preset is not self._unexplained:
                self._unexplained = self._preset.preset
                self.error.emit(str(error))
            return None

    def _told_analyses(self, path: Path, channel: Channel, first: int, last: int) -> Iterator[Analysis]:
        """Analyse frames that are not played; a damaged file is reported."""
        try:
            yield from _analyses(path, channel, (first, last), self._preset.in_force)
        except EngineError as error:
            self.error.emit(str(error))


def _analyses(path: Path, channel: Channel, run: tuple[int, int], preset: Preset) -> Iterator[Analysis]:
    """Analyse the frames of a file from one to before another."""
    with SoundReader(path, channel) as reader:
        yield from analyse_range(reader, *run, preset, pitch=True)
