"""Keys of blend shapes, as an animator meets them: seen, dragged, added, deleted, smoothed, saved and exported."""

import shutil
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.export_dialog import ExportDialog
from phonemeanalyser.desktop.session.exports import ExportOrder, with_texts, work_of
from phonemeanalyser.desktop.talk.keys.key_lanes import KeyLanes
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.batch.work import Job, say_nothing
from phonemeengine.execution import no_progress
from phonemeengine.mouth.curves_file import read_curves
from phonemeengine.mouth.key_layer import NO_KEYS, KeyCurve, KeyLayer, keys_beside, read_keys
from phonemeengine.settings import Channel
from phonemeengine.storage.paths import presets_folder
from tests.desktop.hands import CARDS, DEMO, FileAnswers, answer, shown

SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    """A recorded sentence with its labels, in a folder of its own."""
    for path in CARDS.parent.glob(f"{CARDS.stem}.*"):
        shutil.copy(path, tmp_path / path.name)
    return tmp_path / CARDS.name


@pytest.fixture
def window(desktop: Desktop, qtbot: QtBot, recording: Path, graphics: None) -> MainWindow:
    """The page of the head with the curves of the recording."""
    window = shown(desktop, qtbot, recording)
    window.resize(1400, 1000)
    window.show_page(2)
    window.talk.show_keys.click()
    qtbot.waitUntil(lambda: desktop.talking.keys.animation is not None, timeout=60_000)
    return window


@pytest.fixture
def lanes(window: MainWindow) -> KeyLanes:
    return window.talk.key_panel.lanes


def point_in(lanes: KeyLanes, shape: str) -> tuple[float, QPoint]:
    """Return the time of a key of a curve that stands alone, and where it is."""
    curve = lanes.keys.curve_of(shape)
    assert curve is not None
    points = curve.points()
    gaps = np.minimum(np.diff(points)[:-1], np.diff(points)[1:])
    time = float(points[1 + int(np.argmax(gaps))])
    return time, lanes.place_of(shape, time).toPoint()


def drag(lanes: KeyLanes, start: QPoint, end: QPoint, modifier: Qt.KeyboardModifier) -> None:
    QTest.mousePress(lanes, Qt.MouseButton.LeftButton, modifier, start)
    for k in range(1, 5):
        QTest.mouseMove(lanes, start + (end - start) * k / 4)
    QTest.mouseRelease(lanes, Qt.MouseButton.LeftButton, modifier, end)


def choose(lanes: KeyLanes, place: QPoint, entry: str) -> None:
    """Choose an entry of the menu of a curve."""
    QApplication.sendEvent(lanes, QContextMenuEvent(QContextMenuEvent.Reason.Mouse, place, lanes.mapToGlobal(place)))
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    next(action for action in menu.actions() if action.text() == entry).trigger()
    menu.close()


def test_a_key_is_dragged_as_one_change_or_moved_chosen_and_deleted_by_keyboard(desktop, window, lanes):
    time, place = point_in(lanes, "jawOpen")
    before = lanes.keys.curve_of("jawOpen")
    top = QPoint(place.x(), round(lanes.rows()["jawOpen"].top()) + 6)
    drag(lanes, place, top, Qt.KeyboardModifier.NoModifier)
    curve = lanes.keys.curve_of("jawOpen")
    assert np.interp(time, curve.times, curve.shown) > 0.9
    assert desktop.preset.undo_stack.undoText() == "move a key"
    assert desktop.preset.undo_stack.count() == 1
    desktop.session.seek(time)
    desktop.talking.tick()
    desktop.preset.undo_stack.undo()
    assert lanes.keys.layer == NO_KEYS
    assert lanes.keys.curve_of("jawOpen").shown == pytest.approx(before.shown)
    time, place = point_in(lanes, "jawOpen")
    QTest.mouseClick(lanes, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)
    assert lanes.selected is not None
    assert lanes.selected.time == pytest.approx(time)
    lanes.setFocus()
    was = np.interp(time, lanes.keys.curve_of("jawOpen").times, lanes.keys.curve_of("jawOpen").shown)
    QTest.keyClick(lanes, Qt.Key.Key_Up, SHIFT)
    curve = lanes.keys.curve_of("jawOpen")
    assert np.interp(lanes.selected.time, curve.times, curve.shown) == pytest.approx(was + 0.1, abs=0.02)
    QTest.keyClick(lanes, Qt.Key.Key_PageDown)
    assert lanes.selected.time > time
    QTest.keyClick(lanes, Qt.Key.Key_Delete)
    assert desktop.preset.undo_stack.undoText() == "delete a key"
    panel = window.talk.key_panel
    panel.shapes.menu().aboutToShow.emit()
    actions = {action.text(): action for action in panel.shapes.menu().actions()}
    assert actions["jawOpen"].isChecked()
    assert len(actions) == 52
    actions["tongueOut"].trigger()  # the list of blend shapes chooses the curves
    assert lanes.keys.shapes[-1] == "tongueOut"
    assert "tongueOut" in lanes.rows()


