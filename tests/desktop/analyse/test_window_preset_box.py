"""The list of presets, each with a line that says what it is; and what a PhonemeData file cannot hold."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from phonemeengine.presets import files
from phonemeengine.presets.files import FACTORY_PRESETS, THESIS_PRESET, load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.storage.paths import presets_folder
from tests.desktop.hands import FileAnswers, answer, back_in, click, press, shown, type_number

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def window(desktop, qtbot, home):
    return shown(desktop, qtbot)


def listed(window) -> list[tuple[str, str, str]]:
    """Mark, name and summary of the lines that are seen."""
    return [(line.text(0), line.text(1), line.text(2)) for line in window.preset_box.list.lines()]


def headings(window) -> dict[str, list[str]]:
    """The names below each heading."""
    window.preset_box.open_list()
    window.preset_box.list.hide()
    groups = window.preset_box.list._groups
    return {heading.text(0) if heading else "": [line.text(1) for line in lines] for heading, lines in groups}


def test_all_factory_presets_are_one_click_apart_and_say_what_they_are_and_how_well_they_do(desktop, window):
    assert len(headings(window)["Factory"]) == len(FACTORY_PRESETS)
    for path in FACTORY_PRESETS:
        preset = load_preset(path)
        click(window.preset_box)
        lines = window.preset_box.list.lines()
        (line,) = [line for line in lines if line.text(1) == preset.name]
        assert line.text(2) == preset.summary
        assert "% on left-out speakers" in preset.summary
        window.preset_box.list.entries.itemClicked.emit(line, 1)
        assert not window.preset_box.list.isVisible()
        assert desktop.preset.path == path
        assert window.preset_box.text() == f"{preset.name} ▾"


def test_keys_open_search_move_choose_and_close(desktop, window, tmp_path):
    picker = window.preset_box.list
    desktop.session.play()
    press(window, Qt.Key.Key_O, CONTROL | SHIFT)
    QTest.keyClick(picker.search, Qt.Key.Key_Escape)
    assert not picker.isVisible()
    assert desktop.session.source.playing  # Escape is else for Stop
    assert desktop.preset.path == THESIS_PRESET
    desktop.session.stop()
    window.analysis.variable.variable.setFocus()
    press(window, Qt.Key.Key_O, CONTROL | SHIFT)
    assert picker.isVisible()
    assert [line for line in listed(window) if line[0]] == [("✓", "Thesis", desktop.preset.preset.summary)]
    QTest.keyClicks(picker.search, "the")  # as in Templates, too
    assert picker.entries.currentItem().text(1) == "Thesis"
    QTest.keyClicks(picker.search, "sis hyst")
    assert [name for _, name, _ in listed(window)] == ["Thesis, calm", "Thesis, anti-aliased", "Open File…"]
    QTest.keyClick(picker.search, Qt.Key.Key_Down)
    QTest.keyClick(picker.search, Qt.Key.Key_Return)
    assert not picker.isVisible()
    assert desktop.preset.preset.name == "Thesis, anti-aliased"
    assert not desktop.session.source.playing
    assert window.focusWidget() is window.analysis.main_view  # letters are keys again
    save_preset(Preset(name="Ben"), tmp_path / "ben.toml")
    window.files.show = FileAnswers(tmp_path / "ben.toml")
    window.preset_box.open_list()
    QTest.keyClicks(picker.search, "nothing has these words")
    assert [name for _, name, _ in listed(window)] == ["Open File…"]
    QTest.keyClick(picker.search, Qt.Key.Key_Return)
    assert desktop.preset.path == tmp_path / "ben.toml"


def test_any_preset_becomes_b_by_key_button_or_command(desktop, window):
    picker = window.preset_box.list
    press(window, Qt.Key.Key_O, CONTROL | SHIFT)
    QTest.keyClicks(picker.search, "templates")
    QTest.keyClick(picker.search, Qt.Key.Key_Return, CONTROL)
    assert [preset.name for preset in desktop.preset.sides.values()] == ["Thesis", "Templates"]
    window.preset_box.open_list()
    assert [line[:2] for line in listed(window) if line[0]] == [("B", "Templates"), ("A", "Thesis")]
    assert picker.as_other.text() == "Set as B"
    QTest.keyClicks(picker.search, "calm")
    click(picker.as_other)
    assert desktop.preset.sides["B"].name == "Thesis, calm"
    window.menus.actions["Choose Preset B…"].trigger()
    QTest.keyClicks(picker.search, "extended")
    QTest.keyClick(picker.search, Qt.Key.Key_Return)
    assert desktop.preset.sides["B"].name == "Extended rules"
    desktop.preset.switch()
    assert window.preset_box.text() == "B: Extended rules ▾"
    assert picker.as_other.text() == "Set as A"


def test_one_s_own_presets_and_those_used_lately_are_listed_and_remembered(desktop, window, settings, tmp_path):
    assert headings(window).keys() == {"Factory", ""}
    window.files.show = files_asked = FileAnswers(as_suggested=True)
    type_number(window.analysis.thresholds.rows["sz_s1"].number, "3.5")
    assert window.preset_box.text() == "Thesis* ▾"
    press(window, Qt.Key.Key_S, CONTROL | SHIFT)
    assert files_asked.suggested == [presets_folder() / "thesis-mine.toml"]
    assert window.preset_box.text() == "thesis-mine ▾"
    assert headings(window)["User"] == ["thesis-mine"]
    (presets_folder() / "thesis-mine.toml").unlink()
    window.dialogs.presets.load(Path("templates"))
    assert settings.value("preset") == "templates"  # its name, wherever the program lies
    save_preset(Preset(name="Anna", notes="Anna, in the studio.\nMore."), presets_folder() / "anna.toml")
    save_preset(Preset(name="Ben"), tmp_path / "ben.phonemedata")
    (presets_folder() / "broken.toml").write_text("[")
    window.dialogs.presets.load(tmp_path / "ben.phonemedata")
    assert Path(str(settings.value("preset"))) == tmp_path / "ben.phonemedata"
    found = headings(window)
    assert (found["User"], found["Recent"][:1]) == (["Anna"], ["ben"])
    assert ("", "Anna", "Anna, in the studio.") in listed(window)
    assert ("✓", "ben", "The rules of the thesis with the 21 numbers of a PhonemeData file.") in listed(window)


# -- what a PhonemeData file cannot hold ----------------------------------------------------------------------


@pytest.fixture
def old(desktop, window, tmp_path) -> Path:
    """An open PhonemeData file with a changed number."""
    path = tmp_path / "old.phonemedata"
    path.write_bytes((files.FACTORY / "thesis.phonemedata").read_bytes())
    window.dialogs.presets.load(path)
    type_number(window.analysis.thresholds.rows["sz_s1"].number, "3.5")
    return path


def test_numbers_alone_are_saved_without_a_question(window, old, hand):
    press(window, Qt.Key.Key_S, CONTROL)
    assert hand.titles == []
    assert load_preset(old).thresholds.sz_s1 == 3.5
    assert not window.isWindowModified()


def test_who_would_lose_something_is_asked_and_saves_the_numbers_only_or_all_of_it_as_toml(
    desktop, window, old, qtbot
):
    desktop.preset.set_setting("hysteresis", 0.5)
    before = old.read_bytes()
    told = answer("Cancel")
    press(window, Qt.Key.Key_S, CONTROL)
    assert "old.phonemedata cannot store hold and hysteresis of this preset" in told[0]
    assert old.read_bytes() == before
    assert desktop.preset.preset.settings.hysteresis == 0.5
    assert window.isWindowModified()
    back_in(window, qtbot)
    answer("Save 21 Numbers Only")
    press(window, Qt.Key.Key_S, CONTROL)
    assert load_preset(old).thresholds.sz_s1 == 3.5
    assert desktop.preset.preset.settings.hysteresis == 0.5  # until the next start
    assert not window.isWindowModified()
    before = old.read_bytes()
    back_in(window, qtbot)
    type_number(window.analysis.thresholds.rows["sz_s1"].number, "4.5")
    window.files.show = FileAnswers(as_suggested=True)
    answer("Save as TOML…")
    press(window, Qt.Key.Key_S, CONTROL)
    saved = load_preset(old.with_suffix(".toml"))
    assert (saved.settings.hysteresis, saved.thresholds.sz_s1) == (0.5, 4.5)
    assert old.read_bytes() == before
    assert not window.isWindowModified()
