"""The column of filters: every control changes the preset, and what comes out of the analysis."""

from dataclasses import replace

import numpy as np
import pytest
import soundfile
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDockWidget,
    QLineEdit,
    QScrollBar,
    QTabBar,
    QWidget,
)

from phonemeanalyser.desktop.analyse.recognition.threshold_view import ThresholdSlider
from phonemeengine.analyser import Analysis, analyse_blocks
from phonemeengine.batch.work import fingerprint_of
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import PARAMETERS, STAGES, AnalysisSettings, Filter
from tests.desktop.hands import CARDS, click, press, shown, type_number
from tests.sounds import noise

TELLING = {
    "frequency_smooth": 0.5,
    "time_smooth": 0.5,
    "high_pass_start": 200.0,
    "high_pass_end": 400.0,
    "low_pass_start": 1000.0,
    "low_pass_end": 2000.0,
    "denoise_threshold": 0.01,
    "minimum_hold": 0.05,
}
"""Parameters with which every filter does something to speech."""

TYPED = {
    "pre_emphasis": "0.5",
    "frequency_smooth": "0.9",
    "time_smooth": "0.9",
    "high_pass_start": "100",
    "high_pass_end": "900",
    "low_pass_start": "500",
    "low_pass_end": "3000",
    "denoise_threshold": "0.05",
    "mel_bands": "20",
    "minimum_hold": "0.2",
    "hysteresis": "0.9",
    "look_ahead": "0.03",
    "intensity_low": "-30",
    "intensity_high": "-20",
}
OF_STEP = {of.name: step for step in Filter for of in STAGES[step].parameters}
CHOSEN = [name for name, of in PARAMETERS.items() if of.choices and name in OF_STEP]


@pytest.fixture(scope="module")
def speech() -> np.ndarray:
    samples, _ = soundfile.read(CARDS, dtype="float32")
    return samples + noise(len(samples) / 44_100, 0.002)[: len(samples)]


@pytest.fixture
def window(desktop, qtbot):
    settings = replace(desktop.preset.preset.settings, **TELLING)
    desktop.preset.edit(replace(desktop.preset.preset, settings=settings), "telling parameters")
    return shown(desktop, qtbot, None)


def analysed(speech: np.ndarray, preset: Preset) -> Analysis:
    return next(iter(analyse_blocks([speech], preset)))


def seen(analysis: Analysis) -> dict[str, np.ndarray]:
    """Everything that a view shows of an analysis."""
    return {
        "spectra": analysis.spectra,
        "mel": np.zeros(0) if analysis.mel is None else analysis.mel,
        "features": analysis.features.values,
        "phonemes": analysis.phonemes,
        "intensities": analysis.intensities,
    }


def differences(speech: np.ndarray, one: Preset, other: Preset) -> set[str]:
    before, after = seen(analysed(speech, one)), seen(analysed(speech, other))
    return {name for name in before if not np.array_equal(before[name], after[name])}


def test_every_switch_changes_preset_and_what_comes_out_and_back(desktop, window, speech):
    before = desktop.preset.preset
    for step in Filter:
        click(window.filters.switches[step])
        after = desktop.preset.preset
        assert after.settings.filters == before.settings.filters ^ {step}
        changed = differences(speech, before, after)
        assert changed & {"spectra", "mel"}, step
        assert ("features" in changed) == (step is not Filter.MEL), step
        click(window.filters.switches[step])
        assert desktop.preset.preset == before
    click(window.filters.switches["statistics"])  # phonemes, and the intensities of silence
    assert differences(speech, before, desktop.preset.preset) == {"phonemes", "intensities"}
    click(window.filters.switches["statistics"])
    assert desktop.preset.preset == before


def test_every_typed_number_changes_preset_and_what_comes_out(desktop, window, speech):
    expected = {"minimum_hold": "phonemes", "hysteresis": "phonemes", "mel_bands": "mel"}
    expected |= dict.fromkeys(("intensity_low", "intensity_high"), "intensities")
    for name, text in TYPED.items():
        if name in OF_STEP and not window.filters.switches[OF_STEP[name]].isChecked():
            click(window.filters.switches[OF_STEP[name]])
        before = desktop.preset.preset
        type_number(window.filters.fields[name], text)
        assert getattr(desktop.preset.preset.settings, name) == float(text)
        assert window.filters.fields[name].value() == float(text)
        if "look_ahead" not in name:  # rules never wait
            assert expected.get(name, "spectra") in differences(speech, before, desktop.preset.preset), name
        desktop.preset.undo_stack.setIndex(1)


@pytest.mark.parametrize("name", CHOSEN)
def test_every_choice_of_a_box_changes_preset_and_spectra(desktop, window, speech, name):
    step = OF_STEP[name]
    if not window.filters.switches[step].isChecked():
        click(window.filters.switches[step])
    box = window.filters.fields[name]
    box.setFocus()
    box.setCurrentIndex(0)
    box.activated.emit(0)
    presets = [desktop.preset.preset]
    for _, value in PARAMETERS[name].choices[1:]:
        press(window, Qt.Key.Key_Down)
        assert getattr(desktop.preset.preset.settings, name) is value or name == "quantise"
        assert "spectra" in differences(speech, presets[-1], desktop.preset.preset)
        presets.append(desktop.preset.preset)
    assert len(set(map(fingerprint_of, presets))) == len(PARAMETERS[name].choices)


