"""What was said, and what was recognised, one above the other over all recordings."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QImage, QMouseEvent, QPainter, QWheelEvent
from PySide6.QtWidgets import QScrollBar, QSizePolicy, QVBoxLayout, QWidget

from phonemeanalyser.desktop.painting import CENTRED, draw_text
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.plot_menu import PlotMenu, table_of
from phonemeengine.arrays import UInt8Array
from phonemeengine.calibration.scores.confusion import Confusion
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

LEFT = 76
HEADING, LANE, GAP = 14, 20, 2
SIZE = 11
"""Of letters, pixels."""
NARROWEST, WIDEST = 0.02, 12.0
"""Pixels of a frame at most zoom out and in."""
LEAST_TEXT = 16
"""Pixels that a stretch needs to be named."""


class Timeline(QWidget):
    """Paints the part that is seen; the wheel zooms at the mouse."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.confusion: Confusion | None = None
        self.names: list[str] = []
        self.first = 0.0
        self.scale = 1.0
        self.setMinimumSize(200, HEADING + 2 * LANE + GAP + 6)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._table = np.array([QColor(PHONEME_COLOURS[p]).rgb() for p in Phoneme], np.uint32)

    @property
    def n_frames(self) -> int:
        """How many frames there are."""
        return len(self.confusion.predicted) if self.confusion is not None else 0

    @property
    def n_seen(self) -> float:
        """How many frames have room."""
        return max(1.0, (self.width() - LEFT) / self.scale)

    def frame_at(self, x: float) -> int:
        """Return the frame at a pixel."""
        return int(self.first + (x - LEFT) / self.scale)

    def paintEvent(self, _event: Any) -> None:
        """Paint both lanes, the names of the recordings, and where one begins."""
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        if self.confusion is None:
            return
        tops = (HEADING, HEADING + LANE + GAP)
        lanes = (self.confusion.labels.phonemes, self.confusion.predicted)
        for top, word, codes in zip(tops, ("said", "recognised"), lanes, strict=True):
            draw_text(painter, QRectF(6, top, LEFT - 8, LANE), word, self._theme.text, SIZE)
            self._paint_lane(painter, top, codes)
        self._paint_edges(painter, self.confusion)

    def _paint_lane(self, painter: QPainter, top: int, codes: UInt8Array) -> None:
        width = self.width() - LEFT
        frames = (self.first + np.arange(width) / self.scale).astype(np.intp)
        inside = frames < len(codes)
        n = int(inside.sum())
        if not n:
            return
        colours = np.ascontiguousarray(self._table[codes[frames[:n]]])
        image = QImage(colours.tobytes(), n, 1, 4 * n, QImage.Format.Format_RGB32)
        painter.drawImage(QRectF(LEFT, top, n, LANE), image)
        first, last = int(frames[0]), int(frames[n - 1]) + 1
        part = codes[first:last]
        borders = np.concatenate(([0], np.flatnonzero(part[1:] != part[:-1]) + 1, [len(part)]))
        wide = np.flatnonzero(np.diff(borders) * self.scale >= LEAST_TEXT)
        for k in wide.tolist():
            start, end = borders[k : k + 2].tolist()
            name = Phoneme(int(part[start])).label
            x = LEFT + (first + start - self.first) * self.scale
            box = QRectF(max(x, LEFT), top, (end - start) * self.scale, LANE)
            if painter.fontMetrics().horizontalAdvance(name) < box.width() - 2:
                draw_text(painter, box, name, "#ffffff", SIZE, CENTRED)

    def _paint_edges(self, painter: QPainter, confusion: Confusion) -> None:
        for k, edge in enumerate(confusion.edges[:-1].tolist()):
            x, end = (LEFT + (f - self.first) * self.scale for f in (edge, int(confusion.edges[k + 1])))
            if end < LEFT or x > self.width():
                continue
            if x >= LEFT:
                painter.fillRect(QRectF(x, 0, 1, HEADING + 2 * LANE + GAP), QColor(self._theme.text))
            room = min(end, self.width()) - max(x, LEFT) - 6
            if room > 24:
                text = painter.fontMetrics().elidedText(self.names[k], Qt.TextElideMode.ElideMiddle, int(room))
                draw_text(painter, QRectF(max(x, LEFT) + 4, 0, room, HEADING), text, self._theme.faint, SIZE)


