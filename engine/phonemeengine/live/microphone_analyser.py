"""One opened microphone, from its samples to what was found in them."""

import time
from dataclasses import dataclass

import numpy as np

from phonemeengine.analyser import Analyser, Analysis
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.input import Input
from phonemeengine.audio.mixing import cancels
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE, WINDOW

FADING = 0.99999
"""How much of what was measured of the channels stays with each sample: some two seconds of it."""
AUDIBLE = 1.0
"""Least sum of squares, of samples within ±1, by which channels are judged."""
STEADINESS = 0.98
"""How much of what was measured before stays in a latency with each block."""


@dataclass(frozen=True)
class Latency:
    """How long a sound takes to become a phoneme, on the average, seconds.

    Attributes
    ----------
    capture : the device's buffers, and the resampler's where there is one.
    window : from the middle of a frame to the end of its window.
    hop : waiting for the hop to be complete, half a hop on the average.
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
    channel : the channel that is heard, counted from 1; 0 mixes them all.
    preset : what to recognise with.
    pitch : measure ``f0`` too.
    start : number of its first frame.
    phonemes_only : leave spectra, waveforms and variables out where the recogniser needs none.
    """

    def __init__(
        self, source: Input, channel: int, preset: Preset, *, pitch: bool, start: int, phonemes_only: bool = False
    ) -> None:  # fmt: skip
        self.source = source
        self.start = start
        self._n_heard = 0
        self._spent = self._look_ahead = 0.0
        self._products: Float64Array = np.zeros((1, 1))
        self._columns = slice(channel - 1, channel) if channel else slice(None)
        self.analyser = Analyser(
            preset, rate=source.rate, live=True, pitch=pitch, start=start, phonemes_only=phonemes_only
        )

    @property
    def n_channels(self) -> int:
        """Channels of what is heard."""
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
        return self.start * FRAME_PERIOD + self._n_heard / self.source.rate

    @property
    def lost_seconds(self) -> float:
        """Sound that the device lost since it was opened, seconds; frames are counted without it."""
        return self.source.n_lost / self.source.rate

    def pick_channels(self, block: Float32Array) -> Float32Array:
        """Return the channels that are heard, shape (n, n_channels), of what the microphone gave."""
        return block[:, self._columns]

    def set_preset(self, preset: Preset) -> None:
        """Recognise with another preset from the next block on."""
        self.analyser.set_preset(preset)

    def analyse(self, block: Float32Array) -> Analysis:
        """Analyse what is heard, shape (n, n_channels)."""
        began = time.monotonic()
        self._n_heard += len(block)
        if block.shape[1] > 1:
            self._products = FADING ** len(block) * self._products + block.T @ block
        analysis = self.analyser.push(block)
        self._look_ahead = self.analyser.recogniser.look_ahead * FRAME_PERIOD  # asked here: it may be made now
        spent = time.monotonic() - began
        self._spent = STEADINESS * (self._spent or spent) + (1 - STEADINESS) * spent
        return analysis

    def time_of(self, frame: int) -> float:
        """Return when the middle of a frame sounded, on the clock of `time.monotonic`."""
        sample = (frame - self.start) * HOP + HOP // 2
        return self.source.time_of(sample / SAMPLE_RATE * self.source.rate + self.source.n_lost)
