"""A style: how a face speaks, beside what it says. TOML files that a person edits, read strictly.

A file says only in what it differs from the neutral style, with which everything moves as tables and recordings have
it. Three amounts act on all the rest: *mumbling* opens the mouth less, later and for shorter closures, *theatrical*
opens it farther and moves the head more, *asymmetry* leaves the right half of the face behind the left one.
"""

import os
from collections.abc import Iterable, Mapping
from dataclasses import Field, dataclass, field, fields, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError, check_range, remedy
from phonemeengine.mouth.blendshape_names import ARKIT, TONGUE, both_sides
from phonemeengine.mouth.expression.composer import Expression, InhibitionTimes
from phonemeengine.mouth.expression.streams import columns_of, shipped_channels
from phonemeengine.mouth.performer import IdleMotion
from phonemeengine.mouth.poses import USUAL_POSES, USUAL_TONGUE, Pose, PoseTable, load_poses, pose_numbers
from phonemeengine.mouth.style_numbers import FilterNumbers, GestureNumbers, MovementNumbers, PoseNumbers
from phonemeengine.mouth.table import STRONGEST, MouthTable, TransitionTimes, phone_named
from phonemeengine.phonemes import VOWELS, Phoneme
from phonemeengine.storage.files import printable_name, write_file
from phonemeengine.storage.paths import styles_folder
from phonemeengine.storage.strict_table import StrictTable, load_text, parse_toml

FORMAT = "phonemeanalyser style 1"
STYLES = Path(__file__).resolve().parent / "styles"
"""The folder of the styles that ship with the program."""
NEUTRAL = "neutral"
AMOUNTS = ("mumbling", "theatrical", "asymmetry")
LONGEST_INHIBITION = 5.0
"""Seconds."""
MUMBLED, MUMBLED_TIME, MUMBLED_CLOSURE, MUMBLED_FILTER = 0.6, 0.6, 0.5, 0.4
"""Shares by which full mumbling lessens openings, lengthens times but those of closures, shortens closures, and
lowers the cut-offs of recorded faces."""
STRESSED, STRESSED_TIME, STRESSED_HEAD, STRESSED_EXPRESSION = 0.45, 0.25, 1.0, 0.5
"""Shares by which a theatrical mouth opens farther, is quicker, moves its head more, and reduces expressions less."""
LEFT_BEHIND = 0.5
"""Share that the right half of a face lacks at full asymmetry; lips that meet do so on both sides."""
_CLOSING_SIDES = ("mouthPressRight", "mouthRight", "jawRight")
_PHONEMES = {"m": Phoneme.M, "p": Phoneme.P, "o": Phoneme.O, "u": Phoneme.U, "b": Phoneme.P}
"""The phonemes of letters in `closures`; all but the last stand for them, where no phone is known."""


@cache
def _usual(path: Path) -> PoseTable:
    return load_poses(path)


