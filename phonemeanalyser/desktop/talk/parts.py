"""What a window has of the Talk page beside the page itself."""

from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QMainWindow, QMenu

from phonemeanalyser.desktop.menus import Menus
from phonemeanalyser.desktop.talk.commands import fill_talk_menu, show_talk
from phonemeanalyser.desktop.talk.dialogs import TalkDialogs
from phonemeanalyser.desktop.talk.head.head_view import HeadView
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.page import Heads, TalkPage
from phonemeanalyser.desktop.talk.words.spoken_lanes import spoken_lanes
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeanalyser.desktop.widgets.lanes import Lane


class TalkParts:
    """The dialogs, the heads and the menu; the menu is filled.

    Attributes
    ----------
    model : what they show.
    dialogs : ask what the page needs.
    heads : move all that are seen.
    """

    def __init__(
        self, window: QMainWindow, model: TalkModel, theme: Theme, settings: QSettings, files: FileAsker,
        menus: Menus, menu: QMenu,
    ) -> None:  # fmt: skip
        self.model, self._theme, self._menus = model, theme, menus
        self.dialogs = TalkDialogs(window, model, settings, files)
        self.heads = Heads(model)
        fill_talk_menu(menus, menu, model, self.dialogs, window)

    def add_head(self, name: str) -> HeadView:
        """Return a head that moves where it is seen; it is called so in every window."""
        return self.heads.add(name, HeadView(self.model.head, self._theme))

    def make_page(self) -> TalkPage:
        """Return the page, whose head moves where it is seen."""
        page = TalkPage(self.model, self._theme)
        self.dialogs.join(page)
        self.heads.add("page", page.head, page)
        return page

    def show(self) -> list[Lane]:
        """Show in the menu what can be done with the text now; return the lanes of what is said."""
        show_talk(self._menus, self.model)
        return spoken_lanes(self.model.text)
