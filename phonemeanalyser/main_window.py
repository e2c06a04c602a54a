"""The main window: lays the views out, and joins menus, keys and drops to the models. No signal logic."""

import time
from functools import partial
from pathlib import Path

from PySide6.QtCore import QSettings, Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QDockWidget,
    QMainWindow,
    QMenu,
    QMessageBox,
    QSplitter,
    QToolBar,
    QVBoxLayout,
    QWidget,
)

from phonemeanalyser.calibration_dialogs import CalibrationDialogs
from phonemeanalyser.commands import analysis_commands, file_commands, play_commands, record_commands
from phonemeanalyser.dialogs import Dialogs
from phonemeanalyser.menus import Command, Menus
from phonemeanalyser.models.calibration import Calibration
from phonemeanalyser.models.history import shown_spectra
from phonemeanalyser.models.preset import PresetModel
from phonemeanalyser.models.session import Session, Source
from phonemeanalyser.models.talking import Talking
from phonemeanalyser.talking_dialogs import TalkingDialogs
from phonemeanalyser.theme import Theme
from phonemeanalyser.views.averaged_view import AveragedView
from phonemeanalyser.views.banner import Banner
from phonemeanalyser.views.calibration_page import CalibrationPage
from phonemeanalyser.views.filter_column import FilterColumn
from phonemeanalyser.views.head_view import HeadView
from phonemeanalyser.views.keys import KeysOfButtons
from phonemeanalyser.views.page_switch import PageStack, PageSwitch
from phonemeanalyser.views.phoneme_view import PhonemeView
from phonemeanalyser.views.recogniser_choice import RecogniserChoice
from phonemeanalyser.views.shortcuts import ShortcutsDialog
from phonemeanalyser.views.spectrum_view import SpectrumView
from phonemeanalyser.views.status_line import StatusLine
from phonemeanalyser.views.talk_page import TalkPage
from phonemeanalyser.views.threshold_view import ThresholdView
from phonemeanalyser.views.time_view import TimeView
from phonemeanalyser.views.transport import Transport
from phonemeanalyser.views.waveform_view import WaveformView
from phonemeanalyser.window_state import WindowState

FRAME_MS = 16
"""Between two pictures: 60 a second."""
FILTERS_WIDTH, PHONEME_WIDTH, HEAD_HEIGHT = 240, 310, 230
INVITATIONS = {
    Source.FILE: "Press Space to play",
    Source.MICROPHONE: "Press Space to listen, R to record",
    Source.TONE: "Press Space to hear the tone",
}
ANALYSE, CALIBRATE, TALK = range(3)
PAGES = ("Analyse", "Calibrate", "Talk")
KEYS_OF_DOCKS = {"Head": "F7"}
SLOW = 4
"""Numbers and what changes slowly are drawn at every fourth picture."""


