"""Files from sounds: what they become, how and where; one or a whole folder of them, with a look before."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QFontDatabase
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QComboBox,
    QDialog,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QMessageBox,
    QPlainTextEdit,
    QProgressBar,
    QPushButton,
    QSpinBox,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.painting import format_clock
from phonemeanalyser.desktop.session.export_kinds import EXPORT_KINDS, ExportOrder, work_of
from phonemeanalyser.desktop.session.export_queue import ExportJob, ExportQueue, ExportState, in_the_way, sounds_in
from phonemeanalyser.desktop.talk.mouth_table.choices_panel import DETAILS
from phonemeanalyser.desktop.widgets.table_copy import let_copy
from phonemeengine.conversion.spoken_texts import NO_TEXTS, SpokenTexts
from phonemeengine.conversion.work import targets_of
from phonemeengine.errors import EngineError
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.animation import HIGHEST_RATE
from phonemeengine.mouth.cues import MINIMUM, MOST_ANTICIPATION
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.performer import IdleMotion
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.presets.files import PresetEntry, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import Channel

SIZE = 900, 560
"""Of the dialog at first, pixels."""
USUAL = tr_noop("as the format has it")
BESIDE = tr_noop("beside each sound")
COLUMNS = (tr_noop("Sound"), tr_noop("Length"), tr_noop("State"), tr_noop("Becomes"))
MOST_SECONDS = 2.0
"""Of the shortest cue."""


class ExportDialog(QDialog):
    """Asks what sounds become, shows what the first one would become, and works through all of them.

    Parameters
    ----------
    preset, channel : what is recognised with, unless another preset is chosen, and of what.
    sounds : to begin with.
    presets : others to choose from.
    words : what is said in sounds, as far as the window knows it.

    Attributes
    ----------
    queue : works through the files.
    kind, heard, timing, table, rate, minimum, anticipation, detail, blinks, head, seed : choices.
    files : the table of the sounds.
    preview : the beginning of what the chosen sound would become.
    add_files, add_folder, remove, folder, look, start, cancel, shut : buttons.
    question : asks what becomes of files that are there already; None until it was asked.
    replace, keep : its buttons.
    told : what is wrong, or what was done.
    """

    def __init__(
        self, preset: Preset, channel: Channel, sounds: list[Path], settings: QSettings, parent: QWidget,
        presets: Iterable[PresetEntry] = (), words: Mapping[Path, Utterance] | None = None,
    ) -> None:  # fmt: skip
        super().__init__(parent)
        self._preset, self._channel, self._settings = preset, channel, settings
        self._sounds: list[Path] = []
        self._folder: Path | None = None
        self._shown: dict[int, tuple[str, ...]] = {}
        self.question: QMessageBox | None = None
        self.queue = ExportQueue()
        self.setWindowTitle(tr("Export"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setAcceptDrops(True)
        self.resize(*SIZE)
        self._make_choices()
        self.heard.addItem(preset.name, None)
        for entry in presets:
            self.heard.addItem(entry.name, entry.path)
            self.heard.setItemData(self.heard.count() - 1, entry.summary, Qt.ItemDataRole.ToolTipRole)
        self._words = words or {}
        self.timing.addItem(tr("recognition only"), NO_TEXTS)
        self.timing.addItem(tr("words or text beside each sound"), None)
        if self._words.keys() & {*sounds}:
            n = sum(len(utterance.words) for utterance in self._words.values())
            self.timing.addItem(tr("aligned words ({n})").format(n=n), SpokenTexts(scripts=self._words))
            self.timing.setCurrentIndex(self.timing.count() - 1)
        self._make_files()
        self._make_buttons()
        self._lay_out()
        self._connect()
        self.add(sounds)
        self._show_kind()

    # -- what is chosen -----------------------------------------------------------------------------------

    def add(self, paths: list[Path]) -> None:
        """Add sounds, and those in folders."""
        self._sounds = list(dict.fromkeys([*self._sounds, *sounds_in(paths)]))
        self._show_files()

    def order(self) -> ExportOrder:
        """Return what the sounds are turned into.

        Raises
        ------
        EngineError : the preset that is chosen cannot be loaded.
        """
        path = self.heard.currentData()
        preset = self._preset if path is None else load_preset(path)
        table = self.table.currentData()
        detail = Detail(self.detail.currentData())
        idle = IdleMotion(self.blinks.isChecked(), self.head.isChecked(), self.seed.value(), detail)
        anticipation = self.anticipation.value()
        ahead = None if anticipation < 0 else anticipation
        options = ExportOptions(self.rate.value() or None, self._minimum(), ahead, table, idle=idle)
        return ExportOrder(self.kind.currentData(), preset, options, self._channel, self.timing.currentData())

    def _minimum(self) -> float | None:
        return self.minimum.value() if self.minimum.isEnabled() else None

    # -- how it is made -----------------------------------------------------------------------------------

    def _make_choices(self) -> None:
        self.kind, self.heard, self.timing, self.table, self.detail = (QComboBox() for _ in range(5))
        for name, kind in EXPORT_KINDS.items():
            self.kind.addItem(f"{tr(kind.words)} ({name})", name)
        kept = self.kind.findData(str(self._settings.value("export/kind", "rhubarb-json")))
        self.kind.setCurrentIndex(max(0, kept))
        self.table.addItem(tr(USUAL), None)
        for name in shipped_tables():
            self.table.addItem(name, name)
        for detail, words in DETAILS.items():
            self.detail.addItem(tr(words), detail.value)
        self.rate, self.minimum, self.anticipation = QDoubleSpinBox(), QDoubleSpinBox(), QDoubleSpinBox()
        self.rate.setRange(0, HIGHEST_RATE)
        self.rate.setSpecialValueText(tr(USUAL))
        self.rate.setSuffix(" " + tr("frames/s"))
        self.minimum.setRange(0, MOST_SECONDS)
        self.minimum.setDecimals(3)
        self.minimum.setSingleStep(0.01)
        self.minimum.setValue(MINIMUM)
        self.minimum.setSuffix(" s")
        self.anticipation.setRange(-0.01, MOST_ANTICIPATION)
        self.anticipation.setDecimals(2)
        self.anticipation.setSingleStep(0.01)
        self.anticipation.setValue(-0.01)
        self.anticipation.setSpecialValueText(tr(USUAL))
        self.anticipation.setSuffix(" s")
        self.seed = QSpinBox()
        self.seed.setRange(0, 999_999)
        self.blinks, self.head = QCheckBox(tr("the eyes blink")), QCheckBox(tr("the head moves"))
        self.blinks.setChecked(True)
        self.head.setChecked(True)

    def _make_files(self) -> None:
        self.files = QTableWidget(0, len(COLUMNS))
        self.files.setHorizontalHeaderLabels(list(map(tr, COLUMNS)))
        self.files.verticalHeader().hide()
        self.files.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.files.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.files.setAccessibleName(tr("sounds that are exported"))
        let_copy(self.files)
        header = self.files.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        self.preview = QPlainTextEdit()
        self.preview.setReadOnly(True)
        self.preview.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.preview.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.preview.setPlaceholderText(tr("Preview shows what the first, or the chosen, sound becomes."))
        self.preview.setAccessibleName(tr("what a sound becomes"))

    def _make_buttons(self) -> None:
        self.add_files, self.add_folder, self.remove, self.folder = (
            QPushButton(words) for words in (tr("Add Files…"), tr("Add Folder…"), tr("Remove"), tr(BESIDE))
        )
        self.look, self.start, self.cancel, self.shut = (
            QPushButton(words) for words in (tr("Preview"), tr("Export"), tr("Cancel"), tr("Close"))
        )
        for button in (self.add_files, self.add_folder, self.remove, self.folder, self.look, self.cancel, self.shut):
            button.setAutoDefault(False)
        self.start.setDefault(True)
        self.folder.setToolTip(tr("Where the new files go"))
        self.told = QLabel()
        self.told.setWordWrap(True)
        self.bar = QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)

    def _lay_out(self) -> None:
        form = QFormLayout()
        rows: tuple[tuple[str, QWidget], ...] = (
            (tr("Becomes"), self.kind), (tr("Heard with"), self.heard), (tr("Timing"), self.timing),
            (tr("Mouth table"), self.table),
            (tr("Rate"), self.rate), (tr("Shortest cue"), self.minimum), (tr("Mouth ahead"), self.anticipation),
            (tr("Follows"), self.detail), (tr("Seed"), self.seed), ("", self.blinks), ("", self.head),
            (tr("Goes"), self.folder),
        )  # fmt: skip
        for words, widget in rows:
            form.addRow(words, widget)
            widget.setAccessibleName(words or widget.property("text"))
        self.kind.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.kind.setMinimumContentsLength(28)
        self.heard.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        left = QVBoxLayout()
        left.addLayout(form)
        left.addStretch(1)
        listing = QHBoxLayout()
        for button in (self.add_files, self.add_folder, self.remove):
            listing.addWidget(button)
        listing.addStretch(1)
        listing.addWidget(self.look)
        right = QVBoxLayout()
        right.addLayout(listing)
        right.addWidget(self.files, 3)
        right.addWidget(self.preview, 2)
        sides = QHBoxLayout()
        sides.addLayout(left)
        sides.addLayout(right, 1)
        ends = QHBoxLayout()
        ends.addWidget(self.told, 1)
        for button in (self.start, self.cancel, self.shut):
            ends.addWidget(button)
        layout = QVBoxLayout(self)
        layout.addLayout(sides, 1)
        layout.addWidget(self.bar)
        layout.addLayout(ends)

    def _connect(self) -> None:
        self.kind.currentIndexChanged.connect(self._show_kind)
        self.heard.currentIndexChanged.connect(self.preview.clear)
        self.timing.currentIndexChanged.connect(self.preview.clear)
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

    def _show_kind(self) -> None:
        kind = EXPORT_KINDS[self.kind.currentData()]
        numbers = (self.rate, self.minimum, self.anticipation, self.seed)
        for widget in (self.table, self.detail, *numbers, self.blinks, self.head):
            widget.setEnabled(kind.moves_mouth)
        self.minimum.setEnabled(kind.has_cues)
        self.preview.clear()
        self._show_files()

    def _show_files(self) -> None:
        self.queue.jobs = []
        targets = targets_of(self._sounds, self._folder, EXPORT_KINDS[self.kind.currentData()].ending)
        self._shown.clear()
        self.files.setRowCount(len(self._sounds))
        for row, sound in enumerate(self._sounds):
            self._show_row(row, (sound.name, "", "", str(targets[sound])))
        self._show_progress()

    def _show_progress(self) -> None:
        for row, job in enumerate(self.queue.jobs):
            length = format_clock(job.duration, fine=True) if job.duration else ""
            self._show_row(row, (job.source.name, length, tr(job.state.value), job.words or _with_notes(job)))
        busy = self.queue.busy
        self.bar.setValue(round(1000 * self.queue.progress) if self.queue.jobs else 0)
        self.start.setEnabled(bool(self._sounds) and not busy)
        self.look.setEnabled(bool(self._sounds))
        self.cancel.setEnabled(busy)
        for widget in (self.add_files, self.add_folder, self.remove, self.folder, self.kind, self.heard):
            widget.setEnabled(not busy)
        self.timing.setEnabled(not busy and EXPORT_KINDS[self.kind.currentData()].has_words)

    def _show_row(self, row: int, cells: tuple[str, ...]) -> None:
        if self._shown.get(row) == cells:
            return
        self._shown[row] = cells
        for column, words in enumerate(cells):
            item = QTableWidgetItem(words)
            item.setToolTip(words)
            self.files.setItem(row, column, item)

    def _show_end(self) -> None:
        states = [job.state for job in self.queue.jobs]
        parts = [f"{states.count(state)} {tr(state.value)}" for state in ExportState if state in states]
        self.told.setText(", ".join(parts))
        self._show_progress()

    # -- what the user asks for ---------------------------------------------------------------------------

    def _ask_files(self) -> None:
        names, _ = QFileDialog.getOpenFileNames(
            self, tr("Sounds to export"), self._kept("sound"), tr("All files (*)")
        )
        self.add([Path(name) for name in names])

    def _ask_folder(self) -> None:
        name = QFileDialog.getExistingDirectory(self, tr("A folder of sounds"), self._kept("sound"))
        if name:
            self.add([Path(name)])

    def _ask_target(self) -> None:
        name = QFileDialog.getExistingDirectory(self, tr("Where the new files go"), self._kept("export"))
        self._folder = Path(name) if name else None
        self.folder.setText(name or tr(BESIDE))
        if name:
            self._settings.setValue("folder/export", name)
        self._show_files()

    def _remove(self) -> None:
        rows = {index.row() for index in self.files.selectedIndexes()}
        self._sounds = [sound for row, sound in enumerate(self._sounds) if row not in rows]
        self._show_files()

    def _preview(self) -> None:
        order = self._checked_order()
        if order is not None and self._sounds:
            self.preview.setPlainText("…")
            self.queue.preview(self._sounds[max(0, self.files.currentRow())], order)

    def _start(self) -> None:
        order = self._checked_order()
        if order is not None:
            self._settings.setValue("export/kind", order.kind)
            self.told.clear()
            targets = targets_of(self._sounds, self._folder, EXPORT_KINDS[order.kind].ending)
            there = in_the_way(targets, order, self._folder)
            if there:
                self._ask_to_replace(targets, order, there)
            else:
                self.queue.start(targets, order, self._folder)

    def _ask_to_replace(self, targets: dict[Path, Path], order: ExportOrder, there: list[Path]) -> None:
        """Ask what becomes of files that are there already, made in another way or by others."""
        words = (
            tr("{name} is there already.") if len(there) == 1 else tr("{n} files are there already, such as {name}.")
        )
        self.question = QMessageBox(
            QMessageBox.Icon.Question, tr("Replace files?"), words.format(n=len(there), name=targets[there[0]].name),
            parent=self,
        )  # fmt: skip
        self.question.setInformativeText(tr("Perhaps edited by hand, or made with other settings."))
        roles = QMessageBox.ButtonRole
        self.replace = self.question.addButton(tr("Replace"), roles.DestructiveRole)
        self.keep = self.question.addButton(tr("Keep, Make Only the Others"), roles.AcceptRole)
        self.keep.setEnabled(len(there) < len(targets))
        self.question.setDefaultButton(self.question.addButton(QMessageBox.StandardButton.Cancel))
        others = {sound: target for sound, target in targets.items() if sound not in there}
        self.replace.clicked.connect(lambda: self.queue.start(targets, replace(order, overwrite=True), self._folder))
        self.keep.clicked.connect(lambda: self.queue.start(others, order, self._folder))
        self.question.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.question.open()

    def _checked_order(self) -> ExportOrder | None:
        """Return what the sounds are turned into; None, after saying why, where that cannot be done."""
        try:
            order = self.order()
            work_of(order)
        except EngineError as error:
            self.told.setText(str(error))
            return None
        return order

    def _kept(self, kind: str) -> str:
        return str(self._settings.value(f"folder/{kind}", str(Path.home())))

    # -- Qt's events --------------------------------------------------------------------------------------

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take files and folders."""
        if event.mimeData().hasUrls() and not self.queue.busy:
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Add what was dropped."""
        self.add([Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()])

    def closeEvent(self, event: QCloseEvent) -> None:
        """End the work, as *Cancel* does."""
        self._end()
        super().closeEvent(event)

    def reject(self) -> None:
        """Close, and end the work."""
        self._end()
        super().reject()

    def _end(self) -> None:
        if self.queue.busy:
            self.queue.cancel()
        self.queue.close()


def _with_notes(job: ExportJob) -> str:
    """Return what a sound becomes, with what is odd about it."""
    return " – ".join((str(job.target), *job.notes))
