"""A head on a stage whose time only moves when a test says so."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import soundfile
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.words.text_model import TextModel
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.desktop.conftest import AHEAD, STEP, ended
from tests.fakes.outputs import Outputs
from tests.sounds import silence, vowel

AN_A = np.concatenate((silence(0.6), vowel((700, 1200, 2500), 0.5), silence(0.6)))
"""An a from 0.6 s to 1.1 s."""
BEGINS, ENDS = 0.6, 1.1
START = 100.0
"""What the clock says at the beginning, seconds."""
LONG = 20.0
"""Seconds in which everybody blinks."""


class Stage:
    """A talking head whose clock goes with the sound that is heard."""

    def __init__(self, session: Session, outputs: Outputs, qtbot: QtBot, text: TextModel | None = None) -> None:
        self.session, self.outputs, self.qtbot = session, outputs, qtbot
        self.now = START
        self.failed: list[str] = []
        self.talking = TalkModel(session, lambda: self.now, text)
        self.talking.error.connect(self.failed.append)

    def look(self) -> None:
        """Look at the head until it is there."""
        self.talking.watch(True)
        self.settle()

    def settle(self) -> None:
        """Wait until what was asked for is loaded."""
        self.qtbot.waitUntil(lambda: not self.talking.face.busy and not self.talking._work.busy)
        self.talking.tick()

    def open(self, folder: Path, sound: np.ndarray = AN_A) -> None:
        """Have a sound in hand."""
        soundfile.write(folder / "said.wav", sound, SAMPLE_RATE, subtype="FLOAT")
        assert self.session.open(folder / "said.wav")

    def play(self, seconds: float, watch: Callable[[], None] = lambda: None) -> None:
        """Play on for some seconds, at most to the end, and watch after each step."""
        until = self.now + seconds
        self.session.play()
        while self.session.source.playing and self.now < until - 1e-9:
            self.qtbot.waitUntil(
                lambda: self.outputs.last.n_written - self.outputs.last.heard >= AHEAD or ended(self.session)
            )
            self.outputs.last.move(STEP)
            self.now += STEP / SAMPLE_RATE
            self.session.poll()
            self.talking.tick()
            watch()

    def wait(self, seconds: float, watch: Callable[[], None] = lambda: None) -> None:
        """Let time pass without sound."""
        for _ in range(round(60 * seconds)):
            self.now += 1 / 60
            self.talking.tick()
            watch()

    @property
    def jaw(self) -> float:
        """How far the jaw is open, %."""
        return self.talking.percentages["jawOpen"]

    @property
    def said_an_a(self) -> bool:
        """Whether an a was heard by now."""
        history = self.session.history
        return bool(np.any(history.phonemes[history.indices(0, history.n)] == Phoneme.A))
