"""Where played sound goes: a sound card, or a clock where there is none; either may be slowed, with the pitch kept.

Both count samples since they were opened, and say which one is playing now: the picture follows that.
"""

import math
import threading
import time
from collections import deque
from collections.abc import Callable
from typing import Any, Protocol

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.stream import STALLED, CardStream, Device, openable_devices
from phonemeengine.errors import DeviceError, check_range
from phonemeengine.settings import SAMPLE_RATE, Channel


class Reader(Protocol):
    """Gives a sound at 44.1 kHz, block by block."""

    channel: Channel
    n_channels: int
    n_samples: int

    @property
    def duration(self) -> float:
        """Length of the sound, seconds."""
        ...

    def read(self, n: int) -> Float32Array:
        """Return the next samples, shape (m, n_channels), fewer than `n` only at the end."""
        ...

    def mono(self, block: Float32Array) -> Float32Array:
        """Return what is recognised, shape (m,), of a block that `read` gave."""
        ...

    def seek(self, sample: int) -> None:
        """Go to a sample."""
        ...

    def close(self) -> None:
        """Let go."""
        ...


# A ring of samples between two threads: one writes, one reads, neither ever waits.
#
# Both ends count samples since the beginning; the counts only grow, so each side may look at the other's at any time.
# The reader is usually the sound card's callback, which must not lock, so nothing here does.


class Ring:
    """Holds up to `capacity` samples per channel.

    Attributes
    ----------
    n_written, n_read : samples per channel since the beginning.
    """

    def __init__(self, capacity: int, n_channels: int) -> None:
        self.n_written = 0
        self.n_read = 0
        self._skip_to = 0
        self._samples = np.zeros((capacity, n_channels), np.float32)

    @property
    def room(self) -> int:
        """Samples per channel that can be written now."""
        return len(self._samples) - (self.n_written - max(self.n_read, self._skip_to))

    def write(self, block: Float32Array) -> None:
        """Append a block, shape (n, n_channels); the writer makes sure that n is at most `room`."""
        start = self.n_written % len(self._samples)
        head = min(len(block), len(self._samples) - start)
        self._samples[start : start + head] = block[:head]
        self._samples[: len(block) - head] = block[head:]
        self.n_written += len(block)

    def read_into(self, out: Float32Array) -> int:
        """Fill `out`, shape (n, n_channels), with the oldest samples, then silence; returns how many were there."""
        self.n_read = max(self.n_read, self._skip_to)
        n = min(len(out), self.n_written - self.n_read)
        start = self.n_read % len(self._samples)
        head = min(n, len(self._samples) - start)
        out[:head] = self._samples[start : start + head]
        out[head:n] = self._samples[: n - head]
        out[n:] = 0
        self.n_read += n
        return n

    def skip(self) -> None:
        """Have the reader pass over everything written so far; called by the writer."""
        self._skip_to = self.n_written


AHEAD = SAMPLE_RATE // 5
"""Samples that are written at most before they play; the mouth of a head that talks may be ahead by as much."""
LATENCY = 0.05
"""What is asked of the card, seconds."""


class Output(Protocol):
    """Plays what is written to it, at 44.1 kHz."""

    name: str
    is_card: bool
    gain: float

    @property
    def room(self) -> int:
        """Samples per channel that can be written now."""
        ...

    @property
    def n_written(self) -> int:
        """Samples per channel written since the opening."""
        ...

    @property
    def heard(self) -> float:
        """Number of the sample that is playing now, counted like `n_written`."""
        ...

    @property
    def lost(self) -> bool:
        """Whether the device has gone away."""
        ...

    @property
    def alive(self) -> bool:
        """Whether the device asks for sound: some open, and then stand still."""
        ...

    def write(self, block: Float32Array) -> None:
        """Append a block, shape (n, n_channels), n at most `room`."""
        ...

    def skip(self) -> None:
        """Discard everything that is written but not yet played."""
        ...

    def run(self, running: bool) -> None:
        """Go on, or hold still where it is."""
        ...

    def close(self) -> None:
        """Let the device go."""
        ...


