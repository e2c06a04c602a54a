"""The preset's file as the window shows it: marks for unsaved changes, saving, and what closing asks."""

import tomllib

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox

from phonemeengine.presets.files import THESIS_PRESET, load_preset, parse_phoneme_data, save_preset
from tests.desktop.hands import FileAnswers, answer, click, press, shown, type_number

BUTTON = QMessageBox.StandardButton
CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def window(desktop, qtbot):
    return shown(desktop, qtbot)


def said(hand) -> int:
    """How often it was asked about unsaved changes."""
    assert set(hand.titles) <= {"Unsaved Changes"}
    assert all(text.endswith("?") for text in hand.texts)
    return len(hand.texts)


def will_save_to(window, *paths, chosen="Preset (*.toml)") -> FileAnswers:
    window.files.show = FileAnswers(*paths, chosen=chosen)
    return window.files.show


def change(window) -> None:
    type_number(window.analysis.thresholds.rows["sz_s1"].number, "3.5")


def test_title_and_status_bar_name_sound_and_preset_and_mark_changes(desktop, window):
    assert window.windowTitle() == "cards.flac - Thesis[*] - PhonemeAnalyser"
    assert not window.isWindowModified()
    assert window.status.left.text().endswith("Preset: Thesis")
    change(window)
    assert window.isWindowModified()
    assert window.status.left.text().endswith("Preset: Thesis (changed)")
    press(window, Qt.Key.Key_Z, CONTROL)
    assert not window.isWindowModified()
    press(window, Qt.Key.Key_Z, CONTROL | SHIFT)
    assert window.isWindowModified()


def test_a_value_typed_back_is_no_change(desktop, window):
    before = window.analysis.thresholds.rows["sz_s1"].number.text()
    change(window)
    type_number(window.analysis.thresholds.rows["sz_s1"].number, before)
    assert not window.isWindowModified()


def test_a_factory_preset_is_saved_under_another_name(desktop, window, tmp_path):
    factory = THESIS_PRESET.read_bytes()
    change(window)
    will_save_to(window, tmp_path / "voice")
    press(window, Qt.Key.Key_S, CONTROL)
    assert THESIS_PRESET.read_bytes() == factory
    assert load_preset(tmp_path / "voice.toml").thresholds.sz_s1 == 3.5
    assert not window.isWindowModified()
    assert window.windowTitle() == "cards.flac - voice[*] - PhonemeAnalyser"


def test_a_preset_of_one_s_own_is_saved_without_asking(desktop, window, tmp_path):
    save_preset(desktop.preset.preset, tmp_path / "mine.toml")
    window.dialogs.presets.load(tmp_path / "mine.toml")
    change(window)
    files = will_save_to(window)
    press(window, Qt.Key.Key_S, CONTROL)
    assert files.suggested == []
    assert load_preset(tmp_path / "mine.toml").thresholds.sz_s1 == 3.5
    assert not window.isWindowModified()


def test_save_as_writes_phonemedata_by_name_or_by_filter(desktop, window, tmp_path):
    change(window)
    will_save_to(window, tmp_path / "old", chosen="PhonemeData (*.phonemedata *.txt)")
    answer("Save 21 Numbers Only")  # the notes do not go into it
    press(window, Qt.Key.Key_S, CONTROL | SHIFT)
    assert parse_phoneme_data((tmp_path / "old.phonemedata").read_text()).sz_s1 == 3.5


def test_a_preset_whose_ending_nobody_typed_replaces_no_other_one(desktop, window, tmp_path):
    (tmp_path / "voice.toml").write_text("somebody's")
    change(window)
    will_save_to(window, tmp_path / "voice")
    press(window, Qt.Key.Key_S, CONTROL | SHIFT)
    assert (tmp_path / "voice.toml").read_text() == "somebody's"
    assert load_preset(tmp_path / "voice (2).toml").thresholds.sz_s1 == 3.5


def test_a_folder_that_cannot_be_written_is_said_and_nothing_is_lost(desktop, window, tmp_path):
    change(window)
    will_save_to(window, tmp_path / "nowhere" / "voice.toml")
    press(window, Qt.Key.Key_S, CONTROL)
    assert window.banner.isVisible()
    assert window.banner.label.text().startswith("voice.toml: cannot be written")
    assert window.isWindowModified()
    assert desktop.preset.path == THESIS_PRESET


@pytest.mark.usefixtures("own_desktop")
def test_closing_without_changes_asks_nothing_and_silences_what_plays(desktop, window, hand):
    click(window.transport.play)
    assert window.close()
    assert said(hand) == 0
    assert not window.redraw.timer.isActive()
    assert not desktop.session.source.playing


def test_cancel_keeps_the_window_and_the_changes(desktop, window, hand):
    change(window)
    click(window.transport.play)
    assert not window.close()
    assert said(hand) == 1
    assert window.isVisible()
    assert window.isWindowModified()
    assert desktop.session.source.playing
    assert window.redraw.timer.isActive()


@pytest.mark.usefixtures("own_desktop")
def test_discard_closes_and_writes_nothing(desktop, window, hand, tmp_path):
    save_preset(desktop.preset.preset, tmp_path / "mine.toml")
    window.dialogs.presets.load(tmp_path / "mine.toml")
    before = (tmp_path / "mine.toml").read_bytes()
    change(window)
    hand.press(BUTTON.Discard)
    assert window.close()
    assert (tmp_path / "mine.toml").read_bytes() == before


@pytest.mark.usefixtures("own_desktop")
def test_save_writes_and_closes(desktop, window, hand, tmp_path):
    change(window)
    hand.press(BUTTON.Save)
    will_save_to(window, tmp_path / "voice.toml")
    assert window.close()
    assert tomllib.loads((tmp_path / "voice.toml").read_text())["phoneme_data"]["sz_s1"] == 3.5


def test_save_without_choosing_a_file_does_not_close(desktop, window, hand):
    change(window)
    hand.press(BUTTON.Save)
    will_save_to(window)
    assert not window.close()
    assert window.isVisible()
    assert window.isWindowModified()


def test_loading_another_preset_asks_about_changes_too(desktop, window, hand, tmp_path):
    save_preset(desktop.preset.preset, tmp_path / "mine.toml")
    change(window)
    window.dialogs.presets.load(tmp_path / "mine.toml")
    assert said(hand) == 1
    assert desktop.preset.path == THESIS_PRESET
    hand.press(BUTTON.Discard)
    window.dialogs.presets.load(tmp_path / "mine.toml")
    assert desktop.preset.path == tmp_path / "mine.toml"
    assert not window.isWindowModified()
    assert not desktop.preset.undo_stack.canUndo()
