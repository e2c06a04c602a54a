"""The recording that a unit is from, played as it was recorded, while the current sound holds still."""

import time
from collections.abc import Callable
from contextlib import suppress

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.talk.drivers.performance_model import PerformanceModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import AudioError
from phonemeengine.live.player import Player
from phonemeengine.performance.driver import UsedUnit
from phonemeengine.performance.own_sound import RecordedFace, original_sound
from phonemeengine.performance.table_file import PerformanceTable
from phonemeengine.presets.model_choice import while_played
from phonemeengine.storage.files import printable

AROUND = 0.3
"""Seconds before and after a unit that are played, too: a unit alone is too short to make out."""


class OriginalModel(QObject):
    """Plays a segment of a recording, with its face; `tick` ends it.

    Signals
    -------
    changed : it begins or ends.
    error : a sentence for the user.

    Attributes
    ----------
    face : what is seen; None while nothing is played.
    caption : what that is, in words.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(
        self, session: Session, performance: PerformanceModel, clock: Callable[[], float] = time.monotonic
    ) -> None:
        super().__init__()
        self.face: RecordedFace | None = None
        self.caption = ""
        self._session, self._performance, self._clock = session, performance, clock
        self._player: Player | None = None
        self._began = self._start = self._end = 0.0
        self._work = TaskQueue(self.error.emit)
        session.transport_changed.connect(self._give_way)

    @property
    def position(self) -> float:
        """Seconds of the recording that are played; without a sound, the clock's."""
        if self._player is not None:
            return self._player.position
        return self._start + self._clock() - self._began

    def play(self, unit: UsedUnit, *, whole: bool = False) -> None:
        """Play what a unit is taken from, with a little before and after it, or all of its recording."""
        table = self._performance.table
        if table is None:
            return

        def act(_progress: object) -> tuple[RecordedFace, float, SoundReader | None]:
            performance = table.recording_called(unit.recording)
            sound = original_sound(table, unit.recording)
            reader = None
            if sound is not None:
                with suppress(AudioError):  # without it an error is shown below
                    reader = SoundReader(sound)
            return RecordedFace(performance), performance.duration, reader

        def take(found: tuple[RecordedFace, float, SoundReader | None]) -> None:
            face, duration, reader = found
            if reader is None:
                self.error.emit(
                    tr(
                        "The audio of {recording} is missing, so only its face is shown; put the recordings back "
                        "into {folder}."
                    ).format(recording=printable(unit.recording), folder=printable(str(_folder_of(table))))
                )
            start, end = (0.0, duration) if whole else (unit.source_start - AROUND, unit.source_end + AROUND)
            self._begin(face, reader, max(0.0, start), min(duration, end))
            self.caption = tr("{recording}, original recording from {title}").format(
                recording=printable(unit.recording), title=tr_engine(table.about.title)
            )
            self.changed.emit()

        self._work.replace(act, take)

    def tick(self) -> None:
        """End it in time."""
        if self.face is not None and (self.position >= self._end or (self._player is not None and self._at_end)):
            self.stop()

    def stop(self) -> None:
        """End it."""
        if self.face is not None:
            self.face, self.caption = None, ""
            self._let_go()
            self.changed.emit()

    def close(self) -> None:
        """Let everything go."""
        self._let_go()
        self._work.close(CLOSE_TIMEOUT)

    @property
    def _at_end(self) -> bool:
        return self._player is not None and self._player.finished

    def _begin(self, face: RecordedFace, reader: SoundReader | None, start: float, end: float) -> None:
        self._let_go()
        self._session.pause()
        self.face, self._start, self._end, self._began = face, start, end, self._clock()
        if reader is not None:
            self._player = self._session.playback.player_of(reader, while_played(self._session.preset.in_force))
            self._player.seek(start)
            self._player.play()

    def _give_way(self) -> None:
        """End it where the current sound goes on."""
        if self._session.source.playing:
            self.stop()

    def _let_go(self) -> None:
        player, self._player = self._player, None
        if player is not None:
            player.close()


def _folder_of(table: PerformanceTable) -> object:
    return (table.path.parent / table.about.folder).resolve()
