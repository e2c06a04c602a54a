"""What the user is asked about the labels of a file: names, tiers, files, changes; and of its selection."""

from pathlib import Path

from PySide6 import QtWidgets
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QGuiApplication, QKeySequence, QShortcut

from phonemeanalyser.desktop.analyse.lanes.file_view import FileView
from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.label_tiers import ChosenLabel, LabelTiers
from phonemeanalyser.desktop.session.selection import Selection
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.settings import in_program
from phonemeanalyser.desktop.widgets.builders import CANCEL, CLOSE, choice, column, dialog_buttons, label, named
from phonemeanalyser.desktop.widgets.file_asker import FileAsker, ask_to_save
from phonemeengine.features.variables import readable_name
from phonemeengine.inspection.measurement import MEASUREMENT_COLUMNS, StretchMeasurement, format_measurement
from phonemeengine.presets.preset import Preset

LABEL_FILTER = tr_noop("Labels (*.TextGrid *.txt *.csv)")
FORMATS = {
    ".TextGrid": tr_noop("Praat TextGrid"),
    ".csv": tr_noop("Corpus table: class, phone, certainty"),
    ".txt": tr_noop("Audacity labels"),
}
"""The formats in which labels are saved, by the endings of names."""
NONE = tr_noop("None")


WHAT_WAS_HEARD = tr_noop(
    "The history can't be labelled, since it isn't an audio file yet. Save a selection of it by the menu "
    "Selection, open that file, and label it."
)


