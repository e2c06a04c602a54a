"""Which recogniser names the phonemes: one of the program's own, or one of another package."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSizePolicy, QWidget

from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeengine.recognition.spec import recogniser_names


class RecogniserChoice(QWidget):
    """Offers all recognisers that are installed, and shows the preset's.

    Signals
    -------
    chosen : name of the recogniser that the user wants.
    """

    chosen = Signal(str)

    def __init__(self, preset: PresetModel) -> None:
        super().__init__()
        self._preset = preset
        self.names = QComboBox()
        self.names.addItems(recogniser_names())
        self.names.setAccessibleName("recogniser")
        self.names.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.names.setToolTip(
            "<p>What names the phoneme of each frame. Another one brings the front end and the numbers that it was "
            "tuned with, unless you tuned it yourself. What it is tuned by is below.</p><p>To add one, install its "
            "package beside this program, and start the program again. How to write one is in the README.</p>"
        )
        self._lay_out()
        self.names.activated.connect(self._choose)
        preset.changed.connect(self._show_preset)
        self._show_preset()

    def _lay_out(self) -> None:
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 4, 8, 2)
        label = QLabel("Recogniser")
        label.setBuddy(self.names)
        row.addWidget(label)
        row.addWidget(self.names, 1)

    def _choose(self, index: int) -> None:
        self.chosen.emit(self.names.itemText(index))
        self._show_preset()  # where it was refused, the old one is in use still

    def _show_preset(self) -> None:
        name = self._preset.preset.recogniser
        self.names.setCurrentIndex(
            self.names.findText(name, Qt.MatchFlag.MatchExactly | Qt.MatchFlag.MatchCaseSensitive)
        )
