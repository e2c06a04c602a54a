"""The commands of the menus, as tables: text, key, and what is done."""

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QAction, QGuiApplication
from PySide6.QtWidgets import QMenu, QWidget

from phonemeanalyser.desktop.analyse.lanes.label_dialogs import LabelDialogs, SelectionDialogs
from phonemeanalyser.desktop.analyse.lanes.score_strip import ScoreStrip
from phonemeanalyser.desktop.analyse.page import AnalysisPage
from phonemeanalyser.desktop.analyse.transport.transport import SPEEDS, next_speed
from phonemeanalyser.desktop.dialogs import Dialogs
from phonemeanalyser.desktop.docks import Docks
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import LANGUAGES, SYSTEM, tr, tr_noop
from phonemeanalyser.desktop.menus import Command, Commands, Menus
from phonemeanalyser.desktop.session.preset import A, PresetModel
from phonemeanalyser.desktop.session.selection import Selection
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.settings import read
from phonemeanalyser.desktop.welcome import WelcomeCards
from phonemeanalyser.desktop.widgets.keyboard import KEYS
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

PRESET_COMMANDS = (tr_noop("Save Preset"), tr_noop("Save Preset As…"), tr_noop("Preset Notes…"))
PAGES = (tr_noop("Analyse"), tr_noop("Calibrate"), tr_noop("Talk"))


def file_commands(dialogs: Dialogs, choose_preset: Callable[[], object]) -> Commands:
    """Return what opens and saves files."""
    return (
        Command(tr_noop("Open Audio File…"), "Ctrl+O", dialogs.ask_sound),
        Command(tr_noop("Save Phonemes…"), "Ctrl+E", dialogs.ask_save_phonemes),
        Command(tr_noop("Export…"), "Ctrl+Shift+E", dialogs.show_export),
        None,
        Command(tr_noop("Load Preset…"), "Ctrl+Shift+O", choose_preset),
        Command(tr_noop("Save Preset"), "Ctrl+S", dialogs.presets.save),
        Command(tr_noop("Save Preset As…"), "Ctrl+Shift+S", dialogs.presets.save_as),
        Command(tr_noop("Preset Notes…"), "Ctrl+N", dialogs.presets.ask_notes),
        None,
        Command(tr_noop("Ship Preset…"), "", dialogs.presets.show_ship),
        Command(tr_noop("Serve…"), "", dialogs.presets.show_serve),
        Command(tr_noop("Speech Encoder…"), "", dialogs.presets.show_encoder),
        None,
        Command(tr_noop("Load Curve…"), "Ctrl+L", dialogs.curves.ask_load),
        Command(tr_noop("Save Curve…"), "Ctrl+Shift+L", dialogs.curves.ask_save),
        None,
    )


def play_commands(session: Session) -> Commands:
    """Return what plays the current sound."""
    playback = session.playback
    return (
        Command(tr_noop("Play/Pause"), "Space", session.toggle),
        Command(tr_noop("Stop"), "Escape", session.stop),
        Command(tr_noop("Loop"), "L", playback.set_loop, checkable=True),
        None,
        Command(tr_noop("Back 1 s"), "Ctrl+Left", partial(session.step, -1.0), repeats=True),
        Command(tr_noop("Forward 1 s"), "Ctrl+Right", partial(session.step, 1.0), repeats=True),
        Command(tr_noop("Back 10 ms"), "Shift+Left", partial(session.step, -FRAME_PERIOD), repeats=True),
        Command(tr_noop("Forward 10 ms"), "Shift+Right", partial(session.step, FRAME_PERIOD), repeats=True),
        Command(tr_noop("Go to Start"), "Home", lambda: session.seek(0)),
        Command(tr_noop("Go to End"), "End", lambda: session.seek(session.source.duration)),
        None,
        Command(tr_noop("Louder"), "Ctrl+Up", lambda: playback.set_volume(playback.volume + 3), repeats=True),
        Command(tr_noop("Quieter"), "Ctrl+Down", lambda: playback.set_volume(playback.volume - 3), repeats=True),
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
    )


