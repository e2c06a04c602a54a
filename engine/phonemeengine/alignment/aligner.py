"""Finds when the words of a text are spoken in a recording: any length of both, in memory that grows with neither.

A section of the sound is aligned with the words that can be in it at most. All but its end, whose best way may still
change, is settled up to the end of a word, and the next section begins there.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from phonemeengine.alignment import viterbi
from phonemeengine.alignment.evidence import Evidence, joined, least_frames_of, shortfalls_of, spoken_in
from phonemeengine.alignment.passage import Passage
from phonemeengine.arrays import BoolArray, Float32Array, Float64Array
from phonemeengine.errors import CorpusError
from phonemeengine.labels.utterance import UNKNOWN_WORD, Phone, Syllable, Utterance, Word
from phonemeengine.text.pronunciation import ScriptWord

# Where sounds begin and end, finer than frames: where one suits as well as the next, and where speech has faded.

FADED = 28.0
"""A sound before a pause ends this many dB below loud speech: synthesizers' own ends lie at 14 to 39."""
ABOVE_PAUSE = 8.0
"""Or where it is so little above the pause, dB, if that is louder."""
LONGEST_FADING = 12
"""Frames for which a sound may fade after silence is recognised."""
LOUD = 90
"""Percentile of the level of speech that is loud."""


def edges_of(
    steps: Sequence[viterbi.WayStep], passage: Passage, shortfalls: Float64Array, evidence: Evidence
) -> Mapping[int, float]:
    """Return where the edges between the steps of a way are, in frames, by the number of the frame after each."""
    levels, spoken = evidence.levels[:, 0], spoken_in(evidence)
    # The recogniser's edges are on whole frames, and its window smears them. Where two sounds meet their scores are
    # compared, before a pause the level decides.
    quiet = float(np.percentile(levels[spoken], LOUD)) - FADED if spoken.any() else np.inf
    edges: dict[int, float] = {}
    lasting = [step for step in steps if step.kind != viterbi.SKIPPED]
    for step, following in pairwise(lasting):
        edge = step.last
        if step.kind == viterbi.SOUND and following.kind == viterbi.SILENT and not passage.closes(following, lasting):
            edges[edge] = _faded(levels, step, following, quiet)
        else:
            columns = [passage.column_of(part) for part in (step, following)]
            if None not in columns:
                edges[edge] = _crossing(shortfalls[:, columns[0]] - shortfalls[:, columns[1]], edge)
    return edges


def _crossing(lead: Float64Array, edge: int) -> float:
    """Return where the lead of one sound over the next ends; frames are measured at their middle."""
    before, after = float(lead[edge - 1]), float(lead[edge])
    # linear between the two frame middles, at the place where both sounds fit equally well
    return edge - 0.5 + before / (before - after) if before > 0 > after else float(edge)


