"""What scrolls: the sonagram with its colours, the lane of phonemes under it, and the course of one variable."""

from collections.abc import Sequence
from math import ceil, floor
from typing import Any

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, QPointF, QRect, Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QGridLayout, QWidget

from phonemeanalyser.desktop.analyse.lanes.sonagram import (
    SPAN,
    PhonemeLane,
    SonagramItem,
    add_colour_maps,
    colours_of,
)
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.painting import set_size
from phonemeanalyser.desktop.session.courses import Courses
from phonemeanalyser.desktop.session.history import CAPACITY, NOWHERE, History
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import (
    Wrapping,
    choice,
    column,
    label,
    named,
    row,
    silent,
    toggle_button,
    tool_button,
)
from phonemeanalyser.desktop.widgets.number_field import NumberField
from phonemeanalyser.desktop.widgets.plot import READOUTS_PER_SECOND, LiveCurve, ReadOut, live_axes
from phonemeanalyser.desktop.widgets.plot_menu import PlotMenu, table_of
from phonemeengine.arrays import Float32Array, UInt32Array
from phonemeengine.dsp.sonagram import LEVELS
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import BIN_WIDTH, FRAME_PERIOD, SAMPLE_RATE

BAR = 14
"""Width of the bar in pixels."""


class ColourBar(QWidget):
    """Shows which colour stands for which amplitude, brightest on top."""

    def __init__(self) -> None:
        super().__init__()
        self._colours = np.zeros((256, 1), np.uint32)
        self._labels = ("", "", "")
        self.setFixedWidth(58)

    def draw(self, colours: UInt32Array, low: str, middle: str, high: str) -> None:
        """Draw a colour map, 256 pixels, with the values at its ends and middle."""
        self._colours = np.ascontiguousarray(colours[::-1, None])
        self._labels = (high, middle, low)
        self.update()

    def paintEvent(self, _event: Any) -> None:
        """Paint the bar and its three labels."""
        painter = QPainter(self)
        top, height = 12, self.height() - 24
        image = QImage(self._colours.data, 1, 256, 4, QImage.Format.Format_RGB32)
        painter.drawImage(QRect(4, top, BAR, height), image)
        set_size(painter, 10)
        align = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        for words, y in zip(self._labels, (top, top + height // 2, top + height), strict=True):
            painter.drawText(QRect(BAR + 7, y - 8, self.width() - BAR - 7, 16), align, words)


LANE_HEIGHT = 22
COURSE_HEIGHT = 110
AXIS_WIDTH = 52
SECONDS_SHOWN = 6.0


class ScrollView(QWidget):
    """Three plots over the same seconds before now; 0 is what is playing.

    Attributes
    ----------
    courses : the variables whose courses are drawn; here it is the chosen one.
    """

    def __init__(self, history: History, courses: Courses, theme: Theme) -> None:
        super().__init__()
        self._history = history
        self.courses = courses
        self._theme = theme
        self._graphics = pg.GraphicsLayoutWidget()
        self._graphics.setAccessibleName(tr("Live signal over time"))
        self.sonagram = SonagramItem(history, theme)
        self._lane = PhonemeLane(history, self.sonagram, theme)
        self._course = LiveCurve(pen=pg.mkPen(theme.signal))
        self._limits: dict[str, pg.InfiniteLine] = {}
        self._course_range = (0.0, 0.0)
        self._n_bins = 0
        self.decibels = toggle_button("dB", tr("Colours by level in dB, or by linear amplitude"))
        self.back = tool_button(
            tr("History"), tr("Show all that the microphone recorded since Clear on its own time axis (Ctrl+B)")
        )
        self.low = self._limit(
            LEVELS[0],
            tr("Level of the darkest colour"),
            tr("Level of the darkest colour, dBFS; with linear colours, the amplitude of that level"),
        )
        self.high = self._limit(
            LEVELS[1],
            tr("Level of the brightest colour"),
            tr("Level of the brightest colour, dBFS; with linear colours, the amplitude of that level"),
        )
        self.colours = choice((), tr("Colour map"), tr("Colours of the levels in the sonagram"))
        self._mouse: QPointF | None = None
        self._cursor_label = ReadOut(self._graphics, theme)
        self.menu = PlotMenu(self._graphics, "sonagram", self._values_at, self.reset_zoom)
        self._hint = pg.TextItem("", color=theme.faint, anchor=(0.5, 0.5))
        self._colour_bar = ColourBar()
        self._make_plots()
        self._lay_out()
        self._connect()
        self._show_courses()
        self._choose_colours()

    def invite(self, text: str) -> None:
        """Say what the user may do, where nothing has been analysed yet."""
        self._hint.setText(text)

    def refresh(self) -> None:
        """Draw what is new."""
        if self._n_bins != self._history.n_bins:
            self._n_bins = self._history.n_bins
            self._plots[0].vb.setLimits(yMax=self._n_bins * BIN_WIDTH)
            self._plots[0].setYRange(0, self._n_bins * BIN_WIDTH, padding=0)
        self.sonagram.refresh()
        self._lane.update()
        self._draw_course()
        self._refresh_read_out()
        self._hint.setVisible(self._history.n == 0)

    def reset_zoom(self) -> None:
        """Show the newest seconds, and all frequencies that the analysis reaches."""
        self._plots[0].setXRange(-SECONDS_SHOWN, 0, padding=0)
        self._plots[0].setYRange(0, self._n_bins * BIN_WIDTH, padding=0)

    def _make_plots(self) -> None:
        layout = self._graphics.ci
        layout.setContentsMargins(0, 0, 6, 0)
        layout.setSpacing(0)
        self._plots = [layout.addPlot(row=row, col=0, enableMenu=False, axisItems=live_axes()) for row in range(3)]
        labels = (tr("Frequency (Hz)"), "", tr("Variable"))
        for plot, item, name in zip(self._plots, (self.sonagram, self._lane, self._course), labels, strict=True):
            plot.addItem(item)
            plot.hideButtons()
            plot.getAxis("left").setWidth(AXIS_WIDTH)
            plot.setLabel("left", name)
            plot.setMouseEnabled(x=True, y=plot is self._plots[0])
            plot.vb.setLimits(xMin=-SPAN, xMax=0)
            plot.vb.setDefaultPadding(0)
        self._hint.setPos(-SECONDS_SHOWN / 2, SAMPLE_RATE / 16)
        self._plots[0].addItem(self._hint, ignoreBounds=True)
        self._fix_ranges()

    def _fix_ranges(self) -> None:
        sonagram, lane, course = self._plots
        sonagram.vb.setLimits(yMin=0)
        lane.setYRange(0, 1, padding=0)
        lane.setFixedHeight(LANE_HEIGHT)
        lane.getAxis("left").setStyle(showValues=False, tickLength=0)
        course.setFixedHeight(COURSE_HEIGHT)
        course.setLabel("bottom", tr("Time before now (s)"))
        for plot in (sonagram, lane):
            plot.hideAxis("bottom")
        for plot in (lane, course):
            plot.setXLink(sonagram)
        sonagram.setXRange(-SECONDS_SHOWN, 0, padding=0)

    def _limit(self, value: float, name: str, tip: str) -> NumberField:
        field = named(NumberField(-120, 0, unit=" dB"), name, tip)
        field.setValue(value)
        return field

    def _lay_out(self) -> None:
        add_colour_maps(self.colours)
        self.decibels.setChecked(True)
        plots = QGridLayout()
        plots.setSpacing(0)
        plots.addWidget(self._graphics, 0, 0, 2, 1)
        plots.addWidget(self._colour_bar, 0, 1)
        plots.setRowMinimumHeight(1, LANE_HEIGHT + COURSE_HEIGHT)
        plots.setRowStretch(0, 1)
        header = Wrapping(
            row(label(tr("<b>Sonagram and phonemes</b>")), 1, self.back, spacing=8),
            row(
                1,
                self.decibels,
                label(tr("Colours from")),
                self.low,
                label(tr("to")),
                self.high,
                label(tr("Colour map")),
                self.colours,
                spacing=8,
            ),
            (6, 3, 6, 1),
        )
        column(header, (plots, 1), on=self, spacing=0)

    def _connect(self) -> None:
        self.decibels.toggled.connect(lambda _on: self._choose_colours())
        for box in (self.low, self.high):
            box.valueChanged.connect(lambda _value: self._choose_colours())
        self.colours.currentIndexChanged.connect(lambda _k: self._choose_colours())
        self.courses.changed.connect(self._show_courses)
        self._plots[0].vb.sigXRangeChanged.connect(lambda *_range: self._draw_course())  # who pans back sees it too
        scene = self._graphics.scene()
        self._proxy = pg.SignalProxy(scene.sigMouseMoved, rateLimit=READOUTS_PER_SECOND, slot=self._on_mouse)

    # -- colours ------------------------------------------------------------------------------------------

    def _choose_colours(self) -> None:
        colours, in_decibels = colours_of(self.colours.currentData()), self.decibels.isChecked()
        low, high = sorted((float(self.low.value()), float(self.high.value())))
        if not in_decibels:
            low, high = 10 ** (low / 20), 10 ** (high / 20)
        self.sonagram.set_colours(colours, in_decibels, low, high)
        form = "{:.0f} dB" if in_decibels else "{:.3g}"
        self._colour_bar.draw(colours, *(form.format(value) for value in (low, (low + high) / 2, high)))

    # -- the variable -------------------------------------------------------------------------------------

    def _show_courses(self) -> None:
        """Show the chosen variable, and its thresholds as they are now."""
        course, lines = self._plots[2], self.courses.lines.lines_of(self.courses.chosen)
        course.setLabel("left", self.courses.chosen.replace("_", " "))
        if [line.name for line in lines] != [*self._limits]:
            for drawn in self._limits.values():
                course.removeItem(drawn)
            self._limits = {line.name: self._line_called(line.name) for line in lines}
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

    def _line_called(self, name: str) -> pg.InfiniteLine:
        """Return a level line with a name, which is dear to make; a drag moves the threshold."""
        how = {"position": 0.02, "anchors": [(0, 1), (0, 1)], "color": self._theme.bad}
        line = pg.InfiniteLine(angle=0, movable=True, label=name, labelOpts=how)
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

    def leaveEvent(self, event: Any) -> None:
        """Hide the read-out when the mouse leaves."""
        self._mouse = None
        self._refresh_read_out()
        super().leaveEvent(event)

    def _on_mouse(self, event: tuple[QPointF]) -> None:
        self._mouse = event[0]
        self._refresh_read_out()

    def _refresh_read_out(self) -> None:
        """Show what lies under the mouse now: it may stand still while the picture moves."""
        plot = self._plot_at(self._mouse) if self._mouse is not None else None
        self._cursor_label.show_reading(
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
            level = float(self._history.spectra[k, min(1023, max(0, round(point.y() / BIN_WIDTH)))])
            decibels = f"{20 * np.log10(level):.1f} dB" if level > 0 else "−∞ dB"
            return f"{text}   {point.y():.0f} Hz   {level:.4f}   {decibels}"
        name = self.courses.chosen
        values = self._history.features(at)
        return f"{text}   {name} {values[name][0]:.4g}" if name in values.names else text

    def _values_at(self, at: QPoint) -> str:
        """Return what is seen as a table: on the sonagram its amplitudes, else the chosen variable."""
        left, right = self._plots[0].vb.viewRange()[0]
        n, history = self.sonagram.n_drawn, self._history
        seen = history.indices(n + floor(left / FRAME_PERIOD), n + ceil(right / FRAME_PERIOD))
        seen = seen[history.frames[seen] != NOWHERE]
        columns: dict[str, Sequence[object] | NDArray[Any]] = {
            "time in the sound (s)": history.frames[seen] * FRAME_PERIOD,
            "phoneme": [Phoneme(code).label for code in history.phonemes[seen].tolist()],
            "intensity (0..1)": history.intensities[seen],
        }
        name = self.courses.chosen
        if self._plot_at(self._graphics.mapToScene(at)) is self._plots[0]:
            low, high = (round(edge / BIN_WIDTH) for edge in self._plots[0].vb.viewRange()[1])
            bins = range(max(0, low), min(high + 1, history.n_bins))
            columns |= {f"amplitude at {k * BIN_WIDTH:.1f} Hz": history.spectra[seen, k] for k in bins}
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
