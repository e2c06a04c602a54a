"""The list of all keys, under Help."""

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QLabel, QVBoxLayout, QWidget

HEAD = [
    ("Go round; with Shift move it", "Arrows"), ("Nearer, farther", "+, −"), ("The whole of it", "Home"),
    ("Wireframe", "W"), ("Move the light", "Comma, full stop"), ("Hold a mouth shape", "Q S H M P I A E U O"),
]  # fmt: skip
TEXT = [
    ("Say the text", "Ctrl+Return"), ("Stop saying it", "Esc"), ("Align it with the sound", "Ctrl+Shift+Return"),
]  # fmt: skip
CALIBRATE = [
    ("Guided calibration", "G"), ("Record a take while held", "Q S H M P I A E U O"),
    ("Mark where a stretch begins, ends", "[, ]"), ("Play the take", "Return"), ("Exclude the take, or not", "X"),
    ("Delete the take", "Delete"),
]  # fmt: skip
GUIDE = [
    ("Say the sound before once more", "Backspace"), ("Say this sound once more", "R"), ("Go on without it", "Right"),
    ("Use the new preset", "Return"), ("End the guide", "Esc"),
]  # fmt: skip
N_COLUMNS = 3


class ShortcutsDialog(QDialog):
    """Lists the keys by menu.

    Parameters
    ----------
    menus : for each menu, the entries' texts and keys.
    """

    def __init__(self, menus: dict[str, list[tuple[str, str]]], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle("Keyboard shortcuts")
        blocks = [_block(title, [(text, key) for text, key in entries if key]) for title, entries in menus.items()]
        blocks.append(_block("Sliders and time line", [("A step; with Shift a tenth", "Left, Right")]))
        blocks.append(_block("A variable of your own", [("Drop the range that is marked", "Esc")]))
        blocks.append(_block("The page Calibrate", CALIBRATE))
        blocks.append(_block("Guided calibration", GUIDE))
        blocks.append(_block("The head, when it has the focus", HEAD))
        blocks.append(_block("The text below the head", TEXT))
        self.list = QLabel(_side_by_side([block for block in blocks if block]))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addWidget(self.list)
        layout.addWidget(buttons)


def _block(title: str, keys: list[tuple[str, str]]) -> list[str]:
    """Return the rows of a menu; none where it has no key."""
    rows = [f"<tr><td>{text}&nbsp;&nbsp;&nbsp;</td><td>{key}</td></tr>" for text, key in keys]
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
