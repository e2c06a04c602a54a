"""Mouth tables: which shape the mouth takes for a phoneme, and which movestates make that shape.

They are TOML files that an animator edits, read strictly.
"""

import os
import reprlib
import tomllib
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError
from phonemeengine.files import printable_name
from phonemeengine.mouth.blendshape_names import NAMES, both_sides
from phonemeengine.mouth.motion_settings import LIMITS, MotionSettings, TransitionTimes
from phonemeengine.phonemes import Phoneme

FORMAT = "phonemeanalyser mouth 1"
TABLES = Path(__file__).resolve().parent / "tables"
"""The folder of the tables that ship with the program."""
USUAL_TABLE = "arkit"
"""What heads and their receivers move by, unless told otherwise."""
LARGEST_FILE = 1 << 20
MOST_MOVESTATES = 1000
STRONGEST = 400.0
"""Percent: a shape may exaggerate, but not without end."""

SPEAKING: tuple[Phoneme, ...] = tuple(p for p in Phoneme if p != Phoneme.SILENCE)
"""The phonemes that have times: the mouth closes in the release of what was said before a silence."""
USUAL_TIMES = {"attack": 0.09, "closing": 0.05, "release": 0.16}
"""Seconds of phonemes for which a table gives none: the attack of an open mouth, and that of lips that meet."""

_KEYS = {
    "format": str, "name": str, "notes": str, "firm": list, "phonemes": dict, "times": dict, "shapes": dict,
    "manner": dict,
}  # fmt: skip
_OPTIONAL = {"name", "notes", "firm", "times", "manner"}
_WORDS = {str: "text", list: "a list", dict: "a table"}
_PHONEMES = {p.label: p for p in Phoneme}


@dataclass(frozen=True)
class MouthTable:
    """What the mouth does for each phoneme.

    Attributes
    ----------
    name : what people call it.
    movestates : the names of the movestates, in the order of all weights.
    phonemes : the mouth shape of every phoneme.
    shapes : for each mouth shape the percentages of its movestates, 100 for the whole movement.
    times : how fast the mouth is for each phoneme but silence.
    firm : phonemes at which the lips meet: they do so in time, and wholly at any loudness. Silence is always whole.
    manner : how far the mouth moves, and how much that varies.
    notes : for people.
    """

    name: str
    movestates: tuple[str, ...]
    phonemes: Mapping[Phoneme, str]
    shapes: Mapping[str, Mapping[str, float]]
    times: Mapping[Phoneme, TransitionTimes]
    firm: frozenset[Phoneme] = frozenset({Phoneme.M, Phoneme.P})
    manner: MotionSettings = field(default_factory=MotionSettings)
    notes: str = ""

    def weights(self) -> Float32Array:
        """Return the weights of every phoneme's shape, shape (11, n_movestates), 1 for the whole movement."""
        columns = {name: k for k, name in enumerate(self.movestates)}
        rows = np.zeros((len(Phoneme), len(columns)), np.float32)
        for phoneme, shape in self.phonemes.items():
            for movestate, percent in self.shapes[shape].items():
                rows[phoneme, columns[movestate]] = percent / 100
        return rows

    def moved_as(self, attack: float, release: float, *, random: bool) -> "MouthTable":
        """Return the table with all its times multiplied by factors above 0, and with its randomness or without."""
        times = {phoneme: times.scaled(attack, release) for phoneme, times in self.times.items()}
        manner = self.manner if random else replace(self.manner, randomness=0.0)
        return replace(self, times=times, manner=manner)


def shipped_tables() -> tuple[str, ...]:
    """Name the tables that ship with the program."""
    return tuple(sorted(path.stem for path in TABLES.glob("*.toml")))


def load_table(name: str | os.PathLike[str]) -> MouthTable:
    """Load a mouth table: one that ships with the program by its name, such as ``arkit``, or a file.

    Raises
    ------
    MouthError : there is none, or it says something impossible; the message names the file, the entry and what to do.
    """
    shipped = TABLES / f"{name}.toml"
    path = shipped if str(name) in shipped_tables() else Path(name)
    shown = printable_name(path)
    try:
        return table_of(_text_of(path))
    except MouthError as error:
        raise MouthError(f"{shown}: {error}") from error


