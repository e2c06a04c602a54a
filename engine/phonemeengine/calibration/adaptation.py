"""Adapting the learned recogniser to one voice, from a few seconds of it.

The last layers and the heads of the network move a few steps towards the voice (as in Y. Miao and F. Metze, "On
Speaker Adaptation of Long Short-Term Memory Recurrent Neural Networks", Interspeech 2015), and so does the head of
the real-time model where there is one. Anchors hold them: excerpts of other voices that must be named as before (D.
Yu et al., "KL-divergence regularized deep neural network adaptation", ICASSP 2013). How far along that way models
should go, if at all, is judged by `phonemeengine.calibration.calibrate` on held-out speech.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, UInt8Array
from phonemeengine.calibration import fine_tuning
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.dsp.mel import silent_log_mels
from phonemeengine.encoder.head import HALVES, N_OUTPUTS
from phonemeengine.encoder.live import LiveHead, open_live_encoder
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Progress, report_progress
from phonemeengine.labels.visemes import NO_VISEME, STANDARD_VISEMES, VisemeSet
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import states_in, with_real_time_model
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.learned import states_ahead
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.network import Layer, Network, StreamingLayer
from phonemeengine.recognition.scores import MOST_LOG_ODDS
from phonemeengine.settings import SAMPLE_RATE, ModelKind

ANCHORED, HEAD_ANCHORED = 0.5, 2.0
"""How much anchors count against the voice, for the small network and for the head of the real-time model, which has
more channels and half as many frames to learn from: with less it learns them by heart."""
N_TUNED = 3
"""Layers that move, at most; the first one of a network, which takes the sound itself, does not."""
SMOOTHING = 0.05
"""Share of the certainty that is spread over all phonemes: labels lie a little beside the truth."""
LEAST_SHARE = 1e-4
"""Probabilities below count as this, so that a few wrong labels do not choose a warp."""
LEAST_FRAMES = 3
"""A phoneme of which fewer frames are given is not touched."""
WARPS = (1.0, 1.2, 1.35, 1.5)
"""Warps of the mel bands that are tried for a voice: that of an adult, and those of children and cartoon voices."""
MOST_TRIED, SECONDS_TRIED = 30, 20.0
"""Takes by which a warp is chosen, and seconds from the beginning of each, at most."""
LEAST_GAIN = 0.1
"""By how much a warp must raise the mean log-likelihood of the labels, nats a frame, to be preferred."""
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


def step_sizes(warp: float) -> tuple[float, ...]:
    """Return `STEP_SIZES`; with a warp the last is 0, so that a child's voice gets its bands even if learning costs.

    They are as many, as quarters of the takes that are held out in turn may choose different warps.
    """
    return STEP_SIZES if warp == 1 else (*STEP_SIZES[:-1], 0.0)


@dataclass(frozen=True)
class _Encoded:
    """The inputs of the layers that move for a recording, its labels, and the weight of each frame.

    Attributes
    ----------
    hidden : float32, shape (n_frames + look-ahead, n_channels), or (n_frames / 2, n_channels) of the real-time model.
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
    def of(cls, viseme_set: VisemeSet, encoded: Sequence[_Encoded], kind: int) -> "_LabelStats":
        """Count the frames of the labels; vowels count only where the corners of the vowel space are there."""
        n = len(viseme_set.names) if kind else len(Phoneme)
        corners, vowels = (_shown_by(viseme_set, classes) if kind else classes for classes in (CORNERS, VOWELS))
        totals = sum((np.bincount(e.codes[kind], e.weights[kind], n) for e in encoded), np.zeros(n))
        if (totals[corners] < LEAST_FRAMES).any():
            totals[vowels] = 0
        competing = totals >= LEAST_FRAMES
        smoothed = (SMOOTHING * competing / max(1, int(competing.sum()))).astype(np.float32)
        targets = smoothed + np.float32(1 - SMOOTHING) * np.eye(n, dtype=np.float32)
        return cls(competing, (BALANCE / np.maximum(totals, BALANCE) * competing).astype(np.float32), targets)


