"""Fits thresholds: begins it, shows how far it is, and what it gained."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QProgressBar, QPushButton, QWidget

from phonemeanalyser.desktop.calibrate.workbench.figures_table import FiguresTable
from phonemeanalyser.desktop.calibrate.workbench.fit_model import FitModel
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import column, label, named, row


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
