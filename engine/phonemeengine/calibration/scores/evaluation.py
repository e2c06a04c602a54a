"""What a preset answers in labelled recordings, and how right that is: in all, by kind and by speaker."""

import math
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.alignment.align import align_analyses
from phonemeengine.analyser import BLOCK, Analyser, Analysis, analyse_blocks
from phonemeengine.arrays import BoolArray, Float32Array, Int64Array, UInt8Array
from phonemeengine.calibration.scores.added_noise import NoiseAdder
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance, OnSkipped, frame_labels_of
from phonemeengine.calibration.scores.scoring import N_CODES, Answers, Scores, confusion_of, macro_f1_of, scores_of
from phonemeengine.errors import AudioError, CorpusError
from phonemeengine.labels.utterance import Utterance
from phonemeengine.labels.visemes import NO_VISEME, STANDARD_VISEMES, Viseme, viseme_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import UNFITTED, ConfidenceCurve, calibration_errors, fit_confidence
from phonemeengine.recognition.segments import count_changes
from phonemeengine.recognition.spec import Recogniser
from phonemeengine.settings import FRAME_PERIOD, HOP
from phonemeengine.text.pronunciation import ScriptWord

WordsOf = Callable[[LabelledUtterance], Sequence[ScriptWord] | None]
"""Gives the words of a recording with their pronunciations; None where they are not known."""
HUMAN = "human"
"""Parts of a corpus whose names begin so are one kind."""
ROUNDING = 1e-9
"""Frames by which a delay may be off because decimal fractions are."""


@dataclass(frozen=True)
class Predictions:
    """What was answered in one recording, frame by frame.

    Attributes
    ----------
    utterance : the recording.
    labels : what was said.
    phonemes : uint8, shape (n_frames,): codes of `Phoneme`; silence where the sound has ended before its labels.
    intensities : float32, shape (n_frames,): 0..1.
    visemes : uint8, shape (n_frames,): codes of `Viseme`; None where they are those of the phonemes.
    confidences : float32, shape (n_frames,): confidence of the answers, 0..1; None where the words were known.
    """

    utterance: LabelledUtterance
    labels: FrameLabels
    phonemes: UInt8Array
    intensities: Float32Array
    visemes: UInt8Array | None = None
    confidences: Float32Array | None = None

    @property
    def answers(self) -> Answers:
        """The labels and the answers, as `scores_of` wants them."""
        if self.visemes is None:
            return self.labels, self.phonemes
        return self.labels, self.phonemes, self.visemes

    @property
    def right(self) -> BoolArray:
        """Where the answer is what the label says, shape (n_frames,)."""
        return np.equal(self.phonemes, self.labels.phonemes)


@dataclass(frozen=True)
class GroupScores:
    """How right the answers in some recordings are.

    Attributes
    ----------
    scores : the figures.
    confusion : int64, shape (11, 11): frames by label (row) and answer (column).
    changes, label_changes : how often the answer, and the label, becomes another.
    intensity : mean intensity of the frames labelled as speech, 0..1; NaN where there is none.
    n_recordings : how many they are.
    calibration_error : by how much confidences are off, on average; NaN where the words were known.
    largest_gap : between confidence and share right, of tenths of the confidence with at least 1 % of the frames.
    """

    scores: Scores
    confusion: Int64Array
    changes: int
    label_changes: int
    intensity: float
    n_recordings: int
    calibration_error: float = math.nan
    largest_gap: float = math.nan

    def f1_of(self, phoneme: Phoneme) -> float:
        """Return the F1 of one class; NaN where it is not labelled."""
        return float(macro_f1_of(self.confusion, (phoneme,)))


@dataclass(frozen=True)
class CorpusScores:
    """How right a preset is in a corpus.

    Attributes
    ----------
    preset : what was recognised with.
    look_ahead : frames for which its recogniser waits.
    delay : by how much the answers were taken to come late, seconds.
    predictions : what was answered in each recording.
    overall : the figures of all.
    by_kind, by_speaker : those of its parts, by name; parts whose names begin with "human" are one kind.
    """

    preset: Preset
    look_ahead: int
    delay: float
    predictions: tuple[Predictions, ...]
    overall: GroupScores
    by_kind: Mapping[str, GroupScores]
    by_speaker: Mapping[str, GroupScores]


