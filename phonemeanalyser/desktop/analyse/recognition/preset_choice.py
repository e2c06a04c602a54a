"""The preset in the tool bar, A or B, its models for live sound and for files, and where the speech encoder is."""

from collections.abc import Callable
from html import escape
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QLabel, QSizePolicy, QVBoxLayout, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import recogniser_title, tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeanalyser.desktop.widgets.builders import CLOSE, choice, column, dialog_buttons, grid, label
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeanalyser.desktop.widgets.preset_picker import PresetPicker, Sections
from phonemeengine.encoder import model_folder
from phonemeengine.presets.files import PresetEntry
from phonemeengine.presets.model_choice import has_model, has_network, offered_model, why_without
from phonemeengine.recognition.spec import BUILT_IN, recogniser_names
from phonemeengine.settings import ModelKind

WIDTH = 170
_RECOGNISER = Path("recogniser")
"""Stands before the name of a recogniser of another package, as if that were a file."""


class PresetBox(PresetPicker):
    """Shows the preset in use, and lists the others, and the recognisers that other packages bring.

    Parameters
    ----------
    preset : the presets A and B.
    sections, files : as of `PresetPicker`.

    Signals
    -------
    recogniser_chosen : name of the recogniser of another package that the user wants.
    """

    recogniser_chosen = Signal(str)

    def __init__(self, preset: PresetModel, sections: Callable[[], Sections], files: FileAsker) -> None:
        super().__init__(lambda: {**sections(), tr("Recognisers of other packages"): _of_packages()}, files)
        self._preset = preset
        self.setFixedWidth(WIDTH)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.list.as_other.show()
        for signal in (preset.changed, preset.file_changed, preset.sides_changed):
            signal.connect(self._show_preset)
        self._show_preset()

    @override
    def _marks(self) -> dict[Path, str]:
        here, other = self._preset.document, self._preset.other
        if other is None:
            return {here.path.resolve(): "✓"}
        marks = {other.path.resolve(): self._preset.other_letter}
        mine = marks.get(here.path.resolve(), "")
        return {**marks, here.path.resolve(): "".join(sorted(f"{mine}{self._preset.letter}"))}

    @override
    def _take(self, value: Path | str | None, other: bool) -> None:
        if isinstance(value, Path) and value.parent == _RECOGNISER:
            self.recogniser_chosen.emit(value.name)
        else:
            super()._take(value, other)

    def _show_preset(self) -> None:
        preset, other = self._preset.preset, self._preset.other
        mark = "*" if self._preset.has_unsaved_changes else ""
        self.show_name(f"{self._preset.title}{mark}")
        changed = ", " + tr("unsaved changes") if mark else ""
        told = [
            f"{tr('Preset')} <b>{escape(self._preset.title)}</b>{changed}. {escape(tr_engine(preset.summary))}",
            escape(str(self._preset.path)),
        ]
        if other is not None:
            words = tr("{letter}: {preset}; X uses it")
            told.append(escape(words.format(letter=self._preset.other_letter, preset=other.preset.name)))
        self.setToolTip("".join(f"<p>{words}</p>" for words in told))
        as_other = tr("Set as {letter}").format(letter=self._preset.other_letter)
        self.list.as_other.setText(as_other)
        self.list.as_other.setToolTip(tr("Compare the marked preset with the one in use (Ctrl+Return)"))


def _of_packages() -> tuple[PresetEntry, ...]:
    names = (name for name in recogniser_names() if name not in BUILT_IN)
    return tuple(PresetEntry(_RECOGNISER / name, name, "") for name in names)


LIVE_MODELS = {ModelKind.REAL_TIME: tr_noop("Small network"), ModelKind.ENCODER: tr_noop("Encoder")}
FILE_MODELS = {
    ModelKind.REAL_TIME: tr_noop("Real-time"),
    ModelKind.ENCODER: tr_noop("Encoder"),
    ModelKind.OFFLINE: tr_noop("Offline"),
    ModelKind.WHISPER: "Whisper",
}


