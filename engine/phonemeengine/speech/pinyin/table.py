"""Pinyin tables: which letters, and so which mouth shapes, a syllable of Mandarin has, and for how long.

They are TOML files that an animator edits, read strictly; ``pinyin.toml`` is the one that ships.
"""

import os
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError, remedy
from phonemeengine.labels.pinyin import FINALS, INITIALS, initial_and_final, sound_of
from phonemeengine.mouth.table import (
    SPEAKING,
    USUAL_TIMES,
    MouthTable,
    TransitionTimes,
    movestates_of,
    shape_named,
    shapes_in,
    shapes_of_phonemes,
)
from phonemeengine.speech.pinyin.spring import LARGEST, Spring
from phonemeengine.storage.strict_table import StrictTable, load_text, parse_toml, shown

FORMAT = "phonemeanalyser pinyin 1"
USUAL_PINYIN_TABLE = Path(__file__).with_name("pinyin.toml")
REST = "&"
"""The letter of the mouth at rest."""
LEAST_SHARE, MOST_SHARE = 0.1, 0.45
"""Of a syllable, for its onset."""
MOST_SYLLABLES = 20.0
"""Syllables that a pause of weight 1 may last."""

FULL_FORMS = {".": "。", "?": "？", "!": "！", ";": "；", ":": "：", ",": "，", "\n": "。", "⋯": "…", "–": "—"}
"""The mark that another stands for; the end of a line ends a sentence."""

_REQUIRED = ("movestates", "onsets", "rimes", "phonemes", "weights", "marks", "transition", "shapes")
_OPTIONAL = ("name", "notes", "syllables", "variants", "doubtful")
_SPRING = ("mass", "stiffness", "damping")


@dataclass(frozen=True)
class PinyinTable:
    """What a mouth does for a syllable of pinyin.

    Attributes
    ----------
    mouth : the shapes by their names, which are letters and variants of them; those of the eleven phonemes serve for
        sounds that are no pinyin.
    onsets, rimes : the letter of each initial, and of each full final.
    syllables : both letters of whole syllables, which win over their parts.
    variants : the shape that an initial or a final has instead of that of its letter.
    onset_shares : the share of a syllable that its onset has, by the onset's letter.
    variation : by how much these vary where a seed asks for it, as a share of themselves.
    marks : the weight of the pause at each punctuation mark.
    pause : how long one of weight 1 is, in syllables.
    reach : the share of a part in which the mouth gets to its shape.
    spring : what draws the mouth instead of half a cosine, where there is one.
    doubts : syllables without tone whose letters may be doubted, and why.
    """

    mouth: MouthTable
    onsets: Mapping[str, str]
    rimes: Mapping[str, str]
    syllables: Mapping[str, str]
    variants: Mapping[str, str]
    onset_shares: Mapping[str, float]
    variation: float
    marks: Mapping[str, float]
    pause: float
    reach: float
    spring: Spring | None
    doubts: Mapping[str, str]

    def pause_at(self, mark: str) -> float:
        """Return the weight of the pause at a mark, of full width or not; 0 where there is none."""
        return self.marks.get(FULL_FORMS.get(mark, mark), 0.0)

    def letters_of(self, syllable: str) -> str:
        """Return the two letters of a syllable without tone: its onset's and its rime's."""
        if syllable in self.syllables:
            return self.syllables[syllable]
        initial, final = initial_and_final(syllable)
        return self.onsets.get(initial, REST) + self.rimes[final]

    def shapes_of(self, syllable: str) -> tuple[str, str]:
        """Return the names of both shapes of a syllable without tone: those of its letters, or variants of them."""
        onset, rime = tuple(self.letters_of(syllable))
        if syllable in self.syllables:
            return onset, rime
        initial, final = initial_and_final(syllable)
        return self.variants.get(initial, onset), self.variants.get(final, rime)

    def weights(self) -> dict[str, Float32Array]:
        """Return the weights of each shape, shape (n_movestates,), 1 for the whole movement."""
        return dict(zip(self.mouth.shapes, self.mouth.shape_weights(), strict=True))


def load_pinyin_table(path: str | os.PathLike[str] = USUAL_PINYIN_TABLE) -> PinyinTable:
    """Load a pinyin table from a file; the one that ships, unless told otherwise.

    Raises
    ------
    MouthError : it cannot be read, or says something impossible; the message names the file and the entry.
    """
    return load_text(path, "a pinyin table (.toml)", MouthError, pinyin_table_of)


