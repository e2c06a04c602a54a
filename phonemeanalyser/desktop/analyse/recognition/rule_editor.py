"""The rules of the preset in use, in the order of decision: seen beside the current frame, and edited in place."""

from collections.abc import Callable

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import QLabel, QMenu, QPushButton, QToolButton, QWidget

from phonemeanalyser.desktop.analyse.recognition.rule_tree import WRONG, RuleTree
from phonemeanalyser.desktop.engine_words import recogniser_title, sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_count
from phonemeanalyser.desktop.session.rules import RuleModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import choice, column, label, leave_wheel, row, tab_buttons, tool_button
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import Trace

EXTENDED = "rules"
"""The recogniser that one may begin with who has no rules."""


class RuleEditor(QWidget):
    """Lists rules and their conditions, with what is wrong and what holds right now.

    Signals
    -------
    condition_asked : the user wants to add a condition to the rule of this number.
    from_takes_asked : the user wants rules from takes.
    recogniser_asked : the user wants to begin with the rules of this recogniser.
    """

    condition_asked = Signal(int)
    from_takes_asked = Signal()
    recogniser_asked = Signal(str)

    def __init__(self, rules: RuleModel, theme: Theme) -> None:
        super().__init__()
        self._rules, self._theme = rules, theme
        self._seen = True
        self.tree = RuleTree(rules, theme)
        sounds = [(tr("All phonemes"), None), *((sound_name(p), p) for p in Phoneme)]
        self.phoneme = choice(sounds, tr("Phoneme"), tr("Show the rules for this phoneme only"))
        self.add = tool_button("+", tr("Add a rule in front of the current one. It is off until it has a condition."))
        self.condition = tool_button(tr("Condition…"), tr("Add a condition to the current rule"))
        self.duplicate = tool_button(tr("Duplicate"), tr("Duplicate the current rule (Ctrl+D)"))
        self.delete = tool_button("×", tr("Delete the current rule or condition (Delete)"))
        self.up, self.down = (
            tool_button("▲", tr("Move up, to decide earlier (Alt+Up, or drag)")),
            tool_button("▼", tr("Move down, to decide later (Alt+Down, or drag)")),
        )
        self.from_takes = QPushButton(tr("Rules from Takes…"))
        self.from_takes.setToolTip(tr("Find a few rules in the loaded takes and recordings, on the Calibrate page"))
        self.begin = QPushButton()
        self.words, self.faults = label(wraps=True), QLabel()
        self._lay_out()
        self._connect()
        self._show()

    def refresh(self, trace: Trace | None) -> None:
        """Mark what holds in the current frame, as the decision beside the phoneme says."""
        if self.tree.isVisible():
            self.tree.mark(trace)

    def _lay_out(self) -> None:
        self.faults.setStyleSheet(f"color: {self._theme.bad}")
        self.faults.setWordWrap(True)
        buttons = (self.add, self.condition, self.duplicate, self.delete, self.up, self.down)
        for button in (*buttons, self.from_takes, self.begin):
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        tab_buttons(self.from_takes, self.begin)
        self.buttons = QWidget()
        row(*buttons, 1, on=self.buttons, spacing=2)
        column(
            self.phoneme, self.words, self.begin, (self.tree, 1), self.faults, self.buttons, self.from_takes,
            on=self, margins=(6, 4, 6, 6), spacing=4,
        )  # fmt: skip
        self.phoneme.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        leave_wheel(self)

    def _connect(self) -> None:
        rules, tree = self._rules, self.tree
        rules.changed.connect(self._show)
        rules.checked.connect(self._show_faults)
        self.phoneme.currentIndexChanged.connect(lambda _at: tree.show_only(self.phoneme.currentData()))
        self.from_takes.clicked.connect(self.from_takes_asked)
        self.begin.clicked.connect(self._start)
        acts: dict[QToolButton, Callable[[], object]] = {
            self.add: tree.add_rule,
            self.condition: self._ask_condition,
            self.duplicate: tree.duplicate,
            self.delete: tree.delete,
            self.up: lambda: tree.shift(-1),
            self.down: lambda: tree.shift(1),
        }
        for button, act in acts.items():
            button.clicked.connect(lambda _checked, act=act: act())
        tree.currentItemChanged.connect(lambda *_items: self._show_state())
        tree.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        tree.customContextMenuRequested.connect(self._show_menu)

    def set_seen(self, seen: bool) -> None:
        """Take note of whether the user sees the editor; while not, its hundreds of cells are left as they are."""
        self._seen = seen
        self._show()

    def _show(self) -> None:
        if not self._seen:
            return
        rules, preset = self._rules, self._rules.preset
        has_rules = bool(rules.rules)
        for widget in (self.tree, self.phoneme):
            widget.setVisible(has_rules)
        self.buttons.setVisible(rules.can_edit)
        self.words.setVisible(not rules.can_edit)
        self.begin.setVisible(not rules.can_edit)
        if has_rules:
            self.words.setText(tr("The rules of the thesis are fixed; their numbers can be edited."))
            self.begin.setText(tr("Make Editable"))
            self.begin.setToolTip(tr("Turn them into rules of your own that recognise the same"))
        else:
            sentence = tr("The recogniser {name} has no rules. Begin with rules from takes, or with Extended rules.")
            self.words.setText(sentence.format(name=recogniser_title(preset.recogniser)))
            self.begin.setText(tr("Begin with Extended Rules"))
            self.begin.setToolTip(tr("Recognise with Extended rules; undo brings the preset back"))
        self.tree.show_rules()
        self._show_faults()
        self._show_state()

    def _show_faults(self) -> None:
        # What only does not happen in the sound that is loaded is said beside its rule, and no alarm.
        faults = [f"{k + 1} {tr_engine(fault)}" for k, fault in enumerate(self._rules.faults) if fault in WRONG]
        self.faults.setVisible(bool(faults))
        words = tr_count("1 rule needs attention (⚠).", "{n} rules need attention (⚠).", len(faults))
        self.faults.setText(words if faults else "")
        self.faults.setToolTip("\n".join(faults))
        self.tree.show_faults()

    def _show_state(self) -> None:
        k, n = self.tree.current_rule, len(self._rules.rules)
        self.condition.setEnabled(k is not None)
        self.duplicate.setEnabled(k is not None)
        self.delete.setEnabled(k is not None and (n > 1 or self.tree.current_condition is not None))
        self.up.setEnabled(k is not None and k > 0)
        self.down.setEnabled(k is not None and k + 1 < n)

    def _start(self) -> None:
        if self._rules.rules:
            self._rules.make_own()
        else:
            self.recogniser_asked.emit(EXTENDED)

    def _ask_condition(self) -> None:
        if self.tree.current_rule is not None:
            self.condition_asked.emit(self.tree.current_rule)

    def _show_menu(self, at: QPoint) -> None:
        if not self._rules.can_edit:
            return
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for words, button in (
            (tr("Add Rule"), self.add),
            (tr("Add Condition…"), self.condition),
            (tr("Duplicate Rule"), self.duplicate),
            (tr("Delete"), self.delete),
            (tr("Move Up"), self.up),
            (tr("Move Down"), self.down),
        ):
            menu.addAction(words, button.click).setEnabled(button.isEnabled())
        menu.popup(self.tree.viewport().mapToGlobal(at))