@dataclass(frozen=True)
class Style:
    """How a face speaks.

    Attributes
    ----------
    name, notes : for people.
    mumbling, theatrical, asymmetry : amounts, 0..1.
    movement : how the mouth goes from shape to shape.
    poses : how poses come and go over recorded faces.
    filters : how these are smoothed.
    gestures : how the head goes along.
    inhibition : how speech begins and ends to hold expressions back.
    reductions : by how much speech reduces some channels of `ARKIT`, 0..1; the others as ``channels.toml`` says.
    closures, tongue : poses of the lips and of the tongue, by letter of the IPA or class.

    Raises
    ------
    MouthError : an amount or a reduction lies outside its range.
    """

    name: str = NEUTRAL
    notes: str = ""
    mumbling: float = 0.0
    theatrical: float = 0.0
    asymmetry: float = 0.0
    movement: MovementNumbers = field(default_factory=MovementNumbers)
    poses: PoseNumbers = field(default_factory=PoseNumbers)
    filters: FilterNumbers = field(default_factory=FilterNumbers)
    gestures: GestureNumbers = field(default_factory=GestureNumbers)
    inhibition: InhibitionTimes = field(default_factory=InhibitionTimes)
    reductions: Mapping[str, float] = field(default_factory=dict)
    closures: PoseTable = field(default_factory=lambda: _usual(USUAL_POSES))
    tongue: PoseTable = field(default_factory=lambda: _usual(USUAL_TONGUE))

    def __post_init__(self) -> None:
        named = {name: getattr(self, name) for name in AMOUNTS} | dict(self.reductions)
        for name, value in named.items():
            check_range(name, value, (0.0, 1.0, ""), MouthError)

    # -- what it makes of tables, faces and recordings -----------------------------------------------------

    @property
    def reach(self) -> float:
        """How far the mouth goes to shapes at which nothing meets, 1 for as far as tables and recordings say."""
        return self.movement.reach * (1 - MUMBLED * self.mumbling) * (1 + STRESSED * self.theatrical)

    def on_table(self, table: MouthTable) -> MouthTable:
        """Return a mouth table as this style moves it; what meets does so in any style."""
        table = self._with_closures(table)
        firm = firm_shapes(table)
        gains = dict(zip(table.movestates, self.loose_gains(table.movestates).tolist(), strict=True))
        shapes = table.shapes
        if any(gain != 1.0 for gain in gains.values()):
            shapes = {
                name: shape
                if name in firm
                else {state: _limited(percent * gains[state]) for state, percent in shape.items()}
                for name, shape in table.shapes.items()
            }
        return replace(
            table,
            shapes=shapes,
            times={
                phoneme: self._timed(times, phoneme in VOWELS, phoneme in table.closed_phonemes)
                for phoneme, times in table.times.items()
            },
            phone_times={
                name: self._timed(times, "vowel" in name or name in _VOWELS, name in table.closed_phones)
                for name, times in table.phone_times.items()
            },
            movement=replace(self.movement, held=self.movement.held * (1 - MUMBLED_CLOSURE * self.mumbling)),
            widths={name: pose.width for name, pose in self.closures.phones.items() if pose.width != 1.0},
            priorities=self._raised(),
        )

    def with_tongue(self, table: MouthTable) -> MouthTable:
        """Return a table with ARKit's movestates that also moves the tongue, for faces that have its movestates."""
        if table.movestates != ARKIT:
            return table
        tongue = {name: self.tongue.shapes[pose.shape] for name, pose in self.tongue.phones.items()}
        targets = table.targets and {**table.targets, **{name: {name: 100.0} for name in TONGUE}}
        return replace(table, movestates=(*ARKIT, *TONGUE), tongue=tongue, targets=targets)

    def _raised(self) -> dict[str, float]:
        """Return by how much closures have another priority than in the neutral style."""
        usual = _usual(USUAL_POSES).phones
        firm = {name: pose.priority for name, pose in self.closures.phones.items() if pose.firm}
        raised = {name: priority - usual.get(name, Pose("")).priority for name, priority in firm.items()}
        return {name: more for name, more in raised.items() if more}

    def on_idle(self, idle: IdleMotion) -> IdleMotion:
        """Return what a face does besides speaking, as it does that in this style."""
        expression = None if idle.expression is None else self._on_expression(idle.expression)
        return replace(idle, expression=expression, gestures=self.gesturing())

    def gesturing(self) -> GestureNumbers:
        """Return how the head goes along, with what the amounts do to it."""
        factor = (1 + STRESSED_HEAD * self.theatrical) * (1 - MUMBLED * self.mumbling)
        return self.gestures.scaled(factor)

    def filtered(self) -> FilterNumbers:
        """Return how recorded faces are smoothed, with what the amounts do to it."""
        factor = 1 - MUMBLED_FILTER * self.mumbling
        filters = self.filters
        return replace(
            filters, syllable=factor * filters.syllable, word=factor * filters.word, phrase=factor * filters.phrase
        )

    def posed_mouth(self) -> PoseTable:
        """Return the poses that are laid over a recorded mouth, with what the amounts do to them."""
        gains = dict(zip(self.closures.movestates, self.loose_gains(self.closures.movestates).tolist(), strict=True))
        firm = {pose.shape for pose in self.closures.phones.values() if pose.firm}
        shapes = {
            name: shape if name in firm else {state: percent * gains[state] for state, percent in shape.items()}
            for name, shape in self.closures.shapes.items()
        }
        factor = 1 - MUMBLED_CLOSURE * self.mumbling
        phones = {name: replace(pose, width=factor * pose.width) for name, pose in self.closures.phones.items()}
        return replace(self.closures, phones=phones, shapes=shapes, curve=self.poses)

    def posed_tongue(self) -> PoseTable:
        """Return the poses of the tongue in recorded faces."""
        return replace(self.tongue, curve=self.poses)

    def loose_gains(self, movestates: tuple[str, ...]) -> Float32Array:
        """Return by how much each movestate goes farther where nothing meets, shape (n_movestates,)."""
        behind = [
            name.endswith("Right")
            and name.removesuffix("Right") + "Left" in movestates
            and name not in _CLOSING_SIDES
            for name in movestates
        ]
        gains = np.where(behind, 1 - LEFT_BEHIND * self.asymmetry, 1.0) * self.reach
        return np.asarray(gains, np.float32)

    def _timed(self, times: TransitionTimes, is_vowel: bool, meets: bool) -> TransitionTimes:
        movement = self.movement
        factor = movement.closures if meets else movement.vowels if is_vowel else movement.consonants
        if not meets:
            factor *= (1 + MUMBLED_TIME * self.mumbling) * (1 - STRESSED_TIME * self.theatrical)
        return times if factor == 1.0 else times.scaled(factor, factor)

    def _with_closures(self, table: MouthTable) -> MouthTable:
        """Return a table of ARKit's shapes with the poses that differ from the neutral ones, by shape or firmness."""
        usual = _usual(USUAL_POSES)
        if table.movestates[: len(ARKIT)] != ARKIT or self.closures is usual:
            return table
        phones, shapes, phonemes = dict(table.phones), dict(table.shapes), dict(table.phonemes)
        closed, closed_phonemes = set(table.closed_phones), set(table.closed_phonemes)
        for name, pose in self.closures.phones.items():
            shape, known = self.closures.shapes[pose.shape], usual.entry(name)
            phoneme = _PHONEMES.get(name, Phoneme.UNIDENTIFIED)
            before = table.shape_of(phoneme, name)
            if known is None or usual.shapes[known.shape] != shape:
                new = f"{self.name}: {name}"
                shapes[new] = {**table.shapes[before], **shape}
            elif name not in table.phones and name not in _PHONEMES:
                continue
            elif known.firm != pose.firm or (pose.firm and phoneme in table.closed_phonemes - closed_phonemes):
                new = before  # also of b, where p is firm no more, which stood for both
            else:
                continue
            phones[name] = new
            (closed.add if pose.firm else closed.discard)(name)
            if name in _PHONEMES and name != "b":
                phonemes[phoneme] = new
                (closed_phonemes.add if pose.firm else closed_phonemes.discard)(phoneme)
        return replace(
            table,
            phones=phones,
            shapes=shapes,
            phonemes=phonemes,
            closed_phones=frozenset(closed),
            closed_phonemes=frozenset(closed_phonemes),
        )

    def _on_expression(self, expression: Expression) -> Expression:
        if self.inhibition != InhibitionTimes():
            expression = replace(expression, times=self.inhibition)
        if not self.reductions and not self.theatrical:
            return expression
        reductions = shipped_channels().reductions.copy()
        for name, reduction in self.reductions.items():
            reductions[columns_of(name)] = reduction
        reductions *= np.float32(1 - STRESSED_EXPRESSION * self.theatrical)
        return replace(expression, channels=replace(expression.channels, reductions=reductions))


