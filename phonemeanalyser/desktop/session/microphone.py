"""The microphone: which one, what it does, what is recorded of it, and its latency, measured by clicks."""

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.journal import InterruptedRecording, interrupted_recordings
from phonemeengine.audio.level import Level
from phonemeengine.audio.stream import Device, InputChoice, devices, inputs_of
from phonemeengine.errors import EngineError
from phonemeengine.live.listener import NOT_LISTENING, Latency, Listener
from phonemeengine.live.loopback import Loopback, measure_loopback
from phonemeengine.live.recorder import RecordedSound, Recorder, SampleCapture
from phonemeengine.presets.preset import Preset
from phonemeengine.storage.paths import journal_folder, new_recording_path, recordings_folder


class LatencyTest(QObject):
    """Plays clicks and listens for them.

    Parameters
    ----------
    cards : what lets sound cards go; some serve one stream at a time, so it is measured after that.
    measure : plays the clicks.

    Signals
    -------
    info : a sentence about what was measured.
    error : a sentence about why nothing was.
    ended : it is over; `result` is what was measured last.
    """

    info = Signal(str)
    error = Signal(str)
    ended = Signal()

    def __init__(self, cards: TaskQueue, measure: Callable[[InputChoice], Loopback]) -> None:
        super().__init__()
        self.result: Loopback | None = None
        self.running = False
        self._cards = cards
        self._measure = measure

    def begin(self, choice: InputChoice) -> None:
        """Measure as soon as the cards are free."""
        self.running = True
        self._cards.submit(lambda _progress: self._measured(choice), self._take)

    def _measured(self, choice: InputChoice) -> Loopback | EngineError:
        try:
            return self._measure(choice)
        except EngineError as error:
            return error

    def _take(self, found: Loopback | EngineError) -> None:
        self.running = False
        if isinstance(found, Loopback):
            self.result = found
            self.info.emit(_sentence_of(found))
        else:
            self.error.emit(tr("The latency could not be measured: {why}.").format(why=tr_engine(str(found))))
        self.ended.emit()


def _sentence_of(found: Loopback) -> str:
    share = tr("The input takes {ms:.0f} ms of it, which the latency display now includes.").format(
        ms=1000 * found.capture
    )
    if not found.capture:
        share = tr("The audio device does not report which part of it the input takes.")
    return tr(
        "Round-trip latency {ms:.0f} ms ({n_detected} of {n_played} clicks detected, spread {spread:.0f} ms). {share}"
    ).format(
        ms=1000 * found.round_trip,
        n_detected=found.n_detected,
        n_played=found.n_played,
        spread=1000 * found.spread,
        share=share,
    )


RATES = (0, 16_000, 22_050, 32_000, 44_100, 48_000, 96_000)
"""Sample rates to choose from, Hz; 0 leaves it to the device."""
SUFFIXES = (".wav", ".flac")
"""What a recording can be."""
PATIENCE = 0.5
"""Seconds for which nothing may come, as when a microphone is opened, before that counts as trouble."""
MOST_CHANNELS = 8
"""Channels to choose from at most; some devices claim any number."""
WATCH_MS = 100
"""How often it is looked whether the microphone, or the recording, is in trouble."""
LEAST_LOST = 0.05
"""Seconds of lost signal that the message names at least: less would read as 0.0 s."""
CLOSE_TIMEOUT = 6.0
"""Seconds after which the end of the program waits no longer for a card, or a disk."""


class DeviceList(QObject):
    """Lists what records, the default first; a sound system that does not answer has none.

    Signals
    -------
    changed : the list is another.
    """

    changed = Signal()

    def __init__(
        self, list_devices: Callable[[], list[Device]], kind: Callable[[Sequence[Device]], list[Device]] = inputs_of
    ) -> None:
        super().__init__()
        self.devices: list[Device] = []
        self._list_devices, self._kind = list_devices, kind
        self._looking = TaskQueue(lambda _sentence: self._show([]))

    def look(self) -> None:
        """Look which there are now."""
        if not self._looking.busy:
            self._looking.submit(lambda _progress: self._kind(self._list_devices()), self._show)

    def _show(self, devices: list[Device]) -> None:
        if devices != self.devices:
            self.devices = devices
            self.changed.emit()


class NoListener:
    """What a microphone does while it is not in use: nothing."""

    status, level, latency = NOT_LISTENING, Level(), Latency()
    rate = n_dropped = 0
    seconds = lost_seconds = known_for = 0.0

    def take_analyses(self) -> list[Analysis]:
        """Return an empty list."""
        return []

    def set_preset(self, preset: Preset) -> None:
        """Recognise nothing with it."""

    def choose(self, choice: InputChoice) -> None:
        """Open nothing."""

    def record(self, recorder: Recorder | None) -> None:
        """Record nothing."""

    def close(self) -> None:
        """Let nothing go."""


