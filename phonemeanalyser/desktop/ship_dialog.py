"""A preset for programs without Python: which one, for what, and where it goes."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from PySide6 import QtWidgets
from PySide6.QtCore import QSettings, Qt, Signal
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import table_title, tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.settings import keep, read
from phonemeanalyser.desktop.widgets.builders import CANCEL, choice, dialog_buttons, label, named, row
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeanalyser.desktop.widgets.preset_picker import PresetChoice, Sections
from phonemeengine.errors import EngineError
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.presets.files import load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.shipping.targets import TARGETS, USUAL_TABLES, ship, without_real_time_model

WIDTH = 520
CHECKED, NAME = Qt.CheckState.Checked, Qt.ItemDataRole.UserRole


@dataclass(frozen=True)
class ShipOrder:
    """What is shipped, as `phonemeengine.ship` takes it; of a preset that is not the current one, the file."""

    preset: Preset | Path
    folder: Path
    target: str
    tables: tuple[str, ...]
    overwrite: bool = False
    embed: bool = False

    def write(self) -> tuple[Path, ...]:
        """Write the folder; return its files.

        Raises
        ------
        EngineError : it cannot be shipped, or not written.
        """
        preset = load_preset(self.preset) if isinstance(self.preset, Path) else self.preset
        choices = {"embed": self.embed, "overwrite": self.overwrite}
        return ship(preset, self.folder, self.target, tables=self.tables, **choices)


class ShipDialog(QtWidgets.QDialog):
    """Asks what is shipped.

    Parameters
    ----------
    preset : the current one.
    sections : gives other presets to choose from, by heading.

    Attributes
    ----------
    preset, target, tables, embed, folder, overwrite : choices; embed is for C alone.
    note : what of the preset is not shipped.
    choose, start : buttons.

    Signals
    -------
    ordered : the user wants this `ShipOrder` to be written.
    """

    ordered = Signal(object)

    def __init__(
        self,
        preset: Preset,
        sections: Callable[[], Sections],
        settings: QSettings,
        files: FileAsker,
        parent: QtWidgets.QWidget,
    ) -> None:
        super().__init__(parent)
        self._in_hand, self._settings, self._files = preset, settings, files
        self.setWindowTitle(tr("Ship Preset"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setMinimumWidth(WIDTH)
        self.preset = PresetChoice(preset.name, sections, files)
        self.note = label(wraps=True)
        self.target = choice(((tr(target.words), name) for name, target in TARGETS.items()), tr("Target"))
        self.tables = named(QtWidgets.QListWidget(), tr("Mouth tables"))
        self.folder, self.choose = named(QtWidgets.QLineEdit(), tr("Folder")), QtWidgets.QPushButton(tr("Choose…"))
        self.embed = QtWidgets.QCheckBox(tr("Preset as a C array, too (preset.c)"))
        self.overwrite = QtWidgets.QCheckBox(tr("Overwrite changed files"))
        self._fill()
        self._lay_out()

    def order(self) -> ShipOrder:
        """Return what is chosen."""
        items = [self.tables.item(k) for k in range(self.tables.count())]
        tables = tuple(item.data(NAME) for item in items if item.checkState() == CHECKED)
        chosen = self.preset.path or self._in_hand
        folder = Path(self.folder.text()).expanduser()
        target = self.target.currentData()
        embed = target == "c" and self.embed.isChecked()
        return ShipOrder(chosen, folder, target, tables, self.overwrite.isChecked(), embed)

    @override
    def accept(self) -> None:
        order = self.order()
        keep(self._settings, "ship/target", order.target)
        self._files.remember("ship", order.folder)
        super().accept()
        self.ordered.emit(order)

    def _fill(self) -> None:
        self.target.setCurrentIndex(max(0, self.target.findData(read(self._settings, "ship/target", "c"))))
        for name in shipped_tables():
            item = QtWidgets.QListWidgetItem(table_title(name), self.tables)
            item.setData(NAME, name)
            item.setCheckState(CHECKED if name in USUAL_TABLES else Qt.CheckState.Unchecked)
        self.folder.setText(read(self._settings, "folder/ship", ""))
        self.folder.setPlaceholderText(tr("Choose a separate folder"))

    def _lay_out(self) -> None:
        words = label(
            tr(
                "The folder will contain the preset, the runtime that recognises with it, and a README with the "
                "next steps."
            ),
            wraps=True,
        )
        form = QtWidgets.QFormLayout(self)
        form.addRow(tr("Preset"), self.preset)
        form.addRow("", self.note)
        form.addRow(tr("Target"), self.target)
        form.addRow(tr("Mouth tables"), self.tables)
        form.addRow(tr("Folder"), row((self.folder, 1), self.choose))
        form.addRow("", self.embed)
        form.addRow("", self.overwrite)
        form.addRow(words)
        buttons = dialog_buttons(self, CANCEL, verb=tr("Ship"))
        self.start = buttons.buttons()[0]
        form.addRow(buttons)
        self._form = form
        self.preset.changed.connect(self._show_note)
        self.target.currentIndexChanged.connect(self._show_embed)
        self._show_embed()
        self._show_note()
        self.choose.setAutoDefault(False)  # Return ships
        self.choose.clicked.connect(self._ask_folder)
        self.folder.textChanged.connect(self._allow)
        self._allow()

    def _show_note(self) -> None:
        """Say what of the chosen preset is not shipped; one that cannot be loaded is refused when it is shipped."""
        path, note = self.preset.path, ""
        with suppress(EngineError):
            note = without_real_time_model(self._in_hand if path is None else load_preset(path))
        words = tr_engine(note)
        self.note.setText(f"{words[:1].upper()}{words[1:]}.")
        self._form.setRowVisible(self.note, bool(note))

    def _show_embed(self) -> None:
        self._form.setRowVisible(self.embed, self.target.currentData() == "c")

    def _allow(self) -> None:
        self.start.setEnabled(bool(self.folder.text().strip()))

    def _ask_folder(self) -> None:
        if folder := self._files.ask_folder(tr("Choose Folder"), Path(self.folder.text() or Path.home())):
            self.folder.setText(str(folder))
