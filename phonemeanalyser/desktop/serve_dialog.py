"""The server: what it serves, where and to whom, and what its clients do."""

import secrets
from collections.abc import Callable
from pathlib import Path
from socket import gethostname

from PySide6 import QtWidgets
from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QGuiApplication
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.serving import MOST_LOGGED, ServeOrder, ServerModel, kept_token
from phonemeanalyser.desktop.settings import keep, read
from phonemeanalyser.desktop.tasks import tried
from phonemeanalyser.desktop.widgets.builders import CLOSE, choice, dialog_buttons, heading, label, named, row
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeanalyser.desktop.widgets.preset_picker import PresetChoice, Sections
from phonemeanalyser.server.access import TOKEN, USUAL_HOST, USUAL_PORT, is_loopback
from phonemeanalyser.server.activity import Activity, Happening
from phonemeengine.presets.preset import Preset

WIDTH, LOG_HEIGHT = 560, 150
TOKEN_BYTES = 32
HOSTS = {
    USUAL_HOST: tr_noop("This computer only (127.0.0.1)"),
    "0.0.0.0": tr_noop("Other computers, too (0.0.0.0)"),  # noqa: S104 - it is what the user chooses
}
WORDS = {
    Happening.SERVING: tr_noop("Serving {words}"),
    Happening.STREAM_BEGAN: tr_noop("{client}: stream begun, {n} open"),
    Happening.STREAM_ENDED: tr_noop("{client}: stream ended, {n} open"),
    Happening.EXPORTED: tr_noop("{client}: file exported"),
    Happening.REFUSED: tr_noop("{client}: refused: {words}"),
}
"""What the log says."""


