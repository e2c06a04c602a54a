"""The analysis thread: plays a sound and analyses it a little ahead of the playback.

The thread reads, plays and analyses; a view calls `take_analyses` now and then and gets what
has been played since. Nothing else passes between the two.
"""

import logging
import math
import threading
import time
from collections import deque
from collections.abc import Callable

import numpy as np

from phonemeengine.analyser import Analyser, Analysis
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.output import ClockOutput, Output, Reader, SlowedOutput, open_output
from phonemeengine.audio.stream import STALLED
from phonemeengine.errors import DeviceError, EngineError
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.model import MOST_FRAMES_AHEAD
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE

# What is analysed and not played yet.

_log = logging.getLogger(__name__)


class PlaybackQueue:
    """Holds blocks until they are played: one thread puts them in, another takes them out.

    Parameters
    ----------
    most : blocks that wait at most; older ones are dropped and counted.

    Attributes
    ----------
    n_dropped : frames that were not taken in time.
    lock : keeps everything as it is while it is held.
    """

    def __init__(self, most: int) -> None:
        self.most = most
        self.n_dropped = 0
        self.lock = threading.RLock()
        self._blocks: deque[tuple[int, Analysis]] = deque()

    def __bool__(self) -> bool:
        return bool(self._blocks)

    @property
    def next_frame(self) -> int | None:
        """The first frame that waits, or None."""
        return self._blocks[0][1].start if self._blocks else None

    def append(self, due: int, analysis: Analysis) -> None:
        """Have a block wait until this many samples are played."""
        with self.lock:
            self._blocks.append((due, analysis))
            if len(self._blocks) > self.most and self.n_dropped == 0:
                _log.warning("frames are dropped, since the program does not take them")
            while len(self._blocks) > self.most:
                self.n_dropped += len(self._blocks.popleft()[1])

    def pop_due(self, heard: float) -> list[Analysis]:
        """Return what is due when this many samples are played, oldest first."""
        taken = []
        with self.lock:
            while self._blocks and self._blocks[0][0] <= heard:
                taken.append(self._blocks.popleft()[1])
        return taken

    def upcoming(self, heard: float) -> list[tuple[float, Analysis]]:
        """Return all blocks, each with the seconds until it is due."""
        with self.lock:
            return [((due - heard) / SAMPLE_RATE, analysis) for due, analysis in self._blocks]

    def clear(self) -> None:
        """Forget them."""
        with self.lock:
            self._blocks.clear()


STEP = 6 * HOP
"""Samples that are read, played and analysed at a time: many cost less than one by one."""
PART = 2
"""Frames that are handed out at a time: a picture shows no more than them."""
STALL_TIMEOUT = 1.0
"""Seconds that a caller waits for a sound card to open or close; after that it goes on in the background."""
CARD_TIMEOUT = 15.0
"""Seconds after which a player that waits for its sound card gives up."""

_NO_CARD = "there is no sound card to play on; connect one"
_GONE = f"the sound card takes no sound any more, and does not within {CARD_TIMEOUT:g} s; check it, and try again"