class ClockOutput:
    """No sound card: time passes all the same, and samples count as played by the clock.

    Parameters
    ----------
    reason : why there is no card, in a sentence; empty where one was there and has gone.
    clock : tells the time, seconds.
    """

    name = "No audio device (silent playback)"
    is_card = False
    lost = False
    alive = True

    def __init__(self, reason: str = "", clock: Callable[[], float] = time.monotonic) -> None:
        self.reason = reason
        self._clock = clock
        self.gain = 1.0
        self.n_written = 0
        self._heard = 0.0
        self._since: float | None = None
        self._moving = threading.Lock()

    @property
    def room(self) -> int:
        """Samples that can be written now."""
        return AHEAD - (self.n_written - int(self.heard))

    @property
    def heard(self) -> float:
        """Number of the sample whose time it is; never beyond what was written."""
        with self._moving:
            return self._move()

    def write(self, block: Float32Array) -> None:
        """Count a block; time in which there was nothing to play is not made up for."""
        with self._moving:
            self._move()
            self.n_written += len(block)

    def skip(self) -> None:
        """Pass over everything that is written."""
        with self._moving:
            self._move()
            self._heard = float(self.n_written)

    def run(self, running: bool) -> None:
        """Go on, or hold still."""
        with self._moving:
            self._move()
            self._since = self._clock() if running else None

    def close(self) -> None:
        """Nothing has to be let go."""

    def _move(self) -> float:
        now = self._clock()
        if self._since is not None:
            self._heard = min(self._heard + (now - self._since) * SAMPLE_RATE, float(self.n_written))
            self._since = now
        return self._heard


