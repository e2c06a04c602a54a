"""Whose face it is, how it moves, and how fast the mouth is for which sound."""

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QCheckBox, QComboBox, QSizePolicy, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.painting import set_size
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.builders import choice, grid, label, named, offer, row, silent, tool_button
from phonemeanalyser.desktop.widgets.labels import ElidedLabel
from phonemeanalyser.desktop.widgets.number_field import NumberField
from phonemeengine.mouth.files.io import FaceFiles
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.table import SPEAKING, TABLES
from phonemeengine.phonemes import Phoneme

ROW, NAMES_WIDTH, LINE = 15, 46, 2
MEANING = tr_noop(
    "Attack: until the mouth has gone nine tenths of the way to the sound’s shape. Release: nine tenths of the way "
    "back, when silence follows. They stand under [times] in the table: copy one from {tables}, change it, and "
    "choose it as your own table."
)


class TransitionTimesView(QWidget):
    """Paints a column for each phoneme: its attack and its release, as they are in force."""

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self._theme = theme
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(tr("attack and release of each sound"))
        talking.changed.connect(self._show_times)
        self._show_times()

    def sizeHint(self) -> QSize:
        """Ask for three rows."""
        return QSize(300, 3 * ROW + LINE)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint names, attacks and releases."""
        painter = QPainter(self)
        set_size(painter, 11)
        width = (self.width() - NAMES_WIDTH) / len(SPEAKING)
        for k, text in enumerate(("ms", tr("attack"), tr("release"))):
            self._write(painter, k, 0, NAMES_WIDTH, text, self._theme.faint)
        for k, phoneme in enumerate(SPEAKING):
            left = NAMES_WIDTH + k * width
            painter.fillRect(QRectF(left + 1, ROW - LINE, width - 2, LINE), QColor(PHONEME_COLOURS[phoneme]))
            for at, text in enumerate((phoneme.label, *self.milliseconds(phoneme))):
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
        rows = [f"{phoneme.label}: {tr(' and ').join(self.milliseconds(phoneme))} ms" for phoneme in SPEAKING]
        meaning = tr(MEANING).format(tables=TABLES)
        self.setToolTip(f"<p>{meaning}</p>" + "<br>".join(rows))
        self.update()


DETAILS = {
    Detail.PHONEMES: tr_noop("all phonemes"),
    Detail.LOUDNESS: tr_noop("loudness only"),
    Detail.TWO_STATES: tr_noop("open and shut"),
}
OWN = tr_noop("own table …")
FASTEST_PERCENT, SLOWEST_PERCENT, STEP_PERCENT = 10, 1000, 10

WIDE = ElidedLabel | QComboBox | TransitionTimesView
"""What takes the width that is left."""


class ChoicesPanel(QWidget):
    """Chooses face, table, detail, speed, and what the face does besides.

    Signals
    -------
    mesh_asked : the user wants a mesh of his own.
    table_asked : the user wants a table of his own.
    """

    mesh_asked = Signal()
    table_asked = Signal()

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._talking = talking
        self._theme = theme
        self.face = ElidedLabel()
        self.own = tool_button(
            tr("Own Mesh…"), tr("Show a mesh of your own (.obj, .glb, .gltf, .x), with its movestates (.3dm)")
        )
        self.shipped = tool_button(tr("Program’s Own"), tr("Show the head that ships with the program"))
        self.table = choice(
            (), tr("mouth table"), tr("Which mouth shape each phoneme has, and which movestates make it")
        )
        self.detail = choice(
            ((tr(words), detail) for detail, words in DETAILS.items()),
            tr("level of detail"),
            tr("How much of the speech the mouth follows: faces that are far away need less"),
        )
        self.attack, self.release = _time_factor(tr("attack")), _time_factor(tr("release"))
        self.times = TransitionTimesView(talking, theme)
        self.blinks = named(QCheckBox(tr("blinks")), tip=tr("The eyes blink at human intervals"))
        self.motion = named(
            QCheckBox(tr("head motion")), tip=tr("The head moves with pitch and loudness of the voice")
        )
        self.random = named(
            QCheckBox(tr("randomness")), tip=tr("Shapes and times vary a little, as they do in people")
        )
        self._lay_out()
        self._connect()
        self._show_state()

    def _lay_out(self) -> None:
        table = grid(self, across=8, down=5)
        rows: tuple[tuple[str, tuple[QWidget, ...]], ...] = (
            (tr("Face"), (self.face, self.own, self.shipped)),
            (tr("Table"), (self.table, label(tr("detail")), self.detail)),
            (
                tr("Times"),
                (label(tr("attack")), self.attack, label(tr("release")), self.release, label(tr("of the table’s"))),
            ),
            ("", (self.times,)),
            (tr("Life"), (self.blinks, self.motion, self.random)),
        )
        for number, (name, widgets) in enumerate(rows):
            table.addWidget(label(name, self._theme.faint), number, 0)
            wide = [isinstance(widget, WIDE) for widget in widgets]
            parts = zip(widgets, map(int, wide), strict=True)
            table.addLayout(row(*parts, *([] if any(wide) else [1]), spacing=8), number, 1)
        table.setColumnStretch(1, 1)

    def _connect(self) -> None:
        talking = self._talking
        self.own.clicked.connect(lambda _checked: self.mesh_asked.emit())
        self.shipped.clicked.connect(lambda _checked: talking.face.load(FaceFiles()))
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
        with silent(self.attack, self.release, self.blinks, self.motion, self.random):
            self.face.setText(talking.face.name)
            self.face.setToolTip(talking.face.name)
            self.shipped.setEnabled(not talking.face.is_shipped)
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
        offer(
            self.table, [*((tr(words), name) for name, words in listed.items()), (tr(OWN), None)], talking.table_name
        )


def _time_factor(what: str) -> NumberField:
    tip = tr("How long every {what} is: 100 % as the table has it, less is faster, more is slower").format(what=what)
    field = NumberField(FASTEST_PERCENT, SLOWEST_PERCENT, step=STEP_PERCENT, unit=" %", waits=True)
    return named(field, tr("how long every {what} is").format(what=what), tip)
