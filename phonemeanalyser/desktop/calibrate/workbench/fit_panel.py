"""Fits thresholds, shows what that gained, and compares the preset in use with a second one."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QLabel, QProgressBar, QPushButton, QTabWidget, QWidget

from phonemeanalyser.desktop.calibrate.workbench.figures_table import FiguresTable, SegmentList, SegmentRow
from phonemeanalyser.desktop.calibrate.workbench.fit_model import ComparisonModel, FitModel
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import choice, column, label, named, row
from phonemeengine.calibration.scores.comparison import DifferingSegment


class FitPanel(QWidget):
    """The search for thresholds: before, after, and on speakers that were left out."""

    def __init__(self, fit: FitModel, theme: Theme) -> None:
        super().__init__()
        self._fit = fit
        self.begin = QPushButton(tr("Fit thresholds"))
        self.stop = named(QPushButton(tr("cancel")), tip=tr("End the search; the preset stays as it is"))
        self.accept = named(QPushButton(tr("accept")), tip=tr("Use what was found; Ctrl+Z takes it back"))
        self.refuse = named(QPushButton(tr("refuse")), tip=tr("Leave the preset as it is"))
        self.progress = QProgressBar()
        self.words = label(wraps=True)
        self.figures = FiguresTable((tr("before"), tr("after"), tr("left out")), theme)
        self._lay_out()
        self._connect()
        self.show_state()

    def show_state(self) -> None:
        """Show what can be done."""
        fit, report, busy = self._fit, self._fit.report, self._fit.searching.busy
        self.begin.setEnabled(not busy and not fit.why_not)
        self.begin.setToolTip(
            fit.why_not or tr("Search for thresholds that suit what is loaded, with those in use to begin with")
        )
        self.stop.setVisible(busy)
        self.progress.setVisible(busy)
        self.progress.setValue(round(100 * fit.searching.progress))
        self.accept.setVisible(report is not None and report.gains)
        self.refuse.setVisible(report is not None)
        self.refuse.setText(tr("refuse") if report is not None and report.gains else tr("close"))
        self.figures.setVisible(report is not None)
        self.words.setText(self._said())
        if report is not None:
            self.figures.show_scores((report.before, report.after, report.held_out))

    def _said(self) -> str:
        report = self._fit.report
        if self._fit.searching.busy:
            return tr("Searching; you can go on working meanwhile.")
        if report is None:
            return self._fit.why_not or tr("Finds the thresholds that name the most frames right in what is loaded.")
        if not report.gains:
            return tr("Nothing better was found than what is in use.")
        if report.held_out is not None and report.held_out.macro_f1 < report.before.macro_f1:
            return tr(
                "Better on what is loaded, but not on a {left_out} that was left out: load more of them."
            ).format(left_out=tr(report.left_out))
        return tr("Better. The last column leaves each {left_out} out in turn, and fits without it.").format(
            left_out=tr(report.left_out)
        )

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


NONE, OTHER = tr_noop("choose a preset …"), tr_noop("another file …")


class ComparePanel(QWidget):
    """The second preset, both presets' figures, and what only one of them gets right.

    Signals
    -------
    file_asked : the user wants to choose a preset's file.
    play_asked : path, start and end of a stretch.
    """

    file_asked = Signal()
    play_asked = Signal(Path, float, float)

    def __init__(self, comparison: ComparisonModel, theme: Theme) -> None:
        super().__init__()
        self._comparison = comparison
        tip = tr("Preset to compare with, on the same takes and recordings")
        shipped = [(path.stem, path) for path in comparison.shipped()]
        self.box = choice([(tr(NONE), None), *shipped, (tr(OTHER), "")], tip, tip)
        self.state = QLabel()
        self.difference = named(
            QCheckBox(tr("difference in the matrix")),
            tip=tr("Show in the matrix how much more often the preset in use gives each answer"),
        )
        self.figures = FiguresTable((tr("in use"), tr("second")), theme)
        self.own = SegmentList(tr("only the preset in use is right"), tr("said, not"))
        self.others = SegmentList(tr("only the second preset is right"), tr("said, not"))
        self.tabs = QTabWidget()
        self.tabs.tabBar().setAccessibleName(tr("pages of the comparison"))
        self._lay_out()
        self._connect()
        self._show()

    def offer(self, path: Path) -> None:
        """Choose a preset's file."""
        if self.box.findData(path) < 0:
            self.box.insertItem(self.box.count() - 1, path.stem, path)
        self.box.setCurrentIndex(self.box.findData(path))
        self._comparison.choose(path)

    def _lay_out(self) -> None:
        self.tabs.addTab(self.figures, tr("figures"))
        self.tabs.addTab(self.own, tr("only this right"))
        self.tabs.addTab(self.others, tr("only the second right"))
        above = row((self.box, 1), self.state, self.difference)
        column(above, (self.tabs, 1), on=self, margins=(6, 6, 6, 4))
        self.tabs.setFocusPolicy(Qt.FocusPolicy.TabFocus)

    def _connect(self) -> None:
        self.box.activated.connect(self._choose)
        self._comparison.changed.connect(self._show)
        self._comparison.measuring.changed.connect(self._show_measuring)
        for view in (self.own, self.others):
            view.play_asked.connect(self.play_asked)

    def _show_measuring(self) -> None:
        measuring = self._comparison.measuring
        self.state.setText(
            tr("measuring {percent:.0f} %").format(percent=100 * measuring.progress) if measuring.busy else ""
        )

    def _choose(self, index: int) -> None:
        data = self.box.itemData(index)
        if data == "":
            self.box.setCurrentIndex(0)
            self.file_asked.emit()
        else:
            self._comparison.choose(data)

    def _show(self) -> None:
        comparison, preset = self._comparison.result, self._comparison.preset
        self.difference.setEnabled(comparison is not None)
        if preset is None:
            self.box.setCurrentIndex(0)
        self.figures.set_columns((tr("in use"), preset.name if preset is not None else tr("second")))
        if comparison is None:
            self.figures.show_scores((None, None))
            self.own.show_rows(())
            self.others.show_rows(())
            return
        self.figures.show_scores((comparison.one.overall.scores, comparison.other.overall.scores))
        self.own.show_rows([_row_of(stretch) for stretch in comparison.stretches_one])
        self.others.show_rows([_row_of(stretch) for stretch in comparison.stretches_other])
        for k, counts in ((1, comparison.only_one), (2, comparison.only_other)):
            text = tr("only this right: {seconds:.1f} s") if k == 1 else tr("only the second right: {seconds:.1f} s")
            self.tabs.setTabText(k, text.format(seconds=int(counts.sum()) / 100))


def _row_of(stretch: DifferingSegment) -> SegmentRow:
    words = f"{stretch.label.label}, {stretch.wrong.label}"
    return SegmentRow(stretch.utterance.path, stretch.start, stretch.end, words)
