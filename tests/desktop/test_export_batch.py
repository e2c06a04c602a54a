"""The window's batch: what the command line writes, and sounds one by one, byte for byte."""

import shutil

import pytest
from PySide6.QtCore import QSettings
from PySide6.QtTest import QTest

from phonemeanalyser.cli.main import main
from phonemeanalyser.desktop.export_dialog import ExportDialog
from phonemeanalyser.desktop.session.exports import ExportState
from phonemeanalyser.reports.page import TABLE
from phonemeengine import Channel, convert, convert_all, load_preset
from tests.desktop.hands import CARDS, LEFT
from tests.tables import contents

PRESET = load_preset("thesis")
KIND = "rhubarb-json"


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "in").mkdir()
    for name in ("a.flac", "b.flac", "c.flac"):
        shutil.copy(CARDS, tmp_path / "in" / name)
    return tmp_path / "in"


def exported(desktop, folder, out, qtbot):
    settings = QSettings(str(out.with_suffix(".ini")), QSettings.Format.IniFormat)
    dialog = ExportDialog(PRESET, Channel.MIX, [folder], settings, desktop.window)
    dialog.choices.kind.setCurrentIndex(dialog.choices.kind.findData(KIND))
    dialog.write_into(out)
    with qtbot.waitSignal(dialog.queue.finished):
        QTest.mouseClick(dialog.start, LEFT)
    jobs = dialog.queue.jobs
    dialog.queue.close()
    dialog.close()
    return [job.state for job in jobs]


def test_window_command_line_program_and_single_files_write_the_same_bytes(desktop, folder, tmp_path, qtbot):
    assert exported(desktop, folder, tmp_path / "window", qtbot) == 3 * [ExportState.DONE]
    words = ["export", str(folder), "--format", KIND, "--preset", "thesis", "--jobs", "2"]
    assert main([*words, "-o", str(tmp_path / "commands")]) == 0
    assert convert_all(sorted(folder.iterdir()), tmp_path / "program", KIND, PRESET) == {}
    for sound in folder.iterdir():
        convert(sound, tmp_path / "single" / f"{sound.stem}.rhubarb.json", KIND, PRESET)
    found = [contents(tmp_path / way) for way in ("window", "commands", "program", "single")]
    assert len(found[0]) == 3
    assert found[1:] == 3 * found[:1]


def test_what_the_window_did_it_does_not_again(desktop, folder, tmp_path, qtbot):
    out = tmp_path / "out"
    exported(desktop, folder, out, qtbot)
    (folder / "b.flac").write_bytes(b"no sound")
    states = exported(desktop, folder, out, qtbot)
    assert states == [ExportState.SKIPPED, ExportState.FAILED, ExportState.SKIPPED]
    assert "b.flac" in (out / TABLE).read_text()
