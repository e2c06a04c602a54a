"""Controls: every recogniser says what it is tuned by, and each number does what it says."""

from dataclasses import replace

import numpy as np
import pytest
import soundfile

from phonemeengine.analyser import Analyser, Analysis
from phonemeengine.features.variables import DEFICITS, Variable
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.controls import Control, Moment, controls_of, unused_settings
from phonemeengine.presets.files import load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import FILTER_FIELDS, RULE_FIELDS, Condition, Rule
from phonemeengine.recognition.scores import deficits_of, scores_in
from phonemeengine.recognition.spec import recogniser_of
from phonemeengine.settings import SAMPLE_RATE, Filter
from tests.conftest import ROOT
from tests.sounds import Sound, noise, silence, vowel

VOWELS = [
    vowel(formants, 0.3) for formants in ((750.0, 1250.0, 2500.0), (280.0, 2300.0, 3000.0), (300.0, 700.0, 2300.0))
]
SOUND = np.concatenate([silence(0.2), *VOWELS, noise(0.3, 0.1, seed=4), silence(0.2)]).astype(np.float32)
DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"
NAMES = ("thesis", "extended", "templates", "learned")


def controls(preset: Preset) -> dict[str, Control]:
    groups = controls_of(preset, recogniser_of(preset.recogniser, preset.config))
    return {control.name: control for group in groups for control in group.controls}


def analysed(preset: Preset, sound: Sound = SOUND) -> Analysis:
    settings = replace(preset.settings, look_ahead=0.0)
    return Analyser(replace(preset, settings=settings)).push(sound)


def test_the_thesis_is_tuned_by_its_21_numbers_and_its_calm():
    names = [*FILTER_FIELDS, *(name for names in RULE_FIELDS for name in names)]
    assert list(controls(load_preset("thesis"))) == [*names, "hysteresis", "minimum_hold"]


@pytest.mark.parametrize("name", ["templates", "learned"])
def test_who_weighs_probabilities_is_tuned_by_a_sensitivity_for_each_phoneme_that_it_can_name(name: str):
    named = set(Phoneme) - ({Phoneme.UNIDENTIFIED} if name == "templates" else set())
    expected = {f"sensitivity_{p.label}" for p in named} | {"hysteresis", "minimum_hold"}
    assert controls(load_preset(name)).keys() == expected


def test_own_rules_are_tuned_by_each_of_their_limits_once():
    preset = load_preset("extended")
    limits = {(c.variable, c.limit) for rule in preset.rules for c in rule.conditions}
    found = [c for c in controls(preset).values() if c.name.startswith("limit")]
    assert {(c.variable, c.read(preset)) for c in found} == limits
    assert len(found) == len(limits)


def test_a_limit_says_on_which_side_of_it_which_phonemes_lie():
    rules = (
        Rule(Phoneme.SZ, (Condition("w", ">", limit=2.0), Condition("volume", "<", limit=0.5))),
        Rule(Phoneme.SCH, (Condition("w", ">", limit=2.0),)),
        Rule(Phoneme.M, (Condition("w", "<", limit=2.0), Condition("volume", "<", limit=0.5))),
        Rule(Phoneme.A, (Condition("volume", "<", limit=0.5),)),
    )
    variables = (Variable("b", 440, 700), Variable("w", 230, 440, per="b"))
    preset = replace(load_preset("extended"), variables=variables, rules=rules)
    groups = controls_of(preset, recogniser_of(preset.recogniser, preset.config))
    group = next(g for g in groups if g.note == "w")
    assert group.title == "energy 230–440 Hz / 440–700 Hz"
    assert [c.label for c in group.controls] == ["< m; > sz…"]
    assert [c.hint for c in group.controls] == ["Limit for w; 3 conditions: < m; > sz, sch"]
    volume = next(g for g in groups if g.note == "volume")
    assert [(c.label, c.sign) for c in volume.controls] == [("< sz, m…", "<")]


