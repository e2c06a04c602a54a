"""Measuring the background noise by itself: two seconds without speech set silence and denoising."""

from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.calibrate.takes.takes_model import TakesModel
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.takes.room_noise import RoomNoise, SilenceAccuracy, measure_room, speech_in
from phonemeengine.errors import EngineError
from phonemeengine.live.recorder import to_mono_44k
from phonemeengine.presets.preset import Preset

SECONDS = 2.0
"""How long the background noise is recorded."""

Found = tuple[RoomNoise, Preset, SilenceAccuracy]


class RoomModel(QObject):
    """Records background noise, sets the preset's silence by it, and says how well that works.

    Signals
    -------
    changed : it begins to listen, or has ended.
    info : a sentence for the user about what was found.
    error : a sentence for the user.
    """

    changed = Signal()
    info = Signal(str)
    error = Signal(str)

    def __init__(self, session: Session, preset: PresetModel, takes: TakesModel) -> None:
        super().__init__()
        self.listening = False
        self._session = session
        self._capture = session.microphone.capture
        self._preset = preset
        self._takes = takes
        self._work = TaskQueue(self.error.emit)
        session.analysed.connect(self._look_for_end)
        session.microphone.changed.connect(self._look_for_end)

    def begin(self) -> None:
        """Record background noise for two seconds; the microphone listens already."""
        self._capture.begin()
        self._listen(on=True)
        self.info.emit(
            tr("Keep quiet: measuring the background noise for {seconds:g} seconds…").format(seconds=SECONDS)
        )

    def cancel(self) -> None:
        """End it; nothing changes."""
        if self.listening:
            self._capture.end()
            self._listen(on=False)
        self._work.cancel()

    def close(self) -> None:
        """End all work."""
        self.cancel()
        self._work.close()

    def _look_for_end(self) -> None:
        """Take what was recorded, once it is enough."""
        if not self.listening:
            return
        if not self._session.microphone.active:
            self.cancel()
            self.error.emit(
                tr("The background noise was not measured, because the microphone stopped. Measure it again.")
            )
        elif self._capture.seconds >= SECONDS:
            samples, rate = self._capture.end()
            self._listen(on=False)
            preset, takes = self._preset.preset, self._takes.utterances()
            self._work.replace(lambda _progress: _found_in(samples, rate, preset, takes), self._use)

    def _use(self, found: Found) -> None:
        room, preset, accuracy = found
        if room.notes:
            self.error.emit(tr_engine(room.notes[0]))
            return
        try:
            self._preset.end_edit()
            self._preset.edit(replace(preset, name=self._preset.preset.name), tr("background noise measurement"))
            told = tr(
                "Background noise {decibels:.0f} dBFS, measured for {seconds:.1f} s. {accuracy}. Ctrl+Z undoes this."
            )
            self.info.emit(
                told.format(decibels=room.decibels, seconds=room.seconds, accuracy=tr_engine(str(accuracy)))
            )
        except EngineError as error:
            self.error.emit(str(error))

    def _listen(self, *, on: bool) -> None:
        self.listening = on
        self.changed.emit()


def _found_in(samples: Float32Array, rate: int, preset: Preset, takes: tuple[LabelledUtterance, ...]) -> Found:
    room, speech = measure_room(to_mono_44k(samples, rate), preset), speech_in(takes)
    found = room.set_silence(preset, speech)
    return room, found, room.silence_accuracy(found, speech)
