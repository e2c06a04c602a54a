"""What is seen and waited for in a session."""

from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.results import NOWHERE
from phonemeanalyser.desktop.session.session import Session
from phonemeengine.settings import HOP, SAMPLE_RATE
from tests.conftest import SPEECH

N_FRAMES = -(-len(SPEECH) // HOP)
DURATION = len(SPEECH) / SAMPLE_RATE


def frames(session: Session) -> list[int]:
    """Give the frames in the history, without the gaps."""
    found = session.history.frames[session.history.indices(0, session.history.n)]
    return found[found != NOWHERE].tolist()


def settled(session: Session, qtbot: QtBot) -> None:
    """Wait until a seek has arrived."""
    player = session.source.player
    assert player is not None
    qtbot.waitUntil(lambda: player._target is None and not player._commands)
