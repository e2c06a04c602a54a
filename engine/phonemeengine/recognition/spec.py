"""The one registry of recognisers: what each is called, made from, needs and is tuned by, and how it learns.

All that the rest of the program knows of a recogniser stands in its specification; nothing else asks for its name or
its class. Those of other packages come through entry points (see `plug_ins`).
"""

import pkgutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import partial
from importlib.metadata import EntryPoint
from typing import Any, Protocol, runtime_checkable

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import PresetError, RecogniserError
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.decoder import DecodedRules, Decoder
from phonemeengine.recognition.learned import LearnedRecogniser
from phonemeengine.recognition.model import Model
from phonemeengine.recognition.plug_ins import PlugIn, call_foreign, package_of, plug_ins
from phonemeengine.recognition.rules import (
    RULES,
    PitchSet,
    PitchSetRules,
    Rule,
    RuleRecogniser,
    ThesisRules,
    Thresholds,
)
from phonemeengine.recognition.scores import NO_SENSITIVITIES, SCORES, Recognition, Trace
from phonemeengine.recognition.templates import TemplateRecogniser, Templates


@dataclass(frozen=True)
class RecogniserConfig:
    """All that a recogniser may be made from.

    Attributes
    ----------
    thresholds : what the thesis rules compare with.
    rules : the preset's own rules.
    model : what the learned recogniser knows.
    templates : what the recogniser by templates compares with.
    look_ahead : seconds after a frame that it may wait for.
    sensitivities : log-odds that recognisers by scores add to those of phonemes, nats.
    pitch_sets : numbers that take the place of the thresholds by the pitch of the voice.
    decoder : what a search behind the answers of rules goes by; None without one.
    """

    thresholds: Thresholds = field(default_factory=Thresholds)
    rules: tuple[Rule, ...] = ()
    model: Model | None = None
    templates: Templates | None = None
    look_ahead: float = 0.0
    sensitivities: Mapping[Phoneme, float] = field(default_factory=lambda: NO_SENSITIVITIES)
    pitch_sets: tuple[PitchSet, ...] = ()
    decoder: Decoder | None = None


class Recogniser(Protocol):
    """Gives every frame of a sound a phoneme, and can say why.

    Blocks come in the order of the sound, cut anywhere, so a recogniser may remember; after a seek a new one is made,
    which is given a second of the sound unseen. `explain` and `deficits` look only at the block that they are given.
    """

    look_ahead: int
    """Frames after a frame that it waits for; the answers are delayed by as many."""

    scores: tuple[str, ...]
    """Names of what it measures itself, such as how likely each phoneme is; they become columns of the features."""

    @property
    def used_thresholds(self) -> frozenset[str]:
        """The fields of `Thresholds` that it compares with."""
        ...

    def recognise(self, windows: Float32Array, features: Features, /) -> Recognition:
        """Recognise the next frames: what is given belongs to the frames `look_ahead` before those that came.

        The first `look_ahead` frames of a sound give nothing; as many frames of silence after its end give the last.

        Parameters
        ----------
        windows : the raw samples of each frame, float32, shape (n_frames, 2048).
        features : the variables that were measured on them, with as many frames.
        """
        ...

    def deficits(self, features: Features) -> Float32Array | None:
        """Return by how much each phoneme falls short of being named, shape (n_frames, n_phonemes), or None."""
        ...

    def explain(self, features: Features, k: int) -> Trace:
        """Return why frame `k` of a block is recognised as it is."""
        ...


@runtime_checkable
class Finishing(Protocol):
    """What a `Recogniser` is besides that works on excerpts of a sound, and so delays frames until it has one.

    Its answers are about the oldest frames of which it has said nothing. Its `look_ahead` is above 0.
    """

    def finish(self) -> Recognition:
        """Return the answers for all frames that it still holds, since the sound is over."""
        ...


@runtime_checkable
class Joining(Protocol):
    """What a `Recogniser` is besides that can be asked together with those of other sounds, which costs less."""

    kin: object | None
    """Equal to that of those that may be asked with it, since they differ in their sounds alone; None for none."""

    most_together: int
    """Frames of a sound that may be asked at once."""

    def recognise_with(self, others: Sequence[Any], windows: Sequence[Float32Array]) -> list[Recognition]:
        """Recognise the next frames of several sounds with one network, its own first, as if each were alone.

        Parameters
        ----------
        windows : the next frames of each sound, its own first, at least one and `most_together` at the most.
        """
        ...


