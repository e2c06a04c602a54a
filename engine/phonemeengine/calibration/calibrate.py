"""Calibrating a preset to a voice: what it becomes, and what that gains on held-out speech.

The window, the command line and games do it by one function, and so get the same preset::

    result = calibrate(preset, read_recordings(takes), held_out=read_recordings(sentence))
    save_preset(result.preset, path)

What is learned from is never what it is judged by. Where nothing is held out, each quarter of all takes is, in
turn. Of the presets that a recogniser makes of the takes, the boldest is taken that raises the macro F1 on what was
held out, without costing more than 0.01 of mouth shapes or silence there; where there is none, the preset stays as
it was. A real-time model learns, too: what recognises live sound has to gain, and the small network, which serves
where the other one cannot be had, may not lose.
"""

import itertools
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from functools import lru_cache

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, UInt8Array
from phonemeengine.calibration.fine_tuning import sound_of, whisper_mels_of
from phonemeengine.calibration.scores.comparison import Gains, PairedAnswers, gains_of
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, frame_labels_of
from phonemeengine.calibration.scores.evaluation import Predictions, predict
from phonemeengine.calibration.scores.scoring import Scores, scores_of
from phonemeengine.calibration.takes.room_noise import SilenceAccuracy, measure_room, room_in, speech_in
from phonemeengine.calibration.takes.take import TRIMMED
from phonemeengine.errors import CorpusError, RecogniserError
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import for_files, recogniser_for, states_in, with_real_time_model
from phonemeengine.presets.preset import Judgement, Preset
from phonemeengine.recognition.spec import BUILT_IN, spec_of
from phonemeengine.settings import FRAME_PERIOD, ModelKind

Takes = Sequence[LabelledUtterance]
Adapt = Callable[[Preset, Takes, Callable[[Preset], Preset], Progress], tuple[Preset, ...]]
"""How a recogniser learns a voice; its specification names it.

Given a preset, takes, what makes a preset take the room for silence, and whom to tell how far it is, it gives several
presets, the boldest first: what learned most, and milder ones for the case that it costs too much.
"""
MOST_KEPT = 32
"""Recordings of which the real-time model's states are kept while presets are tried."""


