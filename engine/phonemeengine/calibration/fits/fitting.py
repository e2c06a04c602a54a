"""Fit a preset to the recordings at hand, and say what that gains: before, after, and on what was left out.

The thesis rules get new thresholds and successors by `ThresholdSearch`, from several random starts; from there, or
from what was there before, their limits move on by `LimitSearch`, as do those of a preset's own rules. The front end
and the variables stay. How well the fit does on unknown voices is measured by leaving each speaker out in turn;
where there is one speaker only, takes are left out instead. The preset that was there before is kept where the fit is
not better on its own recordings. What that one had been fitted to is not left out: where it knows these speakers
already, such as a factory preset on the recordings that it was made from, the figures flatter.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from phonemeengine.analyser import analyse_file
from phonemeengine.arrays import BoolArray, UInt8Array
from phonemeengine.calibration.fits.limit_search import LimitSearch
from phonemeengine.calibration.fits.threshold_search import ThresholdSearch
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.scoring import Confusion, Scores, confusion_between
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.dsp.pitch import HIGHEST, LOWEST
from phonemeengine.errors import CorpusError, RecogniserError
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.features.variables import PITCH, Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.controls import with_number
from phonemeengine.presets.preset import Preset, with_own_rules
from phonemeengine.recognition.rules import FILTER_FIELDS, RULES, Condition, PitchSet, Rule
from phonemeengine.recognition.spec import spec_of

# Leaving some recordings out of a fit, so that they tell how it does on what it has not seen.

Fitted = TypeVar("Fitted")


def groups_of(names: Sequence[str], most: int) -> list[list[str]]:
    """Put equal names into one group, and all of them into this many groups at most."""
    different = list(dict.fromkeys(names))
    n = min(most, len(different))
    return [different[k::n] for k in range(n)]


def cross_validate(
    names: Sequence[str], groups: Sequence[Sequence[str]], fit: Callable[[BoolArray], Fitted]
) -> list[Fitted]:
    """Fit without each group in turn; gives for each recording the fit that has not seen its group.

    Parameters
    ----------
    names : of whom each recording is.
    groups : the names that are left out together; each name stands in one.
    fit : fits to the chosen recordings. Where a group is all there is, it is fitted to itself.
    """
    of_name: dict[str, Fitted] = {}
    for group in groups:
        rest = ~np.isin(names, group)
        of_name.update(dict.fromkeys(group, fit(rest if rest.any() else ~rest)))
    return [of_name[name] for name in names]


MOST_FOLDS = 8
"""Speakers, or takes, are left out in this many groups at most; fewer speakers each form a group of their own."""
N_STARTS = 16
"""Random starts of the search for all recordings."""
N_FOLD_STARTS = 8
"""Random starts where something is left out."""


@dataclass(frozen=True)
class FitReport:
    """What a fit found, to be accepted or refused.

    Attributes
    ----------
    preset : the preset with what was found; the one before, where nothing better was found.
    before, after : the figures of the preset before and of this one, on all recordings.
    held_out : the figures where each recording is recognised with what was fitted without its speaker (or without
        it); None where there is a single recording.
    left_out : what was left out, in words: "speaker", "take", "part", or nothing.
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
    labelled: LabelledFeatures,
    preset: Preset,
    progress: Progress = no_progress,
    *,
    seed: int = 1,
    leave_out: bool = True,
    keep_successors: bool = False,
) -> FitReport:
    """Search for better thresholds, or for better limits of the preset's own rules.

    Another thread may go on asking it meanwhile.

    Parameters
    ----------
    labelled : the recordings, measured with the preset's front end.
    preset : what to begin with.
    progress : called with the share that is done, 0..1.
    seed : of every random choice.
    leave_out : whether to fit anew without each speaker, or take, which takes most of the time.
    keep_successors : whether the table of successors stays, so that the numbers of PhonemeData alone are fitted.

    Raises
    ------
    CorpusError : the preset has no thresholds to fit, the recordings hold nothing to fit to, or they must be measured
        anew.
    Cancelled : `progress` did not want to go on.
    """
    labelled = labelled.clone_for_thread()
    fitter = _Fitter(labelled, preset, seed, keep_successors=keep_successors)
    known = set(np.unique(labelled.labels.phonemes).tolist()) - {Phoneme.UNIDENTIFIED}
    if len(known) == 1:  # which every frame would become
        only = Phoneme(known.pop()).label
        raise CorpusError(
            f"a fit needs labels of at least two sounds, and the recordings have only {only}; load some with others"
        )
    everything = np.ones(len(labelled.utterances), bool)
    left_out, names = left_out_of(labelled)
    groups = groups_of(names, MOST_FOLDS) if left_out and leave_out else []
    first = 1 / (1 + len(groups) * N_FOLD_STARTS / N_STARTS)
    fitted = fitter.fit(everything, N_STARTS, subrange(progress, 0.0, first))
    unseen = fitter.unseen(names, groups, subrange(progress, first, 1.0)) if groups else None
    report_progress(progress, 1.0)
    return FitReport(
        preset=fitted,
        before=labelled.confusion(preset).scores(),
        after=fitter.confusion(fitted).scores(),
        held_out=unseen.scores() if unseen is not None else None,
        left_out=left_out,
    )


