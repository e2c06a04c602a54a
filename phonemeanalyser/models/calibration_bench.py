"""The workbench of the takes and recordings at hand: measured in the background, asked at once."""

from dataclasses import replace

import numpy as np
from PySide6.QtCore import Signal

from engine.calibration.bench.distributions import Distribution, RankedVariable, distribution_of, ranked_variables
from engine.calibration.bench.workbench import Workbench
from engine.calibration.fits.suggestions import Suggestion, suggested_variables
from engine.calibration.heed import Heed
from engine.calibration.scores.confusion import Confusion, Passage
from engine.calibration.scores.corpus import Utterance
from engine.errors import EngineError
from engine.features.variables import Variable
from engine.phonemes import Phoneme
from engine.recognition.rules import CONDITIONS
from phonemeanalyser.models.preset import PresetModel
from phonemeanalyser.models.workplace import Workplace

Pair = tuple[Phoneme, Phoneme | None]


class Line:
    """A threshold that is drawn into a distribution, and can be moved.

    Attributes
    ----------
    name : what it is called.
    sign : the comparison with it, ``<`` or ``>``.
    value : where it lies.
    """

    def __init__(self, name: str, sign: str, value: float, *, is_limit: bool) -> None:
        self.name, self.sign, self.value, self.is_limit = name, sign, value, is_limit


