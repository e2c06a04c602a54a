"""Starts the program as its command does, and ends it as soon as the window has been painted once.

Imports nothing that the program would not: what this module costs is counted as the program's.
"""

import gc
import os
import sys

gc.disable()  # as the program does before it imports Qt

from phonemeanalyser.cli.main import main  # noqa: E402, I001 - in the order in which the program imports
from phonemeanalyser.desktop.app import make_application  # noqa: E402
from PySide6.QtCore import QEvent, QObject, QSettings, QTimer  # noqa: E402


class Watch(QObject):
    """Ends the process after the paint event of a whole window.

    It looks at all events only until there is a window: the 16 000 of the start would cost 50 ms.
    """

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Wait for the window's paint event; its children are painted before the timer fires."""
        if watched.inherits("QMainWindow"):
            app.removeEventFilter(self)
            watched.installEventFilter(self)
            if event.type() == QEvent.Type.Paint:
                QTimer.singleShot(0, lambda: os._exit(0))
        return False


if __name__ == "__main__":
    if len(sys.argv) != 2 or not os.path.isdir(sys.argv[1]):  # noqa: PTH112 - pathlib would be counted
        sys.exit("usage: python -m tools.bench.first_paint FOLDER, of settings, which must be there")
    QSettings.setDefaultFormat(QSettings.Format.IniFormat)
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, sys.argv[1])
    app = make_application()
    watch = Watch()
    app.installEventFilter(watch)
    sys.exit(main([]))
