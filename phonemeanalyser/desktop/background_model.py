"""A model that has work done in the background."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.tasks import TaskQueue


class BackgroundModel(QObject):
    """Has backrooms, of which the first is the one that people wait for.

    Signals
    -------
    failed : a sentence for the user.
    """

    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._rooms: list[TaskQueue] = []

    @property
    def busy(self) -> bool:
        """Whether people wait for it."""
        return self._rooms[0].busy

    @property
    def share(self) -> float:
        """How much is done, 0..1."""
        return self._rooms[0].share

    def see(self) -> None:
        """Take note of what is done."""
        for room in self._rooms:
            room.see()

    def close(self) -> None:
        """End all work."""
        for room in self._rooms:
            room.cancel()
            room.close()

    def _room(self, refuse: Callable[[str], object] | None = None) -> TaskQueue:
        """Return another room; what the engine refuses in it is told to the user, unless something else is said."""
        self._rooms.append(TaskQueue(refuse or self.error.emit))
        return self._rooms[-1]
