"""One line of a script in several takes: which of them says it best."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from phonemeengine.alignment.align import is_other_text
from phonemeengine.labels.utterance import UNKNOWN_WORD, Utterance


@dataclass(frozen=True)
class ScoredTake:
    """A recording of a line, and how well it says the line.

    Attributes
    ----------
    path : the sound's file.
    text : the line.
    score : of its words, see `Utterance.score`: 0 fits best; None where none of them is said.
    skipped : the words that nobody says.
    n_unknown : stretches in which something else is said.
    is_other : whether another text is said.
    is_best : whether no other take of the line is better.
    """

    path: Path
    text: str
    score: float | None
    skipped: tuple[str, ...]
    n_unknown: int
    is_other: bool
    is_best: bool = False

    @property
    def rank(self) -> tuple[bool, int, float]:
        """What orders takes: the better, the less. Words that are missing or added count before the score."""
        unheard = self.score is None or self.is_other
        return unheard, len(self.skipped) + self.n_unknown, self.score if self.score is not None else 0.0


def scored_take(path: Path, text: str, utterance: Utterance) -> ScoredTake:
    """Return how well a recording says a line, by the line's alignment with it."""
    said = [word for word in utterance.words if word.text != UNKNOWN_WORD]
    score = replace(utterance, words=tuple(said)).score
    n_unknown = len(utterance.words) - len(said)
    return ScoredTake(path, text, score, utterance.skipped, n_unknown, is_other_text(utterance))


def best_marked(takes: Iterable[ScoredTake]) -> tuple[ScoredTake, ...]:
    """Return takes in their order, the best one of each line marked; a line that nobody says has none."""
    takes = tuple(takes)
    best: dict[str, ScoredTake] = {}
    for take in takes:
        key = " ".join(take.text.split())
        if not take.rank[0] and (key not in best or take.rank < best[key].rank):
            best[key] = take
    chosen = {id(take) for take in best.values()}
    return tuple(replace(take, is_best=id(take) in chosen) for take in takes)
