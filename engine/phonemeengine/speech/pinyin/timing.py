"""When each syllable is said, by a rate, or by the times of a voice or of labels; and the mouth that follows that."""

import csv
import io
import math
import random
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import TextError, check_range
from phonemeengine.labels.phone_sets import articulations_of, ipa_phoneme, letters_of
from phonemeengine.labels.pinyin import is_sound, timed_syllable
from phonemeengine.labels.utterance import ROUNDING, Phone, Syllable, Utterance, Word
from phonemeengine.mouth.morpher import EasedMovement, shares_of
from phonemeengine.speech.pinyin.script import Written, WrittenMark, WrittenSyllable, WrittenWord, mark_after
from phonemeengine.speech.pinyin.spring import SpringMass
from phonemeengine.speech.pinyin.table import FULL_FORMS, LEAST_SHARE, MOST_SHARE, REST, PinyinTable
from phonemeengine.text.cleaning import tokens_of
from phonemeengine.text.pronunciation import MARKS

# Plans: what a mouth says from when to when, as a table that people read and programs take in.

PLAN_COLUMNS = ("start_s", "turn_s", "end_s", "kind", "text", "sound", "letters")


class PlanKind(StrEnum):
    """What a row of a plan is."""

    SYLLABLE = "syllable"
    PAUSE = "pause"
    PHONE = "phone"


@dataclass(frozen=True)
class PlanRow:
    """An interval of a plan.

    Attributes
    ----------
    start, end : seconds.
    turn : when the onset of a syllable ends; where there is none, the row's start.
    kind : what it is.
    text : as it is written: the character of a syllable, the mark of a pause.
    sound : a syllable's pinyin with its tone as a digit, such as ``lü4``; a phone's symbol; empty for a pause.
    letters : the two of a syllable, & of a pause; of a phone the name of its shape.
    shapes : the names of the mouth shapes: two of a syllable, else one.
    """

    start: float
    turn: float
    end: float
    kind: PlanKind
    text: str
    sound: str
    letters: str
    shapes: tuple[str, ...]


@dataclass(frozen=True)
class Plan:
    """What a mouth says.

    Attributes
    ----------
    rows : in order of time, without gaps from 0 on; at least one.
    longest_closing : the mouth comes to rest in a pause as if that lasted no longer, seconds.
    """

    rows: tuple[PlanRow, ...]
    longest_closing: float

    @property
    def duration(self) -> float:
        """When the last row ends, seconds."""
        return self.rows[-1].end


def format_plan(plan: Plan) -> str:
    """Write a plan as CSV: `PLAN_COLUMNS`, times in seconds to the millisecond."""
    return "".join(plan_lines(plan.rows))


def plan_lines(rows: Iterable[PlanRow], *, header: bool = True) -> Iterator[str]:
    """Return the lines of a plan as CSV, one by one, with the names of its columns before them; see `format_plan`."""
    if header:
        yield _line(PLAN_COLUMNS)
    for row in rows:
        times = (f"{time:.3f}" for time in (row.start, row.turn, row.end))
        yield _line((*times, row.kind, row.text, row.sound, row.letters))