class MainWindow(QMainWindow):
    """All views over one session and one preset.

    Signals
    -------
    theme_asked : the user chose ``system``, ``light`` or ``dark``.
    """

    theme_asked = Signal(str)

    def __init__(
        self, session: Session, preset: PresetModel, theme: Theme, settings: QSettings, calibration: Calibration,
        talking: Talking,
    ) -> None:  # fmt: skip
        super().__init__()
        self.theme = theme
        self.frozen = False
        self.dialogs = Dialogs(self, session, preset, settings)
        self.calibration_dialogs = CalibrationDialogs(self, calibration, settings)
        self.menus = Menus(self)
        self.talking_dialogs = TalkingDialogs(self, talking, settings)
        self._calibration = calibration
        self._talking = talking
        self._session = session
        self._preset = preset
        self._settings = settings
        self._ticks = 0
        self._stale = True
        self._retired = False
        self._docks_of_analysis: dict[QDockWidget, int] = {}
        self.calibration_dialogs.restore()
        self._make_views()
        self._lay_out()
        self._make_menus()
        self._connect()
        self.state.restore(session, self.time_view)
        self._banner_bar.hide()
        self._show_recent()
        self.refresh_all()

    # -- what it is made of -------------------------------------------------------------------------------

    def _make_views(self) -> None:
        session, theme = self._session, self.theme
        self.banner = Banner(theme)
        self.transport = Transport(session, theme)
        self.spectrum = SpectrumView("Spectrum", theme)
        self.averaged = AveragedView(session.averages, theme)
        self.waveform = WaveformView(theme)
        self.time_view = TimeView(session.history, self._preset, theme)
        self.filters = FilterColumn(self._preset, theme)
        self.recogniser = RecogniserChoice(self._preset)
        self.phoneme = PhonemeView(session, theme)
        self.thresholds = ThresholdView(self._preset, session.history, theme)
        self.status = StatusLine(session, self._preset, theme)
        self.calibration = CalibrationPage(self._calibration, theme)
        self.talk = TalkPage(self._talking, theme)
        self.head = HeadView(self._talking, theme)
        self.head.setMinimumHeight(HEAD_HEIGHT)
        self.switch = PageSwitch(PAGES)
        self.pages = PageStack()

    def _lay_out(self) -> None:
        self._bar("Transport", self.transport)
        self._banner_bar = self._bar("Messages", self.banner)
        self._spectra = QSplitter(Qt.Orientation.Horizontal)
        self._spectra.addWidget(self.spectrum)
        self._spectra.addWidget(self.averaged)
        self._spectra.setSizes([380, 380])
        self._rows = QSplitter(Qt.Orientation.Vertical)
        for widget in (self._spectra, self.waveform, self.time_view):
            self._rows.addWidget(widget)
        self._rows.setSizes([190, 130, 370])
        for splitter in (self._spectra, self._rows):
            splitter.setChildrenCollapsible(False)
        self.pages.addWidget(self._rows)
        self.pages.addWidget(self.calibration)
        self.pages.addWidget(self.talk)
        self.setCentralWidget(self.pages)
        self.menuBar().setCornerWidget(self.switch, Qt.Corner.TopLeftCorner)
        self._rows.setFocus()  # else Qt gives the first button the focus, and Space is for Play
        switches: dict[str, QAbstractButton] = {
            "sonagram_db": self.time_view.decibels,
            "coarse_spectrum": self.spectrum.coarse,
            "coarse_average": self.averaged.coarse,
            "coarse_waveform": self.waveform.coarse,
            "spectrum_db": self.spectrum.decibels,
            "average_db": self.averaged.decibels,
        }
        self.state = WindowState(self, {"rows": self._rows, "spectra": self._spectra}, switches, self._settings)
        self._dock("Filters", Qt.DockWidgetArea.LeftDockWidgetArea, self.filters)
        self._dock("Phoneme", Qt.DockWidgetArea.RightDockWidgetArea, self.recogniser, self.phoneme)
        self._dock("Thresholds", Qt.DockWidgetArea.RightDockWidgetArea, self.thresholds)
        self._dock("Head", Qt.DockWidgetArea.LeftDockWidgetArea, self.head).hide()
        docks = self.findChildren(QDockWidget)
        self.resizeDocks(docks[:2], [FILTERS_WIDTH, PHONEME_WIDTH], Qt.Orientation.Horizontal)
        self.statusBar().addWidget(self.status.left, 1)
        self.statusBar().addPermanentWidget(self.status.right)
        self.setAcceptDrops(True)
        self.resize(1280, 800)

    def _bar(self, title: str, view: QWidget) -> QToolBar:
        bar = QToolBar(title)
        bar.setObjectName(title)
        bar.setMovable(False)
        bar.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        bar.addWidget(view)
        self.addToolBar(bar)
        self.insertToolBarBreak(bar)
        return bar

    def _dock(self, title: str, area: Qt.DockWidgetArea, *views: QWidget) -> QDockWidget:
        dock = QDockWidget(title, self)
        dock.setObjectName(title)
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        for view in views:
            column.addWidget(view)
        body.setSizePolicy(views[-1].sizePolicy())
        dock.setWidget(body)
        self.addDockWidget(area, dock)
        return dock

    def _make_menus(self) -> None:
        session, preset, dialogs, add = self._session, self._preset, self.dialogs, self.menus.add
        file = add("&File", *file_commands(dialogs), Command("Quit", "Ctrl+Q", self.close))
        self._recent = QMenu("Open Recent", self)
        file.insertMenu(self.menus.actions["Save the Phonemes…"], self._recent)
        self.menus.add_edit(preset.undo_stack)
        self.menus.add_edit_of_page(self._calibration.edits.undo, self._calibration.edits.redo)
        add("&Play", *play_commands(session))
        measure = Command("Measure the Latency by Clicks", "Ctrl+M", self._measure_latency)
        add("&Record", *record_commands(session, dialogs), measure)
        freeze = Command("Freeze Views", "F", self.set_frozen, checkable=True)
        mark = Command("New Variable…", "V", self.averaged.measure.toggle)
        add("&Analysis", freeze, *analysis_commands(session, preset, dialogs), mark)
        self._make_view_menu()
        add(
            "&Help",
            Command("Keyboard Shortcuts", "F1", self.show_shortcuts),
            Command("About PhonemeAnalyser", "", self.show_about),
        )

    def _make_view_menu(self) -> None:
        view = self.menus.add(
            "&View",
            *(Command(name, f"Ctrl+{k + 1}", partial(self.show_page, k)) for k, name in enumerate(PAGES)),
            Command("Coarse Display", "Shift+C", self._set_coarse, checkable=True),
            Command("Spectra in dB", "D", self._set_decibels, checkable=True),
        )
        view.addSeparator()
        for dock in self.findChildren(QDockWidget):
            view.addAction(dock.toggleViewAction())
            dock.toggleViewAction().setShortcut(KEYS_OF_DOCKS.get(dock.objectName(), ""))
        view.addSeparator()
        chosen = str(self._settings.value("theme", "system"))
        self.menus.add_choice(view, "Theme", ("system", "light", "dark"), chosen, self.theme_asked.emit)

    def _connect(self) -> None:
        session, preset, dialogs = self._session, self._preset, self.dialogs
        self.transport.open_asked.connect(dialogs.ask_sound)
        self.transport.folder_asked.connect(dialogs.ask_recordings_folder)
        session.microphone.recorded.connect(dialogs.offer_recording)
        session.microphone.told.connect(self.banner.tell)
        session.writer.told.connect(self.banner.tell)
        dialogs.offered.connect(self.banner.offer)
        self.averaged.load_asked.connect(dialogs.ask_curves)
        self.averaged.save_asked.connect(dialogs.ask_save_curve)
        self.averaged.variable_asked.connect(dialogs.ask_variable)
        self.filters.bypass_asked.connect(preset.set_bypassed)
        self.recogniser.chosen.connect(dialogs.choose_recogniser)
        dialogs.refused.connect(self.banner.say)
        preset.refused.connect(self.banner.say)
        dialogs.sound_opened.connect(self._show_recent)
        dialogs.variable_added.connect(self.time_view.variable.setCurrentText)
        self.banner.shown.connect(self._banner_bar.setVisible)
        self._connect_calibration()
        self._connect_talking()
        session.failed.connect(self.banner.say)
        session.opened.connect(self._show_names)
        session.cleared.connect(self.refresh_all)
        session.rewritten.connect(self.time_view.sonagram.forget)
        session.transport_changed.connect(self._show_state)
        preset.changed.connect(self._show_state)
        preset.file_changed.connect(self._show_names)
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self.tick)
        self._timer.start(FRAME_MS)
        self.installEventFilter(KeysOfButtons(self))
        self._show_names()
        self._show_state()

    def _connect_calibration(self) -> None:
        calibration, dialogs = self._calibration, self.calibration_dialogs
        self.switch.chosen.connect(self.show_page)
        self.calibration.takes.project_asked.connect(dialogs.ask_project)
        self.calibration.takes.import_asked.connect(dialogs.ask_recordings)
        self.calibration.workbench.rival.file_asked.connect(self._ask_rival)
        self.calibration.workbench.variables.add_asked.connect(self.dialogs.add_variable)
        calibration.failed.connect(self.banner.say)
        calibration.told.connect(self.banner.tell)
        self.installEventFilter(self.calibration.keys)
        calibration.edits.changed.connect(self._show_edits)
        self.show_page(ANALYSE)

    def _connect_talking(self) -> None:
        talking, dialogs, page = self._talking, self.talking_dialogs, self.talk
        page.sound_asked.connect(self.dialogs.ask_sound)
        page.preset_asked.connect(self.dialogs.ask_preset)
        page.choices.mesh_asked.connect(dialogs.ask_mesh)
        page.choices.table_asked.connect(dialogs.ask_table)
        talking.failed.connect(self.banner.say)
        self.installEventFilter(page.keys)

    def show_page(self, number: int) -> None:
        """Show a page; the docks belong to the first one."""
        docks = self.findChildren(QDockWidget)
        if number != ANALYSE and self.pages.currentIndex() == ANALYSE:
            laid_out = self.isVisible()
            self._docks_of_analysis = {d: d.width() if laid_out else 0 for d in docks if not d.isHidden()}
            for dock in docks:
                dock.hide()
        self.pages.setCurrentIndex(number)  # first, lest docks beside a wide page make the window wider
        if number == ANALYSE:
            self._show_docks(self._docks_of_analysis)
            self._docks_of_analysis = {}
        self.switch.show_page(number)
        self._show_edits()
        (self._rows, self.calibration.takes.list, self.talk.head)[number].setFocus()
        self._stale = True

    def _ask_rival(self) -> None:
        path = self.calibration_dialogs.ask_preset()
        if path is not None:
            self.calibration.workbench.rival.offer(path)

    def _show_docks(self, widths: dict[QDockWidget, int]) -> None:
        for dock in widths:
            dock.show()
        known = {dock: width for dock, width in widths.items() if width}
        if known:
            self.resizeDocks(list(known), list(known.values()), Qt.Orientation.Horizontal)

    def _show_edits(self) -> None:
        edits = self._calibration.edits
        on_page = self.pages.currentIndex() == CALIBRATE
        self.menus.show_edits(of_page=on_page, undo=edits.undoable, redo=edits.redoable)

    # -- drawing ------------------------------------------------------------------------------------------

    def tick(self) -> None:
        """Gather what is new and draw it: fast views each time, slow ones each fourth time."""
        known_at = None
        if self._session.tick():
            self._stale = True
            known_at = time.monotonic() - self._session.microphone.known_for
        self._calibration.tick()
        self._move_head()
        self._ticks += 1
        slow = self._ticks % SLOW == 0
        self._stale |= self._session.deaf != self.phoneme.deaf
        if slow and (self._session.playing or self._session.microphone.recording):
            self.transport.refresh()
            self._show_output()
        if self.pages.currentIndex() == CALIBRATE:
            self.calibration.refresh()
        elif self.pages.currentIndex() == ANALYSE and self._stale and not self.frozen:
            self._draw_analysis(slow=slow, known_at=known_at)

    def _draw_analysis(self, *, slow: bool, known_at: float | None) -> None:
        self._refresh_fast()
        if slow:
            self._refresh_slow()
            self._stale = False
        elif self.phoneme.is_outdated:
            self.phoneme.refresh()
        if known_at is not None and self._session.source is Source.MICROPHONE:
            QTimer.singleShot(0, lambda: self.status.note_display(time.monotonic() - known_at))

    def _move_head(self) -> None:
        """Have the head say what is heard, where it is seen."""
        seen = [view for view in (self.talk, self.head) if view.isVisible()]
        self._talking.watch(bool(seen) and not self.frozen)
        self._talking.tick()
        for view in seen:
            if not self.frozen:
                view.refresh()

    def refresh_all(self) -> None:
        """Draw everything as it is now."""
        self._move_head()
        self.transport.refresh()
        self._refresh_fast()
        self._refresh_slow()

    def _refresh_fast(self) -> None:
        newest = self._session.history.newest
        if newest is not None:
            self.spectrum.draw(shown_spectra(newest)[-1])
            self.waveform.draw(newest.waveforms[-1])
        else:
            self.spectrum.clear()
            self.waveform.clear()
        self.time_view.refresh()

    def _refresh_slow(self) -> None:
        self.averaged.refresh()
        self.phoneme.refresh()
        self.thresholds.refresh()
        self.time_view.refresh_numbers()

    def set_frozen(self, frozen: bool) -> None:
        """Hold the views still while sound goes on, or let them go on."""
        self.frozen = frozen
        self.menus.show_checked("Freeze Views", frozen)
        self._show_state()

    def _measure_latency(self) -> None:
        """Play clicks, with the microphone and the loudspeaker free for that."""
        self._session.set_source(Source.MICROPHONE)
        self.banner.tell("Listening for clicks from the loudspeaker, for three seconds …")
        self._session.microphone.measure()

    def _set_coarse(self, on: bool) -> None:
        for view in (self.spectrum, self.averaged, self.waveform):
            view.coarse.setChecked(on)

    def _set_decibels(self, on: bool) -> None:
        for view in (self.spectrum, self.averaged):
            view.decibels.setChecked(on)

    def _show_names(self) -> None:
        session, preset = self._session, self._preset
        self.time_view.invite(INVITATIONS[session.source] if session.path or session.source is not Source.FILE
                              else "Drop a sound here, or open one with Ctrl+O")  # fmt: skip
        self.setWindowTitle(f"{session.name} - {preset.preset.name}[*] - PhonemeAnalyser")
        self.setWindowModified(preset.has_unsaved_changes)
        self._show_output()

    def _show_recent(self) -> None:
        self._recent.clear()
        for path in self.dialogs.recent_sounds():
            self._recent.addAction(path, partial(self.dialogs.open_sound, Path(path)))
        self._recent.setEnabled(not self._recent.isEmpty())

    def _show_state(self) -> None:
        self.menus.show_checked("Loop", self._session.loop)
        self.menus.show_checked("Bypass All Filters", self._preset.bypassed)
        self._stale = True
        self._show_output()

    def _show_output(self) -> None:
        self.status.refresh(frozen=self.frozen)

    # -- help ---------------------------------------------------------------------------------------------

    def show_shortcuts(self) -> None:
        """List all keys."""
        ShortcutsDialog(self.menus.keys(), self).open()

    def show_about(self) -> None:
        """Say what this is."""
        QMessageBox.about(
            self, "PhonemeAnalyser",
            "<b>PhonemeAnalyser</b><p>Calibrates real-time phoneme recognition for lip sync, and shows why a phoneme "
            "was recognised.<p>MIT licence. The demo is a synthetic voice of the Festival project (CMU slt). "
            "The head is in the public domain (CC0).",
        )  # fmt: skip

    # -- Qt's events --------------------------------------------------------------------------------------

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take files."""
        if event.mimeData().hasUrls():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Load what was dropped."""
        event.acceptProposedAction()
        paths = [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]
        self.talking_dialogs.open([path for path in paths if self.talking_dialogs.opens(path)])
        for path in paths:
            if not self.talking_dialogs.opens(path):
                self.dialogs.open_any(path)
        for url in event.mimeData().urls():
            if not url.isLocalFile():
                self.banner.say(f"{url.toString()}: only files on this computer can be opened; save it here first")

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask about unsaved changes, and keep the layout for the next start."""
        if not self._retired and not self.dialogs.may_go_on():
            event.ignore()
            return
        self.save_state()
        self._timer.stop()
        if not self._retired:
            self._session.pause()
        event.accept()

    def save_state(self) -> None:
        """Keep layout and choices for the next start."""
        page = self.pages.currentIndex()
        self.show_page(ANALYSE)  # whose docks are the layout
        self.calibration_dialogs.save()
        self.talking_dialogs.save()
        self._settings.setValue("page", page)
        self.state.save(self._session, self.time_view)

    def look_like(self, other: "MainWindow") -> None:
        """Show the same page, frozen or not, and the heads from where the other window shows them."""
        self.show_page(other.pages.currentIndex())
        self.set_frozen(other.frozen)
        self.talk.head.look_like(other.talk.head)
        self.head.look_like(other.head)

    def retire(self) -> None:
        """Close without asking, since another window takes over."""
        self._retired = True
        for head in (self.talk.head, self.head):
            head.let_go()
        self.close()
        self.deleteLater()
