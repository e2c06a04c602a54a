"""The whole file as a line: its waveform in the colours of its phonemes, and the playhead."""

from typing import Any

import numpy as np
from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QImage, QKeyEvent, QMouseEvent, QPainter
from PySide6.QtWidgets import QSizePolicy, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.painting import format_clock, set_size
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeengine.arrays import UInt8Array, UInt32Array
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import HOP

SPACINGS = (0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1200, 3600)
"""Between two marks of time, seconds."""
MARGIN = 6
"""Pixels beside the line."""
WAVE_HEIGHT, BAR_HEIGHT = 15, 3
LOUDEST = 0.05
"""A sound that is nowhere louder than this is drawn as soft as it is."""
NOTHING = len(Phoneme)
"""The code of a column of which no phoneme is known."""


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
        self._overview: tuple[tuple[int, int, int], QImage] | None = None
        colours = [*(PHONEME_COLOURS[p] for p in Phoneme), theme.faint]
        self._pixels = np.array([QColor(colour).rgb() for colour in colours], np.uint32)
        self.setMinimumSize(120, 30)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setToolTip(
            tr(
                "Waveform of the whole file in the colours of its phonemes (grey: not analysed yet). Click to go "
                "to that time; arrow keys move by 1 s"
            )
        )
        self.setAccessibleName(tr("Timeline"))
        session.whole.changed.connect(self.update)

    def refresh(self) -> None:
        """Show where the sound is."""
        shown = round(self._x_of(self._session.source.position))
        if shown != self._shown:
            self._shown = shown
            self.update()

    @override
    def paintEvent(self, _event: Any) -> None:
        painter = QPainter(self)
        try:
            self._paint(painter)
        finally:
            painter.end()  # whatever went wrong: Qt crashes where two paint one widget

    def _paint(self, painter: QPainter) -> None:
        width = self.width() - 2 * MARGIN
        tracks = self._session.whole.tracks
        if tracks is not None and width > 0:
            painter.drawImage(MARGIN, 0, self._overview_of(tracks, width))
        painter.fillRect(QRectF(MARGIN, WAVE_HEIGHT, width, BAR_HEIGHT), QColor(self._theme.line))
        x = self._x_of(self._session.source.position)
        painter.fillRect(QRectF(MARGIN, WAVE_HEIGHT, x - MARGIN, BAR_HEIGHT), QColor(self._theme.accent))
        painter.fillRect(QRectF(x - 1, 0, 2, WAVE_HEIGHT + BAR_HEIGHT), QColor(self._theme.text))
        self._paint_marks(painter)

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._seek(event)

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._seek(event)

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        steps = {Qt.Key.Key_Left: -1.0, Qt.Key.Key_Right: 1.0}
        if event.key() in steps:
            self.sought.emit(max(0.0, self._session.source.position + steps[Qt.Key(event.key())]))
        else:
            super().keyPressEvent(event)

    def _overview_of(self, tracks: SoundTracks, width: int) -> QImage:
        """Return the picture of what is known, which is painted anew only when that changed."""
        key = (id(tracks), tracks.revision, width)
        if self._overview is None or self._overview[0] != key:
            pixels = overview_pixels(tracks, width, self._pixels, np.uint32(QColor(self._theme.window).rgb()))
            image = QImage(pixels.data, width, WAVE_HEIGHT, 4 * width, QImage.Format.Format_RGB32).copy()
            self._overview = key, image
        return self._overview[1]

    def _paint_marks(self, painter: QPainter) -> None:
        duration = self._session.source.duration
        if duration <= 0:
            return
        set_size(painter, 9)
        painter.setPen(QColor(self._theme.faint))
        spacing = next((s for s in SPACINGS if duration / s * 46 < self.width() - 60), SPACINGS[-1])
        for k in range(int(duration / spacing) + 1):
            x = self._x_of(k * spacing)
            if x > self.width() - 24:
                break
            painter.fillRect(QRectF(x, WAVE_HEIGHT, 1, BAR_HEIGHT + 2), QColor(self._theme.faint))
            painter.drawText(QRectF(x + 2, 18, 50, 12), format_clock(k * spacing, spacing < 1))

    def _seek(self, event: QMouseEvent) -> None:
        share = min(max((event.position().x() - MARGIN) / max(1, self.width() - 2 * MARGIN), 0.0), 1.0)
        self.sought.emit(share * self._session.source.duration)

    def _x_of(self, seconds: float) -> float:
        return MARGIN + seconds / max(self._session.source.duration, 1e-6) * (self.width() - 2 * MARGIN)


def overview_pixels(tracks: SoundTracks, width: int, colours: UInt32Array, nothing: np.uint32) -> UInt32Array:
    """Return the waveform of a whole sound in the colours of its phonemes, RGB, shape (WAVE_HEIGHT, width)."""
    peaks = tracks.peaks.between(0, tracks.n_frames * HOP, width)
    loudest = max(LOUDEST, float(np.nanmax([np.abs(peaks.low), np.abs(peaks.high), np.zeros(width)])))
    middle = (WAVE_HEIGHT - 1) / 2
    high, low = (np.nan_to_num(middle - values / loudest * middle, nan=-1.0) for values in (peaks.high, peaks.low))
    rows = np.arange(WAVE_HEIGHT)[:, np.newaxis]
    inside = (rows >= np.round(high)) & (rows <= np.round(low)) & ~np.isnan(peaks.low)
    return np.where(inside, colours[main_phonemes(tracks, width)], nothing).astype(np.uint32)


def main_phonemes(tracks: SoundTracks, width: int) -> UInt8Array:
    """Return the phoneme that most frames of each column have, shape (width,); of speech, where there is any."""
    columns = np.arange(tracks.n_frames) * width // max(1, tracks.n_frames)
    codes = np.where(tracks.states == FrameState.UNKNOWN, NOTHING, tracks.phonemes)
    counts = np.bincount(columns * (NOTHING + 1) + codes, minlength=width * (NOTHING + 1)).reshape(width, -1)
    spoken = counts.copy()
    spoken[:, [Phoneme.SILENCE, NOTHING]] = 0
    found = np.where(spoken.any(axis=1), spoken.argmax(axis=1), counts.argmax(axis=1))
    return np.where(counts.any(axis=1), found, NOTHING).astype(np.uint8)
