"""One window that tests use in turn, since making one takes twenty times as long as most tests."""

import shutil
from collections import Counter
from collections.abc import Callable
from enum import Enum
from functools import cache
from pathlib import Path

import pyqtgraph as pg
from PySide6 import QtWidgets
from PySide6.QtCore import QEvent, QSettings
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest

from phonemeanalyser.desktop.analyse.spectra.frame_views import SOFTEST
from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.calibrate.model import TAKES_FOLDER
from phonemeanalyser.desktop.language import tr, use_language
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.talk.head.face_model import HEADS
from phonemeanalyser.desktop.talk.head.head_view import HeadView
from phonemeanalyser.desktop.talk.page import TalkPage
from phonemeanalyser.desktop.theme import apply_theme
from phonemeanalyser.desktop.widgets.plot import PlotMenu
from phonemeanalyser.desktop.window import ANALYSE, CALIBRATE, TALK, MainWindow
from phonemeengine.audio.tone import Tone
from phonemeengine.mouth.files.io import FaceFiles
from phonemeengine.mouth.morph_mesh import USUAL_HEAD
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import THESIS_PRESET
from phonemeengine.settings import Channel
from tests.desktop.studio import Studio
from tests.waiting import wait_for

SEEN: dict[type, tuple[str, ...]] = {
    QtWidgets.QWidget: ("isHidden", "isEnabled"),
    QtWidgets.QAbstractButton: ("text", "isChecked"),
    QtWidgets.QSlider: ("value",),
    QtWidgets.QComboBox: ("currentIndex", "currentText", "count"),
    QtWidgets.QLabel: ("text",),
    QtWidgets.QLineEdit: ("text",),
    QtWidgets.QStackedWidget: ("currentIndex",),
    QtWidgets.QSplitter: ("sizes",),
    QAction: ("text", "isChecked", "isEnabled", "isVisible"),
}
"""What tells, of each kind of things, that somebody changed it."""
APART = QtWidgets.QMenu, QtWidgets.QLineEdit, HeadView
"""What they hold is no part of the looks: what a menu hides until it was opened once, what fades, and a head."""
SIZE = 1280, 800
LAYOUT = {"geometry", "layout", "layout_width", "layout_stacked", "rows", "spectra"}


