"""The fit of thresholds or limits to what is loaded, and A compared with B."""

from dataclasses import replace

import numpy as np
from PySide6.QtCore import QObject, Signal
from typing_extensions import override

from phonemeanalyser.desktop.calibrate.workbench.workbench_model import WorkbenchModel
from phonemeanalyser.desktop.engine_words import recogniser_title
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import A, B, PresetModel
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.calibration.fits.fitting import FitReport, fit_preset
from phonemeengine.calibration.fits.rule_finding import rules_from
from phonemeengine.calibration.scores.comparison import PresetComparison, compare
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import CorpusScores, Predictions, group_scores_of
from phonemeengine.calibration.scores.scoring import Confusion
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.execution import Progress, subrange
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.spec import spec_of

MOST_SEGMENTS = 200
"""Segments that are listed of each preset."""


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
        self._side = preset.letter, preset.path
        for signal in (preset.loaded, preset.sides_changed):
            signal.connect(self._follow_preset)

    @property
    def why_not(self) -> str:
        """Why nothing can be fitted now, as a sentence; nothing where it can."""
        recogniser = self._preset.preset.recogniser
        if not spec_of(recogniser).fit:
            return tr(
                "The recogniser {recogniser} has no thresholds to fit. Use the guided calibration instead."
            ).format(recogniser=recogniser_title(recogniser))
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

    def _follow_preset(self) -> None:
        """Keep nothing that was found for another preset: its figures before are not those of the one in use."""
        before, self._side = self._side, (self._preset.letter, self._preset.path)
        if before != self._side:
            self.searching.cancel()
            self.refuse()


class RuleFinding(FitModel):
    """Finds few rules in the background."""

    @property
    @override
    def why_not(self) -> str:
        """Why no rules can be found now, as a sentence; nothing where they can."""
        return "" if self._workbench.utterances else tr("Record takes or load labelled recordings first.")

    def find(self, most_conditions: int, *, bands: bool) -> None:
        """Find rules that ask for bands of the spectrum, or for what the preset measures."""
        utterances, preset, known = self._workbench.utterances, self._preset.preset, self._workbench.features
        self.refuse()

        def search(progress: Progress) -> FitReport:
            return rules_from(utterances, preset, progress, known=known, bands=bands, most_conditions=most_conditions)

        self.searching.replace(search, self._take_report)

    @override
    def accept(self) -> None:
        """Recognise with what was found; undo brings the old preset back."""
        if self.report is not None:
            self._preset.end_edit()
            self._preset.edit(self.report.preset, tr("rules from takes"))
            self._preset.end_edit()
        self.refuse()


class ComparisonModel(QObject):
    """A and B on the same recordings, compared whenever one of them or the recordings change.

    Signals
    -------
    changed : there is another comparison, or none.
    error : a sentence for the user.

    Attributes
    ----------
    confusion : answers of the one that is not in use; None before they are known.
    result : the comparison, A first; None before it is known.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, preset: PresetModel, workbench: WorkbenchModel) -> None:
        super().__init__()
        self.confusion: Confusion | None = None
        self.result: PresetComparison | None = None
        self.preset = preset
        self._workbench = workbench
        self._features: LabelledFeatures | None = None
        self._letter = preset.letter
        self.measuring, self._comparing = TaskQueue(self.error.emit), TaskQueue(self.error.emit)
        preset.sides_changed.connect(self._follow_sides)
        workbench.measured.connect(self._measure)
        workbench.confusion_changed.connect(self._compare)

    @property
    def busy(self) -> bool:
        """Whether more is being measured or compared."""
        return self.measuring.busy or self._comparing.busy

    @property
    def has_recordings(self) -> bool:
        """Whether there is anything to compare on."""
        return bool(self._workbench.utterances)

    @property
    def better(self) -> str:
        """The letter of the one with the higher macro F1; empty where they are not compared, or equal."""
        difference = 0.0 if self.result is None else self.result.gains.macro_f1.difference
        return "" if not difference else B if difference > 0 else A

    def close(self) -> None:
        """End all work."""
        for queue in (self.measuring, self._comparing):
            queue.close()

    def _follow_sides(self) -> None:
        if self._letter != self.preset.letter and self.preset.other is not None:
            self._features, self.confusion = self._workbench.exchange(self._features, self.confusion)
            self._letter = self.preset.letter
            self._workbench.look_anew()  # which has this one measure, too
        else:
            self._letter, self.confusion, self.result = self.preset.letter, None, None
            self._measure()

    def _measure(self) -> None:
        """Have the one that is not in use recognise all recordings; what it measured before is not measured again."""
        utterances, other, known = self._workbench.utterances, self.preset.other, self._features
        if other is None or not utterances:
            self.measuring.cancel()
            self._comparing.cancel()
            self.confusion = self.result = self._features = None
            self.changed.emit()
            return
        preset = other.preset

        def measured(progress: Progress) -> tuple[LabelledFeatures, Confusion]:
            features = LabelledFeatures(utterances, preset, known=known, progress=progress)
            return features, features.confusion(preset)

        self.measuring.replace(measured, self._take_confusion)

    def _take_confusion(self, found: tuple[LabelledFeatures, Confusion]) -> None:
        self._features, self.confusion = found
        self._compare()

    def _compare(self) -> None:
        own, other, document = self._workbench.confusion, self.confusion, self.preset.other
        if own is None or other is None or document is None or len(own.predicted) != len(other.predicted):
            return
        pairs = [(self.preset.preset, own), (document.preset, other)]
        (one, said), (two, answered) = pairs if self.preset.letter == A else pairs[::-1]
        utterances = self._workbench.utterances
        self._comparing.replace(
            lambda _progress: compare(
                _scores_of(one, said, utterances), _scores_of(two, answered, utterances), most=MOST_SEGMENTS
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
