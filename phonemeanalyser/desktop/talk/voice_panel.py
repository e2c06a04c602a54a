"""The voice that says texts, chosen below a button: who speaks, how fast, and by what the mouth moves."""

from PySide6.QtCore import QPoint, QSignalBlocker, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QComboBox, QFormLayout, QFrame, QLabel, QLineEdit, QToolButton, QWidget

from phonemeanalyser.desktop.talk.voice_model import FASTEST, SLOWEST, TextDriver, VoiceModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.number_field import NumberField
from phonemeengine.speech.program import OUTPUT, TEXT

WIDTH = 420
OWN_VOICE, OWN_PROGRAM = "the language’s own", "a program of your own"
KINDS = {"m": "man", "f": "woman"}
"""What the voices are that are a letter and a number."""
DRIVERS = {
    TextDriver.AUTO: "automatic: pinyin for Chinese",
    TextDriver.PINYIN: "letters of pinyin",
    TextDriver.RULES: "sounds, by the mouth table",
}
MEANING = (
    f"{OUTPUT} is the WAV file that it shall write, {TEXT} the text; without {TEXT}, the program reads the text from "
    "its standard input. A TextGrid that it writes beside the sound tells the times."
)
EXAMPLE = f"my-voice --file {OUTPUT} {TEXT}"


class VoicePanel(QFrame):
    """Pops up below a button; Escape or a click elsewhere closes it."""

    def __init__(self, voice: VoiceModel, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self._voice = voice
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAccessibleName("voice")
        self.name, self.driver = QComboBox(), QComboBox()
        self.rate, self.program = NumberField(), QLineEdit()
        self._hint = QLabel(MEANING)
        self._hint.setWordWrap(True)
        self._hint.setStyleSheet(f"color: {theme.faint}")
        self._describe()
        self._lay_out()
        self._connect()
        self.show_state()

    def show_below(self, button: QWidget) -> None:
        """Show it below a button, or above where the screen ends."""
        self.adjustSize()
        place = button.mapToGlobal(QPoint(0, button.height()))
        screen = button.screen().availableGeometry()
        if place.y() + self.height() > screen.bottom():
            place.setY(button.mapToGlobal(QPoint(0, 0)).y() - self.height())
        place.setX(max(screen.left(), min(place.x(), screen.right() - self.width())))
        self.move(place)
        self.show()
        self.name.setFocus()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Close it by Escape."""
        if event.key() == Qt.Key.Key_Escape:
            self.close()
        else:
            super().keyPressEvent(event)

    def show_state(self) -> None:
        """Show what is chosen."""
        choice = self._voice.choice
        blockers = [QSignalBlocker(field) for field in (self.rate, self.program)]
        self._list_voices()
        own = self.name.count() - 1
        self.name.setCurrentIndex(own if choice.by_program else max(0, self.name.findData(choice.name)))
        self.driver.setCurrentIndex(self.driver.findData(choice.driver))
        self.rate.setValue(choice.rate)
        self.rate.setEnabled(not choice.by_program)
        if self.program.text() != choice.program:
            self.program.setText(choice.program)
        for widget in (self.program, self._hint):
            self._rows.setRowVisible(widget, choice.by_program)
        del blockers

    def _describe(self) -> None:
        self.name.setAccessibleName("voice")
        self.name.setToolTip("Who says the text: a voice of espeak-ng, or a text-to-speech program of your own")
        self.rate.setAccessibleName("rate")
        self.rate.setToolTip("How fast a voice of espeak-ng speaks: people say four to five syllables a second")
        self.rate.setDecimals(1)
        self.rate.setRange(SLOWEST, FASTEST)
        self.rate.setSingleStep(0.1)
        self.rate.setSuffix(" syllables/s")
        self.rate.setKeyboardTracking(False)
        self.driver.setAccessibleName("what moves the mouth")
        self.driver.setToolTip("By what the mouth moves where the words are known, of a voice or of a recording")
        for driver, words in DRIVERS.items():
            self.driver.addItem(words, driver)
        self.program.setAccessibleName("command")
        self.program.setToolTip(f"The command that speaks, such as: {EXAMPLE}")
        self.program.setPlaceholderText(EXAMPLE)

    def _lay_out(self) -> None:
        self._rows = QFormLayout(self)
        self._rows.setContentsMargins(10, 10, 10, 10)
        for words, widget in (
            ("Voice", self.name), ("Rate", self.rate), ("Command", self.program), ("", self._hint),
            ("Mouth by", self.driver),
        ):  # fmt: skip
            self._rows.addRow(words, widget)
        self.setFixedWidth(WIDTH)

    def _connect(self) -> None:
        voice = self._voice
        self.name.activated.connect(self._choose_voice)
        self.rate.valueChanged.connect(lambda rate: voice.choose(rate=rate))
        self.program.editingFinished.connect(lambda: voice.choose(program=self.program.text().strip()))
        self.driver.activated.connect(lambda k: voice.choose(driver=TextDriver(self.driver.itemData(k))))
        voice.changed.connect(self.show_state)

    def _choose_voice(self, place: int) -> None:
        if place == self.name.count() - 1:
            self._voice.choose(by_program=True)
            self.program.setFocus()
        else:
            self._voice.choose(name=self.name.itemData(place), by_program=False)
        self.adjustSize()

    def _list_voices(self) -> None:
        """List the voices, once they are known: those of men and women first."""
        names = sorted(self._voice.installed.voices, key=lambda name: (not _kind_of(name), name.lower()))
        if self.name.count() != len(names) + 2:
            self.name.clear()
            self.name.addItem(OWN_VOICE, "")
            for name in names:
                kind = _kind_of(name)
                self.name.addItem(f"{name} ({kind})" if kind else name, name)
            self.name.addItem(OWN_PROGRAM, None)


class VoiceButton(QToolButton):
    """Says who speaks, and opens the panel.

    Attributes
    ----------
    panel : what it opens.
    """

    def __init__(self, voice: VoiceModel, theme: Theme) -> None:
        super().__init__()
        self._voice = voice
        self.panel = VoicePanel(voice, theme, self)
        self.setText("Voice…")
        self.setAccessibleName("voice, rate and mouth of a spoken text")
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.clicked.connect(lambda _checked: self.panel.show_below(self))
        voice.changed.connect(self._show_state)
        self._show_state()

    def _show_state(self) -> None:
        choice = self._voice.choice
        who = OWN_PROGRAM if choice.by_program else f"{choice.name or OWN_VOICE}, {choice.rate:g} syllables a second"
        self.setToolTip(f"Who says the text, how fast, and what moves the mouth (now: {who})")


def _kind_of(name: str) -> str:
    """Return what kind of voice a letter and a number are; nothing for other names."""
    return KINDS.get(name[0], "") if name[1:].isdecimal() else ""
