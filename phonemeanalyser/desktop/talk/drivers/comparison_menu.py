"""The menu that chooses what moves a second head, which is compared with the first."""

from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMenu, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.drivers.driver_model import DriverModel
from phonemeengine.mouth.face_driver import FaceDriver

COMPARISONS = {
    None: tr_noop("No Comparison"),
    FaceDriver.RULES: tr_noop("With Phonemes (Rules)"),
    FaceDriver.PINYIN: tr_noop("With Pinyin Letters"),
    FaceDriver.TABLE: tr_noop("With Recorded Faces"),
}
"""What a second head can be moved by."""


class ComparisonMenu(QMenu):
    """Lists what a second head can be moved by; a table only where one is open."""

    def __init__(self, drivers: DriverModel, parent: QWidget) -> None:
        super().__init__(tr("Compare"), parent)
        self._drivers = drivers
        self._group = QActionGroup(self)
        for driver, words in COMPARISONS.items():
            action = self._group.addAction(tr(words))
            action.setCheckable(True)
            action.setData(driver)
            self.addAction(action)
        self._group.triggered.connect(self._choose)
        drivers.changed.connect(self._show_state)
        drivers.performance.changed.connect(self._show_state)
        self._show_state()

    def _choose(self, action: QAction) -> None:
        driver = action.data()
        self._drivers.compare(None if driver is None else FaceDriver(driver))

    def _show_state(self) -> None:
        for action in self._group.actions():
            action.setChecked(action.data() == self._drivers.compared)
            by_table = action.data() == FaceDriver.TABLE
            action.setEnabled(not by_table or self._drivers.performance.table is not None)
