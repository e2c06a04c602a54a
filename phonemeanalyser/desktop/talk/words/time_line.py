"""The timeline of what is said, and the bar above it: what is known, which words fit badly, how much is seen."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from PySide6 import QtGui
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt
from PySide6.QtWidgets import QMenu, QSizePolicy, QToolTip, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr, tr_count, tr_noop
from phonemeanalyser.desktop.session.time_view import TimeSpan, TimeView
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.words import spoken_lanes
from phonemeanalyser.desktop.talk.words.felt_text import USUAL
from phonemeanalyser.desktop.theme import CENTRED, Theme, draw_text
from phonemeanalyser.desktop.widgets import builders, lanes
from phonemeanalyser.desktop.widgets.plot import PlotMenu, table_of
from phonemeengine.labels.utterance import LabelUnit
from phonemeengine.performance.driver import UsedUnit

LEFT, GAP, HEIGHT = 66, 1, 20
"""Pixels of the names at the left, between lanes, and of a lane."""
LEAST_WAVE = 24
"""Pixels of the waveform at least; it takes what the lanes leave."""
EDITED = {0: LabelUnit.WORD, 2: LabelUnit.PHONE}
"""The lanes whose spans can be renamed, by their number."""
UNITS = (LabelUnit.WORD, LabelUnit.SYLLABLE, LabelUnit.PHONE)
STALE = 0.55
"""How much of the lanes of another text is hidden, 0..1."""
WHEEL_STEP = 0.8
"""How much less is seen after a notch of the wheel."""
CLICK = 3
"""Pixels by which a press may move and still be a click."""
EDITABLE = tr_noop(
    "Click a word to play it, double-click to rename it, drag a boundary to move it. Left, Right: one picture. Up, "
    "Down or the wheel: zoom. Drag: scroll. F2: rename, to a word or to IPA between slashes. Insert: another word. "
    "Enter: split. Delete: delete."
)
FIXED = tr_noop(
    "Click a word to play it. Left, Right: one picture. Up, Down or the wheel: zoom. Drag: scroll. The voice sets "
    "the boundaries: to move them, save the spoken text and open that file."
)
NOTHING = tr_noop("Open a recording with Ctrl+O, or write a text above and press Speak")


class SpeechTimeline(QWidget):
    """Paints waveform, lanes and times of the current sound, as much of it as the Analyse page shows.

    A click plays a word, a syllable or a phone, or what a unit of a recorded face was taken from, and a double click
    all of its recording; elsewhere it goes to that time. A boundary can be dragged. Left and Right go one picture.

    Attributes
    ----------
    lanes : what is said when, from above.
    menu : copies and saves what is painted.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking, self._texts, self._session = talking, talking.text, talking.session
        self._theme = theme
        self.lanes: tuple[lanes.Lane, ...] = ()
        self._units: list[UsedUnit] = []
        self._shown: tuple[object, ...] = ()
        self._picture: QtGui.QPixmap | None = None
        self._playhead = 0.0
        self._drag = lanes.BoundaryDrag()
        self._pressed: tuple[QPointF, TimeSpan] | None = None
        self.menu = PlotMenu(self, "what is said", lambda _at: table_of(self._columns()))
        edits = self._texts.edits
        self._word_acts = self.menu.put_first(
            {tr("Rename"): edits.ask_rename, tr("Delete"): edits.delete, tr("Realign This Word"): edits.realign}
        )
        self.menu.aboutToShow.connect(self._choose_for_menu)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName(tr("Timeline: words and phones over time"))
        self._stale = ""
        self.editor = lanes.LabelEditor(self)
        self._felt, self._writes = talking.felt_text, partial(self._texts.edits.name)
        self.editor.typed.connect(self._take_typed)
        self._felt.changed.connect(self.show_words)
        self._texts.edits.name_asked.connect(self._ask_name)
        self._texts.edits.changed.connect(self._touch)
        self._texts.changed.connect(self.show_words)
        self._texts.text_changed.connect(self._show_stale)
        for signal in (self._session.whole.changed, self._session.view.moved, self._texts.speech_view.moved):
            signal.connect(self._touch)
        self._session.opened.connect(self._touch)
        self.show_words()

    def show_words(self) -> None:
        """Show what is known now."""
        texts = self._texts
        letters, units = texts.drivers.letters, texts.drivers.performance.units
        known = (texts.utterance, letters, units, texts.editable, self._felt.spans)
        if not self._shown or any(one is not other for one, other in zip(known, self._shown, strict=True)):
            self._shown = known
            self.setToolTip(tr(EDITABLE if texts.editable else FIXED))
            shown = [lanes.Lane(tr(name)) for name in spoken_lanes.NAMES]
            if texts.utterance is not None:
                shown = spoken_lanes.lanes_of(texts.utterance, letters, movable=texts.editable)
            self._units = spoken_lanes.in_a_row(units)
            felt = (
                [spoken_lanes.lane_of_feelings(self._felt.spans)]
                if self._felt.spans or texts.utterance is not None
                else []
            )
            self.lanes = (*shown, *felt, *([spoken_lanes.lane_of_units(self._units)] if units else ()))
            self.setMinimumHeight(LEAST_WAVE + len(self.lanes) * (HEIGHT + GAP) + lanes.TIME_HEIGHT + 2 * GAP)
            self._touch()
        self._drag.release()
        self._show_stale()
        self.update()

    def _show_stale(self) -> None:
        """Hatch the lanes while the text is another one than theirs."""
        if self._texts.stale != self._stale:
            self._stale = self._texts.stale
            self._touch()

    def refresh(self) -> None:
        """Go along with what is playing."""
        position = self._session.source.position
        if self._session.source.playing:
            self.view.follow(position)
        if position != self._playhead:
            self._playhead = position
            self.update()

    @property
    def view(self) -> TimeView:
        """Which seconds are seen."""
        return self._texts.view

    @property
    def axis(self) -> lanes.TimeAxis:
        """Where times lie."""
        seen = self.view.seen
        return lanes.TimeAxis(LEFT, max(1, self.width() - LEFT), seen.start, max(seen.seconds, 1e-9))

    def x_of(self, seconds: float) -> float:
        """Return the pixel of a time."""
        return self.axis.x_of(seconds)

    def rows(self) -> list[tuple[QRectF, lanes.Lane]]:
        """Return where the lanes lie."""
        top = self._wave_row().bottom() + GAP
        width = max(1, self.width() - LEFT)
        return [(QRectF(LEFT, top + k * (HEIGHT + GAP), width, HEIGHT), lane) for k, lane in enumerate(self.lanes)]

    def _wave_row(self) -> QRectF:
        height = self.height() - len(self.lanes) * (HEIGHT + GAP) - lanes.TIME_HEIGHT - 2 * GAP
        return QRectF(LEFT, 0, max(1, self.width() - LEFT), max(LEAST_WAVE, height))

    # -- painting -----------------------------------------------------------------------------------------

    @override
    def paintEvent(self, _event: QtGui.QPaintEvent) -> None:
        """Paint what stands still, which is drawn once, and on it the playhead and the boundary in the hand."""
        painter = QtGui.QPainter(self)
        if self._picture is None:
            self._picture = self._drawn()
        painter.drawPixmap(0, 0, self._picture)
        if self.view.duration <= 0:
            return
        bottom = self.height() - lanes.TIME_HEIGHT
        x = self.x_of(self._playhead)
        if LEFT <= x <= self.width():
            painter.fillRect(QRectF(x - 0.5, 0, 1.5, bottom), QtGui.QColor(self._theme.accent))
        if self._drag.held is not None:
            row = self.rows()[self._drag.held.lane][0]
            held = QRectF(self.x_of(self._drag.held.seconds) - 1, row.top() - 2, 2, row.height() + 4)
            painter.fillRect(held, QtGui.QColor(self._theme.text))

    def _drawn(self) -> QtGui.QPixmap:
        scale = self.devicePixelRatioF()
        picture = QtGui.QPixmap(self.size() * scale)
        picture.setDevicePixelRatio(scale)
        picture.fill(QtGui.QColor(self._theme.base))
        painter = QtGui.QPainter(picture)
        painter.setFont(self.font())
        try:
            self._paint(painter)
        finally:
            painter.end()  # whatever went wrong: Qt crashes where two paint one picture
        return picture

    def _paint(self, painter: QtGui.QPainter) -> None:
        if self.view.duration <= 0:
            draw_text(painter, QRectF(self.rect()), tr(NOTHING), self._theme.faint, 13, CENTRED)
            return
        axis = self.axis
        peaks = self._texts.outline_in(TimeSpan(axis.start, axis.end), round(axis.width))
        if peaks is not None:
            lanes.paint_wave(painter, self._wave_row(), peaks, self._theme)
        for row, lane in self.rows():
            lanes.paint_name(painter, row, lane.name, self._theme)
            lanes.paint_lane(painter, row, lane, axis, self._theme)
            if self._texts.edits.chosen is not None and row == self._chosen_row():
                self._paint_chosen(painter, row, lane)
            if self._stale:
                ground = QtGui.QColor(self._theme.base)
                ground.setAlphaF(STALE)
                painter.fillRect(row, ground)
                painter.fillRect(row, QtGui.QBrush(QtGui.QColor(self._theme.faint), Qt.BrushStyle.BDiagPattern))
        lanes.paint_times(painter, self.height() - lanes.TIME_HEIGHT, axis, self._theme, self.width())

    def _chosen_row(self) -> QRectF:
        """Return where the lane of what is chosen lies."""
        assert self._texts.edits.chosen is not None
        number = next(number for number, unit in EDITED.items() if unit is self._texts.edits.chosen[0])
        return self.rows()[number][0]

    def _paint_chosen(self, painter: QtGui.QPainter, row: QRectF, lane: lanes.Lane) -> None:
        """Frame the word or phone that is chosen."""
        assert self._texts.edits.chosen is not None
        k = self._texts.edits.chosen[1]
        if k < len(lane.starts):
            left, right = (min(max(self.x_of(float(t[k])), LEFT), self.width() - 1) for t in (lane.starts, lane.ends))
            painter.setPen(QtGui.QPen(QtGui.QColor(self._theme.text), 2))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(QRectF(left + 1, row.top() + 1, max(1.0, right - left - 2), row.height() - 2))

    def _ask_name(self, span: TimeSpan, name: str) -> None:
        """Have a word or a phone named in its place."""
        if not self.isVisible():
            return
        self.view.reveal(span)
        chosen = self._texts.edits.chosen
        row = self.rows()[0][0] if chosen is None else self._chosen_row()
        left, right = (min(max(self.x_of(time), LEFT), self.width()) for time in span)
        self.editor.open_over(QRectF(left, row.top(), right - left, row.height()), name, begun=False)

    def _touch(self) -> None:
        self._picture = None
        self.update()

    # -- the user's hand ----------------------------------------------------------------------------------

    @override
    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:
        super().resizeEvent(event)
        self._touch()

    @override
    def wheelEvent(self, event: QtGui.QWheelEvent) -> None:
        """Zoom at the pointer; with Shift, or a sideways wheel, scroll."""
        turned = event.angleDelta()
        if turned.x() or event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self.view.scroll(-(turned.x() or turned.y()) / 1200 * self.view.seen.seconds)
        else:
            self.view.zoom(self.axis.time_at(event.position().x()), WHEEL_STEP ** (turned.y() / 120))

    @override
    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:
        """Take a boundary in the hand, else what is seen, to scroll it."""
        place = event.position()
        if event.button() != Qt.MouseButton.LeftButton or place.x() < LEFT - lanes.GRAB:
            return
        if self._drag.press(self.rows(), self.axis, place, self.view.duration) is None:
            self._pressed = place, self.view.seen

    @override
    def mouseMoveEvent(self, event: QtGui.QMouseEvent) -> None:
        """Drag the boundary or what is seen along; show which boundaries can be dragged."""
        place = event.position()
        if self._drag.move(self.axis.time_at(place.x())) is not None:
            self.update()
        elif self._pressed is not None:
            before, moved = self._pressed[1], place.x() - self._pressed[0].x()
            if abs(moved) > CLICK:
                start = before.start - moved / self.axis.width * before.seconds
                self.view.show(TimeSpan(start, start + before.seconds))
        else:
            over = self._drag.boundary_at(self.rows(), self.axis, place)
            self.setCursor(Qt.CursorShape.ArrowCursor if over is None else Qt.CursorShape.SplitHCursor)

    @override
    def mouseReleaseEvent(self, event: QtGui.QMouseEvent) -> None:
        """Let the boundary go; it has moved, unless it is where it was. Else go to what was clicked."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        moved, pressed, self._pressed = self._drag.release(), self._pressed, None
        self.update()
        if moved is not None and self._is_of_feelings(moved.lane):
            number, is_end = divmod(moved.boundary, 2)
            self._felt.move(number, is_end=bool(is_end), seconds=moved.seconds)
        elif moved is not None:
            self._texts.edits.move_boundary(UNITS[moved.lane], moved.boundary, moved.seconds)
        elif pressed is not None and abs(event.position().x() - pressed[0].x()) <= CLICK:
            self._go_to(event.position())

    @override
    def mouseDoubleClickEvent(self, event: QtGui.QMouseEvent) -> None:
        """Play the whole recording that a unit is from; rename a word or a phone; change or add a feeling."""
        found, lane = self._span_at(event.position()), self._lane_at(event.position())
        if lane is not None and self._is_of_feelings(lane):
            self._ask_feeling(event.position(), None if found is None else found[1])
        elif found is not None and self._is_of_units(found[0]):
            self._texts.original.play(self._units[found[1]], whole=True)
        elif found is not None and self._texts.edits.chosen is not None:
            self._session.pause()
            self._texts.edits.ask_rename()

    def _go_to(self, place: QPointF) -> None:
        """Play what lies at a pixel; where nothing does, go to that time."""
        found = self._span_at(place)
        self._choose(found)
        if found is None:
            self._session.seek(min(max(self.axis.time_at(place.x()), 0.0), self.view.duration))
        elif self._is_of_units(found[0]):
            self._texts.original.play(self._units[found[1]])
        else:
            lane = self.lanes[found[0]]
            self._texts.edits.play(float(lane.starts[found[1]]), float(lane.ends[found[1]]))

    def _choose(self, found: tuple[int, int] | None) -> None:
        """Choose a word or a phone, where it can be edited."""
        is_edited = found is not None and self._texts.edits.possible and found[0] in EDITED
        self._texts.edits.choose((EDITED[found[0]], found[1]) if found is not None and is_edited else None)

    def _choose_for_menu(self) -> None:
        """Choose what was clicked with the right button."""
        self._choose(self._span_at(QPointF(self.menu.at)))
        for entry in self._word_acts:
            entry.setEnabled(self._texts.edits.chosen is not None)

    def _ask_feeling(self, place: QPointF, number: int | None) -> None:
        """Have a feeling typed in its place, or a new one."""
        self._session.pause()
        time = self.axis.time_at(place.x())
        lane = self._lane_at(place)
        if lane is None:
            return
        row = self.rows()[lane][0]
        span = None if number is None else self._felt.spans[number]
        left, right = (self.x_of(time),) * 2 if span is None else (self.x_of(span.start), self.x_of(span.end))
        self._writes = partial(self._felt.insert, time) if span is None else partial(self._felt.write, span)
        words = USUAL if span is None else span.words
        self.editor.open_over(QRectF(left, row.top(), right - left, row.height()), words, begun=False)

    def _take_typed(self, words: str, _step: int) -> None:
        writes, self._writes = self._writes, partial(self._texts.edits.name)
        writes(words)

    def _lane_at(self, place: QPointF) -> int | None:
        return next((number for number, (row, _) in enumerate(self.rows()) if row.contains(place)), None)

    def _is_of_feelings(self, number: int) -> bool:
        return self.lanes[number].name == tr(spoken_lanes.FELT_NAME)

    def _is_of_units(self, number: int) -> bool:
        return self.lanes[number].name == tr(spoken_lanes.PERFORMED)

    def _span_at(self, place: QPointF) -> tuple[int, int] | None:
        """Return lane and number of the span at a pixel; None where there is none."""
        for number, (row, lane) in enumerate(self.rows()):
            if row.contains(place):
                span = lane.span_at(self.axis.time_at(place.x()))
                return None if span is None else (number, span)
        return None

    @override
    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        """Go one picture, zoom, or change the word that is chosen."""
        seen = self.view.seen
        middle = (seen.start + seen.end) / 2
        acts: dict[Qt.Key, Callable[[], Any]] = {
            Qt.Key.Key_Left: lambda: self._talking.pictures.step(-1),
            Qt.Key.Key_Right: lambda: self._talking.pictures.step(1),
            Qt.Key.Key_Up: lambda: self.view.zoom(middle, WHEEL_STEP),
            Qt.Key.Key_Down: lambda: self.view.zoom(middle, 1 / WHEEL_STEP),
            Qt.Key.Key_F2: self._texts.edits.ask_rename,
            Qt.Key.Key_Insert: self._texts.edits.ask_insert,
            Qt.Key.Key_Delete: self._texts.edits.delete,
            Qt.Key.Key_Return: self._texts.edits.split,
            Qt.Key.Key_Enter: self._texts.edits.split,
        }
        act = None if event.modifiers() else acts.get(Qt.Key(event.key()))
        if act is None:
            super().keyPressEvent(event)
        else:
            act()

    @override
    def event(self, event: QEvent) -> bool:
        if isinstance(event, QtGui.QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            found = self._span_at(QPointF(event.pos()))
            tips = () if found is None else self.lanes[found[0]].tips
            if found is not None and tips:
                QToolTip.showText(event.globalPos(), tips[found[1]], self)
                return True
        return super().event(event)

    @override
    def leaveEvent(self, _event: QEvent) -> None:
        self.unsetCursor()

    def _columns(self) -> dict[str, Sequence[object]]:
        """Return the phones as columns, each under its name and unit."""
        utterance = self._texts.utterance
        rows = [(word, phone) for word in (utterance.words if utterance else ()) for phone in word.phones]
        return {
            "start (s)": [phone.start for _, phone in rows],
            "end (s)": [phone.end for _, phone in rows],
            "word": [word.text for word, _ in rows],
            "phone": [phone.ipa for _, phone in rows],
            "phoneme": [phone.phoneme.label for _, phone in rows],
            "score": ["" if phone.score is None else phone.score for _, phone in rows],
        }


MOST_LISTED = 30
"""Words of those that fit badly that are listed at once."""


class LanesPanel(QWidget):
    """The timeline and its bar.

    Attributes
    ----------
    line : the timeline.
    summary : what is known of the sound.
    poor : lists the words that fit badly; `previous` and `next` go to the one before and after.
    whole : shows all of the sound.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._texts, self._theme = talking.text, theme
        self.line = SpeechTimeline(talking, theme)
        self.summary = builders.ElidedLabel()
        self._list = QMenu(self)
        self.previous = builders.spoken_button(
            "◂", tr("Go to the previous poor match"), partial(self._texts.edits.show_poor, -1)
        )
        self.poor = builders.spoken_button("", tr("Words that fit the recording badly; choose one to play it"))
        self.next = builders.spoken_button(
            "▸", tr("Go to the next poor match"), partial(self._texts.edits.show_poor, 1)
        )
        self.whole = builders.spoken_button(tr("Fit All"), tr("Zoom to the whole length"), self._show_whole)
        builders.open_without_arrow(self.poor, self._list)
        bar = builders.row((self.summary, 1), self.previous, self.poor, self.next, self.whole, spacing=4)
        bar.setContentsMargins(8, 0, 8, 0)
        builders.column(bar, (self.line, 1), on=self, margins=(0, 2, 0, 0), spacing=2)
        self._list.aboutToShow.connect(self._fill_list)
        for signal in (self._texts.changed, self._texts.text_changed):
            signal.connect(self._show_state)
        for view in (talking.session.view, self._texts.speech_view):
            view.moved.connect(self._allow_whole)
        self._show_state()

    def refresh(self) -> None:
        """Go along with what is playing."""
        self.line.refresh()

    def _show_whole(self) -> None:
        self._texts.view.show_all()

    def _show_state(self) -> None:
        self.summary.setText(self._summary())
        self.summary.setStyleSheet(f"color: {self._theme.bad if self._texts.stale else self._theme.text}")
        n = len(self._texts.edits.poor)
        self.poor.setText(tr_count("{n} poor match", "{n} poor matches", n) + " ▾")
        for button in (self.previous, self.poor, self.next):
            button.setVisible(n > 0)
        self._allow_whole()

    def _allow_whole(self) -> None:
        self.whole.setEnabled(self._texts.view.duration > 0)

    def _summary(self) -> str:
        """Return what is known, in words."""
        utterance = self._texts.utterance
        if utterance is None:
            return ""
        if self._texts.stale:
            return self._texts.stale
        said = tr_count("{n} word", "{n} words", len(utterance.words))
        return said if self._texts.editable else tr("{said}; boundaries fixed by the voice").format(said=said)

    def _fill_list(self) -> None:
        self._list.clear()
        poor = self._texts.edits.poor
        for word in poor[:MOST_LISTED]:
            words = tr("{seconds:.2f} s: {word}").format(seconds=word.start, word=word.text).replace("&", "&&")
            self._list.addAction(words, partial(self._texts.edits.show, word))
        if len(poor) > MOST_LISTED:
            self._list.addAction(tr("{n} more").format(n=len(poor) - MOST_LISTED)).setEnabled(False)
