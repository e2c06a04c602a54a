"""What a variable is called in words: its range, its divisor, and its spectrum."""

from phonemeengine.features.front_end import why_unmeasured
from phonemeengine.features.variables import BUILT_IN_NAMES, DEFICITS, SCORES, Kind, Spectrum, Variable, readable_name
from phonemeengine.settings import AnalysisSettings, Filter

MINE = (
    Variable("b440_1870", 440, 1870),
    Variable("hiss", 4000.4, 8000, Kind.MEAN, Spectrum.RAW),
    Variable("low_share", 440, 1870, per="energy_n"),
    Variable("low_high", 60, 230, per="b440_1870"),
    Variable("peak_share", 60, 230, Kind.MAX, per="b440_1870"),
    Variable("rate", 60, 230, Kind.SUM, Spectrum.MEL, per="zero_crossings"),
    Variable("lost", 60, 230, per="gone"),
)


def test_a_variable_tells_kind_range_divisor_and_spectrum() -> None:
    assert {v.name: readable_name(v.name, MINE) for v in MINE} == {
        "b440_1870": "energy 440–1870 Hz",
        "hiss": "mean 4000–8000 Hz, raw",
        "low_share": "energy 440–1870 Hz / all",
        "low_high": "energy 60–230 Hz / 440–1870 Hz",
        "peak_share": "peak 60–230 Hz / energy 440–1870 Hz",
        "rate": "energy 60–230 Hz / zero crossings, mel",
        "lost": "energy 60–230 Hz / gone",
    }


def test_those_that_are_built_in_have_their_ranges_in_hertz() -> None:
    assert readable_name("m_s1") == "energy 3768–5168 Hz"  # bins 175 to 240 of 21.53 Hz
    assert readable_name("m_p2") == "peak 4307–4737 Hz"
    assert readable_name("energy_n") == "total energy"
    assert readable_name("max_energy") == "highest peak, filtered"
    assert readable_name("p_sz") == "probability of sz"


def test_a_variable_without_a_band_tells_why_and_one_with_a_band_nothing() -> None:
    settings = AnalysisSettings(filters=frozenset({Filter.QUANTISE}), quantise=4)  # whose spectrum ends at 5512.5 Hz
    mine = (
        Variable("above", 9000, 10_000),
        Variable("between", 100, 105),
        Variable("mel", 1000, 2000, source=Spectrum.MEL),
        Variable("quotient", 1000, 2000, per="above"),
        Variable("fine", 1000, 2000),
    )
    told = {v.name: why_unmeasured(v.name, settings, mine) for v in mine}
    beyond = "above reads 0, since it begins at 9000 Hz and the spectrum ends at 5512 Hz; quantise less."
    assert told == {
        "above": beyond,
        "between": "between reads 0, since no band lies within 100 to 105 Hz; widen its range.",
        "mel": "mel reads 0, since the mel filter bank is off; switch Mel on.",
        "quotient": beyond,
        "fine": "",
    }
    assert {why_unmeasured(name, settings) for name in BUILT_IN_NAMES} == {""}
    low = AnalysisSettings(filters=frozenset({Filter.LOW_PASS}), low_pass_start=8000, low_pass_end=8000)
    sentence = "above reads 0, since it begins at 9000 Hz and the low-pass ends at 8000 Hz; raise the low-pass."
    assert [why_unmeasured(v.name, low, mine) for v in (mine[0], mine[4])] == [sentence, ""]
    assert why_unmeasured("mel", settings.with_filter(Filter.MEL, True), mine) == ""


def test_no_two_are_called_alike_and_an_unknown_one_keeps_its_name() -> None:
    names = (*BUILT_IN_NAMES, *SCORES, *DEFICITS)
    assert len({readable_name(name) for name in names}) == len(names)
    assert readable_name("b440_1870") == "b440_1870"
