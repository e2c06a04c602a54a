"""The editor of rules: what it shows, what it changes, and what it says of rules of no use."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDockWidget, QLineEdit, QMenu, QTreeWidgetItem

from phonemeanalyser.desktop.analyse.recognition.rule_editor import RuleEditor
from phonemeanalyser.desktop.analyse.recognition.rule_tree import LIMIT, NAME, NOW, SIGN, RuleTree
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.rule_dialogs import ConditionDialog
from phonemeanalyser.desktop.session.rules import RuleTrial
from phonemeengine.labels.files import write_labels
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import THESIS_PRESET, load_preset, save_preset
from phonemeengine.recognition.rules import RULES, Condition, Rule, RuleFault
from tests.desktop.hands import CARDS, LEFT, press, shown
from tests.labelled import recording

ALT, CONTROL = Qt.KeyboardModifier.AltModifier, Qt.KeyboardModifier.ControlModifier
QUIET = Condition("volume", "<", limit=0.05)
OWN = (
    Rule(Phoneme.SILENCE, (QUIET,)),
    Rule(Phoneme.SZ, (Condition("zero_crossings", ">", limit=300.0), Condition("energy", ">", limit=0.1))),
    Rule(Phoneme.A, ()),
)


@pytest.fixture
def window(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    next(dock for dock in window.findChildren(QDockWidget) if dock.objectName() == "Rules").raise_()
    QApplication.processEvents()
    return window


@pytest.fixture
def editor(desktop, window, tmp_path) -> RuleEditor:
    """The editor on a preset with three rules of its own."""
    path = tmp_path / "own.toml"
    save_preset(replace(load_preset(THESIS_PRESET), recogniser="rules", rules=OWN), path)
    desktop.preset.load(path)
    window.analysis.rules.tree.setFocus()
    return window.analysis.rules


def item(editor: RuleEditor, k: int, j: int | None = None) -> QTreeWidgetItem:
    found = editor.tree.topLevelItem(k)
    return found if j is None else found.child(j)


def texts(editor: RuleEditor) -> list[str]:
    return [item(editor, k).text(NAME) for k in range(editor.tree.topLevelItemCount())]


def enter(editor: RuleEditor, at: QTreeWidgetItem, column: int, value: object) -> None:
    """Edit a cell in place as a user does: F2, then the list or the line."""
    editor.tree.setFocus()
    editor.tree.setCurrentItem(at, column)
    press(editor.tree, Qt.Key.Key_F2)
    if column == LIMIT:
        field = editor.tree.viewport().findChildren(QLineEdit)[-1]
        QTest.keyClicks(field, str(value))  # over what is there
        press(field, Qt.Key.Key_Return)
        QApplication.processEvents()  # Qt commits what was typed a moment later
        return
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    words = sound_name(value) if isinstance(value, Phoneme) else str(value)
    next(a for a in menu.actions() if a.text() == words or a.text().endswith(f"({words})")).trigger()
    menu.close()


def test_rules_are_listed_in_the_order_of_decision_and_edited_in_place_and_undone(desktop, editor):
    assert texts(editor) == ["1  silence", "2  s", "3  a  otherwise"]
    condition, told = item(editor, 1, 0), list[str]()
    assert [condition.text(column) for column in (NAME, SIGN, LIMIT)] == ["zero crossings", ">", "300"]
    assert not editor.words.isVisibleTo(editor)
    editor.tree.choose(0, 0)
    for key, column in ((Qt.Key.Key_Right, SIGN), (Qt.Key.Key_Right, LIMIT), (Qt.Key.Key_Left, SIGN)):
        press(editor.tree, key)
        assert (editor.tree.current_condition, editor.tree.currentColumn()) == (0, column)
    for at, column, value, expected in (
        ((0, None), NAME, Phoneme.P, Rule(Phoneme.P, (QUIET,))),
        ((0, 0), NAME, "energy", Rule(Phoneme.SILENCE, (replace(QUIET, variable="energy"),))),
        ((0, 0), SIGN, ">", Rule(Phoneme.SILENCE, (replace(QUIET, sign=">"),))),
        ((0, 0), LIMIT, "0,25", Rule(Phoneme.SILENCE, (replace(QUIET, limit=0.25),))),
    ):
        enter(editor, item(editor, *at), column, value)
        assert desktop.preset.preset.rules == (expected, *OWN[1:])
        desktop.preset.undo_stack.undo()
        assert desktop.preset.preset.rules == OWN
        assert texts(editor)[0] == "1  silence"
    desktop.session.rules.error.connect(told.append)
    enter(editor, item(editor, 0, 0), LIMIT, "much")
    assert desktop.preset.preset.rules == OWN
    assert told == ["Limit is a number, such as 0.25; found much"]


def test_rules_move_by_keys_and_are_duplicated_and_deleted_but_the_last(desktop, editor):
    first, second, third = OWN
    editor.tree.choose(1)
    press(editor.tree, Qt.Key.Key_Up, ALT)
    assert desktop.preset.preset.rules == (second, first, third)
    assert editor.tree.current_rule == 0
    press(editor.tree, Qt.Key.Key_D, CONTROL)
    assert desktop.preset.preset.rules == (second, second, first, third)
    press(editor.tree, Qt.Key.Key_Delete)
    editor.tree.choose(0)
    press(editor.tree, Qt.Key.Key_Down, ALT)
    assert desktop.preset.preset.rules == (first, second, third)
    editor.tree.choose(1, 0)
    press(editor.tree, Qt.Key.Key_Delete)
    assert desktop.preset.preset.rules[1] == replace(second, conditions=second.conditions[1:])
    for _ in range(5):
        desktop.preset.undo_stack.undo()
    assert desktop.preset.preset.rules == OWN
    editor.tree.choose(0)
    for _ in range(5):
        press(editor.tree, Qt.Key.Key_Delete)
    assert len(desktop.preset.preset.rules) == 1
    assert not editor.delete.isEnabled()


def drag(tree: RuleTree, k: int, to: QPoint) -> None:
    """Take hold of a rule with the mouse, and let it go elsewhere; no drag lasts without a display."""
    start = tree.visualItemRect(tree.topLevelItem(k)).center()
    QTest.mousePress(tree.viewport(), LEFT, pos=start)
    data, none = tree.model().mimeData(tree.selectedIndexes()), Qt.KeyboardModifier.NoModifier
    tree.dropEvent(QDropEvent(to.toPointF(), Qt.DropAction.MoveAction, data, LEFT, none))
    QTest.mouseRelease(tree.viewport(), LEFT, pos=start)


def test_rules_are_dragged_to_between_or_behind_others(desktop, editor):
    tree, (first, second, third) = editor.tree, OWN
    top = tree.visualItemRect(item(editor, 0)).topLeft()
    drag(tree, 1, top + QPoint(20, 1))
    assert desktop.preset.preset.rules == (second, first, third)
    assert tree.current_rule == 0
    assert texts(editor) == ["1  s", "2  silence", "3  a  otherwise"]
    drag(tree, 0, tree.visualItemRect(item(editor, 1)).bottomLeft() + QPoint(20, -1))  # below it
    assert desktop.preset.preset.rules == OWN
    drag(tree, 0, tree.visualItemRect(item(editor, 1, 0)).center())  # among the conditions of another one
    assert desktop.preset.preset.rules == (second, first, third)
    desktop.preset.undo_stack.undo()
    drag(tree, 0, QPoint(20, tree.viewport().height() - 2))  # below all
    assert desktop.preset.preset.rules == (second, third, first)
    drag(tree, 1, tree.visualItemRect(item(editor, 1)).center())  # where it was
    assert desktop.preset.preset.rules == (second, third, first)
    for _ in range(3):
        desktop.preset.undo_stack.undo()
    assert desktop.preset.preset.rules == OWN


def test_rules_are_switched_off_and_kept_in_the_file_and_a_new_one_is_off(desktop, window, editor, tmp_path):
    editor.phoneme.setCurrentIndex(editor.phoneme.findData(Phoneme.SZ))  # the rules for one phoneme alone
    assert [item(editor, k).isHidden() for k in range(3)] == [True, False, True]
    editor.phoneme.setCurrentIndex(0)
    editor.tree.choose(2)
    editor.add.click()
    assert desktop.preset.preset.rules[2:] == (Rule(Phoneme.A, (), enabled=False), OWN[2])
    assert editor.tree.current_rule == 2
    desktop.preset.undo_stack.undo()
    item(editor, 0).setCheckState(NAME, Qt.CheckState.Unchecked)
    item(editor, 1, 1).setCheckState(NAME, Qt.CheckState.Unchecked)
    off = replace(OWN[0], enabled=False)
    half = replace(OWN[1], conditions=(OWN[1].conditions[0], replace(OWN[1].conditions[1], enabled=False)))
    assert desktop.preset.preset.rules == (off, half, OWN[2])
    desktop.preset.save(tmp_path / "kept.toml")
    assert load_preset(tmp_path / "kept.toml").rules == (off, half, OWN[2])
    docks = {dock.objectName(): dock for dock in window.findChildren(QDockWidget)}
    docks["Thresholds"].raise_()
    QApplication.processEvents()
    desktop.preset.edit(replace(desktop.preset.preset, rules=OWN[::2]), "test")
    assert len(texts(editor)) == 3  # it lies behind another dock
    docks["Rules"].raise_()
    QApplication.processEvents()
    assert texts(editor) == ["1  silence", "2  a  otherwise"]


def test_what_is_wrong_with_a_rule_is_said_beside_it_and_the_decision_is_marked(desktop, window, editor, qtbot):
    rules, preset = desktop.session.rules, desktop.preset
    contrary = replace(OWN[0], conditions=(QUIET, replace(QUIET, sign=">", limit=0.1)))
    hidden = replace(OWN[0], conditions=(replace(QUIET, limit=0.01),))
    preset.edit(replace(preset.preset, rules=(contrary, OWN[0], hidden, OWN[2])), "test")
    qtbot.waitUntil(lambda: len(rules.faults) == 4)
    assert rules.faults == (RuleFault.CONTRADICTORY, None, RuleFault.COVERED, None)
    assert texts(editor)[0] == "1  silence  ⚠ can never hold"
    assert texts(editor)[2] == "3  silence  ⚠ never reached"
    assert "2 rules" in editor.faults.text()
    window.dialogs.open_sound(CARDS)
    loud = replace(OWN[0], conditions=(replace(QUIET, sign=">", limit=7.0),))
    preset.edit(replace(preset.preset, rules=(loud, *OWN)), "test")
    qtbot.waitUntil(lambda: rules.faults[:1] == (RuleFault.NEVER,))
    assert texts(editor)[0] == "1  silence  ⚠ never holds here"
    preset.edit(replace(preset.preset, rules=OWN), "test")
    desktop.session.analyse_until(1.0)
    trace = desktop.session.results.explain()
    editor.tree.mark(trace)
    compared = {(c.rule, c.variable): c for c in trace.comparisons}
    holds = compared["silence", "volume"].margin > 0
    assert item(editor, 0, 0).text(NOW).endswith("✓" if holds else "✗")
    fired = {"silence": 0, "sz": 1, "a": 2}[trace.rule]
    assert [item(editor, k).font(NAME).bold() for k in range(3)] == [k == fired for k in range(3)]


def test_rules_of_the_thesis_show_numbers_that_can_be_edited_and_become_own_rules(desktop, window):
    editor = window.analysis.rules
    assert len(texts(editor)) == len(RULES)
    assert not editor.buttons.isVisibleTo(editor)
    assert "fixed" in editor.words.text()
    enter(editor, item(editor, 1, 1), LIMIT, "7.5")
    assert desktop.preset.preset.thresholds.sz_s1 == 7.5
    assert item(editor, 1, 1).text(LIMIT) == "7.5"
    editor.begin.click()
    preset = desktop.preset.preset
    assert preset.recogniser == "rules"
    assert [rule.phoneme for rule in preset.rules] == [rule.phoneme for rule in RULES]
    assert preset.rules[1].conditions[1] == Condition("m_s1", ">", limit=7.5)
    assert editor.buttons.isVisibleTo(editor)


def test_a_preset_without_rules_of_its_own_says_what_to_do(desktop, window):
    said: list[str] = []
    desktop.session.rules.error.connect(said.append)
    window.rule_dialogs.ask_use("energy", Phoneme.A)
    assert len(said) == 1
    assert "has no rules of its own" in said[0]
    desktop.preset.set_recogniser("templates")
    editor = window.analysis.rules
    assert "has no rules. Begin with rules from takes" in editor.words.text()
    assert not editor.tree.isVisibleTo(editor)
    editor.begin.click()
    assert desktop.preset.preset.recogniser == "rules"
    assert editor.tree.isVisibleTo(editor)


def test_a_condition_is_added_with_the_limit_that_gains_most_on_the_labels_beside_the_file(
    desktop, window, editor, qtbot, tmp_path
):
    spoken = recording(tmp_path / "said.wav")
    write_labels(spoken.labels, tmp_path / "said.csv")
    window.dialogs.open_sound(spoken.path)
    desktop.preset.edit(replace(desktop.preset.preset, rules=(OWN[0], OWN[2])), "test")
    rules = desktop.session.rules
    qtbot.waitUntil(lambda: not desktop.session.busy)
    trials: list[RuleTrial] = []
    rules.tried.connect(trials.append)
    dialog = ConditionDialog(rules, "zero_crossings", None, window, Phoneme.SZ)
    assert dialog.draft().phoneme is Phoneme.SZ
    dialog.place.setValue(2)
    qtbot.waitUntil(lambda: bool(trials) and trials[-1].after.f1_of(Phoneme.SZ) > 0.8)
    assert trials[-1].after.macro_f1 > trials[-1].before.macro_f1
    assert "s +" in dialog.gain.text()
    dialog.accept()
    first, added, last = desktop.preset.preset.rules
    assert added.phoneme is Phoneme.SZ
    assert (added.conditions[0].variable, added.conditions[0].sign) == ("zero_crossings", ">")
    assert added.conditions[0].limit == pytest.approx(trials[-1].condition.limit, rel=1e-4)
    assert (first, last) == (OWN[0], OWN[2])
