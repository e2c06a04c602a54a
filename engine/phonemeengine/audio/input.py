"""Where sound comes in: a microphone, followed sample by sample."""

import queue
import time
from collections.abc import Callable
from typing import Any, Protocol

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.dropouts import DropoutMeter
from phonemeengine.audio.stream import CardStream, Device, InputChoice, chosen_input, openable_devices
from phonemeengine.errors import DeviceError
from phonemeengine.settings import SAMPLE_RATE

STEADINESS = 0.99
"""How much of what is known of the card's delay stays with each block, since cards report it with much jitter."""


class Input(Protocol):
    """Gives the samples of a microphone."""

    name: str
    rate: int
    n_channels: int

    @property
    def lost(self) -> bool:
        """Whether the device has gone away."""
        ...

    @property
    def quiet(self) -> float:
        """Seconds since anything came, silence included."""
        ...

    @property
    def delay(self) -> float:
        """Seconds from the capture of a block's first sample to its arrival."""
        ...

    @property
    def n_lost(self) -> int:
        """Samples that the device lost."""
        ...

    def read(self, timeout: float) -> Float32Array:
        """Return what came since the last call, shape (n, n_channels); wait for it at most `timeout` seconds."""
        ...

    def time_of(self, sample: float) -> float:
        """Return when a sample was captured, counted with the lost ones, on the clock of `time.monotonic`."""
        ...

    def close(self) -> None:
        """Let the device go."""
        ...


class CardInput:
    """A sound card's input.

    The callback copies a block, and notes when it came; nothing else happens there.

    Raises
    ------
    DeviceError : the device is not there, lacks the channel, or cannot be opened.
    """

    def __init__(self, choice: InputChoice, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        device = chosen_input(choice, openable_devices())
        if choice.channel > device.n_inputs:
            raise DeviceError(
                f"{device.name} has {device.n_inputs} channels and so no channel {choice.channel}; choose another"
            )
        self.name = device.label
        self.n_channels = min(choice.n_channels, device.n_inputs)
        self._arrived: queue.SimpleQueue[tuple[float, float, bytes]] = queue.SimpleQueue()
        self._came = self._clock()
        self._age = self._length = 0.0
        self.rate, self._stream = self._open(device, choice)
        self._loss = DropoutMeter(self.rate)

    @property
    def lost(self) -> bool:
        """Whether the device has gone away."""
        return self._stream.lost

    @property
    def quiet(self) -> float:
        """Seconds since the last callback."""
        return self._clock() - self._came

    @property
    def delay(self) -> float:
        """Seconds from the capture of a block's first sample to its arrival, at least the block's length."""
        return max(self._age, self._length)

    @property
    def n_lost(self) -> int:
        """Samples that the device lost."""
        return self._loss.n_lost

    def read(self, timeout: float) -> Float32Array:
        """Return what came since the last call, shape (n, n_channels); wait for it at most `timeout` seconds."""
        try:
            blocks = [self._note(*self._arrived.get(timeout=timeout))]
        except queue.Empty:
            return np.zeros((0, self.n_channels), np.float32)
        while not self._arrived.empty():
            blocks.append(self._note(*self._arrived.get_nowait()))
        return blocks[0] if len(blocks) == 1 else np.concatenate(blocks)

    def time_of(self, sample: float) -> float:
        """Return when a sample was captured: what the card keeps back is taken off its arrival."""
        return self._loss.time_of(sample) - (self.delay - self._length)

    def close(self) -> None:
        """Let the card go at once."""
        self._stream.close()

    def _open(self, device: Device, choice: InputChoice) -> tuple[int, CardStream]:
        rates = [choice.rate] if choice.rate else list(dict.fromkeys((SAMPLE_RATE, device.rate)))
        for rate in rates[:-1]:
            try:
                return rate, self._stream_at(device, rate, choice.latency)
            except DeviceError:
                continue
        return rates[-1], self._stream_at(device, rates[-1], choice.latency)

    def _stream_at(self, device: Device, rate: int, latency: float) -> CardStream:
        return CardStream("input", device, rate, self.n_channels, latency, self._take)

    def _take(self, block: Any, _n: int, times: Any, _status: Any) -> None:
        self._came = self._clock()
        self._arrived.put((self._came, times.currentTime - times.inputBufferAdcTime, bytes(block)))

    def _note(self, came: float, age: float, samples: bytes) -> Float32Array:
        block = np.frombuffer(samples, np.float32).reshape(-1, self.n_channels)
        self._loss.observe(came, len(block))
        self._length = len(block) / self.rate
        kept = STEADINESS if self._age else 0.0
        self._age = kept * self._age + (1 - kept) * max(age, self._length)
        return block
