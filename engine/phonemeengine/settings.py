"""What one analysis agrees on: the fixed grid of frames, and the filters with their parameters."""

from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Any

from typing_extensions import override

from phonemeengine.errors import SettingsError, check_range

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


class ModelKind(StrEnum):
    """The models of a preset, of which one recognises.

    ``real-time`` is the preset's own recogniser (rules, templates or the small network), ``encoder`` the lower layers
    of a speech encoder together with the small network, ``offline`` the network for files, which sees as much of what
    follows a frame as of what precedes it, and ``whisper`` a head on Whisper base together with the offline model.

    ``ModelKind("live")`` and ``ModelKind("twin")``, as version 1 of presets called two of them, are ``real-time`` and
    ``offline``.
    """

    REAL_TIME = "real-time"
    ENCODER = "encoder"
    OFFLINE = "offline"
    WHISPER = "whisper"

    @classmethod
    @override
    def _missing_(cls, value: object) -> "ModelKind | None":
        return OLD_MODEL_KINDS.get(value) if isinstance(value, str) else None


class Decoding(StrEnum):
    """Whether a search finds the likeliest phonemes behind the answers of rules, and by which language's statistics.

    ``none`` is the search without a language.
    """

    OFF = "off"
    NONE = "none"
    CZECH = "cs"
    GERMAN = "de"
    ENGLISH = "en"
    SPANISH = "es"
    FINNISH = "fi"
    FRENCH = "fr"
    ITALIAN = "it"
    RUSSIAN = "ru"


OLD_MODEL_KINDS = {"live": ModelKind.REAL_TIME, "twin": ModelKind.OFFLINE}
"""What presets of version 1 and older options called them."""


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
    @override
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


@dataclass(frozen=True)
class Parameter:
    """A number or a choice of the analysis: the one description for reading, checking, showing and writing it.

    Attributes
    ----------
    name : the field of `AnalysisSettings`, and the key in preset files.
    label : what it is called wherever people meet it; that of its stage, where that has no other parameter.
    part : what it is called beside its stage; empty where the stage has no other parameter.
    low, high : the range of a number.
    unit : of the number; empty where it has none.
    decimals, step : the digits after the point that matter, and how far an arrow key goes.
    usual : the largest usual value, where sliders end.
    choices : the words and the value of each, where it is no free number.
    optional : whether a preset file may lack it.
    """

    name: str
    label: str
    part: str = ""
    low: float = 0.0
    high: float = 1.0
    unit: str = ""
    decimals: int = 2
    step: float = 0.05
    usual: float = 1.0
    choices: tuple[tuple[str, Any], ...] = ()
    optional: bool = False

    @property
    def limits(self) -> tuple[float, float, str]:
        """The lowest and the highest value, and their unit."""
        return self.low, self.high, self.unit


@dataclass(frozen=True)
class Stage:
    """What a sound passes on its way to the answer: a filter, or what follows the filters.

    Attributes
    ----------
    name : that of its `Filter`, or what follows: ``statistics``, ``look_ahead`` and ``intensity``.
    label, hint : what it is called, and what it does.
    parameters : in the order in which they are shown and written.
    strength : the usual value of its parameter, where 0 does nothing.
    is_range : whether its first parameter must not exceed its second.
    hints : what each parameter does, where `hint` does not say it.
    """

    name: str
    label: str
    hint: str
    parameters: tuple[Parameter, ...] = ()
    strength: float = 0.0
    is_range: bool = False
    hints: tuple[str, ...] = ()


def _bound(name: str, label: str, part: str, decimals: int, step: float) -> Parameter:
    return Parameter(name, label, part, 0.0, SAMPLE_RATE / 2, "Hz", decimals, step, usual=1300.0)


def _level(name: str, label: str, part: str) -> Parameter:
    return Parameter(name, label, part, -120.0, 0.0, "dB", decimals=0, step=1.0)


