"""The voice that says texts, and what moves the mouth meanwhile, chosen below a button."""

from pathlib import Path

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QComboBox, QFormLayout, QFrame, QLineEdit, QToolButton, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.drivers.driver_model import DriverModel
from phonemeanalyser.desktop.talk.words.voice_model import FASTEST, SLOWEST, VoiceModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import choice, label, named, offer, silent
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeengine.mouth.animation import NEEDS_FILE, FaceDriver
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.table_file import TableAbout
from phonemeengine.speech.program import OUTPUT, TEXT

WIDTH = 480
OWN_VOICE, OWN_PROGRAM = tr_noop("Default voice of the language"), tr_noop("External program")
OWN_SOUND = tr_noop("Own sound of the recorded faces")
KINDS = {"m": tr_noop("male"), "f": tr_noop("female")}
"""What the voices are that are a letter and a number."""
CHOICES = {
    ExampleChoice.VITERBI: tr_noop("Best fit and joins (Viterbi)"),
    ExampleChoice.NEAREST: tr_noop("Nearest duration"),
    ExampleChoice.BAND: tr_noop("Random within 15 % of the duration"),
    ExampleChoice.RANDOM: tr_noop("Random"),
}
NO_TABLE, OTHER_TABLE = tr_noop("None"), tr_noop("Open Table…")
NO_NETWORK, OTHER_NETWORK = tr_noop("No network"), tr_noop("Open Network…")
LACKING = {
    FaceDriver.TABLE: tr_noop("No table is open, so phonemes move the mouth; open one at Recorded faces."),
    FaceDriver.NETWORK: tr_noop("No network is open, so phonemes move the mouth; open one at Face network."),
}
MEANING = tr_noop(
    "{output} stands for the WAV file to write, {text} for the text; without {text}, the program reads the "
    "text from standard input. If it writes a TextGrid beside the WAV file, its times are used."
)
EXAMPLE = f"my-voice --file {OUTPUT} {TEXT}"


