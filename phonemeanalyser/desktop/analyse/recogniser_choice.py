"""Which recogniser names the phonemes, one of the program's own or of another package, and what hears files."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSizePolicy, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeengine.presets.ears import has_ear, offered_ear
from phonemeengine.recognition.spec import recogniser_names
from phonemeengine.settings import Ear

NAMES_WIDTH = 86
"""Pixels that the recogniser's name has at least."""
EARS = {Ear.LIVE: tr_noop("live"), Ear.TWIN: tr_noop("twin"), Ear.WHISPER: "Whisper"}


class RecogniserChoice(QWidget):
    """Offers all recognisers that are installed, and the ears for files, and shows the preset's.

    Signals
    -------
    chosen : name of the recogniser that the user wants.
    ear_chosen : the `Ear` that the user wants files to be heard with.
    """

    chosen = Signal(str)
    ear_chosen = Signal(object)

    def __init__(self, preset: PresetModel) -> None:
        super().__init__()
        self._preset = preset
        self.names = QComboBox()
        self.names.addItems(recogniser_names())
        self.names.setAccessibleName(tr("recogniser"))
        self.names.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.names.setMinimumWidth(NAMES_WIDTH)
        self.names.setToolTip(
            tr(
                "<p>What names the phoneme of each frame. Another one brings the front end and the numbers that it "
                "was tuned with, unless you tuned it yourself. What it is tuned by is below.</p><p>To add one, "
                "install its package beside this program, and start the program again. How to write one is in the "
                "README.</p>"
            )
        )
        self.ears = QComboBox()
        self.ears.addItems([*map(tr, EARS.values())])
        self.ears.setAccessibleName(tr("ear for files"))
        self.ears.setToolTip(
            tr(
                "<p>The best that files are heard with. <i>live</i>: as a microphone. <i>twin</i>: by a network that "
                "hears half a second ahead. <i>Whisper</i>: with a speech encoder besides, where all of a file is "
                "recognised at once: saved, exported or aligned with its text; while it plays, the twin serves.</p>"
                "<p>What is grey is not there; <i>File &gt; Speech Encoder…</i> gets Whisper.</p>"
            )
        )
        self._lay_out()
        self.names.activated.connect(self._choose)
        self.ears.activated.connect(self._choose_ear)
        preset.changed.connect(self._show_preset)
        self._show_preset()

    def _lay_out(self) -> None:
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 4, 8, 2)
        label = QLabel(tr("Recogniser"))
        label.setBuddy(self.names)
        row.addWidget(label)
        row.addWidget(self.names, 1)
        files = QLabel(tr("Files"))
        files.setBuddy(self.ears)
        row.addWidget(files)
        row.addWidget(self.ears)

    def _choose(self, index: int) -> None:
        self.chosen.emit(self.names.itemText(index))
        self._show_preset()  # where it was refused, the old one is in use still

    def _choose_ear(self, index: int) -> None:
        self.ear_chosen.emit(list(EARS)[index])
        self._show_preset()

    def _show_preset(self) -> None:
        model = self.ears.model()
        assert isinstance(model, QStandardItemModel)
        for row, ear in enumerate(EARS):
            model.item(row).setEnabled(has_ear(self._preset.preset, ear))
        self.ears.setCurrentIndex(list(EARS).index(offered_ear(self._preset.preset)))
        name = self._preset.preset.recogniser
        self.names.setCurrentIndex(
            self.names.findText(name, Qt.MatchFlag.MatchExactly | Qt.MatchFlag.MatchCaseSensitive)
        )
