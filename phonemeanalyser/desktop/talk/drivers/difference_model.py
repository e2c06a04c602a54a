"""What two heads that are compared differ in: by numbers, and where most."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QObject, QTimer, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.exports import FaceInUse
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.talk.drivers.driver_model import OTHER_PRESET
from phonemeanalyser.desktop.talk.drivers.movement import RecordedSpeech, heard_in, movement_of, recording_of
from phonemeanalyser.desktop.talk.words.text_model import TextModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.audio.output import Reader
from phonemeengine.conversion.driving import DriverChoice
from phonemeengine.mouth.animation import DifferentPlace, MovementDifference, movement_difference
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.mouth.performer import MouthTrack
from phonemeengine.mouth.transcript import Transcript

COMPARE_MS = 400
"""So long after the last change both movements are generated anew."""
AROUND = 0.5
"""Seconds before and after a place that are seen with it."""


class DifferenceModel(QObject):
    """Compares what moves the two heads through the current recording, or through what a voice speaks.

    Parameters
    ----------
    texts : know what is said, and what the heads are moved by.
    in_use : says what moves the first head.
    rate : says how many pictures a second are compared.

    Signals
    -------
    changed : the difference.
    known_changed : `known` is another one.
    error : a sentence for the user.

    Attributes
    ----------
    found : the difference; None where nothing is compared, or not yet.
    known : what the preset that is not in use recognises; None where it moves no head, or not all is recognised.
    place : the number of the place that was gone to last; -1 for none.
    """

    changed = Signal()
    known_changed = Signal()
    error = Signal(str)

    def __init__(
        self, session: Session, texts: TextModel, in_use: Callable[[], FaceInUse], rate: Callable[[], float]
    ) -> None:
        super().__init__()
        self._session, self._texts, self._in_use, self._rate = session, texts, in_use, rate
        self._drivers = drivers = texts.drivers
        self.found: MovementDifference | None = None
        self.known: Transcript | None = None
        self.place = -1
        self._work = TaskQueue(self.error.emit)
        self._work.changed.connect(self.changed)
        self._timer = QTimer(self, singleShot=True, interval=COMPARE_MS)
        self._timer.timeout.connect(self._compare)
        for signal in (session.whole.changed, session.second.whole.changed, session.opened, drivers.changed):
            signal.connect(self.compare_soon)
        session.preset.sides_changed.connect(self._follow_sides)

    @property
    def by_preset(self) -> bool:
        """Whether the preset that is not in use moves the second head."""
        return self._drivers.compared == OTHER_PRESET

    @property
    def words(self) -> str:
        """What is found, in words; or why nothing is."""
        if self._session.source.path is None and self._texts.utterance is None:
            return tr("Open a recording or speak a text to see where both heads differ")
        if self.found is None:
            return tr("Comparing…")
        if not self.found.places:
            return tr("Both heads move alike")
        most = max(self.found.shapes, key=lambda shape: shape.greatest)
        return tr("Difference (RMS): {rms:.3f} · greatest: {shape} {greatest:.2f}").format(
            rms=self.found.rms, shape=most.name, greatest=most.greatest
        )

    @property
    def places(self) -> tuple[DifferentPlace, ...]:
        """Where the heads differ most, the first one most."""
        return () if self.found is None else self.found.places

    @property
    def other_preset(self) -> str:
        """What the window calls the preset that is not in use; empty where there is none."""
        preset = self._session.preset
        return "" if preset.other is None else f"{preset.other_letter}: {preset.other.preset.name}"

    def caption_of(self, track: MouthTrack | None) -> str:
        """Return in words what moves the second head, by a track where there is one; empty without that head."""
        if self.by_preset:
            return self.other_preset
        return "" if self._drivers.compared is None else self._drivers.caption_of(self._drivers.compared, track)

    def compare_soon(self) -> None:
        """Compare anew, since something else is said or shown."""
        if self._drivers.compared is None:
            self._timer.stop()
            self._work.cancel()
            self._forget()
        else:
            self._timer.start()

    def go_to(self, number: int) -> None:
        """Hold still at one of the places, and show the time around it."""
        if 0 <= number < len(self.places):
            self.place = number
            place = self.places[number]
            self._session.pause()
            self._session.seek(place.time)
            self._texts.view.reveal(TimeSpan(max(0.0, place.start - AROUND), place.end + AROUND))
            self.changed.emit()

    def close(self) -> None:
        """End the work."""
        self._timer.stop()
        self._work.close(CLOSE_TIMEOUT)

    # -- inside -------------------------------------------------------------------------------------------

    def _follow_sides(self) -> None:
        """Compare with no preset that is gone."""
        if self._session.preset.other is None and self.by_preset:
            self._drivers.compare(None)
        self.compare_soon()

    def _forget(self) -> None:
        if (self.found, self.known) != (None, None):
            self.found, self.known, self.place = None, None, -1
            self.changed.emit()

    def _compare(self) -> None:
        session, in_use = self._session, self._in_use()
        path, duration = session.source.path, session.source.duration
        utterance = None if path is None else in_use.words.get(path)
        one = recording_of(path, duration, session.whole.tracks, utterance)
        if path is None and (spoken := self._texts.utterance) is not None:
            one = RecordedSpeech(None, spoken.duration, None, spoken)
        other = one
        if self.by_preset and path is not None:
            other = recording_of(path, duration, session.second.whole.tracks)
        if one is None or other is None:
            self._work.cancel()
            self._forget()
            return
        reopen, preset, heard = session.source.reopen, session.preset.other, other.transcript
        if self.by_preset and path is None and preset is not None and reopen is not None:
            heard = partial(heard_in, reopen, preset.preset, session.source.name)
        idle = replace(in_use.options.idle, blinks=False, head=False)
        options = replace(in_use.options, rate=self._rate(), table=in_use.table, idle=idle)
        drivers = in_use.driver, self._drivers.choice_beside
        work = partial(_compared, one.transcript, heard, options, *drivers, reopen)
        self._work.replace(lambda _progress: work(), self._take)

    def _take(self, compared: tuple[MovementDifference, Transcript]) -> None:
        self.found, self.place = compared[0], -1
        known = compared[1] if self.by_preset else None
        is_new = known is not None and (self.known is None or self.known.runs != known.runs)
        self.known = known
        if is_new:
            self.known_changed.emit()
        self.changed.emit()


def _compared(
    one: Callable[[], Transcript],
    other: Callable[[], Transcript],
    options: ExportOptions,
    main: DriverChoice,
    beside: DriverChoice,
    reopen: Callable[[], Reader] | None,
) -> tuple[MovementDifference, Transcript]:
    """Return the difference of both movements, and what is said as the second head takes it."""
    heard = other()
    first, second = movement_of(one(), options, main, reopen), movement_of(heard, options, beside, reopen)
    return movement_difference(first, second), heard