@dataclass(frozen=True)
class CalibrationResult:
    """A preset after a calibration, to be accepted or refused.

    Attributes
    ----------
    start : the preset that was calibrated.
    preset : what it became; the same where nothing better was found.
    before, after : the figures of both on the held-out speech.
    seconds : how much of that counted.
    cross_validated : whether it was quarters of the takes, each of them in turn.
    cost : what a bolder preset, which was refused, would have cost; mostly nothing.
    gained : by how much macro F1 and mouth shapes rose, with the range that chance would give.
    warning : why the real-time model of the preset learned nothing, a sentence; mostly nothing.
    learned_seconds : how much of the takes was learned from.
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
    gained: Gains = field(default_factory=Gains)
    warning: str = ""
    learned_seconds: float = 0.0

    @property
    def is_clear(self) -> bool:
        """Whether mouth shapes and macro F1 both rose by more than chance."""
        return self.gained.are_clear

    @property
    def gains(self) -> bool:
        """Whether anything better was found."""
        return self.preset != self.start

    @property
    def refusal(self) -> str:
        """Why something that gained was not taken, a sentence; mostly nothing."""
        if not self.cost:
            return ""
        instead = "a weaker one was chosen" if self.gains else "the preset stays unchanged"
        return f"The strongest adaptation was rejected, because with it {self.cost}; {instead}."


def calibrate(
    preset: Preset,
    takes: Takes,
    *,
    held_out: Takes = (),
    room: Float32Array | None = None,
    progress: Progress = no_progress,
) -> CalibrationResult:
    """Make a preset that knows a voice, and return what that gains on the held-out speech.

    Parameters
    ----------
    preset : what is calibrated; its recogniser says how.
    takes : labelled recordings of the voice; those of silence alone tell what the room sounds like.
    held_out : labelled recordings of the same voice from which nothing is learned, such as a sentence that was
        read (`phonemeengine.calibration.takes.sentences` labels it);
        labels whose certainty is ``trimmed`` do not count.
    room : seconds of background noise, float32, shape (n,), 44.1 kHz; where it is None, the takes' silence.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    CorpusError : the recogniser does not learn voices, there are no takes, or too few, or nothing to judge by.
    AudioError : a sound cannot be read.
    Cancelled : `progress` did not want to go on.
    """
    adapt = _adapt_of(preset)
    if not takes:
        raise CorpusError("there are no takes to calibrate with; record some first")
    judged = held_out or takes
    if not any(counts(utterance.labels) for utterance in judged):
        raise CorpusError(
            "there is nothing to measure the result on; give takes or recordings whose labels are certain"
        )
    trials = _Trials(preset, adapt, room)
    found, trial = trials.on(takes, held_out, progress) if held_out else trials.cross_validated(takes, progress)
    if trial.index is not None:
        found = _with_model_for_files(found, judged, trial.small)
        found = _judged(preset, found, trial, _seconds(judged), cross_validated=not held_out)
    report_progress(progress, 1.0)
    accuracy = _silence_accuracy(trials.models.in_use(found), takes, room)
    return CalibrationResult(
        preset,
        found,
        trial.before,
        trial.after,
        _seconds(judged),
        not held_out,
        trial.cost,
        accuracy,
        trial.gained,
        trials.models.warning,
        _seconds(takes),
    )


@dataclass(frozen=True)
class _Trial:
    """Which of the adapted presets is taken, None for none; the figures, and what a bolder one would have cost.

    `small` are the figures afterwards without any real-time model; `gained` is what is taken gains, with its range.
    """

    index: int | None
    before: Scores
    after: Scores
    small: Scores
    cost: str
    gained: Gains = field(default_factory=Gains)


class _LiveModels:
    """The models by which live sound may be recognised: the small network, and the real-time model if there is one.

    Parameters
    ----------
    preset : what is calibrated.

    Attributes
    ----------
    small : the model kind of the small network, or of the preset's other recogniser.
    kinds : of all models; that in use is the first.
    warning : as of `CalibrationResult`.
    """

    def __init__(self, preset: Preset) -> None:
        live = with_real_time_model(preset)
        self.small: ModelKind = ModelKind.REAL_TIME if preset.model_kind is ModelKind.ENCODER else preset.model_kind
        self.kinds: tuple[ModelKind, ...] = (self.small,)
        self.warning = ""
        if live.model_kind is ModelKind.ENCODER:
            in_use = ModelKind.ENCODER in (preset.model_kind, preset.live_model)
            self.kinds = (ModelKind.ENCODER, self.small) if in_use else (self.small, ModelKind.ENCODER)
        elif preset.live_model is ModelKind.ENCODER and live.warnings != preset.warnings:
            self.warning = f"{live.warnings[-1]}, and it alone learned the voice."
        # the states of a sound are the same whatever the head on them learned
        self._states_of = lru_cache(MOST_KEPT)(
            lambda sound, warp: states_in(live, whisper_mels_of(sound_of(sound), warp))
        )

    def in_use(self, preset: Preset) -> Preset:
        """Return a preset that recognises with the model in use."""
        return self._with(self.kinds[0], preset)

    def predictions(self, kind: ModelKind, cases: Iterable[tuple[Preset, Takes]]) -> list[Predictions]:
        """Have presets recognise recordings with one of the models."""
        if kind is not ModelKind.ENCODER:
            return predictions_on((self._with(kind, preset), utterances) for preset, utterances in cases)
        found = []
        for preset, utterances in cases:
            live = self._with(kind, preset)
            warp = live.model.live_head.warp if live.model and live.model.live_head else 1.0
            for utterance in utterances:
                states = self._states_of(replace(utterance, labels=()), warp)
                found.append(predict(utterance, live, recogniser=recogniser_for(live, states)))
        return found

    @staticmethod
    def _with(kind: ModelKind, preset: Preset) -> Preset:
        return with_real_time_model(preset) if kind is ModelKind.ENCODER else replace(preset, model_kind=kind)


class _Trials:
    """Has a preset learn, and tries what it learned.

    Parameters
    ----------
    preset : what is calibrated.
    adapt : how its recogniser learns.
    room : as in `calibrate`.

    Attributes
    ----------
    models : that are tried.
    """

    def __init__(self, preset: Preset, adapt: Adapt, room: Float32Array | None) -> None:
        self.models = _LiveModels(preset)
        self._preset = preset
        self._adapt = adapt
        self._room = room

    def on(self, takes: Takes, held_out: Takes, progress: Progress) -> tuple[Preset, _Trial]:
        """Learn from all takes, and try that on other speech."""
        adapted = self._adapted(takes, subrange(progress, 0.0, 0.9))
        trial = self._tried([adapted], [held_out], held_out)
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
        kinds, first_cost = self.models.kinds, ""
        used, small = kinds[0], self.models.small
        old = {kind: self.models.predictions(kind, [(self._preset, judged)]) for kind in kinds}
        before = {kind: held_out_scores(old[kind]) for kind in kinds}
        for index, presets in enumerate(zip(*adapted, strict=True)):
            cases = list(zip(presets, kept, strict=True))
            new = {kind: self.models.predictions(kind, cases) for kind in kinds}
            after = {kind: held_out_scores(new[kind]) for kind in kinds}
            gains = after[used].macro_f1 > before[used].macro_f1
            names = ["", *(IN_MODEL[kind] for kind in kinds[1:])]  # figures of that in use are shown beside
            costs = [loss_of(before[kind], after[kind], name) for kind, name in zip(kinds, names, strict=True)]
            cost = next(filter(None, costs), "") if gains else ""
            if gains and not cost:
                gained = gains_of(paired_answers(old[used], new[used]))
                return _Trial(index, before[used], after[used], after[small], first_cost, gained)
            first_cost = first_cost or cost
        return _Trial(None, before[used], before[used], before[small], first_cost)


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


def _with_model_for_files(preset: Preset, judged: Takes, small: Scores) -> Preset:
    """Return the preset without its model for files, which learned nothing, where the small network is better now."""
    if preset.offline_model is None:
        return preset
    with_offline_model = held_out_scores(predictions_on([(for_files(preset, ModelKind.OFFLINE), judged)]))
    if with_offline_model.macro_f1 >= small.macro_f1:
        return preset
    return replace(preset, offline_model=None)


def _judged(start: Preset, found: Preset, trial: _Trial, seconds: float, *, cross_validated: bool) -> Preset:
    """Return a calibrated preset with what it was judged by, in place of the description of what it came from."""
    before, after = trial.before, trial.after
    judgement = Judgement(
        start=start.name if start.judged is None else start.judged.start,
        day=datetime.now(UTC).astimezone().date().isoformat(),
        seconds=round(seconds, 2),
        cross_validated=cross_validated,
        mouth_shapes=(round(before.viseme_accuracy, 4), round(after.viseme_accuracy, 4)),
        macro_f1=(round(before.macro_f1, 4), round(after.macro_f1, 4)),
    )
    return replace(found, judged=judgement, notes=start.notes if start.judged else "")


def _silence_accuracy(preset: Preset, takes: Takes, room: Float32Array | None) -> SilenceAccuracy | None:
    room = room_in(takes) if room is None else room
    return None if room is None else measure_room(room, preset).silence_accuracy(preset, speech_in(takes))


def _seconds(utterances: Takes) -> float:
    return sum(x.end - x.start for u in utterances for x in u.labels if x.certainty != TRIMMED)


# What a preset may not lose by knowing a voice better.

MOST_LOSS = 0.01
"""By how much a share may get worse."""
GUARDED = (
    ("mouth-shape accuracy", "viseme_accuracy", 1),
    ("silence recall", "silence_recall", 1),
    ("false silence", "false_silence", -1),
)
"""What is guarded: in words, the figure's name, and whether more of it is better (1) or worse (-1)."""


