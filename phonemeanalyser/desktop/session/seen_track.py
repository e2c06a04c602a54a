"""What is measured of a sound in the background, as far as it is in view."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.audio.files import SoundReader


class SeenTrack(QObject):
    """Measures something of a sound; subclasses say what, and forget what they know in `_forget`.

    Signals
    -------
    changed : more of it is measured, or another sound is there.
    error : a sentence for the user.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._open: Callable[[], SoundReader] | None = None
        self._duration = 0.0
        self._work = TaskQueue(self.error.emit)

    @property
    def busy(self) -> bool:
        """Whether more is being measured."""
        return self._work.busy

    def open(self, open_sound: Callable[[], SoundReader], duration: float) -> None:
        """Measure another sound, of this many seconds."""
        self._open, self._duration = open_sound, duration
        self._forget()

    def leave(self) -> None:
        """Know nothing any more."""
        self._open, self._duration = None, 0.0
        self._forget()

    def close(self) -> None:
        """End all work."""
        self._work.close(CLOSE_TIMEOUT)

    def _forget(self) -> None:
        """Measure everything anew."""
        self._work.cancel()
        self.changed.emit()