@dataclass(frozen=True)
class FitTask:
    """What a preset is fitted to, and how hard to look for something better.

    Attributes
    ----------
    features : what was measured in all recordings, one after the other.
    phonemes : uint8, shape (n_frames,): what is said in them.
    begins : bool, shape (n_frames,): where recordings begin.
    macro_f1_of : gives how right a preset is in these recordings.
    n_starts : random starts of a search that has some.
    seed : of every random choice.
    keep_successors : whether the table of successors stays, which a PhonemeData file cannot hold.
    """

    features: Features
    phonemes: UInt8Array
    begins: BoolArray
    macro_f1_of: Callable[[Preset], float]
    n_starts: int
    seed: int
    keep_successors: bool = False

    def better_of(self, found: Preset, before: Preset) -> Preset:
        """Return what was found, if it answers better in these recordings."""
        return found if self.macro_f1_of(found) > self.macro_f1_of(before) else before


Fit = Callable[[Preset, FitTask, Progress], Preset]
"""How a recogniser's numbers are fitted: from a preset and recordings to a preset, which need not be better."""


class _Fitter:
    """Fits one preset to some of the recordings."""

    def __init__(
        self, labelled: LabelledFeatures, preset: Preset, seed: int, *, keep_successors: bool = False
    ) -> None:
        spec = spec_of(preset.recogniser)
        if not spec.fit:
            raise CorpusError(
                f"the recogniser {preset.recogniser!r} has no thresholds to fit; choose a preset with thesis rules "
                "or rules of its own"
            )
        self._fit: Fit = spec.load(spec.fit)
        if not np.any(labelled.labels.phonemes != Phoneme.UNIDENTIFIED):
            raise CorpusError("there is nothing to fit to; load recordings with labelled phonemes")
        self._labelled = labelled
        self._preset = preset
        self._seed, self._keep_successors = seed, keep_successors

    def fit(self, chosen: BoolArray, n_starts: int, progress: Progress) -> Preset:
        """Fit to the chosen recordings; gives the preset as it was where nothing better was found."""
        task = self.task(chosen, n_starts)
        found = self._fit(self._preset, task, progress)
        if not isinstance(found, Preset):
            raise RecogniserError(
                f"the recogniser {self._preset.recogniser!r} must fit a preset, got a {type(found).__name__}; choose "
                "another recogniser"
            )
        return task.better_of(found, self._preset)

    def confusion(self, preset: Preset) -> Confusion:
        """Recognise all recordings with a preset; they are analysed anew where that measures differently."""
        labelled = self._labelled
        if labelled.needs_measuring(preset):
            labelled = LabelledFeatures(labelled.utterances, preset)
        return labelled.confusion(preset)

    def unseen(self, names: Sequence[str], groups: Sequence[Sequence[str]], progress: Progress) -> Confusion:
        """Recognise each recording with what was fitted without its group."""
        shares = iter(subrange(progress, k / len(groups), (k + 1) / len(groups)) for k in range(len(groups)))
        fits = cross_validate(names, groups, lambda chosen: self._answers_fitted_to(chosen, next(shares)))
        edges = self._labelled.edges
        lines = [fit[first:end] for fit, first, end in zip(fits, edges[:-1], edges[1:], strict=True)]
        return confusion_between(self._labelled.labels, np.concatenate(lines), edges)

    def _answers_fitted_to(self, chosen: BoolArray, progress: Progress) -> UInt8Array:
        return self.confusion(self.fit(chosen, N_FOLD_STARTS, progress)).predicted

    def task(self, chosen: BoolArray, n_starts: int) -> FitTask:
        """Return what a fit to the chosen recordings gets."""
        edges = self._labelled.edges
        begins = np.zeros(edges[-1] + 1, bool)
        begins[edges[:-1]] = True
        mask = np.repeat(chosen, np.diff(edges))
        features = self._labelled.features()
        recordings = tuple(np.flatnonzero(chosen).tolist())
        return FitTask(
            features=Features(features.names, features.values[mask]),
            phonemes=self._labelled.labels.phonemes[mask],
            begins=begins[:-1][mask],
            macro_f1_of=lambda preset: self.confusion(preset).scores(recordings).macro_f1,
            n_starts=n_starts,
            seed=self._seed,
            keep_successors=self._keep_successors,
        )


