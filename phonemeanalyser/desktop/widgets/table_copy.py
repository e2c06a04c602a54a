"""Tables that copy: Ctrl+C, or a right click, puts all of one on the clipboard for a spreadsheet."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QGuiApplication, QKeySequence, QShortcut
from PySide6.QtWidgets import QTableWidget, QTableWidgetItem

from phonemeanalyser.desktop.language import tr


def let_copy(table: QTableWidget) -> None:
    """Have a table copy itself, headings and all."""
    copy = QAction(tr("Copy Table"), table)
    copy.triggered.connect(lambda: QGuiApplication.clipboard().setText(text_of(table)))
    key = QShortcut(QKeySequence(QKeySequence.StandardKey.Copy), table, copy.trigger)
    key.setContext(Qt.ShortcutContext.WidgetShortcut)
    table.addAction(copy)
    table.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)


def text_of(table: QTableWidget) -> str:
    """Return what a table shows, as tab-separated text; columns that are hidden are left out."""
    columns = [k for k in range(table.columnCount()) if not table.isColumnHidden(k)]
    named = not table.verticalHeader().isHidden()  # each row has a name
    heading = [_words(table.horizontalHeaderItem(k)) for k in columns]
    lines = [["", *heading] if named else heading]
    for row in range(table.rowCount()):
        cells = [_words(table.item(row, k)) for k in columns]
        lines.append([_words(table.verticalHeaderItem(row)), *cells] if named else cells)
    return "".join("\t".join(line) + "\n" for line in lines)


def _words(item: QTableWidgetItem | None) -> str:
    return "" if item is None else item.text().replace("\t", " ").replace("\n", " ")
