"""Calibrating a preset to a voice: what it becomes, and what that gains on speech that was held back.

The window, the command line and games do it by one function, and so get the same preset::

    result = calibrate(preset, read_recordings(takes), held_back=read_recordings(sentence))
    save_preset(result.preset, path)

What is learned from is never what it is judged by. Where nothing is held back, each quarter of all takes is, in
turn. Of the presets that a recogniser makes of the takes, the boldest is taken that raises the macro F1 on what was
held back, without costing more than 0.01 of mouth shapes or silence there; where there is none, the preset stays as
it was.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.held_back import (
    N_PARTS,
    counts,
    gains_beyond_chance,
    held_back_scores,
    loss_of,
    paired_answers,
    parts_of,
    predictions_on,
)
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.scoring import Scores
from phonemeengine.calibration.takes.room_noise import SilenceAccuracy, measure_room, room_in, speech_in
from phonemeengine.calibration.takes.take import TRIMMED
from phonemeengine.errors import CorpusError, RecogniserError
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.presets.ears import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.spec import BUILT_IN, spec_of
from phonemeengine.settings import Ear

Takes = Sequence[LabelledUtterance]
Adapt = Callable[[Preset, Takes, Callable[[Preset], Preset], Progress], tuple[Preset, ...]]
"""How a recogniser learns a voice; its specification names it.

