"""Where the speech encoder's model is: shows it, takes a folder, or fetches it."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QLabel, QVBoxLayout, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeanalyser.desktop.widgets.builders import CLOSE, column, dialog_buttons
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeengine.encoder.model_folder import (
    choose_whisper,
    fetch_whisper,
    has_chosen_folder,
    has_whisper,
    whisper_in_words,
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
                "voices. It works on this computer, takes 400 MB of memory, and helps where all of a file is "
                "recognised at once: saved, exported, or aligned with its text."
            )
        )
        self.state = QLabel()
        for label in (intro, self.state):
            label.setWordWrap(True)
            label.setFixedWidth(WIDTH)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
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
        if folder := self._files.ask_folder(tr("The folder with model.bin and config.json of Whisper base"), Path()):
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
