"""All texts that a widget shows or tells: labels, menus, tool tips, tables, axes, names for screen readers."""

import re
from collections.abc import Iterator

import pyqtgraph as pg
from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QComboBox,
    QDoubleSpinBox,
    QGroupBox,
    QLabel,
    QLineEdit,
    QListWidget,
    QMenu,
    QPlainTextEdit,
    QSpinBox,
    QTableWidget,
    QTabWidget,
    QTextBrowser,
    QWidget,
)

from phonemeanalyser.desktop.manual import ManualDialog

_MARKUP = re.compile(r"<[^>]*>|&nbsp;")
_PARTS = re.compile(r"\s*(?:<(?:br|p|/p|tr|/tr|td|/td)[^>]*>|\n)\s*")


def texts_of(widget: QWidget) -> set[str]:
    """Return the texts of a widget and all that is in it, but for the manual's pages, which are English."""
    found = {text for part in (widget, *widget.findChildren(QObject)) for text in _texts_of(part)}
    return {plain for text in found for part in _PARTS.split(text) if (plain := _MARKUP.sub("", part).strip())}


def _texts_of(part: QObject) -> Iterator[str]:
    if isinstance(part, QAction):
        yield from (part.text(), part.toolTip())
    if not isinstance(part, QWidget) or isinstance(part, QTextBrowser):
        return
    yield from (part.windowTitle(), part.toolTip(), part.statusTip(), part.whatsThis())
    yield from (part.accessibleName(), part.accessibleDescription())
    if isinstance(part, (QLabel, QAbstractButton)):
        yield part.text()
    if isinstance(part, (QMenu, QGroupBox)):
        yield part.title()
    if isinstance(part, (QLineEdit, QPlainTextEdit)):
        yield part.placeholderText()
    if isinstance(part, QComboBox):
        yield from (part.itemText(k) for k in range(part.count()))
    if isinstance(part, (QSpinBox, QDoubleSpinBox)):
        yield from (part.prefix(), part.suffix())
    if isinstance(part, QAbstractSpinBox):
        yield part.specialValueText()
    if isinstance(part, QTabWidget):
        yield from (part.tabText(k) for k in range(part.count()))
    if isinstance(part, (QTableWidget, QListWidget)) and not isinstance(part.parentWidget(), ManualDialog):
        yield from _cells_of(part)
    if isinstance(part, pg.GraphicsView):
        yield from _texts_drawn_in(part)


def _cells_of(view: QTableWidget | QListWidget) -> Iterator[str]:
    """Yield what stands in a table or a list, and above and beside it."""
    model, n_columns = view.model(), view.columnCount() if isinstance(view, QTableWidget) else 1
    for role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole):
        for n, side in ((n_columns, Qt.Orientation.Horizontal), (model.rowCount(), Qt.Orientation.Vertical)):
            yield from (str(model.headerData(k, side, role) or "") for k in range(n))
        for row in range(model.rowCount()):
            yield from (str(model.index(row, k).data(role) or "") for k in range(n_columns))


def _texts_drawn_in(view: pg.GraphicsView) -> Iterator[str]:
    """Yield the labels of axes, and all texts that lie in a plot."""
    for item in view.scene().items():
        if isinstance(item, pg.AxisItem):
            yield item.labelText
        elif isinstance(item, pg.TextItem):
            yield item.toPlainText()
        elif isinstance(item, pg.LabelItem):
            yield item.text
