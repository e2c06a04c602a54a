"""Moves the last layers of a network, and its heads, a few steps towards the labels of recordings.

The layers are those of a finished model: nothing is normalised any more, and what comes before them stays as it is.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import BoolArray, Float32Array, UInt8Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.mel import FLOOR, mel_powers, warped_mel_bank
from phonemeengine.encoder.weights import N_MELS
from phonemeengine.encoder.whisper import whisper_log_mels
from phonemeengine.labels.utterance import Label
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import OutputHead
from phonemeengine.recognition.network import TAPS, Layer

TOGETHER = 512
"""Frames that are measured at once."""

CERTAINTIES = {"core": 1.0, "affricate": 1.0, "diphthong": 0.7, "ambiguous": 0.6}
"""How much a frame counts by the certainty of its label; what is not listed counts for nothing."""
NOT_SAID = 255
"""The code of what no label says."""
N_SOFT_LABELS = len(Phoneme) + len(Viseme)
"""Numbers that a teacher gives for a frame: the probabilities of the phonemes, then those of the visemes."""


@dataclass(frozen=True)
class TrainingExample:
    """One variation of one recording.

    Attributes
    ----------
    log_powers : float16, shape (n_frames, 40): base-10 logarithms of the mel powers.
    phonemes : uint8, shape (n_frames,): codes of `Phoneme`.
    visemes : uint8, shape (n_frames,): codes of `Viseme`, or `NO_VISEME` where that is disputed.
    certainties : float16, shape (n_frames,): how much each label counts, 0..1.
    soft_labels : float16, shape (n_frames, 26): the teacher's probabilities of phonemes and visemes; zeros where
        there is no teacher.
    """

    log_powers: NDArray[np.float16]
    phonemes: UInt8Array
    visemes: UInt8Array
    certainties: NDArray[np.float16]
    soft_labels: NDArray[np.float16]

    def __len__(self) -> int:
        return len(self.phonemes)


def example_of(
    samples: Float32Array,
    labels: tuple[Label, ...],
    warp: float = 1.0,
    soft_labels: NDArray[np.float16] | None = None,
) -> TrainingExample:
    """Measure a sound (float32, shape (n,), 44.1 kHz) that is labelled, or that has a teacher's probabilities."""
    bank = _bank(warp)
    parts = [np.log10(mel_powers(block, bank) + np.float32(FLOOR)) for block in windows_of(samples)]
    powers = np.concatenate(parts) if parts else np.zeros((0, bank.shape[1]), np.float32)
    n = len(powers) if soft_labels is not None else 0
    unsaid = np.full(n, NOT_SAID, np.uint8)
    phonemes, visemes = unsaid, unsaid
    if labels:
        frames = frame_labels_of(labels)
        n = min(len(powers), len(frames.phonemes))
        phonemes, visemes = frames.phonemes[:n], frames.visemes[:n]
    soft = np.zeros((n, N_SOFT_LABELS), np.float16)
    if soft_labels is not None:
        soft[: len(soft_labels)] = soft_labels[:n]
    return TrainingExample(powers[:n].astype(np.float16), phonemes, visemes, certainties_of(labels, n), soft)


def whisper_mels_of(samples: Float32Array, warp: float = 1.0) -> Float32Array:
    """Return what `whisper_log_mels` finds in a sound (float32, shape (n,), 44.1 kHz), shape (n_frames, 80)."""
    parts = [whisper_log_mels(block, warp) for block in windows_of(samples)]
    return np.concatenate([np.zeros((0, N_MELS), np.float32), *parts])


def sound_of(utterance: LabelledUtterance) -> Float32Array:
    """Return the samples of a recording, float32, shape (n,), mono at 44.1 kHz.

    Raises
    ------
    AudioError : the sound cannot be read.
    """
    with utterance.opened() as reader:
        return reader.read_mono()


def certainties_of(labels: tuple[Label, ...], n: int) -> NDArray[np.float16]:
    """Return how much each of n frames counts, 0..1, shape (n,)."""
    times = (np.arange(n) + 0.5) * 0.01
    certainties = np.zeros(n, np.float16)
    for label in labels:
        certainties[(times >= label.start) & (times < label.end)] = CERTAINTIES.get(label.certainty, 0.0)
    return certainties


def windows_of(samples: Float32Array) -> Iterator[Float32Array]:
    """Cut a sound into windows, some at a time, shape (n, 2048)."""
    framer = Framer()
    for windows in (framer.cut_frames(samples), framer.finish()):
        for k in range(0, len(windows), TOGETHER):
            yield windows[k : k + TOGETHER]


@lru_cache(maxsize=64)
def _bank(warp: float) -> Float32Array:
    return warped_mel_bank(warp)


# AdamW with one cycle of the learning rate.

FIRST, SECOND = 0.9, 0.999
DECAY = 0.01
CLIP = 1.0
WARM_UP = 0.15
"""Share of the steps in which the rate rises."""