def firm_shapes(table: MouthTable) -> frozenset[str]:
    """Return the shapes of a table at which something meets, and that of silence."""
    firm = {table.phonemes[phoneme] for phoneme in (*table.closed_phonemes, Phoneme.SILENCE)}
    return frozenset(firm | {table.phones[name] for name in table.closed_phones})


_VOWELS = frozenset("iyɨʉɯuɪʏʊeøɘɵɤoəɛœɜɞʌɔæɐaɶɑɒ")


def _limited(percent: float) -> float:
    return min(max(percent, -STRONGEST), STRONGEST)


@cache
def neutral_style() -> Style:
    """Return the style with which everything moves as tables and recordings have it."""
    return load_style(NEUTRAL)


# Styles between styles.


def blend(one: Style, other: Style, amount: float) -> Style:
    """Return a style between two, of which the second has so much, 0..1.

    Numbers and poses lie between those of both; a choice, such as whether lips meet, is that of the nearer one.

    Raises
    ------
    MouthError : the amount lies outside its range.
    """
    check_range("a blend", amount, (0.0, 1.0, ""), MouthError)
    if amount in (0.0, 1.0):
        return other if amount else one
    nearer = one if amount < 0.5 else other
    mixed: dict[str, Any] = {name: _between(getattr(one, name), getattr(other, name), amount) for name in AMOUNTS}
    for name in ("movement", "poses", "filters", "gestures", "inhibition"):
        first, second = getattr(one, name), getattr(other, name)
        numbers = {
            entry.name: _between(getattr(first, entry.name), getattr(second, entry.name), amount)
            for entry in fields(first)
        }
        mixed[name] = replace(first, **numbers)
    channels = shipped_channels()
    usual = dict(zip(channels.names, channels.reductions.tolist(), strict=True))
    reductions = {
        name: _between(one.reductions.get(name, usual[name]), other.reductions.get(name, usual[name]), amount)
        for name in {**one.reductions, **other.reductions}
    }
    closures, tongue = (
        _poses_between(getattr(one, name), getattr(other, name), amount) for name in ("closures", "tongue")
    )
    return replace(nearer, **mixed, reductions=reductions, closures=closures, tongue=tongue)


