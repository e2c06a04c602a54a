"""Undo and redo on the page of the calibration: of the takes and of the preset, whichever changed last."""

from itertools import count

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from phonemeanalyser.desktop.calibrate.takes_model import TakesModel


class UndoOrder(QObject):
    """Remembers in which order takes and preset were changed.

    Parameters
    ----------
    owner : lives no longer than takes and stack: a stack tells of its own end, and nobody may be listening then.
    takes, stack : what is watched.

    Signals
    -------
    changed : what would be undone or redone is something else.
    """

    changed = Signal()

    def __init__(self, owner: QObject, takes: TakesModel, stack: QUndoStack) -> None:
        super().__init__(owner)
        self._takes = takes
        self._stack = stack
        self._clock = count(1)
        self._edits: dict[int, tuple[QUndoCommand, int]] = {}
        self._done: list[int] = []
        self._undone: list[int] = []
        stack.indexChanged.connect(self._note_edit)
        takes.kept.connect(self._note_take)
        takes.opened.connect(self._forget_takes)
        takes.changed.connect(self.changed)

    @property
    def undoable(self) -> str:
        """What `undo` takes back, in words; nothing where there is nothing."""
        return (self._takes.now.undoable or "") if self._is_take_newer() else self._stack.undoText()

    @property
    def redoable(self) -> str:
        """What `redo` does again, in words; nothing where there is nothing."""
        return (self._takes.now.redoable or "") if self._is_take_next() else self._stack.redoText()

    def undo(self) -> None:
        """Take the newest change back."""
        if self._is_take_newer():
            self._undone.append(self._done.pop())
            self._takes.undo()
        else:
            self._stack.undo()

    def redo(self) -> None:
        """Do again what was undone last."""
        if self._is_take_next():
            self._done.append(self._undone.pop())
            self._takes.redo()
        else:
            self._stack.redo()

    def _is_take_newer(self) -> bool:
        last_edit = self._made_at(self._stack.index()) if self._stack.canUndo() else -1
        return bool(self._done) and self._done[-1] > last_edit

    def _is_take_next(self) -> bool:
        never = 1 << 62
        next_edit = self._made_at(self._stack.index() + 1) if self._stack.canRedo() else never
        return bool(self._undone) and self._undone[-1] < next_edit

    def _made_at(self, index: int) -> int:
        return self._edits[index][1] if index in self._edits else 0

    def _note_edit(self, index: int) -> None:
        """Take note of an edit that is new; one that is undone or done again keeps its place in the order."""
        command = self._stack.command(index - 1) if index else None
        if command is not None and self._edits.get(index, (None, 0))[0] is not command:
            self._edits[index] = command, next(self._clock)
        self.changed.emit()

    def _note_take(self) -> None:
        self._done.append(next(self._clock))
        self._undone.clear()
        self.changed.emit()

    def _forget_takes(self) -> None:
        self._done, self._undone = [], []