class LabelDialogs(QObject):
    """Asks, and passes the answers to the labels of the session.

    Signals
    -------
    name_asked : the name of the chosen label, or of a new one, is to be typed: its `TimeSpan`, and the name so far.
    """

    name_asked = Signal(object, str)

    def __init__(self, window: QtWidgets.QWidget, session: Session, files: FileAsker) -> None:
        super().__init__(window)
        self._window = window
        self._session = session
        self._labels = session.labels
        self._files = files

    def join(self, view: FileView) -> None:
        """Have labels named in the lanes of a view."""
        self.name_asked.connect(view.ask_name)
        view.rename_asked.connect(self.ask_rename)
        view.split_asked.connect(self.split)
        view.named.connect(self._name)

    # -- errors -------------------------------------------------------------------------------------------

    def next_error(self, *, back: bool = False) -> None:
        """Select the next segment, or the one before, in which something else was recognised than the labels say."""
        session, tracks = self._session, self._session.whole.tracks
        if not self._has_file():
            return
        if tracks is None or self._labels.said_frames() is None:
            session.error.emit(
                tr(
                    "There are no errors to go to, since no tier is compared with the recognised "
                    "phonemes. Load labels with Labels > Load Labels, or choose a tier with Labels "
                    "> Tiers."
                )
            )
            return
        selected = session.view.selection
        found = self._labels.next_error(
            tracks, session.source.position if selected is None else selected.start, back=back
        )
        if found is None:
            before, after = tr("No error before this position."), tr("No error after this position.")
            session.labels.info.emit(before if back else after)
            return
        session.show_segment(TimeSpan(found.start, found.end), found.seen_at)
        said, recognised = sound_name(found.said), sound_name(found.recognised)
        session.labels.info.emit(
            tr("{start:.2f} to {end:.2f} s: labelled {said}, recognised as {recognised}").format(
                start=found.start, end=found.end, said=said, recognised=recognised
            )
        )

    def _has_file(self) -> bool:
        """Say whether there is something to label: a microphone's recording becomes a file first."""
        if self._session.seen.looks_back:
            self._session.error.emit(tr(WHAT_WAS_HEARD))
        return not self._session.seen.looks_back

    # -- labels -------------------------------------------------------------------------------------------

    @property
    def _cursor(self) -> float:
        return self._session.source.position

    def ask_rename(self) -> None:
        """Have the chosen label renamed in its place, or that at the cursor."""
        label = self._in_hand()
        if label is not None:
            self._labels.choose(label)
            self.name_asked.emit(self._labels.span_of(label), self._labels.name_of(label))

    def ask_insert(self) -> None:
        """Have what is selected labelled in its place; without a selection, the gap around the cursor."""
        if not self._has_file():
            return
        span = self._session.view.selection or self._labels.gap_at(self._cursor)
        if self._labels.has_room(span):
            self._labels.choose(None)
            self.name_asked.emit(span, "")

    def _name(self, name: str, span: TimeSpan, step: int) -> None:
        """Give the chosen label, or a new one, the name that was typed; then go on with one beside it."""
        labels, chosen = self._labels, self._labels.chosen
        if chosen is None:
            if name.strip():
                labels.insert(labels.tier_in_use, *span, name)
            return
        if name != labels.name_of(chosen):
            labels.rename(chosen, name)
        labels.choose(chosen if step else None)  # letters are shortcuts again
        if step and labels.choose_beside(self._cursor, step) != chosen:
            self.ask_rename()

    def split(self) -> None:
        """Split the label at the cursor."""
        if self._has_file():
            self._labels.split(self._cursor)
            self._select_chosen()

    def merge(self, *, back: bool = False) -> None:
        """Merge the chosen label, or that at the cursor, with the next one or the one before."""
        label = self._in_hand()
        if label is not None:
            self._labels.merge(label, back=back)
            self._select_chosen()

    def set_edge(self, *, end: bool) -> None:
        """Let the chosen label begin or end at the cursor."""
        if self._has_file():
            self._labels.set_edge(self._cursor, end=end)

    def choose(self, *, step: int = 0, tiers: int = 0) -> None:
        """Choose a label some steps on, or some tiers below, and select it."""
        labels = self._labels
        if tiers:
            labels.choose_tier(self._cursor, tiers)
        else:
            labels.choose_beside(self._cursor, step)
        self._select_chosen()

    def _select_chosen(self) -> None:
        if self._labels.chosen is not None:
            span = self._labels.span_of(self._labels.chosen)
            self._session.view.select(span)
            self._session.view.reveal(span)

    def _in_hand(self) -> ChosenLabel | None:
        label = self._labels.in_hand(self._cursor) if self._has_file() else None
        if label is None and not self._session.seen.looks_back:
            self._session.error.emit(tr("No label is selected. Click one below the sonagram first."))
        return label

    def delete(self) -> None:
        """Delete the chosen label."""
        if self._labels.chosen is None:
            self._session.error.emit(tr("No label is selected. Click one below the sonagram first."))
        else:
            self._labels.delete(self._labels.chosen)

    def ask_tiers(self) -> None:
        """Let the user choose which tiers are shown, and which one says what is said."""
        if not self._labels.tiers:
            self._session.error.emit(tr("There are no tiers yet. Load labels with Labels > Load Labels."))
            return
        dialog = TiersDialog(self._labels, self._window)
        if dialog.exec():
            self._labels.show(dialog.shown(), dialog.said())
        dialog.deleteLater()

    # -- files --------------------------------------------------------------------------------------------

    def ask_load(self) -> None:
        """Let the user choose a label file for the current sound."""
        path = self._session.path
        if path is None:
            self._session.error.emit(tr("No audio file is open. Open the one that the labels belong to."))
            return
        file = self._files.ask_file(tr("Load Labels"), tr(LABEL_FILTER), "labels", path.parent)
        if file is not None and self.may_leave():
            self._labels.load(file)

    def save(self) -> bool:
        """Save the labels to their file, or to one that the user chooses."""
        path = self._labels.path
        return self.ask_save_as() if path is None or in_program(path) else self._labels.save(path)

    def ask_save_as(self) -> bool:
        """Let the user choose a file to save the labels to; says whether they were saved."""
        sound = self._session.path
        if sound is None or not self._labels.tiers:
            self._session.error.emit(
                tr("There are no labels to save. Select a segment and press Ctrl+I to label it.")
            )
            return False
        dialog = FormatDialog(self._labels, self._window)
        taken, suffix = dialog.exec(), dialog.format.currentData()
        dialog.deleteLater()
        if not taken:
            return False
        suggested = (self._labels.path or sound).with_suffix(suffix)
        path = self._files.ask_target(tr("Save Labels"), suggested, f"{tr(FORMATS[suffix])} (*{suffix})", "labels")
        return path is not None and self._labels.save(path)

    def may_leave(self) -> bool:
        """Ask what is to become of labels that were changed and not saved; says whether to go on."""
        sound = self._session.path
        if not self._labels.has_unsaved_changes or sound is None:
            return True
        question = tr("Save the changes to the labels of {sound}?").format(sound=sound.name)
        return ask_to_save(self._window, tr("Unsaved Labels"), question, self.save)


