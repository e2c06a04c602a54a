"""The pages that are made when they are first needed, and what they ask of the user."""

from PySide6.QtWidgets import QMainWindow

from phonemeanalyser.desktop.calibrate.dialogs import CalibrationDialogs
from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeanalyser.desktop.calibrate.page import CalibrationPage
from phonemeanalyser.desktop.dialogs import Dialogs
from phonemeanalyser.desktop.talk.dialogs import TalkDialogs
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.page import TalkPage
from phonemeanalyser.desktop.theme import Theme


class PageMaker:
    """Makes pages, and joins them to a window's dialogs and keys.

    Parameters
    ----------
    window : gets the keys of the pages.
    dialogs, calibration, talking : ask what the pages want to be asked.
    """

    def __init__(
        self, window: QMainWindow, theme: Theme, dialogs: Dialogs, calibration: CalibrationDialogs,
        talking: TalkDialogs,
    ) -> None:  # fmt: skip
        self._window = window
        self._theme = theme
        self._dialogs = dialogs
        self._calibration_dialogs = calibration
        self._talking_dialogs = talking

    def calibration_page(self, calibration: CalibrationModel, talking: TalkModel) -> CalibrationPage:
        """Make the page of the calibration."""
        page, dialogs = CalibrationPage(calibration, talking, self._theme), self._calibration_dialogs
        page.takes.project_asked.connect(dialogs.ask_project)
        page.takes.import_asked.connect(dialogs.ask_recordings)
        page.guide.save_asked.connect(self._dialogs.save_as)
        page.workbench.rival.file_asked.connect(lambda: self._ask_rival(page))
        page.workbench.picture_asked.connect(self._dialogs.ask_save_picture)
        page.workbench.variables.add_asked.connect(self._dialogs.add_variable)
        self._window.installEventFilter(page.keys)
        return page

    def talk_page(self, talking: TalkModel) -> TalkPage:
        """Make the page of the head."""
        page, dialogs = TalkPage(talking, self._theme), self._talking_dialogs
        page.sound_asked.connect(lambda: self._say_another(talking))
        page.preset_asked.connect(self._dialogs.ask_preset)
        page.choices.mesh_asked.connect(dialogs.ask_mesh)
        page.choices.table_asked.connect(dialogs.ask_table)
        self._window.installEventFilter(page.keys)
        return page

    def _say_another(self, talking: TalkModel) -> None:
        """Let the user choose a sound file, and have the head say it at once."""
        if self._dialogs.ask_sound():
            talking.session.play()

    def _ask_rival(self, page: CalibrationPage) -> None:
        path = self._calibration_dialogs.ask_preset()
        if path is not None:
            page.workbench.rival.offer(path)
