"""What is played on, and how fast."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from phonemeanalyser.desktop.analyse.transport.transport import SPEEDS, next_speed
from phonemeengine.audio.stream import Device
from tests.desktop.hands import LEFT, shown

PHONES = Device("Phones", "ALSA", 0, 2, 48_000, is_default=False)


@pytest.fixture
def window(desktop, qtbot):
    return shown(desktop, qtbot)


def entry(window, text):
    return next(a for a in window.transport.output.menu().actions() if a.text() == text)


def test_slower_and_faster_by_keys_and_menu(desktop, window):
    session = desktop.session
    window.menus.actions["Slower"].trigger()
    assert session.playback.speed == 0.85
    assert window.transport.output.text() == "♪ 0 dB, 85 %"
    entry(window, "Speed 25 %").trigger()
    assert session.playback.speed == session.source.player.speed == 0.25
    window.menus.actions["Slower"].trigger()
    assert session.playback.speed == 0.25
    window.menus.actions["Faster"].trigger()
    assert session.playback.speed == 0.35
    assert entry(window, "Speed 35 %").isChecked()


def test_a_slow_sound_is_heard_to_its_end_and_recognised_as_a_fast_one(desktop, window, qtbot):
    session = desktop.session
    session.playback.set_speed(0.5)
    session.seek(session.source.duration - 0.3)
    seen = []
    session.analysed.connect(lambda blocks: seen.extend(p for b in blocks for p in b.phonemes.tolist()))
    session.play()
    qtbot.waitUntil(lambda: not session.source.playing, timeout=20_000)
    assert len(seen) >= 29


def test_another_device_is_opened_and_kept_for_the_next_start(desktop, window, qtbot):
    session, opened = desktop.session, []
    usual = session.playback.open_device
    session.playback.open_device = lambda n, label="": (opened.append(label), usual(n))[1]
    session.playback.outputs._show([PHONES])
    entry(window, "Phones · ALSA").trigger()
    qtbot.waitUntil(lambda: opened == ["Phones · ALSA"])
    window.save_state()
    assert window._settings.value("output") == "Phones · ALSA"
    session.playback.outputs._show([])
    assert entry(window, "Phones · ALSA (not connected)").isChecked()


def test_the_next_speed_is_the_nearest_one_on():
    assert next_speed(0.6, SPEEDS) == 0.5
    assert next_speed(0.25, SPEEDS) == 0.25


def test_frozen_is_a_chip_that_a_click_thaws(window):
    window.set_frozen(True)
    assert window.status.chips.words() == "Frozen"
    QTest.mouseClick(window.status.chips.frozen, LEFT)
    assert not window.redraw.frozen
    assert window.status.chips.words() == ""
    QTest.keyClick(window, Qt.Key.Key_F)
    assert window.redraw.frozen
