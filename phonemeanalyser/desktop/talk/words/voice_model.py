"""The voice that says texts: which one it is, and how fast it speaks."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr_noop
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.errors import VoiceError
from phonemeengine.performance.own_sound import OwnSound
from phonemeengine.speech.pinyin.timing import USUAL_RATE
from phonemeengine.speech.voice import RATES
from phonemeengine.text import mandarin
from phonemeengine.text.espeak import Language, languages, voices
from phonemeengine.text.lexicon import Lexicon

SLOWEST, FASTEST = RATES[0][0], RATES[-1][0]
"""Syllables a second."""


@dataclass(frozen=True)
class VoiceChoice:
    """Who says texts, and how.

    Attributes
    ----------
    name : a voice for every language; the language's own where it is empty.
    rate : syllables a second, `SLOWEST`..`FASTEST`.
    program : a text-to-speech program of the user's own, as a command.
    by_program : whether that program speaks, at a rate of its own.
    own_sound : whether the recordings of the table in use speak, as the voice would say it.
    recordings : those; None where no table is in use.
    lexicon : how words are pronounced that the voice reads otherwise; None for none.
    literal : whether the notation of scripts is spoken, too.
    """

    name: str = ""
    rate: float = USUAL_RATE
    program: str = ""
    by_program: bool = False
    own_sound: bool = False
    recordings: OwnSound | None = None
    lexicon: Lexicon | None = None
    literal: bool = False

    @property
    def words(self) -> str:
        """Whose sound it is, in English."""
        return tr_noop("synthetic voice") if self.recordings is None else tr_noop("own sound of the recorded faces")


@dataclass(frozen=True)
class Installed:
    """What can be chosen: languages, and names of voices that speak all of them."""

    languages: tuple[Language, ...] = ()
    voices: tuple[str, ...] = ()


def installed() -> Installed:
    """Return which languages and voices there are.

    Raises
    ------
    VoiceError : none.
    """
    return Installed(languages(), voices())


def warm_up() -> None:
    """Load what reads Chinese, which takes half a second; where it is missing, that is said when it is needed."""
    with suppress(VoiceError):
        mandarin.pinyin_of("好")


class VoiceModel(QObject):
    """Knows the voice that is chosen, and which there are.

    Signals
    -------
    changed : another choice, or it is known by now what there is to choose.

    Attributes
    ----------
    choice : who says texts, and how.
    installed : of several tags of a language, one; nothing before `wake` has looked.
    look : tells what is installed.
    warm_up : loads what the first text would else wait for.
    lack : why there are no voices, as a sentence; empty where there are.
    """

    changed = Signal()

    def __init__(self, look: Callable[[], Installed] = installed, warm_up: Callable[[], object] = warm_up) -> None:
        super().__init__()
        self.choice = VoiceChoice()
        self.installed = Installed()
        self.lack = ""
        self.look, self.warm_up = look, warm_up
        self._awake = False
        self._work = TaskQueue(self._take_lack)

    @property
    def busy(self) -> bool:
        """Whether it still looks what there is."""
        return self._work.busy

    def wake(self) -> None:
        """Look what there is, in the background, and load what the first text needs."""
        if not self._awake:
            self._awake = True
            self._work.submit(lambda _progress: self.look(), self._take)
            self._work.submit(lambda _progress: self.warm_up())

    def choose(self, **chosen: Any) -> None:
        """Change fields of the choice; the next text is spoken so."""
        choice = replace(self.choice, **chosen)
        if choice != self.choice:
            self.choice = replace(choice, rate=min(max(choice.rate, SLOWEST), FASTEST))
            self.changed.emit()

    def close(self) -> None:
        """End the work."""
        self._work.close(CLOSE_TIMEOUT)

    def _take(self, installed: Installed) -> None:
        by_voice = {language.identifier: language for language in reversed(installed.languages)}
        self.installed = replace(installed, languages=tuple(by_voice.values()))
        self.changed.emit()

    def _take_lack(self, sentence: str) -> None:
        self.lack = sentence
        self.changed.emit()
