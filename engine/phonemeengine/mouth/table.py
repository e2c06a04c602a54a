"""Mouth tables: which shape the mouth takes for a sound, and which movestates make that shape.

Every table has a shape for each phoneme. Where more is known of a sound than that, its phone of the IPA, a table may
have one for the phone, or for a class of phones such as ``labiodental``; the narrowest that it names counts.

They are TOML files that an animator edits, read strictly.
"""

import math
import os
import textwrap
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w

from phonemeengine.arrays import Float32Array, ShortRepr
from phonemeengine.errors import MouthError, check_range, remedy
from phonemeengine.labels.phone_sets import ARTICULATIONS, IPA_LETTERS, articulations_of, letters_of, narrowest
from phonemeengine.mouth.blendshape_names import NAMES, both_sides
from phonemeengine.mouth.style_numbers import MovementNumbers
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.files import printable_name
from phonemeengine.storage.strict_table import StrictTable, load_text, parse_toml, shown

# How a mouth moves between its shapes: how fast for which sound, how far, and how much it varies.

# name: (lowest, highest, unit)
LIMITS: dict[str, tuple[float, float, str]] = {
    "attack": (0.005, 1.0, "s"),
    "release": (0.005, 1.0, "s"),
    "loudness": (0.0, 1.0, "s"),
    "minimum_opening": (0.0, 1.0, ""),
    "randomness": (0.0, 0.5, ""),
}
NEARLY = 0.9
"""The share of its way that a movement has gone after an attack or a release."""
PART = math.acos(1 - 2 * NEARLY) / math.pi
"""The share of its time that a movement along half a cosine takes for that: 0.795."""


@dataclass(frozen=True)
class TransitionTimes:
    """How fast the mouth is for one sound.

    Parameters
    ----------
    attack : time in which the mouth has gone nine tenths of the way to the sound's shape, seconds.
    release : time in which it has gone nine tenths of the way back, when silence follows the sound, seconds.

    Raises
    ------
    MouthError : a time lies outside 0.005..1 s.
    """

    attack: float
    release: float

    def __post_init__(self) -> None:
        _check(self)

    @property
    def to_shape(self) -> float:
        """The whole time of the movement to the sound's shape, seconds."""
        return self.attack / PART

    @property
    def to_rest(self) -> float:
        """The whole time of the movement back, seconds."""
        return self.release / PART

    def scaled(self, attack: float, release: float) -> "TransitionTimes":
        """Return both times multiplied by factors above 0, as far as their limits allow."""
        return TransitionTimes(_limited("attack", attack * self.attack), _limited("release", release * self.release))


@dataclass(frozen=True)
class MotionSettings:
    """The ways of one mouth.

    Parameters
    ----------
    loudness : time constant with which it follows the loudness, seconds.
    minimum_opening : share of a shape that the faintest speech keeps, 0..1.
    randomness : by how much shapes and times vary from one phoneme to the next, 0..0.5; 0 is a machine.

    Raises
    ------
    MouthError : a value lies outside its range.
    """

    loudness: float = 0.05
    minimum_opening: float = 0.4
    randomness: float = 0.1

    def __post_init__(self) -> None:
        _check(self)


def _check(values: Any) -> None:
    for name in (entry.name for entry in fields(values)):
        check_range(name, getattr(values, name), LIMITS[name], MouthError)


def _limited(name: str, seconds: float) -> float:
    low, high, _ = LIMITS[name]
    return min(max(seconds, low), high)


FORMAT = "phonemeanalyser mouth 1"
TABLES = Path(__file__).resolve().parent / "tables"
"""The folder of the tables that ship with the program."""
USUAL_TABLE = "arkit"
"""What heads and their receivers move by, unless told otherwise."""
MOST_MOVESTATES = 1000
STRONGEST = 400.0
"""Percent: a shape may exaggerate, but not without end."""

SPEAKING: tuple[Phoneme, ...] = tuple(p for p in Phoneme if p != Phoneme.SILENCE)
"""The phonemes that have times: the mouth closes in the release of what was said before a silence."""
USUAL_TIMES = {"attack": 0.09, "closing": 0.05, "release": 0.16}
"""Seconds of phonemes for which a table gives none: the attack of an open mouth, and that of lips that meet."""