class CardOutput:
    """A sound card.

    The callback copies samples and notes which one leaves when; nothing else happens there.

    Parameters
    ----------
    n_channels : of what is written.
    device : which one; None for the system's default.
    clock : tells the time, seconds.

    Raises
    ------
    DeviceError : there is no sound card, no PortAudio, or the card cannot be opened.
    """

    is_card = True

    def __init__(
        self, n_channels: int, device: Device | None = None, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self.gain = 1.0
        self._clock = clock
        self._ring = Ring(AHEAD, n_channels)
        self._running = False
        self._latest = 0.0
        self._moving = threading.Lock()
        self._mark = (0, 0.0, 0)
        self._asked = -math.inf
        self._opened = self._clock()
        self._stream = CardStream("output", device, SAMPLE_RATE, n_channels, LATENCY, self._fill)
        self._opened = self._clock()
        self.name = self._stream.name

    @property
    def room(self) -> int:
        """Samples that can be written now."""
        return self._ring.room

    @property
    def n_written(self) -> int:
        """Samples written since the opening."""
        return self._ring.n_written

    @property
    def heard(self) -> float:
        """Number of the sample that leaves the card now, by the stream's own clock; never runs back."""
        with self._moving:
            first, leaves_at, n = self._mark
            if self._running:
                since = math.inf if self._stream.ended else (self._stream.time - leaves_at) * SAMPLE_RATE
                self._latest = float(max(min(first + since, first + n), self._latest))
            return self._latest

    @property
    def lost(self) -> bool:
        """Whether the stream ended without our doing, or has stalled."""
        stalled = self._clock() - max(self._asked, self._opened) > STALLED
        return self._stream.lost or (stalled and not self._stream.ended)

    @property
    def alive(self) -> bool:
        """Whether the card asks for sound, beyond what even one that stands still takes in advance."""
        return not self._stream.ended and self._asked - self._opened > 2 * LATENCY

    def write(self, block: Float32Array) -> None:
        """Append a block."""
        self._ring.write(block)

    def skip(self) -> None:
        """Pass over everything that is written."""
        with self._moving:
            self._ring.skip()
            self._latest = float(self._ring.n_written)
            self._mark = (self._ring.n_written, math.inf, 0)

    def run(self, running: bool) -> None:
        """Go on, or hold still."""
        self._latest = self.heard
        self._running = running

    def close(self) -> None:
        """Let the card go at once."""
        self._stream.close()

    def _fill(self, out: Float32Array, _n: int, times: Any, _status: Any) -> None:
        self._asked = self._clock()
        if not self._running:
            out[:] = 0
            return
        n = self._ring.read_into(out)
        out *= np.float32(self.gain)
        if n:
            self._mark = (self._ring.n_read - n, times.outputBufferDacTime, n)


def open_output(n_channels: int, label: str = "") -> Output:
    """Open a sound card, or a clock where there is none.

    Parameters
    ----------
    n_channels : of what will be written.
    label : of the device; the system's default serves where that is empty, or the device is not there.
    """
    try:
        named = [d for d in openable_devices() if d.n_outputs and d.label == label] if label else []
        return CardOutput(n_channels, named[0] if named else None)
    except DeviceError as error:
        return ClockOutput(str(error))


SLOWEST = 0.25
"""Of the usual speed; slower speech falls apart."""
HELD = 4096
"""Samples of quiet that push the last ones out of the stretcher."""


class SlowedOutput:
    """Plays on another output, slowed down.

    The stretching is WSOLA (Verhelst and Roelands, ICASSP 1993), by the package audiotsm; everybody else goes on
    counting the sound's own samples.

    Parameters
    ----------
    output : what plays.
    n_channels : of what is written.
    speed : 0.25..1.

    Raises
    ------
    SettingsError : the speed lies outside.
    DeviceError : the package audiotsm is missing.
    """

    def __init__(self, output: Output, n_channels: int, speed: float) -> None:
        check_range("the speed", speed, (SLOWEST, 1, ""))
        self.name, self.is_card = output.name, output.is_card
        self._output = output
        self._n_channels = n_channels
        self._speed = speed
        self._stretcher = _stretcher(n_channels, speed)
        self._waiting: deque[Float32Array] = deque()
        self._moving = threading.Lock()
        self._base, self._written, self._stretched = 0, 0, output.n_written
        self._latest = 0.0

    @property
    def lost(self) -> bool:
        """Whether the device has gone away."""
        return self._output.lost

    @property
    def alive(self) -> bool:
        """Whether the device asks for sound."""
        return self._output.alive

    @property
    def gain(self) -> float:
        """How loud it plays, 0..1."""
        return self._output.gain

    @gain.setter
    def gain(self, gain: float) -> None:
        self._output.gain = gain

    @property
    def room(self) -> int:
        """Samples of the sound that can be written now."""
        with self._moving:
            self._pump()
            return AHEAD if not self._waiting else 0

    @property
    def n_written(self) -> int:
        """Samples of the sound that were written since the opening."""
        return self._written

    @property
    def heard(self) -> float:
        """Number of the sound's sample that is playing now."""
        with self._moving:
            self._pump()
            heard = self._output.heard
            drained = not self._waiting and heard >= self._output.n_written
            now = self._written if drained else self._base + (heard - self._stretched) * self._speed
            self._latest = max(self._latest, min(float(now), float(self._written)))
            return self._latest

    def write(self, block: Float32Array) -> None:
        """Append a block of the sound, shape (n, n_channels), n at most `room`."""
        with self._moving:
            self._written += len(block)
            self._waiting.append(self._slowed(block))
            self._pump()

    def skip(self) -> None:
        """Discard everything that is written but not yet played."""
        with self._moving:
            self._output.skip()
            self._waiting.clear()
            self._base, self._stretched = self._written, self._output.n_written
            self._latest = float(self._written)
            self._stretcher.clear()

    def run(self, running: bool) -> None:
        """Go on, or hold still where it is."""
        self._output.run(running)

    def close(self) -> None:
        """Let the device go."""
        self._output.close()

    def _pump(self) -> None:
        """Pass on as much of what is slowed as has room."""
        while self._waiting and (room := self._output.room) > 0:
            block = self._waiting.popleft()
            if len(block) > room:
                self._waiting.appendleft(block[room:])
            self._output.write(block[:room])
        if not self._waiting and self._output.heard >= self._output.n_written:
            self._flush()

    def _flush(self) -> None:
        """Play the last samples too, which wait in the stretcher for what follows."""
        missing = round((self._written - self._base) / self._speed) - (self._output.n_written - self._stretched)
        if missing > 0:
            rest = self._slowed(np.zeros((HELD, self._n_channels), np.float32))
            self._waiting.append(rest[:missing])
            self._stretcher.clear()
            self._base, self._stretched = self._written, self._output.n_written + min(missing, len(rest))
            self._pump()

    def _slowed(self, block: Float32Array) -> Float32Array:
        """Return what the stretcher has ready after a block, shape (n, n_channels)."""
        from audiotsm.io.array import ArrayReader, ArrayWriter  # noqa: PLC0415 - only who plays slowly needs it

        reader, writer = ArrayReader(np.ascontiguousarray(block.T)), ArrayWriter(self._n_channels)
        while not reader.empty:
            self._stretcher.read_from(reader)
            self._stretcher.write_to(writer)
        return np.ascontiguousarray(writer.data.T, np.float32)


def _stretcher(n_channels: int, speed: float) -> Any:
    try:
        from audiotsm import wsola  # noqa: PLC0415 - only who plays slowly needs it
    except ImportError as error:
        raise DeviceError(
            "sound cannot be slowed, since the package audiotsm is missing; pip install audiotsm"
        ) from error
    return wsola(n_channels, speed=speed)
