"""Grow rules from labelled frames: a decision tree, each of whose leaves is a rule.

The tree grows where it gains most: of all leaves the one is split, by the variable and the limit, that leaves the
least impurity (weighted Gini). A split by a variable that no rule asks for yet must gain more than one by a
variable that is in use, so that there are few variables to understand. At last the leaves choose their phonemes
together, so that the macro F1 is best, and neighbours with the same phoneme become one.

Each leaf is a rule with all comparisons on the way to it, or, with far fewer, one of a decision list (Rivest, Machine
Learning 2, 1987): what an earlier rule has dealt with is not asked again.
"""

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array, IndexArray, UInt8Array
from phonemeengine.calibration.scores.scoring import N_CODES, SCORED_PHONEMES
from phonemeengine.features.variables import Features
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

LEAST_GAIN = 1e-12
"""A leaf changes its phoneme for no less macro F1, such as that of rounding."""

SIGNIFICANT_DIGITS = 4

NOTHING = np.zeros((0, 0, 0))

Asked = dict[tuple[int, str], int]
"""Comparisons: the number of a limit by that of the variable and the sign."""


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
    asked: Asked
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
    least_share : the least share of the frames' weight that a rule may be made for.
    """

    def __init__(
        self,
        features: Features,
        truth: UInt8Array,
        weights: Float64Array,
        variables: Sequence[str],
        least_share: float = LEAST_SHARE,
    ) -> None:
        self._known = truth != Phoneme.UNIDENTIFIED
        self._names = tuple(variables)
        self._least_share = least_share
        self._limits = [limits_of(features[name][self._known]) for name in self._names]
        self._take(ranks_of(features, self._names, self._limits)[:, self._known], truth, weights)

    def part(self, chosen: BoolArray) -> "RuleSearch":
        """Return a search in some of the frames, with the same candidates for limits, shape (n_frames,)."""
        part = copy(self)
        part._known = self._known & chosen
        part._take(self._ranks[:, chosen[self._known]], self._given[0], self._given[1])
        return part

    def _take(self, ranks: UInt8Array, truth: UInt8Array, weights: Float64Array) -> None:
        self._given = truth, weights
        self._ranks = ranks
        self._truth = truth[self._known].astype(np.int16)
        shares = np.bincount(self._truth, weights[self._known], N_CODES)
        self._balance = np.maximum(shares / shares.sum(), 1e-9) ** -BALANCE
        balanced = weights[self._known] * self._balance[self._truth]
        self._weights = balanced / balanced.sum()
        self._used: set[int] = set()

    def grow(self, n_rules: int) -> Node:
        """Grow a tree of at most this many leaves."""
        leaves = [root := self._root()]
        while len(leaves) < n_rules and self._split_one(leaves):
            pass
        return root

    def list_within(self, most: int) -> tuple[Rule, ...]:
        """Grow a tree as far as its rules, as a decision list, have at most this many conditions in all."""
        leaves = [root := self._root()]
        found = self.list_of(root)
        while len(leaves) <= most and self._split_one(leaves):  # each rule but the last has a condition
            larger = self.list_of(root)
            if conditions_in(larger) > most:
                break
            found = larger
        return found

    def _root(self) -> Node:
        self._used = set()
        everything = np.arange(len(self._truth), dtype=np.int32)
        return self._node(everything, self._count(everything), {})

    def _split_one(self, leaves: list[Node]) -> bool:
        """Split the leaf where that gains most; says whether there was one."""
        best = max(leaves, key=self._worth)
        if best.split is None:
            return False
        leaves.remove(best)
        leaves.extend(self._divide(best, best.split))
        return True

    def rules_of(self, root: Node) -> tuple[Rule, ...]:
        """Write a tree as rules, the leaves' phonemes chosen for the best macro F1."""
        self._choose_phonemes(root)
        return tuple(self._rule_of(node.phoneme, node.asked) for node in merged_leaves_of(root))

    def list_of(self, root: Node) -> tuple[Rule, ...]:
        """Write a tree as a decision list, whose last rule asks nothing."""
        self._choose_phonemes(root)
        rules = [self._rule_of(phoneme, asked) for phoneme, asked in decision_list_of(root)]
        while len(rules) > 1 and rules[-2].phoneme is rules[-1].phoneme:
            del rules[-2]  # the last one says the same of whatever gets there
        return tuple(rules)

    def _choose_phonemes(self, root: Node) -> None:
        leaves = leaves_of(root)
        counts = np.array([leaf.totals for leaf in leaves]) / self._balance
        for leaf, phoneme in zip(leaves, best_phonemes(counts), strict=True):
            leaf.phoneme = phoneme

    def _rule_of(self, phoneme: Phoneme, asked: Asked) -> Rule:
        conditions = (
            Condition(self._names[variable], sign, limit=float(str(self._limits[variable][rank])))
            for (variable, sign), rank in sorted(asked.items())
        )
        return Rule(phoneme, tuple(conditions))

    def _node(self, frames: NDArray[np.int32], counts: Float64Array, asked: Asked) -> Node:
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

    def _best_split(self, counts: Float64Array, asked: Asked) -> Split | None:
        below = counts.cumsum(axis=1)[:, :-1]
        above = below[:, -1:] + counts[:, -1:] - below
        purity = _purity(below) + _purity(above)
        small = np.minimum(below.sum(axis=2), above.sum(axis=2)) < self._least_share
        gains = np.where(small, -np.inf, purity - _purity(counts[0].sum(axis=0)))
        gains = np.where(gains > 0, gains * self._eagerness()[:, np.newaxis], -np.inf)
        gains[~self._askable(asked)] = -np.inf
        variable, limit = divmod(int(gains.argmax()), gains.shape[1])
        gain = float(gains[variable, limit])
        return Split(gain, variable, limit) if gain > 0 else None

    def _eagerness(self) -> Float64Array:
        return np.array([1 if k in self._used else NOVELTY for k in range(len(self._names))])

    def _askable(self, asked: Asked) -> BoolArray:
        """Return which variables both children may be asked about."""
        room = MOST_CONDITIONS - len(asked)
        new = [((k, "<") not in asked, (k, ">") not in asked) for k in range(len(self._names))]
        return np.array([max(pair) <= room for pair in new])


