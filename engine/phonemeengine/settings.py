"""What one analysis agrees on: the fixed grid of frames, and the filters with their parameters."""

import math
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Any

from phonemeengine.errors import SettingsError

SAMPLE_RATE = 44_100
"""Samples per second of everything that is analysed; other rates are resampled to it."""

WINDOW = 2048
"""Samples under one frame (46.4 ms)."""

HOP = 441
"""Samples from one frame to the next (10 ms)."""

FRAME_PERIOD = HOP / SAMPLE_RATE
"""Seconds from one frame to the next."""

BIN_WIDTH = SAMPLE_RATE / WINDOW
"""Hertz from one bin to the next (21.53), whatever the quantisation."""


class Filter(StrEnum):
    """The steps that can be switched on and off, in the order in which the sound passes them."""

    QUANTISE = "quantise"
    PRE_EMPHASIS = "pre_emphasis"
    WINDOW_FUNCTION = "window_function"
    FREQUENCY_SMOOTH = "frequency_smooth"
    TIME_SMOOTH = "time_smooth"
    HIGH_PASS = "high_pass"
    LOW_PASS = "low_pass"
    DENOISE = "denoise"
    MEL = "mel"
    NORMALISE = "normalise"


class Decimation(StrEnum):
    """How quantising drops samples: ``plain`` folds high frequencies down, ``anti_aliased`` removes them."""

    PLAIN = "plain"
    ANTI_ALIASED = "anti_aliased"


class WindowFunction(StrEnum):
    """The weight that each sample of a frame gets before the Fourier transform."""

    RECTANGLE = "rectangle"
    BARTLETT = "bartlett"
    HANN = "hann"
    HAMMING = "hamming"
    BLACKMAN_HARRIS = "blackman_harris"


class Ear(StrEnum):
    """What a sound is heard with: by who does not know yet what comes, or who does.

    ``live`` is the preset's own recogniser, ``twin`` its network for files, which hears as far ahead as back, and
    ``whisper`` a speech encoder together with the network.
    """

    LIVE = "live"
    TWIN = "twin"
    WHISPER = "whisper"


MOST_CHANNELS = 1024
"""The highest number that a channel may have."""


class Channel(StrEnum):
    """Which channel of a sound is analysed: one of them, or the mean of all.

    ``Channel("3")`` is the third; left is the first, and right the second.
    """

    MIX = "mix"
    LEFT = "left"
    RIGHT = "right"

    @property
    def number(self) -> int:
        """Counted from 1; 0 for the mix."""
        known = (Channel.MIX, Channel.LEFT, Channel.RIGHT)
        return known.index(self) if self in known else int(self.value)

    @classmethod
    def _missing_(cls, value: object) -> "Channel | None":
        """Make the channels that have no other name than their number, each once."""
        if not isinstance(value, str) or not value.isdecimal() or int(value) > MOST_CHANNELS:
            return None
        number = int(value)
        if number <= cls.RIGHT.number:
            return (cls.MIX, cls.LEFT, cls.RIGHT)[number]
        made = str.__new__(cls, number)
        made._name_ = made._value_ = str(number)
        known = cls._value2member_map_.setdefault(made.value, made)
        return known if isinstance(known, Channel) else None


QUANTISATIONS = (1, 2, 4)
THESIS_FILTERS = frozenset({Filter.QUANTISE, Filter.HIGH_PASS, Filter.NORMALISE})
"""The filters of the thesis that act with its usual numbers; both blurs and denoise stand at 0 there."""
STRENGTHS: dict[Filter, tuple[str, float]] = {
    Filter.PRE_EMPHASIS: ("pre_emphasis", 0.97),
    Filter.FREQUENCY_SMOOTH: ("frequency_smooth", 0.5),
    Filter.TIME_SMOOTH: ("time_smooth", 0.5),
    Filter.DENOISE: ("denoise_threshold", 0.001),
}
"""The filters that do nothing at strength 0: the field of the strength, and what is usual."""

