"""The bar below two heads: by how much they differ, and the places where they do most."""

from functools import partial

from PySide6.QtWidgets import QMenu, QWidget

from phonemeanalyser.desktop.language import tr, tr_count
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.widgets.builders import open_without_arrow, row, spoken_button
from phonemeanalyser.desktop.widgets.labels import ElidedLabel


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
