"""The guided calibration: it waits for each sound, hears it, checks it, and says what to repeat.

Time is told by the sound that comes, not by a clock: where the microphone stands still, so does the guide.
"""

from dataclasses import dataclass, replace
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from engine.calibration.takes.check import check_take
from engine.calibration.takes.room_noise import RoomNoise, measure_room
from engine.errors import EngineError
from engine.phonemes import Phoneme
from phonemeanalyser.models.backroom import Backroom
from phonemeanalyser.models.calibration_of import Outcome, outcome_of
from phonemeanalyser.models.calibration_takes import TakesModel
from phonemeanalyser.models.catch import in_house_form
from phonemeanalyser.models.preset import PresetModel
from phonemeanalyser.models.session import Session

ABOVE_ROOM = 4.0
"""A voice begins where it is so many times as loud as the room."""
LEAST_VOICE = 0.004
"""... and as loud as this, RMS amplitude (-48 dB)."""
PERIOD = 0.01
QUIET_FRAMES, LOUD_FRAMES = 8, 5
"""How many of 10 ms must be quiet before a sound, and loud in a row where it begins."""
BEFORE = 0.2
"""What is kept from before a sound begins, seconds."""
PATIENCE = 6.0
"""Seconds for which nothing may be heard before that is said."""
PRAISE, ADVICE = 0.6, 2.0
"""For how long it is shown that a take is good, or what is to be done, seconds."""


@dataclass(frozen=True)
class Step:
    """One sound that is asked for.

    Attributes
    ----------
    phoneme : which one.
    say : what to say, in large letters.
    hint : how.
    seconds : for how long.
    """

    phoneme: Phoneme
    say: str
    hint: str
    seconds: float = 1.4


STEPS = (
    Step(Phoneme.SILENCE, "keep quiet", "two seconds of your room, with nobody speaking", 2.0),
    Step(Phoneme.A, "aaaa", "hold the a of “father”"),
    Step(Phoneme.E, "eeee", "hold the e of “bed”"),
    Step(Phoneme.I, "iiii", "hold the sound of “see”"),
    Step(Phoneme.O, "oooo", "hold the o of “more”"),
    Step(Phoneme.U, "uuuu", "hold the sound of “food”"),
    Step(Phoneme.SZ, "ssss", "hold the s of “see”"),
    Step(Phoneme.SCH, "shhh", "hold the sh of “she”"),
    Step(Phoneme.M, "mmmm", "hum with your lips closed"),
    Step(Phoneme.P, "p  p  p  p", "only the puff of the lips, quickly, with no vowel after it", 1.6),
)


class Phase(StrEnum):
    """What the guide is doing."""

    OFF = "off"
    WAITING = "waiting"
    HEARING = "hearing"
    SHOWING = "showing"
    LEARNING = "learning"
    DONE = "done"


