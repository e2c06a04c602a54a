"""The rules of the thesis: first match wins, and the trace says why."""

from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import PresetError, SettingsError
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import ThesisRules, Thresholds
from phonemeengine.recognition.spec import RecogniserConfig, recogniser_of

THRESHOLD_NAMES = tuple(f.name for f in fields(Thresholds))
ROUND = Thresholds(**dict.fromkeys(THRESHOLD_NAMES, 0.5))
VARIABLES = (
    "zero_crossings",
    "volume",
    "energy",
    "max_energy",
    "f0",
    "energy_n",
    "m_szsch1",
    "m_s1",
    "m_p1",
    "m_p2",
    "m_ae1",
    "m_a1",
    "m_o1",
)

# what is 1, while all else is 0, and what each threshold of 0.5 then says
CASES = {
    "silence": ({}, Phoneme.SILENCE),
    "sz": ({"m_szsch1", "m_s1"}, Phoneme.SZ),
    "sch": ({"m_szsch1"}, Phoneme.SCH),
    "sz before p": ({"m_szsch1", "m_s1", "max_energy", "energy_n", "m_p1"}, Phoneme.SZ),
    "p": ({"max_energy", "energy_n", "m_p1"}, Phoneme.P),
    "p before a": ({"max_energy", "energy_n", "m_p1", "m_ae1"}, Phoneme.P),
    "no p with m_p2": ({"max_energy", "energy_n", "m_p1", "m_p2", "m_ae1"}, Phoneme.A),
    "no p without m_p1": ({"max_energy", "energy_n", "m_ae1"}, Phoneme.A),
    "no p without energy_n": ({"max_energy", "m_p1", "m_ae1"}, Phoneme.A),
    "no p without max_energy": ({"energy", "energy_n", "m_p1", "m_ae1"}, Phoneme.A),
    "a": ({"energy", "m_ae1"}, Phoneme.A),
    "e": ({"energy", "m_ae1", "m_a1"}, Phoneme.E),
    "u": ({"energy", "m_o1"}, Phoneme.U),
    "m": ({"energy"}, Phoneme.M),
    "no silence with crossings": ({"zero_crossings"}, Phoneme.M),
    "no silence with a peak": ({"max_energy"}, Phoneme.M),
}


def features_of(**values: float) -> Features:
    row = [values.get(name, 0.0) for name in VARIABLES]
    return Features(VARIABLES, np.array([row], np.float32))


def recognised(thresholds: Thresholds, **values: float) -> Phoneme:
    return Phoneme(int(ThesisRules(thresholds).phonemes_of(features_of(**values))[0]))


def by_the_book(v: dict[str, float], t: dict[str, float]) -> Phoneme:  # noqa: C901, PLR0911
    """Section 4 of the specification, read aloud, without a table."""
    quiet = v["energy"] < t["silence_energy"] and v["max_energy"] < t["silence_max_energy"]
    if v["zero_crossings"] < t["silence_zero_crossings"] and quiet and v["m_szsch1"] < t["silence_szsch1"]:
        return Phoneme.SILENCE
    if v["m_szsch1"] > t["szsch_szsch1"]:
        if v["m_s1"] > t["sz_s1"]:
            return Phoneme.SZ
        return Phoneme.SCH
    loud = v["max_energy"] > t["p_max_energy"] and v["energy_n"] > t["p_energy_n"]
    if loud and v["m_p1"] > t["p_p1"] and v["m_p2"] < t["p_p2"]:
        return Phoneme.P
    if v["m_ae1"] > t["ae_ae1"]:
        if v["m_a1"] < t["a_a1"]:
            return Phoneme.A
        return Phoneme.E
    if v["m_ae1"] < t["ouim_ae1"]:
        if v["m_o1"] > t["u_o1"]:
            return Phoneme.U
        if v["m_o1"] > t["o_o1"]:
            return Phoneme.O
        if v["m_o1"] > t["i_o1"]:
            return Phoneme.I
        return Phoneme.M
    return Phoneme.UNIDENTIFIED


@pytest.mark.parametrize(("ones", "phoneme"), CASES.values(), ids=CASES)
def test_a_rule_fires_where_its_comparisons_hold(ones: set[str], phoneme: Phoneme):
    assert recognised(ROUND, **dict.fromkeys(ones, 1.0)) is phoneme


@pytest.mark.parametrize(
    ("m_o1", "phoneme"),
    [(0.7, Phoneme.U), (0.6, Phoneme.O), (0.5, Phoneme.O), (0.4, Phoneme.I), (0.3, Phoneme.I), (0.2, Phoneme.M)],
)
def test_round_and_narrow_vowels_differ_by_the_energy_at_the_first_formant(m_o1: float, phoneme: Phoneme):
    thresholds = replace(ROUND, u_o1=0.65, o_o1=0.45, i_o1=0.25)
    assert recognised(thresholds, energy=1.0, m_o1=m_o1) is phoneme


def test_between_the_two_limits_of_the_vowels_nothing_is_identified():
    thresholds = replace(ROUND, ae_ae1=0.8, ouim_ae1=0.2)
    assert recognised(thresholds, energy=1.0, m_ae1=0.5) is Phoneme.UNIDENTIFIED
    assert recognised(ROUND, energy=1.0, m_ae1=0.5) is Phoneme.UNIDENTIFIED


