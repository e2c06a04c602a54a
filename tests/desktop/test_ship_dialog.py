"""A preset shipped from the window: the same folder as on the command line, and sentences for what goes wrong."""

from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from phonemeanalyser.cli.main import main
from phonemeanalyser.desktop.ship_dialog import ShipDialog
from phonemeengine import ModelKind, Phoneme, Preset, save_preset
from phonemeengine.encoder.live import build_live_encoder
from tests.desktop.hands import LEFT, FileAnswers, shown
from tests.fakes.encoder_weights import encoder_weights
from tests.models import tone_model


@pytest.fixture
def window(desktop, qtbot):
    return shown(desktop, qtbot, None)


@pytest.fixture
def dialog(window, tmp_path):
    window.menus.actions["Ship Preset…"].trigger()
    dialog = next(d for d in window.findChildren(ShipDialog) if d.isVisible())
    dialog.target.setCurrentIndex(dialog.target.findData("c"))
    dialog.folder.setText(str(tmp_path / "window"))
    return dialog


def contents(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def start(dialog, window, qtbot) -> str:
    """Ship, and give what the banner says of it at last."""
    QTest.mouseClick(dialog.start, LEFT)
    qtbot.waitUntil(lambda: not window.dialogs.presets._shipping.busy)
    return window.banner.label.text()


def choose(dialog, name: str) -> None:
    QTest.mouseClick(dialog.preset, LEFT)
    QTest.keyClicks(dialog.preset.list.search, name)
    QTest.keyClick(dialog.preset.list.search, Qt.Key.Key_Return)


def test_a_preset_of_the_list_is_shipped_as_the_command_line_does(dialog, window, qtbot, tmp_path):
    choose(dialog, "Templates")
    assert "12 files written to" in start(dialog, window, qtbot)
    assert main(["ship", "templates", "-o", str(tmp_path / "typed")]) == 0
    assert contents(tmp_path / "window") == contents(tmp_path / "typed")
    assert window.banner.action.text() == "Open Folder"


def test_the_preset_in_hand_is_shipped_with_its_changes_and_the_chosen_tables(desktop, window, qtbot, tmp_path):
    desktop.preset.tune("sz_s1", 3.5)
    window.files.show = FileAnswers(tmp_path / "chosen")
    window.dialogs.presets.show_ship()
    dialog = next(d for d in window.findChildren(ShipDialog) if d.isVisible())
    QTest.mouseClick(dialog.choose, LEFT)
    for row in range(dialog.tables.count()):
        item = dialog.tables.item(row)
        is_wanted = item.text() in {"Five mouth shapes", "VRM A I U E O"}
        item.setCheckState(Qt.CheckState.Checked if is_wanted else Qt.CheckState.Unchecked)
    dialog.target.setCurrentIndex(dialog.target.findData("web"))
    assert not dialog.embed.isVisible()
    dialog.target.setCurrentIndex(dialog.target.findData("c"))
    QTest.mouseClick(dialog.embed, LEFT, pos=dialog.embed.rect().center() * 0.1)
    assert dialog.embed.isChecked()
    start(dialog, window, qtbot)
    save_preset(desktop.preset.preset, tmp_path / "mine.toml")
    words = [
        "ship",
        str(tmp_path / "mine.toml"),
        "-o",
        str(tmp_path / "typed"),
        "--table",
        "five",
        "--table",
        "vrm",
        "--embed",
    ]
    assert main(words) == 0
    assert contents(tmp_path / "chosen") == contents(tmp_path / "typed")


def test_what_goes_wrong_is_a_banner_and_changed_files_stay_unless_they_are_given_up(dialog, window, qtbot, tmp_path):
    (tmp_path / "window").mkdir()
    (tmp_path / "window" / "Makefile").write_text("all:\n")
    said = start(dialog, window, qtbot)
    assert "Makefile: another file is there, or it was changed; choose another folder" in said
    window.dialogs.presets.show_ship()
    again = next(d for d in window.findChildren(ShipDialog) if d.isVisible())
    assert again.folder.text() == str(tmp_path / "window")
    again.overwrite.setChecked(True)
    assert "12 files written to" in start(again, window, qtbot)


def test_without_a_folder_nothing_can_be_shipped(dialog):
    dialog.folder.setText(" ")
    assert not dialog.start.isEnabled()
    dialog.folder.setText("here")
    assert dialog.start.isEnabled()
    dialog.reject()


def test_where_the_preset_listens_with_the_real_time_model_the_small_one_is_said_to_serve(
    desktop, dialog, window, tmp_path
):
    assert not dialog.note.isVisible()
    encoder = build_live_encoder(encoder_weights(n_layers=1, n_channels=64))
    preset = Preset(name="both", recogniser="learned", model=tone_model({700.0: Phoneme.A}), live_encoder=encoder)
    save_preset(preset, tmp_path / "both.toml")
    dialog.preset.choose(tmp_path / "both.toml")
    assert dialog.note.isVisible()
    assert dialog.note.text().startswith("Programs without Python recognise with the preset's small network; ")
    save_preset(replace(preset, live_model=ModelKind.REAL_TIME), tmp_path / "small.toml")
    dialog.preset.choose(tmp_path / "small.toml")
    assert not dialog.note.isVisible()
