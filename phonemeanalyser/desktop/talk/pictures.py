"""The pictures of an animation: which one belongs to the place in the sound, and the one before or after it."""

import math

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.session.session import Session
from phonemeengine.settings import FRAME_PERIOD

PICTURE_RATES = (24, 25, 30, 50, 60)
"""Pictures per second of an animation, of which one is chosen."""
IN_PICTURE = 0.01
"""Pictures by which a time, rounded to samples, may lie before the picture that it belongs to."""


class PictureModel(QObject):
    """Counts the pictures of the current sound.

    Signals
    -------
    changed : another rate.

    Attributes
    ----------
    rate : pictures a second, one of `PICTURE_RATES`.
    """

    changed = Signal()

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self.rate = 30

    @property
    def number(self) -> int:
        """The number of the picture that belongs to the place in the sound, from 0."""
        return math.floor(self._session.source.position * self.rate + IN_PICTURE)

    def set_rate(self, rate: int) -> None:
        """Count at another rate; one that is not offered changes nothing."""
        if rate in PICTURE_RATES and rate != self.rate:
            self.rate = rate
            self.changed.emit()

    def step(self, step: int) -> None:
        """Hold still some pictures further on, or back: in the first frame of the sound that lies in that picture."""
        source = self._session.source
        if not source.seekable:
            return
        if source.playing:
            self._session.pause()
        last = math.ceil(source.duration * self.rate) - 1
        picture = min(max(self.number + step, 0), max(last, 0))
        frame = math.ceil(picture / self.rate / FRAME_PERIOD - IN_PICTURE)
        self._session.seek((frame + IN_PICTURE) * FRAME_PERIOD)
