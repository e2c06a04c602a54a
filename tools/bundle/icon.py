"""The program's icon as pixels, from which PyInstaller makes what each system wants."""

import os
from pathlib import Path

SIZE = 512


def write_icon(out: Path) -> None:
    """Write the icon as a PNG of `SIZE` x `SIZE` pixels."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from PySide6.QtGui import QGuiApplication, QIcon

    from phonemeanalyser.desktop.app import ICON

    app = QGuiApplication.instance() or QGuiApplication([])
    assert QIcon(str(ICON)).pixmap(SIZE, SIZE).save(str(out)), out
    del app
