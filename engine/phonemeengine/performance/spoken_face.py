"""A face for a text that is still being spoken: each sentence is looked up before its sound is handed on."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Protocol, TypeVar

import numpy as np

from phonemeengine.analyser import Analyser
from phonemeengine.arrays import Float32Array
from phonemeengine.labels.utterance import Utterance, Word, shifted
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.transcript import Prosody
from phonemeengine.performance.driver import FACE, PerformanceDriver, PerformanceOptions, PerformancePart, UsedUnit
from phonemeengine.performance.head_driver import HeadDriver
from phonemeengine.performance.keywords import load_keywords
from phonemeengine.performance.table_file import PerformanceTable
from phonemeengine.performance.track import RATE, PerformedMouth
from phonemeengine.performance.units import Sentence, joined, performed_phones, sentences_in
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE

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
