"""The preset that is being tuned, with undo and redo, and a second one beside it: A and B."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from phonemeanalyser.desktop.engine_words import recogniser_title, sound_name
from phonemeanalyser.desktop.language import tr, tr_amid, tr_noop
from phonemeanalyser.desktop.session.undo import UndoableEdit
from phonemeengine.errors import EngineError, RecogniserError, SettingsError
from phonemeengine.features.variables import BUILT_IN_NAMES, PITCH_SET_COLUMNS, Variable
from phonemeengine.presets import files
from phonemeengine.presets.controls import Control, ControlGroup, controls_of
from phonemeengine.presets.model_choice import for_files, for_live_use
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import Rule, Thresholds
from phonemeengine.recognition.spec import Recogniser, Tuning, recogniser_of, spec_of
from phonemeengine.settings import PARAMETERS, STAGES, AnalysisSettings, Filter, ModelKind

USUAL_VARIABLE = "energy"
"""The one that is drawn while no other is chosen."""


NO_SECOND = tr_noop("There is no preset B yet. Open the list of presets and set one as B.")
A, B = "A", "B"


@dataclass(frozen=True)
class PresetDocument:
    """A preset, its file, and what the file holds."""

    path: Path
    preset: Preset
    saved: Preset

    @classmethod
    def read(cls, path: Path) -> "PresetDocument":
        """Read a preset or PhonemeData file, or the preset of a name; EngineError where it cannot be used."""
        path = files.preset_path(path)
        preset = files.load_preset(path)
        made_recogniser(preset)
        return cls(path, preset, preset)

    @property
    def has_unsaved_changes(self) -> bool:
        """Whether the preset differs from its file."""
        return self.preset != self.saved


class _Edit(UndoableEdit):
    """One change of the preset A or B; changes of the same thing in one run become one."""

    def __init__(self, model: "PresetModel", after: Preset, what: str, run: int) -> None:
        super().__init__(what, self._apply, model.preset, after, lambda: None, (what, run, model.letter))
        self._model, self.letter = model, model.letter

    def _apply(self, preset: Preset) -> None:
        self._model.apply_edit(self.letter, preset)


class PresetModel(QObject):
    """The preset in use, where it came from, and what has been changed since; another one may stand beside it.

    Of the two, A and B, one is in use: it is seen, tuned and saved. `switch` uses the other one.

    Signals
    -------
    replaced : the preset in use is another one; comes before `changed`, so before anything is recognised anew.
    changed : the preset in force is another one.
    sides_changed : another preset stands beside the one in use, or none, or the two changed places. Comes before
        `changed`.
    file_changed : the file's name, or whether there are unsaved changes.
    loaded : another file is open, and the history of changes begins anew.
    rejected : a sentence for the user: the recogniser in use does not take that number, or there is no such model.

    Attributes
    ----------
    document : the preset in use, with its file.
    letter : whether that is A or B.
    other : the one that is not in use; None without a second preset.
    """

    replaced = Signal()
    changed = Signal()
    sides_changed = Signal()
    file_changed = Signal()
    loaded = Signal()
    rejected = Signal(str)

    def __init__(self, path: Path = files.DEFAULT_PRESET) -> None:
        super().__init__()
        self.undo_stack = QUndoStack(self)
        self.undo_stack.indexChanged.connect(self.file_changed)
        self.bypassed = False
        self.document = PresetDocument.read(path)
        self.letter = A
        self.other: PresetDocument | None = None
        self._run = 0
        self._shape_of: PresetDocument | None = None
        self._has_shape = False
        self._left: dict[str, Preset] = {}
        self._groups: tuple[ControlGroup, ...] = ()
        self._kept_groups: tuple[ControlGroup, ...] = ()
        self._tried: Preset | None = None
        self._made: tuple[object, Recogniser] = self._make(self.preset)

    @property
    def preset(self) -> Preset:
        """The preset in use."""
        return self.document.preset

    @property
    def path(self) -> Path:
        """Its file."""
        return self.document.path

    @property
    def sides(self) -> dict[str, Preset]:
        """The presets by letter, A first; the one in use alone where there is no second one."""
        if self.other is None:
            return {self.letter: self.preset}
        return dict(sorted({self.letter: self.preset, self.other_letter: self.other.preset}.items()))

    @property
    def title(self) -> str:
        """What the window calls the preset in use: its name, with its letter where there is a second one."""
        return self.preset.name if self.other is None else f"{self.letter}: {self.preset.name}"

    @property
    def other_letter(self) -> str:
        """The letter of the one that is not in use."""
        return B if self.letter == A else A

    @property
    def recogniser(self) -> Recogniser:
        """The recogniser of the preset in use, made once; EngineError where it cannot be made."""
        if self._made[0] != _recogniser_key(self.preset):
            self._made = self._make(self.preset)
        return self._made[1]

    @property
    def control_groups(self) -> tuple[ControlGroup, ...]:
        """All that the recogniser in use is tuned by; the same while nothing but `tune` changes the preset."""
        if not self._groups:
            self._groups = controls_of(self.preset, self._made_recogniser())
        return self._groups

    @property
    def controls(self) -> dict[str, Control]:
        """The same, by their names."""
        return {control.name: control for group in self.control_groups for control in group.controls}

    @property
    def in_force(self) -> Preset:
        """The preset that the analysis uses: all filters off while bypassed."""
        preset = self._tried or self.preset
        if not self.bypassed:
            return preset
        return replace(preset, settings=replace(preset.settings, filters=frozenset()))

    @property
    def variable_names(self) -> list[tuple[str, str]]:
        """All variables that are measured, each as it is shown and chosen."""
        return [(name, name) for name in (*BUILT_IN_NAMES, *(v.name for v in self.preset.variables))]

    @property
    def has_unsaved_changes(self) -> bool:
        """Whether the preset differs from its file."""
        return self.document.has_unsaved_changes

    @property
    def is_factory(self) -> bool:
        """Whether the preset's file ships with the program, and so is not to be changed."""
        return self.path.resolve().parent == files.FACTORY

    def load(self, path: Path) -> None:
        """Load a preset or PhonemeData file, or the preset of a name; EngineError leaves everything as it was."""
        document = PresetDocument.read(path)
        self._made = self._make(document.preset)
        self._left = {}
        self.undo_stack.clear()
        self._use(document)
        self.loaded.emit()
        self.file_changed.emit()

    def set_other(self, document: PresetDocument | None) -> None:
        """Have another preset beside the one in use, or none; the one in use is A where there is none."""
        stack = self.undo_stack
        edits = [edit for k in range(stack.count()) if isinstance(edit := stack.command(k), _Edit)]
        if any(edit.letter == self.other_letter for edit in edits):
            stack.clear()  # what was done to the preset that goes can't be undone any more
            self.loaded.emit()
        elif document is None:
            for edit in edits:
                edit.letter = A
        self.other = document
        self.letter = A if document is None else self.letter
        self.sides_changed.emit()
        self.file_changed.emit()

    def clear_second(self) -> None:
        """Use A, and have no B any more."""
        if self.letter == B:
            self.switch()
        self.set_other(None)

    def switch(self) -> None:
        """Use the other one of A and B; says so where there is no other one."""
        if self.other is None:
            self.rejected.emit(tr(NO_SECOND))
            return
        made = self._make(self.other.preset)
        before, self._left, self._made = self.document, {}, made
        document, self.other, self.letter = self.other, before, self.other_letter
        self.document = document
        self.end_edit()
        self.sides_changed.emit()
        self._use(document)
        self.file_changed.emit()

    def lost_in(self, path: Path) -> tuple[str, ...]:
        """Return what saving to such a file would drop, in words; a PhonemeData file holds only the 21 numbers."""
        return files.beyond_phoneme_data(self.preset) if files.is_phoneme_data(path) else ()

    def save(self, path: Path) -> None:
        """Save to a file, which becomes the preset's file; EngineError leaves everything as it was.

        Where a PhonemeData file cannot hold all, `lost_in` says what is left out; that counts as saved until the next
        start, since the user chose so.
        """
        named = replace(self.preset, name=path.stem) if path != self.path else self.preset
        files.save_preset(named, path)
        before, saved = self.preset, named if self.lost_in(path) else files.load_preset(path)
        self.document = PresetDocument(path, named, saved)
        if named != before:
            self._use(self.document)
        self.undo_stack.setClean()
        self.file_changed.emit()

    def set_bypassed(self, bypassed: bool) -> None:
        """Switch all filters off at once, or back to what they were."""
        if bypassed != self.bypassed:
            self.end_edit()
            self.bypassed = bypassed
            self.changed.emit()
            self.end_edit()

    def try_out(self, preset: Preset | None) -> None:
        """Analyse with another preset for a while, without changing the one in use; None ends that."""
        if preset is not self._tried:
            self._tried = preset
            self.changed.emit()

    def edit(self, preset: Preset, what: str) -> None:
        """Change the preset; `what` names the change in the Edit menu, and equal names in a row become one.

        EngineError, where its recogniser cannot be made, leaves everything as it was.
        """
        if preset != self.preset:
            preset = self._marked(preset)
            if _recogniser_key(preset) != self._made[0]:
                self._made = self._make(preset)
            self.undo_stack.push(_Edit(self, preset, what, self._run))
            self.file_changed.emit()

    def revert(self) -> None:
        """Go back to what the preset's file says, in one change."""
        self.end_edit()
        self.edit(self.document.saved, tr("revert to the file"))

    @property
    def run(self) -> int:
        """The number of the run of changes that goes on; see `end_edit`."""
        return self._run

    def end_edit(self) -> None:
        """End a run of changes that undo takes back together, such as a drag."""
        self._run += 1

    def set_setting(self, name: str, value: Any) -> None:
        """Change one field of the settings; of an ordered pair, the other one gives way."""
        settings = self.preset.settings.with_number(name, value)
        self._use_settings(settings, tr("change {what}").format(what=_label_of(name)))

    def set_filter(self, step: Filter, on: bool) -> None:
        """Switch a filter on or off; one that would do nothing gets its usual strength."""
        settings = self.preset.settings.with_filter(step, on)
        words = tr("switch {what} on") if on else tr("switch {what} off")
        self._use_settings(settings, words.format(what=_label_of(step)))

    def reset_stage(self, name: str) -> None:
        """Reset a filter, or what follows the filters, to what the preset's file says."""
        saved, settings = self.document.saved.settings, self.preset.settings
        changes: dict[str, Any] = {of.name: getattr(saved, of.name) for of in STAGES[name].parameters}
        if name == "statistics":
            changes[name] = saved.statistics
        switched = (settings.filters ^ saved.filters) & {name}
        settings = replace(settings, filters=settings.filters ^ switched, **changes)
        self._use_settings(settings, tr("reset {what}").format(what=_label_of(name)))

    def tune(self, name: str, value: float) -> None:
        """Set one of the `controls`, if the recogniser takes the value."""
        self._kept_groups = self.control_groups
        try:
            self.edit(self.controls[name].write(self.preset, value), tr("change {what}").format(what=_label_of(name)))
        except (RecogniserError, SettingsError) as error:
            self.rejected.emit(str(error))
            self.changed.emit()  # views go back from the refused number to the old one
        finally:
            self._kept_groups = ()

    def set_recogniser(self, name: str) -> None:
        """Recognise with another recogniser; EngineError, where it cannot be made, leaves everything as it was.

        It goes on as it was left since the preset was loaded. Else it comes as the preset's file has it, or as its
        factory preset has it: front end, statistics, thresholds; thresholds, rules, model and templates of the user's
        own stay.
        """
        tuned = self._tuned_for(name)
        left = {self.preset.recogniser: self.preset}
        self.edit(tuned, tr("switch to recogniser {name}").format(name=recogniser_title(name)))
        self._left |= left

    def set_file_model(self, kind: ModelKind) -> None:
        """Analyse files with another model; one that cannot be had is reported, and nothing changes."""
        chosen = for_files(self.preset, kind)
        if chosen.model_kind is kind:
            self.edit(replace(self.preset, file_model=kind), tr("change file model"))
        else:
            self.rejected.emit(chosen.warnings[-1])

    def set_live_model(self, kind: ModelKind) -> None:
        """Have live sound recognised with another model; one that cannot be had is said, and nothing changes."""
        changed = replace(self.preset, live_model=kind)
        live = for_live_use(changed)
        if live.model_kind is kind:
            self.edit(changed, tr("change real-time model"))
        elif live.warnings:
            self.rejected.emit(live.warnings[-1])

    def saved_value(self, name: str) -> float | None:
        """Return a control's value as the preset's file has it; None where the file's rules are others."""
        has_limits = Tuning.RULES in spec_of(self.preset.recogniser).tuned_by
        if has_limits and not self._keeps_shape():
            return None
        return self.controls[name].read(self.document.saved)

    def _keeps_shape(self) -> bool:
        """Return whether the rules are those of the file but for their limits; each control asks it anew."""
        if self._shape_of is not self.document:
            self._shape_of = self.document
            self._has_shape = _shape(self.document.saved.rules) == _shape(self.preset.rules)
        return self._has_shape

    def add_variable(self, variable: Variable) -> None:
        """Add a user's own variable; EngineError where the name is taken."""
        preset = replace(self.preset, variables=(*self.preset.variables, variable))
        self.edit(preset, tr("add variable {name}").format(name=variable.name))

    def remove_variable(self, name: str) -> None:
        """Remove a user's own variable."""
        kept = tuple(v for v in self.preset.variables if v.name != name)
        self.edit(replace(self.preset, variables=kept), tr("remove {name}").format(name=name))

    def _marked(self, preset: Preset) -> Preset:
        """Return a changed preset; figures of a calibration that are no longer its own say so."""
        judged, saved = preset.judged, self.document.saved
        if judged is None or judged != self.preset.judged:
            return preset
        is_as_saved = replace(preset, judged=saved.judged, notes=saved.notes, name=saved.name) == saved
        return replace(preset, judged=saved.judged if is_as_saved else replace(judged, changed=True))

    def _use_settings(self, settings: AnalysisSettings, what: str) -> None:
        self.edit(replace(self.preset, settings=settings), what)

    def _tuned_for(self, name: str) -> Preset:
        preset, source = self.preset, self._left.get(name)
        if source is None and name == self.document.saved.recogniser:
            source = self.document.saved
        if source is not None:
            return _joined(source, preset, source)
        source = files.factory_preset(name) or replace(preset, recogniser=name)
        own_thresholds = preset.thresholds not in _factory_thresholds()
        source = replace(source, thresholds=preset.thresholds if own_thresholds else source.thresholds)
        return _joined(source, preset, preset)

    def _made_recogniser(self) -> Recogniser | None:
        try:
            recogniser = self.recogniser
            recogniser.used_thresholds  # noqa: B018 - one of another package is made by being asked
        except EngineError:
            return None
        return recogniser

    def _make(self, preset: Preset) -> tuple[object, Recogniser]:
        return _recogniser_key(preset), made_recogniser(preset)

    def apply_edit(self, letter: str, preset: Preset) -> None:
        """Do or undo a change of A or B, which is in use from then on."""
        if letter != self.letter:
            self.switch()
        preset = replace(preset, name=self.preset.name)  # the name is the file's, and saving is not undone
        self._use(replace(self.document, preset=preset))

    def _use(self, document: PresetDocument) -> None:
        self.document = document
        self._groups = self._kept_groups
        self.replaced.emit()
        self.changed.emit()


