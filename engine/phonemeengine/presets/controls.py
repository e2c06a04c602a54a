"""Controls: the numbers of a preset by which its recogniser is tuned, each with what it is compared with right now.

Every recogniser has its own: rules have thresholds or limits, those that weigh probabilities have sensitivities, and
all have the smoothing. So a view needs no knowledge of recognisers.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any

import numpy as np

from phonemeengine.features.variables import DEFICITS, SCORES, Spectrum, readable_name
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import (
    CONDITIONS,
    FILTER_FIELDS,
    RULE_FIELDS,
    Condition,
    PhonemeData,
    Rule,
    Thresholds,
    active_rules,
)
from phonemeengine.recognition.scores import MOST_LOG_ODDS, deficits_of
from phonemeengine.recognition.spec import Recogniser, Tuning, spec_of
from phonemeengine.settings import BIN_WIDTH, HINTS, PARAMETERS, Filter

CONDITION_OF = {c.threshold: c for c in CONDITIONS}
"""The comparison of the thesis rules in which a threshold stands."""
LIMIT_ROOM = 4.0
"""The slider of a rule's limit reaches to this multiple of what the limit was."""
MOST_NAMES = 2
"""Phonemes that are named beside the slider of a limit, at most."""
FILTERS_NOTE = "affect the variables"
NOTES = (
    ("Silence", "silence if all hold"),
    ("S and SH", "S if both hold, SH if only the first"),
    ("P", "if all hold"),
    ("A and E", "A if both hold, E if only the first"),
    ("U, O, I, M", "below the first limit; M if no other"),
)
"""The rules of the thesis in words, in the order of `RULE_FIELDS`."""
RANGES: dict[str, tuple[float, int]] = {
    "zero_crossings": (1500, 1),
    "energy": (20, 4),
    "max_energy": (1, 5),
    "m_szsch1": (51, 3),
    "m_s1": (66, 3),
    "energy_n": (150, 3),
    "m_p1": (3, 4),
    "m_p2": (1, 4),
    "m_ae1": (1, 4),
    "m_a1": (16, 3),
    "m_o1": (11, 3),
}
"""The largest usual value, and decimals, by variable."""


@dataclass(frozen=True)
class Moment:
    """What controls are compared with: one frame, and what was said of it.

    Attributes
    ----------
    values : the measured variables by name, with the probabilities where the recogniser weighs some.
    deficit : by how much the phoneme that is shown falls short of being named; None where unknown.
    lasted : how long the phoneme has been shown, seconds.
    """

    values: Mapping[str, float]
    deficit: float | None = None
    lasted: float = 0.0


@dataclass(frozen=True)
class Control:
    """A number of a preset that tunes its recogniser.

    Attributes
    ----------
    name : tells it from all others of a preset; for the numbers of PhonemeData their names there.
    label : what it is called beside its slider.
    low, high : the range of a slider; lower and higher numbers can be typed.
    decimals : digits after the point that matter.
    read : gives its value in a preset.
    write : gives the preset with another value.
    live : gives what it is compared with in a moment, or None.
    sign : `<` or `>`: how what is measured is compared with it; empty where nothing is.
    variable : the variable that is compared with it; empty where it is none.
    unit : of the value; empty where it has none.
    hint : what it does, for a person.
    places : the conditions of own rules whose limit it is, each by the numbers of rule and condition.
    """

    name: str
    label: str
    low: float
    high: float
    decimals: int
    read: Callable[[Preset], float] = field(compare=False)
    write: Callable[[Preset, float], Preset] = field(compare=False)
    live: Callable[[Preset, Moment], float | None] = field(compare=False)
    sign: str = ""
    variable: str = ""
    unit: str = ""
    hint: str = ""
    places: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True)
class ControlGroup:
    """Controls that belong together.

    Attributes
    ----------
    title : what the group is about.
    note : how they work together; may be empty.
    controls : in the order in which they are shown.
    """

    title: str
    note: str
    controls: tuple[Control, ...]