def adapt(model: Model, examples: Sequence[fine_tuning.TrainingExample], warp: float = 1.0) -> tuple[Model, ...]:
    """Return a model adapted to the labelled recordings or takes of one voice, by each of `step_sizes`.

    Parameters
    ----------
    model : what is adapted.
    examples : labelled recordings or takes.
    warp : of the mel bands of which the examples were made.

    Raises
    ------
    CorpusError : there are less than two seconds of labelled sound, or only one phoneme.
    """
    encoded = [_encode(model, example) for example in examples if len(example)]
    known = np.concatenate([np.zeros(0, np.uint8), *(e.codes[0][e.weights[0] > 0] for e in encoded)])
    if len(known) < LEAST_SECONDS * 100 or len(np.unique(known)) < 2:
        raise CorpusError(
            f"{len(known) / 100:.1f} s of {len(np.unique(known))} phonemes are not enough to adapt to; "
            f"record {LEAST_SECONDS:g} s or more of several phonemes"
        )
    stats = _label_stats(model.viseme_set, encoded)
    tuned_model = _fine_tuned(model, _segments_of(encoded, stats, partial(_ahead, n_heads=len(model.heads))))
    told = {name: value for name, value in model.about.items() if name not in MEASURED}
    tracts = (1.0,) if stats[0].competing[CORNERS].all() else np.divide(model.warps, np.median(model.warps)).tolist()
    warps = tuple(warp * tract for tract in tracts)  # a model that knows the corners of the vowels needs one alone
    between = (_interpolated(model, tuned_model, share) for share in step_sizes(warp))
    return tuple(replace(moved, warps=warps, about=told) for moved in between)