def table_of(text: str) -> MouthTable:
    """Read a mouth table from the text of a TOML file.

    Raises
    ------
    MouthError : not TOML, not of this format, an unknown or missing name, or a value out of range.
    """
    try:
        document = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise MouthError(f"this is no TOML file ({error}); correct it there") from error
    if document.get("format") != FORMAT:
        raise MouthError(f"a mouth table begins with format = {FORMAT!r}, found {_shown(document.get('format'))}")
    _check_keys(document)
    movestates = _movestates_of(document["movestates"])
    shapes = {name: _shape_of(name, entry, movestates) for name, entry in document["shapes"].items()}
    firm = frozenset(_phoneme(name, "firm") for name in document.get("firm", ["m", "p"]))
    general, manner = _manner_of(document.get("manner", {}))
    return MouthTable(
        name=document.get("name", "untitled"),
        movestates=movestates,
        phonemes=_phonemes_of(document["phonemes"], shapes),
        shapes=shapes,
        times=_times_of(document.get("times", {}), general, firm),
        firm=firm,
        manner=manner,
        notes=document.get("notes", ""),
    )


def _text_of(path: Path) -> str:
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise MouthError("a mouth table is smaller than 1 MB; choose another file")
        return path.read_text(encoding="utf-8-sig")
    except FileNotFoundError as error:
        known = ", ".join(shipped_tables())
        raise MouthError(f"there is no such mouth table; name a file, or one of {known}") from error
    except UnicodeDecodeError as error:
        raise MouthError("this is no text file; choose a mouth table (.toml)") from error
    except (OSError, ValueError) as error:
        reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
        raise MouthError(f"it cannot be read ({reason}); check the file") from error


def _check_keys(document: dict[str, Any]) -> None:
    known = [*_KEYS, "movestates"]
    for key in document.keys() - set(known):
        raise MouthError(f"a mouth table does not know {_shown(key)}; known are {', '.join(known)}")
    for key in known:
        if key not in document and key not in _OPTIONAL:
            raise MouthError(f"{key} is missing; add it")
    for key, kind in _KEYS.items():
        if not isinstance(document.get(key, kind()), kind):
            raise MouthError(f"{key} must be {_WORDS[kind]}, found {_shown(document[key])}; correct it")


def _movestates_of(entry: Any) -> tuple[str, ...]:
    if isinstance(entry, str) and entry in NAMES:
        return NAMES[entry]
    names = entry if isinstance(entry, list) else [None]
    if len(names) > MOST_MOVESTATES or any(not isinstance(name, str) or not name for name in names):
        raise MouthError(
            f"movestates must be one of {', '.join(NAMES)}, or a list of at most {MOST_MOVESTATES} names, "
            f"found {_shown(entry)}; correct it"
        )
    for name in names:
        if names.count(name) > 1:
            raise MouthError(f"movestates names {_shown(name)} twice; remove one")
    return tuple(names)


def _shape_of(shape: str, entry: Any, movestates: tuple[str, ...]) -> dict[str, float]:
    if not isinstance(entry, dict):
        raise MouthError(f"[shapes.{shape}] must be a table of movestates and percentages, found {_shown(entry)}")
    percentages: dict[str, float] = {}
    for name, percent in entry.items():
        _check_percent(shape, name, percent)
        sides = (name,) if name in movestates else both_sides(name)
        for side in sides:
            if side not in movestates:
                raise MouthError(
                    f"[shapes.{shape}] moves {_shown(name)}, which is no movestate; use one of movestates, or add it"
                )
            if side in percentages:
                raise MouthError(f"[shapes.{shape}] says twice what {_shown(side)} does; remove one")
            percentages[side] = float(percent)
    return percentages


def _check_percent(shape: str, name: str, percent: Any) -> None:
    number = isinstance(percent, int | float) and not isinstance(percent, bool)
    if not number or not -STRONGEST <= percent <= STRONGEST:
        raise MouthError(
            f"[shapes.{shape}] {name} must be a percentage in -{STRONGEST:g}..{STRONGEST:g}, "
            f"found {_shown(percent)}; correct it"
        )


