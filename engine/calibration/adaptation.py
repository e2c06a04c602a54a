"""Adapting the learned recogniser to one voice, from a few seconds of it.

The last layers and the heads of the network move a few steps towards the voice (as in Y. Miao and F. Metze, "On
Speaker Adaptation of Long Short-Term Memory Recurrent Neural Networks", Interspeech 2015). Anchors hold them:
stretches of other voices that must be named as before (D. Yu et al., "KL-divergence regularized deep neural network
adaptation", ICASSP 2013). Each half of every recording is recognised by what the other halves taught; where that does
not make its labels likelier, nothing is changed.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from engine.calibration.fine_tuning import Stretch, TunedLayers, first_tuned
from engine.calibration.learning.lessons import Lesson
from engine.dsp.log_mel import FLOOR, N_BANDS
from engine.errors import CorpusError
from engine.phonemes import Phoneme
from engine.recognition.model import Head, Model
from engine.recognition.network import Delayed, Network

FEWEST_STEPS, MOST_STEPS, FRAMES_PER_STEP = 30, 120, 50
"""Steps that are taken: one for so many frames of the voice, within these bounds."""
MOST_FRAMES = 1500
"""Frames of the voice that a step hears; more of them take turns."""
ANCHORS_PER_STEP = 2
ANCHORED = 1.0
"""How much the anchors of a step count against the voice."""
SMOOTHING = 0.05
"""Share of the certainty that is spread over all phonemes: labels lie a little beside the truth."""
LEAST_FRAMES = 3
"""A phoneme of which fewer frames are given is not touched."""
LEAST_GAIN = 0.002
"""By how much likelier the labels must be that are held back."""
LEAST_SECONDS = 2.0
BALANCE = 30
"""Frames of a phoneme beyond which further ones count less, so that all phonemes count alike."""

Block = NDArray[np.float32]
_HALVES = (0, 1)


@dataclass(frozen=True)
class Adaptation:
    """A model that knows a voice.

    Attributes
    ----------
    model : the adapted one; the same as before where nothing helped.
    before, after : how likely the labels were where they were held back, 0..1, the geometric mean of all frames.
    """

    model: Model
    before: float
    after: float

    @property
    def gains(self) -> bool:
        """Whether anything helped."""
        return self.after > self.before


@dataclass(frozen=True)
class _Heard:
    """What the layers that move hear in a recording, its labels, what each frame counts, and which half it is in."""

    hidden: Block
    phonemes: NDArray[np.uint8]
    counted: Block
    halves: NDArray[np.int_]


def adapt(model: Model, lessons: Sequence[Lesson]) -> Adaptation:
    """Adapt a model to the labelled recordings or takes of one voice.

    Raises
    ------
    CorpusError : there are less than two seconds of labelled sound, or only one phoneme.
    """
    heard = [_heard(model, lesson) for lesson in lessons if len(lesson)]
    known = np.concatenate([h.phonemes[h.counted > 0] for h in heard]) if heard else np.zeros(0, np.uint8)
    if len(known) < LEAST_SECONDS * 100 or len(np.unique(known)) < 2:
        raise CorpusError(
            f"{len(known) / 100:.1f} s of {len(np.unique(known))} phonemes are too little to adapt to; "
            f"give {LEAST_SECONDS:g} s or more of several phonemes"
        )
    anchors = [_anchor_of(model, anchor) for anchor in model.anchors]
    before = _likelihood([(model, heard, _HALVES)])
    after = _likelihood([(_moved(model, heard, anchors, 1 - half), heard, (half,)) for half in _HALVES])
    if after < before + LEAST_GAIN:
        return Adaptation(model, before, before)
    return Adaptation(_moved(model, heard, anchors), before, after)


def _moved(model: Model, heard: Sequence[_Heard], anchors: Sequence[Stretch], half: int | None = None) -> Model:
    """Give the model that has learned from the recordings, or from one half of each."""
    generator = np.random.default_rng(1)
    stretches = _stretches_of(heard, half, len(model.heads))
    n_frames = sum(len(stretch.heard) for stretch in stretches)
    n_steps = int(np.clip(n_frames / FRAMES_PER_STEP, FEWEST_STEPS, MOST_STEPS))
    tuned = TunedLayers(model, n_steps, generator)
    for _ in range(n_steps):
        few = [anchors[k] for k in generator.permutation(len(anchors))[:ANCHORS_PER_STEP]]
        tuned.learn([(_drawn(stretches, generator), 1.0), (few, ANCHORED)])
    return tuned.model()


def _drawn(stretches: Sequence[Stretch], generator: np.random.Generator) -> list[Stretch]:
    """Draw stretches for a step: all, if they are not too many."""
    drawn: list[Stretch] = []
    n_frames = 0
    for k in generator.permutation(len(stretches)):
        if drawn and n_frames + len(stretches[k].heard) > MOST_FRAMES:
            break
        drawn.append(stretches[k])
        n_frames += len(stretches[k].heard)
    return drawn


def _likelihood(cases: Sequence[tuple[Model, Sequence[_Heard], Sequence[int]]]) -> float:
    """Give how likely models find the labels of some halves, the geometric mean of all frames."""
    total = count = 0.0
    for model, heard, halves in cases:
        n_ahead = len(model.heads) - 1
        for h in heard:
            shares = _shares_of(_through_last_layers(model, h.hidden)[n_ahead:], model.heads[-1])
            counted = h.counted * np.isin(h.halves, halves)
            likely = np.maximum(shares[np.arange(len(shares)), h.phonemes], 1e-9)
            total += float(counted @ np.log(likely))
            count += float(counted.sum())
    return float(np.exp(total / max(count, 1e-9)))


def _heard(model: Model, lesson: Lesson) -> _Heard:
    """Run the first layers over a lesson, and as many frames of silence after it as the model looks ahead."""
    after = np.full((len(model.heads) - 1, N_BANDS), np.log10(FLOOR), np.float32)
    hidden = _first_layers(model).push(np.concatenate((lesson.log_powers.astype(np.float32), after)))
    certain = np.flatnonzero(lesson.certainties > 0)
    middle = certain[len(certain) // 2] if len(certain) else len(lesson) // 2
    halves = (np.arange(len(lesson)) >= middle).astype(int)
    return _Heard(hidden, lesson.phonemes, lesson.certainties.astype(np.float32), halves)


def _stretches_of(heard: Sequence[_Heard], half: int | None, n_heads: int) -> list[Stretch]:
    counted = [h.counted * (True if half is None else h.halves == half) for h in heard]
    phonemes = np.concatenate([h.phonemes for h in heard])
    totals = np.bincount(phonemes, np.concatenate(counted), len(Phoneme))
    competing = totals >= LEAST_FRAMES
    balance = BALANCE / np.maximum(totals, BALANCE) * competing
    smoothed = (SMOOTHING * competing / max(1, int(competing.sum()))).astype(np.float32)
    wanted = smoothed + np.float32(1 - SMOOTHING) * np.eye(len(Phoneme), dtype=np.float32)
    return [
        Stretch(
            h.hidden,
            _ahead(wanted[h.phonemes], n_heads),
            _ahead((c * balance[h.phonemes]).astype(np.float32), n_heads),
            competing,
        )
        for h, c in zip(heard, counted, strict=True)
        if c.any()
    ]


def _anchor_of(model: Model, log_powers: Block) -> Stretch:
    """Give a stretch of other voices, to be named as the model names it now."""
    hidden = _first_layers(model).push(log_powers)
    found = _through_last_layers(model, hidden)
    wanted = np.stack([_shares_of(found, head) for head in model.heads], axis=1)
    counted = np.ones(wanted.shape[:2], np.float32)
    return Stretch(hidden, wanted, counted, np.ones(len(Phoneme), bool))


def _ahead(values: Block, n_heads: int) -> Block:
    """Put what is known of each frame where the heads answer for it: head k does so k frames later."""
    n = len(values)
    placed = np.zeros((n + n_heads - 1, n_heads, *values.shape[1:]), np.float32)
    for k in range(n_heads):
        placed[k : k + n, k] = values
    return placed


def _shares_of(found: Block, head: Head) -> Block:
    scores = found @ head.weights + head.bias
    shares = np.exp(scores - scores.max(axis=1, keepdims=True))
    return np.asarray(shares / shares.sum(axis=1, keepdims=True), np.float32)


def _first_layers(model: Model) -> Network:
    return Network(model.layers[: first_tuned(model)], np.full(N_BANDS, np.log10(FLOOR), np.float32))


def _through_last_layers(model: Model, hidden: Block) -> Block:
    for layer in model.layers[first_tuned(model) :]:
        hidden = hidden + Delayed(layer, np.zeros(len(layer.bias), np.float32)).push(hidden)
    return hidden
