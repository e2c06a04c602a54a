"""Sound cards and their streams, through PortAudio: the only module that imports sounddevice.

Devices go by name: their numbers change with every replug, so none is stored.

PortAudio belongs to the whole process and its list of devices stays as it was when it was initialised, so the list
is made anew whenever no stream is open. A lock keeps threads from doing two of these things at once.
"""

import json
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from importlib.util import find_spec
from typing import Any, Literal

from phonemeengine.errors import DeviceError, check_range

LOWEST_LATENCY, HIGHEST_LATENCY = 0.01, 1.0
"""Latencies that may be asked for, seconds."""
MOST_CHANNELS = 64
"""The highest number that a channel may have."""
LOWEST_RATE, HIGHEST_RATE = 4_000, 384_000
"""Sample rates that may be asked for, Hz."""


@dataclass(frozen=True)
class Device:
    """A sound device as one of the system's sound systems offers it.

    Attributes
    ----------
    name : as the sound system calls it.
    host_api : the sound system, such as ``ALSA``, ``Core Audio`` or ``Windows WASAPI``.
    n_inputs, n_outputs : channels that it records and plays.
    rate : the sample rate that it suggests, Hz.
    is_default : whether the system takes this one for recording where none is named.
    """

    name: str
    host_api: str
    n_inputs: int
    n_outputs: int
    rate: int
    is_default: bool

    @property
    def label(self) -> str:
        """Name and sound system, which together are what a user chooses."""
        return f"{self.name} · {self.host_api}"


@dataclass(frozen=True)
class InputChoice:
    """What to record from, in words that outlive a replug.

    Attributes
    ----------
    label : the device's label, its name, or a part of it that no other has; empty for the system's default.
    channel : which of its channels, counted from 1; 0 mixes the first two.
    rate : sample rate, Hz; 0 takes 44.1 kHz where the device has it, else what the device suggests.
    else_default : record from the system's default device while this one is not there.
    latency : what is asked of the device, seconds. PortAudio makes four blocks of it: longer ones cost less processor
        time, and a busy machine may come later without losing any.

    Raises
    ------
    SettingsError : a number lies outside its range.
    """

    label: str = ""
    channel: int = 1
    rate: int = 0
    else_default: bool = False
    latency: float = 0.08

    def __post_init__(self) -> None:
        check_range("the channel", self.channel, (0, MOST_CHANNELS, ""))
        check_range("the latency", self.latency, (LOWEST_LATENCY, HIGHEST_LATENCY, "s"))
        if self.rate:
            check_range("the sample rate", self.rate, (LOWEST_RATE, HIGHEST_RATE, "Hz"))

    @property
    def n_channels(self) -> int:
        """Channels that have to be opened."""
        return self.channel or 2


def inputs_of(devices: Sequence[Device]) -> list[Device]:
    """Return the devices that record, the default one first."""
    return sorted((d for d in devices if d.n_inputs), key=lambda d: not d.is_default)


def outputs_of(devices: Sequence[Device]) -> list[Device]:
    """Return the devices that play."""
    return [d for d in devices if d.n_outputs]


def chosen_input(choice: InputChoice, devices: Sequence[Device]) -> Device:
    """Find the device that a choice names.

    Raises
    ------
    DeviceError : there is none, or several whose names contain the words.
    """
    inputs = inputs_of(devices)
    if not inputs:
        raise DeviceError("no microphone was found; connect one, or check that the audio system is running")
    if not choice.label:
        return inputs[0]
    found = _named(choice.label, inputs)
    if not found and choice.else_default:
        return inputs[0]
    if len(found) != 1:
        fault = "fits several" if found else "is not connected"
        known = ", ".join(d.label for d in found or inputs)
        raise DeviceError(f"the microphone {choice.label!r} {fault}; choose one of: {known}")
    return found[0]


def _named(label: str, inputs: Sequence[Device]) -> list[Device]:
    """Return the device that is called so, the first of equals, else those whose label contains the words."""
    exact = [d for d in inputs if d.label == label] or [d for d in inputs if d.name == label]
    found = [d for d in inputs if label.casefold() in d.label.casefold()]
    usual = [d for d in found if d.host_api == inputs[0].host_api]  # Windows offers each under several systems
    return exact[:1] or (usual if len(usual) == 1 else found)


Callback = Callable[[Any, int, Any, Any], None]
"""Called by PortAudio with a block, n, times and status; copies, counts, and leaves.

A block to fill is an array, float32, shape (n, n_channels); one that came is raw memory of the same layout.
"""

WITHOUT_SOUNDDEVICE = (
    "audio cannot be played or recorded, since the package sounddevice is missing; install it with pip install "
    "sounddevice"
)
CLOSE_TIMEOUT = 10.0
"""Seconds that another process may take to list the devices."""
STALLED = 5.0
"""Seconds after which a card is lost that asks for nothing, or brings nothing.

The slowest ones sleep for 2 s, such as PulseAudio's null sink before its first sound; a busy machine adds to that.
"""

_portaudio_lock = threading.RLock()
_open: "set[CardStream]" = set()


