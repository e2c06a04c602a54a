"""A key and a slider for each mouth shape, and what becomes of everything else when one is asked for."""

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QSlider, QToolButton, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.painting import set_size
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import (
    choice,
    column,
    fill_columns,
    grid,
    heading,
    label,
    row,
    silent,
    slider_of_percent,
    tool_button,
)
from phonemeanalyser.desktop.widgets.phoneme_keys import KEYS
from phonemeengine.mouth.movestate import Mode
from phonemeengine.mouth.table import MouthTable

MODES = {
    Mode.NONE: tr_noop("others stay"),
    Mode.RESET: tr_noop("others to 0"),
    Mode.FORCE_RESET: tr_noop("others and blinks to 0"),
    Mode.INTERACT: tr_noop("others share 100 %"),
}
PERCENT_WIDTH = 40


class VisemeButton(QToolButton):
    """Shows a mouth shape and its keys; held down, the mouth takes that shape."""

    def __init__(self, shape: str, keys: str, theme: Theme) -> None:
        super().__init__()
        self.shape = shape
        self._keys = keys
        self._theme = theme
        self.setFixedHeight(22)
        self.setMinimumWidth(122)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(tr("hold the mouth shape {shape}").format(shape=shape))
        held = tr("Hold this to see the mouth shape {shape}, whatever is said")
        by_key = tr("Hold this, or the key {keys}, to see the mouth shape {shape}, whatever is said")
        self.setToolTip((by_key if keys else held).format(keys=tr(" or ").join(keys), shape=shape))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint the shape's name at the left, and its keys at the right."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        box, down = self.rect().adjusted(1, 1, -1, -1), self.isDown()
        painter.setPen(QColor(self._theme.accent if self.hasFocus() or self.underMouse() else self._theme.line))
        painter.setBrush(QColor(self._theme.accent if down else self._theme.raised))
        painter.drawRoundedRect(box, 3, 3)
        inner = box.adjusted(6, 0, -6, 0)
        painter.setPen(QColor(self._theme.on_colour if down else self._theme.text))
        painter.drawText(inner, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, self.shape)
        set_size(painter, 10)
        painter.setPen(QColor(self._theme.on_colour if down else self._theme.faint))
        painter.drawText(inner, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, self._keys)


class VisemePanel(QWidget):
    """Lists the shapes of the table in use.

    Attributes
    ----------
    buttons, sliders : by the name of the shape.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self._theme = theme
        self._table: MouthTable | None = None
        self.buttons: dict[str, VisemeButton] = {}
        self.sliders: dict[str, QSlider] = {}
        self._percents: dict[str, QLabel] = {}
        self.mode = choice(
            ((tr(words), mode.value) for mode, words in MODES.items()),
            tr("what becomes of everything else when a slider is pulled"),
            tr(
                "What becomes of the speech, of the other shapes and of blinks when a slider asks for a shape: all "
                "stay, and movements add up; all but blinks go to 0; blinks as well; or first the speech and then "
                "other shapes shrink, so that all are 100 % at most. Keys and buttons set all but blinks to 0 while "
                "they are held"
            ),
        )
        self.leave = tool_button(
            tr("Leave It to the Speech"), tr("Set all sliders back to 0"), act=talking.clear_visemes
        )
        self._body = QWidget()
        head = row((heading(tr("Mouth shapes")), 1), self.mode, self.leave)
        self._column = column(head, self._body, on=self, spacing=4)
        talking.changed.connect(self._take_table)
        self.mode.activated.connect(lambda k: talking.set_mode(Mode(self.mode.itemData(k))))
        talking.visemes_changed.connect(self._show_shares)
        self._take_table()

    def _take_table(self) -> None:
        """List the shapes, where they are others."""
        table = self._talking.table
        self.mode.setCurrentIndex(self.mode.findData(self._talking.mode.value))
        if self._table is None or self._table.shapes is not table.shapes:
            body = QWidget()
            self._column.replaceWidget(self._body, body)
            self._body.deleteLater()
            self._body = body
            self._fill(body, table)
        self._table = table
        self._show_shares()

    def _fill(self, body: QWidget, table: MouthTable) -> None:
        self.buttons, self.sliders, self._percents = {}, {}, {}
        keys = keys_of(table)
        rows = [self._row_of(shape, keys.get(shape, "")) for shape in table.shapes]
        fill_columns(grid(body, across=5, down=3), rows)

    def _row_of(self, shape: str, keys: str) -> tuple[QWidget, QWidget, QWidget]:
        talking = self._talking
        button = self.buttons[shape] = VisemeButton(shape, keys, self._theme)
        button.pressed.connect(lambda: talking.hold(shape))
        button.released.connect(talking.release)
        tip = tr("How far the mouth takes the shape {shape}; with all at 0 it is left to the speech")
        name = tr("share of the mouth shape {shape}")
        slider = self.sliders[shape] = slider_of_percent(name.format(shape=shape), tip.format(shape=shape))
        slider.valueChanged.connect(lambda value: talking.set_viseme(shape, value / 100))
        self._percents[shape] = label(width=PERCENT_WIDTH)
        return button, slider, self._percents[shape]

    def _show_shares(self) -> None:
        visemes = self._talking.visemes
        if visemes.shares.keys() != self.sliders.keys():
            return  # the table is about to be listed
        for shape, share in visemes.shares.items():
            with silent(self.sliders[shape]):
                self.sliders[shape].setValue(round(100 * share))
            self.buttons[shape].setDown(shape == visemes.held)
            self._percents[shape].setText(f"{100 * share:.0f} %" if share else "")
        self.leave.setEnabled(any(visemes.shares.values()))


def keys_of(table: MouthTable) -> Mapping[str, str]:
    """Return the letters of the phonemes for which a table has each shape."""
    keys: dict[str, str] = {}
    for phoneme, key in KEYS.items():
        shape = table.phonemes[phoneme]
        keys[shape] = keys.get(shape, "") + key
    return keys
