"""Sentences and strings of words that were recorded as they are asked for: kept whole, the longest first.

They have no index of their own: each word is found in the table by itself, and words that follow each other in a
recording are a string. So they add nothing to a table, may be of any length, and are found in old tables, too.
"""

from collections.abc import Iterator, Mapping, Sequence
from heapq import heapify, heappop, heappush
from itertools import groupby

from phonemeengine.performance.choice import PlacedUnit
from phonemeengine.performance.recording import SILENCE, PerformedPhone
from phonemeengine.performance.table_file import Example, PerformanceTable
from phonemeengine.performance.units import Unit, UnitKind

MOST_EXAMPLES = 50
"""Of a string; of more, these are spread evenly over the durations of its first word."""
_LONGEST = 1e9

_Span = tuple[int, int]
"""The first and the last phone of a word."""
_Runs = Mapping[tuple[int, int], int]
"""How many words follow each other as they are asked for, by recording and phone."""


def recorded_strings(phones: Sequence[PerformedPhone], table: PerformanceTable) -> Iterator[PlacedUnit]:
    """Return the sentence, or else its strings of two words and more, that a table holds; they do not overlap.

    A pause within a string must have been recorded, too.

    Parameters
    ----------
    phones : in order of time; the first and the last are silence.

    Raises
    ------
    PerformanceError : the table is damaged.
    """
    words = _words_in(phones)
    runs = _runs_of(phones, words, table)
    whole = _whole(phones, words, runs[0], table) if words else None
    if whole is not None:
        yield whole
        return
    coming = [(-max(lengths.values()), k) for k, lengths in enumerate(runs) if lengths]
    free = [True] * len(words)
    heapify(coming)
    while coming:
        length, k = heappop(coming)
        fitting = next((n for n in range(-length) if not free[k + n]), -length)
        if fitting == -length >= 2:
            free[k : k + fitting] = [False] * fitting
            places = [place for place, n in runs[k].items() if n >= fitting]
            yield _string(UnitKind.WORDS, phones, (words[k][0], words[k + fitting - 1][1]), places, table)
        elif fitting >= 2:
            heappush(coming, (-fitting, k))


def _words_in(phones: Sequence[PerformedPhone]) -> list[_Span]:
    runs = ([*run] for _, run in groupby(range(len(phones)), key=lambda k: phones[k].word))
    return [(run[0], run[-1]) for run in runs if phones[run[0]].word != -1]


def _runs_of(phones: Sequence[PerformedPhone], words: Sequence[_Span], table: PerformanceTable) -> list[_Runs]:
    """Return, for each word, where it was recorded with others behind it that follow it here, too.

    Of the first one, those that stand alone are there as well.
    """
    found: list[_Runs] = []
    behind: _Runs = {}
    following: int | None = None
    for first, last in reversed(words):
        own = {}
        for place in _places_of(phones[first : last + 1], table):
            recording, k = place
            n = 0 if following is None else behind.get((recording, k + following - first), 0)
            if n and following is not None and following - last > 1:  # a pause lies between
                between = table.phones_in(recording, k + last - first + 1, k + following - first - 1)
                n = n if {phone.name for phone in between} == {SILENCE} else 0
            own[place] = 1 + n
        found.append({place: n for place, n in own.items() if n > 1 or first == words[0][0]})
        behind, following = own, first
    return found[::-1]


def _places_of(word: Sequence[PerformedPhone], table: PerformanceTable) -> Iterator[tuple[int, int]]:
    """Return where a word was recorded: the recordings, and the numbers of its first phone."""
    names = tuple(phone.name for phone in word)
    kind = UnitKind.WORD if len({phone.syllable for phone in word}) > 1 else UnitKind.SYLLABLE
    return ((found.recording, found.first // 2) for found in table.within(kind, names, 0.0, _LONGEST))


def _whole(
    phones: Sequence[PerformedPhone], words: Sequence[_Span], runs: _Runs, table: PerformanceTable
) -> PlacedUnit | None:
    """Return a sentence that was recorded between two pauses as it is here."""
    first, last = words[0][0] - 1, words[-1][1] + 1
    places = [
        (recording, k - 1)
        for (recording, k), n in runs.items()
        if n == len(words)
        and all(
            {phone.name for phone in table.phones_in(recording, at, at)} == {SILENCE}
            for at in (k - 1, k + last - first - 1)
        )
    ]
    return _string(UnitKind.SENTENCE, phones, (first, last), places, table) if places else None


def _string(
    kind: UnitKind,
    phones: Sequence[PerformedPhone],
    span: _Span,
    places: Sequence[tuple[int, int]],
    table: PerformanceTable,
) -> PlacedUnit:
    """Return a string from the right half of its first phone to the left half of its last one."""
    first, last = span
    unit = Unit(kind, tuple(phone.name for phone in phones[first : last + 1]), 2 * first + 1, 2 * last + 1)
    step = max(1, -(-len(places) // MOST_EXAMPLES))
    examples = []
    for recording, k in places[::step]:
        begin, *_, end = table.phones_in(recording, k, k + last - first)
        examples.append(Example(recording, 2 * k + 1, 2 * (k + last - first) + 1, end.middle - begin.middle))
    return PlacedUnit(unit, kind, unit.names, tuple(examples))
