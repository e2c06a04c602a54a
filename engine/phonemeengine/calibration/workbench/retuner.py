"""Measured frames that are recognised anew, with other thresholds, rules, sensitivities or another calm, at once."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from phonemeengine.analyser import analyse_file
from phonemeengine.arrays import BoolArray, Float32Array, IndexArray, UInt8Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.workbench.batch_smoother import BatchSmoother
from phonemeengine.calibration.workbench.rule_cache import RuleCache
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.features.variables import BUILT_IN_NAMES
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.ears import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.phoneme_data import Thresholds
from phonemeengine.recognition.rules import RuleRecogniser
from phonemeengine.recognition.scores import Sensitivity, scores_in
from phonemeengine.recognition.spec import Tuning, spec_of
from phonemeengine.settings import FRAME_PERIOD, AnalysisSettings, Ear

# Labelled recordings as measured variables: what thresholds, rules and the statistics need, without the sound.

AFTER_MEASURING = (
    "statistics", "minimum_hold", "hysteresis", "look_ahead", "intensity_low", "intensity_high",
)  # fmt: skip
"""The settings that change nothing that is measured."""

_PLAIN = AnalysisSettings()


@dataclass(frozen=True, eq=False)
class Measurement:
    """What was measured on one sound.

    Attributes
    ----------
    values : float32, shape (n_variables, n_frames): the variables, those of the preset after the built-in ones.
    n_in_sound : frames that lie in the sound; what comes after them counts as silence.
    recognised : uint8, shape (n_frames,): what the recogniser said, before the statistics.
    scores : float32, shape (n_phonemes, n_frames): the probabilities before the sensitivities, or None.
    """

    values: Float32Array
    n_in_sound: int
    recognised: UInt8Array
    scores: Float32Array | None

    @property
    def n_frames(self) -> int:
        """How many frames were measured."""
        return len(self.recognised)


def names_of(preset: Preset) -> tuple[str, ...]:
    """Return the measured variables, in the order of `Measurement.values`."""
    return (*BUILT_IN_NAMES, *(v.name for v in preset.variables))


def front_end_key(preset: Preset) -> object:
    """Return all on which the variables depend: where it is equal, nothing need be measured anew."""
    kept = {name: getattr(_PLAIN, name) for name in AFTER_MEASURING}
    return replace(preset.settings, **kept), preset.variables


def recogniser_key(preset: Preset) -> object:
    """Return all on which the answers of a recogniser without rules depend, but for the sensitivities."""
    config = replace(preset.config, rules=(), sensitivities={})
    if Tuning.THRESHOLDS not in spec_of(preset.recogniser).tuned_by:
        config = replace(config, thresholds=Thresholds())
    return preset.recogniser, config


def rules_in(preset: Preset) -> RuleRecogniser | None:
    """Return the preset's recogniser if it works by rules."""
    rules_of = spec_of(preset.recogniser).rules
    return None if rules_of is None else RuleRecogniser(rules_of(preset.config), preset.thresholds)


def measure(path: Path, preset: Preset, n_frames: int, progress: Progress = no_progress) -> Measurement:
    """Analyse a sound file as it is analysed everywhere, and keep what was measured in its first frames.

    Parameters
    ----------
    path : the sound file.
    preset : what it is analysed with.
    n_frames : how many frames are wanted; those beyond the sound measure 0.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    AudioError : the sound cannot be read.
    EngineError : the recogniser cannot be used.
    Cancelled : `progress` did not want to go on.
    """
    n_names = len(names_of(preset))
    values = np.zeros((n_names, n_frames), np.float32)
    recognised = np.zeros(n_frames, np.uint8)
    scores = None
    preset = for_files(preset, Ear.LIVE)  # what is tuned is what hears live
    preset = replace(preset, settings=replace(preset.settings, statistics=False), sensitivities={})
    has_scores = Tuning.SENSITIVITIES in spec_of(preset.recogniser).tuned_by
    with SoundReader(path) as reader:
        for analysis in analyse_file(reader, preset):
            report_progress(progress, min(1.0, (analysis.start + len(analysis)) / max(1, n_frames)))
            span = slice(analysis.start, min(analysis.start + len(analysis), n_frames))
            wanted = analysis.part(slice(max(0, span.stop - span.start)))
            if not len(wanted):
                continue
            values[:, span] = wanted.features.values[:, :n_names].T
            recognised[span] = wanted.recognised
            if has_scores and (found := scores_in(wanted.features)) is not None:
                scores = _silent_scores(n_frames) if scores is None else scores
                scores[:, span] = found.T
        n_in_sound = math.ceil(reader.duration / FRAME_PERIOD - 0.5)  # frames whose middle lies in the sound
    return Measurement(values, min(n_in_sound, n_frames), recognised, scores)


def _silent_scores(n_frames: int) -> Float32Array:
    """Return what is likely where there is no sound: silence, as surely as can be."""
    scores = np.zeros((len(Phoneme), n_frames), np.float32)
    scores[Phoneme.SILENCE] = 1
    return scores


class Retuner:
    """Says what the analyser would say of frames that it has measured, in milliseconds an hour.

    Parameters
    ----------
    values : what was measured, by variable, float32, shape (n_frames,).
    codes : what was recognised, before the statistics, uint8, shape (n_frames,).
    scores : probabilities of the phonemes before sensitivities, float32, shape (n_phonemes, n_frames), or None.
    edges : the first frame of each sound, and the number of all frames.
    """

    def __init__(
        self, values: Mapping[str, Float32Array], codes: UInt8Array, scores: Float32Array | None, edges: IndexArray
    ) -> None:
        self._values, self._codes, self._scores = values, codes, scores
        self._smoother = BatchSmoother(edges)
        self._rule_cache = RuleCache(values, int(edges[-1]))

    def scores(self, preset: Preset) -> Float32Array | None:
        """Return the probabilities with the sensitivities of a preset, shape (n_phonemes, n_frames), or None."""
        return None if self._scores is None else Sensitivity(preset.sensitivities).apply(self._scores.T).T

    def recognise(self, preset: Preset) -> tuple[UInt8Array, UInt8Array]:
        """Return what is recognised with a preset of the same front end, before and after the statistics."""
        rules, settings = rules_in(preset), preset.settings
        scores = None if rules is not None else self.scores(preset)
        recognised = codes = self._recognised(rules, scores)
        if settings.statistics:
            stays = self._may_stay(rules, scores, settings.hysteresis) if settings.hysteresis > 0 else None
            codes = codes if stays is None else self._smoother.hysteresis(codes, stays)
            codes = self._smoother.minimum_hold(
                self._smoother.fill_unidentified(codes, preset.successors), settings.minimum_hold
            )
        return recognised, codes

    def _recognised(self, rules: RuleRecogniser | None, scores: Float32Array | None) -> UInt8Array:
        if rules is not None:
            return self._rule_cache.recognised(rules)
        return self._codes if scores is None else scores.argmax(axis=0).astype(np.uint8)

    def _may_stay(
        self, rules: RuleRecogniser | None, scores: Float32Array | None, hysteresis: float
    ) -> BoolArray | None:
        if rules is not None:
            return self._rule_cache.may_stay(rules, hysteresis)
        return None if scores is None else np.asarray(scores.max(axis=0) - scores <= hysteresis)