@pytest.mark.parametrize("name", NAMES)
def test_every_control_writes_what_it_reads_and_no_other_one(name: str):
    preset = load_preset(name)
    mine = controls(preset)
    for control in mine.values():
        value = round(control.low + 0.37 * (control.high - control.low), control.decimals)
        changed = control.write(preset, value)
        assert control.read(changed) == pytest.approx(value), control.name
        others = {c.name for c in mine.values() if c.read(changed) != pytest.approx(c.read(preset), abs=1e-12)}
        allowed = {"high_pass_start", "high_pass_end"} if control.name.startswith("high_pass") else {control.name}
        assert others <= allowed, control.name


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.long] if name == "extended" else []) for name in NAMES]
)
def test_every_control_changes_what_is_recognised_somewhere_on_its_slider(name: str):
    preset = load_preset(name)
    speech, _ = soundfile.read(DEMO, dtype="float32", frames=4 * SAMPLE_RATE)
    said = analysed(preset, speech).phonemes
    idle = [
        control.name
        for control in controls(preset).values()
        if all(
            np.array_equal(
                analysed(control.write(preset, control.low + share * (control.high - control.low)), speech).phonemes,
                said,
            )
            for share in (0.0, 0.02, 0.1, 0.3, 1.0)
        )
    ]
    assert [n for n in idle if not n.startswith("limit")] == []
    assert len(idle) < len(controls(preset)) / 2  # four seconds of speech do not pass every one of 64 rules


@pytest.mark.parametrize("name", ["templates", "learned"])
def test_a_phoneme_is_named_exactly_where_its_sensitivity_exceeds_its_live_value(name: str):
    preset = load_preset(name)
    preset = replace(preset, sensitivities={Phoneme.A: 1.5, Phoneme.M: -2.0})
    analysis = analysed(preset)
    for k in range(0, len(analysis), 7):
        moment = Moment(analysis.features.frame(k))
        for phoneme in Phoneme:
            control = controls(preset).get(f"sensitivity_{phoneme.label}")
            if control is None:
                assert analysis.recognised[k] != phoneme
                continue
            live = control.live(preset, moment)
            assert live is not None
            assert (live < control.read(preset)) == (analysis.recognised[k] == phoneme)


def test_a_deficit_is_the_log_odds_between_a_phoneme_and_the_best_other_one():
    scores = np.zeros((1, len(Phoneme)), np.float32)
    scores[0, [Phoneme.A, Phoneme.E]] = 0.8, 0.2
    assert deficits_of(scores, Phoneme.A)[0] == pytest.approx(-np.log(4), rel=1e-5)
    assert deficits_of(scores, Phoneme.E)[0] == pytest.approx(np.log(4), rel=1e-5)


def test_the_live_value_of_a_deficit_does_not_depend_on_its_own_sensitivity():
    plain = load_preset("templates")
    tuned = replace(plain, sensitivities={Phoneme.O: 3.0})
    for preset in (plain, tuned):
        scores = scores_in(analysed(preset).features)
        assert scores is not None
        k = int(np.argmax(scores[:, Phoneme.O] * (1 - scores[:, Phoneme.O])))  # where it is least certain
    lives = [
        controls(preset)["sensitivity_o"].live(preset, Moment(analysed(preset).features.frame(k)))
        for preset in (plain, tuned)
    ]
    assert lives[0] == pytest.approx(lives[1], abs=1e-3)


def test_calm_lives_on_how_long_and_by_how_much():
    preset = load_preset("learned")
    moment = Moment({}, deficit=0.25, lasted=0.07)
    assert controls(preset)["hysteresis"].live(preset, moment) == 0.25
    assert controls(preset)["minimum_hold"].live(preset, moment) == 0.07
    off = replace(preset, settings=replace(preset.settings, statistics=False))
    assert controls(off)["minimum_hold"].write(off, 0.1).settings.statistics


def test_the_variable_of_a_sensitivity_is_its_deficit():
    assert [controls(load_preset("learned"))[f"sensitivity_{p.label}"].variable for p in Phoneme] == list(DEFICITS)


def test_what_a_recogniser_does_not_use_is_known():
    everything = {*(step.value for step in Filter), "decoder", "change_cost"}
    assert unused_settings(load_preset("learned")) == everything
    assert unused_settings(load_preset("templates")) == everything | {"look_ahead"}
    assert unused_settings(load_preset("thesis")) == {"mel", "look_ahead", "decoder", "change_cost"}
    assert unused_settings(load_preset("extended")) == {"mel", "hysteresis"}  # its decoder looks ahead instead


@pytest.mark.parametrize("name", NAMES)
def test_what_is_said_to_be_unused_changes_nothing_that_is_recognised(name: str):
    preset = load_preset(name)
    said = analysed(preset).phonemes
    for unused in unused_settings(preset) & set(Filter):
        step = Filter(unused)
        toggled = preset.settings.with_filter(step, not preset.settings.has(step))
        assert np.array_equal(analysed(replace(preset, settings=toggled)).phonemes, said), unused