def controls_of(preset: Preset, recogniser: Recogniser | None) -> tuple[ControlGroup, ...]:
    """Return all that a preset's recogniser is tuned by.

    They stay true while only their numbers change; another recogniser or other rules have others.

    Parameters
    ----------
    preset : whose numbers they read and write.
    recogniser : made from the preset; None where it cannot be made, which has the thresholds of the thesis.
    """
    groups = [*_groups_of(preset, recogniser), _calm(preset, recogniser)]
    return tuple(group for group in groups if group.controls)


def variables_with(preset: Preset, control: Control) -> tuple[str, ...]:
    """Return the variable of a control, and after it those of all further conditions of the rules it stands in."""
    rules = _rules_of(preset)
    of_limit = {k for k, _ in control.places}
    asked = [
        c.variable
        for k, rule in enumerate(rules)
        if k in of_limit or any(c.threshold == control.name for c in rule.conditions)
        for c in rule.conditions
    ]
    return tuple(dict.fromkeys((control.variable, *asked)))


def asked_in_words(preset: Preset, control: Control) -> str:
    """Return for which phonemes a control is compared, such as ``> sz, sch``; its label where no rule asks for it."""
    asked: dict[str, list[str]] = {}
    for rule in () if control.places else _rules_of(preset):
        for c in rule.conditions:
            if c.threshold == control.name:
                asked.setdefault(c.sign, []).append(rule.phoneme.label)
    return _named(asked) or control.label


def _rules_of(preset: Preset) -> tuple[Rule, ...]:
    rules_of = spec_of(preset.recogniser).rules
    return () if rules_of is None else rules_of(preset.config)


def unused_settings(preset: Preset) -> frozenset[str]:
    """Return the filters and further settings that change nothing of what a preset's recogniser says.

    The names are those of `Filter` and of the fields of `AnalysisSettings`.
    """
    spec = spec_of(preset.recogniser)
    unused: set[str] = set() if spec.looks_ahead or preset.decoder else {"look_ahead"}
    if not spec.has_deficits or preset.decoder:
        unused.add("hysteresis")
    if not preset.has_decoder:
        unused.add("decoder")
    if not preset.decoder:
        unused.add("change_cost")
    if not spec.needs_features:
        return frozenset(unused | {step.value for step in Filter})
    if spec.rules is not None:
        compared = {c.variable for rule in active_rules(spec.rules(preset.config)) for c in rule.conditions}
        if not any(v.name in compared and v.source is Spectrum.MEL for v in preset.variables):
            unused.add(Filter.MEL)
    return frozenset(unused)


def _groups_of(preset: Preset, recogniser: Recogniser | None) -> Iterator[ControlGroup]:
    if recogniser is None:
        yield from _thresholds(frozenset(Thresholds.__dataclass_fields__))
        return
    tuned_by = spec_of(preset.recogniser).tuned_by
    if Tuning.SENSITIVITIES in tuned_by:
        yield from _sensitivities(preset)
    if Tuning.THRESHOLDS in tuned_by:
        yield from _thresholds(recogniser.used_thresholds)
    if Tuning.RULES in tuned_by:
        yield from _limits_in(preset)


# -- the numbers of PhonemeData ----------------------------------------------------------------------------------


def _thresholds(used: frozenset[str]) -> Iterator[ControlGroup]:
    yield ControlGroup("Filters", FILTERS_NOTE, tuple(_filter_control(name) for name in FILTER_FIELDS))
    complete = all(name in used for names in RULE_FIELDS for name in names)
    for (title, note), names in zip(NOTES, RULE_FIELDS, strict=True):
        controls = tuple(_threshold_control(name) for name in names if name in used)
        yield ControlGroup(title, note if complete else "", controls)


def _filter_control(name: str) -> Control:
    """Return a control of a filter; the bounds of the high-pass are bins in PhonemeData, and in Hz here."""
    is_bins = name.startswith("high_pass")
    unit = BIN_WIDTH if is_bins else 1.0
    return _parameter_control(
        name,
        hint=f"PhonemeData name: {name}" + (", in bins there, in Hz here" if is_bins else ""),
        read=lambda preset: float(getattr(preset.settings, name)),
        write=lambda preset, value: with_number(preset, name, value / unit),
        live=lambda _preset, _moment: None,
    )