class FormatDialog(QtWidgets.QDialog):
    """Asks in which format labels are saved, and says what each loses of them.

    Attributes
    ----------
    format : the choice, endings of file names as data.
    loses : what the chosen one does not keep.
    """

    def __init__(self, labels: LabelTiers, parent: QtWidgets.QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Save Labels"))
        self._labels = labels
        self.format = choice(((tr(words), suffix) for suffix, words in FORMATS.items()), tr("Format"))
        self.loses = label("")
        self.loses.setWordWrap(True)
        self.loses.setMinimumWidth(360)
        self.format.currentIndexChanged.connect(lambda _k: self._show_losses())
        if labels.path is not None:
            endings = [suffix.lower() for suffix in FORMATS]
            self.format.setCurrentIndex(max(0, endings.index(labels.path.suffix.lower())))
        self._show_losses()
        column(self.format, self.loses, dialog_buttons(self, CANCEL, verb=tr("Save…")), on=self, margins=None)

    def _show_losses(self) -> None:
        lost = self._labels.lost_in(Path(f"labels{self.format.currentData()}"))
        words = tr("Keeps everything.")
        if lost:
            words = tr("Saves a copy without {lost}.").format(lost=", ".join(lost))
        self.loses.setText(words)


class TiersDialog(QtWidgets.QDialog):
    """Asks which tiers are shown, and which one says what is said.

    Attributes
    ----------
    list : the tiers, each with a check mark.
    says : the choice of the one that is compared with what is recognised.
    """

    def __init__(self, labels: LabelTiers, parent: QtWidgets.QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Tiers"))
        self.list = named(QtWidgets.QListWidget(), tr("Visible tiers"))
        self.says = choice([(tr(NONE), None)], tr("Tier to compare with the recognised phonemes"))
        for k, tier in enumerate(labels.tiers):
            n = len(tier.raw_labels)
            held = tr("{n} points") if tier.points else tr("{n} labels")
            item = QtWidgets.QListWidgetItem(f"{tier.name} ({held.format(n=n)})")
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            item.setCheckState(Qt.CheckState.Checked if k in labels.state.shown else Qt.CheckState.Unchecked)
            self.list.addItem(item)
            self.says.addItem(tier.name)
        self.says.setCurrentIndex(0 if labels.state.said is None else labels.state.said + 1)
        column(
            label(tr("Show below the sonagram:")),
            self.list,
            label(tr("Compare with the recognised phonemes:")),
            self.says,
            dialog_buttons(self, CANCEL, verb=tr("Apply")),
            on=self,
            margins=None,
        )

    def shown(self) -> list[int]:
        """Return the numbers of the tiers that are to be shown."""
        return [k for k in range(self.list.count()) if self.list.item(k).checkState() is Qt.CheckState.Checked]

    def said(self) -> int | None:
        """Return the number of the tier that says what is said."""
        k = self.says.currentIndex() - 1
        return None if k < 0 else k


SIZE = 560, 520
"""Of the dialog at first, pixels."""


class MeasurementDialog(QtWidgets.QDialog):
    """Shows a measurement; Ctrl+C, or a button, copies it for a spreadsheet.

    Attributes
    ----------
    table : a row for each measure.
    copy : the button.
    """

    def __init__(
        self, measurement: StretchMeasurement, sound: str, preset: Preset, parent: QtWidgets.QWidget
    ) -> None:
        super().__init__(parent)
        self._text = format_measurement(measurement).replace(",", "\t")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(
            tr("Measurements: {start:.3f} to {end:.3f} s of {sound}").format(
                start=measurement.start, end=measurement.end, sound=sound
            )
        )
        self.resize(*SIZE)
        rows = measurement.rows()
        self.table = named(QtWidgets.QTableWidget(len(rows), len(MEASUREMENT_COLUMNS)), tr("Measurements"))
        self.table.setHorizontalHeaderLabels(list(map(tr, MEASUREMENT_COLUMNS)))
        self.table.verticalHeader().hide()
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.ResizeMode.ResizeToContents)
        self.table.horizontalHeader().setSectionResizeMode(0, QtWidgets.QHeaderView.ResizeMode.Stretch)
        for k, row in enumerate(rows):
            for place, words in enumerate(row):
                item = QtWidgets.QTableWidgetItem(
                    words if place else sound_name(tr_engine(readable_name(words, preset.variables)))
                )
                item.setToolTip("" if place else words)
                if place > 1:
                    item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self.table.setItem(k, place, item)
        told = label(
            tr(
                "Recognised with the preset {preset}. Pitch and formants: of the voiced frames. Level: root mean "
                "square (mean) and largest sample (max), dBFS. Phonemes: shares of all frames."
            ).format(preset=preset.name),
            wraps=True,
        )
        buttons = dialog_buttons(self, CLOSE)
        self.copy = buttons.addButton(tr("Copy"), QtWidgets.QDialogButtonBox.ButtonRole.ActionRole)
        self.copy.setToolTip(tr("Copy the table as tab-separated text"))
        self.copy.clicked.connect(self.copy_table)
        QShortcut(QKeySequence(QKeySequence.StandardKey.Copy), self, self.copy_table)
        column(self.table, told, buttons, on=self, margins=None)

    def copy_table(self) -> None:
        """Put the table on the clipboard."""
        QGuiApplication.clipboard().setText(self._text)


class SelectionDialogs(QObject):
    """Asks where the selected sound goes, and shows what was measured."""

    def __init__(self, window: QtWidgets.QWidget, selection: Selection, session: Session, files: FileAsker) -> None:
        super().__init__(window)
        self._window = window
        self._selection = selection
        self._session = session
        self._files = files
        selection.measured.connect(self.show_measurement)

    def show_measurement(self, measurement: StretchMeasurement) -> None:
        """Show what was measured, beside the window."""
        preset = self._session.preset.in_force
        MeasurementDialog(measurement, self._session.source.name, preset, self._window).show()

    def copy_frames(self) -> None:
        """Put the selected frames on the clipboard as a table."""
        text = self._selection.frames_as_text()
        if text:
            QGuiApplication.clipboard().setText(text)
            self._selection.info.emit(
                tr("Copied {n} frames as a table; paste them into a spreadsheet.").format(n=text.count(chr(10)) - 1)
            )

    def ask_save(self) -> None:
        """Let the user choose a file to save the selected sound to."""
        span, path = self._selection.span, self._session.path
        if span is None or path is None:
            return
        suggested = self._files.folder_of("stretch", path.parent) / f"{path.stem} {span.start:.2f}-{span.end:.2f}.wav"
        if target := self._files.ask_target(
            tr("Save Selection as Audio File"), suggested, "WAV (*.wav)", "stretch", other_endings=True
        ):
            self._selection.save(target)
