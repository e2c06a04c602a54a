"""Variables: what is measured on a frame, over which frequencies, and how a block of frames is measured.

The band variables are those of the thesis, given there as ranges of bins; the user adds others of the same kind.
"""

import math
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, ShortRepr
from phonemeengine.dsp.pitch import fundamental_of
from phonemeengine.errors import SettingsError
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import BIN_WIDTH, SAMPLE_RATE, WINDOW


class Kind(StrEnum):
    """How the amplitudes of a range become one number."""

    SUM = "sum"
    MAX = "max"
    MEAN = "mean"


class Spectrum(StrEnum):
    """Which spectrum a variable looks at.

    ``raw`` comes straight from the Fourier transform, ``filtered`` has passed smoothing and the two pass filters,
    ``normalised`` has passed all filters that are on, ``mel`` is what the mel bank gives (always 0 while it is off).
    """

    RAW = "raw"
    FILTERED = "filtered"
    NORMALISED = "normalised"
    MEL = "mel"


_NAME = re.compile(r"[a-z][a-z0-9_]*")


@dataclass(frozen=True)
class Variable:
    """One measured number: the sum, maximum or mean of a spectrum's amplitudes over a frequency range.

    Divided by another variable, it says how much stronger one range is than another, however loud the sound.

    Parameters
    ----------
    name : lower-case letters, digits and underscores.
    low, high : the range in Hz, both ends included.
    kind : sum, max or mean.
    source : which spectrum.
    per : name of the variable that it is divided by (0 / 0 is 0); empty where it is not divided.

    Raises
    ------
    SettingsError : the name or the range is impossible.
    """

    name: str
    low: float
    high: float
    kind: Kind = Kind.SUM
    source: Spectrum = Spectrum.NORMALISED
    per: str = ""

    def __post_init__(self) -> None:
        if not _NAME.fullmatch(self.name):
            raise SettingsError(
                f"a variable's name must be lower-case letters, digits and underscores, got {self.name[:60]!r}; "
                "rename it"
            )
        if not 0 <= self.low <= self.high <= SAMPLE_RATE / 2:
            raise SettingsError(
                f"{self.name} must range within 0..{SAMPLE_RATE / 2:g} Hz and upwards, "
                f"got {self.low:g}..{self.high:g} Hz; correct it"
            )

    def bins(self, n_bins: int) -> slice:
        """Return the bins whose centre lies in the range, cut to those that a spectrum has."""
        # bin k lies at k times the width of a bin, so the first is rounded up and the last down
        return slice(math.ceil(self.low / BIN_WIDTH), min(math.floor(self.high / BIN_WIDTH) + 1, n_bins))


def _of_bins(name: str, first: int, last: int, kind: Kind) -> Variable:
    return Variable(name, first * BIN_WIDTH, last * BIN_WIDTH, kind)


BAND_VARIABLES: tuple[Variable, ...] = (
    Variable("energy_n", 0, SAMPLE_RATE / 2, Kind.SUM),
    _of_bins("m_szsch1", 80, 130, Kind.SUM),
    _of_bins("m_s1", 175, 240, Kind.SUM),
    _of_bins("m_p1", 3, 5, Kind.SUM),
    _of_bins("m_p2", 200, 220, Kind.MAX),
    _of_bins("m_ae1", 50, 100, Kind.MAX),
    _of_bins("m_a1", 12, 27, Kind.SUM),
    _of_bins("m_o1", 8, 18, Kind.SUM),
)

ENERGY_VARIABLES: tuple[Variable, ...] = (
    Variable("energy", 0, SAMPLE_RATE / 2, Kind.SUM, Spectrum.FILTERED),
    Variable("max_energy", 0, SAMPLE_RATE / 2, Kind.MAX, Spectrum.FILTERED),
)

_ZERO = np.zeros((), np.float32)
_ONES = np.ones(WINDOW - 1, np.float32)


def zero_crossings_of(frames: Float32Array) -> Float32Array:
    """Count the sign changes inside each raw frame (2048 samples); zero counts as positive. Shape (n_frames,)."""
    # Counted by a product with ones, which costs less than count_nonzero for the few frames of a live block; 2047
    # changes at the most are exact in float32.
    negative = frames < _ZERO
    counts: Float32Array = (negative[:, 1:] != negative[:, :-1]).dot(_ONES)
    return counts


def peak_levels_of(frames: Float32Array) -> Float32Array:
    """Return the largest absolute sample of each frame, shape (n_frames,)."""
    levels: Float32Array = np.maximum.reduce(np.abs(frames), axis=1)
    return levels


@dataclass(frozen=True)
class FrameMeasure:
    """What is measured on the samples of whole windows, before every filter.

    Attributes
    ----------
    name : as of a variable.
    measure : gives it for raw frames, shape (n_frames, 2048), as float32, shape (n_frames,).
    unit : of the number.
    """

    name: str
    measure: Callable[[Float32Array], Float32Array]
    unit: str = "amplitude"