def _parameter_control(name: str, **others: Any) -> Control:
    of = PARAMETERS[name]
    return Control(name, of.label, 0.0, of.usual, of.decimals, unit=of.unit, **others)


def _threshold_control(name: str) -> Control:
    condition = CONDITION_OF[name]
    variable = condition.variable
    high, decimals = RANGES[variable]
    rule = f"{name[0].upper()}: " if variable == "m_o1" else ""  # three that else read alike
    return Control(
        name=name,
        label=f"{rule}{variable} {condition.sign}",
        low=0.0,
        high=high,
        decimals=decimals,
        read=lambda preset: float(getattr(preset.thresholds, name)),
        write=lambda preset, value: with_number(preset, name, value),
        live=lambda _preset, moment: moment.values.get(variable),
        sign=condition.sign,
        variable=variable,
        hint=f"PhonemeData name: {name}",
    )


def with_number(preset: Preset, name: str, value: float) -> Preset:
    """Return the preset with another number of PhonemeData; of the bounds of the high-pass, the other gives way.

    `value` is in the units of a PhonemeData file, where the bounds of the high-pass are bins of 21.53 Hz.
    """
    data = preset.phoneme_data
    numbers = {f.name: getattr(data, f.name) for f in fields(PhonemeData)} | {name: value}
    if name == "high_pass_start":
        numbers["high_pass_end"] = max(value, numbers["high_pass_end"])
    if name == "high_pass_end":
        numbers["high_pass_start"] = min(value, numbers["high_pass_start"])
    return preset.with_phoneme_data(PhonemeData(**numbers))


# -- the limits of rules -----------------------------------------------------------------------------------------


def _limits_in(preset: Preset) -> Iterator[ControlGroup]:
    """Yield a group for each variable, with one control for each limit, however many conditions share it."""
    places: dict[str, dict[float, list[tuple[int, int]]]] = {}
    for k, rule in enumerate(preset.rules):
        for j, c in enumerate(rule.conditions):
            if rule.enabled and c.enabled and not c.threshold:
                places.setdefault(c.variable, {}).setdefault(c.limit, []).append((k, j))
    for variable, limits in places.items():
        ordered = sorted(limits.items())
        controls = (_limit_control(preset.rules, variable, limit, found) for limit, found in ordered)
        title = readable_name(variable, preset.variables)
        yield ControlGroup(title, variable if title != variable else "", tuple(controls))


def _limit_control(rules: tuple[Rule, ...], variable: str, limit: float, places: list[tuple[int, int]]) -> Control:
    asked: dict[str, list[str]] = {}
    for k, j in places:
        of_sign = asked.setdefault(rules[k].conditions[j].sign, [])
        if rules[k].phoneme.label not in of_sign:
            of_sign.append(rules[k].phoneme.label)
    most = MOST_NAMES if len(asked) == 1 else 1
    first, number = places[0]
    return Control(
        name=f"limit {first + 1}.{number + 1}",
        label=_named(asked, most),
        low=0.0,
        high=RANGES[variable][0] if variable in RANGES else LIMIT_ROOM * max(abs(limit), 1e-3),
        decimals=4,
        read=lambda preset: preset.rules[first].conditions[number].limit,
        write=lambda preset, value: replace(preset, rules=_with_limit(preset.rules, places, value)),
        live=lambda _preset, moment: moment.values.get(variable),
        sign=next(iter(asked)) if len(asked) == 1 else ">",
        variable=variable,
        hint=f"Limit for {variable}; {len(places)} conditions: {_named(asked)}",
        places=tuple(places),
    )


def _named(asked: Mapping[str, list[str]], most: int = len(Phoneme)) -> str:
    """Return what a limit is asked for, such as ``< m, a; > p…``: by sign the phonemes, at most `most` of them."""
    parts = (f"{sign} {', '.join(of[:most])}{'…' if len(of) > most else ''}" for sign, of in sorted(asked.items()))
    return "; ".join(parts)


def _with_limit(rules: tuple[Rule, ...], places: list[tuple[int, int]], limit: float) -> tuple[Rule, ...]:
    changed = set(places)
    return tuple(
        replace(rule, conditions=tuple(_limited(c, limit, (k, j) in changed) for j, c in enumerate(rule.conditions)))
        for k, rule in enumerate(rules)
    )


