"""Tables that copy."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QTableWidget, QTableWidgetItem
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.widgets.plot import let_copy

CONTROL = Qt.KeyboardModifier.ControlModifier


def test_ctrl_c_copies_all_that_a_table_shows_and_its_headings(qtbot: QtBot) -> None:
    table = QTableWidget(2, 3)
    qtbot.addWidget(table)
    let_copy(table)
    table.setHorizontalHeaderLabels(["file", "secret", "state"])
    table.setColumnHidden(1, True)
    for row, words in enumerate((("a\tb.wav", "x", "done"), ("c.wav", "y", "two\nlines"))):
        for column, text in enumerate(words):
            table.setItem(row, column, QTableWidgetItem(text))
    table.verticalHeader().hide()
    table.show()
    table.activateWindow()
    table.setFocus()
    qtbot.waitUntil(table.hasFocus)
    QTest.keyClick(table, Qt.Key.Key_C, CONTROL)
    assert QGuiApplication.clipboard().text() == "file\tstate\na b.wav\tdone\nc.wav\ttwo lines\n"


def test_rows_that_have_names_keep_them(qtbot: QtBot) -> None:
    table = QTableWidget(1, 1)
    qtbot.addWidget(table)
    let_copy(table)
    table.setHorizontalHeaderLabels(["before"])
    table.setVerticalHeaderLabels(["macro F1"])
    next(action for action in table.actions() if action.text() == "Copy Table").trigger()
    assert QGuiApplication.clipboard().text() == "\tbefore\nmacro F1\t\n"