def limits_of(values: Float32Array) -> Float32Array:
    """Spread limits evenly over the ranks of the values, each between two values that there are.

    They are rounded, so that a file shows few digits.
    """
    ordered = np.sort(values)
    spread = np.quantile(ordered, np.linspace(0, 1, N_LIMITS + 2)[1:-1])
    found = ordered[np.append(True, ordered[1:] != ordered[:-1])]
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


def decision_list_of(node: Node) -> list[tuple[Phoneme, Asked]]:
    """Return the leaves of a tree as a decision list: each with what is still to be asked where it is reached.

    Of the two sides of a comparison the one with fewer rules comes first, and only its rules ask the comparison.
    """
    phonemes = {leaf.phoneme for leaf in leaves_of(node)}
    if len(phonemes) == 1:
        return [(phonemes.pop(), {})]
    assert node.split is not None
    below, above = map(decision_list_of, node.children)
    first, rest, sign = (below, above, "<") if len(below) <= len(above) else (above, below, ">")
    comparison = {(node.split.variable, sign): node.split.limit}
    return [*((phoneme, comparison | asked) for phoneme, asked in first), *rest]  # what is asked within is narrower


def conditions_in(rules: Sequence[Rule]) -> int:
    """Return how many conditions rules have in all."""
    return sum(len(rule.conditions) for rule in rules)


def best_phonemes(counts: Float64Array) -> list[Phoneme]:
    """Choose a phoneme for each leaf, so that the macro F1 is one that no single change betters.

    Parameters
    ----------
    counts : the weight of each phoneme in each leaf, shape (n_leaves, n_phonemes).
    """
    totals = counts.sum(axis=0)
    present = [p for p in SCORED_PHONEMES if totals[p] > 0]
    shares = counts[:, present] / totals[present]
    answers = shares.argmax(axis=1)
    changed = True
    while changed:
        changed = False
        for k in range(len(answers)):
            scores = _macro_f1_by_answer(counts, totals, present, answers, k)
            best = int(scores.argmax())
            if scores[best] > scores[answers[k]] + LEAST_GAIN:
                answers[k], changed = best, True
    return [present[k] for k in answers]


def _macro_f1_by_answer(
    counts: Float64Array, totals: Float64Array, present: Sequence[Phoneme], answers: IndexArray, k: int
) -> Float64Array:
    """Return the macro F1 for each phoneme that leaf `k` may take, all other leaves as they are."""
    n, own = len(present), counts[:, present]
    others = np.arange(len(answers)) != k
    said = np.bincount(answers[others], counts.sum(axis=1)[others], n) + counts[k].sum() * np.eye(n)
    hits = np.bincount(answers[others], own[others, answers[others]], n) + np.diag(own[k])
    scores: Float64Array = (2 * hits / (said + totals[present])).mean(axis=1)
    return scores


def _purity(counts: Float64Array) -> Float64Array:
    """Return the weight of frames times the chance that two of them are the same phoneme."""
    purity: Float64Array = (counts**2).sum(axis=-1) / np.maximum(counts.sum(axis=-1), 1e-12)
    return purity
