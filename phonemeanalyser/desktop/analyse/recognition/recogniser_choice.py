"""Which recogniser names the phonemes, one of the program's own or of another package, and what hears files."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import QSizePolicy, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.widgets.builders import choice, label, row
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
        self.names = choice(
            ((name, None) for name in recogniser_names()),
            tr("recogniser"),
            tr(
                "<p>What names the phoneme of each frame. Another one brings the front end and the numbers that it "
                "was tuned with, unless you tuned it yourself. What it is tuned by is below.</p><p>To add one, "
                "install its package beside this program, and start the program again. How to write one is in the "
                "README.</p>"
            ),
        )
        self.names.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.names.setMinimumWidth(NAMES_WIDTH)
        self.ears = choice(
            ((tr(words), None) for words in EARS.values()),
            tr("ear for files"),
            tr(
                "<p>The best that files are heard with. <i>live</i>: as a microphone. <i>twin</i>: by a network that "
                "hears half a second ahead. <i>Whisper</i>: with a speech encoder besides, where all of a file is "
                "recognised at once: saved, exported or aligned with its text; while it plays, the twin serves.</p>"
                "<p>What is grey is not there; <i>File &gt; Speech Encoder…</i> gets Whisper.</p>"
            ),
        )
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        recogniser, files = label(tr("Recogniser")), label(tr("Files"))
        recogniser.setBuddy(self.names)
        files.setBuddy(self.ears)
        row(recogniser, (self.names, 1), files, self.ears, on=self, margins=(8, 4, 8, 2))
        self.names.activated.connect(self._choose)
        self.ears.activated.connect(self._choose_ear)
        preset.changed.connect(self._show_preset)
        self._show_preset()

    def _choose(self, index: int) -> None:
        self.chosen.emit(self.names.itemText(index))
        self._show_preset()  # where it was refused, the old one is in use still

    def _choose_ear(self, index: int) -> None:
        self.ear_chosen.emit(list(EARS)[index])
        self._show_preset()

    def _show_preset(self) -> None:
        model = self.ears.model()
        assert isinstance(model, QStandardItemModel)
        for k, ear in enumerate(EARS):
            model.item(k).setEnabled(has_ear(self._preset.preset, ear))
        self.ears.setCurrentIndex(list(EARS).index(offered_ear(self._preset.preset)))
        name = self._preset.preset.recogniser
        self.names.setCurrentIndex(
            self.names.findText(name, Qt.MatchFlag.MatchExactly | Qt.MatchFlag.MatchCaseSensitive)
        )
