"""Asks for a variable of the user's own."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QFormLayout, QLineEdit, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.widgets.builders import CANCEL, choice, dialog_buttons, label
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeengine.errors import EngineError
from phonemeengine.features.variables import Kind, Spectrum, Variable
from phonemeengine.settings import SAMPLE_RATE

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
