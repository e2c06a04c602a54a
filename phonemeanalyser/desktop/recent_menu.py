"""The menu of the sounds that were opened last."""

from functools import partial
from pathlib import Path

from PySide6.QtWidgets import QMenu, QWidget

from phonemeanalyser.desktop.dialogs import Dialogs


class RecentMenu(QMenu):
    """Opens one of the last sounds again."""

    def __init__(self, parent: QWidget, dialogs: Dialogs) -> None:
        super().__init__("Open Recent", parent)
        self._dialogs = dialogs
        dialogs.sound_opened.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Show them, the last one first."""
        self.clear()
        for path in self._dialogs.recent_sounds():
            self.addAction(path, partial(self._dialogs.open_sound, Path(path)))
        self.setEnabled(not self.isEmpty())
