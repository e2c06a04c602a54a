"""When each syllable is said: by a rate, or by the times of a voice or of labels."""

import random
from collections.abc import Iterator, Sequence

from phonemeengine.errors import TextError
from phonemeengine.labels.label import ROUNDING
from phonemeengine.labels.pinyin import is_sound
from phonemeengine.labels.utterance import Phone, Syllable, Utterance
from phonemeengine.speech.pinyin.plan import Plan, PlanKind, PlanRow
from phonemeengine.speech.pinyin.script import Written, WrittenMark, WrittenSyllable
from phonemeengine.speech.pinyin.table import LEAST_SHARE, MOST_SHARE, REST, PinyinTable

USUAL_RATE = 4.0
SLOWEST, FASTEST = 0.5, 10.0
"""Syllables per second."""


def pause_unit(table: PinyinTable, rate: float) -> float:
    """Return how long a pause of weight 1 is at a rate of syllables per second, seconds.

    Raises
    ------
    TextError : the rate lies outside 0.5..10.
    """
    if not SLOWEST <= rate <= FASTEST:
        raise TextError(
            f"the rate must lie in {SLOWEST:g}..{FASTEST:g} syllables per second, got {rate:g}; choose another"
        )
    return table.pause / rate


def plan_at_rate(
    script: Sequence[Written], table: PinyinTable, rate: float = USUAL_RATE, seed: int | None = None
) -> Plan:
    """Plan a text that nobody speaks: each syllable lasts 1 / rate.

    Parameters
    ----------
    script : its syllables and pauses.
    table : the letters, weights and marks.
    rate : syllables per second, 0.5..10.
    seed : of the variation of onsets; none varies where it is None.

    Raises
    ------
    TextError : there is no syllable, or the rate lies outside its range.
    """
    if not any(isinstance(item, WrittenSyllable) for item in script):
        raise TextError("there is no Chinese syllable in the text; write some, or choose another driver")
    closing, row_of = pause_unit(table, rate), _SyllableRows(table, seed)
    rows, at = [], 0.0  # counted in syllables, so that the sum of all is exact
    for item in script:
        start, at = at / rate, at + (1.0 if isinstance(item, WrittenSyllable) else table.pause * item.weight)
        if isinstance(item, WrittenSyllable):
            rows.append(row_of.syllable(start, at / rate, item.text, item.sound))
        else:
            rows.append(_pause_row(start, at / rate, item.text))
    return Plan(tuple(rows), closing)


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

    Raises
    ------
    TextError : there is no syllable of pinyin in it.
    """
    n_syllables = sum(is_sound(syllable.text) for word in utterance.words for syllable in word.syllables)
    if not n_syllables:
        raise TextError("there is no syllable of pinyin in what is said; choose another driver")
    marks = _marks_of(script, n_syllables)
    rows = list(_rows_of(utterance, _SyllableRows(table, seed), marks))
    return Plan(tuple(rows), pause_unit(table, USUAL_RATE))


def has_pinyin(utterance: Utterance) -> bool:
    """Return whether a syllable of what is said is pinyin, so that letters can move a mouth."""
    return any(is_sound(syllable.text) for word in utterance.words for syllable in word.syllables)


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


def _rows_of(utterance: Utterance, row_of: _SyllableRows, marks: dict[int, str]) -> Iterator[PlanRow]:
    """Return a row for each syllable of pinyin, each phone of what else is said, and each pause."""
    at, n_syllables = 0.0, 0
    for text, syllable in _syllables_of(utterance):
        if syllable.start > at + ROUNDING:
            yield _pause_row(at, syllable.start, marks.get(n_syllables, ""))
            at = syllable.start
        if is_sound(syllable.text):
            n_syllables += 1
            yield row_of.syllable(at, syllable.end, text, syllable.text)
        else:
            for phone in syllable.phones:
                yield row_of.phone(at, text, phone)
                at = phone.end
        at = syllable.end
    if utterance.duration > at + ROUNDING:
        yield _pause_row(at, utterance.duration, marks.get(n_syllables, ""))


def _syllables_of(utterance: Utterance) -> Iterator[tuple[str, Syllable]]:
    """Return each syllable and how it is written: by a character of its word, where it has as many."""
    for word in utterance.words:
        texts = word.text if len(word.text) == len(word.syllables) else [word.text] * len(word.syllables)
        yield from zip(texts, word.syllables, strict=True)


def _marks_of(script: Sequence[Written], n_syllables: int) -> dict[int, str]:
    """Return the mark after so many syllables."""
    marks: dict[int, str] = {}
    n_written = 0
    for item in script:
        if isinstance(item, WrittenMark):
            marks[n_written] = item.text
        else:
            n_written += 1
    return marks if n_written == n_syllables else {}


def _pause_row(start: float, end: float, mark: str) -> PlanRow:
    return PlanRow(start, start, end, PlanKind.PAUSE, mark, "", REST, (REST,))
