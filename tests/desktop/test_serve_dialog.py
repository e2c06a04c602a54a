"""The server of the window: the command's, with what clients do in a log, and a sentence where it cannot serve."""

import json
import socket
import urllib.error
import urllib.request
from argparse import ArgumentParser
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from phonemeanalyser.cli.serve import add_arguments
from phonemeanalyser.desktop.serve_dialog import ServeDialog
from phonemeanalyser.desktop.session.serving import ServeOrder, ServerModel
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeanalyser.server.access import token_in
from phonemeengine import Preset, load_preset
from phonemeengine.presets.files import THESIS_PRESET
from tests.desktop.hands import LEFT

TOKEN = "0123456789abcdef"


@pytest.fixture
def server(qtbot):
    model = ServerModel()
    yield model
    model.close()


@pytest.fixture
def parent(qtbot):
    return QWidget()


def dialog_of(server: ServerModel, settings: QSettings, parent: QWidget) -> ServeDialog:
    dialog = ServeDialog(server, THESIS_PRESET, "Thesis", dict, settings, FileAsker(settings), parent)
    dialog.show()
    return dialog


def test_an_order_is_what_the_command_takes(tmp_path: Path) -> None:
    words = ServeOrder(Preset(name="mine"), "0.0.0.0", 99, TOKEN).command(tmp_path)
    parser = ArgumentParser()
    add_arguments(parser)
    options = parser.parse_args(words[1:])
    assert (words[0], options.supervised, options.host, options.port) == ("serve", True, "0.0.0.0", 99)
    assert load_preset(options.preset[0]).name == "mine"
    assert token_in(options.token_file) == TOKEN


def test_whoever_lets_other_computers_in_needs_a_token(server, settings, parent):
    dialog = dialog_of(server, settings, parent)
    assert dialog.start.isEnabled()
    assert not dialog.token.isEnabled()
    dialog.host.setCurrentIndex(1)
    assert dialog.needs_token.isChecked()
    assert not dialog.needs_token.isEnabled()
    assert dialog.order().token == dialog.token.text()
    QTest.mouseClick(dialog.copy, LEFT)
    assert QGuiApplication.clipboard().text() == dialog.token.text()
    dialog.token.setText("too short")
    assert not dialog.start.isEnabled()


def test_it_serves_goes_on_while_the_dialog_is_closed_and_says_why_it_cannot(server, settings, parent, qtbot):
    dialog = dialog_of(server, settings, parent)
    with socket.create_server(("127.0.0.1", 0)) as taken:
        dialog.port.setValue(taken.getsockname()[1])
        QTest.mouseClick(dialog.start, LEFT)
        assert not dialog.port.isEnabled()
        qtbot.waitUntil(lambda: not server.running)
    assert "cannot be served (another program uses it); choose another host or port" in dialog.state.text()
    dialog.port.setValue(0)
    QTest.mouseClick(dialog.start, LEFT)
    qtbot.waitUntil(lambda: server.address != "")
    with urllib.request.urlopen(server.address, timeout=60) as answer:
        assert json.load(answer)["presets"] == ["thesis"]
    with pytest.raises(urllib.error.HTTPError):
        urllib.request.urlopen(urllib.request.Request(server.address, headers={"Origin": "http://evil"}), timeout=60)
    qtbot.waitUntil(lambda: "refused: pages of http://evil may not ask" in dialog.log.toPlainText())
    log = dialog.log.toPlainText()
    dialog.reject()
    again = dialog_of(server, settings, parent)
    assert again.log.toPlainText() == log
    assert again.start.text() == "Stop"
    QTest.mouseClick(again.start, LEFT)
    qtbot.waitUntil(lambda: not server.running)
    assert (again.state.text(), server.failure) == ("Stopped", "")
