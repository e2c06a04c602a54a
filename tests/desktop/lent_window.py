"""One window that tests use in turn, since making one takes twenty times as long as most tests."""

from collections import Counter
from collections.abc import Callable
from enum import Enum
from pathlib import Path

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QSettings
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QApplication,
    QComboBox,
    QDialog,
    QLabel,
    QLineEdit,
    QMenu,
    QSplitter,
    QStackedWidget,
    QWidget,
)

from phonemeanalyser.desktop.analyse.spectra.waveform_view import SOFTEST
from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.widgets.plot_menu import PlotMenu
from phonemeanalyser.desktop.window import ANALYSE, MainWindow
from phonemeengine.audio.tone.settings import Tone
from phonemeengine.presets.files import THESIS_PRESET
from phonemeengine.settings import Channel
from tests.waiting import wait_for

SEEN: dict[type, tuple[str, ...]] = {
    QWidget: ("isHidden", "isEnabled"),
    QAbstractButton: ("text", "isChecked"),
    QAbstractSlider: ("value",),
    QComboBox: ("currentIndex", "currentText", "count"),
    QLabel: ("text",),
    QLineEdit: ("text",),
    QStackedWidget: ("currentIndex",),
    QSplitter: ("sizes",),
    QAction: ("text", "isChecked", "isEnabled", "isVisible"),
}
"""What tells, of each kind of things, that somebody changed it."""
SIZE = 1280, 800
LAYOUT = {"geometry", "layout", "layout_width", "layout_stacked", "rows", "spectra"}


class WindowLender:
    """Lends a window, tidied, to each test in turn; one that cannot be tidied is replaced by a new one.

    Parameters
    ----------
    make : makes a program that begins with the rules of the thesis.
    settings : where it keeps its choices.
    """

    def __init__(self, make: Callable[[], Desktop], settings: QSettings) -> None:
        self.settings = settings
        self._make = make
        self._first = _choices(settings)
        self._desktop = self._begin()
        menus = self._desktop.window.menus.actions
        self._checked = {text: action.isChecked() for text, action in menus.items()}
        self._desktop.window.save_state()
        self._usual = {name: value for name, value in _choices(settings).items() if name not in LAYOUT}
        self._tidy()
        self._clean = _looks(self._desktop)  # no test has changed anything yet

    def lend(self) -> Desktop:
        """Return a program that is as one that was just begun, but that its window is seen already."""
        for _ in range(2):  # what the first time hides leaves its room to others with the events of the second
            self._tidy()
            if _looks(self._desktop) == self._clean:
                return self._desktop
        self.close()
        self._desktop = self._begin()
        return self._desktop

    def close(self) -> None:
        """Let the window go."""
        self._desktop.close()

    def _begin(self) -> Desktop:
        _choose(self.settings, self._first)
        desktop = self._make()
        _show(desktop.window)
        return desktop

    def _tidy(self) -> None:
        desktop, window = self._desktop, self._desktop.window
        _show(window)
        _choose(self.settings, self._usual)
        _leave_sound(desktop.session)
        _forget_edits(desktop)
        _show_usual(window, self._checked)
        window.state.restore(desktop.session, window.analysis)
        window.redraw.refresh_all()
        wait_for(lambda: _is_at_rest(desktop.session), "the window")
        for _ in range(3):
            QApplication.processEvents()  # what hides leaves its room to its parent, which then does so to the page
        window.analysis.variable.phonemes.clear()  # it tells sooner or later that nothing is measured
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        _choose(self.settings, self._first)


def _is_at_rest(session: Session) -> bool:
    """Let events come, and return whether all is measured that they ask for."""
    QApplication.processEvents()
    return not session.busy and not session.score.busy


def _choices(settings: QSettings) -> dict[str, object]:
    return {name: settings.value(name) for name in settings.allKeys()}


def _choose(settings: QSettings, choices: dict[str, object]) -> None:
    settings.clear()
    for name, value in choices.items():
        settings.setValue(name, value)


def _show(window: MainWindow) -> None:
    window.resize(*SIZE)
    window.show()
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


def _forget_edits(desktop: Desktop) -> None:
    """Have the rules of the thesis in use, as they are in their file."""
    desktop.preset.set_bypassed(False)
    desktop.preset.try_out(None)
    desktop.preset.load(THESIS_PRESET)
    desktop.session.curves.take_away(desktop.session.curves.curves)


def _show_usual(window: MainWindow, checked: dict[str, bool]) -> None:
    """Show all as it is at first: the page, the zoom and scales of the plots, no mouse over them, and no message."""
    window.show_page(ANALYSE)
    window.set_frozen(False)
    window.banner.show_error("")
    window.dialogs.sound_opened.emit()  # which lists the recent ones
    for text, on in checked.items():
        window.menus.show_checked(text, on)
    page = window.analysis
    for view in (page.spectrum, page.averaged, page.waveform):
        view.scale.setValue(0)
    page.waveform._loudest = SOFTEST
    page.averaged.region.setRegion((1000, 1500))
    for view in window.findChildren(pg.GraphicsView):
        QApplication.sendEvent(view.parentWidget(), QEvent(QEvent.Type.Leave))
    for menu in window.findChildren(PlotMenu):
        for reset in (action for action in menu.actions() if action.text() == "Reset Zoom"):
            reset.trigger()
    for dialog in window.findChildren(QDialog):
        dialog.deleteLater()
    page.file.view.editor.clear()
    page.main_view.setFocus()


def _looks(desktop: Desktop) -> Counter[object]:
    """Return all by which a test may find that another was there before."""
    window, session, preset = desktop.window, desktop.session, desktop.preset
    found: Counter[object] = Counter()
    for child in (window, *window.findChildren(QWidget), *window.findChildren(QAction)):
        if child.objectName().startswith("qt_"):
            continue  # Qt's own, such as what holds a scroll bar
        if isinstance(child, QWidget) and isinstance(child.parent(), QMenu):
            continue  # which a menu hides until it was opened once; what it holds is looked at
        seen = [getattr(child, name)() for kind, names in SEEN.items() if isinstance(child, kind) for name in names]
        kept = sorted((k, repr(v)) for k, v in vars(child).items() if isinstance(v, (bool, str, Enum, Path)))
        found[type(child).__name__, child.objectName(), repr(seen), repr(kept)] += 1
    for view in window.findChildren(pg.GraphicsView):
        for item in view.scene().items():
            region = item.getRegion() if isinstance(item, pg.LinearRegionItem) else ()
            x = np.round(item.viewRange()[0] if isinstance(item, pg.ViewBox) else region, 3).tolist()
            found[type(item).__name__, item.isVisible(), repr(x)] += 1
    found[preset.bypassed, preset.has_unsaved_changes, preset.undo_stack.count(), str(preset.path)] += 1
    playback, kind = session.playback, session.source.kind
    found[playback.loop, playback.volume, playback.speed, session.channel, kind, playback.tone] += 1
    found[session.history.n, session.averages.n_frames, session.view.seen, session.labels.state] += 1
    found[type(window.focusWidget()).__name__, window.size().toTuple(), window.theme] += 1
    return found
