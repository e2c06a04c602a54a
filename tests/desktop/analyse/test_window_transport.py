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


def test_buttons_and_keys_play_pause_stop_and_loop(desktop, window, qtbot):
    session, transport = desktop.session, window.transport
    before = icon_of(transport.play)
    click(transport.play)
    assert session.source.playing
    assert icon_of(transport.play) != before
    click(transport.play)
    assert not session.source.playing
    assert icon_of(transport.play) == before
    press(window, Qt.Key.Key_Space)
    assert session.source.playing
    qtbot.waitUntil(lambda: session.source.position > 0.1)
    click(transport.stop)
    assert not session.source.playing
    assert session.source.position == 0
    assert transport.time.text().startswith("0:00.0 /")
    session.seek(2)
    press(window, Qt.Key.Key_Escape)
    assert session.source.position == 0
    press(window, Qt.Key.Key_L)
    assert session.playback.loop
    assert transport.loop.isChecked()
    click(transport.loop)
    assert not session.playback.loop
    assert not window.menus.actions["Loop"].isChecked()
    texts = [label.text().strip() for label in (window.status.left, window.status.right)]
    assert texts[0].startswith("cards.flac: 44 100 Hz, mono")
    assert texts[1] == "No audio device (silent playback)"
    session.leave_sound()
    window.files.show = FileAnswers(CARDS)
    click(transport.open)
    assert session.path == CARDS


def test_keys_and_the_time_line_go_back_forth_and_home_and_the_volume_from_full_to_silent(desktop, window):
    source, line, volume = desktop.session.source, window.transport.position_slider, window.transport.volume
    for key, position in (
        (Qt.Key.Key_Right, 1),
        (Qt.Key.Key_Right, 2),
        (Qt.Key.Key_Left, 1),
        (Qt.Key.Key_Left, 0),
        (Qt.Key.Key_Left, 0),
    ):
        press(window, key, CONTROL)
        assert source.position == pytest.approx(position, abs=0.03)
    for share in (0.25, 0.9):
        click(line, 6 + share * (line.width() - 12))
        assert source.position == pytest.approx(share * source.duration, abs=0.02)
    press(window, Qt.Key.Key_Home)
    assert source.position == 0
    drag(line, 30, line.width() * 3)
    assert source.position == pytest.approx(source.duration, abs=0.011)
    drag(line, 300, -50)
    assert source.position == 0
    click(line, 6)
    press(window, Qt.Key.Key_Right)
    assert source.position == pytest.approx(1, abs=0.02)
    press(window, Qt.Key.Key_Left)
    assert source.position == pytest.approx(0, abs=0.02)
    drag(volume, volume.width() - 8, 2)
    assert desktop.session.playback.volume == -60
    assert volume.toolTip() == "Muted"
    press(window, Qt.Key.Key_Up, CONTROL)
    assert desktop.session.playback.volume == -57
    assert volume.value() == -57
    assert volume.toolTip() == "Playback volume -57 dB"
    press(window, Qt.Key.Key_Down, CONTROL)
    assert desktop.session.playback.volume == -60


def test_a_sound_that_ends_stops_at_the_beginning_unless_it_loops(desktop, window, qtbot):
    session = desktop.session
    session.seek(session.source.duration - 0.1)
    click(window.transport.play)
    qtbot.waitUntil(lambda: not session.source.playing)
    assert session.source.position == 0
    click(window.transport.loop)
    session.seek(session.source.duration - 0.1)
    click(window.transport.play)
    qtbot.waitUntil(lambda: 0.1 < session.source.position < 1)
    assert session.source.playing


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


def test_playing_moves_the_views_on_and_frozen_ones_stand_still_and_catch_up_after(desktop, window, qtbot):
    session, scrolled = desktop.session, window.analysis.scroll_view
    press(window, Qt.Key.Key_F)
    still = scrolled.grab().toImage()
    session.analyse_until(1)
    press(window, Qt.Key.Key_F)  # they catch up even when the sound has stopped
    qtbot.waitUntil(lambda: scrolled.grab().toImage() != still)
    session.playback.set_loop(True)  # however long the window takes, the sound goes on
    n = session.history.n
    click(window.transport.play)
    qtbot.waitUntil(lambda: session.history.n > n + 40)
    x, _ = window.analysis.spectrum.item.curves[0].getData()
    assert len(x) == 256
    assert window.transport.time.text() != "0:00.0 / 0:03.5"
    assert session.source.player.n_dropped == 0
    press(window, Qt.Key.Key_F)
    qtbot.waitUntil(lambda: pictures(window) == pictures(window))  # what was begun before the key has been drawn
    still = pictures(window)
    assert window.status.chips.words() == "Frozen"
    n = session.history.n
    qtbot.waitUntil(lambda: session.history.n > n + 30)
    assert pictures(window) == still
    press(window, Qt.Key.Key_F)
    qtbot.waitUntil(lambda: scrolled.grab().toImage() != still[0])
    assert window.status.chips.words() == ""


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
