"""A key and a slider for each mouth shape, and what becomes of everything else when one is asked for."""

from collections.abc import Mapping
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QToolButton, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import Theme, set_size
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.fields import PercentSlider
from phonemeanalyser.desktop.widgets.keyboard import KEYS
from phonemeengine.mouth.movestate import Mode
from phonemeengine.mouth.table import MouthTable

MODES = {
    Mode.NONE: tr_noop("Keep others"),
    Mode.RESET: tr_noop("Set others to 0"),
    Mode.FORCE_RESET: tr_noop("Set others and blinks to 0"),
    Mode.INTERACT: tr_noop("Normalise to 100 %"),
}


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
        shown = sound_name(shape)
        self.setAccessibleName(tr("Hold the mouth shape {shape}").format(shape=shown))
        held = tr("Hold to show the mouth shape {shape} instead of the speech")
        by_key = tr("Hold to show the mouth shape {shape} instead of the speech (keys: {keys})")
        self.setToolTip((by_key if keys else held).format(keys=", ".join(keys), shape=shown))

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        box, down = self.rect().adjusted(1, 1, -1, -1), self.isDown()
        painter.setPen(QColor(self._theme.accent if self.hasFocus() or self.underMouse() else self._theme.line))
        painter.setBrush(QColor(self._theme.accent if down else self._theme.raised))
        painter.drawRoundedRect(box, 3, 3)
        inner = box.adjusted(6, 0, -6, 0)
        painter.setPen(QColor(self._theme.on_colour if down else self._theme.text))
        painter.drawText(inner, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, sound_name(self.shape))
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
        self.sliders: dict[str, PercentSlider] = {}
        self.mode = builders.choice(
            ((tr(words), mode.value) for mode, words in MODES.items()),
            tr("Effect of a slider on everything else"),
            tr(
                "What happens to the speech, the other mouth shapes and blinks while a slider is above 0: they "
                "stay, and all movements add up; all but blinks go to 0; blinks go to 0, too; or first the "
                "speech, then the other shapes are reduced until the sum is 100 % at most. Keys and buttons set "
                "everything but blinks to 0 while they are held"
            ),
        )
        self.leave = builders.tool_button(
            tr("Reset to Speech"), tr("Set all sliders to 0"), act=talking.clear_visemes
        )
        self._body = QWidget()
        head = builders.row((builders.heading(tr("Mouth shapes")), 1), self.mode, self.leave)
        self._column = builders.column(head, self._body, on=self, spacing=4)
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
        self.buttons, self.sliders = {}, {}
        keys = keys_of(table)
        rows = [self._row_of(shape, keys.get(shape, "")) for shape in table.shapes]
        builders.fill_rows(builders.grid(body, across=8, down=3), rows)

    def _row_of(self, shape: str, keys: str) -> tuple[QWidget, QWidget, QWidget]:
        talking = self._talking
        button = self.buttons[shape] = VisemeButton(shape, keys, self._theme)
        button.pressed.connect(lambda: talking.hold(shape))
        button.released.connect(talking.release)
        shown = sound_name(shape)
        tip = tr("Weight of the mouth shape {shape}; with all weights at 0, speech alone moves the mouth")
        name = tr("Weight of the mouth shape {shape}")
        act = partial(talking.set_viseme, shape)
        slider = self.sliders[shape] = PercentSlider(name.format(shape=shown), tip.format(shape=shown), act)
        return button, slider, slider.percent

    def _show_shares(self) -> None:
        visemes = self._talking.visemes
        if visemes.shares.keys() != self.sliders.keys():
            return  # the table is about to be listed
        for shape, share in visemes.shares.items():
            self.sliders[shape].show_share(share)
            self.buttons[shape].setDown(shape == visemes.held)
        self.leave.setEnabled(any(visemes.shares.values()))


def keys_of(table: MouthTable) -> Mapping[str, str]:
    """Return the letters of the phonemes for which a table has each shape."""
    keys: dict[str, str] = {}
    for phoneme, key in KEYS.items():
        shape = table.phonemes[phoneme]
        keys[shape] = keys.get(shape, "") + key
    return keys
