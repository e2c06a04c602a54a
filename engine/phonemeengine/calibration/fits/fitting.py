"""Fit a preset to the recordings at hand, and say what that gains: before, after, and on what was left out.

The thesis rules get new thresholds and successors by `ThresholdSearch`, from several random starts; from there, or
from what was there before, their limits move on by `LimitSearch`, as do those of a preset's own rules. The front end
and the variables stay. How the fit does on voices that it has not heard is told by leaving each speaker out in turn;
where there is one speaker only, takes are left out instead. The preset that was there before is kept where the fit is
not better on its own recordings. What that one had been fitted to is not left out: where it knows these speakers
already, such as a factory preset on the recordings that it was made from, the figures flatter.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from phonemeengine.arrays import BoolArray, UInt8Array
from phonemeengine.calibration.fits.cross_validation import cross_validate, groups_of
from phonemeengine.calibration.fits.limit_search import LimitSearch
from phonemeengine.calibration.fits.threshold_search import ThresholdSearch
from phonemeengine.calibration.scores.confusion import Confusion, confusion_between
from phonemeengine.calibration.scores.scoring import Scores
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.errors import CorpusError
from phonemeengine.features.measure import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.progress import Progress, no_progress, report_progress, subrange
from phonemeengine.recognition.rules import RULES, Condition, Rule

MOST_FOLDS = 8
"""Speakers, or takes, are left out in at most so many groups; up to so many speakers each one by itself."""
N_STARTS = 16
"""Random starts of the search for all recordings."""
N_FOLD_STARTS = 8
"""Random starts where something is left out."""
FITTED = ("thesis", "rules")
"""The recognisers that have something to fit."""


@dataclass(frozen=True)
class FitReport:
    """What a fit found, to be accepted or refused.

    Attributes
    ----------
    preset : the preset with what was found; the one before, where nothing better was found.
    before, after : the figures of the preset before and of this one, on all recordings.
    held_out : the figures where each recording is recognised with what was fitted without its speaker (or without
        it); None where there is a single recording.
    left_out : what was left out, in words: "speaker", "take", or nothing.
    """

    preset: Preset
    before: Scores
    after: Scores
    held_out: Scores | None
    left_out: str

    @property
    def gains(self) -> bool:
        """Whether anything better was found."""
        return self.after.macro_f1 > self.before.macro_f1


def fit_preset(
    workbench: LabelledFeatures,
    preset: Preset,
    progress: Progress = no_progress,
    *,
    seed: int = 1,
    leave_out: bool = True,
) -> FitReport:
    """Search for better thresholds, or for better limits of the preset's own rules.

    Another thread may go on asking the workbench meanwhile.

    Parameters
    ----------
    workbench : the recordings, measured with the preset's front end.
    preset : what to begin with.
    progress : told how far it is.
    seed : of every random choice.
    leave_out : whether to fit anew without each speaker, or take, which takes most of the time.

    Raises
    ------
    CorpusError : the preset has no thresholds to fit, the recordings hold nothing to fit to, or they must be measured
        anew.
    Cancelled : `progress` did not want to go on.
    """
    workbench = workbench.clone_for_thread()
    fitter = _Fitter(workbench, preset, seed)
    everything = np.ones(len(workbench.utterances), bool)
    left_out, names = _left_out(workbench)
    groups = groups_of(names, MOST_FOLDS) if left_out and leave_out else []
    first = 1 / (1 + len(groups) * N_FOLD_STARTS / N_STARTS)
    fitted = fitter.fit(everything, N_STARTS, subrange(progress, 0.0, first))
    unseen = fitter.unseen(names, groups, subrange(progress, first, 1.0)) if groups else None
    report_progress(progress, 1.0)
    return FitReport(
        preset=fitted,
        before=workbench.confusion(preset).scores(),
        after=workbench.confusion(fitted).scores(),
        held_out=unseen.scores() if unseen is not None else None,
        left_out=left_out,
    )


class _Fitter:
    """Fits one preset to some of the recordings."""

    def __init__(self, workbench: LabelledFeatures, preset: Preset, seed: int) -> None:
        if preset.recogniser not in FITTED:
            raise CorpusError(
                f"the recogniser {preset.recogniser!r} has no thresholds to fit; choose a preset with thesis rules "
                "or rules of its own"
            )
        if not np.any(workbench.labels.phonemes != Phoneme.UNIDENTIFIED):
            raise CorpusError("there is nothing to fit to; load recordings with labelled phonemes")
        self._workbench = workbench
        self._preset = preset
        self._seed = seed

    def fit(self, chosen: BoolArray, n_starts: int, progress: Progress) -> Preset:
        """Fit to the chosen recordings; gives the preset as it was where nothing better was found."""
        features, truth, first = self._frames_of(chosen)
        recordings = tuple(np.flatnonzero(chosen).tolist())
        best = self._preset
        if best.recogniser == "thesis":
            search = ThresholdSearch(features, truth, first)
            fit = search.best_of(n_starts, np.random.default_rng(self._seed), subrange(progress, 0.0, 0.5))
            found = replace(best, thresholds=fit.thresholds, successors=fit.successors)
            best = self._better(found, best, recordings)
        limits = LimitSearch(features, truth, first, best.thresholds, best.successors)
        rules = _with_numbers(best) if best.recogniser == "thesis" else best.rules
        moved = limits.improve(rules, subrange(progress, 0.5 if best.recogniser == "thesis" else 0.0, 1.0))
        return self._better(_with_rules(best, moved), best, recordings)

    def _better(self, found: Preset, before: Preset, recordings: tuple[int, ...]) -> Preset:
        """Return what was found, if it answers better in these recordings."""
        new, old = (self._workbench.confusion(p).scores(recordings).macro_f1 for p in (found, before))
        return found if new > old else before

    def unseen(self, names: Sequence[str], groups: Sequence[Sequence[str]], progress: Progress) -> Confusion:
        """Recognise each recording with what was fitted without its group."""
        shares = iter(subrange(progress, k / len(groups), (k + 1) / len(groups)) for k in range(len(groups)))
        fits = cross_validate(names, groups, lambda chosen: self._answers_fitted_to(chosen, next(shares)))
        edges = self._workbench.edges
        lines = [fit[first:end] for fit, first, end in zip(fits, edges[:-1], edges[1:], strict=True)]
        return confusion_between(self._workbench.labels, np.concatenate(lines), edges)

    def _answers_fitted_to(self, chosen: BoolArray, progress: Progress) -> UInt8Array:
        return self._workbench.answers(self.fit(chosen, N_FOLD_STARTS, progress))

    def _frames_of(self, chosen: BoolArray) -> tuple[Features, UInt8Array, BoolArray]:
        """Return the features, the labels, and where recordings begin, of the chosen recordings."""
        edges = self._workbench.edges
        first = np.zeros(edges[-1] + 1, bool)
        first[edges[:-1]] = True
        mask = np.repeat(chosen, np.diff(edges))
        features = self._workbench.features()
        return (
            Features(features.names, features.values[mask]),
            self._workbench.labels.phonemes[mask],
            first[:-1][mask],
        )


def _left_out(workbench: LabelledFeatures) -> tuple[str, list[str]]:
    """Return what is left out in turn, and to what of that kind each recording belongs."""
    speakers = [u.speaker for u in workbench.utterances]
    if len(set(speakers)) > 1:
        return "speaker", speakers
    takes = [str(k) for k in range(len(speakers))]
    return ("take" if len(takes) > 1 else ""), takes


def _with_numbers(preset: Preset) -> tuple[Rule, ...]:
    """Write the thesis rules with a preset's thresholds as numbers."""
    return tuple(
        Rule(
            rule.phoneme,
            tuple(
                Condition(c.variable, c.sign, limit=getattr(preset.thresholds, c.threshold)) for c in rule.conditions
            ),
        )
        for rule in RULES
    )


def _with_rules(preset: Preset, rules: tuple[Rule, ...]) -> Preset:
    """Return the preset with these rules: its own, or the thesis rules with other numbers for thresholds."""
    if preset.recogniser != "thesis":
        return replace(preset, rules=rules)
    numbers = {
        named.threshold: c.limit
        for rule, moved in zip(RULES, rules, strict=True)
        for named, c in zip(rule.conditions, moved.conditions, strict=True)
    }
    return replace(preset, thresholds=replace(preset.thresholds, **numbers))
