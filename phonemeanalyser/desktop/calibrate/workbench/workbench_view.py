"""The right of the page: how variables are spread, what is taken for what, and what to do about it."""

import math
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QLabel, QPlainTextEdit, QProgressBar, QPushButton, QSplitter, QTabWidget, QWidget

from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeanalyser.desktop.calibrate.workbench.confusion_view import ConfusionTimeline, ConfusionView
from phonemeanalyser.desktop.calibrate.workbench.figures_table import FiguresTable, SegmentList, SegmentRow
from phonemeanalyser.desktop.calibrate.workbench.fit_model import RuleFinding
from phonemeanalyser.desktop.calibrate.workbench.fit_panel import ComparePanel, FitPanel
from phonemeanalyser.desktop.calibrate.workbench.phoneme_data_panel import PhonemeDataPanel
from phonemeanalyser.desktop.calibrate.workbench.variables_panel import VariablesPanel
from phonemeanalyser.desktop.engine_words import recogniser_title, sound_name, tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.distribution import DistributionView
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeanalyser.desktop.widgets.figures import classes_in_words, colour_of_changes, figure_in_words
from phonemeanalyser.desktop.widgets.preset_picker import PresetPicker
from phonemeengine.calibration.fits.rule_finding import MOST_CONDITIONS_IN_ALL
from phonemeengine.calibration.fits.rule_search import conditions_in
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES
from phonemeengine.presets.model_choice import for_files, model_in_words
from phonemeengine.presets.preset import rule_lines
from phonemeengine.settings import ModelKind


class RulesPanel(QWidget):
    """Begins the search, shows figures and rules, and uses them."""

    def __init__(self, finding: RuleFinding, theme: Theme) -> None:
        super().__init__()
        self._finding = finding
        self.begin = builders.named(
            QPushButton(tr("Find Rules")), tip=tr("Find a few rules in the loaded takes and recordings")
        )
        self.stop = builders.named(QPushButton(tr("Cancel")), tip=tr("Stop the search; the preset stays unchanged"))
        self.accept = builders.named(
            QPushButton(tr("Apply")), tip=tr("Recognise with these rules; Ctrl+Z restores the preset")
        )
        self.refuse = builders.named(QPushButton(tr("Discard")), tip=tr("Leave the preset unchanged"))
        self.conditions = builders.named(
            NumberField(1, 500),
            tr("Maximum conditions"),
            tr("Maximum number of conditions of all rules together; fewer are easier to read"),
        )
        tip = tr("What rules may compare: frequency bands, with filters that suit them, or the preset's variables")
        self.variables = builders.choice(
            [(tr("Frequency bands"), True), (tr("Variables of the preset"), False)], tr("Variables"), tip
        )
        self.progress = QProgressBar()
        self.words = builders.label(wraps=True)
        self.figures = FiguresTable((tr("Before"), tr("After"), tr("Held out")), theme)
        self.rules = builders.named(QPlainTextEdit(), tr("Rules found"))
        self._lay_out()
        self._connect()
        self.show_state()

    def search(self) -> None:
        """Find rules, if there is anything to find them in."""
        if not self._finding.why_not and not self._finding.searching.busy:
            self._finding.find(int(self.conditions.value()), bands=bool(self.variables.currentData()))

    def show_state(self) -> None:
        """Show what can be done, and what was found."""
        finding, report, busy = self._finding, self._finding.report, self._finding.searching.busy
        self.begin.setEnabled(not busy and not finding.why_not)
        self.stop.setVisible(busy)
        self.progress.setVisible(busy)
        self.progress.setValue(round(100 * finding.searching.progress))
        for widget in (self.accept, self.refuse, self.figures, self.rules):
            widget.setVisible(report is not None)
        self.words.setText(self._said())
        if report is not None:
            self.figures.show_scores((report.before, report.after, report.held_out))
            self.rules.setPlainText("\n".join(rule_lines(report.preset)))

    def _said(self) -> str:
        report = self._finding.report
        if self._finding.searching.busy:
            return tr("Searching in the background…")
        if report is None:
            return self._finding.why_not or tr(
                "Finds a small decision tree for the loaded takes and recordings, as rules to read and edit."
            )
        rules = report.preset.rules
        found = tr("Rules: {rules}, conditions: {conditions}.").format(
            rules=len(rules), conditions=conditions_in(rules)
        )
        if report.held_out is None:
            return found
        if report.held_out.macro_f1 < report.before.macro_f1:
            words = tr("On a {left_out} that was held out they are worse than the current preset. Load more data.")
        else:
            words = tr("The last column is cross-validated: each {left_out} in turn is held out and measured.")
        return f"{found} {words.format(left_out=tr(report.left_out))}"

    def _lay_out(self) -> None:
        self.conditions.setValue(MOST_CONDITIONS_IN_ALL)
        self.rules.setReadOnly(True)
        self.rules.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.rules.setMinimumHeight(120)
        buttons = (self.begin, self.progress, self.stop, self.accept, self.refuse)
        for widget in (*buttons, self.conditions, self.variables):
            widget.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        builders.column(
            builders.row(*buttons, 1),
            builders.row(self.variables, 1),
            builders.row(builders.label(tr("Maximum conditions")), self.conditions, 1),
            self.words, self.figures, (self.rules, 1), 0,
            on=self, margins=(6, 6, 6, 4),
        )  # fmt: skip
        builders.leave_wheel(self)

    def _connect(self) -> None:
        self.begin.clicked.connect(self.search)
        self.stop.clicked.connect(self._finding.searching.cancel)
        self.accept.clicked.connect(self._finding.accept)
        self.refuse.clicked.connect(self._finding.refuse)
        for signal in (self._finding.changed, self._finding.searching.changed):
            signal.connect(self.show_state)


