"""Each dialog says in its title what it is for, and names its one default button by what that does."""

import ast
from collections.abc import Callable

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QMessageBox, QPushButton

from phonemeanalyser.desktop.analyse.lanes.label_dialogs import TiersDialog
from phonemeanalyser.desktop.calibrate.page import MappingDialog
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.widgets.file_asker import ask_to_save
from phonemeengine.features.variables import Variable
from tests.conftest import ROOT
from tests.desktop.hands import shown

PLAIN = {"", "OK", "Yes", "No"}
"""What names no action."""


def defaults_of(dialog: QDialog) -> list[str]:
    """Give what the default buttons of a dialog say."""
    return [b.text().replace("&", "") for b in dialog.findChildren(QPushButton) if b.isDefault()]


def accepting(dialog: QDialog) -> list[str]:
    """Give what the buttons say that do what a dialog is for."""
    boxes = dialog.findChildren(QDialogButtonBox)
    roles = (QDialogButtonBox.ButtonRole.AcceptRole, QDialogButtonBox.ButtonRole.YesRole)
    return [b.text().replace("&", "") for box in boxes for b in box.buttons() if box.buttonRole(b) in roles]


def test_every_dialog_has_a_title_and_a_default_button_with_a_verb(desktop, qtbot, hand):
    window = shown(desktop, qtbot)
    dialogs, preset = window.dialogs, desktop.preset
    seen: dict[str, tuple[list[str], list[str]]] = {}

    def look(dialog: QDialog) -> None:
        box = isinstance(dialog, QMessageBox)
        title = dialog.windowTitle() or (dialog.text() if box else "")
        seen[title] = defaults_of(dialog), accepting(dialog)
        dialog.reject()

    hand.act = look
    desktop.session.view.select(TimeSpan(0.1, 0.3))
    asked: tuple[Callable[[], object], ...] = (
        lambda: dialogs.ask_variable(100, 200),
        dialogs.presets.ask_notes,
        dialogs.show_about,
        dialogs.record,
        lambda: ask_to_save(window, "Unsaved Changes", "Save changes?", lambda: True),
        lambda: TiersDialog(desktop.session.labels, window).exec(),
        lambda: MappingDialog({"zh": 3}, window).exec(),
    )
    for ask in asked:
        ask()
    preset.add_variable(Variable("own", 500.0, 900.0))
    dialogs.ask_remove_variable()
    dialogs.presets.show_ship()
    qtbot.waitUntil(lambda: "Ship Preset" in seen)
    dialogs.show_export()
    qtbot.waitUntil(lambda: "Export" in seen)
    assert len(seen) == len(asked) + 3
    assert [
        title for title, (defaults, accepts) in seen.items() if accepts and not set(defaults) & set(accepts)
    ] == []
    assert [title for title, (defaults, _) in seen.items() if len(defaults) > 1 or PLAIN & set(defaults)] == []


def test_every_class_of_dialogs_has_a_title_and_the_buttons_of_all_dialogs():
    paths = (ROOT / "phonemeanalyser" / "desktop").rglob("*.py")
    texts = [path.read_text("utf-8") for path in paths]
    nodes = [(text, node) for text in texts if "QDialog" in text for node in ast.walk(ast.parse(text))]
    found = {
        node.name: ast.get_source_segment(text, node) or ""
        for text, node in nodes
        if isinstance(node, ast.ClassDef) and any(ast.unparse(base).endswith("QDialog") for base in node.bases)
    }
    assert len(found) > 12
    assert [name for name, code in found.items() if "setWindowTitle(" not in code] == []
    of_all = [name for name, code in found.items() if "dialog_buttons(" in code]  # which makes one default at most
    assert {*found} - {*of_all} == {"ExportDialog"}  # which the test above shows
