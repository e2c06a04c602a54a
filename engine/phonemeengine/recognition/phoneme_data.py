"""The thresholds of the thesis rules, the 21 numbers of a PhonemeData file, and sets of them for ranges of pitch."""

from dataclasses import dataclass, fields

from phonemeengine.arrays import LARGEST_FLOAT32
from phonemeengine.dsp.pitch import HIGHEST, LOWEST
from phonemeengine.errors import SettingsError

RULE_FIELDS = (
    ("silence_zero_crossings", "silence_energy", "silence_max_energy", "silence_szsch1"),
    ("szsch_szsch1", "sz_s1"),
    ("p_max_energy", "p_energy_n", "p_p1", "p_p2"),
    ("ae_ae1", "a_a1"),
    ("ouim_ae1", "u_o1", "o_o1", "i_o1"),
)
FILTER_FIELDS = ("time_smooth", "frequency_smooth", "high_pass_start", "high_pass_end", "denoise_threshold")
LAYOUT = (FILTER_FIELDS, *RULE_FIELDS)
"""The lines of a PhonemeData file."""


@dataclass(frozen=True, kw_only=True)
class Thresholds:
    """The 16 numbers that the thesis rules compare with; the first part of a name is the rule.

    Units are those of the variables: counts per window, amplitudes, or sums of normalised amplitudes.

    Raises
    ------
    SettingsError : a number is not finite, or too large for float32.
    """

    silence_zero_crossings: float = 220.0
    silence_energy: float = 0.1
    silence_max_energy: float = 0.01
    silence_szsch1: float = 10.0
    szsch_szsch1: float = 15.0
    sz_s1: float = 15.0
    p_max_energy: float = 0.1
    p_energy_n: float = 20.0
    p_p1: float = 1.0
    p_p2: float = 0.05
    ae_ae1: float = 0.3
    a_a1: float = 6.0
    ouim_ae1: float = 0.3
    u_o1: float = 6.0
    o_o1: float = 4.0
    i_o1: float = 2.5

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if not abs(value) <= LARGEST_FLOAT32:
                raise SettingsError(f"{field.name} must be a finite number within ±3.4e38, got {value}; correct it")


@dataclass(frozen=True, kw_only=True)
class PhonemeData(Thresholds):
    """The 21 numbers of a PhonemeData file: the thresholds and five parameters of the filters.

    The high-pass bounds are bins of 21.53 Hz here, as the old files have them.
    """

    time_smooth: float = 0.0
    frequency_smooth: float = 0.0
    high_pass_start: float = 5.0
    high_pass_end: float = 7.0
    denoise_threshold: float = 0.0


@dataclass(frozen=True)
class PitchSet:
    """The 21 numbers for voices of a range of pitch, such as those of women (section 3.2 of the thesis).

    Attributes
    ----------
    name : what people call it, such as "woman".
    low, high : the range of the fundamental frequency, Hz; `low` belongs to it and `high` does not.
    data : the numbers.

    Raises
    ------
    SettingsError : it has no name, or the range is empty or lies outside 60..500 Hz.
    """

    name: str
    low: float
    high: float
    data: PhonemeData

    def __post_init__(self) -> None:
        if not self.name.strip():
            raise SettingsError("a pitch set has no name; give it one, such as woman")
        if not LOWEST <= self.low < self.high <= HIGHEST:
            raise SettingsError(
                f"the pitch set {self.name[:40]!r} must range upwards within {LOWEST:g}..{HIGHEST:g} Hz, got "
                f"{self.low:g}..{self.high:g} Hz; correct it"
            )
