"""A second preset in memory: its lane, the key that switches, and how much of what is seen differs."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from phonemeanalyser.desktop.session.whole_file import NO_SECOND
from phonemeengine import difference, load_preset
from phonemeengine.presets.files import preset_path
from tests.desktop.hands import CARDS, FileAnswers, click, press, shown


@pytest.fixture
def window(desktop, qtbot):
    window = shown(desktop, qtbot)
    settled(desktop, qtbot)
    return window


def settled(desktop, qtbot):
    session = desktop.session
    qtbot.waitUntil(lambda: not session.whole.busy and not session.second.whole.busy)


def test_without_a_second_preset_the_key_says_so(desktop, window):
    press(window, Qt.Key.Key_X)
    assert window.banner.label.text() == NO_SECOND
    assert not window.menus.actions["Hear with the Second"].isChecked()
    assert window.analysis.file.view._layout.second_row() is None


def test_two_presets_are_seen_and_switched(desktop, window, qtbot):
    session, second = desktop.session, desktop.session.second
    window.files.show = FileAnswers(preset_path("learned"))
    window.menus.actions["Second Preset…"].trigger()
    settled(desktop, qtbot)
    first, other = session.whole.tracks, second.whole.tracks
    expected = difference(CARDS, desktop.preset.preset, load_preset("learned"))
    session.view.show_all()
    panel = window.analysis.file
    assert panel.differs.toolTip() == f"Thesis and Learned differ in {100 * expected.share:.1f} % of what is seen"
    row = panel.view._layout.second_row()
    assert row.top() > panel.view._layout.rows()[1].bottom()
    kept = first.phonemes.copy()
    press(window, Qt.Key.Key_X)
    assert session.preset.in_force.name == "Learned"
    assert session.preset.preset.name == "Thesis"
    assert session.whole.tracks is other
    assert not session.whole.busy  # nothing is found twice
    assert panel.differs.toolTip().startswith("Learned and Thesis differ")
    press(window, Qt.Key.Key_X)
    assert session.whole.tracks is first
    np.testing.assert_array_equal(first.phonemes, kept)


def test_a_change_of_the_first_is_heard_against_what_was_kept(desktop, window, qtbot):
    second = desktop.session.second
    window.menus.actions["Keep This One as the Second"].trigger()
    settled(desktop, qtbot)
    assert "differ in 0.0 %" in window.analysis.file.differs.toolTip()
    click(window.filters.switches["statistics"])
    settled(desktop, qtbot)
    assert "differ in 0.0 %" not in window.analysis.file.differs.toolTip()
    press(window, Qt.Key.Key_X)
    window.menus.actions["Forget the Second"].trigger()
    settled(desktop, qtbot)
    assert not second.is_in_force
    assert desktop.preset.in_force == desktop.preset.preset
    assert not window.analysis.file.differs.isVisible()


def test_another_file_is_heard_with_both(desktop, window, qtbot, tmp_path):
    window.menus.actions["Keep This One as the Second"].trigger()
    other = tmp_path / "other.flac"
    other.write_bytes(CARDS.read_bytes())
    desktop.session.open(other)
    settled(desktop, qtbot)
    np.testing.assert_array_equal(desktop.session.whole.tracks.phonemes, desktop.session.second.whole.tracks.phonemes)


def test_a_file_that_is_no_preset_is_one_sentence(desktop, window, tmp_path, qtbot):
    bad = tmp_path / "bad.toml"
    bad.write_text("nonsense")
    desktop.session.second.load(bad)
    assert "bad.toml" in window.banner.label.text()
    assert desktop.session.second.preset is None