_REQUIRED = ("movestates", "phonemes", "shapes")
_OPTIONAL = ("name", "notes", "firm", "phones", "times", "manner", "targets")
_MOTION_KEYS = {"loudness": "loudness", "quiet": "minimum_opening", "randomness": "randomness"}
"""What [manner] calls the fields of `MotionSettings`."""


@dataclass(frozen=True, repr=False)
class MouthTable(ShortRepr):
    """What the mouth does for each sound.

    Attributes
    ----------
    name : what people call it.
    movestates : the names of the movestates, in the order of all weights.
    phonemes : the mouth shape of every phoneme.
    shapes : for each mouth shape the percentages of its movestates, 100 for the whole movement.
    times : how fast the mouth is for each phoneme but silence.
    closed_phonemes : those at which the lips meet: they do so in time, and wholly at any loudness, as silence does.
    motion : how far the mouth moves, and how much that varies.
    notes : for people.
    phones : the mouth shapes of phones, by their letter in the IPA or a class of `ARTICULATIONS`.
    phone_times : how fast the mouth is for some of those; else as for the phoneme.
    closed_phones : those of `phones` at which lips, teeth or tongue meet as lips do at `closed_phonemes`.
    targets : for a face whose shapes have other names: the percentages of its shapes that a movestate stands for; a
        movestate that is not named moves nothing then. Empty for a face with the movestates themselves.
    movement, widths : how a style moves the mouth, and factors of the time for which what meets stays so, by letter.
    priorities : by how much a style puts what meets above what meets beside it, by letter; 0 for the others.
    tongue : percentages of the tongue's movestates, beside those of shapes, by letter or class.
    """

    name: str
    movestates: tuple[str, ...]
    phonemes: Mapping[Phoneme, str]
    shapes: Mapping[str, Mapping[str, float]]
    times: Mapping[Phoneme, TransitionTimes]
    closed_phonemes: frozenset[Phoneme] = frozenset({Phoneme.M, Phoneme.P})
    motion: MotionSettings = field(default_factory=MotionSettings)
    notes: str = ""
    phones: Mapping[str, str] = field(default_factory=dict)
    phone_times: Mapping[str, TransitionTimes] = field(default_factory=dict)
    closed_phones: frozenset[str] = frozenset()
    targets: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    movement: MovementNumbers = field(default_factory=MovementNumbers)
    widths: Mapping[str, float] = field(default_factory=dict)
    priorities: Mapping[str, float] = field(default_factory=dict)
    tongue: Mapping[str, Mapping[str, float]] = field(default_factory=dict)

    @cached_property
    def face_names(self) -> tuple[str, ...]:
        """The shapes of the face that are moved: those of `targets`, or the movestates themselves."""
        return tuple(dict.fromkeys(name for shapes in self.targets.values() for name in shapes)) or self.movestates

    def on_face(self, weights: Float32Array, movestates: tuple[str, ...] | None = None) -> Float32Array:
        """Return how far each of `face_names` moves, shape (..., n_names), by the weights of movestates.

        The movestates are those of the table, or others by name, shape (..., n_movestates).
        """
        if not self.targets:
            return weights
        matrix = np.zeros((weights.shape[-1], len(self.face_names)), np.float32)
        columns = {name: column for column, name in enumerate(self.face_names)}
        for row, movestate in enumerate(movestates or self.movestates):
            for name, percent in self.targets.get(movestate, {}).items():
                matrix[row, columns[name]] = percent / 100
        mapped: Float32Array = weights @ matrix
        return mapped

    def shape_of(self, phoneme: Phoneme, phone: str = "") -> str:
        """Return the mouth shape of a phone, where the table has one for it or a class of it; else the phoneme's."""
        entry = self._entry_of(phone)
        return self.phones[entry] if entry else self.phonemes[phoneme]

    def times_of(self, phoneme: Phoneme, phone: str = "") -> TransitionTimes:
        """Return how fast the mouth is for a phone, or a class of it; else for the phoneme, which is no silence."""
        return narrowest(self.phone_times, phone, self.times[phoneme])

    def closes(self, phoneme: Phoneme, phone: str = "") -> bool:
        """Return whether the mouth comes to its shape in time, and wholly at any loudness, as lips do that meet."""
        return phoneme in self.closed_phonemes or self._entry_of(phone) in self.closed_phones

    def weights(self) -> Float32Array:
        """Return the weights of every phoneme's shape, shape (11, n_movestates), 1 for the whole movement."""
        rows = {shape: k for k, shape in enumerate(self.shapes)}
        return self.shape_weights()[[rows[self.phonemes[phoneme]] for phoneme in Phoneme]]

    def shape_weights(self) -> Float32Array:
        """Return the weights of every shape in the order of `shapes`, shape (n_shapes, n_movestates)."""
        rows = [[shape.get(name, 0.0) / 100 for name in self.movestates] for shape in self.shapes.values()]
        return np.array(rows, np.float32)

    def with_motion(self, attack: float, release: float, *, random: bool) -> "MouthTable":
        """Return the table with all its times multiplied by factors above 0, and with its randomness or without."""
        times = {phoneme: times.scaled(attack, release) for phoneme, times in self.times.items()}
        phone_times = {name: times.scaled(attack, release) for name, times in self.phone_times.items()}
        motion = self.motion if random else replace(self.motion, randomness=0.0)
        return replace(self, times=times, phone_times=phone_times, motion=motion)

    def _entry_of(self, phone: str) -> str:
        """Return which entry of `phones` a phone comes under; an empty text for none."""
        letters = letters_of(phone) if phone else ()
        return self._entries.get(letters[0], "") if letters else ""

    @cached_property
    def _entries(self) -> dict[str, str]:
        """The entry of `phones` that each letter comes under, where there is one: the narrowest, which comes last."""
        return {
            letter: name
            for letter in IPA_LETTERS
            for name in reversed((letter, *articulations_of(letter)))
            if name in self.phones
        }


