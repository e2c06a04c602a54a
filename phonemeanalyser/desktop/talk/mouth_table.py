"""The mouth table: whose face it is, how it moves and how fast, and a key and a slider for each mouth shape."""

from collections.abc import Mapping
from functools import partial
from pathlib import Path

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QCheckBox, QComboBox, QSizePolicy, QToolButton, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.head.face_model import HEADS
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme, set_size
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.fields import NumberField, PercentSlider
from phonemeanalyser.desktop.widgets.keyboard import KEYS
from phonemeanalyser.desktop.widgets.lanes import names_in_lanes
from phonemeengine.mouth.files.io import FaceFiles
from phonemeengine.mouth.morph_mesh import Head
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.movestate import Mode
from phonemeengine.mouth.table import SPEAKING, TABLES, MouthTable
from phonemeengine.phonemes import Phoneme

ROW, NAMES_WIDTH, LINE = 15, 46, 2
HEAD_TIPS = {
    Head.WOMAN: tr_noop("Show the woman's head that ships with the program"),
    Head.MAN: tr_noop("Show the man's head that ships with the program"),
}
MEANING = tr_noop(
    "Attack: time in which the mouth covers 90 % of the way to the shape of a phoneme. Release: time in which "
    "it covers 90 % of the way back when silence follows. To change them, copy a mouth table from {tables}, "
    "edit its section [times], and load it."
)


class TransitionTimesView(QWidget):
    """Paints a column for each phoneme: its attack and its release, as they are in force."""

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self._theme = theme
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(tr("Attack and release of each phoneme"))
        talking.changed.connect(self._show_times)
        self._show_times()

    @override
    def sizeHint(self) -> QSize:
        return QSize(300, 3 * ROW + LINE)

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        set_size(painter, 11)
        width = (self.width() - NAMES_WIDTH) / len(SPEAKING)
        for k, text in enumerate(("ms", tr("Attack"), tr("Release"))):
            self._write(painter, k, 0, NAMES_WIDTH, text, self._theme.faint)
        for k, phoneme in enumerate(SPEAKING):
            left = NAMES_WIDTH + k * width
            painter.fillRect(QRectF(left + 1, ROW - LINE, width - 2, LINE), QColor(PHONEME_COLOURS[phoneme]))
            for at, text in enumerate((names_in_lanes()[phoneme], *self.milliseconds(phoneme))):
                self._write(painter, at, left, width, text, self._theme.text)

    def milliseconds(self, phoneme: Phoneme) -> tuple[str, str]:
        """Return the attack and the release of a phoneme as they are painted."""
        times = self._talking.table.times[phoneme]
        return f"{1000 * times.attack:.0f}", f"{1000 * times.release:.0f}"

    def _write(self, painter: QPainter, row: int, left: float, width: float, text: str, colour: str) -> None:
        box = QRectF(left, row * ROW + LINE * (row > 0), width, ROW)
        side = Qt.AlignmentFlag.AlignHCenter if left else Qt.AlignmentFlag.AlignLeft
        painter.setPen(QColor(colour))
        shown = painter.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, int(width))
        painter.drawText(box, side | Qt.AlignmentFlag.AlignVCenter, shown)

    def _show_times(self) -> None:
        words = tr("{phoneme}: attack {attack} ms, release {release} ms")
        rows = []
        for phoneme in SPEAKING:
            attack, release = self.milliseconds(phoneme)
            rows.append(words.format(phoneme=sound_name(phoneme), attack=attack, release=release))
        meaning = tr(MEANING).format(tables=TABLES)
        self.setToolTip(f"<p>{meaning}</p>" + "<br>".join(rows))
        self.update()


DETAILS = {
    Detail.PHONEMES: tr_noop("All phonemes"),
    Detail.LOUDNESS: tr_noop("Loudness only"),
    Detail.TWO_STATES: tr_noop("Open and closed"),
}
TABLE_TIP = tr_noop("Table of the mouth shape of each phoneme, and of the blend shapes that form it")
DETAIL_TIP = tr_noop("How closely the mouth follows the speech; distant faces need less detail")
BLINKS_TIP = tr_noop("Blink at natural intervals")
MOTION_TIP = tr_noop("Move the head with the pitch and loudness of the speech")
OWN = tr_noop("Load mouth table…")
FASTEST_PERCENT, SLOWEST_PERCENT, STEP_PERCENT = 10, 1000, 10

WIDE = builders.ElidedLabel | QComboBox | TransitionTimesView
"""What takes the width that is left."""


