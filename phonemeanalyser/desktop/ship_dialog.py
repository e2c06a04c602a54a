"""A preset for programs without Python: which one, for what, and where it goes."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QSettings, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QWidget,
)

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.settings import keep, read
from phonemeanalyser.desktop.widgets.builders import CANCEL, choice, dialog_buttons, label, named, row
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.presets.files import PresetEntry, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.shipping.targets import TARGETS, USUAL_TABLES, ship

WIDTH = 520
CHECKED = Qt.CheckState.Checked


@dataclass(frozen=True)
class ShipOrder:
    """What is shipped, as `phonemeengine.ship` takes it; of a preset that is not in hand, the file."""

    preset: Preset | Path
    folder: Path
    target: str
    tables: tuple[str, ...]
    overwrite: bool = False

    def write(self) -> tuple[Path, ...]:
        """Write the folder; return its files.

        Raises
        ------
        EngineError : it cannot be shipped, or not written.
        """
        preset = load_preset(self.preset) if isinstance(self.preset, Path) else self.preset
        return ship(preset, self.folder, self.target, tables=self.tables, overwrite=self.overwrite)


class ShipDialog(QDialog):
    """Asks what is shipped.

    Parameters
    ----------
    preset : the one in hand.
    sections : other presets to choose from, by heading.

    Attributes
    ----------
    preset, target, tables, folder, overwrite : choices.
    choose, start : buttons.

    Signals
    -------
    ordered : the user wants this `ShipOrder` to be written.
    """

    ordered = Signal(object)

    def __init__(
        self,
        preset: Preset,
        sections: Mapping[str, tuple[PresetEntry, ...]],
        settings: QSettings,
        files: FileAsker,
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self._in_hand, self._settings, self._files = preset, settings, files
        self.setWindowTitle(tr("Ship a Preset"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setMinimumWidth(WIDTH)
        hand = tr("{preset}, as it is in hand").format(preset=preset.name)
        others = [(f"{title}: {entry.name}", entry.path) for title, entries in sections.items() for entry in entries]
        self.preset = choice([(hand, None), *others], tr("Preset"))
        self.target = choice(((f"{name}: {tr(target.words)}", name) for name, target in TARGETS.items()), tr("For"))
        self.tables = named(QListWidget(), tr("Mouth tables"))
        self.folder, self.choose = named(QLineEdit(), tr("Folder")), QPushButton(tr("Choose…"))
        self.overwrite = QCheckBox(tr("replace files that were changed there, too"))
        self._fill()
        self._lay_out()

    def order(self) -> ShipOrder:
        """Return what is chosen."""
        items = [self.tables.item(k) for k in range(self.tables.count())]
        tables = tuple(item.text() for item in items if item.checkState() == CHECKED)
        chosen = self.preset.currentData() or self._in_hand
        folder = Path(self.folder.text()).expanduser()
        return ShipOrder(chosen, folder, self.target.currentData(), tables, self.overwrite.isChecked())

    def accept(self) -> None:
        """Order it, and close."""
        order = self.order()
        keep(self._settings, "ship/target", order.target)
        self._files.remember("ship", order.folder)
        super().accept()
        self.ordered.emit(order)

    def _fill(self) -> None:
        self.target.setCurrentIndex(max(0, self.target.findData(read(self._settings, "ship/target", "c"))))
        for name in shipped_tables():
            item = QListWidgetItem(name, self.tables)
            item.setCheckState(CHECKED if name in USUAL_TABLES else Qt.CheckState.Unchecked)
        self.folder.setText(read(self._settings, "folder/ship", ""))
        self.folder.setPlaceholderText(tr("a folder of its own"))

    def _lay_out(self) -> None:
        words = label(
            tr("The folder has the preset, an ear that hears with it, and a README that says how to go on."),
            wraps=True,
        )
        form = QFormLayout(self)
        form.addRow(tr("Preset"), self.preset)
        form.addRow(tr("For"), self.target)
        form.addRow(tr("Mouth tables"), self.tables)
        form.addRow(tr("Folder"), row((self.folder, 1), self.choose))
        form.addRow("", self.overwrite)
        form.addRow(words)
        buttons = dialog_buttons(self, CANCEL)
        self.start = buttons.addButton(tr("Ship"), QDialogButtonBox.ButtonRole.AcceptRole)
        form.addRow(buttons)
        self.choose.clicked.connect(self._ask_folder)
        self.folder.textChanged.connect(self._allow)
        self._allow()

    def _allow(self) -> None:
        self.start.setEnabled(bool(self.folder.text().strip()))

    def _ask_folder(self) -> None:
        if folder := self._files.ask_folder(tr("Where the ear goes"), Path(self.folder.text() or Path.home())):
            self.folder.setText(str(folder))