def score(
    preset: Preset,
    corpus: Iterable[LabelledUtterance],
    *,
    delay: float = 0.0,
    noise: NoiseAdder | None = None,
    on_skipped: OnSkipped | None = None,
    words: WordsOf | None = None,
) -> CorpusScores:
    """Recognise recordings with a preset, and compare the answers with the labels.

    Parameters
    ----------
    preset : what is recognised with.
    corpus : the recordings; they are taken one by one, so that an iterator can report progress.
    delay : seconds by which the answers are taken to come late; what a recogniser looks ahead is no delay.
    noise : what is added to each recording before it is analysed.
    on_skipped : told of each sound that cannot be read, which is then left out; None refuses it.
    words : gives the words of a recording, which is then aligned with them.

    Raises
    ------
    AudioError : a sound cannot be read, and `on_skipped` is None.
    CorpusError : there is nothing to score.
    EngineError : the preset's recogniser cannot be used.
    """
    predictions = []
    for utterance in corpus:
        try:
            predictions.append(predict(utterance, preset, delay=delay, noise=noise, words=words))
        except AudioError as error:
            if on_skipped is None:
                raise
            on_skipped(error)
    return corpus_scores_of(preset, predictions, delay)


def corpus_scores_of(preset: Preset, predictions: Sequence[Predictions], delay: float = 0.0) -> CorpusScores:
    """Return how right answers of a preset are, which were taken to come late by some seconds.

    Raises
    ------
    CorpusError : there is nothing to score.
    """
    if not any(len(prediction.phonemes) for prediction in predictions):
        raise CorpusError("there is no labelled sound that can be scored; name recordings that can be read")
    return CorpusScores(
        preset=preset,
        look_ahead=Analyser(preset).recogniser.look_ahead,
        delay=delay,
        predictions=tuple(predictions),
        overall=group_scores_of(predictions),
        by_kind=_by(lambda p: kind_of(p.utterance), predictions),
        by_speaker=_by(lambda p: f"{kind_of(p.utterance)}/{p.utterance.speaker}", predictions),
    )


def predict(
    utterance: LabelledUtterance,
    preset: Preset,
    *,
    delay: float = 0.0,
    noise: NoiseAdder | None = None,
    words: WordsOf | None = None,
    recogniser: Recogniser | None = None,
) -> Predictions:
    """Recognise one recording; the parameters are those of `score`, and of `Analyser`.

    Raises
    ------
    AudioError : the sound cannot be read.
    """
    labels = frame_labels_of(utterance.labels)
    with utterance.opened() as reader:
        blocks = reader.blocks(BLOCK * HOP) if noise is None else noise.blocks(utterance, BLOCK * HOP)
        analyses = analyse_blocks(blocks, preset, recogniser=recogniser)
        found = _answers(analyses, None if words is None else words(utterance), reader.duration)
    late, n = math.floor(delay / FRAME_PERIOD + 0.5 + ROUNDING), len(labels.phonemes)
    phonemes, intensities, visemes, confidences = (shifted_frames(values, late, n) for values in found)
    return Predictions(utterance, labels, phonemes, intensities, visemes, confidences if words is None else None)


def _answers(
    analyses: Iterable[Analysis], words: Sequence[ScriptWord] | None, duration: float
) -> tuple[UInt8Array, Float32Array, UInt8Array, Float32Array]:
    """Return the phonemes of a sound's frames, as they are recognised or aligned, and what else is known of them.

    That is: their intensities, their visemes, and the recogniser's confidence.
    """
    n_in_sound = math.ceil(duration / FRAME_PERIOD - 0.5)  # frames whose middle lies in the sound
    nothing = np.zeros(0, np.uint8)
    found = [(nothing, np.zeros(0, np.float32), nothing, np.zeros(0, np.float32))]

    def recorded() -> Iterator[Analysis]:
        for analysis in analyses:
            visemes = STANDARD_VISEMES.codes_of(analysis.visemes, analysis.viseme_set)
            found.append((analysis.phonemes, analysis.intensities, visemes, analysis.confidences))
            yield analysis

    aligned = align_analyses(recorded(), words, duration) if words else None
    if aligned is None:
        deque(recorded(), maxlen=0)
    phonemes, intensities, visemes, sure = (np.concatenate(part)[:n_in_sound] for part in zip(*found, strict=True))
    if aligned is None:
        return phonemes, intensities, visemes, sure
    return frame_phonemes_of(aligned, n_in_sound), intensities, frame_visemes_of(aligned, n_in_sound), sure


