"""The page of the calibration: takes at the left, and what they say of the preset at the right."""

from PySide6.QtWidgets import QFrame, QHBoxLayout, QWidget

from phonemeanalyser.models.calibration import Calibration
from phonemeanalyser.models.talking import Talking
from phonemeanalyser.theme import Theme
from phonemeanalyser.views.calibration_bench import BenchView
from phonemeanalyser.views.calibration_guide import GuideView
from phonemeanalyser.views.calibration_keys import HeldKeys
from phonemeanalyser.views.calibration_takes import TakesPanel
from phonemeanalyser.views.page_switch import PageStack


class CalibrationPage(QWidget):
    """Lays out what belongs to calibration.

    Attributes
    ----------
    keys : to be installed as an event filter of the window.
    """

    def __init__(self, calibration: Calibration, talking: Talking, theme: Theme) -> None:
        super().__init__()
        self._calibration = calibration
        self._theme = theme
        self.takes = TakesPanel(calibration, theme)
        self.keys = HeldKeys(calibration, self)
        self.right = PageStack()
        self.guide = GuideView(calibration, talking, theme)
        self.workbench = BenchView(calibration, theme)
        self._lay_out()
        self.takes.guide_asked.connect(calibration.begin_guide)
        calibration.guide.changed.connect(self._show_guide)

    def refresh(self) -> None:
        """Show what changes by itself."""
        if self._calibration.guide.running:
            self.guide.refresh()
        else:
            self.workbench.refresh()

    def _show_guide(self) -> None:
        running = self._calibration.guide.running
        self.right.setCurrentWidget(self.guide if running else self.workbench)
        self.takes.guide.setEnabled(not running)
        self.takes.room.setEnabled(not running)
        self.takes.record.setEnabled(not running)

    def _lay_out(self) -> None:
        line = QFrame()
        line.setFixedWidth(1)
        line.setStyleSheet(f"background: {self._theme.line}")
        self.right.addWidget(self.workbench)
        self.right.addWidget(self.guide)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(0)
        row.addWidget(self.takes)
        row.addWidget(line)
        row.addWidget(self.right, 1)
