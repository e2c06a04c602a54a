"""Two heads compared: the menu of what moves the second one, and the bar of where they differ most."""

from functools import partial

from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMenu, QWidget

from phonemeanalyser.desktop.language import tr, tr_count, tr_noop
from phonemeanalyser.desktop.talk.drivers.difference_model import DifferenceModel
from phonemeanalyser.desktop.talk.drivers.driver_model import OTHER_PRESET, DriverModel
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.widgets.builders import ElidedLabel, open_without_arrow, row, spoken_button
from phonemeengine.mouth.animation import NEEDS_FILE, FaceDriver

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


class DifferenceBar(QWidget):
    """Shown while two heads are compared.

    Attributes
    ----------
    summary : by how much they differ.
    list : the places, the first one differs most; a click goes there.
    previous, next : go to the place before and after.
    """

    def __init__(self, talking: TalkModel) -> None:
        super().__init__()
        self._talking, self._comparison = talking, talking.comparison
        self.summary = ElidedLabel()
        self.list = QMenu(self)
        self.previous = spoken_button("◂", tr("Go to the previous difference of the list"), partial(self._step, -1))
        self._open = spoken_button("", tr("Where both heads differ most; choose a place to go there"))
        self.next = spoken_button("▸", tr("Go to the next difference of the list"), partial(self._step, 1))
        open_without_arrow(self._open, self.list)
        row((self.summary, 1), self.previous, self._open, self.next, on=self, margins=(8, 2, 8, 0), spacing=4)
        self.list.aboutToShow.connect(self._fill_list)
        self._comparison.changed.connect(self._show_state)
        talking.changed.connect(self._show_state)
        self._show_state()

    def _step(self, step: int) -> None:
        self._comparison.go_to(self._comparison.place + step)

    def _show_state(self) -> None:
        comparison = self._comparison
        n, place = len(comparison.places), comparison.place
        self.setVisible(self._talking.comparing)
        self.summary.setText(comparison.words)
        self.summary.setToolTip(
            tr("Difference of the weights of all blend shapes, 0 to 1: the root mean square, and the greatest one")
        )
        self._open.setText(tr_count("{n} place", "{n} places", n) + " ▾")
        self._open.setEnabled(n > 0)
        self.previous.setEnabled(place > 0)
        self.next.setEnabled(place + 1 < n)

    def _fill_list(self) -> None:
        self.list.clear()
        for number, place in enumerate(self._comparison.places):
            shapes = ", ".join(f"{shape.name} {shape.greatest:.2f}" for shape in place.shapes)
            words = tr("{seconds:.2f} s: {shapes}").format(seconds=place.time, shapes=shapes)
            action = self.list.addAction(words, partial(self._comparison.go_to, number))
            action.setCheckable(True)
            action.setChecked(number == self._comparison.place)