class Guide(QObject):
    """Leads through all sounds; `tick` moves it on.

    Signals
    -------
    changed : another phase or another step.
    failed : a sentence for the user.
    """

    changed = Signal()
    failed = Signal(str)

    def __init__(self, session: Session, preset: PresetModel, takes: TakesModel) -> None:
        super().__init__()
        self.phase = Phase.OFF
        self.index = 0
        self.advice = ""
        self.numbers: dict[int, int] = {}
        self.room: RoomNoise | None = None
        self.outcome: Outcome | None = None
        self._session = session
        self._preset = preset
        self._takes = takes
        self._awaited: list[int] = []
        self._pause = 0.0
        self._voice_at: float | None = None
        self._work = Backroom(self._refuse)
        takes.added.connect(self._note_take)
        takes.failed.connect(self._note_refusal)

    # -- how far it is ------------------------------------------------------------------------------------

    @property
    def running(self) -> bool:
        """Whether somebody is being led."""
        return self.phase is not Phase.OFF

    @property
    def step(self) -> Step:
        """What is asked for."""
        return STEPS[min(self.index, len(STEPS) - 1)]

    @property
    def share(self) -> float:
        """How much of the sound that is asked for was heard, 0..1; of the learning, how much is done."""
        if self.phase is Phase.LEARNING:
            return self._work.share
        if self.phase is Phase.SHOWING:
            return 0.0 if self.advice else 1.0
        if self.phase is not Phase.HEARING or self._voice_at is None:
            return 0.0
        return min(1.0, (self._session.microphone.catch.seconds - self._voice_at) / self.step.seconds)

    # -- what the user wants ------------------------------------------------------------------------------

    def begin(self) -> None:
        """Begin with the silence."""
        self.numbers, self.room, self.outcome, self._awaited = {}, None, None, []
        self._go_to(0)

    def back(self) -> None:
        """Say the sound before once more; its take makes room for the new one."""
        self._work.cancel()
        self._go_to(max(0, self.index - 1))

    def skip(self) -> None:
        """Go on without this sound."""
        if self.phase not in {Phase.LEARNING, Phase.DONE}:
            self._go_to(self.index + 1)

    def again(self) -> None:
        """Say this sound once more."""
        self._go_to(min(self.index, len(STEPS) - 1))

    def cancel(self) -> None:
        """End it; what was recorded stays."""
        self._work.cancel()
        self._session.microphone.catch.end()
        self._show(Phase.OFF)

    def accept(self) -> None:
        """Use the preset that was found; undo brings the old one back."""
        outcome = self.outcome
        if outcome is not None and outcome.gains:
            try:
                self._preset.end_edit()
                self._preset.edit(replace(outcome.preset, name=self._preset.preset.name), "calibration")
            except EngineError as error:
                self.failed.emit(str(error))
        self.cancel()

    def close(self) -> None:
        """End all work."""
        self._work.cancel()
        self._work.close()

    # -- how it goes on -----------------------------------------------------------------------------------

    def tick(self) -> None:
        """Look whether what is awaited has come."""
        self._work.see()
        catch = self._session.microphone.catch
        if self.phase is Phase.WAITING:
            self._look_for_voice()
        elif self.phase is Phase.HEARING and self._voice_at is not None:
            if catch.seconds >= self._voice_at + self.step.seconds:
                self._check()
        elif self.phase is Phase.SHOWING and catch.seconds >= self._pause:
            self._go_to(self.index if self.advice else self.index + 1, advice=self.advice)
        elif self.phase is Phase.LEARNING and not self._takes.busy and not self._work.busy:
            self._learn()

    def _go_to(self, index: int, advice: str = "") -> None:
        self.index, self.advice, self._voice_at = index, advice, None
        if index >= len(STEPS):
            self._session.microphone.catch.end()
            self._show(Phase.LEARNING)
            return
        if not self._session.microphone.active:
            self._session.play()
        self._session.microphone.catch.begin()
        if self.step.phoneme is Phoneme.SILENCE:
            self._voice_at = 0.0
            self._show(Phase.HEARING)
        else:
            self._show(Phase.WAITING)

    def _look_for_voice(self) -> None:
        sound, rate = self._session.microphone.catch.heard()
        level = self.room.level if self.room is not None else 0.0
        found = onset_in(sound, rate, max(ABOVE_ROOM * level, LEAST_VOICE))
        if found is not None:
            self._voice_at = found
            self.advice = ""
            self._show(Phase.HEARING)
        elif len(sound) >= PATIENCE * rate:
            self._go_to(
                self.index, advice="Nothing was heard that stands out from the room; say it louder or closer."
            )

    def _check(self) -> None:
        catch, phoneme = self._session.microphone.catch, self.step.phoneme
        samples, rate = catch.end()
        samples = samples[round(max(0.0, (self._voice_at or 0.0) - BEFORE) * rate) :]
        mono = in_house_form(samples, rate)
        report = check_take(mono, self.room.level if self.room is not None else 0.0, phoneme)
        faults = list(report.faults.values())
        if phoneme is Phoneme.SILENCE:
            faults += self._measure_room(mono)
        self.advice = faults[0] if faults else ""
        if not faults:
            self._takes.add(samples, rate, phoneme, self._device, instead_of=self.numbers.get(self.index))
            self._awaited.append(self.index)
        self._pause = ADVICE if faults else PRAISE
        catch.begin()
        self._show(Phase.SHOWING)

    def _measure_room(self, sound: NDArray[np.float32]) -> list[str]:
        try:
            room = measure_room(sound, self._preset.in_force)
        except EngineError as error:
            return [str(error)]
        if not room.notes:
            self.room = room
        return list(room.notes)

    def _learn(self) -> None:
        numbers = set(self.numbers.values())
        wanted = [t for t in self._takes.now.takes if t.number in numbers and not t.excluded]
        sounds = {self._takes.path_of(take) for take in wanted}
        takes = [u for u in self._takes.utterances() if u.path in sounds]
        preset, room = self._preset.preset, self.room
        self._work.instead(lambda heed: outcome_of(preset, takes, room, heed), self._take_outcome)

    def _take_outcome(self, outcome: Outcome) -> None:
        self.outcome = outcome
        self._show(Phase.DONE)

    def _refuse(self, sentence: str) -> None:
        self.advice = sentence
        self.failed.emit(sentence)
        self._show(Phase.DONE)

    def _note_take(self, number: int) -> None:
        if self._awaited:
            self.numbers[self._awaited.pop(0)] = number

    def _note_refusal(self, _sentence: str) -> None:
        if self.phase is Phase.LEARNING and not self._takes.busy:
            self._awaited = []

    @property
    def _device(self) -> str:
        return self._session.microphone.choice.label or "default microphone"

    def _show(self, phase: Phase) -> None:
        self.phase = phase
        self.changed.emit()


def onset_in(sound: NDArray[np.float32], rate: int, threshold: float) -> float | None:
    """Say when a voice begins, seconds: after some quiet, where it stays as loud as a threshold (RMS)."""
    frame = max(1, round(PERIOD * rate))
    n = len(sound) // frame
    loud = (
        np.sqrt(np.mean(sound[: n * frame].reshape(n, frame) ** 2, axis=1)) >= threshold if n else np.zeros(0, bool)
    )
    quiet = run = 0
    for k, is_loud in enumerate(loud.tolist()):
        run = run + 1 if is_loud else 0
        if quiet >= QUIET_FRAMES and run >= LOUD_FRAMES:
            return (k + 1 - run) * frame / rate
        if not is_loud:
            quiet = quiet + 1
        elif quiet < QUIET_FRAMES:
            quiet = 0
    return None
