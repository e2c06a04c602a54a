"""Rules as a tree: each rule with its conditions below it, edited in place, dragged and moved by keys."""

import math
from collections.abc import Sequence
from typing import Any

from PySide6 import QtWidgets
from PySide6.QtCore import QAbstractItemModel, QEvent, QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtGui import QColor, QDropEvent, QKeyEvent
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.rules import RuleModel
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.builders import silent
from phonemeanalyser.desktop.widgets.distribution import shortest
from phonemeengine.arrays import LARGEST_FLOAT32
from phonemeengine.features.variables import readable_name
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import DEFAULT_RULE, Condition, Rule, RuleFault, rule_labels
from phonemeengine.recognition.scores import RuleComparison, Trace

HEADINGS = (tr_noop("Rule"), "", tr_noop("Limit"), tr_noop("Now"))
NAME, SIGN, LIMIT, NOW = range(4)
WIDTHS = (0, 22, 70, 62)
"""Of the columns, pixels; 0 takes what is left."""
OWN_KEYS = {
    Qt.Key.Key_F2, Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Delete, Qt.Key.Key_Backspace, Qt.Key.Key_Space,
    Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Left, Qt.Key.Key_Right,
}  # fmt: skip
MOST_EXPANDED = 100
"""With more conditions, rules are shown without them at first."""
FAULTS = {
    RuleFault.CONTRADICTORY: tr_noop("can never hold"),
    RuleFault.COVERED: tr_noop("never reached"),
    RuleFault.NEVER: tr_noop("never holds here"),
    RuleFault.ALWAYS: tr_noop("always holds here"),
    RuleFault.UNREACHED: tr_noop("never decides here"),
}
"""What stands beside a rule; its tip says more."""
WRONG = {RuleFault.CONTRADICTORY, RuleFault.COVERED}
"""What is wrong whatever sound is loaded."""
VALUE = Qt.ItemDataRole.UserRole
Index = QModelIndex | QPersistentModelIndex


class _Delegate(QtWidgets.QStyledItemDelegate):
    """Edits the limit of a condition."""

    def __init__(self, tree: "RuleTree") -> None:
        super().__init__(tree)
        self._tree = tree

    @override
    def createEditor(
        self, parent: QtWidgets.QWidget, _option: QtWidgets.QStyleOptionViewItem, _index: Index
    ) -> QtWidgets.QWidget:
        return QtWidgets.QLineEdit(parent)

    @override
    def setEditorData(self, editor: QtWidgets.QWidget, index: Index) -> None:
        if isinstance(editor, QtWidgets.QLineEdit):
            editor.setText(f"{index.data(VALUE):g}")
            editor.selectAll()

    @override
    def setModelData(self, editor: QtWidgets.QWidget, _model: QAbstractItemModel, index: Index) -> None:
        if isinstance(editor, QtWidgets.QLineEdit):
            self._tree.type_limit(index, editor.text())


