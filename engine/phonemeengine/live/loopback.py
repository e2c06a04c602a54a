"""The latency of the whole loop, measured: a click is played and recorded."""

import statistics
import time
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.input import CardInput, Input
from phonemeengine.audio.output import CardOutput, Output
from phonemeengine.audio.stream import STALLED, InputChoice
from phonemeengine.errors import DeviceError
from phonemeengine.settings import SAMPLE_RATE

N_CLICKS = 8
EVERY = 0.4
"""Seconds from one click to the next; an echo has died away by then."""
CLICK = 0.01
"""Length of a click, seconds: a burst of noise, which resembles nothing but itself."""
CLEAR = 6.0
"""How much a click must stand out of everything else that is recorded, as a ratio of correlations."""


@dataclass(frozen=True)
class Loopback:
    """What a loopback measurement found; medians, seconds.

    Attributes
    ----------
    round_trip : from handing a click to the sound card until the program has it back.
    capture : the part of it from leaving the loudspeaker until the program has it; 0 where the card reports the
        leaving so late that nothing is left to tell.
    spread : from the shortest round trip to the longest.
    n_detected, n_played : clicks.
    """

    round_trip: float
    capture: float
    spread: float
    n_detected: int
    n_played: int


def measure_loopback(choice: InputChoice) -> Loopback:
    """Play clicks and listen for them, for three seconds or so.

    Raises
    ------
    DeviceError : a device cannot be opened, or less than half of the clicks are recorded.
    """
    microphone = CardInput(choice)
    try:
        speaker = CardOutput(1)
        try:
            speaker.run(running=True)
            _wait_for(speaker, microphone)
            found = [_click(speaker, microphone) for _ in range(N_CLICKS)]
        finally:
            speaker.close()
    finally:
        microphone.close()
    caught = [times for times in found if times is not None]
    if len(caught) * 2 < N_CLICKS:
        raise DeviceError(
            f"only {len(caught)} of {N_CLICKS} clicks were recorded; turn the loudspeaker up, or move the microphone"
        )
    trips = [trip for trip, _ in caught]
    capture = max(0.0, statistics.median(capture for _, capture in caught))
    return Loopback(statistics.median(trips), capture, max(trips) - min(trips), len(caught), N_CLICKS)


def _wait_for(speaker: Output, microphone: Input) -> None:
    """Wait until both devices work: a slow one sleeps for a while after it is opened.

    Raises
    ------
    DeviceError : one of them does nothing.
    """
    deadline, came = time.monotonic() + STALLED, False
    while not (came and speaker.alive):
        came = bool(len(microphone.read(0.02))) or came
        if time.monotonic() > deadline:
            name = speaker.name if came else microphone.name
            raise DeviceError(f"{name} opens, but does nothing within {STALLED:g} s; check it, or choose another")


def _click(speaker: CardOutput, microphone: CardInput) -> tuple[float, float] | None:
    """Return the seconds from playing and from leaving the card to its arrival; None where it did not arrive."""
    microphone.read(0)
    first = speaker.n_written
    click = _burst(SAMPLE_RATE)
    speaker.write(np.concatenate([click, np.zeros(SAMPLE_RATE // 20, np.float32)])[:, np.newaxis])
    played = time.monotonic()
    left, blocks, arrivals = None, [], []
    while (now := time.monotonic()) < played + EVERY:
        block = microphone.read(0.002)
        if len(block):
            blocks.append(block[:, 0])
            arrivals += [now] * len(block)
        if left is None and speaker.heard > first:
            left = now - (speaker.heard - first) / SAMPLE_RATE
    at = _place_of(_burst(microphone.rate), np.concatenate(blocks) if blocks else np.zeros(0, np.float32))
    if at is None or left is None:
        return None
    return arrivals[at] - played, arrivals[at] - left


def _burst(rate: int) -> Float32Array:
    """Return the click at a rate: the same sound at each."""
    n, seconds = round(CLICK * rate), np.arange(round(CLICK * rate)) / rate
    tones = np.random.default_rng(5).uniform(500, 6000, 40)
    phases = np.random.default_rng(6).uniform(0, 2 * np.pi, 40)
    wave = np.sin(2 * np.pi * tones * seconds[:, np.newaxis] + phases).sum(axis=1) * np.hanning(n)
    burst: Float32Array = (0.8 * wave / np.abs(wave).max()).astype(np.float32)
    return burst


def _place_of(click: Float32Array, recorded: Float32Array) -> int | None:
    """Find where a click begins in the recording; None where nothing stands out."""
    if len(recorded) < len(click):
        return None
    match = np.abs(np.correlate(recorded, click, mode="valid"))
    at = int(match.argmax())
    elsewhere = np.delete(match, np.s_[max(0, at - len(click)) : at + len(click)])
    floor = float(np.sqrt(np.mean(elsewhere**2))) if len(elsewhere) else 0.0
    return at if match[at] > CLEAR * max(floor, 1e-6) else None
