"""The newest analysed window, after the filters of the time domain."""

import math

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSlider

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import label, named, toggle_button
from phonemeanalyser.desktop.widgets.plot import LiveCurve, Plot
from phonemeanalyser.desktop.widgets.plot_menu import PlotMenu, table_of
from phonemeengine.arrays import Float32Array
from phonemeengine.settings import SAMPLE_RATE, WINDOW

COARSE = 8
"""Samples that share a bar of the coarse display."""
LENGTH_MS = 1000 * WINDOW / SAMPLE_RATE
SOFTEST = 0.02
"""Sound that is softer than this is not enlarged any more: it would be noise that looks like speech."""
STEP = 2**0.5
"""Between two scales that are found: the picture stands still while loudness changes a little."""
FADING = 0.985
"""Of the loudest amplitude from one picture to the next, so that a pause does not enlarge its noise at once."""


class WaveformView(Plot):
    """Draws a window, fine (every sample) or coarse (lowest and highest of eight).

    It scales itself to what is loudest, until the slider says otherwise.
    """

    def __init__(self, theme: Theme) -> None:
        tip = tr("Current window of 46.4 ms, after the time-domain filters; full scale is ±1")
        super().__init__(
            tr("Waveform"), tip, ((tr("Time in the window"), "ms"), (tr("Amplitude"), "")), self._describe, theme
        )
        self.menu = PlotMenu(self.graphics, "waveform", lambda _at: table_of(self._columns()), self.reset_zoom)
        self._wave = np.zeros(0, np.float32)
        self._curve = LiveCurve(pen=pg.mkPen(theme.signal))
        self.item.addItem(self._curve)
        self.coarse = toggle_button(
            tr("Coarse"), tr("Coarse display: minimum and maximum of each eight adjacent samples")
        )
        self.auto = toggle_button(
            tr("Auto"), tr("Adapt the display gain to the loudness; moving the slider switches this off")
        )
        self.scale = named(
            QSlider(Qt.Orientation.Horizontal),
            tr("Waveform: display gain"),
            tr("Display gain, 0 to 40 dB: enlarges quiet signals"),
        )
        self._loudest = SOFTEST
        self._half = 0.0
        self._add_controls()
        self.reset_zoom()
        self.item.vb.setLimits(xMin=0, xMax=LENGTH_MS, yMin=-1.1, yMax=1.1)

    def draw(self, wave: Float32Array) -> None:
        """Draw a window, shape (n_samples,), full scale ±1; it always spans 46.4 ms."""
        self._wave = wave
        if self.auto.isChecked() and len(wave):
            self._loudest = max(SOFTEST, FADING * self._loudest, float(np.abs(wave).max()))
            self._show_height(self._height())
        y = wave
        if self.coarse.isChecked() and len(y):
            groups = y.reshape(-1, COARSE)
            y = np.stack((groups.min(axis=1), groups.max(axis=1)), axis=1).ravel()
        self._curve.setData(np.linspace(0, LENGTH_MS, len(y), endpoint=False), y)
        self.tell_empty(not len(wave))
        self.refresh_read_out()

    def clear(self) -> None:
        """Draw nothing."""
        self.draw(np.zeros(0, np.float32))

    def _add_controls(self) -> None:
        self.scale.setRange(0, 40)
        self.scale.setFixedWidth(70)
        for widget in (self.coarse, label(tr("Gain")), self.auto, self.scale):
            self.header.addWidget(widget)
        self.coarse.toggled.connect(lambda _on: self.draw(self._wave))
        self.auto.setChecked(True)
        self.auto.toggled.connect(lambda _on: self.reset_zoom())
        self.scale.valueChanged.connect(self._scale_by_hand)

    def _scale_by_hand(self) -> None:
        self.auto.setChecked(False)
        self.reset_zoom()

    def _height(self) -> float:
        """Return the amplitude at the upper edge."""
        if not self.auto.isChecked():
            return 1.05 * 10 ** (-self.scale.value() / 20)
        return min(1.05, 1.05 * STEP ** math.ceil(math.log(self._loudest, STEP) - 0.05))

    def _show_height(self, half: float) -> None:
        if half != self._half:
            self._half = half
            self.item.setYRange(-half, half, padding=0)

    def reset_zoom(self) -> None:
        """Show the whole window, as high as the vertical scale says."""
        self.item.setXRange(0, LENGTH_MS, padding=0)
        self._half = 0.0
        self._show_height(self._height())

    def _columns(self) -> dict[str, NDArray[np.floating]]:
        """Return what is drawn as columns, each under its name and unit."""
        times = np.linspace(0, LENGTH_MS, len(self._wave), endpoint=False)
        return {"time in the window (ms)": times, "amplitude (full scale 1)": self._wave}

    def _describe(self, milliseconds: float, _height: float) -> str:
        k = int(milliseconds / LENGTH_MS * len(self._wave))
        value = f"   {self._wave[k]:+.4f}" if 0 <= k < len(self._wave) else ""
        return f"{milliseconds:.1f} ms{value}"
