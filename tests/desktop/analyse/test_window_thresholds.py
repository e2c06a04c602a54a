"""The 21 thresholds: sliders, numbers, live marks, undo."""

from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor

from phonemeanalyser.desktop.analyse.recognition.threshold_view import CURVATURE
from phonemeanalyser.desktop.session.preset import PresetDocument
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import CONDITIONS, LAYOUT, PhonemeData
from phonemeengine.settings import BIN_WIDTH
from tests.desktop.hands import click, drag, followed, press, shown, type_number

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
NAMES = [field.name for field in fields(PhonemeData)]
IN_HERTZ = {"high_pass_start", "high_pass_end"}


@pytest.fixture
def window(desktop, qtbot):
    return shown(desktop, qtbot, None)


def value_of(desktop, name: str) -> float:
    """A threshold as the window shows it."""
    return getattr(desktop.preset.preset.phoneme_data, name) * (BIN_WIDTH if name in IN_HERTZ else 1)


def x_of(slider, share: float) -> float:
    return 6 + share * (slider.width() - 12)


def test_sliders_of_a_preset_to_which_x_goes_back_are_kept_and_show_its_values(desktop, window):
    view, preset = window.analysis.thresholds, desktop.preset
    preset.set_other(PresetDocument.read(Path("extended")))
    rows, before = view.rows, preset.preset.thresholds.silence_energy
    preset.switch()
    others = view.rows
    assert rows.keys() != others.keys()
    preset.switch()
    preset.tune("silence_energy", before + 1)
    assert view.rows is rows
    preset.switch()
    assert view.rows is others
    preset.switch()
    assert rows["silence_energy"].slider.isVisible()
    assert rows["silence_energy"].slider.value == pytest.approx(before + 1)
    assert not next(iter(others.values())).slider.isVisible()


def test_a_drag_moves_one_threshold_and_its_number_and_undo_takes_the_whole_drag_back(desktop, window):
    for name in NAMES[::4]:  # rows are alike
        before = desktop.preset.preset.phoneme_data
        slider, number = window.analysis.thresholds.rows[name].slider, window.analysis.thresholds.rows[name].number
        window.analysis.thresholds.ensureWidgetVisible(slider)
        drag(slider, x_of(slider, 0.2), x_of(slider, 0.7))
        after = desktop.preset.preset.phoneme_data
        changed = {n for n in NAMES if getattr(before, n) != getattr(after, n)}
        assert name in changed
        assert changed == {name} or changed <= IN_HERTZ
        share = (round(x_of(slider, 0.7)) - 6) / (slider.width() - 12)
        highest = slider.value / share**CURVATURE
        rounding = 0.5 * 10 ** -number.decimals() / slider.value
        assert highest == pytest.approx(float(f"{highest:.2g}"), rel=0.001 + rounding), name
        assert value_of(desktop, name) == pytest.approx(slider.value, rel=1e-6)
        assert number.value() == pytest.approx(slider.value, abs=0.5 * 10 ** -number.decimals())
        assert window.analysis.thresholds.rows[name].reset.isVisible()
        press(window, Qt.Key.Key_Z, CONTROL)
        assert desktop.preset.preset.phoneme_data == before
        press(window, Qt.Key.Key_Z, CONTROL | SHIFT)
        assert desktop.preset.preset.phoneme_data == after
        press(window, Qt.Key.Key_Z, CONTROL)


def test_a_slider_goes_from_nothing_to_its_end_and_no_further_and_two_drags_are_two_undos(desktop, window):
    for name in ("sz_s1", "high_pass_end"):  # rows are alike
        slider = window.analysis.thresholds.rows[name].slider
        first = value_of(desktop, name)
        drag(slider, x_of(slider, 0.5), -100)
        assert value_of(desktop, name) == 0
        drag(slider, x_of(slider, 0.5), slider.width() + 500)
        highest = value_of(desktop, name)
        drag(slider, x_of(slider, 0.5), x_of(slider, 1))
        assert value_of(desktop, name) == highest > 0
        drag(slider, x_of(slider, 0.5), x_of(slider, 0.2))
        for value in (highest, 0, first) if name == "sz_s1" else ():
            press(window, Qt.Key.Key_Z, CONTROL)
            assert value_of(desktop, name) == value
        if name == "sz_s1":
            assert not desktop.preset.undo_stack.canUndo()


