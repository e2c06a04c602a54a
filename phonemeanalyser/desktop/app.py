"""The desktop program: the only place where its objects are made and joined."""

import gc
import logging
import sys
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from types import TracebackType

from PySide6 import QtCore
from PySide6.QtGui import QFileOpenEvent, QIcon, QSurfaceFormat
from PySide6.QtWidgets import QApplication, QMessageBox, QWidget
from typing_extensions import override

from phonemeanalyser.desktop import calibrate, talk
from phonemeanalyser.desktop.language import SYSTEM, language_of, tr, use_language
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.unsaved import UnsavedChanges
from phonemeanalyser.desktop.settings import keep, read
from phonemeanalyser.desktop.shutdown import SessionKeeper, end_promptly
from phonemeanalyser.desktop.theme import DARK, LIGHT, Theme, apply_theme, system_theme
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeanalyser.desktop.window import MainWindow
from phonemeanalyser.logs import logged_beside
from phonemeengine.audio.output import ClockOutput, Output, open_output
from phonemeengine.errors import EngineError
from phonemeengine.settings import Channel

COLLECT_EVERY_MS = 1000


class WindowThreadCollector(QtCore.QObject):
    """Collects garbage while the event loop runs, in the thread in which it was made; nothing else does until closed.

    Python collects in whichever thread allocates when it is due. Qt's objects must be destroyed in the thread in
    which they live: one that a thread of the analysis collects may wait for ever for the window, which waits for
    that thread.

    What was there before it was made is taken for needed for ever, so that each collection is short.
    """

    def __init__(self) -> None:
        super().__init__()
        gc.disable()
        gc.freeze()
        self._timer = QtCore.QTimer(self, interval=COLLECT_EVERY_MS)
        self._timer.timeout.connect(self.collect)
        self._timer.start()

    def collect(self) -> None:
        """Collect what is due, as Python would: the oldest generation whose count is above its threshold."""
        due = [count > threshold for count, threshold in zip(gc.get_count(), gc.get_threshold(), strict=True)]
        if any(due):
            gc.collect(max(generation for generation, is_due in enumerate(due) if is_due))

    def close(self) -> None:
        """Leave collecting to Python again."""
        self._timer.stop()
        gc.unfreeze()
        gc.enable()


AFTER_PAINTING_MS = 20
"""The window is to be seen before the sound card is awake."""
PATIENCE_MS = 50
"""Milliseconds for which a picture waits at a time for what is measured for it."""
ICON = Path(__file__).parent / "icon" / "phonemeanalyser.svg"
_log = logging.getLogger(__name__)
THEMES = {"light": LIGHT, "dark": DARK}


