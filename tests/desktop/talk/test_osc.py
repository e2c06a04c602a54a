"""The mouth that is sent over the network, by OSC: what a receiver gets of a sound, of keys and of sliders."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.analyser import analyse_blocks
from phonemeengine.audio.files import SoundReader
from phonemeengine.mouth.animation import animation_of
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.movestate import Mode
from phonemeengine.mouth.performer import MOUTH_ALONE
from phonemeengine.mouth.table import load_table
from phonemeengine.mouth.transcript import transcript_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.desktop.conftest import STEP
from tests.desktop.hands import click, press
from tests.desktop.stage import AN_A, START, Stage
from tests.fakes.osc_receiver import Receiver
from tests.sounds import silence, vowel

# -- without a window ---------------------------------------------------------------------------------


def test_what_is_heard_is_sent_and_the_mouth_closes_at_the_end(
    stage: Stage, receiver: Receiver, qtbot: QtBot
) -> None:
    osc = stage.talking.osc
    osc.set_address(f"127.0.0.1:{receiver.address.port}")
    osc.set_on(True)
    qtbot.waitUntil(lambda: osc.words.startswith("Sending"))
    stage.play(1.0)
    qtbot.waitUntil(lambda: any(name == "a" for name, *_ in receiver.of("/phoneme")))
    qtbot.waitUntil(lambda: receiver.weights().get("jawOpen", 0.0) > 0.1)
    osc.set_on(False)
    qtbot.waitUntil(lambda: receiver.weights()["jawOpen"] < 0.01)
    assert osc.words == "Off"
    assert not stage.failed


def test_a_pause_holds_the_mouth_that_is_sent_as_it_holds_the_head(stage: Stage) -> None:
    talking = stage.talking
    stage.play(0.9)
    stage.session.pause()
    stage.wait(1.0)
    now = stage.now - START
    shown, sent = talking.performer.at(now).weights, talking.osc.performer.at(now).weights
    np.testing.assert_array_equal(sent, shown[: len(sent)])  # the head has a tongue, too
    assert shown[talking.table.movestates.index("jawOpen")] > 0.15


@pytest.mark.parametrize("address", ["nowhere", "127.0.0.1:99999", ":9", ""])
def test_a_wrong_address_switches_it_off_with_one_sentence(stage: Stage, address: str) -> None:
    stage.talking.osc.set_address(address)
    stage.talking.osc.set_on(True)
    (sentence,) = stage.failed
    assert "HOST:PORT" in sentence
    assert not stage.talking.osc.on


def test_a_receiver_that_nobody_knows_is_told(stage: Stage, qtbot: QtBot) -> None:
    stage.talking.osc.set_address("nobody.invalid:39539")
    stage.talking.osc.set_on(True)
    qtbot.waitUntil(lambda: bool(stage.failed))
    assert "nobody.invalid" in stage.failed[0]
    assert not stage.talking.osc.on


def test_another_set_is_sent_under_its_own_names(stage: Stage, receiver: Receiver, qtbot: QtBot) -> None:
    osc = stage.talking.osc
    osc.set_address(f"127.0.0.1:{receiver.address.port}")
    osc.set_on(True)
    osc.set_table("vrm")
    qtbot.waitUntil(lambda: "A" in receiver.weights())


@pytest.mark.parametrize("own_table", [False, True])
def test_a_receiver_moves_by_the_table_of_the_head_and_as_fast(stage: Stage, own_table: bool) -> None:
    talking, osc = stage.talking, stage.talking.osc
    osc.set_table("vrm" if own_table else "head")
    talking.set_table("five")
    talking.set_speed(3.0, 2.0)
    talking.set_random(False)
    talking.set_detail(Detail.TWO_STATES)
    shown, head = osc.performer, talking.performer
    assert talking.table.name == "Five mouth shapes"
    assert (shown.table.times, shown.table.motion) == (head.table.times, head.table.motion)
    assert shown.idle.detail is Detail.TWO_STATES
    assert shown.table.shapes == (load_table("vrm") if own_table else talking.table).shapes


def test_film_window_and_network_move_alike(stage: Stage, receiver: Receiver, qtbot: QtBot, tmp_path: Path) -> None:
    """The same sound as the frames of a film, on the head in the window, and as it arrives at a receiver."""
    sound = np.concatenate((AN_A, vowel((300, 2300, 3000), 0.4), silence(0.5)))
    stage.open(tmp_path, sound)
    path, session, talking = stage.session.path, stage.session, stage.talking
    assert path is not None
    with SoundReader(path) as reader:
        analyses = analyse_blocks(reader.blocks(SAMPLE_RATE), session.preset.in_force, pitch=True)
        utterance = transcript_of(analyses, "", reader.duration)
    film = animation_of(utterance, talking.table, SAMPLE_RATE / STEP, MOUTH_ALONE)
    talking.osc.set_address(f"127.0.0.1:{receiver.address.port}")
    talking.osc.set_on(True)
    qtbot.waitUntil(lambda: talking.osc.words.startswith("Sending"))
    session.play()
    qtbot.waitUntil(lambda: stage.outputs.last.n_written >= len(sound))
    shown, sent = [], []

    def look() -> None:
        if session.source.playing:
            now = stage.now - START
            qtbot.waitUntil(lambda: receiver.weights_at(now) is not None)  # older mouths may still be on their way
            weights = receiver.weights_at(now) or {}
            shown.append(talking.performer.at(now).weights[: len(film.movestates)])
            sent.append([weights.get(name, 0.0) for name in film.movestates])

    stage.play(3.0, look)
    expected = film.weights[1 : len(shown) + 1]
    assert len(shown) > 100
    np.testing.assert_allclose(shown, expected, atol=1e-5)
    np.testing.assert_allclose(sent, np.clip(expected, 0, 1), atol=1e-5)
    assert expected[:, film.movestates.index("jawOpen")].max() > 0.2


def test_a_receiver_that_is_switched_off_stays_so_whatever_moves_the_head(stage: Stage) -> None:
    stage.talking.set_table("five")
    stage.talking.set_speed(3.0, 2.0)
    assert not stage.talking.osc.on
    assert not stage.talking.osc._work.busy


def test_the_receiver_is_told_how_far_the_speech_goes_on(stage: Stage) -> None:
    talking, visemes = stage.talking, stage.talking.osc.performer.visemes
    talking.set_mode(Mode.INTERACT)
    talking.set_viseme("u", 0.25)
    assert (visemes.phonemes, visemes.speech) == ({Phoneme.U: 0.25}, 0.75)
    talking.press(Phoneme.A)
    assert (visemes.phonemes, visemes.speech) == ({Phoneme.A: 1.0}, 0.0)
    talking.release()
    assert (visemes.phonemes, visemes.speech) == ({Phoneme.U: 0.25}, 0.75)
    talking.clear_visemes()
    assert (visemes.phonemes, visemes.speech) == ({}, 1.0)


@pytest.mark.parametrize("asked_first", [False, True])
def test_keys_and_sliders_move_the_receivers_mouth_too(
    stage: Stage, receiver: Receiver, qtbot: QtBot, asked_first: bool
) -> None:
    osc, talking = stage.talking.osc, stage.talking
    osc.set_address(f"127.0.0.1:{receiver.address.port}")
    osc.set_table("vrm")
    if asked_first:
        talking.press(Phoneme.U)
    osc.set_on(True)
    qtbot.waitUntil(lambda: "U" in receiver.weights())
    talking.press(Phoneme.U)
    stage.wait(0.5)
    qtbot.waitUntil(lambda: receiver.weights()["U"] > 0.5)
    qtbot.waitUntil(lambda: ("u", 1.0) in receiver.of("/phoneme"))
    talking.release()
    talking.set_viseme("a", 0.5)
    stage.wait(0.5)
    qtbot.waitUntil(lambda: receiver.weights()["U"] < 0.01 and receiver.weights()["A"] > 0.2)
    qtbot.waitUntil(lambda: receiver.of("/viseme")[-1] == ("A", 0.5))
    talking.clear_visemes()
    stage.wait(0.5)
    qtbot.waitUntil(lambda: receiver.weights()["A"] < 0.01)
    osc.set_on(False)


# -- in the window ---------------------------------------------------------------------------------


def type_address(window: MainWindow, text: str) -> None:
    box = window.talk.osc.fields.address
    box.setFocus()
    box.selectAll()
    QTest.keyClicks(box, text)


def test_the_switch_sends_the_mouth_to_the_address_that_was_typed(window, desktop, qtbot, receiver):
    type_address(window, f"127.0.0.1:{receiver.address.port}")
    click(window.talk.osc.fields.switch)
    qtbot.waitUntil(lambda: window.talk.osc.fields.state.text().startswith("Sending"))
    press(window, Qt.Key.Key_Escape)
    desktop.session.play()
    qtbot.waitUntil(lambda: any(name == "a" for name, *_ in receiver.of("/phoneme")))
    qtbot.waitUntil(lambda: receiver.weights().get("jawOpen", 0.0) > 0.1)
    click(window.talk.osc.fields.switch)
    assert window.talk.osc.fields.state.text() == "Off"
    assert not window.talk.osc.fields.switch.isChecked()


def test_test_keys_and_sliders_reach_the_receiver_too(window, qtbot, receiver):
    type_address(window, f"127.0.0.1:{receiver.address.port}")
    click(window.talk.osc.fields.switch)
    qtbot.waitUntil(lambda: receiver.weights().get("jawOpen") == 0)
    window.talk.head.setFocus()
    QTest.keyPress(window.talk.head, Qt.Key.Key_A)
    qtbot.waitUntil(lambda: receiver.weights()["jawOpen"] > 0.5)
    qtbot.waitUntil(lambda: ("a", 1.0) in receiver.of("/phoneme"))
    QTest.keyRelease(window.talk.head, Qt.Key.Key_A)
    window.talk.keys.settling.timeout.emit()
    window.talk.visemes.sliders["u"].setValue(60)
    qtbot.waitUntil(lambda: receiver.weights()["mouthPucker"] > 0.3 > receiver.weights()["jawOpen"])
    qtbot.waitUntil(lambda: receiver.of("/viseme")[-1] == ("u", pytest.approx(0.6)))
    click(window.talk.visemes.leave)
    qtbot.waitUntil(lambda: receiver.weights()["mouthPucker"] < 0.01)


def test_a_wrong_address_is_told_and_the_switch_goes_back(window, desktop):
    type_address(window, "somewhere")
    click(window.talk.osc.fields.switch)
    assert "HOST:PORT" in window.banner.label.text()
    assert not window.talk.osc.fields.switch.isChecked()
