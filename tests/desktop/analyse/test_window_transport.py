"""Playing by mouse and keyboard."""

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QImage

from phonemeengine.settings import Channel
from tests.desktop.hands import CARDS, FileAnswers, TimeEyes, click, drag, press, shown, wav
from tests.sounds import silence, tone

CONTROL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def window(desktop, qtbot):
    return shown(desktop, qtbot)


def icon_of(button) -> QImage:
    return button.icon().pixmap(20, 20).toImage()


def test_a_click_on_play_plays_and_another_one_pauses(desktop, window):
    before = icon_of(window.transport.play)
    click(window.transport.play)
    assert desktop.session.source.playing
    assert icon_of(window.transport.play) != before
    click(window.transport.play)
    assert not desktop.session.source.playing
    assert icon_of(window.transport.play) == before


def test_playing_moves_the_views_on(desktop, window, qtbot):
    click(window.transport.play)
    qtbot.waitUntil(lambda: desktop.session.history.n > 40)
    x, _ = window.analysis.spectrum.item.curves[0].getData()
    assert len(x) == 256
    assert window.transport.time.text() != "0:00.0 / 0:03.5"
    assert desktop.session.source.position > 0.3
    assert desktop.session.source.player.n_dropped == 0


def test_stop_goes_to_the_beginning(desktop, window, qtbot):
    click(window.transport.play)
    qtbot.waitUntil(lambda: desktop.session.source.position > 0.1)
    click(window.transport.stop)
    assert not desktop.session.source.playing
    assert desktop.session.source.position == 0
    assert window.transport.time.text().startswith("0:00.0 /")


def test_space_plays_and_escape_stops(desktop, window, qtbot):
    press(window, Qt.Key.Key_Space)
    assert desktop.session.source.playing
    press(window, Qt.Key.Key_Space)
    assert not desktop.session.source.playing
    desktop.session.seek(2)
    press(window, Qt.Key.Key_Escape)
    assert desktop.session.source.position == 0


def test_keys_go_back_forth_and_home(desktop, window):
    press(window, Qt.Key.Key_Right, CONTROL)
    assert desktop.session.source.position == pytest.approx(1, abs=0.02)
    press(window, Qt.Key.Key_Right, CONTROL)
    press(window, Qt.Key.Key_Left, CONTROL)
    assert desktop.session.source.position == pytest.approx(1, abs=0.03)
    press(window, Qt.Key.Key_Home)
    assert desktop.session.source.position == 0
    press(window, Qt.Key.Key_Left, CONTROL)
    assert desktop.session.source.position == 0


def test_l_loops_and_the_button_shows_it(desktop, window):
    press(window, Qt.Key.Key_L)
    assert desktop.session.playback.loop
    assert window.transport.loop.isChecked()
    click(window.transport.loop)
    assert not desktop.session.playback.loop
    assert not window.menus.actions["Loop"].isChecked()


def test_a_loop_begins_again_at_the_end(desktop, window, qtbot):
    click(window.transport.loop)
    desktop.session.seek(desktop.session.source.duration - 0.1)
    click(window.transport.play)
    qtbot.waitUntil(lambda: 0.1 < desktop.session.source.position < 1)
    assert desktop.session.source.playing


def test_a_sound_that_ends_stops_at_the_beginning(desktop, window, qtbot):
    desktop.session.seek(desktop.session.source.duration - 0.1)
    click(window.transport.play)
    qtbot.waitUntil(lambda: not desktop.session.source.playing)
    assert desktop.session.source.position == 0


def test_a_click_on_the_time_line_goes_there(desktop, window):
    line = window.transport.position_slider
    for share in (0.25, 0.9):
        click(line, 6 + share * (line.width() - 12))
        assert desktop.session.source.position == pytest.approx(share * desktop.session.source.duration, abs=0.02)


def test_a_drag_along_the_time_line_ends_where_the_mouse_is(desktop, window):
    line = window.transport.position_slider
    drag(line, 30, line.width() * 3)
    assert desktop.session.source.position == pytest.approx(desktop.session.source.duration, abs=0.011)
    drag(line, 300, -50)
    assert desktop.session.source.position == 0


def test_arrow_keys_move_the_time_line_once_it_has_the_focus(desktop, window):
    click(window.transport.position_slider, 6)
    press(window, Qt.Key.Key_Right)
    assert desktop.session.source.position == pytest.approx(1, abs=0.02)
    press(window, Qt.Key.Key_Left)
    assert desktop.session.source.position == pytest.approx(0, abs=0.02)


def test_the_volume_slider_goes_from_full_to_silent(desktop, window):
    volume = window.transport.volume
    drag(volume, volume.width() - 8, 2)
    assert desktop.session.playback.volume == -60
    assert volume.toolTip() == "Muted"
    press(window, Qt.Key.Key_Up, CONTROL)
    assert desktop.session.playback.volume == -57
    assert volume.value() == -57
    assert volume.toolTip() == "Playback volume -57 dB"
    press(window, Qt.Key.Key_Down, CONTROL)
    assert desktop.session.playback.volume == -60


