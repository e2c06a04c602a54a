"""The menu of the selection, from the window."""

import pytest
import soundfile
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication

from phonemeanalyser.desktop.analyse.lanes.label_dialogs import MeasurementDialog
from phonemeanalyser.desktop.session.time_view import TimeSpan
from tests.desktop.hands import FileAnswers, shown


def opened(desktop, qtbot):
    window = shown(desktop, qtbot)
    qtbot.waitUntil(lambda: not desktop.session.whole.busy)
    desktop.session.view.select(TimeSpan(0.5, 1.0))
    return window


def test_brackets_select_from_the_cursor_and_to_it(desktop, qtbot):
    window = opened(desktop, qtbot)
    for seconds, key, selected in ((0.2, "[", (0.2, 1.0)), (0.7, "]", (0.2, 0.7)), (0.1, "]", (0.0, 0.1))):
        desktop.session.seek(seconds)
        qtbot.keyClicks(window, key)
        assert desktop.session.view.selection == pytest.approx(selected, abs=1e-3)


def test_a_measurement_is_shown_and_copied(desktop, qtbot):
    window = opened(desktop, qtbot)
    window.menus.actions["Measure Selection"].trigger()
    qtbot.waitUntil(lambda: bool(window.findChildren(MeasurementDialog)))
    dialog = window.findChildren(MeasurementDialog)[0]
    assert dialog.windowTitle().startswith("Measurements: 0.500 to 1.000 s of ")
    qtbot.mouseClick(dialog.copy, Qt.MouseButton.LeftButton)
    copied = QGuiApplication.clipboard().text().splitlines()
    assert copied[0].split("\t") == ["measure", "unit", "mean", "min", "max"]
    assert dialog.table.rowCount() == len(copied) - 1
    dialog.close()


def test_the_selected_sound_is_saved_where_the_user_says(desktop, qtbot, tmp_path):
    window = opened(desktop, qtbot)
    window.files.show = FileAnswers(tmp_path / "part")
    with qtbot.waitSignal(window.selection.info):
        window.menus.actions["Save Selection as Audio File…"].trigger()
    assert soundfile.info(tmp_path / "part.wav").frames == 22050
    assert "0.50 s of cards.flac saved as" in window.banner.label.text()


def test_the_selection_becomes_a_take(desktop, qtbot, tmp_path):
    window = opened(desktop, qtbot)
    takes = next(a.menu() for a in window.analysis.file.view.actions() if a.menu() is not None)
    next(a for a in takes.actions() if a.text() == "a").trigger()
    takes = desktop.calibration.takes
    qtbot.waitUntil(lambda: len(takes.now.takes) == 1)
    (take,) = takes.now.takes
    assert (take.phoneme.label, take.device) == ("a", desktop.session.source.name)


def test_frames_are_copied(desktop, qtbot):
    window = opened(desktop, qtbot)
    window.menus.actions["Copy Frames as Table"].trigger()
    assert len(QGuiApplication.clipboard().text().splitlines()) == 51
