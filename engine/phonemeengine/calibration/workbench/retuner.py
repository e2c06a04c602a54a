"""Measured frames that are recognised anew, with other thresholds, rules, sensitivities or smoothing, at once."""

import math
from collections import defaultdict
from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass, replace
from functools import partial, reduce
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from phonemeengine.analyser import analyse_file
from phonemeengine.arrays import BoolArray, Float32Array, IndexArray, UInt8Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.workbench.batch_smoother import BatchSmoother
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.features.variables import BUILT_IN_NAMES, PITCH_SET_COLUMNS
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import for_files
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.decoder import SoundsDecoder, evidence_in, lag_of
from phonemeengine.recognition.rules import PitchSetRules, Rule, RuleRecogniser, Thresholds
from phonemeengine.recognition.scores import Sensitivity, scores_in
from phonemeengine.recognition.searched import SEARCH_LAG
from phonemeengine.recognition.spec import Tuning, spec_of
from phonemeengine.settings import FRAME_PERIOD, AnalysisSettings, ModelKind

# Rules asked of the same frames again and again: what a new limit does not touch is remembered.
#
# It gives exactly what `RuleRecogniser` gives, but keeps for each comparison what it says of every frame, a bit for
# each. A limit that is dragged changes one comparison, so only that and the rules that ask it are worked out anew.


class _ConditionKey(NamedTuple):
    """A comparison of a variable with a limit: ``>``, ``<``, or whether its margin is more or not less than a share.

    Attributes
    ----------
    variable, sign, limit : the comparison.
    least : by what share of the limit it must hold at least (negative: may fail at most); None where it must hold.
    beyond : whether it must hold by more than `least`.
    """

    variable: str
    sign: str
    limit: float
    least: float | None = None
    beyond: bool = False