def test_the_channel_box_chooses_what_is_analysed(desktop, qtbot, tmp_path):
    both = np.stack((tone(1000, 1.0, 0.5), tone(1000, 1.0, 0.1)), axis=1)
    window = shown(desktop, qtbot, wav(tmp_path, both))
    levels = {}
    window.transport.channel.setFocus()
    for channel in Channel:
        assert desktop.session.channel is channel
        assert window.transport.channel.currentText().lower() == channel.value
        desktop.session.clear()
        desktop.session.analyse_until(0.5)
        levels[channel] = desktop.session.history.extremes("volume")[0]
        press(window, Qt.Key.Key_Down)
    assert levels == pytest.approx({Channel.MIX: 0.3, Channel.LEFT: 0.5, Channel.RIGHT: 0.1}, abs=0.01)


def test_the_channel_changes_while_it_plays(desktop, qtbot, tmp_path):
    both = np.stack((tone(1000, 20.0, 0.5), silence(20.0)), axis=1)
    window = shown(desktop, qtbot, wav(tmp_path, both))
    click(window.transport.play)
    qtbot.waitUntil(lambda: desktop.session.source.position > 0.3)
    window.transport.channel.activated.emit(window.transport.channel.findText("Right"))
    assert desktop.session.source.playing
    assert desktop.session.source.position > 0.25
    desktop.session.clear()
    qtbot.waitUntil(lambda: desktop.session.history.n > 5)
    assert desktop.session.history.extremes("volume")[0] == 0


def test_the_status_bar_says_what_plays_where(desktop, window):
    texts = [label.text() for label in (window.status.left, window.status.right)]
    assert texts[0].strip().startswith("cards.flac: 44 100 Hz, mono")
    assert texts[1].strip() == "No audio device (silent playback)"


def test_without_a_sound_nothing_can_be_played(desktop, qtbot):
    window = shown(desktop, qtbot, None)
    for widget in (window.transport.play, window.transport.stop, window.transport.position_slider):
        assert not widget.isEnabled()
    press(window, Qt.Key.Key_Space)
    press(window, Qt.Key.Key_Right, CONTROL)
    assert not desktop.session.source.playing
    assert window.transport.time.text() == "0:00.0 / 0:00.0"


def pictures(window) -> tuple[QImage, QImage]:
    QCoreApplication.processEvents()
    return window.analysis.scroll_view.grab().toImage(), window.analysis.spectrum.grab().toImage()


def test_frozen_views_stand_still_while_the_sound_goes_on_and_catch_up_after(desktop, window, qtbot):
    desktop.session.playback.set_loop(True)  # however long the window takes, the sound goes on
    click(window.transport.play)
    qtbot.waitUntil(lambda: desktop.session.history.n > 20)
    press(window, Qt.Key.Key_F)
    qtbot.waitUntil(lambda: pictures(window) == pictures(window))  # what was begun before the key has been drawn
    still = pictures(window)
    assert window.status.chips.words() == "Frozen"
    n = desktop.session.history.n
    qtbot.waitUntil(lambda: desktop.session.history.n > n + 30)
    assert pictures(window) == still
    press(window, Qt.Key.Key_F)
    qtbot.waitUntil(lambda: window.analysis.scroll_view.grab().toImage() != still[0])
    assert window.status.chips.words() == ""


def test_frozen_views_catch_up_even_when_the_sound_has_stopped(desktop, window, qtbot):
    press(window, Qt.Key.Key_F)
    still = window.analysis.scroll_view.grab().toImage()
    desktop.session.analyse_until(2)
    press(window, Qt.Key.Key_F)
    qtbot.waitUntil(lambda: window.analysis.scroll_view.grab().toImage() != still)


def test_clear_empties_the_views(desktop, window):
    desktop.session.analyse_until(2)
    window.redraw.refresh_all()
    eyes = TimeEyes(window)
    assert eyes.colour(eyes.sonagram, -1, 1000) != eyes.colour(eyes.sonagram, -3, 1000)
    press(window, Qt.Key.Key_C)
    assert desktop.session.history.n == 0
    assert desktop.session.averages.n_frames == 0
    eyes = TimeEyes(window)
    assert eyes.colour(eyes.sonagram, -1, 1000) == eyes.colour(eyes.sonagram, -3, 1000)
    assert window.analysis.thresholds.rows["silence_energy"].slider.live is None
    for view in (window.analysis.spectrum, window.analysis.averaged, window.analysis.waveform):
        x, _ = view.item.curves[0].getData()
        assert x is None or len(x) == 0


def test_the_window_opens_the_sound_that_is_asked_for(desktop, window):
    window.files.show = FileAnswers(CARDS)
    click(window.transport.open)
    assert desktop.session.path == CARDS