IN_MODEL = {ModelKind.ENCODER: " in the real-time model", ModelKind.REAL_TIME: " in the small network"}
"""How a loss ends that is not of the model in use."""


def loss_of(before: Scores, after: Scores, end: str = "") -> str:
    """Return what gets worse by more than `MOST_LOSS`, such as "silence recall falls from 99.9 % to 39.7 %".

    Empty where nothing does; what the labels do not hold is not asked.

    Parameters
    ----------
    before, after : figures.
    end : of the words, such as those of `IN_MODEL`.
    """
    losses = []
    for words, name, sign in GUARDED:
        old, new = float(getattr(before, name)), float(getattr(after, name))
        if sign * (old - new) > MOST_LOSS:
            losses.append(f"{words} {'falls' if sign > 0 else 'rises'} from {100 * old:.1f} % to {100 * new:.1f} %")
    return " and ".join(losses) + (end if losses else "")


N_PARTS = 4
"""Parts of each recording, each of which is held out once: so it is tried with nearly all that there is to learn."""

NOT_ASKED = 255
"""Stands for the answer about a frame that does not count."""

Utterances = tuple[LabelledUtterance, ...]


def parts_of(utterances: Sequence[LabelledUtterance]) -> Iterator[tuple[Utterances, Utterances]]:
    """Return what is learned from, and what is held out meanwhile, for each quarter of all recordings.

    Both are the whole recordings. What is held out is unidentified in the first; in both, what does not count is
    ``trimmed``.
    """
    for part in range(N_PARTS):
        halves = [_parted(utterance, part) for utterance in utterances]
        yield tuple(learned_from for learned_from, _ in halves), tuple(kept for _, kept in halves)