class RuleCache:
    """Asks rules of the same frames with ever other limits.

    Parameters
    ----------
    values : by variable, float32, shape (n_frames,), as a recogniser would get them.
    n_frames : how many frames there are.
    """

    def __init__(self, values: Mapping[str, Float32Array], n_frames: int) -> None:
        self._values = values
        self._n_frames = n_frames
        self._holding = _Memory()
        self._near_misses = _Memory()

    def recognised(self, recogniser: RuleRecogniser) -> UInt8Array:
        """Return the codes that `RuleRecogniser.recognise` gives, shape (n_frames,)."""
        self._holding.begin()
        named, free = self._bits_by_phoneme(), self._all_set()
        for rule in recogniser.rules:
            holds = self._all(self._holding, _condition_keys(rule, recogniser))
            named[rule.phoneme] |= holds & free
            free &= ~holds
        codes = np.zeros(self._n_frames, np.uint8)
        for phoneme in Phoneme:
            codes += np.unpackbits(named[phoneme], count=self._n_frames) * np.uint8(phoneme)
        return codes

    def may_stay(self, recogniser: RuleRecogniser, hysteresis: float) -> BoolArray:
        """Return where `RuleRecogniser.deficits` are at most `hysteresis`; shape (n_phonemes, n_frames).

        A phoneme may stay where the comparisons of one of its rules fail by no more than that, and no rule before
        that one holds by more.
        """
        self._near_misses.begin()
        stays, free = self._bits_by_phoneme(), self._all_set()
        for rule in recogniser.rules:
            nearly = self._all(self._near_misses, _condition_keys(rule, recogniser, -hysteresis))
            stays[rule.phoneme] |= nearly & free
            free &= ~self._all(self._near_misses, _condition_keys(rule, recogniser, hysteresis, beyond=True))
        return np.unpackbits(stays, axis=1, count=self._n_frames).view(bool)

    def _all_set(self) -> UInt8Array:
        return np.full(-(-self._n_frames // 8), 255, np.uint8)

    def _bits_by_phoneme(self) -> UInt8Array:
        return np.zeros((len(Phoneme), -(-self._n_frames // 8)), np.uint8)

    def _all(self, memory: "_Memory", keys: tuple[_ConditionKey, ...]) -> UInt8Array:
        """Return where all of these hold, a bit for each frame."""
        if not keys:
            return self._all_set()

        def answered() -> UInt8Array:
            first, *others = (memory.recall(k, partial(self._answer, k)) for k in keys)
            return reduce(np.bitwise_and, others, first)

        return memory.recall(keys, answered)

    def _answer(self, key: _ConditionKey) -> UInt8Array:
        return np.packbits(self._compared(key))

    def _compared(self, key: _ConditionKey) -> BoolArray:
        values, limit = self._values[key.variable], np.float32(key.limit)
        if key.least is None:
            return np.asarray(values > limit if key.sign == ">" else values < limit)
        margins = (values - limit if key.sign == ">" else limit - values) / np.maximum(np.abs(limit), 1e-9)
        return np.asarray(margins > key.least if key.beyond else margins >= key.least)


class _Memory:
    """Remembers what was worked out for the last question of each kind, and forgets what is no longer asked."""

    def __init__(self) -> None:
        self._before: dict[Hashable, UInt8Array] = {}
        self._now: dict[Hashable, UInt8Array] = {}

    def begin(self) -> None:
        """Keep only what has been asked since the last beginning."""
        self._before, self._now = self._now, {}

    def recall(self, key: Hashable, work_out: Callable[[], UInt8Array]) -> UInt8Array:
        """Return what was said of the same, or work it out."""
        answer = self._now.get(key)
        if answer is None:
            answer = self._before.get(key)
        if answer is None:
            answer = work_out()
        self._now[key] = answer
        return answer


def _condition_keys(
    rule: Rule, recogniser: RuleRecogniser, least: float | None = None, *, beyond: bool = False
) -> tuple[_ConditionKey, ...]:
    return tuple(
        _ConditionKey(c.variable, c.sign, recogniser.limit_of(c), least, beyond=beyond) for c in rule.conditions
    )


# Labelled recordings as measured variables: what thresholds, rules and the statistics need, without the sound.

AFTER_MEASURING = (
    "statistics",
    "minimum_hold",
    "hysteresis",
    "decoder",
    "change_cost",
    "look_ahead",
    "intensity_low",
    "intensity_high",
)
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
    of_sets = PITCH_SET_COLUMNS if preset.pitch_ranges else ()
    return (*BUILT_IN_NAMES, *(v.name for v in preset.variables), *of_sets)


def front_end_key(preset: Preset) -> object:
    """Return all on which the variables depend: where it is equal, nothing need be measured anew."""
    kept = {name: getattr(_PLAIN, name) for name in AFTER_MEASURING}
    settings = tuple(replace(p.settings, **kept) for p in preset.by_pitch)
    return settings, preset.pitch_ranges, preset.variables


def recogniser_key(preset: Preset) -> object:
    """Return all on which the answers of a recogniser without rules depend, but for the sensitivities."""
    config = replace(preset.config, rules=(), sensitivities={})
    if Tuning.THRESHOLDS not in spec_of(preset.recogniser).tuned_by:
        config = replace(config, thresholds=Thresholds())
    return preset.recogniser, config


def rules_in(preset: Preset) -> RuleRecogniser | None:
    """Return the preset's recogniser if it works by rules."""
    rules_of = spec_of(preset.recogniser).rules
    if rules_of is None:
        return None
    if preset.pitch_ranges:
        return PitchSetRules(preset.thresholds, [pitch_set.data for pitch_set in preset.pitch_sets])
    return RuleRecogniser(rules_of(preset.config), preset.thresholds)


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
    preset = for_files(preset, ModelKind.REAL_TIME)  # what is tuned is what recognises live sound
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
        self._smoother, self._decoder = BatchSmoother(edges), SoundsDecoder(edges)
        n_frames = int(edges[-1])
        self._numbers = np.nan_to_num(values.get(PITCH_SET_COLUMNS[1], np.zeros(n_frames, np.float32)))
        self._rule_caches: defaultdict[int, RuleCache] = defaultdict(lambda: RuleCache(values, n_frames))

    def scores(self, preset: Preset) -> Float32Array | None:
        """Return the probabilities with the sensitivities of a preset, shape (n_phonemes, n_frames), or None."""
        return None if self._scores is None else Sensitivity(preset.sensitivities).apply(self._scores.T).T

    def recognise(self, preset: Preset) -> tuple[UInt8Array, UInt8Array]:
        """Return what is recognised with a preset of the same front end, before and after the statistics."""
        rules, settings = rules_in(preset), preset.settings
        scores = None if rules is not None else self.scores(preset)
        recognised = codes = self._recognised(rules, scores)
        if settings.statistics:
            if preset.decoder:
                codes = self._decoder.decode(preset.decoder, lag_of(settings.look_ahead), codes)
            elif preset.search is not None and scores is not None:
                codes = self._decoder.decode(preset.search, SEARCH_LAG, evidence_in(scores.T))
            elif settings.hysteresis > 0:
                stays = self._may_stay(rules, scores, settings.hysteresis)
                codes = codes if stays is None else self._smoother.hysteresis(codes, stays)
            codes = self._smoother.minimum_hold(
                self._smoother.fill_unidentified(codes, preset.successors), settings.minimum_hold
            )
        return recognised, codes

    def _recognised(self, rules: RuleRecogniser | None, scores: Float32Array | None) -> UInt8Array:
        if rules is not None:
            return self._by_rules(rules, RuleCache.recognised)
        return self._codes if scores is None else scores.argmax(axis=0).astype(np.uint8)

    def _may_stay(
        self, rules: RuleRecogniser | None, scores: Float32Array | None, hysteresis: float
    ) -> BoolArray | None:
        if rules is not None:
            return self._by_rules(rules, lambda cache, one: cache.may_stay(one, hysteresis))
        return None if scores is None else np.asarray(scores.max(axis=0) - scores <= hysteresis)

    def _by_rules(
        self, rules: RuleRecogniser, ask: Callable[[RuleCache, RuleRecogniser], NDArray[Any]]
    ) -> NDArray[Any]:
        """Ask the rules, or those of each pitch set about its frames; frames are the last axis."""
        of_sets = rules.by_set if isinstance(rules, PitchSetRules) else (rules,)
        answers = ask(self._rule_caches[0], of_sets[0])
        for number, one in enumerate(of_sets[1:], 1):
            answers = np.where(self._numbers == number, ask(self._rule_caches[number], one), answers)
        return answers
