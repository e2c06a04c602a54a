"""The list of all keys, under Help."""

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QLabel, QVBoxLayout, QWidget


class ShortcutsDialog(QDialog):
    """Lists the keys by menu.

    Parameters
    ----------
    menus : for each menu, the entries' texts and keys.
    """

    def __init__(self, menus: dict[str, list[tuple[str, str]]], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle("Keyboard shortcuts")
        rows = []
        for title, entries in menus.items():
            keys = [(text, key) for text, key in entries if key]
            if keys:
                rows.append(f"<tr><td colspan=2><br><b>{title}</b></td></tr>")
                rows += [f"<tr><td>{text}&nbsp;&nbsp;&nbsp;</td><td>{key}</td></tr>" for text, key in keys]
        rows.append("<tr><td colspan=2><br><b>Sliders and time line</b></td></tr>")
        rows.append("<tr><td>A step; with Shift a tenth&nbsp;&nbsp;</td><td>Left, Right</td></tr>")
        self.list = QLabel(f"<table>{''.join(rows)}</table>")
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addWidget(self.list)
        layout.addWidget(buttons)
