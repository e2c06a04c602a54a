"""The averaged spectrum, curves beside it, and a region that becomes a variable."""

from typing import Any

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QColor, QKeySequence, QResizeEvent, QShortcut
from PySide6.QtWidgets import QGraphicsPolygonItem, QLabel, QMenu
from typing_extensions import override

from phonemeanalyser.desktop.analyse.spectra.frame_views import FLOOR_DB, SpectrumView, reading_of
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.curves import CurveTable, RunningAverage
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import open_at_once, toggle_button, tool_button
from phonemeanalyser.desktop.widgets.plot import polyline_of
from phonemeengine.arrays import Float64Array
from phonemeengine.errors import CurveError
from phonemeengine.inspection.averaged_spectrum import AveragedSpectrum, check_comparable, distance_of
from phonemeengine.settings import BIN_WIDTH

TIP = tr_noop("Mean of all spectra since Play, Record or Clear; a change of the filters starts a new mean")
EMPTY = tr_noop("No data yet: press Play, or add an averaged spectrum to the table")
MOST_NAMED = 8
"""Curves in the legend at most; the table lists all."""
LONGEST = 30
"""Letters of a name in the legend; of a longer one the middle is left out."""
LINE = 44
"""Pixels beside a name in the legend: the line of the curve, and gaps."""
BAND = 46
"""Opacity of the spread, 0..255."""


class LegendLine(pg.graphicsItems.LegendItem.ItemSample):
    """A curve's line in the legend, which does nothing when it is clicked: the table hides curves."""

    @override
    def mouseClickEvent(self, event: Any) -> None:
        event.ignore()


