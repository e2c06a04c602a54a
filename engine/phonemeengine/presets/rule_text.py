"""The rules of a preset as a person reads them."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from phonemeengine.errors import PresetError
from phonemeengine.features.measure import Features
from phonemeengine.features.variables import readable_name
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.recognition import Trace
from phonemeengine.recognition.rule_checks import rule_faults
from phonemeengine.recognition.rules import DEFAULT_RULE, Condition, Rule, limit_of, rule_labels
from phonemeengine.recognition.spec import OWN_RULES, spec_of


def rules_of(preset: Preset) -> tuple[Rule, ...]:
    """Return the rules by which a preset recognises, in the order of decision; none where it has no rules."""
    found = spec_of(preset.recogniser).rules
    return () if found is None else found(preset.config)


def with_own_rules(preset: Preset) -> Preset:
    """Return the preset with fixed rules as rules of its own, which recognise alike and can be changed."""
    rules = tuple(
        replace(
            rule,
            conditions=tuple(
                Condition(c.variable, c.sign, limit=limit_of(c, preset.thresholds)) for c in rule.conditions
            ),
        )
        for rule in rules_of(preset)
    )
    return replace(preset, recogniser=OWN_RULES.name, rules=rules)


def rule_lines(preset: Preset, features: Features | None = None) -> list[str]:
    """Return a line for each rule in the order of decision, and one for each variable that they ask for.

    Parameters
    ----------
    preset : whose rules they are.
    features : what was measured in some sound, to tell of rules that never hold there, or always.

    Raises
    ------
    PresetError : it recognises without rules.
    """
    rules = rules_of(preset)
    if not rules:
        raise PresetError(
            f"the recogniser {preset.recogniser!r} has no rules; choose a preset with rules, such as extended, or "
            "find some with phonemeanalyser rules"
        )
    labels = rule_labels((*rules, DEFAULT_RULE))
    faults = rule_faults(rules, preset.thresholds, features)
    width = max(map(len, labels))
    lines = [
        f"{k + 1:3d}  {label or rule.phoneme.label:{width}}  {_words(rule, preset)}{f'  ({fault})' if fault else ''}"
        for k, (rule, label, fault) in enumerate(zip(rules, labels, faults, strict=False))
    ]
    return [*lines, "", *_legend(rules, preset)]


def trace_lines(trace: Trace) -> Iterator[str]:
    """Yield why a frame was recognised: each rule down to the one that fired, with what it compared."""
    if not trace.comparisons:
        yield f"{trace.rule}: no comparison decides it"
    for c in trace.comparisons:
        mark = "holds" if c.margin > 0 else "fails"
        yield f"{c.rule}: {c.variable} {c.value:.4g} {c.sign} {c.limit:.4g} {mark} by {abs(c.margin):.3g}"


def _words(rule: Rule, preset: Preset) -> str:
    asked = [_condition(c, preset) for c in rule.conditions if c.enabled]
    off = [f"[off: {_condition(c, preset)}]" for c in rule.conditions if not c.enabled]
    words = " ".join([*(["if " + " and ".join(asked)] if asked else ["always"]), *off])
    return words if rule.enabled else f"[off] {words}"


def _condition(c: Condition, preset: Preset) -> str:
    return f"{c.variable} {c.sign} {limit_of(c, preset.thresholds):g}" + (f" ({c.threshold})" if c.threshold else "")


def _legend(rules: Sequence[Rule], preset: Preset) -> Iterator[str]:
    names = sorted({c.variable for rule in rules for c in rule.conditions})
    width = max(map(len, names), default=0)
    for name in names:
        yield f"{name:{width}}  {readable_name(name, preset.variables)}"