class Microphone(QObject):
    """Listens and records.

    Attributes
    ----------
    listener : what is recognised, how loud, and what was lost of it.
    capture : the samples, while a take is recorded.
    since_clear : everything that was recorded since Clear; None before the first listening.

    Signals
    -------
    changed : another choice, or a recording begins or ends.
    devices_changed : the list of devices is another.
    recorded : a recording is complete: its path, its seconds, and the gaps in it, in words.
    info : a sentence for the user about something that went well.
    error : a sentence for the user.
    """

    changed = Signal()
    info = Signal(str)
    devices_changed = Signal()
    recorded = Signal(str, float, str)
    error = Signal(str)

    def __init__(
        self,
        make_listener: Callable[..., Listener] = Listener,
        list_devices: Callable[[], list[Device]] = devices,
        journal: Path | None = None,
        folder: Path | None = None,
        measure: Callable[[InputChoice], Loopback] = measure_loopback,
    ) -> None:
        super().__init__()
        self.choice = InputChoice()
        self.listener: Listener | NoListener = NoListener()
        self.inputs = DeviceList(list_devices)
        self._cards, self._files = TaskQueue(self.error.emit), TaskQueue(self.error.emit)
        self.latency_test = LatencyTest(self._cards, measure)
        self.capture = SampleCapture()
        self.since_clear: RecordedSound | None = None
        self.folder = self._rescue = folder or recordings_folder()
        self.suffix = ".wav"
        self.with_phonemes = False
        self.fill_gaps = False
        self._journal = journal or journal_folder()
        self._make_listener = make_listener
        self._recorder: Recorder | None = None
        self._preset = Preset()
        self._goes_on = False
        self._troubled = self._trouble = ""
        self._since = 0.0
        self.inputs.changed.connect(self.devices_changed)
        self.latency_test.info.connect(self.info)
        self.latency_test.error.connect(self.error)
        self.latency_test.ended.connect(self._go_on)
        self._watch = QTimer(self, interval=WATCH_MS)
        self._watch.timeout.connect(self._look_for_trouble)

    # -- how it is ----------------------------------------------------------------------------------------

    @property
    def devices(self) -> list[Device]:
        """The microphones that there are, the default first."""
        return self.inputs.devices

    @property
    def name(self) -> str:
        """What is listened to, as the user chose it."""
        return self.choice.label or tr("Default microphone")

    @property
    def active(self) -> bool:
        """Whether it is listened to, or tried to."""
        return not isinstance(self.listener, NoListener)

    @property
    def listening(self) -> bool:
        """Whether sound comes in now."""
        return self.listener.status.listening

    @property
    def silent(self) -> bool:
        """Whether sound should come in, and none does: what came last is out of date then."""
        return self.active and not self.listening

    @property
    def recording(self) -> bool:
        """Whether what comes is recorded."""
        return self._recorder is not None

    @property
    def words(self) -> str:
        """What is going on, in words."""
        if self.latency_test.running:
            return tr("measuring latency")
        status, rate = self.listener.status, f"{self.listener.rate:,} Hz".replace(",", " ")
        return f"{status.words}, {rate}" if status.listening else status.words

    @property
    def recorded_seconds(self) -> float:
        """How much of the present recording is on disk, seconds."""
        return self._recorder.seconds if self._recorder else 0.0

    @property
    def latency(self) -> Latency | None:
        """How long a sound takes to become a phoneme; None while nothing comes.

        The card's own word for its share gives way to what a loopback measured.
        """
        if not self.listening:
            return None
        latency, measured = self.listener.latency, self.latency_test.result
        return replace(latency, capture=measured.capture) if measured and measured.capture else latency

    def read_level(self) -> Level:
        """Return what the level meter shows now."""
        return self.listener.level

    # -- what it shall do ---------------------------------------------------------------------------------

    def listen(self, preset: Preset) -> None:
        """Begin to listen; while the latency is measured, as soon as that is done."""
        self._preset = preset
        if self.latency_test.running:
            self._goes_on = True
        elif not self.active:
            self.since_clear = self.since_clear or RecordedSound()
            self.listener = self._make_listener(preset, self.choice, pitch=True, on_sound=self._take_samples)
            self._watch.start()
            self.changed.emit()

    def _take_samples(self, block: Float32Array, rate: int) -> None:
        self.capture.add_samples(block, rate)
        if self.since_clear is not None:
            self.since_clear.add_samples(block, rate)

    def forget_recorded(self) -> None:
        """Forget what was recorded so far."""
        if self.since_clear is not None:
            self.since_clear.clear()

    def stop(self) -> None:
        """Let the microphone go, and end the recording."""
        self.end_recording()
        self._goes_on = False
        if self.active:
            listener, self.listener = self.listener, NoListener()
            self._watch.stop()
            self._troubled = self._trouble = ""
            self._cards.submit(lambda _progress: listener.close())  # a sound server that hangs, hangs no window
            self.changed.emit()

    def set_preset(self, preset: Preset) -> None:
        """Recognise with another preset."""
        self._preset = preset
        self.listener.set_preset(preset)

    def choose(self, choice: InputChoice) -> None:
        """Listen to another microphone, channel or rate."""
        if choice != self.choice:
            self.choice = choice
            self.latency_test.result = None
            self.listener.choose(choice)
            self.changed.emit()

    def set_else_default(self, on: bool) -> None:
        """Go on with the system's default microphone while the chosen one is not there, or wait for it."""
        self.choose(replace(self.choice, else_default=on))

    def set_latency(self, seconds: float) -> None:
        """Ask for longer or shorter blocks."""
        self.choose(replace(self.choice, latency=seconds))

    def refresh_devices(self) -> None:
        """Look which microphones there are; `devices_changed` tells when that is known."""
        self.inputs.look()

    def measure(self) -> None:
        """Play clicks and listen for them; `info` or `error` tells what came of it. Listening goes on afterwards."""
        if not self.latency_test.running:
            goes_on = self.active
            self.stop()
            self._goes_on = goes_on
            self.latency_test.begin(self.choice)
            self.changed.emit()

    def begin_recording(self) -> None:
        """Record the microphone from now on into a new file in the folder."""
        if self.latency_test.running:
            self.error.emit(
                tr("Recording did not start, since the latency is being measured. Try again in a few seconds.")
            )
        if not self.active or self.recording:
            return
        folder, suffix = self.folder, self.suffix
        self._recorder = Recorder(
            lambda: new_recording_path(folder, suffix), with_phonemes=self.with_phonemes, fill_gaps=self.fill_gaps
        )
        self._recorder.journal, self._recorder.rescue = self._journal, self._rescue
        self.listener.record(self._recorder)
        self.changed.emit()

    def end_recording(self) -> None:
        """End the recording; `recorded` tells when its file is complete."""
        recorder, self._recorder = self._recorder, None
        if recorder is not None:
            self.listener.record(None)
            self._files.submit(lambda _progress: recorder.close(), lambda _none: self._tell_recorded(recorder))
            self.changed.emit()

    def interrupted_recordings(self) -> list[InterruptedRecording]:
        """Return the recordings that were cut off when the program ended."""
        return interrupted_recordings(self._journal)

    def close(self) -> None:
        """Let everything go; waits until recordings are complete."""
        self.stop()
        if self.since_clear is not None:
            self.since_clear.close()
        for queue in (self._cards, self._files):
            queue.finish(CLOSE_TIMEOUT)

    def _go_on(self) -> None:
        """Listen again, if it was listened to before the latency was measured."""
        if self._goes_on:
            self._goes_on = False
            self.listen(self._preset)
        self.changed.emit()

    def _look_for_trouble(self) -> None:
        """Say once when nothing comes any more, and once when it does again."""
        if self._recorder is not None and self._recorder.failure:
            self.end_recording()
        status = self.listener.status
        if status.listening:
            if self._troubled:
                lost, words = self.listener.lost_seconds, tr("The microphone is back: {status}.")
                if lost >= LEAST_LOST:
                    words = tr("The microphone is back: {status}. {seconds:.1f} s of its signal were lost.")
                self.info.emit(words.format(status=tr_engine(status.words), seconds=lost))
            self._troubled = self._trouble = ""
            return
        trouble, now = status.trouble, time.monotonic()
        if trouble != self._trouble:
            self._trouble, self._since = trouble, now
        if trouble != self._troubled and now - self._since >= PATIENCE:
            self._troubled = trouble
            waits = "; " + tr("the recording continues once the signal is back") if self.recording else ""
            told = tr_engine(trouble)
            self.error.emit(f"{told[0].upper()}{told[1:]}{waits}.")

    def _tell_recorded(self, recorder: Recorder) -> None:
        if recorder.failure:
            self.error.emit(recorder.failure)
        elif recorder.path is not None and recorder.seconds:
            self.recorded.emit(str(recorder.path), recorder.seconds, recorder.gap_words)
            for remark in _remarks(recorder):
                self.info.emit(remark)
        else:
            self.error.emit(tr("Nothing was recorded, since the microphone sent no signal. Check the microphone."))


def _remarks(recorder: Recorder) -> list[str]:
    """Return what else there is to know of a recording that went well."""
    earlier = [path.name for path in recorder.paths[:-1]]
    if not earlier:
        return list(recorder.notes)
    files = ", ".join(earlier)
    return [
        *recorder.notes,
        tr(
            "The format of the microphone changed during the recording; the part before the change is in {files}."
        ).format(files=files),
    ]
