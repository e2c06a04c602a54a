"""Few rules, found in the takes and recordings that are loaded: how right they are, and what they ask."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPlainTextEdit, QProgressBar, QPushButton, QWidget

from phonemeanalyser.desktop.calibrate.workbench.figures_table import FiguresTable
from phonemeanalyser.desktop.calibrate.workbench.fit_model import RuleFinding
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import choice, column, label, leave_wheel, named, row
from phonemeanalyser.desktop.widgets.number_field import NumberField
from phonemeengine.calibration.fits.rule_finding import MOST_CONDITIONS_IN_ALL
from phonemeengine.calibration.fits.rule_search import conditions_in
from phonemeengine.presets.rule_text import rule_lines


class RulesPanel(QWidget):
    """Begins the search, shows figures and rules, and uses them."""

    def __init__(self, finding: RuleFinding, theme: Theme) -> None:
        super().__init__()
        self._finding = finding
        self.begin = named(
            QPushButton(tr("Find Rules")), tip=tr("Find a few rules in the loaded takes and recordings")
        )
        self.stop = named(QPushButton(tr("Cancel")), tip=tr("Stop the search; the preset stays unchanged"))
        self.accept = named(
            QPushButton(tr("Apply")), tip=tr("Recognise with these rules; Ctrl+Z restores the preset")
        )
        self.refuse = named(QPushButton(tr("Discard")), tip=tr("Leave the preset unchanged"))
        self.conditions = named(
            NumberField(1, 500),
            tr("Maximum conditions"),
            tr("Maximum number of conditions of all rules together; fewer are easier to read"),
        )
        tip = tr("What rules may compare: frequency bands, with filters that suit them, or the preset's variables")
        self.variables = choice(
            [(tr("Frequency bands"), True), (tr("Variables of the preset"), False)], tr("Variables"), tip
        )
        self.progress = QProgressBar()
        self.words = label(wraps=True)
        self.figures = FiguresTable((tr("Before"), tr("After"), tr("Held out")), theme)
        self.rules = named(QPlainTextEdit(), tr("Rules found"))
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
        column(
            row(*buttons, 1),
            row(self.variables, 1),
            row(label(tr("Maximum conditions")), self.conditions, 1),
            self.words, self.figures, (self.rules, 1), 0,
            on=self, margins=(6, 6, 6, 4),
        )  # fmt: skip
        leave_wheel(self)

    def _connect(self) -> None:
        self.begin.clicked.connect(self.search)
        self.stop.clicked.connect(self._finding.searching.cancel)
        self.accept.clicked.connect(self._finding.accept)
        self.refuse.clicked.connect(self._finding.refuse)
        for signal in (self._finding.changed, self._finding.searching.changed):
            signal.connect(self.show_state)
