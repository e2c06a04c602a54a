"""The preset's file as the window shows it: marks for unsaved changes, saving, and what closing asks."""

import tomllib

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QMessageBox

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


def change(window, text: str = "3.5") -> None:
    type_number(window.analysis.thresholds.rows["sz_s1"].number, text)


def test_title_and_status_bar_name_sound_and_preset_and_mark_changes(window):
    number = window.analysis.thresholds.rows["sz_s1"].number
    assert window.windowTitle() == "cards.flac - Thesis[*] - PhonemeAnalyser"
    assert not window.isWindowModified()
    assert window.status.left.text().endswith("Preset: Thesis")
    before = number.text()
    change(window)
    assert window.isWindowModified()
    assert window.status.left.text().endswith("Preset: Thesis (changed)")
    press(window, Qt.Key.Key_Z, CONTROL)
    assert not window.isWindowModified()
    press(window, Qt.Key.Key_Z, CONTROL | SHIFT)
    assert window.isWindowModified()
    type_number(number, before)
    assert not window.isWindowModified()


def test_a_factory_preset_is_saved_under_another_name_and_one_s_own_without_asking(desktop, window, tmp_path):
    factory = THESIS_PRESET.read_bytes()
    change(window)
    will_save_to(window, tmp_path / "nowhere" / "voice.toml")
    press(window, Qt.Key.Key_S, CONTROL)
    assert window.banner.isVisible()
    assert window.banner.label.text().startswith("voice.toml: cannot be written")
    assert window.isWindowModified()
    assert desktop.preset.path == THESIS_PRESET
    will_save_to(window, tmp_path / "voice")
    press(window, Qt.Key.Key_S, CONTROL)
    assert THESIS_PRESET.read_bytes() == factory
    assert load_preset(tmp_path / "voice.toml").thresholds.sz_s1 == 3.5
    assert not window.isWindowModified()
    assert window.windowTitle() == "cards.flac - voice[*] - PhonemeAnalyser"
    change(window, "4.5")
    files = will_save_to(window)
    press(window, Qt.Key.Key_S, CONTROL)
    assert files.suggested == []
    assert load_preset(tmp_path / "voice.toml").thresholds.sz_s1 == 4.5
    assert not window.isWindowModified()
    change(window)
    will_save_to(window, tmp_path / "voice")  # whose ending nobody typed
    press(window, Qt.Key.Key_S, CONTROL | SHIFT)
    assert load_preset(tmp_path / "voice.toml").thresholds.sz_s1 == 4.5
    assert load_preset(tmp_path / "voice (2).toml").thresholds.sz_s1 == 3.5
    will_save_to(window, tmp_path / "old", chosen="PhonemeData (*.phonemedata *.txt)")
    answer("Save 21 Numbers Only")  # the notes do not go into it
    press(window, Qt.Key.Key_S, CONTROL | SHIFT)
    assert parse_phoneme_data((tmp_path / "old.phonemedata").read_text()).sz_s1 == 3.5


@pytest.mark.usefixtures("own_desktop")
def test_closing_without_changes_asks_nothing_and_silences_what_plays(desktop, window, hand):
    click(window.transport.play)
    assert window.close()
    assert said(hand) == 0
    assert not window.redraw.timer.isActive()
    assert not desktop.session.source.playing


def test_cancel_and_save_without_a_file_keep_the_window_and_the_changes(desktop, window, hand, tmp_path):
    change(window)
    click(window.transport.play)
    desktop.session.playback.set_loop(True)  # however long the window takes, the sound goes on
    for act in (QDialog.reject, lambda box: box.button(BUTTON.Save).click()):
        hand.act = act
        will_save_to(window)
        assert not window.close()
        assert window.isVisible()
        assert window.isWindowModified()
        assert desktop.session.source.playing
        assert window.redraw.timer.isActive()
    assert said(hand) == 2
    will_save_to(window, tmp_path / "voice.toml")
    assert window.dialogs.presets.may_close()
    assert tomllib.loads((tmp_path / "voice.toml").read_text())["phoneme_data"]["sz_s1"] == 3.5
    change(window, "4.5")
    hand.press(BUTTON.Discard)
    assert window.dialogs.presets.may_close()
    assert tomllib.loads((tmp_path / "voice.toml").read_text())["phoneme_data"]["sz_s1"] == 3.5


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
