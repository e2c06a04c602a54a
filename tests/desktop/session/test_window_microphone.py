"""Listening by mouse and keyboard: what is heard is seen, and which microphone it is."""

from collections.abc import Callable

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.widgets.level_meter import words_of
from phonemeengine.audio.stream import Device
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import BIN_WIDTH, HOP
from tests.desktop.hands import CARDS, DEMO, ON_BIN, FileAnswers, TimeEyes, click, drag, press, settle
from tests.desktop.studio import DESK, HEADSET, Booth, Studio, choose
from tests.fakes.microphones import HandDrivenMicrophone, offline
from tests.fakes.players import SPEECH
from tests.sounds import noise, silence, tone, vowel

HEARD = SPEECH[: len(SPEECH) // HOP * HOP]
A = vowel((700, 1200, 2500), 0.4)

Open = Callable[..., Booth]


def entries(box: QComboBox) -> list[str]:
    return [box.itemText(k) for k in range(box.count())]


# -- what is heard is seen ----------------------------------------------------------------------------


def test_choosing_the_microphone_listens_and_space_lets_it_go_and_takes_it_again(
    open_booth: Open, mic: HandDrivenMicrophone
):
    again = HandDrivenMicrophone(name=DESK.label)
    booth = open_booth(mic, again)
    press(booth.window, Qt.Key.Key_Space)
    session, player, transport = booth.desktop.session, booth.desktop.session.source.player, booth.window.transport
    booth.listen()
    assert player is not None
    booth.until(lambda: not player._thread.is_alive())
    assert session.source.player is None
    booth.feed(mic, A)
    booth.go_to_view()
    press(booth.window, Qt.Key.Key_C)
    assert session.history.n == 0
    booth.feed(mic, A)
    assert session.history.n == 40  # listening goes on
    assert session.source.kind is SourceKind.MICROPHONE
    assert booth.window.windowTitle().startswith("Microphone - ")
    booth.until(lambda: booth.status.strip().startswith("Microphone: Desk · ALSA, 44 100 Hz"), mic)
    assert transport.microphone.isVisible()
    assert not any(of_file.isVisible() for of_file in (transport.position_slider, transport.loop, transport.volume))
    press(booth.window, Qt.Key.Key_Space)
    assert not session.source.playing
    booth.until(mic.closed.is_set)
    booth.until(lambda: "Microphone: not listening" in booth.status)
    click(transport.play)
    booth.feed(again, A)
    booth.until(lambda: "Microphone: Desk" in booth.status, again)


def test_a_sine_is_seen_at_its_frequency_and_the_level_meter_holds_and_clips(booth: Booth, mic: HandDrivenMicrophone):
    listener = booth.studio.model.listener
    booth.feed(mic, tone(1000, 0.2, 0.25))
    assert listener.level.held == pytest.approx(0.25, abs=0.001)
    assert listener.level.clipped_ago is None
    booth.feed(mic, tone(1000, 0.1, 1.0))
    assert words_of(listener.level.clipped_ago) == "CLIPPED"
    assert listener.level.held == pytest.approx(1, abs=0.001)
    booth.feed(mic, silence(0.5))
    assert listener.level.peak < 1
    booth.feed(mic, tone(ON_BIN, 1.0, 0.5))
    booth.window.redraw.refresh_all()
    x, y = booth.window.analysis.spectrum.item.curves[0].getData()
    assert x[np.argmax(y)] == pytest.approx(ON_BIN, abs=BIN_WIDTH)
    assert TimeEyes(booth.window).brightest(-0.3) == pytest.approx(ON_BIN, abs=2 * BIN_WIDTH)
    assert booth.window.analysis.phoneme.meters["vol"] == "0.500"
    assert booth.window.analysis.phoneme.meters["zc"] == f"{2 * ON_BIN * 2048 / 44_100:.0f}"


def test_the_phonemes_are_those_of_the_analysis_of_a_file_until_a_threshold_is_dragged(
    booth: Booth, mic: HandDrivenMicrophone
):
    booth.feed(mic, HEARD)
    booth.window.redraw.refresh_all()
    history = booth.desktop.session.history
    found = history.phonemes[history.indices(0, history.n)]
    expected = offline(HEARD, booth.desktop.preset.in_force).phonemes[: len(found)]
    np.testing.assert_array_equal(found, expected)
    assert len(np.unique(found)) > 3
    assert booth.window.analysis.phoneme.phoneme == Phoneme(int(expected[-1]))
    assert booth.frames == list(range(len(expected)))
    booth.feed(mic, A)
    assert history.phonemes[history.n - 1] == Phoneme.A
    n = history.n
    for name in ("silence_energy", "silence_max_energy"):
        slider = booth.window.analysis.thresholds.rows[name].slider
        drag(slider, slider.width() / 2, slider.width() + 50)
    booth.feed(mic, A)
    phonemes = history.phonemes[history.indices(0, history.n)]
    assert phonemes[n - 15] == Phoneme.A
    assert set(phonemes[-20:]) == {Phoneme.SILENCE}


# -- between the sources ------------------------------------------------------------------------------


def test_back_at_the_file_it_stands_where_it_was_left(booth: Booth, mic: HandDrivenMicrophone):
    choose(booth.window.transport.source, "File")
    booth.desktop.session.seek(1.5)
    booth.listen()
    choose(booth.window.transport.source, "File")
    session = booth.desktop.session
    assert session.path == CARDS
    assert session.source.position == pytest.approx(1.5, abs=0.01)
    assert not session.source.playing
    booth.until(mic.closed.is_set)
    assert booth.window.transport.position_slider.isVisible()
    assert booth.window.transport.time.text().startswith("0:01.5 / ")


def test_opening_a_file_while_it_listens_lets_the_microphone_go(booth: Booth, mic: HandDrivenMicrophone):
    booth.feed(mic, A)
    booth.window.files.show = FileAnswers(DEMO)
    press(booth.window, Qt.Key.Key_O, Qt.KeyboardModifier.ControlModifier)
    assert booth.desktop.session.source.kind is SourceKind.FILE
    assert booth.window.transport.source.currentText() == "File"
    booth.until(mic.closed.is_set)
    assert booth.desktop.session.path == DEMO


@pytest.mark.long
@pytest.mark.usefixtures("open_own_booth")
def test_another_theme_goes_on_listening(booth: Booth, mic: HandDrivenMicrophone):
    booth.feed(mic, A)
    old = booth.window
    booth.desktop.set_theme("dark" if old.theme.name == "light" else "light")
    assert booth.window is not old
    assert booth.window.transport.source.currentText() == "Microphone"
    assert not mic.closed.is_set()
    booth.feed(mic, A)
    assert booth.frames == list(range(len(booth.frames)))


# -- which microphone ---------------------------------------------------------------------------------


def test_device_channel_and_rate_are_opened_as_chosen_and_a_device_that_has_gone_is_marked(booth: Booth):
    bar, studio = booth.window.transport.microphone, booth.studio
    booth.until(lambda: bar.device.count() == 3)
    assert entries(bar.device) == ["Default microphone", DESK.label, HEADSET.label]
    studio.devices.append(Device("Interface", "JACK", 4, 4, 96_000, is_default=False))
    press(booth.window, Qt.Key.Key_F5)
    booth.until(lambda: bar.device.count() == 4)
    assert bar.device.currentText() == "Default microphone"
    studio.devices.append(Device("Webcam", "ALSA", 1, 0, 16_000, is_default=False))
    click(bar.again)
    booth.until(lambda: "Webcam · ALSA" in entries(bar.device))
    choose(bar.device, DESK.label)
    assert entries(bar.channel) == ["Channel 1", "Channel 2", "1 + 2"]
    choose(bar.channel, "1 + 2")
    choose(bar.rate, "48 000 Hz")
    booth.until(lambda: studio.openers.asked[-1].rate == 48_000)
    assert studio.openers.asked[-1] == studio.model.choice
    assert (studio.model.choice.label, studio.model.choice.channel) == (DESK.label, 0)
    choose(bar.device, HEADSET.label)
    assert entries(bar.channel) == ["Channel 1"]
    assert bar.channel.currentText() == "Channel 1"
    studio.devices.remove(HEADSET)
    click(bar.again)
    booth.until(lambda: bar.device.currentText() == f"{HEADSET.label} (not connected)")
    studio.devices.append(HEADSET)
    click(bar.again)
    booth.until(lambda: bar.device.currentText() == HEADSET.label)


def test_the_second_channel_is_heard(open_booth: Open):
    stereo = HandDrivenMicrophone(n_channels=2)
    booth = open_booth(stereo)
    booth.listen()
    booth.until(lambda: booth.window.transport.microphone.device.count() == 3)
    booth.feed(stereo, np.stack((tone(ON_BIN, 0.3), silence(0.3)), axis=1))
    assert booth.desktop.session.history.newest.features.frame(0)["volume"] > 0.9


def test_another_buffer_is_asked_of_the_microphone_at_once(open_booth: Open):
    first, second = HandDrivenMicrophone(), HandDrivenMicrophone(name="the same again")
    booth = open_booth(first, second)
    booth.listen()
    booth.feed(first, noise(0.2))
    booth.window.transport.record.buffers[0.04].trigger()
    booth.until(lambda: len(booth.studio.openers.asked) == 2)
    booth.feed(second, noise(0.2))
    assert [choice.latency for choice in booth.studio.openers.asked] == [0.08, 0.04]
    assert booth.studio.model.listener.lost_seconds == 0


@pytest.mark.usefixtures("open_own_booth")
def test_the_choice_survives_a_restart_and_nothing_is_opened_at_the_start(booth: Booth, qtbot, qapp, tmp_path):
    bar = booth.window.transport.microphone
    booth.until(lambda: bar.device.count() == 3)
    for box, text in ((bar.device, DESK.label), (bar.channel, "Channel 2"), (bar.rate, "48 000 Hz")):
        choose(box, text)
    booth.window.transport.record.else_default.trigger()
    booth.window.transport.record.kinds[".flac"].trigger()
    booth.window.transport.record.buffers[0.2].trigger()
    booth.window.transport.record.phonemes.trigger()
    booth.window.transport.record.gaps.trigger()
    assert booth.window.close()
    booth.settings.sync()
    studio = Studio(tmp_path)
    again = Desktop(qapp, booth.settings, microphone=studio.model)
    again.window.show()
    settle()
    assert studio.openers.asked == []
    assert again.session.source.kind is SourceKind.FILE
    assert studio.model.choice == booth.studio.model.choice
    assert studio.model.choice.latency == 0.2
    assert (studio.model.suffix, studio.model.with_phonemes, studio.model.fill_gaps) == (".flac", True, True)
    bar = again.window.transport.microphone
    assert bar.device.currentText() == f"{DESK.label} (not connected)"
    assert (bar.channel.currentText(), bar.rate.currentText()) == ("Channel 2", "48 000 Hz")
    again.close()
