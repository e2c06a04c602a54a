"""The mouth over the network: a switch, where to, and how it goes."""

from PySide6.QtWidgets import QCheckBox, QLabel, QLineEdit, QWidget

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.talk.expression.osc_model import OscModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import choice, grid, named, silent


class OscPanel(QWidget):
    """Switches the OSC messages on and off."""

    def __init__(self, osc: OscModel, theme: Theme) -> None:
        super().__init__()
        self._osc = osc
        self._theme = theme
        self.switch = named(
            QCheckBox(tr("Send the mouth (OSC) to")),
            tip=tr(
                "Send phonemes, mouth shapes and the weights of the movestates over the network, as OSC messages of "
                "the VMC protocol, which VTuber programs understand"
            ),
        )
        self.address = named(
            QLineEdit(),
            tr("receiver of the OSC messages"),
            tr("HOST:PORT of the program that shall receive the mouth, such as 127.0.0.1:39539"),
        )
        self.address.setPlaceholderText("HOST:PORT")
        self.table = choice(
            ((words, name) for name, words in osc.tables.items()),
            tr("movestates that are sent"),
            tr("The movestates of the avatar that receives them: those of the head’s table, or another set"),
        )
        self.state = QLabel()
        fields = grid(self, down=4)
        fields.addWidget(self.switch, 0, 0)
        fields.addWidget(self.address, 0, 1)
        fields.addWidget(self.state, 1, 0)
        fields.addWidget(self.table, 1, 1)
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
        with silent(self.switch):
            self.switch.setChecked(osc.on)
        if not self.address.hasFocus() or not self.address.isModified():
            self.address.setText(osc.address)
        self.table.setCurrentIndex(self.table.findData(osc.table))
        self.refresh()
