"""The labels of the file in hand, tier by tier: loaded, edited, saved, and compared with what is recognised."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from phonemeanalyser.desktop.language import tr
from phonemeengine.calibration.scores.confusion import LabelError, label_errors
from phonemeengine.calibration.scores.corpus import FrameLabels, frame_labels_of
from phonemeengine.errors import CorpusError, EngineError, UnknownPhonemeError
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.labels.files import known_labels, phoneme_tier_of
from phonemeengine.labels.phoneme_map import PhonemeMap
from phonemeengine.labels.textgrid import Tier
from phonemeengine.labels.tiers import (
    columns_lost,
    deleted,
    inserted,
    labels_beside,
    moved,
    read_tiers,
    renamed,
    write_tiers,
)
from phonemeengine.storage.files import printable_name

MOST_SHOWN = 3
"""Tiers that are shown of a file at first: more leave the sonagram little room."""
ID_OF_MOVES = 1
"""Of all undo commands that move boundaries."""
FIRST_TIER = "phonemes"
"""The tier of labels that begin with nothing."""


class ChosenLabel(NamedTuple):
    """A label: the number of its tier, and its own in that."""

    tier: int
    label: int


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


class LabelsEdit(QUndoCommand):
    """Other labels of a sound; of no use once another sound, or another label file, is in hand.

    Parameters
    ----------
    what : the change in words, for the Edit menu.
    moves : the boundary that it moves; another command that moves the same one continues it.
    """

    def __init__(self, labels: "LabelTiers", after: LabelState, what: str, moves: tuple[object, ...] | None) -> None:
        super().__init__(what)
        self._labels, self._opened = labels, labels.opened
        self._before, self._after = labels.state, after
        self._moves = moves

    def id(self) -> int:
        """Return what commands have in common that may continue each other."""
        return ID_OF_MOVES if self._moves is not None else -1

    def mergeWith(self, other: QUndoCommand) -> bool:
        """Go on with a boundary that is still being moved."""
        if not isinstance(other, LabelsEdit) or (other._moves, other._opened) != (self._moves, self._opened):
            return False
        self._after = other._after
        return True

    def redo(self) -> None:
        """Do it."""
        self._put(self._after)

    def undo(self) -> None:
        """Take it back."""
        self._put(self._before)

    def _put(self, state: LabelState) -> None:
        if self._labels.opened == self._opened:
            self._labels.put(state)
        else:
            self.setObsolete(True)


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
    opened : another number for each sound and label file in hand.
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

    @property
    def tiers(self) -> tuple[Tier, ...]:
        """All of them."""
        return self.state.tiers

    # -- files --------------------------------------------------------------------------------------------

    @property
    def has_unsaved_changes(self) -> bool:
        """Whether the labels are not as they are in their file."""
        return self.tiers != self._saved

    def follow(self, sound: Path | None, duration: float) -> None:
        """Take the labels beside another sound, if there are any; they are refused with one sentence."""
        self._take(None, (), duration)
        found = None if sound is None else labels_beside(sound)
        if found is not None:
            self.load(found)

    def load(self, path: Path) -> bool:
        """Load a label file for the sound in hand; what cannot be used leaves the labels as they were."""
        try:
            tiers = read_tiers(path, duration=self.duration)
        except EngineError as error:
            self.error.emit(str(error))
            return False
        self._take(path, tiers, self.duration)
        return True

    def save(self, path: Path) -> bool:
        """Save all tiers; says whether that went well."""
        try:
            write_tiers(self.tiers, path, duration=self.duration)
        except EngineError as error:
            self.error.emit(str(error))
            return False
        self.path, self._saved = path, self.tiers
        self.info.emit(tr("Saved the labels as {path}").format(path=path))
        if lost := columns_lost(self.tiers, path):
            words = tr("Saved the labels as {path}, without {columns}, which Audacity's labels do not hold.")
            self.info.emit(words.format(path=path, columns=", ".join(lost)))
        self.changed.emit()
        return True

    def _take(self, path: Path | None, tiers: tuple[Tier, ...], duration: float) -> None:
        self.opened += 1
        self.path, self.duration, self._saved = path, duration, tiers
        filled = [tier for tier in tiers if tier.raw_labels and not tier.points]
        best = phoneme_tier_of(filled, PhonemeMap()) if filled else None
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
            self.changed.emit()

    def label_at(self, tier: int, seconds: float) -> ChosenLabel | None:
        """Return the label of a tier at a time."""
        for k, raw in enumerate(self.tiers[tier].raw_labels):
            if raw.start <= seconds < max(raw.end, raw.start + 1e-6):
                return ChosenLabel(tier, k)
        return None

    # -- said and recognised ------------------------------------------------------------------------------

    def said_frames(self) -> FrameLabels | None:
        """Return what is said in each frame, as far as names are phonemes; None where nobody knows."""
        if self._said[0] != self.state:
            self._said = self.state, self._find_said()
        return self._said[1]

    def _find_said(self) -> FrameLabels | None:
        if self.state.said is None:
            return None
        name = printable_name(self.path) if self.path else FIRST_TIER
        try:
            labels = known_labels(self.tiers[self.state.said].raw_labels, PhonemeMap(), name)
        except UnknownPhonemeError:
            return None
        return frame_labels_of(labels) if labels else None

    def errors(self, tracks: SoundTracks) -> list[LabelError]:
        """Return where something else was recognised than is said, in order of time."""
        said = self.said_frames()
        asked = (id(said), id(tracks), tracks.revision)
        if self._errors[0] != asked:
            self._errors = asked, [] if said is None else label_errors(_known_of(said, tracks), tracks.phonemes)
        return self._errors[1]

    def next_error(self, tracks: SoundTracks, position: float, *, back: bool = False) -> LabelError | None:
        """Return the first error after a time, or the last one before it; None without one."""
        found = self.errors(tracks)
        if back:
            return next((e for e in reversed(found) if e.start < position - 1e-6), None)
        return next((e for e in found if e.start > position + 1e-6), None)

    # -- changes ------------------------------------------------------------------------------------------

    def begin_move(self) -> None:
        """Have what is moved from now on be undone by itself."""
        self._n_moves += 1

    def move(self, label: ChosenLabel, seconds: float, *, end: bool) -> None:
        """Move a boundary of a label; all of it until the next `begin_move` is undone at once."""
        tier = moved(self.tiers[label.tier], label.label, end=end, seconds=seconds)
        self._push(self._with(label.tier, tier), tr("move of a boundary"), (label, end, self._n_moves))
        self.choose(label)

    def rename(self, label: ChosenLabel, name: str) -> None:
        """Have a label say something else."""
        self._try(
            tr("change of a label"),
            lambda: self._with(label.tier, renamed(self.tiers[label.tier], label.label, name)),
        )

    def insert(self, tier: int | None, start: float, end: float, name: str) -> None:
        """Insert a label into a tier, or into a new one where there is none."""

        def act() -> LabelState:
            if tier is not None:
                return self._with(tier, inserted(self.tiers[tier], start, end, name))
            n = len(self.tiers)
            first = inserted(Tier(FIRST_TIER, ()), start, end, name)
            return LabelState((*self.tiers, first), (*self.state.shown, n), n)

        self._try(tr("new label"), act)

    def delete(self, label: ChosenLabel) -> None:
        """Delete a label."""
        self._push(self._with(label.tier, deleted(self.tiers[label.tier], label.label)), tr("deletion of a label"))

    def put(self, state: LabelState) -> None:
        """Say this of the sound; that cannot be undone."""
        self.state = state
        self.chosen = None
        self.changed.emit()

    def _with(self, number: int, tier: Tier) -> LabelState:
        return self.state._replace(tiers=(*self.tiers[:number], tier, *self.tiers[number + 1 :]))

    def _try(self, what: str, act: Callable[[], LabelState]) -> None:
        try:
            state = act()
        except CorpusError as error:
            self.error.emit(str(error))
        else:
            self._push(state, what)

    def _push(self, state: LabelState, what: str, moves: tuple[object, ...] | None = None) -> None:
        if state != self.state:
            self._undo_stack.push(LabelsEdit(self, state, what, moves))


def _known_of(said: FrameLabels, tracks: SoundTracks) -> FrameLabels:
    """Return labels that are sure of nothing where nobody knows yet what is recognised."""
    known = tracks.states[: len(said.phonemes)] != FrameState.UNKNOWN
    labels = said.at(slice(len(known)))
    return replace(labels, certain=labels.certain & known)
