"""Adapting the learned recogniser to one voice, from a few seconds of it.

What the network hears stays; how it names what it hears moves towards this voice. It is held by a price on every
change (maximum a posteriori, as in J.-L. Gauvain and C.-H. Lee, IEEE Trans. Speech and Audio Processing 2(2), 1994),
and by anchors: frames of other voices, which must be named as before. How far it moves is chosen on recordings that
are held back, and where nothing helps there, nothing is changed.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from engine.calibration.learning.lessons import Lesson
from engine.calibration.learning.validation import hidden_of
from engine.errors import CorpusError
from engine.phonemes import Phoneme
from engine.recognition.model import Head, Model

BOLDNESS = (1.0, 3.0, 10.0)
"""How much the voice counts against what was learned before, from wary to bold."""
ANCHORED = 1000.0
"""How much all anchors count together, in frames, for the wariest."""
PRICE = 10.0
"""What a change of a weight costs, in units of its square."""
STEADY_BIAS = 3.0
"""How much more a change of a phoneme's share costs: a few seconds tell little about how often it will be said."""
LEAST_FRAMES = 3
"""A phoneme of which fewer frames are given is not touched."""
N_FOLDS = 4
LEAST_GAIN = 0.005
"""By how much more frames must be right on what is held back."""
LEAST_SECONDS = 2.0
BALANCE = 30
"""Frames of a phoneme beyond which further ones count less, so that all phonemes count alike."""
MOST_ROUNDS = 60

Block = NDArray[np.float32]
Numbers = NDArray[np.float64]


@dataclass(frozen=True)
class Adaptation:
    """A model that knows a voice.

    Attributes
    ----------
    model : the adapted one; the same as before where nothing helped.
    before, after : share of frames that were right on recordings that were held back, all phonemes counted alike.
    boldness : how much the voice counted; 0 where nothing was changed.
    """

    model: Model
    before: float
    after: float
    boldness: float


@dataclass(frozen=True)
class _Heard:
    """What the network made of a recording, with labels and what each frame counts."""

    found: Block
    phonemes: NDArray[np.uint8]
    counted: Block


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
    scores = {boldness: _held_back(model, heard, boldness) for boldness in (0.0, *BOLDNESS)}
    best = max(scores, key=scores.__getitem__)
    if scores[best] < scores[0.0] + LEAST_GAIN:
        best = 0.0
    heads = tuple(_moved(model, heard, k, best) for k in range(len(model.heads))) if best else model.heads
    return Adaptation(replace(model, heads=heads).rounded(), scores[0.0], scores[best], best)


def _heard(model: Model, lesson: Lesson) -> _Heard:
    return _Heard(hidden_of(model, lesson), lesson.phonemes, lesson.certainties.astype(np.float32))


def _held_back(model: Model, heard: Sequence[_Heard], boldness: float) -> float:
    """Give the share of frames that are right when each part is recognised by what the other parts taught."""
    n_folds = min(N_FOLDS, len(heard)) if len(heard) > 1 else 1
    n_ahead = len(model.heads) - 1
    right, counts = np.zeros(len(Phoneme)), np.zeros(len(Phoneme))
    for k in range(n_folds):
        taught = [h for i, h in enumerate(heard) if i % n_folds != k] or list(heard)
        moved = _moved(model, taught, n_ahead, boldness) if boldness else model.heads[n_ahead]
        for h in heard[k::n_folds]:
            answers = (h.found[n_ahead:] @ moved.weights + moved.bias).argmax(axis=1)
            np.add.at(right, h.phonemes, (answers == h.phonemes) * h.counted)
            np.add.at(counts, h.phonemes, h.counted)
    present = counts > 0
    return float(np.mean(right[present] / counts[present]))


def _moved(model: Model, heard: Sequence[_Heard], n_ahead: int, boldness: float) -> Head:
    """Give the head that names the recordings best, less what its change costs."""
    from scipy.optimize import minimize  # noqa: PLC0415 - it takes a second that only an adaptation should wait for

    head = model.heads[n_ahead]
    voice = _voice_of(heard, n_ahead, boldness)
    parts = [voice, *([_anchors_of(model, head)] if len(model.anchors) else [])]
    shape = head.weights.shape

    def cost(change: Numbers) -> tuple[float, Numbers]:
        weights, bias = change[: -shape[1]].reshape(shape), change[-shape[1] :]
        total = PRICE * float(np.sum(weights**2) + STEADY_BIAS * np.sum(bias**2))
        slopes = [2 * PRICE * weights, 2 * PRICE * STEADY_BIAS * bias]
        for part in parts:
            loss, errors = part.loss_of(head.weights + weights, head.bias + bias)
            total += loss
            slopes[0] += part.found.T @ errors
            slopes[1] += errors.sum(axis=0)
        return total, np.concatenate((slopes[0].ravel(), slopes[1]))

    start = np.zeros(head.weights.size + shape[1])
    change = minimize(cost, start, jac=True, method="L-BFGS-B", options={"maxiter": MOST_ROUNDS}).x
    weights = head.weights + change[: -shape[1]].reshape(shape)
    return Head(weights.astype(np.float32), (head.bias + change[-shape[1] :]).astype(np.float32))


@dataclass(frozen=True)
class _Examples:
    """Frames, what they should be named (a share for each phoneme), what each counts, and which phonemes compete."""

    found: Numbers
    wanted: Numbers
    counted: Numbers
    competing: NDArray[np.bool_]

    def loss_of(self, weights: Numbers, bias: Numbers) -> tuple[float, Numbers]:
        """Give the cross-entropy, and its slope for each score."""
        scores = np.where(self.competing, self.found @ weights + bias, -np.inf)
        scores -= scores.max(axis=1, keepdims=True)
        shares = np.exp(scores)
        totals = shares.sum(axis=1, keepdims=True)
        logarithms = np.where(self.competing, scores - np.log(totals), 0)
        loss = -float(np.sum(self.counted * (logarithms * self.wanted).sum(axis=1)))
        return loss, (shares / totals - self.wanted) * self.counted[:, np.newaxis]


def _voice_of(heard: Sequence[_Heard], n_ahead: int, boldness: float) -> _Examples:
    found = np.concatenate([h.found[n_ahead : n_ahead + len(h.phonemes)] for h in heard]).astype(float)
    phonemes = np.concatenate([h.phonemes for h in heard])
    counted = np.concatenate([h.counted for h in heard]).astype(float)
    totals = np.bincount(phonemes, counted, len(Phoneme))
    competing = totals >= LEAST_FRAMES
    counted *= boldness * (BALANCE / np.maximum(totals, BALANCE) * competing)[phonemes]
    return _Examples(found, np.eye(len(Phoneme))[phonemes], counted, competing)


def _anchors_of(model: Model, head: Head) -> _Examples:
    """Give the anchors, named as the model names them now."""
    n = len(model.anchors)
    scores = (model.anchors @ head.weights + head.bias).astype(float)
    shares = np.exp(scores - scores.max(axis=1, keepdims=True))
    wanted = shares / shares.sum(axis=1, keepdims=True)
    return _Examples(model.anchors.astype(float), wanted, np.full(n, ANCHORED / n), np.ones(len(Phoneme), bool))
