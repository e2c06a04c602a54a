"""Files that are dropped on the window."""

from pathlib import Path

from PySide6.QtCore import QMimeData

from phonemeanalyser.desktop.dialogs import Dialogs
from phonemeanalyser.desktop.talk.dialogs import TalkDialogs


def open_dropped(mime: QMimeData, dialogs: Dialogs, talking: TalkDialogs) -> None:
    """Open what was dropped: meshes and movestates as one face, everything else for itself."""
    paths = [Path(url.toLocalFile()) for url in mime.urls() if url.isLocalFile()]
    talking.open([path for path in paths if talking.opens(path)])
    for path in paths:
        if not talking.opens(path):
            dialogs.open_any(path)
    for url in mime.urls():
        if not url.isLocalFile():
            dialogs.rejected.emit(f"{url.toString()}: only files on this computer can be opened; save it here first")
