"""Which movestate of the face is on, and by how many percent, as bars."""

import math

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import Theme, set_size
from phonemeanalyser.desktop.widgets.plot import PlotMenu, table_of
from phonemeengine.mouth.blendshape_names import EYELIDS

ROW, COLUMNS, GAP = 16, 2, 14
NAME_SHARE, NUMBER_WIDTH = 0.5, 36
LEAST = 1.0
"""Percent by which a movestate that the table does not move has to be on to be listed."""
LEFT, RIGHT = "Left", "Right"


class MovestateBars(QWidget):
    """Paints a bar for each movestate that the table moves, or that has moved; the two sides of a face share one.

    Attributes
    ----------
    rows : for each bar its name, and its one or two movestates.
    menu : what a right click offers.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self._theme = theme
        self._shown: list[tuple[int, ...]] = []
        self._listed: tuple[str, ...] = ()
        self.rows: list[tuple[str, tuple[str, ...]]] = []
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setToolTip(
            tr(
                "Current weight of each blend shape of the face, in percent; of two sides in one row, the upper "
                "bar is the left one"
            )
        )
        self.menu = PlotMenu(self, "movestates", lambda _at: self._values())
        talking.changed.connect(self._list_states)
        self._list_states()

    def refresh(self) -> None:
        """Show how it is now."""
        percentages = self._talking.percentages
        others = [name for name, percent in percentages.items() if abs(percent) >= LEAST and name not in self._listed]
        if others:
            self._list(*self._listed, *others)
        shown = [tuple(round(percentages.get(name, 0.0)) for name in names) for _, names in self.rows]
        for k, row in enumerate(shown):
            if k >= len(self._shown) or row != self._shown[k]:
                self.update(self._box_of(k).toAlignedRect())
        self._shown = shown

    @override
    def sizeHint(self) -> QSize:
        return QSize(300, ROW * max(1, self._n_rows) + 2)

    @override
    def minimumSizeHint(self) -> QSize:
        return QSize(200, self.sizeHint().height())

    @override
    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        set_size(painter, 11)
        percentages = self._talking.percentages
        for k, (name, states) in enumerate(self.rows):
            box = self._box_of(k)
            if event.region().intersects(box.toAlignedRect()):
                self._paint_row(painter, box, name, [percentages.get(state, 0.0) for state in states])

    def _box_of(self, k: int) -> QRectF:
        """Return where a row lies."""
        width = (self.width() - GAP * (COLUMNS - 1)) / COLUMNS
        column, row = divmod(k, max(1, self._n_rows))
        return QRectF(column * (width + GAP), row * ROW, width, ROW)

    def _values(self) -> str:
        """Return how far each movestate is on, as a table."""
        percentages = self._talking.percentages
        return table_of({"movestate": list(percentages), "percent": list(percentages.values())})

    @property
    def _n_rows(self) -> int:
        return math.ceil(len(self.rows) / COLUMNS)

    def _paint_row(self, painter: QPainter, box: QRectF, name: str, percents: list[float]) -> None:
        theme, most = self._theme, max(percents, key=abs)
        words = box.adjusted(0, 0, -box.width() * (1 - NAME_SHARE) - 4, 0)
        number = QRectF(box.right() - NUMBER_WIDTH, box.top(), NUMBER_WIDTH, ROW)
        bar = QRectF(words.right() + 4, box.top() + 3, number.left() - words.right() - 6, ROW - 6)
        painter.fillRect(bar, QColor(theme.raised))
        for k, percent in enumerate(percents):
            height = bar.height() / len(percents)
            length = bar.width() * min(abs(percent), 100) / 100
            colour = theme.accent if percent >= 0 else theme.bad
            painter.fillRect(QRectF(bar.left(), bar.top() + k * height, length, height), QColor(colour))
        seen = abs(most) >= 0.5
        painter.setPen(QColor(theme.text if seen else theme.faint))
        shown = painter.fontMetrics().elidedText(name, Qt.TextElideMode.ElideMiddle, int(words.width()))
        painter.drawText(words, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, shown)
        if seen:
            painter.drawText(number, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, f"{most:.0f} %")

    def _list_states(self) -> None:
        face = self._talking.face
        mine = () if face.states is None else face.states.names
        moved = [*face.moved_by(self._talking.table)] if mine else []
        moved += [lid for lid in EYELIDS if lid in mine and lid not in moved]
        kept = [name for name in self._listed if name in mine and name not in moved]
        self._list(*moved, *kept)

    def _list(self, *names: str) -> None:
        self._listed, self.rows = names, _paired(list(names))
        self._shown = []
        self.updateGeometry()
        self.update()


def _paired(names: list[str]) -> list[tuple[str, tuple[str, ...]]]:
    """Put the two sides of a face into one row."""
    rows: dict[str, tuple[str, ...]] = {}
    for name in names:
        side = next((side for side in (LEFT, RIGHT) if name.endswith(side)), "")
        stem = name.removesuffix(side) if side else name
        both = (stem + LEFT, stem + RIGHT)
        if side and all(other in names for other in both):
            rows[stem] = both
        else:
            rows[name] = (name,)
    return list(rows.items())