QUANTISATIONS = (1, 2, 4)
DECODINGS = tuple(
    zip(
        ("Off", "Any language", "Czech", "German", "English", "Spanish", "Finnish", "French", "Italian", "Russian"),
        Decoding,
        strict=True,
    )
)
"""The words and the value of each choice of a decoder."""
_RATES = tuple((f"{n}: {SAMPLE_RATE // n:,} Hz".replace(",", " "), n) for n in QUANTISATIONS)
_METHODS = tuple((kind.replace("_", "-"), kind) for kind in Decimation)
_SHAPES = tuple((shape.replace("_", "-").title(), shape) for shape in WindowFunction)
_STAGES = (
    Stage(
        Filter.QUANTISE,
        "Quantise",
        "Keeps every n-th sample, which lowers the sample rate and keeps frequencies below half of that.",
        (
            Parameter("quantise", "Quantise", "Rate", choices=_RATES),
            Parameter("decimation", "Decimation", "Method", choices=_METHODS),
        ),
        hints=(
            "Keeps every sample, every second or every fourth.",
            "Plain lets high frequencies alias, as in the thesis; anti-aliased filters them out first.",
        ),
    ),
    Stage(
        Filter.PRE_EMPHASIS,
        "Pre-emphasis",
        "Boosts high frequencies: subtracts a share of the previous sample from each sample.",
        (Parameter("pre_emphasis", "Pre-emphasis", step=0.01),),
        strength=0.97,
    ),
    Stage(
        Filter.WINDOW_FUNCTION,
        "Window",
        "Fades each window in and out, which keeps a tone within few bins. Off: rectangle.",
        (Parameter("window_function", "Window", choices=_SHAPES),),
    ),
    Stage(
        Filter.FREQUENCY_SMOOTH,
        "Freq. smoothing",
        "Averages each bin with its neighbours; 1 is the mean of three bins.",
        (Parameter("frequency_smooth", "Freq. smoothing", decimals=3),),
        strength=0.5,
    ),
    Stage(
        Filter.TIME_SMOOTH,
        "Time smoothing",
        "Averages each spectrum with the previous one; closer to 1 is slower.",
        (Parameter("time_smooth", "Time smoothing", decimals=3),),
        strength=0.5,
    ),
    Stage(
        Filter.HIGH_PASS,
        "High-pass",
        "Removes frequencies below the start (hum, rumble) and fades in up to the end.",
        (
            _bound("high_pass_start", "High-pass start", "From", decimals=1, step=10.0),
            _bound("high_pass_end", "High-pass end", "To", decimals=1, step=10.0),
        ),
        is_range=True,
        hints=("Frequencies below are removed.", "Frequencies above pass unchanged."),
    ),
    Stage(
        Filter.LOW_PASS,
        "Low-pass",
        "Fades out from the start to the end and removes frequencies above.",
        (
            _bound("low_pass_start", "Low-pass start", "From", decimals=0, step=100.0),
            _bound("low_pass_end", "Low-pass end", "To", decimals=0, step=100.0),
        ),
        is_range=True,
        hints=("Frequencies below pass unchanged.", "Frequencies above are removed."),
    ),
    Stage(
        Filter.DENOISE,
        "Denoise",
        "Sets amplitudes below the threshold to 0.",
        (Parameter("denoise_threshold", "Denoise", decimals=5, step=0.0005, usual=0.1),),
        strength=0.001,
    ),
    Stage(
        Filter.MEL,
        "Mel",
        "Shows the spectrum after triangular filters on the mel scale (HTK); variables can measure it.",
        (Parameter("mel_bands", "Mel", low=4, high=80, unit="bands", decimals=0, step=1.0),),
    ),
    Stage(
        Filter.NORMALISE,
        "Normalise",
        "Divides each spectrum by its largest amplitude, which makes it independent of loudness.",
    ),
    Stage(
        "statistics",
        "Smoothing",
        "Keeps phonemes from flickering, by a minimum duration and by stability or a decoder. An unidentified "
        "phoneme is replaced by the most likely successor.",
        (
            Parameter("minimum_hold", "Minimum duration", "Minimum", unit="s", step=0.01, usual=0.2),
            Parameter("hysteresis", "Stability", "Stability", optional=True),
            Parameter("decoder", "Decoder", "Decoder", choices=DECODINGS, optional=True),
            Parameter("change_cost", "Cost of a change", "Change", high=10.0, step=0.25, usual=10.0, optional=True),
        ),
        hints=(
            "Shortest time that a recognised phoneme lasts.",
            "By how much another phoneme must score higher to replace the current one (hysteresis).",
            "Finds the most likely sequence of phonemes within the look-ahead, from the results of the rules and "
            "from how phonemes follow each other in the language.",
            "Cost of each change of phoneme in the decoder; a higher cost gives fewer changes.",
        ),
    ),
    Stage(
        "look_ahead",
        "Look-ahead",
        "How long the recogniser may wait for what follows a frame: longer is more accurate, but adds latency. "
        "Rules need none without a decoder.",
        (
            Parameter("look_ahead", "Look-ahead", "Files", high=0.05, unit="s", step=0.01, optional=True),
            Parameter("live_look_ahead", "Live look-ahead", "Live", high=0.05, unit="s", step=0.01, optional=True),
        ),
        hints=(
            "How long the recogniser of files may wait for what follows a frame: longer is more accurate.",
            "How long the recogniser of the microphone may wait for what follows a frame: longer is more accurate, "
            "but delays the mouth.",
        ),
    ),
    Stage(
        "intensity",
        "Intensity",
        "Peak levels at which the intensity is 0 and 1; in silence it is always 0.",
        (
            _level("intensity_low", "Level of intensity 0", "0 at"),
            _level("intensity_high", "Level of intensity 1", "1 at"),
        ),
        is_range=True,
        hints=("Peak level up to which the intensity is 0.", "Peak level from which the intensity is 1."),
    ),
)
STAGES = {stage.name: stage for stage in _STAGES}
"""All that a sound passes, in order, by name."""
PARAMETERS = {parameter.name: parameter for stage in _STAGES for parameter in stage.parameters}
"""All parameters, in order, by name."""
STRENGTHS = {stage.parameters[0].name: stage for stage in _STAGES if stage.strength}
"""The filters that do nothing at strength 0, by the field of their strength."""
HINTS = {p.name: hint for s in _STAGES for p, hint in zip(s.parameters, s.hints or (s.hint,) * 9, strict=False)}
"""What each parameter does, by its name."""
RANGES = tuple(tuple(parameter.name for parameter in stage.parameters) for stage in _STAGES if stage.is_range)
"""Pairs of parameters of which the first must not exceed the second."""
THESIS_FILTERS = frozenset({Filter.QUANTISE, Filter.HIGH_PASS, Filter.NORMALISE})
"""The filters of the thesis that act with its usual numbers; both blurs and denoise stand at 0 there."""


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
    hysteresis : by how much another phoneme must be the better one to follow, 0..1; 0 lets the best one follow. In a
        whole sound, a search through the scores takes its place; see `phonemeengine.presets.preset.Preset.search`.
    decoder : whether a search finds the phonemes behind the answers of rules, and with which language's statistics;
        it takes the place of `hysteresis`, and of successors of unidentified frames.
    change_cost : what a change of phoneme costs there, nats, 0..10.
    look_ahead : how long a recogniser may wait for what comes after a frame, seconds; rules without a decoder never
        wait.
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
    decoder: Decoding = Decoding.OFF
    change_cost: float = 4.0
    look_ahead: float = 0.05
    live_look_ahead: float = 0.02
    intensity_low: float = -45.0
    intensity_high: float = -3.0

    def __post_init__(self) -> None:
        if self.quantise not in QUANTISATIONS:
            raise SettingsError(f"quantise must be one of 1, 2, 4, got {self.quantise}; choose one of them")
        for name, of in PARAMETERS.items():
            if not of.choices:
                check_range(name, getattr(self, name), of.limits)
        for lower, upper in RANGES:
            self._check_order(lower, upper)

    def with_filter(self, step: Filter, on: bool) -> "AnalysisSettings":
        """Return the settings with a filter on or off; one that would do nothing gets its usual strength."""
        if not on:
            return replace(self, filters=self.filters - {step})
        usual: dict[str, Any] = {name: of.strength for name, of in STRENGTHS.items() if of.name == step}
        weak = {name: strength for name, strength in usual.items() if not getattr(self, name)}
        return replace(self, filters=self.filters | {step}, **weak)

    def with_numbers(self, **numbers: Any) -> "AnalysisSettings":
        """Return the settings with other numbers; a filter whose strength changes is on while that is above 0."""
        filters = self.filters
        for name, stage in STRENGTHS.items():
            strength, step = numbers.get(name, getattr(self, name)), Filter(stage.name)
            if strength != getattr(self, name):
                filters = filters | {step} if strength else filters - {step}
        return replace(self, filters=filters, **numbers)

    def with_number(self, name: str, value: Any) -> "AnalysisSettings":
        """Return the settings with another number; of two that are ordered, the other one gives way.

        A look-ahead for a microphone lengthens that for files where it is longer.
        """
        changes = {name: value}
        for low, high in (*RANGES, ("live_look_ahead", "look_ahead")):
            if name == low:
                changes[high] = max(value, getattr(self, high))
            if name == high:
                changes[low] = min(value, getattr(self, low))
        return self.with_numbers(**changes)

    def _check_order(self, lower: str, upper: str) -> None:
        low, high = getattr(self, lower), getattr(self, upper)
        if low > high:
            raise SettingsError(f"{lower} must not exceed {upper}, got {low:g} above {high:g}; lower it")

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
        return ", ".join(
            [quantised, *(self._words_of(STAGES[f]) for f in Filter if f in self.filters - {Filter.QUANTISE})]
        )

    def _words_of(self, stage: Stage) -> str:
        """Return name, values and unit of a filter."""
        values = [getattr(self, parameter.name) for parameter in stage.parameters]
        written = "-".join(value if isinstance(value, str) else f"{value:.7g}" for value in values)
        unit = stage.parameters[0].unit if stage.parameters else ""
        return f"{stage.name.removesuffix('_function')} {written} {unit}".strip()
