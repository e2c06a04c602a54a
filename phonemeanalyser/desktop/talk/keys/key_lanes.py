"""The curves of blend shapes over time, whose keys can be dragged, added, deleted, smoothed and raised."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QContextMenuEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPixmap
from PySide6.QtWidgets import QMenu, QSizePolicy, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.talk.keys.key_model import KeyModel
from phonemeanalyser.desktop.talk.words.text_model import TextModel
from phonemeanalyser.desktop.theme import AT_LEFT, CENTRED, Theme, draw_text
from phonemeanalyser.desktop.widgets.lanes import TimeAxis
from phonemeanalyser.desktop.widgets.plot import polyline_of
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


class _Painted(NamedTuple):
    """What a row shows, by which its picture is still the right one."""

    curve: ShownCurve | None
    selected: HeldKey | None
    marked: MarkedRange | None
    axis: TimeAxis
    row: QRectF
    scale: float


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
        self._laid_out = keys.shapes
        self._pictures: dict[str, tuple[_Painted, QPixmap]] = {}
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
        curve, row = self.keys.curve_of(shape), self.rows()[shape]
        weight = 0.0 if curve is None else np.interp(time, curve.times, curve.shown)
        return QPointF(self.axis.x_of(time), _y_of(weight, row))

    def _places(self, curve: ShownCurve, row: QRectF, times: Float64Array) -> Float64Array:
        """Return the pixels at which a curve is at some times, shape (n_times, 2)."""
        return np.stack([self.axis.x_of(times), _y_of(np.interp(times, curve.times, curve.shown), row)], axis=1)

    # -- painting -----------------------------------------------------------------------------------------

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint the rows, each of which is drawn once until something in it is different, and the playhead."""
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        if self.keys.animation is None:
            words = tr("Open a recording to edit its keys") if not self.keys.possible else tr("Generating curves…")
            draw_text(painter, QRectF(self.rect()), words, self._theme.faint, 12, CENTRED)
            return
        rows, axis, scale = self.rows(), self.axis, self.devicePixelRatioF()
        self._pictures = {shape: known for shape, known in self._pictures.items() if shape in rows}
        for shape, row in rows.items():
            shown = _Painted(self.keys.curve_of(shape), *self._chosen_in(shape), axis, row, scale)
            if shape not in self._pictures or self._pictures[shape][0] != shown:
                self._pictures[shape] = shown, self._drawn(shape, shown)
            painter.drawPixmap(QPointF(0, row.top()), self._pictures[shape][1])
        x = axis.x_of(self._playhead)
        if x >= LEFT:
            painter.fillRect(QRectF(x - 0.5, 0, 1.5, self.height()), QColor(self._theme.accent))

    def _drawn(self, shape: str, shown: _Painted) -> QPixmap:
        picture = QPixmap(math.ceil(self.width() * shown.scale), math.ceil((shown.row.height() + 1) * shown.scale))
        picture.setDevicePixelRatio(shown.scale)
        picture.fill(QColor(self._theme.base))
        painter = QPainter(picture)
        painter.setFont(self.font())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.translate(0, -shown.row.top())
        try:
            self._paint_row(painter, shape, shown)
        finally:
            painter.end()  # whatever went wrong: Qt crashes where two paint one picture
        return picture

    def _paint_row(self, painter: QPainter, shape: str, shown: _Painted) -> None:
        row, curve, marked = shown.row, shown.curve, shown.marked
        painter.setPen(QPen(QColor(self._theme.line), 1))
        painter.drawLine(row.bottomLeft(), row.bottomRight())
        for k, part in enumerate(_in_two_lines(shape)):
            draw_text(painter, QRectF(3, row.top() + 2 + 12 * k, LEFT - 5, 12), part, self._theme.text, 10, AT_LEFT)
        if curve is None:
            words = tr("The mouth table does not move {shape}").format(shape=shape)
            draw_text(painter, row, words, self._theme.faint, 11, CENTRED)
            return
        if marked is not None:
            left, right = shown.axis.x_of(marked.ordered.start), shown.axis.x_of(marked.ordered.end)
            ground = QColor(self._theme.accent)
            ground.setAlpha(50)
            painter.fillRect(QRectF(left, row.top(), right - left, row.height()), ground)
        painter.setClipRect(row)
        if len(curve.keys.times):
            painter.setPen(QPen(QColor(self._theme.faint), 1, Qt.PenStyle.DashLine))
            self._paint_line(painter, row, curve.times, curve.generated)
        painter.setPen(QPen(QColor(self._theme.signal), 1.5))
        self._paint_line(painter, row, curve.times, curve.shown)
        times, held = self._visible_points(curve), shown.selected
        edited, places = np.isin(times, curve.keys.times), self._places(curve, row, times)
        for time, x, y, is_key in np.column_stack([times, places, edited]).tolist():
            chosen = held is not None and held.time == time
            colour = self._theme.accent if chosen else self._theme.text if is_key else self._theme.faint
            dot = DOT + chosen
            painter.fillRect(QRectF(x - dot, y - dot, 2 * dot, 2 * dot), QColor(colour))

    def _paint_line(self, painter: QPainter, row: QRectF, times: Float64Array, weights: Any) -> None:
        axis = self.axis
        seen = (times >= axis.start - 0.1) & (times <= axis.end + 0.1)
        painter.drawPolyline(polyline_of(axis.x_of(times[seen]), _y_of(weights[seen], row)))

    def _visible_points(self, curve: ShownCurve) -> Float64Array:
        """Return the keys that are seen, as far as they can be told apart; seconds."""
        axis = self.axis
        shown: list[float] = []
        least = LEAST_PIXELS * axis.seconds / axis.width
        for time in curve.points(axis.start, axis.end).tolist():
            if not shown or time - shown[-1] >= least:
                shown.append(time)
        return np.array(shown)

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
        curve = None if shape is None else self.keys.curve_of(shape)
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
        if shape is None or self.keys.curve_of(shape) is None:
            return
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        marked = self._chosen_in(shape)[1] is not None
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
        curve = None if held is None else self.keys.curve_of(held.shape)
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
        curve = None if marked is None else self.keys.curve_of(marked.shape)
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
        curve = None if held is None else self.keys.curve_of(held.shape)
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
        curve = self.keys.curve_of(shape) if shape else None
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
        curve = self.keys.curve_of(shape) if shape else None
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

    def _within(self, held: HeldKey, time: float) -> float:
        """Return a time between the neighbours of a key, on a frame of the animation."""
        rate = 1.0 if self.keys.animation is None else self.keys.animation.rate
        frame = round(time * rate) / rate
        least = 0.5 / rate
        return min(max(frame, held.before + least), held.after - least)

    def _shape_at(self, place: QPointF) -> str | None:
        return next((shape for shape, row in self.rows().items() if row.contains(place)), None)

    def _key_at(self, shape: str, place: QPointF) -> HeldKey | None:
        """Return the key that lies at a pixel; None for none."""
        curve = self.keys.curve_of(shape)
        if curve is None:
            return None
        times = self._visible_points(curve)
        apart = np.abs(self._places(curve, self.rows()[shape], times) - place.toTuple()).sum(axis=1)
        if not len(apart) or apart.min() > 2 * NEAR:
            return None
        return self._held(shape, curve.points(), float(times[np.argmin(apart)]))

    def _held(self, shape: str, points: Float64Array, time: float) -> HeldKey:
        around = (*points[points < time][-1:].tolist(), time), (*points[points > time][:1].tolist(), time)
        return HeldKey(shape, time, around[0][0], around[1][0])

    def _chosen_in(self, *shapes: str) -> tuple[HeldKey | None, MarkedRange | None]:
        """Return the selected key and the marked range, as far as they are in these curves."""
        key, marked = self.selected, self.marked
        return key if key and key.shape in shapes else None, marked if marked and marked.shape in shapes else None

    def _take_change(self) -> None:
        self.selected, self.marked = self._chosen_in(*self.keys.shapes)
        if self.keys.shapes != self._laid_out:
            self._laid_out = self.keys.shapes
            self.updateGeometry()
        self.update()


def _goes_along(event: QKeyEvent) -> bool:
    """Return whether a key moves something along the time."""
    return event.key() in {Qt.Key.Key_Left, Qt.Key.Key_Right} and event.modifiers() in PLAIN


def _y_of(weight: Any, row: QRectF) -> Any:
    return row.bottom() - MARGIN - np.clip(weight, 0.0, 1.0) * (row.height() - 2 * MARGIN)


def _weight_at(y: float, row: QRectF) -> float:
    return min(max((row.bottom() - MARGIN - y) / max(row.height() - 2 * MARGIN, 1.0), 0.0), 1.0)


def _in_two_lines(name: str) -> tuple[str, ...]:
    """Return a name such as mouthSmileLeft in two parts, of which the second begins with a capital letter."""
    places = [k for k in range(1, len(name)) if name[k].isupper()]
    if len(name) <= 10 or not places:
        return (name,)
    middle = min(places, key=lambda k: abs(k - len(name) / 2))
    return name[:middle], name[middle:]
