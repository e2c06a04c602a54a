"""The main window: lays the views out, and joins menus, keys and drops to the models. No signal logic."""

import math
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QEvent, QSettings, QSize, Qt, Signal
from PySide6.QtGui import QCloseEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QDockWidget, QMainWindow, QSizePolicy, QToolBar, QWidget
from typing_extensions import override

from phonemeanalyser.desktop import calibrate, commands
from phonemeanalyser.desktop import talk as talk_package
from phonemeanalyser.desktop.analyse.lanes.label_dialogs import LabelDialogs, SelectionDialogs
from phonemeanalyser.desktop.analyse.page import AnalysisPage
from phonemeanalyser.desktop.analyse.recognition.filter_column import FilterColumn
from phonemeanalyser.desktop.analyse.recognition.preset_choice import PresetBox, RecogniserChoice
from phonemeanalyser.desktop.analyse.spectra.curve_panel import CurvePanel
from phonemeanalyser.desktop.analyse.status_line import StatusLine
from phonemeanalyser.desktop.analyse.transport.transport import Transport
from phonemeanalyser.desktop.dialogs import Dialogs
from phonemeanalyser.desktop.docks import Docks
from phonemeanalyser.desktop.help import LicencesDialog, ManualDialog, ShortcutsDialog, WhatIsThis
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.menus import Command, Menus
from phonemeanalyser.desktop.redraw import RedrawLoop
from phonemeanalyser.desktop.rule_dialogs import RuleDialogs
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.selection import Selection
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.state import WindowState
from phonemeanalyser.desktop.theme import Theme, style_sheet
from phonemeanalyser.desktop.welcome import WelcomeCards
from phonemeanalyser.desktop.widgets.banner import Banner
from phonemeanalyser.desktop.widgets.builders import column
from phonemeanalyser.desktop.widgets.file_asker import FileAsker, FileDrops
from phonemeanalyser.desktop.widgets.keyboard import ControlKeys, FocusReturn, settle_focus
from phonemeanalyser.desktop.widgets.pages import LazyPage, PageStack, PageSwitch
from phonemeengine.audio.files import is_sound
from phonemeengine.phonemes import Phoneme

FILTERS_WIDTH, PHONEME_WIDTH, HEAD_HEIGHT = 280, 310, 230
USUAL_SIZE, DECORATIONS = QSize(1280, 800), QSize(8, 40)
"""What the window likes to have, and what window managers put around it, pixels."""
NARROW = 1272
"""A window that is narrower than this has its filters behind the thresholds, unless the user moves them."""
ANALYSE, CALIBRATE, TALK = range(3)
KEYS_OF_DOCKS = {tr_noop("Head"): "F7", tr_noop("Spectra"): "F8", tr_noop("Rules"): "F9"}