def made_recogniser(preset: Preset) -> Recogniser:
    """Return the recogniser of a preset; EngineError where it cannot be made."""
    recogniser = recogniser_of(preset.recogniser, preset.config)
    recogniser.used_thresholds  # noqa: B018 - one of another package is made by being asked
    return recogniser


def _label_of(name: str) -> str:
    """Return what a stage, a parameter or another control is called amid a sentence."""
    known = STAGES.get(name) or PARAMETERS.get(name)
    kind, _, sound = name.partition("_")
    if kind == "sensitivity":
        return tr("sensitivity to {sound}").format(sound=sound_name(sound))
    return tr_amid(known.label) if known else tr(name.replace("_", " "))


def _factory_thresholds() -> tuple[Thresholds, ...]:
    """Return the thresholds that no user has tuned."""
    return Thresholds(), *(files.load_preset(path).thresholds for path in files.THESIS_PRESETS)


def _joined(source: Preset, preset: Preset, first: Preset) -> Preset:
    """Return what `source` recognises with, named as `preset`, with all that either knows; `first` goes first."""
    mine = {v.name for v in source.variables}
    knows = next((known for known in (first, source, preset) if known.model), source)
    return replace(
        source,
        name=preset.name,
        notes=preset.notes,
        variables=(*source.variables, *(v for v in preset.variables if v.name not in mine)),
        rules=first.rules or source.rules or preset.rules,
        model=knows.model,
        offline_model=knows.offline_model,
        encoder_head=knows.encoder_head,
        live_encoder=knows.live_encoder,
        live_model=knows.live_model,
        confidences=source.confidences,
        file_model=knows.file_model,
        templates=first.templates or source.templates or preset.templates,
        pitch_sets=first.pitch_sets or source.pitch_sets or preset.pitch_sets,
    )


