"""The chosen variable: its choice, its least, mean and greatest values, and how it is spread over the phonemes."""

import math
from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QComboBox, QCompleter, QDialog, QFormLayout, QLineEdit, QMenu, QToolButton, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.courses import Courses
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import SCOPES, Scope
from phonemeanalyser.desktop.session.variable_study import Extremes, VariableStudy
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.builders import CANCEL, choice, dialog_buttons, label
from phonemeanalyser.desktop.widgets.distribution import DistributionView, phoneme_of_rule, short
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeanalyser.desktop.widgets.keyboard import KEYS
from phonemeengine.errors import EngineError
from phonemeengine.features.front_end import why_unmeasured
from phonemeengine.features.variables import Kind, Spectrum, Variable
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE

COLUMNS = (tr_noop("min"), tr_noop("mean"), tr_noop("max"))
OFFERED = (Scope.WHOLE, Scope.SEEN, Scope.SELECTION)
ROWS = {"seen": SCOPES[Scope.SEEN], "selection": SCOPES[Scope.SELECTION], "clear": tr_noop("Since Clear")}
NOTHING_SELECTED = tr_noop("Nothing is selected. Shift+drag over the file to select a segment.")
NOTHING_SAID = tr_noop("No certain label lies in this part of the recording.")
NOTHING_TO_SORT_BY = tr_noop("Without frames of {sounds}, the variables are not sorted by separation.")
NOTHING_MEASURED = tr_noop("Not measured yet: open a file, or play something.")