def selection_commands(selection: Selection, dialogs: SelectionDialogs, average: Callable[[], object]) -> Commands:
    """Return what is done with the selected part of a file."""
    return (
        Command(tr_noop("Select All"), "Ctrl+A", selection.select_all),
        Command(tr_noop("Start Selection at Cursor"), "[", partial(selection.set_edge, end=False)),
        Command(tr_noop("End Selection at Cursor"), "]", partial(selection.set_edge, end=True)),
        None,
        Command(tr_noop("Zoom to Entire File"), "Shift+A", selection.show_all),
        Command(tr_noop("Zoom to Selection"), "Shift+Z", selection.zoom),
        None,
        Command(tr_noop("Play Selection"), "Shift+Space", selection.play),
        Command(tr_noop("Loop Selection"), "Shift+L", lambda: selection.play(loop=True)),
        None,
        Command(tr_noop("Measure Selection"), "Shift+M", selection.measure),
        Command(tr_noop("Average Spectrum"), "", average),
        Command(tr_noop("Copy Frames as Table"), "Ctrl+Shift+C", dialogs.copy_frames),
        None,
        Command(tr_noop("Save Selection as Audio File…"), "", dialogs.ask_save),
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
    menu = menus.add(tr("&Selection"), *selection_commands(selection, dialogs, pictures.curves.add_selection))
    takes = menu.addMenu(tr("Use as Take of"))
    for phoneme in KEYS:
        if phoneme is Phoneme.I:  # consonants above, vowels below
            takes.addSeparator()
        takes.addAction(sound_name(phoneme), partial(use_as_take, phoneme))
    view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
    view.addActions(menu.actions())
    separator = QAction(view)
    separator.setSeparator(True)
    view.addAction(separator)
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
        None,
        Command(tr_noop("Insert Label"), "Ctrl+I", labels.ask_insert),
        Command(tr_noop("Rename Label"), "F2", labels.ask_rename),
        Command(tr_noop("Delete Label"), "Delete", labels.delete),
        Command(tr_noop("Split Label at Cursor (Enter)"), "", labels.split),
        Command(tr_noop("Merge with Next Label"), "Ctrl+J", labels.merge),
        Command(tr_noop("Merge with Previous Label"), "Ctrl+Shift+J", partial(labels.merge, back=True)),
        None,
        Command(tr_noop("Next Label"), "Alt+Right", partial(labels.choose, step=1), repeats=True),
        Command(tr_noop("Previous Label"), "Alt+Left", partial(labels.choose, step=-1), repeats=True),
        Command(tr_noop("Tier Below"), "Alt+Down", partial(labels.choose, tiers=1)),
        Command(tr_noop("Tier Above"), "Alt+Up", partial(labels.choose, tiers=-1)),
        Command(tr_noop("Start Label at Cursor"), "F3", partial(labels.set_edge, end=False)),
        Command(tr_noop("End Label at Cursor"), "F4", partial(labels.set_edge, end=True)),
        None,
        Command(tr_noop("Tiers…"), "", labels.ask_tiers),
        None,
        Command(tr_noop("Load Labels…"), "", labels.ask_load),
        Command(tr_noop("Save Labels"), "Ctrl+Alt+S", labels.save),
        Command(tr_noop("Save Labels As…"), "", labels.ask_save_as),
    )


def connect_score(score: ScoreStrip, show_page: Callable[[int], None], labels: LabelDialogs) -> None:
    """Have the buttons of a score without labels lead to where labels come from."""
    pages = {name: k for k, name in enumerate(PAGES)}
    score.takes_asked.connect(lambda: show_page(pages["Calibrate"]))
    score.labels_asked.connect(labels.ask_load)
    score.script_asked.connect(lambda: show_page(pages["Talk"]))


def connect_cards(
    cards: WelcomeCards, session: Session, show_page: Callable[[int], None], calibrate: Callable[[], object]
) -> None:
    """Have the cards of the first start lead somewhere; the program itself plays the demo and animates."""

    def listen() -> None:
        show_page(PAGES.index("Analyse"))
        session.set_source(SourceKind.MICROPHONE)

    cards.microphone_asked.connect(listen)
    cards.calibration_asked.connect(calibrate)
    session.transport_changed.connect(cards.hide)  # something else was begun


def record_commands(session: Session, dialogs: Dialogs) -> Commands:
    """Return what belongs to the microphone."""
    return (
        Command(tr_noop("Record"), "R", dialogs.record),
        Command(tr_noop("Show History"), "Ctrl+B", session.look_back, checkable=True),
        None,
        Command(tr_noop("Recordings Folder…"), "", dialogs.ask_recordings_folder),
        Command(tr_noop("Rescan Audio Devices"), "F5", session.microphone.refresh_devices),
        None,
        Command(tr_noop("Measure Latency with Clicks"), "Ctrl+M", dialogs.measure_latency),
    )


