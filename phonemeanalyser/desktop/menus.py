"""The menu bar, made from tables of commands."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from PySide6.QtCore import QSignalBlocker
from PySide6.QtGui import QAction, QActionGroup, QKeySequence, QUndoStack
from PySide6.QtWidgets import QMainWindow, QMenu

from phonemeanalyser.desktop.language import tr

NATIVE = QKeySequence.SequenceFormat.NativeText


@dataclass(frozen=True)
class Command:
    """An entry of a menu: its text in English, its key, and what it does; a checkable one is given its state."""

    text: str
    key: str
    act: Callable[..., Any]
    checkable: bool = False


class Menus:
    """The menus of a window.

    Attributes
    ----------
    actions : every action by its text in English.
    """

    def __init__(self, window: QMainWindow) -> None:
        self.actions: dict[str, QAction] = {}
        self._window = window
        self._menus: dict[str, QMenu] = {}
        self._keys: dict[str, str] = {}

    def add(self, title: str, *commands: Command) -> QMenu:
        """Add a menu."""
        menu = self._menus[title] = self._window.menuBar().addMenu(title)
        for command in commands:
            action = QAction(tr(command.text), self._window, checkable=command.checkable)
            action.setShortcut(QKeySequence(command.key))
            signal = action.toggled if command.checkable else action.triggered
            signal.connect(command.act if command.checkable else partial(_call, command.act))
            menu.addAction(action)
            self.actions[command.text] = action
            self._keys[command.text] = command.key
        return menu

    def add_edit(self, stack: QUndoStack) -> None:
        """Add the menu of undo and redo."""
        menu = self.add(tr("&Edit"))
        for action, key in (
            (stack.createUndoAction(self._window), QKeySequence.StandardKey.Undo),
            (stack.createRedoAction(self._window), QKeySequence.StandardKey.Redo),
        ):
            action.setShortcuts(QKeySequence.keyBindings(key))  # Ctrl+Y and Ctrl+Shift+Z
            menu.addAction(action)

    def add_choice(
        self, menu: QMenu, label: str, names: Mapping[str, str], chosen: str, act: Callable[[str], Any]
    ) -> None:
        """Add entries of which one at a time is chosen; `act` is given the chosen name, the key of its text."""
        group = QActionGroup(self._window)
        for name, text in names.items():
            action = QAction(f"{label}: {text}", self._window, checkable=True, checked=name == chosen)
            action.triggered.connect(partial(act, name))
            group.addAction(action)
            menu.addAction(action)

    def lend_key(self, text: str, *, lent: bool) -> None:
        """Leave an entry's key to something else for a while; the entry itself stays."""
        self.actions[text].setShortcut(QKeySequence("" if lent else self._keys[text]))

    def show_checked(self, text: str, on: bool) -> None:
        """Show an entry as on or off, without doing what it does."""
        with QSignalBlocker(self.actions[text]):
            self.actions[text].setChecked(on)

    def keys(self) -> dict[str, list[tuple[str, str]]]:
        """Return text and key of every entry, by menu."""
        return {
            menu.title().replace("&", ""): [
                (a.text().replace("&", ""), a.shortcut().toString(NATIVE)) for a in menu.actions() if a.isVisible()
            ]
            for menu in self._menus.values()
        }


def _call(act: Callable[[], Any], *_checked: bool) -> None:
    act()
