"""Labels in the window: lanes that are looked at, chosen, dragged, renamed; errors; and questions about them."""

import shutil

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMessageBox

from phonemeanalyser.desktop.analyse.lanes.label_dialogs import FormatDialog, TiersDialog
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.session.label_tiers import ChosenLabel
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.widgets.lanes import Lane
from phonemeengine.labels.textgrid import Tier
from phonemeengine.labels.tiers import read_tiers, write_tiers
from phonemeengine.labels.utterance import RawLabel
from tests.desktop.hands import CARDS, FileAnswers, press, shown

TIERS = (
    Tier("phones", (RawLabel(0.5, 1.0, "o", ""), RawLabel(1.0, 1.5, "s", ""))),
    Tier("words", (RawLabel(0.5, 1.5, "os", ""),)),
)


@pytest.fixture
def window(desktop, qtbot, tmp_path):
    sound = tmp_path / "cards.flac"
    shutil.copy(CARDS, sound)
    write_tiers(TIERS, sound.with_suffix(".TextGrid"), duration=2.0)
    window = shown(desktop, qtbot, sound)
    qtbot.waitUntil(lambda: not desktop.session.whole.busy)
    desktop.session.view.show(TimeSpan(0.0, 2.0))
    return window


def place(view, tier, seconds):
    row = view.file_layout.label_rows()[tier]
    return QPoint(round(view.file_layout.x_of(seconds)), round(row.center().y()))


def send(view, kind, at, modifier):
    held = Qt.MouseButton.LeftButton
    place = QPointF(at)
    QApplication.sendEvent(view, QMouseEvent(kind, place, view.mapToGlobal(place), held, held, modifier))


def test_lanes_are_painted_a_click_chooses_and_a_drag_moves_the_boundary(desktop, window):
    view, labels = window.analysis.file.view, desktop.session.labels
    rows = view.file_layout.label_rows()
    assert list(rows) == [0, 1]
    assert view.file_layout.rows()[1].bottom() < rows[0].top() < rows[1].top() < view.file_layout.rows()[2].top()
    picture = view.grab().toImage()
    edge = round(view.file_layout.x_of(1.0))
    y = round(rows[0].top()) + 3
    assert picture.pixel(edge, y) != picture.pixel(edge + 5, y)
    for name in ("Rename Label", "Delete Label", "Merge with Next Label", "End Label at Cursor"):
        window.banner.show_error("")
        window.menus.actions[name].trigger()
        assert window.banner.label.text().startswith("No label is selected"), name
    desktop.session.view.select(TimeSpan(0.6, 0.9))
    window.menus.actions["Insert Label"].trigger()  # refused before a name is typed
    assert "is labelled from" in window.banner.label.text()
    assert not view.editor.isVisible()
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, pos=place(view, 0, 1.2))
    assert labels.chosen == ChosenLabel(0, 1)
    assert desktop.session.view.selection == TimeSpan(1.0, 1.5)
    QTest.mousePress(view, Qt.MouseButton.LeftButton, pos=place(view, 0, 1.0))
    for seconds in (1.05, 1.1, 1.2):
        QTest.mouseMove(view, place(view, 0, seconds))
    QTest.mouseRelease(view, Qt.MouseButton.LeftButton, pos=place(view, 0, 1.2))
    first, second = labels.tiers[0].raw_labels
    assert first.end == second.start == pytest.approx(1.2, abs=0.01)
    window.menus.actions["Save Labels"].trigger()
    assert read_tiers(labels.path)[0].raw_labels[0].end == pytest.approx(1.2, abs=0.01)
    assert [raw.name for raw in read_tiers(labels.path)[1].raw_labels] == ["os"]
    desktop.preset.undo_stack.undo()
    assert labels.tiers[0].raw_labels[0].end == 1.0
    assert labels.has_unsaved_changes
    desktop.preset.undo_stack.redo()


def test_labels_are_renamed_inserted_and_deleted_in_their_place(desktop, window, qtbot):
    view, labels = window.analysis.file.view, desktop.session.labels
    QTest.mouseDClick(view, Qt.MouseButton.LeftButton, pos=place(view, 0, 0.7))
    assert view.editor.text() == "o"
    QTest.keyClicks(view.editor, "u")
    QTest.keyClick(view.editor, Qt.Key.Key_Return)
    assert labels.tiers[0].raw_labels[0].name == "u"
    assert not view.editor.isVisible()
    desktop.session.view.select(TimeSpan(1.6, 1.8))
    press(window, Qt.Key.Key_I, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClicks(view.editor, "u")
    QTest.keyClick(view.editor, Qt.Key.Key_Return)
    assert labels.tiers[0].raw_labels[2].name == "u"
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, pos=place(view, 0, 0.7))
    window.menus.actions["Delete Label"].trigger()
    assert [raw.name for raw in labels.tiers[0].raw_labels] == ["s", "u"]
    for _ in range(3):
        desktop.preset.undo_stack.undo()
    assert not labels.has_unsaved_changes


