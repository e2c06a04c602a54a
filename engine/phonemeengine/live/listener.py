"""The listening thread: follows a microphone, whatever happens to it.

The thread opens, reads, analyses and hands over to a recording; a view calls `take_analyses` or
`poll` now and then, and never waits for sound.
"""

import logging
import threading
import time
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
from typing_extensions import override

from phonemeengine.analyser import Analyser, Analysis, Reading, latest_reading
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.input import CardInput, Input
from phonemeengine.audio.level import Level, PeakMeter
from phonemeengine.audio.mixing import cancels
from phonemeengine.audio.stream import STALLED, InputChoice, missing_library
from phonemeengine.errors import DeviceError
from phonemeengine.execution import Closing
from phonemeengine.live.recorder import Recorder
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE, WINDOW

# One opened microphone, from its samples to what was found in them.

FADING = 0.99999
"""How much of what was measured of the channels stays with each sample: some two seconds of it."""
AUDIBLE = 1.0
"""Least sum of squares, of samples within ±1, by which channels are judged."""
STEADINESS = 0.98
"""How much of what was measured before stays in a latency with each block."""


@dataclass(frozen=True)
class Latency:
    """Mean time from a sound to its phoneme, seconds.

    Attributes
    ----------
    capture : the device's buffers, and the resampler's where there is one.
    window : from the middle of a frame to the end of its window.
    hop : waiting for the hop to be complete, half a hop in the mean.
    look_ahead : what the recogniser waits for after a frame.
    analysis : from a block's arrival to its phonemes.
    """

    capture: float = 0.0
    window: float = WINDOW / 2 / SAMPLE_RATE
    hop: float = HOP / 2 / SAMPLE_RATE
    look_ahead: float = 0.0
    analysis: float = 0.0

    @property
    def total(self) -> float:
        """All of it, seconds."""
        return self.capture + self.window + self.hop + self.look_ahead + self.analysis


class MicrophoneAnalyser:
    """Follows an open microphone.

    Parameters
    ----------
    source : the microphone.
    channel : the channel that is analysed, counted from 1; 0 mixes them all.
    preset : what to recognise with.
    pitch : measure ``f0`` too.
    start : number of its first frame.
    phonemes_only : leave spectra, waveforms and variables out where the recogniser needs none.
    """

    def __init__(
        self, source: Input, channel: int, preset: Preset, *, pitch: bool, start: int, phonemes_only: bool = False
    ) -> None:
        self.source = source
        self.start = start
        self._n_analysed = 0
        self._spent = self._look_ahead = 0.0
        self._products: Float64Array = np.zeros((1, 1))
        self._columns = slice(channel - 1, channel) if channel else slice(None)
        self.analyser = Analyser(
            preset, rate=source.rate, live=True, pitch=pitch, start=start, phonemes_only=phonemes_only
        )

    @property
    def n_channels(self) -> int:
        """Channels that are analysed and recorded."""
        return len(range(self.source.n_channels)[self._columns])

    @property
    def latency(self) -> Latency:
        """How long a sound takes to become a phoneme here; nothing is known before the first."""
        if not self._spent:
            return Latency()
        return Latency(self.source.delay + self.analyser.delay, look_ahead=self._look_ahead, analysis=self._spent)

    @property
    def cancels(self) -> bool:
        """Whether the channels that are mixed cancelled each other in the last seconds."""
        products = self._products
        return len(products) > 1 and bool(products.trace() > AUDIBLE) and cancels(products)

    @property
    def seconds(self) -> float:
        """Where the next sample lies, counted like the frames: frame k begins at 10k ms."""
        return self.start * FRAME_PERIOD + self._n_analysed / self.source.rate

    @property
    def lost_seconds(self) -> float:
        """Sound that the device lost since it was opened, seconds; frames are counted without it."""
        return self.source.n_lost / self.source.rate

    def pick_channels(self, block: Float32Array) -> Float32Array:
        """Return the chosen channels, shape (n, n_channels), of the microphone's samples."""
        return block[:, self._columns]

    def set_preset(self, preset: Preset) -> None:
        """Recognise with another preset from the next block on."""
        self.analyser.set_preset(preset)

    def analyse(self, block: Float32Array) -> Analysis:
        """Analyse samples of the microphone, shape (n, n_channels)."""
        began = time.monotonic()
        if block.shape[1] > 1:
            self._products = FADING ** len(block) * self._products + block.T @ block
        analysis = self.analyser.push(block)
        self._look_ahead = self.analyser.recogniser.look_ahead * FRAME_PERIOD  # asked here: it may be made now
        spent = time.monotonic() - began
        self._spent = STEADINESS * (self._spent or spent) + (1 - STEADINESS) * spent
        self._n_analysed += len(block)  # last, so that who waits for some seconds of sound finds the latency known
        return analysis

    def time_of(self, frame: int) -> float:
        """Return when the middle of a frame sounded, on the clock of `time.monotonic`."""
        sample = (frame - self.start) * HOP + HOP // 2
        return self.source.time_of(sample / SAMPLE_RATE * self.source.rate + self.source.n_lost)


