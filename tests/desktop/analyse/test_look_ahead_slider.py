"""The look-ahead of a microphone against how late and how right it is."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.presets.files import DEFAULT_PRESET, THESIS_PRESET, factory_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import ModelKind
from tests.desktop.hands import click, edits, shown
from tests.desktop.studio import Booth
from tests.fakes.microphones import HandDrivenMicrophone

FIGURES = {str(10 * k): [0.6 + 0.02 * k, 0.7 + 0.02 * k] for k in range(6)}


def measured(preset: Preset) -> Preset:
    """The preset, with a small network whose training measured the look-ahead, and which recognises live sound."""
    assert preset.model is not None
    model = replace(preset.model, about=preset.model.about | {"by_look_ahead_ms": FIGURES})
    return replace(
        preset, model=model, live_model=ModelKind.REAL_TIME, settings=replace(preset.settings, live_look_ahead=0.02)
    )


@pytest.fixture
def window(desktop: Desktop, qtbot) -> MainWindow:
    desktop.preset.edit(measured(factory_preset("learned")), "a measured model")
    return shown(desktop, qtbot, None)


def test_keys_set_the_look_ahead_of_the_microphone_and_undo_takes_it_back(desktop: Desktop, window: MainWindow):
    slider = window.filters.look_ahead
    assert slider.value() == 2
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_Right)
    assert desktop.preset.preset.settings.live_look_ahead == 0.03
    QTest.keyClick(slider, Qt.Key.Key_End)
    assert desktop.preset.preset.settings.live_look_ahead == 0.05
    assert "Undo change live look-ahead" in edits(window)
    desktop.preset.undo_stack.undo()
    assert slider.value() == 2


def test_a_longer_look_ahead_takes_that_of_files_along_and_a_shorter_one_of_files_takes_it_back(
    desktop: Desktop, window: MainWindow
):
    desktop.preset.set_setting("look_ahead", 0.01)
    assert desktop.preset.preset.settings.live_look_ahead == 0.01
    slider = window.filters.look_ahead
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_End)
    assert desktop.preset.preset.settings.look_ahead == 0.05


def test_the_reset_gives_back_what_the_file_says(desktop: Desktop, window: MainWindow):
    desktop.preset.load(DEFAULT_PRESET)
    saved = desktop.preset.preset.settings.live_look_ahead
    slider = window.filters.look_ahead
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_Home)
    assert desktop.preset.preset.settings.live_look_ahead == 0
    click(window.filters.resets["look_ahead"])
    assert desktop.preset.preset.settings.live_look_ahead == saved


def test_how_right_it_is_stands_beside_and_is_not_made_up(desktop: Desktop, window: MainWindow):
    slider = window.filters.look_ahead
    figures = "mouth-shape accuracy 74 % · macro F1 0.64"
    assert slider.words.text() == f"Look-ahead 20 ms · latency not measured yet · {figures}"
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_Right)
    assert "macro F1 0.66" in slider.words.text()
    model = desktop.preset.preset.model
    assert model is not None
    unmeasured = replace(model, about={"by_look_ahead_ms": {"long": "ago"}}, warps=(*model.warps, 1.01))
    desktop.preset.edit(replace(desktop.preset.preset, model=unmeasured), "an unmeasured model")
    assert "accuracy not measured" in slider.words.text()


def test_rules_never_wait(desktop: Desktop, qtbot):
    window = shown(desktop, qtbot, None)
    desktop.preset.load(THESIS_PRESET)
    assert window.filters.look_ahead.words.text() == "Thesis: no look-ahead · latency not measured yet"


def test_how_late_it_is_is_what_the_microphone_measured_and_stays_known(booth: Booth, mic: HandDrivenMicrophone):
    booth.desktop.preset.edit(measured(factory_preset("learned")), "a measured model")
    slider, status = booth.window.filters.look_ahead, booth.window.status
    mic.delay = 0.033
    booth.until(lambda: "look-ahead 20 +" in booth.status, mic)
    booth.until(lambda: "not measured yet" not in slider.words.text(), mic)
    late = int(slider.words.text().split("latency ")[1].split()[0])
    assert status.without_look_ahead is not None
    assert late == round(1000 * status.without_look_ahead + 20)
    slider.setValue(5)
    assert slider.words.text().startswith("Look-ahead 50 ms · latency ")
    further = int(slider.words.text().split("latency ")[1].split()[0])
    assert further == round(1000 * status.without_look_ahead + 50)
    booth.until(lambda: "look-ahead 50 +" in booth.status, mic)
    assert status.latency_ms == pytest.approx(1000 * status.without_look_ahead + 50)
    booth.until(lambda: "Latency" not in status.chips.words())
    assert "not measured yet" not in slider.words.text()
