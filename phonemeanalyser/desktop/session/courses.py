"""Which variables' courses are drawn, and the thresholds in them, which can be dragged."""

from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.session.preset import USUAL_VARIABLE, PresetModel
from phonemeengine.features.variables import Variable, readable_name, unit_of
from phonemeengine.presets.controls import asked_in_words, variables_with

MOST_COURSES = 8
"""Variables whose courses are drawn at once at most: the comparisons of the longest factory rule."""
DIGITS = 4
"""Digits that count of a threshold that is dragged."""


@dataclass(frozen=True)
class ThresholdLine:
    """A threshold that is drawn beside the values of its variable, and can be moved.

    Attributes
    ----------
    name : the control's.
    label : what it is called where it is drawn.
    sign : the comparison with it, ``<`` or ``>``.
    value : where it lies.
    """

    name: str
    label: str
    sign: str
    value: float


class ThresholdLines:
    """The thresholds of the preset in use by the variables that are compared with them.

    Attributes
    ----------
    suggested : variables that the preset does not have, and that are shown for a choice.
    """

    def __init__(self, preset: PresetModel) -> None:
        self._preset = preset
        self.suggested: tuple[Variable, ...] = ()

    def lines_of(self, variable: str) -> list[ThresholdLine]:
        """Return what tunes the recogniser on a variable."""
        preset = self._preset.preset
        mine = (c for c in self._preset.controls.values() if c.variable == variable)
        return [ThresholdLine(c.name, asked_in_words(preset, c), c.sign, c.read(preset)) for c in mine]

    def move(self, name: str, value: float) -> None:
        """Move a threshold, a limit or a sensitivity."""
        self._preset.tune(name, float(f"{value:.{DIGITS}g}"))

    def end_move(self) -> None:
        """End a drag: undo takes it back as a whole."""
        self._preset.end_edit()

    def words_of(self, variable: str) -> str:
        """Return what a variable measures, in words."""
        return tr_engine(readable_name(variable, (*self._preset.preset.variables, *self.suggested)))

    def unit_of(self, variable: str) -> str:
        """Return the unit of a variable."""
        return unit_of(variable, self._preset.preset.variables)


class Courses(QObject):
    """Holds the variables that are drawn over time: one that was chosen, or all that a threshold is judged with.

    Signals
    -------
    changed : other variables are drawn, or their thresholds have other values.
    touched : a threshold was touched.

    Attributes
    ----------
    lines : the thresholds of each.
    variables : those that are drawn, the chosen one first.
    n_more : how many more are judged with the threshold than are drawn.
    control : the control that was touched last; empty where a variable was chosen since.
    live_seconds : how much is seen of live sound.
    """

    changed = Signal()
    touched = Signal()

    def __init__(self, preset: PresetModel) -> None:
        super().__init__()
        self.lines = ThresholdLines(preset)
        self.variables: tuple[str, ...] = (USUAL_VARIABLE,)
        self.n_more = 0
        self.control = ""
        self.live_seconds = 0.0
        self._preset = preset
        preset.replaced.connect(self._follow_preset)

    @property
    def chosen(self) -> str:
        """The variable that was chosen, or that is compared with the threshold that was touched."""
        return self.variables[0]

    def choose(self, variable: str) -> None:
        """Draw a variable by itself."""
        if (variable, "") != (self.chosen, self.control) or len(self.variables) > 1:
            self._draw((variable,), "")

    def touch(self, name: str) -> None:
        """Draw the variable of a control, and all that are judged with it; nothing where it has none."""
        if name not in self._preset.controls or not self._preset.controls[name].variable:
            return
        if name != self.control:
            self._draw(variables_with(self._preset.preset, self._preset.controls[name]), name)
        self.touched.emit()

    def drag(self, name: str, value: float) -> None:
        """Touch a threshold, and move it; `end_move` of the lines ends the drag."""
        if name != self.control:
            self.touch(name)
        self.lines.move(name, value)

    def _draw(self, variables: tuple[str, ...], control: str) -> None:
        self.variables, self.control = variables[:MOST_COURSES], control
        self.n_more = len(variables) - len(self.variables)
        self.changed.emit()

    def _follow_preset(self) -> None:
        """Go back to the usual variable where the preset measures those that are drawn no longer."""
        controls = self._preset.controls
        known = {name for name, _ in self._preset.variable_names} | {c.variable for c in controls.values()}
        if not known.issuperset(self.variables) or (self.control and self.control not in controls):
            self.variables = (self.chosen if self.chosen in known else USUAL_VARIABLE,)
            self.control, self.n_more = "", 0
        self.changed.emit()
