"""PortAudio as sounddevice shows it, with devices that a test plugs in, and streams that it drives."""

from collections.abc import Callable
from importlib.machinery import ModuleSpec
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray


class PortAudioError(Exception):
    """As sounddevice has it."""


class FakeStream:
    """Calls back when the test says so."""

    def __init__(self, portaudio: "FakePortAudio", callback: Callable[..., None], **options: Any) -> None:
        self.callback, self.options = callback, options
        self._finish = options["finished_callback"]
        self.began = False
        self.device = portaudio.default.device[0] if options["device"] is None else options["device"]
        self._hears = portaudio.hears_of(self.device)
        self.time = 50.0
        self.closed = False
        if portaudio.may_open is not None:
            portaudio.may_open(options)
        portaudio.streams.append(self)

    def start(self) -> None:
        """Nothing comes before the test says so."""
        self.began = True
        for k in range(0, len(self._hears), 441):
            self.bring(self._hears[k : k + 441])

    def abort(self, ignore_errors: bool = False) -> None:
        self._finish()

    def close(self, ignore_errors: bool = False) -> None:
        self.closed = True

    def vanish(self) -> None:
        """End as a stream does whose device is pulled out."""
        self._finish()

    def ask(self, n: int, latency: float = 0.0) -> NDArray[np.float32]:
        """Ask for n samples per channel, which leave the card after `latency` seconds."""
        out = np.full((n, self.options["channels"]), np.nan, np.float32)
        self.callback(out, n, SimpleNamespace(outputBufferDacTime=self.time + latency), None)
        return out

    def bring(self, samples: NDArray[np.float32], age: float = 0.0) -> None:
        """Bring a block, shape (n, n_channels), in memory that is used again, captured `age` seconds ago."""
        memory = bytearray(samples.astype(np.float32).tobytes())
        times = SimpleNamespace(currentTime=self.time, inputBufferAdcTime=self.time - age)
        self.callback(memory, len(samples), times, None)
        memory[:] = bytes(len(memory))


class FakePortAudio:
    """The module, as far as it is used."""

    PortAudioError = PortAudioError
    __spec__ = ModuleSpec("sounddevice", None)

    def __init__(self) -> None:
        self.apis = ["ALSA", "JACK"]
        self.default = SimpleNamespace(device=(-1, -1))
        self.hears: list[NDArray[np.float32] | None] = []
        self.plugged: list[dict[str, Any]] = []
        self.streams: list[FakeStream] = []
        self.may_open: Callable[[dict[str, Any]], None] | None = None
        self.n_initialised = 0
        self.answers = True
        self._listed: list[dict[str, Any]] = []
        self._up = True

    def plug(
        self,
        name: str,
        n_inputs: int = 1,
        *,
        api: int = 0,
        rate: float = 48_000.0,
        hears: NDArray[np.float32] | None = None,
    ) -> None:
        """Plug a device in; it is listed after the next initialisation, and brings what it hears at once."""
        self.hears.append(hears)
        self.plugged.append(
            {
                "name": name,
                "hostapi": api,
                "max_input_channels": n_inputs,
                "max_output_channels": 0,
                "default_samplerate": rate,
            }
        )

    def hears_of(self, device: int) -> NDArray[np.float32]:
        """Give what a device hears, shape (n, 1); nothing where the test brings it."""
        hears = self.hears[device] if 0 <= device < len(self.hears) else None
        return np.zeros((0, 1), np.float32) if hears is None else hears[:, np.newaxis]

    def query_hostapis(self) -> list[dict[str, str]]:
        return [{"name": name} for name in self.apis]

    def query_devices(self, number: int | None = None) -> Any:
        return self._listed if number is None else self._listed[number]

    def RawInputStream(self, **options: Any) -> FakeStream:
        return FakeStream(self, **options)

    def OutputStream(self, **options: Any) -> FakeStream:
        return FakeStream(self, **options)

    def _terminate(self) -> None:
        if not self._up:
            raise PortAudioError("PortAudio not initialized")
        self._up = False
        assert not [stream for stream in self.streams if not stream.closed], "this would end a stream"

    def _initialize(self) -> None:
        if not self.answers:
            raise PortAudioError("Error initializing PortAudio: Unanticipated host error")
        self._up = True
        self.n_initialised += 1
        self._listed = list(self.plugged)