@pytest.mark.parametrize("variable", ["zero_crossings", "energy", "max_energy", "m_szsch1"])
def test_silence_ends_as_soon_as_one_of_its_four_comparisons_fails(variable: str):
    assert recognised(ROUND) is Phoneme.SILENCE
    assert recognised(ROUND, **{variable: 0.5}) is not Phoneme.SILENCE


numbers = st.one_of(st.floats(0, 300, width=32), st.sampled_from([0.0, 0.25, 0.5, 1.0, 2.0]))
rows = st.lists(st.tuples(*[numbers] * len(VARIABLES)), min_size=1, max_size=20)
thresholds_at_random = st.builds(Thresholds, **dict.fromkeys(THRESHOLD_NAMES, numbers))


@given(rows=rows, thresholds=thresholds_at_random)
def test_the_table_of_rules_says_what_the_book_says(rows: list[tuple[float, ...]], thresholds: Thresholds):
    features = Features(VARIABLES, np.array(rows, np.float32))
    rules = ThesisRules(thresholds)
    limits = {name: getattr(thresholds, name) for name in THRESHOLD_NAMES}
    expected = [by_the_book(features.frame(k), limits) for k in range(len(rows))]
    np.testing.assert_array_equal(rules.phonemes_of(features), expected)
    assert [rules.explain(features, k).phoneme for k in range(len(rows))] == expected


@given(order=st.permutations(VARIABLES), row=st.tuples(*[numbers] * len(VARIABLES)))
def test_the_order_of_the_variables_does_not_matter(order: list[str], row: tuple[float, ...]):
    values = dict(zip(VARIABLES, row, strict=True))
    shuffled = Features((*order, "mine"), np.array([[*(values[n] for n in order), 7]], np.float32))
    assert ThesisRules(ROUND).phonemes_of(shuffled)[0] == recognised(ROUND, **values)


@given(row=st.tuples(*[numbers] * len(VARIABLES)), thresholds=thresholds_at_random)
def test_the_trace_tells_every_comparison_on_the_way(row: tuple[float, ...], thresholds: Thresholds):
    features = Features(VARIABLES, np.array([row], np.float32))
    trace = ThesisRules(thresholds).explain(features, 0)
    assert trace.rule == trace.phoneme.label
    for c in trace.comparisons:
        assert c.value == features.frame(0)[c.variable]
        assert c.limit == getattr(thresholds, c.threshold)
        holds = c.value > c.limit if c.sign == ">" else c.value < c.limit
        assert (c.margin > 0) == holds
    for rule in {c.rule for c in trace.comparisons}:
        all_hold = all(c.margin > 0 for c in trace.comparisons if c.rule == rule)
        assert all_hold == (rule == trace.rule)


@given(row=st.tuples(*[numbers] * len(VARIABLES)), thresholds=thresholds_at_random)
def test_moving_a_threshold_by_more_than_its_margin_changes_that_comparison(
    row: tuple[float, ...], thresholds: Thresholds
):
    features = Features(VARIABLES, np.array([row], np.float32))
    for c in ThesisRules(thresholds).explain(features, 0).comparisons:
        towards = c.margin if c.sign == ">" else -c.margin
        little = 1e-4 * (1 + abs(c.limit)) * (1 if towards > 0 or (towards == 0 and c.sign == "<") else -1)
        answers = []
        for limit in (c.limit + towards - little, c.limit + towards + little):
            moved = ThesisRules(replace(thresholds, **{c.threshold: limit}))
            same = [d for d in moved.explain(features, 0).comparisons if d.threshold == c.threshold]
            answers += [d.margin > 0 for d in same[:1]]
        if len(answers) == 2 and abs(c.margin) > abs(little):
            assert answers == [c.margin > 0, c.margin <= 0]


def test_the_trace_of_an_sch_asks_for_silence_then_sz_then_sch():
    trace = ThesisRules(ROUND).explain(features_of(m_szsch1=2.0, m_s1=0.25), 0)
    asked = [(c.rule, c.variable, c.sign, c.threshold, c.margin) for c in trace.comparisons]
    assert trace.phoneme is Phoneme.SCH
    assert asked == [
        ("silence", "zero_crossings", "<", "silence_zero_crossings", 0.5),
        ("silence", "energy", "<", "silence_energy", 0.5),
        ("silence", "max_energy", "<", "silence_max_energy", 0.5),
        ("silence", "m_szsch1", "<", "silence_szsch1", -1.5),
        ("sz", "m_szsch1", ">", "szsch_szsch1", 1.5),
        ("sz", "m_s1", ">", "sz_s1", -0.25),
        ("sch", "m_szsch1", ">", "szsch_szsch1", 1.5),
    ]


def test_a_block_without_frames_has_no_phonemes():
    nothing = Features(VARIABLES, np.zeros((0, len(VARIABLES)), np.float32))
    assert len(ThesisRules(ROUND).phonemes_of(nothing)) == 0


@pytest.mark.parametrize("value", [float("nan"), float("inf"), float("-inf"), 1e39])
def test_a_threshold_that_float32_cannot_hold_is_refused(value: float):
    with pytest.raises(SettingsError, match="sz_s1 must be a finite number"):
        Thresholds(sz_s1=value)


def test_an_unknown_recogniser_is_refused_with_the_known_ones():
    with pytest.raises(PresetError, match=r"no recogniser named 'magic'; known are .*thesis"):
        recogniser_of("magic", RecogniserConfig(ROUND))
