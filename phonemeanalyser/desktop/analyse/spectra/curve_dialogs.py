"""What the user is asked about averaged spectra: of what, which files, and where to."""

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import QDialog, QListWidget, QListWidgetItem, QSizePolicy, QToolButton, QWidget

from phonemeanalyser.desktop.analyse.spectra.averaged_view import AveragedView
from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_count, tr_noop
from phonemeanalyser.desktop.session.curves import SUFFIX
from phonemeanalyser.desktop.session.selection import NOTHING_SELECTED
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.tasks import TaskQueue, tried
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeengine.calibration.scores.corpus import LabelledUtterance, is_labelled, read_recordings
from phonemeengine.errors import AudioError, CurveError, EngineError
from phonemeengine.inspection import speaker_spectra
from phonemeengine.inspection.averaged_spectrum import AveragedSpectrum, SoundPart, format_distances, format_spectra
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.files import portable_name, write_file

COLUMNS = 5
"""Phonemes in a row."""
SIZE = 420, 440
"""Of the dialog at first, pixels."""


class LabelledSounds(NamedTuple):
    """Labelled recordings, and what they are called."""

    words: str
    utterances: tuple[LabelledUtterance, ...]


class GroupDialog(QDialog):
    """Lets the user choose speakers, phonemes, and what each curve is of; says how much sound that is.

    Attributes
    ----------
    source, by : which recordings, and what each curve is of.
    speakers : a list, of which those count that are ticked.
    phonemes : a button for each.
    told : how much sound that is, or what is missing.
    add : the button that accepts.
    """

    def __init__(self, sources: list[LabelledSounds], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Average by Phoneme"))
        self.resize(*SIZE)
        self._sources = sources
        self.source = builders.choice(((source.words, k) for k, source in enumerate(sources)), tr("Recordings"))
        self.speakers = builders.named(QListWidget(), tr("Speakers"))
        self.by = builders.choice(
            (
                (tr("One curve for each speaker"), speaker_spectra.Grouping.SPEAKER),
                (tr("One curve for each phoneme"), speaker_spectra.Grouping.PHONEME),
                (tr("One curve for each phoneme of each speaker"), speaker_spectra.Grouping.SPEAKER_PHONEME),
            ),
            tr("Curves"),
        )
        self.phonemes: dict[Phoneme, QToolButton] = {}
        self.told = builders.label(wraps=True)
        buttons = builders.dialog_buttons(self, builders.CANCEL, verb=tr("Add"))
        self.add = next(b for b in buttons.buttons() if b is not buttons.button(builders.Button.Cancel))
        builders.column(
            self.source,
            builders.row(
                builders.label(tr("Speakers")),
                1,
                builders.tool_button(tr("All"), tr("Choose all speakers"), act=lambda: self._tick_all(True)),
                builders.tool_button(tr("None"), tr("Choose no speaker"), act=lambda: self._tick_all(False)),
            ),
            (self.speakers, 1),
            builders.row(
                builders.label(tr("Phonemes")),
                1,
                builders.tool_button(
                    tr("Vowels"), tr("Choose the vowels"), act=lambda: self.choose(speaker_spectra.VOWELS)
                ),
                builders.tool_button(
                    tr("All"), tr("Choose all phonemes but silence"), act=lambda: self.choose(tuple(Phoneme))
                ),
            ),
            self._phoneme_buttons(),
            self.by,
            self.told,
            buttons,
            on=self,
            margins=None,
        )
        self.source.currentIndexChanged.connect(self._show_source)
        self.speakers.itemChanged.connect(self._tell)
        self.by.currentIndexChanged.connect(self._tell)
        self._show_source()

    def groups(self) -> speaker_spectra.Groups:
        """Return what the user chose to average."""
        ticked = [item.text() for item in self.items() if item.checkState() is Qt.CheckState.Checked]
        chosen = [phoneme for phoneme, button in self.phonemes.items() if button.isChecked()]
        if not ticked or not chosen:
            return {}
        is_all = len(chosen) == sum(button.isEnabled() for p, button in self.phonemes.items() if p != Phoneme.SILENCE)
        everything = is_all and not self.phonemes[Phoneme.SILENCE].isChecked()
        by = speaker_spectra.Grouping(self.by.currentData())
        return speaker_spectra.groups_of(self._utterances, by, () if everything else chosen, ticked, tr("vowels"))

    def items(self) -> list[QListWidgetItem]:
        """Return the lines of the list of speakers."""
        return [self.speakers.item(k) for k in range(self.speakers.count())]

    def choose(self, phonemes: tuple[Phoneme, ...]) -> None:
        """Choose these phonemes, as far as the recordings have them; silence only by its own button."""
        for phoneme, button in self.phonemes.items():
            with builders.silent(button):
                button.setChecked(button.isEnabled() and phoneme in phonemes and phoneme is not Phoneme.SILENCE)
        self._tell()

    @property
    def _utterances(self) -> tuple[LabelledUtterance, ...]:
        return self._sources[self.source.currentIndex()].utterances

    def _tick_all(self, on: bool) -> None:
        with builders.silent(self.speakers):
            for item in self.items():
                item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
        self.speakers.viewport().update()
        self._tell()

    def _phoneme_buttons(self) -> QWidget:
        body = QWidget()
        places = builders.grid(body, across=4, down=4)
        others = (p for p in reversed(Phoneme) if p not in speaker_spectra.VOWELS)
        for k, phoneme in enumerate((*speaker_spectra.VOWELS, *others)):
            button = self.phonemes[phoneme] = builders.toggle_button(sound_name(phoneme), "")
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.toggled.connect(self._tell)
            places.addWidget(button, k // COLUMNS, k % COLUMNS)
        return body

    def _show_source(self) -> None:
        said = {label.phoneme for utterance in self._utterances for label in utterance.labels}
        with builders.silent(self.speakers):
            self.speakers.clear()
            for name in sorted(set(speaker_spectra.speaker_names(self._utterances).values())):
                item = QListWidgetItem(name, self.speakers)
                item.setCheckState(Qt.CheckState.Checked)
        for phoneme, button in self.phonemes.items():
            button.setEnabled(phoneme in said)
            button.setToolTip("" if phoneme in said else tr("The labels have no such phoneme"))
        self.choose(speaker_spectra.VOWELS if said & set(speaker_spectra.VOWELS) else tuple(Phoneme))

    def _tell(self) -> None:
        groups = self.groups()
        seconds = sum(end - start for parts in groups.values() for part in parts for start, end in part.spans)
        words = tr(
            "1 curve of {seconds:.1f} s of sound" if len(groups) == 1 else "{n} curves of {seconds:.1f} s of sound"
        ).format(n=len(groups), seconds=seconds)
        self.told.setText(
            words if groups else tr("Choose at least one speaker and one phoneme that the labels have.")
        )
        self.add.setEnabled(bool(groups))


CURVE_FILTER = tr_noop("Curves (*.csv)")
TABLE_FILTER = tr_noop("Tables (*.csv)")
Read = tuple[tuple[LabelledUtterance, ...], list[str]] | speaker_spectra.Groups


class CurveDialogs(QObject):
    """Asks, and passes the answers to the table of curves.

    Signals
    -------
    rejected : a sentence for the user; an empty one after something went well.
    info : a sentence for the user about something that went well.
    picture_asked : the user wants to save the picture of the curves.

    Attributes
    ----------
    loaded : gives the takes, and the recordings of the workbench.
    """

    rejected = Signal(str)
    info = Signal(str)
    picture_asked = Signal()

    def __init__(self, window: QWidget, session: Session, files: FileAsker) -> None:
        super().__init__(window)
        self._window, self._session, self._files = window, session, files
        self._curves = session.curves
        self._reading = TaskQueue(self.rejected.emit)
        self.loaded: Callable[[], tuple[LabelledUtterance, ...]] = tuple

    def join(self, view: AveragedView) -> None:
        """Ask what the plot of the curves wants asked, and have it drawn in pictures."""
        view.load_asked.connect(self.ask_load)
        view.save_asked.connect(self.ask_save)
        self.picture_asked.connect(view.menu.ask_save)

    # -- what is averaged ---------------------------------------------------------------------------------

    def add_file(self) -> None:
        """Average all of the current file."""
        path, file = self._session.path, self._session.file
        if path is None or file is None:
            self.rejected.emit(tr("No audio file is open. Open the one that you want to average."))
            return
        self._curves.average(path.stem, [SoundPart(path, self._session.channel, ((0.0, file.duration),))])

    def add_selection(self) -> None:
        """Average what is selected."""
        span, seen = self._session.view.selection, self._session.seen.sound
        if span is None or seen is None:
            self.rejected.emit(tr(NOTHING_SELECTED))
            return
        part = SoundPart(*seen, ((span.start, span.end),))
        name = tr("microphone") if self._session.seen.looks_back else part.path.stem
        self._curves.average(f"{name} {span.start:.2f}-{span.end:.2f} s", [part])

    def add_microphone(self) -> None:
        """Average what the microphone recorded since Clear."""
        microphone = self._session.microphone
        past = None if microphone.since_clear is None else microphone.since_clear.snapshot()
        if past is None:
            self.rejected.emit(
                tr("The microphone has recorded nothing since Clear. Use it first, then add its average.")
            )
            return
        try:
            part = speaker_spectra.whole_file(past)
        except EngineError as error:
            self.rejected.emit(str(error))
            return
        self._curves.average(microphone.name, [part])

    def ask_by_phoneme(self) -> None:
        """Let the user choose phonemes and speakers of all labels that are loaded."""
        sources = []
        path, said = self._session.path, self._session.labels.said_labels()
        if path is not None and said:
            utterance = LabelledUtterance(path, said, path.stem, path.parent.name, self._session.channel)
            sources.append(LabelledSounds(tr("This file: {name}").format(name=path.name), (utterance,)))
        if loaded := self.loaded():
            words = tr_count("Calibrate: 1 recording", "Calibrate: {n} recordings", len(loaded))
            sources.append(LabelledSounds(words, loaded))
        if not sources:
            self.rejected.emit(
                tr(
                    "There are no labels yet. Open a sound with a label file beside it, record takes, load labelled "
                    "recordings on Calibrate, or choose Add > Folder."
                )
            )
            return
        self._ask_groups(sources)

    def ask_folder(self) -> None:
        """Let the user choose a folder; of labelled recordings, then phonemes and speakers too."""
        folder = self._files.ask_folder(tr("Folder to Average"), self._files.folder_of("speakers"))
        if folder is not None:
            self._files.remember("speakers", folder)
            self._reading.submit(lambda _progress: _read(folder), lambda found: self._take_folder(folder, found))

    def _take_folder(self, folder: Path, found: Read) -> None:
        if isinstance(found, dict):
            self._curves.add_groups(found)
            return
        utterances, refused = found
        if refused:
            self.rejected.emit(
                tr("{n} audio files were skipped. The first one: {refusal}").format(
                    n=len(refused), refusal=tr_engine(refused[0])
                )
            )
        self._ask_groups([LabelledSounds(tr("Folder: {name}").format(name=folder.name), utterances)])

    def _ask_groups(self, sources: list[LabelledSounds]) -> None:
        dialog = GroupDialog(sources, self._window)
        if dialog.exec():
            self._curves.add_groups(dialog.groups())
        dialog.deleteLater()

    # -- files --------------------------------------------------------------------------------------------

    def ask_load(self) -> None:
        """Let the user choose curves to compare with."""
        for path in self._files.ask_files(tr("Load Curves"), tr(CURVE_FILTER), "curve"):
            self.load(path)

    def load(self, path: Path) -> None:
        """Load a curve into the table."""
        self.rejected.emit("")
        tried(lambda: self._curves.load(path), self._tell)

    def ask_save(self) -> None:
        """Let the user choose a file for the running mean; where there is none, for what is chosen in the table."""
        averages, source = self._session.averages, self._session.source
        if not averages.n_frames:
            self.ask_save_chosen()
            return
        name = f"{Path(source.name).stem} {averages.current().seconds:.1f} s"
        if path := self._ask_target(tr("Save Averaged Spectrum"), name):
            self.rejected.emit("")
            tried(lambda: self._curves.add([averages.save(path)]), self._tell)

    def ask_save_chosen(self) -> None:
        """Let the user choose where to save what is chosen in the table, or all that is shown."""
        places = self._chosen()
        if not places:
            self.rejected.emit(tr("There is no averaged spectrum yet. Play a sound, or add one to the table first."))
        elif len(places) == 1:
            if path := self._ask_target(tr("Save Averaged Spectrum"), self._curves.curves[places[0]].name):
                tried(lambda: self._curves.save(places, path), self._tell)
        elif folder := self._files.ask_folder(tr("Save Averaged Spectra"), self._files.folder_of("curve")):
            self._files.remember("curve", folder)
            tried(lambda: self._curves.save(places, folder), self._tell)

    def ask_export(self) -> None:
        """Let the user choose a file for the levels of all chosen curves, as a table."""
        self._export(tr("Export Levels as CSV"), "averaged spectra", format_spectra)

    def ask_export_differences(self) -> None:
        """Let the user choose a file for the differences of all chosen curves, as a table."""
        self._export(tr("Export Differences as CSV"), "differences", format_distances)

    def _export(self, title: str, name: str, written: Callable[[list[AveragedSpectrum]], str]) -> None:
        curves = [self._curves.curves[place] for place in self._chosen()]
        if not curves:
            self.rejected.emit(tr("There is no averaged spectrum to export yet. Add one to the table first."))
        elif path := self._ask_target(title, name, TABLE_FILTER):

            def act() -> None:
                write_file(path, written(curves).encode(errors="replace"), CurveError)
                self.info.emit(tr("Table saved as {path}").format(path=path))

            tried(act, self._tell)

    def close(self) -> None:
        """End all work."""
        self._reading.close()

    def _chosen(self) -> list[int]:
        """Return the places of what is chosen in the table; of all that is shown where nothing is."""
        curves = self._curves
        return list(curves.chosen) or [k for k, curve in enumerate(curves.curves) if not curve.hidden]

    def _ask_target(self, title: str, name: str, filters: str = CURVE_FILTER) -> Path | None:
        suggested = self._files.folder_of("curve") / f"{portable_name(name)}{SUFFIX}"
        return self._files.ask_target(title, suggested, tr(filters), "curve")

    def _tell(self, sentence: str) -> None:
        """Say what was refused; after something went well, that was said already."""
        if sentence:
            self.rejected.emit(sentence)


def _read(folder: Path) -> Read:
    """Read the labelled recordings in a folder; without labels, what to average of each speaker's."""
    if not is_labelled(folder):
        return speaker_spectra.groups_in(folder)
    refused: list[AudioError] = []
    return read_recordings(folder, on_skipped=refused.append), [str(error) for error in refused]
