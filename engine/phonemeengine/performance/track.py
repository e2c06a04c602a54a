"""What is said in a sound, or in a text that is still being spoken, as the track of a face that a table moves."""

import csv
import io
import math
import threading
from bisect import bisect_right
from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cached_property
from typing import Protocol, TypeVar

import numpy as np
from typing_extensions import override

from phonemeengine.analyser import Analyser
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.labels.utterance import Utterance, Word, shifted
from phonemeengine.mouth.animation import MovementTrack
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table
from phonemeengine.mouth.transcript import Prosody, Transcript
from phonemeengine.performance.driver import FACE, PerformanceDriver, PerformanceOptions, PerformancePart, UsedUnit
from phonemeengine.performance.halves import weights_at
from phonemeengine.performance.head_driver import HeadDriver
from phonemeengine.performance.keywords import CHANNELS, load_keywords
from phonemeengine.performance.recording import HEAD
from phonemeengine.performance.smoothing import TO_REST, crossed
from phonemeengine.performance.table_file import PerformanceTable
from phonemeengine.performance.units import Sentence, joined, performed_phones, sentences_in
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE
from phonemeengine.storage.files import begins_like

RATE = 60.0
"""Frames a second at least of what is looked up."""
KEPT, FEWEST_KEPT = 120.0, 2
"""Seconds of movement that stay in memory, and sentences that stay however long they are: neighbours meet."""
_HEAD_COLUMNS = [(*HEAD, *FACE).index(name) for name in CHANNELS]
UNIT_COLUMNS = ("start_s", "end_s", "set", "phones", "recording", "from_s", "to_s")


def face_table() -> MouthTable:
    """Return the mouth table of faces that are looked up: ARKit's shapes, and all movestates of `FACE`."""
    return replace(load_table(USUAL_TABLE), movestates=FACE)


class PerformanceTrack(MovementTrack):
    """What a table's performer says.

    Parameters
    ----------
    utterance : what is said, with times.
    speech : how loud and high it is.
    table : recorded performances; it stays open as long as the track is used.
    options : how they are looked up.

    Attributes
    ----------
    sentences : what is said, parted at long pauses.

    Raises
    ------
    PerformanceError : the table has no blend shapes of a mouth.
    """

    def __init__(
        self,
        utterance: Utterance,
        speech: Transcript,
        table: PerformanceTable,
        options: PerformanceOptions | None = None,
    ) -> None:
        self.utterance = utterance
        self.sentences = sentences_in(performed_phones(utterance, speech))
        self._driver = PerformanceDriver(table, options)
        self._head = self._head_by(table)
        self.head_follows = self._head is not None

    @property
    @override
    def face(self) -> MouthTable:
        return face_table()

    @property
    @override
    def rests_from(self) -> float:
        return _end_of(self.sentences[-1])

    @cached_property
    def notes(self) -> tuple[str, ...]:
        """What the table lacks for it, a sentence each."""
        phones = joined(self.sentences)
        return (*self._driver.notes(phones), *(() if self._head is None else self._head.notes(phones)))

    def units(self) -> Iterator[UsedUnit]:
        """Return the units that it is made of, in order of time; at a pause, neighbouring sentences overlap."""
        for number, sentence in enumerate(self.sentences):
            yield from self._driver.units(sentence, number)

    @override
    def mouth(self, rate: float = RATE) -> "PerformedMouth":
        """Return a mouth that says it, for a performer to play.

        Parameters
        ----------
        rate : pictures a second that will be shown of it.
        """
        return PerformedMouth(self.sentences, self._driver, self._head, rate)

    @override
    def mouth_at(self, rate: float) -> "PerformedMouth":
        """Return a mouth each of whose pictures is one that was looked up."""
        return self.mouth(rate)

    def _head_by(self, table: PerformanceTable) -> HeadDriver | None:
        """Return what moves the head, unless that is left out."""
        options = self._driver.options
        if PerformancePart.HEAD in options.without:
            return None
        words = [word.text for word in self.utterance.words]
        return HeadDriver(
            table, words, self.utterance.language, options.keywords, options.seed, options.style.gesturing()
        )