PITCH = FrameMeasure("f0", fundamental_of, "Hz")
"""It takes long, so it is measured only where it is asked for."""
FRAME_MEASURES = (
    FrameMeasure("zero_crossings", zero_crossings_of, "per window"),
    FrameMeasure("volume", peak_levels_of),
    PITCH,
)
"""A new one goes to the end, since some columns are found by their places."""
_MEASURED = [measured.name for measured in FRAME_MEASURES]
WHOLE_FRAME_VARIABLES = (*_MEASURED[:2], *(v.name for v in ENERGY_VARIABLES), *_MEASURED[2:])
"""What is measured on the window or on the whole spectrum: a count, 0..1, amplitudes, an amplitude, Hz."""

TABLE_COLUMNS = ("start_s", "end_s", "phoneme", "intensity")
"""What stands beside the variables in a table of frames."""

SCORES = tuple(f"p_{phoneme.label}" for phoneme in Phoneme)
"""How likely each phoneme is, in the order of `Phoneme`: further columns, of recognisers that measure it."""

DEFICITS = tuple(f"deficit_{phoneme.label}" for phoneme in Phoneme)
"""By how much each phoneme falls short of being the likeliest, log-odds; worked out from the scores."""

PITCH_SET_COLUMNS = ("voice_pitch", "pitch_set")
"""The pitch of the voice (Hz), and the number of the set of PhonemeData that it chooses: further columns, where a
preset has such sets."""

BUILT_IN_NAMES = (*WHOLE_FRAME_VARIABLES, *(v.name for v in BAND_VARIABLES))


UNITS = (
    {m.name: m.unit for m in FRAME_MEASURES if m.unit != "amplitude"}
    | dict.fromkeys(DEFICITS, "log-odds")
    | dict(zip(PITCH_SET_COLUMNS, ("Hz", "number"), strict=True))
)
"""Units of what is no amplitude."""


def unit_of(name: str, mine: Iterable[Variable] = ()) -> str:
    """Return the unit of a variable, built in or one of the user's own; a quotient of two is a ratio."""
    quotients = {variable.name for variable in mine if variable.per}
    return "ratio" if name in quotients else UNITS.get(name, "amplitude")


ALL = "all"
_WORDS = {"zero_crossings": "zero crossings", "volume": "volume (peak level)", "f0": "pitch (f0)"}
_WORDS |= {score: f"probability of {phoneme.label}" for score, phoneme in zip(SCORES, Phoneme, strict=True)}
_WORDS |= {deficit: f"deficit of {phoneme.label}" for deficit, phoneme in zip(DEFICITS, Phoneme, strict=True)}
_OF_KIND = {Kind.SUM: "energy", Kind.MAX: "peak", Kind.MEAN: "mean"}
_OF_ALL = {Kind.SUM: "total energy", Kind.MAX: "highest peak", Kind.MEAN: "mean amplitude"}
_OF_SOURCE = {Spectrum.NORMALISED: "", Spectrum.FILTERED: ", filtered", Spectrum.RAW: ", raw", Spectrum.MEL: ", mel"}


def readable_name(name: str, mine: Iterable[Variable] = ()) -> str:
    """Return what a variable measures, in words: kind, range in Hz, divisor and spectrum; an unknown name as it is.

    Parameters
    ----------
    name : of a variable that is built in, one of the user's own, or a score of a recogniser.
    mine : the user's own variables.
    """
    known = {v.name: v for v in (*BAND_VARIABLES, *ENERGY_VARIABLES, *mine)}
    if name not in known:
        return _WORDS.get(name, name)
    variable = known[name]
    words = (
        f"{_OF_KIND[variable.kind]} {_range_of(variable)}" if _range_of(variable) != ALL else _OF_ALL[variable.kind]
    )
    if variable.per:
        divisor = known.get(variable.per)
        alike = divisor is not None and divisor.kind is variable.kind
        words += f" / {_range_of(divisor) if divisor is not None and alike else readable_name(variable.per, mine)}"
    return words + _OF_SOURCE[variable.source]


def _range_of(variable: Variable) -> str:
    is_all = variable.low == 0 and variable.high == SAMPLE_RATE / 2
    return ALL if is_all else f"{variable.low:.0f}–{variable.high:.0f} Hz"


