"""The heads of a window: on its pages, once they are there, and in a dock."""

from phonemeanalyser.desktop.talk.head.head_view import HeadView
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.page import TalkPage


class Heads:
    """Moves the heads that are seen."""

    def __init__(self, talking: TalkModel) -> None:
        self._talking = talking
        self._heads: dict[str, HeadView] = {}
        self._views: list[HeadView | TalkPage] = []

    def add(self, name: str, head: HeadView, page: TalkPage | None = None) -> HeadView:
        """Move this one too, with all of its page; it is called so in every window."""
        self._heads[name] = head
        self._views.append(page or head)
        return head

    def move(self, *, frozen: bool) -> None:
        """Have the head say what is heard, where it is seen."""
        seen = [view for view in self._views if view.isVisible()]
        self._talking.watch(bool(seen) and not frozen)
        self._talking.tick()
        for view in seen:
            if not frozen:
                view.refresh()

    def copy_view_from(self, other: "Heads") -> None:
        """Show the heads from where another window shows them."""
        for name, head in self._heads.items():
            if name in other._heads:
                head.copy_view_from(other._heads[name])

    def release_gl(self) -> None:
        """Give everything back to the graphics driver."""
        for head in self._heads.values():
            head.release_gl()