def analysis_commands(
    session: Session,
    preset: PresetModel,
    dialogs: Dialogs,
    mark: Callable[[], object],
    choose_other: Callable[[], object],
) -> Commands:
    """Return what belongs to filters and results."""
    return (
        Command(tr_noop("Bypass All Filters"), "B", preset.set_bypassed, checkable=True),
        None,
        Command(tr_noop("New Variable…"), "V", mark),
        Command(tr_noop("Remove Variable…"), "", dialogs.ask_remove_variable),
        None,
        Command(tr_noop("Choose Preset B…"), "Ctrl+Shift+B", choose_other),
        Command(tr_noop("Set Current as B"), "", lambda: dialogs.presets.set_other(preset.document)),
        Command(tr_noop("Switch between A and B"), "X", preset.switch),
        Command(tr_noop("Clear B"), "", dialogs.presets.clear_second),
        None,
        Command(tr_noop("Clear"), "C", session.clear),
    )


def allow_second(menus: Menus, preset: PresetModel) -> None:
    """Allow what can be done with A and B now."""
    menus.actions["Set Current as B"].setEnabled(preset.letter == A)
    menus.actions["Clear B"].setEnabled(preset.other is not None)


KEYS_OF_TALK = ("Align Text with Recording", "Speak Text")
"""The commands whose keys count on the Talk page only."""


def lend_keys(menus: Menus, page: str, *, is_used: bool) -> None:
    """Leave keys to what is seen; `is_used` says whether Escape ends something there.

    Elsewhere than on the Analyse page, letters have other uses or none.
    """
    menus.lend_key("Stop", lent=is_used)
    menus.lend_key("Select All", lent=page != "Analyse")
    for text in KEYS_OF_TALK:
        if text in menus.actions:  # the menu is filled after the first picture
            menus.lend_key(text, lent=page != "Talk")
    menus.lend_keys_of_views(lent=page != "Analyse")


def help_commands(*acts: Callable[[], object]) -> Commands:
    """Return what helps: keys, What Is This?, manual, first steps, tour, licences and About are done by `acts`."""
    keys, what, manual, first_steps, tour, licences, about = acts
    return (
        Command(tr_noop("Keyboard Shortcuts"), "F1", keys),
        Command(tr_noop("What Is This?"), "Shift+F1", what),
        Command(tr_noop("Manual"), "Ctrl+F1", manual),
        Command(tr_noop("First Steps…"), "", first_steps),
        Command(tr_noop("Tour of Talk"), "", tour),
        None,
        Command(tr_noop("Licences"), "", licences),
        Command(tr_noop("About PhonemeAnalyser"), "", about),
    )


def view_commands(show_page: Callable[[int], None], analysis: AnalysisPage, docks: Docks) -> Commands:
    """Return what chooses what is seen, and how."""
    return (
        *(Command(name, f"Ctrl+{k + 1}", partial(show_page, k)) for k, name in enumerate(PAGES)),
        None,
        Command(tr_noop("Coarse Display"), "Shift+C", analysis.set_coarse, checkable=True),
        Command(tr_noop("Spectra in dB"), "D", analysis.set_decibels, checkable=True),
        None,
        Command(tr_noop("Next Panel"), "F6", lambda: docks.focus_next(1, analysis.main_view), repeats=True),
        Command(
            tr_noop("Previous Panel"), "Shift+F6", lambda: docks.focus_next(-1, analysis.main_view), repeats=True
        ),
    )


def add_looks(
    menus: Menus,
    view: QMenu,
    settings: QSettings,
    use_theme: Callable[[str], Any],
    use_language: Callable[[str], Any],
) -> None:
    """Add the choices of theme and language to a menu."""
    themes = {"system": tr("System"), "light": tr("Light"), "dark": tr("Dark")}
    languages = {SYSTEM: tr("System"), **LANGUAGES}
    view.addSeparator()
    menus.add_choice(view, tr("Theme"), themes, read(settings, "theme", "system"), use_theme)
    view.addSeparator()
    menus.add_choice(view, tr("Language"), languages, read(settings, "language", SYSTEM), use_language)