class RuleTree(QtWidgets.QTreeWidget):
    """Shows the rules in the order of decision; space switches, F2 or a double click edits, Delete deletes."""

    def __init__(self, rules: RuleModel, theme: Theme) -> None:
        super().__init__()
        self._rules, self._theme = rules, theme
        self._items: list[QtWidgets.QTreeWidgetItem] = []
        self._shown: tuple[Rule, ...] = ()
        self._shape: object = None
        self._written: list[object] = []
        self._judged: list[object] = []
        self._marked: tuple[RuleComparison, ...] | None = None
        self._only: Phoneme | None = None
        self._style()
        self.itemChanged.connect(self._switch)
        self.itemDoubleClicked.connect(self._edit)

    @property
    def current_rule(self) -> int | None:
        """The number of the rule that is chosen, or whose condition is; None where none is."""
        place = self._place_of(self.currentItem())
        return None if place is None else place[0]

    @property
    def current_condition(self) -> int | None:
        """The number of the condition that is chosen; None where none is."""
        place = self._place_of(self.currentItem())
        return None if place is None else place[1]

    # -- what is shown ------------------------------------------------------------------------------------

    def show_rules(self) -> None:
        """Show the rules as they are now; what is chosen and unfolded stays."""
        rules = self._rules.rules
        shape = self._rules.can_edit, self._rules.preset.variables, [len(rule.conditions) for rule in rules]
        with silent(self):
            if shape != self._shape:
                self._make_items(rules)
                self._shape = shape
                self._written, self._judged = [None] * len(rules), [None] * len(rules)
            for k, rule in enumerate(rules):  # hundreds of cells, of which a dragged limit changes few
                written = rule, [self._rules.limit_of(condition) for condition in rule.conditions]
                if written != self._written[k]:
                    self._show_rule(k, rule)
                    self._written[k], self._judged[k] = written, None
        self._marked, self._shown = None, rules
        self.show_only(self._only)
        self.show_faults()

    def show_faults(self) -> None:
        """Say beside each rule what is wrong with it."""
        rules, faults = self._rules.rules, self._rules.faults
        with silent(self):
            for k, (item, rule) in enumerate(zip(self._items, rules, strict=False)):
                fault = faults[k] if len(faults) == len(rules) else None
                judged = fault, self._otherwise(k, rule)
                if judged == self._judged[k]:
                    continue
                self._judged[k] = judged
                words = judged[1] if fault is None else f"  ⚠ {tr(FAULTS[fault])}"
                item.setText(NAME, f"{k + 1}  {sound_name(rule.phoneme)}{words}")
                told = "" if fault is None else f"{k + 1}  {sound_name(rule.phoneme)} {tr_engine(fault)}"
                item.setToolTip(NAME, f"<p>{told}</p><p>{self._words_of(rule)}</p>")
                item.setForeground(NAME, QColor(self._colour_of(rule.enabled, fault in WRONG)))

    def show_only(self, phoneme: Phoneme | None) -> None:
        """Show the rules for one phoneme, or all."""
        self._only = phoneme
        for item, rule in zip(self._items, self._rules.rules, strict=False):
            item.setHidden(phoneme is not None and rule.phoneme is not phoneme)

    def mark(self, trace: Trace | None) -> None:
        """Mark which comparisons hold in the current frame, and the rule that fired."""
        compared = () if trace is None else trace.comparisons
        if compared == self._marked:
            return
        self._marked = compared
        labels = rule_labels((*self._rules.rules, DEFAULT_RULE))
        found: dict[str, list[RuleComparison]] = {}
        for comparison in compared:
            found.setdefault(comparison.rule, []).append(comparison)
        with silent(self):
            for item, rule, name in zip(self._items, self._rules.rules, labels, strict=False):
                _set_bold(item, trace is not None and name == trace.rule)
                left = iter(found.get(name, ()))
                for child, condition in zip(_children(item), rule.conditions, strict=False):
                    self._mark_condition(child, next(left, None) if condition.enabled else None)
        self.viewport().update()

    def _mark_condition(self, item: QtWidgets.QTreeWidgetItem, comparison: RuleComparison | None) -> None:
        if comparison is None:
            item.setText(NOW, "")
            return
        holds = comparison.margin > 0
        item.setText(NOW, f"{shortest(comparison.value, 2)} {'✓' if holds else '✗'}")
        item.setForeground(NOW, QColor(self._theme.good if holds else self._theme.bad))

    def _make_items(self, rules: Sequence[Rule]) -> None:
        chosen = self._place_of(self.currentItem())
        unfolded = {rule: item.isExpanded() for rule, item in zip(self._shown, self._items, strict=False)}
        is_edited = any(rule in unfolded for rule in rules)
        self._items = []
        self.clear()
        few = sum(len(rule.conditions) for rule in rules) <= MOST_EXPANDED
        for rule in rules:
            item = QtWidgets.QTreeWidgetItem(self)
            self._items.append(item)
            item.addChildren([QtWidgets.QTreeWidgetItem() for _ in rule.conditions])
            item.setFirstColumnSpanned(True)
            item.setExpanded(unfolded.get(rule, True) if is_edited else few)
        if chosen is not None and rules:
            self.choose(min(chosen[0], len(rules) - 1), chosen[1])

    def choose(self, k: int, j: int | None = None) -> None:
        """Choose a rule, or one of its conditions."""
        if k < len(self._items):
            children = _children(self._items[k])
            self.setCurrentItem(children[j] if j is not None and j < len(children) else self._items[k])

    def _show_rule(self, k: int, rule: Rule) -> None:
        item, fixed = self._items[k], not self._rules.can_edit
        item.setData(NAME, VALUE, rule.phoneme)
        item.setData(NAME, Qt.ItemDataRole.DecorationRole, QColor(PHONEME_COLOURS[rule.phoneme]))
        _set_checked(item, rule.enabled, fixed=fixed, drags=True)
        for child, condition in zip(_children(item), rule.conditions, strict=True):
            self._show_condition(child, rule, condition, fixed=fixed)

    def _show_condition(
        self, item: QtWidgets.QTreeWidgetItem, rule: Rule, condition: Condition, *, fixed: bool
    ) -> None:
        limit = self._rules.limit_of(condition)
        name = tr_engine(readable_name(condition.variable, self._rules.preset.variables))
        for column, text, value in (
            (NAME, name, condition.variable),
            (SIGN, condition.sign, condition.sign),
            (LIMIT, f"{limit:.4g}", limit),
        ):
            item.setText(column, text)
            item.setData(column, VALUE, value)
            item.setForeground(column, QColor(self._colour_of(rule.enabled and condition.enabled, wrong=False)))
        item.setToolTip(NAME, f"<p>{condition.variable}: {name}</p>")
        item.setTextAlignment(LIMIT, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        item.setTextAlignment(NOW, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        _set_checked(item, condition.enabled, fixed=fixed, drags=False)

    def _otherwise(self, k: int, rule: Rule) -> str:
        """Return how a rule without conditions reads."""
        if any(c.enabled for c in rule.conditions) or not rule.enabled:
            return ""
        return "  " + (tr("otherwise") if k + 1 == len(self._rules.rules) else tr("always"))

    def _words_of(self, rule: Rule) -> str:
        asked = [f"{c.variable} {c.sign} {self._rules.limit_of(c):.4g}" for c in rule.conditions if c.enabled]
        return "<br>".join(f"<nobr>{words.replace('<', '&lt;')}</nobr>" for words in asked)

    def _colour_of(self, enabled: bool, wrong: bool) -> str:
        return self._theme.bad if wrong else self._theme.text if enabled else self._theme.faint

    # -- what is changed ----------------------------------------------------------------------------------

    def _choices(self, item: QtWidgets.QTreeWidgetItem, column: int) -> list[tuple[str, Any]]:
        """Return what a cell may hold."""
        if item.parent() is None:
            return [(sound_name(p), p) for p in Phoneme]
        if column == SIGN:
            return [(sign, sign) for sign in "<>"]
        mine = self._rules.preset.variables
        return [(f"{tr_engine(readable_name(name, mine))}  ({name})", name) for name in self._rules.variables]

    def _offer(self, item: QtWidgets.QTreeWidgetItem, column: int) -> None:
        """Let the user choose what a cell holds, from a menu below it."""
        menu, index = QtWidgets.QMenu(self), self.indexFromItem(item, column)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for text, value in self._choices(item, column):
            action = menu.addAction(text.replace("&", "&&"))
            action.triggered.connect(lambda _on, value=value: self.take_value(index, value))
            if value == item.data(column, VALUE):
                menu.setActiveAction(action)
        menu.popup(self.viewport().mapToGlobal(self.visualRect(index).bottomLeft()))

    def take_value(self, index: Index, value: Any) -> None:
        """Take what was entered in a cell."""
        place = self._place_of(self.itemFromIndex(index))
        if place is None or value is None or value == index.data(VALUE):
            return
        k, j = place
        if j is None:
            self._rules.set_rule(k, phoneme=Phoneme(value))
        elif index.column() != LIMIT:
            self._rules.set_condition(k, j, **{"variable" if index.column() == NAME else "sign": str(value)})
        else:
            self._rules.set_condition(k, j, limit=float(value))

    def type_limit(self, index: Index, text: str) -> None:
        """Take a limit as it was typed; what is no number is refused in a sentence."""
        try:
            limit = float(text.replace(",", "."))
        except ValueError:
            limit = math.nan
        if abs(limit) <= LARGEST_FLOAT32:
            self.take_value(index, limit)
        else:
            words = tr("{name} is a number, such as 0.25; found {text}")
            self._rules.error.emit(words.format(name=tr("Limit"), text=text[:40]))

    def add_rule(self) -> None:
        """Add a rule in front of the one that is chosen, for the same phoneme."""
        k = self.current_rule or 0
        self._rules.add_rule(k, self._only or self._rules.rules[k].phoneme)
        self.choose(k)

    def duplicate(self) -> None:
        """Duplicate the rule that is chosen."""
        if (k := self.current_rule) is not None:
            self._rules.duplicate(k)
            self.choose(k + 1)

    def delete(self) -> None:
        """Delete the condition or the rule that is chosen."""
        k, j = self.current_rule, self.current_condition
        if k is not None and j is not None:
            self._rules.delete_condition(k, j)
        elif k is not None:
            self._rules.delete(k)

    def shift(self, by: int) -> None:
        """Have the rule that is chosen decide earlier or later."""
        k = self.current_rule
        if k is not None and 0 <= k + by < len(self._rules.rules):
            self._move(k, k + by)

    def _move(self, k: int, to: int) -> None:
        self._rules.move(k, to)
        self.choose(to)

    def _switch(self, item: QtWidgets.QTreeWidgetItem, column: int) -> None:
        place = self._place_of(item)
        if place is None or column != NAME or not self._rules.can_edit:
            return
        k, j = place
        on, rule = item.checkState(NAME) == Qt.CheckState.Checked, self._rules.rules[k]
        if j is None and on != rule.enabled:
            self._rules.set_rule(k, enabled=on)
        elif j is not None and on != rule.conditions[j].enabled:
            self._rules.set_condition(k, j, enabled=on)

    def _edit(self, item: QtWidgets.QTreeWidgetItem, column: int) -> None:
        if item.parent() is not None and column == LIMIT:
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsEditable)
            self.editItem(item, column)
            with silent(self):
                item.setFlags(item.flags() & ~Qt.ItemFlag.ItemIsEditable)
        elif column != NOW and self._rules.can_edit:
            self._offer(item, NAME if item.parent() is None else column)

    @override
    def event(self, event: QEvent) -> bool:
        """Keep keys to itself that mean something else in the menus."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent) and self._is_own(event):
            event.accept()
            return True
        return super().event(event)

    @staticmethod
    def _is_own(event: QKeyEvent) -> bool:
        key, modifiers = Qt.Key(event.key()), event.modifiers()
        if modifiers & Qt.KeyboardModifier.AltModifier:
            return key in {Qt.Key.Key_Up, Qt.Key.Key_Down}
        if modifiers & Qt.KeyboardModifier.ControlModifier:
            return key == Qt.Key.Key_D
        return key in OWN_KEYS

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move, duplicate, delete or edit what is chosen; other letters are the page's."""
        key, modifiers = Qt.Key(event.key()), event.modifiers()
        steps = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}
        item = self.currentItem()
        if self.state() == QtWidgets.QAbstractItemView.State.EditingState:
            event.ignore()  # Return, which ends the editing
        elif modifiers & Qt.KeyboardModifier.AltModifier and key in steps and self._rules.can_edit:
            self.shift(steps[key])
        elif key == Qt.Key.Key_D and modifiers & Qt.KeyboardModifier.ControlModifier and self._rules.can_edit:
            self.duplicate()
        elif key in {Qt.Key.Key_Delete, Qt.Key.Key_Backspace} and self._rules.can_edit:
            self.delete()
        elif key == Qt.Key.Key_Left and item is not None and self.currentColumn() > NAME:
            self.setCurrentItem(item, self.currentColumn() - 1)
        elif key in {Qt.Key.Key_F2, Qt.Key.Key_Return, Qt.Key.Key_Enter} and item is not None:
            column = self.currentColumn() if item.parent() is not None and self.currentColumn() != NOW else NAME
            self._edit(item, LIMIT if item.parent() is not None and not self._rules.can_edit else column)
        elif event.text().isalpha():
            event.ignore()
        else:
            super().keyPressEvent(event)

    @override
    def dropEvent(self, event: QDropEvent) -> None:
        """Move the rule that was dragged to before or behind the one on whose upper or lower half it is dropped."""
        at = event.position().toPoint()
        k, target = self.current_rule, self.itemAt(at)
        place = self._place_of(target)
        to = len(self._rules.rules) if place is None else place[0]
        below = target is not None and at.y() > self.visualItemRect(target).center().y()
        if place is not None and (below or place[1] is not None):
            to += 1
        event.setDropAction(Qt.DropAction.IgnoreAction)  # the tree is made anew from the rules
        event.accept()
        if k is not None and (to := to - (to > k)) != k:
            self._move(k, to)

    def _place_of(self, item: QtWidgets.QTreeWidgetItem | None) -> tuple[int, int | None] | None:
        """Return the numbers of rule and condition that an item shows; None where it shows none."""
        if item is None:
            return None
        above = item.parent()
        if above is None:
            return self.indexOfTopLevelItem(item), None
        return self.indexOfTopLevelItem(above), above.indexOfChild(item)

    def _style(self) -> None:
        self.setColumnCount(len(HEADINGS))
        self.setHeaderLabels([tr(heading) if heading else "" for heading in HEADINGS])
        self.setAccessibleName(tr("Rules"))
        self.setItemDelegate(_Delegate(self))
        header = self.header()
        header.setMinimumSectionSize(20)
        header.setStretchLastSection(False)
        for column, width in enumerate(WIDTHS):
            header.setSectionResizeMode(
                column, QtWidgets.QHeaderView.ResizeMode.Fixed if width else QtWidgets.QHeaderView.ResizeMode.Stretch
            )
            if width:
                header.resizeSection(column, width)
        self.setIndentation(14)
        self.setUniformRowHeights(True)
        self.setSelectionBehavior(
            QtWidgets.QAbstractItemView.SelectionBehavior.SelectItems
        )  # Right goes on to the next cell
        self.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setDragDropMode(QtWidgets.QAbstractItemView.DragDropMode.InternalMove)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setMinimumHeight(140)


def _children(item: QtWidgets.QTreeWidgetItem) -> list[QtWidgets.QTreeWidgetItem]:
    return [child for j in range(item.childCount()) if (child := item.child(j)) is not None]


def _set_checked(item: QtWidgets.QTreeWidgetItem, on: bool, *, fixed: bool, drags: bool) -> None:
    flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
    if not fixed:
        flags |= Qt.ItemFlag.ItemIsUserCheckable | Qt.ItemFlag.ItemIsDropEnabled
        flags |= Qt.ItemFlag.ItemIsDragEnabled if drags else Qt.ItemFlag.NoItemFlags
        item.setCheckState(NAME, Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
    else:
        item.setData(NAME, Qt.ItemDataRole.CheckStateRole, None)
    item.setFlags(flags)


def _set_bold(item: QtWidgets.QTreeWidgetItem, on: bool) -> None:
    font = item.font(NAME)
    if font.bold() != on:
        font.setBold(on)
        item.setFont(NAME, font)