def _recogniser_key(preset: Preset) -> object:
    return preset.recogniser, preset.config


def _shape(rules: tuple[Rule, ...]) -> object:
    """Return all of some rules but their limits."""
    return [(rule.phoneme, [(c.variable, c.sign, c.threshold) for c in rule.conditions]) for rule in rules]


def pitch_set_name(preset: Preset, values: Mapping[str, float]) -> str:
    """Return the name of the set that a frame was recognised with; empty where it was with the preset's own numbers.

    `values` are the variables of the frame.
    """
    number = int(values.get(PITCH_SET_COLUMNS[1], 0))
    return preset.pitch_sets[number - 1].name if 0 < number <= len(preset.pitch_sets) else ""


def pitch_set_in_words(preset: Preset, values: Mapping[str, float]) -> str:
    """Return which numbers of PhonemeData a frame was recognised with, and why; empty where there are no sets."""
    if not preset.pitch_ranges:
        return ""
    pitch, name = values.get(PITCH_SET_COLUMNS[0], 0), pitch_set_name(preset, values)
    if not pitch > 0:
        return tr("In use: the preset's own numbers, until the pitch of the voice is known.")
    if not name:
        words = tr("In use: the preset's own numbers, since no pitch set has {pitch:.0f} Hz, the pitch of the voice.")
        return words.format(pitch=pitch)
    found = preset.pitch_sets[int(values[PITCH_SET_COLUMNS[1]]) - 1]
    return tr(
        "In use: {name} ({low:.0f}–{high:.0f} Hz), since the pitch of the voice is {pitch:.0f} Hz, the median of its "
        "last second."
    ).format(name=name, pitch=pitch, low=found.low, high=found.high)