Given a preset, takes, what makes a preset take the room for silence, and whom to tell how far it is, it gives several
presets, the boldest first: what learned most, and milder ones for the case that it costs too much.
"""


@dataclass(frozen=True)
class CalibrationResult:
    """A preset after a calibration, to be accepted or refused.

    Attributes
    ----------
    start : the preset that was calibrated.
    preset : what it became; the same where nothing better was found.
    before, after : the figures of both on what was held back.
    seconds : how much of that counted.
    cross_validated : whether it was quarters of the takes, each of them in turn.
    cost : what a bolder preset, which was refused, would have cost; mostly nothing.
    is_clear : whether mouth shapes and macro F1 both rose by more than chance, see `gains_beyond_chance`.
    silence_accuracy : how well the preset tells the room from speech, as far as the takes say; None where they hold
        no silence.
    """

    start: Preset
    preset: Preset
    before: Scores
    after: Scores
    seconds: float
    cross_validated: bool
    cost: str = ""
    silence_accuracy: SilenceAccuracy | None = None
    is_clear: bool = False

    @property
    def gains(self) -> bool:
        """Whether anything better was found."""
        return self.preset != self.start

    @property
    def refusal(self) -> str:
        """Why something that gained was not taken, a sentence; mostly nothing."""
        if not self.cost:
            return ""
        instead = "something milder was taken" if self.gains else "the preset stays as it was"
        return f"What learned most was refused, since with it {self.cost}; {instead}."


def calibrate(
    preset: Preset,
    takes: Takes,
    *,
    held_back: Takes = (),
    room: Float32Array | None = None,
    progress: Progress = no_progress,
) -> CalibrationResult:
    """Make a preset that knows a voice, and tell what that gains on what was held back.

    Parameters
    ----------
    preset : what is calibrated; its recogniser says how.
    takes : labelled recordings of the voice; those of silence alone tell what the room sounds like.
    held_back : labelled recordings of the same voice from which nothing is learned, such as a sentence that was
        read (`phonemeengine.calibration.alignment` labels it); labels whose certainty is ``trimmed`` do not count.
    room : seconds in which nobody speaks, float32, shape (n,), 44.1 kHz; where it is None, the takes' silence.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    CorpusError : the recogniser does not learn voices, there are no takes, or too few, or nothing to judge by.
    AudioError : a sound cannot be read.
    Cancelled : `progress` did not want to go on.
    """
    adapt = _adapt_of(preset)
    if not takes:
        raise CorpusError("there is no take to calibrate with; record some first")
    judged = held_back or takes
    if not any(counts(utterance.labels) for utterance in judged):
        raise CorpusError("there is nothing to judge by; give takes or recordings with labels that count")
    trials = _Trials(preset, adapt, room)
    found, trial = trials.on(takes, held_back, progress) if held_back else trials.cross_validated(takes, progress)
    if trial.index is not None:
        found = _with_ear_for_files(found, judged, trial.after)
    report_progress(progress, 1.0)
    accuracy = _silence_accuracy(found, takes, room)
    return CalibrationResult(
        preset,
        found,
        trial.before,
        trial.after,
        _seconds(judged),
        not held_back,
        trial.cost,
        accuracy,
        trial.is_clear,
    )


@dataclass(frozen=True)
class _Trial:
    """Which of the adapted presets is taken, None for none; the figures, and what a bolder one would have cost.

    `is_clear` says whether what is taken gains more than chance.
    """

    index: int | None
    before: Scores
    after: Scores
    cost: str
    is_clear: bool = False


class _Trials:
    """Has a preset learn, and tries what it learned.

    Parameters
    ----------
    preset : what is calibrated.
    adapt : how its recogniser learns.
    room : as in `calibrate`.
    """

    def __init__(self, preset: Preset, adapt: Adapt, room: Float32Array | None) -> None:
        self._preset = preset
        self._adapt = adapt
        self._room = room

    def on(self, takes: Takes, held_back: Takes, progress: Progress) -> tuple[Preset, _Trial]:
        """Learn from all takes, and try that on other speech."""
        adapted = self._adapted(takes, subrange(progress, 0.0, 0.9))
        trial = self._tried([adapted], [held_back], held_back)
        return self._preset if trial.index is None else adapted[trial.index], trial

    def cross_validated(self, takes: Takes, progress: Progress) -> tuple[Preset, _Trial]:
        """Learn without each quarter of the takes in turn, and try that on the quarter; then learn from all."""
        adapted, kept = [], []
        for k, (others, quarter) in enumerate(parts_of(takes)):
            share = 0.9 / (N_PARTS + 1)
            adapted.append(self._adapted(others, subrange(progress, k * share, (k + 1) * share)))
            kept.append(quarter)
        trial = self._tried(adapted, kept, takes)
        if trial.index is None:
            return self._preset, trial
        return self._adapted(takes, subrange(progress, 0.8, 1.0))[trial.index], trial

    def _adapted(self, takes: Takes, progress: Progress) -> tuple[Preset, ...]:
        found = self._adapt(self._preset, takes, lambda preset: _with_silence(preset, takes, self._room), progress)
        if not isinstance(found, tuple) or not all(isinstance(preset, Preset) for preset in found):
            raise RecogniserError(
                f"the recogniser {self._preset.recogniser!r} must learn a tuple of presets, got a "
                f"{type(found).__name__}; choose another recogniser"
            )
        return found

    def _tried(self, adapted: Sequence[tuple[Preset, ...]], kept: Sequence[Takes], judged: Takes) -> _Trial:
        """Try what was learned on what was kept from it; together these are what is judged by."""
        old = predictions_on([(self._preset, judged)])
        before, first_cost = held_back_scores(old), ""
        for index, presets in enumerate(zip(*adapted, strict=True)):
            new = predictions_on(zip(presets, kept, strict=True))
            after = held_back_scores(new)
            cost = loss_of(before, after) if after.macro_f1 > before.macro_f1 else ""
            if after.macro_f1 > before.macro_f1 and not cost:
                return _Trial(index, before, after, first_cost, gains_beyond_chance(paired_answers(old, new)))
            first_cost = first_cost or cost
        return _Trial(None, before, before, first_cost)


def _adapt_of(preset: Preset) -> Adapt:
    spec = spec_of(preset.recogniser)
    if not spec.adapt:
        raise CorpusError(
            f"the recogniser {preset.recogniser!r} does not learn voices; choose one of "
            f"{', '.join(name for name, known in BUILT_IN.items() if known.adapt)}"
        )
    adapt: Adapt = spec.load(spec.adapt)
    return adapt


def _with_silence(preset: Preset, takes: Takes, room: Float32Array | None) -> Preset:
    """Return the preset that takes the room for silence; where the room was not quiet, the same preset."""
    room = room_in(takes) if room is None else room
    measured = None if room is None else measure_room(room, preset)
    if measured is None or measured.notes:
        return preset
    return measured.set_silence(preset, speech_in(takes))


def _with_ear_for_files(preset: Preset, judged: Takes, live: Scores) -> Preset:
    """Return the preset without its model for files, which has learned nothing, where the other one is better now."""
    if preset.file_model is None:
        return preset
    with_twin = held_back_scores(predictions_on([(for_files(preset, Ear.TWIN), judged)]))
    if with_twin.macro_f1 >= live.macro_f1:
        return preset
    return replace(preset, file_model=None)


def _silence_accuracy(preset: Preset, takes: Takes, room: Float32Array | None) -> SilenceAccuracy | None:
    room = room_in(takes) if room is None else room
    return None if room is None else measure_room(room, preset).silence_accuracy(preset, speech_in(takes))


def _seconds(utterances: Takes) -> float:
    return sum(x.end - x.start for u in utterances for x in u.labels if x.certainty != TRIMMED)
