"""The list of all keys, under Help."""

from itertools import combinations, pairwise

from PySide6.QtWidgets import QDialog, QLabel, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.widgets.builders import CLOSE, ScrolledDown, column, dialog_buttons, label

HEAD = [
    (tr_noop("Orbit; with Shift, pan"), tr_noop("Arrows")),
    (tr_noop("Zoom in, zoom out"), "+, −"),
    (tr_noop("Fit to view"), tr_noop("Home")),
    (tr_noop("Wireframe"), "W"),
    (tr_noop("Move light"), tr_noop("Comma, full stop")),
    (tr_noop("Hold mouth shape"), "Q S H M P I A E U O"),
]
KEYS = [
    (tr_noop("Raise, lower key; with Shift, farther"), tr_noop("Up, Down")),
    (tr_noop("Move key by one picture"), tr_noop("Left, Right")),
    (tr_noop("Mark range"), tr_noop("Shift+Left, Shift+Right")),
    (tr_noop("Smooth, raise or lower range"), tr_noop("Menu key")),
    (tr_noop("Previous, next key; with Ctrl, curve"), tr_noop("Page Up, Page Down")),
    (tr_noop("Delete key"), tr_noop("Del")),
]
CALIBRATE = [
    (tr_noop("Guided calibration"), "G"),
    (tr_noop("Record take while held"), "Q S H M P I A E U O"),
    (tr_noop("Set start, end of the range"), "[, ]"),
    (tr_noop("Play take"), tr_noop("Return")),
    (tr_noop("Exclude or include take"), "X"),
    (tr_noop("Delete take"), tr_noop("Del")),
]
GUIDE = [
    (tr_noop("Start"), tr_noop("Return")),
    (tr_noop("Repeat previous sound"), tr_noop("Backspace")),
    (tr_noop("Repeat this sound"), "R"),
    (tr_noop("Skip"), tr_noop("Right")),
    (tr_noop("Use New Preset"), tr_noop("Return")),
    (tr_noop("End guided calibration"), tr_noop("Esc")),
]
N_COLUMNS = (3, 2)
"""Of the list, and of one that would be wider than the screen."""
HIGHEST, EDGES = 640, 60
"""Pixels; what does not fit into a small window is scrolled. Those that frame, margins and scroll bar take."""


class ShortcutsDialog(QDialog):
    """Lists the keys by menu.

    Parameters
    ----------
    menus : for each menu, the entries' texts and keys.
    """

    def __init__(self, menus: dict[str, list[tuple[str, str]]], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Keyboard Shortcuts"))
        blocks = [_block(title, [(text, key) for text, key in entries if key]) for title, entries in menus.items()]
        blocks.append(_block(tr("Sliders and timeline"), [(tr("One step; with Shift, a tenth"), tr("Left, Right"))]))
        blocks.append(_block(tr("Custom variable"), [(tr("Discard the marked range"), tr("Esc"))]))
        blocks.append(_block(tr("Calibrate page"), CALIBRATE))
        blocks.append(_block(tr("Guided calibration"), GUIDE))
        blocks.append(_block(tr("Head, while it has the focus"), HEAD))
        blocks.append(_block(tr("Keys of blend shapes, while they have the focus"), KEYS))
        room = self.screen().availableSize().width() - EDGES
        for n_columns in N_COLUMNS:
            self.list = QLabel(_side_by_side([block for block in blocks if block], n_columns))
            if self.list.sizeHint().width() <= room:
                break
        scope = label(
            tr(
                "Menu shortcuts that are single letters, Delete, F2 or use Shift work on the Analyse page only. "
                "While a list, number or text field has the focus, letters go to that field: click a plot to "
                "leave it."
            ),
            wraps=True,
        )
        scroll = ScrolledDown()
        scroll.show_body(self.list)
        rows = column((scroll, 1), scope, dialog_buttons(self, CLOSE), on=self, margins=None)
        width = self.sizeHint().width()
        height = rows.totalHeightForWidth(width) - scroll.sizeHint().height() + self.list.sizeHint().height()
        self.resize(width, min(height, HIGHEST))


def _block(title: str, keys: list[tuple[str, str]]) -> list[str]:
    """Return the rows of a menu; none where it has no key."""
    rows = [f"<tr><td>{tr(text)}&nbsp;&nbsp;&nbsp;</td><td>{tr(key)}</td></tr>" for text, key in keys]
    return [f"<tr><td colspan=2><br><b>{title}</b></td></tr>", *rows] if rows else []


def _side_by_side(blocks: list[list[str]], n_columns: int) -> str:
    """Lay blocks of rows out in columns, the highest of which is as low as it can be."""
    ways = [(0, *cuts, len(blocks)) for cuts in combinations(range(1, len(blocks)), n_columns - 1)]
    parts = [[blocks[start:end] for start, end in pairwise(cuts)] for cuts in ways]
    best = min(parts, key=lambda part: max(sum(map(len, column)) + len(column) for column in part))
    columns = [[row for block in part for row in block] for part in best]
    cells = "<td width=24></td>".join(
        f"<td><table cellspacing=0>{''.join(column)}</table></td>" for column in columns
    )
    return f"<table><tr>{cells}</tr></table>"