def _line(values: Iterable[str]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(values)
    return text.getvalue()


USUAL_RATE = 4.0
SLOWEST, FASTEST = 0.5, 10.0
"""Syllables per second."""
LENGTHS = {"vowel": 0.37, "plosive": 0.32, "nasal": 0.3, "lateral": 0.3, "rhotic": 0.3, "fricative": 0.39}
"""How long sounds last, in syllables: means over the labels of the tests' corpus, at 4.0 syllables a second."""
OTHER_LENGTH = 0.27


def pause_unit(table: PinyinTable, rate: float) -> float:
    """Return how long a pause of weight 1 is at a rate of syllables per second, seconds.

    Raises
    ------
    TextError : the rate lies outside 0.5..10.
    """
    check_range("the rate", rate, (SLOWEST, FASTEST, "syllables per second"), TextError)
    return table.pause / rate


@dataclass(frozen=True)
class SaidPart:
    """A word or a pause of a text without a voice, with its times.

    Attributes
    ----------
    rows : of its plan.
    word : None for a pause.
    """

    rows: tuple[PlanRow, ...]
    word: Word | None = None


def said_at_rate(
    script: Iterable[Written], table: PinyinTable, rate: float = USUAL_RATE, seed: int | None = None
) -> Iterator[SaidPart]:
    """Return the parts of a text with times, one by one: each Chinese syllable lasts 1 / rate.

    Words of other languages last as long as their phones, by `LENGTHS`.

    Parameters
    ----------
    script : its syllables, words and pauses.
    table : the letters, weights and marks.
    rate : syllables per second.
    seed : of the variation of onsets; none varies where it is None.
    """
    row_of, at = _SyllableRows(table, seed), 0.0  # counted in syllables, so that the sum of all is exact
    for item in script:
        start = at / rate
        if isinstance(item, WrittenSyllable):
            at += 1.0
            row = row_of.syllable(start, at / rate, item.text, item.sound)
            yield SaidPart((row,), Word(row.text, (timed_syllable(row.sound, row.start, row.turn, row.end),)))
        elif isinstance(item, WrittenWord):
            word, at = _timed_word(item, at, rate)
            yield SaidPart(tuple(row_of.phone(phone.start, word.text, phone) for phone in word.phones), word)
        else:
            at += table.pause * item.weight
            yield SaidPart((_pause_row(start, at / rate, item.text),))


def length_of(phone: str) -> float:
    """Return how long a phone of IPA lasts where its language is not Chinese, in syllables of the rate."""
    classes = {name for letter in letters_of(phone)[:1] for name in articulations_of(letter)}
    return next((length for name, length in LENGTHS.items() if name in classes), OTHER_LENGTH)


def _timed_word(written: WrittenWord, at: float, rate: float) -> tuple[Word, float]:
    """Return a word that begins after this many syllables, and after how many it ends."""
    syllables = []
    for syllable in written.syllables:
        phones = []
        for ipa in syllable.phones:
            start, at = at / rate, at + length_of(ipa)
            phones.append(Phone(start, at / rate, ipa, ipa_phoneme(ipa)))
        syllables.append(Syllable(tuple(phones), syllable.stress, syllable.text))
    return Word(written.text, tuple(syllables)), at


def plan_of(
    utterance: Utterance, table: PinyinTable, script: Sequence[Written] = (), seed: int | None = None
) -> Plan:
    """Plan what is said in a sound, by the sound's own times.

    Parameters
    ----------
    utterance : its syllables hold pinyin with the tone as a digit; those that do not move the mouth by their phones.
    table : the letters and weights.
    script : the text that was spoken, for the marks of its pauses; they stay without, where it has other syllables.
    seed : of the variation of onsets; none varies where it is None.
    """
    n_syllables = sum(is_sound(syllable.text) for word in utterance.words for syllable in word.syllables)
    marks, row_of = _marks_of(script, n_syllables), _SyllableRows(table, seed)
    said = _rows_of(utterance.words, 0.0, utterance.duration, row_of, lambda syllables, _: marks.get(syllables, ""))
    rows = list(said)
    return Plan(tuple(rows), pause_unit(table, USUAL_RATE))


def has_pinyin(utterance: Utterance) -> bool:
    """Return whether a syllable of what is said is pinyin, so that letters can move a mouth."""
    return any(map(says_pinyin, utterance.words))


def says_pinyin(word: Word) -> bool:
    """Return whether a syllable of a word is pinyin."""
    return any(is_sound(syllable.text) for syllable in word.syllables)


class _SyllableRows:
    """Makes rows of syllables; with a seed their onsets vary."""

    def __init__(self, table: PinyinTable, seed: int | None) -> None:
        self.table = table
        self._random = None if seed is None else random.Random(seed)  # noqa: S311 - nothing secret depends on it

    def syllable(self, start: float, end: float, text: str, sound: str) -> PlanRow:
        letters, shapes = self.table.letters_of(sound[:-1]), self.table.shapes_of(sound[:-1])
        turn = start + self._share(letters[0]) * (end - start)
        return PlanRow(start, turn, end, PlanKind.SYLLABLE, text, sound, letters, shapes)

    def phone(self, start: float, text: str, phone: Phone) -> PlanRow:
        shape = self.table.mouth.phonemes[phone.phoneme]
        return PlanRow(start, start, phone.end, PlanKind.PHONE, text, phone.ipa, shape, (shape,))

    def _share(self, letter: str) -> float:
        share = self.table.onset_shares[letter]
        if self._random is None:
            return share
        spread = self.table.variation
        return min(max(share * (1 + self._random.uniform(-spread, spread)), LEAST_SHARE), MOST_SHARE)


class SentencePlanner:
    """Plans sentences as they are spoken, one after the other.

    Parameters
    ----------
    table : the letters, weights and marks.
    seed : of the variation of onsets; none varies where it is None.
    """

    def __init__(self, table: PinyinTable, seed: int | None = None) -> None:
        self._table, self._row_of, self._at = table, _SyllableRows(table, seed), 0.0

    def rows_of(self, text: str, words: Sequence[Word], end: float) -> Iterator[PlanRow]:
        """Return the rows of the next sentence.

        Parameters
        ----------
        text : as it is written, for the marks of its pauses.
        words : with their times in the whole sound.
        end : when it ends, seconds.
        """
        marks = self._marks_in(text, words)
        start, self._at = self._at, end
        return _rows_of(words, start, end, self._row_of, lambda _, n_words: marks.get(n_words, ""))

    def _marks_in(self, text: str, words: Sequence[Word]) -> dict[int, str]:
        """Return the mark after this many words of a sentence."""
        full = FULL_FORMS if any(map(says_pinyin, words)) else {}
        marks: dict[int, str] = {}
        n_words = 0
        for token in tokens_of(text):
            n_words += n_words < len(words) and token.strip(MARKS) == words[n_words].text
            if mark := mark_after(token, self._table):
                marks[n_words] = full.get(mark.text, mark.text)
        if mark := mark_after(text, self._table):
            marks[len(words)] = full.get(mark.text, mark.text)
        return marks


def _rows_of(
    words: Iterable[Word], at: float, end: float, row_of: _SyllableRows, mark_of: Callable[[int, int], str]
) -> Iterator[PlanRow]:
    """Return a row for each syllable of pinyin, each phone of what else is said, and each pause.

    `mark_of` gives the mark after a number of syllables of pinyin and of words.
    """
    n_syllables = n_words = 0
    for word in words:
        for text, syllable in _syllables_of(word):
            if syllable.start > at + ROUNDING:
                yield _pause_row(at, syllable.start, mark_of(n_syllables, n_words))
                at = syllable.start
            if is_sound(syllable.text):
                n_syllables += 1
                yield row_of.syllable(at, syllable.end, text, syllable.text)
            else:
                for phone in syllable.phones:
                    yield row_of.phone(at, text, phone)
                    at = phone.end
            at = syllable.end
        n_words += 1
    if end > at + ROUNDING:
        yield _pause_row(at, end, mark_of(n_syllables, n_words))


def _syllables_of(word: Word) -> Iterator[tuple[str, Syllable]]:
    """Return each syllable and how it is written: by a character of its word, where it has as many."""
    texts = word.text if len(word.text) == len(word.syllables) else [word.text] * len(word.syllables)
    return zip(texts, word.syllables, strict=True)


def _marks_of(script: Sequence[Written], n_syllables: int) -> dict[int, str]:
    """Return the mark after this many syllables."""
    marks: dict[int, str] = {}
    n_written = 0
    for item in script:
        if isinstance(item, WrittenMark):
            marks[n_written] = item.text
        elif isinstance(item, WrittenSyllable):
            n_written += 1
    return marks if n_written == n_syllables else {}


def _pause_row(start: float, end: float, mark: str) -> PlanRow:
    return PlanRow(start, start, end, PlanKind.PAUSE, mark, "", REST, (REST,))


AFTERWARDS = 0.3
"""Seconds in which the mouth comes to rest after the last row."""


class PinyinMouth:
    """A mouth that says a plan: the weights of its movestates at any time.

    In each part of a syllable it moves along half a cosine from where it was to the part's shape, for the first share
    of the part that the table calls reach, and holds the shape for the rest. With a spring, a mass is drawn to the
    part's shape instead, from the part's start on.

    Parameters
    ----------
    plan : what is said.
    table : its shapes, and how the mouth goes there.

    Attributes
    ----------
    movestates : their names, in the order of the weights.
    rests_from : when it has come to rest after the last row, seconds.
    """

    def __init__(self, plan: Plan, table: PinyinTable) -> None:
        self.movestates = table.mouth.movestates
        shapes = table.weights()
        rows = {name: row for row, name in enumerate(shapes)}
        self._rows = np.array(list(shapes.values()))
        self._movements = [EasedMovement(-math.inf, 0.0, rows[REST]), *_movements_of(plan, table.reach, rows)]
        self._starts = [movement.start for movement in self._movements]
        self.rests_from = plan.duration + (AFTERWARDS if table.spring else self._movements[-1].duration)
        self._spring = None if table.spring is None else SpringMass(self._target, table.spring)

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, seconds, float32, shape (n_movestates,), 1 for the whole movement."""
        return self._eased(time) if self._spring is None else self._spring.at(time)

    def head(self, time: float) -> None:
        """Let the head follow the sound."""

    def _eased(self, time: float) -> Float32Array:
        begun = bisect_right(self._starts, time)
        mixed = shares_of(self._movements[max(begun - 2, 0) : begun], time)
        shares = np.array([share for _, share in mixed], np.float32)
        weights: Float32Array = shares @ self._rows[[movement.row for movement, _ in mixed]]
        return weights

    def _target(self, time: float) -> Float32Array:
        shape: Float32Array = self._rows[self._movements[bisect_right(self._starts, time) - 1].row]
        return shape


def _movements_of(plan: Plan, reach: float, rows: dict[str, int]) -> Iterator[EasedMovement]:
    """Return the movement of each part; it has ended before the next one begins."""
    for row in plan.rows:
        bounds = (row.start, row.turn, row.end) if len(row.shapes) == 2 else (row.start, row.end)
        for shape, (start, end) in zip(row.shapes, pairwise(bounds), strict=True):
            length = end - start if row.kind is not PlanKind.PAUSE else min(end - start, plan.longest_closing)
            yield EasedMovement(start, reach * length, rows[shape])
    yield EasedMovement(plan.duration, reach * AFTERWARDS, rows[REST])
