"""The list of all keys, under Help."""

from PySide6.QtWidgets import QDialog, QLabel, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.widgets.builders import CLOSE, column, dialog_buttons, label

HEAD = [
    (tr_noop("Go round; with Shift move it"), tr_noop("Arrows")),
    (tr_noop("Nearer, farther"), "+, −"),
    (tr_noop("The whole of it"), tr_noop("Home")),
    (tr_noop("Wireframe"), "W"),
    (tr_noop("Move the light"), tr_noop("Comma, full stop")),
    (tr_noop("Hold a mouth shape"), "Q S H M P I A E U O"),
]
TEXT = [
    (tr_noop("Say the text"), tr_noop("Ctrl+Return")),
    (tr_noop("Stop saying it"), tr_noop("Esc")),
    (tr_noop("Align it with the sound"), tr_noop("Ctrl+Shift+Return")),
]
CALIBRATE = [
    (tr_noop("Guided calibration"), "G"),
    (tr_noop("Record a take while held"), "Q S H M P I A E U O"),
    (tr_noop("Mark where a stretch begins, ends"), "[, ]"),
    (tr_noop("Play the take"), tr_noop("Return")),
    (tr_noop("Exclude the take, or not"), "X"),
    (tr_noop("Delete the take"), tr_noop("Delete")),
]
GUIDE = [
    (tr_noop("Start"), tr_noop("Return")),
    (tr_noop("Say the sound before once more"), tr_noop("Backspace")),
    (tr_noop("Say this sound once more"), "R"),
    (tr_noop("Go on without it"), tr_noop("Right")),
    (tr_noop("Use the new preset"), tr_noop("Return")),
    (tr_noop("End the guide"), tr_noop("Esc")),
]
N_COLUMNS = 3


class ShortcutsDialog(QDialog):
    """Lists the keys by menu.

    Parameters
    ----------
    menus : for each menu, the entries' texts and keys.
    """

    def __init__(self, menus: dict[str, list[tuple[str, str]]], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Keyboard shortcuts"))
        blocks = [_block(title, [(text, key) for text, key in entries if key]) for title, entries in menus.items()]
        blocks.append(_block(tr("Sliders and time line"), [(tr("A step; with Shift a tenth"), tr("Left, Right"))]))
        blocks.append(_block(tr("A variable of your own"), [(tr("Drop the range that is marked"), tr("Esc"))]))
        blocks.append(_block(tr("The page Calibrate"), CALIBRATE))
        blocks.append(_block(tr("Guided calibration"), GUIDE))
        blocks.append(_block(tr("The head, when it has the focus"), HEAD))
        blocks.append(_block(tr("The text below the head"), TEXT))
        self.list = QLabel(_side_by_side([block for block in blocks if block]))
        scope = label(
            tr(
                "In the menus, single letters, Delete, F2 and keys with Shift act on the page Analyse only. Where a "
                "list, a number or a text has the focus, letters belong to that: click into a plot to leave it."
            ),
            wraps=True,
        )
        column(self.list, scope, dialog_buttons(self, CLOSE), on=self, margins=None)


def _block(title: str, keys: list[tuple[str, str]]) -> list[str]:
    """Return the rows of a menu; none where it has no key."""
    rows = [f"<tr><td>{tr(text)}&nbsp;&nbsp;&nbsp;</td><td>{tr(key)}</td></tr>" for text, key in keys]
    return [f"<tr><td colspan=2><br><b>{title}</b></td></tr>", *rows] if rows else []


def _side_by_side(blocks: list[list[str]]) -> str:
    """Lay blocks of rows out in columns of about the same height."""
    columns: list[list[str]] = [[] for _ in range(N_COLUMNS)]
    n_rows = sum(map(len, blocks))
    for block in blocks:
        middle = sum(map(len, columns)) + len(block) // 2
        columns[N_COLUMNS * middle // n_rows].extend(block)
    cells = "<td width=24></td>".join(
        f"<td><table cellspacing=0>{''.join(column)}</table></td>" for column in columns
    )
    return f"<table><tr>{cells}</tr></table>"
