"""What a recogniser gives for a block of frames: scores, how likely each phoneme is, and the confidence of an answer.

Scores become columns of the features, one for each phoneme, and all that such a recogniser says is read from them.

The probabilities of a recogniser are not that: they are too high, and what is named is smoothed besides. A
rising curve, found by isotonic regression on speakers who took no part in the training, turns the one into the other.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array, UInt8Array
from phonemeengine.errors import PresetError, SettingsError
from phonemeengine.features.variables import DEFICITS, SCORES, Features
from phonemeengine.labels.visemes import STANDARD_VISEMES, VisemeSet
from phonemeengine.phonemes import Phoneme

# Why a frame was recognised as it was.


@dataclass(frozen=True)
class RuleComparison:
    """One question that a recogniser asked of a frame.

    Attributes
    ----------
    rule : the rule that asks.
    variable, value : what was measured.
    sign : ``<`` or ``>``.
    threshold, limit : name and value of what it was compared with.
    margin : how far the answer is from changing; positive where the comparison holds.
    """

    rule: str
    variable: str
    value: float
    sign: str
    threshold: str
    limit: float
    margin: float


def _asked(comparison: RuleComparison) -> tuple[str, str, str, str]:
    return comparison.rule, comparison.variable, comparison.sign, comparison.threshold


@dataclass(frozen=True)
class Trace:
    """The rule that fired, and every comparison on the way to it."""

    phoneme: Phoneme
    rule: str
    comparisons: tuple[RuleComparison, ...]

    def turned_since(self, earlier: "Trace") -> RuleComparison | None:
        """Return the first comparison whose answer is another than in an earlier trace; None where none is."""
        answers = {_asked(c): c.margin > 0 for c in earlier.comparisons}
        turned = (c for c in self.comparisons if (c.margin > 0) != answers.get(_asked(c), c.margin > 0))
        return next(turned, None)


@dataclass(frozen=True)
class Recognition:
    """The phonemes of a block.

    Attributes
    ----------
    phonemes : uint8, shape (n_frames,): codes of `Phoneme`.
    scores : float32, shape (n_frames, n_scores): the columns that the recogniser's `scores` names, or None where it
        names none.
    visemes : float32, shape (n_frames, n_visemes): how likely each viseme of the set is; None where the recogniser
        tells none apart.
    viseme_set : the visemes that it tells apart.
    decoded : uint8, shape (n_frames,): the phonemes that a search found behind those; None without one.
    """

    phonemes: UInt8Array
    scores: Float32Array | None = None
    visemes: Float32Array | None = None
    viseme_set: VisemeSet = STANDARD_VISEMES
    decoded: UInt8Array | None = None


__all__ = ["SCORES", "ScoredRecogniser", "Sensitivity", "agreed", "check_sensitivities", "scores_in"]


N_NEAREST = 5
"""How many phonemes a trace compares."""
MOST_LOG_ODDS = 10.0
"""A sensitivity lies within ± this: e to the tenth is 22 000 to one."""
LEAST_SHARE = 1e-6
"""What less likely is counts as that, where recognisers have to agree."""


class Sensitivity:
    """Makes some phonemes likelier than they were measured to be.

    A sensitivity is added to the log-odds (natural logarithm) of its phoneme, as a prior is in Bayes' rule: each +1
    makes the phoneme e times likelier beside any other one.

    Parameters
    ----------
    sensitivities : by phoneme, log-odds in nats; those that are not named have 0.
    """

    def __init__(self, sensitivities: Mapping[Phoneme, float]) -> None:
        self._factors = np.exp([sensitivities.get(p, 0.0) for p in Phoneme]).astype(np.float32)
        self._acts = bool((self._factors != 1).any())

    def apply(self, scores: Float32Array) -> Float32Array:
        """Return the probabilities, shape (n_frames, n_phonemes), with the sensitivities; each frame adds up to 1."""
        if not self._acts:
            return scores
        # log-odds are added by multiplying probabilities with e to their power
        weighed = scores * self._factors
        weighed /= np.add.reduce(weighed, axis=1, keepdims=True)
        return weighed


def agreed(first: Float32Array, second: Float32Array, share: float, penalties: Float32Array) -> Float32Array:
    """Return probabilities that two recognisers agree on most, float32, shape (n_frames, n_classes).

    Parameters
    ----------
    first, second : their probabilities, shape (n_frames, n_classes).
    share : of the first in the mean of the logarithms, 0..1; the rest is the second's.
    penalties : log-odds by which classes count less, nats, shape (n_classes,): a part of the logarithms of the
        priors, where both were trained on the same frequent classes and so count them twice.
    """
    # a weighted geometric mean (a product of experts): a class has to be plausible to both
    logs = share * np.log(np.maximum(first, LEAST_SHARE)) + (1 - share) * np.log(np.maximum(second, LEAST_SHARE))
    logs -= penalties
    together = np.exp(logs - logs.max(axis=1, keepdims=True))
    return np.asarray(together / together.sum(axis=1, keepdims=True), np.float32)


def check_sensitivities(sensitivities: Mapping[Phoneme, float]) -> None:
    """Refuse sensitivities beyond ±`MOST_LOG_ODDS`.

    Raises
    ------
    SettingsError : names the phoneme, the limit and what came.
    """
    for phoneme, value in sensitivities.items():
        if not (math.isfinite(value) and abs(value) <= MOST_LOG_ODDS):
            raise SettingsError(
                f"the sensitivity for {phoneme.label} must lie within ±{MOST_LOG_ODDS:g}, got {value:g}; "
                "choose another value"
            )


NO_SENSITIVITIES: Mapping[Phoneme, float] = MappingProxyType({})
LEAST_PROBABILITY = 1e-9
"""Below it a logarithm means nothing: float32 probabilities add up to 1 within some 1e-7."""


def deficits_of(scores: Float32Array, phoneme: Phoneme) -> Float32Array:
    """Return by how much a phoneme falls short of the likeliest other one, shape (n_frames,), in nats of log-odds.

    Where it is below 0 the phoneme is named; a sensitivity above it would have named it.

    Parameters
    ----------
    scores : probabilities, shape (n_frames, n_phonemes).
    phoneme : which one.
    """
    # the difference of the logarithms of two probabilities is the log-odds of one beside the other
    logs = np.log(np.maximum(scores, np.float32(LEAST_PROBABILITY)))
    deficits: Float32Array = np.delete(logs, phoneme, axis=1).max(axis=1) - logs[:, phoneme]
    return deficits


def scores_in(features: Features) -> Float32Array | None:
    """Return the columns of the scores, shape (n_frames, n_phonemes), or None where they were not measured yet."""
    if SCORES[0] not in features.names:
        return None
    first = features.names.index(SCORES[0])
    return features.values[:, first : first + len(SCORES)]


def values_of(features: Features, variable: str, sensitivities: Mapping[Phoneme, float]) -> Float32Array | None:
    """Return what was measured of a variable, or a phoneme's deficit; shape (n_frames,), None where it was not.

    Parameters
    ----------
    features : the variables, with the scores as they are with the sensitivities.
    sensitivities : of all phonemes; a deficit is that without the phoneme's own.
    """
    scores = scores_in(features)
    if variable not in DEFICITS or scores is None:
        return features[variable] if variable in features.names else None
    phoneme = Phoneme(DEFICITS.index(variable))
    return deficits_of(scores, phoneme) + np.float32(sensitivities.get(phoneme, 0.0))


def separations_of(deficits: Float32Array, phonemes: UInt8Array) -> Float32Array:
    """Return how far phonemes are from giving way to another one, 0..1, shape (n_frames,).

    It is d / (1 + |d|), where d is by how much the nearest other phoneme falls short of being named, less by how much
    the phoneme itself does; 0.5 stands for d = 0, and less for a phoneme that is held though another is named.

    Parameters
    ----------
    deficits : by how much each phoneme falls short, 0 or more, shape (n_frames, n_phonemes); infinite of those that
        are never named.
    phonemes : of the frames, codes, shape (n_frames,).
    """
    places = np.arange(len(phonemes))
    # an infinite lead divides to NaN, which the last line replaces by its sign
    others = deficits.copy()
    others[places, phonemes] = np.inf
    with np.errstate(invalid="ignore"):
        apart = others.min(axis=1) - deficits[places, phonemes]
        ratios = apart / (1 + np.abs(apart))
    return np.asarray(0.5 + 0.5 * np.where(np.isinf(apart), np.sign(apart), ratios), np.float32)


class ScoredRecogniser:
    """What recognisers share that name the likeliest phoneme; see `phonemeengine.recognition.spec.Recogniser`."""

    scores = SCORES
    used_thresholds: frozenset[str] = frozenset()

    def deficits(self, features: Features) -> Float32Array | None:
        """Return by how much each phoneme is less likely than the likeliest, shape (n_frames, n_phonemes)."""
        scores = scores_in(features)
        if scores is None:
            return None
        deficits: Float32Array = scores.max(axis=1, keepdims=True) - scores
        return deficits

    def explain(self, features: Features, k: int) -> Trace:
        """Return why frame `k` of a block is recognised as it is: the likeliest phonemes, the best one first.

        The best is compared with the second, all others with the best. Frames without scores are unidentified.
        """
        scores = scores_in(features)
        if scores is None:
            return Trace(Phoneme.UNIDENTIFIED, Phoneme.UNIDENTIFIED.label, ())
        row = scores[k]
        order = [Phoneme(int(code)) for code in np.argsort(-row, kind="stable")[:N_NEAREST]]
        best = order[0]
        return Trace(best, best.label, tuple(_compared(row, p, order[1] if p is best else best) for p in order))


def _compared(row: Float32Array, phoneme: Phoneme, other: Phoneme) -> RuleComparison:
    value, limit = float(row[phoneme]), float(row[other])
    return RuleComparison(phoneme.label, SCORES[phoneme], value, ">", SCORES[other], limit, value - limit)


MOST_POINTS = 16
"""Of a curve."""
LEAST_STEP = 0.001
"""Between the scores of two points."""
N_BINS = 10
"""In which confidences are compared with the shares that are right."""
LEAST_SHARE_OF_FRAMES = 0.01
"""Of all frames, that a bin must hold for its gap to count."""


@dataclass(frozen=True)
class ConfidenceCurve:
    """Shares of right answers by the score of what is named; straight lines between its points.

    Attributes
    ----------
    scores : rising, 0..1.
    shares : not falling, 0..1; one alone holds for all scores.

    Raises
    ------
    PresetError : they are not as said, or not equally many.
    """

    scores: tuple[float, ...] = (0.0, 1.0)
    shares: tuple[float, ...] = (0.0, 1.0)

    def __post_init__(self) -> None:
        scores, shares = np.array(self.scores), np.array(self.shares)
        fits = 0 < len(scores) == len(shares) <= MOST_POINTS and (np.diff(scores) > 0).all()
        inside = all(np.isfinite(a).all() and (a >= 0).all() and (a <= 1).all() for a in (scores, shares))
        if not (fits and inside and (np.diff(shares) >= 0).all()):
            raise PresetError(
                f"a confidence has 1..{MOST_POINTS} rising scores and as many shares that do not fall, all of 0..1; "
                "fit it again"
            )

    def of(self, scores: Float32Array) -> Float32Array:
        """Return the confidence of answers with these scores, 0..1, same shape."""
        return np.interp(scores, *self._points).astype(np.float32)

    @cached_property
    def _points(self) -> tuple[Float64Array, Float64Array]:
        return np.array(self.scores, np.float64), np.array(self.shares, np.float64)


UNFITTED = ConfidenceCurve()
"""Takes a score for what it is."""


def fit_confidence(scores: Float32Array, right: BoolArray) -> ConfidenceCurve:
    """Return the rising curve that is nearest to what was right, least squares.

    Isotonic regression by pooling adjacent violators (M. Ayer et al., Ann. Math. Stat. 26(4), 1955), of the means of
    equally many frames each.

    Parameters
    ----------
    scores : of what was named, shape (n,), at least one.
    right : whether it was, shape (n,).
    """
    # Equally many frames for each point, so that all are known equally well, also where scores crowd near 1.
    order = np.argsort(scores, kind="stable")
    parts = np.array_split(order, min(MOST_POINTS, len(order)))
    heights = [float(right[part].mean()) for part in parts]
    middles = [float(scores[part].mean()) for part in parts]
    pools: list[tuple[float, float, int]] = []
    for middle, height in zip(middles, heights, strict=True):
        pool = (middle, height, 1)
        # A pool that does not rise above the one before it is joined with it, and the joined one is compared again:
        # what is left rises, and is the best rising fit (least squares). Points too close in score join too.
        while pools and (pools[-1][1] >= pool[1] or pools[-1][0] + LEAST_STEP > pool[0]):
            before = pools.pop()
            n = before[2] + pool[2]
            pool = (
                (before[0] * before[2] + pool[0] * pool[2]) / n,
                (before[1] * before[2] + pool[1] * pool[2]) / n,
                n,
            )
        pools.append(pool)
    return ConfidenceCurve(
        tuple(round(middle, 4) for middle, _, _ in pools), tuple(round(height, 4) for _, height, _ in pools)
    )


def calibration_errors(confidences: Float32Array, right: BoolArray) -> tuple[float, float]:
    """Return the expected calibration error (C. Guo et al., arXiv:1706.04599), and the largest gap of a bin.

    NaN where there is no frame.
    """
    # a confidence of exactly 1 belongs to the last bin
    bins = np.minimum((confidences * N_BINS).astype(int), N_BINS - 1)
    counts = np.bincount(bins, minlength=N_BINS)
    if not len(bins):
        return float("nan"), float("nan")
    # the mean of differences is the difference of means, so the sums of each bin are enough
    gaps = np.abs(_sums(bins, confidences) - _sums(bins, right.astype(np.float32))) / np.maximum(counts, 1)
    full = counts >= LEAST_SHARE_OF_FRAMES * len(bins)
    return float((gaps * counts).sum() / len(bins)), float(gaps[full].max())


def _sums(bins: np.ndarray[tuple[int], np.dtype[np.int64]], values: Float32Array) -> Float64Array:
    return np.asarray(np.bincount(bins, values, N_BINS), np.float64)
