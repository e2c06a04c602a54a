"""Edits on the undo stack: another value for what there is one of."""

from collections.abc import Callable
from typing import Any

from PySide6.QtGui import QUndoCommand
from typing_extensions import override


class UndoableEdit(QUndoCommand):
    """Puts another value; of no use once something else is open, such as another sound.

    Parameters
    ----------
    what : the change in words, for the Edit menu.
    put : makes a value the one that is shown.
    before, after : the values.
    opened : says what is open; the edit is dropped where that is not what it was made in.
    run : what edits have in common of which those in a row become one, such as a drag; None for none.
    """

    def __init__(
        self,
        what: str,
        put: Callable[[Any], object],
        before: object,
        after: object,
        opened: Callable[[], object],
        run: object = None,
    ) -> None:
        super().__init__(what)
        self._put, self._before, self._after = put, before, after
        self._opened, self._made_in, self._run = opened, opened(), run

    @override
    def id(self) -> int:
        return -1 if self._run is None else 2

    @override
    def mergeWith(self, other: QUndoCommand) -> bool:
        if not isinstance(other, UndoableEdit) or (other._run, other._made_in) != (self._run, self._made_in):
            return False
        self._after = other._after
        self.setObsolete(self._after == self._before)  # a drag back to where it began is no change
        return True

    @override
    def redo(self) -> None:
        self._put_if_open(self._after)

    @override
    def undo(self) -> None:
        self._put_if_open(self._before)

    def _put_if_open(self, value: object) -> None:
        if self._opened() == self._made_in:
            self._put(value)
        else:
            self.setObsolete(True)
