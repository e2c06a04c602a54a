"""Why a frame was recognised as it was."""

from dataclasses import dataclass

from phonemeengine.phonemes import Phoneme


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


@dataclass(frozen=True)
class Trace:
    """The rule that fired, and every comparison on the way to it."""

    phoneme: Phoneme
    rule: str
    comparisons: tuple[RuleComparison, ...]
