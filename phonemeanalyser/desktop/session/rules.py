"""The rules of the preset in use: their changes, what is wrong with them, and what a change gains."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.label_tiers import LabelTiers
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.seen_sound import SeenSound
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.calibration.fits.limit_search import RuleTrials, with_rule
from phonemeengine.calibration.scores.scoring import Agreement
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.errors import EngineError
from phonemeengine.features.variables import Features
from phonemeengine.inspection.whole_sound import FrameState
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset, rules_of, with_own_rules
from phonemeengine.recognition.rules import Condition, Rule, RuleFault, limit_of, rule_faults
from phonemeengine.recognition.spec import Tuning, spec_of

CHECK_MS = 250
"""After a change, until rules are checked anew: a limit that is dragged changes all the time."""


@dataclass(frozen=True)
class Draft:
    """A condition that may become part of a rule.

    Attributes
    ----------
    rule : the number of the rule that is to ask it, or in front of which a new rule is to stand.
    variable : what is to be asked.
    phoneme : what the new rule names; None where the condition is for rule `rule` itself.
    condition : the comparison; None to have the best one looked for.
    """

    rule: int
    variable: str
    phoneme: Phoneme | None = None
    condition: Condition | None = None

    def applied(self, preset: Preset) -> Preset:
        """Return the preset with the condition in its place, or with a new rule that asks nothing yet."""
        asked = () if self.condition is None else (self.condition,)
        if self.phoneme is not None:
            return with_rule(preset, self.rule, Rule(self.phoneme, asked))
        old = preset.rules[self.rule]
        rules = list(preset.rules)
        rules[self.rule] = replace(old, conditions=(*old.conditions, *asked))
        return replace(preset, rules=tuple(rules))


class RuleTrial(NamedTuple):
    """What a draft would change on the labelled sound: a comparison, and the agreement before and with it."""

    condition: Condition
    before: Agreement
    after: Agreement


class RuleModel(QObject):
    """Follows the preset in use; every change of a rule can be undone.

    Signals
    -------
    changed : the rules are others.
    checked : what is wrong with them is known anew.
    tried : a `RuleTrial` of the last draft is there.
    error : a sentence for the user.

    Attributes
    ----------
    faults : what is wrong with each rule; empty until that is known.
    """

    changed = Signal()
    checked = Signal()
    tried = Signal(object)
    error = Signal(str)

    def __init__(self, preset: PresetModel, seen: SeenSound, labels: LabelTiers) -> None:
        super().__init__()
        self.faults: tuple[RuleFault | None, ...] = ()
        self._preset, self._seen, self._labels = preset, seen, labels
        self._labelled: LabelledFeatures | None = None
        self._trials: tuple[object, RuleTrials | None] = (), None
        self._followed: tuple[Rule, ...] | None = None
        self._checking, self._trying = TaskQueue(self.error.emit), TaskQueue(self.error.emit)
        self._timer = QTimer(self, singleShot=True, interval=CHECK_MS)
        self._timer.timeout.connect(self._check)
        preset.changed.connect(self._follow)
        seen.whole.changed.connect(self._check_soon)
        self._follow()

    # -- what there is ------------------------------------------------------------------------------------

    @property
    def preset(self) -> Preset:
        """The preset in use."""
        return self._preset.preset

    @property
    def rules(self) -> tuple[Rule, ...]:
        """The rules in the order of decision; none where the recogniser has none."""
        return rules_of(self.preset)

    @property
    def can_edit(self) -> bool:
        """Whether the rules are the preset's own: those of the thesis are fixed but for their numbers."""
        return Tuning.RULES in spec_of(self.preset.recogniser).tuned_by

    @property
    def variables(self) -> tuple[str, ...]:
        """What rules may ask for."""
        return tuple(name for name, _ in self._preset.variable_names)

    def limit_of(self, condition: Condition) -> float:
        """Return the number that a condition compares with."""
        return limit_of(condition, self.preset.thresholds)

    def show_loaded(self, labelled: LabelledFeatures | None) -> None:
        """Take up the recordings that are loaded in the workbench."""
        self._labelled = labelled
        self._check_soon()

    # -- what is changed ----------------------------------------------------------------------------------

    def set_rule(self, k: int, **values: Any) -> None:
        """Change what a rule names, or switch it on or off."""
        self._change(k, lambda rule: replace(rule, **values), tr("change a rule"))

    def set_condition(self, k: int, j: int, **values: Any) -> None:
        """Change a condition: variable, sign, limit, or whether it is on; of fixed rules only the limit."""
        condition = self.rules[k].conditions[j]
        if condition.threshold:
            self._preset.tune(condition.threshold, float(str(values["limit"])))
            self._preset.end_edit()
            return

        def changed(rule: Rule) -> Rule:
            new = replace(condition, **values)
            return replace(rule, conditions=(*rule.conditions[:j], new, *rule.conditions[j + 1 :]))

        self._change(k, changed, tr("change a condition"))

    def delete_condition(self, k: int, j: int) -> None:
        """Have a rule ask one condition less."""
        self._change(
            k, lambda rule: replace(rule, conditions=rule.conditions[:j] + rule.conditions[j + 1 :]),
            tr("delete a condition"),
        )  # fmt: skip

    def move(self, k: int, to: int) -> None:
        """Have a rule stand at another place; those between move on by one."""
        rules = list(self.rules)
        rules.insert(to, rules.pop(k))
        self._use(tuple(rules), tr("move a rule"))

    def add_rule(self, at: int, phoneme: Phoneme) -> None:
        """Add a rule that asks nothing yet; it is switched off, since it would always hold."""
        self._use(with_rule(self.preset, at, Rule(phoneme, (), enabled=False)).rules, tr("add a rule"))

    def duplicate(self, k: int) -> None:
        """Add the same rule behind a rule."""
        self._use((*self.rules[: k + 1], *self.rules[k:]), tr("duplicate a rule"))

    def delete(self, k: int) -> None:
        """Delete a rule; the last one stays, since a preset with rules has at least one."""
        if len(self.rules) > 1:
            self._use(self.rules[:k] + self.rules[k + 1 :], tr("delete a rule"))

    def make_own(self) -> None:
        """Make the fixed rules of the thesis rules of the preset's own, which can be edited and recognise alike."""
        self._edit(with_own_rules(self.preset), tr("make the rules editable"))

    def add(self, draft: Draft) -> None:
        """Add a condition, in a rule or a new one."""
        words = tr("use {variable} in a rule for {phoneme}")
        phoneme = self.rules[draft.rule].phoneme if draft.phoneme is None else draft.phoneme
        self._edit(draft.applied(self.preset), words.format(variable=draft.variable, phoneme=sound_name(phoneme)))

    def _change(self, k: int, change: Callable[[Rule], Rule], what: str) -> None:
        self._use((*self.rules[:k], change(self.rules[k]), *self.rules[k + 1 :]), what)

    def _use(self, rules: tuple[Rule, ...], what: str) -> None:
        self._edit(replace(self.preset, rules=rules), what)

    def _edit(self, preset: Preset, what: str) -> None:
        self._preset.end_edit()
        try:
            self._preset.edit(preset, what)
        except EngineError as error:
            self.error.emit(str(error))
            self.changed.emit()  # views go back from what was refused to the old rule
        self._preset.end_edit()

    # -- what it gains ------------------------------------------------------------------------------------

    def try_out(self, draft: Draft) -> bool:
        """Look for what a draft gains, in the background; says whether there is labelled sound to try it on."""
        trials, preset = self._made_trials(), self.preset
        if trials is None or draft.variable not in trials.features.names:
            self._trying.cancel()
            return False

        def act(_progress: object) -> RuleTrial:
            found = draft.condition
            if found is None:
                found = trials.proposed(draft.applied(preset), draft.rule, draft.variable)
            after = trials.agreement(replace(draft, condition=found).applied(preset))
            return RuleTrial(found, trials.agreement(preset), after)

        self._trying.replace(act, self.tried.emit)
        return True

    def close(self) -> None:
        """End all work."""
        self._timer.stop()
        for queue in (self._checking, self._trying):
            queue.close(CLOSE_TIMEOUT)

    def _made_trials(self) -> RuleTrials | None:
        """Return the labelled sound on which changes are tried: what is loaded, and the open file."""
        labelled, features, labels = self._usable_labelled(), self._features_of_file(), self._labels.said_frames()
        key = labelled, None if features is None else self._seen.whole.tracks, self._labels.state
        if key != self._trials[0]:
            parts = [] if labelled is None else [(labelled.features(), labelled.labels.phonemes, labelled.edges)]
            if features is not None and labels is not None and not self._seen.looks_back:
                n = min(len(features.values), len(labels.phonemes))
                if np.any(labels.phonemes[:n] != Phoneme.UNIDENTIFIED):
                    parts.append((features.part(slice(n)), labels.phonemes[:n], np.array([0, n], np.intp)))
            self._trials = key, RuleTrials.of(parts) if parts else None
        return self._trials[1]

    def _usable_labelled(self) -> LabelledFeatures | None:
        labelled = self._labelled
        if labelled is None or not len(labelled.labels.phonemes) or labelled.needs_measuring(self.preset):
            return None
        return labelled

    def _features_of_file(self) -> Features | None:
        """Return what is measured of the open file, if all of it is, and it is not among what is loaded."""
        tracks, sound, labelled = self._seen.whole.tracks, self._seen.sound, self._usable_labelled()
        if tracks is None or not tracks.n_frames or np.any(tracks.states == FrameState.UNKNOWN):
            return None
        is_loaded = labelled is not None and sound is not None and sound[0] in {u.path for u in labelled.utterances}
        return None if is_loaded else tracks.features

    # -- what is wrong ------------------------------------------------------------------------------------

    def _follow(self) -> None:
        if self.rules is not self._followed:
            self._followed = self.rules
            self._check_soon()
            self.changed.emit()
        elif not self.can_edit:
            self.changed.emit()  # numbers of fixed rules stand elsewhere in the preset

    def _check_soon(self) -> None:
        if not self._timer.isActive():
            self._timer.start()

    def _check(self) -> None:
        rules, thresholds, labelled = self._followed or (), self.preset.thresholds, self._usable_labelled()
        parts = [self._features_of_file(), None if labelled is None else labelled.features()]
        known = [part for part in parts if part is not None]
        self._checking.replace(lambda _progress: rule_faults(rules, thresholds, *known), self._take_faults)

    def _take_faults(self, faults: tuple[RuleFault | None, ...]) -> None:
        if len(faults) == len(self._followed or ()) and faults != self.faults:
            self.faults = faults
            self.checked.emit()