class ChoicesPanel(QWidget):
    """Chooses face, table, detail, speed, and what the face does besides.

    Signals
    -------
    mesh_asked : the user wants a mesh of his own.
    table_asked : the user wants a table of his own.
    mapping_asked : the user wants to say which shapes of the face stand for which of ours.
    """

    mesh_asked = Signal()
    table_asked = Signal()
    mapping_asked = Signal()

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self._theme = theme
        self.face = builders.ElidedLabel()
        self.own = builders.tool_button(
            tr("Load Face…"),
            tr("Load a face mesh (.obj, .glb, .vrm, .gltf, .x) with its blend shapes (.3dm)"),
            act=self.mesh_asked.emit,
        )
        self.heads = {
            head: builders.tool_button(
                tr(name), tr(HEAD_TIPS[head]), act=partial(talking.face.load, FaceFiles(Path(head)))
            )
            for head, name in HEADS.items()
        }
        self.map = builders.tool_button(
            tr("Map Shapes…"),
            tr("Map the blend shapes of this face to those of the mouth table"),
            act=self.mapping_asked.emit,
        )
        self.table = builders.choice((), tr("Mouth table"), tr(TABLE_TIP))
        self.detail = builders.choice(
            ((tr(words), detail) for detail, words in DETAILS.items()), tr("Level of detail"), tr(DETAIL_TIP)
        )
        self.attack = _time_factor(
            tr("Attack time"),
            tr("Length of all attacks: 100 % as in the mouth table; less is faster, more is slower"),
        )
        self.release = _time_factor(
            tr("Release time"),
            tr("Length of all releases: 100 % as in the mouth table; less is faster, more is slower"),
        )
        self.times = TransitionTimesView(talking, theme)
        self.blinks = builders.named(QCheckBox(tr("Blinks")), tip=tr(BLINKS_TIP))
        self.motion = builders.named(QCheckBox(tr("Head motion")), tip=tr(MOTION_TIP))
        self.random = builders.named(
            QCheckBox(tr("Random variation")), tip=tr("Vary mouth shapes and times slightly, as people do")
        )
        self._lay_out()
        self._connect()
        self._show_state()

    def _lay_out(self) -> None:
        table = builders.grid(self, across=8, down=5)
        rows: tuple[tuple[str, tuple[QWidget, ...]], ...] = (
            (tr("Face"), (self.face, *self.heads.values(), self.own)),
            ("", (self.map,)),
            (tr("Mouth table"), (self.table, builders.label(tr("Detail")), self.detail)),
            (
                tr("Speed"),
                (builders.label(tr("Attack time")), self.attack, builders.label(tr("Release time")), self.release),
            ),
            ("", (self.times,)),
            (tr("Idle motion"), (self.blinks, self.motion, self.random)),
        )
        for number, (name, widgets) in enumerate(rows):
            table.addWidget(builders.label(name, self._theme.faint), number, 0)
            wide = [isinstance(widget, WIDE) for widget in widgets]
            parts = zip(widgets, map(int, wide), strict=True)
            table.addLayout(builders.row(*parts, *([] if any(wide) else [1]), spacing=8), number, 1)
        table.setColumnStretch(1, 1)

    def _connect(self) -> None:
        talking = self._talking
        self.table.activated.connect(self._choose_table)
        self.detail.activated.connect(lambda k: talking.set_detail(self.detail.itemData(k)))
        for box in (self.attack, self.release):
            box.valueChanged.connect(self._choose_speed)
        self.blinks.toggled.connect(talking.set_blinks)
        self.motion.toggled.connect(talking.set_head_motion)
        self.random.toggled.connect(talking.set_random)
        talking.changed.connect(self._show_state)

    def _choose_table(self, place: int) -> None:
        name = self.table.itemData(place)
        if name is None:
            self.table_asked.emit()
            self._show_state()
        else:
            self._talking.set_table(name)

    def _choose_speed(self, _value: float) -> None:
        self._talking.set_speed(self.attack.value() / 100, self.release.value() / 100)

    def _show_state(self) -> None:
        talking = self._talking
        with builders.silent(self.attack, self.release, self.blinks, self.motion, self.random):
            self.face.setText(talking.face.name)
            self.face.setToolTip(talking.face.name)
            for head, button in self.heads.items():
                button.setEnabled(talking.face.head is not head)
            self._list_tables()
            self.detail.setCurrentIndex(self.detail.findData(talking.idle.detail))
            self.attack.setValue(round(100 * talking.attack_factor))
            self.release.setValue(round(100 * talking.release_factor))
            self.blinks.setChecked(talking.idle.blinks)
            self.motion.setChecked(talking.idle.head)
            self.random.setChecked(talking.random)

    def _list_tables(self) -> None:
        """List the tables of the program that move this face, the user's own, and the way to another one."""
        talking = self._talking
        listed = talking.face.tables | {talking.table_name: talking.table.name}
        builders.offer(
            self.table, [*((tr(words), name) for name, words in listed.items()), (tr(OWN), None)], talking.table_name
        )


def _time_factor(name: str, tip: str) -> NumberField:
    return builders.named(
        NumberField(FASTEST_PERCENT, SLOWEST_PERCENT, step=STEP_PERCENT, unit=" %", waits=True), name, tip
    )


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
