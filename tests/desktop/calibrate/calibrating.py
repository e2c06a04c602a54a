"""The page of the calibration before a microphone that a test moves, and sounds to say."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import soundfile
from numpy.typing import NDArray
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from phonemeanalyser.desktop.calibrate.guide.guide_model import Phase
from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeanalyser.desktop.calibrate.page import CalibrationPage
from phonemeengine.calibration.takes.take import Take
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import HOP, SAMPLE_RATE
from tests.desktop.hands import press
from tests.desktop.studio import Booth
from tests.fakes.microphones import HandDrivenMicrophone
from tests.sounds import noise, silence, vowel

FORMANTS = {
    Phoneme.A: (700, 1200, 2500),
    Phoneme.E: (450, 1900, 2500),
    Phoneme.I: (280, 2250, 2900),
    Phoneme.O: (450, 800, 2500),
    Phoneme.U: (310, 800, 2300),
    Phoneme.M: (250, 1000, 2200),
}
ROOM = 0.0006
"""The noise of the room, RMS amplitude."""
LEFT = 3
"""Blocks that the microphone still has to hear when it is given more of the room."""
CONTROL = Qt.KeyboardModifier.ControlModifier


def said(phoneme: Phoneme, seconds: float, f0: float = 160.0) -> NDArray[np.float32]:
    """A sound as somebody says it: whole hops, float32."""
    seconds = round(seconds * 100) / 100
    if phoneme in FORMANTS:
        return vowel(FORMANTS[phoneme], seconds, f0=f0, amplitude=0.2 if phoneme is Phoneme.M else 0.5)
    if phoneme is Phoneme.SZ:
        return noise(seconds, 0.1)
    if phoneme is Phoneme.SCH:
        return np.convolve(noise(seconds, 0.3), np.ones(6) / 6, "same").astype(np.float32)
    if phoneme is Phoneme.P:
        puff = np.concatenate((noise(0.05, 0.3), silence(0.15)))
        return np.tile(puff, 1 + round(seconds / 0.2))[: round(seconds * SAMPLE_RATE)]
    return silence(seconds)


def in_room(sound: NDArray[np.float32]) -> NDArray[np.float32]:
    """A sound with the noise of the room, cut to whole hops."""
    sound = sound[: len(sound) // HOP * HOP]
    return (sound + noise(len(sound) / SAMPLE_RATE, ROOM, seed=5)).astype(np.float32)


class Calibrator:
    """Somebody at the page of the calibration."""

    def __init__(self, booth: Booth, mic: HandDrivenMicrophone) -> None:
        self.booth = booth
        self.mic = mic
        press(booth.window, Qt.Key.Key_2, CONTROL)

    @property
    def page(self) -> CalibrationPage:
        return self.booth.window.calibration

    @property
    def model(self) -> CalibrationModel:
        return self.booth.desktop.calibration

    @property
    def takes(self) -> tuple[Take, ...]:
        return self.model.takes.now.takes

    def until(self, true: Callable[[], object], *, silently: bool = True) -> None:
        """Wait, with the window alive; the microphone hears the room meanwhile, unless it is to hear nothing."""

        def look() -> bool:
            hears = self.model.guide.phase is not Phase.LEARNING and self.mic.n_waiting < LEFT
            if hears and not silently:
                self.booth.give(self.mic, in_room(silence(0.1)))
            return bool(true())

        self.booth.qtbot.waitUntil(look)

    def settle(self) -> None:
        """Wait until nothing is done in the background."""
        model = self.model
        bench = (model.workbench.measuring, model.workbench.looking)
        rooms = (model.takes, model.recordings, *bench, model.fit.searching, model.comparison)
        timers = model.workbench.findChildren(QTimer)  # it answers a little later
        self.until(lambda: not any(room.busy for room in rooms) and not any(timer.isActive() for timer in timers))

    def listen(self) -> None:
        """Have the microphone heard, and nothing of the room left that would begin a take."""
        self.model.listen()
        self.until(lambda: self.booth.studio.model.listening, silently=False)
        self.until(lambda: not self.mic.n_waiting)

    def say(self, key: Qt.Key, sound: NDArray[np.float32]) -> None:
        """Hold a key while something is heard."""
        widget = QApplication.focusWidget() or self.booth.window
        QTest.keyPress(widget, key)
        heard = self.booth.studio.model.capture
        rate_seconds = len(sound) / SAMPLE_RATE
        self.booth.give(self.mic, sound)
        self.until(lambda: heard.seconds >= rate_seconds - 1e-9)
        self.let_go(key)
        self.settle()

    def let_go(self, key: Qt.Key) -> None:
        """Let a held key go, and have the time pass after which that counts."""
        QTest.keyRelease(QApplication.focusWidget() or self.booth.window, key)
        self.page.keys.settling.timeout.emit()

    def keep(self, phoneme: Phoneme, seconds: float = 0.8) -> None:
        """Make a take without the microphone."""
        around = silence(0.2)
        sound = in_room(np.concatenate((around, said(phoneme, seconds), around)))
        self.model.takes.add(sound[:, np.newaxis], SAMPLE_RATE, phoneme, "Desk")
        self.settle()


def corpus(folder: Path, names: dict[Phoneme, str] | None = None) -> Path:
    """Labelled recordings of two speakers, with labels for Audacity beside them; sounds may have other names."""
    phonemes = (Phoneme.A, Phoneme.I, Phoneme.SZ, Phoneme.U)
    for k, speaker in enumerate(("ann", "bob")):
        place = folder / speaker
        place.mkdir(parents=True)
        parts, rows, at = [], [], 0.0
        for phoneme in phonemes:
            for what, seconds in ((Phoneme.SILENCE, 0.3), (phoneme, 0.5)):
                parts.append(said(what, seconds, f0=110.0 + 90 * k))
                name = (names or {}).get(what, what.label)
                rows.append(f"{at:.6f}\t{at + seconds:.6f}\t{name}")
                at += seconds
        soundfile.write(place / f"{speaker}.wav", in_room(np.concatenate(parts)), SAMPLE_RATE)
        (place / f"{speaker}.txt").write_text("\n".join(rows) + "\n", encoding="utf-8")
    return folder
