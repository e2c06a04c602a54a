"""Adapting the learned recogniser to one voice, from a few seconds of it.

The last layers and the heads of the network move a few steps towards the voice (as in Y. Miao and F. Metze, "On
Speaker Adaptation of Long Short-Term Memory Recurrent Neural Networks", Interspeech 2015). Anchors hold them:
stretches of other voices that must be named as before (D. Yu et al., "KL-divergence regularized deep neural network
adaptation", ICASSP 2013). How far along that way a model should go, if at all, is judged by
`phonemeengine.calibration.calibrate` on what was held back.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, UInt8Array
from phonemeengine.calibration.fine_tuning import (
    TrainingSegment,
    TunedLayers,
    first_tuned,
    heads_of,
    kinds_of,
    softmax_of,
)
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.training_examples import TrainingExample, example_of_recording
from phonemeengine.dsp.log_mel import silent_log_mels
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Progress, report_progress
from phonemeengine.labels.visemes import NO_VISEME, STANDARD_VISEMES
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.network import Layer, Network, StreamingLayer
from phonemeengine.recognition.scores import MOST_LOG_ODDS

FEWEST_STEPS, MOST_STEPS, FRAMES_PER_STEP = 40, 120, 50
"""Steps that are taken: one for so many frames of the voice, within these bounds."""
MOST_FRAMES = 1500
"""Frames of the voice that a step hears; more of them take turns."""
ANCHORS_PER_STEP = 2
ANCHORED = 0.5
"""How much the anchors of a step count against the voice."""
SMOOTHING = 0.05
"""Share of the certainty that is spread over all phonemes: labels lie a little beside the truth."""
LEAST_FRAMES = 3
"""A phoneme of which fewer frames are given is not touched."""
NO_WARP = (1.0,)
"""The vocal tract that a model listens with which knows it."""
LEAST_SECONDS = 2.0
BALANCE = 30
"""Frames of a phoneme beyond which further ones count less, so that all phonemes count alike."""

CORNERS = np.array([Phoneme.A, Phoneme.I, Phoneme.U], np.uint8)
VOWELS = np.array([*CORNERS, Phoneme.E, Phoneme.O], np.uint8)
"""A network that learned some vowels alone would name them in all others, too."""
GIVEN_TO_SILENCE = 0.5
"""By how much silence becomes likelier in the second of each pair of adapted presets, nats."""
MEASURED = ("by_look_ahead_ms", "macro_f1")
"""What a model tells of its training's figures, which are not those of an adapted one."""
STEP_SIZES = (1.0, 0.5, 0.25)
"""Shares of the way from the model to what it learned, the boldest first."""


@dataclass(frozen=True)
class _Encoded:
    """What the layers that move hear in a recording, its labels, and what each frame counts.

    Attributes
    ----------
    hidden : float32, shape (n_frames + look-ahead, n_channels).
    codes : of the phonemes, and of the visemes where the model knows any, each of shape (n_frames,).
    weights : by kind as `codes`, each of shape (n_frames,); 0 where the labels do not say.
    """

    hidden: Float32Array
    codes: tuple[UInt8Array, ...]
    weights: tuple[Float32Array, ...]


@dataclass(frozen=True)
class _LabelStats:
    """Which classes of a kind are in the labels, and what a frame of each counts.

    Attributes
    ----------
    competing : the classes among which an answer is chosen, bool, shape (n_classes,).
    class_weights : float32, shape (n_classes,).
    targets : what is to be answered for each class, float32, shape (n_classes, n_classes).
    """

    competing: BoolArray
    class_weights: Float32Array
    targets: Float32Array

    @classmethod
    def of(cls, model: Model, encoded: Sequence[_Encoded], kind: int) -> "_LabelStats":
        """Count the frames of the labels; vowels count only where the corners of the vowel space are there."""
        n = len(model.viseme_set.names) if kind else len(Phoneme)
        corners, vowels = (_shown_by(model, classes) if kind else classes for classes in (CORNERS, VOWELS))
        totals = sum((np.bincount(e.codes[kind], e.weights[kind], n) for e in encoded), np.zeros(n))
        if (totals[corners] < LEAST_FRAMES).any():
            totals[vowels] = 0
        competing = totals >= LEAST_FRAMES
        smoothed = (SMOOTHING * competing / max(1, int(competing.sum()))).astype(np.float32)
        targets = smoothed + np.float32(1 - SMOOTHING) * np.eye(n, dtype=np.float32)
        return cls(competing, (BALANCE / np.maximum(totals, BALANCE) * competing).astype(np.float32), targets)


