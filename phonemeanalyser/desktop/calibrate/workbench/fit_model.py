"""The fit of thresholds or limits to what is loaded, and a second preset to compare with."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.calibrate.workbench.workbench_model import WorkbenchModel
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.calibration.fits.fitting import FitReport, fit_preset
from phonemeengine.calibration.scores.comparison import PresetComparison, compare
from phonemeengine.calibration.scores.confusion import Confusion
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import CorpusScores, Predictions, group_scores_of
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.errors import EngineError
from phonemeengine.execution import Progress, subrange
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.spec import spec_of

MOST_SEGMENTS = 200
"""Stretches that are listed of each preset."""


class FitModel(QObject):
    """Fits in the background; what was found is accepted or refused.

    Signals
    -------
    changed : there is a report, or none.
    error : a sentence for the user.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, preset: PresetModel, workbench: WorkbenchModel) -> None:
        super().__init__()
        self.report: FitReport | None = None
        self._preset = preset
        self._workbench = workbench
        self.searching = TaskQueue(self.error.emit)

    @property
    def why_not(self) -> str:
        """Why nothing can be fitted now, as a sentence; nothing where it can."""
        recogniser = self._preset.preset.recogniser
        if not spec_of(recogniser).fit:
            return tr(
                "The recogniser {recogniser} has no thresholds; the guided calibration teaches it your voice."
            ).format(recogniser=recogniser)
        return "" if self._workbench.features is not None else tr("Record takes or load labelled recordings first.")

    def begin(self) -> None:
        """Search for better thresholds, or for better limits of the preset's own rules."""
        utterances, known, preset = self._workbench.utterances, self._workbench.features, self._preset.preset
        self.report = None
        self.searching.replace(lambda progress: _fitted(utterances, known, preset, progress), self._take_report)

    def accept(self) -> None:
        """Use what was found; undo brings the old preset back."""
        report, self.report = self.report, None
        if report is not None:
            now, found = self._preset.preset, report.preset
            self._preset.end_edit()
            fitted = {tuning.value: getattr(found, tuning) for tuning in spec_of(found.recogniser).tuned_by}
            self._preset.edit(replace(now, successors=found.successors, **fitted), tr("fit"))
        self.changed.emit()

    def refuse(self) -> None:
        """Leave the preset as it is."""
        self.report = None
        self.changed.emit()

    def close(self) -> None:
        """End all work."""
        self.searching.close()

    def _take_report(self, report: FitReport) -> None:
        self.report = report
        self.changed.emit()


class ComparisonModel(QObject):
    """A second preset on the same recordings, compared with the one in use whenever that changes.

    Signals
    -------
    changed : there is another comparison, or none.
    error : a sentence for the user.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, preset: PresetModel, workbench: WorkbenchModel) -> None:
        super().__init__()
        self.preset: Preset | None = None
        self.confusion: Confusion | None = None
        self.result: PresetComparison | None = None
        self._own = preset
        self._workbench = workbench
        self.measuring, self._comparing = TaskQueue(self.error.emit), TaskQueue(self.error.emit)
        workbench.measured.connect(self._measure)
        workbench.confusion_changed.connect(self._compare)

    def shipped(self) -> tuple[Path, ...]:
        """Return the presets that come with the program."""
        return tuple(sorted(FACTORY.glob("*.toml")))

    def choose(self, path: Path | None) -> None:
        """Compare with the preset of a file, or with none."""
        self.preset = self.confusion = self.result = None
        if path is not None:
            try:
                self.preset = load_preset(path)
            except EngineError as error:
                self.error.emit(str(error))
        self._measure()
        self.changed.emit()

    def close(self) -> None:
        """End all work."""
        for queue in (self.measuring, self._comparing):
            queue.close()

    def _measure(self) -> None:
        utterances, preset = self._workbench.utterances, self.preset
        if preset is None or not utterances:
            self.measuring.cancel()
            self.confusion = self.result = None
            self.changed.emit()
            return
        self.measuring.replace(
            lambda progress: LabelledFeatures(utterances, preset, progress=progress).confusion(preset),
            self._take_confusion,
        )

    def _take_confusion(self, confusion: Confusion) -> None:
        self.confusion = confusion
        self._compare()

    def _compare(self) -> None:
        own, other, preset = self._workbench.confusion, self.confusion, self.preset
        if own is None or other is None or preset is None or len(own.predicted) != len(other.predicted):
            return
        now, utterances = self._own.preset, self._workbench.utterances
        self._comparing.replace(
            lambda _progress: compare(
                _scores_of(now, own, utterances), _scores_of(preset, other, utterances), most=MOST_SEGMENTS
            ),
            self._take_comparison,
        )

    def _take_comparison(self, comparison: PresetComparison) -> None:
        self.result = comparison
        self.changed.emit()


def _fitted(
    utterances: tuple[LabelledUtterance, ...], known: LabelledFeatures | None, preset: Preset, progress: Progress
) -> FitReport:
    """Fit on a workbench of its own, since the window asks the other one meanwhile."""
    features = LabelledFeatures(utterances, preset, known=known, progress=subrange(progress, 0.0, 0.05))
    return fit_preset(features, preset, subrange(progress, 0.05, 1.0))


def _scores_of(preset: Preset, confusion: Confusion, utterances: tuple[LabelledUtterance, ...]) -> CorpusScores:
    """Return what a workbench answered as what a score of the files gives."""
    answers = []
    for k, utterance in enumerate(utterances):
        span = slice(int(confusion.edges[k]), int(confusion.edges[k + 1]))
        labels = confusion.labels.at(span)
        codes = confusion.predicted[span]
        answers.append(Predictions(utterance, labels, codes, np.zeros(len(codes), np.float32)))
    return CorpusScores(preset, 0, 0.0, tuple(answers), group_scores_of(answers), {}, {})
