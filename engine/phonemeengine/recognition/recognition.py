"""What a recogniser gives for a block of frames, and why."""

from dataclasses import dataclass

from phonemeengine.arrays import Float32Array, UInt8Array
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
