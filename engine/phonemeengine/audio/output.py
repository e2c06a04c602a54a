"""Where played sound goes: a sound card, or a clock where there is none.

Both count samples since they were opened, and say which one is playing now: the picture follows that.
"""

import math
import threading
import time
from collections.abc import Callable
from typing import Any, Protocol

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.devices import Device
from phonemeengine.audio.stream import STALLED, CardStream, openable_devices
from phonemeengine.errors import DeviceError
from phonemeengine.settings import SAMPLE_RATE

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
