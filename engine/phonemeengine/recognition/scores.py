"""What a recogniser gives for a block of frames, and scores: how likely each phoneme is.

Scores become columns of the features, one for each phoneme, and all that such a recogniser says is read from them.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.errors import SettingsError
from phonemeengine.features.measure import Features
from phonemeengine.features.variables import DEFICITS, SCORES
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