class ServeDialog(QtWidgets.QDialog):
    """Shows the server, which goes on when this is closed.

    Parameters
    ----------
    server : what is shown.
    preset : the current one, or its file where that says the same.
    name : what it is called.
    sections : gives other presets to choose from, by heading.

    Attributes
    ----------
    preset, host, port, needs_token, token : choices.
    state, log : what the server does, and what its clients do.
    copy, renew, start : buttons; the last one stops, too.
    """

    def __init__(
        self,
        server: ServerModel,
        preset: Preset | Path,
        name: str,
        sections: Callable[[], Sections],
        settings: QSettings,
        files: FileAsker,
        parent: QtWidgets.QWidget,
    ) -> None:
        super().__init__(parent)
        self._server, self._in_hand, self._settings = server, preset, settings
        self.setWindowTitle(tr("Serve"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setMinimumWidth(WIDTH)
        self.preset = PresetChoice(name, sections, files)
        self.host = choice(((tr(words), host) for host, words in HOSTS.items()), tr("Address"))
        self.port = named(QtWidgets.QSpinBox(), tr("Port"), tr("TCP port; 0 lets the system choose a free one"))
        self.port.setRange(0, 65_535)
        self.needs_token = QtWidgets.QCheckBox(tr("Clients need a token"))
        self.token = named(QtWidgets.QLineEdit(), tr("Token"), tr("16 to 256 letters, digits or . _ ~ -"))
        self.copy, self.renew = QtWidgets.QPushButton(tr("Copy")), QtWidgets.QPushButton(tr("New"))
        self.state = label(wraps=True)
        self.log = named(QtWidgets.QPlainTextEdit(), tr("Log"))
        self._fill()
        self._lay_out()
        self._connect()
        self._show_state()

    def order(self) -> ServeOrder:
        """Return what is chosen."""
        token = self.token.text().strip() if self.needs_token.isChecked() else ""
        chosen = self.preset.path or self._in_hand
        return ServeOrder(
            chosen, self.host.currentData(), self.port.value(), token, self.preset.text().removesuffix(" ▾")
        )

    @override
    def accept(self) -> None:
        """Start or stop; the dialog stays open."""
        if self._server.running:
            self._server.stop()
            return
        order = self.order()
        keep(self._settings, "serve/host", order.host)
        keep(self._settings, "serve/port", order.port)
        keep(self._settings, "serve/token", bool(order.token))
        self.log.clear()
        tried(lambda: self._server.start(order), self._say)

    def _fill(self) -> None:
        order, settings = self._server.order, self._settings
        last = order or ServeOrder(
            Path(), read(settings, "serve/host", USUAL_HOST), read(settings, "serve/port", USUAL_PORT)
        )
        if self._server.running:
            self.preset.show_name(last.name)
        self.host.setCurrentIndex(max(0, self.host.findData(last.host)))
        self.port.setValue(last.port)
        self.needs_token.setChecked(read(settings, "serve/token", False))
        self.token.setText(last.token or kept_token() or secrets.token_urlsafe(TOKEN_BYTES))
        self.token.setCursorPosition(0)
        self.log.setReadOnly(True)
        self.log.setMaximumBlockCount(MOST_LOGGED)
        self.log.setMinimumHeight(LOG_HEIGHT)
        for activity in self._server.log:
            self._tell(activity)

    def _lay_out(self) -> None:
        form = QtWidgets.QFormLayout(self)
        form.addRow(heading(tr("Recognise speech for other programs")))
        words = tr(
            "Streams and files of other programs are recognised with this preset. The server runs until it is "
            "stopped or the program quits."
        )
        form.addRow(label(words, wraps=True))
        form.addRow(tr("Preset"), self.preset)
        form.addRow(tr("Address"), self.host)
        form.addRow(tr("Port"), self.port)
        form.addRow("", self.needs_token)
        form.addRow(tr("Token"), row((self.token, 1), self.copy, self.renew))
        form.addRow(self.state)
        form.addRow(self.log)
        buttons = dialog_buttons(self, CLOSE, verb=tr("Start"))
        self.start = buttons.buttons()[0]
        form.addRow(buttons)
        for button in (self.copy, self.renew):
            button.setAutoDefault(False)  # Return starts

    def _connect(self) -> None:
        self._server.changed.connect(self._show_state)
        self._server.told.connect(self._tell)
        self.copy.clicked.connect(self._copy)
        self.renew.clicked.connect(self._renew)
        for signal in (self.host.currentIndexChanged, self.needs_token.toggled, self.token.textChanged):
            signal.connect(self._allow)

    def _show_state(self) -> None:
        server = self._server
        shown = tr("Stopped")
        if server.running:
            host = gethostname() if server.address.startswith("http://0.") else USUAL_HOST
            streams = f"ws://{host}:{server.address.rpartition(':')[2]}/stream"
            shown = tr("Serving {address}").format(address=streams) if server.address else tr("Starting or stopping…")
        self._say(server.failure) if server.failure else self.state.setText(shown)
        self.start.setText(tr("Stop") if server.running else tr("Start"))
        self._allow()

    def _say(self, words: str) -> None:
        translated = tr_engine(words)
        self.state.setText(f"{translated[:1].upper()}{translated[1:]}")

    def _allow(self) -> None:
        """Enable what applies: access from other computers needs a token, and a running server keeps its settings."""
        stopped, everybody = not self._server.running, not is_loopback(self.host.currentData())
        if everybody:
            self.needs_token.setChecked(True)
        needs = self.needs_token.isChecked()
        for choices, allowed in (
            (self.preset, True), (self.host, True), (self.port, True), (self.needs_token, not everybody),
            (self.token, needs), (self.renew, needs),
        ):  # fmt: skip
            choices.setEnabled(stopped and allowed)
        self.copy.setEnabled(needs)
        self.start.setEnabled(not stopped or not needs or bool(TOKEN.fullmatch(self.token.text().strip())))

    def _tell(self, activity: Activity) -> None:
        words = tr(WORDS[activity.what]).format(client=activity.client, words=activity.words, n=activity.n_streams)
        self.log.appendPlainText(f"{activity.clock}  {words}")

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.token.text().strip())

    def _renew(self) -> None:
        self.token.setText(secrets.token_urlsafe(TOKEN_BYTES))
        self.token.setCursorPosition(0)