class Tuning(StrEnum):
    """What of a preset a recogniser can be tuned by; each is a field of `Preset` and of `RecogniserConfig`.

    Who is tuned by `SENSITIVITIES` names the likeliest phoneme: its scores are `SCORES`, probabilities that add up to
    1 with the sensitivities in them.
    """

    THRESHOLDS = "thresholds"
    RULES = "rules"
    MODEL = "model"
    TEMPLATES = "templates"
    SENSITIVITIES = "sensitivities"
    PITCH_SETS = "pitch_sets"


_INDISPENSABLE = {Tuning.RULES: "rules", Tuning.MODEL: "a model", Tuning.TEMPLATES: "templates"}
"""What a recogniser that is tuned by it cannot do without, in words."""


@dataclass(frozen=True)
class RecogniserSpec:
    """All that the program knows of a recogniser.

    Attributes
    ----------
    name : what presets call it; of one of another package, the name of its entry point.
    make : makes one for one sound.
    tuned_by : what of a preset it depends on.
    needs_features : whether it reads variables; without them it measures the windows for itself.
    uses_own_variables : whether variables that a user adds can act on it.
    looks_ahead : whether it heeds `RecogniserConfig.look_ahead`.
    has_deficits : whether it knows by how much phonemes fall short, without which there is no hysteresis.
    rules : gives the rules that it asks, where it is one by rules: `LabelledFeatures` asks them itself.
    factory_preset : file name of the factory preset that suits it, or the path of a preset of its package; or none.
    fit : the function that fits its numbers to recordings, ``"module:function"``, called as
        `phonemeengine.calibration.fits.fitting.Fit`; or none.
    adapt : the function by which it learns one voice, ``"module:function"``, called as
        `phonemeengine.calibration.calibrate.Adapt`; or none.
    entry : where another package offers it; None for those of the program.
    """

    name: str
    make: Callable[[RecogniserConfig], Recogniser]
    tuned_by: frozenset[Tuning] = frozenset({Tuning.THRESHOLDS})
    needs_features: bool = True
    uses_own_variables: bool = True
    looks_ahead: bool = False
    has_deficits: bool = False
    rules: Callable[[RecogniserConfig], tuple[Rule, ...]] | None = None
    factory_preset: str = ""
    fit: str = ""
    adapt: str = ""
    entry: EntryPoint | None = None

    def check(self, config: RecogniserConfig) -> None:
        """Refuse a configuration that lacks what the recogniser cannot do without.

        Raises
        ------
        PresetError : it says what is missing, and with which preset to begin.
        """
        for tuning, words in _INDISPENSABLE.items():
            if tuning in self.tuned_by and not getattr(config, tuning):
                hint = (
                    f"begin with the preset {self.factory_preset}" if self.factory_preset else "choose another preset"
                )
                raise PresetError(f"the recogniser {self.name!r} needs {words}, and this preset has none; {hint}")

    def load(self, function: str) -> Callable[..., Any]:
        """Return the function that `fit` or `adapt` names, imported now: it knows rooms above this one.

        Raises
        ------
        RecogniserError : it is another package's and cannot be imported, or, when it is called, fails.
        """
        if self.entry is None:
            found: Callable[..., Any] = pkgutil.resolve_name(function)
            return found
        foreign = call_foreign(self.entry, "learn", pkgutil.resolve_name, function)
        return partial(call_foreign, self.entry, "learn", foreign)


def _learned(config: RecogniserConfig) -> Recogniser:
    assert config.model is not None
    return LearnedRecogniser(config.model, config.look_ahead, config.sensitivities)


def _by_templates(config: RecogniserConfig) -> Recogniser:
    assert config.templates is not None
    return TemplateRecogniser(config.templates, config.sensitivities)


def _thesis(config: RecogniserConfig) -> Recogniser:
    sets = [pitch_set.data for pitch_set in config.pitch_sets]
    return _decoded(PitchSetRules(config.thresholds, sets) if sets else ThesisRules(config.thresholds), config)


def _by_own_rules(config: RecogniserConfig) -> Recogniser:
    return _decoded(RuleRecogniser(config.rules, config.thresholds), config)


def _decoded(rules: RuleRecogniser, config: RecogniserConfig) -> Recogniser:
    """Return rules, with a search behind them where there is one."""
    return rules if config.decoder is None else DecodedRules(rules, config.decoder, config.look_ahead)


