"""What scrolls: the sonagram with its colours, the lane of phonemes under it, and the course of one variable."""

from collections.abc import Sequence
from math import ceil, floor
from typing import Any

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QGridLayout, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.analyse.lanes import feeling_lane, sonagram
from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.courses import Courses
from phonemeanalyser.desktop.session.results import CAPACITY, NOWHERE, History
from phonemeanalyser.desktop.session.seen_tracks import LiveFeelings
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sonagram_tiles import Tile
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.builders import Wrapping, column, label, row, silent, tool_button
from phonemeanalyser.desktop.widgets.lanes import TimeAxis, lane_of_frames, names_in_lanes, paint_lane
from phonemeanalyser.desktop.widgets.plot import (
    READOUTS_PER_SECOND,
    LiveAxis,
    LiveCurve,
    PlotMenu,
    ReadOut,
    live_axes,
    table_of,
    unlink_hidden_axes,
)
from phonemeengine.arrays import Float32Array
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

SPAN = CAPACITY * FRAME_PERIOD
"""Seconds that can be seen."""


class SonagramItem(pg.GraphicsObject):
    """The last minute of live sound as a sonagram: measured, coloured and painted as that of a file.

    Attributes
    ----------
    n_drawn : columns since Clear up to the newest that is drawn; while the views are frozen, others follow it.
    """

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._history, self._live, self._sonagram = session.history, session.live, session.sonagram
        self._formants, self._theme = session.formants, theme
        self.painter = sonagram.SonagramPainter(session.sonagram, theme)
        self.n_drawn = 0

    def refresh(self) -> None:
        """Draw what is new since the last call."""
        self.n_drawn = self._history.n
        self.update()

    @override
    def boundingRect(self) -> QRectF:
        """One minute by one."""
        return QRectF(-SPAN, 0, SPAN, 1)

    def tiles(self, axis: TimeAxis) -> list[Tile]:
        """Return what is known of what is seen."""
        return self._live.tiles_for(TimeSpan(axis.start, axis.end), max(1, round(axis.width)))

    @override
    def paint(self, painter: QPainter, _option: Any, _widget: Any = None) -> None:
        row, axis = row_of(self, painter, self.n_drawn)
        painter.resetTransform()
        painter.fillRect(row, QColor(self._theme.base))
        self.painter.paint_tiles(painter, row, axis, self.tiles(axis))
        first, last = floor(axis.start / FRAME_PERIOD), min(ceil(axis.end / FRAME_PERIOD), self.n_drawn)
        at = self._history.indices(first, last)
        seen, wanted = TimeSpan(axis.start, axis.end), "formants" in self._sonagram.overlays
        formants = self._live.formants_in(seen, self._formants.ceiling) if wanted else None
        over = sonagram.Overlaid(last - len(at), self._history.features(at), formants)
        self.painter.paint_over(painter, row, axis, over)


class PhonemeLane(pg.GraphicsObject):
    """The recognised phonemes as coloured segments, named where there is room; as far as the sonagram is drawn."""

    def __init__(self, history: History, sonagram: SonagramItem, theme: Theme) -> None:
        super().__init__()
        self._history = history
        self._sonagram = sonagram
        self._theme = theme
        colours = [*(PHONEME_COLOURS[p] for p in Phoneme), theme.base]  # the last one is that of a gap
        self._pixels = np.array([QColor(colour).rgb() for colour in colours], np.uint32)
        self._names = [*names_in_lanes(), ""]

    @override
    def boundingRect(self) -> QRectF:
        """One minute by one."""
        return QRectF(-SPAN, 0, SPAN, 1)

    @override
    def paint(self, painter: QPainter, _option: Any, _widget: Any = None) -> None:
        """Paint the segments that are in view, and the names of those that are wide enough."""
        view, n = self.viewRect(), self._sonagram.n_drawn
        first, last = (n + edge(side / FRAME_PERIOD) for edge, side in ((floor, view.left()), (ceil, view.right())))
        last = min(last, n)
        at = self._history.indices(first, last)
        row, axis = row_of(self, painter, n)
        painter.resetTransform()
        codes = self._history.phonemes[at]
        lane = lane_of_frames("", codes, self._names, self._pixels, first=last - len(at))
        paint_lane(painter, row, lane, axis, self._theme)


class FeelingItem(pg.GraphicsObject):
    """The feeling in the voice, as far as the sonagram is drawn."""

    def __init__(self, feelings: LiveFeelings, sonagram: SonagramItem, theme: Theme) -> None:
        super().__init__()
        self._feelings, self._sonagram, self._theme = feelings, sonagram, theme
        self.setToolTip(feeling_lane.feeling_tip())

    @override
    def boundingRect(self) -> QRectF:
        """One minute by one."""
        return QRectF(-SPAN, 0, SPAN, 1)

    @override
    def paint(self, painter: QPainter, _option: Any, _widget: Any = None) -> None:
        row, axis = row_of(self, painter, self._sonagram.n_drawn)
        painter.resetTransform()
        feeling_lane.paint_feelings(
            painter, row, axis, self._feelings.feelings_in(TimeSpan(axis.start, axis.end)), self._theme
        )