class AveragedView(SpectrumView):
    """Draws the running mean and every curve that is shown on one frequency axis, with its spread as a band.

    Attributes
    ----------
    since : says how long the mean has been running.

    Signals
    -------
    load_asked, save_asked : the user wants to load or save a curve.
    table_asked : the user wants to see the table of the curves.
    variable_asked : the user wants a variable over this range (Hz).
    """

    load_asked = Signal()
    save_asked = Signal()
    table_asked = Signal()
    variable_asked = Signal(float, float)

    def __init__(self, averages: RunningAverage, curves: CurveTable, theme: Theme) -> None:
        self._averages, self._curves = averages, curves
        super().__init__(tr_noop("Averaged spectrum"), tr(TIP), theme)
        self._hint.setText(tr(EMPTY))
        self.since = QLabel(self.graphics)
        self._drawn: list[tuple[AveragedSpectrum, pg.PlotCurveItem, QGraphicsPolygonItem | None]] = []
        self.legend = pg.LegendItem(
            offset=(-8, 26), labelTextSize="7.5pt", labelTextColor=theme.text, sampleType=LegendLine, verSpacing=-8,
        )  # fmt: skip
        self.region = pg.LinearRegionItem((1000, 1500), brush=pg.mkBrush(theme.accent + "33"), movable=False)
        self.measure = toggle_button(
            tr("Variable"), tr("Make a frequency range a variable of your own (V): drag in the plot, then press Add")
        )
        self._escape = QShortcut(QKeySequence("Escape"), self)
        self._dropped = False
        self._reached = 0.0
        self._add_curve_controls()
        self._add_region()
        curves.changed.connect(self._show_curves)
        self.coarse.toggled.connect(lambda _on: self._draw_curves())
        self._show_curves()

    def refresh(self) -> None:
        """Draw the running mean as it is now, and say of how much it is."""
        current = self._averages.current()
        self.draw(current.amplitudes.astype(np.float32))
        self._tell_since(current)
        self._name_curves(current)

    @property
    @override
    def is_empty(self) -> bool:
        """Whether neither a mean nor a curve is drawn."""
        return super().is_empty and not self._curves.shown

    @property
    @override
    def highest(self) -> float:
        """Where the frequency axis ends, Hz: where all curves have ended."""
        ends = [float(curve.frequencies[-1]) + BIN_WIDTH for curve in self._curves.shown]
        return max([*ends, super().highest] if len(self._amplitudes) else ends, default=super().highest)

    def _tell_since(self, current: AveragedSpectrum) -> None:
        text = (
            tr("Mean of {seconds:.1f} s since {event}").format(
                seconds=current.seconds, event=tr(current.since.partition(" at ")[0])
            )
            if current.n_frames
            else ""
        )
        if text != self.since.text():
            self.since.setText(text)
            self.since.adjustSize()
            now = tr("{n} frames since {event}; {front_end}").format(
                n=current.n_frames, event=tr_engine(current.since), front_end=current.front_end
            )
            of = f"<p>{tr('Now')}: {now}</p>" if current.n_frames else ""
            self.heading.setToolTip(f"<p>{tr(TIP)}.</p>{of}")

    @override
    def _columns(self) -> dict[str, Float64Array]:
        curves, columns = self._curves.shown, super()._columns()
        finest = max([columns["frequency (Hz)"], *(c.frequencies for c in curves)], key=len)
        short = len(finest) - len(self._amplitudes)
        padded = {name: np.pad(column, (0, short), constant_values=np.nan) for name, column in columns.items()}
        of_curves = {f"{k + 1} {c.name}, amplitude (linear)": c.at(finest) for k, c in enumerate(curves)}
        return {**padded, "frequency (Hz)": finest, **of_curves}

    @override
    def _describe(self, frequency: float, height: float) -> str:
        """Read the mean, or the curve that is nearest."""
        k, nearest, gap = round(frequency / BIN_WIDTH), super()._describe(frequency, height), np.inf
        if 0 <= k < len(self._amplitudes):
            gap = abs(float(self.heights_of(self._amplitudes[k : k + 1])[0]) - height)
        for curve in self._curves.shown:
            amplitude = curve.at(np.array([frequency]))
            away = abs(float(self.heights_of(amplitude)[0]) - height)
            if away < gap:
                gap, nearest = away, f"{_short(curve.name)}   {reading_of(frequency, float(amplitude[0]))}"
        return nearest

    @override
    def _change_scale(self) -> None:
        super()._change_scale()
        self._draw_curves()

    def _add_curve_controls(self) -> None:
        menu = QMenu(self)
        menu.addAction(tr("Show Table"), self.table_asked.emit)
        self.spread = menu.addAction(tr("Show Spread"))
        self.spread.setCheckable(True)
        self.spread.setChecked(True)
        self.spread.setToolTip(tr("Standard deviation of the level, as a band about each curve"))
        self.spread.toggled.connect(lambda _on: self._show_curves())
        menu.setToolTipsVisible(True)
        menu.addSeparator()
        menu.addAction(tr("Load Curve…"), self.load_asked.emit)
        menu.addAction(tr("Save Curve…"), self.save_asked.emit)
        curves = tool_button(
            tr("Curves"), tr("Save the averaged spectrum as a curve, or load saved curves to compare with")
        )
        open_at_once(curves, menu)
        self.beside.addWidget(curves)
        self.legend.setParentItem(self.item.vb)
        self.legend.setAcceptedMouseButtons(Qt.MouseButton.NoButton)

    def _add_region(self) -> None:
        self.beside.addWidget(self.measure)
        self.region.setVisible(False)
        for edge in self.region.lines:
            edge.setMovable(True)  # while a drag inside of it draws another
        self.item.addItem(self.region, ignoreBounds=True)
        self.measure.toggled.connect(self._toggle_region)
        self.since.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)  # a drag may begin there
        self.since.setStyleSheet(f"color: {self.theme.faint}")
        self.since.move(60, 6)
        self._escape.setEnabled(False)
        self._escape.activated.connect(self.drop_region)

    @override
    def changeEvent(self, event: QEvent) -> None:
        """Have the button that marks a range keep its width: other words on it must not widen the window."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.StyleChange:
            self.measure.setFixedWidth(self.measure.sizeHint().width())

    def drop_region(self) -> None:
        """Mark no range any more, and ask for no variable."""
        self._dropped = True
        self.measure.setChecked(False)

    def _toggle_region(self, on: bool) -> None:
        self.measure.setText(tr("Add…") if on else tr("Variable"))
        self.region.setVisible(on)
        self._escape.setEnabled(on)
        self.item.vb.draw = (lambda start, end: self.region.setRegion((start, end))) if on else None
        dropped, self._dropped = self._dropped, False
        if not on and not dropped:
            low, high = (max(0.0, edge) for edge in self.region.getRegion())
            self.variable_asked.emit(round(low / BIN_WIDTH) * BIN_WIDTH, round(high / BIN_WIDTH) * BIN_WIDTH)

    def _show_curves(self) -> None:
        for _, line, band in self._drawn:
            for item in (line, band):
                if item is not None:
                    self.item.removeItem(item)
        self._drawn.clear()
        self.legend.clear()
        for k, curve in enumerate(self._curves.shown):
            band = self._band(curve) if self.spread.isChecked() and curve.spread is not None else None
            line = pg.PlotCurveItem(pen=pg.mkPen(curve.colour))
            self.item.addItem(line, ignoreBounds=True)
            self._drawn.append((curve, line, band))
            if k < MOST_NAMED:
                self.legend.addItem(line, "")
        if self.highest != self._reached:
            self._reached = self.highest
            self.reset_zoom()
        self._draw_curves()
        self.tell_empty(self.is_empty)
        self._name_curves(self._averages.current())

    def _band(self, curve: AveragedSpectrum) -> QGraphicsPolygonItem:
        band = QGraphicsPolygonItem()
        colour = QColor(curve.colour)
        colour.setAlpha(BAND)
        band.setBrush(colour)
        band.setPen(QColor(Qt.GlobalColor.transparent))
        band.setZValue(-1)
        self.item.addItem(band, ignoreBounds=True)
        return band

    def _draw_curves(self) -> None:
        """Draw the curves at the scale of the plot: fine or coarse, linear or in dB."""
        for curve, line, band in self._drawn:
            x, y = self.line_of(curve.frequencies, curve.amplitudes)
            line.setData(x, y)
            if band is not None and curve.spread is not None:
                factor = 10 ** (curve.spread / 20)
                _, upper = self.line_of(curve.frequencies, curve.amplitudes * factor)
                _, lower = self.line_of(curve.frequencies, curve.amplitudes / factor)
                band.setPolygon(polyline_of(np.append(x, x[::-1]), np.append(upper, lower[::-1])))
        self._place_legend()

    @override
    def resizeEvent(self, event: QResizeEvent) -> None:
        """Lay the legend out for another width."""
        super().resizeEvent(event)
        self._place_legend()

    def _place_legend(self) -> None:
        """Have the legend lie where curves seldom are: below loud ones in dB, else at the upper right."""
        labels = [label for _, label in self.legend.items]
        if not labels:
            return
        widest = max(label.itemRect().width() for label in labels) + LINE
        n_columns = max(1, min(len(labels), int(self.item.vb.width() // widest)))
        if n_columns != self.legend.columnCount:
            self.legend.setColumnCount(n_columns)
        levels = [float(curve.levels.mean()) for curve, _, _ in self._drawn]
        is_below = self.in_decibels and bool(levels) and np.mean(levels) > FLOOR_DB / 2
        top = max(0, min(26, int(self.item.vb.height() - self.legend.height())))  # within a plot that is low
        corner, offset = ((0, 1), (30, 0)) if is_below else ((1, 0), (-8, top))
        self.legend.anchor(corner, corner, offset)

    def _name_curves(self, current: AveragedSpectrum) -> None:
        """Name the curves in the legend, with their difference from the running mean where there is one."""
        n_more = len(self._drawn) - MOST_NAMED
        for k, (curve, line, _) in enumerate(self._drawn[:MOST_NAMED]):
            text = _short(curve.name) + _difference(curve, current)
            if n_more > 0 and k == MOST_NAMED - 1:
                text = tr("{name} (and {n} more)").format(name=text, n=n_more)
            named = self.legend.getLabel(line)
            if named is not None and named.text != text:
                named.setText(text)
                self.legend.updateSize()
                self._place_legend()


def _difference(curve: AveragedSpectrum, current: AveragedSpectrum) -> str:
    """Return the difference from the running mean in words; nothing where they cannot be compared."""
    try:
        check_comparable(curve, current)
    except CurveError:
        return ""
    return f" Δ {distance_of(curve, current):.1f} dB" if current.n_frames else ""


def _short(name: str) -> str:
    half = (LONGEST - 1) // 2
    return name if len(name) <= LONGEST else f"{name[:half]}…{name[-half:]}"
