"""All texts that a widget shows or tells: labels, menus, tool tips, tables, axes, names for screen readers."""

import re
from collections.abc import Callable, Iterator
from typing import Any

import pyqtgraph as pg
from PySide6 import QtWidgets
from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction

from phonemeanalyser.desktop.help import ManualDialog
from phonemeanalyser.desktop.widgets.timeline import Timeline

_MARKUP = re.compile(r"<[^>]*>|&nbsp;")
_BREAKS = re.compile(r"\s*(?:<(?:br|p|/p|tr|/tr|td|/td)[^>]*>|\n)\s*")
Texts = Iterator[str]


def texts_of(widget: QtWidgets.QWidget) -> set[str]:
    """Return the texts of a widget and all that is in it, each without markup, but for the manual's pages."""
    found = {text for part in (widget, *widget.findChildren(QObject)) for text in _texts_of(part)}
    return {plain for text in found for part in _BREAKS.split(text) if (plain := _MARKUP.sub("", part).strip())}


def _texts_of(part: QObject) -> Texts:
    if isinstance(part, QtWidgets.QTextBrowser) or (
        isinstance(part.parent(), ManualDialog) and isinstance(part, QtWidgets.QListWidget)
    ):
        return
    if isinstance(part, QAction) and not isinstance(part.parent(), QtWidgets.QWidget):
        return  # pyqtgraph has some for a menu that nobody can open
    for kind, texts in _KINDS.items():
        if isinstance(part, kind):
            yield from texts(part)


def _of_widget(part: QtWidgets.QWidget) -> Texts:
    yield from (part.windowTitle(), part.toolTip(), part.accessibleName(), part.accessibleDescription())


def _of_table(table: QtWidgets.QTableWidget) -> Texts:
    for role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole):
        for n, side in (
            (table.columnCount(), Qt.Orientation.Horizontal),
            (table.rowCount(), Qt.Orientation.Vertical),
        ):
            yield from (str(table.model().headerData(k, side, role) or "") for k in range(n))
    items = (table.item(row, k) for row in range(table.rowCount()) for k in range(table.columnCount()))
    for item in items:
        if item is not None:
            yield from (item.text(), item.toolTip())


def _of_plot(view: Any) -> Texts:
    for item in view.scene().items():
        if isinstance(item, pg.AxisItem) and item.isVisible():
            yield item.labelText
        elif isinstance(item, pg.TextItem):
            yield item.toPlainText()


_KINDS: dict[Any, Callable[[Any], Texts]] = {
    QAction: lambda action: iter((action.text(), action.toolTip())),
    QtWidgets.QWidget: _of_widget,
    QtWidgets.QLabel: lambda label: iter((label.text(),)),
    QtWidgets.QAbstractButton: lambda button: iter((button.text(),)),
    QtWidgets.QMenu: lambda menu: iter((menu.title(),)),
    QtWidgets.QLineEdit: lambda field: iter((field.placeholderText(),)),
    QtWidgets.QPlainTextEdit: lambda field: iter((field.placeholderText(),)),
    QtWidgets.QComboBox: lambda box: (box.itemText(k) for k in range(box.count())),
    QtWidgets.QAbstractSpinBox: lambda box: iter((box.specialValueText(),)),
    QtWidgets.QSpinBox: lambda box: iter((box.prefix(), box.suffix())),
    QtWidgets.QDoubleSpinBox: lambda box: iter((box.prefix(), box.suffix())),
    QtWidgets.QTabWidget: lambda tabs: (tabs.tabText(k) for k in range(tabs.count())),
    QtWidgets.QTableWidget: _of_table,
    QtWidgets.QListWidget: lambda rows: (rows.item(k).text() for k in range(rows.count())),
    pg.GraphicsView: _of_plot,
    Timeline: lambda timeline: (lane.name for lane in timeline.lanes),
}
"""What each kind of object shows."""
