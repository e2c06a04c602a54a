"""The phoneme that is heard now, small, beside the sound's name."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeengine.phonemes import Phoneme

WIDTH, HEIGHT, EDGE = 96, 24, 4


class PhonemeChip(QWidget):
    """Paints the phoneme on its colour, and its intensity as a line below it.

    Attributes
    ----------
    phoneme, intensity : what is shown.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self._theme = theme
        self.phoneme, self.intensity = Phoneme.SILENCE, 0.0
        self.setFixedSize(WIDTH, HEIGHT)
        self.setToolTip(tr("The phoneme that is heard now, and its intensity"))
        self.setAccessibleName(tr("the phoneme that is heard"))

    def refresh(self) -> None:
        """Show what is heard now."""
        session = self._talking.session
        rests = not session.source.playing and (session.source.live or not session.source.position)
        newest = None if rests or session.microphone.silent else session.history.newest
        heard = (Phoneme.SILENCE, 0.0)
        if newest is not None:
            heard = Phoneme(int(newest.phonemes[-1])), round(float(newest.intensities[-1]), 2)
        if heard != (self.phoneme, self.intensity):
            self.phoneme, self.intensity = heard
            self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint it."""
        painter = QPainter(self)
        colour = QColor(PHONEME_COLOURS[self.phoneme])
        painter.fillRect(self.rect(), QColor(colour.red(), colour.green(), colour.blue(), 50))
        painter.fillRect(0, 0, EDGE, HEIGHT, colour)
        painter.fillRect(EDGE, HEIGHT - 3, round((WIDTH - EDGE) * self.intensity), 3, colour)
        painter.setPen(QColor(self._theme.text))
        box = self.rect().adjusted(EDGE, 0, 0, -2)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self.phoneme.label)
