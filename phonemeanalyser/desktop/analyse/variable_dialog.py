"""Asks for a variable of the user's own."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QDialog, QDialogButtonBox, QFormLayout, QLabel, QLineEdit, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.widgets.number_field import NumberField
from phonemeengine.errors import EngineError
from phonemeengine.features.variables import Kind, Spectrum, Variable
from phonemeengine.settings import SAMPLE_RATE

SOURCES = {
    Spectrum.NORMALISED: tr_noop("after all filters"),
    Spectrum.FILTERED: tr_noop("after smoothing and pass filters"),
    Spectrum.RAW: tr_noop("before all filters of the spectrum"),
    Spectrum.MEL: tr_noop("through the mel bank"),
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
        self.setWindowTitle(tr("New variable"))
        self._add = add
        self.name, self.trouble = QLineEdit(), QLabel()
        self.low, self.high = NumberField(), NumberField()
        self.kind, self.source = QComboBox(), QComboBox()
        self._fill(low, high)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        form = QFormLayout(self)
        form.addRow(tr("name"), self.name)
        form.addRow(self.trouble)
        form.addRow(tr("from"), self.low)
        form.addRow(tr("to"), self.high)
        form.addRow(tr("kind"), self.kind)
        form.addRow(tr("spectrum"), self.source)
        form.addRow(buttons)

    def variable(self) -> Variable:
        """Return what was asked for; SettingsError where it is impossible."""
        kind, source = Kind(self.kind.currentData()), Spectrum(self.source.currentData())
        return Variable(self.name.text().strip().lower(), self.low.value(), self.high.value(), kind, source)

    def accept(self) -> None:
        """Add the variable; where that is refused, say why and keep what was entered."""
        try:
            self._add(self.variable())
        except EngineError as error:
            self.trouble.setText(str(error))
            self.trouble.show()
            self.name.setFocus()
            self.name.selectAll()
        else:
            super().accept()

    def _fill(self, low: float, high: float) -> None:
        self.name.setPlaceholderText(tr("a-z, 0-9, _, such as my_hiss"))
        self.name.textEdited.connect(self.trouble.hide)
        self.trouble.setTextFormat(Qt.TextFormat.PlainText)
        self.trouble.setWordWrap(True)
        self.trouble.hide()
        for box, value in ((self.low, low), (self.high, high)):
            box.setRange(0, SAMPLE_RATE / 2)
            box.setDecimals(1)
            box.setSuffix(" Hz")
            box.setValue(value)
        for kind in Kind:
            self.kind.addItem(tr(kind.value), kind)
        for source, words in SOURCES.items():
            self.source.addItem(tr(words), source)
