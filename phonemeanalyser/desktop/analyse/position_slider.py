"""The whole file as a line."""

from typing import Any

from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter
from PySide6.QtWidgets import QSizePolicy, QWidget

from phonemeanalyser.desktop.painting import format_clock, set_size
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import Theme

SPACINGS = (0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1200, 3600)
"""Between two marks of time, seconds."""


class PositionSlider(QWidget):
    """The whole file as a line; a click or a drag goes there.

    Signals
    -------
    sought : seconds from the file's beginning.
    """

    sought = Signal(float)

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self._theme = theme
        self._shown = -1
        self.setMinimumSize(120, 30)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setToolTip("Click to go there; arrow keys go by a second")
        self.setAccessibleName("time line")

    def refresh(self) -> None:
        """Show where the sound is."""
        shown = round(self._x_of(self._session.position))
        if shown != self._shown:
            self._shown = shown
            self.update()

    def paintEvent(self, _event: Any) -> None:
        """Paint the track, what has been heard, marks of time, and the place."""
        painter = QPainter(self)
        track = QRectF(6, 5, self.width() - 12, 9)
        painter.fillRect(track, QColor(self._theme.line))
        x = self._x_of(self._session.position)
        painter.fillRect(QRectF(6, 5, x - 6, 9), QColor(self._theme.accent))
        painter.fillRect(QRectF(x - 1.5, 1, 3, 17), QColor(self._theme.text))
        self._paint_marks(painter)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Go there."""
        self._seek(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Follow the mouse."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._seek(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go by a second."""
        steps = {Qt.Key.Key_Left: -1.0, Qt.Key.Key_Right: 1.0}
        if event.key() in steps:
            self.sought.emit(max(0.0, self._session.position + steps[Qt.Key(event.key())]))
        else:
            super().keyPressEvent(event)

    def _paint_marks(self, painter: QPainter) -> None:
        duration = self._session.duration
        if duration <= 0:
            return
        set_size(painter, 9)
        painter.setPen(QColor(self._theme.faint))
        spacing = next((s for s in SPACINGS if duration / s * 46 < self.width() - 60), SPACINGS[-1])
        for k in range(int(duration / spacing) + 1):
            x = self._x_of(k * spacing)
            if x > self.width() - 24:
                break
            painter.fillRect(QRectF(x, 14, 1, 4), QColor(self._theme.faint))
            painter.drawText(QRectF(x + 2, 17, 50, 12), format_clock(k * spacing, spacing < 1))

    def _seek(self, event: QMouseEvent) -> None:
        share = min(max((event.position().x() - 6) / max(1, self.width() - 12), 0.0), 1.0)
        self.sought.emit(share * self._session.duration)

    def _x_of(self, seconds: float) -> float:
        return 6 + seconds / max(self._session.duration, 1e-6) * (self.width() - 12)
