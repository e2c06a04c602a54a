"""The level meter's pixels and words."""

from collections.abc import Callable

import numpy as np
import pytest
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.theme import DARK, LIGHT, Theme
from phonemeanalyser.desktop.widgets import level_meter
from phonemeengine.audio.level import Level

WIDTH = 500
TRACK = WIDTH - level_meter.LIGHT_WIDTH - 8
BAR_Y, HELD_Y = 9, 3
"""A row through the bar, and one above it that only the held peak reaches."""


@pytest.fixture(params=[LIGHT, DARK], ids=lambda theme: theme.name)
def theme(request: pytest.FixtureRequest) -> Theme:
    theme: Theme = request.param
    return theme


@pytest.fixture
def picture(qapp: QApplication, qtbot: QtBot, theme: Theme) -> Callable[[Level], QImage]:
    def paint(level: Level) -> QImage:
        meter = level_meter.LevelMeterView(lambda: level, theme)
        qtbot.addWidget(meter)
        meter.resize(WIDTH, 28)
        return meter.grab().toImage()

    return paint


def columns(image: QImage, y: int, colour: str) -> list[int]:
    """The columns of a row that have a colour."""
    return [x for x in range(image.width()) if image.pixelColor(x, y) == QColor(colour)]


@pytest.mark.parametrize("decibels", [-48.0, -30.0, -12.0])
def test_the_bar_reaches_as_far_as_the_peak_in_decibels(
    picture: Callable[[Level], QImage], theme: Theme, decibels: float
) -> None:
    peak = 10 ** (decibels / 20)
    bar = columns(picture(Level(peak, peak)), BAR_Y, theme.good)
    assert len(bar) == pytest.approx((decibels - level_meter.LOWEST_DB) / -level_meter.LOWEST_DB * TRACK, abs=3)


def test_the_held_peak_stays_where_it_was_while_the_bar_falls(
    picture: Callable[[Level], QImage], theme: Theme
) -> None:
    image = picture(Level(0.01, 0.25))
    (mark,) = {round(np.mean(columns(image, HELD_Y, theme.text)))}
    assert mark == pytest.approx(2 + (20 * np.log10(0.25) + 60) / 60 * TRACK, abs=2)
    assert max(columns(image, BAR_Y, theme.good)) == pytest.approx(2 + TRACK / 3, abs=3)


def test_a_loud_bar_is_red_and_silence_has_none(picture: Callable[[Level], QImage], theme: Theme) -> None:
    loud = picture(Level(0.9, 0.9))
    assert columns(loud, BAR_Y, theme.good) == []
    assert len(columns(loud, BAR_Y, theme.bad)) > 0.9 * TRACK
    silent = picture(Level())
    assert columns(silent, BAR_Y, theme.good) == columns(silent, BAR_Y, theme.bad) == []
    assert len(columns(silent, BAR_Y, theme.line)) > 0.98 * TRACK


@pytest.mark.parametrize(("ago", "lit"), [(0.2, True), (5.0, False), (70.0, False), (None, False)])
def test_the_light_is_lit_for_a_second_after_clipping(
    picture: Callable[[Level], QImage], theme: Theme, ago: float | None, lit: bool
) -> None:
    image = picture(Level(0.1, 0.1, ago))
    assert image.pixelColor(WIDTH - 5, 5) == QColor(theme.bad if lit else theme.raised)


def test_the_light_tells_how_long_ago_it_clipped() -> None:
    words = [level_meter.words_of(ago) for ago in (None, 0.0, 0.9, 1.2, 12.4, 59.4, 60.0)]
    assert words == [
        "no clipping",
        "CLIPPED",
        "CLIPPED",
        "clipped 1 s ago",
        "clipped 12 s ago",
        "clipped 59 s ago",
        "no clipping",
    ]


def test_the_words_of_the_light_fit_into_it(qapp: QApplication, qtbot: QtBot) -> None:
    meter = level_meter.LevelMeterView(Level, DARK)
    qtbot.addWidget(meter)
    font = meter.font()
    font.setPixelSize(10)
    meter.setFont(font)
    assert (
        max(meter.fontMetrics().horizontalAdvance(level_meter.words_of(ago)) for ago in (None, 0.0, 59.4))
        < level_meter.LIGHT_WIDTH - 4
    )


@pytest.mark.parametrize(("width", "written"), [(100, {0, -24, -48}), (500, {0, -12, -24, -36, -48})])
def test_marks_that_would_run_into_one_another_are_not_written(width: float, written: set[int]) -> None:
    """Of a narrow meter, "-12" and "0 dB" would read "-120 dB"."""
    assert level_meter.marks_that_fit(lambda text: 6 * len(text), width) == written
