"""Which keys act where: single letters belong to the page Analyse, and typing to the control that has the focus."""

import re

import numpy as np
import pytest
import soundfile
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QDialog, QListView

from phonemeanalyser.desktop.help import ShortcutsDialog
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.desktop.calibrate.calibrating import Calibrator
from tests.desktop.hands import CARDS, DEMO, LEFT, answer, click, press, shown, type_number

pops_up = pytest.mark.qt_log_ignore("does not support", extend=True)  # lists without a display


def opened(box: QComboBox) -> QListView:
    """Click into a box, and give the list that opens."""
    QTest.mouseClick(box, LEFT)
    QApplication.processEvents()
    assert box.view().isVisible()
    return box.view()


@pops_up
def test_letters_typed_into_a_list_that_was_closed_search_in_it_and_record_nothing(desktop, qtbot):
    window, session = shown(desktop, qtbot), desktop.session
    window.show_page(2)
    box = window.talk.choices.findChild(QComboBox)
    box.blockSignals(True)  # what is chosen has no meaning here
    box.clear()
    box.addItems(["Choose", "Georgian", "German"])
    box.setFocus()
    QTest.keyClick(opened(box), Qt.Key.Key_Escape)
    assert QApplication.focusWidget() is box
    QTest.keyClicks(box, "Ger")
    assert box.currentText() == "German"
    assert not session.microphone.recording
    assert session.source.kind is SourceKind.FILE


def test_single_letters_of_the_menus_do_nothing_on_other_pages_where_the_list_of_keys_is_whole(desktop, qtbot):
    window, session, preset = shown(desktop, qtbot), desktop.session, desktop.preset
    keys, actions = window.menus.keys(), window.menus.actions
    for page in (1, 2):
        window.show_page(page)
        for key in (Qt.Key.Key_R, Qt.Key.Key_N, Qt.Key.Key_L, Qt.Key.Key_B, Qt.Key.Key_C, Qt.Key.Key_F, Qt.Key.Key_D):
            press(window, key)
        assert session.source.kind is SourceKind.FILE
        assert not session.playback.loop
        assert not preset.bypassed
        assert not window.redraw.frozen
    assert window.menus.keys() == keys
    window.show_page(0)
    press(window, Qt.Key.Key_L)
    press(window, Qt.Key.Key_B)
    assert session.playback.loop
    assert preset.bypassed
    repeated = [actions[name].autoRepeat() for name in ("Loop", "Play/Pause", "Forward 1 s")]
    assert repeated == [False, False, True]  # a key that is held switches once
    window.show_shortcuts()
    text = window.findChild(ShortcutsDialog).list.text()
    assert re.search("<td>Record&nbsp;.*?<td>R</td>", text)


def test_a_list_a_number_and_a_text_keep_what_is_typed_into_them(desktop, qtbot):
    window, session = shown(desktop, qtbot), desktop.session
    assert QApplication.focusWidget() is window.analysis.file.view
    number = next(iter(window.analysis.thresholds.rows.values())).number
    for control in (window.analysis.score.scope, number, window.transport.source):
        control.setFocus()
        assert QApplication.focusWidget() is control
        QTest.keyClicks(control, "lbrn")
        press(window, Qt.Key.Key_Delete)
    assert not session.playback.loop
    assert not desktop.preset.bypassed
    assert not session.microphone.recording
    type_number(number, "0.5")
    assert number.value() == 0.5
    press(window, Qt.Key.Key_Space)  # which writes no number
    assert session.source.playing


def test_record_asks_before_it_leaves_the_file_in_hand(desktop, qtbot):
    window, session = shown(desktop, qtbot), desktop.session
    asked = answer("Cancel")
    press(window, Qt.Key.Key_R)
    assert asked == ["Switch from cards.flac to the microphone and record?"]
    assert session.source.kind is SourceKind.FILE
    answer("Record")
    window.menus.actions["Record"].trigger()  # without a window manager, the window has the keyboard no more
    assert session.source.kind is SourceKind.MICROPHONE


def test_space_plays_after_a_control_that_had_the_focus_was_disabled(desktop, qtbot, tmp_path):
    """Qt gives the focus to the next control, which is the button of presets, and that takes Space for itself."""
    window = shown(desktop, qtbot)
    window.transport.channel.setEnabled(True)
    window.transport.channel.setFocus()
    window.dialogs.open_sound(DEMO)  # mono: there is nothing to choose from
    assert not window.transport.channel.isEnabled()
    assert QApplication.focusWidget() is window.analysis.file.view
    press(window, Qt.Key.Key_Space)
    assert desktop.session.source.playing


@pops_up
def test_space_plays_after_a_choice_with_the_mouse_and_after_one_was_hidden(desktop, qtbot):
    window = shown(desktop, qtbot)
    box = window.transport.source
    box.setFocus()
    view = opened(box)

    def is_closed() -> bool:
        """Click again where Qt took the click on the list, which has just opened, for half a double click."""
        if view.isVisible():
            QTest.mouseClick(view.viewport(), LEFT, pos=view.visualRect(view.model().index(0, 0)).center())
        return not view.isVisible()

    qtbot.waitUntil(is_closed)
    qtbot.waitUntil(lambda: QApplication.focusWidget() is window.analysis.file.view)
    window.transport.channel.setEnabled(True)
    window.transport.channel.setFocus()
    desktop.session.set_source(SourceKind.TONE)  # which has no channels to choose from
    assert window.transport.channel.isHidden()
    assert QApplication.focusWidget() is window.analysis
    press(window, Qt.Key.Key_Space)
    assert desktop.session.source.playing


def test_space_plays_after_a_file_without_the_channel_that_had_the_focus_was_opened(desktop, qtbot, tmp_path):
    many = tmp_path / "many.wav"
    soundfile.write(many, np.zeros((SAMPLE_RATE, 8), np.float32), SAMPLE_RATE)
    window = shown(desktop, qtbot, many)
    window.transport.channel.setFocus()
    dialog = QDialog(window)
    dialog.open()
    qtbot.waitUntil(dialog.isActiveWindow)
    desktop.session.open(CARDS)  # which has one channel
    dialog.reject()
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    qtbot.waitUntil(lambda: QApplication.focusWidget() is window.analysis.file.view)
    press(window, Qt.Key.Key_Space)
    assert desktop.session.source.playing
    assert not window.preset_box.list.isVisible()


def test_a_button_reached_with_tab_keeps_space_and_one_that_was_clicked_does_not_get_the_focus(desktop, qtbot):
    window = shown(desktop, qtbot)
    window.show_page(2)
    wireframe = window.talk.heads.wireframe
    click(wireframe)
    assert wireframe.isChecked()
    assert not wireframe.hasFocus()
    wireframe.setFocus(Qt.FocusReason.TabFocusReason)
    press(window, Qt.Key.Key_Space)
    assert not wireframe.isChecked()
    assert not desktop.session.source.playing


def test_letters_in_a_table_of_the_calibration_record_no_take(open_booth, mic):
    calibrator = Calibrator(open_booth(mic), mic)
    calibrator.keep(Phoneme.A)
    for control in (calibrator.page.workbench.variables.table, calibrator.page.takes.phoneme):
        control.setFocus()
        QTest.keyPress(control, Qt.Key.Key_A)
        assert calibrator.model.phoneme is None
        QTest.keyRelease(control, Qt.Key.Key_A)
