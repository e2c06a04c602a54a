"""Head, shoulders and brows of a text: as they moved in recorded phrases, and with gestures at key words.

A recorded phrase is fitted to the one that is said, syllable by syllable, neighbours are cross-faded, key words take
the place of what moves over them, and all is filtered at last. Where no head was recorded, it moves with the sound.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, IndexArray
from phonemeengine.mouth.idle_motion import HeadMotion
from phonemeengine.mouth.style_numbers import GestureNumbers
from phonemeengine.performance.keywords import CHANNELS, Gesture, Keywords, joined_words, load_keywords, phrases_in
from phonemeengine.performance.recording import HEAD, SILENCE, Performance
from phonemeengine.performance.smoothing import MonotoneCubics, crossed, low_passed
from phonemeengine.performance.table_file import PerformanceTable
from phonemeengine.performance.units import Phrase, PhraseMatch, PhraseMatchKind, Sentence, phrases_of

CUTOFF = 6.0
"""Hertz above which the filter takes movement away: a shake of the head has 2 to 4."""
FADE = 0.4
"""Seconds in which one recording goes over into the next, at most."""
REST = 0.3
"""Seconds in which all come from rest, and go back there, at the beginning and the end."""
MARGIN = 1.0
"""Seconds before and after the times that are asked for, over which the filter goes too."""
LOUD_RANGE = 24.0
"""Decibels from silence to full loudness, about the mean of the sentence."""


class HeadDriver:
    """Moves head, shoulders and brows through a text by the phrases of a table.

    Parameters
    ----------
    table : recorded performances; it stays open as long as this is used.
    words : of the text, by the numbers that phones have.
    language : its tag, such as ``en-us``; in an unknown one, words have no gestures.
    keywords : words with gestures, and conjunctions; those that ship, where it is None.
    seed : equal seeds sway alike where no head was recorded.
    gestures : how far all goes.
    """

    def __init__(
        self,
        table: PerformanceTable,
        words: Sequence[str],
        language: str,
        keywords: Keywords | None = None,
        seed: int = 0,
        gestures: GestureNumbers | None = None,
    ) -> None:
        self._numbers = gestures or GestureNumbers()
        keywords = load_keywords() if keywords is None else keywords
        self._conjunctions = keywords.conjunctions_in(words, language)
        clips = table.about.clips
        self._clips = tuple((*span, clips[joined_words(words, *span)]) for span in phrases_in(words, clips))
        answered = {word for first, last, _name in self._clips for word in range(first, last + 1)}
        made = keywords.gestures_in(words, language)
        self._gestures = tuple(found for found in made if answered.isdisjoint(range(found[0], found[1] + 1)))
        self._table, self._seed = table, seed
        self._columns = {name: k for k, name in enumerate(table.about.channels) if name in CHANNELS}
        self._turns = {*HEAD} <= self._columns.keys()

    def matches(self, sentence: Sentence) -> tuple[PhraseMatch, ...]:
        """Return the recorded phrases of which a sentence's movement is made, in order of time."""
        if not self._columns:
            return ()
        phrases = phrases_of(sentence)
        return tuple(found for phrase in phrases for found in self._table.phrases.matches(phrase, self._conjunctions))

    def notes(self, sentence: Sentence) -> Iterator[str]:
        """Return what the table lacks for a sentence, a sentence each."""
        if not self._turns:
            yield "the table has no turns of the head: it moves with the sound"
        lengths = {len(match.phrase) for match in self.matches(sentence) if match.kind is PhraseMatchKind.PIECE}
        if lengths:
            counts = ", ".join(map(str, sorted(lengths)))
            yield f"the table has no phrase with these numbers of syllables: {counts}; the head takes parts of others"

    def track(self, sentence: Sentence, times: Float64Array) -> Float32Array:
        """Return how a sentence moves head, shoulders and brows at some times.

        Tracks of neighbouring times meet, if they are of the same sentence, or know what is said about the join.

        Parameters
        ----------
        sentence : its phones; all is at rest where they begin and end.
        times : seconds, evenly spaced.

        Returns
        -------
        float32, shape (n_times, 10), by `CHANNELS`: turns of the head in degrees, then weights 0..1.
        """
        times, inner = _with_margins(times)
        values = self._joined(self.matches(sentence), times)
        if not self._turns:
            values[:, : len(HEAD)] = _moved_by_sound(sentence, times, HeadMotion(self._seed, self._numbers))
        begin, end = sentence[0].start, sentence[-1].end
        values *= (crossed(times, begin, begin + REST) * (1 - crossed(times, end - REST, end)))[:, None]
        for start, stop, gesture in self._gestures_in(sentence):
            _gesticulate(values, gesture, (times - start) / (stop - start), self._numbers.size)
        for start, stop, clip in self._clips_in(sentence):
            begun, ended = (crossed(times, at - FADE / 2, at + FADE / 2) for at in (start, stop))
            spoken = clip.phones[0].end, clip.phones[-1].start
            recorded = self._sampled(clip, np.interp(times, (start, stop), spoken))
            moved = [CHANNELS.index(name) for name in self._columns]
            values[:, moved] += (begun - ended)[:, None] * (self._numbers.size * recorded - values)[:, moved]
        values = low_passed(values, CUTOFF * (times[1] - times[0]))
        values[:, len(HEAD) :] = values[:, len(HEAD) :].clip(0, 1)
        return values[inner].astype(np.float32)

    def _joined(self, matches: Sequence[PhraseMatch], times: Float64Array) -> Float64Array:
        """Return recorded phrases as they follow each other, shape (n_times, n_channels)."""
        values = np.zeros((len(times), len(CHANNELS)))
        for match, share in zip(matches, _shares_of([match.phrase for match in matches], times), strict=True):
            within = share > 0
            recorded = self._sampled(self._table.recording(match.recording), _fitted(match, times[within]))
            values[within] += self._numbers.size * share[within, None] * recorded
        return values

    def _sampled(self, performance: Performance, times: Float64Array) -> Float64Array:
        """Return the channels of a recording at some times; turns of the head are counted from their median.

        A camera stands anywhere.
        """
        values = np.zeros((len(times), len(CHANNELS)))
        frames = np.arange(len(performance.weights)) / performance.rate
        for name, column in self._columns.items():
            recorded = performance.weights[:, column]
            median = np.median(recorded) if name in HEAD else 0.0
            values[:, CHANNELS.index(name)] = np.interp(times, frames, recorded) - median
        return values

    def _clips_in(self, sentence: Sentence) -> Iterator[tuple[float, float, Performance]]:
        """Return the recordings that answer words of a sentence, each with the start and end of these, seconds."""
        starts, ends = _times_of_words(sentence)
        for first, last, name in self._clips:
            if first in starts and last in ends:
                yield starts[first], ends[last], self._table.recording_called(name)

    def _gestures_in(self, sentence: Sentence) -> Iterator[tuple[float, float, Gesture]]:
        """Return the gestures of a sentence, each with its start and end, seconds."""
        starts, ends = _times_of_words(sentence)
        for first, last, gesture in self._gestures:
            if first in starts and last in ends:
                end = max(ends[last], starts[first] + gesture.shortest)
                yield starts[first], min(end, sentence[-1].end), gesture