def shipped_tables() -> tuple[str, ...]:
    """Name the tables that ship with the program."""
    return tuple(sorted(path.stem for path in TABLES.glob("*.toml")))


def tables_by_movestates() -> dict[str, str]:
    """Name for each set of movestates the table that ships with the program, with what people call it.

    Of several tables that move the same it is that which the set is named after, else the first one.
    """
    found: dict[tuple[str, ...], tuple[str, str]] = {}
    for name in sorted(shipped_tables(), key=lambda name: name not in NAMES):
        table = load_table(name)
        found.setdefault(table.movestates, (name, table.name))
    return dict(named for movestates, named in found.items() if movestates)


def load_table(name: str | os.PathLike[str]) -> MouthTable:
    """Load a mouth table: one that ships with the program by its name, such as ``arkit``, or a file.

    Raises
    ------
    MouthError : there is none, or it says something impossible; the message names the file, the entry and what to do.
    """
    if str(name) in shipped_tables():
        return _shipped_table(str(name))
    path = Path(name)
    if not os.path.lexists(path):
        file = printable_name(path)
        words = remedy(file, shipped_tables(), "name a file, or one of {}")
        raise MouthError(f"{file}: there is no such mouth table; {words}")
    return _table_in(path)


@cache
def _shipped_table(name: str) -> MouthTable:
    return _table_in(TABLES / f"{name}.toml")


def _table_in(path: Path) -> MouthTable:
    return load_text(path, "a mouth table (.toml)", MouthError, table_of)


def table_of(text: str) -> MouthTable:
    """Read a mouth table from the text of a TOML file.

    Raises
    ------
    MouthError : not TOML, not of this format, an unknown or missing name, or a value out of range.
    """
    top = parse_toml(text, "a mouth table", FORMAT, MouthError)
    top.check_keys(_REQUIRED, _OPTIONAL)
    movestates = movestates_of(top)
    shapes = shapes_in(top, movestates)
    closed = frozenset(top.members("firm", Phoneme)) if "firm" in top else MouthTable.closed_phonemes
    general, motion = _motion_of(top.table("manner"))
    phones = _phones_of(top.table("phones"))
    return MouthTable(
        name=top.value("name", str, "untitled"),
        movestates=movestates,
        phonemes=shapes_of_phonemes(top.table("phonemes"), shapes),
        shapes=shapes,
        times=_times_of(top.table("times"), general, closed),
        closed_phonemes=closed,
        motion=motion,
        notes=top.value("notes", str, ""),
        phones={
            name: shape_named(f"[phones] {name}", entry.entries["shape"], shapes) for name, entry in phones.items()
        },
        phone_times={name: times for name, entry in phones.items() for times in _phone_times(entry)},
        closed_phones=frozenset(name for name, entry in phones.items() if entry.value("firm", bool, False)),
        targets=_targets_of(top.table("targets"), movestates) if "targets" in top else {},
    )


