"""The labels of the current file, tier by tier: loaded, edited, saved, and compared with what is recognised."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.session.undo import UndoableEdit
from phonemeanalyser.desktop.settings import outside_program
from phonemeengine.arrays import IndexArray
from phonemeengine.calibration.scores.corpus import FrameLabels, frame_labels_of
from phonemeengine.calibration.scores.scoring import LabelError, error_spans, label_errors
from phonemeengine.errors import CorpusError, EngineError, UnknownPhonemeError
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.labels.files import known_labels, phoneme_tier_of
from phonemeengine.labels.phone_sets import PhonemeMap
from phonemeengine.labels.textgrid import Tier
from phonemeengine.labels.tiers import (
    check_room,
    deleted,
    gap_at,
    inserted,
    kept_in,
    labels_beside,
    lost_in,
    merged,
    moved,
    read_tiers,
    renamed,
    split,
    write_tiers,
)
from phonemeengine.labels.utterance import CORE, ROUNDING, Label
from phonemeengine.storage.files import printable_name

MOST_SHOWN = 3
"""Tiers that are shown of a file at first: more leave the sonagram little room."""
FIRST_TIER = "phonemes"
"""The tier of labels that begin with nothing."""


class ChosenLabel(NamedTuple):
    """A label: the number of its tier, and its own in that."""

    tier: int
    label: int


class Boundary(NamedTuple):
    """The start or the end of a label."""

    label: ChosenLabel
    is_end: bool


class LabelState(NamedTuple):
    """What can be undone.

    Attributes
    ----------
    tiers : all of them.
    shown : numbers of those that are shown.
    said : number of the tier that says which phonemes are said; None where none does.
    """

    tiers: tuple[Tier, ...] = ()
    shown: tuple[int, ...] = ()
    said: int | None = None


class LabelTiers(QObject):
    """Holds the labels of one sound; changes can be undone.

    Parameters
    ----------
    undo_stack : of the whole program.

    Signals
    -------
    changed : labels, or what is shown of them, are others.
    info, error : a sentence for the user.

    Attributes
    ----------
    path : the label file; None while there is none.
    state : the tiers, and what is shown of them.
    chosen : the label that the user chose; None for none.
    duration : of the sound, seconds.
    opened : another number for each sound and open label file.
    """

    changed = Signal()
    info = Signal(str)
    error = Signal(str)

    def __init__(self, undo_stack: QUndoStack) -> None:
        super().__init__()
        self.path: Path | None = None
        self.state = LabelState()
        self.chosen: ChosenLabel | None = None
        self.opened = 0
        self.duration = 0.0
        self._undo_stack = undo_stack
        self._saved: tuple[Tier, ...] = ()
        self._said: tuple[LabelState, FrameLabels | None] = LabelState(), None
        self._errors: tuple[tuple[object, ...], list[LabelError]] = (), []
        self._n_moves = 0
        self._together: list[Boundary] = []
        self._tier_chosen: int | None = None

    @property
    def tiers(self) -> tuple[Tier, ...]:
        """All of them."""
        return self.state.tiers

    @property
    def tier_in_use(self) -> int | None:
        """Number of the tier that is edited: that of the label chosen last, or else the one that is compared."""
        shown = self.state.shown
        if self._tier_chosen in shown:
            return self._tier_chosen
        return self.state.said if self.state.said in shown else next(iter(shown), None)

    # -- files --------------------------------------------------------------------------------------------

    @property
    def has_unsaved_changes(self) -> bool:
        """Whether the labels are not as they are in their file."""
        return self.tiers != self._saved

    def follow(self, sound: Path | None, duration: float) -> None:
        """Take the labels beside another sound, if there are any; they are refused with one sentence."""
        self._take(None, (), duration)
        found = None if sound is None else labels_beside(outside_program(sound)) or labels_beside(sound)
        if found is not None:
            self.load(found)

    def load(self, path: Path) -> bool:
        """Load a label file for the current sound; what cannot be used leaves the labels as they were."""
        try:
            tiers = read_tiers(path, duration=self.duration)
        except EngineError as error:
            self.error.emit(str(error))
            return False
        self._take(path, tiers, self.duration)
        return True

    def save(self, path: Path) -> bool:
        """Save all tiers, or what the format can hold of them, as a copy; says whether that went well."""
        lost = self.lost_in(path)
        try:
            write_tiers(kept_in(self.tiers, self.tier_in_use or 0, path), path, duration=self.duration)
        except EngineError as error:
            self.error.emit(str(error))
            return False
        if lost:
            words = tr("Copy saved as {path}, without {lost}: the format can't store that. A TextGrid keeps all.")
            self.info.emit(words.format(path=path, lost=", ".join(lost)))
            return True
        self.path, self._saved = path, self.tiers
        self.info.emit(tr("Labels saved as {path}").format(path=path))
        self.changed.emit()
        return True

    def lost_in(self, path: Path) -> tuple[str, ...]:
        """Return the names of what a label file of such a name would not keep."""
        return lost_in(self.tiers, self.tier_in_use or 0, path) if self.tiers else ()

    def _take(self, path: Path | None, tiers: tuple[Tier, ...], duration: float) -> None:
        self.opened += 1
        self._tier_chosen = None
        self.path, self.duration, self._saved = path, duration, tiers
        filled = [tier for tier in tiers if tier.raw_labels and not tier.points]
        judged = [tier for tier in filled if any(raw.certainty for raw in tier.raw_labels)]
        best = phoneme_tier_of(judged or filled, PhonemeMap()) if filled else None
        said = next((k for k, tier in enumerate(tiers) if tier is best), None)
        others = [k for k, tier in enumerate(tiers) if tier.raw_labels and k != said][: MOST_SHOWN - 1]
        self.put(LabelState(tiers, tuple(sorted([*others, *([] if said is None else [said])])), said))

    # -- what is shown ------------------------------------------------------------------------------------

    def show(self, shown: Sequence[int], said: int | None) -> None:
        """Show other tiers, and compare another one with what is recognised."""
        self.put(LabelState(self.tiers, tuple(shown), said))

    def choose(self, label: ChosenLabel | None) -> None:
        """Choose the label that is renamed or deleted."""
        if label != self.chosen:
            self.chosen = label
            self._tier_chosen = self._tier_chosen if label is None else label.tier
            self.changed.emit()

    def choose_beside(self, seconds: float, step: int) -> ChosenLabel | None:
        """Choose the next label of the tier in use (`step` 1), or the one before (-1), and return it.

        Without a chosen one, that is the label at a time, or the nearest in that direction.
        """
        tier, at = self.tier_in_use, self.chosen
        labels = () if tier is None else self.tiers[tier].raw_labels
        if tier is None or not labels:
            return None
        if at is not None:
            k = at.label + step
        elif (here := self.label_at(tier, seconds)) is not None:
            k = here.label
        else:
            after = sum(raw.start <= seconds for raw in labels)
            k = after if step > 0 else after - 1
        self.choose(ChosenLabel(tier, min(max(k, 0), len(labels) - 1)))
        return self.chosen

    def choose_tier(self, seconds: float, step: int) -> ChosenLabel | None:
        """Choose the label at a time in the tier that is shown below the one in use (`step` 1), or above it (-1)."""
        shown = self.state.shown
        if self.tier_in_use is None:
            return None
        if self.chosen is not None:
            seconds = sum(self.span_of(self.chosen)) / 2
        self._tier_chosen = shown[min(max(shown.index(self.tier_in_use) + step, 0), len(shown) - 1)]
        self.chosen = self.label_at(self._tier_chosen, seconds)
        self.changed.emit()
        return self.chosen

    def in_hand(self, seconds: float) -> ChosenLabel | None:
        """Return the chosen label; without one, that of the tier in use at a time."""
        if self.chosen is not None or self.tier_in_use is None:
            return self.chosen
        return self.label_at(self.tier_in_use, seconds)

    def label_at(self, tier: int, seconds: float) -> ChosenLabel | None:
        """Return the label of a tier at a time."""
        for k, raw in enumerate(self.tiers[tier].raw_labels):
            if raw.start <= seconds < max(raw.end, raw.start + 1e-6):
                return ChosenLabel(tier, k)
        return None

    def name_of(self, label: ChosenLabel) -> str:
        """Return what a label says."""
        return self.tiers[label.tier].raw_labels[label.label].name

    def span_of(self, label: ChosenLabel) -> TimeSpan:
        """Return from when to when a label is."""
        raw = self.tiers[label.tier].raw_labels[label.label]
        return TimeSpan(raw.start, raw.end)

    # -- said and recognised ------------------------------------------------------------------------------

    def said_frames(self) -> FrameLabels | None:
        """Return what is said in each frame, as far as names are phonemes; None where it is unknown."""
        if self._said[0] is not self.state:  # an hour of labels takes long to compare
            self._said = self.state, self._find_said()
        return self._said[1]

    def said_labels(self) -> tuple[Label, ...]:
        """Return the labels that say which phonemes are said; none where that is unknown."""
        if self.state.said is None:
            return ()
        name = printable_name(self.path) if self.path else FIRST_TIER
        try:
            return known_labels(self.tiers[self.state.said].raw_labels, PhonemeMap(), name)
        except UnknownPhonemeError:
            return ()

    def doubts(self, number: int) -> dict[int, str]:
        """Return which labels of a tier are in doubt, and how: ``ambiguous``, ``diphthong``, ..."""
        raws = self.tiers[number].raw_labels
        said = {label.start: label.certainty for label in self.said_labels()} if number == self.state.said else {}
        found = {k: said.get(raw.start, raw.certainty) for k, raw in enumerate(raws)}
        return {k: certainty for k, certainty in found.items() if certainty not in {None, CORE}}

    def _find_said(self) -> FrameLabels | None:
        labels = self.said_labels()
        return frame_labels_of(labels) if labels else None

    def errors(self, tracks: SoundTracks) -> list[LabelError]:
        """Return where something else was recognised than is said, in order of time."""
        said = self.said_frames()
        asked = (id(said), id(tracks), tracks.revision)
        if self._errors[0] != asked:
            self._errors = asked, [] if said is None else label_errors(_known_of(said, tracks), tracks.phonemes)
        return self._errors[1]

    def error_spans(self, tracks: SoundTracks) -> IndexArray:
        """Return the frames of the same errors, as `phonemeengine.calibration.scores.scoring.error_spans` does."""
        said = self.said_frames()
        if said is None:
            return np.zeros((0, 2), np.intp)
        return error_spans(_known_of(said, tracks), tracks.phonemes)

    def next_error(self, tracks: SoundTracks, position: float, *, back: bool = False) -> LabelError | None:
        """Return the first error after a time, or the last one before it; None without one."""
        found = self.errors(tracks)
        if back:
            return next((e for e in reversed(found) if e.start < position - 1e-6), None)
        return next((e for e in found if e.start > position + 1e-6), None)

    # -- changes ------------------------------------------------------------------------------------------

    def begin_move(self, boundary: Boundary, *, alone: bool = False) -> None:
        """Move a boundary from now on, to be undone by itself.

        Boundaries of other tiers that are shown move along where they lie at the same time, unless it moves `alone`.
        """
        self._n_moves += 1
        self._together = [boundary, *(() if alone else self._others_at(boundary))]

    def move(self, seconds: float) -> None:
        """Move the boundary, and those that move along, as far as all of them can; undone at once."""
        here = self._time_of(self._together[0])
        reached = (self._time_of(edge, self._moved(edge, seconds)) for edge in self._together)
        place = min(reached, key=lambda time: abs(time - here))
        tiers = list(self.tiers)
        for edge in self._together:
            tiers[edge.label.tier] = self._moved(edge, place)
        self._push(self.state._replace(tiers=tuple(tiers)), tr("move boundary"), (self._together[0], self._n_moves))

    def _moved(self, edge: Boundary, seconds: float) -> Tier:
        return moved(self.tiers[edge.label.tier], edge.label.label, end=edge.is_end, seconds=seconds)

    def _time_of(self, edge: Boundary, tier: Tier | None = None) -> float:
        raw = (tier or self.tiers[edge.label.tier]).raw_labels[edge.label.label]
        return raw.end if edge.is_end else raw.start

    def _others_at(self, boundary: Boundary) -> list[Boundary]:
        here = self._time_of(boundary)
        found = {}  # one of each tier: the label that touches it there moves along
        for tier in self.state.shown:
            if tier != boundary.label.tier and not self.tiers[tier].points:
                for k, raw in enumerate(self.tiers[tier].raw_labels):
                    if min(abs(raw.start - here), abs(raw.end - here)) <= ROUNDING:
                        found[tier] = Boundary(ChosenLabel(tier, k), abs(raw.end - here) <= ROUNDING)
        return list(found.values())

    def set_edge(self, seconds: float, *, end: bool) -> None:
        """Let the chosen label begin or end at a time."""
        if self.chosen is None:
            self.error.emit(tr("No label is selected. Click one below the sonagram first."))
            return
        chosen = self.chosen
        self.begin_move(Boundary(chosen, end))
        self.move(seconds)
        self.choose(chosen)

    def split(self, seconds: float) -> None:
        """Split the label of the tier in use at a time; the second part is chosen then, to be renamed."""
        tier = self.tier_in_use
        label = None if tier is None else self.label_at(tier, seconds)
        if label is None:
            self.error.emit(tr("There is no label to split at the cursor. Click into one below the sonagram first."))
            return
        tiers, (number, k) = self.tiers, label
        if self._try(tr("split label"), lambda: self._with(number, split(tiers[number], k, seconds))):
            self.choose(ChosenLabel(number, k + 1))

    def merge(self, label: ChosenLabel, *, back: bool = False) -> None:
        """Let a label reach over the next one, too, or over the one before; it keeps its name."""
        other = label.label + (-1 if back else 1)
        what = tr("merge labels")
        if self._try(what, lambda: self._with(label.tier, merged(self.tiers[label.tier], label.label, other))):
            self.choose(ChosenLabel(label.tier, min(label.label, other)))

    def gap_at(self, seconds: float) -> TimeSpan:
        """Return from when to when the tier in use labels nothing around a time."""
        tier = None if self.tier_in_use is None else self.tiers[self.tier_in_use]
        return TimeSpan(*gap_at(tier, seconds, self.duration))

    def has_room(self, span: TimeSpan) -> bool:
        """Say whether a label can be inserted into the tier in use; if not, one sentence tells why."""
        try:
            check_room(Tier(FIRST_TIER, ()) if self.tier_in_use is None else self.tiers[self.tier_in_use], *span)
        except CorpusError as error:
            self.error.emit(str(error))
            return False
        return True

    def rename(self, label: ChosenLabel, name: str) -> None:
        """Have a label say something else."""
        self._try(
            tr("rename label"), lambda: self._with(label.tier, renamed(self.tiers[label.tier], label.label, name))
        )

    def insert(self, tier: int | None, start: float, end: float, name: str) -> None:
        """Insert a label into a tier, or into a new one where there is none."""

        def act() -> LabelState:
            if tier is not None:
                return self._with(tier, inserted(self.tiers[tier], start, end, name))
            n = len(self.tiers)
            first = inserted(Tier(FIRST_TIER, ()), start, end, name)
            return LabelState((*self.tiers, first), (*self.state.shown, n), n)

        self._try(tr("insert label"), act)

    def delete(self, label: ChosenLabel) -> None:
        """Delete a label."""
        self._push(self._with(label.tier, deleted(self.tiers[label.tier], label.label)), tr("delete label"))

    def put(self, state: LabelState) -> None:
        """Say this of the sound; that cannot be undone."""
        self.state = state
        self.chosen = None
        self.changed.emit()

    def _with(self, number: int, tier: Tier) -> LabelState:
        return self.state._replace(tiers=(*self.tiers[:number], tier, *self.tiers[number + 1 :]))

    def _try(self, what: str, act: Callable[[], LabelState]) -> bool:
        try:
            state = act()
        except CorpusError as error:
            self.error.emit(str(error))
            return False
        self._push(state, what)
        return True

    def _push(self, state: LabelState, what: str, moves: tuple[object, ...] | None = None) -> None:
        if state != self.state:
            self._undo_stack.push(UndoableEdit(what, self.put, self.state, state, lambda: self.opened, moves))


def _known_of(said: FrameLabels, tracks: SoundTracks) -> FrameLabels:
    """Return labels that are certain of nothing where the phonemes are not known yet."""
    known = tracks.states[: len(said.phonemes)] != FrameState.UNKNOWN
    labels = said.at(slice(len(known)))
    return replace(labels, certain=labels.certain & known)
