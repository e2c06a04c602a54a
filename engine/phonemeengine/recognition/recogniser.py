"""What a recogniser is, and which ones there are."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Protocol

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import PresetError, RecogniserError
from phonemeengine.features.measure import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.learned import LearnedRecogniser
from phonemeengine.recognition.model import Model
from phonemeengine.recognition.phoneme_data import Thresholds
from phonemeengine.recognition.plug_ins import PlugIn, package_of, plug_ins
from phonemeengine.recognition.recognition import Recognition
from phonemeengine.recognition.rules import Rule, RuleRecogniser, ThesisRules
from phonemeengine.recognition.scores import NO_SENSITIVITIES
from phonemeengine.recognition.templates import TemplateRecogniser, Templates
from phonemeengine.recognition.trace import Trace


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
    sensitivities : log-odds that the learned one and templates add to those of phonemes, nats.
    """

    thresholds: Thresholds = field(default_factory=Thresholds)
    rules: tuple[Rule, ...] = ()
    model: Model | None = None
    templates: Templates | None = None
    look_ahead: float = 0.0
    sensitivities: Mapping[Phoneme, float] = field(default_factory=lambda: NO_SENSITIVITIES)


class Recogniser(Protocol):
    """Gives every frame of a sound a phoneme, and can say why.

    Blocks come in the order of the sound, cut anywhere, so a recogniser may remember; after a seek a new one is made,
    which hears a second of the sound unseen. `explain` and `deficits` look only at the block that they are given.
    """

    look_ahead: int
    """Frames after a frame that it waits for; so many frames the answers are behind."""

    scores: tuple[str, ...]
    """Names of what it measures itself, such as how likely each phoneme is; they become columns of the features."""

    @property
    def used_thresholds(self) -> frozenset[str]:
        """The fields of `Thresholds` that it compares with."""
        ...

    def recognise(self, features: Features) -> Recognition:
        """Recognise the next frames: what is given belongs to the frames `look_ahead` before those that came.

        The first `look_ahead` frames of a sound give nothing; as many frames of silence after its end give the last.
        """
        ...

    def deficits(self, features: Features) -> Float32Array | None:
        """Return by how much each phoneme falls short of being named, shape (n_frames, n_phonemes), or None."""
        ...

    def explain(self, features: Features, k: int) -> Trace:
        """Return why frame `k` of a block is recognised as it is."""
        ...


RECOGNISERS: dict[str, Callable[[RecogniserConfig], Recogniser]] = {
    "thesis": lambda tuning: ThesisRules(tuning.thresholds),
    "learned": lambda tuning: LearnedRecogniser(_model_of(tuning), tuning.look_ahead, tuning.sensitivities),
    "rules": lambda tuning: RuleRecogniser(tuning.rules, tuning.thresholds),
    "templates": lambda tuning: TemplateRecogniser(_templates_of(tuning), tuning.sensitivities),
}
"""The recognisers that come with the program; no other package can take their names."""
NEED_WAVEFORM = frozenset({"learned", "templates"})
"""Those that listen to the windows themselves, and need no variables."""


def takes_own_variables(name: str) -> bool:
    """Return whether a user's own variables can act on what a recogniser says.

    The rules of a preset may name them, and recognisers of other packages see them; the other ones of the program
    measure what they need themselves.
    """
    return name == "rules" or name not in RECOGNISERS


def _model_of(tuning: RecogniserConfig) -> Model:
    if tuning.model is None:
        raise PresetError(
            "the recogniser 'learned' needs a model, and this preset names none; begin with the preset learned.toml"
        )
    return tuning.model


def _templates_of(tuning: RecogniserConfig) -> Templates:
    if tuning.templates is None:
        raise PresetError(
            "the recogniser 'templates' needs templates, and this preset has none; begin with the preset "
            "templates.toml"
        )
    return tuning.templates


def recogniser_names() -> tuple[str, ...]:
    """Return the names of all recognisers, the program's own first; those of other packages are not imported."""
    return (*RECOGNISERS, *(name for name in plug_ins() if name not in RECOGNISERS))


def check_recogniser(name: str) -> None:
    """Refuse a name that is not exactly one recogniser's; nothing is imported.

    Raises
    ------
    PresetError : there is none of that name.
    RecogniserError : several packages offer one of that name.
    """
    if name in RECOGNISERS:
        return
    entries = plug_ins().get(name, ())
    if not entries:
        raise PresetError(
            f"there is no recogniser named {name!r}; known are {', '.join(recogniser_names())}; install the package "
            "that brings it, or choose another preset"
        )
    if len(entries) > 1:
        packages = " and ".join(package_of(entry) for entry in entries)
        raise RecogniserError(f"the recogniser {name!r} is offered twice, by {packages}; uninstall one of them")


def recogniser_of(name: str, tuning: RecogniserConfig) -> Recogniser:
    """Return the recogniser that a preset names; one of another package is made when it is first asked.

    Raises
    ------
    PresetError : there is none of that name.
    RecogniserError : several packages offer it, or it cannot be imported.
    """
    check_recogniser(name)
    if name in RECOGNISERS:
        return RECOGNISERS[name](tuning)
    (entry,) = plug_ins()[name]
    return PlugIn(entry, tuning.thresholds)
