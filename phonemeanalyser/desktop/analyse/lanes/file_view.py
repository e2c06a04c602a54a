"""The current file on its own time: sonagram, phonemes, waveform, and the course of a variable."""

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QHelpEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QWheelEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QToolTip, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.analyse.lanes.feeling_lane import feeling_tip, feeling_words
from phonemeanalyser.desktop.analyse.lanes.file_layout import LANE, LEFT, FileLayout
from phonemeanalyser.desktop.analyse.lanes.file_painter import CourseLanes, FilePainter, HeldLine
from phonemeanalyser.desktop.analyse.lanes.sonagram import SonagramChoices
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.courses import Courses
from phonemeanalyser.desktop.session.label_tiers import Boundary, ChosenLabel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import ElidedLabel, Wrapping, column, row, toggle_button, tool_button
from phonemeanalyser.desktop.widgets.lanes import BoundaryDrag, LabelEditor, Lane
from phonemeengine.inspection.whole_sound import FrameRange, FrameState
from phonemeengine.labels.utterance import ROUNDING
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

WHEEL_STEP = 0.8
"""How much less is seen after a notch of the wheel."""
GRAB = 3
"""Pixels by which a press may move and still be a click."""
SNAP = 6
"""Pixels within which a dragged boundary snaps."""


class FileView(QWidget):
    """Paints what is seen of the file; the wheel zooms at the pointer, a drag scrolls, a click goes there.

    With Shift a drag selects. In the lanes of labels a click chooses a label, a double click or a letter renames it,
    Enter splits one at the cursor, and a drag at a boundary moves that: see `_drag_boundary`. A drag at a threshold
    in the course of its variable moves that.

    Attributes
    ----------
    file_layout : where the rows lie, and which place is which time.

    Signals
    -------
    sought : seconds from the file's beginning.
    rename_asked : the user wants to rename the chosen label.
    split_asked : the user wants to split the label at the cursor.
    named : what was typed for a label, its `TimeSpan`, and how many labels further on another one is to be named.
    """

    sought = Signal(float)
    rename_asked = Signal()
    split_asked = Signal()
    named = Signal(str, object, int)

    def __init__(self, session: Session, courses: Courses, theme: Theme) -> None:
        super().__init__()
        self._session, self._courses = session, courses
        self._labels = session.labels
        self._view = session.view
        self.file_layout = FileLayout(session, self, theme)
        self._lanes = CourseLanes(session, courses, theme, self.file_layout)
        self._painter = FilePainter(session, theme, self.file_layout, self._lanes, self)
        self._line: HeldLine | None = None
        self._mouse: QPointF | None = None
        self._pressed: QPointF | None = None
        self._dragged_from = TimeSpan(0.0, 0.0)
        self._selects = False
        self._boundary = BoundaryDrag()
        self._edges = np.zeros(0)
        self._named = TimeSpan(0.0, 0.0)
        self.editor = LabelEditor(self)
        self.editor.typed.connect(lambda name, step: self.named.emit(name, self._named, step))
        self.setMinimumSize(260, 200)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(tr("File over time"))
        self.setToolTip(
            tr(
                "Wheel: zoom at the pointer. Drag: scroll. Click: go to that time. Shift+drag, or [ and ] at the "
                "cursor: select. Home, End: go to the start or end. Labels: type to rename, Enter splits at the "
                "cursor, drag a boundary (Ctrl: without snapping)."
            )
        )
        self.setMouseTracking(True)
        models = (
            session.whole,
            session.second.whole,
            session.second,
            session.sonagram,
            session.formants,
            session.feelings,
            session.waveform,
            session.labels,
        )
        for signal in (*(model.changed for model in models), self._view.moved):
            signal.connect(self._renew)
        self._view.selected.connect(self.update)  # it lies over the rows, as the playhead and what is read out do
        courses.changed.connect(self._show_courses)

    def course_rows(self) -> dict[str, QRectF]:
        """Return where each variable whose course is drawn has its lane."""
        return self._lanes.rows()

    def _show_courses(self) -> None:
        """Draw other variables, or only their thresholds where they are the same."""
        n = len(self._courses.variables)
        if n != self.file_layout.n_courses:
            self.file_layout.n_courses = n
            self._renew()
        else:
            self._painter.renew(courses_only=True)
            # at once: what a threshold that is dragged changes is recognised after that
            self.repaint(self.file_layout.rows()[-1].toAlignedRect().adjusted(-LEFT, 0, 0, 1))

    def show_spoken(self, lanes: list[Lane]) -> None:
        """Draw other lanes of what is said; those that a tier of labels of the same name shows are left out."""
        self.file_layout.spoken = lanes
        self._renew()

    def _renew(self) -> None:
        """Paint the rows anew."""
        self._painter.renew()
        self.update()

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint all rows, what is selected, and the playhead."""
        painter = QPainter(self)
        try:
            self._painter.paint(painter, self.reading())
        finally:
            painter.end()  # whatever went wrong: Qt crashes where two paint one widget

    def reading(self) -> str:
        """Return what lies under the mouse, in words; empty where that is nothing."""
        row, tracks = self.file_layout.rows()[0], self._session.whole.tracks
        if self._mouse is None or tracks is None or not LEFT <= self._mouse.x() <= LEFT + self.file_layout.width:
            return ""
        time = self.file_layout.time_at(self._mouse.x())
        frame = int(time / FRAME_PERIOD)
        if not 0 <= frame < tracks.n_frames or tracks.states[frame] == FrameState.UNKNOWN:
            return ""
        values = tracks.features.frame(frame)
        parts = [f"{time:.3f} s", sound_name(Phoneme(int(tracks.phonemes[frame])))]
        for under, lane in self.file_layout.spoken_rows():
            if under.contains(self._mouse) and (span := lane.span_at(time)) is not None:
                parts.append(f"{lane.name}: {lane.texts[span]}")
        if row.contains(self._mouse):
            share = (row.bottom() - self._mouse.y()) / row.height()
            tiles = self._session.sonagram.tiles_for(self._view.seen, self.file_layout.width)
            parts += self._painter.sonagram.reading(tiles, time, share)
        parts += self._reading_over(values, frame)
        variable = self._lanes.variable_at(self._mouse) or self._courses.chosen
        if variable in values:
            parts.append(f"{self._lanes.named(variable)} {values[variable]:.4g}")
        return "   ".join(parts)

    def _reading_over(self, values: dict[str, float], frame: int) -> list[str]:
        """Return the values of what is drawn over the sonagram."""
        parts, shows = [], self._session.sonagram.overlays
        if "pitch" in shows:
            parts.append(f"f0 {values['f0']:.0f} Hz" if values.get("f0") else tr("no f0"))
        if "level" in shows:
            level = 20 * math.log10(max(values.get("volume", 0.0), 1e-6))
            parts.append(tr("level {level:.0f} dB").format(level=level))
        known = self._session.formants.formants_in(self._view.seen) if "formants" in shows else None
        if known is not None and 0 <= frame - known.first < len(known.frequencies):
            found = known.frequencies[frame - known.first, :3].tolist()
            parts += [f"F{k} {value:.0f}" for k, value in enumerate(found, 1) if not math.isnan(value)]
        if "feeling" in shows and (felt := self._session.feelings.feelings_in(self._view.seen).at(frame)) is not None:
            parts += feeling_words(felt)
        return parts

    # -- the user's hand ----------------------------------------------------------------------------------

    @override
    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom at the pointer; with Shift, or a sideways wheel, scroll."""
        turned = event.angleDelta()
        if turned.x() or event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self._view.scroll(-(turned.x() or turned.y()) / 1200 * self._view.seen.seconds)
        else:
            self._view.zoom(self.file_layout.time_at(event.position().x()), WHEEL_STEP ** (turned.y() / 120))
        event.accept()

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin to scroll, or with Shift to select."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed, self._dragged_from = event.position(), self._view.seen
            self._selects = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            self._line = None if self._selects else self._lanes.line_at(event.position())
            if self._line is not None:
                self._courses.touch(self._line.name)
            elif not self._selects:
                self._catch(event)

    @override
    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Rename the label that lies there."""
        label = self._label_at(event.position())
        if label is not None:
            self._labels.choose(label)
            self.rename_asked.emit()

    def _label_at(self, place: QPointF) -> ChosenLabel | None:
        for tier, strip in self.file_layout.label_rows().items():
            if strip.contains(place):
                return self._labels.label_at(tier, self.file_layout.time_at(place.x()))
        return None

    def _catch(self, event: QMouseEvent) -> None:
        """Catch a boundary; it moves alone with Ctrl, and else together with those at its time in other tiers."""
        lanes, alone = self.file_layout.label_lanes(), bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        held = self._boundary.press(lanes, self.file_layout.axis, event.position(), self._view.duration)
        if held is not None:
            here = held.seconds
            others = [lane.boundaries() for k, (_, lane) in enumerate(lanes) if k != held.lane and lane.movable]
            edges = np.concatenate([np.zeros(0), *others])
            self._edges = edges[np.abs(edges - here) > ROUNDING]
            label = ChosenLabel(self.file_layout.tiers_shown()[held.lane], held.boundary // 2)
            self._labels.begin_move(Boundary(label, bool(held.boundary % 2)), alone=alone)

    def _drag_boundary(self, event: QMouseEvent) -> bool:
        """Move a boundary that is held, say whether one is; it snaps to what lies near, unless Ctrl is down."""
        if self._boundary.held is None:
            return False
        time = self.file_layout.time_at(event.position().x())
        if not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            time = self._snapped(time, SNAP / self.file_layout.width * self._view.seen.seconds)
        held = self._boundary.move(time)
        if held is not None:
            self._labels.move(held.seconds)
        return True

    def _snapped(self, time: float, reach: float) -> float:
        """Return the nearest boundary of another tier within some seconds, or else the nearest zero crossing."""
        near = self._edges[np.abs(self._edges - time) <= reach]
        if len(near):
            return float(near[np.argmin(np.abs(near - time))])
        crossing = self._session.waveform.crossing_near(self._view.seen, time, reach)
        return time if crossing is None else crossing

    def ask_name(self, span: TimeSpan, name: str, *, begun: bool = False) -> None:
        """Have a label named in its place; see `LabelEditor.open_over`."""
        self._view.reveal(span)
        self._named = span
        layout, tier = self.file_layout, self._labels.tier_in_use
        row = layout.label_rows().get(-1 if tier is None else tier, layout.rows()[LANE])
        left, right = (min(max(layout.x_of(t), LEFT), LEFT + layout.width) for t in span)
        self.editor.open_over(QRectF(left, row.top(), right - left, row.height()), name, begun=begun)

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Scroll, or select; with no button, tell what lies there."""
        self._mouse = event.position()
        if self._pressed is None:
            over = self._boundary.boundary_at(self.file_layout.label_lanes(), self.file_layout.axis, event.position())
            upright = (
                Qt.CursorShape.SplitVCursor if self._lanes.line_at(event.position()) else Qt.CursorShape.ArrowCursor
            )
            self.setCursor(upright if over is None else Qt.CursorShape.SplitHCursor)
            self.update()
            return
        if self._line is not None:
            self._lanes.drag(self._line, event.position().y())
            return
        if self._drag_boundary(event):
            return
        moved = event.position().x() - self._pressed.x()
        if self._selects:
            self._view.select(
                TimeSpan(self.file_layout.time_at(self._pressed.x()), self.file_layout.time_at(event.position().x()))
            )
        elif abs(moved) > GRAB:
            start = self._dragged_from.start - moved / self.file_layout.width * self._dragged_from.seconds
            self._view.show(TimeSpan(start, start + self._dragged_from.seconds))

    @override
    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Go to a place that was clicked."""
        if self._pressed is None:
            return
        if self._line is not None:
            self._pressed = self._line = None
            self._courses.lines.end_move()
            return
        clicked = abs(event.position().x() - self._pressed.x()) <= GRAB and not self._selects
        self._pressed = None
        self._boundary.release()
        if not clicked:
            return
        label = self._label_at(event.position())
        self._labels.choose(label)
        self._view.select(None if label is None else self._labels.span_of(label))
        self.sought.emit(min(max(self.file_layout.time_at(event.position().x()), 0.0), self._view.duration))

    @override
    def leaveEvent(self, event: Any) -> None:
        self._mouse = None
        self.update()
        super().leaveEvent(event)

    @override
    def event(self, event: QEvent) -> bool:
        """Keep letters, and Escape, from being shortcuts while a label is chosen: they name it, or let it go."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride and self._names(event):
            event.accept()
            return True
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip and (tip := self._tip_at(event)):
            QToolTip.showText(event.globalPos(), tip, self)
            return True
        return super().event(event)

    def _tip_at(self, event: QHelpEvent) -> str:
        """Return why a label is hatched, or what the feeling in the voice is; empty where neither lies there."""
        feeling = self.file_layout.feeling_row()
        if feeling is not None and feeling.contains(QPointF(event.pos())):
            return feeling_tip()
        time = self.file_layout.time_at(event.pos().x())
        for strip, lane in self.file_layout.label_lanes():
            if strip.contains(QPointF(event.pos())) and lane.tips and (k := lane.span_at(time)) is not None:
                return lane.tips[k]
        return ""

    def _names(self, event: QKeyEvent) -> bool:
        """Say whether a key has to do with the name of the chosen label."""
        control = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
        plain = not event.modifiers() & control or event.modifiers() & control == control  # both: AltGr of Windows
        letter = event.text().isprintable() and bool(event.text().strip())
        return self._labels.chosen is not None and ((plain and letter) or event.key() == Qt.Key.Key_Escape)

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Name the chosen label, split the one at the cursor; scroll by half of what is seen, and zoom."""
        chosen = self._labels.chosen
        if chosen is not None and self._names(event):
            if event.key() == Qt.Key.Key_Escape:
                self._labels.choose(None)
            else:
                self.ask_name(self._labels.span_of(chosen), event.text(), begun=True)
            return
        half, seen = self._view.seen.seconds / 2, self._view.seen
        acts: dict[Qt.Key, Callable[[], Any]] = {
            Qt.Key.Key_Left: lambda: self._view.scroll(-half),
            Qt.Key.Key_Right: lambda: self._view.scroll(half),
            Qt.Key.Key_Up: lambda: self._view.zoom((seen.start + seen.end) / 2, WHEEL_STEP),
            Qt.Key.Key_Down: lambda: self._view.zoom((seen.start + seen.end) / 2, 1 / WHEEL_STEP),
            Qt.Key.Key_Return: self.split_asked.emit,
            Qt.Key.Key_Enter: self.split_asked.emit,
        }
        act = acts.get(Qt.Key(event.key()))
        if act is None:
            super().keyPressEvent(event)
        else:
            act()


class FilePanel(QWidget):
    """The view of the file, and choices above it.

    Attributes
    ----------
    view : what is painted.
    follow : whether the view goes along with what is playing.
    heading : whether that is a file, or a microphone's recording.
    live : a button that goes back to the live view of the microphone.
    whole, selection : buttons that show all of it, and what is selected.
    differs : the share of what is seen in which two presets differ.
    """

    def __init__(self, session: Session, courses: Courses, choices: SonagramChoices, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self.view = FileView(session, courses, theme)
        self.follow = toggle_button(tr("Follow"), tr("Scroll on by a page when playback leaves the view"))
        self.whole = tool_button(tr("Fit All"), tr("Zoom to the whole file (Shift+A)"))
        self.selection = tool_button(tr("Fit Selection"), tr("Zoom to the selection (Shift+Z); Shift+drag selects"))
        self.live = tool_button(tr("Live"), tr("Return to the live signal of the microphone (Ctrl+B)"))
        self.heading = QLabel(tr("<b>File</b>"))
        self.differs = ElidedLabel()
        self._lay_out(choices)
        self._connect()
        self._show_state()

    def refresh(self) -> None:
        """Go along with what is playing."""
        if self._session.source.playing and not self._session.seen.looks_back:
            self._session.view.follow(self._session.source.position)
            self.view.update()

    def _lay_out(self, choices: SonagramChoices) -> None:
        buttons = (self.live, self.follow, self.whole, self.selection)
        above = Wrapping(
            row(self.heading, (self.differs, 1), *buttons, spacing=8),
            row(1, *choices.buttons(), spacing=8),
            (6, 3, 6, 1),
        )
        column(above, (self.view, 1), on=self, spacing=2)

    def _connect(self) -> None:
        view = self._session.view
        self.follow.toggled.connect(partial(setattr, view, "follows"))
        self.whole.clicked.connect(lambda _checked: view.show_all())
        self.live.clicked.connect(lambda _checked: self._session.look_back(False))
        self._session.seen.looked_back.connect(self._show_state)
        self.selection.clicked.connect(lambda _checked: self._show_selection())
        self.view.sought.connect(self._session.seek)
        view.selected.connect(self._show_state)
        second = self._session.second
        for signal in (self._session.whole.changed, second.whole.changed, second.changed, view.moved):
            signal.connect(self._show_difference)
        self._session.sought.connect(lambda: view.follow(self._session.source.position))
        self._session.sought.connect(self.view.update)

    def _show_difference(self) -> None:
        seen = self._session.view.seen
        frames = FrameRange(int(seen.start / FRAME_PERIOD), int(seen.end / FRAME_PERIOD) + 1)
        share = self._session.second.share_of_difference(frames)
        self.differs.setVisible(share is not None)
        if share is not None:
            first, second = self._session.second.names
            self.differs.setText(tr("{share:.1f} % different").format(share=100 * share))
            self.differs.setToolTip(
                tr("{first} and {second} recognise different phonemes in {share:.1f} % of the visible frames").format(
                    first=first, second=second, share=100 * share
                )
            )

    def _show_selection(self) -> None:
        if self._session.view.selection is not None:
            self._session.view.show(self._session.view.selection)

    def _show_state(self) -> None:
        self.live.setVisible(self._session.seen.looks_back)
        self.follow.setVisible(not self._session.seen.looks_back)
        self.heading.setText(tr("<b>History</b>") if self._session.seen.looks_back else tr("<b>File</b>"))
        self.follow.setChecked(self._session.view.follows)
        self.selection.setEnabled(self._session.view.selection is not None)