class Desktop:
    """The window with its models; makes the window anew when theme or language change.

    Parameters
    ----------
    app : Qt's application.
    settings : where layout and choices are kept between starts.
    open_device : opens what is played on.
    microphone : what is listened to; the system's, unless another is given.
    preset : what is tuned; the default preset, unless another is given.

    Attributes
    ----------
    demo : the sound that is shown to who asks for a demo; None where there is none.
    files : asks the user for files.
    """

    def __init__(
        self,
        app: QApplication,
        settings: QtCore.QSettings,
        open_device: Callable[[int], Output] = open_output,
        microphone: Microphone | None = None,
        preset: PresetModel | None = None,
    ) -> None:
        QtCore.QLocale.setDefault(QtCore.QLocale.c())  # one decimal sign everywhere, the point, as in all our files
        self._app = app
        self._settings = settings
        self.files = FileAsker(settings)
        self._use_language()
        self.preset = preset or PresetModel()
        self.session = Session(self.preset, open_device, microphone)
        self.demo: Path | None = None
        self._calibration: calibrate.CalibrationModel | None = None
        self._talking: talk.TalkModel | None = None
        self.window = self._make_window()
        self._scheme = app.styleHints().colorSchemeChanged.connect(lambda _scheme: self._follow_system())

    def close(self) -> None:
        """Let sound, window and system go, each before what it listens to; unsaved changes are not asked for."""
        self._app.styleHints().colorSchemeChanged.disconnect(self._scheme)
        models = [model for model in (self._calibration, self._talking) if model is not None]
        self.session.close()
        for model in models:
            model.close()
        self.window.close_without_asking()
        for closed in (*reversed(models), self.session, self.preset):
            closed.deleteLater()
        QtCore.QCoreApplication.sendPostedEvents(
            None, QtCore.QEvent.Type.DeferredDelete
        )  # in this order; no event loop runs now
        self._settings.sync()

    def save(self) -> None:
        """Keep layout and choices for the next start, on the disk."""
        self.window.save_state()
        self._settings.sync()

    @property
    def calibration(self) -> "calibrate.CalibrationModel":
        """The calibration; it is made when it is first asked for, which is after the first picture."""
        if self._calibration is None:
            self._calibration = calibrate.CalibrationModel(self.session, self.preset)
            self.window.join_calibration(self._calibration)
        return self._calibration

    @property
    def talking(self) -> "talk.TalkModel":
        """The head that talks; it is made when it is first asked for, which is after the first picture."""
        if self._talking is None:
            self._talking = talk.TalkModel(self.session)
            self.window.join_talk(self._talking)
            self.window.talk_parts.dialogs.restore()
        return self._talking

    @property
    def theme(self) -> Theme:
        """The look that the user chose, or the system's."""
        return THEMES.get(read(self._settings, "theme", "system"), system_theme())

    def set_theme(self, name: str) -> None:
        """Choose ``light``, ``dark`` or ``system``."""
        keep(self._settings, "theme", name)
        self._remake_window()

    def set_language(self, name: str) -> None:
        """Choose ``en``, ``de`` or ``system``."""
        keep(self._settings, "language", name)
        self._use_language()
        self._remake_window()

    def _use_language(self) -> None:
        use_language(self._app, language_of(read(self._settings, "language", SYSTEM)))

    def _remake_window(self) -> None:
        old = self.window
        old.save_state()
        self.window = self._make_window()
        self.window.show()  # which lays the docks out, before a page without them is shown
        self.window.copy_view_from(old)
        old.close_without_asking()

    def _make_window(self) -> MainWindow:
        apply_theme(self._app, self.theme)
        session, preset = self.session, self.preset
        window = MainWindow(
            session, preset, self.theme, self._settings, lambda: self.calibration, lambda: self.talking, self.files
        )
        window.theme_asked.connect(self.set_theme)
        window.language_asked.connect(self.set_language)
        window.demo_asked.connect(self._show_demo)
        window.welcome.animation_asked.connect(self._animate)
        if self._talking is not None:
            window.join_talk(self._talking)
        if self._calibration is not None:
            window.join_calibration(self._calibration)
        return window

    def greet(self) -> None:
        """Show what one could begin with, at the first start only."""
        if not read(self._settings, "greeted", False):
            keep(self._settings, "greeted", True)
            self.window.welcome.show_cards()

    def _show_demo(self) -> None:
        self.window.show_page(0)
        if self.demo is not None and self.window.dialogs.open_sound(self.demo):
            self.session.play()

    def _animate(self) -> None:
        """Lead through the Talk page with the recording that is open; without one of the user's own, ask for it."""
        talk = self.window.talk_parts.dialogs
        talk.page_asked.emit()
        if self.session.path in {None, self.demo}:
            self.window.dialogs.ask_sound()
        talk.show_first_tour()

    def _follow_system(self) -> None:
        if read(self._settings, "theme", "system") == "system" and self.window.theme != system_theme():
            self.set_theme("system")


class FirstPaint(QtCore.QObject):
    """Waits until a window is seen.

    Signals
    -------
    painted : the window has been painted, a moment ago, for the first time.
    """

    painted = QtCore.Signal()

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        window.installEventFilter(self)

    @override
    def eventFilter(self, window: QtCore.QObject, event: QtCore.QEvent) -> bool:
        if event.type() == QtCore.QEvent.Type.Paint:
            window.removeEventFilter(self)
            QtCore.QTimer.singleShot(AFTER_PAINTING_MS, self.painted.emit)
        return False


class FileRequests(QtCore.QObject):
    """Takes the files that macOS asks a running program to open, which come as events and not as arguments.

    Signals
    -------
    asked : the file to open.
    """

    asked = QtCore.Signal(Path)

    def __init__(self, app: QApplication) -> None:
        super().__init__(app)
        app.installEventFilter(self)

    @override
    def eventFilter(self, _watched: QtCore.QObject, event: QtCore.QEvent) -> bool:
        if isinstance(event, QFileOpenEvent) and event.file():
            self.asked.emit(Path(event.file()))
            return True
        return False


def make_application() -> QApplication:
    """Make Qt's application, or give the one that is there."""
    app = QApplication.instance()
    if isinstance(app, QApplication):
        return app
    form = QSurfaceFormat()  # some systems want to know the version of OpenGL before there is any window
    form.setVersion(3, 3)
    form.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    QSurfaceFormat.setDefaultFormat(form)
    app = QApplication(sys.argv[:1])
    app.setApplicationName("PhonemeAnalyser")
    app.setOrganizationName("PhonemeAnalyser")
    app.setDesktopFileName("phonemeanalyser")  # by which Wayland finds the icon
    app.setWindowIcon(QIcon(str(ICON)))
    return app