class Player:
    """Plays a sound, and hands out its analysis in step with the playback.

    Starts standing still at the beginning. All methods may be called from any one thread; they return at once.
    Without a sound card it goes on silently on the clock, or waits, and looks for one every two seconds.

    Parameters
    ----------
    reader : the sound; it is closed by `close`. All its channels are played, one is analysed.
    preset : what to recognise with.
    open_device : opens the output for a number of channels.
    waits : stand still while no sound card plays, so that nothing is passed over unheard; `take_analyses` raises
        DeviceError if there is none at first, or none again within `CARD_TIMEOUT`.
    """

    retry_period = 2.0
    """Seconds between two tries to find a sound card again."""
    wake_timeout = STALLED
    """Seconds that a sound card is given to ask for sound."""
    most_waiting = 1500
    """Blocks that wait for `take_analyses` at most; older ones are dropped and counted."""

    def __init__(
        self,
        reader: Reader,
        preset: Preset,
        open_device: Callable[[int], Output] = open_output,
        *,
        waits: bool = False,
    ) -> None:
        self.reader = reader
        self._waits = waits
        self.loop = False
        self._open_device = open_device
        self._speed = 1.0
        self._output: Output = ClockOutput()
        self._found: Output | None = None
        self._opened = threading.Event()
        self._next_try = time.monotonic() + self.retry_period
        self._wake_until = self._give_up_at = math.inf
        self._preset = preset
        self._analyser = Analyser(preset, pitch=True)
        self._playing = self._running = self._at_end = False
        self._read_ahead: deque[Float32Array] = deque()
        self._all_read = False
        self._next_frame = 0
        self._closing = False
        self._target: int | None = None
        self._stretch: tuple[int, int] | None = None
        self._to_read: int | None = None
        self._error: Exception | None = None
        self._segments: tuple[tuple[int, int], ...] = ((0, 0),)
        self._waiting = PlaybackQueue(self.most_waiting)
        self._commands: deque[Callable[[], None]] = deque()
        self._wake = threading.Event()
        self._thread = threading.Thread(target=self._run, name="analysis", daemon=True)
        self._thread.start()
        self._opened.wait(STALL_TIMEOUT)

    @property
    def playing(self) -> bool:
        """Whether sound is going on."""
        return self._playing

    @property
    def finished(self) -> bool:
        """Whether the end of the file has been played and taken, and nothing else is asked for."""
        if self._target is not None:
            return False
        drained = self._output.heard >= self._output.n_written
        return self._at_end and not self._waiting and (drained or not self._playing)

    @property
    def all_written(self) -> bool:
        """Whether all of the sound is written to the output; it may not all be played yet."""
        return self._at_end

    def catch_up(self) -> bool:
        """Have the thread look at its output at once.

        Returns
        -------
        whether it has followed all calls and written as much as the output takes, or has failed.
        """
        self._wake.set()
        held = not self._playing or self._at_end or self._output.room < STEP
        return self._error is not None or (not self._commands and self._target is None and held)

    @property
    def n_dropped(self) -> int:
        """Frames that were analysed but not taken in time."""
        return self._waiting.n_dropped

    @property
    def output_name(self) -> str:
        """What plays: the sound card's name, or that there is none."""
        return self._output.name

    @property
    def has_card(self) -> bool:
        """Whether a sound card plays, rather than the clock."""
        return self._output.is_card

    @property
    def position(self) -> float:
        """Seconds from the beginning of the file to what is playing now, or to where a seek is on its way."""
        if self._target is not None:
            return self._target * FRAME_PERIOD
        heard = self._output.heard
        begun = [segment for segment in self._segments if segment[0] <= heard]
        written, sample = begun[-1] if begun else self._segments[0]
        return max(0.0, sample + heard - written) / SAMPLE_RATE

    def play(self) -> None:
        """Go on from where it stands, as soon as enough is read ahead."""
        self._playing = True
        self._wake.set()

    def pause(self) -> None:
        """Hold still."""
        self._playing = False
        self._do(self._hold)

    def seek(self, seconds: float) -> None:
        """Go to a place in the file, rounded down to a frame; what is played then ends with the file."""
        self._go(_frame_at(max(0.0, min(seconds, self.reader.duration))), None)

    def play_stretch(self, start: float, end: float) -> None:
        """Play from one time to another, seconds, rounded to frames; over and over, while `loop` is set."""
        duration = self.reader.duration
        first, last = (_frame_at(max(0.0, min(seconds, duration))) for seconds in (start, end))
        self._go(first, (first, max(last, first + 1)))
        self.play()

    @property
    def stretch(self) -> tuple[float, float] | None:
        """The segment that is played, seconds; None for the whole sound."""
        stretch = self._stretch
        return None if stretch is None else (stretch[0] * FRAME_PERIOD, stretch[1] * FRAME_PERIOD)

    def _go(self, frame: int, stretch: tuple[int, int] | None) -> None:
        self._target, self._stretch = frame, stretch
        self._do(lambda: self._jump(frame))

    @property
    def preset(self) -> Preset:
        """What it recognises with; `set_preset` takes another one."""
        return self._preset

    def set_preset(self, preset: Preset) -> None:
        """Recognise with another preset from the next block on."""
        self._preset = preset
        self._do(lambda: self._analyser.set_preset(preset))

    def set_gain(self, gain: float) -> None:
        """Set the loudness of the playback, 0..1; the analysis does not change."""
        self._output.gain = gain

    @property
    def speed(self) -> float:
        """How fast it plays, 0.25..1 of the usual speed, with the pitch kept."""
        return self._speed

    def set_speed(self, speed: float) -> None:
        """Play slower from here on, or at the usual speed again; the analysis does not change.

        Parameters
        ----------
        speed : 0.25..1; `take_analyses` raises what does not go.
        """
        if speed != self._speed:
            self._speed = speed
            self._do(self._reopen)

    def change_device(self, open_device: Callable[[int], Output]) -> None:
        """Go on, from the same place, on another output."""
        self._open_device = open_device
        self._do(self._reopen)

    def take_analyses(self) -> list[Analysis]:
        """Return what has been played since the last call; raises whatever ended the analysis.

        The frames of each block are numbered from the beginning of the file.
        """
        if self._error is not None:
            error, self._error = self._error, None
            raise error
        if self._output.lost:
            self._do(self._drop_device)
        return self._waiting.pop_due(self._output.heard)

    def upcoming(self) -> list[tuple[float, Analysis]]:
        """Return what is analysed and not played yet: `take_analyses` gives it later.

        Returns
        -------
        each block with the seconds until it is taken, negative ones where it waits for that: the middle of its last
        frame is played then.
        """
        ahead = self._waiting.upcoming(self._output.heard)
        return ahead if self._speed == 1 else [(seconds / self._speed, analysis) for seconds, analysis in ahead]

    def close(self) -> None:
        """Stop, and let file and device go; a device that hangs is left to itself."""
        self._closing = True
        self._wake.set()
        self._thread.join(timeout=STALL_TIMEOUT)

    def _do(self, command: Callable[[], None]) -> None:
        self._commands.append(command)
        self._wake.set()

    def _run(self) -> None:
        try:
            self._open()
            self._follow()
        finally:
            self._let_found_go()
            self._output.close()
            self.reader.close()

    def _open(self) -> None:
        try:
            output = self._open_slowed()
            output.gain, self._output = self._output.gain, output
            _log.info("playing on %s", output.name)
            if self._waits and not output.is_card:
                reason = output.reason if isinstance(output, ClockOutput) else ""
                self._error = DeviceError(reason or _NO_CARD)
        except Exception as error:  # noqa: BLE001 - `take_analyses` raises it where it is seen
            self._error = error
            _log.exception("no output can be opened")
        finally:
            self._opened.set()

    def _open_slowed(self) -> Output:
        n_channels = self.reader.n_channels
        output = self._open_device(n_channels)
        return output if self._speed == 1 else SlowedOutput(output, n_channels, self._speed)

    def _reopen(self) -> None:
        """Go on with another output, or at another speed; some cards serve one stream at a time."""
        self._hold()
        self._let_found_go()
        self._output.close()
        self._change_output(self._open_slowed())

    def _follow(self) -> None:
        while not self._closing:
            try:
                while self._commands:
                    self._commands.popleft()()
                self._look_for_card()
                still = self._waits and not self._output.is_card
                busy = self._playing and not self._at_end and not still and self._output.room >= STEP
                if busy:
                    self._advance()
                elif self._playing and not self._running:
                    self._running = True
                    self._output.run(running=True)
            except Exception as error:  # noqa: BLE001 - `take_analyses` raises it where it is seen
                self._error, self._at_end, self._target, busy = error, True, None, False
                _log.warning("playing has stopped: %s", error, exc_info=not isinstance(error, EngineError))
            if not busy:
                self._wake.wait(0.02 if self._playing else 1.0)
                self._wake.clear()

    def _advance(self) -> None:
        """Play the next block, after enough of what follows is analysed to know its phonemes when it plays."""
        ahead = HOP * max(0, self._analyser.recogniser.look_ahead - MOST_FRAMES_AHEAD)  # few fit into the output
        while not self._all_read and self._n_read_ahead <= ahead:
            self._read_on()
        if self._read_ahead:
            self._output.write(self._read_ahead.popleft())
        elif self.loop:
            first, last = self._stretch or (0, self.reader.n_samples // HOP)
            rest = max(0, PART - (last - first)) * HOP  # a few samples would leave no time for anything
            self._output.write(np.zeros((rest, self.reader.n_channels), np.float32))
            self._begin(first)
        else:
            self._at_end = True

    def _read_on(self) -> None:
        block = self.reader.read(STEP if self._to_read is None else min(STEP, self._to_read))
        self._all_read = not len(block)
        if self._to_read is not None:
            self._to_read -= len(block)
        if self._all_read:
            self._queue(self._analyser.finish())
            return
        self._read_ahead.append(block)
        self._queue(self._analyser.push(self.reader.mono(block)))

    @property
    def _n_read_ahead(self) -> int:
        """Samples that are read and not played yet."""
        return sum(map(len, self._read_ahead))

    def _hold(self) -> None:
        """Hold the output still: until the user plays on, or until enough is read ahead again."""
        self._running = False
        self._output.run(running=False)

    def _jump(self, frame: int) -> None:
        self._hold()
        self._waiting.clear()
        self._output.skip()
        self._begin(frame)
        if self._target == frame:
            self._target = None

    def _begin(self, frame: int) -> None:
        """Start reading and analysing at a frame, as if the file had been followed until there."""
        start = max(0, frame - self._preset.pre_roll)
        self.reader.seek(start * HOP)
        self._analyser = Analyser(self._preset, pitch=True, start=start)
        self._segments = (*self._segments[-8:], (self._output.n_written, frame * HOP))
        self._next_frame = frame
        self._to_read = None if self._stretch is None else max(0, self._stretch[1] - frame) * HOP
        self._read_ahead.clear()
        self._all_read = False
        if frame > start:
            self._queue(self._analyser.push(self.reader.mono(self.reader.read((frame - start) * HOP))))
        self._at_end = False

    def _queue(self, analysis: Analysis) -> None:
        """Have each part of a block wait until it is played; frames from before the segment are dropped."""
        (written, sample), end = self._segments[-1], self._output.n_written + self._n_read_ahead
        analysis = analysis.part(slice(max(0, sample // HOP - analysis.start), None))
        for first in range(0, len(analysis), PART):
            part = analysis.part(slice(first, first + PART))
            self._next_frame = part.start + len(part)
            due = written + (self._next_frame - 1) * HOP + HOP // 2 - sample
            self._waiting.append(min(due, end), part)

    def _drop_device(self) -> None:
        """Go on silently, since the card has gone."""
        if self._output.lost:
            self._change_output(ClockOutput())

    @property
    def _needs_device(self) -> bool:
        return self._playing and not self._at_end and not self._output.is_card

    def _look_for_card(self) -> None:
        """Go on aloud if there is a card again; one that opens and asks for nothing is none."""
        if self._found is None:
            if not self._needs_device or time.monotonic() < self._next_try:
                return
            self._found = self._open_slowed()
            self._wake_until = time.monotonic() + self.wake_timeout
        if self._needs_device and self._found.is_card and self._found.alive:
            output, self._found = self._found, None
            self._change_output(output)
        elif not self._needs_device or not self._found.is_card or time.monotonic() > self._wake_until:
            self._let_found_go()
            self._check_patience()

    def _let_found_go(self) -> None:
        if self._found is not None:
            self._found.close()
            self._found = None
        self._next_try = time.monotonic() + self.retry_period

    def _check_patience(self) -> None:
        if self._waits and self._needs_device and time.monotonic() > self._give_up_at:
            raise DeviceError(_GONE)

    def _change_output(self, output: Output) -> None:
        """Go on elsewhere from the first frame that was not handed out."""
        old = self._output
        _log.log(logging.INFO if output.is_card else logging.WARNING, "%s: on with %s", old.name, output.name)
        output.gain = old.gain
        self._give_up_at = time.monotonic() + CARD_TIMEOUT
        with self._waiting.lock:
            place, over = round(self.position * SAMPLE_RATE), self._at_end and not self._waiting
            frame = self._next_frame if self._waiting.next_frame is None else self._waiting.next_frame
            self._waiting.clear()
            self._target = frame
            self._output = output
            self._running = False
        if over:
            self._segments = ((output.n_written, place),)
        else:
            self._begin(frame)
        self._segments, self._target = self._segments[-1:], None
        old.close()


def _frame_at(seconds: float) -> int:
    """Return the frame in which a time lies; a frame's own beginning belongs to it, however it is rounded."""
    return int(seconds / FRAME_PERIOD + 1e-6)
