"""The right of the page: how variables are spread, what is taken for what, and what to do about it."""

import math
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QLabel, QSplitter, QTabWidget, QWidget

from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeanalyser.desktop.calibrate.workbench.confusion_view import ConfusionTimeline, ConfusionView
from phonemeanalyser.desktop.calibrate.workbench.distribution import DistributionView
from phonemeanalyser.desktop.calibrate.workbench.figures_table import SegmentList, SegmentRow
from phonemeanalyser.desktop.calibrate.workbench.fit_panel import ComparePanel, FitPanel
from phonemeanalyser.desktop.calibrate.workbench.variables_panel import VariablesPanel
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import Scrolled, column, label, named, row
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES
from phonemeengine.presets.ears import ear_in_words, for_files
from phonemeengine.settings import FRAME_PERIOD, Ear

TABS_WIDTH = 250
"""In less room than this nobody reads a list."""


class WorkbenchView(QWidget):
    """Lays out distributions, matrix, lists, fit, comparison and lanes.

    Signals
    -------
    play_asked : path, start and end of a stretch.
    picture_asked : the user wants to save a picture of a plot, of this name.
    """

    play_asked = Signal(Path, float, float)
    picture_asked = Signal(QWidget, str)

    def __init__(self, calibration: CalibrationModel, theme: Theme) -> None:
        super().__init__()
        self._calibration = calibration
        self._theme = theme
        workbench = calibration.workbench
        self.variables = VariablesPanel(workbench, theme)
        self.distribution = DistributionView(workbench, theme)
        self.confusion = ConfusionView(theme)
        self.cell = label(wraps=True)
        self.figures = named(
            QLabel(),
            tip=tr(
                "<p>Macro F1 is the mean over those of the ten sounds that the labels hold. More changes a second "
                "than the labels have are flicker.</p><p>Takes and recordings are recognised by the model for live "
                "sound, which is what you calibrate; files that you open may have a better one.</p>"
            ),
        )
        self.segments = SegmentList(tr("stretches of the cell"), "")
        self.fit = FitPanel(calibration.fit, theme)
        self.compare = ComparePanel(calibration.comparison, theme)
        self.tabs = QTabWidget()
        self.tabs.tabBar().setAccessibleName(tr("pages of the workbench"))
        self.timeline = ConfusionTimeline(theme)
        self.rows, self.columns = QSplitter(Qt.Orientation.Vertical), QSplitter(Qt.Orientation.Horizontal)
        self._lay_out()
        self._connect()
        self._show_confusion()

    def _lay_out(self) -> None:
        upper, listed = QWidget(), QWidget()
        row(self.variables, (self.distribution, 1), on=upper, spacing=0)
        column(self.cell, (self.segments, 1), on=listed, margins=(6, 6, 6, 4))
        for widget, name in (
            (listed, tr("Stretches")),
            (Scrolled(self.fit), tr("Fit")),
            (Scrolled(self.compare), tr("Compare")),
        ):
            self.tabs.addTab(widget, name)
        self.tabs.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.tabs.setMinimumWidth(TABS_WIDTH)
        self.columns.addWidget(self.confusion)
        self.columns.addWidget(self.tabs)
        self.columns.setSizes([540, 400])
        self.rows.addWidget(upper)
        self.rows.addWidget(self.columns)
        self.rows.setSizes([320, 300])
        for splitter in (self.rows, self.columns):
            splitter.setChildrenCollapsible(False)
        self.figures.setContentsMargins(8, 3, 8, 3)
        column((self.rows, 1), self.figures, self.timeline, on=self, spacing=0)

    def _connect(self) -> None:
        calibration = self._calibration
        calibration.workbench.confusion_changed.connect(self._show_confusion)
        calibration.workbench.confusion_changed.connect(self.distribution.show_lines)
        calibration.workbench.measured.connect(self.fit.show_state)
        calibration.workbench.measuring.changed.connect(self._show_measuring)
        calibration.preset.changed.connect(self.fit.show_state)
        calibration.comparison.changed.connect(self._show_matrix)
        self.compare.difference.toggled.connect(lambda _on: self._show_matrix())
        self.confusion.chosen.connect(self._choose_cell)
        self.timeline.chosen.connect(self._play_segment)
        for view in (self.segments, self.compare):
            view.play_asked.connect(calibration.play)
        self.segments.play_asked.connect(self._show_place)
        for plot in (self.distribution, self.confusion, self.timeline):
            plot.menu.save_asked.connect(self.picture_asked)

    # -- what is shown ------------------------------------------------------------------------------------

    def _show_confusion(self) -> None:
        workbench = self._calibration.workbench
        self.timeline.show_confusion(workbench.confusion, [u.path.stem for u in workbench.answered])
        self._show_matrix()
        self._show_figures()
        self._show_cell()

    def _show_matrix(self) -> None:
        own, comparison = self._calibration.workbench.confusion, self._calibration.comparison
        against = (
            comparison.confusion if self.compare.difference.isChecked() and comparison.result is not None else None
        )
        self.confusion.show_counts(own.counts if own else None, against.counts if against else None)

    def _show_measuring(self) -> None:
        measuring = self._calibration.workbench.measuring
        if measuring.busy:
            self.figures.setText(tr("measuring … {percent:.0f} %").format(percent=100 * measuring.progress))

    def _show_figures(self) -> None:
        confusion = self._calibration.workbench.confusion
        if confusion is None:
            self.figures.setText(f"<span style='color:{self._theme.faint}'>{tr('nothing is loaded yet')}</span>")
            return
        changes, of_labels = confusion.changes_per_s, confusion.label_changes_per_s
        calm = changes <= 1.5 * of_labels
        colour = self._theme.good if calm else self._theme.bad
        ratio = f" ({changes / of_labels:.1f} ×)" if of_labels > 0 else ""
        n_sounds = sum(not math.isnan(confusion.f1_of(phoneme)) for phoneme in SCORED_PHONEMES)
        of_sounds = "" if n_sounds == len(SCORED_PHONEMES) else f" ({tr('{n} of 10 sounds').format(n=n_sounds)})"
        live = for_files(self._calibration.preset.in_force, Ear.LIVE)
        model = tr("Model: {ear}").format(ear=tr_engine(ear_in_words(live)))
        of_what = f"{_length(len(confusion.predicted) * FRAME_PERIOD, confusion.n_recordings)}   ·   {model}"
        self.figures.setText(
            f"{tr('accuracy')} <b>{_percent(confusion.accuracy)}</b> &nbsp; "
            f"{tr('macro F1')} <b>{_percent(confusion.macro_f1)}</b>{of_sounds} &nbsp; "
            f"{tr('changes a second')} <b style='color:{colour}'>{changes:.1f}</b>, "
            f"{tr('labels')} {of_labels:.1f}{ratio} &nbsp; <span style='color:{self._theme.faint}'>{of_what}</span>"
        )

    # -- what is chosen -----------------------------------------------------------------------------------

    def _choose_cell(self, _truth: int, _answer: int) -> None:
        self.tabs.setCurrentIndex(0)
        self._show_cell()

    def _show_cell(self) -> None:
        workbench, cell = self._calibration.workbench, self.confusion.cell
        if cell is None or workbench.confusion is None:
            self.cell.setText(tr("Click a cell of the matrix to list what is in it."))
            self.segments.show_rows(())
            return
        truth, answer = self.confusion.phonemes_of(cell)
        found = workbench.segments_in(truth, answer)
        seconds = sum(p.end - p.start for p in found)
        self.cell.setText(
            tr("<b>{truth}</b> recognised as <b>{answer}</b>: {n} stretches, {seconds:.2f} s").format(
                truth=truth.label, answer=answer.label, n=len(found), seconds=seconds
            )
        )
        paths = [u.path for u in workbench.answered]
        self.segments.show_rows([SegmentRow(paths[p.recording], p.start, p.end) for p in found[:1000]])

    def _play_segment(self, recording: int, start: float, end: float) -> None:
        self._calibration.play(self._calibration.workbench.answered[recording].path, start, end)

    def _show_place(self, path: Path, start: float, _end: float) -> None:
        paths = [u.path for u in self._calibration.workbench.answered]
        if path in paths:
            self.timeline.show_frame(paths.index(path), start)


def _length(seconds: float, n: int) -> str:
    """Return how much is loaded, in words."""
    if seconds >= 60:
        return tr("{minutes:.1f} min in {n} recordings").format(minutes=seconds / 60, n=n)
    return tr("{seconds:.1f} s, recordings: {n}").format(seconds=seconds, n=n)


def _percent(share: float) -> str:
    return "–" if math.isnan(share) else f"{share:.1%}"