def _times_of_words(sentence: Sentence) -> tuple[dict[int, float], dict[int, float]]:
    """Return when each word begins and ends, seconds, by its number."""
    return {phone.word: phone.start for phone in reversed(sentence)}, {phone.word: phone.end for phone in sentence}


def _fitted(match: PhraseMatch, times: Float64Array) -> Float64Array:
    """Return the times of the recorded phrase that belong to some times of the one that is said.

    Syllables meet where their numbers agree, else those with stress; before and after, the recording runs on.
    """
    said, recorded = np.array(_anchors(match.phrase, match)), np.array(_anchors(match.example, match))
    first: IndexArray = np.zeros(1, np.intp)
    return MonotoneCubics(said, recorded, first).at(times, np.zeros(len(times), np.intp))


def _anchors(phrase: Phrase, match: PhraseMatch) -> tuple[float, ...]:
    if len(match.phrase) == len(match.example):
        return phrase.times
    beats = phrase.beats if len(match.phrase.beats) == len(match.example.beats) else ()
    return (phrase.start, *beats, phrase.end)


def _shares_of(phrases: Sequence[Phrase], times: Float64Array) -> Iterator[Float32Array]:
    """Return the share of each phrase at each time; they sum to 1, and meet in the middles of pauses."""
    if not phrases:
        return
    borders = [(a.end + b.start) / 2 for a, b in pairwise(phrases)]
    lengths = [b - a for a, b in pairwise([phrases[0].start, *borders, phrases[-1].end])]
    halves = [min(FADE, a, b) / 2 for a, b in pairwise(lengths)]
    begun = [np.ones(len(times), np.float32)]
    begun += [crossed(times, at - half, at + half) for at, half in zip(borders, halves, strict=True)]
    for before, after in pairwise([*begun, np.zeros(len(times), np.float32)]):
        yield before - after


def _with_margins(times: Float64Array) -> tuple[Float64Array, slice]:
    """Return times with some before and after them, evenly spaced, and where among these they are."""
    period = (times[-1] - times[0]) / max(len(times) - 1, 1) or MARGIN
    n = round(MARGIN / period)
    return times[0] + period * np.arange(-n, len(times) + n), slice(n, n + len(times))


def _gesticulate(values: Float64Array, gesture: Gesture, places: Float64Array, size: float) -> None:
    """Put a gesture, places 0..1, in the place of what moves, from where that was to where it goes on."""
    within = np.flatnonzero((places >= 0) & (places <= 1))
    if not len(within):
        return
    way = crossed(places[within], 0.0, 1.0)
    for channel in gesture.channels:
        column = values[:, CHANNELS.index(channel)]
        first, last = column[within[0]], column[within[-1]]
        column[within] = first + (last - first) * way + size * gesture.curve(channel, places[within])


def _moved_by_sound(sentence: Sentence, times: Float64Array, motion: HeadMotion) -> Float64Array:
    """Return the turns of a head that follows loudness and pitch, degrees, shape (n_times, 3)."""
    coming = [*sentence][::-1]
    spoken = [phone.energy for phone in sentence if phone.name != SILENCE]
    mean = sum(spoken) / max(len(spoken), 1)
    turns = np.zeros((len(times), len(HEAD)))
    for k, time in enumerate(times.tolist()):
        while coming and coming[-1].start <= time:
            phone = coming.pop()
            loudness = 0.0 if phone.name == SILENCE else 0.5 + (phone.energy - mean) / LOUD_RANGE
            motion.add(phone.start, loudness, phone.pitch)
        turns[k] = motion.pose(time)
    return turns