class Optimiser:
    """Improves arrays in place, as AdamW has it (I. Loshchilov and F. Hutter, arXiv:1711.05101).

    Parameters
    ----------
    values : the arrays.
    n_steps : how many steps there will be.
    rate : the highest learning rate.
    """

    def __init__(self, values: list[Float32Array], n_steps: int, rate: float) -> None:
        self._values = values
        self._first = [np.zeros_like(v) for v in values]
        self._second = [np.zeros_like(v) for v in values]
        self._n_steps = n_steps
        self._rate = rate
        self.n_done = 0

    def step(self, gradients: list[Float32Array]) -> None:
        """Go one step down the gradients, which are clipped to a length of 1 together."""
        length = math.sqrt(sum(float(np.vdot(g, g)) for g in gradients))
        clip = np.float32(min(1.0, CLIP / max(length, 1e-12)))
        self.n_done += 1
        rate = self._rate * share_of_rate(self.n_done / self._n_steps)
        for k, (value, gradient) in enumerate(zip(self._values, gradients, strict=True)):
            step, decay = rate * self._adam(k, gradient * clip), rate * DECAY * (value.ndim > 1)
            np.multiply(value, np.float32(1 - decay), out=value)
            np.subtract(value, step, out=value, casting="same_kind")

    def _adam(self, k: int, gradient: Float32Array) -> Float32Array:
        first, second = self._first[k], self._second[k]
        np.add(first, np.float32(1 - FIRST) * (gradient - first), out=first)
        np.add(second, np.float32(1 - SECOND) * (gradient * gradient - second), out=second)
        debias = np.float32(math.sqrt(1 - SECOND**self.n_done) / (1 - FIRST**self.n_done))
        return np.asarray(debias * first / (np.sqrt(second) + np.float32(1e-8)), np.float32)


def share_of_rate(progress: float) -> float:
    """Return the share of the highest rate at a share of the steps: it rises and falls like a cosine, to almost 0."""
    if progress < WARM_UP:
        return 0.04 + 0.96 * (0.5 - 0.5 * math.cos(math.pi * progress / WARM_UP))
    return 1e-4 + 0.5 + 0.5 * math.cos(math.pi * min(1.0, (progress - WARM_UP) / (1 - WARM_UP)))


VISEME_SHARE = 0.5
"""How much the visemes count, beside the phonemes."""
HEAD_SHARES = np.array([0.11, 0.11, 0.15, 0.15, 0.15, 0.33], np.float32)
"""How much each look-ahead counts; a network with context on both sides has one answer."""
KIND_SHARES = np.array([1.0, VISEME_SHARE], np.float32)
RATE = 2e-3
DROPOUT = 0.2
"""Share of the layers' inputs that is dropped, so that they do not learn the recordings by heart."""
FEWEST_STEPS, MOST_STEPS, FRAMES_PER_STEP = 40, 120, 50
"""Steps that are taken: one for this many frames of the voice, within these bounds."""
MOST_FRAMES = 1500
"""Frames of the voice that a step learns from; more of them take turns."""
ANCHORS_PER_STEP = 2


@dataclass(frozen=True)
class TrainingSegment:
    """The inputs of the layers in an excerpt of speech, and what each head should answer.

    Attributes
    ----------
    inputs : float32, shape (n_frames, n_channels); silence before it is understood.
    targets : shares of the phonemes, and of the visemes where the model knows any, float32,
        shape (n_frames, n_heads, n_classes).
    weights : how much each answer counts, of either kind, float32, shape (n_frames, n_heads, n_kinds).
    competing : the classes among which an answer is chosen, bool, shape (n_classes,).
    """

    inputs: Float32Array
    targets: Float32Array
    weights: Float32Array
    competing: BoolArray


class TunedLayers:
    """Layers, and the head after them, which learn.

    Parameters
    ----------
    layers : of a network; none where the head alone learns.
    head : the scores of all classes for each answer, side by side.
    kinds : the classes of an answer that compete with each other.
    shares : how much each answer counts, shape (n_answers,).
    n_steps : how often `learn` will be called.
    generator : of what is dropped.
    """

    def __init__(
        self,
        layers: Sequence[Layer],
        head: OutputHead,
        kinds: Sequence[slice],
        shares: Float32Array,
        n_steps: int,
        generator: np.random.Generator,
    ) -> None:
        self._layers = [_TunableLayer(layer) for layer in layers]
        self._weights, self._bias = head.weights.copy(), head.bias.copy()
        self._kinds, self._shares = kinds, shares[:, np.newaxis] * KIND_SHARES[: len(kinds)]
        values = [v for layer in self._layers for v in layer.values] + [self._weights, self._bias]
        self._optimiser = Optimiser(values, n_steps, RATE)
        self._generator = generator

    @property
    def layers(self) -> tuple[Layer, ...]:
        """The layers as they are now."""
        return tuple(layer.finished() for layer in self._layers)

    @property
    def head(self) -> OutputHead:
        """The head as it is now."""
        return OutputHead(self._weights, self._bias)

    def learn(self, parts: Iterable[tuple[Sequence[TrainingSegment], float]]) -> None:
        """Take one step; each part is a number of excerpts, and what they count together."""
        gradients = [np.zeros_like(v) for layer in self._layers for v in layer.values]
        gradients += [np.zeros_like(self._weights), np.zeros_like(self._bias)]
        for segments, weight in parts:
            if not segments:
                continue
            total = np.sum([segment.weights.sum(axis=0) for segment in segments], axis=0)
            factors = weight * self._shares / np.maximum(total, 1e-9)
            for segment in segments:
                for k, more in enumerate(self._gradients_of(segment, factors)):
                    gradients[k] += more
        self._optimiser.step(gradients)

    def _gradients_of(self, segment: TrainingSegment, factors: Float32Array) -> list[Float32Array]:
        kept = self._generator.random(segment.inputs.shape, np.float32) >= DROPOUT
        hidden: Float32Array = segment.inputs * kept / np.float32(1 - DROPOUT)
        for layer in self._layers:
            hidden = layer.forward(hidden)
        scores = (hidden @ self._weights + self._bias).reshape(segment.targets.shape)
        errors = -segment.targets
        for k, kind in enumerate(self._kinds):
            errors[..., kind] += softmax_of(scores[..., kind], segment.competing[kind])
            errors[..., kind] *= (segment.weights[..., k] * factors[:, k])[..., np.newaxis]
        sums = errors.reshape(len(hidden), -1)
        back = sums @ self._weights.T
        found = [hidden.T @ sums, sums.sum(axis=0)]
        for layer in reversed(self._layers):
            back, gradients = layer.back(back)
            found = [*gradients, *found]
        return found