def test_letters_name_the_chosen_label_tab_goes_on_and_enter_splits(desktop, window, qtbot):
    view, labels = window.analysis.file.view, desktop.session.labels
    view.setFocus()
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, pos=place(view, 0, 0.7))
    press(window, Qt.Key.Key_N)  # which is a shortcut where no label is chosen
    assert view.editor.text() == "n"
    QTest.keyClick(view.editor, Qt.Key.Key_Tab)
    assert view.editor.text() == "s"
    QTest.keyClick(view.editor, Qt.Key.Key_Escape)
    assert [raw.name for raw in labels.tiers[0].raw_labels] == ["n", "s"]
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, pos=place(view, 0, 1.2))
    assert desktop.session.source.position == pytest.approx(1.2, abs=0.01)
    QTest.keyClick(view, Qt.Key.Key_Return)
    assert [raw.name for raw in labels.tiers[0].raw_labels] == ["n", "s", "s"]
    assert labels.chosen == ChosenLabel(0, 2)
    press(window, Qt.Key.Key_J, Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier)
    assert [raw.name for raw in labels.tiers[0].raw_labels] == ["n", "s"]
    press(window, Qt.Key.Key_Down, Qt.KeyboardModifier.AltModifier)
    assert labels.chosen == ChosenLabel(1, 0)
    press(window, Qt.Key.Key_Escape)
    assert labels.chosen is None


def test_a_dragged_boundary_snaps_to_other_tiers_and_with_ctrl_it_does_not(desktop, window):
    view, labels = window.analysis.file.view, desktop.session.labels
    words = Tier("words", (RawLabel(0.5, 1.25, "o", ""),))
    labels.put(labels.state._replace(tiers=(TIERS[0], words)))
    start, near = place(view, 0, 1.0), place(view, 0, 1.25) - QPoint(4, 0)
    for ctrl, expected in (
        (Qt.KeyboardModifier.NoModifier, 1.25),
        (Qt.KeyboardModifier.ControlModifier, view.file_layout.time_at(near.x())),
    ):
        send(view, QEvent.Type.MouseButtonPress, start, ctrl)
        send(view, QEvent.Type.MouseMove, near, ctrl)
        send(view, QEvent.Type.MouseButtonRelease, near, ctrl)
        assert labels.tiers[0].raw_labels[0].end == pytest.approx(expected, abs=1e-6)
        desktop.preset.undo_stack.undo()


def test_errors_are_gone_through_by_key(desktop, window):
    errors = desktop.session.labels.errors(desktop.session.whole.tracks)
    assert errors
    press(window, Qt.Key.Key_N)
    assert desktop.session.view.selection == TimeSpan(errors[0].start, errors[0].end)
    assert desktop.session.source.position == pytest.approx(errors[0].seen_at, abs=1e-3)
    assert f"recognised as {sound_name(errors[0].recognised)}" in window.banner.label.text()
    newest = desktop.session.results.history.newest  # the frame that the decision is about
    assert newest.times[-1] > errors[0].start
    assert newest.phonemes[-1] == errors[0].recognised
    for _ in errors:
        press(window, Qt.Key.Key_N)
    assert "No error after" in window.banner.label.text()
    press(window, Qt.Key.Key_N, Qt.KeyboardModifier.ShiftModifier)
    expected = errors[-2] if len(errors) > 1 else errors[-1]
    assert desktop.session.view.selection.start == expected.start


def test_tiers_and_format_are_chosen_no_tier_is_shown_twice_and_doubt_is_explained(desktop, window):
    view, labels = window.analysis.file.view, desktop.session.labels
    tiers, form = TiersDialog(labels, window), FormatDialog(labels, window)
    assert [tiers.list.item(k).text() for k in range(2)] == ["phones (2 labels)", "words (1 labels)"]
    tiers.list.item(0).setCheckState(Qt.CheckState.Unchecked)
    tiers.says.setCurrentText("None")
    assert (tiers.shown(), tiers.said()) == ([1], None)
    assert (form.format.currentData(), form.loses.text()) == (".TextGrid", "Keeps everything.")
    form.format.setCurrentIndex(2)
    assert (form.format.currentData(), form.loses.text()) == (".txt", "Saves a copy without words.")
    for dialog in (tiers, form):
        dialog.deleteLater()
    spoken = [Lane(name) for name in ("Words", "Syllables", "Phones", "Units")]
    view.show_spoken(spoken)
    assert [lane.name for lane in view.file_layout.spoken_shown()] == ["Units"]
    labels.put(labels.state._replace(tiers=(Tier("phones", (RawLabel(0.5, 1.0, "aɪ", ""),)),), shown=(0,)))
    assert [lane.name for lane in view.file_layout.spoken_shown()] == ["Words", "Syllables", "Units"]
    ((_, lane),) = view.file_layout.label_lanes()
    assert lane.doubtful == {0}
    assert "diphthong" in lane.tips[0]


def test_unsaved_labels_are_asked_about_before_they_go_and_others_are_loaded(desktop, window, hand, tmp_path):
    labels, path = desktop.session.labels, tmp_path / "other.csv"
    write_tiers([TIERS[0]], path)
    window.files.show = FileAnswers(path)
    window.menus.actions["Load Labels…"].trigger()
    assert labels.path == path
    labels.delete(ChosenLabel(0, 0))
    assert not desktop.session.open(CARDS)
    assert "Save the changes to the labels of cards.flac" in hand.texts[0]
    hand.press(QMessageBox.StandardButton.Discard)
    assert desktop.session.open(CARDS)
    assert labels.path == CARDS.with_suffix(".csv")
