"""Find few rules in labelled sound, that one can read and go on editing, and say how they do on held-out recordings.

The rules are a tree, written as a decision list, over the variables that a preset measures, or over bands of the
spectrum and bands divided by one another (`with_bands`). They are grown from all recordings. How well that does on
unknown voices is measured by growing them anew without each speaker in turn; where there is one speaker only, without
each take, and where there is one recording only, without each quarter of it.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from phonemeengine.arrays import Float64Array, IndexArray
from phonemeengine.calibration.fits.fitting import MOST_FOLDS, FitReport, left_out_of
from phonemeengine.calibration.fits.rule_search import RuleSearch
from phonemeengine.calibration.scores.corpus import FrameLabels, LabelledUtterance
from phonemeengine.calibration.scores.scoring import Scores, confusion_between
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.dsp.mel import frequency_of, mel_of
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.features.variables import BAND_VARIABLES, PITCH, Variable
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import Rule
from phonemeengine.recognition.spec import OWN_RULES, THESIS
from phonemeengine.settings import AnalysisSettings, Filter, WindowFunction

# What rules may ask for: bands of the spectrum.

N_BANDS = 24
LOWEST, HIGHEST = 60.0, 8000.0
"""Above, many recordings hold nothing; below, there is hum."""
WIDTHS = (1, 2, 4, 8)
"""How many bands of the mel scale a variable reaches over."""
DIVIDED = {"r": 2, "w": 4}
"""Widths of the variables that are divided by one another, by the letter with which their names begin."""

FRONT_END = AnalysisSettings(
    filters=frozenset({Filter.WINDOW_FUNCTION, Filter.HIGH_PASS, Filter.LOW_PASS, Filter.NORMALISE}),
    window_function=WindowFunction.HAMMING,
    high_pass_start=LOWEST,
    high_pass_end=LOWEST,
    low_pass_start=HIGHEST,
    low_pass_end=HIGHEST,
)
UNASKED = frozenset({PITCH.name, *(v.name for v in BAND_VARIABLES)} - {"energy_n"})
"""What no rule asks for where there are bands: the pitch costs more than all else, and the others are among them."""


def candidates() -> tuple[Variable, ...]:
    """Return the variables to choose from: bands of several widths, and bands divided by one another."""
    marks = np.linspace(mel_of(LOWEST), mel_of(HIGHEST), N_BANDS + 1)
    edges = [10.0 * round(float(frequency_of(mark)) / 10) for mark in marks]
    bands = {
        (first, width): Variable(
            f"b{edges[first]:.0f}_{edges[first + width]:.0f}", edges[first], edges[first + width]
        )
        for width in WIDTHS
        for first in range(0, N_BANDS + 1 - width, max(1, width // 2))
    }
    divided = [
        Variable(f"{letter}{low.low:.0f}_{high.low:.0f}", low.low, low.high, per=high.name)
        for letter, width in DIVIDED.items()
        for low, high in combinations([bands[k, width] for k in range(0, N_BANDS + 1 - width, 2)], 2)
    ]
    return (*bands.values(), *divided)


def with_bands(preset: Preset) -> Preset:
    """Return a preset that measures all bands beside a preset's own variables, with the front end of extended rules.

    It has the rules of the thesis, which take no time, until others are found.
    """
    own = {v.name for v in preset.variables}
    variables = (*preset.variables, *(v for v in candidates() if v.name not in own))
    keeps = {name: getattr(preset.settings, name) for name in ("intensity_low", "intensity_high")}
    return replace(preset, recogniser=THESIS.name, settings=replace(FRONT_END, **keeps), variables=variables)


# The search, and what it is judged by.

MOST_CONDITIONS_IN_ALL = 40
"""More are no longer read."""
LEAST_SHARE = 0.003
"""The least share of the frames' weight that a rule may be made for: rules for less say more of these voices."""
BESIDE_BOUNDARY = 0.3
"""How much a frame counts beside one with another label, whose place is seldom sure."""
HYSTERESES = tuple(k / 20 for k in range(11))
MOST_CHANGES = 1.6
"""The least hysteresis is chosen by which the phonemes change at most this many times as often as the labels."""
N_PARTS = 4
"""Into how many parts a single recording is cut."""


def rules_from(
    utterances: Sequence[LabelledUtterance],
    preset: Preset,
    progress: Progress = no_progress,
    *,
    known: LabelledFeatures | None = None,
    bands: bool = True,
    most_conditions: int = MOST_CONDITIONS_IN_ALL,
) -> FitReport:
    """Measure labelled recordings, and find rules for them; the other numbers of the preset stay.

    Parameters
    ----------
    utterances : the labelled recordings.
    preset : what the rules are for, and are compared with.
    progress : called with the share that is done, 0..1.
    known : recordings that were measured already.
    bands : whether rules may ask for bands of the spectrum (`with_bands`); else for what the preset measures.
    most_conditions : how many conditions the rules may have in all.

    Raises
    ------
    AudioError : a sound cannot be read.
    CorpusError : fewer than two sounds are labelled.
    Cancelled : `progress` did not want to go on.
    """
    own = LabelledFeatures(utterances, preset, known=known, progress=subrange(progress, 0.0, 0.2))
    before = own.confusion(preset).scores()
    if not bands:
        return find_rules(own, preset, before, subrange(progress, 0.2, 1.0), most_conditions)
    wide = with_bands(preset)
    labelled = LabelledFeatures(utterances, wide, known=known, progress=subrange(progress, 0.2, 0.7))
    return find_rules(labelled, wide, before, subrange(progress, 0.7, 1.0), most_conditions)


