"""What tests of the page of the head share."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.session import Session
from tests.desktop.talk.desk import Desk
from tests.fakes.outputs import Outputs


@pytest.fixture
def desk(session: Session, outputs: Outputs, qtbot: QtBot) -> Iterator[Desk]:
    desk = Desk(session, outputs, qtbot)
    yield desk
    desk.stage.talking.close()
