"""The menu bar, made from tables of commands."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from PySide6.QtGui import QAction, QActionGroup, QKeySequence, QUndoStack
from PySide6.QtWidgets import QMainWindow, QMenu

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.builders import silent

NATIVE = QKeySequence.SequenceFormat.NativeText


@dataclass(frozen=True)
class Command:
    """An entry of a menu.

    Attributes
    ----------
    text : in English.
    key : how it is written in English; empty where there is none.
    act : what is done; that of a checkable entry is given its state.
    repeats : whether it is done again and again while the key is held.
    """

    text: str
    key: str
    act: Callable[..., Any]
    checkable: bool = False
    repeats: bool = False

    @property
    def of_views(self) -> bool:
        """Whether its key, a letter or one that edits, counts only while the Analyse page is seen."""
        edits = self.key in {"Delete", "F2", "F3", "F4", "Shift+Space"} or self.key.startswith("Alt+")
        return len(self.key.removeprefix("Shift+")) == 1 or edits


Commands = tuple[Command | None, ...]


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
        self._of_views: list[str] = []

    def add(self, title: str, *commands: Command | QAction | None, within: QMenu | None = None) -> QMenu:
        """Add a menu, maybe within another one; None is a line between groups of seven entries at most."""
        menu = self._menus[title] = (within or self._window.menuBar()).addMenu(title)
        self.fill(menu, *commands)
        return menu

    def fill(self, menu: QMenu, *commands: Command | QAction | None) -> None:
        """Add entries to a menu; None is a line between groups."""
        for command in commands:
            if command is None:
                menu.addSeparator()
                continue
            if isinstance(command, QAction):
                menu.addAction(command)
                continue
            action = QAction(tr(command.text), self._window, checkable=command.checkable)
            action.setShortcut(QKeySequence(command.key))
            action.setAutoRepeat(command.repeats)
            signal = action.toggled if command.checkable else action.triggered
            signal.connect(command.act if command.checkable else partial(_call, command.act))
            menu.addAction(action)
            self.actions[command.text] = action
            self._keys[command.text] = command.key
            if command.of_views:
                self._of_views.append(command.text)

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

    def lend_keys_of_views(self, *, lent: bool) -> None:
        """Take the plain keys that belong to the Analyse page away while another one is seen, or give them back."""
        for text in self._of_views:
            self.lend_key(text, lent=lent)

    def show_checked(self, text: str, on: bool) -> None:
        """Show an entry as on or off, without doing what it does."""
        with silent(self.actions[text]):
            self.actions[text].setChecked(on)

    def keys(self) -> dict[str, list[tuple[str, str]]]:
        """Return text and key of every entry, by menu; of a key that is lent, too."""
        known = {self.actions[text]: QKeySequence(key) for text, key in self._keys.items()}
        return {
            menu.title().replace("&", ""): [
                (a.text().replace("&", ""), known.get(a, a.shortcut()).toString(NATIVE))
                for a in menu.actions()
                if a.isVisible() and not a.isSeparator()
            ]
            for menu in self._menus.values()
        }


def _call(act: Callable[[], Any], *_checked: bool) -> None:
    act()