class VoicePanel(QFrame):
    """Pops up beside the button that it belongs to; Escape or a click elsewhere closes it.

    Signals
    -------
    table_asked, network_asked : the user wants to open a table of recorded faces, or a network.
    """

    table_asked = Signal()
    network_asked = Signal()

    def __init__(self, voice: VoiceModel, drivers: DriverModel, theme: Theme, button: QWidget) -> None:
        super().__init__(button, Qt.WindowType.Popup)
        self._voice, self._drivers, self._button = voice, drivers, button
        self.setObjectName("voice")
        self.setStyleSheet(f"#voice {{ background: {theme.window}; border: 1px solid {theme.line} }}")
        self.setAccessibleName(tr("Voice"))
        self.name = choice(
            (),
            tr("Voice"),
            tr(
                "Voice that speaks the text: one of espeak-ng, the recordings of the table in use, or an external "
                "text-to-speech program"
            ),
        )
        self.rate = named(
            NumberField(SLOWEST, FASTEST, decimals=1, step=0.1, unit=" " + tr("syllables/s"), waits=True),
            tr("Speech rate"),
            tr("Speech rate of the voices of espeak-ng; people speak four to five syllables a second"),
        )
        self.driver = choice(
            ((tr(driver.caption), driver) for driver in FaceDriver),
            tr("Driven by"),
            tr(
                "What moves the mouth: recorded faces and pinyin letters where the words are known, a network by "
                "any sound. Automatic: recorded faces or a network if one is open, pinyin letters for Chinese, else "
                "phonemes"
            ),
        )
        self.table = choice(
            (),
            tr("Table of recorded faces"),
            tr(
                "Table of recorded faces whose motion is used for new sentences; `phonemeanalyser performance "
                "build` makes one"
            ),
        )
        self.network = choice(
            (),
            tr("Face network"),
            tr(
                "Network that moves the face from the sound alone, also live; `phonemeanalyser performance learn` "
                "makes one of recorded faces"
            ),
        )
        self.choice = choice(
            ((tr(words), kind) for kind, words in CHOICES.items()),
            tr("Unit selection"),
            tr("Which recording is used where several have the same phones"),
        )
        self.program = named(
            QLineEdit(),
            tr("Command"),
            tr("Command of the external program, such as: {example}").format(example=EXAMPLE),
        )
        self.program.setPlaceholderText(EXAMPLE)
        self._hint = label(tr(MEANING).format(output=OUTPUT, text=TEXT), theme.faint, wraps=True)
        self._lay_out()
        self._connect()
        self.show_state()

    def show_beside(self) -> None:
        """Show it below what it belongs to, or above where the screen ends there."""
        self._place()
        self.show()
        self.name.setFocus()

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.close()
        else:
            super().keyPressEvent(event)

    def show_state(self) -> None:
        """Show what is chosen."""
        choice = self._voice.choice
        with silent(self.rate, self.program):
            self._list_voices()
            program, found = self.name.count() - 1, max(0, self.name.findData(choice.name))
            self.name.setCurrentIndex(program if choice.by_program else int(choice.own_sound) or found)
            self.driver.setCurrentIndex(self.driver.findData(self._drivers.chosen))
            self._show_files()
            self.rate.setValue(choice.rate)
            self.rate.setEnabled(not choice.by_program)
            if self.program.text() != choice.program:
                self.program.setText(choice.program)
            for widget in (self.program, self._hint):
                self._rows.setRowVisible(widget, choice.by_program)
        if self.isVisible():
            self._place()

    def _place(self) -> None:
        self.adjustSize()
        button = self._button
        screen = button.screen().availableGeometry()
        place = button.mapToGlobal(QPoint(0, button.height()))
        if place.y() + self.height() > screen.bottom():
            place.setY(button.mapToGlobal(QPoint(0, 0)).y() - self.height())
        place.setX(max(screen.left(), min(place.x(), screen.right() - self.width())))
        self.move(place)

    def _lay_out(self) -> None:
        self._rows = QFormLayout(self)
        self._rows.setContentsMargins(10, 10, 10, 10)
        for words, widget in (
            (tr("Voice"), self.name),
            (tr("Speech rate"), self.rate),
            (tr("Command"), self.program),
            ("", self._hint),
            (tr("Driven by"), self.driver),
            (tr("Recorded faces"), self.table),
            (tr("Unit selection"), self.choice),
            (tr("Face network"), self.network),
        ):
            self._rows.addRow(words, widget)
        self.table.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setFixedWidth(WIDTH)

    def _connect(self) -> None:
        voice = self._voice
        self.name.activated.connect(self._choose_voice)
        self.rate.valueChanged.connect(lambda rate: voice.choose(rate=rate))
        self.program.editingFinished.connect(lambda: voice.choose(program=self.program.text().strip()))
        drivers, performance = self._drivers, self._drivers.performance
        self.driver.activated.connect(self._choose_driver)
        self.table.activated.connect(self._choose_table)
        self.network.activated.connect(self._choose_network)
        self.choice.activated.connect(lambda k: performance.set_choice(ExampleChoice(self.choice.itemData(k))))
        for part in (drivers, performance, drivers.network):
            part.changed.connect(self.show_state)
        voice.changed.connect(self.show_state)

    def _choose_voice(self, place: int) -> None:
        if place == self.name.count() - 1:
            self._voice.choose(by_program=True, own_sound=False)
            self.program.setFocus()
        elif place == 1:
            self._voice.choose(by_program=False, own_sound=True)
            if self._drivers.performance.chosen is None:
                self._choose_table(self.table.count() - 1)
        else:
            self._voice.choose(name=self.name.itemData(place), by_program=False, own_sound=False)

    def _choose_driver(self, place: int) -> None:
        driver = FaceDriver(self.driver.itemData(place))
        self._drivers.choose(driver)
        if driver in NEEDS_FILE and not self._drivers.name_of(driver):
            self._drivers.info.emit(tr(LACKING[driver]))

    def _choose_table(self, place: int) -> None:
        if place == self.table.count() - 1:
            self.close()
            self.table_asked.emit()
        else:
            self._choose_faces(self.table.itemData(place))

    def _choose_network(self, place: int) -> None:
        if place == self.network.count() - 1:
            self.close()
            self.network_asked.emit()
        else:
            self._drivers.network.choose(self.network.itemData(place))

    def _choose_faces(self, chosen: Path | str | None) -> None:
        """Use a table, or those of a person by the language of the text."""
        performance = self._drivers.performance
        if isinstance(chosen, str):
            performance.choose_person(chosen)
        else:
            performance.choose(chosen)

    def _show_files(self) -> None:
        """List whose tables are open, and all tables and networks; those of synthetic performers are named so."""
        performance, network = self._drivers.performance, self._drivers.network
        tables = [(_named(about), path) for path, about in performance.known.items()]
        by_language = tr("{person}, by the language of the text")
        persons = [(by_language.format(person=name), name) for name in performance.persons]
        offered = [(tr(NO_TABLE), None), *persons, *tables, (tr(OTHER_TABLE), OTHER_TABLE)]
        known = performance.person in performance.persons
        offer(self.table, offered, performance.person if known else performance.chosen)
        networks = [(tr_engine(known.title), path) for path, known in network.known.items()]
        offered = [(tr(NO_NETWORK), None), *networks, (tr(OTHER_NETWORK), OTHER_NETWORK)]
        offer(self.network, offered, network.chosen)
        self.choice.setCurrentIndex(self.choice.findData(performance.choice))
        self._rows.setRowVisible(self.choice, performance.chosen is not None)

    def _list_voices(self) -> None:
        """List the voices, once they are known: those of men and women first."""
        names = sorted(self._voice.installed.voices, key=lambda name: (not _kind_of(name), name.lower()))
        if self.name.count() != len(names) + 3:
            self.name.clear()
            self.name.addItem(tr(OWN_VOICE), "")
            self.name.addItem(tr(OWN_SOUND), None)
            for name in names:
                kind = _kind_of(name)
                self.name.addItem(f"{name} ({tr(kind)})" if kind else name, name)
            self.name.addItem(tr(OWN_PROGRAM), None)


