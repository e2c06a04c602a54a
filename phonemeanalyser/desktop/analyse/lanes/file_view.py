"""The file in hand on its own time: sonagram, phonemes, waveform, and the course of a variable."""

import math
from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from phonemeanalyser.desktop.analyse.lanes.file_layout import LEFT, FileLayout
from phonemeanalyser.desktop.analyse.lanes.file_painter import FilePainter
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.label_tiers import ChosenLabel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.lanes import BoundaryDrag, Drag, Lane
from phonemeengine.arrays import UInt32Array
from phonemeengine.inspection.whole_sound import FrameState
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

WHEEL_STEP = 0.8
"""How much less is seen after a notch of the wheel."""
GRAB = 3
"""Pixels by which a press may move and still be a click."""


class FileView(QWidget):
    """Paints what is seen of the file; the wheel zooms at the pointer, a drag scrolls, a click goes there.

    With Shift a drag selects. In the lanes of labels a click chooses a label, a double click renames it, and a drag
    at a boundary moves that.

    Signals
    -------
    sought : seconds from the file's beginning.
    rename_asked : the user wants to rename a `ChosenLabel`.
    """

    sought = Signal(float)
    rename_asked = Signal(object)

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self._labels = session.labels
        self._view = session.view
        self._layout = FileLayout(session, self, theme)
        self._painter = FilePainter(session, theme, self._layout, self)
        self._mouse: QPointF | None = None
        self._pressed: QPointF | None = None
        self._dragged_from = TimeSpan(0.0, 0.0)
        self._selects = False
        self._boundary = BoundaryDrag()
        self.setMinimumSize(260, 200)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(tr("the file over time"))
        self.setToolTip(
            tr("Wheel: zoom at the pointer. Drag: scroll. Click: go there. Shift+drag: select. Home, End: the ends.")
        )
        self.setMouseTracking(True)
        models = (
            session.whole,
            session.second.whole,
            session.second,
            session.sonagram,
            session.formants,
            session.waveform,
            session.labels,
        )
        for signal in (*(model.changed for model in models), self._view.moved, self._view.selected):
            signal.connect(self.update)

    @property
    def variable(self) -> str:
        """Name of the variable whose course is drawn."""
        return self._painter.variable

    @property
    def shows(self) -> set[str]:
        """What is drawn over the sonagram and below it, see `FileLayout`."""
        return self._layout.shows

    def set_colours(self, colours: UInt32Array) -> None:
        """Choose the colours of the levels, 256 RGB values."""
        self._painter.set_colours(colours)
        self.update()

    def show_variable(self, name: str) -> None:
        """Draw the course of another variable."""
        self._painter.variable = name
        self.update()

    def show_over(self, name: str, *, on: bool) -> None:
        """Draw formants, pitch or level over the sonagram, or not."""
        self._layout.shows = self.shows | {name} if on else self.shows - {name}
        self.update()

    def show_spoken(self, lanes: list[Lane]) -> None:
        """Draw other lanes of what is said; those that a tier of labels of the same name shows are left out."""
        self._layout.spoken = lanes
        self.update()

    def paintEvent(self, _event: Any) -> None:
        """Paint all rows, what is selected, and the place that is heard."""
        painter = QPainter(self)
        try:
            self._painter.paint(painter, self.reading())
        finally:
            painter.end()  # whatever went wrong: Qt crashes where two paint one widget

    def reading(self) -> str:
        """Return what lies under the mouse, in words; empty where that is nothing."""
        row, tracks = self._layout.rows()[0], self._session.whole.tracks
        if self._mouse is None or tracks is None or not LEFT <= self._mouse.x() <= LEFT + self._layout.width:
            return ""
        time = self._layout.time_at(self._mouse.x())
        frame = int(time / FRAME_PERIOD)
        if not 0 <= frame < tracks.n_frames or tracks.states[frame] == FrameState.UNKNOWN:
            return ""
        values = tracks.features.frame(frame)
        parts = [f"{time:.3f} s", Phoneme(int(tracks.phonemes[frame])).label]
        for under, lane in self._layout.spoken_rows():
            if under.contains(self._mouse) and (span := lane.span_at(time)) is not None:
                parts.append(f"{lane.name}: {lane.texts[span]}")
        if row.contains(self._mouse):
            frequencies = self._session.sonagram.settings.frequencies
            share = (row.bottom() - self._mouse.y()) / row.height()
            parts.append(f"{np.interp(share, np.linspace(0, 1, len(frequencies)), frequencies):.0f} Hz")
        parts += self._reading_over(values, frame)
        if self.variable in values:
            parts.append(f"{self.variable} {values[self.variable]:.4g}")
        return "   ".join(parts)

    def _reading_over(self, values: dict[str, float], frame: int) -> list[str]:
        """Return the values of what is drawn over the sonagram."""
        parts = []
        if "pitch" in self.shows:
            parts.append(f"f0 {values['f0']:.0f} Hz" if values.get("f0") else tr("no f0"))
        if "level" in self.shows:
            parts.append(f"{20 * math.log10(max(values.get('volume', 0.0), 1e-6)):.0f} dB")
        known = self._session.formants.formants_in(self._view.seen) if "formants" in self.shows else None
        if known is not None and 0 <= frame - known.first < len(known.frequencies):
            found = known.frequencies[frame - known.first, :3].tolist()
            parts += [f"F{k} {value:.0f}" for k, value in enumerate(found, 1) if not math.isnan(value)]
        return parts

    # -- the user's hand ----------------------------------------------------------------------------------

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom at the pointer; with Shift, or a sideways wheel, scroll."""
        turned = event.angleDelta()
        if turned.x() or event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self._view.scroll(-(turned.x() or turned.y()) / 1200 * self._view.seen.seconds)
        else:
            self._view.zoom(self._layout.time_at(event.position().x()), WHEEL_STEP ** (turned.y() / 120))
        event.accept()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin to scroll, or with Shift to select."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed, self._dragged_from = event.position(), self._view.seen
            self._selects = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            held = None if self._selects else self._catch(event.position())
            if held is not None:
                self._labels.begin_move()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Rename the label that lies there."""
        label = self._label_at(event.position())
        if label is not None:
            self._labels.choose(label)
            self.rename_asked.emit(label)

    def _label_at(self, place: QPointF) -> ChosenLabel | None:
        for tier, row in self._layout.label_rows().items():
            if row.contains(place):
                return self._labels.label_at(tier, self._layout.time_at(place.x()))
        return None

    def _catch(self, place: QPointF) -> Drag | None:
        layout = self._layout
        return self._boundary.press(layout.label_lanes(), layout.axis, place, self._view.duration)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Scroll, or select; with no button, tell what lies there."""
        self._mouse = event.position()
        if self._pressed is None:
            over = self._boundary.boundary_at(self._layout.label_lanes(), self._layout.axis, event.position())
            self.setCursor(Qt.CursorShape.ArrowCursor if over is None else Qt.CursorShape.SplitHCursor)
            self.update()
            return
        held = self._boundary.move(self._layout.time_at(event.position().x()))
        if held is not None:
            label = ChosenLabel(self._layout.tiers_shown()[held.lane], held.boundary // 2)
            self._labels.move(label, held.seconds, end=bool(held.boundary % 2))
            return
        moved = event.position().x() - self._pressed.x()
        if self._selects:
            self._view.select(
                TimeSpan(self._layout.time_at(self._pressed.x()), self._layout.time_at(event.position().x()))
            )
        elif abs(moved) > GRAB:
            start = self._dragged_from.start - moved / self._layout.width * self._dragged_from.seconds
            self._view.show(TimeSpan(start, start + self._dragged_from.seconds))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Go to a place that was clicked."""
        if self._pressed is None:
            return
        clicked = abs(event.position().x() - self._pressed.x()) <= GRAB and not self._selects
        self._pressed = None
        self._boundary.release()
        if not clicked:
            return
        label = self._label_at(event.position())
        self._labels.choose(label)
        if label is None:
            self._view.select(None)
            self.sought.emit(min(max(self._layout.time_at(event.position().x()), 0.0), self._view.duration))
        else:
            raw = self._labels.tiers[label.tier].raw_labels[label.label]
            self._view.select(TimeSpan(raw.start, raw.end))

    def leaveEvent(self, event: Any) -> None:
        """Tell nothing when the mouse leaves."""
        self._mouse = None
        self.update()
        super().leaveEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Scroll by half of what is seen, and zoom."""
        half, seen = self._view.seen.seconds / 2, self._view.seen
        acts = {
            Qt.Key.Key_Left: lambda: self._view.scroll(-half),
            Qt.Key.Key_Right: lambda: self._view.scroll(half),
            Qt.Key.Key_Up: lambda: self._view.zoom((seen.start + seen.end) / 2, WHEEL_STEP),
            Qt.Key.Key_Down: lambda: self._view.zoom((seen.start + seen.end) / 2, 1 / WHEEL_STEP),
        }
        act = acts.get(Qt.Key(event.key()))
        if act is None:
            super().keyPressEvent(event)
        else:
            act()