def row_of(item: pg.GraphicsObject, painter: QPainter, n_drawn: int) -> tuple[QRectF, TimeAxis]:
    """Return where an item is painted, pixels, and where times since Clear lie there; `n_drawn` columns end at 0."""
    view = item.viewRect()
    row = painter.transform().mapRect(QRectF(view.left(), 0, view.width(), 1))
    return row, TimeAxis(row.left(), row.width(), n_drawn * FRAME_PERIOD + view.left(), view.width())


class MarksAxis(LiveAxis):
    """The frequencies beside the live sonagram, written as beside that of a file."""

    def __init__(self, painter: sonagram.SonagramPainter, theme: Theme) -> None:
        super().__init__("left")
        self._painter, self._theme = painter, theme

    @override
    def paint(self, painter: QPainter, _option: Any, _widget: Any = None) -> None:
        row = QRectF(0, 0, self.size().width(), self.size().height())
        self._painter.paint_marks(painter, row, self._theme.faint, row.width() - 7)


class ColourBar(QWidget):
    """Shows which colour stands for which level, brightest on top, and the scales of what is drawn over them."""

    def __init__(self, painter: sonagram.SonagramPainter) -> None:
        super().__init__()
        self._painter = painter
        self.setFixedWidth(sonagram.SIDE)

    @override
    def paintEvent(self, _event: Any) -> None:
        self._painter.paint_side(QPainter(self), QRectF(0, 1, 0, self.height() - 3))


LANE_HEIGHT = 22
COURSE_HEIGHT = 110
AXIS_WIDTH = 52
SECONDS_SHOWN = 6.0