def _targets_of(table: StrictTable, movestates: tuple[str, ...]) -> dict[str, dict[str, float]]:
    """Return the shapes of a face that each movestate stands for."""
    what = f"a percentage in -{STRONGEST:g}..{STRONGEST:g}"
    for name in table.entries:
        if name not in movestates:
            raise MouthError(f"targets names {shown(name)}, which is no movestate; use one of movestates")
    return {
        name: {shape: shapes.limited(shape, -STRONGEST, STRONGEST, what) for shape in shapes.entries}
        for name, shapes in table.tables_by_name()
    }


def movestates_of(top: StrictTable) -> tuple[str, ...]:
    """Return the movestates of a file: those of a set by its name, or a list of its own."""
    entry = top.entries["movestates"]
    if isinstance(entry, str) and entry in NAMES:
        return NAMES[entry]
    names = entry if isinstance(entry, list) else [None]
    if len(names) > MOST_MOVESTATES or any(not isinstance(name, str) or not name for name in names):
        what = f"one of {', '.join(NAMES)}, or a list of at most {MOST_MOVESTATES} names"
        raise top.refusal("movestates", what, entry)
    for name in names:
        if names.count(name) > 1:
            raise MouthError(f"movestates names {shown(name)} twice; remove one")
    return tuple(names)


def shapes_in(top: StrictTable, movestates: tuple[str, ...]) -> dict[str, dict[str, float]]:
    """Return the percentages of each mouth shape of a file; a name without a side stands for both."""
    return {name: _shape_of(table, movestates) for name, table in top.table("shapes").tables_by_name()}


def _shape_of(table: StrictTable, movestates: tuple[str, ...]) -> dict[str, float]:
    percentages: dict[str, float] = {}
    for name in table.entries:
        percent = table.limited(name, -STRONGEST, STRONGEST, f"a percentage in -{STRONGEST:g}..{STRONGEST:g}")
        for side in (name,) if name in movestates else both_sides(name):
            if side not in movestates:
                raise MouthError(
                    f"{table.name} moves {shown(name)}, which is no movestate; use one of movestates, or add it"
                )
            if side in percentages:
                raise MouthError(f"{table.name} says twice what {shown(side)} does; remove one")
            percentages[side] = percent
    return percentages


def shapes_of_phonemes(table: StrictTable, shapes: Collection[str]) -> dict[Phoneme, str]:
    """Return the shape of every phoneme, which must be one of these."""
    found = table.phonemes()
    for phoneme in Phoneme:
        if phoneme not in found:
            raise MouthError(f"[phonemes] lacks {phoneme.label}; name its mouth shape")
    return {
        phoneme: shape_named(f"[phonemes] {phoneme.label}", table.entries[phoneme.label], shapes)
        for phoneme in Phoneme
    }


def shape_named(place: str, shape: object, shapes: Collection[str]) -> str:
    """Return a shape that is named at a place of a file, or refuse one that is none of these."""
    if not isinstance(shape, str) or shape not in shapes:
        raise MouthError(f"{place} has the shape {shown(shape)}, which [shapes] lacks; add it there")
    return shape


def _phones_of(table: StrictTable) -> dict[str, StrictTable]:
    """Return the entry of each phone or class as a table; a shape alone stands for one that says no more."""
    entries: dict[str, StrictTable] = {}
    for key in table.entries:
        name = phone_named(key)
        if name in entries:
            raise MouthError(f"[phones] says twice what {name} is; remove one")
        entry = table.entries[key]
        entries[name] = StrictTable({"shape": entry}, f"[phones.{key}]", MouthError)
        if isinstance(entry, dict):
            entries[name] = table.table(key)
            entries[name].check_keys(("shape",), ("attack", "release", "firm"))
    return entries


def phone_named(key: str, table: str = "[phones]") -> str:
    """Return the letter or class that a key of a table of phones means, or refuse it."""
    if key in ARTICULATIONS:
        return key
    letters = letters_of(key)
    if len(letters) != 1 or key not in {letters[0], "g"}:
        known = textwrap.shorten(", ".join(ARTICULATIONS), 120, placeholder=" …")
        raise MouthError(
            f"{table} knows no sound {shown(key)}; name a letter of the IPA without marks, or a class: {known}"
        )
    return letters[0]


