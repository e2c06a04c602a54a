"""How a variable is distributed over the frames of each phoneme, and how well it tells them apart."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, Int64Array, UInt8Array
from phonemeengine.calibration.scores.scoring import N_CODES, SCORED_PHONEMES
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.features.variables import UNITS
from phonemeengine.phonemes import NO_PHONEME, Phoneme
from phonemeengine.recognition.scores import NO_SENSITIVITIES

# How well a number tells phonemes apart.
#
# The measure is the chance that of two frames, one of each phoneme, the one of the first has the larger value (equal
# ones count half): the area under the ROC curve, which is the Mann-Whitney U statistic over the number of pairs,
# ``AUC = U / (n1 n2)`` (Hanley and McNeil, Radiology 143, 1982). Which of the two is larger does not matter here, so
# the separation of two phonemes is ``max(AUC, 1 - AUC)``: 0.5 where the number says nothing about them, 1 where one
# threshold parts them all. Of several phonemes it is the mean over all pairs (Hand and Till, Machine Learning 45,
# 2001).


def separability(values: Float32Array, others: Float32Array) -> float:
    """Return how well a threshold can part two sets of values, 0.5..1; NaN where one is empty."""
    if not (len(values) and len(others)):
        return float("nan")
    ordered = np.sort(others)
    below = np.searchsorted(ordered, values, side="left").sum(dtype=float)
    up_to = np.searchsorted(ordered, values, side="right").sum(dtype=float)
    larger = (below + up_to) / (2 * len(values) * len(others))
    return float(max(larger, 1 - larger))


def separabilities(values: Float32Array, phonemes: UInt8Array) -> Float64Array:
    """Return how well a threshold can part each pair of phonemes.

    Parameters
    ----------
    values : shape (n_frames,).
    phonemes : codes of `Phoneme`, shape (n_frames,).

    Returns
    -------
    shape (11, 11), 0.5..1; NaN where a phoneme has no frames, and for each with itself.
    """
    order = np.argsort(values)
    ordered, codes = values[order], phonemes[order]
    groups = np.concatenate(([True], ordered[1:] != ordered[:-1])) if len(ordered) else np.zeros(0, bool)
    firsts = np.flatnonzero(groups)
    sizes = np.diff(firsts, append=len(ordered))
    counts = np.bincount(codes, minlength=N_CODES)
    larger = np.empty((N_CODES, N_CODES))
    for other in Phoneme:
        up_to = np.cumsum(codes == other)[firsts + sizes - 1]
        below = np.concatenate(([0], up_to[:-1]))[: len(up_to)]
        larger[:, other] = np.bincount(codes, np.repeat((below + up_to) / 2, sizes), minlength=N_CODES)
    with np.errstate(invalid="ignore", divide="ignore"):
        larger /= np.outer(counts, counts)
    np.fill_diagonal(larger, np.nan)
    separations = np.maximum(larger, 1 - larger)
    return np.maximum(separations, separations.T)  # equal but for rounding


def mean_separability(separations: Float64Array, phonemes: Iterable[Phoneme]) -> float:
    """Return the mean over all pairs of phonemes of which there are frames; NaN where there is no such pair."""
    pairs = np.array([separations[p, q] for p, q in combinations(phonemes, 2)])
    known = pairs[~np.isnan(pairs)]
    return float(known.mean()) if len(known) else float("nan")


def best_threshold(values: Float32Array, others: Float32Array) -> float:
    """Return the threshold that parts two sets best, in the middle of the gap where it lies.

    Best is where the shares of both that lie on their own side are largest together (Youden, Cancer 3, 1950); of
    several equal ones the middle one. Neither may be empty.
    """
    both = np.concatenate((values, others))
    order = np.argsort(both, kind="stable")
    ordered = both[order]
    own = order < len(values)
    shares = np.cumsum(np.where(own, 1 / len(values), -1 / len(others)))
    cuts = np.flatnonzero(ordered[1:] > ordered[:-1])
    if not len(cuts):
        return float(ordered[0])
    gains = np.abs(shares[cuts])
    best = cuts[gains >= gains.max() - 1e-9]
    cut = best[len(best) // 2]
    return float((float(ordered[cut]) + float(ordered[cut + 1])) / 2)


N_BINS = 60
"""Bins of a histogram."""
OUTERMOST = 0.002
"""A histogram reaches from this quantile of all frames to the opposite one; what lies beyond is in its end bins."""
DECADES = 1.5
"""An amplitude whose middle 90 % span more powers of ten than these is shown on a logarithmic scale."""
NO_AMPLITUDES = frozenset(UNITS)
"""Variables that are counts, frequencies or logarithms, and shown on a linear scale."""
Pair = tuple[Phoneme, Phoneme]


@dataclass(frozen=True, eq=False)
class Quartiles:
    """The values of a variable in the frames of one phoneme.

    Attributes
    ----------
    n : how many frames there are.
    minimum, lower_quartile, median, upper_quartile, maximum : of their values.
    counts : int64, shape (n_bins,): the histogram, over the bins of the `Distribution`.
    """

    n: int
    minimum: float
    lower_quartile: float
    median: float
    upper_quartile: float
    maximum: float
    counts: Int64Array


@dataclass(frozen=True, eq=False)
class Distribution:
    """A variable over all certain frames.

    Attributes
    ----------
    variable : its name.
    edges : shape (n_bins + 1,): the ascending borders of the bins of all histograms; values beyond the ends are
        counted in the end bins.
    logarithmic : whether the bins are equally wide on a logarithmic scale; `edges` are values all the same.
    spreads : one for each phoneme of which there are frames.
    separations : shape (11, 11): how well one threshold parts each pair, 0.5..1, as
        `phonemeengine.calibration.workbench.distributions` defines it; NaN where there are no frames.
    """

    variable: str
    edges: Float64Array
    logarithmic: bool
    spreads: Mapping[Phoneme, Quartiles]
    separations: Float64Array

    @property
    def separation(self) -> float:
        """How well the variable separates the ten phonemes: the mean over all pairs, 0.5..1; NaN without a pair."""
        return mean_separability(self.separations, SCORED_PHONEMES)

    def higher_of(self, phonemes: Iterable[Phoneme]) -> Phoneme | None:
        """Return the one of some phonemes with the highest median; None without frames of any."""
        known = [phoneme for phoneme in phonemes if phoneme in self.spreads]
        return max(known, key=lambda phoneme: self.spreads[phoneme].median) if known else None


@dataclass(frozen=True)
class RankedVariable:
    """A variable, and how well it separates what was asked for, 0.5..1; NaN where there was nothing to separate."""

    variable: str
    separation: float


def distribution_of(
    labelled: LabelledFeatures, variable: str, sensitivities: Mapping[Phoneme, float] = NO_SENSITIVITIES
) -> Distribution:
    """Return the distribution of a variable over those frames whose label is certain.

    `sensitivities` are those of the other phonemes, where the variable is a phoneme's deficit.

    Raises
    ------
    CorpusError : the variable was not measured.
    """
    certain = labelled.labels.certain
    values = labelled.values(variable, sensitivities)
    return distribution_in(variable, values[certain], labelled.labels.phonemes[certain])


def distribution_in(variable: str, values: Float32Array, phonemes: UInt8Array) -> Distribution:
    """Return the distribution of a variable over frames: its values, and what is said; both (n_frames,)."""
    logarithmic = variable not in NO_AMPLITUDES and _spans_decades(values)
    edges = _edges_over(values, logarithmic=logarithmic)
    present = [p for p in Phoneme if np.any(phonemes == p)]
    spreads = {p: _spread_of(values[phonemes == p], edges) for p in present}
    return Distribution(variable, edges, logarithmic, spreads, separabilities(values, phonemes))


def ranked_variables(
    labelled: LabelledFeatures, pair: Pair | None = None, progress: Progress = no_progress
) -> tuple[RankedVariable, ...]:
    """Rank all measured variables by how well they separate the ten phonemes, or one pair; the best one first.

    Variables that are the same in all frames come last, such as ``f0`` while it is not measured.

    Raises
    ------
    Cancelled : `progress` did not want to go on.
    """
    labels = labelled.labels
    phonemes = np.where(labels.certain, labels.phonemes, NO_PHONEME).astype(np.uint8)
    return ranked_in(labelled.variables, labelled.values, phonemes, pair, progress)


def ranked_in(
    variables: Iterable[str],
    values_of: Callable[[str], Float32Array],
    phonemes: UInt8Array,
    pair: Pair | None = None,
    progress: Progress = no_progress,
) -> tuple[RankedVariable, ...]:
    """Rank variables by how well they separate the ten phonemes, or one pair; the best one first.

    Parameters
    ----------
    values_of : gives the values of a variable, shape (n_frames,).
    phonemes : codes of what is said or recognised, shape (n_frames,); frames of other codes do not count.

    Raises
    ------
    Cancelled : `progress` did not want to go on.
    """
    names, wanted = tuple(variables), SCORED_PHONEMES if pair is None else pair
    chosen = np.isin(phonemes, wanted)
    codes = phonemes[chosen]
    ranked = []
    for k, name in enumerate(names):
        report_progress(progress, k / len(names))
        ranked.append(RankedVariable(name, mean_separability(separabilities(values_of(name)[chosen], codes), wanted)))
    report_progress(progress, 1.0)
    return tuple(sorted(ranked, key=lambda r: -np.nan_to_num(r.separation, nan=0.0)))


def _spread_of(values: Float32Array, edges: Float64Array) -> Quartiles:
    minimum, lower, median, upper, maximum = np.quantile(values, (0, 0.25, 0.5, 0.75, 1)).tolist()
    counts, _ = np.histogram(np.clip(values, edges[0], edges[-1]), edges)
    return Quartiles(len(values), minimum, lower, median, upper, maximum, counts.astype(np.int64))


def _spans_decades(values: Float32Array) -> bool:
    positive = values[values > 0]
    if len(positive) < len(values) / 2 or not len(positive):
        return False
    low, high = np.log10(np.quantile(positive, (0.05, 0.95)))
    return bool(high - low > DECADES)


def _edges_over(values: Float32Array, *, logarithmic: bool) -> Float64Array:
    """Spread the bins over the values; those at zero belong to the lowest bin of a logarithmic scale."""
    reach = values[values > 0] if logarithmic else values
    low, high = np.quantile(reach, (OUTERMOST, 1 - OUTERMOST)).tolist() if len(reach) else (0.0, 1.0)
    if not high > low:
        low, high = (low / 2, low * 2) if logarithmic else (low - 0.5, low + 0.5)
    edges = np.geomspace(low, high, N_BINS + 1) if logarithmic else np.linspace(low, high, N_BINS + 1)
    return np.asarray(edges, float)