# How listening goes, in words.

QUIET = 0.5
"""Seconds without a block after which nothing counts as coming: even silence comes every 10 ms."""


@dataclass(frozen=True)
class Status:
    """Whether sound is coming in at this moment, and what is going on, in words."""

    listening: bool
    words: str
    trouble: str = ""
    """Why nothing comes in, without for how long, so that it can be said once; empty while sound comes in."""


NOT_LISTENING = Status(listening=False, words="not listening", trouble="not listening")


def status_of(source: Input, *, analysed: bool, silent: float, cancels: bool = False) -> Status:
    """Return the status of an open microphone, whose last block came `silent` seconds ago, or never yet.

    `cancels` says that the channels that are mixed cancel each other.
    """
    if not analysed:
        words = f"waiting for a signal from {source.name}"
        return Status(listening=False, words=words, trouble=words)
    if silent < QUIET and cancels:
        words = f"{source.name}; its channels cancel each other out when mixed, so choose one of them"
        return Status(listening=True, words=words)
    if silent < QUIET:
        return Status(listening=True, words=source.name)
    return Status(
        listening=False,
        words=f"no signal from {source.name} for {silent:.0f} s; trying again every 2 s",
        trouble=f"no signal from {source.name}; trying again every 2 s",
    )


CLOSE_TIMEOUT = 5.0
"""Seconds that `close` waits for the end of the thread at most, while a microphone is open."""
OPEN_TIMEOUT = 0.5
"""The same while none is: a sound system that hangs when it is asked for one delays nothing else."""
READ_TIMEOUT = 0.1
"""Seconds that the thread waits for sound before it looks whether all is well."""

_log = logging.getLogger(__name__)