class VariablePanel(QWidget):
    """Everything about the variable whose course is drawn.

    Signals
    -------
    use_asked : the user wants to use the variable of this name in a rule, a new one for that phoneme.
    looked_for : a threshold of the variable was touched; it is to be seen.

    Attributes
    ----------
    variable : the box to choose it from, by what it measures; typing searches it.
    one, other : the phonemes by whose separation it is sorted.
    scope : of what the distribution is.
    values : buttons with the least, mean and greatest values by row and column; a click makes one a threshold.
    distribution : the variable by phoneme.
    use : asks to use it in a rule.
    study : what is known of the variable.
    """

    use_asked = Signal(str, object)
    looked_for = Signal()

    def __init__(self, session: Session, preset: PresetModel, courses: Courses, theme: Theme) -> None:
        super().__init__()
        courses.touched.connect(self.looked_for)
        self._session, self._preset, self._courses = session, preset, courses
        self.study = VariableStudy(session, courses)
        tip = tr("Variable whose course is drawn. Type to search; sorted by how well it separates the two phonemes.")
        self.variable = builders.choice((), tr("Variable"), tip)
        sounds = [(tr("–"), None), *((sound_name(phoneme), phoneme) for phoneme in KEYS)]
        self.one = builders.choice(
            sounds, tr("Phoneme to separate"), tr("Sort the variables by how well they separate this")
        )
        self.other = builders.choice(sounds, tr("Phoneme to separate it from"), tr("Phoneme to separate it from"))
        self.scope = builders.choice(
            ((tr(SCOPES[scope]), scope) for scope in OFFERED),
            tr("Part of the recording"),
            tr("Part of the recording whose phonemes are shown"),
        )
        self.about, self.phonemes = builders.label(wraps=True), builders.label(wraps=True)
        self.use = builders.tool_button(tr("Use in a Rule…"), tr("Add a condition with this variable to a rule"))
        self.values = {(name, k): self._value_button(name, k) for name in ROWS for k in range(len(COLUMNS))}
        self._numbers: dict[tuple[str, int], float] = {}
        self._listed: tuple[object, ...] = ()
        self._of = {name: builders.label(tr(words), theme.faint) for name, words in ROWS.items()}
        self.distribution = DistributionView(courses.lines, theme, narrow=True)
        self._lay_out()
        self._connect()
        self._list_variables()

    def refresh(self) -> None:
        """Show the values since Clear, and look at live sound again."""
        if not self.isVisible():
            return
        played = self.study.since_clear()
        self._show_row("clear", None if played is None else played[0])
        of = tr("Since Clear") if played is None else tr("Since Clear, {s:.1f} s").format(s=played[1])
        if of != self._of["clear"].text():
            self._of["clear"].setText(of)
        if self._session.whole.tracks is None:
            self.study.look()

    @override
    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.study.want(True)

    @override
    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self.study.want(False)

    # -- how it is laid out -------------------------------------------------------------------------------

    def _lay_out(self) -> None:
        self.variable.setEditable(True)
        self.variable.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
        self.variable.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.variable.setMinimumContentsLength(12)
        completer = QCompleter(self.variable.model(), self.variable)
        completer.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        completer.setFilterMode(Qt.MatchFlag.MatchContains)
        self.variable.setCompleter(completer)
        self.one.setCurrentIndex(self.one.findData(Phoneme.SZ))
        self.other.setCurrentIndex(self.other.findData(Phoneme.SCH))
        pair = builders.row(
            builders.label(tr("Separate")), (self.one, 1), builders.label(tr("from")), (self.other, 1), spacing=4
        )
        numbers = builders.grid(across=4, down=1)
        numbers.setColumnStretch(0, 1)
        for k, words in enumerate(COLUMNS):
            heading = builders.label(tr(words))
            heading.setContentsMargins(0, 0, 8, 0)  # above the letters of the buttons
            numbers.addWidget(heading, 0, k + 1, Qt.AlignmentFlag.AlignRight)
        for at, name in enumerate(ROWS, 1):
            numbers.addWidget(self._of[name], at, 0)
            for k in range(len(COLUMNS)):
                numbers.addWidget(self.values[name, k], at, k + 1, Qt.AlignmentFlag.AlignRight)
        self.use.clicked.connect(self._use)
        self.use.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        below = builders.row((self.phonemes, 1), self.scope, spacing=4)
        parts = (self.variable, pair, self.about, numbers, builders.row(self.use, 1), below, (self.distribution, 1))
        builders.column(*parts, on=self, margins=(6, 4, 6, 4), spacing=4)
        builders.leave_wheel(self)

    def _value_button(self, name: str, k: int) -> QToolButton:
        button = builders.tool_button("–", flat=True, act=partial(self._take, name, k))
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        return button

    def _connect(self) -> None:
        self.variable.activated.connect(lambda _k: self._choose())
        editor = self.variable.lineEdit()
        if editor is not None:
            editor.editingFinished.connect(self._show_chosen)  # what names no variable is no choice
        for box in (self.one, self.other, self.scope):
            box.currentIndexChanged.connect(lambda _k: self._ask())
        self._courses.changed.connect(self._show_courses)
        for act in (self._list_variables, self._show_trouble):
            self._preset.changed.connect(act)
        self.study.changed.connect(self._show_found)
        self._ask()
        for name in ROWS:
            self._show_row(name, None)

    # -- what is chosen -----------------------------------------------------------------------------------

    def _ask(self) -> None:
        one, other = self.one.currentData(), self.other.currentData()
        pair = None if one is None or other is None or one == other else (Phoneme(one), Phoneme(other))
        self.study.ask(Scope(self.scope.currentData()), pair)

    def _use(self) -> None:
        phoneme = phoneme_of_rule(self.study.found.distribution, self.one, self.other)
        self.use_asked.emit(self._courses.chosen, phoneme)

    def _choose(self) -> None:
        name = self.variable.currentData()
        if name is not None:
            self._courses.choose(str(name))

    def _list_variables(self) -> None:
        """Offer all variables, those first that separate the two phonemes best."""
        editor, own = self.variable.lineEdit(), self._preset.preset.variables
        if editor is not None and editor.hasFocus():
            return  # what is typed stays; the list is made anew when that is done
        if (shown := (own, self.study.found.separations, self._courses.chosen)) == self._listed:
            return
        self._listed = shown
        separations = dict(self.study.found.separations)
        names = [name for name, _ in self._preset.variable_names]
        if self._courses.chosen not in names:
            names.append(self._courses.chosen)  # a phoneme's deficit, beside whose sensitivity it stands
        order = {name: k for k, name in enumerate(separations)}
        names.sort(key=lambda name: order.get(name, len(order)))
        with builders.silent(self.variable):
            items = [(self._words_of(name, separations.get(name, math.nan)), name) for name in names]
            builders.offer(self.variable, items, self._courses.chosen)
        if editor is not None:
            editor.setCursorPosition(0)  # else the end of what is long is seen

    def _words_of(self, name: str, separation: float) -> str:
        words = self._courses.lines.words_of(name)
        parts = [words, *([name] if words != name else [])]
        return "  ·  ".join([*parts, *([] if math.isnan(separation) else [f"{separation:.0%}"])])

    def _show_chosen(self) -> None:
        self._list_variables()
        self.variable.setEditText(self.variable.itemText(self.variable.currentIndex()))

    def _show_courses(self) -> None:
        if self.variable.currentData() != self._courses.chosen:
            self._list_variables()
        self.distribution.show_lines()
        self.distribution.choose_line(self._courses.control)
        can_take = bool(self._courses.lines.lines_of(self._courses.chosen))
        for button in self.values.values():
            button.setEnabled(can_take)
        self._show_trouble()

    def _show_trouble(self) -> None:
        """Say why the variable reads nothing, or why the variables are not sorted, where that is so."""
        settings, mine, found = self._preset.in_force.settings, self._preset.preset.variables, self.study.found
        words = tr_engine(why_unmeasured(self._courses.chosen, settings, mine))
        spreads = () if found.distribution is None else found.distribution.spreads
        lacking = [sound_name(p) for p in self.study.pair or () if p not in spreads]
        if spreads and found.known == 1 and lacking and not words:
            words = tr(NOTHING_TO_SORT_BY).format(sounds=", ".join(lacking))
        self.about.setText(words)
        self.about.setVisible(bool(self.about.text()))

    # -- what is found ------------------------------------------------------------------------------------

    def _show_found(self) -> None:
        found = self.study.found
        self._show_row("seen", found.seen)
        self._show_row("selection", found.selection)
        said = tr("Phonemes of the labels") if found.by_labels else tr("Phonemes as recognised")
        if found.known < 1:
            said = tr("{what}; {percent:.0f} % measured").format(what=said, percent=100 * found.known)
        self.phonemes.setText(said)
        empty = NOTHING_SAID if found.by_labels and found.known > 0 else NOTHING_MEASURED
        nothing_selected = self.study.scope is Scope.SELECTION and self._session.view.selection is None
        self.distribution.show_distribution(found.distribution, tr(NOTHING_SELECTED if nothing_selected else empty))
        self.distribution.choose_line(self._courses.control)
        self._list_variables()
        self._show_trouble()

    def _show_row(self, name: str, extremes: Extremes | None) -> None:
        variable = self._courses.lines.words_of(self._courses.chosen)
        for k, column_name in enumerate(COLUMNS):
            button = self.values[name, k]
            text = "–" if extremes is None else short(extremes[k])
            if extremes is None:
                self._numbers.pop((name, k), None)
            else:
                self._numbers[name, k] = extremes[k]
            told = f"{variable} · {tr(ROWS[name])} · {tr(column_name)}: {text}"
            if told != button.accessibleName():
                button.setText(text)
                button.setAccessibleName(told)
                button.setToolTip(
                    f"<p>{told}</p><p>{tr('Click: make it the value of a threshold of this variable')}</p>"
                )

    def _take(self, name: str, k: int) -> None:
        """Make a value that of the threshold that was touched, of the only one, or of one that is asked for."""
        value = self._numbers.get((name, k))
        lines = {line.name: line for line in self._courses.lines.lines_of(self._courses.chosen)}
        if value is None or not lines:
            return
        if self._courses.control in lines or len(lines) == 1:
            self._set(self._courses.control if self._courses.control in lines else next(iter(lines)), value)
            return
        button = self.values[name, k]
        menu = QMenu(button)
        for line in lines.values():
            menu.addAction(f"{tr_engine(line.label)}  {short(line.value)}", partial(self._set, line.name, value))
        menu.aboutToHide.connect(menu.deleteLater)
        menu.popup(button.mapToGlobal(QPoint(0, button.height())))

    def _set(self, name: str, value: float) -> None:
        self._preset.end_edit()
        self._courses.lines.move(name, value)
        self._courses.lines.end_move()


