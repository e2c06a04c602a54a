"""Python's garbage collection, kept to the thread of the window.

Python collects in whichever thread allocates when it is due. Qt's objects must be destroyed in the thread in which
they live: one that a thread of the analysis collects may wait for ever for the window, which waits for that thread.
"""

import gc

from PySide6.QtCore import QObject, QTimer

EVERY_MS = 1000


class WindowThreadCollector(QObject):
    """Collects garbage while the event loop runs, in the thread in which it was made; nobody else does until closed.

    What was there before it was made is taken for needed for ever, so that each collection is short.
    """

    def __init__(self) -> None:
        super().__init__()
        gc.disable()
        gc.freeze()
        self._timer = QTimer(self, interval=EVERY_MS)
        self._timer.timeout.connect(self.collect)
        self._timer.start()

    def collect(self) -> None:
        """Collect what is due, as Python would: the oldest generation whose count is above its threshold."""
        due = [count > threshold for count, threshold in zip(gc.get_count(), gc.get_threshold(), strict=True)]
        if any(due):
            gc.collect(max(generation for generation, is_due in enumerate(due) if is_due))

    def close(self) -> None:
        """Leave collecting to Python again."""
        self._timer.stop()
        gc.unfreeze()
        gc.enable()
