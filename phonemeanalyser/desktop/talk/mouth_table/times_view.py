"""How fast the mouth is for which sound."""

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.painting import set_size
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
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
        for row, text in enumerate(("ms", tr("attack"), tr("release"))):
            self._write(painter, row, 0, NAMES_WIDTH, text, self._theme.faint)
        for k, phoneme in enumerate(SPEAKING):
            left = NAMES_WIDTH + k * width
            painter.fillRect(QRectF(left + 1, ROW - LINE, width - 2, LINE), QColor(PHONEME_COLOURS[phoneme]))
            for row, text in enumerate((phoneme.label, *self.milliseconds(phoneme))):
                self._write(painter, row, left, width, text, self._theme.text)

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
