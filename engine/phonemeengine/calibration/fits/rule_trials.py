"""Try changes of rules on labelled frames before they are made: which limit is best, and what that gains."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from phonemeengine.arrays import IndexArray, UInt8Array
from phonemeengine.calibration.fits.limit_search import SIGNIFICANT_DIGITS, candidate_limits, counts_by_rank
from phonemeengine.calibration.scores.scoring import (
    SCORED_PHONEMES,
    Agreement,
    agreement_of,
    confusion_of,
    macro_f1_of,
)
from phonemeengine.calibration.workbench.retuner import Retuner
from phonemeengine.features.measure import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import Condition, Rule


class RuleTrials:
    """Labelled frames, and what presets with other rules recognise in them.

    Parameters
    ----------
    features : what was measured.
    truth : codes of `Phoneme`, shape (n_frames,); frames labelled unidentified are not scored.
    edges : the first frame of each sound, and the number of all frames.
    """

    def __init__(self, features: Features, truth: UInt8Array, edges: IndexArray) -> None:
        self.features = features
        self.truth = truth
        values = dict(zip(features.names, np.ascontiguousarray(features.values.T), strict=True))
        self._retuner = Retuner(values, np.full(len(truth), Phoneme.UNIDENTIFIED, np.uint8), None, edges)

    @classmethod
    def of(cls, parts: Sequence[tuple[Features, UInt8Array, IndexArray]]) -> "RuleTrials":
        """Return trials on parts of labelled sound, as the parameters; what not all have measured is left out."""
        names = tuple(n for n in parts[0][0].names if all(n in features.names for features, _, _ in parts))
        values = np.concatenate([np.stack([f[n] for n in names], axis=1) for f, _, _ in parts])
        starts = np.cumsum([0, *(edges[-1] for _, _, edges in parts)])
        edges = np.concatenate([e[:-1] + start for (_, _, e), start in zip(parts, starts, strict=False)])
        truth = np.concatenate([truth for _, truth, _ in parts])
        return cls(Features(names, values), truth, np.append(edges, starts[-1]))

    def agreement(self, preset: Preset) -> Agreement:
        """Return how a preset with rules agrees with the labels, after the statistics."""
        return agreement_of(self.truth, self._retuner.recognise(preset)[1])

    def proposed(self, preset: Preset, rule: int, variable: str) -> Condition:
        """Return the comparison of a variable by which a rule gains most, with all its others as they are.

        What counts is the macro F1 together with the F1 of the phoneme that the rule names.

        Where the rule decides no labelled frame, the limit is the middle one of all values.

        Parameters
        ----------
        preset : with the rule, which may be a new one that asks nothing yet.
        rule : the rule's number, from 0.
        variable : what it is to ask.
        """
        values, known = self.features[variable], self.truth != Phoneme.UNIDENTIFIED
        holds, fails = self._answers(preset), self._answers(with_rule_off(preset, rule))
        open_ = known & (holds != fails)
        candidates = candidate_limits(values[open_]) if open_.any() else np.zeros(0, np.float32)
        if not len(candidates):
            middle = float(np.median(values)) if len(values) else 0.0
            return Condition(variable, ">", limit=float(f"{middle:.{SIGNIFICANT_DIGITS}g}"))
        settled = confusion_of(self.truth[known & ~open_], holds[known & ~open_])
        ranks, truth = np.searchsorted(candidates, values[open_], side="right"), self.truth[open_]
        kept, lost = (
            counts_by_rank(ranks, truth, codes[open_], len(candidates) + 1).cumsum(axis=0) for codes in (holds, fails)
        )
        counts = [settled + below[:-1] + above[-1] - above[:-1] for below, above in ((kept, lost), (lost, kept))]
        own = (preset.rules[rule].phoneme,)
        scores = [macro_f1_of(c, SCORED_PHONEMES) + np.nan_to_num(macro_f1_of(c, own)) for c in counts]
        sign, best = divmod(int(np.argmax(scores)), len(candidates))
        return Condition(variable, "<>"[sign], limit=float(str(candidates[best])))

    def _answers(self, preset: Preset) -> UInt8Array:
        return self._retuner.recognise(preset)[0]


def with_rule(preset: Preset, at: int, rule: Rule) -> Preset:
    """Return the preset with another rule in front of rule `at`."""
    return replace(preset, rules=(*preset.rules[:at], rule, *preset.rules[at:]))


def with_rule_off(preset: Preset, rule: int) -> Preset:
    """Return the preset with one of its rules switched off."""
    rules = tuple(replace(r, enabled=r.enabled and k != rule) for k, r in enumerate(preset.rules))
    return replace(preset, rules=rules)