def adapt(model: Model, examples: Sequence[TrainingExample]) -> tuple[Model, ...]:
    """Return a model adapted to the labelled recordings or takes of one voice, by each of `STEP_SIZES`.

    Raises
    ------
    CorpusError : there are less than two seconds of labelled sound, or only one phoneme.
    """
    encoded = [_encode(model, example) for example in examples if len(example)]
    known = np.concatenate([np.zeros(0, np.uint8), *(e.codes[0][e.weights[0] > 0] for e in encoded)])
    if len(known) < LEAST_SECONDS * 100 or len(np.unique(known)) < 2:
        raise CorpusError(
            f"{len(known) / 100:.1f} s of {len(np.unique(known))} phonemes are too little to adapt to; "
            f"give {LEAST_SECONDS:g} s or more of several phonemes"
        )
    stats = [_LabelStats.of(model, encoded, kind) for kind in range(len(encoded[0].codes))]
    anchors = [_anchor_of(model, anchor) for anchor in model.anchors]
    tuned_model = _fine_tuned(model, _segments_of(encoded, stats, len(model.heads)), anchors)
    told = {name: value for name, value in model.about.items() if name not in MEASURED}
    warps = NO_WARP if stats[0].competing[CORNERS].all() else model.warps
    return tuple(replace(_interpolated(model, tuned_model, share), warps=warps, about=told) for share in STEP_SIZES)


def adapt_to_takes(
    preset: Preset, takes: Sequence[LabelledUtterance], set_silence: Callable[[Preset], Preset], progress: Progress
) -> tuple[Preset, ...]:
    """Adapt a preset's model to a voice, further or less far, each with silence as it is and a little likelier.

    The last preset keeps the model. It is an `Adapt` of `phonemeengine.calibration.calibrate`.
    """
    assert preset.model is not None
    examples: list[TrainingExample] = []
    for k, utterance in enumerate(takes):
        report_progress(progress, 0.5 * k / len(takes))
        examples.append(example_of_recording(utterance))
    report_progress(progress, 0.5)
    presets = [set_silence(replace(preset, model=model)) for model in adapt(preset.model, examples)]
    return (*(found for adapted in presets for found in (adapted, _with_more_silence(adapted))), set_silence(preset))


def _with_more_silence(preset: Preset) -> Preset:
    """Return back to silence what it loses where all phonemes count alike in learning."""
    now = preset.sensitivities.get(Phoneme.SILENCE, 0.0)
    given = min(now + GIVEN_TO_SILENCE, MOST_LOG_ODDS)
    return replace(preset, sensitivities={**preset.sensitivities, Phoneme.SILENCE: given})


def _fine_tuned(model: Model, segments: Sequence[TrainingSegment], anchors: Sequence[TrainingSegment]) -> Model:
    """Return the model that has learned from the recordings."""
    generator = np.random.default_rng(1)
    n_frames = sum(len(segment.inputs) for segment in segments)
    n_steps = int(np.clip(n_frames / FRAMES_PER_STEP, FEWEST_STEPS, MOST_STEPS))
    tuned = TunedLayers(model, n_steps, generator)
    for _ in range(n_steps):
        few = [anchors[k] for k in generator.permutation(len(anchors))[:ANCHORS_PER_STEP]]
        tuned.learn([(_draw(segments, generator), 1.0), (few, ANCHORED)])
    return tuned.model()