THESIS = RecogniserSpec(
    name="thesis",
    make=_thesis,
    tuned_by=frozenset({Tuning.THRESHOLDS, Tuning.PITCH_SETS}),
    uses_own_variables=False,
    has_deficits=True,
    rules=lambda _config: RULES,
    factory_preset="thesis.toml",
    fit="phonemeengine.calibration.fits.fitting:fit_thresholds",
    adapt="phonemeengine.calibration.fits.fitting:adapt_rules",
)
LEARNED = RecogniserSpec(
    name="learned",
    make=_learned,
    tuned_by=frozenset({Tuning.MODEL, Tuning.SENSITIVITIES}),
    needs_features=False,
    uses_own_variables=False,
    looks_ahead=True,
    has_deficits=True,
    factory_preset="learned.toml",
    adapt="phonemeengine.calibration.adaptation:adapt_to_takes",
)
OWN_RULES = RecogniserSpec(
    name="rules",
    make=_by_own_rules,
    tuned_by=frozenset({Tuning.RULES, Tuning.THRESHOLDS}),
    has_deficits=True,
    rules=lambda config: config.rules,
    factory_preset="extended.toml",
    fit="phonemeengine.calibration.fits.fitting:fit_limits",
    adapt="phonemeengine.calibration.fits.fitting:adapt_rules",
)
TEMPLATES = RecogniserSpec(
    name="templates",
    make=_by_templates,
    tuned_by=frozenset({Tuning.TEMPLATES, Tuning.SENSITIVITIES}),
    needs_features=False,
    uses_own_variables=False,
    has_deficits=True,
    factory_preset="templates.toml",
    adapt="phonemeengine.calibration.fits.templates:adapt_to_takes",
)
BUILT_IN: dict[str, RecogniserSpec] = {spec.name: spec for spec in (THESIS, LEARNED, OWN_RULES, TEMPLATES)}
"""The recognisers that come with the program; no other package can take their names."""


def recogniser_names() -> tuple[str, ...]:
    """Return the names of all recognisers, the program's own first; those of other packages are not imported."""
    return (*BUILT_IN, *(name for name in plug_ins() if name not in BUILT_IN))


def check_recogniser(name: str, config: RecogniserConfig) -> None:
    """Refuse a name that is not exactly one recogniser's, or one of the program that lacks what it needs.

    Nothing is imported.

    Raises
    ------
    PresetError : there is none of that name, or it lacks something.
    RecogniserError : several packages offer one of that name.
    """
    if name in BUILT_IN:
        BUILT_IN[name].check(config)
    else:
        _entry_of(name)


def spec_of(name: str) -> RecogniserSpec:
    """Return what is known of the recogniser that a preset names; that of another package is imported.

    Raises
    ------
    PresetError : there is none of that name.
    RecogniserError : several packages offer it, or it cannot be imported.
    """
    return BUILT_IN.get(name) or _offered(_entry_of(name))


def recogniser_of(name: str, config: RecogniserConfig) -> Recogniser:
    """Return the recogniser that a preset names; one of another package is made when it is first asked.

    Raises
    ------
    PresetError : there is none of that name, or the preset lacks what it needs.
    RecogniserError : several packages offer it, or it cannot be imported.
    """
    spec = spec_of(name)
    spec.check(config)
    return spec.make(config)


def _entry_of(name: str) -> EntryPoint:
    entries = plug_ins().get(name, ())
    if not entries:
        raise PresetError(
            f"there is no recogniser named {name!r:.60}; known are {', '.join(recogniser_names())}; install the "
            "package that brings it, or choose another preset"
        )
    if len(entries) > 1:
        packages = " and ".join(package_of(entry) for entry in entries)
        raise RecogniserError(f"the recogniser {name!r:.60} is offered twice, by {packages}; uninstall one of them")
    return entries[0]


def _offered(entry: EntryPoint) -> RecogniserSpec:
    """Return the specification that a package offers, or that of its class, which is made from `Thresholds` alone."""
    offered = call_foreign(entry, "be imported", entry.load)
    is_spec = isinstance(offered, RecogniserSpec)
    spec = offered if is_spec else RecogniserSpec(entry.name, lambda config: offered(config.thresholds))
    wanted = SCORES if Tuning.SENSITIVITIES in spec.tuned_by else None
    return replace(
        spec, name=entry.name, make=lambda config: PlugIn(entry, partial(spec.make, config), wanted), entry=entry
    )
