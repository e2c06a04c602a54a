"""The newest analysed window and spectra: amplitude over time, and over frequency, linear or in dB."""

import math

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSlider

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import label, named, toggle_button
from phonemeanalyser.desktop.widgets.plot import LiveCurve, Plot, PlotMenu, table_of
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.settings import BIN_WIDTH, SAMPLE_RATE, WINDOW

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


COARSE = 8
"""Samples, or bins, that share a step of the coarse display."""
FLOOR_DB = -100.0
HEAD_ROOM_DB = 6.0
"""Above full scale, so that the loudest line does not lie on the edge."""
SCALE_STEPS = 60
"""The amplitude scale's slider runs over this many steps of 1 dB."""


class SpectrumView(Plot):
    """Draws one spectrum, fine (every bin) or coarse (the highest of eight as a step).

    The amplitude scale enlarges small amplitudes: at 20 dB, an amplitude of 0.1 fills the height.
    """

    def __init__(self, title: str, tip: str, theme: Theme) -> None:
        super().__init__(tr(title), tip, ((tr("Frequency"), "Hz"), (tr("Amplitude"), "")), self._describe, theme)
        self.menu = PlotMenu(self.graphics, title.lower(), lambda _at: table_of(self._columns()), self.reset_zoom)
        self._frequencies: Float64Array = np.zeros(0)
        self._amplitudes = np.zeros(0, np.float32)
        self._curve = LiveCurve(pen=pg.mkPen(theme.signal))
        self.item.addItem(self._curve)
        self.coarse = toggle_button(
            tr("Coarse"), tr("Coarse display: the maximum of each eight adjacent bins as one step")
        )
        self.decibels = toggle_button("dB", tr("Show the amplitude in dB"))
        self.scale = named(
            QSlider(Qt.Orientation.Horizontal),
            tr("{plot}: display gain").format(plot=self.heading.text()),
            tr("Display gain, 0 to 60 dB: enlarges small amplitudes"),
        )
        self._add_controls()
        self.reset_zoom()

    def draw(self, amplitudes: Float32Array) -> None:
        """Draw a spectrum, shape (n_bins,); bin k lies at k x 21.53 Hz."""
        self._amplitudes = amplitudes
        if len(self._frequencies) != len(amplitudes):
            self._frequencies = np.arange(len(amplitudes), dtype=float) * BIN_WIDTH
            self.reset_zoom()
        self._curve.setData(*self.line_of(self._frequencies, amplitudes))
        self.tell_empty(self.is_empty)
        self.refresh_read_out()

    @property
    def is_empty(self) -> bool:
        """Whether nothing is drawn."""
        return not len(self._amplitudes)

    def line_of(
        self, frequencies: Float64Array, amplitudes: Float64Array | Float32Array
    ) -> tuple[Float64Array, Float64Array]:
        """Return a spectrum as it is drawn, fine or coarse: places and heights."""
        x, y = frequencies, np.asarray(amplitudes, float)
        if self.coarse.isChecked() and len(y):
            x, y = x[::COARSE], np.maximum.reduceat(y, np.arange(0, len(y), COARSE))
            x, y = np.repeat(np.append(x, x[-1] + COARSE * BIN_WIDTH), 2)[1:-1], np.repeat(y, 2)
        return x, self.heights_of(y)

    @property
    def highest(self) -> float:
        """Where the frequency axis ends, Hz."""
        return float(self._frequencies[-1]) + BIN_WIDTH if len(self._frequencies) else SAMPLE_RATE / 8

    def clear(self) -> None:
        """Draw nothing."""
        self.draw(np.zeros(0, np.float32))

    def heights_of(self, amplitudes: Float64Array | Float32Array) -> Float64Array:
        """Return amplitudes as they are drawn: as they are, or in dB."""
        if not self.in_decibels:
            return np.asarray(amplitudes, float)
        return 20 * np.log10(np.maximum(amplitudes, 10 ** (FLOOR_DB / 20)))

    @property
    def in_decibels(self) -> bool:
        """Whether the amplitude axis is in dB."""
        return self.decibels.isChecked()

    def _add_controls(self) -> None:
        self.scale.setRange(0, SCALE_STEPS)
        self.scale.setFixedWidth(44)
        for widget in (self.coarse, self.decibels, label(tr("Gain")), self.scale):
            self.header.addWidget(widget)
        self.coarse.toggled.connect(lambda _on: self.draw(self._amplitudes))
        self.decibels.toggled.connect(lambda _on: self._change_scale())
        self.scale.valueChanged.connect(lambda _value: self._change_scale())

    def _change_scale(self) -> None:
        self.reset_zoom()
        self.draw(self._amplitudes)

    def reset_zoom(self) -> None:
        """Show the whole spectrum, as high as the amplitude scale says."""
        highest, zoom = self.highest, float(self.scale.value())
        low, high = (FLOOR_DB, HEAD_ROOM_DB - zoom) if self.in_decibels else (0.0, 10 ** (-zoom / 20))
        bottom, top = (FLOOR_DB - 5, 2 * HEAD_ROOM_DB) if self.in_decibels else (0.0, 1.05)
        self.item.vb.setLimits(xMin=0, xMax=highest, yMin=bottom, yMax=top)
        self.item.setXRange(0, highest, padding=0)
        self.item.setYRange(low, high + (high - low) * 0.03, padding=0)
        self.item.setLabel("left", tr("Level (dB)") if self.in_decibels else tr("Amplitude"))

    def _columns(self) -> dict[str, Float64Array]:
        """Return what is drawn as columns, each under its name and unit."""
        amplitudes = self._amplitudes.astype(float)
        with np.errstate(divide="ignore"):
            levels = 20 * np.log10(amplitudes)
        return {"frequency (Hz)": self._frequencies, "amplitude (linear)": amplitudes, "level (dB)": levels}

    def _describe(self, frequency: float, _height: float) -> str:
        k = round(frequency / BIN_WIDTH)
        if not 0 <= k < len(self._amplitudes):
            return f"{frequency:.0f} Hz"
        return reading_of(frequency, float(self._amplitudes[k]))


def reading_of(frequency: float, amplitude: float) -> str:
    """Return what is read at a frequency (Hz): the amplitude, also in dB."""
    decibels = f"{20 * math.log10(amplitude):.1f} dB" if amplitude > 0 else "−∞ dB"
    return f"{frequency:.0f} Hz   {amplitude:.4f}   {decibels}"
