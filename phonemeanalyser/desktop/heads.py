"""The heads of a window: those of the pages, once they are there, and that of the dock."""

from phonemeanalyser.desktop.calibrate.page import CalibrationPage
from phonemeanalyser.desktop.talk.head_view import HeadView
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.page import TalkPage
from phonemeanalyser.desktop.widgets.pages import LazyPage


class Heads:
    """Moves the heads that are seen."""

    def __init__(
        self, talking: TalkModel, page: LazyPage[TalkPage], calibrating: LazyPage[CalibrationPage],
        docked: HeadView,
    ) -> None:  # fmt: skip
        self._talking = talking
        self._page = page
        self._calibrating = calibrating
        self._docked = docked

    def move(self, *, frozen: bool) -> None:
        """Have the head say what is heard, where it is seen."""
        made = self._calibrating.made
        heads = (self._page.made, made.guide.head if made is not None else None, self._docked)
        seen = [view for view in heads if view is not None and view.isVisible()]
        self._talking.watch(bool(seen) and not frozen)
        self._talking.tick()
        for view in seen:
            if not frozen:
                view.refresh()

    def copy_view_from(self, other: "Heads") -> None:
        """Show the heads from where another window shows them."""
        if other._page.made is not None:
            self._page.get().head.copy_view_from(other._page.made.head)
        self._docked.copy_view_from(other._docked)

    def release_gl(self) -> None:
        """Return everything back to the graphics driver."""
        if self._page.made is not None:
            self._page.made.head.release_gl()
        if self._calibrating.made is not None:
            self._calibrating.made.guide.head.release_gl()
        self._docked.release_gl()