class MainWindow(QMainWindow):
    """All views over one session and one preset.

    Parameters
    ----------
    calibration, talking : make the model of a page, if there is none yet, and have it joined to the window.
    files : asks the user for files.

    Signals
    -------
    demo_asked : the user wants to play the demo.
    theme_asked : the user chose ``system``, ``light`` or ``dark``.
    language_asked : the user chose ``system``, or one of `LANGUAGES`.
    """

    theme_asked = Signal(str)
    language_asked = Signal(str)
    demo_asked = Signal()

    def __init__(
        self, session: Session, preset: PresetModel, theme: Theme, settings: QSettings,
        calibration: "Callable[[], calibrate.CalibrationModel]", talking: "Callable[[], talk_package.TalkModel]",
        files: FileAsker,
    ) -> None:  # fmt: skip
        super().__init__()
        self.theme, self.files = theme, files
        self.dialogs = Dialogs(self, session, preset, settings, lambda: talking().in_use, files)
        self.selection = Selection(session)
        self.selection_dialogs = SelectionDialogs(self, self.selection, session, files)
        self.label_dialogs = LabelDialogs(self, session, files)
        self.menus = Menus(self)
        self.rule_dialogs = RuleDialogs(self, session.rules)
        self._docks = Docks(self, NARROW)
        self._ask_calibration, self._ask_talking = calibration, talking
        self._calibration: calibrate.CalibrationModel | None = None
        self._calibration_dialogs: calibrate.CalibrationDialogs | None = None
        self._talk_parts: talk_package.TalkParts | None = None
        self._session, self._preset, self._settings = session, preset, settings
        self._retired = self._closed = False
        self._make_views()
        self._lay_out()
        self._make_menus()
        self._connect()
        self.state.restore(session, self.analysis)
        self._docks.laid_out_for(self.state.docks_width(), stacked=self.state.docks_stacked())
        self.redraw.refresh_all()

    # -- what it is made of -------------------------------------------------------------------------------

    def _make_views(self) -> None:
        session, theme = self._session, self.theme
        self.transport = Transport(session, theme)
        self.analysis = AnalysisPage(session, self._preset, theme)
        self.filters = FilterColumn(self._preset, theme)
        self.curves = CurvePanel(session.curves, self.dialogs.curves, theme)
        self.recogniser = RecogniserChoice(self._preset)
        self.preset_box = PresetBox(self._preset, self.dialogs.presets.sections, self.files)
        self.status = StatusLine(session, self._preset, theme)
        self._head_place = QWidget()
        self._head_place.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._head_place.setMinimumHeight(HEAD_HEIGHT)
        self.switch = PageSwitch(tuple(map(tr, commands.PAGES)))
        self.pages = PageStack()
        self.banner = Banner(theme, self, self.pages, self.analysis.waveform)
        self.welcome = WelcomeCards(theme, self, self.pages)
        self._focus = FocusReturn(self, lambda: self._focused_on(self.pages.currentIndex()))
        self.preset_box.list.chosen.connect(self._focus.leave_field)
        self.what_is_this = WhatIsThis(self)
        self.pages.addWidget(self.analysis)
        self._late_calibration = LazyPage(self.pages, self._make_calibration_page)
        self._late_talk = LazyPage(self.pages, self._make_talk_page)
        self.redraw = RedrawLoop(
            self, session, self.pages, self.analysis, self._late_calibration, self.transport, self.status,
            self.filters.look_ahead,
        )  # fmt: skip

    def join_calibration(self, model: "calibrate.CalibrationModel") -> None:
        """Take up the takes of the last start, and show what the calibration says, whatever page is seen."""
        self._calibration = model
        self._calibration_dialogs = calibrate.CalibrationDialogs(self, model, self._settings, self.files)
        model.error.connect(self.banner.show_error)
        model.info.connect(self.banner.show_info)
        model.guide.changed.connect(self._lend_keys)
        self._calibration_dialogs.restore()

    def join_talk(self, model: "talk_package.TalkModel") -> None:
        """Have heads say what is playing, and fill the menu of the Talk page."""
        parts = self._talk_parts = talk_package.TalkParts(
            self, model, self.theme, self._settings, self.files, self.menus, self._talk_menu
        )
        self.redraw.heads = parts.heads
        head = parts.add_head("dock")
        head.menu.save_asked.connect(self.dialogs.ask_save_picture)
        column(head, on=self._head_place, spacing=0)
        parts.dialogs.page_asked.connect(lambda: self.show_page(TALK))
        for told in (model.text.changed, model.keys.opened):
            told.connect(self._show_spoken)
        model.text.speech_saved.connect(self.dialogs.offer_speech)
        model.text.info.connect(self.banner.show_info)
        model.error.connect(self.banner.show_error)
        self._show_spoken()
        self._lend_keys()

    @property
    def talk_parts(self) -> "talk_package.TalkParts":
        """The dialogs and heads of the Talk page."""
        if self._talk_parts is None:
            self._ask_talking()
        assert self._talk_parts is not None
        return self._talk_parts

    @property
    def calibration(self) -> "calibrate.CalibrationPage":
        """The page of the calibration."""
        return self._late_calibration.get()

    @property
    def talk(self) -> "talk_package.TalkPage":
        """The page of the head."""
        return self._late_talk.get()

    def _make_calibration_page(self) -> "calibrate.CalibrationPage":
        head = self.talk_parts.add_head("guide")
        presets = self.dialogs.presets
        page = calibrate.CalibrationPage(self._ask_calibration(), head, presets.picker_of_other(), self.theme)
        assert self._calibration_dialogs is not None
        self._calibration_dialogs.join(page)
        page.guide.save_asked.connect(presets.save_as)
        page.guide.accepted.connect(presets.offer_to_save)
        for signal in (head.menu.save_asked, page.workbench.picture_asked, page.takes.wave.menu.save_asked):
            signal.connect(self.dialogs.ask_save_picture)
        page.workbench.variables.add_asked.connect(self.dialogs.add_variable)
        page.workbench.variables.use_asked.connect(self.rule_dialogs.ask_use)
        settle_focus(page)
        self.installEventFilter(page.keys)
        return page

    def _make_talk_page(self) -> "talk_package.TalkPage":
        page = self.talk_parts.make_page()
        page.export_asked.connect(self.dialogs.show_export)
        page.picture_asked.connect(self.dialogs.ask_save_picture)
        settle_focus(page)
        self.installEventFilter(page.keys)
        return page

    def _lay_out(self) -> None:
        self.menuBar().setCornerWidget(self.switch, Qt.Corner.TopLeftCorner)
        bar = QToolBar(tr("Transport"))
        bar.setObjectName("Transport")
        bar.setMovable(False)
        bar.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        for view in (self.transport, self.status.chips, self.preset_box):
            bar.addWidget(view)
        self.addToolBar(bar)
        self._filters = self._docks.add(tr_noop("Filters"), Qt.DockWidgetArea.LeftDockWidgetArea, self.filters)
        self._spectra = self._docks.add_behind(self._filters, tr_noop("Spectra"), self.curves)
        self.setCentralWidget(self.pages)  # after what stands left of it, as Tab goes
        self.analysis.main_view.setFocus()  # else Qt gives the first button the focus, and Space is for Play
        analysis = self.analysis
        self.state = WindowState(self, analysis.splitters, analysis.switches, analysis.choices, self._settings)
        self._last_page = self.state.page()
        widths = self._add_docks()
        self.statusBar().addWidget(self.status.left, 1)
        self.statusBar().addPermanentWidget(self.status.right)
        drops = FileDrops(self)
        drops.dropped.connect(self.open_files)
        drops.refused.connect(self.dialogs.rejected)
        self.setStyleSheet(style_sheet(self.theme))  # widths are measured in it
        self._docks.prefer(widths)
        self.resize(USUAL_SIZE.boundedTo(self.screen().availableSize() - DECORATIONS))

    def _add_docks(self) -> dict[QDockWidget, int]:
        """Add what is not there yet; return how wide docks are."""
        docks, left, right = self._docks, Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea
        phoneme = docks.add(tr_noop("Phoneme"), right, self.recogniser, self.analysis.phoneme)
        self._thresholds = docks.add(tr_noop("Thresholds"), right, self.analysis.thresholds)
        variable = docks.add_behind(phoneme, tr_noop("Variable"), self.analysis.variable)
        self.analysis.variable.looked_for.connect(lambda: docks.bring_forward(variable))
        rules = docks.add_behind(self._thresholds, tr_noop("Rules"), self.analysis.rules)
        rules.visibilityChanged.connect(self.analysis.rules.set_seen)
        docks.add(tr_noop("Head"), left, self._head_place).hide()
        return {self._filters: FILTERS_WIDTH, phoneme: PHONEME_WIDTH, self._thresholds: PHONEME_WIDTH}

    def _make_menus(self) -> None:
        session, preset, dialogs, add = self._session, self._preset, self.dialogs, self.menus.add
        box, end = self.preset_box, Command(tr_noop("Quit"), "Ctrl+Q", self.close)
        file = add(tr("&File"), *commands.file_commands(dialogs, box.open_list), end)
        box.list.add_commands([self.menus.actions[text] for text in commands.PRESET_COMMANDS])
        file.insertMenu(self.menus.actions["Save Phonemes…"], commands.RecentMenu(dialogs, self))
        self.menus.add_edit(preset.undo_stack)
        add(tr("&Play"), *commands.play_commands(session))
        commands.add_selection_menu(
            self.menus, self.selection, self.selection_dialogs, self._use_as_take, self.analysis.file.view, dialogs
        )
        add(tr("&Labels"), *commands.label_commands(self.label_dialogs))
        room = Command(tr_noop("Measure Background Noise (2 s)"), "", lambda: self._ask_calibration().measure_room())
        add(tr("&Record"), *commands.record_commands(session, dialogs), room)
        freeze = Command(tr_noop("Freeze Views"), "F", self.set_frozen, checkable=True)
        mark = self.analysis.averaged.measure.toggle
        add(tr("&Analysis"), freeze, *commands.analysis_commands(session, preset, dialogs, mark, box.choose_other))
        self._talk_menu = self.menus.add(tr("&Talk"))
        self._make_view_menu()
        pages = self.show_shortcuts, self.what_is_this.begin, self.show_manual, self.welcome.show_cards
        ends = self._show_tour, lambda: LicencesDialog(self).open(), dialogs.show_about
        add(tr("&Help"), *commands.help_commands(*pages, *ends))

    def _use_as_take(self, phoneme: Phoneme) -> None:
        """Make what is selected a take of a phoneme."""
        span, seen = self.selection.span, self._session.seen.sound
        if span is not None and seen is not None:
            self._ask_calibration().takes.add_from_file(*seen, *span, phoneme)

    def _make_view_menu(self) -> None:
        full = Command(tr_noop("Full Screen"), "F11", self.show_full, checkable=True)
        layout = Command(tr_noop("Reset Layout"), "", self.reset_layout)
        views = commands.view_commands(self.show_page, self.analysis, self._docks)
        score, docks = self.analysis.score.shown, self._docks.switches(KEYS_OF_DOCKS)
        view = self.menus.add(tr("&View"), *views, None, full, layout, score, None, *docks)
        commands.add_looks(self.menus, view, self._settings, self.theme_asked.emit, self.language_asked.emit)

    def _connect(self) -> None:
        session, preset, dialogs = self._session, self._preset, self.dialogs
        self.transport.open_asked.connect(dialogs.ask_sound)
        self.transport.folder_asked.connect(dialogs.ask_recordings_folder)
        session.may_leave = self._may_leave_sound
        self.label_dialogs.join(self.analysis.file.view)
        session.microphone.recorded.connect(dialogs.offer_recording)
        dialogs.action_offered.connect(self.banner.offer)
        dialogs.presets.offer_ended.connect(self.banner.withdraw)
        dialogs.join(self.analysis)
        dialogs.curves.loaded = lambda: () if self._calibration is None else self._calibration.workbench.utterances
        self.analysis.averaged.table_asked.connect(lambda: self._docks.show(self._spectra))
        dialogs.presets.join(self.preset_box)
        self.rule_dialogs.join(self.analysis.rules, self.analysis.variable, dialogs.presets.choose_recogniser)
        self.rule_dialogs.find_asked.connect(self._find_rules)
        dialogs.sound_changed.connect(self.status.chips.show_changed)
        self.status.chips.open_again_asked.connect(dialogs.open_again)
        self.status.chips.go_on_asked.connect(lambda: self.set_frozen(False))
        self.switch.chosen.connect(self.show_page)
        for part in (session.labels, session.microphone, session.writer, self.selection, dialogs):
            part.info.connect(self.banner.show_info)
        for signal in (session.error, self.selection.error, dialogs.rejected, preset.rejected):
            signal.connect(self.banner.show_error)
        self.analysis.averaged.measure.toggled.connect(lambda _on: self._lend_keys())
        self.what_is_this.page_asked.connect(self.show_manual)
        session.opened.connect(self._show_names)
        session.cleared.connect(self.redraw.refresh_all)
        session.rewritten.connect(self._draw_rewritten)
        for signal in (session.transport_changed, session.seen.looked_back, preset.changed, preset.sides_changed):
            signal.connect(self._show_state)
        preset.file_changed.connect(self._show_names)
        commands.connect_score(self.analysis.score, self.show_page, self.label_dialogs)
        commands.connect_cards(self.welcome, session, self.show_page, self._begin_calibration)
        self.welcome.demo_asked.connect(self.demo_asked)
        self._focus.clicked.connect(self.welcome.leave_for)
        self.installEventFilter(ControlKeys(self))
        self.show_page(ANALYSE)
        settle_focus(self)
        self._show_names()
        self._show_state()

    def show_page(self, number: int) -> None:
        """Show a page; the docks belong to the first one, and the cards of the first start go."""
        self.welcome.hide()
        if number != ANALYSE and self.pages.currentIndex() == ANALYSE:
            self.state.save_docks(stacked=self._docks.stacked)
            self._docks.put_away()
        focused = self._focused_on(number)
        self.pages.setCurrentIndex(number)  # first, lest docks beside a wide page make the window wider
        if number == ANALYSE:
            self._docks.bring_back()
            self._fit_docks()
        self.switch.show_page(number)
        self.state.save_page(number)
        self._lend_keys()
        focused.setFocus()
        self.redraw.dirty = True

    def _focused_on(self, number: int) -> QWidget:
        """Return what has the focus when a page is shown; makes the page if it is not there yet."""
        if number == CALIBRATE:
            return self.calibration.takes.list
        return self.talk.lanes.line if number == TALK else self.analysis.main_view

    def _lend_keys(self) -> None:
        """Leave keys to what the user is in the middle of: the guide, or a region that becomes a variable."""
        page = self.pages.currentIndex()
        guided = page == CALIBRATE and self._calibration is not None and self._calibration.guide.running
        marking = page == ANALYSE and self.analysis.averaged.measure.isChecked()
        commands.lend_keys(self.menus, commands.PAGES[page], is_used=guided or marking)

    def set_frozen(self, frozen: bool) -> None:
        """Hold the views still while sound goes on, or let them go on."""
        self.redraw.frozen = frozen
        self.menus.show_checked("Freeze Views", frozen)
        self._show_state()

    def show_full(self, on: bool) -> None:
        """Fill the screen, or be a window again."""
        (self.showFullScreen if on else self.showNormal)()

    def reset_layout(self) -> None:
        """Lay everything out as at the first start."""
        self.show_page(ANALYSE)
        self.state.reset()
        self._docks.laid_out_for(math.inf, stacked=False)
        self._docks.prefer({self._filters: FILTERS_WIDTH, self._thresholds: PHONEME_WIDTH})
        self._fit_docks()

    def _draw_rewritten(self, _column: int) -> None:
        self.redraw.dirty = True

    def _show_names(self) -> None:
        session, preset = self._session, self._preset
        self.analysis.invite()
        self.setWindowTitle(f"{session.source.name} - {preset.title}[*] - PhonemeAnalyser")
        self.setWindowModified(preset.has_unsaved_changes)
        self.redraw.refresh_status()

    def _show_state(self) -> None:
        self.menus.show_checked("Loop", self._session.playback.loop)
        self.menus.show_checked("Show History", self._session.seen.looks_back)
        self.menus.show_checked("Bypass All Filters", self._preset.bypassed)
        commands.allow_second(self.menus, self._preset)
        self.redraw.dirty = True
        self.redraw.refresh_status()

    def show_shortcuts(self) -> None:
        """List all keys."""
        ShortcutsDialog(self.menus.keys(), self).open()

    def show_manual(self, page: str = "manual.md") -> None:
        """Show the manual, at a page of it."""
        dialog = ManualDialog(self)
        dialog.show_page(page)
        dialog.show()

    def _show_spoken(self) -> None:
        self.analysis.file.view.show_spoken(self.talk_parts.show())

    def _show_tour(self) -> None:
        self.talk_parts.dialogs.show_tour()

    def _begin_calibration(self) -> None:
        self.show_page(CALIBRATE)
        self._ask_calibration().begin_guide()

    def _find_rules(self) -> None:
        self.show_page(CALIBRATE)
        self.calibration.workbench.find_rules()

    # -- files --------------------------------------------------------------------------------------------

    def opens_as_sound(self, path: Path) -> bool:
        """Return whether a file is taken for a sound."""
        return not self.talk_parts.dialogs.opens(path) and self.dialogs.opens_as_sound(path)

    def open_files(self, paths: list[Path]) -> None:
        """Open a sound, a preset, a curve, a mesh with its movestates; several sounds are offered for export."""
        talking = self.talk_parts.dialogs
        if faces := [path for path in paths if talking.opens(path)]:
            talking.open(faces)  # meshes and movestates as one face
            self.show_page(TALK)
        if any(path.is_dir() for path in paths) or sum(is_sound(path) for path in paths) > 1:
            self.dialogs.show_export(paths)
            return
        for path in paths:
            if not talking.opens(path):
                self.dialogs.open_any(path)

    @override
    def showEvent(self, event: QShowEvent) -> None:
        """Lay the docks out for a narrow window, unless they were laid out for one already."""
        self._fit_docks()
        super().showEvent(event)

    @override
    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_docks()

    def _fit_docks(self) -> None:
        if self.isVisible() and self.pages.currentIndex() == ANALYSE:
            self._docks.fit((self._filters, self._spectra), on=self._thresholds)

    @override
    def changeEvent(self, event: QEvent) -> None:
        """Keep everything whenever the user turns to another program: this one may end in any way."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.ActivationChange and not self.isActiveWindow():
            self.save_state()

    @override
    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask about unsaved changes, and keep the layout for the next start."""
        if not self._retired and not (self._may_leave_sound() and self.dialogs.presets.may_close()):
            event.ignore()
            return
        self.save_state()
        for part in (self.selection, self.analysis.variable.study, self.dialogs.presets, self.dialogs.curves):
            part.close()
        self.redraw.timer.stop()
        if not self._closed:
            self._closed = True
            self._focus.end()
            self._docks.end()
        if not self._retired:
            self._session.pause()
        event.accept()

    def _may_leave_sound(self) -> bool:
        """Ask what is to become of words and labels that are in no file; says whether to go on."""
        parts = self._talk_parts
        return (parts is None or parts.dialogs.may_leave_words()) and self.label_dialogs.may_leave()

    def save_state(self) -> None:
        """Keep layout and choices for the next start."""
        if self.pages.currentIndex() == ANALYSE:
            self.state.save_docks(stacked=self._docks.stacked)
        if self._calibration_dialogs is not None:
            self._calibration_dialogs.save()
        if self._talk_parts is not None:
            self._talk_parts.dialogs.save()
        self.state.save(self._session, self.analysis)

    def show_last_page(self) -> None:
        """Show the page that was seen when the program ended the last time."""
        if self._last_page in {CALIBRATE, TALK}:
            self.show_page(self._last_page)

    def copy_view_from(self, other: "MainWindow") -> None:
        """Have the same size and page, frozen or not, and show the heads from where the other window shows them."""
        if not self.isMaximized() and not self.isFullScreen():
            self.resize(other.size())
        self.show_page(other.pages.currentIndex())
        self.set_frozen(other.redraw.frozen)
        if other._late_talk.made is not None:
            self._late_talk.get()
        if other._talk_parts is not None:
            self.talk_parts.heads.copy_view_from(other._talk_parts.heads)

    def close_without_asking(self) -> None:
        """Close without asking, since another window takes over."""
        self._retired = True
        if self._talk_parts is not None:
            self._talk_parts.heads.release_gl()
        self.close()
        self.deleteLater()
