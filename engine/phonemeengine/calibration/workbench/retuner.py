"""Measured frames that are recognised anew, with other thresholds, rules, sensitivities or another calm, at once."""

from collections.abc import Mapping

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, IndexArray, UInt8Array
from phonemeengine.calibration.workbench.batch_smoother import BatchSmoother
from phonemeengine.calibration.workbench.measuring import rules_in
from phonemeengine.calibration.workbench.rule_cache import RuleCache
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import RuleRecogniser
from phonemeengine.recognition.scores import Sensitivity


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