def fine_tuned(
    layers: Sequence[Layer],
    head: OutputHead,
    kinds: Sequence[slice],
    shares: Float32Array,
    segments: Sequence[TrainingSegment],
    anchors: Sequence[TrainingSegment],
    anchored: float,
) -> TunedLayers:
    """Return layers and a head that have learned from a voice.

    Parameters
    ----------
    layers, head, kinds, shares : as of `TunedLayers`.
    segments : of the voice.
    anchors : excerpts of other voices, which are to be named as before; some of them, at random, in each step.
    anchored : how much the anchors of a step count against the voice.
    """
    generator = np.random.default_rng(1)
    n_frames = sum(len(segment.inputs) for segment in segments)
    n_steps = int(np.clip(n_frames / FRAMES_PER_STEP, FEWEST_STEPS, MOST_STEPS))
    tuned = TunedLayers(layers, head, kinds, shares, n_steps, generator)
    for _ in range(n_steps):
        few = [anchors[k] for k in generator.permutation(len(anchors))[:ANCHORS_PER_STEP]]
        tuned.learn([(_draw(segments, generator), 1.0), (few, anchored)])
    return tuned


def _draw(segments: Sequence[TrainingSegment], generator: np.random.Generator) -> list[TrainingSegment]:
    """Draw excerpts for a step: all, if they are not too many."""
    drawn: list[TrainingSegment] = []
    n_frames = 0
    for k in generator.permutation(len(segments)):
        if drawn and n_frames + len(segments[k].inputs) > MOST_FRAMES:
            break
        drawn.append(segments[k])
        n_frames += len(segments[k].inputs)
    return drawn


class _TunableLayer:
    """One layer that learns; see `phonemeengine.recognition.network.Layer`."""

    def __init__(self, layer: Layer) -> None:
        self.values = [layer.weights.copy(), layer.bias.copy()]
        self._dilation = layer.dilation
        self._reach = layer.reach

    def forward(self, block: Float32Array) -> Float32Array:
        """Return the output of the layer, and remember what `back` needs."""
        n = len(block)
        padded = np.concatenate((np.zeros((self._reach, block.shape[1]), np.float32), block))
        starts = range(0, self._reach + 1, self._dilation)
        self._taps = np.concatenate([padded[k : k + n] for k in starts], axis=1)
        found: Float32Array = np.maximum(self._taps @ self.values[0] + self.values[1], 0)
        self._fires = found > 0
        return found + block

    def back(self, gradient: Float32Array) -> tuple[Float32Array, list[Float32Array]]:
        """Take the gradient of what `forward` gave; give that of what it took, and those of weights and bias."""
        sums = gradient * self._fires
        taps = (sums @ self.values[0].T).reshape(len(gradient), TAPS, -1)
        block = gradient + taps[:, TAPS - 1]
        for k in range(TAPS - 1):
            delay = (TAPS - 1 - k) * self._dilation
            block[: max(0, len(block) - delay)] += taps[delay:, k]
        return block, [self._taps.T @ sums, sums.sum(axis=0)]

    def finished(self) -> Layer:
        return Layer(self.values[0], self.values[1], self._dilation)


def softmax_of(scores: Float32Array, competing: BoolArray) -> Float32Array:
    """Return the probabilities of the competing classes, which lie on the last axis; those of the others are 0."""
    if not competing.any():
        return np.zeros_like(scores)
    shares = np.where(competing, scores, -np.inf)
    shares -= shares.max(axis=-1, keepdims=True)
    np.exp(shares, out=shares)
    shares /= shares.sum(axis=-1, keepdims=True)
    return np.asarray(shares, np.float32)
