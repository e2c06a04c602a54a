"""The 21 numbers of PhonemeData as the window edits them: those of the preset, or of one of its pitch sets."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.calibrate.workbench.workbench_model import WorkbenchModel
from phonemeanalyser.desktop.engine_words import recogniser_title
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetModel, pitch_set_in_words
from phonemeanalyser.desktop.session.results import History
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.calibration.fits.fitting import fit_number, fit_pitch_set, fit_preset
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.calibration.workbench.phoneme_data_table import NumberRow, number_rows
from phonemeengine.dsp.pitch import HIGHEST, LOWEST
from phonemeengine.errors import EngineError
from phonemeengine.execution import Progress, subrange
from phonemeengine.presets.controls import with_number
from phonemeengine.presets.files import load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import PhonemeData, PitchSet
from phonemeengine.recognition.spec import Tuning, spec_of

Fitted = tuple[Preset, float, float]
"""A preset that was fitted, and the macro F1 before and after."""


class PhonemeDataModel(QObject):
    """Edits, fits and compares the 21 numbers; each change is one step of the preset's undo.

    Attributes
    ----------
    rows : the numbers, with what they divide in the loaded recordings.
    chosen : the pitch set whose numbers are edited, from 1 on; 0 for the preset's own.
    words : what the last fit did, or why nothing can be fitted.

    Signals
    -------
    changed : numbers, rows or sets are others.
    error : a sentence for the user.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, preset: PresetModel, workbench: WorkbenchModel, history: History) -> None:
        super().__init__()
        self.rows: tuple[NumberRow, ...] = number_rows(None)
        self.chosen = 0
        self.words = ""
        self._preset, self._workbench = preset, workbench
        self._history = history
        self.measuring, self.fitting = TaskQueue(self.error.emit), TaskQueue(self.error.emit)
        workbench.measured.connect(self._measure)
        for signal in (preset.changed, preset.sides_changed):
            signal.connect(self._follow)

    # -- what there is ------------------------------------------------------------------------------------

    @property
    def sets(self) -> tuple[PitchSet, ...]:
        """The pitch sets of the preset."""
        return self._preset.preset.pitch_sets

    @property
    def chosen_set(self) -> PitchSet | None:
        """The pitch set whose numbers are edited; None for the preset's own numbers."""
        return self.sets[self.chosen - 1] if self.chosen else None

    @property
    def data(self) -> PhonemeData:
        """The numbers that are edited."""
        pitch_set = self.chosen_set
        return self._preset.preset.phoneme_data if pitch_set is None else pitch_set.data

    @property
    def other(self) -> PhonemeData | None:
        """The numbers of the other one of A and B; None without one."""
        return None if self._preset.other is None else self._preset.other.preset.phoneme_data

    @property
    def speakers(self) -> tuple[str, ...]:
        """Whose takes and recordings are loaded."""
        return tuple(dict.fromkeys(u.speaker for u in self._workbench.utterances))

    @property
    def why_unused(self) -> str:
        """Why the recogniser in use does not compare with these numbers, as a sentence; empty where it does."""
        name = self._preset.preset.recogniser
        if Tuning.PITCH_SETS in spec_of(name).tuned_by:
            return ""
        sentence = tr("“{name}” does not use these numbers. Choose the preset “Thesis”.")
        return sentence.format(name=recogniser_title(name))

    @property
    def why_no_fit(self) -> str:
        """Why nothing can be fitted now, as a sentence; empty where it can."""
        if self._workbench.features is None:
            return tr("Record takes or load labelled recordings first.")
        return self.why_unused

    def in_use(self) -> str:
        """Return which numbers the voice has at this moment, and why, in words; empty without pitch sets."""
        newest = self._history.newest
        values = {} if newest is None or not len(newest) else newest.features.frame(len(newest) - 1)
        return pitch_set_in_words(self._preset.preset, values)

    # -- what is changed ----------------------------------------------------------------------------------

    def choose(self, number: int) -> None:
        """Edit the numbers of a pitch set, or the preset's own (0)."""
        self.chosen = number
        self._measure()
        self.changed.emit()

    def set_number(self, name: str, value: float) -> None:
        """Set one of the 21 numbers, in the units of a PhonemeData file."""
        self._edit(lambda alone: with_number(alone, name, value), tr("change {what}").format(what=name))

    def type_number(self, name: str, text: str) -> None:
        """Set one of the 21 numbers as it was typed; what is no number is refused in a sentence."""
        try:
            value = float(text.replace(",", "."))
        except ValueError:
            self.error.emit(tr("{name} is a number, such as 0.25; found {text}").format(name=name, text=text[:40]))
            self.changed.emit()
            return
        self.set_number(name, value)

    def fit(self, name: str = "") -> None:
        """Fit all thresholds to the loaded recordings, or the number of a name; the table of successors stays."""
        if self.why_no_fit:
            self.error.emit(self.why_no_fit)
            return
        utterances, known, alone = self._utterances(), self._workbench.features, self._alone()
        what = tr("fit {what}").format(what=name or "PhonemeData")
        self.fitting.replace(
            lambda progress: _fitted(utterances, known, alone, name, progress),
            lambda found: self._take_fit(found, what),
        )

    def add_set(self, speaker: str) -> None:
        """Fit a pitch set to one speaker, around the pitch of the voice, and add it to the preset."""
        if self.why_no_fit:
            self.error.emit(self.why_no_fit)
            return
        utterances = tuple(u for u in self._workbench.utterances if u.speaker == speaker)
        alone = self._preset.preset.by_pitch[0]
        self.fitting.replace(
            lambda progress: fit_pitch_set(
                LabelledFeatures(utterances, alone, progress=subrange(progress, 0.0, 0.2)),
                alone,
                speaker,
                subrange(progress, 0.2, 1.0),
            ),
            self._take_set,
        )

    def add_file(self, path: Path) -> None:
        """Add a pitch set with the numbers of a PhonemeData file or preset; its range is all pitches at first."""
        try:
            data = load_preset(path).phoneme_data
        except EngineError as error:
            self.error.emit(str(error))
            return
        self._take_set(PitchSet(path.stem, LOWEST, HIGHEST, data))

    def set_range(self, low: float, high: float) -> None:
        """Change the range of the chosen pitch set, Hz; an impossible one is refused in a sentence."""
        pitch_set = self.chosen_set
        if pitch_set is not None:
            self._replace_set(lambda: replace(pitch_set, low=low, high=high), tr("change pitch range"))

    def remove_set(self) -> None:
        """Remove the chosen pitch set from the preset."""
        number, self.chosen = self.chosen, 0
        if number:
            kept = tuple(s for k, s in enumerate(self.sets, 1) if k != number)
            self._preset.end_edit()
            self._preset.edit(replace(self._preset.preset, pitch_sets=kept), tr("remove pitch set"))

    def close(self) -> None:
        """End all work."""
        for queue in (self.measuring, self.fitting):
            queue.close()

    # -- the work -----------------------------------------------------------------------------------------

    def _alone(self) -> Preset:
        """Return the preset with the numbers that are edited, and no sets."""
        own, pitch_set = replace(self._preset.preset, pitch_sets=()), self.chosen_set
        return own if pitch_set is None else own.with_phoneme_data(pitch_set.data)

    def _utterances(self) -> tuple[LabelledUtterance, ...]:
        """Return what the chosen numbers are fitted to: the recordings of the set's speaker, where there are some."""
        pitch_set = self.chosen_set
        mine = tuple(u for u in self._workbench.utterances if pitch_set is not None and u.speaker == pitch_set.name)
        return mine or self._workbench.utterances

    def _edit(self, change: Callable[[Preset], Preset], what: str) -> None:
        if self.chosen_set is not None:
            self._replace_set(
                lambda: replace(self.sets[self.chosen - 1], data=change(self._alone()).phoneme_data), what
            )
            return
        try:
            changed = change(self._preset.preset)
        except EngineError as error:
            self.error.emit(str(error))
            self.changed.emit()  # what was typed gives way to the number again
            return
        self._preset.end_edit()
        self._preset.edit(changed, what)

    def _replace_set(self, made: Callable[[], PitchSet], what: str) -> None:
        try:
            changed = made()
        except EngineError as error:
            self.error.emit(str(error))
            self.changed.emit()
            return
        sets = tuple(changed if k == self.chosen else s for k, s in enumerate(self.sets, 1))
        self._preset.end_edit()
        self._preset.edit(replace(self._preset.preset, pitch_sets=sets), what)

    def _take_fit(self, found: Fitted, what: str) -> None:
        preset, before, after = found
        gained = tr("Macro F1 on what is loaded: {before:.1%} → {after:.1%}").format(before=before, after=after)
        self.words = gained if after > before else tr("No better numbers were found.")
        data = preset.phoneme_data
        if data != self.data:
            self._edit(lambda alone: alone.with_phoneme_data(data), what)
        self.changed.emit()

    def _take_set(self, pitch_set: PitchSet) -> None:
        now = self._preset.preset
        self._preset.end_edit()
        self.chosen = len(now.pitch_sets) + 1
        what = tr("add pitch set {name}").format(name=pitch_set.name)
        self._preset.edit(replace(now, pitch_sets=(*now.pitch_sets, pitch_set)), what)
        self.words = tr("Added {name}, for a pitch of {low:.0f}–{high:.0f} Hz").format(
            name=pitch_set.name, low=pitch_set.low, high=pitch_set.high
        )
        self.changed.emit()

    def _follow(self) -> None:
        self.chosen = min(self.chosen, len(self.sets))  # undo may have taken the set away
        self.changed.emit()

    def _measure(self) -> None:
        features, alone = self._workbench.features, self._alone()
        if features is None:
            self.measuring.cancel()
            self._take_rows(number_rows(None))
            return
        utterances = self._workbench.utterances
        self.measuring.replace(lambda progress: _rows_of(utterances, features, alone, progress), self._take_rows)

    def _take_rows(self, rows: tuple[NumberRow, ...]) -> None:
        self.rows = rows
        self.changed.emit()


def _rows_of(
    utterances: tuple[LabelledUtterance, ...], known: LabelledFeatures, alone: Preset, progress: Progress
) -> tuple[NumberRow, ...]:
    """Return the rows as measured with the filters of the numbers that are edited."""
    features = known if not known.needs_measuring(alone) else LabelledFeatures(utterances, alone, progress=progress)
    return number_rows(features)


def _fitted(
    utterances: tuple[LabelledUtterance, ...],
    known: LabelledFeatures | None,
    alone: Preset,
    name: str,
    progress: Progress,
) -> Fitted:
    features = LabelledFeatures(utterances, alone, known=known, progress=subrange(progress, 0.0, 0.1))
    before, rest = features.confusion(alone).agreement.macro_f1, subrange(progress, 0.1, 1.0)
    if name:
        preset, after = fit_number(features, alone, name, rest)
    else:
        report = fit_preset(features, alone, rest, leave_out=False, keep_successors=True)
        preset, after = report.preset, report.after.macro_f1
    return preset, before, after
