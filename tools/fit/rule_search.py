"""Grow rules from labelled frames: a decision tree, each of whose leaves is a rule.

The tree grows where it gains most: of all leaves the one is split, by the variable and the limit, that leaves the
least impurity (weighted Gini). A split by a variable that no rule asks for yet must gain more than one by a
variable that is in use, so that there are few variables to understand. At last the leaves choose their phonemes
together, so that the macro F1 is best, and neighbours with the same phoneme become one.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array, UInt8Array
from phonemeengine.calibration.scores.scoring import N_CODES, SCORED_PHONEMES
from phonemeengine.features.measure import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import Condition, Rule

N_LIMITS = 63
"""Candidates for the limit of a comparison; fewer than 256."""

MOST_CONDITIONS = 8
"""A rule asks no more, so that it can be read."""

NOVELTY = 0.8
"""What the gain of a split counts whose variable is new to the rules."""

BALANCE = 0.5
"""The power of a phoneme's rarity by which its frames count more while the tree grows."""

LEAST_SHARE = 0.0005
"""The least share of the frames' weight that a rule may be made for."""

SIGNIFICANT_DIGITS = 4

NOTHING = np.zeros((0, 0, 0))


@dataclass(frozen=True)
class Split:
    """A comparison that divides a leaf: `variable` below or above its limit number `limit`."""

    gain: float
    variable: int
    limit: int


@dataclass(eq=False)
class Node:
    """A part of the frames: a leaf, until it is split.

    Attributes
    ----------
    frames : which frames.
    counts : the weight of each phoneme at each rank of each variable, shape (n_variables, n_ranks, n_phonemes);
        forgotten once it is split.
    asked : the ranks by which the comparisons on the way here bound each variable, by variable and sign.
    """

    frames: NDArray[np.int32]
    counts: Float64Array
    asked: dict[tuple[int, str], int]
    split: Split | None = None
    children: tuple["Node", ...] = ()
    phoneme: Phoneme = Phoneme.UNIDENTIFIED
    totals: Float64Array = field(default_factory=lambda: np.zeros(N_CODES))


class RuleSearch:
    """Grows rules for labelled frames.

    Parameters
    ----------
    features : what was measured.
    truth : codes of `Phoneme`, shape (n_frames,); frames labelled unidentified are not learned from.
    weights : how much each frame counts while the tree grows, shape (n_frames,).
    variables : the names of those that rules may ask for.
    """

    def __init__(
        self, features: Features, truth: UInt8Array, weights: Float64Array, variables: Sequence[str]
    ) -> None:
        known = truth != Phoneme.UNIDENTIFIED
        self._names = tuple(variables)
        self._limits = [limits_of(features[name][known]) for name in self._names]
        self._ranks = ranks_of(features, self._names, self._limits)[:, known]
        self._truth = truth[known].astype(np.int16)
        shares = np.bincount(self._truth, weights[known], N_CODES)
        self._balance = np.maximum(shares / shares.sum(), 1e-9) ** -BALANCE
        balanced = weights[known] * self._balance[self._truth]
        self._weights = balanced / balanced.sum()
        self._used: set[int] = set()

    def grow(self, n_rules: int) -> Node:
        """Grow a tree of so many leaves at the most."""
        self._used = set()
        everything = np.arange(len(self._truth), dtype=np.int32)
        root = self._node(everything, self._count(everything), {})
        leaves = [root]
        while len(leaves) < n_rules:
            best = max(leaves, key=self._worth)
            if best.split is None:
                break
            leaves.remove(best)
            leaves.extend(self._divide(best, best.split))
        return root

    def rules_of(self, root: Node) -> tuple[Rule, ...]:
        """Write a tree as rules, the leaves' phonemes chosen for the best macro F1."""
        leaves = leaves_of(root)
        counts = np.array([leaf.totals for leaf in leaves]) / self._balance
        for leaf, phoneme in zip(leaves, best_phonemes(counts), strict=True):
            leaf.phoneme = phoneme
        return tuple(self._rule_of(node) for node in merged_leaves_of(root))

    def _rule_of(self, node: Node) -> Rule:
        conditions = (
            Condition(self._names[variable], sign, limit=float(str(self._limits[variable][rank])))
            for (variable, sign), rank in sorted(node.asked.items())
        )
        return Rule(node.phoneme, tuple(conditions))

    def _node(self, frames: NDArray[np.int32], counts: Float64Array, asked: dict[tuple[int, str], int]) -> Node:
        node = Node(frames, counts, asked, totals=counts[0].sum(axis=0))
        node.split = self._best_split(counts, asked)
        return node

    def _worth(self, leaf: Node) -> float:
        return leaf.split.gain if leaf.split is not None else -1.0

    def _divide(self, node: Node, split: Split) -> tuple[Node, ...]:
        self._used.add(split.variable)
        below = self._ranks[split.variable][node.frames] <= split.limit
        parts = node.frames[below], node.frames[~below]
        few = int(len(parts[0]) > len(parts[1]))
        counts = [NOTHING, NOTHING]
        counts[few] = self._count(parts[few])
        counts[1 - few] = np.maximum(node.counts - counts[few], 0)
        node.counts = NOTHING
        node.children = tuple(
            self._node(part, count, {**node.asked, (split.variable, sign): split.limit})
            for part, count, sign in zip(parts, counts, "<>", strict=True)
        )
        return node.children

    def _count(self, frames: NDArray[np.int32]) -> Float64Array:
        truth, weights = self._truth[frames], self._weights[frames]
        counts = np.empty((len(self._ranks), N_LIMITS + 1, N_CODES))
        for k, ranks in enumerate(self._ranks):
            cells = ranks[frames] * np.int16(N_CODES) + truth
            counts[k] = np.bincount(cells, weights, counts[k].size).reshape(counts[k].shape)
        return counts

    def _best_split(self, counts: Float64Array, asked: dict[tuple[int, str], int]) -> Split | None:
        below = counts.cumsum(axis=1)[:, :-1]
        above = below[:, -1:] + counts[:, -1:] - below
        purity = _purity(below) + _purity(above)
        small = np.minimum(below.sum(axis=2), above.sum(axis=2)) < LEAST_SHARE
        gains = np.where(small, -np.inf, purity - _purity(counts[0].sum(axis=0)))
        gains = np.where(gains > 0, gains * self._eagerness()[:, np.newaxis], -np.inf)
        gains[~self._askable(asked)] = -np.inf
        variable, limit = divmod(int(gains.argmax()), gains.shape[1])
        gain = float(gains[variable, limit])
        return Split(gain, variable, limit) if gain > 0 else None

    def _eagerness(self) -> Float64Array:
        return np.array([1 if k in self._used else NOVELTY for k in range(len(self._names))])

    def _askable(self, asked: dict[tuple[int, str], int]) -> BoolArray:
        """Return which variables both children may be asked about."""
        room = MOST_CONDITIONS - len(asked)
        new = [((k, "<") not in asked, (k, ">") not in asked) for k in range(len(self._names))]
        return np.array([max(pair) <= room for pair in new])


