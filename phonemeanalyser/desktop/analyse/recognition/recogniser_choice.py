"""Which recogniser names the phonemes, its models for live sound and for files, and where the speech encoder is."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QLabel, QSizePolicy, QVBoxLayout, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeanalyser.desktop.widgets.builders import CLOSE, choice, column, dialog_buttons, label, row
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeengine.encoder.model_folder import (
    choose_whisper,
    fetch_whisper,
    has_chosen_folder,
    has_whisper,
    whisper_in_words,
)
from phonemeengine.presets.ears import has_ear, offered_ear
from phonemeengine.recognition.spec import recogniser_names
from phonemeengine.settings import Ear

NAMES_WIDTH = 86
"""Pixels that the recogniser's name has at least."""
LIVE_MODELS = {Ear.LIVE: tr_noop("network"), Ear.ENCODER: tr_noop("encoder")}
EARS = {Ear.LIVE: tr_noop("live"), Ear.ENCODER: tr_noop("encoder"), Ear.TWIN: tr_noop("twin"), Ear.WHISPER: "Whisper"}


class RecogniserChoice(QWidget):
    """Offers all recognisers that are installed, and the models for live sound and for files, and shows the preset's.

    Signals
    -------
    chosen : name of the recogniser that the user wants.
    live_model_chosen : the `Ear` that the user wants live sound to be recognised with.
    ear_chosen : the `Ear` that the user wants files to be heard with.
    """

    chosen = Signal(str)
    live_model_chosen = Signal(object)
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
        self.live_models = choice(
            ((tr(words), None) for words in LIVE_MODELS.values()),
            tr("model for the microphone"),
            tr(
                "<p>What recognises a microphone. <i>network</i>: the small network, which costs next to nothing and "
                "looks ahead as little as you like. <i>encoder</i>: the lower layers of a speech encoder, which "
                "knows very many voices, together with the network; it looks ahead 20 or 40 ms and takes a few "
                "percent of a processor core.</p><p>What is grey is not there.</p>"
            ),
        )
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
        recogniser, live, files = label(tr("Recogniser")), label(tr("Microphone")), label(tr("Files"))
        for words, box in ((recogniser, self.names), (live, self.live_models), (files, self.ears)):
            words.setBuddy(box)
        models = row(live, (self.live_models, 1), files, (self.ears, 1))
        column(row(recogniser, (self.names, 1)), models, on=self, margins=(8, 4, 8, 2), spacing=4)
        self.names.activated.connect(self._choose)
        self.live_models.activated.connect(self._choose_live_model)
        self.ears.activated.connect(self._choose_ear)
        preset.changed.connect(self._show_preset)
        self._show_preset()

    def _choose(self, index: int) -> None:
        self.chosen.emit(self.names.itemText(index))
        self._show_preset()  # where it was refused, the old one is in use still

    def _choose_live_model(self, index: int) -> None:
        self.live_model_chosen.emit(list(LIVE_MODELS)[index])
        self._show_preset()

    def _choose_ear(self, index: int) -> None:
        self.ear_chosen.emit(list(EARS)[index])
        self._show_preset()

    def _show_preset(self) -> None:
        preset = self._preset.preset
        for box, ears in ((self.live_models, LIVE_MODELS), (self.ears, EARS)):
            model = box.model()
            assert isinstance(model, QStandardItemModel)
            for k, ear in enumerate(ears):
                model.item(k).setEnabled(has_ear(preset, ear))
        live = preset.live_model if has_ear(preset, preset.live_model) else Ear.LIVE
        self.live_models.setCurrentIndex(list(LIVE_MODELS).index(live))
        self.ears.setCurrentIndex(list(EARS).index(offered_ear(preset)))
        name = self._preset.preset.recogniser
        self.names.setCurrentIndex(
            self.names.findText(name, Qt.MatchFlag.MatchExactly | Qt.MatchFlag.MatchCaseSensitive)
        )


WIDTH = 560
LOOKING = tr_noop("Looking for the model …")


class EncoderDialog(QDialog):
    """Says which model is used, and lets the user choose or fetch one; nothing of it keeps the window waiting.

    Signals
    -------
    model_changed : another model is used, or none any more.
    """

    model_changed = Signal()

    def __init__(self, files: FileAsker, parent: QWidget) -> None:
        super().__init__(parent)
        self._files = files
        self.setWindowTitle(tr("Speech Encoder"))
        self._work = TaskQueue(self._refuse)
        intro = QLabel(
            tr(
                "Files are heard best by the network and the encoder of Whisper base together, which knows very many "
                "voices. It works on this computer, takes 250 MB of memory, and helps where all of a file is "
                "recognised at once: saved, exported, or aligned with its text."
            )
        )
        self.state = QLabel()
        for words in (intro, self.state):
            words.setWordWrap(True)
            words.setFixedWidth(WIDTH)
            words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        buttons = dialog_buttons(self, CLOSE)
        self.buttons = [
            buttons.addButton(text, QDialogButtonBox.ButtonRole.ActionRole)
            for text in (tr("Choose Folder…"), tr("Forget the Folder"), tr("Fetch It (145 MB)"))
        ]
        for button, act in zip(self.buttons, (self.ask_folder, self.forget, self.fetch), strict=True):
            button.clicked.connect(act)
        layout = column(intro, self.state, buttons, on=self, margins=None)
        layout.setSizeConstraint(QVBoxLayout.SizeConstraint.SetFixedSize)  # as high as the words need
        self._do(LOOKING, lambda: None)

    def ask_folder(self) -> None:
        """Let the user choose the folder of a model."""
        if folder := self._files.ask_folder(tr("The folder with model.bin of Whisper base"), Path()):
            self._do(tr_noop("Opening the model …"), lambda: choose_whisper(folder))

    def forget(self) -> None:
        """Use the chosen folder no longer."""
        self._do(LOOKING, lambda: choose_whisper(None))

    def fetch(self) -> None:
        """Get the model over the network."""
        self._do(tr_noop("Fetching the model, 145 MB …"), fetch_whisper)

    def done(self, result: int) -> None:
        """Close, and leave alone what is still fetched."""
        self._work.close(CLOSE_TIMEOUT)
        super().done(result)

    def _do(self, words: str, act: Callable[[], object]) -> None:
        """Do something in the background, then say which model is used."""
        self._asked = words
        self._show(tr(words), is_idle=False)

        def acted(_progress: object) -> str:
            act()
            return whisper_in_words()

        self._work.submit(acted, self._tell)

    def _tell(self, words: str) -> None:
        self._show(tr("In use: {words}.").format(words=words), is_idle=True)
        self.model_changed.emit()

    def _refuse(self, words: str) -> None:
        if not has_whisper() and self._asked == LOOKING:
            words = tr("there is no model yet: fetch it, or choose the folder of one that you have")
        self._show(f"{words[:1].upper()}{words[1:]}.", is_idle=True)
        self.model_changed.emit()

    def _show(self, words: str, *, is_idle: bool) -> None:
        self.state.setText(words)
        for button in self.buttons:
            button.setEnabled(is_idle)
        self.buttons[1].setEnabled(is_idle and has_chosen_folder())
