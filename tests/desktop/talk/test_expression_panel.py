"""Expressions on the page of the head: sliders, what speech leaves of them, and what the network is sent."""

import socket
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from pythonosc.udp_client import SimpleUDPClient

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.talk.expression.expression_panel import ExpressionPanel
from phonemeanalyser.desktop.talk.head.movestate_bars import MovestateBars
from phonemeanalyser.desktop.theme import LIGHT
from phonemeengine.analyser import Analyser
from phonemeengine.mouth.exports.livelink import lines_of
from phonemeengine.presets.files import THESIS_PRESET, load_preset
from tests.desktop.stage import AN_A, Stage
from tests.engine.performance.faces import ramp
from tests.fakes.osc_receiver import Receiver
from tests.sounds import vowel

SMILE, BROW = "mouthSmileLeft", "browOuterUpLeft"


@pytest.fixture
def panel(stage: Stage, qtbot: QtBot) -> ExpressionPanel:
    panel = ExpressionPanel(stage.talking, LIGHT)
    qtbot.addWidget(panel)
    return panel


def shown(stage: Stage, name: str) -> float:
    return stage.talking.percentages[name]


def test_a_slider_moves_the_face_while_nobody_speaks(stage: Stage, panel: ExpressionPanel) -> None:
    panel.sliders["surprise"].setValue(50)
    stage.wait(0.1)
    assert shown(stage, BROW) == pytest.approx(40, abs=1)
    panel.neutral.click()
    stage.wait(0.1)
    assert shown(stage, BROW) == pytest.approx(0, abs=1)
    assert panel.sliders["surprise"].value() == 0


def test_speech_holds_a_smile_back_and_the_meter_tells(stage: Stage, panel: ExpressionPanel) -> None:
    panel.sliders["smile"].setValue(100)
    seen: list[tuple[int, float]] = []

    def look() -> None:
        panel.refresh()
        seen.append((panel.meter.value(), shown(stage, SMILE)))

    stage.play(10, look)
    reduced, free = [smile for held, smile in seen if held == 100], [smile for held, smile in seen if held == 0]
    assert max(free) == pytest.approx(75, abs=1)
    assert min(reduced) < 45
    stage.wait(1.5, look)
    assert panel.meter.value() == 0


def test_a_smile_stays_while_the_table_changes(stage: Stage, panel: ExpressionPanel) -> None:
    panel.sliders["smile"].setValue(100)
    stage.talking.set_speed(2.0, 2.0)
    stage.wait(0.1)
    assert shown(stage, SMILE) == pytest.approx(75, abs=1)


def test_priority_keeps_expressions_off_the_jaw(stage: Stage, panel: ExpressionPanel) -> None:
    panel.sliders["surprise"].setValue(100)
    stage.wait(0.1)
    assert stage.jaw == pytest.approx(35, abs=1)
    panel.priority.setValue(100)
    stage.wait(0.1)
    assert stage.jaw == pytest.approx(0, abs=1)
    assert shown(stage, BROW) == pytest.approx(80, abs=1)


def test_the_network_is_sent_the_expression_too(stage: Stage, panel: ExpressionPanel, qtbot: QtBot) -> None:
    receiver = Receiver()
    panel.sliders["surprise"].setValue(100)
    stage.talking.osc.set_address(f"127.0.0.1:{receiver.address.port}")
    stage.talking.osc.set_on(True)
    qtbot.waitUntil(lambda: receiver.weights().get(BROW, 0.0) > 0.7, timeout=60_000)
    stage.talking.osc.set_on(False)
    receiver.close()


# -- from files and other programs --------------------------------------------------------------------