def run(file: Path | None, demo: Path, preset: Path | None = None, channel: Channel | None = None) -> int:
    """Open the window on a file, or on the last one, or on the demo; returns the exit code when it is closed."""
    app = make_application()
    with logged_beside(_settings_folder()) as log:
        sys.excepthook = partial(_report_bug, log)
        return _run(app, file, demo, preset, channel)


def _run(app: QApplication, file: Path | None, demo: Path, preset: Path | None, channel: Channel | None) -> int:
    settings, collector = QtCore.QSettings(), WindowThreadCollector()
    desktop = Desktop(app, settings)
    dialogs, unsaved = desktop.window.dialogs, UnsavedChanges(desktop.preset, _data_folder(), settings)
    keeper = SessionKeeper(app, desktop.save, unsaved)
    dialogs.presets.restore()
    dialogs.presets.restore_unsaved(unsaved)
    if preset is not None:
        dialogs.presets.load(preset)
    desktop.session.curves.keep_in(_data_folder() / "averaged spectra")
    desktop.demo = demo
    begin = partial(_begin, desktop, file, dialogs.last_sound() or demo, channel)
    FirstPaint(desktop.window).painted.connect(begin)
    FileRequests(app).asked.connect(lambda path: desktop.window.open_files([path]))
    desktop.window.show()  # which lays the docks out, before a page without them is shown
    desktop.window.show_last_page()
    code = app.exec()
    keeper.close()
    desktop.close()
    collector.close()
    end_promptly(code)
    return code


def _settings_folder() -> Path:
    return Path(
        QtCore.QStandardPaths.writableLocation(QtCore.QStandardPaths.StandardLocation.AppConfigLocation)
    ).parent


def _data_folder() -> Path:
    return Path(QtCore.QStandardPaths.writableLocation(QtCore.QStandardPaths.StandardLocation.AppDataLocation))


def _begin(desktop: Desktop, file: Path | None, last_sound: Path, channel: Channel | None) -> None:
    """Go on with what the window need not wait for."""
    _ = desktop.talking, desktop.calibration  # both restore what the last start kept
    if file is None or not desktop.window.opens_as_sound(file):
        desktop.window.dialogs.open_sound(last_sound)
    if file is not None:
        desktop.window.open_files([file])
    if channel is not None:
        desktop.session.set_channel(channel)
    desktop.window.dialogs.offer_unfinished()
    desktop.greet()


def screenshot(
    file: Path,
    out: Path,
    *,
    at: float | None,
    size: tuple[int, int],
    theme: str,
    language: str,
    preset: Path | None,
    channel: Channel,
) -> None:
    """Save a picture of the window, with a file analysed up to a time (seconds; None means its end).

    Raises
    ------
    EngineError : the sound or the preset cannot be read, or the picture cannot be written.
    """
    app = make_application()
    QtCore.qInstallMessageHandler(_pass_message)
    with tempfile.TemporaryDirectory() as folder:
        settings = QtCore.QSettings(str(Path(folder) / "settings.ini"), QtCore.QSettings.Format.IniFormat)
        settings.setValue("theme", theme)
        settings.setValue("language", language)
        desktop = Desktop(app, settings, lambda _n: ClockOutput())
        try:
            if preset is not None:
                desktop.preset.load(preset)
            desktop.window.resize(*size)
            desktop.window.show()
            _follow(desktop.session, file, at, channel)
            desktop.window.redraw.refresh_all()
            desktop.window.grab()  # what is looked at is measured
            while desktop.session.busy:
                app.processEvents(QtCore.QEventLoop.ProcessEventsFlag.AllEvents, PATIENCE_MS)
            app.processEvents()
            saved = desktop.window.grab().save(str(out), "PNG")
        finally:
            desktop.close()
    if not saved:
        raise EngineError(
            tr("{out}: the picture could not be written; choose another location with -o").format(out=out)
        )


def _follow(session: Session, file: Path, at: float | None, channel: Channel) -> None:
    failures: list[str] = []
    session.error.connect(failures.append)
    if session.open(file):
        session.set_channel(channel)
    if failures:
        raise EngineError(failures[0])
    session.analyse_until(session.source.duration if at is None else at)


def _pass_message(_kind: QtCore.QtMsgType, _context: QtCore.QMessageLogContext, message: str) -> None:
    """Pass Qt's messages on, but for one that every window makes that is not on a screen."""
    if "propagateSizeHints" not in message:
        print(message, file=sys.stderr)


def _report_bug(log: Path, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
    """Write a bug to the log, and show one dialog however often it comes."""
    _log.error("the program crashed", exc_info=(kind, error, trace))
    if QApplication.activeModalWidget() is None:
        QMessageBox.critical(
            QApplication.activeWindow(),  # whose style it has
            "PhonemeAnalyser",
            tr("Internal error. Details are in {log}; send that file with your report.").format(log=log),
        )