@lru_cache(maxsize=4)
def pinyin_table_of(text: str) -> PinyinTable:
    """Read a pinyin table from the text of a TOML file.

    Raises
    ------
    MouthError : not TOML, not of this format, an unknown or missing name, or a value out of range.
    """
    top = parse_toml(text, "a pinyin table", FORMAT, MouthError)
    top.check_keys(_REQUIRED, _OPTIONAL)
    mouth = _mouth_of(top)
    onsets = _letters_by_part(top.table("onsets"), INITIALS, mouth.shapes)
    rimes = _letters_by_part(top.table("rimes"), FINALS, mouth.shapes)
    weights, marks, transition = top.table("weights"), top.table("marks"), top.table("transition")
    transition.check_keys(("reach",), ("spring", *_SPRING))
    return PinyinTable(
        mouth=mouth,
        onsets=onsets,
        rimes=rimes,
        syllables=_syllables_of(top.table("syllables"), mouth.shapes),
        variants=_parts_of(top.table("variants"), (*INITIALS, *FINALS), mouth.shapes),
        onset_shares=_onset_shares_of(weights, mouth.shapes),
        variation=weights.limited("variation", 0, 1, "a share in 0..1", 0.0),
        marks=_marks_of(marks),
        pause=marks.limited("syllables", 0, MOST_SYLLABLES, f"a number of syllables in 0..{MOST_SYLLABLES:g}"),
        reach=transition.limited("reach", 0.05, 1, "a share in 0.05..1"),
        spring=_spring_of(transition),
        doubts=_doubts_of(top.table("doubtful")),
    )


def _mouth_of(top: StrictTable) -> MouthTable:
    """Return the shapes as a mouth table, by which any face moves."""
    movestates = movestates_of(top)
    shapes = shapes_in(top, movestates)
    if REST not in shapes:
        raise MouthError(f'[shapes] lacks {REST}, the mouth at rest; add [shapes."{REST}"]')
    return MouthTable(
        name=top.value("name", str, "untitled"),
        movestates=movestates,
        phonemes=shapes_of_phonemes(top.table("phonemes"), shapes),
        shapes=shapes,
        times=dict.fromkeys(SPEAKING, TransitionTimes(USUAL_TIMES["attack"], USUAL_TIMES["release"])),
        notes=top.value("notes", str, ""),
    )


def _letters_by_part(table: StrictTable, parts: Collection[str], shapes: Collection[str]) -> dict[str, str]:
    """Return the letter of each initial, or of each final; every one must have one."""
    for letter in table.entries:
        if len(letter) != 1:
            raise MouthError(f"{table.name} has {shown(letter)}, which is no letter; give it a single character")
    letters = _parts_of(table, parts, shapes)
    for part in parts:
        if part not in letters:
            raise MouthError(f"{table.name} lacks {part!r}; add it to the list of one of its letters")
    return letters


def _parts_of(table: StrictTable, parts: Collection[str], shapes: Collection[str]) -> dict[str, str]:
    """Return the shape of initials and finals, which stand in lists under its name."""
    found: dict[str, str] = {}
    for shape in table.entries:
        shape_named(table.name, shape, shapes)
        for part in table.value(shape, list):
            if not isinstance(part, str) or part not in parts:
                words = remedy(str(part), parts)
                raise MouthError(f"{table.name} {shape} names {shown(part)}, which does not exist; {words}")
            if part in found:
                raise MouthError(f"{table.name} names {part!r} twice; remove one")
            found[part] = shape
    return found


def _syllables_of(table: StrictTable, shapes: Collection[str]) -> dict[str, str]:
    for syllable in table.entries:
        _check_syllable(table, syllable)
        letters = table.value(syllable, str)
        if len(letters) != 2 or not set(letters) <= set(shapes):
            raise table.refusal(syllable, "two letters that [shapes] has", letters)
    return dict(table.entries)


def _check_syllable(table: StrictTable, syllable: str) -> None:
    try:
        known = sound_of(syllable)[:-1] == syllable
    except ValueError:
        known = False
    if not known:
        raise MouthError(f"{table.name} names {shown(syllable)}, which is no syllable without tone; correct it")


def _onset_shares_of(table: StrictTable, shapes: Collection[str]) -> dict[str, float]:
    letters = [shape for shape in shapes if len(shape) == 1]
    table.check_keys(("ws",), ("variation", *letters))
    what = f"a share in {LEAST_SHARE:g}..{MOST_SHARE:g}"
    usual = table.limited("ws", LEAST_SHARE, MOST_SHARE, what)
    return {letter: table.limited(letter, LEAST_SHARE, MOST_SHARE, what, usual) for letter in letters}


def _marks_of(table: StrictTable) -> dict[str, float]:
    marks = [mark for mark in table.entries if mark != "syllables"]
    for mark in marks:
        if len(mark) != 1 or mark.isalnum() or mark.isspace():
            raise MouthError(f"[marks] names {shown(mark)}, which is no punctuation mark; remove it")
    table.check_keys(("syllables",), marks)
    return {mark: table.limited(mark, 0, 1, "a weight in 0..1") for mark in marks}


def _spring_of(table: StrictTable) -> Spring | None:
    numbers = {key: table.limited(key, 0, LARGEST, f"a number in 0..{LARGEST:g}") for key in _SPRING if key in table}
    spring = Spring(**numbers)
    return spring if table.value("spring", bool, False) else None


def _doubts_of(table: StrictTable) -> dict[str, str]:
    for syllable in table.entries:
        _check_syllable(table, syllable)
    return {syllable: table.value(syllable, str) for syllable in table.entries}