class WindowLender:
    """Lends a window, tidied, to each test in turn; one that cannot be tidied is replaced by a new one.

    No window is made before one is asked for. Once a test made another page than the first, all are made beforehand.

    Parameters
    ----------
    make : makes a program that begins with the rules of the thesis.
    settings : where it keeps its choices.
    folder : where its microphones record, a folder of its own.
    whole : makes all pages beforehand.
    """

    def __init__(
        self,
        make: Callable[[QSettings, Microphone], Desktop],
        settings: QSettings,
        folder: Path,
        *,
        whole: bool = False,
    ) -> None:
        self.settings = settings
        self._folder = folder
        self._make = make
        self._first = _choices(settings)
        self._desktop: Desktop | None = None
        self._whole = whole
        self._draws = False

    def draw(self, on: bool) -> None:
        """Draw the window, or do not: what fixtures make would be drawn again and again before a test begins."""
        self._draws = on
        if self._desktop is not None:
            draw(self._desktop.window, on)

    def lend(self) -> Desktop:
        """Return a program that is as one that was just begun, but that its window is seen already.

        Its microphones are those of `studio`, which has none.
        """
        lent = self._desktop
        if lent is not None and (lent._calibration, lent.window.findChild(TalkPage)) != (None, None):
            lent = lent if self._whole else None
            self._whole = True
        if lent is not None:
            app = QtWidgets.QApplication.instance()
            use_language(app, "en")
            apply_theme(app, lent.window.theme)  # both may be those of another window
            for whole in (False, True):  # what the first hides leaves its room to others with the second's events
                self._tidy(lent, whole=whole)
                if _looks(lent) == self._clean:
                    return lent
        self.close()
        self._desktop = self._begin()
        return self._desktop

    def rest(self) -> None:
        """Hide the window while a test needs none: it would be drawn all the time."""
        if self._desktop is not None:
            self._desktop.window.hide()

    def close(self) -> None:
        """Let the window go."""
        desktop, self._desktop = self._desktop, None
        if desktop is not None:
            desktop.close()

    def _begin(self) -> Desktop:
        """Make a window, and note what a clean one is like."""
        _choose(self.settings, self._first)
        self.studio = Studio(self._folder)
        desktop = self._make(self.settings, self.studio.model)
        _show(desktop.window)
        if self._whole:
            desktop.window.show_page(CALIBRATE)
            QtWidgets.QApplication.processEvents()
            desktop.window.show_page(TALK)
            wait_for(  # which is loaded when it is drawn, so not after a page without it has come
                lambda: not (QtWidgets.QApplication.processEvents() or desktop.talking.face.states is None),
                "the head",
            )
            desktop.window.show_page(ANALYSE)
            QtWidgets.QApplication.processEvents()
        for dock in desktop.window.findChildren(QtWidgets.QDockWidget):
            dock.raise_()  # it lays itself out when it is seen for the first time
            QtWidgets.QApplication.processEvents()
        self.studio.model.refresh_devices()
        desktop.window.reset_layout()
        QtWidgets.QApplication.processEvents()
        menus = desktop.window.menus.actions
        self._checked = {text: action.isChecked() for text, action in menus.items()}
        desktop.window.save_state()
        self._layout = desktop.window.saveState()
        self._ways = desktop.files.show, desktop.session.playback.open_device
        self._learn = desktop.calibration.guide.learn if self._whole else None
        self._sizes = [splitter.sizes() for splitter in desktop.window.findChildren(QtWidgets.QSplitter)]
        self._usual = {name: value for name, value in _choices(self.settings).items() if name not in LAYOUT}
        self._tidy(desktop)
        self._clean = _looks(desktop)  # no test has changed anything yet
        return desktop

    def _tidy(self, desktop: Desktop, *, whole: bool = True) -> None:
        """Have all as it was at first; a preset that is as in its file is read again, and shown, only if `whole`."""
        window = desktop.window
        window.setUpdatesEnabled(False)  # it would be painted ten times
        _show(window)
        _choose(self.settings, self._usual)
        self.studio.tidy()
        desktop.files.show, desktop.session.playback.open_device = self._ways
        desktop.demo = window.status.without_look_ahead = None
        _forget_edits(desktop, whole=whole)
        _leave_sound(desktop.session)
        _show_usual(window, self._checked)
        if window.saveState() != self._layout:
            window.reset_layout()
            window.restoreState(self._layout)
        window.state.restore(desktop.session, window.analysis)
        _leave_talk(desktop)
        if self._whole:
            self._leave_takes(desktop)
        window.redraw.refresh_all()
        wait_for(lambda: _is_at_rest(desktop), "the window")
        for _ in range(3):
            # what hides leaves its room to its parent, which then does so to the page
            QtWidgets.QApplication.processEvents()
        for splitter, sizes in zip(window.findChildren(QtWidgets.QSplitter), self._sizes, strict=False):
            splitter.setSizes(sizes)
        window.analysis.variable.phonemes.clear()  # it tells sooner or later that nothing is measured
        QtWidgets.QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        _choose(self.settings, self._first)
        draw(window, self._draws)

    def _leave_takes(self, desktop: Desktop) -> None:
        """Have no takes and no recordings, in the folder where the program has takes unless another one is chosen."""
        model, page = desktop.calibration, desktop.window.calibration
        guide = model.guide
        guide.learn = self._learn
        guide.cancel()
        guide._language_chosen = guide.by_sounds = False
        guide.begin()  # at the first step again
        guide.cancel()
        model.room.cancel()
        model.fit.refuse()
        model.rule_finding.refuse()
        model.recordings.clear()
        folder = self._folder / "takes" / TAKES_FOLDER
        if model.takes.folder != folder or model.takes.now.takes or model.takes.now.n_deleted:
            for place in (self._folder / "no takes", folder):  # a project that is open would not be opened again
                shutil.rmtree(place, ignore_errors=True)
                model.takes.open(place)
                wait_for(lambda: not (QtWidgets.QApplication.processEvents() or model.takes.busy), "the takes")
        model.takes.speaker = ""
        page.takes.speaker.clear()
        bench = page.workbench
        bench.tabs.setCurrentIndex(0)
        bench.upper.setCurrentIndex(0)
        bench.phoneme_data.show_all()
        bench.phoneme_data.add.menu().clear()
        bench.variables.one.setCurrentIndex(bench.variables.one.findData(Phoneme.SZ))
        bench.variables.other.setCurrentIndex(bench.variables.other.findData(Phoneme.SCH))
        bench.compare.difference.setChecked(False)
        bench.compare.picker.list.search.clear()
        bench.compare.picker.list.for_other = False


