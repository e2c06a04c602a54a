"""The preset: everything that a recognition was tuned with, as one value; what it was judged by; rules as text."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from datetime import date
from types import MappingProxyType
from typing import Any

from typing_extensions import override

from phonemeengine.arrays import ShortRepr
from phonemeengine.encoder.head import EncoderHead
from phonemeengine.encoder.live import LiveEncoder
from phonemeengine.errors import PresetError
from phonemeengine.features.variables import BUILT_IN_NAMES, Features, Variable, check_user_variables, readable_name
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.decoder import Confusions, Decoder, ScoreSearch, check_confusions
from phonemeengine.recognition.model import Model
from phonemeengine.recognition.rules import (
    DEFAULT_RULE,
    FILTER_FIELDS,
    Condition,
    PhonemeData,
    PitchSet,
    Rule,
    Thresholds,
    limit_of,
    rule_faults,
    rule_labels,
)
from phonemeengine.recognition.scores import NO_SENSITIVITIES, UNFITTED, ConfidenceCurve, Trace, check_sensitivities
from phonemeengine.recognition.segments import SUCCESSORS
from phonemeengine.recognition.spec import OWN_RULES, THESIS, RecogniserConfig, Tuning, check_recogniser, spec_of
from phonemeengine.recognition.templates import Templates
from phonemeengine.settings import BIN_WIDTH, AnalysisSettings, Decoding, ModelKind
from phonemeengine.storage.strict_table import StrictTable


@dataclass(frozen=True)
class Judgement:
    """What a calibration gained on held-out speech.

    Attributes
    ----------
    start : name of the preset that was calibrated.
    day : of the calibration, as in ``2026-11-25``.
    seconds : how much held-out speech was measured.
    cross_validated : whether that was each quarter of the takes in turn, and no speech of its own.
    mouth_shapes : share of frames with the right mouth shape, before and after, 0..1.
    macro_f1 : macro F1 before and after, 0..1.
    changed : whether the preset was changed since, so that the figures are no longer its own.

    Raises
    ------
    PresetError : the day is none.
    """

    start: str
    day: str
    seconds: float
    cross_validated: bool
    mouth_shapes: tuple[float, float]
    macro_f1: tuple[float, float]
    changed: bool = False

    def __post_init__(self) -> None:
        try:
            date.fromisoformat(self.day)
        except ValueError as error:
            raise PresetError(
                f"[judged] day is a date such as 2026-11-25, found {self.day!r:.40}; correct it"
            ) from error

    @override
    def __str__(self) -> str:
        """Return one line for lists of presets."""
        before, after = (f"{100 * share:.0f}" for share in self.mouth_shapes)
        figures = f"mouth shapes {before} to {after} % on held-out speech"
        return f"{self.start}, own voice, {self.day}: {figures}{', changed since' if self.changed else ''}"

    def table(self) -> dict[str, Any]:
        """Return it as a table of a preset file."""
        table = asdict(self)
        if not self.changed:
            del table["changed"]
        return {key: list(value) if isinstance(value, tuple) else value for key, value in table.items()}


def judgement_of(table: StrictTable) -> Judgement:
    """Read it from a table of a preset file; PresetError where it is none."""
    table.check_keys([key for key in Judgement.__dataclass_fields__ if key != "changed"], ["changed"])
    return Judgement(
        table.value("start", str),
        table.value("day", str),
        table.value("seconds", float),
        table.value("cross_validated", bool),
        _pair(table, "mouth_shapes"),
        _pair(table, "macro_f1"),
        table.value("changed", bool, False),
    )


def _pair(table: StrictTable, key: str) -> tuple[float, float]:
    shares = table.numbers(key)
    if len(shares) != 2 or not all(0.0 <= share <= 1.0 for share in shares):
        raise table.refusal(key, "two shares 0..1, before and after", list(shares))
    return shares[0], shares[1]


NO_CONFUSIONS: Confusions = MappingProxyType({})
NO_CURVES: Mapping[ModelKind, ConfidenceCurve] = MappingProxyType({})
PRE_ROLL = 100
"""Frames before a place in a sound that are analysed unseen, so that filters and networks know their past."""
PITCH_PRE_ROLL = 1000
"""The same where the pitch of the voice chooses a set, which takes a second of voice, and pauses lie between."""
SEARCHED_NATS = 15.0
"""What a change of phoneme costs the search through the scores of a whole sound, nats for each 1 of hysteresis."""
LIVE_KINDS = (ModelKind.REAL_TIME, ModelKind.ENCODER)
"""Models for live sound."""
_IN_BINS = ("high_pass_start", "high_pass_end")


@dataclass(frozen=True, repr=False)
class Preset(ShortRepr):
    """A calibrated recognition.

    Attributes
    ----------
    name : what people call it.
    settings : the front end.
    thresholds : the numbers that the rules compare with.
    variables : the user's own variables.
    recogniser : name of the recogniser.
    rules : what the recogniser of own rules asks, in this order; each condition compares a variable with a number.
    model : what the learned recogniser knows.
    offline_model : the offline model, a centred one; None if it has none.
    encoder_head : the head on layer 4 of Whisper, for the model ``whisper``; None if it has none.
    live_encoder : the encoder that recognises live sound together with `model`; None if it has none.
    live_model : the model for live sound: ``encoder`` to use the encoder if possible, or ``real-time`` for the small
        network alone; see `phonemeengine.presets.model_choice.for_live_use`.
    file_model : the best model for files, if it can be used; see `phonemeengine.presets.model_choice.for_files`.
    model_kind : the model in use; only `for_files` and `for_live_use` return presets with another one than
        ``real-time``.
    templates : what the recogniser by templates compares with.
    sensitivities : by phoneme, log-odds in nats that recognisers by scores add to those of the phoneme, -10..10.
    successors : what replaces an unidentified frame after each phoneme.
    pitch_sets : sets of PhonemeData that take the place of the preset's own numbers by the pitch of the voice; of
        several whose range holds it, the first.
    confusions : by phoneme that is spoken, how likely each answer of the rules is, nats: what a decoder goes by.
    confidences : by model, the curve that turns scores into confidences; without one a score is its own confidence,
        and rules have none.
    judged : what a calibration gained on held-out speech; None for a preset that no calibration made.
    notes : free text.
    warnings : what of it could not be had, and what serves instead, a sentence each; two presets that differ in
        nothing else are equal.

    Raises
    ------
    EngineError : a variable's name is taken, a rule asks for a variable that is not measured, there is no such
        recogniser, or there are two, or it lacks rules, a model or templates.
    """

    name: str = "untitled"
    settings: AnalysisSettings = field(default_factory=AnalysisSettings)
    thresholds: Thresholds = field(default_factory=Thresholds)
    variables: tuple[Variable, ...] = ()
    recogniser: str = THESIS.name
    rules: tuple[Rule, ...] = ()
    model: Model | None = None
    offline_model: Model | None = None
    encoder_head: EncoderHead | None = None
    live_encoder: LiveEncoder | None = None
    live_model: ModelKind = ModelKind.ENCODER
    file_model: ModelKind = ModelKind.WHISPER
    model_kind: ModelKind = ModelKind.REAL_TIME
    templates: Templates | None = None
    sensitivities: Mapping[Phoneme, float] = field(default_factory=lambda: NO_SENSITIVITIES)
    successors: Mapping[Phoneme, Phoneme] = field(default_factory=lambda: SUCCESSORS)
    pitch_sets: tuple[PitchSet, ...] = ()
    confusions: Confusions = field(default_factory=lambda: NO_CONFUSIONS)
    confidences: Mapping[ModelKind, ConfidenceCurve] = field(default_factory=lambda: NO_CURVES)
    judged: Judgement | None = None
    notes: str = ""
    warnings: tuple[str, ...] = field(default=(), compare=False)

    def __post_init__(self) -> None:
        check_user_variables(self.variables)
        check_recogniser(self.recogniser, self.config)
        check_sensitivities(self.sensitivities)
        check_confusions(self.confusions)
        if self.live_model not in LIVE_KINDS:
            raise PresetError(f"live_model is one of {', '.join(LIVE_KINDS)}, got {self.live_model}; correct it")
        _check_rules(self.rules, {*BUILT_IN_NAMES, *(v.name for v in self.variables)})

    @property
    def summary(self) -> str:
        """What it is, in one line: what it was judged by, or the first line of its notes; empty without both."""
        return str(self.judged) if self.judged else self.notes.strip().partition("\n")[0]

    @property
    def config(self) -> RecogniserConfig:
        """What the recogniser is made from."""
        model = self.model if self.model_kind in LIVE_KINDS else self.offline_model or self.model
        return RecogniserConfig(
            self.thresholds,
            self.rules,
            model,
            self.templates,
            self.settings.look_ahead,
            self.sensitivities,
            self.pitch_sets,
            self.decoder,
        )

    @property
    def decoder(self) -> Decoder | None:
        """What a search behind the answers of its rules goes by; None where there is none, or it is off."""
        settings = self.settings
        if not (settings.statistics and self.has_decoder) or settings.decoder is Decoding.OFF:
            return None
        return Decoder(self.confusions, settings.change_cost, settings.decoder)

    @property
    def search(self) -> ScoreSearch | None:
        """What a search through the scores of a whole sound goes by; None for live sound, which has hysteresis."""
        settings = self.settings
        model = self.config.model if Tuning.MODEL in spec_of(self.recogniser).tuned_by else None
        whole = model is not None and (model.centred or self.model_kind is ModelKind.WHISPER)
        if not (whole and settings.statistics and settings.hysteresis):
            return None
        return ScoreSearch(SEARCHED_NATS * settings.hysteresis)

    @property
    def has_decoder(self) -> bool:
        """Whether a decoder can be switched on: it recognises by rules, and what they confuse is known."""
        return bool(self.confusions) and spec_of(self.recogniser).rules is not None

    @property
    def pre_roll(self) -> int:
        """Frames before a place in a sound that are analysed unseen, so that it is recognised as in the whole."""
        return PITCH_PRE_ROLL if self.pitch_ranges else PRE_ROLL

    @property
    def by_pitch(self) -> tuple["Preset", ...]:
        """The presets between which the pitch of the voice chooses, each without sets.

        The first one has its own numbers, which serve until the pitch is known and where no range holds it; the
        others have those of each set. There is the first alone where the recogniser uses no sets.
        """
        own = replace(self, pitch_sets=()) if self.pitch_sets else self
        if not self.pitch_sets or Tuning.PITCH_SETS not in spec_of(self.recogniser).tuned_by:
            return (own,)
        return (own, *(own.with_phoneme_data(pitch_set.data) for pitch_set in self.pitch_sets))

    @property
    def pitch_ranges(self) -> tuple[tuple[float, float], ...]:
        """The ranges of the sets that its recogniser uses, Hz; empty where it uses none."""
        uses_sets = len(self.by_pitch) > 1
        return tuple((pitch_set.low, pitch_set.high) for pitch_set in self.pitch_sets) if uses_sets else ()

    @property
    def curve(self) -> ConfidenceCurve:
        """How scores become confidences of the model in use."""
        return self.confidences.get(self.model_kind, UNFITTED)

    @property
    def is_measured(self) -> bool:
        """Whether its confidence was measured on labelled speech, of the model in use."""
        return self.model_kind in self.confidences

    @property
    def phoneme_data(self) -> PhonemeData:
        """The 21 numbers of the old file format."""
        numbers = {name: getattr(self.settings, name) for name in FILTER_FIELDS}
        for name in _IN_BINS:
            numbers[name] /= BIN_WIDTH
        return PhonemeData(**vars(self.thresholds), **numbers)

    def with_decoder(self, decoder: Decoding | None) -> "Preset":
        """Return the preset with the decoder switched so; None leaves it as it is.

        Raises
        ------
        PresetError : it has no decoder.
        """
        if decoder is None:
            return self
        if not self.has_decoder:
            raise PresetError(
                f"the preset {self.name[:60]!r} has no decoder, which needs rules and what they confuse; choose a "
                "preset such as extended"
            )
        return replace(self, settings=replace(self.settings, statistics=True, decoder=decoder))

    def with_phoneme_data(self, data: PhonemeData) -> "Preset":
        """Return the preset with these 21 numbers; a blur or denoise that changes is on while it is above 0."""
        numbers = {name: getattr(data, name) for name in FILTER_FIELDS}
        for name in _IN_BINS:
            numbers[name] = float(f"{numbers[name] * BIN_WIDTH:.15g}")  # what was round in Hz is so again
        thresholds = Thresholds(**{f.name: getattr(data, f.name) for f in fields(Thresholds)})
        return replace(self, settings=self.settings.with_numbers(**numbers), thresholds=thresholds)


def _check_rules(rules: tuple[Rule, ...], known: set[str]) -> None:
    for rule in rules:
        for condition in rule.conditions:
            if condition.variable not in known:
                raise PresetError(
                    f"a rule for {rule.phoneme.label} asks for the variable {condition.variable[:60]}, which is not "
                    "measured; add it, or change the rule"
                )


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
