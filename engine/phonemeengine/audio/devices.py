"""Sound devices by name: their numbers change with every replug, so none is stored."""

from collections.abc import Sequence
from dataclasses import dataclass

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
