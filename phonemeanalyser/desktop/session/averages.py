"""The running averaged spectrum."""

from pathlib import Path

from phonemeanalyser.desktop.language import tr_noop
from phonemeengine.analyser import Analysis
from phonemeengine.inspection.averaged_spectrum import AveragedSpectrum, SpectrumAverage, save_averaged_spectrum
from phonemeengine.settings import FRAME_PERIOD, AnalysisSettings


class RunningAverage:
    """The mean spectrum since Play, Record or Clear, through one front end.

    Attributes
    ----------
    settings : of all that is in the running mean; None while that is empty.
    """

    def __init__(self) -> None:
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
        """Begin the running mean anew, of a sound of that name, and remember why, in English."""
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
        self._average.add(analysis.linear_spectra, analysis.frames.windows)

    def current(self, name: str = "now") -> AveragedSpectrum:
        """Return the running mean."""
        front_end = self.settings.front_end() if self.settings is not None else ""
        return self._average.curve(name, front_end, self.since)

    def save(self, path: Path) -> AveragedSpectrum:
        """Save the running mean under the file's name, and return it; EngineError says why not."""
        curve = self.current(path.stem)
        save_averaged_spectrum(curve, path)
        return curve