class VoiceButton(QToolButton):
    """Says who speaks, and opens the panel.

    Attributes
    ----------
    panel : what it opens.
    """

    def __init__(self, voice: VoiceModel, drivers: DriverModel, theme: Theme) -> None:
        super().__init__()
        self._voice, self._drivers = voice, drivers
        self.panel = VoicePanel(voice, drivers, theme, self)
        self.setText(tr("Voice && Face…"))
        self.setAccessibleName(tr("Voice, speech rate, and driver of the mouth"))
        self.clicked.connect(lambda _checked: self.panel.show_beside())
        for part in (voice, drivers):
            part.changed.connect(self._show_state)
        self._show_state()

    def _show_state(self) -> None:
        choice = self._voice.choice
        who = (
            tr(OWN_PROGRAM)
            if choice.by_program
            else tr("{name}, {rate:g} syllables/s").format(
                name=tr(OWN_SOUND) if choice.own_sound else choice.name or tr(OWN_VOICE), rate=choice.rate
            )
        )
        moved = tr_engine(self._drivers.name_of(self._drivers.main)) or tr(self._drivers.main.caption)
        self.setToolTip(
            tr("Choose the voice, its speech rate, and what moves the mouth (now: {who}; {moved})").format(
                who=who, moved=moved
            )
        )


def _named(about: TableAbout) -> str:
    """Return what a table is called, whose it is and in which language, as far as that is known."""
    return ", ".join(filter(None, (tr_engine(about.title), about.person, about.language)))


def _kind_of(name: str) -> str:
    """Return what kind of voice a letter and a number are; nothing for other names."""
    return KINDS.get(name[0], "") if name[1:].isdecimal() else ""