def _limited(condition: Condition, limit: float, changes: bool) -> Condition:
    return replace(condition, limit=limit) if changes else condition


# -- sensitivities -----------------------------------------------------------------------------------------------


def _sensitivities(preset: Preset) -> Iterator[ControlGroup]:
    """Yield a control for each phoneme that the recogniser can name."""
    templates = preset.templates if Tuning.TEMPLATES in spec_of(preset.recogniser).tuned_by else None
    named = set(Phoneme) if templates is None else {Phoneme.SILENCE, *templates.means}
    apart = {Phoneme.SILENCE: "Silence", Phoneme.UNIDENTIFIED: "Other sounds"}
    sounds = tuple(_sensitivity_control(p) for p in Phoneme if p in named - apart.keys())
    yield ControlGroup("Sounds", "the most likely one is recognised", sounds)
    for phoneme, title in apart.items():
        yield ControlGroup(title, "", (_sensitivity_control(phoneme),) if phoneme in named else ())


def _sensitivity_control(phoneme: Phoneme) -> Control:
    return Control(
        name=f"sensitivity_{phoneme.label}",
        label=phoneme.label,
        low=-MOST_LOG_ODDS / 2,
        high=MOST_LOG_ODDS / 2,
        decimals=2,
        read=lambda preset: preset.sensitivities.get(phoneme, 0.0),
        write=lambda preset, value: replace(preset, sensitivities=_sensitised(preset.sensitivities, phoneme, value)),
        live=lambda preset, moment: _deficit(preset.sensitivities, moment.values, phoneme),
        sign="<",
        variable=DEFICITS[phoneme],
        hint=(
            f"Added to the log-odds of {phoneme.label}: each +1 makes it 2.7 times more likely. The bar shows by how "
            "much it trails the most likely other phoneme; it is recognised while the bar is left of the handle."
        ),
    )


def _sensitised(sensitivities: Mapping[Phoneme, float], phoneme: Phoneme, value: float) -> Mapping[Phoneme, float]:
    others = {p: s for p, s in sensitivities.items() if p is not phoneme}
    return {**others, phoneme: value} if value else others


def _deficit(sensitivities: Mapping[Phoneme, float], values: Mapping[str, float], phoneme: Phoneme) -> float | None:
    """Return by how much a phoneme falls short before its own sensitivity; None before anything was measured."""
    if SCORES[0] not in values:
        return None
    scores = np.array([[values[name] for name in SCORES]], np.float32)
    return float(deficits_of(scores, phoneme)[0]) + sensitivities.get(phoneme, 0.0)


# -- smoothing --------------------------------------------------------------------------------------------------


def _calm(preset: Preset, recogniser: Recogniser | None) -> ControlGroup:
    hold = _setting_control(
        "minimum_hold",
        "Shortest time for which a phoneme is shown. The bar shows how long the current one has lasted.",
        lambda _preset, moment: moment.lasted,
    )
    hysteresis = _setting_control(
        "hysteresis",
        "By how much another phoneme must score higher to replace the current one. The bar shows by how much it does "
        "now.",
        lambda _preset, moment: moment.deficit,
    )
    change_cost = _setting_control("change_cost", HINTS["change_cost"], lambda _preset, _moment: None)
    if preset.decoder:
        steady: tuple[Control, ...] = (change_cost,)
    else:
        steady = (hysteresis,) if recogniser is not None and spec_of(preset.recogniser).has_deficits else ()
    return ControlGroup("Smoothing", "lower reacts faster", (*steady, hold))


def _with_statistics(preset: Preset, changes: dict[str, Any]) -> Preset:
    """Return the preset with other numbers of the statistics, which are switched on, else they would not act."""
    return replace(preset, settings=replace(preset.settings, statistics=True, **changes))


def _setting_control(name: str, hint: str, live: Callable[[Preset, Moment], float | None]) -> Control:
    return _parameter_control(
        name,
        hint=hint,
        read=lambda preset: float(getattr(preset.settings, name)),
        write=lambda preset, value: _with_statistics(preset, {name: value}),
        live=live,
        sign=">",
    )
