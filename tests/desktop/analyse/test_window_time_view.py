"""The sonagram, the lane of phonemes and the course of a variable, by their pixels."""

import re

import numpy as np
import pyqtgraph as pg
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest

from phonemeanalyser.desktop.analyse.lanes.scroll_view import ColourBar
from phonemeanalyser.desktop.analyse.lanes.sonagram import COLOUR_MAPS, colours_of
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.session.results import CAPACITY
from phonemeanalyser.desktop.theme import PHONEME_COLOURS
from phonemeengine.analyser import analyse_blocks
from phonemeengine.features.variables import BUILT_IN_NAMES
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import CONDITIONS
from phonemeengine.settings import FRAME_PERIOD
from tests.desktop.hands import (
    ON_BIN,
    TimeEyes,
    copied,
    followed,
    hover,
    place,
    press,
    settle,
    shown,
    type_number,
    wait_for_results,
    wav,
)
from tests.sounds import tone

GREY = "grey"


@pytest.fixture
def window(desktop, qtbot, tmp_path):
    """A window that has heard two seconds of a tone of a tenth of the full scale, without normalising."""
    desktop.preset.set_filter("normalise", on=False)
    window = followed(desktop, qtbot, wav(tmp_path, tone(ON_BIN, 2.5, 0.1)), 2.0)
    window.resize(1280, 1100)  # enough pixels for each bin
    window.analysis.sonagram.colours.setCurrentText(GREY)
    window.analysis.sonagram.low.setValue(-60)
    window.analysis.sonagram.high.setValue(0)
    return window


@pytest.fixture
def close(window):
    """The same up to 4000 Hz only, so that a tone has several pixels."""
    window.analysis.sonagram.top.setCurrentIndex(0)
    return window


