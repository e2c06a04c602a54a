"""Averaged spectra: the running one, and curves loaded to compare with."""

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from engine.analyser import Analysis
from engine.curves import Curve, SpectrumAverage, distance_of, load_curve, save_curve
from phonemeanalyser.models.history import shown_spectra


class AveragesModel(QObject):
    """The mean spectrum since Play or Clear, and named curves beside it.

    Signals
    -------
    curves_changed : a curve was added or removed.
    """

    curves_changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.curves: list[Curve] = []
        self._average = SpectrumAverage()

    @property
    def n_frames(self) -> int:
        """Frames in the running mean."""
        return self._average.n_frames

    def add(self, analysis: Analysis) -> None:
        """Take in a block of frames."""
        self._average.add(shown_spectra(analysis))

    def clear(self) -> None:
        """Begin the running mean anew; loaded curves stay."""
        self._average.clear()

    def current(self, name: str = "now", front_end: str = "") -> Curve:
        """Give the running mean."""
        return self._average.curve(name, front_end)

    def load(self, path: Path) -> None:
        """Load a curve beside the others; EngineError leaves them as they are."""
        self.curves.append(load_curve(path))
        self.curves_changed.emit()

    def save(self, path: Path, front_end: str) -> None:
        """Save the running mean under the file's name, and keep it as a curve."""
        curve = self.current(path.stem, front_end)
        save_curve(curve, path)
        self.curves.append(curve)
        self.curves_changed.emit()

    def remove(self, k: int) -> None:
        """Take curve `k` away."""
        del self.curves[k]
        self.curves_changed.emit()

    def distances(self) -> list[float]:
        """Give the difference in shape of each loaded curve from the running mean, dB; NaN while that is empty."""
        current = self.current()
        if not self.n_frames:
            return [float("nan")] * len(self.curves)
        return [distance_of(curve, current) for curve in self.curves]
