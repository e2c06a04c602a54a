"""Asks for a condition of a rule, proposes its limit, and says what it gains on the labelled sound that is loaded."""

import math
from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QDialog, QFormLayout, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.analyse.recognition.rule_editor import RuleEditor
from phonemeanalyser.desktop.analyse.recognition.variable_panel import VariablePanel
from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.rules import Draft, RuleModel, RuleTrial
from phonemeanalyser.desktop.widgets.builders import CANCEL, choice, dialog_buttons, label, row, silent
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeengine.arrays import LARGEST_FLOAT32
from phonemeengine.calibration.scores.scoring import Agreement
from phonemeengine.features.variables import readable_name
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import Condition

MOST_NAMED = 3
"""Phonemes that are named of those that gain or lose."""
LEAST_CHANGE = 0.0005
AGAIN_MS = 500
"""Until it is looked again whether there is labelled sound."""


class ConditionDialog(QDialog):
    """Uses a variable in a rule: in one that there is, or in a new one.

    Sign and limit are those by which the most is gained on the labelled sound, until the user sets others.

    Attributes
    ----------
    variable, rule, phoneme, sign, limit : what is chosen; a new rule has a phoneme.
    gain : what it gains.
    """

    def __init__(
        self, rules: RuleModel, variable: str, rule: int | None, parent: QWidget, phoneme: Phoneme = Phoneme.SILENCE
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Use in a Rule"))
        self._rules = rules
        mine = rules.preset.variables
        self.variable = choice(
            (f"{tr_engine(readable_name(name, mine))}  ({name})", name) for name in rules.variables
        )
        lines = [(f"{k + 1}  {sound_name(r.phoneme)}: {_words(r.conditions)}", k) for k, r in enumerate(rules.rules)]
        self.rule = choice([(tr("New rule"), None), *lines])
        self.phoneme = choice((sound_name(p), p) for p in Phoneme)
        self.place = NumberField(1, len(rules.rules) + 1)
        self.sign = choice((sign, sign) for sign in "<>")
        self.limit = NumberField(-LARGEST_FLOAT32, LARGEST_FLOAT32, decimals=6, waits=True)
        self.gain = label(wraps=True)
        self.gain.setMinimumWidth(360)
        self.gain.setMinimumHeight(4 * self.fontMetrics().height())
        self.buttons = dialog_buttons(self, CANCEL, verb=tr("Add"))
        self._again = QTimer(self, singleShot=True, interval=AGAIN_MS)
        self._again.timeout.connect(self._propose)
        self._form = QFormLayout(self)
        self.variable.setCurrentIndex(self.variable.findData(variable))
        self.rule.setCurrentIndex(self.rule.findData(rule))
        self.phoneme.setCurrentIndex(self.phoneme.findData(phoneme))
        self._lay_out()
        self._connect()
        self._propose()

    def draft(self, *, proposed: bool = False) -> Draft:
        """Return what is chosen; `proposed` leaves sign and limit open."""
        name, rule = str(self.variable.currentData()), self.rule.currentData()
        condition = Condition(name, str(self.sign.currentData()), limit=float(f"{self.limit.value():.6g}"))
        asked = None if proposed else condition
        if rule is None:
            return Draft(int(self.place.value()) - 1, name, Phoneme(self.phoneme.currentData()), asked)
        return Draft(int(rule), name, None, asked)

    @override
    def accept(self) -> None:
        self._rules.add(self.draft())
        super().accept()

    def _lay_out(self) -> None:
        for words, widget in (
            (tr("Variable"), self.variable),
            (tr("Rule"), self.rule),
            (tr("Phoneme"), self.phoneme),
            (tr("Place"), self.place),
        ):
            self._form.addRow(words, widget)
        self.place.setToolTip(tr("Number of the new rule: earlier rules decide first"))
        self.variable.setMinimumContentsLength(24)
        self.rule.setMinimumContentsLength(24)
        for box in (self.variable, self.rule):
            box.setSizeAdjustPolicy(box.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self._form.addRow(tr("Condition"), row(self.sign, (self.limit, 1)))
        self._form.addRow(self.gain)
        self._form.addRow(self.buttons)

    def _connect(self) -> None:
        for box in (self.variable, self.rule, self.phoneme):
            box.currentIndexChanged.connect(lambda _at: self._propose())
        self.place.valueChanged.connect(lambda _value: self._propose())
        self.sign.currentIndexChanged.connect(lambda _at: self._try())
        self.limit.valueChanged.connect(lambda _value: self._try())
        self._rules.tried.connect(self._show)

    def _propose(self) -> None:
        is_new = self.rule.currentData() is None
        self._form.setRowVisible(self.phoneme, is_new)
        self._form.setRowVisible(self.place, is_new)
        self._ask(self.draft(proposed=True))

    def _try(self) -> None:
        self._ask(self.draft())

    def _ask(self, draft: Draft) -> None:
        self._again.stop()
        if self._rules.try_out(draft):
            self.gain.setText(tr("Testing it on the labelled recordings…"))
        else:
            self._again.start()  # the open file may still be analysed
            self.gain.setText(
                tr(
                    "No labelled recording with this variable is loaded. With labels, the best limit is proposed "
                    "here, with its gain."
                )
            )

    def _show(self, trial: RuleTrial) -> None:
        if trial.condition.variable != self.variable.currentData():
            return
        with silent(self.sign, self.limit):
            self.sign.setCurrentIndex(self.sign.findData(trial.condition.sign))
            self.limit.setValue(trial.condition.limit)
        self.gain.setText(_in_words(trial.before, trial.after))


class RuleDialogs(QObject):
    """Opens the dialogs about rules.

    Signals
    -------
    find_asked : the user wants rules found in takes.
    """

    find_asked = Signal()

    def __init__(self, window: QWidget, rules: RuleModel) -> None:
        super().__init__(window)
        self._window, self._rules = window, rules

    def join(self, editor: RuleEditor, panel: VariablePanel, choose_recogniser: Callable[[str], object]) -> None:
        """Do what the editor and the panel of the variable ask for."""
        panel.use_asked.connect(self.ask_use)
        editor.condition_asked.connect(self.ask_condition)
        editor.from_takes_asked.connect(self.find_asked)
        editor.recogniser_asked.connect(choose_recogniser)

    def ask_condition(self, rule: int) -> None:
        """Let the user add a condition to a rule."""
        conditions = self._rules.rules[rule].conditions
        self._ask(conditions[-1].variable if conditions else self._rules.variables[0], rule)

    def ask_use(self, variable: str, phoneme: Phoneme) -> None:
        """Let the user use a variable in a rule; a new one is for that phoneme at first."""
        self._ask(variable, None, phoneme)

    def _ask(self, variable: str, rule: int | None, phoneme: Phoneme = Phoneme.SILENCE) -> None:
        if not self._rules.can_edit:
            sentence = tr(
                "The preset {name} has no rules of its own. Make its rules editable in the dock Rules, or begin with "
                "Extended rules or rules from takes."
            )
            self._rules.error.emit(sentence.format(name=self._rules.preset.name))
            return
        dialog = ConditionDialog(self._rules, variable, rule, self._window, phoneme)
        dialog.exec()
        dialog.deleteLater()


def _words(conditions: tuple[Condition, ...]) -> str:
    return ", ".join(f"{c.variable} {c.sign} {c.limit:.4g}" for c in conditions if c.enabled) or "–"


def _in_words(before: Agreement, after: Agreement) -> str:
    """Return what changes: macro F1, and the phonemes that gain and lose the most."""
    if math.isnan(before.macro_f1):
        return tr("The loaded recordings have no usable labels.")
    minutes = after.seconds / 60
    sentence = tr("Macro F1 {before:.1%} → {after:.1%} on everything loaded ({minutes:.1f} min).")
    lines = [sentence.format(before=before.macro_f1, after=after.macro_f1, minutes=minutes)]
    gains = {p: gain for p, gain in after.gains_over(before).items() if abs(gain) >= LEAST_CHANGE}
    if not gains:
        lines.append(tr("No phoneme changes. Choose a rule that the variable is to narrow, or another limit."))
    better = [p for p, gain in gains.items() if gain > 0][:MOST_NAMED]
    worse = [p for p, gain in reversed(gains.items()) if gain < 0][:MOST_NAMED]
    for words, phonemes in ((tr("Gain: {sounds}"), better), (tr("Loss: {sounds}"), worse)):
        if phonemes:
            lines.append(words.format(sounds=", ".join(f"{sound_name(p)} {100 * gains[p]:+.1f}" for p in phonemes)))
    return "\n".join(lines)
