"""A user's hands and eyes: what tests do with mouse and keyboard, and how they look at the window."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pyqtgraph as pg
import soundfile
from numpy.typing import NDArray
from PySide6 import QtWidgets
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QTimer, QUrl
from PySide6.QtGui import QColor, QDragEnterEvent, QDropEvent, QImage, QWheelEvent, qGray
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.widgets.plot import PlotMenu
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.settings import BIN_WIDTH, SAMPLE_RATE
from tests.conftest import ROOT

CARDS = ROOT / "tests" / "data" / "cards.flac"
DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"
ON_BIN = 46 * BIN_WIDTH
"""A frequency near 1 kHz that lies on a bin."""
LEFT = Qt.MouseButton.LeftButton


def shown(desktop: Desktop, qtbot: QtBot, sound: Path | None = CARDS) -> MainWindow:
    """Show the window, with a sound in hand."""
    window = desktop.window
    window.resize(1280, 800)  # the screen of the tests is smaller
    with qtbot.waitActive(window):
        window.show()
        window.activateWindow()
    if sound is not None:
        window.dialogs.open_sound(sound)
    return window


def followed(desktop: Desktop, qtbot: QtBot, sound: Path = CARDS, seconds: float = 3.4) -> MainWindow:
    """Show the window with a sound that has been analysed up to a time, on the strip chart of what is heard."""
    window = shown(desktop, qtbot, sound)
    window.analysis.over_time.setCurrentWidget(window.analysis.scroll_view)
    desktop.session.analyse_until(seconds)
    window.redraw.refresh_all()
    return window


def wait_for_results(desktop: Desktop, qtbot: QtBot) -> None:
    """Wait until what was heard last is analysed with the preset in force."""
    qtbot.waitUntil(lambda: not desktop.session.results.busy)


def wav(folder: Path, sound: NDArray[np.float32], name: str = "sound.wav") -> Path:
    """Write a sound, shape (n,) or (n, n_channels), as a float WAV."""
    soundfile.write(folder / name, sound, SAMPLE_RATE, subtype="FLOAT")
    return folder / name


def menu(window: MainWindow, title: str) -> QtWidgets.QMenu:
    """Find a menu by its title."""
    return next(action.menu() for action in window.menuBar().actions() if action.text() == title)


def edits(window: MainWindow) -> list[str]:
    """Give what undo and redo would do, as the menu says it."""
    return [action.text() for action in menu(window, "&Edit").actions() if action.isEnabled()]


def click(widget: QtWidgets.QWidget, x: float | None = None) -> None:
    """Click on a widget's middle, or on x of it; of a check box, on its box."""
    if x is None:
        x = (
            8
            if isinstance(widget, QtWidgets.QAbstractButton) and not isinstance(widget, QtWidgets.QToolButton)
            else widget.width() / 2
        )
    QTest.mouseClick(widget, LEFT, pos=QPoint(round(x), widget.height() // 2))


def drag(widget: QtWidgets.QWidget, start: float, end: float, steps: int = 5) -> None:
    """Drag along a widget, from x to x."""
    middle = widget.height() // 2
    QTest.mousePress(widget, LEFT, pos=QPoint(round(start), middle))
    for x in np.linspace(start, end, steps + 1)[1:]:
        QTest.mouseMove(widget, QPoint(round(x), middle))
    QTest.mouseRelease(widget, LEFT, pos=QPoint(round(end), middle))


def press(
    window: QtWidgets.QWidget, key: Qt.Key, modifier: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier
) -> None:
    """Press a key, wherever the focus is."""
    QTest.keyClick(QtWidgets.QApplication.focusWidget() or window, key, modifier)


def answer(button: str) -> list[str]:
    """Press a button of the question that comes next; gives a list that will hold its text."""
    told: list[str] = []

    def press_it() -> None:
        box = QtWidgets.QApplication.activeModalWidget()
        if not isinstance(box, QtWidgets.QMessageBox):
            QTimer.singleShot(10, press_it)
            return
        told.append(box.text())
        next(b for b in box.buttons() if b.text().replace("&", "") == button).click()

    QTimer.singleShot(0, press_it)
    return told


class DialogHand:
    """Acts in each dialog that comes from now on, once, in place of a user; without `act` it rejects them.

    Attributes
    ----------
    act : given each dialog, which it should close.
    titles : of all dialogs that came.
    texts : what the message boxes among them said.
    """

    def __init__(self) -> None:
        self.act: Callable[[Any], object] = QtWidgets.QDialog.reject
        self.titles: list[str] = []
        self.texts: list[str] = []
        self._known = [QtWidgets.QApplication.activeModalWidget()]
        self._timer = QTimer(interval=5)
        self._timer.timeout.connect(self._look)
        self._timer.start()

    def press(self, button: QtWidgets.QMessageBox.StandardButton) -> None:
        """Have a button of the next message boxes be pressed."""
        self.act = lambda box: box.button(button).click()

    def _look(self) -> None:
        dialog = QtWidgets.QApplication.activeModalWidget()
        if not isinstance(dialog, QtWidgets.QDialog) or any(dialog is known for known in self._known):
            return
        self._known.append(dialog)
        self.titles.append(dialog.windowTitle())
        if isinstance(dialog, QtWidgets.QMessageBox):
            self.texts.append(dialog.text())
        try:
            self.act(dialog)
        except BaseException:
            dialog.reject()
            raise

    def rest(self) -> None:
        """Act no more."""
        self._timer.stop()
        self._known.clear()


def back_in(window: MainWindow, qtbot: QtBot) -> None:
    """Give the keyboard back to the window after a dialog."""
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)


NOTHING_HELD = Qt.KeyboardModifier.NoModifier


def turn_wheel(
    widget: QtWidgets.QWidget, notches: int, at: QPointF | None = None, held: Qt.KeyboardModifier = NOTHING_HELD
) -> bool:
    """Turn the wheel over a place, the middle unless told otherwise; return whether the widget took it for itself."""
    place = QPointF(widget.rect().center()) if at is None else at
    turn, released, phase = QPoint(0, 120 * notches), Qt.MouseButton.NoButton, Qt.ScrollPhase.NoScrollPhase
    event = QWheelEvent(place, widget.mapToGlobal(place), QPoint(), turn, released, held, phase, False)
    QtWidgets.QApplication.sendEvent(widget, event)
    return event.isAccepted()


def settle() -> None:
    """Let the window lay itself out and paint: all that waits in the event loop is done."""
    for _ in range(10):  # what is painted first may still fill its words in
        QtWidgets.QApplication.sendPostedEvents()
        QtWidgets.QApplication.processEvents()


def type_number(box: QtWidgets.QAbstractSpinBox, text: str) -> None:
    """Click into a number, replace it, and press Return."""
    click(box.lineEdit(), 4)
    box.selectAll()
    QTest.keyClicks(box, text)
    QTest.keyClick(box, Qt.Key.Key_Return)


def button(view: QtWidgets.QWidget, text: str) -> QtWidgets.QToolButton:
    """Find a button by what is written on it."""
    return next(b for b in view.findChildren(QtWidgets.QToolButton) if b.text() == text)


def hover(graphics: pg.GraphicsView, plot: Any, x: float, y: float) -> None:
    """Move the mouse to a point of a plot."""
    QTest.mouseMove(graphics.viewport(), QPoint(5, 5))
    QTest.mouseMove(graphics.viewport(), place(graphics, plot, x, y))


def place(graphics: pg.GraphicsView, plot: Any, x: float, y: float) -> QPoint:
    """Give the pixel at which a point of a plot is drawn."""
    return graphics.mapFromScene(plot.vb.mapViewToScene(QPointF(x, y)))


def copied(menu: PlotMenu, at: QPoint) -> list[list[str]]:
    """Copy the values that a plot's menu offers at a point, and give their cells; the first row is the header."""
    menu.at = at
    choose(menu, "Copy Values")
    return [line.split("\t") for line in QtWidgets.QApplication.clipboard().text().splitlines()]


def choose(menu: QtWidgets.QMenu, entry: str) -> None:
    """Choose an entry of a menu."""
    next(action for action in menu.actions() if action.text() == entry).trigger()


class FileAnswers:
    """Answers for a user who is asked for a file: these paths, none for one who cancels, or what is suggested.

    Attributes
    ----------
    suggested : what each dialog began with.
    """

    def __init__(self, *paths: Path, chosen: str = "", as_suggested: bool = False) -> None:
        self.paths, self.chosen, self.as_suggested = paths, chosen, as_suggested
        self.suggested: list[Path] = []

    def __call__(self, _mode: object, _title: str, place: str, _filters: str) -> tuple[list[str], str]:
        self.suggested.append(Path(place))
        return [place] if self.as_suggested else list(map(str, self.paths)), self.chosen


class TimeEyes:
    """Looks at the time view's pixels."""

    def __init__(self, window: MainWindow) -> None:
        self.view = window.analysis.scroll_view
        self.graphics = self.view.findChild(pg.GraphicsLayoutWidget)
        items = (self.graphics.ci.getItem(row, 0) for row in (0, 1, 3))  # row 2 is the feeling
        self.sonagram, self.lane, self.course = items
        self.image: QImage = self.graphics.grab().toImage()
        self.top: float = window.analysis.sonagram.top.currentData()

    def share(self, frequency: float) -> float:
        """Give where a frequency lies in the sonagram, 0..1 from below, while its axis is linear."""
        return frequency / self.top

    def colour(self, plot: Any, x: float, y: float) -> QColor:
        """Give the colour that is seen at a point of a plot; of the sonagram at a frequency, Hz."""
        y = self.share(y) if plot is self.sonagram else y
        return self.image.pixelColor(place(self.graphics, plot, x, y))

    def brightest(self, seconds: float) -> float:
        """Give the frequency of the brightest pixel of a column of the sonagram, Hz: of several the middle one."""
        column = self._column(seconds)
        most = max(light for light, _ in column)
        return float(np.median([y for light, y in column if light == most]))

    def brightness(self, seconds: float) -> int:
        """Give how bright the brightest pixel of a column of the sonagram is, 0..255."""
        return max(light for light, _ in self._column(seconds))

    def _column(self, seconds: float) -> list[tuple[int, float]]:
        places = np.linspace(0.02, 0.98, 400) * self.top
        return [(qGray(self.colour(self.sonagram, seconds, y).rgb()), y) for y in places]


def lies_behind(widget: QtWidgets.QWidget | None) -> bool:
    """Whether a widget is in a dock that lies behind another: Qt leaves that one visible, outside the window."""
    while widget is not None and not isinstance(widget, QtWidgets.QDockWidget):
        widget = widget.parentWidget()
    return widget is not None and widget.geometry().right() < 0


def drop(widget: QtWidgets.QWidget, *paths: Path) -> bool:
    """Drag files from elsewhere and drop them onto a widget; says whether they were welcome."""
    mime = QMimeData()
    mime.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    return drop_data(widget, mime)


def drop_data(widget: QtWidgets.QWidget, mime: QMimeData) -> bool:
    """Drag something from elsewhere and drop it onto a widget; says whether it was welcome."""
    place = QPoint(widget.width() // 2, widget.height() // 2)
    enter = QDragEnterEvent(place, Qt.DropAction.CopyAction, mime, LEFT, Qt.KeyboardModifier.NoModifier)
    QtWidgets.QApplication.sendEvent(widget, enter)
    event = QDropEvent(QPointF(place), Qt.DropAction.CopyAction, mime, LEFT, Qt.KeyboardModifier.NoModifier)
    QtWidgets.QApplication.sendEvent(widget, event)
    return enter.isAccepted() and event.isAccepted()
