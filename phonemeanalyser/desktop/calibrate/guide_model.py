"""The guided calibration: it waits for each sound, hears it, checks it, and says what to repeat.

After the sounds a sentence is read, from which nothing is learned: what the calibration gains is told on it alone.
Time is told by the sound that comes, not by a clock: where the microphone stands still, so does the guide.
"""

from dataclasses import dataclass, replace
from enum import StrEnum

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.calibrate.takes_model import UNNAMED, TakesModel
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.calibrate import CalibrationResult, calibrate
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.sentences import SENTENCES, Sentence
from phonemeengine.calibration.takes.onset import onset_in, quiet_at_end
from phonemeengine.calibration.takes.quality import check_take
from phonemeengine.calibration.takes.room_noise import RoomNoise, measure_room
from phonemeengine.calibration.takes.spoken import keep_sentence
from phonemeengine.errors import EngineError, TakeError
from phonemeengine.live.capture import to_mono_44k
from phonemeengine.phonemes import Phoneme
from phonemeengine.progress import Progress

ABOVE_ROOM = 4.0
"""A voice begins where it is so many times as loud as the room."""
LEAST_VOICE = 0.004
"""... and as loud as this, RMS amplitude (-48 dB)."""
BEFORE = 0.2
"""What is kept from before a sound begins, seconds."""
PATIENCE = 6.0
"""Seconds for which nothing may be heard before that is said."""
PRAISE, ADVICE = 0.6, 2.0
"""For how long it is shown that a take is good, or what is to be done, seconds."""
BEFORE_SENTENCE, AFTER_SENTENCE = 0.6, 0.8
"""What is kept from before the sentence, and the quiet that ends it, seconds."""
LONGEST_SENTENCE = 15.0
"""Seconds after which nobody waits for its end."""


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


READING = len(STEPS)
"""The number of the step after the sounds: the sentence."""
N_STEPS = READING + 1


class Phase(StrEnum):
    """What the guide is doing."""

    OFF = "off"
    WAITING = "waiting"
    HEARING = "hearing"
    CHECKING = "checking"
    SHOWING = "showing"
    LEARNING = "learning"
    DONE = "done"