def _leave_talk(desktop: Desktop) -> None:
    """Have a head that says nothing, and moves by the usual table."""
    talking = desktop.talking
    desktop.window.talk_parts.dialogs.restore()
    talking.clear_visemes()
    talking.text.drivers.compare(None)
    talking.text.set_lexicon(None)
    talking.expression.set_file(None)
    talking.expression.clear()
    for head in desktop.window.findChildren(HeadView):
        head.trouble = ""  # each test has OpenGL, or has none
    if talking.face.name != tr(HEADS[USUAL_HEAD]):
        talking.face.load(FaceFiles())


def _is_at_rest(desktop: Desktop) -> bool:
    """Let events come, and return whether all is measured that they ask for."""
    QtWidgets.QApplication.processEvents()
    session, talking = desktop.session, desktop.talking
    return not (session.busy or session.score.busy or talking.text.busy or talking.face.busy)


def _choices(settings: QSettings) -> dict[str, object]:
    return {name: settings.value(name) for name in settings.allKeys()}


def _choose(settings: QSettings, choices: dict[str, object]) -> None:
    settings.clear()
    for name, value in choices.items():
        settings.setValue(name, value)


def draw(window: QtWidgets.QWidget, on: bool) -> None:
    """Have a window drawn, or not."""
    window.setUpdatesEnabled(on)
    if on:  # Qt drops a request to paint while updates are off, and asks no second time for what is marked already
        QtWidgets.QApplication.postEvent(window, QEvent(QEvent.Type.UpdateRequest))


def close_popups() -> None:
    """Close what a test left open over all windows: it gets their keys, and no window becomes active meanwhile."""
    while (popup := QtWidgets.QApplication.activePopupWidget()) is not None:
        popup.hide()


def _show(window: MainWindow) -> None:
    window.resize(*SIZE)
    window.show()
    window.activateWindow()
    QTest.qWaitForWindowActive(window)
    if not window.isActiveWindow():  # it came to the front while a popup was open, of which Qt takes no note
        other = QtWidgets.QWidget()
        other.show()
        QTest.qWaitForWindowActive(other)
        other.close()
        window.activateWindow()
        QTest.qWaitForWindowActive(window)


def _leave_sound(session: Session) -> None:
    """Have no sound open, as before the first one."""
    session.preset.clear_second()
    session.view.follows = True
    session.leave_sound()
    session.set_channel(Channel.MIX)
    session.playback.set_tone(Tone())
    session.playback.set_speed(1.0)
    session.clear()


def _forget_edits(desktop: Desktop, *, whole: bool) -> None:
    """Have the rules of the thesis in use, as they are in their file."""
    preset = desktop.preset
    if whole or preset.path != THESIS_PRESET or preset.has_unsaved_changes or preset.undo_stack.count():
        preset.load(THESIS_PRESET)  # first, since the recogniser of another preset may be gone
    preset.set_bypassed(False)
    preset.try_out(None)
    desktop.session.curves.take_away(desktop.session.curves.curves)