SOURCES = {
    Spectrum.NORMALISED: tr_noop("After all filters"),
    Spectrum.FILTERED: tr_noop("After smoothing, high-pass and low-pass"),
    Spectrum.RAW: tr_noop("Before all spectral filters"),
    Spectrum.MEL: tr_noop("Mel filter bank"),
}


class VariableDialog(QDialog):
    """Name, range, kind and spectrum of a new variable; stays, and says why, while it cannot be added.

    Parameters
    ----------
    low, high : the range to begin with, Hz.
    add : adds the variable, or raises EngineError.
    """

    def __init__(self, low: float, high: float, add: Callable[[Variable], object], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("New Variable"))
        self._add = add
        self.name, self.trouble = QLineEdit(), label(wraps=True)
        self.low, self.high = (NumberField(0, SAMPLE_RATE / 2, decimals=1, unit=" Hz") for _ in range(2))
        self.kind = choice((tr(kind.value), kind) for kind in Kind)
        self.source = choice((tr(words), source) for source, words in SOURCES.items())
        self._fill(low, high)
        form = QFormLayout(self)
        form.addRow(tr("Name"), self.name)
        form.addRow(self.trouble)
        form.addRow(tr("From"), self.low)
        form.addRow(tr("To"), self.high)
        form.addRow(tr("Measure"), self.kind)
        form.addRow(tr("Spectrum"), self.source)
        form.addRow(dialog_buttons(self, CANCEL, verb=tr("Add")))

    def variable(self) -> Variable:
        """Return what was asked for; SettingsError where it is impossible."""
        kind, source = Kind(self.kind.currentData()), Spectrum(self.source.currentData())
        return Variable(self.name.text().strip().lower(), self.low.value(), self.high.value(), kind, source)

    @override
    def accept(self) -> None:
        """Add the variable; where that is refused, say why and keep what was entered."""
        try:
            self._add(self.variable())
        except EngineError as error:
            self.trouble.setText(tr_engine(str(error)))
            self.trouble.show()
            self.resize(self.width(), self.heightForWidth(self.width()))
            self.name.setFocus()
            self.name.selectAll()
        else:
            super().accept()

    def _fill(self, low: float, high: float) -> None:
        self.name.setPlaceholderText(tr("a-z, 0-9 and _, such as my_hiss"))
        self.name.textEdited.connect(self.trouble.hide)
        self.trouble.setTextFormat(Qt.TextFormat.PlainText)
        self.trouble.hide()
        for box, value in ((self.low, low), (self.high, high)):
            box.setValue(value)