def predictions_on(cases: Iterable[tuple[Preset, Sequence[LabelledUtterance]]]) -> list[Predictions]:
    """Have presets recognise recordings.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    return [predict(utterance, preset) for preset, utterances in cases for utterance in utterances]


def held_out_scores(predictions: Sequence[Predictions]) -> Scores:
    """Score recordings, all together; labels that are ``trimmed`` do not count, but for the flicker."""
    scores = scores_of([_counted(prediction) for prediction in predictions])
    flicker = scores_of([prediction.answers for prediction in predictions])
    return replace(scores, changes_per_s=flicker.changes_per_s, label_changes_per_s=flicker.label_changes_per_s)


def paired_answers(before: Sequence[Predictions], after: Sequence[Predictions]) -> list[PairedAnswers]:
    """Return of each recording what was said and both answers, of the frames that count in both."""
    learned: dict[object, UInt8Array] = {}
    for prediction in after:
        codes = learned.setdefault(_key(prediction), np.full(len(prediction.phonemes), NOT_ASKED, np.uint8))
        kept = _kept(prediction)
        codes[kept] = prediction.phonemes[kept]
    pairs = []
    for prediction in before:
        codes = learned[_key(prediction)]
        both = _kept(prediction) & (codes != NOT_ASKED)
        pairs.append((prediction.labels.phonemes[both], prediction.phonemes[both], codes[both]))
    return pairs


def counts(labels: Sequence[Label]) -> bool:
    """Return whether anything of these labels counts."""
    return any(label.certainty != TRIMMED for label in labels)


def _counted(prediction: Predictions) -> tuple[FrameLabels, UInt8Array]:
    kept = _kept(prediction)
    return prediction.labels.at(kept), prediction.phonemes[kept]


def _key(prediction: Predictions) -> object:
    return prediction.utterance.path, prediction.utterance.channel


def _kept(prediction: Predictions) -> BoolArray:
    """Return which frames count, shape (n_frames,)."""
    trimmed = tuple(
        replace(label, phoneme=Phoneme.UNIDENTIFIED if label.certainty == TRIMMED else Phoneme.SILENCE)
        for label in prediction.utterance.labels
    )
    kept: BoolArray = frame_labels_of(trimmed).phonemes != Phoneme.UNIDENTIFIED
    return kept


def _parted(utterance: LabelledUtterance, part: int) -> tuple[LabelledUtterance, LabelledUtterance]:
    """Return a recording without a part of what counts in it, and with that part alone."""
    first, last = _borders_of(utterance.labels, part)
    pieces = [piece for label in utterance.labels for piece in _cut(label, first, last)]
    inside = [first <= piece.start < last for piece in pieces]
    hidden = [replace(piece, phoneme=Phoneme.UNIDENTIFIED, certainty=TRIMMED) for piece in pieces]
    learned_from = tuple(h if within else piece for piece, h, within in zip(pieces, hidden, inside, strict=True))
    kept = tuple(
        piece if within else replace(piece, certainty=TRIMMED) for piece, within in zip(pieces, inside, strict=True)
    )
    return replace(utterance, labels=learned_from), replace(utterance, labels=kept)


def _borders_of(labels: tuple[Label, ...], part: int) -> tuple[float, float]:
    """Return between which times a part lies, so that of what counts each has as much."""
    times = [np.arange(x.start, x.end, FRAME_PERIOD) for x in labels if x.certainty != TRIMMED]
    split = np.array_split(np.concatenate([np.zeros(0), *times]), N_PARTS)
    firsts = [float(piece[0]) if len(piece) else labels[-1].end for piece in split]
    edges = [0.0, *firsts[1:], labels[-1].end]
    return edges[part], edges[part + 1]


def _cut(label: Label, *times: float) -> list[Label]:
    borders = [label.start, *(time for time in times if label.start < time < label.end), label.end]
    return [replace(label, start=a, end=b) for a, b in itertools.pairwise(borders)]
