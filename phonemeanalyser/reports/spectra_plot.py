"""Averaged spectra as a picture, SVG."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from phonemeanalyser.colours import DARK, LIGHT, free_curve_colour
from phonemeanalyser.reports.page import rendered
from phonemeengine.inspection.averaged_spectrum import AveragedSpectrum

WIDTH, HEIGHT = 720, 300
"""Of the area in which curves are drawn, pixels."""
STEP_DB, STEPS_HZ = 10, (500, 1000, 2000, 5000)
MOST_TICKS = 8
MOST_BANDS = 4
"""Curves whose spread is drawn: more would hide each other."""


@dataclass(frozen=True)
class _PlottedCurve:
    """A curve in pixels: its name and colour, its points, and those around its spread; empty without one."""

    name: str
    colour: str
    points: str
    band: str


def plot_of(curves: Sequence[AveragedSpectrum], theme: str = "light") -> str:
    """Return a picture of averaged spectra: level in dB over frequency, with the spread as a band.

    Parameters
    ----------
    curves : at least one.
    theme : ``light`` or ``dark``.
    """
    highest = max(float(curve.frequencies[-1]) for curve in curves)
    levels = np.concatenate([curve.levels for curve in curves])
    top = float(np.ceil(levels.max() / STEP_DB) * STEP_DB)
    bottom = max(float(np.floor(np.quantile(levels, 0.02) / STEP_DB) * STEP_DB) - STEP_DB, -100.0)
    taken: list[str] = []
    lines = []

    def points(frequencies: np.ndarray, heights: np.ndarray) -> str:
        x = frequencies / highest * WIDTH
        y = np.clip((top - heights) / (top - bottom), 0, 1) * HEIGHT
        return " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, y, strict=True))

    for curve in curves:
        taken.append(curve.colour or free_curve_colour(taken))
        band = ""
        if curve.spread is not None and len(curves) <= MOST_BANDS:
            upper = points(curve.frequencies, curve.levels + curve.spread)
            band = f"{upper} {points(curve.frequencies[::-1], (curve.levels - curve.spread)[::-1])}"
        lines.append(_PlottedCurve(curve.name, taken[-1], points(curve.frequencies, curve.levels), band))
    step = next((step for step in STEPS_HZ if highest / step <= MOST_TICKS), STEPS_HZ[-1])
    values = {
        "theme": {"light": LIGHT, "dark": DARK}[theme],
        "lines": lines,
        "width": WIDTH,
        "height": HEIGHT,
        "hertz": [(hertz, hertz / highest * WIDTH) for hertz in range(0, int(highest) + 1, step)],
        "decibels": [(db, (top - db) / (top - bottom) * HEIGHT) for db in range(int(bottom), int(top) + 1, STEP_DB)],
    }
    return rendered("spectra.svg.j2", values, {})
