"""Fits thresholds, shows what that gained, and compares A with B."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QLabel, QProgressBar, QPushButton, QSizePolicy, QTabWidget, QWidget

from phonemeanalyser.desktop.calibrate.workbench import figures_table
from phonemeanalyser.desktop.calibrate.workbench.fit_model import ComparisonModel, FitModel
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import A, B
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import column, label, named, row, tab_buttons
from phonemeanalyser.desktop.widgets.preset_picker import PresetPicker
from phonemeengine.calibration.scores.comparison import DifferingSegment


class FitPanel(QWidget):
    """The search for thresholds: before, after, and on speakers that were left out."""

    def __init__(self, fit: FitModel, theme: Theme) -> None:
        super().__init__()
        self._fit = fit
        self.begin = QPushButton(tr("Fit Thresholds"))
        self.stop = named(QPushButton(tr("Cancel")), tip=tr("Stop the search; the preset stays unchanged"))
        self.accept = named(
            QPushButton(tr("Apply")), tip=tr("Apply the fitted thresholds; Ctrl+Z restores the old ones")
        )
        self.refuse = named(QPushButton(tr("Discard")), tip=tr("Leave the preset unchanged"))
        self.progress = QProgressBar()
        self.words = label(wraps=True)
        self.figures = figures_table.FiguresTable((tr("Before"), tr("After"), tr("Held out")), theme)
        self._lay_out()
        self._connect()
        self.show_state()

    def show_state(self) -> None:
        """Show what can be done."""
        fit, report, busy = self._fit, self._fit.report, self._fit.searching.busy
        self.begin.setEnabled(not busy and not fit.why_not)
        self.begin.setToolTip(
            fit.why_not
            or tr("Search for thresholds that fit the loaded takes and recordings, starting from the current ones")
        )
        self.stop.setVisible(busy)
        self.progress.setVisible(busy)
        self.progress.setValue(round(100 * fit.searching.progress))
        self.accept.setVisible(report is not None and report.gains)
        self.refuse.setVisible(report is not None)
        self.refuse.setText(tr("Discard") if report is not None and report.gains else tr("Close"))
        self.figures.setVisible(report is not None)
        self.words.setText(self._said())
        if report is not None:
            self.figures.show_scores((report.before, report.after, report.held_out))

    def _said(self) -> str:
        report = self._fit.report
        if self._fit.searching.busy:
            return tr("Searching in the background…")
        if report is None:
            return self._fit.why_not or tr(
                "Finds the thresholds with which the most frames of the loaded takes "
                "and recordings are recognised correctly."
            )
        if not report.gains:
            return tr("No better thresholds were found.")
        if report.held_out is None:
            return tr("Improved on the loaded recording. With one alone nothing can be held out. Load more data.")
        if report.held_out.macro_f1 < report.before.macro_f1:
            return tr(
                "Improved on the loaded data, but not on a {left_out} left out of the fit. Load more data."
            ).format(left_out=tr(report.left_out))
        return tr(
            "Improved. The last column is cross-validated: each {left_out} in turn is left out of the fit "
            "and used for measuring."
        ).format(left_out=tr(report.left_out))

    def _lay_out(self) -> None:
        widgets = (self.begin, self.progress, self.stop, self.accept, self.refuse)
        for widget in widgets:
            widget.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        column(row(*widgets, 1), self.words, (self.figures, 1), 0, on=self, margins=(6, 6, 6, 4))

    def _connect(self) -> None:
        self.begin.clicked.connect(self._fit.begin)
        self.stop.clicked.connect(self._fit.searching.cancel)
        self.accept.clicked.connect(self._fit.accept)
        self.refuse.clicked.connect(self._fit.refuse)
        for signal in (self._fit.changed, self._fit.searching.changed):
            signal.connect(self.show_state)


class ComparePanel(QWidget):
    """Figures of A and B, by how much they differ, what only one of them gets right, and which one to use.

    Parameters
    ----------
    picker : the list of presets, from which the other one of A and B is chosen.

    Signals
    -------
    play_asked : path, start and end of a segment.

    Attributes
    ----------
    verdict : which one is better.
    use : a button that uses the better one.
    """

    play_asked = Signal(Path, float, float)

    def __init__(self, comparison: ComparisonModel, picker: PresetPicker, theme: Theme) -> None:
        super().__init__()
        self._comparison = comparison
        self.picker = named(picker, tr("Preset to compare"), tr("Preset to compare with the one in use"))
        self.state, self.verdict = QLabel(), label(wraps=True)
        self.use = named(QPushButton(), tip=tr("Use the preset with the higher macro F1 from now on"))
        self.switch = named(QPushButton(tr("Switch")), tip=tr("Use the other one of A and B"))
        self.difference = named(
            QCheckBox(tr("Difference in matrix")),
            tip=tr("Show in the confusion matrix how much more often the current preset gives each result"),
        )
        self.figures = figures_table.FiguresTable((A, B, f"{B} − {A}"), theme)
        self.own, self.others = (
            figures_table.SegmentList(words.format(letter=letter), tr("Label → error"))
            for letter, words in ((A, tr("Only {letter} correct")), (B, tr("Only {letter} correct")))
        )
        self.changes = figures_table.ChangesTable()
        self.tabs = QTabWidget()
        self.tabs.tabBar().setAccessibleName(tr("Comparison tabs"))
        self._lay_out()
        self._connect()
        self._show()

    def _lay_out(self) -> None:
        self.tabs.addTab(self.figures, tr("Scores"))
        self.tabs.addTab(self.own, self.own.accessibleName())
        self.tabs.addTab(self.others, self.others.accessibleName())
        self.tabs.addTab(self.changes, tr("Changed"))
        for button in tab_buttons(self.use, self.switch):
            button.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        column(
            row((self.picker, 1), self.state),
            self.verdict,
            row((self.use, 1), self.switch),
            self.difference,
            (self.tabs, 1),
            on=self,
            margins=(6, 6, 6, 4),
        )
        self.tabs.setFocusPolicy(Qt.FocusPolicy.TabFocus)

    def _connect(self) -> None:
        self._comparison.changed.connect(self._show)
        self._comparison.preset.changed.connect(self._show_presets)
        self._comparison.measuring.changed.connect(self._show_measuring)
        self.picker.clicked.disconnect()
        self.picker.clicked.connect(lambda _checked: self.picker.choose_other())
        self.switch.clicked.connect(self._comparison.preset.switch)
        self.use.clicked.connect(self._use_better)
        for view in (self.own, self.others):
            view.play_asked.connect(self.play_asked)

    def _use_better(self) -> None:
        if self._comparison.better == self._comparison.preset.other_letter:
            self._comparison.preset.switch()

    def _show_measuring(self) -> None:
        measuring = self._comparison.measuring
        self.state.setText(
            tr("Measuring {percent:.0f} %").format(percent=100 * measuring.progress) if measuring.busy else ""
        )

    def _show_presets(self) -> None:
        """Show which two are compared, and which one is in use."""
        model, better = self._comparison.preset, self._comparison.better
        sides = [f"{letter}: {preset.name}" for letter, preset in model.sides.items()]
        other = f"{model.other_letter}: {model.other.preset.name}" if model.other else tr("Choose Preset to Compare…")
        self.picker.show_name(other)
        self.figures.set_columns((*(sides if model.other else (sides[0], B)), f"{B} − {A}"))
        self.switch.setEnabled(model.other is not None)
        self.use.setEnabled(better == model.other_letter and bool(better))
        if not better:
            self.use.setText(tr("Use the Better One"))
        else:
            words = tr("{letter}: {preset} is in use") if better == model.letter else tr("Use {letter}: {preset}")
            name = model.sides[better].name if better in model.sides else ""
            self.use.setText(words.format(letter=better, preset=name).replace("&", "&&"))

    def _show(self) -> None:
        comparison = self._comparison.result
        self.difference.setEnabled(comparison is not None)
        self._show_presets()
        self.verdict.setText(self._verdict())
        self.verdict.setVisible(bool(self.verdict.text()))
        if comparison is None:
            self.figures.show_scores((None, None))
            self.own.show_rows(())
            self.others.show_rows(())
            self.changes.show_counts(None)
            return
        self.figures.show_scores((comparison.one.overall.scores, comparison.other.overall.scores), comparison.gains)
        self.own.show_rows([_row_of(stretch) for stretch in comparison.segments_one])
        self.others.show_rows([_row_of(stretch) for stretch in comparison.segments_other])
        self.changes.show_counts(comparison.changed)
        for k, letter, counts in ((1, A, comparison.only_one), (2, B, comparison.only_other)):
            words = tr("Only {letter} correct: {seconds:.1f} s")
            self.tabs.setTabText(k, words.format(letter=letter, seconds=int(counts.sum()) / 100))

    def _verdict(self) -> str:
        """Return which one is better, by how much, and whether that may be chance."""
        comparison, better = self._comparison.result, self._comparison.better
        if comparison is None:
            is_empty = self._comparison.preset.other is not None and not self._comparison.has_recordings
            return tr("Load takes or labelled recordings to compare on.") if is_empty else ""
        gain = comparison.gains.macro_f1
        if not better:
            return tr("Both have the same macro F1.")
        low, high = (gain.low, gain.high) if better == B else (-gain.high, -gain.low)
        words = tr("<b>No clear difference</b>: macro F1 {gain} points higher for {letter} ({low} to {high}).")
        if gain.is_clear:
            words = tr("<b>{letter} is better</b>: macro F1 {gain} points higher (95 % interval {low} to {high}).")
        shares = {"gain": abs(gain.difference), "low": low, "high": high}
        return words.format(letter=better, **{name: f"{100 * share:.1f}" for name, share in shares.items()})


def _row_of(stretch: DifferingSegment) -> figures_table.SegmentRow:
    words = f"{sound_name(stretch.label)} → {sound_name(stretch.wrong)}"
    return figures_table.SegmentRow(stretch.utterance.path, stretch.start, stretch.end, words)
