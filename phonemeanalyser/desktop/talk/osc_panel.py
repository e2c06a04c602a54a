"""The mouth over the network: a switch, where to, and how it goes."""

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QCheckBox, QComboBox, QGridLayout, QLabel, QLineEdit, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.talk.osc_model import AS_THE_HEAD, TABLES, OscModel
from phonemeanalyser.desktop.theme import Theme

NAMES = {
    AS_THE_HEAD: tr_noop("as the head"),
    "arkit": "ARKit 52",
    "vrm": "VRM 0: A I U E O",
    "vrm1": "VRM 1: aa ih ou ee oh",
    "oculus": "Oculus 15",
}


class OscPanel(QWidget):
    """Switches the OSC messages on and off."""

    def __init__(self, osc: OscModel, theme: Theme) -> None:
        super().__init__()
        self._osc = osc
        self._theme = theme
        self.switch = QCheckBox(tr("Send the mouth (OSC) to"))
        self.address = QLineEdit()
        self.table = QComboBox()
        self.state = QLabel()
        self._lay_out()
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

    def _lay_out(self) -> None:
        self.switch.setToolTip(
            tr(
                "Send phonemes, mouth shapes and the weights of the movestates over the network, as OSC messages of "
                "the VMC protocol, which VTuber programs understand"
            )
        )
        self.address.setPlaceholderText("HOST:PORT")
        self.address.setAccessibleName(tr("receiver of the OSC messages"))
        self.address.setToolTip(tr("HOST:PORT of the program that shall receive the mouth, such as 127.0.0.1:39539"))
        self.table.setAccessibleName(tr("movestates that are sent"))
        self.table.setToolTip(
            tr("The movestates of the avatar that receives them: those of the head’s table, or another set")
        )
        for name in TABLES:
            self.table.addItem(tr(NAMES[name]), name)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setVerticalSpacing(4)
        grid.addWidget(self.switch, 0, 0)
        grid.addWidget(self.address, 0, 1)
        grid.addWidget(self.state, 1, 0)
        grid.addWidget(self.table, 1, 1)
        grid.setColumnStretch(1, 1)

    def _switch(self, on: bool) -> None:
        self._osc.set_address(self.address.text())
        self._osc.set_on(on)

    def _show_state(self) -> None:
        osc = self._osc
        with QSignalBlocker(self.switch):
            self.switch.setChecked(osc.on)
        if not self.address.hasFocus() or not self.address.isModified():
            self.address.setText(osc.address)
        self.table.setCurrentIndex(self.table.findData(osc.table))
        self.refresh()