def fit_thresholds(preset: Preset, task: FitTask, progress: Progress) -> Preset:
    """Fit the thresholds of the thesis rules: search for them from random starts, then move their limits on."""
    kept = preset.successors if task.keep_successors else None
    search = ThresholdSearch(task.features, task.phonemes, task.begins, kept)
    fit = search.best_of(task.n_starts, np.random.default_rng(task.seed), subrange(progress, 0.0, 0.5))
    found = task.better_of(replace(preset, thresholds=fit.thresholds, successors=fit.successors), preset)
    rules = _limits_moved(with_own_rules(found).rules, found, task, subrange(progress, 0.5, 1.0))
    return task.better_of(_with_thresholds_of(rules, found), found)


FILTER_CANDIDATES: dict[str, tuple[float, ...]] = {
    "time_smooth": (0.0, 0.15, 0.3, 0.45, 0.6),
    "frequency_smooth": (0.0, 0.2, 0.4, 0.6, 0.8),
    "high_pass_start": (0.0, 2.0, 3.0, 4.0, 5.0, 7.0),
    "high_pass_end": (3.0, 5.0, 7.0, 10.0, 14.0),
    "denoise_threshold": (0.0, 0.0002, 0.0005, 0.001, 0.002),
}
"""What a number of a filter is fitted to, in the units of PhonemeData."""


def fit_number(
    labelled: LabelledFeatures, preset: Preset, name: str, progress: Progress = no_progress
) -> tuple[Preset, float]:
    """Return the preset with the best value of one number of PhonemeData, all others as they are, and its macro F1.

    The preset stays as it is where no other value is better. A number of a filter changes what is measured, so the
    recordings are measured anew for each of its `FILTER_CANDIDATES`.

    Parameters
    ----------
    labelled : the recordings, measured with the preset's front end.
    preset : one whose recogniser compares with the number.
    name : of the number, such as ``a_a1``.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    CorpusError : the preset has no thresholds, or the recordings hold nothing to fit to.
    Cancelled : `progress` did not want to go on.
    """
    fitter = _Fitter(labelled.clone_for_thread(), preset, seed=1)
    everything = fitter.task(np.ones(len(labelled.utterances), bool), n_starts=0)
    if name in FILTER_FIELDS:
        found = _best_filter(preset, name, everything, progress)
    else:
        rules = tuple(Rule(r.phoneme, tuple(_freed(c, name, preset) for c in r.conditions)) for r in RULES)
        moved = [c for rule in _limits_moved(rules, preset, everything, progress) for c in rule.conditions]
        limit = next(c.limit for c in moved if not c.threshold)
        found = replace(preset, thresholds=replace(preset.thresholds, **{name: limit}))
    better = everything.better_of(found, preset)
    return better, everything.macro_f1_of(better)


PITCH_REACH = 2 ** (4 / 12)
"""A set for one speaker reaches from the speaker's pitch by this factor up and down, four semitones."""


