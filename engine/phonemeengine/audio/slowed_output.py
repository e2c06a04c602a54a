"""An output that plays slower and keeps the pitch; everybody else goes on counting the sound's own samples.

The stretching is WSOLA (Verhelst and Roelands, ICASSP 1993), by the package audiotsm.
"""

import threading
from collections import deque
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.output import AHEAD, Output
from phonemeengine.errors import DeviceError, check_range

SLOWEST = 0.25
"""Of the usual speed; slower speech falls apart."""
HELD = 4096
"""Samples of quiet that push the last ones out of the stretcher."""


class SlowedOutput:
    """Plays on another output, slowed down.

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
