"""The page of the calibration: takes at the left, and what they say of the preset at the right."""

from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.calibrate.guide.guide_view import GuideView
from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeanalyser.desktop.calibrate.takes.takes_panel import TakesPanel
from phonemeanalyser.desktop.calibrate.workbench.workbench_view import WorkbenchView
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import line, row
from phonemeanalyser.desktop.widgets.pages import PageStack
from phonemeanalyser.desktop.widgets.phoneme_keys import HeldKeys
from phonemeanalyser.desktop.widgets.preset_picker import PresetPicker


class CalibrationPage(QWidget):
    """Lays out what belongs to calibration.

    Parameters
    ----------
    head : says in the guided calibration what is recognised.
    picker : the list of presets, from which the other one of A and B is chosen.

    Attributes
    ----------
    keys : to be installed as an event filter of the window.
    """

    def __init__(self, calibration: CalibrationModel, head: QWidget, picker: PresetPicker, theme: Theme) -> None:
        super().__init__()
        self._calibration = calibration
        self._theme = theme
        self.takes = TakesPanel(calibration, theme)
        self.keys = HeldKeys(calibration, self)
        self.right = PageStack()
        self.guide = GuideView(calibration, head, theme)
        self.workbench = WorkbenchView(calibration, picker, theme)
        self._lay_out()
        self.takes.guide_asked.connect(calibration.begin_guide)
        calibration.guide.changed.connect(self._show_guide)

    def refresh(self) -> None:
        """Show what changes by itself."""
        if self._calibration.guide.running:
            self.guide.refresh()
        elif self.workbench.phoneme_data.isVisible():
            self.workbench.phoneme_data.refresh()

    def _show_guide(self) -> None:
        running = self._calibration.guide.running
        self.right.setCurrentWidget(self.guide if running else self.workbench)
        self.takes.guide.setEnabled(not running)
        self.takes.room.setEnabled(not running)
        self.takes.record.setEnabled(not running)

    def _lay_out(self) -> None:
        self.right.addWidget(self.workbench)
        self.right.addWidget(self.guide)
        row(self.takes, line(self._theme.line, upright=True), (self.right, 1), on=self, spacing=0)