def _show_usual(window: MainWindow, checked: dict[str, bool]) -> None:
    """Show all as it is at first: the page, the zoom and scales of the plots, no mouse over them, and no message."""
    window.show_page(ANALYSE)
    window.set_frozen(False)
    while window.banner.isVisible():
        window.banner.dismiss.click()  # messages first, then what is offered
    window.dialogs.sound_opened.emit()  # which lists the recent ones
    for text, on in checked.items():
        window.menus.show_checked(text, on)
    page = window.analysis
    for view in (page.spectrum, page.averaged, page.waveform):
        view.scale.setValue(0)
    page.waveform._loudest = SOFTEST
    window.transport.tone.show_tone(Tone())
    window.preset_box.list.search.clear()
    window.preset_box.list.for_other = False
    window.redraw.timer.start()
    for view in window.findChildren(pg.GraphicsView):
        QtWidgets.QApplication.sendEvent(view.parentWidget(), QEvent(QEvent.Type.Leave))
    for menu in window.findChildren(PlotMenu):
        for reset in (action for action in menu.actions() if action.text() == "Reset Zoom"):
            reset.trigger()
    for dialog in window.findChildren(QtWidgets.QDialog):
        dialog.deleteLater()
    _show_from_the_beginning(window)


def _show_from_the_beginning(window: MainWindow) -> None:
    """Have nothing marked, written or scrolled to."""
    page = window.analysis
    if page.averaged.measure.isChecked():
        page.averaged.drop_region()  # the button would ask for a name
    page.averaged.region.setRegion((1000, 1500))
    page.file.view.editor.clear()
    page.rules.phoneme.setCurrentIndex(0)
    page.rules.phoneme.activated.emit(0)
    page.rules.tree.setCurrentItem(None)
    for bar in window.findChildren(QtWidgets.QScrollBar):
        bar.setValue(bar.minimum())
    page.main_view.setFocus()


def _looks(desktop: Desktop) -> Counter[object]:
    """Return all by which a test may find that another was there before."""
    window, session, preset = desktop.window, desktop.session, desktop.preset
    found: Counter[object] = Counter(
        _looks_of(child)
        for child in (window, *window.findChildren(QtWidgets.QWidget), *window.findChildren(QAction))
        if not child.objectName().startswith("qt_")
        and not (child.isWidgetType() and _is(type(child.parent()), APART))
    )
    for view in window.findChildren(pg.GraphicsView):
        for item in view.scene().items():
            region = item.getRegion() if isinstance(item, pg.LinearRegionItem) else ()
            x = [f"{end:.3f}" for end in (item.viewRange()[0] if isinstance(item, pg.ViewBox) else region)]
            found[type(item).__name__, item.isVisible(), repr(x)] += 1
    found[preset.bypassed, preset.has_unsaved_changes, preset.undo_stack.count(), str(preset.path)] += 1
    playback, kind = session.playback, session.source.kind
    found[playback.loop, playback.volume, playback.speed, session.channel, kind, playback.tone] += 1
    found[session.history.n, session.averages.n_frames, session.view.seen, session.labels.state] += 1
    found[type(window.focusWidget()).__name__, window.size().toTuple(), window.theme] += 1
    found[window.redraw.timer.isActive(), desktop.talking.face.name] += 1
    return found


def _looks_of(child: QtWidgets.QWidget | QAction) -> tuple[object, ...]:
    """Return what is seen of something; what is hidden, or off, gets its text or its choice when it is shown."""
    kind = type(child)
    names, rests_where = _names_of(kind)
    seen = [getattr(child, name)() for name in (SEEN[QtWidgets.QWidget] if rests_where(child) else names)]
    kept = frozenset(
        (name, value) for name, value in vars(child).items() if _is(type(value), (bool, str, Enum, Path))
    )
    return kind, child.objectName(), repr(seen), kept


_is = cache(issubclass)  # Qt's objects answer `isinstance` slowly


@cache
def _names_of(kind: type) -> tuple[tuple[str, ...], Callable[[QtWidgets.QWidget], bool]]:
    """Return what tells of a kind of things that it was changed, and what tells of one that it rests."""
    names = tuple(name for known, names in SEEN.items() if issubclass(kind, known) for name in names)
    if issubclass(kind, QtWidgets.QLabel | QtWidgets.QToolButton):
        return names, QtWidgets.QWidget.isHidden
    if issubclass(kind, QtWidgets.QComboBox):
        return names, lambda box: not box.isEnabled()
    return names, (lambda splitter: not splitter.isVisible()) if issubclass(
        kind, QtWidgets.QSplitter
    ) else lambda _other: False