def test_every_parameter_has_its_field_bounds_push_each_other_along_and_what_is_out_of_range_is_not_taken(
    desktop, window
):
    named, before = {*TYPED, *CHOSEN, "decoder", "change_cost"}, desktop.preset.preset
    assert set(window.filters.fields) == named
    plain = set(AnalysisSettings.__dataclass_fields__) - {"filters", "statistics"}
    assert plain == named | {"live_look_ahead"}  # which has the slider
    type_number(window.filters.fields["high_pass_start"], "700")
    assert desktop.preset.preset.settings.high_pass_end == 700
    assert window.filters.fields["high_pass_end"].value() == 700
    type_number(window.filters.fields["low_pass_end"], "300")
    assert desktop.preset.preset.settings.low_pass_start == 300
    type_number(window.filters.fields["time_smooth"], "7")
    assert 0 <= desktop.preset.preset.settings.time_smooth <= 1
    type_number(window.filters.fields["mel_bands"], "3")
    assert desktop.preset.preset.settings.mel_bands == before.settings.mel_bands


def test_a_reset_gives_back_what_the_file_says_of_one_filter_only(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    saved = desktop.preset.preset
    for step in Filter:
        other = Filter.MEL if step is not Filter.MEL else Filter.LOW_PASS
        click(window.filters.switches[other])
        elsewhere = desktop.preset.preset
        click(window.filters.switches[step])
        for of in STAGES[step].parameters:
            change(window, desktop, of.name)
        assert desktop.preset.preset != elsewhere
        click(window.filters.resets[step])
        assert desktop.preset.preset == elsewhere
        assert window.filters.switches[step].isChecked() == saved.settings.has(step)
        click(window.filters.resets[other])
        assert not desktop.preset.has_unsaved_changes
    click(window.filters.switches["statistics"])
    for key, names in (("statistics", ["minimum_hold"]), ("intensity", ["intensity_low", "intensity_high"])):
        for name in names:
            type_number(window.filters.fields[name], TYPED[name])
        assert desktop.preset.has_unsaved_changes
        click(window.filters.resets[key])
        assert not desktop.preset.has_unsaved_changes


def change(window, desktop, name: str) -> None:
    """Give a parameter another value."""
    if name in TYPED:
        type_number(window.filters.fields[name], TYPED[name])
    else:
        choices = [value for _, value in PARAMETERS[name].choices]
        k = 0 if getattr(desktop.preset.preset.settings, name) != choices[0] else 1
        window.filters.fields[name].activated.emit(k)


def test_bypass_turns_all_filters_off_and_b_turns_them_back_on(desktop, window, speech):
    kept = desktop.preset.preset
    click(window.filters.bypass)
    assert desktop.preset.bypassed
    assert window.menus.actions["Bypass All Filters"].isChecked()
    assert not any(window.filters.switches[step].isEnabled() for step in Filter)
    raw = analysed(speech, desktop.preset.in_force)
    assert raw.spectra.shape[1] == 1024
    assert "spectra" in differences(speech, kept, desktop.preset.in_force)
    press(window, Qt.Key.Key_B)
    assert not window.filters.bypass.isChecked()
    assert all(window.filters.switches[step].isEnabled() for step in Filter)
    assert desktop.preset.in_force == desktop.preset.preset == kept


def test_a_switch_acts_on_what_is_played_next(desktop, qtbot):
    window = shown(desktop, qtbot)
    desktop.session.playback.set_loop(True)  # however long the window takes, the sound goes on
    click(window.transport.play)
    qtbot.waitUntil(lambda: desktop.session.history.n > 30)
    assert desktop.session.history.newest.spectra.max() == 1
    click(window.filters.switches[Filter.NORMALISE])
    qtbot.waitUntil(lambda: 0 < desktop.session.history.newest.spectra.max() < 1)
    click(window.filters.bypass)
    qtbot.waitUntil(lambda: desktop.session.history.newest.spectra.shape[1] == 1024)
    assert desktop.session.source.playing


def test_space_ticks_a_switch_that_was_reached_with_tab_and_plays_after_a_click(desktop, qtbot):
    window = shown(desktop, qtbot)
    window.filters.bypass.setFocus(Qt.FocusReason.TabFocusReason)
    press(window, Qt.Key.Key_Tab)
    assert QApplication.focusWidget() is window.filters.switches[Filter.QUANTISE]
    press(window, Qt.Key.Key_Space)
    assert not desktop.preset.preset.settings.has(Filter.QUANTISE)
    assert not desktop.session.source.playing
    window.setFocus()
    click(window.filters.switches[Filter.QUANTISE])
    press(window, Qt.Key.Key_Space)
    assert desktop.session.source.playing


def test_after_typing_a_number_the_keys_are_shortcuts_again(desktop, qtbot):
    window = shown(desktop, qtbot)
    type_number(window.filters.fields["time_smooth"], "0.5")
    press(window, Qt.Key.Key_Space)
    assert desktop.session.source.playing
    press(window, Qt.Key.Key_B)
    assert desktop.preset.bypassed
    press(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert desktop.preset.preset.settings.time_smooth == 0
    assert window.filters.fields["time_smooth"].text() == "0.000"


@pytest.mark.usefixtures("own_desktop")  # before other pages are made
def test_every_control_of_the_window_says_what_it_does(desktop, qtbot):
    window = shown(desktop, qtbot)
    kinds = (QAbstractButton, QComboBox, QAbstractSpinBox, QAbstractSlider, ThresholdSlider)
    controls = [w for w in window.findChildren(QWidget) if isinstance(w, kinds) and not made_by_qt(w)]
    assert len(controls) > 80
    assert not [w for w in controls if len(w.toolTip()) < 5]


def made_by_qt(widget: QWidget) -> bool:
    """Scroll bars, the buttons of docks, tabs and tables, and what lies inside a box."""
    inside = isinstance(widget.parent(), QComboBox | QAbstractSpinBox | QLineEdit | QDockWidget | QTabBar)
    return inside or isinstance(widget, QScrollBar) or widget.objectName().startswith("qt_")