def limits_of(values: Float32Array) -> Float32Array:
    """Spread limits evenly over the ranks of the values, each between two values that there are.

    They are rounded, so that a file shows few digits.
    """
    spread = np.quantile(values, np.linspace(0, 1, N_LIMITS + 2)[1:-1])
    found = np.unique(values)
    above = np.clip(np.searchsorted(found, spread), min(1, len(found) - 1), len(found) - 1)
    between = (found[np.maximum(above - 1, 0)] + found[above]) / 2
    return np.unique(np.array([float(f"{v:.{SIGNIFICANT_DIGITS}g}") for v in between], np.float32))


def ranks_of(features: Features, names: Sequence[str], limits: list[Float32Array]) -> UInt8Array:
    """Count for each value the limits that it exceeds or equals, shape (n_variables, n_frames)."""
    ranks = [np.searchsorted(edges, features[name], side="right") for name, edges in zip(names, limits, strict=True)]
    return np.array(ranks, np.uint8)


def leaves_of(node: Node) -> list[Node]:
    """Return the leaves of a tree from left to right."""
    return [leaf for child in node.children for leaf in leaves_of(child)] if node.children else [node]


def merged_leaves_of(node: Node) -> list[Node]:
    """Return the leaves of a tree; a part whose leaves all say the same is one."""
    leaves = leaves_of(node)
    if len({leaf.phoneme for leaf in leaves}) == 1:
        node.phoneme = leaves[0].phoneme
        return [node]
    return [leaf for child in node.children for leaf in merged_leaves_of(child)]


def best_phonemes(counts: Float64Array) -> list[Phoneme]:
    """Choose a phoneme for each leaf, so that the macro F1 is one that no single change betters.

    Parameters
    ----------
    counts : the weight of each phoneme in each leaf, shape (n_leaves, n_phonemes).
    """
    totals = counts.sum(axis=0)
    present = [p for p in SCORED_PHONEMES if totals[p] > 0]
    shares = counts[:, present] / totals[present]
    answers = [present[k] for k in shares.argmax(axis=1)]
    score, before = _macro_f1(counts, answers, present), -1.0
    while score > before:
        before = score
        for k in range(len(answers)):
            changed = [[*answers[:k], p, *answers[k + 1 :]] for p in present]
            scores = [_macro_f1(counts, others, present) for others in changed]
            if max(scores) > score:
                score, answers = max(scores), changed[int(np.argmax(scores))]
    return answers


def _macro_f1(counts: Float64Array, answers: Sequence[Phoneme], present: Sequence[Phoneme]) -> float:
    said = np.bincount(answers, counts.sum(axis=1), N_CODES)[present]
    hits = np.bincount(answers, counts[np.arange(len(answers)), answers], N_CODES)[present]
    return float((2 * hits / (said + counts.sum(axis=0)[present])).mean())


def _purity(counts: Float64Array) -> Float64Array:
    """Return the weight of frames times the chance that two of them are the same phoneme."""
    purity: Float64Array = (counts**2).sum(axis=-1) / np.maximum(counts.sum(axis=-1), 1e-12)
    return purity