def test_a_tone_is_a_bright_line_at_its_frequency_and_what_is_seen_is_copied_as_a_table(window):
    eyes, menu = TimeEyes(window), window.analysis.scroll_view.menu
    for seconds in (-0.1, -1.0, -1.9):
        assert eyes.brightest(seconds) == pytest.approx(ON_BIN, abs=44)  # a bin
    nothing = QColor(window.theme.base)
    assert eyes.colour(eyes.sonagram, -2.5, ON_BIN) == nothing
    assert eyes.colour(eyes.sonagram, -1.0, ON_BIN) != nothing
    eyes.sonagram.setXRange(-1, -0.5, padding=0)
    at = place(eyes.graphics, eyes.sonagram, -0.7, eyes.share(ON_BIN))
    rows = copied(menu, at)
    assert rows[0][:3] == ["time in the sound (s)", "phoneme", "intensity (0..1)"]
    nearest = f"level at {32 * 8000 / 255:.1f} Hz (dB)"
    assert [float(row[0]) for row in rows[1:]] == pytest.approx(np.arange(100, 150) / 100)
    column = rows[0].index(nearest)
    assert [float(row[column]) for row in rows[1:]] == pytest.approx([-20] * 50, abs=1)
    QTest.mouseDClick(eyes.graphics.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert eyes.sonagram.viewRange()[0] == pytest.approx([-6, 0])  # the whole again
    window.analysis.courses.choose("zero_crossings")
    rows = copied(menu, place(eyes.graphics, eyes.course, -0.7, 10))
    assert rows[0] == ["time in the sound (s)", "phoneme", "intensity (0..1)", "zero_crossings (per window)"]
    assert len(rows) == 1 + 200
    assert float(rows[100][3]) == pytest.approx(2 * ON_BIN * 2048 / 44_100, abs=1)


def test_brightness_is_the_level_in_db_within_a_range_that_may_be_typed(close):
    assert TimeEyes(close).brightness(-1.0) == pytest.approx(255 * 40 / 60, abs=4)
    menu = close.analysis.sonagram.low.window()
    menu.popup(QPoint())
    type_number(close.analysis.sonagram.low, "-40")
    menu.close()
    assert TimeEyes(close).brightness(-1.0) == pytest.approx(127, abs=4)
    lightness = []
    for low, high in ((-60, -20), (-25, -15)):
        close.analysis.sonagram.low.setValue(low)
        close.analysis.sonagram.high.setValue(high)
        lightness.append(TimeEyes(close).brightness(-1.0))
    assert lightness == pytest.approx([255, 127], abs=16)  # of 25 for each dB at the most


def test_a_colour_map_colours_sonagram_and_colour_bar(close):
    bar = close.analysis.scroll_view.findChild(ColourBar)
    for name in COLOUR_MAPS:
        close.analysis.sonagram.colours.setCurrentText(name)
        colours, eyes, image = colours_of(name), TimeEyes(close), bar.grab().toImage()
        pixels = {
            170: eyes.colour(eyes.sonagram, -1.0, ON_BIN),
            255: image.pixelColor(8, 3),
            0: image.pixelColor(8, bar.height() - 4),
        }
        for level, pixel in pixels.items():
            difference = np.abs(np.array(pixel.getRgb()) - QColor(int(colours[level])).getRgb())
            assert difference.max() < 12, (name, level)


def test_after_more_than_a_minute_the_newest_is_still_at_the_right_and_no_more_than_a_minute_is_seen(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    window.analysis.sonagram.colours.setCurrentText(GREY)
    sound = np.concatenate((tone(ON_BIN, 62.0), tone(3 * ON_BIN, 2.0)))
    for analysis in analyse_blocks(np.array_split(sound, 30), desktop.preset.preset):
        desktop.session.results.add(analysis)
        window.analysis.scroll_view.refresh()
    assert desktop.session.history.n > CAPACITY + 300
    eyes = TimeEyes(window)
    assert [round(eyes.brightest(s) / ON_BIN) for s in (-0.2, -1.8, -2.2, -5.5)] == [3, 3, 1, 1]
    ring = eyes.image
    desktop.session.live.forget()
    assert TimeEyes(window).image == ring
    eyes.sonagram.setXRange(-1000, 0, padding=0)
    assert eyes.sonagram.viewRange()[0] == pytest.approx([-60, 0])
    assert eyes.course.viewRange()[0] == pytest.approx([-60, 0])


# -- reading out --------------------------------------------------------------------------------------


def test_the_cursor_reads_out_what_lies_under_it(desktop, window, qtbot):
    settle()
    eyes, label = TimeEyes(window), window.analysis.scroll_view.cursor_label
    hover(eyes.graphics, eyes.sonagram, -1.0, eyes.share(ON_BIN))
    qtbot.waitUntil(label.isVisible)
    seconds, phoneme, hertz, level = re.fullmatch(r"([\d.]+) s   (\w+)   (\d+) Hz   (-\d+) dB", label.text()).groups()
    assert float(seconds) == pytest.approx(1.0, abs=0.025)
    k = round(float(seconds) / FRAME_PERIOD)
    assert phoneme == sound_name(Phoneme(int(desktop.session.history.phonemes[k])))
    assert float(hertz) == pytest.approx(ON_BIN, abs=40)
    assert float(level) == pytest.approx(-20, abs=3)
    assert eyes.graphics.rect().contains(label.geometry())
    hover(eyes.graphics, eyes.sonagram, -4.0, eyes.share(ON_BIN))  # where nothing was heard yet
    qtbot.waitUntil(lambda: not label.isVisible())
    window.analysis.courses.choose("volume")
    hover(eyes.graphics, eyes.course, -1.0, 0.05)
    qtbot.waitUntil(label.isVisible)
    assert re.fullmatch(r"[\d.]+ s   \w+   volume 0\.1", label.text())
    hover(eyes.graphics, eyes.sonagram, -1.0, eyes.share(ON_BIN))
    qtbot.waitUntil(lambda: label.text().endswith(" dB"))
    results, session = desktop.session.results, desktop.session  # under a still mouse it follows the picture
    results.add_file_start(session.path, session.channel, 96)
    window.redraw.refresh_all()
    assert label.text() == ""  # it lies in the gap before what begins anew
    results.add_file_start(session.path, session.channel, 30)
    window.redraw.refresh_all()
    assert float(label.text().split(" s")[0]) == pytest.approx(0.36, abs=0.025)


def test_while_frozen_the_cursor_reads_what_is_drawn(desktop, window, qtbot):
    press(window, Qt.Key.Key_F)
    desktop.session.analyse_until(1.0)
    eyes = TimeEyes(window)
    hover(eyes.graphics, eyes.sonagram, -0.5, eyes.share(ON_BIN))
    label = window.analysis.scroll_view.cursor_label
    qtbot.waitUntil(label.isVisible)
    assert float(label.text().split(" s")[0]) == pytest.approx(1.5, abs=0.025)


# -- zooming and what the menu does -------------------------------------------------------------------


def test_the_highest_frequency_is_the_chosen_one_whatever_the_preset_quantises(desktop, window, qtbot):
    top = window.analysis.sonagram.top
    for step in (4, 1):
        desktop.preset.set_setting("quantise", step)
        wait_for_results(desktop, qtbot)
        for k in range(top.count()):
            top.setCurrentIndex(k)
            window.redraw.refresh_all()
            assert desktop.session.sonagram.settings.high == top.currentData()
            assert TimeEyes(window).brightest(-1.0) == pytest.approx(ON_BIN, abs=top.currentData() / 60)


# -- phonemes and variables ---------------------------------------------------------------------------


def test_the_lane_s_colours_are_the_phonemes_and_the_course_the_variable_with_its_thresholds(desktop, qtbot):
    def lines() -> list[float]:
        items = TimeEyes(window).course.items
        return sorted(line.value() for line in items if isinstance(line, pg.InfiniteLine))

    window = followed(desktop, qtbot)
    history, eyes = desktop.session.history, TimeEyes(window)
    n, codes = history.n, history.phonemes
    inside = [k for k in range(5, n - 5) if len(set(codes[k - 3 : k + 4])) == 1]
    assert len({codes[k] for k in inside}) >= 4
    for k in inside:
        colour = eyes.colour(eyes.lane, (k + 0.5 - n) * FRAME_PERIOD, 0.95)
        assert colour == QColor(PHONEME_COLOURS[Phoneme(int(codes[k]))])
    for name, words in {
        "volume": "volume (peak level)",
        "m_szsch1": "energy 1723–2799 Hz",
        "f0": "pitch (f0)",
    }.items():
        window.analysis.courses.choose(name)
        course = next(i for i in TimeEyes(window).course.items if isinstance(i, pg.PlotCurveItem))
        x, y = course.getData()
        assert np.array_equal(y, history.features(history.indices(0, history.n))[name])
        assert x[-1] == pytest.approx(-FRAME_PERIOD / 2)
        assert TimeEyes(window).course.viewRange()[1][1] >= y.max()
        (shown,) = (i for i in TimeEyes(window).course.vb.childItems() if isinstance(i, pg.LabelItem))
        assert shown.text == words
    for name in BUILT_IN_NAMES:
        window.analysis.courses.choose(name)
        thresholds = desktop.preset.preset.thresholds
        assert lines() == sorted(getattr(thresholds, c.threshold) for c in CONDITIONS if c.variable == name)
    window.analysis.courses.choose("m_s1")
    type_number(window.analysis.thresholds.rows["sz_s1"].number, "12.5")
    assert lines() == [12.5]


def test_in_a_pause_the_course_is_drawn_anew_where_one_pans_and_when_the_preset_changes(desktop, qtbot, tmp_path):
    window = followed(desktop, qtbot, wav(tmp_path, tone(ON_BIN, 20, 0.5)), 20.0)
    window.redraw.timer.stop()
    history, sonagram = desktop.session.history, TimeEyes(window).sonagram
    course = next(i for i in TimeEyes(window).course.items if isinstance(i, pg.PlotCurveItem))
    sonagram.setXRange(-18, -12, padding=0)
    x, y = course.getData()
    assert x[0] < -17.9
    assert np.array_equal(y, history.features(history.indices(history.n - len(y), history.n))["energy"])
    before = y[-500:].copy()
    desktop.preset.set_setting("high_pass_end", 2000.0)
    wait_for_results(desktop, qtbot)
    window.redraw.tick()
    _, y = course.getData()
    assert len(y) > 1790
    assert np.array_equal(y, history.features(history.indices(history.n - len(y), history.n))["energy"])
    assert (y[-500:] < 0.9 * before).all()
    window.analysis.courses.choose("volume")
    assert course.getData()[1] == pytest.approx(0.5, abs=0.01)


def test_a_gap_is_empty_in_sonagram_lane_and_course(desktop, qtbot, tmp_path):
    window = followed(desktop, qtbot, wav(tmp_path, tone(ON_BIN, 3, 0.5)), 2.0)
    desktop.session.seek(1.0)
    window.redraw.refresh_all()
    eyes, nothing = TimeEyes(window), QColor(window.theme.base)
    for seconds, empty in ((-0.5, False), (-1.05, True), (-2.0, False), (-3.05, False), (-3.2, True)):
        for plot, y in ((eyes.sonagram, ON_BIN), (eyes.lane, 0.95)):
            assert (eyes.colour(plot, seconds, y) == nothing) is empty, seconds
    course = next(i for i in eyes.course.items if isinstance(i, pg.PlotCurveItem))
    x, y = course.getData()
    assert x[np.isnan(y)] == pytest.approx(-1 - np.arange(9.5, 0, -1) / 100)
