"""The curve that is drawn anew many times a second: its bounds follow the axes."""

import numpy as np
import pyqtgraph as pg
import pytest

from phonemeanalyser.desktop.widgets.plot import LiveAxis, LiveCurve


def test_what_is_drawn_beyond_the_old_range_is_painted(qtbot):
    plot = pg.PlotWidget()
    qtbot.addWidget(plot)
    plot.setYRange(0, 1, padding=0)
    plot.setXRange(0, 1, padding=0)
    curve = LiveCurve(pg.mkPen("k"))
    plot.addItem(curve)
    plot.show()
    plot.grab()
    curve.setData(np.array([0.0, 1.0]), np.array([0.0, 5.0]))
    plot.setYRange(0, 5, padding=0)
    plot.grab()
    # What Qt paints of an item is what lies in its bounds as the scene knows them.
    bounds = curve.sceneBoundingRect()
    box = plot.getPlotItem().vb.sceneBoundingRect()
    assert (bounds.top(), bounds.bottom()) == pytest.approx((box.top(), box.bottom()), abs=1)
    assert curve in plot.scene().items(plot.getPlotItem().vb.mapViewToScene(pg.Point(0.5, 4.5)))


def test_numbers_of_a_low_axis_are_a_line_apart_and_its_name_is_not_cut(qtbot):
    for height in (12, 30, 60, 100, 200, 400):
        axis = LiveAxis("left")
        axis.resize(40, height)
        axis.setLabel("Amplitude")
        spacings = [spacing * height for spacing, _ in axis.tickSpacing(0.0, 1.0, height)]
        assert min(spacings) >= min(16, 0.4 * height)
        assert axis.label.isVisible() == (height > 60)