TABS_WIDTH = 250
"""With less space than this a list cannot be read."""


class WorkbenchView(QWidget):
    """Lays out distributions, matrix, lists, fit, comparison and lanes.

    Signals
    -------
    play_asked : path, start and end of a segment.
    picture_asked : the user wants to save a picture of a plot, of this name.
    """

    play_asked = Signal(Path, float, float)
    picture_asked = Signal(QWidget, str)

    def __init__(self, calibration: CalibrationModel, picker: PresetPicker, theme: Theme) -> None:
        super().__init__()
        self._calibration = calibration
        self._theme = theme
        workbench = calibration.workbench
        self.variables = VariablesPanel(workbench, theme)
        self.distribution = DistributionView(workbench.lines, theme)
        self.phoneme_data = PhonemeDataPanel(calibration.phoneme_data, theme)
        self.upper = QTabWidget()
        self.upper.tabBar().setAccessibleName(tr("Variables or PhonemeData"))
        self.confusion = ConfusionView(theme)
        self.cell = builders.label(wraps=True)
        self.about = builders.ElidedLabel()
        self.about.setStyleSheet(f"color: {theme.faint}")
        self.figures = QLabel()
        self._about_figures = tr(
            "<p>Macro F1 is the mean of the F1 scores of those of the ten phonemes that occur in the labels. "
            "More changes per second than in the labels are flicker.</p><p>Takes and recordings are "
            "recognised by the real-time model, which is the one you calibrate; files that you open may be "
            "analysed with a better file model.</p>"
        )
        self.segments = SegmentList(tr("Segments in the cell"), "")
        self.fit = FitPanel(calibration.fit, theme)
        self.rules = RulesPanel(calibration.rule_finding, theme)
        self._found = builders.Scrolled(self.rules)
        self.compare = ComparePanel(calibration.comparison, picker, theme)
        self.tabs = QTabWidget()
        self.tabs.tabBar().setAccessibleName(tr("Workbench tabs"))
        self.timeline = ConfusionTimeline(theme)
        self.rows, self.columns = QSplitter(Qt.Orientation.Vertical), QSplitter(Qt.Orientation.Horizontal)
        self._lay_out()
        self._connect()
        self._show_distribution()
        self._show_confusion()

    def _lay_out(self) -> None:
        variables, listed = QWidget(), QWidget()
        builders.row((self.variables, 1), (self.distribution, 3), on=variables, spacing=0)
        self.upper.addTab(variables, tr("Variables"))
        self.upper.addTab(self.phoneme_data, "PhonemeData")
        self.upper.setDocumentMode(True)
        self.upper.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        builders.column(self.cell, (self.segments, 1), on=listed, margins=(6, 6, 6, 4))
        for widget, name in (
            (listed, tr("Segments")),
            (builders.Scrolled(self.fit), tr("Fit")),
            (self._found, tr("Rules")),
            (builders.Scrolled(self.compare), tr("Compare")),
        ):
            self.tabs.addTab(widget, name)
        self.tabs.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.tabs.setMinimumWidth(max(TABS_WIDTH, self.tabs.tabBar().sizeHint().width() + 8))
        self.columns.addWidget(self.confusion)
        self.columns.addWidget(self.tabs)
        self.columns.setSizes([540, 400])
        self.rows.addWidget(self.upper)
        self.rows.addWidget(self.columns)
        self.rows.setSizes([320, 300])
        for splitter in (self.rows, self.columns):
            splitter.setChildrenCollapsible(False)
        below = builders.row(self.figures, (self.about, 1), margins=(8, 3, 8, 3), spacing=16)
        builders.column((self.rows, 1), below, self.timeline, on=self, spacing=0)

    def _connect(self) -> None:
        calibration = self._calibration
        calibration.workbench.confusion_changed.connect(self._show_confusion)
        calibration.workbench.confusion_changed.connect(self.distribution.show_lines)
        calibration.workbench.distribution_changed.connect(self._show_distribution)
        calibration.workbench.measured.connect(self.fit.show_state)
        calibration.workbench.measured.connect(self.rules.show_state)
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

    def find_rules(self) -> None:
        """Show where rules are found, and begin to."""
        self.tabs.setCurrentWidget(self._found)
        self.rules.search()

    # -- what is shown ------------------------------------------------------------------------------------

    def _show_distribution(self) -> None:
        workbench = self._calibration.workbench
        words = (
            tr("Measuring…")
            if workbench.measuring.busy
            else tr("All labels are ambiguous, so there are no distributions; load others")
            if workbench.features is not None
            else tr("Record takes or load labelled recordings to see distributions")
        )
        preview = workbench.preview
        self.distribution.show_distribution(
            workbench.shown, words, math.nan if preview is None else preview.threshold
        )

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
        if self._calibration.workbench.shown is None:
            self._show_distribution()
        if measuring.busy:
            self.figures.setText(tr("Measuring… {percent:.0f} %").format(percent=100 * measuring.progress))
            if self._calibration.workbench.confusion is None:
                self.about.setText("")

    def _show_figures(self) -> None:
        confusion = self._calibration.workbench.confusion
        if confusion is None:
            loaded = self._calibration.workbench.utterances
            self.figures.setText("")
            self.about.setText("" if loaded else tr("No takes or recordings loaded"))
            return
        agreement, n_classes = confusion.agreement, len(confusion.agreement.classes)
        of_labels = agreement.label_changes_per_s
        ratio = f" ({agreement.changes_per_s / of_labels:.1f} ×)" if of_labels > 0 else ""
        of_sounds = "" if n_classes == len(SCORED_PHONEMES) else f" ({tr('{n} of 10 phonemes').format(n=n_classes)})"
        live = for_files(self._calibration.preset.in_force, ModelKind.REAL_TIME)
        model = tr("Model: {model}").format(model=tr_engine(recogniser_title(model_in_words(live))))
        of_what = f"{_length(agreement.seconds, confusion.n_recordings)}   ·   {model}"
        self.figures.setText(
            f"{tr('Accuracy')} <b>{figure_in_words('accuracy', agreement.accuracy)}</b> &nbsp; "
            f"{tr('Macro F1')} <b>{figure_in_words('macro_f1', agreement.macro_f1)}</b>{of_sounds} &nbsp; "
            f"{tr('Changes/s')} <b style='color:{colour_of_changes(agreement, self._theme)}'>"
            f"{figure_in_words('changes_per_s', agreement.changes_per_s)}</b>, "
            f"{tr('labels')} {figure_in_words('changes_per_s', of_labels)}{ratio}"
        )
        self.figures.setToolTip(f"{self._about_figures}<p>{classes_in_words(agreement)}</p>")
        self.about.setText(of_what)
        self.about.setToolTip(of_what)

    # -- what is chosen -----------------------------------------------------------------------------------

    def _choose_cell(self, _truth: int, _answer: int) -> None:
        self.tabs.setCurrentIndex(0)
        self._show_cell()

    def _show_cell(self) -> None:
        workbench, cell = self._calibration.workbench, self.confusion.cell
        if cell is None or workbench.confusion is None:
            self.cell.setText(tr("Click a cell of the matrix to list its segments."))
            self.segments.show_rows(())
            return
        truth, answer = self.confusion.phonemes_of(cell)
        found = workbench.segments_in(truth, answer)
        seconds = sum(p.end - p.start for p in found)
        self.cell.setText(
            tr("<b>{truth}</b> recognised as <b>{answer}</b> · segments: {n} ({seconds:.2f} s)").format(
                truth=sound_name(truth), answer=sound_name(answer), n=len(found), seconds=seconds
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
        return tr("Recordings: {n} ({minutes:.1f} min)").format(minutes=seconds / 60, n=n)
    return tr("Recordings: {n} ({seconds:.1f} s)").format(seconds=seconds, n=n)
