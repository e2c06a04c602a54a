"""The rules of a preset as a person reads them."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from phonemeengine.errors import PresetError
from phonemeengine.features.variables import Features, Variable, readable_name
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import DEFAULT_RULE, Condition, Rule, limit_of, rule_faults, rule_labels
from phonemeengine.recognition.scores import Trace
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
    """Return the rules in the order of decision, with a line for each condition.

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
    faults = rule_faults(rules, preset.thresholds, *([] if features is None else [features]))
    width = max(map(len, labels))
    lines = []
    for k, (rule, label, fault) in enumerate(zip(rules, labels, faults, strict=False)):
        first, *others = _words(rule, preset)
        lines.append(f"{k + 1:3d}  {label or rule.phoneme.label:{width}}  {first}{f'  ({fault})' if fault else ''}")
        lines += [f"{'':{width + 5}}  {words}" for words in others]
    return lines


def trace_lines(trace: Trace, mine: Iterable[Variable] = ()) -> Iterator[str]:
    """Yield why a frame was recognised: each rule down to the one that fired, with what it compared.

    Parameters
    ----------
    trace : of the frame.
    mine : the user's own variables.
    """
    mine = tuple(mine)
    if not trace.comparisons:
        yield f"{trace.rule}: no comparison decides it"
    for c in trace.comparisons:
        mark = "holds" if c.margin > 0 else "fails"
        compared = f"{named_twice(c.variable, mine)} {c.value:.4g} {c.sign} {c.limit:.4g}"
        yield f"{c.rule}: {compared} {mark} by {abs(c.margin):.3g}"


def named_twice(variable: str, mine: Iterable[Variable] = ()) -> str:
    """Return what a variable measures, and its short name after it in parentheses, unless it has that already."""
    words = readable_name(variable, mine)
    return words if words.startswith(variable) or words.endswith(f"({variable})") else f"{words} ({variable})"


def _words(rule: Rule, preset: Preset) -> list[str]:
    asked = [_condition(c, preset) for c in rule.conditions if c.enabled]
    off = [f"[off: {_condition(c, preset)}]" for c in rule.conditions if not c.enabled]
    words = [f"{'and' if k else 'if'} {words}" for k, words in enumerate(asked)] or ["always"]
    return [*([] if rule.enabled else ["[off]"]), *words, *off]


def _condition(c: Condition, preset: Preset) -> str:
    words = f"{named_twice(c.variable, preset.variables)} {c.sign} {limit_of(c, preset.thresholds):g}"
    return words + (f"  [{c.threshold}]" if c.threshold else "")
