"""A button for each phoneme: held down, it records a take."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QKeySequence, QPainter, QPaintEvent, QShortcut
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QToolButton, QWidget

from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.painting import CENTRED, draw_text, format_clock, letters_on
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.builders import column, row, spoken_button
from phonemeanalyser.desktop.widgets.phoneme_keys import KEYS
from phonemeengine.phonemes import Phoneme

COLUMNS = 5


class PhonemeButton(QToolButton):
    """Shows a phoneme, its colour and its key."""

    def __init__(self, phoneme: Phoneme, theme: Theme) -> None:
        super().__init__()
        self.phoneme = phoneme
        self.n_takes = 0
        self._theme = theme
        self.setMinimumSize(52, 40)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        name = phoneme.label
        self.setAccessibleName(tr("record a take of {name}").format(name=name))
        self.setToolTip(
            tr(
                "Hold the button, or the key {key}, while you say {name}; or while it is heard in the file that plays"
            ).format(key=KEYS[phoneme], name=name)
        )

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint the phoneme on its colour, its key in the corner, and how many takes there are."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        colour = QColor(PHONEME_COLOURS[self.phoneme])
        box = self.rect().adjusted(1, 1, -1, -1)
        painter.setPen(QColor(self._theme.accent if self.hasFocus() or self.underMouse() else self._theme.line))
        down = self.isDown()
        painter.setBrush(colour if down else QColor(self._theme.raised))
        painter.drawRoundedRect(box, 4, 4)
        painter.fillRect(box.left() + 4, box.bottom() - 4, box.width() - 8, 3, colour)
        text = QColor(letters_on(PHONEME_COLOURS[self.phoneme]) if down else self._theme.text)
        name = self.phoneme.label
        inner = self.rect().adjusted(5, 2, -5, -3)
        draw_text(painter, inner.adjusted(-5, 0, 5, 0), name, text, 15 if len(name) < 4 else 12, CENTRED)
        faint = text if down else QColor(self._theme.faint)
        draw_text(painter, inner, KEYS[self.phoneme], faint, 10, Qt.AlignmentFlag.AlignLeft)
        if self.n_takes:
            draw_text(painter, inner, f"×{self.n_takes}", faint, 10, Qt.AlignmentFlag.AlignRight)


class RecordPanel(QWidget):
    """Records takes, of the microphone or of the file that plays, and marks stretches of it."""

    def __init__(self, calibration: CalibrationModel, theme: Theme) -> None:
        super().__init__()
        self._calibration = calibration
        self._theme = theme
        self.buttons = {phoneme: PhonemeButton(phoneme, theme) for phoneme in KEYS}
        self.hint = QLabel()
        self.start = spoken_button("[", tr("The marked stretch of the file begins where the file stands ([)"))
        self.end = spoken_button("]", tr("The marked stretch of the file ends where the file stands (])"))
        self._lay_out()
        self._connect()
        self._show_takes()
        self.show_state()

    def show_state(self) -> None:
        """Show what holding a button does now."""
        session, selection = self._calibration.session, self._calibration.selection
        held = self._calibration.phoneme
        of_file = session.source.path is not None
        if held is not None:
            text = tr("<b>Taking {phoneme}</b>: let go when it is said").format(phoneme=held.label)
        elif of_file and selection is not None and not session.source.playing:
            start, end = (format_clock(seconds, True) for seconds in selection)
            text = tr("Marked <b>{start} – {end} s</b>: choose its sound").format(start=start, end=end)
        elif of_file and session.source.playing:
            text = tr("Hold a key while its sound is heard")
        else:
            text = tr("Hold a key, or a button, and say the sound")
        self.hint.setText(text)
        for button in (self.start, self.end):
            button.setEnabled(of_file)
        for phoneme, button in self.buttons.items():
            if button.isDown() != (phoneme is held):
                button.setDown(phoneme is held)

    def _lay_out(self) -> None:
        for button in (self.start, self.end):
            button.setFixedWidth(24)
        buttons = QGridLayout()
        buttons.setSpacing(4)
        for k, button in enumerate(self.buttons.values()):
            buttons.addWidget(button, k // COLUMNS, k % COLUMNS)
        column(row((self.hint, 1), self.start, self.end), buttons, on=self, spacing=3)

    def _connect(self) -> None:
        calibration = self._calibration
        for phoneme, button in self.buttons.items():
            button.pressed.connect(lambda phoneme=phoneme: calibration.press(phoneme))
            button.released.connect(calibration.release)
        for sign, end in ((self.start, False), (self.end, True)):
            sign.clicked.connect(lambda _checked=False, end=end: calibration.mark(end=end))
            key = QShortcut(QKeySequence(sign.text()), self)  # a button's own would wait to be seen pressed
            key.activated.connect(lambda end=end: calibration.mark(end=end))
        calibration.held.connect(self.show_state)
        calibration.selection_changed.connect(self.show_state)
        calibration.session.transport_changed.connect(self.show_state)
        calibration.session.opened.connect(self.show_state)
        calibration.takes.changed.connect(self._show_takes)

    def _show_takes(self) -> None:
        takes = self._calibration.takes.now.takes
        for phoneme, button in self.buttons.items():
            button.n_takes = sum(take.phoneme is phoneme and not take.excluded for take in takes)
            button.update()