def adapt_live_head(
    live: Preset, examples: Sequence[fine_tuning.TrainingExample], states: Sequence[Float32Array], warp: float = 1.0
) -> tuple[LiveHead, ...]:
    """Return the head of the real-time model adapted to one voice, by each of `step_sizes`.

    Parameters
    ----------
    live : a preset that recognises with the real-time model.
    examples : labelled recordings or takes.
    states : in each of them, see `states_in`.
    warp : of the mel bands from which the states come.
    """
    assert live.live_encoder is not None
    assert live.model is not None
    encoder = open_live_encoder(live.live_encoder)
    head, ahead = encoder.fitting(live.model.live_head), states_ahead(live.settings.look_ahead)
    encoded = [
        _labelled(hidden[: -(-len(example) // HALVES)], example, STANDARD_VISEMES, 2)
        for hidden, example in zip(states, examples, strict=True)
        if len(example)
    ]
    segments = _segments_of(encoded, _label_stats(STANDARD_VISEMES, encoded), _by_state)
    begun, kinds = OutputHead(head.weights, head.bias), _kinds_of(N_OUTPUTS)
    halves = _one_by_one(begun, HALVES)
    anchors = [_anchor_of(hidden, hidden, halves, kinds) for hidden in encoder.anchor_states(ahead)]
    tuned = fine_tuning.fine_tuned(
        (), begun, kinds, np.ones(HALVES, np.float32), segments, anchors, HEAD_ANCHORED
    ).head
    found = (_head_between(begun, tuned, share) for share in step_sizes(warp))
    return tuple(replace(head, weights=moved.weights, bias=moved.bias, warp=warp) for moved in found)


def adapt_to_takes(
    preset: Preset, takes: Sequence[LabelledUtterance], set_silence: Callable[[Preset], Preset], progress: Progress
) -> tuple[Preset, ...]:
    """Adapt a preset's models to a voice, further or less far, each with silence as it is and a little likelier.

    The last preset keeps the models. It is an `Adapt` of `phonemeengine.calibration.calibrate`.
    """
    assert preset.model is not None
    live = with_real_time_model(preset)
    warp = _best_warp(preset.model, takes)
    examples: list[fine_tuning.TrainingExample] = []
    states: list[Float32Array] = []
    for k, utterance in enumerate(takes):
        report_progress(progress, 0.5 * k / len(takes))
        sound = fine_tuning.sound_of(utterance)
        examples.append(fine_tuning.example_of(sound, utterance.labels, warp))
        if live.model_kind is ModelKind.ENCODER:
            states.append(states_in(live, fine_tuning.whisper_mels_of(sound, warp)))
    report_progress(progress, 0.5)
    models = adapt(preset.model, examples, warp)
    if live.model_kind is ModelKind.ENCODER:
        heads = adapt_live_head(live, examples, states, warp)
        models = tuple(replace(model, live_head=head) for model, head in zip(models, heads, strict=True))
    presets = [set_silence(replace(preset, model=model)) for model in models]
    return (*(found for adapted in presets for found in (adapted, _with_more_silence(adapted))), set_silence(preset))


def _best_warp(model: Model, takes: Sequence[LabelledUtterance]) -> float:
    """Return the warp of the mel bands with which a model recognises a voice best, by a part of long takes.

    Speakers are normalised so before anything is learned from them (L. Lee and R. Rose, "A Frequency Warping Approach
    to Speaker Normalization", IEEE Trans. Speech and Audio Processing 6(1), 1998).
    """
    # spread over all takes, which may be sorted by phoneme; the features of each are measured once for each warp
    chosen = takes[:: max(1, -(-len(takes) // MOST_TRIED))]
    some = [(fine_tuning.sound_of(take)[: int(SECONDS_TRIED * SAMPLE_RATE)], take) for take in chosen]

    def score(warp: float) -> float:
        examples = [fine_tuning.example_of(sound, take.labels, warp) for sound, take in some]
        return _likelihood_of(model, examples) - LEAST_GAIN * (warp != 1)

    return max(WARPS, key=score)


def _likelihood_of(model: Model, examples: Sequence[fine_tuning.TrainingExample]) -> float:
    """Return the mean logarithm of the probability of the labelled speech sounds, nats a frame; 0 without any.

    Silence tells nothing of a vocal tract: two seconds of it beside a sentence would outweigh a child's vowels.
    """
    total = n_frames = 0.0
    for example in examples:
        encoded, head = _encode(model, example), model.heads[-1]
        scores = _through_last_layers(model, encoded.hidden) @ head.weights + head.bias
        shares = fine_tuning.softmax_of(scores[len(model.heads) - 1 :], np.ones(len(Phoneme), bool))
        (codes, *_), (weights, *_) = encoded.codes, encoded.weights
        known = (weights > 0) & (codes != Phoneme.SILENCE)
        total += float(weights[known] @ np.log(np.maximum(shares[known, codes[known]], LEAST_SHARE)))
        n_frames += float(weights[known].sum())
    return total / n_frames if n_frames else 0.0


def _with_more_silence(preset: Preset) -> Preset:
    """Return back to silence what it loses where all phonemes count alike in learning."""
    now = preset.sensitivities.get(Phoneme.SILENCE, 0.0)
    given = min(now + GIVEN_TO_SILENCE, MOST_LOG_ODDS)
    return replace(preset, sensitivities={**preset.sensitivities, Phoneme.SILENCE: given})


# What both models learn from: labels, put where they answer, and anchors.


def _labelled(
    hidden: Float32Array, example: fine_tuning.TrainingExample, viseme_set: VisemeSet, n_kinds: int
) -> _Encoded:
    weights = example.certainties.astype(np.float32)
    visemes = viseme_set.codes_of(example.visemes, STANDARD_VISEMES)
    said = visemes != NO_VISEME
    codes = (example.phonemes, np.where(said, visemes, 0).astype(np.uint8))
    return _Encoded(hidden, codes[:n_kinds], (weights, weights * said)[:n_kinds])


def _label_stats(viseme_set: VisemeSet, encoded: Sequence[_Encoded]) -> list[_LabelStats]:
    return [_LabelStats.of(viseme_set, encoded, kind) for kind in range(len(encoded[0].codes))]


def _shown_by(viseme_set: VisemeSet, phonemes: UInt8Array) -> UInt8Array:
    """Return the visemes of a set that phonemes usually have."""
    visemes = viseme_set.usual_visemes(phonemes)
    return np.array([viseme for viseme in visemes.tolist() if viseme != NO_VISEME], np.uint8)


def _segments_of(
    encoded: Sequence[_Encoded], stats: Sequence[_LabelStats], place: Callable[[Float32Array], Float32Array]
) -> list[fine_tuning.TrainingSegment]:
    """Return what is to be answered; `place` puts what is known of each frame where the head answers for it."""
    kinds = range(len(stats))
    competing = np.concatenate([stat.competing for stat in stats])
    segments = []
    for e in encoded:
        targets = np.concatenate([stats[k].targets[e.codes[k]] for k in kinds], axis=1)
        weights = np.stack([e.weights[k] * stats[k].class_weights[e.codes[k]] for k in kinds], axis=1)
        if weights.any():
            segments.append(fine_tuning.TrainingSegment(e.hidden, place(targets), place(weights), competing))
    return segments


def _ahead(values: Float32Array, n_heads: int) -> Float32Array:
    """Place frames for heads of which number k answers k frames later."""
    n = len(values)
    placed = np.zeros((n + n_heads - 1, n_heads, *values.shape[1:]), np.float32)
    for k in range(n_heads):
        placed[k : k + n, k] = values
    return placed


def _by_state(values: Float32Array) -> Float32Array:
    """Place frames for a head that answers for two at once."""
    missing = np.zeros((len(values) % HALVES, *values.shape[1:]), np.float32)
    return np.concatenate((values, missing)).reshape(-1, HALVES, *values.shape[1:])


def _anchor_of(
    hidden: Float32Array, outputs: Float32Array, heads: Sequence[OutputHead], kinds: Sequence[slice]
) -> fine_tuning.TrainingSegment:
    """Return an excerpt of other voices, to be named as it is named now.

    Parameters
    ----------
    hidden, outputs : what the layers that move get, and what they make of it, shape (n_frames, n_channels).
    heads : on that, one for each answer, of all kinds.
    """
    scores = np.stack([outputs @ head.weights + head.bias for head in heads], axis=1)
    everything = np.ones(scores.shape[2], bool)
    targets = np.concatenate([fine_tuning.softmax_of(scores[..., kind], everything[kind]) for kind in kinds], axis=2)
    return fine_tuning.TrainingSegment(
        hidden, targets, np.ones((*targets.shape[:2], len(kinds)), np.float32), everything
    )


def _kinds_of(n_classes: int) -> tuple[slice, ...]:
    """Return the classes that compete with each other: phonemes, and visemes where there are any."""
    n = len(Phoneme)
    return (slice(0, n), slice(n, n_classes)) if n_classes > n else (slice(0, n),)


def _side_by_side(heads: Iterable[OutputHead]) -> OutputHead:
    known = list(heads)
    return OutputHead(np.concatenate([h.weights for h in known], axis=1), np.concatenate([h.bias for h in known]))


def _one_by_one(head: OutputHead, n: int) -> list[OutputHead]:
    parts = zip(np.split(head.weights, n, axis=1), np.split(head.bias, n), strict=True)
    return [OutputHead(*part) for part in parts]


def _head_between(a: OutputHead, b: OutputHead, share: float) -> OutputHead:
    return OutputHead(_between(a.weights, b.weights, share), _between(a.bias, b.bias, share))


def _between(a: Float32Array, b: Float32Array, share: float) -> Float32Array:
    """Return what lies a share of the way from one array to another."""
    return np.asarray(a + np.float32(share) * (b - a), np.float32)


# The small network.


def _encode(model: Model, example: fine_tuning.TrainingExample) -> _Encoded:
    """Run the first layers over an example, and as many frames of silence after it as the model looks ahead."""
    after = silent_log_mels(len(model.heads) - 1)
    hidden = _first_layers(model).forward(np.concatenate((example.log_powers.astype(np.float32), after)))
    return _labelled(hidden, example, model.viseme_set, 2 if model.viseme_heads else 1)


def _fine_tuned(model: Model, segments: Sequence[fine_tuning.TrainingSegment]) -> Model:
    """Return the model that has learned from the recordings."""
    heads = [_side_by_side(of_one) for of_one in zip(*_heads_by_kind(model), strict=True)]
    kinds, first = _kinds_of(len(heads[0].bias)), _first_tuned(model)
    anchors = []
    for log_powers in model.anchors:
        hidden = _first_layers(model).forward(log_powers)
        anchors.append(_anchor_of(hidden, _through_last_layers(model, hidden), heads, kinds))
    shares = fine_tuning.HEAD_SHARES[: len(heads)]
    tuned = fine_tuning.fine_tuned(
        model.layers[first:], _side_by_side(heads), kinds, shares, segments, anchors, ANCHORED
    )
    found = _one_by_one(tuned.head, len(heads))
    phonemes, *visemes = (tuple(OutputHead(h.weights[:, kind], h.bias[kind]) for h in found) for kind in kinds)
    layers = (*model.layers[:first], *tuned.layers)
    return replace(model, layers=layers, heads=phonemes, viseme_heads=visemes[0] if visemes else ()).rounded()


def _interpolated(model: Model, tuned_model: Model, share: float) -> Model:
    """Return the model that lies a share of the way from one to another."""
    layers = tuple(
        Layer(_between(a.weights, b.weights, share), _between(a.bias, b.bias, share), a.dilation)
        for a, b in zip(model.layers, tuned_model.layers, strict=True)
    )
    heads, viseme_heads = (
        tuple(_head_between(a, b, share) for a, b in zip(old, new, strict=True))
        for old, new in ((model.heads, tuned_model.heads), (model.viseme_heads, tuned_model.viseme_heads))
    )
    return replace(model, layers=layers, heads=heads, viseme_heads=viseme_heads).rounded()


def _heads_by_kind(model: Model) -> tuple[tuple[OutputHead, ...], ...]:
    return (model.heads, model.viseme_heads) if model.viseme_heads else (model.heads,)


def _first_tuned(model: Model) -> int:
    """Return the number of the first layer that moves."""
    return max(1, len(model.layers) - N_TUNED)


def _first_layers(model: Model) -> Network:
    return Network(model.layers[: _first_tuned(model)], silent_log_mels())


def _through_last_layers(model: Model, hidden: Float32Array) -> Float32Array:
    for layer in model.layers[_first_tuned(model) :]:
        hidden = hidden + StreamingLayer(layer, np.zeros(len(layer.bias), np.float32)).forward(hidden)
    return hidden
