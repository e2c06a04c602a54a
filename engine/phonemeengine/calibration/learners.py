"""How each recogniser learns a voice: the one place that knows it.

Each gives several presets, the boldest first: what learned most, and milder ones for the case that it costs too much.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from phonemeengine.calibration.adaptation import adapt
from phonemeengine.calibration.fits.fitting import fit_preset
from phonemeengine.calibration.fits.templates import templates_of
from phonemeengine.calibration.learning.training_examples import TrainingExample, example_of_recording
from phonemeengine.calibration.scores.corpus import Utterance
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.errors import CorpusError, PresetError
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.progress import Progress, report_progress, subrange
from phonemeengine.recognition.scores import MOST_LOG_ODDS
from phonemeengine.recognition.templates import Templates, rounded_templates

GIVEN_TO_SILENCE = 0.5
"""By how much silence becomes likelier in the second of each pair of adapted presets, nats."""

Takes = Sequence[Utterance]
Quiet = Callable[[Preset], Preset]
"""Gives a preset that takes the room for silence; where no room is known, the same preset."""
Learner = Callable[[Preset, Takes, Quiet, Progress], tuple[Preset, ...]]


def learner_of(preset: Preset) -> Learner:
    """Return how a preset's recogniser learns voices.

    Raises
    ------
    CorpusError : it does not.
    PresetError : it has nothing to begin with.
    """
    if preset.recogniser not in LEARNERS:
        raise CorpusError(
            f"the recogniser {preset.recogniser!r} does not learn voices; choose one of {', '.join(LEARNERS)}"
        )
    if preset.recogniser == "learned" and preset.model is None:
        raise PresetError("this preset has no learned model to adapt; choose the preset learned.toml")
    return LEARNERS[preset.recogniser]


def _thresholds(preset: Preset, takes: Takes, quiet: Quiet, progress: Progress) -> tuple[Preset, ...]:
    """Search for thresholds, or for limits of the preset's rules; the milder one leaves silence to the room."""
    start = quiet(preset)
    bench = LabelledFeatures(takes, start, progress=subrange(progress, 0.0, 0.2))
    fitted = fit_preset(bench, start, subrange(progress, 0.2, 1.0), leave_out=False).preset
    silence = {name: value for name, value in vars(start.thresholds).items() if name.startswith("silence")}
    rules = tuple(
        old if old.phoneme is Phoneme.SILENCE else new for old, new in zip(start.rules, fitted.rules, strict=True)
    )
    milder = replace(fitted, thresholds=replace(fitted.thresholds, **silence), rules=rules)
    return fitted, milder, start


def _model(preset: Preset, takes: Takes, quiet: Quiet, progress: Progress) -> tuple[Preset, ...]:
    """Adapt the model to the voice, further or less far, each with silence as it is and a little likelier; or not."""
    assert preset.model is not None
    lessons: list[TrainingExample] = []
    for k, utterance in enumerate(takes):
        report_progress(progress, 0.5 * k / len(takes))
        lessons.append(example_of_recording(utterance))
    report_progress(progress, 0.5)
    presets = [quiet(replace(preset, model=model)) for model in adapt(preset.model, lessons)]
    return (*(found for adapted in presets for found in (adapted, _with_more_silence(adapted))), quiet(preset))


def _with_more_silence(preset: Preset) -> Preset:
    """Return back to silence what it loses where all phonemes count alike in learning."""
    now = preset.sensitivities.get(Phoneme.SILENCE, 0.0)
    given = min(now + GIVEN_TO_SILENCE, MOST_LOG_ODDS)
    return replace(preset, sensitivities={**preset.sensitivities, Phoneme.SILENCE: given})


def _templates(preset: Preset, takes: Takes, quiet: Quiet, progress: Progress) -> tuple[Preset, ...]:
    """Let the takes be the templates of their sounds: quite, half, or not at all; only the room sets the silence."""
    report_progress(progress, 0.0)
    start = quiet(preset)
    found = templates_of(takes, start.templates)
    old = start.templates or found
    found = replace(found, silence_below=old.silence_below)
    return replace(start, templates=found), replace(start, templates=_between(old, found)), start


def _between(old: Templates, new: Templates) -> Templates:
    rows = {p: (old.means.get(p, row), row) for p, row in new.means.items()}
    means = {p: np.array(pair, np.float32).mean(axis=0) for p, pair in rows.items()}
    return rounded_templates(means, np.array(new.spread, np.float32), new.silence_below)


LEARNERS: dict[str, Learner] = {
    "thesis": _thresholds,
    "rules": _thresholds,
    "learned": _model,
    "templates": _templates,
}
