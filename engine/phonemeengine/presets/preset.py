"""The preset: everything that a recognition was tuned with, as one value."""

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from types import MappingProxyType

from phonemeengine.arrays import ShortRepr
from phonemeengine.encoder.head import EncoderHead
from phonemeengine.encoder.live import LiveEncoder
from phonemeengine.errors import PresetError
from phonemeengine.features.variables import BUILT_IN_NAMES, Variable, check_user_variables
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.confidence import UNFITTED, ConfidenceCurve
from phonemeengine.recognition.model import Model
from phonemeengine.recognition.phoneme_data import FILTER_FIELDS, PhonemeData, Thresholds
from phonemeengine.recognition.rules import Rule
from phonemeengine.recognition.scores import NO_SENSITIVITIES, check_sensitivities
from phonemeengine.recognition.smoothing import SUCCESSORS
from phonemeengine.recognition.spec import THESIS, RecogniserConfig, check_recogniser
from phonemeengine.recognition.templates import Templates
from phonemeengine.settings import BIN_WIDTH, AnalysisSettings, Ear

NO_CURVES: Mapping[Ear, ConfidenceCurve] = MappingProxyType({})
LIVE_EARS = (Ear.LIVE, Ear.ENCODER)
"""What live sound may be recognised with."""
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
    file_model : what it knows of sounds that are wholly known, a centred one; None where it hears files as all else.
    encoder_head : what it knows of phonemes from a speech encoder, for the ear ``whisper``; None where it has none.
    live_encoder : the real-time model that recognises live sound together with `model`; None where it has none.
    live_model : ``encoder`` to use it where it can be had, or ``live`` for the small network alone; see
        `phonemeengine.presets.ears.for_live_use`.
    file_ear : the best that files are heard with, if it can be had; see `phonemeengine.presets.ears.for_files`.
    ear : what is heard with now; only `for_files` and `for_live_use` give presets whose ear is another one than
        ``live``.
    templates : what the recogniser by templates compares with.
    sensitivities : by phoneme, log-odds in nats that recognisers by scores add to those of the phoneme, -10..10.
    successors : what replaces an unidentified frame after each phoneme.
    confidences : by ear, how the scores of what is named become confidences; those without one take a score for what
        it is, and rules say nothing.
    notes : free text.
    warnings : what of it could not be had, and what serves instead, a sentence each; two presets that differ in
        nothing else are equal.

    Raises
    ------
    EngineError : a variable's name is taken, a rule asks for a variable that nobody measures, there is no such
        recogniser, or there are two, or it lacks rules, a model or templates.
    """

    name: str = "untitled"
    settings: AnalysisSettings = field(default_factory=AnalysisSettings)
    thresholds: Thresholds = field(default_factory=Thresholds)
    variables: tuple[Variable, ...] = ()
    recogniser: str = THESIS.name
    rules: tuple[Rule, ...] = ()
    model: Model | None = None
    file_model: Model | None = None
    encoder_head: EncoderHead | None = None
    live_encoder: LiveEncoder | None = None
    live_model: Ear = Ear.ENCODER
    file_ear: Ear = Ear.WHISPER
    ear: Ear = Ear.LIVE
    templates: Templates | None = None
    sensitivities: Mapping[Phoneme, float] = field(default_factory=lambda: NO_SENSITIVITIES)
    successors: Mapping[Phoneme, Phoneme] = field(default_factory=lambda: SUCCESSORS)
    confidences: Mapping[Ear, ConfidenceCurve] = field(default_factory=lambda: NO_CURVES)
    notes: str = ""
    warnings: tuple[str, ...] = field(default=(), compare=False)

    def __post_init__(self) -> None:
        check_user_variables(self.variables)
        check_recogniser(self.recogniser, self.config)
        check_sensitivities(self.sensitivities)
        if self.live_model not in LIVE_EARS:
            raise PresetError(f"live_model is one of {', '.join(LIVE_EARS)}, got {self.live_model}")
        _check_rules(self.rules, {*BUILT_IN_NAMES, *(v.name for v in self.variables)})

    @property
    def summary(self) -> str:
        """What it is, in one line: the first one of its notes; empty where it has none."""
        return self.notes.strip().partition("\n")[0]

    @property
    def config(self) -> RecogniserConfig:
        """What the recogniser is made from."""
        model = self.model if self.ear in LIVE_EARS else self.file_model or self.model
        look_ahead = self.settings.look_ahead
        return RecogniserConfig(self.thresholds, self.rules, model, self.templates, look_ahead, self.sensitivities)

    @property
    def curve(self) -> ConfidenceCurve:
        """How scores become confidences with the ear in use."""
        return self.confidences.get(self.ear, UNFITTED)

    @property
    def is_measured(self) -> bool:
        """Whether its confidence was measured on labelled speech, with the ear in use."""
        return self.ear in self.confidences

    @property
    def phoneme_data(self) -> PhonemeData:
        """The 21 numbers of the old file format."""
        numbers = {name: getattr(self.settings, name) for name in FILTER_FIELDS}
        for name in _IN_BINS:
            numbers[name] /= BIN_WIDTH
        return PhonemeData(**vars(self.thresholds), **numbers)

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
                    f"a rule for {rule.phoneme.label} asks for the variable {condition.variable[:60]}, which nobody "
                    "measures; add it, or change the rule"
                )