# name: (lowest, highest, unit) of every parameter that is a plain number
LIMITS: dict[str, tuple[float, float, str]] = {
    "pre_emphasis": (0.0, 1.0, ""),
    "frequency_smooth": (0.0, 1.0, ""),
    "time_smooth": (0.0, 1.0, ""),
    "high_pass_start": (0.0, SAMPLE_RATE / 2, "Hz"),
    "high_pass_end": (0.0, SAMPLE_RATE / 2, "Hz"),
    "low_pass_start": (0.0, SAMPLE_RATE / 2, "Hz"),
    "low_pass_end": (0.0, SAMPLE_RATE / 2, "Hz"),
    "denoise_threshold": (0.0, 1.0, ""),
    "mel_bands": (4, 80, "bands"),
    "minimum_hold": (0.0, 1.0, "s"),
    "hysteresis": (0.0, 1.0, ""),
    "look_ahead": (0.0, 0.05, "s"),
    "live_look_ahead": (0.0, 0.05, "s"),
    "intensity_low": (-120.0, 0.0, "dB"),
    "intensity_high": (-120.0, 0.0, "dB"),
}
PAIRS = (
    ("high_pass_start", "high_pass_end"),
    ("low_pass_start", "low_pass_end"),
    ("intensity_low", "intensity_high"),
)
"""Parameters of which the first must not exceed the second."""


