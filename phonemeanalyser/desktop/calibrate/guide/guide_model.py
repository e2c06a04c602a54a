"""The guided calibration: it waits for each thing that is said, records it, checks it, and says what to repeat.

A sentence is read, from which the voice is learned, or nine single sounds are said instead. Then another sentence is
read, from which nothing is learned: what the calibration gains is measured on it alone. Time is measured by
the sound that arrives, not by a clock: where the microphone stands still, so does the guide.
"""

from dataclasses import dataclass, replace
from enum import StrEnum
from functools import partial

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.calibrate.takes.takes_model import UNNAMED, TakesModel
from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import language_in_use, tr, tr_count, tr_noop
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.calibrate import CalibrationResult, calibrate
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.takes import sentences
from phonemeengine.calibration.takes.quality import check_take
from phonemeengine.calibration.takes.room_noise import RoomNoise, measure_room
from phonemeengine.errors import EngineError, TakeError
from phonemeengine.execution import Progress
from phonemeengine.live.recorder import to_mono_44k
from phonemeengine.phonemes import Phoneme

ABOVE_ROOM = 4.0
"""A voice begins where it is this many times as loud as the background noise."""
LEAST_VOICE = 0.004
"""... and as loud as this, RMS amplitude (-48 dB)."""
BEFORE = 0.2
"""What is kept from before a sound begins, seconds."""
PATIENCE = 6.0
"""Seconds without sound before that is said."""
PRAISE, ADVICE = 0.6, 2.0
"""For how long it is shown that a take is good, or what is to be done, seconds."""
BEFORE_SENTENCE, AFTER_SENTENCE = 0.6, 0.8
"""What is kept from before the sentence, and the quiet that ends it, seconds."""
LONGEST_SENTENCE = 15.0
"""Seconds after which its end is no longer waited for."""
COUNTDOWN = 2.0
"""Seconds from *Start* until something is recorded: the click of the button is not part of the room."""
SENTENCES_OF = {"en": "English", "de": "German"}
"""The language of the sentences in a window of each language, unless the user chooses another."""
SOUNDS_PER_S = 10
"""Of a sentence that is read; the ring fills so fast."""


@dataclass(frozen=True)
class Step:
    """One sound or sentence that is asked for.

    Attributes
    ----------
    phoneme : which one; unidentified for a sentence.
    say : what to say, in large letters.
    hint : how.
    seconds : for how long.
    sentence : what is read; None for a sound.
    teaches : whether it is learned from; else it is to judge by.
    """

    phoneme: Phoneme
    say: str
    hint: str
    seconds: float = 1.4
    sentence: sentences.Sentence | None = None
    teaches: bool = True

    @property
    def name(self) -> str:
        """What it is called where there is little room."""
        if self.sentence is None:
            return sound_name(self.phoneme)
        return tr("Sentence") if self.teaches else tr("Test")


QUIET = Step(
    Phoneme.SILENCE,
    tr_noop("Keep quiet"),
    tr_noop("Say nothing for two seconds while the background noise is measured"),
    2.0,
)
SOUNDS = (
    Step(Phoneme.A, "aaaa", tr_noop("Hold the a in “father”")),
    Step(Phoneme.E, "eeee", tr_noop("Hold the e in “bed”")),
    Step(Phoneme.I, "iiii", tr_noop("Hold the ee in “see”")),
    Step(Phoneme.O, "oooo", tr_noop("Hold the o in “more”")),
    Step(Phoneme.U, "uuuu", tr_noop("Hold the oo in “food”")),
    Step(Phoneme.SZ, "ssss", tr_noop("Hold the s in “see”")),
    Step(Phoneme.SCH, "shhh", tr_noop("Hold the sh in “she”")),
    Step(Phoneme.M, "mmmm", tr_noop("Hum with your lips closed")),
    Step(Phoneme.P, "p  p  p  p", tr_noop("Say only the burst of the p, in quick succession, without a vowel"), 1.6),
)


def steps_of(language: str, *, by_sounds: bool) -> tuple[Step, ...]:
    """Return what is asked for, in order: the room, a sentence or single sounds, and a sentence to judge by."""
    learned, judged = sentences.sentences_in(language)
    if by_sounds:
        return (QUIET, *SOUNDS, _reading(learned, teaches=False))
    return (QUIET, _reading(learned, teaches=True), _reading(judged, teaches=False))