def test_a_typed_number_is_taken_as_it_is_or_held_at_the_limit_until_the_reset(desktop, window):
    rows, fields_ = window.analysis.thresholds.rows, window.filters.fields
    names = [name for line in LAYOUT for name in line]
    assert sorted(names) == sorted(NAMES)
    assert list(rows)[:21] == names
    for name, text in (("sz_s1", "77"), ("high_pass_end", "770"), ("denoise_threshold", "0.77")):
        before = value_of(desktop, name)
        type_number(rows[name].number, text)
        assert rows[name].reset.isVisible()
        click(rows[name].reset)
        assert value_of(desktop, name) == before
        assert not rows[name].reset.isVisible()
    assert not desktop.preset.has_unsaved_changes
    for name in (*NAMES[::4], "time_smooth", "frequency_smooth", "denoise_threshold"):  # the other rows are alike
        text = {"time_smooth": "0.125", "frequency_smooth": "0.125", "denoise_threshold": "0.0125"}.get(name, "0.5")
        type_number(rows[name].number, text)
        assert value_of(desktop, name) == pytest.approx(float(text), rel=1e-12)
        assert rows[name].slider.value == pytest.approx(float(text), rel=1e-12)
    type_number(rows["u_o1"].number, "500")  # beyond the slider
    assert value_of(desktop, "u_o1") == 500
    type_number(rows["high_pass_end"].number, "250")  # the filter column shows it, too
    assert desktop.preset.preset.settings.high_pass_end == pytest.approx(250, abs=1e-9)
    assert fields_["high_pass_end"].value() == 250
    type_number(fields_["time_smooth"], "0.25")
    assert rows["time_smooth"].number.value() == 0.25
    limits = {"time_smooth": 1, "frequency_smooth": 1, "denoise_threshold": 1, "high_pass_start": 22050}
    for name, limit in (limits | {"high_pass_end": 22050}).items():
        type_number(rows[name].number, "99999")
        assert 0 <= value_of(desktop, name) <= limit
        assert rows[name].number.value() == pytest.approx(value_of(desktop, name))


def test_the_marks_are_the_live_values_and_the_trace_follows_an_edit_while_it_stands_still(desktop, qtbot):
    window = followed(desktop, qtbot, seconds=0.8)
    newest = desktop.session.history.newest
    for condition in CONDITIONS:
        live = window.analysis.thresholds.rows[condition.threshold].slider.live
        assert live == pytest.approx(float(newest.features[condition.variable][-1]))
    assert window.analysis.phoneme.trace.phoneme is not Phoneme.SILENCE
    for name in ("silence_zero_crossings", "silence_energy", "silence_max_energy", "silence_szsch1"):
        type_number(window.analysis.thresholds.rows[name].number, "99999")
    qtbot.waitUntil(lambda: window.analysis.phoneme.trace.phoneme is Phoneme.SILENCE)


def test_a_mark_is_green_where_the_comparison_holds_and_lies_at_its_value_and_arrow_keys_move_it(desktop, window):
    slider = window.analysis.thresholds.rows["sz_s1"].slider
    click(slider, x_of(slider, 0.5))
    share = (value_of(desktop, "sz_s1") / 66) ** (1 / CURVATURE)
    for key, modifier, step in (
        (Qt.Key.Key_Right, Qt.KeyboardModifier.NoModifier, 0.01),
        (Qt.Key.Key_Left, Qt.KeyboardModifier.NoModifier, -0.01),
        (Qt.Key.Key_Right, SHIFT, 0.001),
        (Qt.Key.Key_Left, SHIFT, -0.001),
    ):
        press(window, key, modifier)
        now = (value_of(desktop, "sz_s1") / 66) ** (1 / CURVATURE)
        assert now - share == pytest.approx(step, abs=2e-4)
        share = now
    slider.set_value(20)
    for live, colour in ((40.0, window.theme.good), (5.0, window.theme.bad)):
        slider.set_live(live)
        x = round(x_of(slider, (live / 66) ** (1 / CURVATURE)))
        assert slider.grab().toImage().pixelColor(x, 2) == QColor(colour)
    slider.set_live(slider.value)
    for width in (slider.width() + 40, slider.width() - 20):
        slider.resize(width, slider.height())
        image, middle = slider.grab().toImage(), slider._x_of(slider.value)
        colours = {image.pixelColor(x, 2).name() for x in range(slider.width()) if abs(x - middle) < 2}
        assert window.theme.bad in colours


def test_an_edit_while_it_plays_acts_on_later_blocks_and_the_marks_move(desktop, qtbot):
    window = shown(desktop, qtbot)
    desktop.session.playback.set_loop(True)  # however long the window takes, the sound goes on
    history, marks = desktop.session.history, set[float | None]()
    click(window.transport.play)

    def has_moved() -> bool:
        marks.add(window.analysis.thresholds.rows["szsch_szsch1"].slider.live)
        return history.n > 50 and len(marks) > 5

    qtbot.waitUntil(has_moved)
    heard = history.phonemes[: history.n].copy()
    assert np.any(heard != Phoneme.SILENCE)
    for name in ("silence_zero_crossings", "silence_energy", "silence_max_energy", "silence_szsch1"):
        type_number(window.analysis.thresholds.rows[name].number, "99999")
    edited = history.n

    def is_silent() -> bool:  # for two seconds, which the sound never is
        return history.n > edited + 200 and np.all(history.phonemes[history.n - 200 : history.n] == Phoneme.SILENCE)

    qtbot.waitUntil(is_silent)
    assert np.array_equal(history.phonemes[: len(heard)], heard)
    assert np.any(history.phonemes[: edited + 40] != Phoneme.SILENCE)
    assert desktop.session.source.playing
