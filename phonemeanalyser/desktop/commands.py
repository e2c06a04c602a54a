"""The commands of the menus, as tables: text, key, and what is done."""

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QAction, QGuiApplication
from PySide6.QtWidgets import QMenu, QWidget

from phonemeanalyser.desktop.analyse.lanes.label_dialogs import LabelDialogs
from phonemeanalyser.desktop.analyse.lanes.selection_dialogs import SelectionDialogs
from phonemeanalyser.desktop.analyse.page import AnalysisPage
from phonemeanalyser.desktop.analyse.transport.transport import SPEEDS, next_speed
from phonemeanalyser.desktop.dialogs import Dialogs
from phonemeanalyser.desktop.language import LANGUAGES, SYSTEM, tr, tr_noop
from phonemeanalyser.desktop.menus import Command, Menus
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.selection import Selection
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.settings import read
from phonemeanalyser.desktop.widgets.phoneme_keys import KEYS
from phonemeengine.phonemes import Phoneme

Commands = tuple[Command, ...]
PRESET_COMMANDS = (
    tr_noop("Load Preset…"),
    tr_noop("Save Preset"),
    tr_noop("Save Preset As…"),
    tr_noop("Preset Notes…"),
)
PAGES = (tr_noop("Analyse"), tr_noop("Calibrate"), tr_noop("Talk"))


def file_commands(dialogs: Dialogs) -> Commands:
    """Return what opens and saves files."""
    return (
        Command(tr_noop("Open Sound…"), "Ctrl+O", dialogs.ask_sound),
        Command(tr_noop("Save the Phonemes…"), "Ctrl+E", dialogs.ask_save_phonemes),
        Command(tr_noop("Export…"), "Ctrl+Shift+E", dialogs.show_export),
        Command(tr_noop("Load Preset…"), "Ctrl+Shift+O", dialogs.ask_preset),
        Command(tr_noop("Save Preset"), "Ctrl+S", dialogs.save),
        Command(tr_noop("Save Preset As…"), "Ctrl+Shift+S", dialogs.save_as),
        Command(tr_noop("Preset Notes…"), "Ctrl+N", dialogs.ask_notes),
        Command(tr_noop("Ship Preset…"), "", dialogs.show_ship),
        Command(tr_noop("Speech Encoder…"), "", dialogs.show_encoder),
        Command(tr_noop("Load Curve…"), "Ctrl+L", dialogs.ask_curves),
        Command(tr_noop("Save Curve…"), "Ctrl+Shift+L", dialogs.ask_save_curve),
    )


def play_commands(session: Session) -> Commands:
    """Return what moves the sound in hand."""
    playback = session.playback
    return (
        Command(tr_noop("Play or Pause"), "Space", session.toggle),
        Command(tr_noop("Stop"), "Escape", session.stop),
        Command(tr_noop("Loop"), "L", playback.set_loop, checkable=True),
        Command(tr_noop("Back 1 s"), "Ctrl+Left", lambda: session.seek(session.source.position - 1), repeats=True),
        Command(
            tr_noop("Forward 1 s"), "Ctrl+Right", lambda: session.seek(session.source.position + 1), repeats=True
        ),
        Command(tr_noop("To the Beginning"), "Home", lambda: session.seek(0)),
        Command(tr_noop("To the End"), "End", lambda: session.seek(session.source.duration)),
        Command(tr_noop("Louder"), "Ctrl+Up", lambda: playback.set_volume(playback.volume + 3), repeats=True),
        Command(
            tr_noop("Slower"),
            "Ctrl+Shift+Left",
            lambda: playback.set_speed(next_speed(playback.speed, SPEEDS)),
            repeats=True,
        ),
        Command(
            tr_noop("Faster"),
            "Ctrl+Shift+Right",
            lambda: playback.set_speed(next_speed(playback.speed, SPEEDS[::-1])),
            repeats=True,
        ),
        Command(tr_noop("Quieter"), "Ctrl+Down", lambda: playback.set_volume(playback.volume - 3), repeats=True),
    )


def selection_commands(selection: Selection, dialogs: SelectionDialogs) -> Commands:
    """Return what is done with the selected part of a file."""
    return (
        Command(tr_noop("Select All"), "Ctrl+A", selection.select_all),
        Command(tr_noop("Zoom to the Whole File"), "Shift+A", selection.show_all),
        Command(tr_noop("Play Selection"), "Shift+Space", selection.play),
        Command(tr_noop("Loop Selection"), "Shift+L", lambda: selection.play(loop=True)),
        Command(tr_noop("Zoom to Selection"), "Shift+Z", selection.zoom),
        Command(tr_noop("Measure Selection"), "Shift+M", selection.measure),
        Command(tr_noop("Average Its Spectrum"), "", selection.average),
        Command(tr_noop("Copy Its Frames as a Table"), "Ctrl+Shift+C", dialogs.copy_frames),
        Command(tr_noop("Save Selection as Sound…"), "", dialogs.ask_save),
    )