class PerformedMouth:
    """A `MouthTrack` that is looked up: the weights of its movestates, and how the head is turned, at any time.

    A sentence is looked up when a time in it is first asked for. Its frames are a whole number of times closer than
    pictures, so that each picture is a frame.

    Parameters
    ----------
    sentences : what is said.
    driver : looks the mouth up.
    head : looks head, shoulders and brows up, which are at rest where it is None.
    rate : pictures a second.
    first : the number of the first sentence in its text.

    Attributes
    ----------
    movestates : those of `FACE`, in the order of the weights.
    rests_from : when it has come to rest after the last phone, seconds.
    """

    movestates = FACE

    def __init__(
        self,
        sentences: tuple[Sentence, ...],
        driver: PerformanceDriver,
        head: HeadDriver | None,
        rate: float,
        first: int = 0,
    ) -> None:
        self._sentences, self._driver, self._head, self._picture = sentences, driver, head, 1 / rate
        self._first = first
        self.rests_from = _end_of(sentences[-1])
        self._rate = rate * math.ceil(RATE / rate)
        self._begins = [_turn_to(sentence)[0] for sentence in sentences[1:]]
        self._made: dict[int, tuple[int, Float32Array]] = {}
        self._lock = threading.Lock()

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, seconds, float32, shape (60,), 1 for the whole movement.

        Raises
        ------
        PerformanceError : the table is damaged.
        """
        return self._frame_at(time)[len(HEAD) :]

    def head(self, time: float) -> HeadPose | None:
        """Return how the head is turned at a time, seconds; None where it is not looked up.

        Raises
        ------
        PerformanceError : the table is damaged.
        """
        return None if self._head is None else HeadPose(*self._frame_at(time)[: len(HEAD)].tolist())

    def prepare(self, begin: float, end: float) -> None:
        """Look up what is said between two times, seconds, so that there is no wait then.

        Raises
        ------
        PerformanceError : the table is damaged.
        """
        for number in range(bisect_right(self._begins, begin), bisect_right(self._begins, end) + 1):
            self._frames_of(number)

    def take_over(self, other: "PerformedMouth") -> None:
        """Take what another mouth of the same text has looked up, as far as it is the same."""
        shift = other._first - self._first
        with other._lock:
            made = [*other._made.items()]
        for number, frames in made:
            mine = number + shift
            if 0 <= mine < len(self._sentences) and other._about(number) == self._about(mine):
                self._made[mine] = frames

    def _about(self, number: int) -> tuple[Sentence, ...]:
        """Return a sentence with its neighbours, which its head meets."""
        return self._sentences[max(number - 1, 0) : number + 2]

    def _frame_at(self, time: float) -> Float32Array:
        """Return turns and weights at a time; where two sentences meet, both have a share."""
        number = bisect_right(self._begins, time)
        weights = self._weights_in(number, time)
        begin, end = _turn_to(self._sentences[number])
        if not number or time >= end:
            return weights
        share = crossed(np.array([time]), begin, end)
        earlier = self._weights_in(number - 1, time)
        mixed: Float32Array = earlier + share * (weights - earlier)
        return mixed

    def _weights_in(self, number: int, time: float) -> Float32Array:
        first, frames = self._frames_of(number)
        weights: Float32Array = weights_at(frames, np.array([time * self._rate - first]))[0]
        return weights

    def _frames_of(self, number: int) -> tuple[int, Float32Array]:
        """Return the number of the first frame of a sentence, and turns and weights of all its frames."""
        made = self._made.get(number)
        if made is None:
            with self._lock:
                made = self._made.get(number) or self._look_up(number)
        return made

    def _look_up(self, number: int) -> tuple[int, Float32Array]:
        sentence = self._sentences[number]
        end = _end_of(sentence)
        first, last = math.floor(sentence[0].start * self._rate), math.ceil(end * self._rate)
        frames = self._frames_at(number, np.arange(first, last + 1) / self._rate)
        self._made[number] = first, frames
        while len(self._made) > FEWEST_KEPT and self._n_made > KEPT * self._rate:
            del self._made[next(iter(self._made))]
        return first, frames

    @property
    def _n_made(self) -> int:
        return sum(len(frames) for _, frames in self._made.values())

    def _frames_at(self, number: int, times: Float64Array) -> Float32Array:
        frames = np.zeros((len(times), len(HEAD) + len(FACE)), np.float32)
        sentence = self._sentences[number]
        frames[:, len(HEAD) :] = self._driver.weights(sentence, self._first + number, times, self._picture)
        if self._head is not None:
            frames[:, _HEAD_COLUMNS] = self._head.track(joined(self._about(number)), times)
        return frames


def _end_of(sentence: Sentence) -> float:
    """Return when a face has come to rest after a sentence, seconds."""
    return max(sentence[-1].end, sentence[-1].start + TO_REST)


owns = begins_like(",".join(UNIT_COLUMNS).encode() + b"\n")
"""Whether the content of a file is a list of units that was written here."""


def format_units(units: Iterable[UsedUnit]) -> str:
    """Write units as CSV: `UNIT_COLUMNS`, times in seconds to the millisecond."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(UNIT_COLUMNS)
    for unit in units:
        start, end, source_start, source_end = (
            f"{time:.3f}" for time in (unit.start, unit.end, unit.source_start, unit.source_end)
        )
        table.writerow((start, end, unit.kind, " ".join(unit.names), unit.recording, source_start, source_end))
    return text.getvalue()


def _turn_to(sentence: Sentence) -> tuple[float, float]:
    """Return from when to when, seconds, the sentence before goes over into one: around the middle of the pause."""
    pause = sentence[0]
    return (pause.start + pause.middle) / 2, (pause.middle + pause.end) / 2


