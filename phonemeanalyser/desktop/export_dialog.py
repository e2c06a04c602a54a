"""Files from sounds: what they become, how and where; one or a whole folder of them, with a look before."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QFontDatabase
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QComboBox,
    QDialog,
    QFormLayout,
    QHeaderView,
    QMessageBox,
    QPlainTextEdit,
    QProgressBar,
    QPushButton,
    QSpinBox,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.painting import format_clock
from phonemeanalyser.desktop.session.export_kinds import EXPORT_KINDS, ExportOrder, FaceInUse, work_of
from phonemeanalyser.desktop.session.export_queue import ExportJob, ExportQueue, ExportState, in_the_way, sounds_in
from phonemeanalyser.desktop.settings import keep, read
from phonemeanalyser.desktop.talk.mouth_table.choices_panel import DETAILS
from phonemeanalyser.desktop.widgets.builders import choice, column, label, named, row
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeanalyser.desktop.widgets.number_field import NumberField
from phonemeanalyser.desktop.widgets.plot_menu import let_copy
from phonemeengine.conversion.driving import USUAL_DRIVER, DriverChoice
from phonemeengine.conversion.options import OPTIONS
from phonemeengine.conversion.spoken_texts import NO_TEXTS, SpokenTexts
from phonemeengine.conversion.work import targets_of
from phonemeengine.errors import EngineError
from phonemeengine.mouth.cues import MINIMUM
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.mouth.exports.formats import FORMATS
from phonemeengine.mouth.face_driver import FaceDriver
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.presets.files import PresetEntry, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import Channel

SIZE = 900, 560
"""Of the dialog at first, pixels."""
USUAL = tr_noop("as the format has it")
BESIDE = tr_noop("beside each sound")
COLUMNS = (tr_noop("Sound"), tr_noop("Length"), tr_noop("State"), tr_noop("Becomes"))
TEXT = Path("text")
"""Stands for the text in hand among the sounds."""
ON_TALK = "as on Talk"
"""Chosen where it is as the page Talk has it."""
ON_TALK_WORDS = tr_noop("as on Talk: {name}")


class ExportDialog(QDialog):
    """Asks what sounds become, shows what the first one would become, and works through all of them.

    Parameters
    ----------
    preset, channel : what is recognised with, unless another preset is chosen, and of what.
    sounds : to begin with.
    presets : others to choose from.
    face : what the page Talk holds; its text is exported where it is in hand.
    files : asks for files and folders.

    Attributes
    ----------
    queue : works through the files.
    kind, heard, timing, driver, table, mesh, expression, rate, minimum, anticipation, detail, blinks, head, seed :
        choices.
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
        parent: QWidget,
        presets: Iterable[PresetEntry] = (),
        face: FaceInUse | None = None,
        files: FileAsker | None = None,
    ) -> None:
        super().__init__(parent)
        self._preset, self._channel, self._settings = preset, channel, settings
        self._face, self._asker = face or FaceInUse(), files or FileAsker(settings)
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
        self._offer_timing(sounds)
        self._make_files()
        self._make_buttons()
        self._lay_out()
        self._connect()
        if self._is_text:
            self._sounds, self._folder = [TEXT], self._asker.folder_of("export")
            self.folder.setText(str(self._folder))
        self.add(sounds)
        self._show_kind()

    # -- what is chosen -----------------------------------------------------------------------------------

    @property
    def _is_text(self) -> bool:
        """Whether the text in hand is exported, and no sound."""
        return self._face.speech is not None

    def add(self, paths: list[Path]) -> None:
        """Add sounds, and those in folders."""
        if not self._is_text:
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
        kind, talk, timing = EXPORT_KINDS[self.kind.currentData()], self._face, self.timing.currentData()
        knows_words = self._is_text or timing != NO_TEXTS
        chosen = talk.driver if self.driver.currentData() == ON_TALK else DriverChoice(FaceDriver.RULES)
        driver = chosen if knows_words else USUAL_DRIVER
        return ExportOrder(
            kind.name,
            preset,
            self._options(kind.options),
            self._channel,
            timing,
            driver,
            talk.movestates if self.mesh.currentData() == ON_TALK else None,
            talk.speech,
        )

    def _options(self, offered: frozenset[str]) -> ExportOptions:
        """Return how mouths move, by the choices that the format offers."""
        talk, table = self._face.options, self.table.currentData()
        as_on_talk = table == ON_TALK
        feels = "expression" in offered and self.expression.currentData() == ON_TALK
        idle = replace(
            talk.idle,
            blinks=self.blinks.isChecked(),
            head=self.head.isChecked(),
            seed=self.seed.value(),
            detail=Detail(self.detail.currentData()),
            expression=talk.idle.expression if feels else None,
        )
        anticipation = self.anticipation.value()
        return replace(
            talk if as_on_talk else ExportOptions(),
            rate=(self.rate.value() or None) if "fps" in offered else None,
            minimum=self.minimum.value() if "minimum" in offered else None,
            anticipation=None if anticipation < 0 else anticipation,
            table=talk.table if as_on_talk else table,
            mesh=talk.mesh if "mesh" in offered and self.mesh.currentData() == ON_TALK else None,
            idle=idle,
        )

    # -- how it is made -----------------------------------------------------------------------------------

    def _make_choices(self) -> None:
        talk, name = self._face.options, tr(ON_TALK_WORDS).format(name=Path(self._face.table).name)
        kinds = [kind for kind in EXPORT_KINDS.values() if not self._is_text or kind.name in FORMATS]
        self.kind = choice((f"{tr(kind.words)} ({kind.name})", kind.name) for kind in kinds)
        self.kind.setCurrentIndex(max(0, self.kind.findData(read(self._settings, "export/kind", "rhubarb-json"))))
        self.heard, self.timing = QComboBox(), QComboBox()
        tables = [(tr(USUAL), None), *((table, table) for table in shipped_tables())]
        self.table = choice([(name, ON_TALK), *tables])
        by_talk = tr(ON_TALK_WORDS).format(name=tr(self._face.driver.driver.caption))
        self.driver = choice([(by_talk, ON_TALK), (tr(FaceDriver.RULES.caption), None)])
        meshes: list[tuple[str, str | None]] = [(tr("the program's own head"), None)]
        if talk.mesh is not None:
            meshes.insert(0, (tr(ON_TALK_WORDS).format(name=Path(talk.mesh).name), ON_TALK))
        self.mesh = choice(meshes)
        self.expression = choice([(tr("as on Talk"), ON_TALK), (tr("no expression"), None)])
        self.detail = choice((tr(words), detail) for detail, words in DETAILS.items())
        self.detail.setCurrentIndex(self.detail.findData(talk.idle.detail))
        self.rate = _number("fps", unit=" " + tr("frames/s"), decimals=2, below=1.0)
        self.minimum = _number("minimum", unit=" s", decimals=3, step=0.01)
        self.minimum.setValue(MINIMUM)
        self.anticipation = _number("anticipation", unit=" s", decimals=2, step=0.01, below=0.01)
        self.seed = QSpinBox()
        self.seed.setRange(0, 999_999)
        self.seed.setValue(talk.idle.seed)
        self.blinks, self.head = QCheckBox(tr("the eyes blink")), QCheckBox(tr("the head moves"))
        self.blinks.setChecked(talk.idle.blinks)
        self.head.setChecked(talk.idle.head)

    def _offer_timing(self, sounds: list[Path]) -> None:
        """Offer when words are said: as recognised, as files beside the sounds say, or as the window knows."""
        words = self._face.words
        self.timing.addItem(tr("recognition only"), NO_TEXTS)
        self.timing.addItem(tr("words or text beside each sound"), None)
        if words.keys() & {*sounds}:
            n = sum(len(utterance.words) for utterance in words.values())
            self.timing.addItem(tr("aligned words ({n})").format(n=n), SpokenTexts(scripts=words))
            self.timing.setCurrentIndex(self.timing.count() - 1)

    def _make_files(self) -> None:
        self.files = named(QTableWidget(0, len(COLUMNS)), tr("sounds that are exported"))
        self.files.setHorizontalHeaderLabels(list(map(tr, COLUMNS)))
        self.files.verticalHeader().hide()
        self.files.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.files.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        let_copy(self.files)
        header = self.files.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        self.preview = named(QPlainTextEdit(), tr("what a sound becomes"))
        self.preview.setReadOnly(True)
        self.preview.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.preview.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.preview.setPlaceholderText(tr("Preview shows what the first, or the chosen, sound becomes."))

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
        named(self.folder, tip=tr("Where the new files go"))
        self.told = label(wraps=True)
        self.bar = QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)

    def _lay_out(self) -> None:
        self._form = QFormLayout()
        rows: tuple[tuple[str, QWidget], ...] = (
            (tr("Becomes"), self.kind),
            (tr("Heard with"), self.heard),
            (tr("Timing"), self.timing),
            (tr("Moved by"), self.driver),
            (tr("Mouth table"), self.table),
            (tr("Face"), self.mesh),
            (tr("Expression"), self.expression),
            (tr("Rate"), self.rate),
            (tr("Shortest cue"), self.minimum),
            (tr("Mouth ahead"), self.anticipation),
            (tr("Follows"), self.detail),
            (tr("Seed"), self.seed),
            ("", self.blinks),
            ("", self.head),
            (tr("Goes"), self.folder),
        )
        for words, widget in rows:
            self._form.addRow(words, named(widget, words or str(widget.property("text"))))
        for box in (self.kind, self.heard, self.driver, self.table, self.mesh):
            box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.kind.setMinimumContentsLength(28)
        left = column(self._form, 1, margins=None)
        listing = row(self.add_files, self.add_folder, self.remove, 1, self.look)
        right = column(listing, (self.files, 3), (self.preview, 2))
        ends = row((self.told, 1), self.start, self.cancel, self.shut)
        column((row(left, (right, 1)), 1), self.bar, ends, on=self, margins=None)

    def _connect(self) -> None:
        self.kind.currentIndexChanged.connect(self._show_kind)
        self.heard.currentIndexChanged.connect(self.preview.clear)
        self.timing.currentIndexChanged.connect(self._show_kind)
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
        """Show the choices that make a difference to the format, and no others."""
        kind = EXPORT_KINDS[self.kind.currentData()]
        options, knows_words = kind.options, self._is_text or self.timing.currentData() != NO_TEXTS
        has_mesh = self.mesh.count() > 1 and (self._face.movestates is None or kind.name not in FORMATS)
        shown: dict[QWidget, bool] = {
            self.table: "table" in options,
            self.rate: "fps" in options,
            self.minimum: "minimum" in options,
            self.anticipation: "anticipation" in options,
            self.detail: "detail" in options,
            self.seed: "seed" in options,
            self.blinks: "no-blinks" in options,
            self.head: "no-head" in options,
            self.driver: "text-driver" in options and knows_words,
            self.mesh: "mesh" in options and has_mesh,
            self.expression: "expression" in options and self._face.options.idle.expression is not None,
            self.timing: not self._is_text and kind.has_words,
            self.heard: not self._is_text,
        }
        for widget, is_shown in shown.items():
            widget.setEnabled(is_shown)
            self._form.setRowVisible(widget, is_shown)
        self._offer_table("text-driver" in options)
        self.preview.clear()
        self._show_files()

    def _offer_table(self, fits: bool) -> None:
        """Offer the table of Talk, and first, where a format takes the whole face; drawings have their own shapes."""
        place = self.table.findData(ON_TALK)
        if fits and place < 0:
            self.table.insertItem(0, tr(ON_TALK_WORDS).format(name=Path(self._face.table).name), ON_TALK)
            self.table.setCurrentIndex(0)
        elif not fits and place >= 0:
            self.table.removeItem(place)

    def _show_files(self) -> None:
        self.queue.jobs = []
        targets = targets_of(self._sounds, self._folder, EXPORT_KINDS[self.kind.currentData()].ending)
        self._shown.clear()
        self.files.setRowCount(len(self._sounds))
        for place, sound in enumerate(self._sounds):
            self._show_row(place, (self._name_of(sound), "", "", str(targets[sound])))
        self._show_progress()

    def _show_progress(self) -> None:
        for place, job in enumerate(self.queue.jobs):
            length = format_clock(job.duration, fine=True) if job.duration else ""
            cells = self._name_of(job.source), length, tr(job.state.value), job.words or _with_notes(job)
            self._show_row(place, cells)
        busy = self.queue.busy
        self.bar.setValue(round(1000 * self.queue.progress) if self.queue.jobs else 0)
        self.start.setEnabled(bool(self._sounds) and not busy)
        self.look.setEnabled(bool(self._sounds))
        self.cancel.setEnabled(busy)
        for widget in (self.folder, self.kind, self.heard):
            widget.setEnabled(not busy)
        for button in (self.add_files, self.add_folder, self.remove):
            button.setEnabled(not busy and not self._is_text)
        self.timing.setEnabled(not busy and EXPORT_KINDS[self.kind.currentData()].has_words)

    def _name_of(self, sound: Path) -> str:
        return tr("the text on Talk") if sound == TEXT else sound.name

    def _show_row(self, place: int, cells: tuple[str, ...]) -> None:
        if self._shown.get(place) == cells:
            return
        self._shown[place] = cells
        for k, words in enumerate(cells):
            item = QTableWidgetItem(words)
            item.setToolTip(words)
            self.files.setItem(place, k, item)

    def _show_end(self) -> None:
        states = [job.state for job in self.queue.jobs]
        parts = [f"{states.count(state)} {tr(state.value)}" for state in ExportState if state in states]
        self.told.setText(", ".join(parts))
        self._show_progress()

    # -- what the user asks for ---------------------------------------------------------------------------

    def _ask_files(self) -> None:
        self.add(self._asker.ask_files(tr("Sounds to export"), tr("All files (*)"), "sound"))

    def _ask_folder(self) -> None:
        if folder := self._asker.ask_folder(tr("A folder of sounds"), self._asker.folder_of("sound")):
            self.add([folder])

    def _ask_target(self) -> None:
        folder = self._asker.ask_folder(tr("Where the new files go"), self._asker.folder_of("export"))
        if folder is not None:
            self._asker.remember("export", folder)
        elif self._is_text:
            return  # a text lies nowhere, so that nothing can go beside it
        self._folder = folder
        self.folder.setText(str(folder or tr(BESIDE)))
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
            QMessageBox.Icon.Question,
            tr("Replace files?"),
            words.format(n=len(there), name=targets[there[0]].name),
            parent=self,
        )
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


def _number(option: str, *, unit: str, decimals: int, step: float = 1.0, below: float = 0.0) -> NumberField:
    """Make the field of an option, with its limits; the value that is so much below them stands for what is usual."""
    low, high = OPTIONS[option].limits or (0.0, 0.0)
    field = NumberField(low - below, high, decimals=decimals, step=step, unit=unit)
    if below:
        field.setSpecialValueText(tr(USUAL))
        field.setValue(low - below)
    return field
