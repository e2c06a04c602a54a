"""Which shapes of a face, or action units of FACS, stand for which of ours: guessed by names, put into a mouth table.

A guess compares names without their case, sides, and what programs put before them, with those of `SHAPE_NAMES`; what
is left is compared letter by letter. Bones that turn stand in for shapes that a face does not have.
"""

import difflib
import re
import tomllib
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import NamedTuple

from phonemeengine.arrays import ShortRepr
from phonemeengine.errors import MouthError, remedy
from phonemeengine.mouth.blendshape_names import ARKIT, BONE, EYELIDS, NAMES, both_sides
from phonemeengine.mouth.idle_motion import EYES
from phonemeengine.mouth.table import MouthTable, load_table

SHAPE_NAMES = Path(__file__).with_name("shape_names.toml")
BOTH = 50.0
"""Percent that each side moves a shape of both."""
ALIKE = 0.84
"""How alike a name must be to one of ours that no table names, 0..1, as `difflib` measures it."""
ENOUGH = {"arkit": 8, "oculus": 8, "vrm": 3}
"""Shapes of the mouth that a face has at least whose mouth is moved by a set of movestates."""
LEFT, RIGHT = "Left", "Right"
_SIDES = {"l": LEFT, "left": LEFT, "r": RIGHT, "right": RIGHT}
_QUARTERS = {"lb": (LEFT, "b"), "lt": (LEFT, "t"), "rb": (RIGHT, "b"), "rt": (RIGHT, "t")}
_QUARTERS |= {"ul": (LEFT, "u"), "dl": (LEFT, "d"), "ur": (RIGHT, "u"), "dr": (RIGHT, "d")}
_NOISE = {"xr", "face", "expression", "expressions", "fb", "ctrl", "facs", "bs", "jnt", "blendshape", "blendshapes"}
_NOISE |= {"morph", "target", "morpher", "fcl", "vrc", "head", "shape", "key", "div", "ph", "arkit", "mesh", "eyes"}
_ASIDE = {
    "jaw",
    "mouth",
    "mouthupper",
    "mouthlower",
    "jawsideways",
    "jawslide",
    "mouthslide",
    "mouthmove",
    "chin",
    "au30",
}
"""Before a side these mean a direction, not a side of the face."""
_LOOKS = {"eyelook", "look", "eyeturn", "eye", "eyesturn"}
_TURNED = {"au61": LEFT, "au62": RIGHT}
"""Action units of eyes that turn to a side."""
_WINKS = {"ウィンク": LEFT, "ウィンク2": LEFT}
"""In MikuMikuDance a wink without a side is one of the left eye."""


class ShapeKey(NamedTuple):
    """What a name of a shape means: its letters without a side, and its side; empty for both or none."""

    stem: str
    side: str = ""


@dataclass(frozen=True, repr=False)
class FaceMapping(ShortRepr):
    """Which shapes of a face stand for which of ours.

    Attributes
    ----------
    basis : whose movestates ours are: ``arkit``, ``oculus`` or ``vrm``; eyelids and eyes are those of ARKit.
    targets : for each of ours that the face has, percentages of the face's own shapes.
    left_over : shapes of the face that stand for none of ours.
    """

    basis: str
    targets: Mapping[str, Mapping[str, float]]
    left_over: tuple[str, ...] = ()

    @property
    def ours(self) -> tuple[str, ...]:
        """All movestates of ours, found or not."""
        return ours_of(self.basis)

    @property
    def missing(self) -> tuple[str, ...]:
        """Ours that the face has no shape for."""
        return tuple(name for name in self.ours if name not in self.targets)

    def with_target(self, ours: str, shape: str) -> "FaceMapping":
        """Return the mapping where one of ours stands for another shape of the face; for none, where it is empty.

        A shape for which both sides stand is moved by half from each.
        """
        targets = {name: dict(shapes) for name, shapes in self.targets.items() if name != ours}
        if shape:
            targets[ours] = {shape: 100.0}
        for left in (name for name in self.ours if name.endswith(LEFT)):
            right = left.removesuffix(LEFT) + RIGHT
            both = {*targets.get(left, ())} & {*targets.get(right, ())}
            for name in {left, right} & targets.keys():
                targets[name] = {one: BOTH if one in both else 100.0 for one in targets[name]}
        ordered = {name: targets[name] for name in self.ours if name in targets}
        names = dict.fromkeys((*self.left_over, *(one for shapes in self.targets.values() for one in shapes)))
        return _mapping([*names], self.basis, ordered)