def _faded(levels: Float32Array, step: viterbi.WayStep, pause: viterbi.WayStep, quiet: float) -> float:
    """Return where a sound before a pause has faded, at the earliest where silence is recognised."""
    # Where the room is noisy speech never falls FADED dB; then it ends where it sinks into the noise.
    limit = max(quiet, float(levels[pause.first : pause.last].min()) + ABOVE_PAUSE)
    last = min(step.last + LONGEST_FADING, (pause.first + pause.last) // 2)
    frame = step.last - 1
    if levels[frame] < limit:
        return float(step.last)
    # on to the first frame below the limit, but not into the second half of the pause
    while frame + 1 < last and levels[frame + 1] >= limit:
        frame += 1
    if frame + 1 >= len(levels) or levels[frame + 1] >= limit:
        return float(max(step.last, last))
    # the level is interpolated between the last frame above the limit and the first one below
    return max(step.last - 0.5, frame + 0.5 + float((levels[frame] - limit) / (levels[frame] - levels[frame + 1])))


# How badly a text fits a sound, and from when on another text was said.
#
# What counts are sounds, not frames: in a text that is said most sounds fit well and a few do not, since they are
# said or recognised otherwise; in another text many of them do not fit. So no sound counts more than `WORST_SOUND`.
# Silence does not count, however long it is.

WORST_SOUND = 3.0
"""The most that a sound falls short of the best one, in the mean over its frames; more of it tells nothing."""
STRANGE_SOUND = 2.0
"""What a sound counts that is said and does not stand in the text."""
FRAMES_OF_A_SOUND = 8
"""Frames for each sound that is spoken besides the text."""
WORST_FIT = 1.38
"""Another text was said where its sounds count more in the mean."""


@dataclass(frozen=True)
class TextFit:
    """How badly a text fits a sound.

    Attributes
    ----------
    misfit : of all sounds, natural logarithms.
    n_sounds : how many there are, of the text and besides it.
    """

    misfit: float = 0.0
    n_sounds: float = 0.0

    @property
    def mean(self) -> float:
        """How badly a sound fits in the mean, 0..`WORST_SOUND`."""
        return self.misfit / self.n_sounds if self.n_sounds else 0.0

    @property
    def is_wrong(self) -> bool:
        """Whether another text was said."""
        return self.mean > WORST_FIT

    def __add__(self, other: "TextFit") -> "TextFit":
        return TextFit(self.misfit + other.misfit, self.n_sounds + other.n_sounds)

    def __lt__(self, other: "TextFit") -> bool:
        return self.mean < other.mean


def fit_of(
    steps: Sequence[viterbi.WayStep], passage: Passage, shortfalls: Float64Array, spoken: BoolArray
) -> TextFit:
    """Return how badly a way through a passage fits.

    Parameters
    ----------
    steps : of the way.
    passage : the text.
    shortfalls : by which it was found, shape (n_frames, n_kinds).
    spoken : in which frames there is speech, shape (n_frames,).
    """
    fit = TextFit()
    for step in steps:
        frames = slice(step.first, step.last)
        if step.kind == viterbi.SOUND:
            kind = passage.lattice.columns[step.sound]
            fit += TextFit(_of_a_sound(shortfalls[frames, kind]), 1.0)
        elif step.kind == viterbi.SKIPPED:
            n_skipped = float(passage.lattice.fewest[step.sound])
            fit += TextFit(WORST_SOUND * n_skipped, n_skipped)
        elif spoken[frames].any():
            n_besides = np.count_nonzero(spoken[frames]) / FRAMES_OF_A_SOUND
            quiet = shortfalls[frames, 0][spoken[frames]]
            fit += TextFit(
                n_besides * (STRANGE_SOUND if step.kind == viterbi.STRANGE else _of_a_sound(quiet)), n_besides
            )
    return fit


def _of_a_sound(shortfalls: Float64Array) -> float:
    return min(-float(shortfalls.mean()), WORST_SOUND)


STRETCH, UNSETTLED = 1000, 220
"""Frames that are aligned at once, and how many at their end stay unsettled."""
MOST_SOUNDS = 200
"""Sounds of the text that may be in a section: 20 a second, more than fast speakers say."""
ONLY_THE_TEXT = viterbi.Prices(silence=3.0)
PRICES = viterbi.Prices(silence=3.0, skip=42.0, skip_sound=3.0, strange=35.0, strange_frame=1.0)
"""What does not fit costs so much: of 113 words that are left out 90 are found (of those of up to three sounds 6 in
10), and in 3 of 158 lines that are said as they are written a word is taken to be left out."""
PRICES_OF_ACCEPTED = viterbi.Prices(silence=3.0, skip=126.0, skip_sound=9.0, strange=105.0, strange_frame=3.0)
"""The same thrice, for a text that is known to be spoken."""
UNHURRIED = 0.6
"""Sounds last their usual least duration where all of them fill no more than this share of the whole sound."""
AROUND = 8
"""Frames before and after the speech that count as part of the sound; more silence says nothing of its hurry."""
MOST_HURRY = 5
"""Frames by which sounds may be shorter than usual."""


class Aligner:
    """Finds the words of a text, one section of the sound after the other.

    Parameters
    ----------
    words : the text.
    n_frames : how long the whole sound is: by that it is known how hurried the speech is.
    accepted : whether the text is known to be spoken: then less of it is left out.

    Raises
    ------
    CorpusError : there is no word.
    """

    def __init__(self, words: Sequence[ScriptWord], n_frames: int, *, accepted: bool = False) -> None:
        if not words:
            raise CorpusError("there is no word in the text; write down what is said in the sound")
        self._words = tuple(words)
        self._prices = PRICES_OF_ACCEPTED if accepted else PRICES
        self._n_sounds = np.cumsum([0, *(_shortest(word) for word in words)])
        self._hurry = _hurry_of(words, n_frames)
        self._waiting: list[Evidence] = []
        self._n_frames = self._n_words = 0
        self._found: list[Word] = []
        self._skipped: list[str] = []
        self._fit = TextFit()

    @property
    def fit(self) -> TextFit:
        """How badly the text fits the sound so far."""
        return self._fit

    def push(self, evidence: Evidence) -> None:
        """Take the evidence of the next frames."""
        self._waiting.append(evidence)
        # Settled up to a word that ends well before the end of the section; the rest is aligned again with what
        # follows, so memory holds one section, however long sound and text are.
        while sum(len(part) for part in self._waiting) > STRETCH:
            evidence = joined(self._waiting)
            n = self._align(evidence.part(slice(STRETCH)), last=False)
            self._waiting = [evidence.part(slice(n, None))]

    def finish(self, duration: float, language: str = "") -> Utterance:
        """Return where the words are in a sound of `duration` seconds; `language` is that of the text."""
        if any(len(part) for part in self._waiting):
            self._align(joined(self._waiting), last=True)
        skipped = (*self._skipped, *(word.text for word in self._words[self._n_words :]))
        words = (within(word, duration) for word in united(self._found) if word.start < duration)
        return Utterance(tuple(words), duration, language, skipped)

    def _align(self, evidence: Evidence, *, last: bool) -> int:
        """Align a section, and settle its beginning, or all of it; return how many of its frames are settled."""
        # no more of the text than can be said in a section: the rest would only cost time
        end = int(np.searchsorted(self._n_sounds, self._n_sounds[self._n_words] + MOST_SOUNDS))
        passage = Passage(self._words[self._n_words : end])
        whole = last and end > len(self._words)
        spoken, first = spoken_in(evidence), not self._n_words
        hurry = max(self._hurry, _hurry_of(passage.words, _n_about(spoken))) if whole else self._hurry
        shortfalls, least = shortfalls_of(evidence), viterbi.LeastFrames(passage.least_frames(hurry))
        way = viterbi.cheapest_way(shortfalls, passage.lattice, self._prices, least, whole=whole)
        assert way is not None  # all of it may be strange
        steps = way.steps if last else settled_steps(way.steps, len(evidence) - UNSETTLED, passage)
        n = steps[-1].last if steps else 0
        fit = fit_of(steps, passage, shortfalls, spoken)
        # A short text may fit badly only because the cheapest way skipped what was said: without skips it gets a
        # second chance.
        if fit.is_wrong and whole and first:
            strict = viterbi.cheapest_way(shortfalls, passage.lattice, ONLY_THE_TEXT, least)
            fit = fit if strict is None else min(fit, fit_of(strict.steps, passage, shortfalls, spoken))
        self._fit += fit
        edges = edges_of(steps, passage, shortfalls, evidence)
        self._found += passage.words_in(steps, shortfalls, self._n_frames, edges)
        self._skipped += passage.skipped_in(steps)
        self._n_words += passage.n_words_in(steps)
        self._n_frames += n
        return n


def settled_steps(steps: Sequence[viterbi.WayStep], limit: int, passage: Passage) -> Sequence[viterbi.WayStep]:
    """Return the steps up to the last end of a word before a frame; pauses and unknown speech are cut there."""
    # The cheapest way hardly changes but near its end, as more sound comes; `UNSETTLED` frames are left for that.
    ends = [k for k, step in enumerate(steps) if step.last <= limit and passage.ends_word(step)]
    n = ends[-1] + 1 if ends else 0
    if (
        n < len(steps)
        and steps[n].kind in {viterbi.SILENT, viterbi.STRANGE}
        and steps[n].first < limit < steps[n].last
    ):
        return [*steps[:n], steps[n]._replace(last=limit)]
    return steps[:n] or steps


def _hurry_of(words: Sequence[ScriptWord], n_frames: int) -> int:
    """Return by how many frames sounds are shorter than usual, so that all of them have room."""
    # The least durations are those of speech that is not hurried. Where all of them fill more than `UNHURRIED` of the
    # sound, every sound loses a frame, then another, until they fit: an alignment must exist, and have room to
    # choose.
    usual = np.array([least_frames_of(ipa) for word in words for ipa in word.pronunciations[0].phones])
    lengths = (int(np.maximum(usual - hurry, 1).sum()) for hurry in range(MOST_HURRY))
    return next((hurry for hurry, n in enumerate(lengths) if n <= UNHURRIED * n_frames), MOST_HURRY)


def _n_about(spoken: BoolArray) -> int:
    """Return how many frames there are from a little before the first one with speech to a little after the last."""
    frames = np.flatnonzero(spoken)
    return min(len(spoken), int(frames[-1] - frames[0]) + 1 + 2 * AROUND) if len(frames) else 0


def _shortest(word: ScriptWord) -> int:
    return min(len(pronunciation.phones) for pronunciation in word.pronunciations)


def united(words: Sequence[Word]) -> Iterator[Word]:
    """Return words, where unknown ones that touch each other are one."""
    before: Word | None = None
    for word in words:
        if before is not None and before.text == word.text == UNKNOWN_WORD and word.start - before.end < 1e-6:
            before = Word(UNKNOWN_WORD, (Syllable(before.phones + word.phones),))
            continue
        if before is not None:
            yield before
        before = word
    if before is not None:
        yield before


def within(word: Word, duration: float) -> Word:
    """Return a word that ends within the sound."""
    if word.end <= duration:
        return word
    syllables = (replace(s, phones=tuple(_cut(phone, duration) for phone in s.phones)) for s in word.syllables)
    return replace(word, syllables=tuple(syllables))


def _cut(phone: Phone, duration: float) -> Phone:
    return replace(phone, start=min(phone.start, duration), end=min(phone.end, duration))
