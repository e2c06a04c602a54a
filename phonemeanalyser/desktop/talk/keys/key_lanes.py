"""The curves of blend shapes over time, whose keys can be dragged, added, deleted, smoothed and raised."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QContextMenuEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QMenu, QSizePolicy, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.painting import AT_LEFT, CENTRED, draw_text
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.talk.keys.key_model import KeyModel
from phonemeanalyser.desktop.talk.words.text_model import TextModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.lanes import TimeAxis
from phonemeengine.arrays import Float64Array
from phonemeengine.mouth.key_layer import KeyCurve, ShownCurve

LEFT = 66
"""Pixels of the names, as in the timeline above."""
LANE, LEAST_LANE = 64, 26
"""Pixels of a lane: as it would like to be, and at least."""
NEAR, DOT = 7, 3
"""Pixels by which a press may miss a key, and from the middle of a key to its edge."""
MARGIN = 5
"""Pixels above and below a curve, so that keys at 0 and 1 can be caught."""
STEP, COARSE = 0.01, 0.1
"""Of the weight, for an arrow key, and with Shift."""
PLAIN = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier
LEAST_PIXELS = 3
"""Between two keys that can be told apart."""
HINT = tr_noop(
    "Drag a key, or move the selected one with the arrow keys (Shift: farther). Double-click adds a key, Delete "
    "removes it. Shift+drag, or Shift+Left and Shift+Right, marks a range to smooth, raise or lower. Page Up, Page "
    "Down: select another key; with Ctrl, another curve."
)


@dataclass(frozen=True)
class HeldKey:
    """A key that is selected: its blend shape, its time and the times of its neighbours, seconds."""

    shape: str
    time: float
    before: float
    after: float


@dataclass(frozen=True)
class MarkedRange:
    """A range of a curve, seconds."""

    shape: str
    start: float
    end: float

    @property
    def ordered(self) -> "MarkedRange":
        """The same from left to right."""
        return replace(self, start=min(self.start, self.end), end=max(self.start, self.end))


class KeyLanes(QWidget):
    """Paints a curve for each chosen blend shape; what is generated is faint, what is shown is bold.

    Attributes
    ----------
    keys : whose curves they are.
    selected : the key that the arrow keys move; None for none.
    marked : the range that is smoothed or raised; None for none.
    """

    sought = Signal(float)

    def __init__(self, keys: KeyModel, texts: TextModel, theme: Theme) -> None:
        super().__init__()
        self.keys, self._texts, self._theme = keys, texts, theme
        self.selected: HeldKey | None = None
        self.marked: MarkedRange | None = None
        self._dragged: tuple[HeldKey, KeyCurve, float, float] | None = None
        self._marking = False
        self._playhead = 0.0
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setToolTip(tr(HINT))
        self.setAccessibleName(tr("Keys of blend shapes over time"))
        keys.changed.connect(self._take_change)

    @override
    def sizeHint(self) -> QSize:
        """Return a size at which each lane is as it would like to be."""
        return QSize(400, LANE * max(1, len(self.keys.shapes)))

    @override
    def minimumSizeHint(self) -> QSize:
        """Return a size at which keys can be caught."""
        return QSize(200, LEAST_LANE * max(1, len(self.keys.shapes)))

    def refresh(self, position: float) -> None:
        """Show where the sound is, seconds."""
        if position != self._playhead:
            self._playhead = position
            self.update()

    @property
    def axis(self) -> TimeAxis:
        """Where times lie."""
        seen = self._texts.view.seen
        return TimeAxis(LEFT, max(1, self.width() - LEFT), seen.start, max(seen.seconds, 1e-9))

    def rows(self) -> dict[str, QRectF]:
        """Return where the curve of each blend shape lies."""
        shapes = self.keys.shapes
        height = self.height() / max(1, len(shapes))
        width = max(1, self.width() - LEFT)
        return {name: QRectF(LEFT, k * height, width, height - 1) for k, name in enumerate(shapes)}

    def place_of(self, shape: str, time: float) -> QPointF:
        """Return the pixel at which a curve is at a time."""
        curve, row = self._shown(shape), self.rows()[shape]
        weight = 0.0 if curve is None else float(np.interp(time, curve.times, curve.shown))
        return QPointF(self.axis.x_of(time), _y_of(weight, row))

    # -- painting -----------------------------------------------------------------------------------------

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        if self.keys.animation is None:
            words = tr("Open a recording to edit its keys") if not self.keys.possible else tr("Generating curves…")
            draw_text(painter, QRectF(self.rect()), words, self._theme.faint, 12, CENTRED)
            return
        for shape, row in self.rows().items():
            self._paint_row(painter, shape, row)
        x = self.axis.x_of(self._playhead)
        if x >= LEFT:
            painter.fillRect(QRectF(x - 0.5, 0, 1.5, self.height()), QColor(self._theme.accent))

    def _paint_row(self, painter: QPainter, shape: str, row: QRectF) -> None:
        painter.setPen(QPen(QColor(self._theme.line), 1))
        painter.drawLine(row.bottomLeft(), row.bottomRight())
        for k, part in enumerate(_in_two_lines(shape)):
            draw_text(painter, QRectF(3, row.top() + 2 + 12 * k, LEFT - 5, 12), part, self._theme.text, 10, AT_LEFT)
        curve = self._shown(shape)
        if curve is None:
            words = tr("The mouth table does not move {shape}").format(shape=shape)
            draw_text(painter, row, words, self._theme.faint, 11, CENTRED)
            return
        marked = self.marked
        if marked is not None and marked.shape == shape:
            marked = marked.ordered
            left, right = self.axis.x_of(marked.start), self.axis.x_of(marked.end)
            ground = QColor(self._theme.accent)
            ground.setAlpha(50)
            painter.fillRect(QRectF(left, row.top(), right - left, row.height()), ground)
        painter.setClipRect(row)
        if len(curve.keys.times):
            painter.setPen(QPen(QColor(self._theme.faint), 1, Qt.PenStyle.DashLine))
            painter.drawPolyline(self._polygon(row, curve.times, curve.generated))
        painter.setPen(QPen(QColor(self._theme.signal), 1.5))
        painter.drawPolyline(self._polygon(row, curve.times, curve.shown))
        edited = set(curve.keys.times.tolist())
        for time in self._visible_points(curve):
            chosen = self.selected is not None and (self.selected.shape, self.selected.time) == (shape, time)
            colour = self._theme.accent if chosen else self._theme.text if time in edited else self._theme.faint
            dot = DOT + chosen
            place = self.place_of(shape, time)
            painter.fillRect(QRectF(place.x() - dot, place.y() - dot, 2 * dot, 2 * dot), QColor(colour))
        painter.setClipping(False)

    def _polygon(self, row: QRectF, times: Float64Array, weights: Any) -> QPolygonF:
        axis = self.axis
        seen = (times >= axis.start - 0.1) & (times <= axis.end + 0.1)
        x, y = axis.left + (times[seen] - axis.start) / axis.seconds * axis.width, weights[seen]
        heights = row.bottom() - MARGIN - np.clip(y, 0, 1) * (row.height() - 2 * MARGIN)
        return QPolygonF([QPointF(a, b) for a, b in zip(x.tolist(), heights.tolist(), strict=True)])

    def _visible_points(self, curve: ShownCurve) -> list[float]:
        """Return the keys that are seen, as far as they can be told apart."""
        axis, times = self.axis, curve.points()
        shown: list[float] = []
        least = LEAST_PIXELS * axis.seconds / axis.width
        for time in times[(times >= axis.start) & (times <= axis.end)].tolist():
            if not shown or time - shown[-1] >= least:
                shown.append(time)
        return shown

    # -- the user's hand ----------------------------------------------------------------------------------

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take a key in the hand; with Shift, begin to mark a range."""
        place = event.position()
        shape = self._shape_at(place)
        if event.button() != Qt.MouseButton.LeftButton or shape is None:
            return
        time = self.axis.time_at(place.x())
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self.marked, self._marking, self.selected = MarkedRange(shape, time, time), True, None
        else:
            self.marked = None
            self.selected = self._key_at(shape, place)
            if self.selected is None:
                self.sought.emit(time)
            else:
                self._dragged = self.selected, self.keys.layer.curve_of(shape), time, place.y()
        self.update()

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Move the key along, or the end of the marked range; the head shows it at once."""
        place = event.position()
        time = self.axis.time_at(place.x())
        if self._marking and self.marked is not None:
            self.marked = replace(self.marked, end=time)
            self.update()
        elif self._dragged is not None:
            held, before, _, _ = self._dragged
            self._drag(held, before, time, place.y())
        else:
            shape = self._shape_at(place)
            near = shape is not None and self._key_at(shape, place) is not None
            self.setCursor(Qt.CursorShape.SizeAllCursor if near else Qt.CursorShape.ArrowCursor)

    @override
    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let the key go: what was dragged is one change, which can be undone."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        self._marking = False
        if self._dragged is not None:
            held, before, _, _ = self._dragged
            self._dragged = None
            after = self.keys.layer.curve_of(held.shape)
            if after != before:
                self.keys.put(self.keys.layer.with_curve(held.shape, before))
                self.keys.edit(held.shape, after, tr("move a key"))

    @override
    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Add a key where there is none."""
        place = event.position()
        shape = self._shape_at(place)
        curve = None if shape is None else self._shown(shape)
        if shape is not None and curve is not None and self._key_at(shape, place) is None:
            self._set(shape, curve, self.axis.time_at(place.x()), _weight_at(place.y(), self.rows()[shape]))

    @override
    def event(self, event: QEvent) -> bool:
        """Claim Shift+Left and Shift+Right, which are shortcuts of the window elsewhere."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride and _goes_along(event):
            event.accept()
            return True
        return super().event(event)

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move, choose or delete the selected key; raise, lower or mark a range."""
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        control = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        step, choose = COARSE if shift else STEP, self._choose_curve if control else self._choose
        frame = 0.0 if self.keys.animation is None else 1 / self.keys.animation.rate
        along = self._mark if shift else lambda seconds: self._nudge(seconds, 0.0)
        acts: dict[Qt.Key, Callable[[], None]] = {
            Qt.Key.Key_Up: lambda: self._nudge(0.0, step),
            Qt.Key.Key_Down: lambda: self._nudge(0.0, -step),
            Qt.Key.Key_Left: lambda: along(-frame),
            Qt.Key.Key_Right: lambda: along(frame),
            Qt.Key.Key_PageUp: lambda: choose(-1),
            Qt.Key.Key_PageDown: lambda: choose(1),
            Qt.Key.Key_Delete: self.delete,
            Qt.Key.Key_Backspace: self.delete,
        }
        act = acts.get(Qt.Key(event.key()))
        if act is None:
            super().keyPressEvent(event)
        else:
            act()

    @override
    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer what can be done with the key, the range and the curve."""
        shape = self._shape_at(QPointF(event.pos()))
        if event.reason() is QContextMenuEvent.Reason.Keyboard:
            shape = self.marked.shape if self.marked is not None else self._curve_in_hand()
        if shape is None or self._shown(shape) is None:
            return
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        marked = self.marked is not None and self.marked.shape == shape
        menu.addAction(tr("Delete Key"), self.delete).setEnabled(self.selected is not None)
        menu.addSeparator()
        menu.addAction(tr("Smooth Range"), self.smooth).setEnabled(marked)
        menu.addAction(tr("Raise Range by 0.1"), lambda: self.raise_by(COARSE)).setEnabled(marked)
        menu.addAction(tr("Lower Range by 0.1"), lambda: self.raise_by(-COARSE)).setEnabled(marked)
        menu.addAction(tr("Reset Range"), self.reset).setEnabled(marked)
        menu.popup(event.globalPos())

    # -- edits --------------------------------------------------------------------------------------------

    def delete(self) -> None:
        """Delete the selected key: the curve goes straight from the key before to the key after."""
        held = self.selected
        curve = None if held is None else self._shown(held.shape)
        if held is not None and curve is not None and held.before < held.time < held.after:
            self.selected = None
            self.keys.edit(held.shape, curve.without_point(held.before, held.after), tr("delete a key"))

    def smooth(self) -> None:
        """Smooth the marked range."""
        self._edit_range(tr("smooth keys"), lambda curve, start, end: curve.smoothed(start, end))

    def raise_by(self, by: float) -> None:
        """Raise the marked range by a weight; lower it where that is negative."""
        self._edit_range(tr("raise keys"), lambda curve, start, end: curve.raised(start, end, by))

    def reset(self) -> None:
        """Have the marked range as it is generated."""
        self._edit_range(tr("reset keys"), lambda curve, start, end: curve.as_generated(start, end))

    def _edit_range(self, what: str, edited: Callable[[ShownCurve, float, float], KeyCurve]) -> None:
        marked = None if self.marked is None else self.marked.ordered
        curve = None if marked is None else self._shown(marked.shape)
        if marked is None or curve is None:
            return
        start, end = max(marked.start, 0.0), min(marked.end, float(curve.times[-1]))
        if end - start >= 2 / curve.rate:
            self.keys.edit(marked.shape, edited(curve, start, end), what)

    def _set(self, shape: str, curve: ShownCurve, time: float, weight: float) -> None:
        points = curve.points()
        before, after = points[points < time], points[points > time]
        if len(before) and len(after):
            keys = curve.with_point(time, weight, float(before[-1]), float(after[0]))
            self.keys.edit(shape, keys, tr("add a key"))
            self.selected = HeldKey(shape, time, float(before[-1]), float(after[0]))

    def _nudge(self, seconds: float, weight: float) -> None:
        held = self.selected
        if held is None and weight:
            self.raise_by(weight)
        curve = None if held is None else self._shown(held.shape)
        if held is None or curve is None or not held.before < held.time < held.after:
            return
        now = float(np.interp(held.time, curve.times, curve.shown))
        time = self._within(held, held.time + seconds)
        self.keys.edit(held.shape, curve.with_point(time, now + weight, held.before, held.after), tr("move a key"))
        self.selected = replace(held, time=time)

    def _choose(self, step: int) -> None:
        """Select the next key of the blend shape, or the one before."""
        here = self.axis.start if self.selected is None else self.selected.time
        self._take_key(self._curve_in_hand(), here, lambda apart: apart > 0 if step > 0 else apart < 0)

    def _choose_curve(self, step: int) -> None:
        """Select a key of the next curve, or of the one before, near the time of the selected one."""
        shapes = self.keys.shapes
        number = shapes.index(self._curve_in_hand()) + step if shapes else -1
        if 0 <= number < len(shapes):
            here = self._playhead if self.selected is None else self.selected.time
            self._take_key(shapes[number], here, lambda apart: np.ones_like(apart, bool))

    def _take_key(self, shape: str, here: float, wanted: Callable[[Float64Array], Any]) -> None:
        """Select that key of a curve nearest to a time whose distance from it is wanted."""
        curve = self._shown(shape) if shape else None
        points = np.zeros(0) if curve is None else curve.points()
        others = points[wanted(points - here)]
        if len(others):
            self.marked = None
            self.selected = self._held(shape, points, float(others[np.argmin(np.abs(others - here))]))
            self._texts.view.reveal(TimeSpan(self.selected.time, self.selected.time))
            self.update()

    def _curve_in_hand(self) -> str:
        """Return the blend shape of the selected key, or of the marked range, or the first one; empty for none."""
        for chosen in (self.selected, self.marked):
            if chosen is not None:
                return chosen.shape
        return next(iter(self.keys.shapes), "")

    def _mark(self, seconds: float) -> None:
        """Mark a range from the selected key on, or from where the sound is, or move the end of the one there is."""
        shape = self._curve_in_hand()
        curve = self._shown(shape) if shape else None
        if curve is None:
            return
        start = self._playhead if self.selected is None else self.selected.time
        marked = self.marked or MarkedRange(shape, start, start)
        end = min(max(marked.end + seconds, 0.0), float(curve.times[-1]))
        self.marked, self.selected = replace(marked, end=end), None
        self._texts.view.reveal(TimeSpan(end, end))
        self.update()

    def _drag(self, held: HeldKey, before: KeyCurve, time: float, y: float) -> None:
        curve = self.keys.curve_of(held.shape)
        if curve is None or not held.before < held.time < held.after:
            return
        curve, time = replace(curve, keys=before), self._within(held, time)
        keys = curve.with_point(time, _weight_at(y, self.rows()[held.shape]), held.before, held.after)
        self.keys.put(self.keys.layer.with_curve(held.shape, keys))
        self.selected = replace(held, time=time)
        self.update()

    def _within(self, held: HeldKey, time: float) -> float:
        """Return a time between the neighbours of a key, on a frame of the animation."""
        rate = 1.0 if self.keys.animation is None else self.keys.animation.rate
        frame = round(time * rate) / rate
        least = 0.5 / rate
        return min(max(frame, held.before + least), held.after - least)

    def _shown(self, shape: str) -> ShownCurve | None:
        return self.keys.curve_of(shape)

    def _shape_at(self, place: QPointF) -> str | None:
        return next((shape for shape, row in self.rows().items() if row.contains(place)), None)

    def _key_at(self, shape: str, place: QPointF) -> HeldKey | None:
        """Return the key that lies at a pixel; None for none."""
        curve = self._shown(shape)
        if curve is None:
            return None
        places = {time: self.place_of(shape, time) for time in self._visible_points(curve)}
        apart = {time: abs(at.x() - place.x()) + abs(at.y() - place.y()) for time, at in places.items()}
        nearest = min(apart, key=lambda time: apart[time], default=None)
        if nearest is None or apart[nearest] > 2 * NEAR:
            return None
        return self._held(shape, curve.points(), nearest)

    def _held(self, shape: str, points: Float64Array, time: float) -> HeldKey:
        before, after = points[points < time], points[points > time]
        return HeldKey(
            shape, time, float(before[-1]) if len(before) else time, float(after[0]) if len(after) else time
        )

    def _take_change(self) -> None:
        if self.selected is not None and self.selected.shape not in self.keys.shapes:
            self.selected = None
        if self.marked is not None and self.marked.shape not in self.keys.shapes:
            self.marked = None
        self.updateGeometry()
        self.update()


def _goes_along(event: QKeyEvent) -> bool:
    """Return whether a key moves something along the time."""
    return event.key() in {Qt.Key.Key_Left, Qt.Key.Key_Right} and event.modifiers() in PLAIN


def _y_of(weight: float, row: QRectF) -> float:
    return row.bottom() - MARGIN - min(max(weight, 0.0), 1.0) * (row.height() - 2 * MARGIN)


def _weight_at(y: float, row: QRectF) -> float:
    return min(max((row.bottom() - MARGIN - y) / max(row.height() - 2 * MARGIN, 1.0), 0.0), 1.0)


def _in_two_lines(name: str) -> tuple[str, ...]:
    """Return a name such as mouthSmileLeft in two parts, of which the second begins with a capital letter."""
    places = [k for k in range(1, len(name)) if name[k].isupper()]
    if len(name) <= 10 or not places:
        return (name,)
    middle = min(places, key=lambda k: abs(k - len(name) / 2))
    return name[:middle], name[middle:]
