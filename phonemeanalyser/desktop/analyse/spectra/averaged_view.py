"""The averaged spectrum, curves beside it, and a region that becomes a variable."""

import re
from typing import Any

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeySequence, QPainter, QShortcut
from PySide6.QtWidgets import QLabel, QMenu, QWidget

from phonemeanalyser.desktop.analyse.spectra.spectrum_view import SpectrumView
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.averages import AveragesModel
from phonemeanalyser.desktop.theme import CURVE_COLOURS, Theme
from phonemeanalyser.desktop.widgets.builders import open_at_once, row, toggle_button, tool_button
from phonemeengine.arrays import Float64Array
from phonemeengine.inspection.averaged_spectrum import AveragedSpectrum
from phonemeengine.settings import BIN_WIDTH, FRAME_PERIOD

TIP = tr_noop(
    "The mean of all spectra that were heard since Play, Record or Clear; when other filters are heard, a new mean "
    "begins"
)


_SINCE = re.compile(r"(.*?) at ([\d.]+) s of (.*)")
DELTA = tr_noop("Δ is how differently it is shaped from the averaged spectrum, whatever the loudness")


class LegendEntry(QLabel):
    """A curve's name and distance in its colour; where there is little room, the middle is left out."""

    def __init__(self, text: str, colour: str, tip: str) -> None:
        super().__init__(text)
        self._colour = QColor(colour)
        font = self.font()
        font.setPixelSize(11)
        self.setFont(font)
        self.setToolTip(tip)

    def minimumSizeHint(self) -> QSize:
        """Many curves must not widen the window."""
        return QSize(8, super().minimumSizeHint().height())

    def paintEvent(self, _event: Any) -> None:
        """Paint as much of the text as there is room for."""
        painter = QPainter(self)
        painter.setPen(self._colour)
        text = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideMiddle, self.width())
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignVCenter, text)


