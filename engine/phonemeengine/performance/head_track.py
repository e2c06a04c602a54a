"""Head, shoulders and brows of a sentence: as they moved in recorded phrases, and with gestures at key words.

A recorded phrase is fitted to the one that is said, syllable by syllable, neighbours are cross-faded, key words take
the place of what moves over them, and all is filtered at last. Where no head was recorded, it moves with the sound.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.mouth.head_motion import HeadMotion
from phonemeengine.performance.keywords import CHANNELS, Gesture, Keywords, load_keywords
from phonemeengine.performance.phrases import Match, MatchKind, Phrase, PhraseIndex, phrases_of
from phonemeengine.performance.recording import HEAD, SILENCE, Performance, PerformedPhone
from phonemeengine.performance.table_file import PerformanceTable

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
_FAR = 1e4
"""Seconds before and after a phrase in which a recording runs at its own pace: longer than any."""


@dataclass(frozen=True, eq=False)
class HeadTrack:
    """How head, shoulders and brows move through a sentence.

    Attributes
    ----------
    values : float32, shape (n_times, 10), by `CHANNELS`: turns of the head in degrees, then weights 0..1.
    matches : what it was made of, in order of time.
    notes : what is odd about it, a sentence each.
    """

    values: Float32Array
    matches: tuple[Match, ...]
    notes: tuple[str, ...]

    @property
    def head(self) -> Float32Array:
        """Yaw, pitch and roll, degrees, shape (n_times, 3)."""
        return self.values[:, : len(HEAD)]

    @property
    def weights(self) -> Mapping[str, Float32Array]:
        """The weights of brows and shoulders by channel, each of shape (n_times,)."""
        return dict(zip(CHANNELS[len(HEAD) :], self.values.T[len(HEAD) :], strict=True))


class HeadDriver:
    """Moves head, shoulders and brows of sentences by the phrases of a table.

    Parameters
    ----------
    table : recorded performances; it stays open as long as this is used.
    keywords : words with gestures, and conjunctions; those that ship, where it is None.
    seed : equal seeds sway alike where no head was recorded.
    """

    def __init__(self, table: PerformanceTable, keywords: Keywords | None = None, seed: int = 0) -> None:
        self._table, self._seed = table, seed
        self._keywords = load_keywords() if keywords is None else keywords
        self._columns = {name: k for k, name in enumerate(table.about.channels) if name in CHANNELS}
        recordings = table.recordings() if self._columns else iter(())
        self._index = PhraseIndex((number, performance.phones) for number, performance in recordings)

    def track(
        self, phones: Sequence[PerformedPhone], words: Sequence[str], language: str, times: Float64Array
    ) -> HeadTrack:
        """Return how a sentence, or what is said within one, moves head, shoulders and brows.

        Neighbours meet where the times of one are those of the other, if both know the phones about them.

        Parameters
        ----------
        phones : at least of these times, with energy and pitch where they are known; from rest to rest.
        words : the texts of words, by the numbers that phones have; there may be others before and after.
        language : its tag, such as ``en-us``; empty where nobody knows it: then no word has a gesture.
        times : seconds, evenly spaced.
        """
        spans = _spans_of(phones)
        numbers = [*spans]
        said = [words[number] for number in numbers]
        conjunctions = {numbers[k] for k in self._keywords.conjunctions_in(said, language)}
        matches = tuple(match for phrase in phrases_of(phones) for match in self._index.matches(phrase, conjunctions))
        times, inner = _with_margins(times)
        values = self._joined(matches, times)
        if not {*HEAD} <= self._columns.keys():
            values[:, : len(HEAD)] = _moved_by_sound(phones, times, self._seed)
        values *= _rested(phones, times)[:, None]
        for first, last, gesture in self._keywords.gestures_in(said, language):
            start = spans[numbers[first]][0]
            end = min(max(spans[numbers[last]][1], start + gesture.shortest), phones[-1].end)
            _gesticulate(values, gesture, (times - start) / (end - start))
        values = low_passed(values, 1 / (times[1] - times[0]), CUTOFF)
        values[:, len(HEAD) :] = values[:, len(HEAD) :].clip(0, 1)
        return HeadTrack(values[inner].astype(np.float32), matches, tuple(self._notes(matches)))

    def _joined(self, matches: Sequence[Match], times: Float64Array) -> Float64Array:
        """Return recorded phrases as they follow each other, shape (n_times, n_channels)."""
        values = np.zeros((len(times), len(CHANNELS)))
        for match, share in zip(matches, _shares_of([match.phrase for match in matches], times), strict=True):
            within = share > 0
            fitted = self._sampled(self._table.recording(match.recording), _fitted(match, times[within]))
            values[within] += share[within, None] * fitted
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

    def _notes(self, matches: Sequence[Match]) -> Iterator[str]:
        if not {*HEAD} <= self._columns.keys():
            yield "the table has no turns of the head; it moves with the sound"
        pieces = sorted({len(match.phrase) for match in matches if match.kind is MatchKind.PIECE})
        if pieces:
            lengths = ", ".join(map(str, pieces))
            yield f"the table has no phrases of {lengths} syllables for the head; it takes parts of others"


def _fitted(match: Match, times: Float64Array) -> Float64Array:
    """Return the times of the recorded phrase that belong to some times of the one that is said.

    Syllables meet where their numbers agree, else those with stress; before and after, the recording runs as it did.
    """
    said, recorded = np.array(_anchors(match.phrase, match)), np.array(_anchors(match.example, match))
    said = np.concatenate([[said[0] - _FAR], said, [said[-1] + _FAR]])
    recorded = np.concatenate([[recorded[0] - _FAR], recorded, [recorded[-1] + _FAR]])
    fitted: Float64Array = np.interp(times, said, recorded)
    return fitted


def _anchors(phrase: Phrase, match: Match) -> tuple[float, ...]:
    if len(match.phrase) == len(match.example):
        return phrase.times
    beats = phrase.beats if len(match.phrase.beats) == len(match.example.beats) else ()
    return (phrase.start, *beats, phrase.end)


def _shares_of(phrases: Sequence[Phrase], times: Float64Array) -> Iterator[Float64Array]:
    """Return the share of each phrase at each time; they sum to 1, and meet in the middles of pauses."""
    if not phrases:
        return
    borders = [(a.end + b.start) / 2 for a, b in pairwise(phrases)]
    lengths = [b - a for a, b in pairwise([phrases[0].start, *borders, phrases[-1].end])]
    widths = [min(FADE, a, b) for a, b in pairwise(lengths)]
    begun = [_step((times - at) / width + 0.5) for at, width in zip(borders, widths, strict=True)]
    for before, after in pairwise([np.ones(len(times)), *begun, np.zeros(len(times))]):
        yield before - after


def _step(places: Float64Array) -> Float64Array:
    """Return half a cosine from 0 at place 0 to 1 at place 1, even before and after."""
    step: Float64Array = (1 - np.cos(np.pi * places.clip(0, 1))) / 2
    return step


def _rested(phones: Sequence[PerformedPhone], times: Float64Array) -> Float64Array:
    """Return 1, but for the beginning and the end, where it comes from 0 and goes there."""
    return _step((times - phones[0].start) / REST) * _step((phones[-1].end - times) / REST)


def _with_margins(times: Float64Array) -> tuple[Float64Array, slice]:
    """Return times with some before and after them, evenly spaced, and where among these they are."""
    period = (times[-1] - times[0]) / max(len(times) - 1, 1) or MARGIN
    n = round(MARGIN / period)
    return times[0] + period * np.arange(-n, len(times) + n), slice(n, n + len(times))


def _gesticulate(values: Float64Array, gesture: Gesture, places: Float64Array) -> None:
    """Put a gesture, places 0..1, in the place of what moves, from where that was to where it goes on."""
    within = np.flatnonzero((places >= 0) & (places <= 1))
    if not len(within):
        return
    for channel in gesture.channels:
        column = values[:, CHANNELS.index(channel)]
        first, last = column[within[0]], column[within[-1]]
        column[within] = first + (last - first) * _step(places[within]) + gesture.curve(channel, places[within])


def _spans_of(phones: Sequence[PerformedPhone]) -> dict[int, tuple[float, float]]:
    """Return from when to when each word is said, seconds, by number."""
    spans: dict[int, tuple[float, float]] = {}
    for phone in phones:
        if phone.word >= 0:
            spans[phone.word] = (spans.get(phone.word, (phone.start, 0.0))[0], phone.end)
    return spans


def _moved_by_sound(phones: Sequence[PerformedPhone], times: Float64Array, seed: int) -> Float64Array:
    """Return the turns of a head that follows loudness and pitch, degrees, shape (n_times, 3)."""
    motion, coming = HeadMotion(seed), [*phones][::-1]
    spoken = [phone.energy for phone in phones if phone.name != SILENCE]
    mean = sum(spoken) / max(len(spoken), 1)
    turns = np.zeros((len(times), len(HEAD)))
    for k, time in enumerate(times.tolist()):
        while coming and coming[-1].start <= time:
            phone = coming.pop()
            loudness = 0.0 if phone.name == SILENCE else 0.5 + (phone.energy - mean) / LOUD_RANGE
            motion.hear(phone.start, loudness, phone.pitch)
        turns[k] = motion.pose(time)
    return turns


def low_passed(values: Float64Array, rate: float, cutoff: float) -> Float64Array:
    """Return values without what changes faster than a frequency, Hz; it is neither early nor late.

    A Butterworth filter of second order goes over them forwards and backwards.
    """
    from scipy.signal import butter, sosfiltfilt  # noqa: PLC0415 - it costs a second at the start

    if cutoff >= 0.45 * rate or len(values) < 2:
        return values
    sections = butter(2, cutoff, fs=rate, output="sos")
    padding = min(len(values) - 1, round(2 * rate / cutoff))
    filtered: Float64Array = sosfiltfilt(sections, values, axis=0, padlen=padding)
    return filtered
