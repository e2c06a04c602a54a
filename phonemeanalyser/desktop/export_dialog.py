"""Files from sounds: what they become, how and where; one or a whole folder of them, with a look before."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from PySide6 import QtWidgets
from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QCloseEvent, QFontDatabase
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.export_choices import ExportChoices
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session import exports
from phonemeanalyser.desktop.settings import in_program, keep, outside_program
from phonemeanalyser.desktop.theme import format_clock
from phonemeanalyser.desktop.widgets.builders import column, label, named, row
from phonemeanalyser.desktop.widgets.file_asker import FileAsker, FileDrops, audio_filters
from phonemeanalyser.desktop.widgets.plot import let_copy
from phonemeanalyser.desktop.widgets.preset_picker import Sections
from phonemeengine.conversion.work import targets_of
from phonemeengine.errors import EngineError
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import Channel

SIZE = 900, 560
"""Of the dialog at first, pixels."""
BESIDE = tr_noop("Beside each audio file")
COLUMNS = (tr_noop("Audio file"), tr_noop("Duration"), tr_noop("Status"), tr_noop("Output"))
TEXT = Path("text")
"""Stands for the current text among the sounds."""


class ExportDialog(QtWidgets.QDialog):
    """Asks what sounds become, shows what the first one would become, and works through all of them.

    Parameters
    ----------
    preset, channel, presets, face : as of `ExportChoices`.
    sounds : to begin with.
    files : asks for files and folders.

    Attributes
    ----------
    queue : works through the files.
    choices : what sounds become, and how.
    files : the table of the sounds.
    preview : the beginning of what the chosen sound would become.
    add_files, add_folder, remove, folder, look, start, cancel, shut : buttons.
    question : asks what becomes of files that are there already; None until it was asked.
    replace, keep : its buttons.
    told : what is wrong, or what was done.
    """

    def __init__(
        self,
        preset: Preset,
        channel: Channel,
        sounds: list[Path],
        settings: QSettings,
        parent: QtWidgets.QWidget,
        presets: Callable[[], Sections] = dict,
        face: exports.FaceInUse | None = None,
        files: FileAsker | None = None,
    ) -> None:
        super().__init__(parent)
        self._settings = settings
        self._face, self._asker = face or exports.FaceInUse(), files or FileAsker(settings)
        self._sounds: list[Path] = []
        self._folder: Path | None = None
        self._shown: dict[int, tuple[str, ...]] = {}
        self.question: QtWidgets.QMessageBox | None = None
        self.queue = exports.ExportQueue()
        self.setWindowTitle(tr("Export"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        drops = FileDrops(self, lambda: not self.queue.busy)
        drops.dropped.connect(self.add)
        self.resize(*SIZE)
        self.choices = ExportChoices(preset, channel, sounds, settings, presets, self._face, self._asker)
        self._make_files()
        self._make_buttons()
        self._lay_out()
        self._connect()
        if self.choices.is_text:
            self._sounds, self._folder = [TEXT], self._asker.folder_of("export")
            self.folder.setText(str(self._folder))
        self.add(sounds)
        self.choices.show_kind()

    # -- what is chosen -----------------------------------------------------------------------------------

    def add(self, paths: list[Path]) -> None:
        """Add sounds, and those in folders."""
        if not self.choices.is_text:
            self._sounds = list(dict.fromkeys([*self._sounds, *exports.sounds_in(paths)]))
        self.write_into(self._folder)

    # -- how it is made -----------------------------------------------------------------------------------

    def _make_files(self) -> None:
        self.files = named(QtWidgets.QTableWidget(0, len(COLUMNS)), tr("Audio files to export"))
        self.files.setHorizontalHeaderLabels(list(map(tr, COLUMNS)))
        self.files.verticalHeader().hide()
        self.files.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.files.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectionBehavior.SelectRows)
        let_copy(self.files)
        header = self.files.horizontalHeader()
        header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        self.preview = named(QtWidgets.QPlainTextEdit(), tr("Preview of the output"))
        self.preview.setReadOnly(True)
        self.preview.setLineWrapMode(QtWidgets.QPlainTextEdit.LineWrapMode.NoWrap)
        self.preview.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.preview.setPlaceholderText(
            tr("Press Preview to see the output for the selected file, or for the first one.")
        )

    def _make_buttons(self) -> None:
        self.add_files, self.add_folder, self.remove, self.folder = (
            QtWidgets.QPushButton(words) for words in (tr("Add Files…"), tr("Add Folder…"), tr("Remove"), tr(BESIDE))
        )
        self.look, self.start, self.cancel, self.shut = (
            QtWidgets.QPushButton(words) for words in (tr("Preview"), tr("Export"), tr("Cancel"), tr("Close"))
        )
        for button in (self.add_files, self.add_folder, self.remove, self.folder, self.look, self.cancel, self.shut):
            button.setAutoDefault(False)
        self.start.setDefault(True)
        named(self.folder, tip=tr("Folder for the exported files"))
        self.told = label(wraps=True)
        self.bar = QtWidgets.QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)

    def _lay_out(self) -> None:
        self.choices.addRow(tr("Save to"), named(self.folder, tr("Save to")))
        left = column(self.choices, 1, margins=None)
        listing = row(self.add_files, self.add_folder, self.remove, 1, self.look)
        right = column(listing, (self.files, 3), (self.preview, 2))
        ends = row((self.told, 1), self.start, self.cancel, self.shut)
        column((row(left, (right, 1)), 1), self.bar, ends, on=self, margins=None)

    def _connect(self) -> None:
        for changed in (self.choices.changed, self.choices.preset.changed):
            changed.connect(self.preview.clear)
            changed.connect(self._show_files)
        self.add_files.clicked.connect(self._ask_files)
        self.add_folder.clicked.connect(self._ask_folder)
        self.remove.clicked.connect(self._remove)
        self.folder.clicked.connect(self._ask_target)
        self.look.clicked.connect(self._preview)
        self.start.clicked.connect(self._start)
        self.cancel.clicked.connect(self.queue.cancel)
        self.shut.clicked.connect(self.reject)
        self.queue.changed.connect(self._show_progress)
        self.queue.finished.connect(self._show_end)
        self.queue.previewed.connect(self.preview.setPlainText)

    # -- what is shown ------------------------------------------------------------------------------------

    def _show_files(self) -> None:
        self.queue.jobs = []
        self.told.clear()
        targets = targets_of(self._sounds, self._folder, self.choices.chosen.ending)
        self._shown.clear()
        self.files.setRowCount(len(self._sounds))
        for place, sound in enumerate(self._sounds):
            self._show_row(place, (self._name_of(sound), "", "", str(targets[sound])))
        self._show_progress()

    def _show_progress(self) -> None:
        for place, job in enumerate(self.queue.jobs):
            length = format_clock(job.duration, fine=True) if job.duration else ""
            cells = self._name_of(job.source), length, tr(job.state.value), tr_engine(job.words) or _with_notes(job)
            self._show_row(place, cells)
        busy = self.queue.busy
        self.bar.setValue(round(1000 * self.queue.progress) if self.queue.jobs else 0)
        self.start.setEnabled(bool(self._sounds) and not busy)
        self.look.setEnabled(bool(self._sounds))
        self.cancel.setEnabled(busy)
        self.choices.allow(on=not busy)
        self.folder.setEnabled(not busy)
        for button in (self.add_files, self.add_folder, self.remove):
            button.setEnabled(not busy and not self.choices.is_text)

    def _name_of(self, sound: Path) -> str:
        return tr("Text on the Talk page") if sound == TEXT else sound.name

    def _show_row(self, place: int, cells: tuple[str, ...]) -> None:
        if self._shown.get(place) == cells:
            return
        self._shown[place] = cells
        for k, words in enumerate(cells):
            item = QtWidgets.QTableWidgetItem(words)
            item.setToolTip(words)
            self.files.setItem(place, k, item)

    def _show_end(self) -> None:
        states = [job.state for job in self.queue.jobs]
        parts = [f"{states.count(state)} {tr(state.value)}" for state in exports.ExportState if state in states]
        self.told.setText(", ".join(parts))
        self._show_progress()

    # -- what the user asks for ---------------------------------------------------------------------------

    def _ask_files(self) -> None:
        self.add(self._asker.ask_files(tr("Add Audio Files"), audio_filters(), "sound"))

    def _ask_folder(self) -> None:
        if folder := self._asker.ask_folder(tr("Add Folder"), self._asker.folder_of("sound")):
            self.add([folder])

    def _ask_target(self) -> None:
        folder = self._asker.ask_folder(tr("Folder for Exported Files"), self._asker.folder_of("export"))
        if folder is not None:
            self._asker.remember("export", folder)
        elif self.choices.is_text:
            return  # a text lies nowhere, so that nothing can go beside it
        self.write_into(folder)

    def write_into(self, folder: Path | None) -> None:
        """Have the files written into a folder; None for beside each sound, but nothing beside the demo."""
        own = next(filter(in_program, self._sounds), None)
        self._folder = folder or (None if own is None else outside_program(own, make_folder=True).parent)
        self.folder.setText(str(self._folder or tr(BESIDE)))
        self._show_files()

    def _remove(self) -> None:
        rows = {index.row() for index in self.files.selectedIndexes()}
        self._sounds = [sound for k, sound in enumerate(self._sounds) if k not in rows]
        self._show_files()

    def _preview(self) -> None:
        order = self._checked_order()
        if order is not None and self._sounds:
            self.preview.setPlainText("…")
            self.queue.preview(self._sounds[max(0, self.files.currentRow())], order)

    def _start(self) -> None:
        order = self._checked_order()
        if order is not None:
            keep(self._settings, "export/kind", order.kind)
            self.told.clear()
            targets = targets_of(self._sounds, self._folder, exports.EXPORT_KINDS[order.kind].ending)
            there = exports.in_the_way(targets, order, self._folder)
            if there:
                self._ask_to_replace(targets, order, there)
            else:
                self.queue.start(targets, order, self._folder)

    def _ask_to_replace(self, targets: dict[Path, Path], order: exports.ExportOrder, there: list[Path]) -> None:
        """Ask what becomes of files that are there already, made in another way or by others."""
        words = tr("{name} already exists.") if len(there) == 1 else tr("{n} files already exist, such as {name}.")
        self.question = QtWidgets.QMessageBox(
            QtWidgets.QMessageBox.Icon.Question,
            tr("Overwrite Existing Files"),
            words.format(n=len(there), name=targets[there[0]].name),
            parent=self,
        )
        self.question.setInformativeText(
            tr("Existing files may have been edited by hand or made with other settings.")
        )
        roles = QtWidgets.QMessageBox.ButtonRole
        self.replace = self.question.addButton(tr("Overwrite"), roles.DestructiveRole)
        self.keep = self.question.addButton(tr("Export Only the Others"), roles.AcceptRole)
        self.keep.setVisible(len(there) < len(targets))
        self.question.setDefaultButton(self.question.addButton(QtWidgets.QMessageBox.StandardButton.Cancel))
        others = {sound: target for sound, target in targets.items() if sound not in there}
        self.replace.clicked.connect(lambda: self.queue.start(targets, replace(order, overwrite=True), self._folder))
        self.keep.clicked.connect(lambda: self.queue.start(others, order, self._folder))
        self.question.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.question.open()

    def _checked_order(self) -> exports.ExportOrder | None:
        """Return what the sounds are turned into; None, after saying why, where that cannot be done."""
        try:
            order = self.choices.order()
            exports.work_of(order)
        except EngineError as error:
            self.told.setText(tr_engine(str(error)))
            return None
        return order

    # -- Qt's events --------------------------------------------------------------------------------------

    @override
    def closeEvent(self, event: QCloseEvent) -> None:
        """End the work, as *Cancel* does."""
        self._end()
        super().closeEvent(event)

    @override
    def reject(self) -> None:
        self._end()
        super().reject()

    def _end(self) -> None:
        if self.queue.busy:
            self.queue.cancel()
        self.queue.close()


def _with_notes(job: exports.ExportJob) -> str:
    """Return what a sound becomes, with what is odd about it."""
    return " – ".join((str(job.target), *map(tr_engine, job.notes)))