class ScrollView(QWidget):
    """Plots over the same seconds before now, the feeling in the voice if it is wanted; 0 is what is playing.

    Attributes
    ----------
    courses : the variables whose courses are drawn; here it is the chosen one.
    cursor_label : reads out what lies under the mouse.
    """

    def __init__(self, session: Session, courses: Courses, choices: sonagram.SonagramChoices, theme: Theme) -> None:
        super().__init__()
        self._session, self._history = session, session.history
        self.courses = courses
        self._theme = theme
        self._graphics = pg.GraphicsLayoutWidget()
        self._graphics.setAccessibleName(tr("Live signal over time"))
        self.sonagram = SonagramItem(session, theme)
        self._lane = PhonemeLane(self._history, self.sonagram, theme)
        self._feeling = FeelingItem(session.live_feelings, self.sonagram, theme)
        self._course = LiveCurve(pen=pg.mkPen(theme.signal))
        self._limits: dict[str, pg.InfiniteLine] = {}
        self._name = pg.LabelItem(size="8pt", color=theme.text, justify="left")
        self._course_range = (0.0, 0.0)
        self.back = tool_button(
            tr("History"), tr("Show all that the microphone recorded since Clear on its own time axis (Ctrl+B)")
        )
        self._mouse: QPointF | None = None
        self.cursor_label = ReadOut(self._graphics, theme)
        self.menu = PlotMenu(self._graphics, "sonagram", self._values_at, self.reset_zoom)
        self._hint = pg.TextItem("", color=theme.faint, anchor=(0.5, 0.5))
        self._colour_bar = ColourBar(self.sonagram.painter)
        self._make_plots()
        self._lay_out(choices)
        self._connect()
        self._show_courses()

    def invite(self, text: str) -> None:
        """Say what the user may do, where nothing has been analysed yet."""
        self._hint.setText(text)

    def refresh(self) -> None:
        """Draw what is new."""
        self.sonagram.refresh()
        self._lane.update()
        self._feeling.update()
        self._draw_course()
        self._refresh_read_out()
        self._hint.setVisible(self._history.n == 0)

    def reset_zoom(self) -> None:
        """Show the newest seconds."""
        self._plots[0].setXRange(-SECONDS_SHOWN, 0, padding=0)

    def _show_look(self) -> None:
        """Draw all anew, as is chosen now."""
        height = feeling_lane.FEELING_HEIGHT if "feeling" in self._session.sonagram.overlays else 0
        self._plots[-1].setVisible(height > 0)
        self._plots[-1].setFixedHeight(height)
        self._rows.setRowMinimumHeight(1, LANE_HEIGHT + height + COURSE_HEIGHT)
        self.sonagram.update()
        self._plots[0].getAxis("left").update()
        self._colour_bar.setFixedWidth(sonagram.side_width(self._session.sonagram))
        self._colour_bar.update()

    def _make_plots(self) -> None:
        layout = self._graphics.ci
        layout.setContentsMargins(0, 0, 6, 0)
        layout.setSpacing(0)
        places = (0, 1, 3, 2)  # the feeling lies above the course
        axes = [live_axes() for _ in places]
        axes[0]["left"] = MarksAxis(self.sonagram.painter, self._theme)
        self._plots = [
            layout.addPlot(row=row, col=0, enableMenu=False, axisItems=of)
            for row, of in zip(places, axes, strict=True)
        ]
        items = (self.sonagram, self._lane, self._course, self._feeling)
        for plot, item in zip(self._plots, items, strict=True):
            plot.addItem(item)
            unlink_hidden_axes(plot)
            plot.hideButtons()
            plot.getAxis("left").setWidth(AXIS_WIDTH)
            plot.setMouseEnabled(x=True, y=False)
            plot.vb.setLimits(xMin=-SPAN, xMax=0)
            plot.vb.setDefaultPadding(0)
        self._hint.setPos(-SECONDS_SHOWN / 2, 0.5)
        self._plots[0].addItem(self._hint, ignoreBounds=True)
        self._name.setParentItem(self._plots[2].vb)  # where it stays, whatever is seen
        self._fix_ranges()

    def _fix_ranges(self) -> None:
        sonagram, lane, course, feeling = self._plots
        for plot in (sonagram, lane, feeling):
            plot.setYRange(0, 1, padding=0)
        lane.setFixedHeight(LANE_HEIGHT)
        for plot in (lane, feeling):
            plot.getAxis("left").setStyle(showValues=False, tickLength=0)
        course.setFixedHeight(COURSE_HEIGHT)
        course.setLabel("bottom", tr("Time before now (s)"))
        for plot in (sonagram, lane, feeling):
            plot.hideAxis("bottom")
        for plot in (lane, course, feeling):
            plot.setXLink(sonagram)
        sonagram.setXRange(-SECONDS_SHOWN, 0, padding=0)

    def _lay_out(self, choices: sonagram.SonagramChoices) -> None:
        plots = self._rows = QGridLayout()
        plots.setSpacing(0)
        plots.addWidget(self._graphics, 0, 0, 2, 1)
        plots.addWidget(self._colour_bar, 0, 1)
        plots.setRowStretch(0, 1)
        header = Wrapping(
            row(label(tr("<b>Sonagram and phonemes</b>")), 1, self.back, spacing=8),
            row(1, *choices.buttons(), spacing=8),
            (6, 3, 6, 1),
        )
        column(header, (plots, 1), on=self, spacing=0)

    def _connect(self) -> None:
        self._session.sonagram.changed.connect(self._show_look)
        self._show_look()
        self.courses.changed.connect(self._show_courses)
        self._plots[0].vb.sigXRangeChanged.connect(lambda *_range: self._draw_course())  # who pans back sees it too
        scene = self._graphics.scene()
        self._proxy = pg.SignalProxy(scene.sigMouseMoved, rateLimit=READOUTS_PER_SECOND, slot=self._on_mouse)

    # -- the variable -------------------------------------------------------------------------------------

    def _show_courses(self) -> None:
        """Show the chosen variable, and its thresholds as they are now."""
        course, lines = self._plots[2], self.courses.lines.lines_of(self.courses.chosen)
        self._name.setText(self.courses.lines.words_of(self.courses.chosen))
        if [line.name for line in lines] != [*self._limits]:
            for drawn in self._limits.values():
                course.removeItem(drawn)
            self._limits = {line.name: self._line_called(line.name, tr_engine(line.label)) for line in lines}
            for drawn in self._limits.values():
                course.addItem(drawn, ignoreBounds=True)
        for line in lines:
            drawn = self._limits[line.name]
            touched = line.name == self.courses.control
            style = Qt.PenStyle.SolidLine if touched else Qt.PenStyle.DashLine
            with silent(drawn):
                drawn.setValue(line.value)
            drawn.setPen(pg.mkPen(self._theme.bad, style=style, width=2 if touched else 1))
        self._draw_course()

    def _line_called(self, name: str, words: str) -> pg.InfiniteLine:
        """Return a level line with a name, which is dear to make; a drag moves the threshold."""
        how = {"position": 0.02, "anchors": [(0, 1), (0, 1)], "color": self._theme.bad}
        line = pg.InfiniteLine(angle=0, movable=True, label=words, labelOpts=how)
        line.sigDragged.connect(lambda dragged: self.courses.drag(name, float(dragged.value())))
        line.sigPositionChangeFinished.connect(lambda _line: self.courses.lines.end_move())
        return line

    def _draw_course(self) -> None:
        self.courses.live_seconds = -self._plots[0].vb.viewRange()[0][0]
        n_shown = min(CAPACITY, int(self.courses.live_seconds / FRAME_PERIOD) + 1)
        n = self.sonagram.n_drawn
        at = self._history.indices(n - n_shown, n)
        name = self.courses.chosen
        if len(at) == 0 or name not in self._history.names:
            self._course.setData([], [])
            return
        values = self._history.features(at)[name]
        self._course.setData((np.arange(len(at)) - len(at) + 0.5) * FRAME_PERIOD, values)
        self._fit_course(name, values)

    def _fit_course(self, name: str, drawn: Float32Array) -> None:
        highest, _, lowest = self._history.extremes(name) or (0.0, 0.0, 0.0)
        wanted = (
            float(np.fmin.reduce(drawn, initial=min(0.0, lowest))),
            _round_up(float(np.fmax.reduce(drawn, initial=highest))),
        )
        if wanted != self._course_range:
            self._course_range = wanted
            self._plots[2].setYRange(*wanted, padding=0.02)

    # -- the cursor ---------------------------------------------------------------------------------------

    @override
    def leaveEvent(self, event: Any) -> None:
        self._mouse = None
        self._refresh_read_out()
        super().leaveEvent(event)

    def _on_mouse(self, event: tuple[QPointF]) -> None:
        self._mouse = event[0]
        self._refresh_read_out()

    def _refresh_read_out(self) -> None:
        """Show what lies under the mouse now: it may stand still while the picture moves."""
        plot = self._plot_at(self._mouse) if self._mouse is not None else None
        self.cursor_label.show_reading(
            "" if plot is None else self._describe(plot, plot.vb.mapSceneToView(self._mouse))
        )

    def _plot_at(self, point: QPointF) -> Any:
        """Return the plot at a point of the scene, or None."""
        return next((plot for plot in self._plots if plot.vb.sceneBoundingRect().contains(point)), None)

    def _describe(self, plot: Any, point: QPointF) -> str:
        column = self.sonagram.n_drawn + int(np.floor(point.x() / FRAME_PERIOD))
        at = self._history.indices(column, column + 1)
        if len(at) == 0 or self._history.frames[at[0]] == NOWHERE:
            return ""
        k = int(at[0])
        phoneme = sound_name(Phoneme(int(self._history.phonemes[k])))
        text = f"{self._history.frames[k] * FRAME_PERIOD:.2f} s   {phoneme}"
        if plot is self._plots[0]:
            left, right = plot.vb.viewRange()[0]
            now = self.sonagram.n_drawn * FRAME_PERIOD
            axis = TimeAxis(0, plot.vb.width(), now + left, right - left)
            return "   ".join(
                [text, *self.sonagram.painter.reading(self.sonagram.tiles(axis), now + point.x(), point.y())]
            )
        if plot is self._plots[-1]:
            felt = self._session.live_feelings.feelings_in(TimeSpan(column * FRAME_PERIOD, self.sonagram.n_drawn))
            known = felt.at(column)
            return text if known is None else "   ".join([text, *feeling_lane.feeling_words(known)])
        name = self.courses.chosen
        values = self._history.features(at)
        return f"{text}   {name} {values[name][0]:.4g}" if name in values.names else text

    def _values_at(self, at: QPoint) -> str:
        """Return what is seen as a table: on the sonagram its amplitudes, else the chosen variable."""
        left, right = self._plots[0].vb.viewRange()[0]
        n, history = self.sonagram.n_drawn, self._history
        seen_columns = np.arange(n + floor(left / FRAME_PERIOD), min(n, n + ceil(right / FRAME_PERIOD)))
        seen_columns = seen_columns[history.columns_with_sound(seen_columns)]
        seen = seen_columns % CAPACITY
        columns: dict[str, Sequence[object] | NDArray[Any]] = {
            "time in the sound (s)": history.frames[seen] * FRAME_PERIOD,
            "phoneme": [Phoneme(code).label for code in history.phonemes[seen].tolist()],
            "intensity (0..1)": history.intensities[seen],
        }
        name = self.courses.chosen
        if self._plot_at(self._graphics.mapToScene(at)) is self._plots[0]:
            levels = self._session.live.levels_of(seen_columns)
            frequencies = self._session.sonagram.settings.frequencies.tolist()
            columns |= {f"level at {f:.1f} Hz (dB)": levels[:, k] for k, f in enumerate(frequencies)}
        elif name in history.names:
            unit = self.courses.lines.unit_of(name)
            columns[f"{name} ({unit})"] = history.features(seen)[name]
        return table_of(columns)


def _round_up(value: float) -> float:
    """Return the next of 1, 1.5, 2, 3, 5, 7, 10 times a power of ten, so that an axis seldom changes."""
    if value <= 0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(value))
    return float(power * next(step for step in (1, 1.5, 2, 3, 5, 7, 10) if step * power >= value * 0.999))
