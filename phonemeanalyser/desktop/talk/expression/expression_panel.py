"""What the face expresses beside its speech, as sliders; and the mouth over the network, with how it goes."""

from functools import partial

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QLineEdit, QProgressBar, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.expression.expression_model import OscConnection, OscModel
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.fields import PercentSlider

RECORDING = tr_noop(
    "Load a face that Live Link Face or OpenFace captured (CSV), and show it along with the speech, in sync with the "
    "audio"
)
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
        self._model.changed.connect(self._show_state)
        self._show_state()

    def _make_sliders(self) -> None:
        """Make what asks for expressions, and for what follows the voice and the text."""
        model = self._model
        self.sliders = {
            name: PercentSlider(words, words, partial(model.set_share, name))
            for name in model.shares
            for words in (tr("Strength of the expression: {name}").format(name=tr(name)),)
        }
        tip = tr(
            "How far this follows the voice: lively, loud and high speech lifts, relaxed speech lowers, each "
            "compared with the speaker’s usual voice"
        )
        self.following = {
            part: PercentSlider(tr(words), tip, partial(model.set_feeling, part)) for part, words in FOLLOWING.items()
        }
        self.text_feeling = PercentSlider(
            tr("Face follows the text"),
            tr(
                "How far the face shows what the text says of feeling: [smile], [angry 0.6], emoji, good and bad "
                "words; the lane Feeling of the timeline shows and edits it"
            ),
            model.set_text_feeling,
        )
        self.neutral = builders.tool_button(tr("Neutral"), tr("Set all sliders to 0"), act=model.clear)

    def _make_inputs(self) -> None:
        """Make what shows and sets the speech's share, and what takes expressions from files and programs."""
        self.priority = PercentSlider(
            tr("Speech priority"),
            tr(
                "How much of the lips and the jaw speech controls; the expression controls the rest. At 50 %, "
                "both are applied in full"
            ),
            self._model.set_priority,
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
        self.file = builders.spoken_button(tr("Load Face Capture…"), tr(RECORDING), self._choose_file)
        self.osc = OscFields(
            self._model.input,
            tr("Receive OSC at"),
            tr(
                "Show expressions that other programs send: /expression NAME 0..1, or the blend shapes of a face "
                "tracker (VMC)"
            ),
            tr("Address for receiving expressions"),
            tr("Address (HOST:PORT) at which messages of other programs are received, such as 127.0.0.1:39540"),
            self._theme,
        )

    def refresh(self) -> None:
        """Show what changes by itself."""
        reduced = round(100 * self._talking.performer.inhibition)
        if reduced != self.meter.value():
            self.meter.setValue(reduced)
        self.osc.refresh()

    def _lay_out(self, theme: Theme) -> None:
        shares = builders.grid(across=5, down=3)
        builders.fill_rows(
            shares,
            [
                (builders.label(tr(name).capitalize()), slider, slider.percent)
                for name, slider in self.sliders.items()
            ],
        )
        following = builders.grid(across=5, down=3)
        builders.fill_rows(
            following,
            [
                (builders.label(slider.accessibleName()), slider, slider.percent)
                for slider in (*self.following.values(), self.text_feeling)
            ],
        )
        others = builders.grid(across=8, down=4)
        others.addWidget(self.file, 0, 0, 1, 3, Qt.AlignmentFlag.AlignLeft)
        for place, widget in enumerate((self.osc.switch, self.osc.address, self.osc.state)):
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

    def _choose_file(self) -> None:
        """Open a recording, or do without the one that is in use."""
        if self._model.path is None:
            self.file_asked.emit()
        else:
            self._model.set_file(None)

    def _show_state(self) -> None:
        for name, share in self._model.shares.items():
            self.sliders[name].show_share(share)
        for part, amount in self._model.feeling.items():
            self.following[part].show_share(amount)
        self.priority.show_share(self._model.priority)
        self.text_feeling.show_share(self._model.text_feeling)
        moved = *self._model.shares.values(), *self._model.feeling.values(), self._model.text_feeling
        self.neutral.setEnabled(any(moved))
        path = self._model.path
        if path is None:
            builders.named(self.file, tr(RECORDING), tr(RECORDING)).setText(tr("Load Face Capture…"))
        else:
            builders.show_removable(self.file, path.name, tr("Remove the face capture {path}").format(path=path))
        self.osc.show_state()
        self.refresh()


class OscFields:
    """The switch of an OSC connection, its address, and how it goes.

    Attributes
    ----------
    switch, address, state : the widgets.
    """

    def __init__(
        self, connection: OscConnection, switch: str, tip: str, address: str, address_tip: str, theme: Theme
    ) -> None:
        self._connection, self._theme = connection, theme
        self.switch = builders.named(QCheckBox(switch), tip=tip)
        self.address = builders.named(QLineEdit(), address, address_tip)
        self.address.setPlaceholderText("HOST:PORT")
        self.state = builders.ElidedLabel()
        self.switch.clicked.connect(self._switch)
        self.address.editingFinished.connect(self._take_address)

    def refresh(self) -> None:
        """Show how it goes."""
        words = self._connection.words
        if words != self.state.text():
            self.state.setText(words)
            self.state.setToolTip(words)
            self.state.setStyleSheet(f"color: {self._theme.good if self._connection.active else self._theme.faint}")

    def show_state(self) -> None:
        """Show what is set; an address that is being written stays."""
        with builders.silent(self.switch):
            self.switch.setChecked(self._connection.on)
        if not self.address.hasFocus() or not self.address.isModified():
            self.address.setText(self._connection.address)
        self.refresh()

    def _switch(self, on: bool) -> None:
        self._take_address()
        self._connection.set_on(on)

    def _take_address(self) -> None:
        self._connection.set_address(self.address.text())


class OscPanel(QWidget):
    """Switches the OSC messages on and off."""

    def __init__(self, osc: OscModel, theme: Theme) -> None:
        super().__init__()
        self._osc = osc
        self.fields = OscFields(
            osc,
            tr("Send OSC to"),
            tr(
                "Send phonemes, mouth shapes and blend shape weights over the network, as OSC messages of the VMC "
                "protocol that VTuber programs use"
            ),
            tr("Receiver of the OSC messages"),
            tr("Address (HOST:PORT) of the program that receives the messages, such as 127.0.0.1:39539"),
            theme,
        )
        self.table = builders.choice(
            ((words, name) for name, words in osc.tables.items()),
            tr("Blend shapes to send"),
            tr("Set of blend shapes that the receiving avatar has: that of the head’s mouth table, or another one"),
        )
        table = builders.grid(self, down=4)
        table.addWidget(self.fields.switch, 0, 0)
        table.addWidget(self.fields.address, 0, 1)
        table.addWidget(builders.label(self.table.accessibleName()), 1, 0)
        table.addWidget(self.table, 1, 1)
        table.addWidget(self.fields.state, 2, 1)
        table.setColumnStretch(1, 1)
        self.table.activated.connect(lambda k: osc.set_table(self.table.itemData(k)))
        osc.changed.connect(self._show_state)
        self._show_state()

    def refresh(self) -> None:
        """Show how it goes."""
        self.fields.refresh()

    def _show_state(self) -> None:
        self.fields.show_state()
        self.table.setCurrentIndex(self.table.findData(self._osc.table))