REMEMBERED = 120.0
"""Seconds of what is spoken that can be shown: it may be made half a minute before it plays."""
PREPARED = 60.0
"""Seconds before the end of what is spoken that are looked up already."""


class Spoken(Protocol):
    """A sentence as a voice speaks it; see `SpokenSentence`."""

    @property
    def samples(self) -> Float32Array:
        """Mono at 44.1 kHz."""

    @property
    def words(self) -> tuple[Word, ...]:
        """What is said, in seconds from the sentence's beginning."""


SpokenT = TypeVar("SpokenT", bound=Spoken)


class SpokenFace:
    """What a table's performer says while a voice speaks it: a `MouthTrack` that grows, in constant memory.

    It is what `PerformanceTrack` shows of the whole text. One thread may show it while another one speaks.

    Parameters
    ----------
    table : recorded performances; it stays open as long as this is used.
    language : of the text.
    options : how they are looked up.
    remembered : seconds of what is spoken, at least, that can be shown.

    Attributes
    ----------
    movestates : those of `FACE`, in the order of the weights.

    Raises
    ------
    PerformanceError : the table has no blend shapes of a mouth.
    """

    movestates = FACE

    def __init__(
        self,
        table: PerformanceTable,
        language: str,
        options: PerformanceOptions | None = None,
        remembered: float = REMEMBERED,
    ) -> None:
        options = options or PerformanceOptions()
        self._table, self._language, self._remembered = table, language, remembered
        self._driver = PerformanceDriver(table, options)
        self._keywords = load_keywords() if options.keywords is None else options.keywords
        self._analyser, self._prosody = Analyser(load_preset(DEFAULT_PRESET), pitch=True), Prosody()
        self._words: list[Word] = []
        self._n = self._first = 0
        self._begin = 0.0
        self._known: tuple[tuple[Sentence, tuple[UsedUnit, ...]], ...] = ()
        self._mouth: PerformedMouth | None = None

    def follow(self, sentences: Iterable[SpokenT]) -> Iterator[SpokenT]:
        """Hand on sentences, each once it is looked up.

        Raises
        ------
        PerformanceError : the table is damaged.
        """
        for sentence in sentences:
            self._add(sentence)
            yield sentence

    @property
    def units(self) -> tuple[UsedUnit, ...]:
        """The units of what is spoken and not forgotten, in order of time."""
        return tuple(unit for _, units in self._known for unit in units)

    @property
    def notes(self) -> tuple[str, ...]:
        """What the table lacks for it, a sentence each."""
        known = self._known
        return self._driver.notes(joined([sentence for sentence, _ in known])) if known else ()

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, seconds, float32, shape (60,), as far as it is spoken.

        Raises
        ------
        PerformanceError : the table is damaged.
        """
        mouth = self._mouth
        return np.zeros(len(FACE), np.float32) if mouth is None else mouth.weights(time)

    def head(self, time: float) -> HeadPose | None:
        """Return how the head is turned at a time, seconds; None where it is not looked up.

        Raises
        ------
        PerformanceError : the table is damaged.
        """
        mouth = self._mouth
        return None if mouth is None else mouth.head(time)

    def _add(self, sentence: Spoken) -> None:
        self._prosody.add(self._analyser.push(sentence.samples))
        self._words += (shifted(word, self._n / SAMPLE_RATE) for word in sentence.words)
        self._n += len(sentence.samples)
        self._forget()
        sentences = self._sentences()
        mouth = PerformedMouth(sentences, self._driver, self._head(), RATE, self._first)
        if self._mouth is not None:
            mouth.take_over(self._mouth)
        end = self._n / SAMPLE_RATE
        mouth.prepare(end - PREPARED, end)
        before = dict(self._known)
        self._known = tuple(
            (said, before.get(said) or self._driver.units(said, number))
            for number, said in enumerate(sentences, self._first)
        )
        self._mouth = mouth

    def _forget(self) -> None:
        """Forget the sentences that ended long ago, seldom, as all others have other numbers then."""
        end = self._n / SAMPLE_RATE
        if end - self._begin < 2 * self._remembered:
            return
        old = [said for said, _ in self._known if said[-1].end < end - self._remembered]
        if old:
            self._begin, self._first = old[-1][-1].start, self._first + len(old)
            self._words = [word for word in self._words if word.start >= self._begin]
            self._prosody.forget(int(self._begin / FRAME_PERIOD))

    def _sentences(self) -> tuple[Sentence, ...]:
        utterance = Utterance(tuple(self._words), self._n / SAMPLE_RATE, self._language)
        first, *others = performed_phones(utterance, self._prosody)
        begin = min(self._begin, first.end)
        return sentences_in((replace(first, start=begin, middle=(begin + first.end) / 2), *others))

    def _head(self) -> HeadDriver | None:
        options = self._driver.options
        if PerformancePart.HEAD in options.without:
            return None
        words = [word.text for word in self._words]
        return HeadDriver(self._table, words, self._language, self._keywords, options.seed, options.style.gesturing())