class BenchModel(Workplace):
    """Measures what is loaded, and follows the preset: what a threshold changes is known at the next `see`.

    It is busy while recordings are being measured.

    Signals
    -------
    measured : another workbench is there, or none.
    confusion_changed : the answers are others.
    distribution_changed : the distribution of the chosen variable, or the ranking, is another.
    suggested : variables were found that are worth adding, or none.
    """

    measured = Signal()
    confusion_changed = Signal()
    distribution_changed = Signal()
    suggested = Signal()

    def __init__(self, preset: PresetModel) -> None:
        super().__init__()
        self.workbench: Workbench | None = None
        self.confusion: Confusion | None = None
        self.distribution: Distribution | None = None
        self.ranking: tuple[RankedVariable, ...] = ()
        self.suggestions: tuple[Suggestion, ...] = ()
        self.preview: Suggestion | None = None
        self.variable = "m_szsch1"
        self._preset = preset
        self._utterances: tuple[Utterance, ...] = ()
        self._stale = False
        self._measuring, self._looking, self._searching = self._room(), self._room(), self._room()
        preset.changed.connect(self._follow_preset)

    # -- what there is ------------------------------------------------------------------------------------

    @property
    def searching(self) -> bool:
        """Whether variables are being searched for."""
        return self._searching.busy

    @property
    def search_share(self) -> float:
        """How much of the search is done, 0..1."""
        return self._searching.share

    @property
    def utterances(self) -> tuple[Utterance, ...]:
        """The recordings that are measured, or are being."""
        return self._utterances

    @property
    def shown(self) -> Distribution | None:
        """The distribution of the suggestion that is looked at, or of the chosen variable."""
        return self.distribution if self.preview is None else self.preview.distribution

    @property
    def own_variables(self) -> tuple[Variable, ...]:
        """The user's own variables."""
        return self._preset.preset.variables

    @property
    def recogniser(self) -> str:
        """The name of the recogniser in use."""
        return self._preset.preset.recogniser

    def lines(self) -> list[Line]:
        """Give the thresholds of the preset on the chosen variable; a suggestion has none yet."""
        preset = self._preset.preset
        if self.preview is not None:
            return []
        if preset.recogniser == "rules":
            found = {
                (c.limit, c.sign): Line("limit", c.sign, c.limit, is_limit=True)
                for rule in preset.rules
                for c in rule.conditions
                if c.variable == self.variable and not c.threshold
            }
            return list({value: line for (value, _), line in found.items()}.values())
        used = self._preset.used_thresholds
        conditions = {c.threshold: c for c in CONDITIONS if c.variable == self.variable and c.threshold in used}
        return [
            Line(name, c.sign, float(getattr(preset.thresholds, name)), is_limit=False)
            for name, c in conditions.items()
        ]

    def move(self, line: Line, value: float) -> None:
        """Move a threshold, of the thesis rules or of the preset's own."""
        value = float(f"{value:.4g}")
        if not line.is_limit:
            self._preset.set_threshold(line.name, value)
            return
        preset, old = self._preset.preset, line.value
        rules = tuple(
            replace(
                rule,
                conditions=tuple(
                    replace(c, limit=value) if (c.variable, c.threshold, c.limit) == (self.variable, "", old) else c
                    for c in rule.conditions
                ),
            )
            for rule in preset.rules
        )
        line.value = value
        self._preset.edit(replace(preset, rules=rules), f"change of a limit of {self.variable}")

    def end_move(self) -> None:
        """End a drag: undo takes it back as a whole."""
        self._preset.end_edit()

    def passages(self, truth: Phoneme, answer: Phoneme) -> list[Passage]:
        """Give the stretches of a cell of the confusion matrix, the longest first."""
        found = self.confusion.frames_in(truth, answer) if self.confusion else ()
        return sorted(found, key=lambda p: p.start - p.end)

    # -- what is asked ------------------------------------------------------------------------------------

    def load(self, utterances: tuple[Utterance, ...]) -> None:
        """Measure these recordings; what was measured before is not measured again."""
        self._utterances = utterances
        self._measure()

    def choose(self, variable: str) -> None:
        """Show the distribution of another variable."""
        self.variable, self.preview = variable, None
        self._look()

    def look_at(self, suggestion: Suggestion | None) -> None:
        """Show the distribution of a variable that is suggested, before it is added."""
        self.preview = suggestion
        self.distribution_changed.emit()

    def suggest(self, one: Phoneme, other: Phoneme | None) -> None:
        """Search for variables that part two phonemes, or one from all others."""
        bench, preset = self.workbench, self._preset.in_force
        if bench is None:
            self.failed.emit("There is nothing to search in yet; record takes or load labelled recordings first.")
            return
        self._searching.instead(
            lambda heed: suggested_variables(bench, preset, one, other, heed), self._take_suggestions
        )

    def cancel_search(self) -> None:
        """End the search for variables."""
        self._searching.cancel()

    def see(self) -> None:
        """Take note of what was measured, and answer anew where the preset is another."""
        super().see()
        if self._stale:
            self._stale = False
            self._answer()

    # -- the work -----------------------------------------------------------------------------------------

    def _follow_preset(self) -> None:
        if self.workbench is not None and self._must_measure():
            self._measure()
        self._stale = True

    def _must_measure(self) -> bool:
        try:
            return self.workbench is not None and self.workbench.needs_measuring(self._preset.in_force)
        except EngineError:
            return False

    def _measure(self) -> None:
        utterances, preset, known = self._utterances, self._preset.in_force, self.workbench
        if not utterances:
            self._measuring.cancel()
            self._take_up(None)
            return
        self._measuring.instead(lambda heed: Workbench(utterances, preset, known=known, heed=heed), self._take_up)

    def _take_up(self, workbench: Workbench | None) -> None:
        self.workbench = workbench
        if self.preview is not None and (workbench is None or self.preview.variable.name in workbench.variables):
            self.variable, self.preview = self.preview.variable.name, None
        self._stale = True
        self.measured.emit()
        self._look()

    def _answer(self) -> None:
        if self.workbench is None:
            self.confusion = None
        elif self._must_measure():
            return
        else:
            try:
                self.confusion = self.workbench.confusion(self._preset.in_force)
            except EngineError as error:
                self.failed.emit(str(error))
                return
        self.confusion_changed.emit()

    def _look(self) -> None:
        bench, variable = self.workbench, self.variable
        if bench is None or not bool(np.any(bench.labels.certain)):
            self.distribution, self.ranking = None, ()
            self.distribution_changed.emit()
            return
        if variable not in bench.variables:
            variable = self.variable = bench.variables[0]
        ranking = self.ranking if self._ranked_for is bench else ()
        self._looking.instead(
            lambda heed: _looked_at(bench, variable, ranking, heed), lambda found: self._take_look(bench, found)
        )

    _ranked_for: Workbench | None = None

    def _take_look(self, bench: Workbench, found: tuple[Distribution, tuple[RankedVariable, ...]]) -> None:
        self.distribution, self.ranking = found
        self._ranked_for = bench
        self.distribution_changed.emit()

    def _take_suggestions(self, suggestions: tuple[Suggestion, ...]) -> None:
        self.suggestions = suggestions
        self.look_at(suggestions[0] if suggestions else None)
        self.suggested.emit()
        if not suggestions:
            self.failed.emit("No frequency range parts these two; record more takes of them, or choose another pair.")


def _looked_at(
    bench: Workbench, variable: str, ranking: tuple[RankedVariable, ...], heed: Heed
) -> tuple[Distribution, tuple[RankedVariable, ...]]:
    return distribution_of(bench, variable), ranking or ranked_variables(bench, heed=heed)
