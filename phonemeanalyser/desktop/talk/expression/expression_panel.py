"""What the face expresses beside its speech, as sliders; and the mouth over the network, with how it goes."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QLabel, QLineEdit, QProgressBar, QSlider, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.expression.osc_model import OscModel
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders

RECORDING = tr_noop(
    "Load a face that Live Link Face or OpenFace captured (CSV), and show it along with the speech, in sync with the "
    "audio"
)
PERCENT_WIDTH = 40
FOLLOWING = {
    "brows": tr_noop("Brows follow the voice"),
    "lids": tr_noop("Lids follow the voice"),
    "smile": tr_noop("Smile follows the voice"),
    "head": tr_noop("Head follows the voice"),
}
"""What follows the feeling in the voice, and what its slider is called."""
METER_HEIGHT = 10


class ExpressionPanel(QWidget):
    """Lists the expressions that ship with the program, and takes others from files and programs.

    Signals
    -------
    file_asked : the user wants to open a recording.

    Attributes
    ----------
    sliders : by the name of the expression.
    following : sliders of what follows the feeling in the voice, by the part of the face.
    text_feeling : the slider of what the text says of feeling.
    priority : the slider of speech's priority.
    meter : shows how far speech holds expressions back, %.
    """

    file_asked = Signal()

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._talking, self._model = talking, talking.expression
        self._make_sliders()
        self._make_inputs()
        self._lay_out(theme)
        self._connect()
        self._show_state()

    def _make_sliders(self) -> None:
        """Make what asks for expressions, and for what follows the voice and the text."""
        self.sliders = {
            name: _slider(tr("Strength of the expression: {name}").format(name=tr(name)))
            for name in self._model.shares
        }
        self._percents = {name: builders.label(width=PERCENT_WIDTH) for name in self._model.shares}
        for name, percent in self._percents.items():
            percent.setToolTip(self.sliders[name].toolTip())
        tip = tr(
            "How far this follows the voice: lively, loud and high speech lifts, relaxed speech lowers, each "
            "compared with the speaker’s usual voice"
        )
        self.following = {part: builders.slider_of_percent(tr(words), tip) for part, words in FOLLOWING.items()}
        self._amounts = {part: builders.label(width=PERCENT_WIDTH) for part in FOLLOWING}
        for percent in self._amounts.values():
            percent.setToolTip(tip)
        self.text_feeling = builders.slider_of_percent(
            tr("Face follows the text"),
            tr(
                "How far the face shows what the text says of feeling: [smile], [angry 0.6], emoji, good and bad "
                "words; the lane Feeling of the timeline shows and edits it"
            ),
        )
        self._of_text = builders.label(width=PERCENT_WIDTH)
        self._of_text.setToolTip(self.text_feeling.toolTip())
        self.neutral = builders.tool_button(tr("Neutral"), tr("Set all sliders to 0"))

    def _make_inputs(self) -> None:
        """Make what shows and sets the speech's share, and what takes expressions from files and programs."""
        self.priority = builders.slider_of_percent(
            tr("Speech priority"),
            tr(
                "How much of the lips and the jaw speech controls; the expression controls the rest. At 50 %, "
                "both are applied in full"
            ),
        )
        self.meter = builders.named(
            QProgressBar(),
            tr("Reduced by speech"),
            tr(
                "How much speech reduces the expression now: it fades within 0.1 s when speech starts, and returns "
                "within 0.5 s"
            ),
        )
        self.meter.setRange(0, 100)
        self.meter.setTextVisible(False)
        self.meter.setFixedHeight(METER_HEIGHT)
        self.file = builders.spoken_button(tr("Load Face Capture…"), tr(RECORDING))
        self.state = builders.ElidedLabel()
        self.switch = builders.named(
            QCheckBox(tr("Receive OSC at")),
            tip=tr(
                "Show expressions that other programs send: /expression NAME 0..1, or the blend shapes of a face "
                "tracker (VMC)"
            ),
        )
        self.address = builders.named(
            QLineEdit(),
            tr("Address for receiving expressions"),
            tr("Address (HOST:PORT) at which messages of other programs are received, such as 127.0.0.1:39540"),
        )
        self.address.setPlaceholderText("HOST:PORT")

    def refresh(self) -> None:
        """Show what changes by itself."""
        reduced = round(100 * self._talking.performer.inhibition)
        if reduced != self.meter.value():
            self.meter.setValue(reduced)
        words = self._model.input.words
        if words != self.state.text():
            self.state.setText(words)
            self.state.setToolTip(words)
            colour = self._theme.good if self._model.input.receives else self._theme.faint
            self.state.setStyleSheet(f"color: {colour}")

    def _lay_out(self, theme: Theme) -> None:
        shares = builders.grid(across=5, down=3)
        builders.fill_rows(
            shares,
            [
                (builders.label(tr(name).capitalize()), self.sliders[name], self._percents[name])
                for name in self.sliders
            ],
        )
        following = builders.grid(across=5, down=3)
        builders.fill_rows(
            following,
            [
                *((builders.label(tr(words)), self.following[p], self._amounts[p]) for p, words in FOLLOWING.items()),
                (builders.label(self.text_feeling.accessibleName()), self.text_feeling, self._of_text),
            ],
        )
        others = builders.grid(across=8, down=4)
        others.addWidget(self.file, 0, 0, 1, 3, Qt.AlignmentFlag.AlignLeft)
        for place, widget in enumerate((self.switch, self.address, self.state)):
            others.addWidget(widget, 1, place)
        others.setColumnStretch(1, 1)
        others.setColumnStretch(2, 1)
        priority, reduced = (
            builders.label(tr("Speech priority"), theme.faint),
            builders.label(tr("Reduced by speech"), theme.faint),
        )
        builders.column(
            builders.row((builders.heading(tr("Expression")), 1), self.neutral),
            shares,
            following,
            builders.row(priority, (self.priority, 1), reduced, (self.meter, 1), spacing=8),
            others,
            on=self,
            spacing=4,
        )

    def _connect(self) -> None:
        for name, slider in self.sliders.items():
            slider.valueChanged.connect(lambda value, name=name: self._model.set_share(name, value / 100))
        for part, slider in self.following.items():
            slider.valueChanged.connect(lambda value, part=part: self._model.set_feeling(part, value / 100))
        self.text_feeling.valueChanged.connect(lambda value: self._model.set_text_feeling(value / 100))
        self.priority.valueChanged.connect(lambda value: self._model.set_priority(value / 100))
        self.neutral.clicked.connect(lambda _checked: self._model.clear())
        self.file.clicked.connect(lambda _checked: self._choose_file())
        self.switch.clicked.connect(self._switch)
        self.address.editingFinished.connect(lambda: self._model.input.set_address(self.address.text()))
        self._model.changed.connect(self._show_state)

    def _choose_file(self) -> None:
        """Open a recording, or do without the one that is in use."""
        if self._model.path is None:
            self.file_asked.emit()
        else:
            self._model.set_file(None)

    def _switch(self, on: bool) -> None:
        self._model.input.set_address(self.address.text())
        self._model.input.set_on(on)

    def _show_state(self) -> None:
        for name, share in self._model.shares.items():
            with builders.silent(self.sliders[name]):
                self.sliders[name].setValue(round(100 * share))
            self._percents[name].setText(f"{100 * share:.0f} %")
        for part, amount in self._model.feeling.items():
            with builders.silent(self.following[part]):
                self.following[part].setValue(round(100 * amount))
            self._amounts[part].setText(f"{100 * amount:.0f} %")
        with builders.silent(self.priority, self.text_feeling):
            self.priority.setValue(round(100 * self._model.priority))
            self.text_feeling.setValue(round(100 * self._model.text_feeling))
        self._of_text.setText(f"{100 * self._model.text_feeling:.0f} %")
        moved = *self._model.shares.values(), *self._model.feeling.values(), self._model.text_feeling
        self.neutral.setEnabled(any(moved))
        path, received = self._model.path, self._model.input
        if path is None:
            builders.named(self.file, tr(RECORDING), tr(RECORDING)).setText(tr("Load Face Capture…"))
        else:
            builders.show_removable(self.file, path.name, tr("Remove the face capture {path}").format(path=path))
        with builders.silent(self.switch):
            self.switch.setChecked(received.on)
        if not self.address.hasFocus() or not self.address.isModified():
            self.address.setText(received.address)
        self.refresh()