def _phonemes_of(entry: dict[str, Any], shapes: Mapping[str, Any]) -> dict[Phoneme, str]:
    found = {_phoneme(name, "[phonemes]"): shape for name, shape in entry.items()}
    for phoneme in Phoneme:
        if phoneme not in found:
            raise MouthError(f"[phonemes] lacks {phoneme.label}; name its mouth shape")
        shape = found[phoneme]
        if not isinstance(shape, str) or shape not in shapes:
            raise MouthError(
                f"[phonemes] {phoneme.label} has the shape {_shown(shape)}, which [shapes] lacks; add it there"
            )
    return {phoneme: found[phoneme] for phoneme in Phoneme}


def _phoneme(name: Any, place: str) -> Phoneme:
    if not isinstance(name, str) or name not in _PHONEMES:
        raise MouthError(f"{place} knows no phoneme {_shown(name)}; known are {', '.join(_PHONEMES)}")
    return _PHONEMES[name]


def _times_of(
    entry: dict[str, Any], general: Mapping[str, float], firm: Collection[Phoneme]
) -> dict[Phoneme, TransitionTimes]:
    """Return the times of every phoneme: its own, else those of [manner] for all, else the usual ones."""
    own = {_phoneme(name, "[times]"): _own_times(name, times) for name, times in entry.items()}
    if Phoneme.SILENCE in own:
        raise MouthError(
            "[times] silence has none: the mouth closes in the release of what was said before; remove it"
        )
    used: set[str] = set()
    times: dict[Phoneme, TransitionTimes] = {}
    for phoneme in SPEAKING:
        sources = {"attack": "closing" if phoneme in firm else "attack", "release": "release"}
        used |= {source for name, source in sources.items() if name not in own.get(phoneme, {})}
        usual = {name: general.get(source, USUAL_TIMES[source]) for name, source in sources.items()}
        times[phoneme] = TransitionTimes(**usual | own.get(phoneme, {}))
    if entry and (idle := [name for name in general if name not in used]):
        raise MouthError(f"[manner] {idle[0]} acts on nothing, since [times] names every phoneme; remove one of them")
    return times


def _own_times(phoneme: str, entry: Any) -> dict[str, float]:
    place = f"[times] {phoneme}"
    if not isinstance(entry, dict) or not entry.keys() <= {"attack", "release"}:
        raise MouthError(
            f"{place} must be like {{ attack = 0.1, release = 0.18 }}, seconds, found {_shown(entry)}; correct it"
        )
    return _seconds(place, entry)


def _manner_of(entry: dict[str, Any]) -> tuple[dict[str, float], MotionSettings]:
    """Return the times for all phonemes that [times] leaves out, and the manner."""
    known = [*USUAL_TIMES, *(f.name for f in fields(MotionSettings))]
    for name in entry:
        if name not in known:
            raise MouthError(f"[manner] does not know {_shown(name)}; known are {', '.join(known)}")
    general = _seconds("[manner]", {name: entry[name] for name in USUAL_TIMES if name in entry})
    rest = {name: _number("[manner]", name, value) for name, value in entry.items() if name not in general}
    try:
        return general, MotionSettings(**rest)
    except MouthError as error:
        raise MouthError(f"[manner] {error}") from error


def _seconds(place: str, entry: Mapping[str, Any]) -> dict[str, float]:
    low, high, _ = LIMITS["attack"]
    seconds = {name: _number(place, name, value) for name, value in entry.items()}
    for name, value in seconds.items():
        if not low <= value <= high:
            raise MouthError(f"{place} {name} must lie in {low:g}..{high:g} s, got {value:g}; correct it")
    return seconds


def _number(place: str, name: str, value: Any) -> float:
    if not isinstance(value, int | float) or isinstance(value, bool) or not abs(value) <= 1:
        raise MouthError(f"{place} {name} must be a number within 0..1, found {_shown(value)}; correct it")
    return float(value)


def _shown(value: Any) -> str:
    if isinstance(value, list | dict):
        return reprlib.repr(value)  # however deep it is
    return f"{value!r:.40}" if not isinstance(value, int) or abs(value) < 10**30 else "an endless number"