def _between(one: float, other: float, amount: float) -> float:
    return one if one == other else (1 - amount) * one + amount * other


def _poses_between(one: PoseTable, other: PoseTable, amount: float) -> PoseTable:
    if one == other:
        return one
    nearer = one if amount < 0.5 else other
    phones, shapes = dict(nearer.phones), dict(nearer.shapes)
    for name in one.phones.keys() & other.phones.keys():
        first, second = one.phones[name], other.phones[name]
        a, b, own = one.shapes[first.shape], other.shapes[second.shape], nearer.phones[name].shape
        if a != b:
            own = _own_shape(name)
            shapes[own] = {
                state: _between(a.get(state, b.get(state, 0.0)), b.get(state, a.get(state, 0.0)), amount)
                for state in {**a, **b}
            }
        phones[name] = Pose(
            own,
            _between(first.priority, second.priority, amount),
            nearer.phones[name].firm,
            _between(first.width, second.width, amount),
        )
    return replace(nearer, phones=phones, shapes=shapes)


def _own_shape(phone: str) -> str:
    """Return what the shape is called that a style has for one phone alone."""
    return f"of {phone}"


# Files.


@cache
def shipped_styles() -> tuple[str, ...]:
    """Name the styles that ship with the program, the neutral one first."""
    return (NEUTRAL, *sorted(path.stem for path in STYLES.glob("*.toml") if path.stem != NEUTRAL))


def own_styles() -> tuple[Path, ...]:
    """Return the files of styles in the user's own folder, by name."""
    folder = styles_folder()
    return tuple(sorted(folder.glob("*.toml"))) if folder.is_dir() else ()


def load_style(name: str | os.PathLike[str]) -> Style:
    """Load a style: one that ships with the program or that of the user's folder, by its name, or a file.

    Raises
    ------
    MouthError : there is none, or it says something impossible; the message names the file, the entry and what to do.
    """
    if str(name) in shipped_styles():
        return _shipped_style(STYLES / f"{name}.toml")
    own = {path.stem: path for path in own_styles()}
    path = own.get(str(name), Path(name))
    if not os.path.lexists(path):
        known = [*shipped_styles(), *own]
        raise MouthError(
            f"{printable_name(path)}: there is no such style; {remedy(str(name), known, 'name a file, or one of {}')}"
        )
    return _style_in(path)


def save_style(style: Style, path: str | os.PathLike[str]) -> None:
    """Write a style as a TOML file, which `load_style` reads as the same one.

    Raises
    ------
    MouthError : it cannot be written.
    """
    write_file(Path(path), style_to_toml(style).encode(), MouthError)


def style_to_toml(style: Style) -> str:
    """Write as TOML in what a style differs from the neutral one."""
    usual = Style()
    document: dict[str, Any] = {"format": FORMAT, "name": style.name}
    if style.notes:
        document["notes"] = style.notes
    amounts = {name: getattr(style, name) for name in AMOUNTS if getattr(style, name)}
    document |= {"amounts": amounts} if amounts else {}
    for name in GROUPS:
        own, known = getattr(style, name), getattr(usual, name)
        changed = {
            entry.name: getattr(own, entry.name)
            for entry in fields(own)
            if getattr(own, entry.name) != getattr(known, entry.name)
        }
        document |= {name: changed} if changed else {}
    document |= {"reductions": dict(style.reductions)} if style.reductions else {}
    for name in ("closures", "tongue"):
        changed = dict(_changed_poses(getattr(style, name), getattr(usual, name)))
        document |= {name: changed} if changed else {}
    return tomli_w.dumps(document)