def _slider(name: str) -> QSlider:
    return builders.slider_of_percent(name, name)


class OscPanel(QWidget):
    """Switches the OSC messages on and off."""

    def __init__(self, osc: OscModel, theme: Theme) -> None:
        super().__init__()
        self._osc = osc
        self._theme = theme
        self.switch = builders.named(
            QCheckBox(tr("Send OSC to")),
            tip=tr(
                "Send phonemes, mouth shapes and blend shape weights over the network, as OSC messages of the VMC "
                "protocol that VTuber programs use"
            ),
        )
        self.address = builders.named(
            QLineEdit(),
            tr("Receiver of the OSC messages"),
            tr("Address (HOST:PORT) of the program that receives the messages, such as 127.0.0.1:39539"),
        )
        self.address.setPlaceholderText("HOST:PORT")
        self.table = builders.choice(
            ((words, name) for name, words in osc.tables.items()),
            tr("Blend shapes to send"),
            tr("Set of blend shapes that the receiving avatar has: that of the head’s mouth table, or another one"),
        )
        self.state = QLabel()
        fields = builders.grid(self, down=4)
        fields.addWidget(self.switch, 0, 0)
        fields.addWidget(self.address, 0, 1)
        fields.addWidget(builders.label(self.table.accessibleName()), 1, 0)
        fields.addWidget(self.table, 1, 1)
        fields.addWidget(self.state, 2, 1)
        fields.setColumnStretch(1, 1)
        self.switch.clicked.connect(self._switch)
        self.address.editingFinished.connect(lambda: osc.set_address(self.address.text()))
        self.table.activated.connect(lambda k: osc.set_table(self.table.itemData(k)))
        osc.changed.connect(self._show_state)
        self._show_state()

    def refresh(self) -> None:
        """Show how it goes."""
        if self._osc.words != self.state.text():
            self.state.setText(self._osc.words)
            colour = self._theme.good if self._osc.sending else self._theme.faint
            self.state.setStyleSheet(f"color: {colour}")

    def _switch(self, on: bool) -> None:
        self._osc.set_address(self.address.text())
        self._osc.set_on(on)

    def _show_state(self) -> None:
        osc = self._osc
        with builders.silent(self.switch):
            self.switch.setChecked(osc.on)
        if not self.address.hasFocus() or not self.address.isModified():
            self.address.setText(osc.address)
        self.table.setCurrentIndex(self.table.findData(osc.table))
        self.refresh()
