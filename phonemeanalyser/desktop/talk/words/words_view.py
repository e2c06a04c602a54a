"""What is said when, below the head: lanes of words, syllables or letters, and phones."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtGui import QColor

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.talk.words.sound_words import fits_badly
from phonemeanalyser.desktop.talk.words.text_model import TextModel
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.lanes import Lane
from phonemeanalyser.desktop.widgets.plot_menu import PlotMenu, table_of
from phonemeanalyser.desktop.widgets.timeline import Chapter, Timeline, TimelineView
from phonemeengine.arrays import UInt32Array
from phonemeengine.labels.utterance import UNKNOWN_WORD, LabelUnit, Utterance, Word
from phonemeengine.performance.driver import UsedUnit
from phonemeengine.performance.units import UnitKind
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.timing import PlanKind, PlanRow
from phonemeengine.speech.pinyin.track import PinyinTrack

NAMES = (tr_noop("Words"), tr_noop("Syllables"), tr_noop("Phones"))
LETTERS, PERFORMED = tr_noop("Letters"), tr_noop("Units")
UNITS = (LabelUnit.WORD, LabelUnit.SYLLABLE, LabelUnit.PHONE)
WORD_COLOUR, SYLLABLE_COLOUR, RIME_COLOUR = "#3d5a80", "#5c677d", "#7a8499"
"""Dark enough for white letters, in both looks."""
UNIT_COLOURS = {
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
HEARD = tr_noop("Click to play the original with its face, double-click for the whole recording.")
SEEN = 4.0
"""Seconds of a longer sound that are seen at first."""
SHADE = 130
"""By how much the colours of phonemes are darker here, %, so that letters are read on them."""


class WordsTimeline(TimelineView):
    """The lanes of what is said in the current sound, its waveform and its times, with their scroll bar.

    A click plays a word, a syllable or a phone, or what a unit of a recorded face was taken from, and a double click
    all of its recording; a boundary can be dragged.
    """

    def __init__(self, texts: TextModel, theme: Theme) -> None:
        super().__init__(
            Timeline(theme, lambda axis: texts.outline_in(TimeSpan(axis.start, axis.end), round(axis.width)))
        )
        self._texts = texts
        self._shown: tuple[object, ...] = ()
        self._units: list[UsedUnit] = []
        self.menu = PlotMenu(self.lanes, "what is said", lambda _at: table_of(self._columns()), self.show_whole)
        self.setAccessibleName(tr("Words and phones over time"))
        self.span_clicked.connect(self._play)
        self.span_double_clicked.connect(self._play_recording)
        self.boundary_moved.connect(self._move)
        texts.changed.connect(self.show_words)
        self.show_words()

    def show_words(self) -> None:
        """Show what is known now."""
        texts = self._texts
        letters, units = texts.drivers.letters, texts.drivers.performance.units
        known = (texts.utterance, letters, units, texts.editable)
        if self._shown and all(one is other for one, other in zip(known, self._shown, strict=True)):
            self.lanes.drag.release()
            self.lanes.update()
            return
        self._shown = known
        utterance = texts.utterance
        if utterance is None:
            self.show_lanes([Lane(tr(name)) for name in NAMES], 0.0)
        else:
            lanes = lanes_of(utterance, letters, movable=texts.editable)
            self._units = _in_a_row(units)
            lanes += [_lane_of_units(self._units)] if units else []
            if utterance.duration != self.lanes.duration:
                self.fill(min(utterance.duration, SEEN))
            self.show_lanes(lanes, utterance.duration, [Chapter(0.0, texts.summary)])

    def show_position(self, seconds: float) -> None:
        """Show which time is playing; a view that was scrolled by hand stays until that is another one."""
        heard = None if self._texts.utterance is None else seconds
        if heard != self.lanes.playhead:
            self.show_playhead(heard)

    def _play(self, number: int, span: int) -> None:
        lane = self.lanes.lanes[number]
        if lane.name == tr(PERFORMED):
            self._texts.play_original(self._units[span])
        else:
            self._texts.play(float(lane.starts[span]), float(lane.ends[span]))

    def _play_recording(self, number: int, span: int) -> None:
        if self.lanes.lanes[number].name == tr(PERFORMED):
            self._texts.play_original(self._units[span], whole=True)

    def _move(self, number: int, boundary: int, seconds: float) -> None:
        self._texts.move_boundary(UNITS[number], boundary, seconds)

    def _columns(self) -> dict[str, Sequence[object]]:
        """Return the phones as columns, each under its name and unit."""
        utterance = self._texts.utterance
        if utterance is None:
            return {}
        rows = [(word, phone) for word in utterance.words for phone in word.phones]
        return {
            "start (s)": [phone.start for _, phone in rows],
            "end (s)": [phone.end for _, phone in rows],
            "word": [word.text for word, _ in rows],
            "phone": [phone.ipa for _, phone in rows],
            "phoneme": [phone.phoneme.label for _, phone in rows],
            "score": ["" if phone.score is None else phone.score for _, phone in rows],
        }


def spoken_lanes(texts: TextModel) -> list[Lane]:
    """Return the lanes of what is said in the current sound, none of which can be moved; none where it is unknown."""
    if texts.utterance is None:
        return []
    units = _in_a_row(texts.drivers.performance.units)
    lanes = lanes_of(texts.utterance, texts.drivers.letters, movable=False)
    return [lane for lane in (*lanes, *([_lane_of_units(units)] if units else [])) if len(lane.starts)]


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
    texts = [syllable.text or "".join(phone.ipa for phone in syllable.phones) for syllable in syllables]
    return _lane(NAMES[1], syllables, texts, [SYLLABLE_COLOUR] * len(syllables), movable=movable)


def _lane_of_letters(letters: PinyinTrack) -> Lane:
    rows = [row for row in letters.plan.rows if row.kind is PlanKind.SYLLABLE]
    parts = [part for row in rows for part in _parts_of(row)]
    starts, ends = (np.array([part[k] for part in parts]) for k in (0, 1))
    colours = [SYLLABLE_COLOUR if part[3] else RIME_COLOUR for part in parts]
    return Lane(tr(LETTERS), starts, ends, [part[2] for part in parts], _rgb(colours))


def _in_a_row(units: Sequence[UsedUnit]) -> list[UsedUnit]:
    """Return units without those that later ones hide: two sentences meet in a pause that both have."""
    row: list[UsedUnit] = []
    for unit in units:
        while row and row[-1].start >= unit.start:
            row.pop()
        row.append(unit)
    return row


def _lane_of_units(units: Sequence[UsedUnit]) -> Lane:
    starts = np.array([unit.start for unit in units])
    ends = np.minimum([unit.end for unit in units], np.append(starts[1:], np.inf))
    colours = _rgb([UNIT_COLOURS[unit.kind] for unit in units])
    return Lane(
        tr(PERFORMED), starts, ends, [" ".join(unit.names) for unit in units], colours, tips=list(map(_tip_of, units))
    )


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