def _interpolated(model: Model, tuned_model: Model, share: float) -> Model:
    """Return the model that lies a share of the way from one to another."""

    def between(a: Float32Array, b: Float32Array) -> Float32Array:
        return np.asarray(a + np.float32(share) * (b - a), np.float32)

    layers = tuple(
        Layer(between(a.weights, b.weights), between(a.bias, b.bias), a.dilation)
        for a, b in zip(model.layers, tuned_model.layers, strict=True)
    )
    heads, viseme_heads = (
        tuple(
            OutputHead(between(a.weights, b.weights), between(a.bias, b.bias)) for a, b in zip(old, new, strict=True)
        )
        for old, new in ((model.heads, tuned_model.heads), (model.viseme_heads, tuned_model.viseme_heads))
    )
    return replace(model, layers=layers, heads=heads, viseme_heads=viseme_heads).rounded()


def _draw(segments: Sequence[TrainingSegment], generator: np.random.Generator) -> list[TrainingSegment]:
    """Draw stretches for a step: all, if they are not too many."""
    drawn: list[TrainingSegment] = []
    n_frames = 0
    for k in generator.permutation(len(segments)):
        if drawn and n_frames + len(segments[k].inputs) > MOST_FRAMES:
            break
        drawn.append(segments[k])
        n_frames += len(segments[k].inputs)
    return drawn


def _encode(model: Model, example: TrainingExample) -> _Encoded:
    """Run the first layers over an example, and as many frames of silence after it as the model looks ahead."""
    after = silent_log_mels(len(model.heads) - 1)
    hidden = _first_layers(model).forward(np.concatenate((example.log_powers.astype(np.float32), after)))
    weights = example.certainties.astype(np.float32)
    visemes = model.viseme_set.codes_of(example.visemes, STANDARD_VISEMES)
    said = visemes != NO_VISEME
    codes = (example.phonemes, np.where(said, visemes, 0).astype(np.uint8))
    n = 2 if model.viseme_heads else 1
    return _Encoded(hidden, codes[:n], (weights, weights * said)[:n])


def _shown_by(model: Model, phonemes: UInt8Array) -> UInt8Array:
    """Return the visemes of the model's set that phonemes usually have."""
    visemes = model.viseme_set.usual_visemes(phonemes)
    return np.array([viseme for viseme in visemes.tolist() if viseme != NO_VISEME], np.uint8)


def _segments_of(encoded: Sequence[_Encoded], stats: Sequence[_LabelStats], n_heads: int) -> list[TrainingSegment]:
    kinds = range(len(stats))
    competing = np.concatenate([stat.competing for stat in stats])
    segments = []
    for e in encoded:
        targets = np.concatenate([stats[k].targets[e.codes[k]] for k in kinds], axis=1)
        weights = np.stack([e.weights[k] * stats[k].class_weights[e.codes[k]] for k in kinds], axis=1)
        if weights.any():
            segments.append(TrainingSegment(e.hidden, _ahead(targets, n_heads), _ahead(weights, n_heads), competing))
    return segments


def _anchor_of(model: Model, log_powers: Float32Array) -> TrainingSegment:
    """Return a stretch of other voices, to be named as the model names it now."""
    hidden = _first_layers(model).forward(log_powers)
    outputs = _through_last_layers(model, hidden)
    heads = heads_of(model)
    everything = np.ones(len(heads[0].bias), bool)
    scores = np.stack([outputs @ head.weights + head.bias for head in heads], axis=1)
    kinds = kinds_of(model)
    targets = np.concatenate([softmax_of(scores[..., kind], everything[kind]) for kind in kinds], axis=2)
    return TrainingSegment(hidden, targets, np.ones((*targets.shape[:2], len(kinds)), np.float32), everything)


def _ahead(values: Float32Array, n_heads: int) -> Float32Array:
    """Put what is known of each frame where the heads answer for it: head k does so k frames later."""
    n = len(values)
    placed = np.zeros((n + n_heads - 1, n_heads, *values.shape[1:]), np.float32)
    for k in range(n_heads):
        placed[k : k + n, k] = values
    return placed


def _first_layers(model: Model) -> Network:
    return Network(model.layers[: first_tuned(model)], silent_log_mels())


def _through_last_layers(model: Model, hidden: Float32Array) -> Float32Array:
    for layer in model.layers[first_tuned(model) :]:
        hidden = hidden + StreamingLayer(layer, np.zeros(len(layer.bias), np.float32)).forward(hidden)
    return hidden