def fit_pitch_set(
    labelled: LabelledFeatures, preset: Preset, name: str, progress: Progress = no_progress
) -> PitchSet:
    """Return a set of PhonemeData for the speaker of some recordings: fitted to them, around their median pitch.

    Parameters
    ----------
    labelled : the recordings of one speaker, measured with `preset`.
    preset : the numbers to begin with; its table of successors stays.
    name : of the set.
    progress : called with the share that is done, 0..1.

    Raises
    ------
    CorpusError : the recordings hold nothing to fit to, or no voiced sound.
    Cancelled : `progress` did not want to go on.
    """
    fitted = fit_preset(labelled, preset, subrange(progress, 0.0, 0.8), leave_out=False, keep_successors=True)
    voiced = []
    for utterance in labelled.utterances:
        report_progress(progress, 0.9)
        with utterance.opened() as reader:
            for analysis in analyse_file(reader, Preset(), pitch=True):
                f0 = analysis.features[PITCH.name]
                voiced.append(f0[f0 > 0])
    pitches = np.concatenate([np.zeros(0), *voiced])
    if not len(pitches):
        raise CorpusError(f"there is no voiced sound of {name[:40]}; record vowels or a sentence")
    pitch = float(np.median(pitches))
    low, high = max(LOWEST, pitch / PITCH_REACH), min(HIGHEST, pitch * PITCH_REACH)
    return PitchSet(name, float(round(low)), float(round(high)), fitted.preset.phoneme_data)


def _freed(condition: Condition, name: str, preset: Preset) -> Condition:
    """Return a comparison with a number in place of the threshold of this name; others stay."""
    if condition.threshold != name:
        return condition
    return Condition(condition.variable, condition.sign, limit=getattr(preset.thresholds, name))


def _best_filter(preset: Preset, name: str, task: FitTask, progress: Progress) -> Preset:
    """Return the preset with the candidate for a number of the filters that answers best."""
    found, candidates = [preset], FILTER_CANDIDATES[name]
    for k, value in enumerate(candidates):
        report_progress(progress, k / len(candidates))
        found.append(with_number(preset, name, value))
    return max(found, key=task.macro_f1_of)


def fit_limits(preset: Preset, task: FitTask, progress: Progress) -> Preset:
    """Fit the limits of a preset's own rules."""
    return replace(preset, rules=_limits_moved(preset.rules, preset, task, progress))


def adapt_rules(
    preset: Preset, takes: Sequence[LabelledUtterance], set_silence: Callable[[Preset], Preset], progress: Progress
) -> tuple[Preset, ...]:
    """Fit thresholds or limits to the takes of one voice; the milder preset leaves silence to the room.

    It is an `Adapt` of `phonemeengine.calibration.calibrate`.
    """
    start = set_silence(preset)
    labelled = LabelledFeatures(takes, start, progress=subrange(progress, 0.0, 0.2))
    fitted = fit_preset(labelled, start, subrange(progress, 0.2, 1.0), leave_out=False).preset
    silence = {name: value for name, value in vars(start.thresholds).items() if name.startswith("silence")}
    rules = tuple(
        old if old.phoneme is Phoneme.SILENCE else new for old, new in zip(start.rules, fitted.rules, strict=True)
    )
    milder = replace(fitted, thresholds=replace(fitted.thresholds, **silence), rules=rules)
    return fitted, milder, start


def _limits_moved(rules: tuple[Rule, ...], preset: Preset, task: FitTask, progress: Progress) -> tuple[Rule, ...]:
    search = LimitSearch(task.features, task.phonemes, task.begins, preset.thresholds, preset.successors)
    return search.improve(rules, progress)


def left_out_of(labelled: LabelledFeatures) -> tuple[str, list[str]]:
    """Return what is left out in turn, and to what of that kind each recording belongs."""
    speakers = [u.speaker for u in labelled.utterances]
    if len(set(speakers)) > 1:
        return "speaker", speakers
    takes = [str(k) for k in range(len(speakers))]
    return ("take" if len(takes) > 1 else ""), takes


def _with_thresholds_of(rules: tuple[Rule, ...], preset: Preset) -> Preset:
    """Return the preset with the numbers of thesis rules as thresholds."""
    numbers = {
        named.threshold: c.limit
        for rule, moved in zip(RULES, rules, strict=True)
        for named, c in zip(rule.conditions, moved.conditions, strict=True)
    }
    return replace(preset, thresholds=replace(preset.thresholds, **numbers))