def _reading(sentence: sentences.Sentence, *, teaches: bool) -> Step:
    seconds = len(sentence.sounds) / SOUNDS_PER_S
    return Step(Phoneme.UNIDENTIFIED, tr_noop("Read aloud"), sentence.text, seconds, sentence, teaches)


class Phase(StrEnum):
    """What the guide is doing."""

    OFF = "off"
    READY = "ready"
    COUNTING = "counting"
    WAITING = "waiting"
    RECORDING = "recording"
    CHECKING = "checking"
    SHOWING = "showing"
    LEARNING = "learning"
    DONE = "done"


class GuideModel(QObject):
    """Leads through all that is asked for; it goes on whenever sound has arrived.

    Signals
    -------
    changed : another phase or another step.
    error : a sentence for the user.

    Attributes
    ----------
    steps : what is asked for, in order.
    index : the number of the step at hand; that of steps when all were taken.
    by_sounds : whether single sounds are said, in place of the sentence that teaches.
    language : of the sentences.
    numbers : the takes of the sounds that were said, by their steps.
    sentences : what was read, by its step.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, session: Session, preset: PresetModel, takes: TakesModel) -> None:
        super().__init__()
        self.learn = calibrate
        self.phase = Phase.OFF
        self.index = 0
        self.advice = ""
        self.numbers: dict[int, int] = {}
        self.room: RoomNoise | None = None
        self.outcome: CalibrationResult | None = None
        self.language, self.by_sounds = sentences.LANGUAGES[0], False
        self._language_chosen = False
        self.steps = steps_of(self.language, by_sounds=self.by_sounds)
        self.sentences: dict[int, LabelledUtterance] = {}
        self._session = session
        self._capture = session.microphone.capture
        self._preset = preset
        self._takes = takes
        self._awaited: list[int] = []
        self._unwanted = False
        self._pause = 0.0
        self._voice_at: float | None = None
        self._work = TaskQueue(self._refuse)
        self._checks = TaskQueue(self._ask_again)
        takes.added.connect(self._note_take)
        takes.error.connect(self._note_refusal)
        takes.idle.connect(self._learn)
        session.analysed.connect(self._follow)

    # -- how far it is ------------------------------------------------------------------------------------

    @property
    def running(self) -> bool:
        """Whether the guide runs."""
        return self.phase is not Phase.OFF

    @property
    def step(self) -> Step:
        """What is asked for."""
        return self.steps[min(self.index, len(self.steps) - 1)]

    @property
    def reading(self) -> bool:
        """Whether a sentence is asked for."""
        return self.step.sentence is not None and self.asking

    @property
    def asking(self) -> bool:
        """Whether a sound or a sentence is asked for, or was just said."""
        return self.phase in {Phase.WAITING, Phase.RECORDING, Phase.CHECKING, Phase.SHOWING}

    @property
    def seconds_left(self) -> float:
        """Seconds of the countdown that are left."""
        return max(0.0, COUNTDOWN - self._capture.seconds) if self.phase is Phase.COUNTING else 0.0

    @property
    def spoken(self) -> LabelledUtterance | None:
        """The sentence that was read last: to judge by, or else to learn from."""
        return self.sentences[max(self.sentences)] if self.sentences else None

    @property
    def learned_from(self) -> str:
        """What was learned from, a sentence."""
        if self.outcome is None:
            return ""
        n_sounds = len(self.numbers.keys() - {0})
        parts = (
            (any(self.steps[k].teaches for k in self.sentences), tr("one sentence")),
            (n_sounds, tr_count("one single sound", "{n} single sounds", n_sounds)),
            (0 in self.numbers, tr("background noise")),
        )
        return tr("Learned from: {parts} ({seconds:.1f} s).").format(
            parts=", ".join(words for is_there, words in parts if is_there), seconds=self.outcome.learned_seconds
        )

    @property
    def measured_on(self) -> str:
        """What the figures are measured on, a sentence."""
        if self.outcome is None:
            return ""
        if self.outcome.cross_validated:
            return tr(
                "Measured by four-fold cross-validation: each quarter of your recordings ({seconds:.0f} s) in turn "
                "was left out of the calibration."
            ).format(seconds=self.outcome.seconds)
        return tr(
            "Measured on the test sentence only ({seconds:.1f} s), whose labels were aligned with its known text."
        ).format(seconds=self.outcome.seconds)

    @property
    def share(self) -> float:
        """How much of the sound that is asked for was recorded, 0..1; of the learning, how much is done."""
        if self.phase is Phase.LEARNING:
            return self._work.progress
        if self.phase is Phase.COUNTING:
            return 1.0 - self.seconds_left / COUNTDOWN
        if self.phase is Phase.SHOWING:
            return 0.0 if self.advice else 1.0
        if self.phase is not Phase.RECORDING or self._voice_at is None:
            return 0.0
        return min(1.0, (self._capture.seconds - self._voice_at) / self.step.seconds)

    # -- what the user wants ------------------------------------------------------------------------------

    def begin(self) -> None:
        """Say what will be asked for, with the microphone on, and wait for `start`."""
        self.numbers, self.room, self.outcome, self.sentences, self._awaited = {}, None, None, {}, []
        if not self._language_chosen:
            self.language = SENTENCES_OF.get(language_in_use(), sentences.LANGUAGES[0])
            self.steps = steps_of(self.language, by_sounds=self.by_sounds)
        self.index, self.advice = 0, ""
        self._show(Phase.READY)

    def start(self) -> None:
        """Count down, and begin with the silence."""
        if self.phase is Phase.READY:
            self._capture_from_now()
            self._show(Phase.COUNTING)

    def back(self) -> None:
        """Say what came before once more; its take makes room for the new one."""
        self._forget_work()
        self._go_to(max(0, min(self.index, len(self.steps)) - 1))

    def skip(self) -> None:
        """Go on without this sound or sentence."""
        if self.phase not in {Phase.LEARNING, Phase.DONE}:
            self.sentences.pop(self.index, None)
            self._go_to(self.index + 1)

    def choose(self, language: str, *, by_sounds: bool) -> None:
        """Have sentences of a language read, or single sounds said; from the first of them on, after the room."""
        same_way = by_sounds == self.by_sounds
        self._language_chosen |= language != self.language
        self.language, self.by_sounds = language, by_sounds
        self.steps = steps_of(language, by_sounds=by_sounds)
        if not same_way:
            self.numbers = {k: number for k, number in self.numbers.items() if k == 0}
            self.sentences = {}
        if self.phase in {Phase.OFF, Phase.LEARNING, Phase.DONE} or self.index == 0:
            self.changed.emit()
        elif not same_way:
            self._forget_work()
            self._go_to(1)
        elif self.reading:
            self.again()

    def again(self) -> None:
        """Say this once more."""
        self._go_to(min(self.index, len(self.steps) - 1))

    def cancel(self) -> None:
        """End it; the takes of one that is not finished are deleted, which undo brings back."""
        if self.asking and self.numbers:
            self._takes.delete(set(self.numbers.values()))
        self._unwanted = self.asking
        self._end()

    def _end(self) -> None:
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
                self._preset.edit(replace(outcome.preset, name=self._preset.preset.name), tr("calibration"))
            except EngineError as error:
                self.error.emit(str(error))
        self._end()

    def close(self) -> None:
        """End all work."""
        for queue in (self._checks, self._work):
            queue.close()

    # -- how it goes on -----------------------------------------------------------------------------------

    def _follow(self) -> None:
        """Look whether what is awaited was said."""
        if self.phase is Phase.WAITING:
            self._look_for_voice()
        elif self.phase is Phase.RECORDING and self._voice_at is not None:
            if self._has_ended(self._voice_at):
                self._check()
        elif self.phase is Phase.COUNTING and self.seconds_left == 0.0:
            self._go_to(0)
        elif self.phase is Phase.SHOWING and self._capture.seconds >= self._pause:
            self._go_to(self.index if self.advice else self.index + 1, advice=self.advice)

    def _go_to(self, index: int, advice: str = "") -> None:
        self.index, self.advice, self._voice_at = index, advice, None
        if index >= len(self.steps):
            self._capture.end()
            self._show(Phase.LEARNING)
            self._learn()
            return
        self._capture_from_now()
        if self.step.phoneme is Phoneme.SILENCE:
            self._voice_at = 0.0
            self._show(Phase.RECORDING)
        else:
            self._show(Phase.WAITING)

    def _capture_from_now(self) -> None:
        """Keep the microphone's samples from now on."""
        if not self._session.microphone.active:
            self._session.play()
        self._capture.begin()

    def _look_for_voice(self) -> None:
        sound, rate = self._capture.so_far()
        found = sentences.onset_in(sound, rate, self._least_voice)
        if found is not None:
            self._voice_at = found
            self.advice = ""
            self._show(Phase.RECORDING)
        elif len(sound) >= PATIENCE * rate:
            self._go_to(
                self.index,
                advice=tr(
                    "No voice was detected above the background noise. Speak louder or move closer to the microphone."
                ),
            )

    def _has_ended(self, voice_at: float) -> bool:
        capture = self._capture
        if self.step.sentence is None:
            return capture.seconds >= voice_at + self.step.seconds
        sound, rate = capture.so_far()
        quiet = sentences.quiet_at_end(sound, rate, self._least_voice)
        return quiet >= AFTER_SENTENCE or capture.seconds >= voice_at + LONGEST_SENTENCE

    @property
    def _least_voice(self) -> float:
        """How loud a voice is at least, an amplitude."""
        return max(ABOVE_ROOM * (self.room.level if self.room is not None else 0.0), LEAST_VOICE)

    def _check_sentence(self, sentence: sentences.Sentence) -> None:
        """Label the sentence, or say why it must be read again."""
        samples, rate = self._capture.end()
        samples = samples[round(max(0.0, (self._voice_at or 0.0) - BEFORE_SENTENCE) * rate) :]
        room, teaches, folder = self.room.level if self.room else 0.0, self.step.teaches, self._takes.folder
        speaker = self._takes.speaker.strip() or UNNAMED

        def keep(_progress: Progress) -> LabelledUtterance:
            mono = to_mono_44k(samples, rate)
            for fault in check_take(mono, room, Phoneme.A).faults.values():
                raise TakeError(fault)
            if folder is None:
                raise TakeError(
                    tr("The background noise has not been recorded yet. Go back and keep quiet for two seconds.")
                )
            return sentences.keep_sentence(folder, samples, rate, mono, sentence, speaker, teaches=teaches)

        self._checks.replace(keep, self._take_sentence)
        self._show(Phase.CHECKING)

    def _take_sentence(self, spoken: LabelledUtterance) -> None:
        self.sentences[self.index] = spoken
        self._tell_checked("")

    def _ask_again(self, sentence: str) -> None:
        words = tr_engine(sentence)
        self._tell_checked(f"{words[0].upper()}{words[1:].rstrip('.')}.")

    def _tell_checked(self, advice: str) -> None:
        """Show for a while what came of a check."""
        self.advice = advice
        self._pause = ADVICE if advice else PRAISE
        self._capture.begin()
        self._show(Phase.SHOWING)

    def _check(self) -> None:
        if self.step.sentence is not None:
            self._check_sentence(self.step.sentence)
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
            before = partial(self.numbers.get, self.index)
            self._takes.add(samples, rate, phoneme, self._session.microphone.name, instead_of=before)
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
        """Begin to learn from the takes and the sentence that teaches, as soon as all takes are on the disk."""
        if self.phase is not Phase.LEARNING or self._takes.busy or self._work.busy:
            return
        numbers = set(self.numbers.values())
        wanted = [t for t in self._takes.now.takes if t.number in numbers and not t.excluded]
        sounds = {self._takes.path_of(take) for take in wanted}
        takes = [u for u in self._takes.utterances() if u.path in sounds]
        preset = self._preset.preset
        takes += [said for k, said in self.sentences.items() if self.steps[k].teaches]
        held_out = [said for k, said in self.sentences.items() if not self.steps[k].teaches]
        self._work.replace(
            lambda progress: self.learn(preset, takes, held_out=held_out, progress=progress), self._take_outcome
        )

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
            if self._unwanted and not self.running:
                self._takes.delete({number})

    def _note_refusal(self, _sentence: str) -> None:
        if self.phase is Phase.LEARNING and not self._takes.busy:
            self._awaited = []

    def _forget_work(self) -> None:
        for work in (self._work, self._checks):
            work.cancel()

    def _show(self, phase: Phase) -> None:
        self.phase = phase
        self.changed.emit()