class Listener(Closing):
    """Listens to a microphone and recognises its sound, from the moment it is made until it is closed.

    A device that is missing, vanishes, stands still or comes back never raises: `status` says what is going on, and
    it is tried again every two seconds. All methods return at once.

    Parameters
    ----------
    preset : what to recognise with.
    choice : which microphone, channel and rate; the system's default where it names none.
    pitch : measure ``f0`` too, which no rule needs.
    phonemes_only : leave spectra, waveforms and variables out where the recogniser needs none.
    recorder : records from the first sample on; see `record`.
    on_analysis : called in the listening thread with each block, as soon as it is known; it must not wait.
    on_sound : called there with each block of sound, shape (n, n_channels), and its rate; it must not wait either.
    clock : tells the time, seconds.
    """

    retry_period = 2.0
    """Seconds between two tries to reach a device that gives nothing."""
    most_waiting = 500
    """Blocks that wait for `take_analyses` at most; older ones are dropped and counted."""

    def __init__(
        self,
        preset: Preset,
        choice: InputChoice | None = None,
        *,
        pitch: bool = False,
        phonemes_only: bool = False,
        recorder: Recorder | None = None,
        on_analysis: Callable[[Analysis], object] = lambda _analysis: None,
        on_sound: Callable[[Float32Array, int], object] = lambda _block, _rate: None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.choice = choice or InputChoice()
        self.n_dropped = 0
        self._preset = preset
        self._pitch = pitch
        self._phonemes_only = phonemes_only
        self._on_analysis = on_analysis
        self._on_sound = on_sound
        self.clock = clock
        self._source: Input | None = None
        self._analyser: MicrophoneAnalyser | None = None
        self._newest: Analysis | None = None
        self._meter = PeakMeter()
        self._recorder = recorder
        self._error: Exception | None = None
        is_card = type(self)._open_input is Listener._open_input
        self._refusal = (missing_library() if is_card else "") or "opening the microphone"
        self._began = self._last_sound_at = self.clock()
        self._known_at = 0.0
        self._next_frame = 0
        self._lost_before = 0.0
        self._gap_is_loss = False
        self._closing = False
        self._pause = threading.Event()
        self._waiting: deque[Analysis] = deque()
        self._commands: deque[Callable[[], None]] = deque()
        self._thread = threading.Thread(target=self._run, name="listening", daemon=True)
        self._thread.start()

    # -- the microphone's sound ------------------------------------------------------------------------------

    def poll(self) -> Reading:
        """Return the newest phoneme and intensity; silence while nothing comes."""
        return latest_reading(self._newest if self.clock() - self._last_sound_at < QUIET else None)

    @property
    def level(self) -> Level:
        """What the level meter reads now."""
        return self._meter.read(self.clock())

    def take_analyses(self) -> list[Analysis]:
        """Return what has been found since the last call, oldest first; raises what ended the listening.

        Frames are numbered from the first that arrived; while the microphone gives nothing, the numbers go on.
        """
        if self._error is not None:
            error, self._error = self._error, None
            raise error
        taken = []
        with suppress(IndexError):
            while True:
                taken.append(self._waiting.popleft())
        return taken

    # -- how it goes --------------------------------------------------------------------------------------

    @property
    def status(self) -> Status:
        """Whether sound comes in now, and what is going on."""
        source, analyser = self._source, self._analyser
        if self._closing or not self._thread.is_alive():
            return NOT_LISTENING
        if source is None:
            return Status(listening=False, words=self._refusal, trouble=self._refusal)
        return status_of(
            source,
            analysed=analyser is not None,
            silent=self.clock() - self._last_sound_at,
            cancels=analyser is not None and analyser.cancels,
        )

    @property
    def rate(self) -> int:
        """The device's sample rate, Hz; 0 while none is open."""
        analyser = self._analyser
        return analyser.source.rate if analyser else 0

    @property
    def n_channels(self) -> int:
        """Channels that are analysed, and so recorded; 0 while no device is open."""
        analyser = self._analyser
        return analyser.n_channels if analyser else 0

    @property
    def seconds(self) -> float:
        """How long it has been listening, from the first sound to the newest, gaps included, seconds."""
        analyser = self._analyser
        return analyser.seconds + analyser.lost_seconds if analyser else self._next_frame * FRAME_PERIOD

    @property
    def lost_seconds(self) -> float:
        """Sound that was lost since the beginning: by the device, or while there was none; seconds."""
        analyser = self._analyser
        away = self.clock() - self._last_sound_at if self._gap_is_loss else 0.0
        return self._lost_before + (analyser.lost_seconds if analyser else away)

    @property
    def latency(self) -> Latency:
        """How long a sound takes to become a phoneme here."""
        analyser = self._analyser
        return analyser.latency if analyser else Latency()

    @property
    def known_for(self) -> float:
        """Seconds since the newest frames became known."""
        return self.clock() - self._known_at

    def time_of(self, frame: int) -> float:
        """Return when a frame that is not long past began, counted from the first sound, gaps included, seconds."""
        analyser = self._analyser
        return frame * FRAME_PERIOD + (analyser.lost_seconds if analyser else 0.0)

    def age_of(self, frame: int) -> float:
        """Return how long ago the middle of a frame sounded, seconds."""
        analyser = self._analyser
        return self.clock() - analyser.time_of(frame) if analyser else 0.0

    # -- what it shall do ---------------------------------------------------------------------------------

    @property
    def preset(self) -> Preset:
        """What it recognises with; `set_preset` takes another one."""
        return self._preset

    def set_preset(self, preset: Preset) -> None:
        """Recognise with another preset from the next block on."""
        self._preset = preset
        self._commands.append(lambda: self._analyser.set_preset(preset) if self._analyser else None)

    def choose(self, choice: InputChoice) -> None:
        """Listen to another microphone."""
        self.choice = choice
        self._commands.append(self._change)
        self._pause.set()

    def record(self, recorder: Recorder | None) -> None:
        """Record everything from now on; None ends that. The caller closes the recorder."""
        self._recorder = recorder

    @override
    def close(self) -> None:
        """Stop, and let the microphone go; one that is being opened and hangs is let go when it answers."""
        self._closing = True
        self._pause.set()
        self._thread.join(CLOSE_TIMEOUT if self._source is not None else OPEN_TIMEOUT)

    # -- the thread ---------------------------------------------------------------------------------------

    def _run(self) -> None:
        try:
            self._warm_up()
            while not self._closing:
                while self._commands:
                    self._commands.popleft()()
                if self._source is None:
                    self._open()
                else:
                    self._listen(self._source)
        except Exception as error:  # noqa: BLE001 - `take_analyses` raises it where it is seen
            self._error = error
            _log.exception("listening has failed")
        finally:
            if self._analyser is None:
                self._lost_before = self.lost_seconds
            self._gap_is_loss = False
            self._let_go("not listening")
            _log.info("listening has ended; %.2f s lost, %d frames dropped", self.lost_seconds, self.n_dropped)

    def _warm_up(self) -> None:
        """Analyse silence, so that the first sound need not wait for what is imported at the first use."""
        analyser = Analyser(self._preset, pitch=self._pitch, phonemes_only=self._phonemes_only)
        analyser.push(np.zeros(2 * WINDOW, np.float32))

    def _open_input(self, choice: InputChoice) -> Input:
        """Open a microphone; a subclass listens to something else.

        Raises
        ------
        DeviceError : it cannot be opened now.
        """
        return CardInput(choice)

    def _open(self) -> None:
        try:
            self._source = source = self._open_input(self.choice)
            _log.info("%s is open: %d Hz, %d channels", source.name, source.rate, source.n_channels)
        except DeviceError as error:
            refusal = f"{error}; trying again every 2 s"
            if refusal != self._refusal:
                _log.warning("%s", refusal)
            self._refusal = refusal
            self._pause.wait(self.retry_period)
            self._pause.clear()

    def _listen(self, source: Input) -> None:
        block = source.read(READ_TIMEOUT)
        if len(block):
            self._follow(source, block)
        elif source.lost:
            self._let_go(f"{source.name} was disconnected; trying again every 2 s")
        elif source.quiet > STALLED:
            self._let_go(f"no signal from {source.name}; trying again every 2 s")

    def _follow(self, source: Input, block: Float32Array) -> None:
        now, gap = self.clock(), None
        if self._analyser is None:
            began = now - len(block) / source.rate
            gap = max(0.0, began - self._last_sound_at)
            self._analyser = self._new_analyser(source, began, gap)
        self._last_sound_at, analyser = now, self._analyser
        block = analyser.pick_channels(block)
        self._meter.add_samples(block, self._last_sound_at)
        self._on_sound(block, source.rate)
        recorder = self._recorder
        if recorder is not None:
            recorder.write(block, source.rate, analyser.seconds, gap)
        analysis = analyser.analyse(block)
        if len(analysis):
            self._hand_over(analysis)
            if recorder is not None:
                recorder.add_analysis(analysis)

    def _new_analyser(self, source: Input, began: float, gap: float) -> MicrophoneAnalyser:
        """Go on counting frames where the clock stands, `gap` seconds after the last sound."""
        if self._next_frame == 0:
            self._began = began
        start = max(self._next_frame, round((began - self._began) / FRAME_PERIOD))
        if self._gap_is_loss:
            self._lost_before += gap
        self._gap_is_loss = True
        return MicrophoneAnalyser(
            source,
            self.choice.channel,
            self._preset,
            pitch=self._pitch,
            start=start,
            phonemes_only=self._phonemes_only,
        )

    def _hand_over(self, analysis: Analysis) -> None:
        self._next_frame = analysis.start + len(analysis)
        self._waiting.append(analysis)
        if len(self._waiting) > self.most_waiting:
            if self.n_dropped == 0:
                _log.warning("frames are dropped, since the program does not take them")
            with suppress(IndexError):  # `take_analyses` may have come first
                self.n_dropped += len(self._waiting.popleft())
        self._newest = analysis
        self._known_at = self.clock()
        self._on_analysis(analysis)

    def _change(self) -> None:
        self._let_go("opening the microphone")
        self._gap_is_loss = False

    def _let_go(self, refusal: str) -> None:
        source, self._refusal = self._source, refusal
        if source is not None:
            _log.info("%s is let go: %s", source.name, refusal)
            if self._analyser is not None:
                self._lost_before += self._analyser.lost_seconds
                self._next_frame += round(self._analyser.lost_seconds / FRAME_PERIOD)  # the numbers follow the clock
            self._source = self._analyser = None
            source.close()
