"""Expressions on the page of the head: sliders, what speech leaves of them, and what the network is sent."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.talk.expression_panel import ExpressionPanel
from phonemeanalyser.desktop.theme import LIGHT
from tests.desktop.stage import Stage
from tests.fakes.osc_receiver import Receiver
from tests.fakes.outputs import Outputs

SMILE, BROW = "mouthSmileLeft", "browOuterUpLeft"


@pytest.fixture
def stage(session: Session, outputs: Outputs, qtbot: QtBot, tmp_path: Path) -> Iterator[Stage]:
    stage = Stage(session, outputs, qtbot)
    stage.open(tmp_path)
    stage.look()
    yield stage
    stage.talking.close()


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
    held_back, free = [smile for held, smile in seen if held == 100], [smile for held, smile in seen if held == 0]
    assert max(free) == pytest.approx(75, abs=1)
    assert min(held_back) < 45
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