class TimelineView(QWidget):
    """The lanes with their scroll bar.

    Signals
    -------
    chosen : recording, start and end (seconds) of the stretch that was clicked.
    """

    chosen = Signal(int, float, float)

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self.lanes = Timeline(theme)
        self.bar = QScrollBar(Qt.Orientation.Horizontal)
        self.menu = PlotMenu(self.lanes, "said and recognised", lambda _at: table_of(self._columns()), self._whole)
        self.setToolTip("Click a stretch to hear it; the wheel scrolls, with Ctrl it zooms")
        self.setAccessibleName("said and recognised")
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.lanes)
        column.addWidget(self.bar)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.bar.valueChanged.connect(self._scroll)

    def show_confusion(self, confusion: Confusion | None, names: list[str]) -> None:
        """Show the answers to these recordings."""
        fresh = confusion is None or self.lanes.confusion is None or len(confusion.predicted) != self.lanes.n_frames
        self.lanes.confusion, self.lanes.names = confusion, names
        if fresh:
            self._fit()
        self.lanes.update()

    def show_frame(self, recording: int, seconds: float) -> None:
        """Scroll to a place in a recording."""
        if self.lanes.confusion is not None:
            frame = int(self.lanes.confusion.edges[recording]) + round(seconds / FRAME_PERIOD)
            self.lanes.scale = max(self.lanes.scale, 1.0)
            self._fit()
            self.bar.setValue(round(frame - self.lanes.n_seen / 2))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Choose the labelled stretch, or the recognised one, under the mouse."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        confusion, y = self.lanes.confusion, event.position().y()
        frame = self.lanes.frame_at(event.position().x())
        if confusion is None or not 0 <= frame < self.lanes.n_frames or event.position().x() < LEFT:
            return
        recording = int(np.searchsorted(confusion.edges, frame, side="right")) - 1
        edge = int(confusion.edges[recording])
        line = confusion.line(recording) if y > HEADING + LANE else confusion.label_line(recording)
        at = frame - edge
        changes = np.flatnonzero(line[1:] != line[:-1]) + 1
        start = int(changes[changes <= at].max(initial=0))
        end = int(changes[changes > at].min(initial=len(line)))
        self.chosen.emit(recording, start * FRAME_PERIOD, end * FRAME_PERIOD)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scroll, or zoom at the mouse."""
        turns = (event.angleDelta().y() or event.angleDelta().x()) / 120
        if not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self.bar.setValue(round(self.bar.value() - turns * self.lanes.n_seen / 8))
            return
        x = event.position().x()
        frame = self.lanes.first + (x - LEFT) / self.lanes.scale
        self.lanes.scale = min(max(self.lanes.scale * 1.3**turns, NARROWEST), WIDEST)
        self._fit()
        self.bar.setValue(round(frame - (x - LEFT) / self.lanes.scale))

    def resizeEvent(self, event: Any) -> None:
        """Let the scroll bar know how much is seen."""
        super().resizeEvent(event)
        self._fit()

    def _whole(self) -> None:
        """Zoom out to all recordings."""
        self.lanes.scale = min(max((self.lanes.width() - LEFT) / max(1, self.lanes.n_frames), NARROWEST), 1.0)
        self._fit()

    def _columns(self) -> dict[str, Sequence[object]]:
        """Return what is seen as columns, each under its name and unit."""
        confusion = self.lanes.confusion
        if confusion is None:
            return {}
        frames = np.arange(int(self.lanes.first), min(int(self.lanes.first + self.lanes.n_seen), self.lanes.n_frames))
        recordings = np.searchsorted(confusion.edges, frames, side="right") - 1
        return {
            "recording": [self.lanes.names[k] for k in recordings.tolist()],
            "time (s)": ((frames - confusion.edges[recordings]) * FRAME_PERIOD).tolist(),
            "said": [Phoneme(code).label for code in confusion.labels.phonemes[frames].tolist()],
            "recognised": [Phoneme(code).label for code in confusion.predicted[frames].tolist()],
        }

    def _fit(self) -> None:
        seen = int(self.lanes.n_seen)
        self.bar.setRange(0, max(0, self.lanes.n_frames - seen))
        self.bar.setPageStep(seen)
        self.bar.setSingleStep(max(1, seen // 10))
        self._scroll(self.bar.value())

    def _scroll(self, value: int) -> None:
        self.lanes.first = float(value)
        self.lanes.update()
