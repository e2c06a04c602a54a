"""A and B: their lanes, the key that switches, what follows it, and how much of what is seen differs."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from phonemeanalyser.desktop.session.preset import NO_SECOND, PresetDocument
from phonemeanalyser.desktop.session.unsaved import UnsavedChanges
from phonemeengine import difference, load_preset
from phonemeengine.presets.files import preset_path
from tests.desktop.hands import CARDS, answer, click, press, shown


@pytest.fixture
def window(desktop, qtbot):
    window = shown(desktop, qtbot)
    settled(desktop, qtbot)
    return window


def settled(desktop, qtbot):
    session = desktop.session
    qtbot.waitUntil(lambda: not session.whole.busy and not session.second.whole.busy)


def test_two_presets_are_seen_and_switched_and_all_that_names_one_follows(desktop, window, qtbot, tmp_path):
    press(window, Qt.Key.Key_X)
    assert window.banner.label.text() == NO_SECOND
    assert desktop.preset.letter == "A"
    bad = tmp_path / "bad.toml"
    bad.write_text("nonsense")
    window.dialogs.presets.load_other(bad)
    assert "bad.toml" in window.banner.label.text()
    assert desktop.preset.other is None
    session, second, panel = desktop.session, desktop.session.second, window.analysis.file
    assert panel.view.file_layout.second_row() is None
    window.dialogs.presets.load_other(preset_path("learned"))
    settled(desktop, qtbot)
    first, other = session.whole.tracks, second.whole.tracks
    expected = difference(CARDS, desktop.preset.preset, load_preset("learned"))
    session.view.show_all()
    said = (
        f"A: Thesis and B: Learned recognise different phonemes in {100 * expected.share:.1f} % of the visible frames"
    )
    assert panel.differs.toolTip() == said
    row = panel.view.file_layout.second_row()
    assert row.top() > panel.view.file_layout.rows()[1].bottom()
    kept = first.phonemes.copy()
    press(window, Qt.Key.Key_X)
    assert session.whole.tracks is other
    assert not session.whole.busy  # nothing is found twice
    assert panel.differs.toolTip() == said  # A stays above B
    assert desktop.preset.letter == "B"
    assert desktop.preset.preset.name == desktop.preset.in_force.name == "Learned"
    assert "Learned" in window.windowTitle()
    assert "Preset: B: Learned" in window.status.left.text()
    assert desktop.preset.path == preset_path("learned")
    sensitivities = set(desktop.preset.controls)
    press(window, Qt.Key.Key_X)
    assert session.whole.tracks is first
    np.testing.assert_array_equal(first.phonemes, kept)
    assert "Thesis" in window.windowTitle()
    assert "Preset: A: Thesis" in window.status.left.text()
    assert set(desktop.preset.controls) != sensitivities


def test_a_change_of_the_one_in_use_is_compared_with_what_was_kept(desktop, window, qtbot, tmp_path):
    window.menus.actions["Set Current as B"].trigger()
    (tmp_path / "other.flac").write_bytes(CARDS.read_bytes())
    desktop.session.open(tmp_path / "other.flac")  # which is recognised with both, too
    settled(desktop, qtbot)
    np.testing.assert_array_equal(desktop.session.whole.tracks.phonemes, desktop.session.second.whole.tracks.phonemes)
    assert "phonemes in 0.0 %" in window.analysis.file.differs.toolTip()
    click(window.filters.switches["statistics"])
    settled(desktop, qtbot)
    assert "phonemes in 0.0 %" not in window.analysis.file.differs.toolTip()
    changed = desktop.preset.preset
    press(window, Qt.Key.Key_X)
    assert not window.menus.actions["Set Current as B"].isEnabled()
    window.menus.actions["Clear B"].trigger()
    settled(desktop, qtbot)
    assert desktop.preset.letter == "A"
    assert desktop.preset.preset == changed
    assert not window.analysis.file.differs.isVisible()


def test_undo_shows_the_preset_that_it_changes(model):
    model.set_other(PresetDocument.read(preset_path("extended")))
    model.set_setting("minimum_hold", 0.08)
    model.switch()
    model.set_setting("minimum_hold", 0.09)
    model.switch()
    model.undo_stack.undo()
    assert (model.letter, model.preset) == ("B", load_preset("extended"))
    model.undo_stack.undo()
    assert (model.letter, model.preset) == ("A", load_preset("thesis"))
    model.undo_stack.redo()
    assert (model.letter, model.preset.settings.minimum_hold) == ("A", 0.08)


def test_what_was_done_to_a_preset_that_goes_cannot_be_undone(model):
    model.set_other(PresetDocument.read(preset_path("extended")))
    model.switch()
    model.set_setting("minimum_hold", 0.09)
    model.switch()
    model.set_other(PresetDocument.read(preset_path("templates")))
    assert model.undo_stack.count() == 0
    assert model.sides["B"].name == "Templates"


def test_b_alone_becomes_a_and_its_changes_can_be_undone(model):
    model.set_other(PresetDocument.read(preset_path("extended")))
    model.switch()
    model.set_setting("minimum_hold", 0.09)
    model.set_other(None)
    assert list(model.sides) == ["A"]
    model.undo_stack.undo()
    assert (model.letter, model.preset) == ("A", load_preset("extended"))


def test_changes_of_both_are_asked_about_at_the_end_and_outlive_a_crash(desktop, window, tmp_path):
    model = desktop.preset
    model.set_other(PresetDocument.read(preset_path("extended")))
    model.set_setting("minimum_hold", 0.08)
    model.switch()
    model.set_setting("minimum_hold", 0.09)
    asked = answer("Cancel")
    assert not window.dialogs.presets.may_close()
    assert "Extended rules" in asked[0]
    kept = UnsavedChanges(model, tmp_path, desktop._settings)
    kept.keep()
    model.clear_second()
    model.load(preset_path("templates"))
    window.dialogs.presets.restore_unsaved(kept)
    assert window.banner.action.text() == "Discard Changes"
    assert model.preset.settings.minimum_hold == 0.09
    assert model.other.preset.settings.minimum_hold == 0.08
    assert model.other.path == preset_path("thesis")
    model.load(preset_path("templates"))
    assert window.banner.isHidden()  # what it offered would discard nothing
    kept.forget()
    assert list(tmp_path.glob("*.toml")) == []
    kept.close()
    model.clear_second()
