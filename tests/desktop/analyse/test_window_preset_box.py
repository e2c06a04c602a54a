"""The box of presets, each with a line that says what it is; and what a PhonemeData file cannot hold."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt

from phonemeengine.presets import files
from phonemeengine.presets.files import FACTORY_PRESETS, load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.storage.paths import presets_folder
from tests.desktop.hands import FileAnswers, answer, press, shown, type_number

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def window(desktop, qtbot, home):
    return shown(desktop, qtbot)


def entries(window) -> dict[str, list[str]]:
    """The entries of the menu below each heading."""
    menu = window.preset_box.menu()
    menu.aboutToShow.emit()
    found: dict[str, list[str]] = {}
    for action in menu.actions():
        if action.isSeparator():
            heading = action.text()
            found[heading] = []
        else:
            found[heading].append(action.text())
    return found


def choose(window, name: str) -> None:
    menu = window.preset_box.menu()
    menu.aboutToShow.emit()
    (action,) = [a for a in menu.actions() if a.text().partition(":")[0] == name]
    action.trigger()


def test_all_factory_presets_are_one_click_apart_and_say_what_they_are(desktop, window):
    listed = entries(window)["Factory"]
    assert len(listed) == len(FACTORY_PRESETS)
    for path in FACTORY_PRESETS:
        preset = load_preset(path)
        assert f"{preset.name}:  {preset.summary}" in listed
        choose(window, preset.name)
        assert desktop.preset.path == path
        assert window.preset_box.text() == preset.name


def test_a_preset_that_is_named_is_remembered_by_its_file(desktop, window, settings):
    window.dialogs.load_preset(Path("templates"))
    assert Path(str(settings.value("preset"))) == files.FACTORY / "templates.toml"


def test_the_one_in_use_is_ticked(window):
    choose(window, "Templates")
    window.preset_box.menu().aboutToShow.emit()
    assert [a.text().partition(":")[0] for a in window.preset_box.menu().actions() if a.isChecked()] == ["Templates"]


def test_one_s_own_presets_and_those_used_lately_are_listed(window, tmp_path):
    assert entries(window).keys() == {"Factory", ""}
    presets_folder().mkdir(parents=True)
    save_preset(Preset(name="Anna", notes="Anna, in the studio.\nMore."), presets_folder() / "anna.toml")
    save_preset(Preset(name="Ben"), tmp_path / "ben.phonemedata")
    (presets_folder() / "broken.toml").write_text("[")
    window.dialogs.load_preset(tmp_path / "ben.phonemedata")
    listed = entries(window)
    assert listed["Mine"] == ["Anna:  Anna, in the studio."]
    assert listed["Recent"] == ["ben:  The rules of the thesis with the 21 numbers of a PhonemeData file."]
    assert {"Save Preset As…", "Load Preset…"} < set(listed[""])


def test_an_own_preset_is_saved_into_the_folder_of_own_presets_and_then_listed(desktop, window, tmp_path):
    window.files.show = files_asked = FileAnswers(as_suggested=True)
    type_number(window.analysis.thresholds.rows["sz_s1"].number, "3.5")
    assert window.preset_box.text() == "Thesis*"
    press(window, Qt.Key.Key_S, CONTROL | SHIFT)
    assert files_asked.suggested == [presets_folder() / "thesis-mine.toml"]
    assert window.preset_box.text() == "thesis-mine"
    assert entries(window)["Mine"] == [f"thesis-mine:  {desktop.preset.preset.summary}"]


# -- what a PhonemeData file cannot hold ----------------------------------------------------------------------


@pytest.fixture
def old(desktop, window, tmp_path) -> Path:
    """A PhonemeData file in hand, with something that it cannot hold."""
    path = tmp_path / "old.phonemedata"
    path.write_bytes((files.FACTORY / "thesis.phonemedata").read_bytes())
    window.dialogs.load_preset(path)
    desktop.preset.set_setting("hysteresis", 0.5)
    type_number(window.analysis.thresholds.rows["sz_s1"].number, "3.5")
    return path


def test_numbers_alone_are_saved_without_a_question(desktop, window, tmp_path, hand):
    path = tmp_path / "old.phonemedata"
    path.write_bytes((files.FACTORY / "thesis.phonemedata").read_bytes())
    window.dialogs.load_preset(path)
    type_number(window.analysis.thresholds.rows["sz_s1"].number, "3.5")
    press(window, Qt.Key.Key_S, CONTROL)
    assert hand.titles == []
    assert load_preset(path).thresholds.sz_s1 == 3.5
    assert not window.isWindowModified()


def test_cancel_writes_nothing_and_keeps_all(desktop, window, old):
    before = old.read_bytes()
    told = answer("Cancel")
    press(window, Qt.Key.Key_S, CONTROL)
    assert "old.phonemedata cannot hold hold and hysteresis of this preset" in told[0]
    assert old.read_bytes() == before
    assert desktop.preset.preset.settings.hysteresis == 0.5
    assert window.isWindowModified()


def test_all_of_it_is_saved_as_toml(desktop, window, old):
    window.files.show = FileAnswers(as_suggested=True)
    before = old.read_bytes()
    answer("Save as TOML…")
    press(window, Qt.Key.Key_S, CONTROL)
    saved = load_preset(old.with_suffix(".toml"))
    assert (saved.settings.hysteresis, saved.thresholds.sz_s1) == (0.5, 3.5)
    assert old.read_bytes() == before
    assert not window.isWindowModified()


def test_the_numbers_are_saved_with_a_yes_and_the_rest_stays_marked(desktop, window, old):
    answer("Save the 21 Numbers Only")
    press(window, Qt.Key.Key_S, CONTROL)
    assert load_preset(old).thresholds.sz_s1 == 3.5
    assert desktop.preset.preset.settings.hysteresis == 0.5
    assert window.isWindowModified()
