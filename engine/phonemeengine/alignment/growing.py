"""Where the words of a text are in a sound while both still come: at once as it seems, a little later for good."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, takewhile

from phonemeengine.alignment.aligner import PRICES, TextFit, edges_of, fit_of, settled_steps, united, within
from phonemeengine.alignment.evidence import Evidence, joined, shortfalls_of, spoken_in
from phonemeengine.alignment.passage import Passage
from phonemeengine.alignment.viterbi import LeastFrames, WayStep, cheapest_way
from phonemeengine.errors import TextError
from phonemeengine.labels.utterance import Word
from phonemeengine.storage.files import printable
from phonemeengine.text.pronunciation import ScriptWord

LONGEST, UNSETTLED = 200, 100
"""Frames that are aligned anew each time, and how many at their end stay unsettled beyond that."""
MOST_SOUNDS = 80
"""Sounds of the text that are looked for in these frames: 25 a second, more than fast speakers say."""
LONGEST_WORD = 1000
"""Sounds that a word has at the most."""
SHOWN = 20
"""Letters of a word that are shown."""
HURRY = 1
"""Frames by which sounds may be shorter than usual: the rate of the speech is not known yet."""


@dataclass(frozen=True)
class GrownWords:
    """What is known of the words by now.

    Attributes
    ----------
    settled : words that were settled since the last look; they stay as they are.
    open : those after them that are recognised by now, and may still move or change; the last one may be
        cut off.
    skipped : words of the text, as it writes them, that were settled since the last look as not spoken.
    """

    settled: tuple[Word, ...] = ()
    open: tuple[Word, ...] = ()
    skipped: tuple[str, ...] = ()


class GrowingAligner:
    """Finds the words of a text in a sound, while both arrive in chunks, in memory that grows with neither.

    Words are looked for in the last seconds of the sound only, so they must come before it, or soon after.

    Attributes
    ----------
    n_waiting : frames that are kept since a word may still end in them.
    """

    def __init__(self) -> None:
        self._words: list[ScriptWord] = []
        self._waiting: list[Evidence] = []
        self.n_waiting = self._n_settled = 0
        self._fit = TextFit()

    @property
    def fit(self) -> TextFit:
        """How badly the text fits what is settled of the sound."""
        return self._fit

    def add_words(self, words: Sequence[ScriptWord]) -> None:
        """Take the next words of the text.

        Raises
        ------
        TextError : a word has more sounds than anybody says in one.
        """
        for word in words:
            if _n_sounds_of(word) > LONGEST_WORD:
                shown = printable(word.text[:SHOWN])
                raise TextError(f"the word {shown!r}... has more than {LONGEST_WORD} sounds; write it as several")
        self._words += words

    def push(self, evidence: Evidence) -> None:
        """Take the evidence of the next frames."""
        self._waiting.append(evidence)
        self.n_waiting += len(evidence)

    def look(self) -> GrownWords:
        """Return what is known of the words by now; to be asked every few frames."""
        return self._look(last=False)

    def finish(self, duration: float) -> GrownWords:
        """Return what is known of the words in the end, all of it settled, in a sound of `duration` seconds."""
        found = self._look(last=True)
        words = tuple(within(word, duration) for word in found.settled if word.start < duration)
        return GrownWords(words, (), (*found.skipped, *(word.text for word in self._words)))

    def _look(self, *, last: bool) -> GrownWords:
        if not self.n_waiting:
            return GrownWords()
        given = joined(self._waiting)
        self._waiting = [given]
        if not self._words:
            self._forget(0 if last else max(0, len(given) - LONGEST))
            return GrownWords()
        # What waits is aligned anew at each look: 2 s of sound and 80 sounds are cheap enough, and nothing of an
        # earlier, worse guess can stick.
        passage = Passage(self._next_words())
        shortfalls = shortfalls_of(given)
        least = LeastFrames(passage.least_frames(HURRY))
        whole = last and len(self._words) == len(passage.words)
        way = cheapest_way(shortfalls, passage.lattice, PRICES, least, whole=whole)
        assert way is not None  # all of it may be strange
        steps, rest = self._parted(way.steps, len(given), passage, last=last)
        settled, coming = (
            united([*passage.words_in(part, shortfalls, self._n_settled, edges_of(part, passage, shortfalls, given))])
            for part in (steps, rest)
        )
        found = GrownWords(tuple(settled), tuple(coming), tuple(passage.skipped_in(steps)))
        n = steps[-1].last if steps else 0
        self._fit += fit_of(steps, passage, shortfalls, spoken_in(given))
        del self._words[: passage.n_words_in(steps)]
        self._forget(n)
        return found

    def _next_words(self) -> tuple[ScriptWord, ...]:
        """Return the words that can be said in the frames that wait, at least one."""
        n_sounds = accumulate(map(_n_sounds_of, self._words))
        n_words = sum(1 for _ in takewhile(lambda n: n <= MOST_SOUNDS, n_sounds))
        return tuple(self._words[: max(1, n_words)])

    def _forget(self, n: int) -> None:
        """Forget the first frames that wait."""
        self._waiting = [self._waiting[0].part(slice(n, None))]
        self._n_settled += n
        self.n_waiting -= n

    def _parted(
        self, steps: Sequence[WayStep], n: int, passage: Passage, *, last: bool
    ) -> tuple[Sequence[WayStep], Sequence[WayStep]]:
        """Return the steps that are settled, and those that are not, of a way through `n` frames."""
        if last:
            return steps, ()
        if n <= LONGEST:
            return (), steps
        settled = settled_steps(steps, n - UNSETTLED, passage)
        rest = list(steps[len(settled) :])
        cut = steps[len(settled) - 1]
        # a quiet or strange step was cut in two: its rest comes first in what is open
        if settled and settled[-1].last < cut.last:
            rest.insert(0, cut._replace(first=settled[-1].last))
        return settled, rest


def _n_sounds_of(word: ScriptWord) -> int:
    return max(len(pronunciation.phones) for pronunciation in word.pronunciations)
