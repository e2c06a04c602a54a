"""The keys of the current sound: an animator's edits over the movement that is generated."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.exports import FaceInUse
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.session.undo import UndoableEdit
from phonemeanalyser.desktop.settings import outside_program
from phonemeanalyser.desktop.talk.drivers.movement import movement_of, recording_of
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.errors import EngineError
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.key_layer import NO_KEYS, KeyCurve, KeyLayer, ShownCurve, keys_beside, read_keys, write_keys

USUAL_SHAPES = ("jawOpen", "mouthPucker", "mouthSmileLeft")
"""Blend shapes whose curves are seen at first."""
MOST_SHAPES = 8
GENERATE_MS = 300
"""So long after the last change the movement is generated anew."""


class KeyModel(QObject):
    """Holds the keys of one sound file at a time, and the curves that they change; changes can be undone.

    Parameters
    ----------
    session : whose sound it is, and whose undo stack.
    in_use : says what moves the face.
    rate : says how many pictures a second the movement has.

    Signals
    -------
    changed : other keys, curves or blend shapes.
    opened : the curves are wanted on the page, or not any more.
    error, info : a sentence for the user.

    Attributes
    ----------
    sound : whose keys they are; None where the sound is no file.
    layer : the keys.
    shapes : the blend shapes whose curves are seen.
    open : whether the curves are wanted on the page.
    watched : whether they are seen, so that the movement is generated.
    animation : the movement without keys; None until it is generated.
    """

    changed = Signal()
    opened = Signal()
    error = Signal(str)
    info = Signal(str)

    def __init__(self, session: Session, in_use: Callable[[], FaceInUse], rate: Callable[[], float]) -> None:
        super().__init__()
        self._session, self._in_use, self._rate = session, in_use, rate
        self.sound: Path | None = None
        self.layer = self._saved = NO_KEYS
        self.shapes: tuple[str, ...] = USUAL_SHAPES
        self.open = self.watched = False
        self.animation: Animation | None = None
        self._curves: dict[str, ShownCurve] = {}
        self._work = TaskQueue(self.error.emit)
        self._timer = QTimer(self, singleShot=True, interval=GENERATE_MS)
        self._timer.timeout.connect(self._generate)
        session.opened.connect(self._follow)
        session.whole.changed.connect(self.generate_soon)

    @property
    def possible(self) -> bool:
        """Whether there is a sound file, beside which keys can be kept."""
        return self.sound is not None

    @property
    def has_unsaved_changes(self) -> bool:
        """Whether keys were edited that are in no file."""
        return self.layer != self._saved

    def curve_of(self, movestate: str) -> ShownCurve | None:
        """Return the curve of a blend shape as it is shown; None before the movement is generated."""
        animation = self.animation
        if animation is None or movestate not in animation.movestates:
            return None
        keys = self.layer.curve_of(movestate)
        known = self._curves.get(movestate)
        if known is None or known.keys is not keys:
            generated = animation.weights[:, animation.movestates.index(movestate)]
            known = self._curves[movestate] = ShownCurve(generated, animation.rate, keys)
        return known

    def names(self) -> tuple[str, ...]:
        """Return the blend shapes that there are, those that move most first."""
        if self.animation is None:
            return ()
        ranges = np.ptp(self.animation.weights, axis=0)
        return tuple(self.animation.movestates[k] for k in np.argsort(-ranges, kind="stable").tolist())

    # -- what is seen -------------------------------------------------------------------------------------

    def watch(self, on: bool) -> None:
        """Take note of whether curves are seen."""
        if on and not self.watched:
            self._timer.start()
        self.watched = on

    def set_open(self, on: bool) -> None:
        """Want the curves on the page, or not."""
        if on != self.open:
            self.open = on
            self.opened.emit()

    def show_shapes(self, names: Sequence[str]) -> None:
        """Show the curves of these blend shapes, at most eight."""
        names = tuple(dict.fromkeys(names))[:MOST_SHAPES]
        if names != self.shapes:
            self.shapes = names
            self.changed.emit()

    def generate_soon(self) -> None:
        """Generate the movement anew, since something else is said or shown; not before anybody looks."""
        if self.watched:
            self._timer.start()

    # -- edits --------------------------------------------------------------------------------------------

    def put(self, layer: KeyLayer) -> None:
        """Have these keys; that cannot be undone."""
        self.layer = layer
        self.changed.emit()

    def edit(self, movestate: str, curve: KeyCurve, what: str) -> None:
        """Have other keys of a blend shape, until that is undone."""
        if self.possible and curve != self.layer.curve_of(movestate):
            self._push(self.layer.with_curve(movestate, curve), what)

    def _push(self, layer: KeyLayer, what: str) -> None:
        edit = UndoableEdit(what, self.put, self.layer, layer, lambda: self.sound)
        self._session.preset.undo_stack.push(edit)

    def clear(self) -> None:
        """Have no keys, until that is undone."""
        if self.layer:
            self._push(NO_KEYS, tr("delete all keys"))

    def save(self) -> bool:
        """Write the keys beside the sound, those of the demo to Documents; says whether that went well."""
        if self.sound is None:
            return False
        path = outside_program(keys_beside(self.sound), make_folder=True)
        try:
            write_keys(self.layer, path)
        except EngineError as error:
            self.error.emit(str(error))
            return False
        self._saved = self.layer
        self.info.emit(tr("Keys saved as {path}").format(path=path))
        self.changed.emit()
        return True

    def close(self) -> None:
        """End the work."""
        self._timer.stop()
        self._work.close(CLOSE_TIMEOUT)

    # -- inside -------------------------------------------------------------------------------------------

    def _follow(self) -> None:
        """Take up the keys of the sound that is open now."""
        source = self._session.source
        sound = source.path if source.kind is SourceKind.FILE else None
        if sound == self.sound:
            return
        self.sound, self.animation = sound, None
        self._curves.clear()
        self.layer = self._saved = NO_KEYS
        path = None if sound is None else outside_program(keys_beside(sound))
        if path is not None and path.is_file():
            try:
                self.layer = self._saved = read_keys(path)
            except EngineError as error:
                self.error.emit(str(error))
        self.changed.emit()
        self.generate_soon()

    def _generate(self) -> None:
        """Generate the movement as an export of the sound would, once all of the sound is recognised."""
        sound, in_use, source = self.sound, self._in_use(), self._session.source
        utterance = None if sound is None else in_use.words.get(sound)
        said = recording_of(sound, source.duration, self._session.whole.tracks, utterance)
        if said is None:
            return
        options = replace(in_use.options, rate=self._rate(), table=in_use.table)
        work = partial(movement_of, options=options, choice=in_use.driver, reopen=source.reopen)
        self._work.replace(lambda _progress: work(said.transcript()), lambda made: self._take(sound, made))

    def _take(self, sound: Path | None, made: Animation) -> None:
        if sound != self.sound:
            return
        if self._session.source.duration > 0:  # what comes after the sound cannot be edited
            n = int(self._session.source.duration * made.rate) + 1
            made = replace(made, weights=made.weights[:n], head=made.head[:n])
        self.animation = made
        self._curves.clear()
        self.changed.emit()