class GuideModel(QObject):
    """Leads through all sounds; it goes on whenever sound was heard.

    Signals
    -------
    changed : another phase or another step.
    error : a sentence for the user.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, session: Session, preset: PresetModel, takes: TakesModel) -> None:
        super().__init__()
        self.phase = Phase.OFF
        self.index = 0
        self.advice = ""
        self.numbers: dict[int, int] = {}
        self.room: RoomNoise | None = None
        self.outcome: CalibrationResult | None = None
        self.sentence = SENTENCES[0]
        self.spoken: LabelledUtterance | None = None
        self._session = session
        self._capture = session.microphone.capture
        self._preset = preset
        self._takes = takes
        self._awaited: list[int] = []
        self._pause = 0.0
        self._voice_at: float | None = None
        self._work = TaskQueue(self._refuse)
        self._checks = TaskQueue(self._ask_again)
        takes.added.connect(self._note_take)
        takes.error.connect(self._note_refusal)
        takes.idle.connect(self._learn)
        session.heard.connect(self._follow)

    # -- how far it is ------------------------------------------------------------------------------------

    @property
    def running(self) -> bool:
        """Whether somebody is being led."""
        return self.phase is not Phase.OFF

    @property
    def step(self) -> Step:
        """What is asked for."""
        return STEPS[self.index] if self.index < READING else self._reading

    @property
    def _reading(self) -> Step:
        return Step(Phoneme.UNIDENTIFIED, "read aloud", self.sentence.text, float(len(self.sentence.sounds)) / 10)

    @property
    def reading(self) -> bool:
        """Whether the sentence is asked for."""
        return self.index == READING and self.phase not in {Phase.OFF, Phase.LEARNING, Phase.DONE}

    @property
    def measured_on(self) -> str:
        """What the figures are measured on, in words."""
        if self.outcome is None:
            return ""
        if self.outcome.cross_validated:
            return f"on quarters of the takes, each held back in turn, {self.outcome.seconds:.0f} s"
        seconds = f"{self.outcome.seconds:.1f} s"
        return f"on one sentence that was held back, {seconds}, labels aligned by the known text"

    @property
    def share(self) -> float:
        """How much of the sound that is asked for was heard, 0..1; of the learning, how much is done."""
        if self.phase is Phase.LEARNING:
            return self._work.progress
        if self.phase is Phase.SHOWING:
            return 0.0 if self.advice else 1.0
        if self.phase is not Phase.HEARING or self._voice_at is None:
            return 0.0
        return min(1.0, (self._capture.seconds - self._voice_at) / self.step.seconds)

    # -- what the user wants ------------------------------------------------------------------------------

    def begin(self) -> None:
        """Begin with the silence."""
        self.numbers, self.room, self.outcome, self.spoken, self._awaited = {}, None, None, None, []
        self._go_to(0)

    def back(self) -> None:
        """Say the sound before once more; its take makes room for the new one."""
        self._forget_work()
        self._go_to(max(0, min(self.index, N_STEPS) - 1))

    def skip(self) -> None:
        """Go on without this sound, or the sentence."""
        if self.phase not in {Phase.LEARNING, Phase.DONE}:
            if self.index == READING:
                self.spoken = None
            self._go_to(self.index + 1)

    def choose(self, sentence: Sentence) -> None:
        """Have another sentence read."""
        self.sentence = sentence
        if self.reading:
            self.again()

    def again(self) -> None:
        """Say this sound once more."""
        self._go_to(min(self.index, READING))

    def cancel(self) -> None:
        """End it; what was recorded stays."""
        self._forget_work()
        self._capture.end()
        self._preset.try_out(None)
        self._show(Phase.OFF)

    def accept(self) -> None:
        """Use the preset that was found; undo brings the old one back."""
        outcome = self.outcome
        self._preset.try_out(None)
        if outcome is not None and outcome.gains:
            try:
                self._preset.end_edit()
                self._preset.edit(replace(outcome.preset, name=self._preset.preset.name), "calibration")
            except EngineError as error:
                self.error.emit(str(error))
        self.cancel()

    def close(self) -> None:
        """End all work."""
        for queue in (self._checks, self._work):
            queue.close()

    # -- how it goes on -----------------------------------------------------------------------------------

    def _follow(self) -> None:
        """Look whether what is awaited was heard."""
        if self.phase is Phase.WAITING:
            self._look_for_voice()
        elif self.phase is Phase.HEARING and self._voice_at is not None:
            if self._has_ended(self._voice_at):
                self._check()
        elif self.phase is Phase.SHOWING and self._capture.seconds >= self._pause:
            self._go_to(self.index if self.advice else self.index + 1, advice=self.advice)

    def _go_to(self, index: int, advice: str = "") -> None:
        self.index, self.advice, self._voice_at = index, advice, None
        if index >= N_STEPS:
            self._capture.end()
            self._show(Phase.LEARNING)
            self._learn()
            return
        if not self._session.microphone.active:
            self._session.play()
        self._capture.begin()
        if self.step.phoneme is Phoneme.SILENCE:
            self._voice_at = 0.0
            self._show(Phase.HEARING)
        else:
            self._show(Phase.WAITING)

    def _look_for_voice(self) -> None:
        sound, rate = self._capture.heard()
        found = onset_in(sound, rate, self._least_voice)
        if found is not None:
            self._voice_at = found
            self.advice = ""
            self._show(Phase.HEARING)
        elif len(sound) >= PATIENCE * rate:
            self._go_to(
                self.index, advice="Nothing was heard that stands out from the room; say it louder or closer."
            )

    def _has_ended(self, voice_at: float) -> bool:
        capture = self._capture
        if self.index != READING:
            return capture.seconds >= voice_at + self.step.seconds
        sound, rate = capture.heard()
        quiet = quiet_at_end(sound, rate, self._least_voice)
        return quiet >= AFTER_SENTENCE or capture.seconds >= voice_at + LONGEST_SENTENCE

    @property
    def _least_voice(self) -> float:
        """How loud a voice is at least, an amplitude."""
        return max(ABOVE_ROOM * (self.room.level if self.room is not None else 0.0), LEAST_VOICE)

    def _check_sentence(self) -> None:
        """Label the sentence, or say why it must be read again."""
        samples, rate = self._capture.end()
        samples = samples[round(max(0.0, (self._voice_at or 0.0) - BEFORE_SENTENCE) * rate) :]
        room, sentence, folder = self.room.level if self.room else 0.0, self.sentence, self._takes.folder
        speaker = self._takes.speaker.strip() or UNNAMED

        def keep(_progress: Progress) -> LabelledUtterance:
            mono = to_mono_44k(samples, rate)
            for fault in check_take(mono, room, Phoneme.A).faults.values():
                raise TakeError(fault)
            if folder is None:
                raise TakeError("No sound was kept before it; go back and say some.")
            return keep_sentence(folder, samples, rate, mono, sentence, speaker)

        self._checks.replace(keep, self._take_sentence)
        self._show(Phase.CHECKING)

    def _take_sentence(self, spoken: LabelledUtterance) -> None:
        self.spoken = spoken
        self._tell_checked("")

    def _ask_again(self, sentence: str) -> None:
        self._tell_checked(f"{sentence[0].upper()}{sentence[1:].rstrip('.')}.")

    def _tell_checked(self, advice: str) -> None:
        """Show for a while what came of a check."""
        self.advice = advice
        self._pause = ADVICE if advice else PRAISE
        self._capture.begin()
        self._show(Phase.SHOWING)

    def _check(self) -> None:
        if self.index == READING:
            self._check_sentence()
            return
        phoneme = self.step.phoneme
        samples, rate = self._capture.end()
        samples = samples[round(max(0.0, (self._voice_at or 0.0) - BEFORE) * rate) :]
        mono = to_mono_44k(samples, rate)
        report = check_take(mono, self.room.level if self.room is not None else 0.0, phoneme)
        faults = list(report.faults.values())
        if phoneme is Phoneme.SILENCE:
            faults += self._measure_room(mono)
        if not faults:
            self._takes.add(
                samples, rate, phoneme, self._session.microphone.name, instead_of=self.numbers.get(self.index)
            )
            self._awaited.append(self.index)
        self._tell_checked(faults[0] if faults else "")

    def _measure_room(self, sound: Float32Array) -> list[str]:
        try:
            room = measure_room(sound, self._preset.in_force)
        except EngineError as error:
            return [str(error)]
        if not room.notes:
            self.room = room
        return list(room.notes)

    def _learn(self) -> None:
        """Begin to learn, as soon as all takes are on the disk."""
        if self.phase is not Phase.LEARNING or self._takes.busy or self._work.busy:
            return
        numbers = set(self.numbers.values())
        wanted = [t for t in self._takes.now.takes if t.number in numbers and not t.excluded]
        sounds = {self._takes.path_of(take) for take in wanted}
        takes = [u for u in self._takes.utterances() if u.path in sounds]
        preset, held_back = self._preset.preset, (self.spoken,) if self.spoken else ()
        self._work.replace(
            lambda progress: calibrate(preset, takes, held_back=held_back, progress=progress), self._take_outcome
        )  # fmt: skip

    def _take_outcome(self, outcome: CalibrationResult) -> None:
        self.outcome = outcome
        self._show(Phase.DONE)

    def _refuse(self, sentence: str) -> None:
        self.advice = sentence
        self.error.emit(sentence)
        self._show(Phase.DONE)

    def _note_take(self, number: int) -> None:
        if self._awaited:
            self.numbers[self._awaited.pop(0)] = number

    def _note_refusal(self, _sentence: str) -> None:
        if self.phase is Phase.LEARNING and not self._takes.busy:
            self._awaited = []

    def _forget_work(self) -> None:
        for work in (self._work, self._checks):
            work.cancel()

    def _show(self, phase: Phase) -> None:
        self.phase = phase
        self.changed.emit()