def add_selection_menu(
    menus: Menus,
    selection: Selection,
    dialogs: SelectionDialogs,
    use_as_take: Callable[[Phoneme], object],
    view: QWidget,
    pictures: Dialogs,
) -> None:
    """List what is done with the selected part of a file in the menu bar, and in the menu of its view."""
    menu = menus.add(tr("&Selection"), *selection_commands(selection, dialogs))
    takes = menu.addMenu(tr("Use as a Take of"))
    for phoneme in KEYS:
        takes.addAction(phoneme.label, partial(use_as_take, phoneme))
    view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
    view.addActions(menu.actions())
    for words, act in (
        (tr("Copy Picture"), lambda: QGuiApplication.clipboard().setPixmap(view.grab())),
        (tr("Save Picture…"), lambda: pictures.ask_save_picture(view, "file")),
    ):
        picture = QAction(words, view)
        picture.triggered.connect(lambda _checked, act=act: act())
        view.addAction(picture)


class RecentMenu(QMenu):
    """Lists the sounds that were opened last, the last one first."""

    def __init__(self, dialogs: Dialogs, window: QWidget) -> None:
        super().__init__(tr("Open Recent"), window)
        self._dialogs = dialogs
        dialogs.sound_opened.connect(self._fill)
        self._fill()

    def _fill(self) -> None:
        self.clear()
        for path in self._dialogs.recent_sounds():
            self.addAction(str(path), partial(self._dialogs.open_sound, path))
        self.setEnabled(not self.isEmpty())


def label_commands(labels: LabelDialogs) -> Commands:
    """Return what is done with the labels of a file."""
    return (
        Command(tr_noop("Next Error"), "N", labels.next_error, repeats=True),
        Command(tr_noop("Previous Error"), "Shift+N", partial(labels.next_error, back=True), repeats=True),
        Command(tr_noop("Insert Label…"), "Ctrl+I", labels.ask_insert),
        Command(tr_noop("Rename Label…"), "F2", labels.ask_rename),
        Command(tr_noop("Delete Label"), "Delete", labels.delete),
        Command(tr_noop("Tiers…"), "", labels.ask_tiers),
        Command(tr_noop("Load Labels…"), "", labels.ask_load),
        Command(tr_noop("Save Labels"), "Ctrl+Alt+S", labels.save),
        Command(tr_noop("Save Labels As…"), "", labels.ask_save_as),
    )


def record_commands(session: Session, dialogs: Dialogs) -> Commands:
    """Return what belongs to the microphone."""
    return (
        Command(tr_noop("Record"), "R", dialogs.record),
        Command(tr_noop("Look Back"), "Ctrl+B", session.look_back, checkable=True),
        Command(tr_noop("Recordings Folder…"), "", dialogs.ask_recordings_folder),
        Command(tr_noop("Look for Microphones"), "F5", session.microphone.refresh_devices),
        Command(tr_noop("Measure the Latency by Clicks"), "Ctrl+M", dialogs.measure_latency),
    )


def analysis_commands(session: Session, preset: PresetModel, dialogs: Dialogs) -> Commands:
    """Return what belongs to filters and results."""
    return (
        Command(tr_noop("Bypass All Filters"), "B", preset.set_bypassed, checkable=True),
        Command(tr_noop("Second Preset…"), "", dialogs.ask_second_preset),
        Command(tr_noop("Keep This One as the Second"), "", lambda: session.second.take(preset.preset)),
        Command(tr_noop("Hear with the Second"), "X", session.second.switch, checkable=True),
        Command(tr_noop("Forget the Second"), "", lambda: session.second.take(None)),
        Command(tr_noop("Clear"), "C", session.clear),
        Command(tr_noop("Remove Variable…"), "", dialogs.ask_remove_variable),
    )


def view_commands(show_page: Callable[[int], None], analysis: AnalysisPage) -> Commands:
    """Return what chooses what is seen, and how."""
    return (
        *(Command(name, f"Ctrl+{k + 1}", partial(show_page, k)) for k, name in enumerate(PAGES)),
        Command(tr_noop("Coarse Display"), "Shift+C", analysis.set_coarse, checkable=True),
        Command(tr_noop("Spectra in dB"), "D", analysis.set_decibels, checkable=True),
    )


def add_looks(
    menus: Menus,
    view: QMenu,
    settings: QSettings,
    use_theme: Callable[[str], Any],
    use_language: Callable[[str], Any],
) -> None:
    """Add the choices of theme and language to a menu."""
    themes = {"system": tr("system"), "light": tr("light"), "dark": tr("dark")}
    languages = {SYSTEM: tr("system"), **LANGUAGES}
    view.addSeparator()
    menus.add_choice(view, tr("Theme"), themes, read(settings, "theme", "system"), use_theme)
    view.addSeparator()
    menus.add_choice(view, tr("Language"), languages, read(settings, "language", SYSTEM), use_language)