def find_rules(
    labelled: LabelledFeatures,
    preset: Preset,
    before: Scores,
    progress: Progress = no_progress,
    most_conditions: int = MOST_CONDITIONS_IN_ALL,
) -> FitReport:
    """Grow rules from measured recordings, and judge them by held-out recordings.

    Parameters
    ----------
    labelled : the recordings, measured with the front end and the variables of `preset`.
    preset : what the rules are for; one of `with_bands` loses the bands that no rule asks for.
    before : the figures of the preset before.
    progress : called with the share that is done, 0..1.
    most_conditions : how many conditions the rules may have in all.

    Raises
    ------
    CorpusError : fewer than two sounds are labelled, or the recordings must be measured anew.
    Cancelled : `progress` did not want to go on.
    """
    labelled = labelled.clone_for_thread()
    search = _search_in(labelled, preset)
    report_progress(progress, 0.1)
    found = _settled(labelled, _with_rules(preset, search.list_within(most_conditions)))
    report_progress(progress, 0.2)
    kind, parts = _parts_of(labelled)
    predicted = np.zeros(len(parts), np.uint8)
    for part in range(n_parts := int(parts.max()) + 1 if kind else 0):
        rules = search.part(parts != part).list_within(most_conditions)
        held_out = parts == part
        predicted[held_out] = labelled.predict(replace(found, rules=rules))[held_out]
        report_progress(progress, 0.2 + 0.8 * (part + 1) / n_parts)
    unseen = confusion_between(labelled.labels, predicted, labelled.edges).scores() if kind else None
    return FitReport(_without_unused(found), before, labelled.confusion(found).scores(), unseen, kind)


def frame_weights(labels: FrameLabels) -> Float64Array:
    """Return how much each frame counts, shape (n_frames,): less beside a boundary, whose place is seldom sure."""
    changes = np.flatnonzero(np.diff(labels.phonemes))
    weights = np.ones(len(labels.phonemes))
    weights[changes] = weights[changes + 1] = BESIDE_BOUNDARY
    return weights


def _search_in(labelled: LabelledFeatures, preset: Preset) -> RuleSearch:
    known = set(np.unique(labelled.labels.phonemes).tolist()) - {Phoneme.UNIDENTIFIED}
    if len(known) < 2:
        only = Phoneme(known.pop() if known else Phoneme.UNIDENTIFIED).label
        raise CorpusError(
            f"rules need labels of at least two sounds, and the recordings have only {only}; load some with others"
        )
    unasked = UNASKED if _has_bands(preset) else {PITCH.name}
    names = [name for name in labelled.variables if name not in unasked]
    speakers = _numbers_of([u.speaker for u in labelled.utterances], labelled.edges)
    weights = frame_weights(labelled.labels) / np.bincount(speakers)[speakers]  # each speaker counts the same
    return RuleSearch(labelled.features(), labelled.labels.phonemes, weights, names, LEAST_SHARE)


def _has_bands(preset: Preset) -> bool:
    return set(candidates()) <= set(preset.variables)


def _with_rules(preset: Preset, rules: tuple[Rule, ...]) -> Preset:
    settings = replace(preset.settings, statistics=True, minimum_hold=0.0)
    return replace(preset, recogniser=OWN_RULES.name, settings=settings, rules=rules, confidences={}, confusions={})


def _settled(labelled: LabelledFeatures, preset: Preset) -> Preset:
    """Return the preset with the least hysteresis by which its answers flicker no more than they may."""
    for hysteresis in HYSTERESES:
        calmer = replace(preset, settings=replace(preset.settings, hysteresis=hysteresis))
        scores = labelled.confusion(calmer).scores()
        if scores.changes_per_s <= MOST_CHANGES * scores.label_changes_per_s:
            break
    return calmer


def _without_unused(preset: Preset) -> Preset:
    used = {c.variable for rule in preset.rules for c in rule.conditions}
    used |= {v.per for v in preset.variables if v.name in used}
    bands = set(candidates()) if _has_bands(preset) else set()
    return replace(preset, variables=tuple(v for v in preset.variables if v.name in used or v not in bands))


def _parts_of(labelled: LabelledFeatures) -> tuple[str, IndexArray]:
    """Return what is held out in turn, in words, and the number of the part of each frame."""
    kind, names = left_out_of(labelled)
    if kind:
        return kind, _numbers_of(names, labelled.edges) % MOST_FOLDS
    n_frames = int(labelled.edges[-1])
    parts = np.arange(n_frames) * N_PARTS // max(1, n_frames)
    return "part", parts.astype(np.intp)


def _numbers_of(names: Sequence[str], edges: IndexArray) -> IndexArray:
    """Return a number for each frame, the same in recordings of one name."""
    known = list(dict.fromkeys(names))
    return np.repeat(np.array([known.index(name) for name in names], np.intp), np.diff(edges))
