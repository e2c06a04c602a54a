"""The measurement of latency by clicks, while the window stays alive."""

import threading
from collections.abc import Sequence

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.threads import start_thread
from phonemeengine.audio.devices import InputChoice
from phonemeengine.errors import EngineError
from phonemeengine.live.loopback import Loopback, measure_loopback


class LatencyTest(QObject):
    """Plays clicks and listens for them; `begin` begins, and `see` says when it has ended.

    Signals
    -------
    told : a sentence about what was measured.
    failed : a sentence about why nothing was.
    """

    info = Signal(str)
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.result: Loopback | None = None
        self.measuring: threading.Thread | None = None
        self._found: Loopback | EngineError | None = None

    @property
    def running(self) -> bool:
        """Whether clicks are being played."""
        return self.measuring is not None

    def begin(self, choice: InputChoice, after: Sequence[threading.Thread]) -> None:
        """Measure as soon as these threads have ended: some cards serve one stream at a time."""
        waiting = list(after)
        self.measuring = start_thread(lambda: self._measure(choice, waiting))

    def see(self) -> bool:
        """Tell what came of it, if it has just ended; says whether it has."""
        if self.measuring is None or self.measuring.is_alive():
            return False
        self.measuring = None
        found = self._found
        if isinstance(found, Loopback):
            self.result = found
            share = (
                f"{1000 * found.capture:.0f} ms of it are the microphone's, and the status line now counts with them"
            )
            if not found.capture:
                share = "the card does not tell which part of it is the microphone's"
            self.info.emit(
                f"A click comes back after {1000 * found.round_trip:.0f} ms ({found.n_heard} of {found.n_played} "
                f"heard, within {1000 * found.spread:.0f} ms of each other); {share}."
            )
        else:
            words = str(found)
            self.error.emit(f"The latency was not measured: {words}.")
        return True

    def _measure(self, choice: InputChoice, waiting: list[threading.Thread]) -> None:
        for thread in waiting:
            thread.join()
        try:
            self._found = measure_loopback(choice)
        except EngineError as error:
            self._found = error
