"""The variables, ranked by how well they separate the sounds, and the search for better ones."""

import math

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QAbstractItemView, QGridLayout, QPushButton, QTableWidget, QTableWidgetItem, QWidget

from phonemeanalyser.desktop.calibrate.workbench.workbench_model import WorkbenchModel
from phonemeanalyser.desktop.engine_words import recogniser_title, sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import choice, column, label, named, silent, style_list, tab_buttons
from phonemeanalyser.desktop.widgets.distribution import phoneme_of_rule
from phonemeanalyser.desktop.widgets.keyboard import KEYS
from phonemeanalyser.desktop.widgets.plot import let_copy
from phonemeengine.calibration.fits.suggestions import Suggestion
from phonemeengine.features.variables import Variable, readable_name
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.spec import spec_of

NAME = Qt.ItemDataRole.UserRole


ACTS = tr_noop("It takes effect once a rule of the preset uses it.")
NO_ACT = tr_noop(
    "The recogniser {name} cannot use custom variables: this one would be measured and drawn, but would not change "
    "any phoneme. A preset with rules of its own can use it."
)


class VariablesPanel(QWidget):
    """Chooses the variable that is shown, and suggests others for a pair of sounds.

    Signals
    -------
    add_asked : a `Variable` that the user wants to have.
    use_asked : the user wants to use the variable of this name in a rule, a new one for that phoneme.
    """

    add_asked = Signal(Variable)
    use_asked = Signal(str, object)

    def __init__(self, workbench: WorkbenchModel, theme: Theme) -> None:
        super().__init__()
        self._workbench = workbench
        self._theme = theme
        self.table = named(
            QTableWidget(0, 2),
            tr("Variables"),
            tr(
                "Separation: probability that a threshold tells two frames of different phonemes apart; 50 % is "
                "chance level"
            ),
        )
        sounds = [(sound_name(phoneme), phoneme) for phoneme in KEYS]
        told_apart, other = tr("Phoneme to separate"), tr("Phoneme to separate it from, or all others")
        self.one = choice(sounds, told_apart, told_apart)
        self.other = choice([*sounds, (tr("all others"), None)], other, other)
        self.search = named(
            QPushButton(tr("Suggest")), tip=tr("Search for the frequency ranges that separate the two phonemes best")
        )
        self.add = named(
            QPushButton(tr("Add")), tip=tr("Add the suggested variable to the preset; Ctrl+Z removes it")
        )
        self.use = named(
            QPushButton(tr("Use in a Rule…")),
            tip=tr("Add a condition with this variable to a rule; the limit that gains most is proposed"),
        )
        self.words = label(wraps=True)
        self._lay_out()
        self._connect()
        self._fill()

    def _lay_out(self) -> None:
        self.setMinimumWidth(236)
        self.setMaximumWidth(340)
        self.table.setHorizontalHeaderLabels([tr("Variable"), tr("Separation")])
        let_copy(self.table)
        style_list(self.table, 20, (0, 68))
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.table.setWordWrap(False)
        self.one.setCurrentIndex(self.one.findData(Phoneme.SZ))
        self.other.setCurrentIndex(self.other.findData(Phoneme.SCH))
        tab_buttons(self.search, self.add, self.use)
        pair = QGridLayout()
        pair.setSpacing(4)
        for k, widget in enumerate((label(tr("Separate")), self.one, label(tr("from")), self.other)):
            pair.addWidget(widget, 0, k)
        pair.setColumnStretch(1, 1)
        pair.setColumnStretch(3, 1)
        pair.addWidget(self.search, 1, 0, 1, 2)
        pair.addWidget(self.add, 1, 2, 1, 2)
        pair.addWidget(self.use, 2, 0, 1, 4)
        self.words.setVisible(False)
        column((self.table, 1), pair, self.words, on=self, margins=(6, 4, 4, 4), spacing=4)

    def _connect(self) -> None:
        self.table.currentCellChanged.connect(self._choose)
        self.search.clicked.connect(self._search)
        self.add.clicked.connect(self._add)
        self.use.clicked.connect(self._use)
        self._workbench.distribution_changed.connect(self._fill)
        self._workbench.suggested.connect(self._fill)
        self._workbench.searching.changed.connect(self._show_search)
        self._workbench.confusion_changed.connect(self._tell)  # the recogniser may be another

    def _use(self) -> None:
        phoneme = phoneme_of_rule(self._workbench.distribution, self.one, self.other)
        self.use_asked.emit(self._workbench.variable, phoneme)

    def _fill(self) -> None:
        own = self._workbench.own_variables
        ranked = [
            (r.variable, _name_of(r.variable, own), r.separation, f"{_name_of(r.variable, own)} ({r.variable})")
            for r in self._workbench.ranking
        ]
        have = {name for name, *_ in ranked}
        suggested = [
            (
                s.variable.name,
                f"+ {_name_of(s.variable.name, (*own, s.variable))}",
                s.separation,
                f"{_words_of(s)} ({s.variable.name})",
            )
            for s in self._workbench.suggestions
            if s.variable.name not in have
        ]
        rows = [*suggested, *ranked]
        with silent(self.table):
            self.table.setRowCount(len(rows))
            for row, (name, text, separation, words) in enumerate(rows):
                new = row < len(suggested)
                items = (
                    QTableWidgetItem(text),
                    QTableWidgetItem("–" if math.isnan(separation) else f"{separation:.0%}"),
                )
                items[1].setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                for column, item in enumerate(items):
                    item.setData(NAME, name)
                    item.setToolTip(words)
                    item.setForeground(QColor(self._theme.accent if new else self._theme.text))
                    self.table.setItem(row, column, item)
                preview = self._workbench.preview
                if name == (self._workbench.variable if preview is None else preview.variable.name):
                    self.table.setCurrentCell(row, 0)
        self._show_add()

    def _choose(self, row: int, _column: int, old: int, _old_column: int) -> None:
        item = self.table.item(row, 0)
        if item is None or row == old:
            return
        suggestion = self._suggested()
        if suggestion is None:
            self._workbench.choose(str(item.data(NAME)))
        else:
            self._workbench.look_at(suggestion)
        self._show_add()

    def _show_search(self) -> None:
        searching = self._workbench.searching
        self.search.setText(
            tr("Stop {percent:.0f} %").format(percent=100 * searching.progress) if searching.busy else tr("Suggest")
        )

    def _search(self) -> None:
        if self._workbench.searching.busy:
            self._workbench.searching.cancel()
        else:
            self._workbench.suggest(Phoneme(self.one.currentData()), self.other.currentData())

    def _add(self) -> None:
        suggestion = self._suggested()
        if suggestion is not None:
            self.add_asked.emit(suggestion.variable)

    def _suggested(self) -> Suggestion | None:
        """Return the suggestion that is chosen; None where it is a variable that there is."""
        item = self.table.item(self.table.currentRow(), 0)
        name = item.data(NAME) if item is not None else ""
        have = {r.variable for r in self._workbench.ranking}
        return next((s for s in self._workbench.suggestions if s.variable.name == name and name not in have), None)

    def _show_add(self) -> None:
        self.add.setEnabled(self._suggested() is not None)
        self.use.setEnabled(self._suggested() is None)
        self._tell()

    def _tell(self) -> None:
        """Say what the suggestion that is chosen measures, and whether it can act."""
        suggestion, name = self._suggested(), self._workbench.recogniser
        self.words.setVisible(suggestion is not None)
        if suggestion is not None:
            acts = spec_of(name).uses_own_variables
            colour = self._theme.faint if acts else self._theme.bad
            note = tr(ACTS) if acts else tr(NO_ACT).format(name=recogniser_title(name))
            words = _words_of(suggestion)
            self.words.setText(f"{words[:1].upper()}{words[1:]}.<br><span style='color:{colour}'>{note}</span>")


def _name_of(name: str, own: tuple[Variable, ...]) -> str:
    return tr_engine(readable_name(name, own))


def _words_of(suggestion: Suggestion) -> str:
    variable = suggestion.variable
    return tr("{kind} over {low:.0f}–{high:.0f} Hz of the {source} spectrum; separation {separation:.0%}").format(
        kind=tr(variable.kind.value),
        low=variable.low,
        high=variable.high,
        source=tr(variable.source.value),
        separation=suggestion.separation,
    )