class RecogniserChoice(QWidget):
    """Offers the preset's models for live sound and for files, and says how to get those that are not there."""

    def __init__(self, preset: PresetModel) -> None:
        super().__init__()
        self._preset = preset
        self.live_models = choice(
            ((tr(words), None) for words in LIVE_MODELS.values()),
            tr("Real-time model"),
            tr(
                "<p>Model that recognises the microphone.</p><p><i>Small network</i>: next to no processor "
                "load, any look-ahead.<br><i>Encoder</i>: the lower layers of a speech encoder, trained on very "
                "many voices, together with the small network; look-ahead 20 or 40 ms, a few percent of a "
                "processor core.</p><p>Models that are not available are grey and say why.</p>"
            ),
        )
        self.file_models = choice(
            ((tr(words), None) for words in FILE_MODELS.values()),
            tr("File model"),
            tr(
                "<p>Best model that files are recognised with.</p><p><i>Real-time</i>: the preset's recogniser, as "
                "for a microphone.<br><i>Encoder</i>: the real-time model with the encoder.<br><i>Offline</i>: a "
                "network with half a second of context on both sides.<br><i>Whisper</i>: the offline model and a "
                "speech encoder, where a whole file is recognised at once: saving, exporting, aligning with its "
                "text. Playback uses the offline model.</p><p>Models that are not available are grey and say why.</p>"
            ),
        )
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        rows = grid(self, margins=(8, 4, 8, 2), down=4)
        for k, box in enumerate((self.live_models, self.file_models)):
            words = label(box.accessibleName())
            words.setBuddy(box)
            rows.addWidget(words, k, 0)
            rows.addWidget(box, k, 1)
        rows.setColumnStretch(1, 1)
        self.live_models.activated.connect(self._choose_live_model)
        self.file_models.activated.connect(self._choose_file_model)
        preset.changed.connect(self._show_preset)
        self._show_preset()

    def _choose_live_model(self, index: int) -> None:
        self._preset.set_live_model(list(LIVE_MODELS)[index])
        self._show_preset()

    def _choose_file_model(self, index: int) -> None:
        self._preset.set_file_model(list(FILE_MODELS)[index])
        self._show_preset()

    def _show_preset(self) -> None:
        preset = self._preset.preset
        for box, kinds in ((self.live_models, LIVE_MODELS), (self.file_models, FILE_MODELS)):
            model = box.model()
            assert isinstance(model, QStandardItemModel)
            for k, kind in enumerate(kinds):
                why_not = tr_engine(why_without(preset, kind))
                model.item(k).setEnabled(not why_not)
                model.item(k).setToolTip(f"<p>{why_not[:1].upper()}{why_not[1:]}.</p>" if why_not else "")
        network = LIVE_MODELS[ModelKind.REAL_TIME] if has_network(preset) else recogniser_title(preset.recogniser)
        self.live_models.setItemText(0, tr(network))
        live = preset.live_model if has_model(preset, preset.live_model) else ModelKind.REAL_TIME
        self.live_models.setCurrentIndex(list(LIVE_MODELS).index(live))
        self.file_models.setCurrentIndex(list(FILE_MODELS).index(offered_model(preset)))


TEXT_WIDTH = 560
LOOKING = tr_noop("Looking for the model…")


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
                "The offline model recognises files best together with the encoder of Whisper base, which was "
                "trained on very many voices. The encoder runs on this computer, takes 250 MB of memory, and is "
                "used where a whole file is recognised at once: saving, exporting, aligning with its text."
            )
        )
        self.state = QLabel()
        for words in (intro, self.state):
            words.setWordWrap(True)
            words.setFixedWidth(TEXT_WIDTH)
            words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        buttons = dialog_buttons(self, CLOSE)
        self.buttons = [
            buttons.addButton(text, QDialogButtonBox.ButtonRole.ActionRole)
            for text in (tr("Choose Folder…"), tr("Clear Folder"), tr("Download (145 MB)"))
        ]
        for button, act in zip(self.buttons, (self.ask_folder, self.forget, self.fetch), strict=True):
            button.clicked.connect(act)
        layout = column(intro, self.state, buttons, on=self, margins=None)
        layout.setSizeConstraint(QVBoxLayout.SizeConstraint.SetFixedSize)  # as high as the words need
        self._do(LOOKING, lambda: None)

    def ask_folder(self) -> None:
        """Let the user choose the folder of a model."""
        if folder := self._files.ask_folder(tr("Choose the Folder with model.bin of Whisper base"), Path()):
            self._do(tr_noop("Opening the model…"), lambda: model_folder.choose_whisper(folder))

    def forget(self) -> None:
        """Use the chosen folder no longer."""
        self._do(LOOKING, lambda: model_folder.choose_whisper(None))

    def fetch(self) -> None:
        """Get the model over the network."""
        self._do(tr_noop("Downloading the model (145 MB)…"), model_folder.fetch_whisper)

    @override
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
            return model_folder.whisper_in_words()

        self._work.submit(acted, self._tell)

    def _tell(self, words: str) -> None:
        self._show(tr("In use: {words}.").format(words=tr_engine(words)), is_idle=True)
        self.model_changed.emit()

    def _refuse(self, words: str) -> None:
        if not model_folder.has_whisper() and self._asked == LOOKING:
            words = tr("no model is installed: download it, or choose the folder of one that you have")
        self._show(f"{words[:1].upper()}{words[1:]}.", is_idle=True)
        self.model_changed.emit()

    def _show(self, words: str, *, is_idle: bool) -> None:
        self.state.setText(words)
        for button in self.buttons:
            button.setEnabled(is_idle)
        self.buttons[1].setEnabled(is_idle and model_folder.has_chosen_folder())
