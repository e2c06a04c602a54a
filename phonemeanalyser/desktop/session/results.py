"""What was found in the sound so far: the last minute, the averaged spectrum, and why the newest frame is so."""

from collections.abc import Iterator
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.session.averages import AveragesModel
from phonemeanalyser.desktop.session.history import History
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeengine.analyser import Analysis, analyse_range
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import EngineError
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.recognition import Trace
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
        self.averages = AveragesModel()
        self._preset = preset
        self._unexplained: Preset | None = None  # its recogniser could not say why, which was told

    def add(self, analysis: Analysis) -> None:
        """Take in a block of analysed frames."""
        self.history.append(analysis)
        self.averages.add(analysis)

    def clear(self) -> None:
        """Forget sonagram and extremes."""
        self.history.clear()
        self.cleared.emit()

    def add_file_start(self, path: Path, channel: Channel, n_frames: int) -> None:
        """Gather the first frames of a file."""
        for analysis in self._analyses(path, channel, 0, n_frames):
            self.add(analysis)

    def analyse_again(self, path: Path, channel: Channel) -> None:
        """Analyse what was heard last of a file anew with the preset in force."""
        first, last = self.history.newest_run(AGAIN)
        column = rewritten = self.history.n - (last - first)
        for analysis in self._told_analyses(path, channel, first, last):
            self.history.rewrite(column, analysis)
            column += len(analysis)
        if first < last:
            self.rewritten.emit(rewritten)

    def show_before(self, path: Path, channel: Channel, seconds: float) -> None:
        """Show the seconds of a file before a time after what was heard, from which a gap parts them.

        Nobody hears them, so they do not count, and they give way to those before the next place that is sought.
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
        """Analyse frames that nobody hears; a damaged file is said."""
        try:
            yield from self._analyses(path, channel, first, last)
        except EngineError as error:
            self.error.emit(str(error))

    def _analyses(self, path: Path, channel: Channel, first: int, last: int) -> Iterator[Analysis]:
        with SoundReader(path, channel) as reader:
            yield from analyse_range(reader, first, last, self._preset.in_force, pitch=True)
