"""The program before microphones that a test moves, with folders of its own."""

from collections import Counter
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QSettings, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.results import NOWHERE
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.analyser import Analysis
from phonemeengine.audio.stream import Device, InputChoice
from phonemeengine.errors import DeviceError
from phonemeengine.live.loopback import Loopback, measure_loopback
from tests.desktop.hands import answer, press
from tests.fakes.microphones import HandDrivenListener, HandDrivenMicrophone, Microphones, frames_in
from tests.sounds import silence
from tests.waiting import wait_for

DESK = Device("Desk", "ALSA", 2, 0, 48_000, is_default=True)
HEADSET = Device("Headset", "ALSA", 1, 2, 44_100, is_default=False)


class Studio:
    """A microphone's model on hand-driven microphones; they are opened in turn."""

    def __init__(self, folder: Path, *microphones: HandDrivenMicrophone | None) -> None:
        self.takes, self.journal = folder / "takes", folder / "unfinished"
        self.openers = Microphones()
        self._begin_anew(microphones)
        self.model = Microphone(
            partial(HandDrivenListener, self.openers),
            self._list_devices,
            journal=self.journal,
            folder=self.takes,
            measure=self._measured,
        )
        self.model.info.connect(self.told.append)
        self.model.error.connect(self.failed.append)
        self.model.recorded.connect(self._note_recording)  # a lambda would keep all of this alive

    def _begin_anew(self, microphones: tuple[HandDrivenMicrophone | None, ...]) -> None:
        self.openers.waiting.extend(microphones)
        self.devices, self.refusal = [HEADSET, DESK], ""
        self.measure: Callable[[InputChoice], Loopback] = measure_loopback
        self.given: Counter[HandDrivenMicrophone] = Counter()
        self.taken: list[Analysis] = []
        self.told: list[str] = []
        self.failed: list[str] = []
        self.recorded: list[tuple[str, float]] = []
        self.gaps: list[str] = []

    def tidy(self, *microphones: HandDrivenMicrophone | None) -> None:
        """Be as one that is new, with these microphones, which are opened in turn."""
        model, openers = self.model, self.openers
        openers.may_answer.set()
        openers.waiting.clear()
        model.stop()
        model.capture.end()
        wait_for(
            lambda: not (QApplication.processEvents() or model._cards.busy or model._files.busy), "the microphone"
        )
        openers.asked.clear()
        if model.since_clear is not None:
            model.since_clear.close()
            model.since_clear = None
        model.latency_test.result = None
        for path in (*self.takes.glob("*.*"), *self.journal.glob("*"), *(p for p in (self.takes,) if p.is_file())):
            path.unlink()
        named, self.devices = self.devices, [HEADSET, DESK]
        self._begin_anew(microphones)
        if named != self.devices:
            model.refresh_devices()

    def _note_recording(self, path: str, seconds: float, gaps: str) -> None:
        self.recorded.append((path, seconds))
        self.gaps.append(gaps)

    def _list_devices(self) -> list[Device]:
        if self.refusal:
            raise DeviceError(self.refusal)
        return list(self.devices)

    def _measured(self, choice: InputChoice) -> Loopback:
        return self.measure(choice)

    def until(self, true: Callable[[], object], what: str = "the microphone") -> None:
        """Wait, taking what is found, until something is so."""

        def look() -> bool:
            QApplication.processEvents()  # what is done in the background comes by signals
            self.taken += self.model.listener.take_analyses()
            return bool(true())

        wait_for(look, what)

    def feed(self, microphone: HandDrivenMicrophone, samples: NDArray[np.float32]) -> None:
        """Give a microphone whole hops, and wait until all frames that they complete were taken."""
        n = sum(map(len, self.taken))
        before = self.given[microphone]
        self.given[microphone] += len(samples)
        microphone.give(samples)
        n += frames_in(self.given[microphone]) - frames_in(before)
        self.until(lambda: sum(map(len, self.taken)) == n, f"{n} frames")

    @property
    def files(self) -> list[str]:
        """Names of what lies in the folder of recordings."""
        return sorted(path.name for path in self.takes.iterdir() if path.is_file()) if self.takes.exists() else []

    @property
    def take(self) -> Path:
        """The only recording."""
        (path,) = (path for path in self.takes.iterdir() if path.suffix not in {"", ".csv"})
        return path


class Booth:
    """The window of a studio, and a hand on the microphone."""

    def __init__(self, desktop: Desktop, settings: QSettings, studio: Studio, qtbot: QtBot) -> None:
        self.studio, self.settings, self.qtbot = studio, settings, qtbot
        self.desktop = desktop
        self._given = studio.given

    @property
    def window(self) -> MainWindow:
        return self.desktop.window

    @property
    def banner(self) -> str:
        """What the banner says; nothing where it is not seen."""
        return self.window.banner.label.text() if self.window.banner.isVisible() else ""

    @property
    def status(self) -> str:
        """What the status line and the chips say."""
        status = self.window.status
        return f"{status.left.text()} | {status.right.text()} | {status.chips.words()} {status.chips.late.toolTip()}"

    @property
    def frames(self) -> list[int]:
        """The numbers of all frames that were gathered."""
        history = self.desktop.session.history
        found = history.frames[history.indices(0, history.n)]
        return found[found != NOWHERE].tolist()

    def until(self, true: Callable[[], object], giving: HandDrivenMicrophone | None = None) -> None:
        """Wait, with the window alive, until something is so; a microphone may give silence meanwhile."""

        def look() -> bool:
            if giving is not None:
                self.give(giving, silence(0.01))
            return bool(true())

        self.qtbot.waitUntil(look)

    def give(self, microphone: HandDrivenMicrophone, samples: NDArray[np.float32]) -> None:
        """Give a microphone samples."""
        self._given[microphone] += len(samples)
        microphone.give(samples)

    def feed(self, microphone: HandDrivenMicrophone, samples: NDArray[np.float32]) -> None:
        """Give a microphone samples, and wait until the views know all of them."""
        known, before = len(self.frames), frames_in(self._given[microphone])
        self.give(microphone, samples)
        n = known + frames_in(self._given[microphone]) - before
        self.until(lambda: len(self.frames) == n)

    def listen(self) -> None:
        """Choose the microphone in the source box."""
        choose(self.window.transport.source, "Microphone")

    def go_to_view(self) -> None:
        """Give the keyboard to the view, as a click into it does; a box of questions or of choices had it before."""
        self.window.activateWindow()
        self.until(self.window.isActiveWindow)
        self.window.analysis.main_view.setFocus()

    def record(self) -> None:
        """Press R in the view, and leave the file in hand for the microphone."""
        self.go_to_view()
        if self.desktop.session.source.kind is SourceKind.FILE:
            answer("Record")
        press(self.window, Qt.Key.Key_R)


def choose(box: QComboBox, text: str) -> None:
    """Choose with the keyboard, as a person does."""
    box.setFocus()
    while box.currentText() != text:
        before = box.currentIndex()
        QTest.keyClick(box, Qt.Key.Key_Down if box.findText(text) > before else Qt.Key.Key_Up)
        assert box.currentIndex() != before, f"{text} cannot be chosen"