def _changed_poses(own: PoseTable, usual: PoseTable) -> Iterable[tuple[str, dict[str, Any]]]:
    for name, pose in own.phones.items():
        known = usual.entry(name)
        entry: dict[str, Any] = {
            part: getattr(pose, part)
            for part in ("priority", "firm", "width")
            if getattr(pose, part) != getattr(known or Pose(""), part)
        }
        shape = own.shapes[pose.shape]
        if known is None or name not in usual.phones or usual.shapes[known.shape] != shape:
            entry["shape"] = dict(shape)
        if entry:
            yield name, entry


GROUPS = {
    "movement": MovementNumbers,
    "poses": PoseNumbers,
    "filters": FilterNumbers,
    "gestures": GestureNumbers,
    "inhibition": InhibitionTimes,
}
"""The tables of a style that hold numbers."""


def limits_of(number: Field[float]) -> tuple[float, float, str]:
    """Return the least and the greatest value of a number of a style, and its unit."""
    limits: tuple[float, float, str] = number.metadata.get("limits", (0.0, LONGEST_INHIBITION, "s"))
    return limits


def _style_in(path: Path) -> Style:
    return load_text(path, "a style (.toml)", MouthError, style_of)


_shipped_style = cache(_style_in)


def style_of(text: str) -> Style:
    """Read a style from the text of a TOML file.

    Raises
    ------
    MouthError : not TOML, not of this format, an unknown name, or a value out of range.
    """
    top = parse_toml(text, "a style", FORMAT, MouthError)
    top.check_keys((), ("name", "notes", "amounts", *GROUPS, "reductions", "closures", "tongue"))
    amounts = top.table("amounts")
    amounts.check_keys((), AMOUNTS)
    reductions = top.table("reductions")
    usual = Style()
    given: dict[str, Any] = {name: amounts.limited(name, 0, 1, "a number in 0..1", 0.0) for name in AMOUNTS}
    given |= {name: _numbers_of(top.table(name), kind) for name, kind in GROUPS.items()}
    return Style(
        top.value("name", str, "untitled"),
        top.value("notes", str, ""),
        **given,
        reductions={
            side: reductions.limited(name, 0, 1, "a number in 0..1")
            for name in reductions.entries
            for side in (ARKIT[column] for column in columns_of(name))
        },
        closures=_poses_in(top.table("closures"), usual.closures, ARKIT),
        tongue=_poses_in(top.table("tongue"), usual.tongue, TONGUE),
    )


def _numbers_of(table: StrictTable, kind: type[Any]) -> Any:
    """Return numbers of a kind, those that a table does not name as the neutral style has them."""
    known = {entry.name: entry for entry in fields(kind)}
    table.check_keys((), known)
    given = {}
    for name in table.entries:
        low, high, unit = limits_of(known[name])
        given[name] = table.limited(name, low, high, f"a number in {low:g}..{high:g}{unit and ' '}{unit}")
    return kind(**given)


def _poses_in(table: StrictTable, usual: PoseTable, movestates: tuple[str, ...]) -> PoseTable:
    if not table.entries:
        return usual
    phones, shapes = dict(usual.phones), dict(usual.shapes)
    for key, entry in table.tables_by_name():
        name = phone_named(key, table.name)
        pose = usual.entry(name) or Pose(_own_shape(name))
        entry.check_keys(() if pose.shape in shapes else ("shape",), ("shape", "priority", "firm", "width"))
        if "shape" in entry:
            pose = replace(pose, shape=_own_shape(name))
            shapes[pose.shape] = _percentages_of(entry.table("shape"), movestates)
        phones[name] = pose_numbers(entry, pose)
    return replace(usual, phones=phones, shapes=shapes)


def _percentages_of(table: StrictTable, movestates: tuple[str, ...]) -> dict[str, float]:
    found: dict[str, float] = {}
    for name in table.entries:
        sides = [side for side in (name, *both_sides(name)) if side in movestates]
        if not sides:
            raise MouthError(f"{table.name} names {name[:40]!r}, which is no movestate; {remedy(name, movestates)}")
        percent = table.limited(name, -STRONGEST, STRONGEST, f"a percentage in -{STRONGEST:g}..{STRONGEST:g}")
        found |= dict.fromkeys(sides, percent)
    return found
