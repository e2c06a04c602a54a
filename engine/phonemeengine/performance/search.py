"""The search for the units of a sentence in a table: long ones first, and what nobody recorded by what is like it."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from phonemeengine.labels.articulation import OPENNESS, articulations_of, letters_of
from phonemeengine.performance.recording import SILENCE, PerformedPhone
from phonemeengine.performance.units import Unit, UnitKind, units_of

Inventory = Mapping[UnitKind, frozenset[tuple[str, ...]]]
"""What a table has: of each set, the phones of all its units."""

LIPS = ("labiovelar", "labiodental", "bilabial", "front rounded vowel", "rounded vowel")
"""Classes of sounds that lips make: nobody takes such a sound for another one."""
_TEETH = "dental"
"""The class of sounds that show the tongue: these, too, are taken for each other alone."""
PLACES = (
    *LIPS, "dental", "postalveolar", "alveolo-palatal", "retroflex", "alveolar", "palatal", "velar", "uvular",
    "pharyngeal", "glottal", "open vowel", "mid vowel", "close vowel", "apical vowel", "front vowel", "back vowel",
    "central vowel",
)  # fmt: skip
"""Classes by which sounds look alike, what is seen the most first; others tell more to the ear than to the eye."""
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
    """

    unit: Unit
    kind: UnitKind
    names: tuple[str, ...]


def placed_units(phones: Sequence[PerformedPhone], inventory: Inventory) -> tuple[PlacedUnit, ...]:
    """Cover all halves of a sentence by units, each half by one; they come in order of time.

    A set is exhausted before the next one is looked at, and a unit is placed only where all its halves are free. A
    phone that the table lacks is replaced by the half of one that looks like it. At pauses within a sentence, what
    was recorded at the boundaries of sentences serves as well.

    Parameters
    ----------
    phones : in order of time; the first and the last are silence.
    inventory : of the table.
    """
    free = [True] * (2 * len(phones))
    found = []
    for unit in units_of(phones):
        if all(free[unit.first : unit.last]) and (placed := _placed(unit, inventory)):
            found.append(placed)
            free[unit.first : unit.last] = [False] * (unit.last - unit.first)
    return tuple(sorted(found, key=lambda placed: placed.unit.first))


def notes_on(phones: Sequence[PerformedPhone], inventory: Inventory) -> Iterator[str]:
    """Say which phones the table lacks, and what it has in their place, a sentence each."""
    for name in sorted({phone.name for phone in phones}):
        if (name,) not in inventory[UnitKind.LEFT_HALF]:
            likest_ones = dict.fromkeys(likest(name, inventory, kind) for kind in reversed(_HALVES))
            others = " and ".join(f"[{other}]" for other in likest_ones)
            yield f"nobody says [{name}] in the recordings, so it looks like {others}"


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