def free_port() -> int:
    """A port at which nobody listens."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as door:
        door.bind(("127.0.0.1", 0))
        return int(door.getsockname()[1])


def recorded_brow(folder: Path, seconds: float = 2.0) -> Path:
    """Write a recording of a brow that rises from 0 to 1."""
    track = ramp(round(60 * seconds) + 1, BROW)
    (folder / "brow.csv").write_text("".join(lines_of(track)), encoding="utf-8")
    return folder / "brow.csv"


def opened(stage: Stage, path: Path) -> None:
    stage.talking.expression.set_file(path)
    stage.qtbot.waitUntil(lambda: not stage.talking.expression._work.busy)


def test_a_recorded_face_goes_with_the_sound(stage: Stage, panel: ExpressionPanel, tmp_path: Path) -> None:
    opened(stage, recorded_brow(tmp_path))
    assert panel.file.text() == "brow.csv ×"
    seen = []
    stage.play(0.5, lambda: seen.append((stage.session.source.position, shown(stage, BROW))))
    assert all(brow == pytest.approx(50 * position, abs=2) for position, brow in seen[5:])
    stage.session.pause()
    before = shown(stage, BROW)
    stage.wait(1.0)
    assert shown(stage, BROW) == pytest.approx(before, abs=1)
    stage.session.seek(1.4)
    stage.wait(0.1)
    assert shown(stage, BROW) == pytest.approx(70, abs=2)
    panel.file.click()
    stage.wait(0.1)
    assert shown(stage, BROW) == pytest.approx(0, abs=1)
    assert panel.file.text() == "Load Face Capture…"


def test_what_is_no_recorded_face_is_refused_in_a_sentence(stage: Stage, tmp_path: Path) -> None:
    (tmp_path / "no.csv").write_text("a,b\n1,2\n", encoding="utf-8")
    opened(stage, tmp_path / "no.csv")
    (sentence,) = stage.failed
    assert sentence.startswith("no.csv: this is no recording of Live Link Face")
    assert stage.talking.expression.path is None


def test_other_programs_move_the_face_and_it_is_said_what_is_heard(
    stage: Stage, panel: ExpressionPanel, qtbot: QtBot
) -> None:
    heard = stage.talking.expression.input
    heard.set_address(f"127.0.0.1:{free_port()}")
    panel.osc.switch.click()
    qtbot.waitUntil(lambda: heard.stream is not None)
    panel.refresh()
    assert panel.osc.state.text() == "Waiting for messages"
    assert heard.stream is not None
    with SimpleUDPClient("127.0.0.1", heard.stream.port) as sender:

        def arrived() -> bool:
            sender.send_message("/expression", ["surprise", 0.5])
            sender.send_message("/VMC/Ext/Blend/Val", ["cheekPuff", 0.3])
            stage.talking.tick()
            return shown(stage, "cheekPuff") > 25

        qtbot.waitUntil(arrived)
    assert shown(stage, BROW) == pytest.approx(40, abs=1)
    panel.refresh()
    assert panel.osc.state.text() == "Receiving surprise and 1 more"
    panel.sliders["surprise"].setValue(25)
    stage.wait(0.1)
    assert shown(stage, BROW) == pytest.approx(60, abs=1)
    panel.sliders["surprise"].setValue(0)
    panel.osc.switch.click()
    stage.wait(0.1)
    assert shown(stage, BROW) == pytest.approx(0, abs=1)
    assert panel.osc.state.text() == "Off"


@pytest.mark.parametrize("address", ["nowhere", "127.0.0.1:99999", "nobody.invalid:39540"])
def test_a_place_where_nobody_can_be_heard_switches_it_off(
    stage: Stage, panel: ExpressionPanel, qtbot: QtBot, address: str
) -> None:
    heard = stage.talking.expression.input
    heard.set_address(address)
    panel.osc.switch.click()
    qtbot.waitUntil(lambda: bool(stage.failed))
    assert len(stage.failed) == 1
    assert not heard.on
    assert not panel.osc.switch.isChecked()


@pytest.mark.usefixtures("own_desktop")
def test_recording_and_address_are_there_again_at_the_next_start(
    desktop: Desktop, qapp: QApplication, settings: QSettings, no_microphone: Microphone, qtbot: QtBot, tmp_path: Path
) -> None:
    expression = desktop.talking.expression
    expression.set_file(recorded_brow(tmp_path))
    address = f"127.0.0.1:{free_port()}"
    expression.input.set_address(address)
    expression.input.set_on(True)
    qtbot.waitUntil(lambda: expression.path is not None and expression.input.stream is not None)
    desktop.save()
    expression.input.close()
    again = Desktop(qapp, settings, microphone=no_microphone)
    restored = again.talking.expression
    qtbot.waitUntil(lambda: restored.path == tmp_path / "brow.csv" and restored.input.stream is not None)
    assert restored.input.address == address
    again.close()


def test_bars_show_what_an_expression_moves_though_no_shape_of_the_table_does(
    stage: Stage, panel: ExpressionPanel, qtbot: QtBot, tmp_path: Path
) -> None:
    bars = MovestateBars(stage.talking, LIGHT)
    qtbot.addWidget(bars)
    before = [name for name, _ in bars.rows]
    assert "eyeWide" not in before
    panel.sliders["surprise"].setValue(100)
    stage.wait(0.1)
    bars.refresh()
    assert [name for name, _ in bars.rows if name not in before] != []
    assert ("eyeWide", ("eyeWideLeft", "eyeWideRight")) in bars.rows
    stage.talking.set_speed(2.0, 2.0)
    assert ("eyeWide", ("eyeWideLeft", "eyeWideRight")) in bars.rows


def test_the_face_follows_the_voice_as_far_as_its_sliders_say(
    stage: Stage, panel: ExpressionPanel, tmp_path: Path
) -> None:
    usual, lively = vowel((700, 1200), 1.0, 110, 0.1), vowel((700, 1200), 0.6, 190, 0.5)
    stage.open(tmp_path, np.concatenate([usual, lively]))
    panel.following["brows"].setValue(100)
    seen: list[float] = []
    stage.play(1.6, lambda: seen.append(shown(stage, BROW)))
    assert max(seen) > 2 > seen[10]
    assert stage.talking.expression.exported is not None
    panel.neutral.click()
    assert panel.following["brows"].value() == 0


class Collector:
    """Keeps what a face is told of the feeling in a voice."""

    def __init__(self) -> None:
        self.spreads: list[float] = []

    def feel(self, feelings: np.ndarray, _end: float) -> None:
        self.spreads += feelings[:, 1].tolist()


def test_the_habits_of_a_voice_are_learned_anew_with_each_sound(stage: Stage, tmp_path: Path) -> None:
    expression = stage.talking.expression
    expression.set_feeling("smile", 1.0)
    said = Analyser(load_preset(THESIS_PRESET)).push(AN_A)
    spreads = []
    for _ in range(2):
        told = Collector()
        expression.feel([(1.0, said)], [told])
        spreads.append(told.spreads)
    stage.open(tmp_path)
    again = Collector()
    expression.feel([(1.0, said)], [again])
    assert spreads[1][-1] < spreads[0][-1]
    assert again.spreads == spreads[0]
