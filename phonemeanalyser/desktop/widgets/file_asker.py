"""Which file or folder the user wants, by the dialogs of the system; and what becomes of what is in no file yet."""

import re
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QEvent, QObject, QSettings, Signal
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QApplication, QFileDialog, QMessageBox, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.settings import outside_program
from phonemeengine.audio.files import SUFFIXES
from phonemeengine.storage.files import free_path

Mode = QFileDialog.FileMode
ShowDialog = Callable[[Mode, str, str, str], tuple[list[str], str]]
"""Takes what is asked for, title, place and filters; gives what was chosen, and the filter that was on."""


def show_dialog(mode: Mode, title: str, place: str, filters: str) -> tuple[list[str], str]:
    """Ask by a dialog over the window in use."""
    parent = QApplication.activeModalWidget() or QApplication.activeWindow()
    if mode is Mode.Directory:
        return [QFileDialog.getExistingDirectory(parent, title, place)], ""
    if mode is Mode.ExistingFiles:
        return QFileDialog.getOpenFileNames(parent, title, place, filters)
    ask = QFileDialog.getSaveFileName if mode is Mode.AnyFile else QFileDialog.getOpenFileName
    name, chosen = ask(parent, title, place, filters)
    return [name], chosen


def audio_filters() -> str:
    """Return the filters of a dialog that asks for sound: audio and video files, then all."""
    patterns = " ".join(f"*{suffix}" for suffix in sorted(SUFFIXES))
    return tr("Audio and video files ({patterns});;All files (*)").format(patterns=patterns)


class FileDrops(QObject):
    """Takes the files that the user drags from elsewhere onto a widget.

    Parameters
    ----------
    widget : that they are dropped onto.
    welcome : says whether they are taken now.

    Signals
    -------
    dropped : their paths.
    refused : a sentence on what is no file of this computer.
    """

    dropped = Signal(list)
    refused = Signal(str)

    def __init__(self, widget: QWidget, welcome: Callable[[], bool] = lambda: True) -> None:
        super().__init__(widget)
        self._welcome = welcome
        widget.setAcceptDrops(True)
        widget.installEventFilter(self)

    @override
    def eventFilter(self, _widget: QObject, event: QEvent) -> bool:
        if event.type() not in {QEvent.Type.DragEnter, QEvent.Type.Drop}:
            return False
        assert isinstance(event, QDropEvent)
        if event.mimeData().hasUrls() and self._welcome():
            event.acceptProposedAction()
            if event.type() == QEvent.Type.Drop:
                self._take(event)
        return True

    def _take(self, event: QDropEvent) -> None:
        urls = event.mimeData().urls()
        self.dropped.emit([Path(url.toLocalFile()) for url in urls if url.isLocalFile()])
        for url in urls:
            if not url.isLocalFile():
                sentence = tr("{url} cannot be opened, since only files on this computer can. Save it here first.")
                self.refused.emit(sentence.format(url=url.toString()))


class FileAsker:
    """Asks for files and folders, and begins where the last of their kind was.

    Parameters
    ----------
    settings : where the folder of each kind is kept.

    Attributes
    ----------
    show : shows a dialog; that of the system, unless another is handed in.
    """

    def __init__(self, settings: QSettings, show: ShowDialog = show_dialog) -> None:
        self._settings = settings
        self.show = show

    def folder_of(self, kind: str, default: Path | None = None) -> Path:
        """Return the folder where something of a kind was last; the default, or the user's own, before that."""
        return Path(str(self._settings.value(f"folder/{kind}", str(default or Path.home()))))

    def ask_file(self, title: str, filters: str, kind: str = "", default: Path | None = None) -> Path | None:
        """Let the user choose a file that is there."""
        return _first(self._ask(Mode.ExistingFile, title, self.folder_of(kind, default), filters, kind)[0])

    def ask_files(self, title: str, filters: str, kind: str) -> list[Path]:
        """Let the user choose files that are there."""
        return self._ask(Mode.ExistingFiles, title, self.folder_of(kind), filters, kind)[0]

    def ask_folder(self, title: str, place: Path) -> Path | None:
        """Let the user choose a folder; it is not remembered."""
        return _first(self._ask(Mode.Directory, title, place)[0])

    def ask_target(
        self, title: str, suggested: Path, filters: str, kind: str = "", *, other_endings: bool = False
    ) -> Path | None:
        """Let the user choose a file to write; where its name lacks an ending, add that of the chosen filter.

        Such a name replaces nothing, since no question was asked. With `other_endings`, one that no filter has stays,
        for the engine to refuse; that of "demo 0.10-0.25" is none. What is suggested beside the demo is in Documents.
        """
        suggested = outside_program(suggested, make_folder=True)
        paths, chosen = self._ask(Mode.AnyFile, title, suggested, filters, kind)
        path = _first(paths)
        if path is None:
            return None
        known = _endings_of(filters)
        ends = path.suffix.lower() in map(str.lower, known) or (other_endings and any(map(str.isalpha, path.suffix)))
        return path if ends else free_path(path.with_name(path.name + (*_endings_of(chosen), *known)[0]))

    def remember(self, kind: str, folder: Path) -> None:
        """Begin in this folder when something of the kind is asked for next."""
        self._settings.setValue(f"folder/{kind}", str(folder))

    def _ask(self, mode: Mode, title: str, place: Path, filters: str = "", kind: str = "") -> tuple[list[Path], str]:
        names, chosen = self.show(mode, title, str(place), filters)
        paths = [Path(name) for name in names if name]
        if paths and kind:
            self.remember(kind, paths[0].parent)
        return paths, chosen


def ask_to_save(window: QWidget, title: str, question: str, save: Callable[[], bool]) -> bool:
    """Ask what is to become of what is in no file yet; return whether to go on."""
    buttons = QMessageBox.StandardButton
    offered = buttons.Save | buttons.Discard | buttons.Cancel
    answer = QMessageBox.question(window, title, question, offered, buttons.Save)
    return save() if answer == buttons.Save else answer == buttons.Discard


def _endings_of(filters: str) -> list[str]:
    """Return the endings that filters name, such as .toml of "Presets (*.toml)"."""
    return re.findall(r"\*(\.\w+)", filters)


def _first(paths: list[Path]) -> Path | None:
    return paths[0] if paths else None
