"""Files of recorded faces that were opened, of which one is in use."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.errors import EngineError


class OpenedFiles(QObject):
    """Opens files of a kind in the background, and knows which one is in use.

    Parameters
    ----------
    look : reads what is to be known of a file, which has a `title`.
    load : reads the same, and what is in it.

    Signals
    -------
    changed : other files or another choice, or it is going on.
    error : a sentence for the user.

    Attributes
    ----------
    known : what is known of the files that were opened, by path; each has a `title`.
    chosen : the file in use; None for none.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, look: Callable[[Path], Any], load: Callable[[Path], tuple[Any, Any]]) -> None:
        super().__init__()
        self.known: dict[Path, Any] = {}
        self.chosen: Path | None = None
        self._look, self._load = look, load
        self._value: Any = None
        self._kept: tuple[tuple[Path, ...], Path | None] = (), None
        self._opening = TaskQueue(self.error.emit)
        self._opening.changed.connect(self.changed)

    @property
    def name(self) -> str:
        """What the file in use is called, and whether no person moved for it; empty without one."""
        return "" if self.chosen is None else str(self.known[self.chosen].title)

    def keep(self, paths: Sequence[Path], chosen: Path | None) -> None:
        """Take note of what was open at the last start; `wake` opens it."""
        self._kept = tuple(paths), chosen

    def wake(self) -> None:
        """Open what was open at the last start, in the background; what is not there any more is forgotten."""
        (paths, chosen), self._kept = self._kept, ((), None)
        if paths:
            self._opening.submit(lambda _progress: self._found(paths), lambda found: self._take_found(found, chosen))

    @property
    def opened(self) -> tuple[tuple[Path, ...], Path | None]:
        """The files that are open, or would be after `wake`, and the one in use."""
        return self._kept if self._kept[0] else (tuple(self.known), self.chosen)

    def open(self, path: Path) -> None:
        """Open a file, in the background, and use it."""
        self._open(path)

    def choose(self, path: Path | None) -> None:
        """Use a file that was opened before; None for none."""
        if path is not None:
            self._open(path)
        elif self.chosen is not None:
            self._opening.cancel()
            self.chosen = self._value = None
            self.changed.emit()

    def _open(self, path: Path) -> None:
        self._opening.replace(lambda _progress: self._load(path), lambda loaded: self._take(path, *loaded))

    def _found(self, paths: Sequence[Path]) -> dict[Path, Any]:
        """Return what is known of those files that can be opened."""
        known = {}
        for path in paths:
            with suppress(EngineError):  # which is no longer listed
                known[path] = self._look(path)
        return known

    def _take_found(self, known: dict[Path, Any], chosen: Path | None) -> None:
        self.known = {**known, **self.known}
        if chosen in known and self.chosen is None:
            self._open(chosen)
        self.changed.emit()

    def _take(self, path: Path, known: Any, value: Any) -> None:
        self._value, self.chosen = value, path
        self.known[path] = known
        self.changed.emit()