def test_a_double_click_adds_a_key_and_a_marked_range_is_smoothed_raised_and_reset(desktop, lanes):
    row, axis = lanes.rows()["mouthPucker"], lanes.axis
    points = lanes.keys.curve_of("mouthPucker").points()
    widest = int(np.argmax(np.diff(points)))  # far from other keys
    middle = QPointF(axis.x_of((points[widest] + points[widest + 1]) / 2), row.center().y()).toPoint()
    QTest.mouseDClick(lanes, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, middle)
    assert desktop.preset.undo_stack.undoText() == "add a key"
    drag(lanes, middle - QPoint(80, 0), middle + QPoint(80, 0), SHIFT)
    assert lanes.marked is not None
    assert lanes.marked.ordered.end > lanes.marked.ordered.start
    for entry, words in (("Smooth Range", "smooth keys"), ("Raise Range by 0.1", "raise keys")):
        choose(lanes, middle, entry)
        assert desktop.preset.undo_stack.undoText() == words
    choose(lanes, middle, "Reset Range")
    assert not np.any(lanes.keys.layer.curve_of("mouthPucker").offsets)


def test_a_range_is_marked_from_a_key_and_raised_by_keyboard_in_another_curve(desktop, lanes):
    lanes.selected = lanes.marked = None  # what a test before left in the window that is lent
    lanes.setFocus()
    QTest.keyClick(lanes, Qt.Key.Key_PageDown)
    QTest.keyClick(lanes, Qt.Key.Key_PageDown, Qt.KeyboardModifier.ControlModifier)
    assert lanes.selected.shape == lanes.keys.shapes[1]
    start = lanes.selected.time
    for key in (*[Qt.Key.Key_Right] * 12, *[Qt.Key.Key_Left] * 2):
        QTest.keyClick(lanes, key, SHIFT)
    assert (lanes.selected, lanes.marked.shape) == (None, lanes.keys.shapes[1])
    assert lanes.marked.start == start
    assert lanes.marked.end == pytest.approx(start + 10 / lanes.keys.animation.rate)
    curve = lanes.keys.curve_of(lanes.marked.shape)
    middle = start + 5 / lanes.keys.animation.rate
    QTest.keyClick(lanes, Qt.Key.Key_Up, SHIFT)
    raised = lanes.keys.curve_of(lanes.marked.shape)
    assert np.interp(middle, raised.times, raised.shown) > np.interp(middle, curve.times, curve.shown) + 0.05
    assert desktop.preset.undo_stack.undoText() == "raise keys"


def test_keys_are_saved_beside_the_sound_found_again_and_exported(desktop, window, lanes, recording, tmp_path, qtbot):
    _, place = point_in(lanes, "jawOpen")
    drag(lanes, place, place - QPoint(0, 30), Qt.KeyboardModifier.NoModifier)
    layer = lanes.keys.layer
    in_use = desktop.talking.in_use
    assert in_use.keys == {recording: layer}
    panel = window.talk.key_panel
    assert panel.save.isEnabled()
    panel.save.click()
    assert not panel.save.isEnabled()
    saved = read_keys(keys_beside(recording))
    assert saved.curve_of("jawOpen").offsets == pytest.approx(layer.curve_of("jawOpen").offsets, abs=1e-5)
    found = {}
    for name, keys in (("plain", None), ("edited", {})):
        order = ExportOrder("curves-json", desktop.preset.preset, in_use.options, keys=keys)
        with work_of(with_texts(order, [recording])).opened() as act:
            act(Job(recording, tmp_path / f"{name}.json"), say_nothing, no_progress)
        found[name] = read_curves(tmp_path / f"{name}.json").weights
    assert np.any(found["plain"] != found["edited"])
    desktop.session.open(CARDS)
    assert lanes.keys.layer == NO_KEYS
    desktop.session.open(recording)
    assert lanes.keys.layer == saved


def test_what_is_made_of_the_demo_stays_out_of_the_folder_of_the_program(desktop, settings, tmp_path):
    desktop.session.open(DEMO)
    layer = KeyLayer({"jawOpen": KeyCurve(np.array([0.1, 0.2, 0.3]), np.array([0, 0.5, 0.0]))})
    desktop.talking.keys.put(layer)
    assert desktop.talking.keys.save()
    assert not keys_beside(DEMO).exists()
    kept = presets_folder().with_name(keys_beside(DEMO).name)
    assert kept.is_file()
    desktop.session.open(CARDS)
    desktop.session.open(DEMO)
    assert desktop.talking.keys.layer == layer
    desktop.files.show = answers = FileAnswers(tmp_path / "demo.TextGrid")
    assert desktop.window.talk_parts.dialogs.ask_save_words() is False  # there are none yet
    assert answers.suggested == [kept.with_name("demo.TextGrid")]
    dialog = ExportDialog(desktop.preset.preset, Channel.MIX, [DEMO], settings, desktop.window)
    assert dialog.folder.text() == str(kept.parent)
    dialog.queue.close()
    dialog.close()
    kept.unlink()


def test_unsaved_keys_are_asked_about(desktop, window, lanes, recording):
    _, place = point_in(lanes, "jawOpen")
    drag(lanes, place, place - QPoint(0, 30), Qt.KeyboardModifier.NoModifier)
    asked = answer("Cancel")
    desktop.session.open(CARDS)
    assert asked
    assert desktop.session.path == recording
    answer("Save")
    desktop.session.open(CARDS)
    assert keys_beside(recording).is_file()


def test_a_broken_file_of_keys_is_told_and_the_sound_opens(desktop, qtbot, recording, graphics):
    keys_beside(recording).write_text("format = 1")
    window = shown(desktop, qtbot, recording)
    assert desktop.session.path == recording
    assert "begins with format" in window.banner.label.text()
