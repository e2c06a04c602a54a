"""Find the thresholds of the thesis rules that give the best macro F1 on labelled frames.

A coordinate search: one threshold after the other takes the best of its candidates, until no change helps; it
starts anew from random thresholds and the best end counts. A threshold decides one condition, so two runs of the
rules, with the condition everywhere true and everywhere false, tell the exact score of every candidate at once.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from engine.calibration.scoring import N_CODES, TEN, Codes, confusion_of, macro_f1_of
from engine.features.measure import Features
from engine.phonemes import Phoneme
from engine.recognition.phoneme_data import Thresholds
from engine.recognition.rules import CONDITIONS, RULES, Condition

N_CANDIDATES = 24
"""Few, since finer ones only fit better to the speakers that are there, not to others."""

SIGNIFICANT_DIGITS = 4
LEAST_GAIN = 2e-4
MOST_SWEEPS = 12

Flags = dict[Condition, NDArray[np.bool_]]


@dataclass(frozen=True)
class Fit:
    """The end of a search.

    Attributes
    ----------
    thresholds : the best that were found.
    score : their macro F1 on the frames that they were fitted to.
    """

    thresholds: Thresholds
    score: float


class ThresholdSearch:
    """Fits to one set of frames.

    Parameters
    ----------
    features : what was measured.
    truth : codes of `Phoneme`, shape (n_frames,); frames labelled unidentified are passed over.
    filler : what an unidentified frame becomes.
    """

    def __init__(self, features: Features, truth: Codes, filler: Phoneme) -> None:
        known = truth != Phoneme.UNIDENTIFIED
        self._truth = truth[known]
        self._filler = filler
        self._values = {c: np.ascontiguousarray(features[c.variable][known]) for c in CONDITIONS}
        self._candidates = {c: _candidates_of(values) for c, values in self._values.items()}
        self._ranks = {
            c: np.searchsorted(self._candidates[c], values, side="left" if c.sign == ">" else "right")
            for c, values in self._values.items()
        }

    def best_of(self, n_starts: int, generator: np.random.Generator) -> Fit:
        """Search from some random starts and give the best end."""
        return max((self._descend(generator) for _ in range(n_starts)), key=lambda fit: fit.score)

    def _descend(self, generator: np.random.Generator) -> Fit:
        limits = {c: generator.choice(candidates) for c, candidates in self._candidates.items()}
        flags = {c: self._holds(c, limit) for c, limit in limits.items()}
        best = float(macro_f1_of(confusion_of(self._truth, self._answers(flags)), TEN))
        for _ in range(MOST_SWEEPS):
            before = best
            for k in generator.permutation(len(CONDITIONS)):
                best = self._improve(CONDITIONS[k], limits, flags, best)
            if best - before < LEAST_GAIN:
                break
        return Fit(Thresholds(**{c.threshold: float(str(limits[c])) for c in CONDITIONS}), best)

    def _improve(self, c: Condition, limits: dict[Condition, np.float32], flags: Flags, best: float) -> float:
        scores = self._scores_of_candidates(c, flags)
        k = int(scores.argmax())
        if scores[k] <= best:
            return best
        limits[c] = self._candidates[c][k]
        flags[c] = self._holds(c, limits[c])
        return float(scores[k])

    def _scores_of_candidates(self, c: Condition, flags: Flags) -> NDArray[np.float64]:
        """Give the macro F1 with each candidate for one condition, all others as they are."""
        every = np.ones(len(self._truth), bool)
        when_true = self._answers({**flags, c: every})
        when_false = self._answers({**flags, c: ~every})
        open_ = when_true != when_false
        settled = confusion_of(self._truth[~open_], when_true[~open_])
        n = len(self._candidates[c])
        below_true = self._counts_below(c, open_, when_true)
        below_false = self._counts_below(c, open_, when_false)
        if c.sign == ">":
            below_true, below_false = below_false, below_true
        counts = below_true[:n] + below_false[-1] - below_false[:n]
        return macro_f1_of(counts + settled, TEN)

    def _counts_below(self, c: Condition, frames: NDArray[np.bool_], answers: Codes) -> NDArray[np.int64]:
        """Count label and answer of the frames whose value lies below each candidate; the last row is all."""
        n = len(self._candidates[c]) + 1
        cells = self._ranks[c][frames] * N_CODES + self._truth[frames]
        counts = np.bincount(cells * N_CODES + answers[frames], minlength=n * N_CODES**2)
        return counts.reshape(n, N_CODES, N_CODES).cumsum(axis=0)

    def _holds(self, c: Condition, limit: np.float32) -> NDArray[np.bool_]:
        return np.asarray(self._values[c] > limit if c.sign == ">" else self._values[c] < limit)

    def _answers(self, flags: Flags) -> Codes:
        answers = np.full(len(self._truth), self._filler, np.uint8)
        for rule in reversed(RULES[:-1]):
            holds = np.logical_and.reduce([flags[c] for c in rule.conditions])
            answers[holds] = rule.phoneme
        return answers


def _candidates_of(values: NDArray[np.float32]) -> NDArray[np.float32]:
    """Spread thresholds evenly over the ranks of the values, rounded so that a file shows few digits."""
    ranks = np.linspace(0.002, 0.998, N_CANDIDATES)
    spread = np.unique(np.quantile(values, ranks))
    rounded = [float(f"{value:.{SIGNIFICANT_DIGITS}g}") for value in spread]
    return np.unique(np.array(rounded, np.float32))