def ours_of(basis: str) -> tuple[str, ...]:
    """Return the movestates that a mapping is for: a set by its name, with eyelids and eyes.

    Raises
    ------
    MouthError : there is no such set.
    """
    if basis not in ENOUGH:
        raise MouthError(f"there is no set of movestates {basis!r}; {remedy(basis, ENOUGH)}")
    return tuple(dict.fromkeys((*NAMES[basis], *EYELIDS, *EYES)))


def guess_mapping(names: Sequence[str], basis: str = "") -> FaceMapping:
    """Guess which shapes of a face stand for which of ours, by their names alone.

    Parameters
    ----------
    names : of the face's shapes; those that begin with ``bone`` are bones that turn.
    basis : ``arkit``, ``oculus`` or ``vrm``; the one that the face has most of, where it is empty.

    Raises
    ------
    MouthError : there is no such basis.
    """
    if basis:
        return _mapping(names, basis, _guessed(names, basis))
    found = {name: _guessed(names, name) for name in ENOUGH}
    for name, targets in found.items():
        mouths = [ours for ours in targets if ours in NAMES[name] and ours not in (*EYELIDS, *EYES)]
        if len([ours for ours in mouths if not ours.startswith(("brow", "eye"))]) >= ENOUGH[name]:
            return _mapping(names, name, targets)
    return _mapping(names, "arkit", found["arkit"])


def mapped_table(mapping: FaceMapping, name: str, table: MouthTable | None = None) -> MouthTable:
    """Return a mouth table for a face: it moves ours, which stand for the face's own shapes.

    Parameters
    ----------
    mapping : what stands for what.
    name : what people call the table.
    table : the mouth shapes, made of movestates of the mapping's basis; the program's own, where it is None.

    Raises
    ------
    MouthError : the table has movestates that the mapping does not know.
    """
    table = table or load_table(mapping.basis)
    if unknown := {*table.movestates} - {*mapping.ours}:
        raise MouthError(
            f"the table {table.name!r} moves {min(unknown)!r}, which is none of {mapping.basis}; choose another table"
        )
    return replace(table, name=name, movestates=mapping.ours, targets=mapping.targets)


