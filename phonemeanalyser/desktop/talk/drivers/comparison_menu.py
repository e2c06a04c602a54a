"""The menu that chooses what moves a second head, which is compared with the first."""

from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMenu, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.drivers.difference_model import DifferenceModel
from phonemeanalyser.desktop.talk.drivers.driver_model import OTHER_PRESET, DriverModel
from phonemeengine.mouth.face_driver import NEEDS_FILE, FaceDriver

COMPARISONS = {
    None: tr_noop("No Comparison"),
    FaceDriver.RULES: tr_noop("With Phonemes (Rules)"),
    FaceDriver.PINYIN: tr_noop("With Pinyin Letters"),
    FaceDriver.TABLE: tr_noop("With Recorded Faces"),
    FaceDriver.NETWORK: tr_noop("With a Face Network"),
    OTHER_PRESET: tr_noop("With Preset B (Analysis > Choose Preset B…)"),
}
"""What a second head can be moved by."""


class ComparisonMenu(QMenu):
    """Lists what a second head can be moved by; a table, a network or preset B only where there is one."""

    def __init__(self, drivers: DriverModel, comparison: DifferenceModel, parent: QWidget) -> None:
        super().__init__(tr("Compare"), parent)
        self._drivers, self._comparison = drivers, comparison
        self._group = QActionGroup(self)
        for driver, words in COMPARISONS.items():
            action = self._group.addAction(tr(words))
            action.setCheckable(True)
            action.setData(driver)
            self.addAction(action)
        self._group.triggered.connect(self._choose)
        drivers.changed.connect(self._show_state)
        for files in (drivers.performance, drivers.network):
            files.changed.connect(self._show_state)
        self.aboutToShow.connect(self._show_state)
        self._show_state()

    def _choose(self, action: QAction) -> None:
        driver = action.data()
        self._drivers.compare(driver if driver in {None, OTHER_PRESET} else FaceDriver(driver))

    def _show_state(self) -> None:
        for action in self._group.actions():
            action.setChecked(action.data() == self._drivers.compared)
            if action.data() in NEEDS_FILE:
                action.setEnabled(bool(self._drivers.name_of(action.data())))
            elif action.data() == OTHER_PRESET:
                other = self._comparison.other_preset
                action.setEnabled(bool(other))
                words = tr("With Preset {preset}").format(preset=other.replace("&", "&&"))
                action.setText(words if other else tr(COMPARISONS[OTHER_PRESET]))
