"""What tests of the page of the head share."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.window import MainWindow
from tests.desktop.stage import Stage
from tests.desktop.talk.desk import Desk, talking
from tests.fakes.osc_receiver import Receiver
from tests.fakes.outputs import Outputs
from tests.graphics import context_or_skip


@pytest.fixture
def desk(session: Session, outputs: Outputs, qtbot: QtBot) -> Iterator[Desk]:
    desk = Desk(session, outputs, qtbot)
    yield desk
    desk.stage.talking.close()


@pytest.fixture
def stage(session: Session, outputs: Outputs, qtbot: QtBot, tmp_path: Path) -> Iterator[Stage]:
    stage = Stage(session, outputs, qtbot)
    stage.open(tmp_path)
    stage.look()
    yield stage
    stage.talking.close()


@pytest.fixture
def receiver() -> Iterator[Receiver]:
    receiver = Receiver()
    yield receiver
    receiver.close()


@pytest.fixture
def graphics() -> None:
    """OpenGL without a window."""
    context_or_skip().release()


@pytest.fixture
def window(desktop: Desktop, qtbot: QtBot, tmp_path: Path, graphics: None) -> MainWindow:
    """The window with its page of the head, and an a in hand."""
    return talking(desktop, qtbot, tmp_path)
