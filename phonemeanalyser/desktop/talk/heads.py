"""The heads of a window: on its pages, once they are there, and in a dock."""

from phonemeanalyser.desktop.talk.head_view import HeadView
from phonemeanalyser.desktop.talk.model import TalkModel


class Heads:
    """Moves the heads that are seen."""

    def __init__(self, talking: TalkModel) -> None:
        self._talking = talking
        self._views: dict[str, HeadView] = {}

    def add(self, name: str, view: HeadView) -> HeadView:
        """Move this one too, which is called so in every window."""
        self._views[name] = view
        return view

    def move(self, *, frozen: bool) -> None:
        """Have the head say what is heard, where it is seen."""
        seen = [view for view in self._views.values() if view.isVisible()]
        self._talking.watch(bool(seen) and not frozen)
        self._talking.tick()
        for view in seen:
            if not frozen:
                view.refresh()

    def copy_view_from(self, other: "Heads") -> None:
        """Show the heads from where another window shows them."""
        for name, view in self._views.items():
            if name in other._views:
                view.copy_view_from(other._views[name])

    def release_gl(self) -> None:
        """Give everything back to the graphics driver."""
        for view in self._views.values():
            view.release_gl()