@dataclass(frozen=True)
class AnalysisSettings:
    """Every choice between the raw window and the recogniser's answer.

    A filter acts only while it is in `filters`; its parameters stay when it is switched off.

    Parameters
    ----------
    filters : the filters that are on.
    quantise : keep every n-th sample, n in 1, 2, 4.
    decimation : whether quantising folds (plain) or is band-limited first.
    pre_emphasis : a of ``x[n] - a x[n-1]``, 0..1.
    window_function : the weighting while `Filter.WINDOW_FUNCTION` is on; off means rectangle.
    frequency_smooth, time_smooth : strengths of the two blurs, 0..1.
    high_pass_start, high_pass_end : the ramp rises from 0 to 1 between them, Hz.
    low_pass_start, low_pass_end : the ramp falls from 1 to 0 between them, Hz.
    denoise_threshold : amplitudes below it become 0; full scale is 1.
    mel_bands : number of triangular filters of the mel bank, 4..80.
    statistics : whether flicker is held and unidentified frames are replaced.
    minimum_hold : least time that a phoneme stays, seconds.
    hysteresis : by how much another phoneme must be the better one to follow, 0..1; 0 lets the best one follow.
    look_ahead : how long a recogniser may wait for what comes after a frame, seconds; those of rules never wait.
    live_look_ahead : the same for a microphone, where waiting makes the mouth late; no longer than `look_ahead`.
    intensity_low, intensity_high : peak levels at which the intensity is 0 and 1, dB below full scale.

    Raises
    ------
    SettingsError : a value lies outside its range.
    """

    filters: frozenset[Filter] = THESIS_FILTERS
    quantise: int = 4
    decimation: Decimation = Decimation.PLAIN
    pre_emphasis: float = 0.97
    window_function: WindowFunction = WindowFunction.HAMMING
    frequency_smooth: float = 0.0
    time_smooth: float = 0.0
    high_pass_start: float = 100.0
    high_pass_end: float = 150.0
    low_pass_start: float = 10_000.0
    low_pass_end: float = 11_000.0
    denoise_threshold: float = 0.0
    mel_bands: int = 40
    statistics: bool = True
    minimum_hold: float = 0.02
    hysteresis: float = 0.0
    look_ahead: float = 0.05
    live_look_ahead: float = 0.02
    intensity_low: float = -45.0
    intensity_high: float = -3.0

    def __post_init__(self) -> None:
        if self.quantise not in QUANTISATIONS:
            raise SettingsError(f"quantise must be one of 1, 2, 4, got {self.quantise}")
        for name, (low, high, unit) in LIMITS.items():
            value = getattr(self, name)
            if not (math.isfinite(value) and low <= value <= high):
                raise SettingsError(f"{name} must lie in {low:g}..{high:g} {unit}".rstrip() + f", got {value:g}")
        for lower, upper in PAIRS:
            self._check_order(lower, upper)

    def with_filter(self, step: Filter, on: bool) -> "AnalysisSettings":
        """Return the settings with a filter on or off; one that would do nothing gets its usual strength."""
        if not on:
            return replace(self, filters=self.filters - {step})
        name, usual = STRENGTHS.get(step, ("", 0.0))
        strength: dict[str, Any] = {name: usual} if name and not getattr(self, name) else {}
        return replace(self, filters=self.filters | {step}, **strength)

    def with_numbers(self, **numbers: Any) -> "AnalysisSettings":
        """Return the settings with other numbers; a filter whose strength changes is on while that is above 0."""
        filters = self.filters
        for step, (name, _) in STRENGTHS.items():
            strength = numbers.get(name, getattr(self, name))
            if strength != getattr(self, name):
                filters = filters | {step} if strength else filters - {step}
        return replace(self, filters=filters, **numbers)

    def with_number(self, name: str, value: Any) -> "AnalysisSettings":
        """Return the settings with another number; of two that are ordered, the other one gives way.

        A look-ahead for a microphone lengthens that for files where it is longer.
        """
        changes = {name: value}
        for low, high in (*PAIRS, ("live_look_ahead", "look_ahead")):
            if name == low:
                changes[high] = max(value, getattr(self, high))
            if name == high:
                changes[low] = min(value, getattr(self, low))
        return self.with_numbers(**changes)

    def _check_order(self, lower: str, upper: str) -> None:
        low, high = getattr(self, lower), getattr(self, upper)
        if low > high:
            raise SettingsError(f"{lower} must not exceed {upper}, got {low:g} above {high:g}")

    def has(self, step: Filter) -> bool:
        """Return whether a filter is on."""
        return step in self.filters

    @property
    def step(self) -> int:
        """Keep every `step`-th sample: the quantisation in force, 1 while the filter is off."""
        return self.quantise if self.has(Filter.QUANTISE) else 1

    @property
    def n_samples(self) -> int:
        """Samples of a window after quantising."""
        return WINDOW // self.step

    @property
    def n_bins(self) -> int:
        """Amplitudes of a spectrum: 256, 512 or 1024."""
        return self.n_samples // 2

    @property
    def window_in_force(self) -> WindowFunction:
        """The window function that is applied now."""
        return self.window_function if self.has(Filter.WINDOW_FUNCTION) else WindowFunction.RECTANGLE

    def front_end(self) -> str:
        """Describe all that shapes the spectra, for curve files and legends: equal words stand for equal filters."""
        quantised = f"quantise {self.step} {self.decimation}" if self.step > 1 else "quantise off"
        words = {
            Filter.PRE_EMPHASIS: f"pre_emphasis {self.pre_emphasis:.7g}",
            Filter.WINDOW_FUNCTION: f"window {self.window_function}",
            Filter.FREQUENCY_SMOOTH: f"frequency_smooth {self.frequency_smooth:.7g}",
            Filter.TIME_SMOOTH: f"time_smooth {self.time_smooth:.7g}",
            Filter.HIGH_PASS: f"high_pass {self.high_pass_start:.7g}-{self.high_pass_end:.7g} Hz",
            Filter.LOW_PASS: f"low_pass {self.low_pass_start:.7g}-{self.low_pass_end:.7g} Hz",
            Filter.DENOISE: f"denoise {self.denoise_threshold:.7g}",
            Filter.MEL: f"mel {self.mel_bands} bands",
            Filter.NORMALISE: "normalise",
        }
        return ", ".join([quantised, *(text for step, text in words.items() if self.has(step))])
