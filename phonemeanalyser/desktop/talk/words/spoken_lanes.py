"""What is said when, as lanes: words, syllables or letters, phones, and the units of a recorded face."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtGui import QColor

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.words.felt_text import FeltSpan
from phonemeanalyser.desktop.talk.words.sound_words import fits_badly
from phonemeanalyser.desktop.talk.words.text_model import TextModel
from phonemeanalyser.desktop.theme import PHONEME_COLOURS
from phonemeanalyser.desktop.widgets.lanes import Lane
from phonemeengine.arrays import UInt32Array
from phonemeengine.labels.utterance import UNKNOWN_WORD, Utterance, Word
from phonemeengine.labels.utterance_files import ipa_of_syllable
from phonemeengine.performance.driver import UsedUnit
from phonemeengine.performance.units import UnitKind
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.timing import PlanKind, PlanRow
from phonemeengine.speech.pinyin.track import PinyinTrack

NAMES = (tr_noop("Words"), tr_noop("Syllables"), tr_noop("Phones"))
LETTERS, PERFORMED = tr_noop("Letters"), tr_noop("Units")
WORD_COLOUR, SYLLABLE_COLOUR, RIME_COLOUR = "#3d5a80", "#5c677d", "#7a8499"
"""Dark enough for white letters, in both looks."""
UNIT_COLOURS = {
    UnitKind.CLIP: "#0f5c70",
    UnitKind.SENTENCE: "#155e63",
    UnitKind.WORDS: "#17665a",
    UnitKind.WORD: "#1b6e53",
    UnitKind.SYLLABLE: "#2f7f3c",
    UnitKind.VOWEL_TRIPHONE: "#2b6cb0",
    UnitKind.CONSONANT_TRIPHONE: "#4f5bb5",
    UnitKind.BOUNDARY_TRIPHONE: "#6b4fa8",
    UnitKind.DIPHONE: "#a35a1c",
    UnitKind.BOUNDARY_DIPHONE: "#8a6d1a",
    UnitKind.RIGHT_HALF: "#9c3d54",
    UnitKind.LEFT_HALF: "#7d3a6e",
}
"""Of the sets, from the longest units to the shortest."""
FELT_NAME, FEELING_COLOUR = tr_noop("Feeling"), "#8a4b7d"
FELT = tr_noop(
    "What the text says of feeling. Double-click to change it (such as smile 0.6; nothing deletes it), or where "
    "there is none to add one; drag an end to move it. Edits are directions in the text."
)
HEARD = tr_noop("Click to play the original with its face, double-click for the whole recording.")
SHADE = 130
"""By how much the colours of phonemes are darker here, %, so that letters are read on them."""


def spoken_lanes(texts: TextModel) -> list[Lane]:
    """Return the lanes of what is said in the current sound, none of which can be moved; none where it is unknown.

    Where a file of phones names no words, there are no lanes of words and syllables, which would be guesses.
    """
    if texts.utterance is None:
        return []
    units = in_a_row(texts.drivers.performance.units)
    lanes = lanes_of(texts.utterance, texts.drivers.letters, movable=False)
    if not any(word.text for word in texts.utterance.words):
        del lanes[:2]
    return [lane for lane in (*lanes, *([lane_of_units(units)] if units else [])) if len(lane.starts)]


def lanes_of(utterance: Utterance, letters: PinyinTrack | None, *, movable: bool) -> list[Lane]:
    """Return the lanes of an utterance, from above; letters of pinyin, where there are any, instead of syllables."""
    words = utterance.words
    bad = frozenset(k for k, word in enumerate(words) if fits_badly(word))
    phones = list(utterance.phones)
    texts = [phone.ipa or sound_name(phone.phoneme) for phone in phones]
    return [
        _lane(NAMES[0], words, list(map(_shown, words)), [WORD_COLOUR] * len(words), bad, movable=movable),
        _lane_of_syllables(utterance, movable=movable) if letters is None else _lane_of_letters(letters),
        _lane(NAMES[2], phones, texts, [_colour_of(phone.phoneme) for phone in phones], movable=movable),
    ]


def _lane_of_syllables(utterance: Utterance, *, movable: bool) -> Lane:
    syllables = [syllable for word in utterance.words for syllable in word.syllables]
    texts = [syllable.text or ipa_of_syllable(syllable) for syllable in syllables]
    return _lane(NAMES[1], syllables, texts, [SYLLABLE_COLOUR] * len(syllables), movable=movable)


def _lane_of_letters(letters: PinyinTrack) -> Lane:
    rows = [row for row in letters.plan.rows if row.kind is PlanKind.SYLLABLE]
    parts = [part for row in rows for part in _parts_of(row)]
    starts, ends = (np.array([part[k] for part in parts]) for k in (0, 1))
    colours = [SYLLABLE_COLOUR if part[3] else RIME_COLOUR for part in parts]
    return Lane(tr(LETTERS), starts, ends, [part[2] for part in parts], _rgb(colours))


def in_a_row(units: Sequence[UsedUnit]) -> list[UsedUnit]:
    """Return units without those that later ones hide: two sentences meet in a pause that both have."""
    row: list[UsedUnit] = []
    for unit in units:
        while row and row[-1].start >= unit.start:
            row.pop()
        row.append(unit)
    return row


def lane_of_units(units: Sequence[UsedUnit]) -> Lane:
    """Return the lane of the units of a recorded face, which follow each other; see `in_a_row`."""
    starts = np.array([unit.start for unit in units])
    ends = np.minimum([unit.end for unit in units], np.append(starts[1:], np.inf))
    colours = _rgb([UNIT_COLOURS[unit.kind] for unit in units])
    return Lane(
        tr(PERFORMED), starts, ends, [" ".join(unit.names) for unit in units], colours, tips=list(map(_tip_of, units))
    )


def lane_of_feelings(spans: Sequence[FeltSpan]) -> Lane:
    """Return the lane of what the text says of feeling; what no direction says is hatched."""
    starts, ends = (np.array([getattr(span, edge) for span in spans], float) for edge in ("start", "end"))
    texts = [", ".join(_felt(part) for part in span.words.split(", ")) for span in spans]
    guessed = frozenset(k for k, span in enumerate(spans) if not span.directed)
    colours = _rgb([FEELING_COLOUR] * len(spans))
    tips = [f"{text}. {tr(FELT)}" for text in texts]
    return Lane(tr(FELT_NAME), starts, ends, texts, colours, frozenset(), True, tips, doubtful=guessed)


def _felt(part: str) -> str:
    name, _, share = part.partition(" ")
    return f"{tr(name)} {100 * float(share):.0f} %"


def _tip_of(unit: UsedUnit) -> str:
    source = tr("{kind} [{names}] from {recording}, {start:.2f} to {end:.2f} s.").format(
        kind=tr(unit.kind.value),
        names=" ".join(unit.names),
        recording=unit.recording,
        start=unit.source_start,
        end=unit.source_end,
    )
    return f"{source} {tr(HEARD)}"


def _parts_of(row: PlanRow) -> list[tuple[float, float, str, bool]]:
    """Return start, end and letter of both parts of a syllable, and whether it is the onset."""
    parts = [(row.start, row.turn, row.letters[0], True), (row.turn, row.end, row.letters[1], False)]
    return [part for part in parts if part[1] > part[0]]


def _lane(
    name: str,
    spans: Sequence[object],
    texts: Sequence[str],
    colours: Sequence[str],
    marked: frozenset[int] = frozenset(),
    *,
    movable: bool,
) -> Lane:
    starts, ends = (np.array([getattr(span, edge) for span in spans], float) for edge in ("start", "end"))
    return Lane(tr(name), starts, ends, texts, _rgb(colours), marked, movable)


def _rgb(colours: Sequence[str]) -> UInt32Array:
    return np.array([QColor(colour).rgb() for colour in colours], np.uint32)


def _shown(word: Word) -> str:
    """Return a word as people read it."""
    return "?" if word.text == UNKNOWN_WORD else word.text


def _colour_of(phoneme: Phoneme) -> str:
    return QColor(PHONEME_COLOURS[phoneme]).darker(SHADE).name()
