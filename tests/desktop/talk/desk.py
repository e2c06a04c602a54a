"""A stage whose texts a test writes, with a voice and an aligner that need no time; and the page of the head."""

from pathlib import Path

import numpy as np
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.talk.head.head_view import HeadView
from phonemeanalyser.desktop.talk.words.text_model import TextModel, TextTools
from phonemeanalyser.desktop.talk.words.voice_model import VoiceModel
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.labels.utterance import Utterance
from tests.desktop.hands import press, shown, wav
from tests.desktop.lent_window import draw
from tests.desktop.stage import AN_A, Stage
from tests.desktop.talk.voices import INSTALLED, FakeAligner, FakeVoice, word
from tests.fakes.outputs import Outputs
from tests.sounds import silence, vowel

DURATION = len(AN_A) / 44100
SAID = Utterance((word("so", 0.6, 0.9, 0.1), word("oh", 0.9, 1.1, 3.0)), DURATION, "en-us")


class Desk:
    """A stage whose texts a test writes."""

    def __init__(self, session: Session, outputs: Outputs, qtbot: QtBot) -> None:
        self.voice, self.aligner = FakeVoice(), FakeAligner(SAID)
        known = VoiceModel(lambda: INSTALLED, lambda: None)
        self.texts = TextModel(session, TextTools(self.aligner.align, self.voice.speak), known)
        self.stage = Stage(session, outputs, qtbot, self.texts)
        self.session, self.qtbot = session, qtbot
        self.told: list[str] = []
        self.texts.info.connect(self.told.append)

    @property
    def failed(self) -> list[str]:
        """What was refused."""
        return [sentence for sentence in self.stage.failed if sentence]

    def open(self, folder: Path) -> None:
        """Have a sound in hand, and look what lies beside it."""
        self.stage.open(folder)
        self.wait()

    def wait(self) -> None:
        """Wait until all work is done."""
        texts = self.texts
        self.qtbot.waitUntil(
            lambda: not (texts.busy or texts._looking.busy or texts._saving.busy or texts.voice.busy)
        )

    def align(self, text: str = "so oh", language: str = "en-us") -> None:
        """Align a text with the sound in hand."""
        self.texts.set_text(text)
        self.texts.set_language(language)
        self.texts.align()
        self.wait()

    def say(self, text: str, language: str = "en-us") -> None:
        """Have a text spoken."""
        self.texts.set_text(text)
        self.texts.set_language(language)
        self.texts.say()
        self.wait()

    def words(self) -> list[str]:
        """What is known to be said."""
        return [] if self.texts.utterance is None else [said.text for said in self.texts.utterance.words]


def talking(desktop: Desktop, qtbot: QtBot, folder: Path) -> MainWindow:
    """Show the page of the head, on an a that is so long that a slow window sees it as well."""
    long_a = np.concatenate((silence(0.6), vowel((700, 1200, 2500), 2.5), silence(0.6)))
    window = shown(desktop, qtbot, wav(folder, long_a))
    press(window, Qt.Key.Key_3, Qt.KeyboardModifier.ControlModifier)
    drawn(window.talk.head, qtbot)
    return window


def drawn(head: HeadView, qtbot: QtBot) -> None:
    """Wait until a head is drawn, also in a fixture."""
    draw(head.window(), True)
    qtbot.waitUntil(lambda: head.surface is not None and head.surface.n_drawn > 0)