def check_user_variables(variables: tuple[Variable, ...]) -> None:
    """Refuse names that are built in, head another column of a table, or stand twice, and unknown divisors.

    Raises
    ------
    SettingsError : a name is taken, or a variable is divided by one that is not measured or divided itself.
    """
    seen = {*BUILT_IN_NAMES, *TABLE_COLUMNS, *SCORES, *DEFICITS, *PITCH_SET_COLUMNS}
    for variable in variables:
        if variable.name in seen:
            raise SettingsError(f"a variable named {variable.name[:60]} exists already; choose another name")
        seen.add(variable.name)
    divisors = {*BUILT_IN_NAMES, *(v.name for v in variables if not v.per)}
    for variable in variables:
        if variable.per and variable.per not in divisors:
            raise SettingsError(
                f"{variable.name[:40]} is divided by {variable.per[:40]!r}, which is not measured or is divided "
                "itself; name a variable that stands by itself"
            )


FLOAT = np.dtype(np.float32)


@dataclass(frozen=True, repr=False)
class Features(ShortRepr):
    """What was measured on a block of frames.

    Attributes
    ----------
    names : the variables, one a column.
    values : float32, shape (n_frames, n_variables).
    """

    names: tuple[str, ...]
    values: Float32Array

    def __getitem__(self, name: str) -> Float32Array:
        """Return one variable's values, shape (n_frames,); KeyError for an unknown name."""
        try:
            return self.values[:, self.names.index(name)]
        except ValueError:
            raise KeyError(name) from None

    def part(self, frames: slice) -> "Features":
        """Return some of the frames of the block, as a block."""
        return Features(self.names, self.values[frames])

    def with_columns(self, names: tuple[str, ...], values: Float32Array) -> "Features":
        """Return the same with more columns, shape (n_frames, n_more)."""
        return Features(self.names + names, np.concatenate((self.values, values), axis=1))

    def frame(self, k: int) -> dict[str, float]:
        """Return the values of frame `k` by name."""
        return dict(zip(self.names, self.values[k].tolist(), strict=True))


class BandFeatures:
    """Measures variables on spectra, and on what denoising and normalising make of them.

    The maxima are written beside the bins of their spectrum, as if they were more bins. What happens to them after
    that keeps the order of amplitudes, so they stay the maxima, and all variables are one matrix product.

    Parameters
    ----------
    names : the columns of what is measured.
    variables : what to measure.
    centres : frequency of each bin or band, shape (n_bins,), Hz.
    """

    def __init__(self, names: tuple[str, ...], variables: Iterable[Variable], centres: Float64Array) -> None:
        # variables without a bin in reach, such as mel ones above the last band, measure 0: all their weights are
        reaches = {v: reach for v in variables if (reach := reach_of(v, centres)).stop > reach.start}
        maxima = [v for v in reaches if v.kind is Kind.MAX]
        self._n_bins, self._n_wide = len(centres), len(centres) + len(maxima)
        self._edges = np.array([(reaches[v].start, reaches[v].stop) for v in maxima], np.intp).ravel()
        self._weights = {source: np.zeros((self._n_wide, len(names)), FLOAT) for source in Spectrum}
        for v, reach in reaches.items():
            bins = self._n_bins + maxima.index(v) if v.kind is Kind.MAX else reach
            # a sum weighs its bins with 1, a mean with 1 / n, and a maximum is its own column behind the bins
            weight = 1 / (reach.stop - reach.start) if v.kind is Kind.MEAN else 1
            self._weights[v.source][bins, names.index(v.name)] = weight

    def allocate(self, n_frames: int) -> Float32Array:
        """Return room for spectra and their maxima: zeros, float32, shape (n_frames, n_bins + n_maxima)."""
        return np.zeros((n_frames, self._n_wide), FLOAT)

    def fill_maxima(self, wide: Float32Array) -> None:
        """Write the maxima beside the bins."""
        # `reduceat` gives a result for begin to end and one for end to the next begin; the latter mean nothing
        wide[:, self._n_bins :] = np.maximum.reduceat(wide, self._edges, axis=1)[:, ::2]

    def append_maxima(self, spectra: Float32Array) -> Float32Array:
        """Return spectra with their maxima beside the bins; float32, shape (n_frames, n_bins + n_maxima)."""
        wide = self.allocate(len(spectra))
        wide[:, : self._n_bins] = spectra
        self.fill_maxima(wide)
        return wide

    def weights(self, source: Spectrum) -> Float32Array:
        """Return what widened spectra are multiplied with to measure the variables of a source.

        Returns
        -------
        float32, shape (n_bins + n_maxima, n_names); the columns of all other variables are 0.
        """
        return self._weights[source]


def reach_of(variable: Variable, centres: Float64Array) -> slice:
    """Return the bins, or the mel bands, that a variable looks at; their centres are in Hz."""
    if variable.source is not Spectrum.MEL:
        reach = variable.bins(len(centres))
        return slice(reach.start, max(reach.start, reach.stop))
    # the next float above `high`, so that a band whose centre lies on it belongs to it
    first, last = np.searchsorted(centres, (variable.low, np.nextafter(variable.high, np.inf)))
    return slice(int(first), int(last))