def shape_key(name: str) -> ShapeKey:
    """Return what the name of a shape means in any convention: ``eyeBlink_L``, ``Eye_Blink_Left``, ``AU45L``."""
    text = unicodedata.normalize("NFKC", name)
    _, dot, last = text.rpartition(".")
    text = last if dot and len(last) > 1 else text  # head_blendShape.jawOpen, not eye.L
    if text in _WINKS:
        return ShapeKey("まばたき", _WINKS[text])
    for sign, side in (("左", LEFT), ("右", RIGHT)):
        if sign in text:
            stem = re.sub(r"[\W\d_]", "", text.replace(sign, ""))
            return ShapeKey("まばたき" if stem == "ウィンク" else stem, side)
    words = [word.lower() for word in re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+|[^\W\d_A-Za-z]+", text)]
    return _key_of(_cleaned(words))


def _cleaned(words: list[str]) -> list[str]:
    """Return words without what programs put before a name, and with the numbers of action units."""
    kept: list[str] = []
    for place, word in enumerate(words):
        if word.isdigit():
            if kept and kept[-1] == "au":
                kept[-1] += word
            elif place == 1 and len(words[0]) == 1:
                kept.clear()  # A14_Eye_Blink_Left
        elif word not in _NOISE or (word == "eyes" and len(words) > place + 1):
            kept.append("eye" if word == "eyes" else word)
    return kept


def _key_of(words: list[str]) -> ShapeKey:
    stems: list[str] = []
    sides: list[str] = []
    direction = ""
    for word in words:
        if word in _QUARTERS:
            side, part = _QUARTERS[word]
            sides.append(side)
            stems.append(part)
        elif word in _SIDES:
            if not direction and "".join(stems) in _LOOKS - {"eye"}:
                direction = _SIDES[word]
            else:
                sides.append(_SIDES[word])
        else:
            stems.append(word)
    stem = "".join(stems)
    side = sides[0] if sides else ""
    if not side:
        stem, side = _glued(stem)
    direction = direction or _TURNED.get(stem, "") or (sides[1] if len(sides) > 1 and stem in _LOOKS else "")
    if direction and side:
        return ShapeKey("eyelookout" if direction == side else "eyelookin", side)
    if stem in _ASIDE and side:
        return ShapeKey(stem + side.lower())
    return ShapeKey(stem, side)


def _glued(stem: str) -> tuple[str, str]:
    """Return a stem and the side that is written at its end without a sign between, such as ``eyeblinkleft``."""
    for word, side in (("left", LEFT), ("right", RIGHT)):
        if stem.endswith(word) and stem != word:
            return stem.removesuffix(word), side
    return stem, ""


@cache
def _known() -> dict[str, dict[str, list[list[str]]]]:
    """Return the alternatives for each of ours, each a list of stems, by set."""
    document = tomllib.loads(SHAPE_NAMES.read_text(encoding="utf-8"))
    return {
        basis: {ours: [[one] if isinstance(one, str) else one for one in some] for ours, some in table.items()}
        for basis, table in document.items()
    }


def _guessed(names: Sequence[str], basis: str) -> dict[str, dict[str, float]]:
    order = ours_of(basis)
    keys: dict[ShapeKey, str] = {}
    for name in names:
        if not name.startswith(BONE):
            keys.setdefault(shape_key(name), name)
    wanted = dict(_known()[basis])
    if basis != "arkit":
        wanted |= {
            ours: known for ours, known in _known()["arkit"].items() if ours.startswith(("eyeBlink", "eyeLook"))
        }
    targets: dict[str, dict[str, float]] = {}
    for stem, alternatives in wanted.items():
        for ours, side in _sided(stem):
            if ours in names:
                targets[ours] = {ours: 100.0}
            elif found := next(filter(None, (_moved_by(keys, parts, side) for parts in alternatives)), None):
                targets[ours] = found
    used = {name for shapes in targets.values() for name in shapes}
    targets |= _alike([key for key, name in keys.items() if name not in used], keys, wanted, targets)
    bones = {ours: {f"{BONE}{ours}": 100.0} for ours in order if f"{BONE}{ours}" in names}
    return {ours: (bones | targets)[ours] for ours in order if ours in bones or ours in targets}


def _sided(stem: str) -> tuple[tuple[str, str], ...]:
    """Return ours for which a stem stands, each with its side."""
    if stem in ARKIT or f"{stem}{LEFT}" not in ARKIT:
        return ((stem, ""),)
    return tuple(zip(both_sides(stem), (LEFT, RIGHT), strict=True))


def _moved_by(keys: Mapping[ShapeKey, str], parts: Iterable[str], side: str) -> dict[str, float]:
    """Return the shapes that some parts are called by: those of a side, or of both by half; all, without a side."""
    found: dict[str, float] = {}
    for part in parts:
        if side:
            if name := keys.get(ShapeKey(part, side)):
                found[name] = 100.0
            elif name := keys.get(ShapeKey(part)):
                found[name] = BOTH
        else:
            sides = ("",) if ShapeKey(part) in keys else (LEFT, RIGHT)
            found |= {keys[ShapeKey(part, one)]: 100.0 for one in sides if ShapeKey(part, one) in keys}
    return found


def _alike(
    unused: list[ShapeKey], keys: Mapping[ShapeKey, str], wanted: Iterable[str], known: Mapping[str, object]
) -> dict[str, dict[str, float]]:
    """Return shapes whose names are nearly those of ours, for ours that have none."""
    found: dict[str, dict[str, float]] = {}
    for stem in wanted:
        for ours, side in _sided(stem):
            stems = [key.stem for key in unused if key.side == side and len(key.stem) > 4]
            if ours not in known and (near := difflib.get_close_matches(stem.lower(), stems, 1, ALIKE)):
                found[ours] = {keys[ShapeKey(near[0], side)]: 100.0}
    return found


def _mapping(names: Sequence[str], basis: str, targets: Mapping[str, Mapping[str, float]]) -> FaceMapping:
    used = {name for shapes in targets.values() for name in shapes}
    return FaceMapping(basis, targets, tuple(name for name in names if name not in used))


HIGHEST = 65
"""The number of the last action unit that moves eyes or face."""
_UNIT = re.compile(r"au\d+(?:left|right|lower|upper)?")


def is_unit(name: str) -> bool:
    """Return whether a name is that of an action unit, such as ``AU12``, ``au45L`` or ``AU28_Lower``."""
    return _UNIT.fullmatch(shape_key(name).stem) is not None


def shapes_moved_by(names: Sequence[str]) -> dict[str, tuple[int, ...]]:
    """Return the blend shapes of ARKit that action units move, each with the places of its units among the names.

    A shape's weight is the mean of theirs; names of other things are passed over.
    """
    places = {name: k for k, name in enumerate(names) if is_unit(name)}
    targets = guess_mapping([*places], "arkit").targets if places else {}
    return {shape: tuple(places[name] for name in units) for shape, units in targets.items()}


@cache
def units_shown() -> dict[str, tuple[str, ...]]:
    """Return the action units that blend shapes of ARKit can show, each with these; its intensity is their mean."""
    names = [f"AU{number:02}" for number in range(1, HIGHEST + 1)]
    shapes = shapes_moved_by(names)
    found = {name: tuple(shape for shape, units in shapes.items() if k in units) for k, name in enumerate(names)}
    return {name: some for name, some in found.items() if some}
