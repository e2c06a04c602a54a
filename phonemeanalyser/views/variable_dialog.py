"""Asks for a variable of the user's own."""

from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QDoubleSpinBox,
    QFormLayout,
    QLineEdit,
    QWidget,
)

from engine.features.variables import Kind, Spectrum, Variable
from engine.settings import SAMPLE_RATE

SOURCES = {
    Spectrum.NORMALISED: "after all filters",
    Spectrum.FILTERED: "after smoothing and pass filters",
    Spectrum.RAW: "before all filters of the spectrum",
    Spectrum.MEL: "through the mel bank",
}


class VariableDialog(QDialog):
    """Name, range, kind and spectrum of a new variable; begins with a range in Hz."""

    def __init__(self, low: float, high: float, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle("New variable")
        self.name = QLineEdit()
        self.low, self.high = QDoubleSpinBox(), QDoubleSpinBox()
        self.kind, self.source = QComboBox(), QComboBox()
        self._fill(low, high)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        form = QFormLayout(self)
        form.addRow("name", self.name)
        form.addRow("from", self.low)
        form.addRow("to", self.high)
        form.addRow("kind", self.kind)
        form.addRow("spectrum", self.source)
        form.addRow(buttons)

    def variable(self) -> Variable:
        """Give what was asked for; SettingsError where it is impossible."""
        kind, source = Kind(self.kind.currentData()), Spectrum(self.source.currentData())
        return Variable(self.name.text().strip().lower(), self.low.value(), self.high.value(), kind, source)

    def _fill(self, low: float, high: float) -> None:
        self.name.setPlaceholderText("a-z, 0-9, _, such as my_hiss")
        for box, value in ((self.low, low), (self.high, high)):
            box.setRange(0, SAMPLE_RATE / 2)
            box.setDecimals(1)
            box.setSuffix(" Hz")
            box.setValue(value)
        for kind in Kind:
            self.kind.addItem(kind.value, kind)
        for source, words in SOURCES.items():
            self.source.addItem(words, source)