def _phone_times(entry: StrictTable) -> tuple[TransitionTimes, ...]:
    """Return the times that an entry of [phones] gives, if it does."""
    given = [name for name in ("attack", "release") if name in entry]
    if len(given) == 1:
        raise MouthError(f"{entry.name} gives {given[0]} alone; give attack and release, or none of them")
    return (TransitionTimes(*(_seconds(entry, name) for name in given)),) if given else ()


def _times_of(
    table: StrictTable, general: Mapping[str, float], closed: Collection[Phoneme]
) -> dict[Phoneme, TransitionTimes]:
    """Return the times of every phoneme: its own, else those of [manner] for all, else the usual ones."""
    own = {phoneme: _own_times(table, name) for phoneme, name in table.phonemes().items()}
    if Phoneme.SILENCE in own:
        raise MouthError(
            "[times] silence has none: the mouth closes in the release of what was said before; remove it"
        )
    used: set[str] = set()
    times: dict[Phoneme, TransitionTimes] = {}
    for phoneme in SPEAKING:
        sources = {"attack": "closing" if phoneme in closed else "attack", "release": "release"}
        used |= {source for name, source in sources.items() if name not in own.get(phoneme, {})}
        usual = {name: general.get(source, USUAL_TIMES[source]) for name, source in sources.items()}
        times[phoneme] = TransitionTimes(**usual | own.get(phoneme, {}))
    if own and (idle := [name for name in general if name not in used]):
        raise MouthError(f"[manner] {idle[0]} acts on nothing, since [times] names every phoneme; remove one of them")
    return times


def _own_times(table: StrictTable, phoneme: str) -> dict[str, float]:
    entry = table.entries[phoneme]
    if not isinstance(entry, dict) or not entry.keys() <= {"attack", "release"}:
        raise table.refusal(phoneme, "like { attack = 0.1, release = 0.18 }, seconds", entry)
    times = table.table(phoneme)
    return {name: _seconds(times, name) for name in entry}


def _motion_of(table: StrictTable) -> tuple[dict[str, float], MotionSettings]:
    """Return the times for all phonemes that [times] leaves out, and the settings."""
    table.check_keys((), (*USUAL_TIMES, *_MOTION_KEYS))
    general = {name: _seconds(table, name) for name in USUAL_TIMES if name in table}
    settings = {}
    for name in filter(table.__contains__, _MOTION_KEYS):
        low, high, unit = LIMITS[_MOTION_KEYS[name]]
        what = f"a number of seconds in {low:g}..{high:g}" if unit else f"a number in {low:g}..{high:g}"
        settings[_MOTION_KEYS[name]] = table.limited(name, low, high, what)
    return general, MotionSettings(**settings)


def _seconds(table: StrictTable, name: str) -> float:
    low, high, _ = LIMITS["attack"]
    return table.limited(name, low, high, f"a number of seconds in {low:g}..{high:g}")


# The text of a mouth table's file: TOML that `table.table_of` reads as the same table.


def table_to_toml(table: MouthTable) -> str:
    """Write a mouth table as the text of a TOML file; every phoneme has its times by name."""
    known = [name for name, movestates in NAMES.items() if movestates == table.movestates]
    document: dict[str, Any] = {
        "format": FORMAT,
        "name": table.name,
        "notes": table.notes,
        "movestates": known[0] if known else list(table.movestates),
        "firm": [phoneme.label for phoneme in sorted(table.closed_phonemes)],
        "phonemes": {phoneme.label: shape for phoneme, shape in table.phonemes.items()},
        "phones": {name: _phone_entry(table, name) for name in table.phones},
        "times": {phoneme.label: _times_entry(times) for phoneme, times in table.times.items()},
        "manner": {
            "loudness": table.motion.loudness,
            "quiet": table.motion.minimum_opening,
            "randomness": table.motion.randomness,
        },
        "shapes": {name: dict(percentages) for name, percentages in table.shapes.items()},
    }
    if table.targets:
        document["targets"] = {name: dict(shapes) for name, shapes in table.targets.items()}
    return tomli_w.dumps(document)


def _phone_entry(table: MouthTable, name: str) -> str | dict[str, Any]:
    """Return what [phones] says of a phone or class: a shape alone, where it says no more."""
    times = table.phone_times.get(name)
    firm = {"firm": True} if name in table.closed_phones else {}
    more = (_times_entry(times) if times else {}) | firm
    return {"shape": table.phones[name]} | more if more else table.phones[name]


def _times_entry(times: TransitionTimes) -> dict[str, float]:
    return {"attack": times.attack, "release": times.release}
