"""Which recorded strings of words are taken whole, and which example of a unit: any, the nearest, or the best.

They have no index of their own: each word is found in the table by itself, and words that follow each other in a
recording are a string. So they add nothing to a table, may be of any length, and are found in old tables, too.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from heapq import heapify, heappop, heappush
from itertools import groupby, pairwise

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import PerformanceError
from phonemeengine.labels.phone_sets import OPENNESS, articulations_of, letters_of
from phonemeengine.performance.halves import TRAITS, RecordedHalves, Recordings, bounds_of, traits_of
from phonemeengine.performance.recording import SILENCE, PerformedPhone
from phonemeengine.performance.table_file import Example, PerformanceTable, TableAbout
from phonemeengine.performance.units import Sentence, Unit, UnitKind, duration_of, units_of
from phonemeengine.storage.files import printable
from phonemeengine.text.mandarin import TAGS

# The search for the units of a sentence in a table: long ones first, and what was not recorded by what is like it.

Inventory = Mapping[UnitKind, frozenset[tuple[str, ...]]]
"""What a table has: of each set, the phones of all its units."""

LIPS = ("labiovelar", "labiodental", "bilabial", "front rounded vowel", "rounded vowel")
"""Classes of sounds that lips make: such a sound is mistaken for no other one."""
_TEETH = "dental"
"""The class of sounds that show the tongue: these, too, are taken for each other alone."""
PLACES = (
    *LIPS,
    "dental",
    "postalveolar",
    "alveolo-palatal",
    "retroflex",
    "alveolar",
    "palatal",
    "velar",
    "uvular",
    "pharyngeal",
    "glottal",
    "open vowel",
    "mid vowel",
    "close vowel",
    "apical vowel",
    "front vowel",
    "back vowel",
    "central vowel",
)
"""Classes by which sounds look alike, the most visible first; the others are audible more than visible."""
_AT_PAUSES = {
    UnitKind.VOWEL_TRIPHONE: UnitKind.BOUNDARY_TRIPHONE,
    UnitKind.CONSONANT_TRIPHONE: UnitKind.BOUNDARY_TRIPHONE,
    UnitKind.DIPHONE: UnitKind.BOUNDARY_DIPHONE,
}
_HALVES = (UnitKind.RIGHT_HALF, UnitKind.LEFT_HALF)


@dataclass(frozen=True)
class PlacedUnit:
    """A unit of a sentence, and what is looked up in its place.

    Attributes
    ----------
    unit : where it is.
    kind, names : the set and the phones of the examples; those of the unit, unless the table lacks them.
    examples : of a unit that no index finds.
    """

    unit: Unit
    kind: UnitKind
    names: tuple[str, ...]
    examples: tuple[Example, ...] = ()


@dataclass(frozen=True, eq=False)
class ChosenUnits:
    """What a sentence is made of.

    Attributes
    ----------
    bounds : of its halves, seconds; see `bounds_of`.
    placed : its units, in order of time.
    examples : one for each.
    """

    bounds: Float64Array
    placed: tuple[PlacedUnit, ...]
    examples: tuple[Example, ...]

    def bounds_in(self, sentence: Sentence) -> Float64Array:
        """Return the bounds in a text, where the sentence stands, seconds; its silences are as long as there."""
        bounds = bounds_of(sentence)
        bounds[2:-2] = self.bounds[2:-2] + (bounds[2] - self.bounds[2])
        return bounds


Given = Callable[[Sentence], ChosenUnits | None]
"""Tells the units of a sentence that are chosen already; None where it does not know the sentence."""


def placed_units(
    phones: Sequence[PerformedPhone], inventory: Inventory, strings: Iterable[PlacedUnit] = ()
) -> tuple[PlacedUnit, ...]:
    """Cover all halves of a sentence by units, each half by one; they come in order of time.

    A set is exhausted before the next one is looked at, and a unit is placed only where all its halves are free. A
    phone that the table lacks is replaced by the half of one that looks like it. At pauses within a sentence, what
    was recorded at the boundaries of sentences serves as well.

    Parameters
    ----------
    phones : in order of time; the first and the last are silence.
    inventory : of the table.
    strings : those of words, which go before all other units; they do not overlap.
    """
    free = [True] * (2 * len(phones))
    found = [*strings]
    for string in found:
        free[string.unit.first : string.unit.last] = [False] * (string.unit.last - string.unit.first)
    for unit in units_of(phones):
        if all(free[unit.first : unit.last]) and (placed := _placed(unit, inventory)):
            found.append(placed)
            free[unit.first : unit.last] = [False] * (unit.last - unit.first)
    return tuple(sorted(found, key=lambda placed: placed.unit.first))


def notes_on(phones: Sequence[PerformedPhone], inventory: Inventory, verb: str = "looks") -> Iterator[str]:
    """Say which phones the table lacks, and what each looks, or sounds, like in their place, a sentence each."""
    for name in sorted({phone.name for phone in phones}):
        if (name,) not in inventory[UnitKind.LEFT_HALF]:
            likest_ones = dict.fromkeys(likest(name, inventory, kind) for kind in reversed(_HALVES))
            others = " and ".join(f"[{other}]" for other in likest_ones)
            yield f"the recordings have no [{name}], so it {verb} like {others}"


def likest(name: str, inventory: Inventory, kind: UnitKind) -> str:
    """Return the phone of a table whose left or right half looks the most like that of another one.

    Of a diphthong or the like, the left half is that of its first sound, the right half that of its last one.
    """
    side = -1 if kind is UnitKind.RIGHT_HALF else 0
    classes, openness = _classes_of(name, side), _openness_of(name, side)

    def likeness(other: str) -> tuple[bool, bool, int, int, float, str]:
        theirs = _classes_of(other, side)
        common = classes & theirs
        place = next((k for k, place in enumerate(PLACES) if place in common), len(PLACES))
        same_lips = (classes & {*LIPS}) == (theirs & {*LIPS})
        same_teeth = (_TEETH in classes) == (_TEETH in theirs)
        farther = abs(_openness_of(other, side) - openness)
        return same_lips, same_teeth, -place, -farther, len(common) / max(len(classes | theirs), 1), other

    known = (names[0] for names in inventory[kind])
    return max((other for other in known if other != SILENCE), key=likeness, default=SILENCE)


def _placed(unit: Unit, inventory: Inventory) -> PlacedUnit | None:
    if unit.names in inventory[unit.kind]:
        return PlacedUnit(unit, unit.kind, unit.names)
    if unit.kind in _HALVES:
        return PlacedUnit(unit, unit.kind, (likest(unit.names[0], inventory, unit.kind),))
    kind = _AT_PAUSES.get(unit.kind, unit.kind)
    known = SILENCE in unit.names and unit.names in inventory[kind]
    return PlacedUnit(unit, kind, unit.names) if known else None


def _classes_of(name: str, side: int) -> frozenset[str]:
    letters = letters_of(name)
    return frozenset(articulations_of(letters[side])) if letters else frozenset()


def _openness_of(name: str, side: int) -> int:
    letters = letters_of(name)
    return OPENNESS.get(letters[side], 0) if letters else 0


N_CANDIDATES = 10
"""Examples of a unit that a way through the sentence may take: those of the nearest durations."""
BAND = 0.15
"""Share of a duration by which those of others may differ from it."""
TRAIT_WEIGHTS = {
    "duration": 0.4,
    "energy": 0.1,
    "pitch": 0.05,
    "stress": 0.15,
    "word": 0.05,
    "syllable": 0.05,
    "lips beside": 1.0,
    "rounding beside": 0.7,
    "opening beside": 0.7,
    "spreading beside": 0.4,
}
"""What a difference of each trait costs, beside differences of weights where two examples meet."""
_TRAIT_WEIGHTS = np.array([TRAIT_WEIGHTS[name] for name in TRAITS], np.float32)
_LONGEST = 1e9

Chosen = tuple[RecordedHalves, Example]
"""An example and its recording."""


class ExampleChoice(StrEnum):
    """How one of several examples is chosen."""

    VITERBI = "viterbi"
    NEAREST = "nearest"
    BAND = "band"
    RANDOM = "random"


def chosen_examples(
    placed: Sequence[PlacedUnit],
    sentence: Sentence,
    table: PerformanceTable,
    recordings: Recordings,
    choice: ExampleChoice,
    seed: Sequence[int],
) -> list[Chosen]:
    """Return an example for each unit of a sentence.

    Parameters
    ----------
    placed : the units.
    table, recordings : where the examples are.
    seed : whole numbers from 0, of what is left to chance; equal ones choose alike.

    Raises
    ------
    PerformanceError : the table is damaged.
    """
    candidates = [_candidates(unit, duration_of(unit.unit, sentence), table, choice) for unit in placed]
    if choice is not ExampleChoice.VITERBI:
        chance = np.random.default_rng([*seed])
        candidates = [(few[chance.integers(len(few))],) for few in candidates]
    chosen = [
        [_found(example, unit, table, recordings) for example in few]
        for unit, few in zip(placed, candidates, strict=True)
    ]
    return [few[0] for few in chosen] if choice is not ExampleChoice.VITERBI else _best_way(placed, chosen, sentence)


def _candidates(
    placed: PlacedUnit, duration: float, table: PerformanceTable, choice: ExampleChoice
) -> tuple[Example, ...]:
    """Return the examples among which is chosen, at least one."""
    found: tuple[Example, ...] = ()
    low, high = (0.0, _LONGEST) if choice is ExampleChoice.RANDOM else (duration * (1 - BAND), duration * (1 + BAND))
    if choice in {ExampleChoice.RANDOM, ExampleChoice.BAND}:
        found = tuple(few for few in placed.examples if low <= few.duration <= high)
        found = found or table.within(placed.kind, placed.names, low, high)
    n = N_CANDIDATES if choice is ExampleChoice.VITERBI else 1
    nearest = sorted(placed.examples, key=lambda example: abs(example.duration - duration))[:n]
    found = found or tuple(nearest) or table.nearest(placed.kind, placed.names, duration, n)
    if not found:
        raise _damage(table)
    return found


def _found(example: Example, placed: PlacedUnit, table: PerformanceTable, recordings: Recordings) -> Chosen:
    """Return an example with its recording, in which it must be."""
    halves, unit = recordings[example.recording], placed.unit
    if example.last - example.first != unit.last - unit.first or not 0 <= example.first < example.last <= len(halves):
        raise _damage(table)
    return halves, example


def _damage(table: PerformanceTable) -> PerformanceError:
    return PerformanceError(
        f"{table.about.name}: this table of performances is damaged (a unit is not in its recording); build it anew "
        "with `phonemeanalyser performance build`"
    )


def _best_way(placed: Sequence[PlacedUnit], chosen: Sequence[Sequence[Chosen]], sentence: Sentence) -> list[Chosen]:
    """Return the way of the least cost: of the examples beside what is asked for, and of each beside the next one.

    A. Hunt and A. Black, Unit selection in a concatenative speech synthesis system (1996); A. Viterbi (1967).
    """
    wanted = traits_of(sentence)
    costs = [
        _target_costs(few, wanted[unit.unit.first : unit.unit.last]) for unit, few in zip(placed, chosen, strict=True)
    ]
    total, ways = costs[0], []
    for (before, after), own in zip(pairwise(chosen), costs[1:], strict=True):
        joined = total[:, None] + _join_costs(before, after)
        ways.append(joined.argmin(axis=0))
        total = joined.min(axis=0) + own
    best = [int(total.argmin())]
    for way in reversed(ways):
        best.append(int(way[best[-1]]))
    return [few[k] for few, k in zip(chosen, reversed(best), strict=True)]


def _target_costs(chosen: Sequence[Chosen], wanted: Float32Array) -> Float32Array:
    """Return how far the traits of examples are from what is wanted, shape (n_examples,)."""
    traits = np.stack([halves.traits[example.first : example.last] for halves, example in chosen])
    costs: Float32Array = (np.abs(traits - wanted) @ _TRAIT_WEIGHTS).sum(axis=1)
    return costs


def _join_costs(before: Sequence[Chosen], after: Sequence[Chosen]) -> Float32Array:
    """Return how far faces are from each other where an example meets the next one, shape (n_before, n_after)."""
    ends = np.stack([halves.joints[example.last] for halves, example in before])
    starts = np.stack([halves.joints[example.first] for halves, example in after])
    costs: Float32Array = np.abs(ends[:, None] - starts).sum(axis=2)
    return costs


def chosen_table(tables: Sequence[TableAbout], use: str | None, person: str | None, language: str = "") -> int:
    """Return the place of the one table that is asked for.

    Where several have the name and the person, those of the language count, the nearest of its dialects first; where
    none is of the language, those of no language do.

    Parameters
    ----------
    tables : at least one.
    use : its name; None for any.
    person : who speaks; None for anybody.
    language : of what is said; empty where that is not known.

    Raises
    ------
    PerformanceError : there is none of the name or person, or several are left.
    """
    _check_named(tables, use, person)
    found = [k for k, about in enumerate(tables) if use in {None, about.name} and person in {None, about.person}]
    for near in (str.lower, _tongue):
        spoken = [k for k in found if language and near(tables[k].language) == near(language)]
        if spoken:
            found = spoken
            break
    else:
        found = [k for k in found if not tables[k].language] or found
    if len(found) > 1:
        names = _listed(tables[k].name for k in found)
        raise PerformanceError(
            f"one table moves a face, and there are {names}; name one of them with --use, or a person with --person "
            "and the language of the text with --language"
        )
    return found[0]


def _check_named(tables: Sequence[TableAbout], use: str | None, person: str | None) -> None:
    """Refuse a person or a name that none of the tables has."""
    persons = dict.fromkeys(about.person for about in tables if about.person)
    if person is not None and person not in persons:
        asked = printable(person[:40])
        if not persons:
            raise PerformanceError(
                f"there is no table of {asked!r}, as none says who speaks in it; leave --person out"
            )
        raise PerformanceError(
            f"there is no table of {asked!r}, but of {_listed(persons)}; choose another one with --person"
        )
    names = [about.name for about in tables if person in {None, about.person}]
    if use is not None and use not in names:
        raise PerformanceError(
            f"there is no such table {printable(use[:40])!r}, but {_listed(names)}; choose another one with --use"
        )


def _listed(names: Iterable[str]) -> str:
    return ", ".join(repr(printable(name[:40])) for name in names)


def _tongue(tag: str) -> str:
    """Return a language without its dialect."""
    return "cmn" if tag.lower() in TAGS else tag.lower().partition("-")[0]


MOST_EXAMPLES = 50
"""Of a string; of more, these are spread evenly over the durations of its first word."""
_LONGEST_STRING = 1e9

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
    return ((found.recording, found.first // 2) for found in table.within(kind, names, 0.0, _LONGEST_STRING))


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