class AveragedView(SpectrumView):
    """Draws the running mean and every loaded curve on one frequency axis.

    Signals
    -------
    load_asked, save_asked : the user wants to load or save a curve.
    variable_asked : the user wants a variable over this range (Hz).
    """

    load_asked = Signal()
    save_asked = Signal()
    variable_asked = Signal(float, float)

    def __init__(self, averages: AveragesModel, theme: Theme) -> None:
        super().__init__(tr_noop("Averaged spectrum"), tr(TIP), theme)
        self._averages = averages
        self._since = QLabel(self.graphics)
        self._overlays: list[pg.PlotCurveItem] = []
        self._legend = QWidget()
        self._entries = row(on=self._legend, margins=(8, 0, 4, 2), spacing=2)
        self._names: list[LegendEntry] = []
        self.region = pg.LinearRegionItem((1000, 1500), brush=pg.mkBrush(theme.accent + "33"), movable=False)
        self.measure = toggle_button(
            tr("variable"), tr("Mark a range of frequencies as a variable of your own (V): drag anywhere in the plot")
        )
        self._escape = QShortcut(QKeySequence("Escape"), self)
        self._dropped = False
        self._add_curve_controls()
        self._add_region()
        averages.curves_changed.connect(self._show_curves)
        self._show_curves()

    def refresh(self) -> None:
        """Draw the running mean as it is now, and say of how much it is."""
        current = self._averages.current()
        self.draw(current.amplitudes.astype(np.float32))
        self.tell_empty(not (current.n_frames or self._overlays))
        self._tell_since(current)
        for label, curve, distance in zip(
            self._names, self._averages.curves, self._averages.distances(), strict=True
        ):
            label.setText(curve.name if np.isnan(distance) else f"{curve.name} Δ {distance:.1f} dB")

    def _tell_since(self, current: AveragedSpectrum) -> None:
        seconds = current.n_frames * FRAME_PERIOD
        text = (
            tr("mean of {seconds:.1f} s since {event}").format(
                seconds=seconds, event=tr(current.since.partition(" at ")[0])
            )
            if current.n_frames
            else ""
        )
        if text != self._since.text():
            self._since.setText(text)
            self._since.adjustSize()
            of = f"<p>{tr('Now')}: {_told(current)}</p>" if current.n_frames else ""
            self.heading.setToolTip(f"<p>{tr(TIP)}.</p>{of}")

    def _columns(self) -> dict[str, Float64Array]:
        curves, columns = self._averages.curves, super()._columns()
        finest = max([columns["frequency (Hz)"], *(c.frequencies for c in curves)], key=len)
        short = len(finest) - len(self._amplitudes)
        padded = {name: np.pad(column, (0, short), constant_values=np.nan) for name, column in columns.items()}
        of_curves = {f"{k + 1} {c.name}, amplitude (linear)": c.at(finest) for k, c in enumerate(curves)}
        return {**padded, "frequency (Hz)": finest, **of_curves}

    def _change_scale(self) -> None:
        super()._change_scale()
        for overlay, curve in zip(self._overlays, self._averages.curves, strict=True):
            overlay.setData(curve.frequencies, self.heights_of(curve.amplitudes))

    def _add_curve_controls(self) -> None:
        menu = QMenu(self)
        menu.addAction(tr("Load Curve…"), self.load_asked.emit)
        menu.addAction(tr("Save Curve…"), self.save_asked.emit)
        curves = tool_button(tr("curves"), tr("Save the averaged spectrum, or load saved ones to compare with"))
        open_at_once(curves, menu)
        self.header.addWidget(curves)
        self._legend.setVisible(False)
        self._body.addWidget(self._legend)

    def _add_region(self) -> None:
        self.measure.setFixedWidth(self.measure.sizeHint().width())  # other words on it must not widen the window
        self.header.addWidget(self.measure)
        self.region.setVisible(False)
        for edge in self.region.lines:
            edge.setMovable(True)  # while a drag inside of it draws another
        self.item.addItem(self.region, ignoreBounds=True)
        self.measure.toggled.connect(self._toggle_region)
        self._since.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)  # a drag may begin there
        self._since.setStyleSheet(f"color: {self.theme.faint}")
        self._since.move(60, 6)
        self._escape.setEnabled(False)
        self._escape.activated.connect(self.drop_region)

    def drop_region(self) -> None:
        """Mark no range any more, and ask for no variable."""
        self._dropped = True
        self.measure.setChecked(False)

    def _toggle_region(self, on: bool) -> None:
        self.measure.setText(tr("name it") if on else tr("variable"))
        self.region.setVisible(on)
        self._escape.setEnabled(on)
        self.item.vb.draw = (lambda start, end: self.region.setRegion((start, end))) if on else None
        dropped, self._dropped = self._dropped, False
        if not on and not dropped:
            low, high = (max(0.0, edge) for edge in self.region.getRegion())
            self.variable_asked.emit(round(low / BIN_WIDTH) * BIN_WIDTH, round(high / BIN_WIDTH) * BIN_WIDTH)

    def _show_curves(self) -> None:
        self._remove_curves()
        for k, curve in enumerate(self._averages.curves):
            colour = CURVE_COLOURS[k % len(CURVE_COLOURS)]
            overlay = pg.PlotCurveItem(curve.frequencies, self.heights_of(curve.amplitudes), pen=pg.mkPen(colour))
            self.item.addItem(overlay)
            self._overlays.append(overlay)
            self._names.append(
                self._legend_entry(k, curve.name, f"{curve.name}: {_told(curve)}; {tr(DELTA)}", colour)
            )
        self._entries.addStretch(1)
        self._legend.setVisible(bool(self._overlays))

    def _remove_curves(self) -> None:
        for overlay in self._overlays:
            self.item.removeItem(overlay)
        self._overlays.clear()
        self._names.clear()
        while self._entries.count():
            entry = self._entries.takeAt(0)
            widget = entry.widget() if entry else None
            if widget is not None:
                widget.deleteLater()

    def _legend_entry(self, k: int, name: str, tip: str, colour: str) -> LegendEntry:
        label = LegendEntry(name, colour, tip)
        tip = tr("Remove {name}").format(name=name)
        button = tool_button("✕", tip, act=lambda: self._averages.remove(k), flat=True)
        button.setFixedWidth(18)
        self._entries.addWidget(label)
        self._entries.addWidget(button)
        return label


def _told(curve: AveragedSpectrum) -> str:
    since = " " + tr("since {event}").format(event=_in_words(curve.since)) if curve.since else ""
    return tr("{n} frames{since}; {front_end}").format(n=curve.n_frames, since=since, front_end=curve.front_end)


def _in_words(since: str) -> str:
    """Return what an average begins with in the language of the window; words of others stay as they are."""
    found = _SINCE.fullmatch(since)
    if found is None:
        return since
    return tr("{cause} at {seconds} s of {sound}").format(cause=tr(found[1]), seconds=found[2], sound=found[3])