def frame_phonemes_of(utterance: Utterance, n_frames: int) -> UInt8Array:
    """Return the codes of what is said in frames, uint8, shape (n_frames,); what lies between phones is silence."""
    phonemes = np.full(n_frames, Phoneme.SILENCE, np.uint8)
    for phone in utterance.phones:
        phonemes[round(phone.start / FRAME_PERIOD) : round(phone.end / FRAME_PERIOD)] = phone.phoneme
    return phonemes


def frame_visemes_of(utterance: Utterance, n_frames: int) -> UInt8Array:
    """Return what is seen of what is said in frames, uint8, shape (n_frames,): codes of `Viseme`, or `NO_VISEME`."""
    visemes = np.full(n_frames, Viseme.SIL, np.uint8)
    for phone in utterance.phones:
        seen = viseme_of(phone.ipa, phone.phoneme)
        first, last = round(phone.start / FRAME_PERIOD), round(phone.end / FRAME_PERIOD)
        visemes[first:last] = NO_VISEME if seen is None else seen
    return visemes


def group_scores_of(predictions: Sequence[Predictions]) -> GroupScores:
    """Score some recordings together; at least one has a frame."""
    pairs = [(prediction.labels, prediction.phonemes) for prediction in predictions]
    error, gap = _calibration_of(predictions)
    spoken = np.concatenate([p.intensities[p.labels.phonemes != Phoneme.SILENCE] for p in predictions], dtype=float)
    return GroupScores(
        scores=scores_of(prediction.answers for prediction in predictions),
        confusion=sum(
            (confusion_of(labels.phonemes, guess) for labels, guess in pairs), np.zeros((N_CODES, N_CODES), np.int64)
        ),
        changes=sum(count_changes(guess) for _, guess in pairs),
        label_changes=sum(count_changes(labels.phonemes) for labels, _ in pairs),
        intensity=float(spoken.mean()) if len(spoken) else math.nan,
        n_recordings=len(predictions),
        calibration_error=error,
        largest_gap=gap,
    )


def _calibration_of(predictions: Iterable[Predictions]) -> tuple[float, float]:
    """Compare confidences with what was right, where both are known."""
    sure, right = _confidences_in(predictions)
    known = ~np.isnan(sure)
    return calibration_errors(sure[known], right[known])


def _confidences_in(predictions: Iterable[Predictions]) -> tuple[Float32Array, BoolArray]:
    """Return the confidence of answers, NaN where unknown, and whether they are right, where labels are certain."""
    sure, right = [np.zeros(0, np.float32)], [np.zeros(0, bool)]
    for prediction in predictions:
        if prediction.confidences is not None:
            sure.append(prediction.confidences[prediction.labels.certain])
            right.append(prediction.right[prediction.labels.certain])
    return np.concatenate(sure), np.concatenate(right)


def confidence_of(predictions: Iterable[Predictions]) -> ConfidenceCurve:
    """Fit the confidence of answers, where labels are certain; without any, scores are used unchanged."""
    sure, right = _confidences_in(predictions)
    known = ~np.isnan(sure)
    return fit_confidence(sure[known], right[known]) if known.any() else UNFITTED


def kind_of(utterance: LabelledUtterance) -> str:
    """Return the kind of speech: the part of the corpus, or "human" for all parts whose names begin so."""
    return HUMAN if utterance.corpus.startswith(HUMAN) else utterance.corpus


def _by(name_of: Callable[[Predictions], str], predictions: Iterable[Predictions]) -> dict[str, GroupScores]:
    groups: dict[str, list[Predictions]] = {}
    for prediction in predictions:
        if len(prediction.phonemes):
            groups.setdefault(name_of(prediction), []).append(prediction)
    return {name: group_scores_of(groups[name]) for name in sorted(groups)}


def shifted_frames(values: NDArray[Any], late: int, n: int) -> NDArray[Any]:
    """Return `n` values of frames, of which the first is number `late`; zero (silence) where there is none."""
    shifted = np.zeros(n, values.dtype)
    first, last = max(0, late), min(len(values), late + n)
    if last > first:
        shifted[first - late : last - late] = values[first:last]
    return shifted
