"""Averaged spectra: the running one, and curves loaded to compare with."""

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr_noop
from phonemeengine.analyser import Analysis
from phonemeengine.inspection.averaged_spectrum import (
    AveragedSpectrum,
    SpectrumAverage,
    distance_of,
    load_averaged_spectrum,
    save_averaged_spectrum,
)
from phonemeengine.settings import FRAME_PERIOD, AnalysisSettings


class AveragesModel(QObject):
    """The mean spectrum since Play, Record or Clear, through one front end, and named curves beside it.

    Signals
    -------
    curves_changed : a curve was added or removed.

    Attributes
    ----------
    settings : of all that is in the running mean; None while that is empty.
    """

    curves_changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.curves: list[AveragedSpectrum] = []
        self.settings: AnalysisSettings | None = None
        self._average = SpectrumAverage()
        self._cause = self._sound = ""
        self._from = 0.0

    @property
    def n_frames(self) -> int:
        """Frames in the running mean."""
        return self._average.n_frames

    @property
    def since(self) -> str:
        """What the running mean begins with, and where in which sound; empty while it is empty."""
        return f"{self._cause} at {self._from:.2f} s of {self._sound}" if self.n_frames else ""

    def begin(self, cause: str, sound: str) -> None:
        """Begin the running mean anew, of a sound of that name, and remember why, in English; loaded curves stay."""
        self._cause, self._sound = cause, sound
        self.settings = None
        self._average.clear()

    def add(self, analysis: Analysis) -> None:
        """Take in a block of frames; those that other filters shaped begin a new mean."""
        known, given = self.settings, analysis.settings
        if known is not None and given is not known and given.front_end() != known.front_end():
            self.begin(tr_noop("change of the filters"), self._sound)
        if self.settings is None:
            self._from = analysis.start * FRAME_PERIOD
        self.settings = given
        self._average.add(analysis.linear_spectra)

    def current(self, name: str = "now") -> AveragedSpectrum:
        """Return the running mean."""
        front_end = self.settings.front_end() if self.settings is not None else ""
        return self._average.curve(name, front_end, self.since)

    def load(self, path: Path) -> None:
        """Load a curve beside the others; EngineError leaves them as they are."""
        self.add_curve(load_averaged_spectrum(path))

    def add_curve(self, curve: AveragedSpectrum) -> None:
        """Show another curve beside the others."""
        self.curves.append(curve)
        self.curves_changed.emit()

    def save(self, path: Path) -> None:
        """Save the running mean under the file's name, and keep it as a curve."""
        curve = self.current(path.stem)
        save_averaged_spectrum(curve, path)
        self.add_curve(curve)

    def remove(self, k: int) -> None:
        """Take curve `k` away."""
        del self.curves[k]
        self.curves_changed.emit()

    def distances(self) -> list[float]:
        """Return the difference in shape of each loaded curve from the running mean, dB; NaN while that is empty."""
        current = self.current()
        if not self.n_frames:
            return [float("nan")] * len(self.curves)
        return [distance_of(curve, current) for curve in self.curves]
