"""The chosen variable: its values in what is seen and selected, and by phoneme; and what separates two of these."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from phonemeanalyser.desktop.session.courses import Courses
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import Scope, TimeSpan
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.arrays import BoolArray, Float32Array, UInt8Array
from phonemeengine.calibration.scores.corpus import FrameLabels
from phonemeengine.calibration.workbench.distributions import Distribution, Pair, distribution_in, ranked_in
from phonemeengine.execution import Progress
from phonemeengine.features.variables import Features
from phonemeengine.inspection.measurement import frames_between
from phonemeengine.inspection.whole_sound import FrameState
from phonemeengine.phonemes import NO_PHONEME
from phonemeengine.recognition.scores import values_of
from phonemeengine.settings import FRAME_PERIOD

AGAIN_MS = 200
"""Between two looks at a sound that is still analysed, or at thresholds that are dragged."""


class Extremes(NamedTuple):
    """The least, the mean and the greatest value of a variable."""

    least: float
    mean: float
    greatest: float


@dataclass(frozen=True, eq=False)
class Findings:
    """What was found of a variable.

    Attributes
    ----------
    distribution : over the phonemes of the scope; None where there are no frames of any.
    seen, selection : extremes of what is seen and selected; None where nothing of it is measured.
    by_labels : whether the phonemes are those of labels, or else those that are recognised.
    known : the share of the scope that is measured, 0..1; NaN where it holds no frame.
    separations : of all variables, how well they separate the two phonemes that are asked about, 0.5..1 or NaN.
    """

    distribution: Distribution | None = None
    seen: Extremes | None = None
    selection: Extremes | None = None
    by_labels: bool = False
    known: float = float("nan")
    separations: tuple[tuple[str, float], ...] = ()


NOTHING = Findings()


class _LookedAt(NamedTuple):
    """What is looked at: what was measured, what is said or recognised, and which of it is seen and selected."""

    features: Features
    phonemes: UInt8Array
    measured: BoolArray
    by_labels: bool
    seen: slice
    selection: slice


class VariableStudy(QObject):
    """Looks at the chosen variable in the background, while its panel is visible.

    Signals
    -------
    changed : something else was found.
    error : a sentence for the user.

    Attributes
    ----------
    found : what is known.
    scope : of what the distribution is: of the whole sound, or of what is seen or selected of it.
    pair : the two phonemes that a variable ought to separate; None for none.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, session: Session, courses: Courses) -> None:
        super().__init__()
        self.found = NOTHING
        self.scope = Scope.WHOLE
        self.pair: Pair | None = None
        self._session, self._courses = session, courses
        self._wanted = False
        self._looked_at: tuple[object, ...] = ()
        self._ranked: tuple[object, tuple[tuple[str, float], ...]] = (), ()
        self._work = TaskQueue(self.error.emit)
        self._timer = QTimer(self, singleShot=True, interval=AGAIN_MS)
        self._timer.timeout.connect(self._look)
        for signal in (courses.changed, session.whole.changed, session.labels.changed, session.view.moved):
            signal.connect(self.look)
        for signal in (session.view.selected, session.cleared):
            signal.connect(self.look)
        session.opened.connect(self._forget)

    def want(self, on: bool) -> None:
        """Begin to look, or stop until the panel is visible again."""
        self._wanted = on
        self.look()

    def ask(self, scope: Scope, pair: Pair | None) -> None:
        """Look at another part of the sound, and rank the variables for another pair of phonemes."""
        self.scope, self.pair = scope, pair
        self.look()

    def look(self) -> None:
        """Look soon at what may have changed."""
        if self._wanted and not self._timer.isActive():
            self._timer.start()

    def since_clear(self) -> tuple[Extremes, float] | None:
        """Return the extremes since Clear, and of how many seconds they are; None before the first frame."""
        name, history = self._courses.chosen, self._session.history
        found = history.extremes(name)
        return None if found is None else (Extremes(*reversed(found)), history.n_measured(name) * FRAME_PERIOD)

    def close(self) -> None:
        """End all work."""
        self._timer.stop()
        self._work.close()

    def _forget(self) -> None:
        """Know nothing of another sound."""
        self._work.cancel()
        self.found, self._looked_at = NOTHING, ()
        self.changed.emit()
        self.look()

    def _look(self) -> None:
        if not self._wanted or self._work.busy:
            return
        frames, asked = self._frames(), self._question()
        if asked == self._looked_at:
            return
        self._looked_at = asked
        variable, scope, pair = self._courses.chosen, self.scope, self.pair
        sensitivities = self._session.preset.in_force.sensitivities
        ranked_for = (asked[0], scope, pair)
        ranking = self._ranked[1] if self._ranked[0] == ranked_for else None

        def act(_progress: Progress) -> Findings:
            values = values_of(frames.features, variable, sensitivities)
            place = {Scope.WHOLE: slice(None), Scope.SEEN: frames.seen, Scope.SELECTION: frames.selection}[scope]
            part, codes = frames.features.part(place), frames.phonemes[place]
            ranks = _ranking(part, codes, pair) if ranking is None else ranking
            measured = frames.measured[place]
            known = float(measured.mean()) if len(measured) else float("nan")
            if values is None:
                return Findings(None, None, None, frames.by_labels, 0.0, ranks)
            of_scope = values[place]
            counts = (codes != NO_PHONEME) & np.isfinite(of_scope)
            shown = distribution_in(variable, of_scope[counts], codes[counts]) if counts.any() else None
            seen, selection = (_extremes_of(values[part]) for part in (frames.seen, frames.selection))
            return Findings(shown, seen, selection, frames.by_labels, known, ranks)

        def show(found: Findings) -> None:
            self.found, self._ranked = found, (ranked_for, found.separations)
            self.changed.emit()
            self.look()  # which does nothing if all is as it was

        self._work.submit(act, show)

    def _question(self) -> tuple[object, ...]:
        """Return all of which the answer depends: what ranks depend on first."""
        session = self._session
        tracks, labels = session.whole.tracks, self._labels()
        said = session.labels.state if labels is not None else None
        if tracks is None:
            sound: tuple[object, ...] = (session.history.n, session.history.names)
        else:
            sound = (id(tracks), tracks.n_written if said is not None else tracks.revision, tracks.names, id(said))
        scope = {Scope.WHOLE: None, Scope.SEEN: session.view.seen, Scope.SELECTION: session.view.selection}[
            self.scope
        ]
        ranked = (*sound, scope)
        sensitivities = tuple(session.preset.in_force.sensitivities.items())
        seen = session.view.seen, session.view.selection, round(self._courses.live_seconds, 2)
        return ranked, self._courses.chosen, sensitivities, self.scope, self.pair, seen

    def _frames(self) -> _LookedAt:
        session, tracks = self._session, self._session.whole.tracks
        if tracks is None:
            history = session.history
            at = history.indices(0, history.n)
            n_seen = round(self._courses.live_seconds / FRAME_PERIOD)
            phonemes = history.phonemes[at]
            measured = phonemes != NO_PHONEME
            seen = slice(max(0, len(at) - n_seen), len(at))
            return _LookedAt(history.features(at), phonemes, measured, False, seen, slice(0, 0))
        labels = self._labels()
        measured = tracks.states != FrameState.UNKNOWN
        codes = np.where(measured, tracks.phonemes, NO_PHONEME).astype(np.uint8)
        if labels is not None:
            said = np.where(labels.certain, labels.phonemes, NO_PHONEME)[: tracks.n_frames]
            codes = np.full(tracks.n_frames, NO_PHONEME, np.uint8)
            codes[: len(said)] = said
        spans = [_frames_in(span, tracks.n_frames) for span in (session.view.seen, session.view.selection)]
        return _LookedAt(tracks.features, codes, measured, labels is not None, *spans)

    def _labels(self) -> FrameLabels | None:
        return None if self._session.seen.looks_back else self._session.labels.said_frames()


def _frames_in(span: TimeSpan | None, n_frames: int) -> slice:
    if span is None or span.seconds <= 0 or not n_frames:
        return slice(0, 0)
    return slice(*frames_between(*span, n_frames))


def _extremes_of(values: Float32Array) -> Extremes | None:
    known = values[np.isfinite(values)]
    if not len(known):
        return None
    return Extremes(float(known.min()), float(known.mean(dtype=float)), float(known.max()))


def _ranking(features: Features, codes: UInt8Array, pair: Pair | None) -> tuple[tuple[str, float], ...]:
    if pair is None or not features.names:
        return ()
    of_pair = np.isin(codes, pair)
    values, said = features.values[of_pair], codes[of_pair]
    known = np.isfinite(values).all(axis=1)
    values, said = values[known], said[known]
    columns = dict(zip(features.names, values.T, strict=True))
    return tuple((r.variable, r.separation) for r in ranked_in(features.names, columns.__getitem__, said, pair))