def devices() -> list[Device]:
    """List the sound devices that are there now.

    While a stream is open, another process looks, since a new list would end the stream.

    Raises
    ------
    DeviceError : PortAudio is missing.
    """
    with _portaudio_lock:
        if not _open:
            return openable_devices()
    command = [sys.executable, "-c", f"from {__name__} import print_devices; print_devices()"]
    try:
        seen = subprocess.run(command, capture_output=True, timeout=CLOSE_TIMEOUT, check=True)  # noqa: S603 - our own words
        return [Device(**values) for values in json.loads(seen.stdout)]
    except (OSError, subprocess.SubprocessError, ValueError):  # then at least those that were there
        return openable_devices()


def openable_devices() -> list[Device]:
    """List the devices that can be opened: those there now, or while a stream is open, those at its opening.

    Raises
    ------
    DeviceError : PortAudio is missing.
    """
    with _portaudio_lock:
        sounddevice = _sounddevice()
        _rescan(sounddevice)
        apis = [str(api["name"]) for api in sounddevice.query_hostapis()]
        default = sounddevice.default.device[0]
        return [
            Device(
                name=str(d["name"]),
                host_api=apis[d["hostapi"]],
                n_inputs=int(d["max_input_channels"]),
                n_outputs=int(d["max_output_channels"]),
                rate=round(d["default_samplerate"]),
                is_default=k == default,
            )
            for k, d in enumerate(sounddevice.query_devices())
        ]


def print_devices() -> None:
    """Print the devices that are there as JSON, for another process."""
    sys.stdout.write(json.dumps([asdict(device) for device in devices()]))


class CardStream:
    """An open stream, in or out, that runs until it is closed or its device goes away.

    Parameters
    ----------
    direction : ``input`` or ``output``.
    device : None for the system's default.
    rate : sample rate, Hz.
    n_channels : channels.
    latency : suggested latency, seconds.
    callback : takes or fills the blocks.

    Raises
    ------
    DeviceError : there is no such device, no PortAudio, or it cannot be opened that way.
    """

    def __init__(
        self,
        direction: Literal["input", "output"],
        device: Device | None,
        rate: int,
        n_channels: int,
        latency: float,
        callback: Callback,
    ) -> None:
        self._closing = False
        self._finished = False
        with _portaudio_lock:
            sounddevice = _sounddevice()
            _rescan(sounddevice)
            kind = sounddevice.RawInputStream if direction == "input" else sounddevice.OutputStream
            try:
                self._stream = kind(
                    samplerate=rate,
                    channels=n_channels,
                    device=None if device is None else _number_of(device, sounddevice),
                    dtype="float32",
                    latency=latency,
                    callback=callback,
                    finished_callback=self._finish,
                )
                self._start()
                self.name = str(sounddevice.query_devices(self._stream.device)["name"])
            except (sounddevice.PortAudioError, ValueError) as error:
                raise DeviceError(
                    f"the audio device could not be opened ({_reason(error)}); check that it is connected and not in "
                    "use, or choose another"
                ) from error
            _open.add(self)

    @property
    def time(self) -> float:
        """The stream's clock, seconds."""
        return float(self._stream.time)

    @property
    def ended(self) -> bool:
        """Whether it runs no more, for whatever reason."""
        return self._finished

    @property
    def lost(self) -> bool:
        """Whether it ended without our doing: the device has gone away."""
        return self._finished and not self._closing

    def close(self) -> None:
        """Let the device go at once, without waiting for what is under way."""
        with _portaudio_lock:
            if self._closing:
                return
            self._closing = True
            _open.discard(self)
            self._stream.abort(ignore_errors=True)
            self._stream.close(ignore_errors=True)

    def _start(self) -> None:
        try:
            self._stream.start()
        except BaseException:
            self._stream.close(ignore_errors=True)
            raise

    def _finish(self) -> None:
        self._finished = True


def _rescan(sounddevice: Any) -> None:
    """Have PortAudio list the devices anew, which ends all streams, so only where none is open."""
    if _open:
        return
    try:
        with suppress(sounddevice.PortAudioError):  # what could not be initialised the last time needs no end
            sounddevice._terminate()
        sounddevice._initialize()
    except sounddevice.PortAudioError as error:
        raise DeviceError(
            f"the audio system does not respond ({_reason(error)}); check that it is running"
        ) from error


def _number_of(device: Device, sounddevice: Any) -> int:
    apis = [str(api["name"]) for api in sounddevice.query_hostapis()]
    for k, d in enumerate(sounddevice.query_devices()):
        if (str(d["name"]), apis[d["hostapi"]]) == (device.name, device.host_api):
            return k
    raise ValueError(f"{device.label} is not there")


def missing_library() -> str:
    """Return why no sound card can be used, in a sentence, where the package is not installed; empty where it is."""
    return "" if find_spec("sounddevice") is not None else WITHOUT_SOUNDDEVICE


def _sounddevice() -> Any:
    try:
        import sounddevice  # noqa: PLC0415 - raises where PortAudio is missing, so only who plays imports it
    except ImportError as error:
        raise DeviceError(WITHOUT_SOUNDDEVICE) from error
    except Exception as error:  # sounddevice initialises PortAudio, which may fail in its own ways
        raise DeviceError(
            "audio cannot be played or recorded, since PortAudio is missing or broken; install libportaudio2"
        ) from error
    return sounddevice


def _reason(error: Exception) -> str:
    return str(error).splitlines()[0][:120]
