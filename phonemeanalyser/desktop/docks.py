"""The docks of the window, which are seen beside its first page only."""

import math
from collections.abc import Mapping, Sequence
from typing import cast

from PySide6.QtCore import QChildEvent, QEvent, QObject, Qt, QTimer
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDockWidget, QMainWindow, QTabBar, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.builders import Scrolled, column, leave_wheel

_MOVES = {QEvent.Type.Resize, QEvent.Type.Move, QEvent.Type.Show, QEvent.Type.Hide, QEvent.Type.LayoutRequest}


class Docks(QObject):
    """Adds docks to a window, and puts them away while a page is seen that has none.

    Parameters
    ----------
    narrow : a window that is narrower than this, pixels, has no room for docks on both sides.

    Attributes
    ----------
    stacked : whether a dock lies behind another one since the window is narrow, and not since the user put it there.
    """

    def __init__(self, window: QMainWindow, narrow: int) -> None:
        super().__init__(window)
        self.stacked = False
        self._window = window
        self._narrow = narrow
        self._fitted_for = math.inf
        self._fits = False
        self._wide: dict[QDockWidget, int] = {}
        self._docks: dict[str, QDockWidget] = {}
        self._away: dict[QDockWidget, int] = {}
        self._in_front: list[QDockWidget] = []
        self._moved = QTimer(self)
        self._moved.setSingleShot(True)
        self._moved.timeout.connect(self._hide_stale_tabs)
        window.installEventFilter(self)

    def add(self, title: str, area: Qt.DockWidgetArea, *views: QWidget) -> QDockWidget:
        """Add a dock of a title, in English, with views one below the other."""
        dock = self._docks[title] = QDockWidget(tr(title), self._window)
        dock.setObjectName(title)
        body = QWidget()
        column(*views, on=body, spacing=0)
        scrolled = Scrolled(body)
        scrolled.setSizePolicy(views[-1].sizePolicy())
        dock.setWidget(scrolled)
        self._window.addDockWidget(area, dock)
        dock.installEventFilter(self)
        return dock

    def add_behind(self, other: QDockWidget, title: str, *views: QWidget) -> QDockWidget:
        """Add a dock as a tab behind another one; see `add`."""
        dock = self.add(title, self._window.dockWidgetArea(other), *views)
        self._window.tabifyDockWidget(other, dock)
        other.raise_()
        return dock

    def show(self, dock: QDockWidget) -> None:
        """Show a dock, before those that lie at its place."""
        dock.show()
        dock.raise_()

    def bring_forward(self, dock: QDockWidget) -> None:
        """Show a dock before those that hide it, unless the user has closed it."""
        if not dock.isHidden():
            dock.raise_()

    def focus_next(self, step: int, main_view: QWidget) -> None:
        """Give the focus to the next dock that is seen (1), or the one before (-1), or to what they lie beside."""
        in_front = [dock for dock in self._docks.values() if not dock.visibleRegion().isEmpty()]
        seen = sorted(in_front, key=lambda dock: (dock.x(), dock.y()))
        now = self._window.focusWidget()
        here = next((k for k, dock in enumerate(seen, 1) if now is not None and dock.isAncestorOf(now)), 0)
        at = (here + step) % (len(seen) + 1)
        controls = seen[at - 1].widget().findChildren(QWidget) if at else []
        first = (w for w in controls if w.isVisible() and w.isEnabled() and w.focusPolicy() & Qt.FocusPolicy.TabFocus)
        next(first, main_view).setFocus(Qt.FocusReason.TabFocusReason)

    def laid_out_for(self, width: float, *, stacked: bool) -> None:
        """Take docks as they are as the layout for a window of this many pixels."""
        self._fitted_for, self.stacked = width, stacked

    def fit(self, docks: Sequence[QDockWidget], on: QDockWidget) -> None:
        """Put the docks at the left behind one at the right when the window becomes narrow, and back when it is wide.

        Parameters
        ----------
        docks : those at the left, one behind the other.
        on : the one at the right.
        """
        before, width = self._fitted_for, self._window.width()
        self._fitted_for, self._fits = width, True
        if before >= self._narrow > width:
            self._stack(docks, on)
        elif self._narrow <= width and before < width:
            if self.stacked:
                self.stacked = False
                self._put_left(docks)
            at_left = max(self._wide.get(dock, 0) for dock in docks)  # they have one place
            wide = {**self._wide, **dict.fromkeys(docks, at_left)}
            # one that lies behind another knows no width of its own but that of before it was laid out
            shown = [dock for dock in wide if dock in docks or not dock.visibleRegion().isEmpty()]
            self.resize(
                {dock: wide[dock] for dock in shown if wide[dock] and not (dock.isHidden() or dock.isFloating())}
            )
        self._fits = False

    def _stack(self, docks: Sequence[QDockWidget], on: QDockWidget) -> None:
        left, right = Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea
        at_left = [dock for dock in docks if self._is_seen_at(dock, left)]
        if not at_left or not self._is_seen_at(on, right):
            return
        self.stacked = True
        for dock in at_left:
            self._window.tabifyDockWidget(on, dock)
        on.raise_()
        self.resize({on: self._wide.get(on, on.width())})

    def _is_seen_at(self, dock: QDockWidget, side: Qt.DockWidgetArea) -> bool:
        return self._window.dockWidgetArea(dock) is side and not dock.isHidden() and not dock.isFloating()

    def _put_left(self, docks: Sequence[QDockWidget]) -> None:
        """Put docks at the left, one behind the other, the first in front."""
        first, *others = [dock for dock in docks if not dock.isFloating()] or docks
        self._window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, first)
        for dock in others:
            self._window.tabifyDockWidget(first, dock)
        first.raise_()

    @override
    def eventFilter(self, dock: QObject, event: QEvent) -> bool:
        """Note how wide the user has a dock while there is room for all; while the window grows, that is not he.

        The tabs of docks that lie behind one another are Qt's, and get a name for screen readers.
        """
        if isinstance(event, QChildEvent) and event.polished() and isinstance(event.child(), QTabBar):
            tabs = cast("QTabBar", event.child())
            tabs.setAccessibleName(tr("Tabs of the docks"))
            tabs.setObjectName("DockTabs")
            tabs.setElideMode(Qt.TextElideMode.ElideNone)  # in a narrow dock they scroll: "Sch…" says nothing
            tabs.setUsesScrollButtons(True)
            leave_wheel(tabs)
        if event.type() in _MOVES:
            self._moved.start(0)
        by_user = self._narrow <= self._window.width() == self._fitted_for and not self._fits
        if event.type() == QEvent.Type.Resize and isinstance(dock, QDockWidget) and by_user and not dock.isFloating():
            self._wide[dock] = dock.width()
        return False

    def _hide_stale_tabs(self) -> None:
        """Hide the tab bars that lie below no dock.

        When a layout is restored or a second pair of docks tabbed, Qt 6.11 makes new tab bars, forgets the old ones
        and leaves them where they were.
        """
        below = [dock.geometry() for dock in self._docks.values() if dock.isVisible() and not dock.isFloating()]
        places = {(place.x(), place.bottom() + 1, place.width()) for place in below}
        direct = Qt.FindChildOption.FindDirectChildrenOnly
        for tabs in reversed(self._window.findChildren(QTabBar, "DockTabs", direct)):
            if tabs.count() > 1:
                place = tabs.x(), tabs.y(), tabs.width()
                tabs.setVisible(place in places)
                places.discard(place)  # of two at one place the newer one is in use

    def end(self) -> None:
        """Look no more: the window closes, and lays its docks out once more while it is destroyed."""
        for watched in (self._window, *self._docks.values()):
            watched.removeEventFilter(self)
        self._moved.stop()

    def prefer(self, widths: Mapping[QDockWidget, int]) -> None:
        """Give some docks other widths, pixels, or what all of them needs; they get these whenever there is room."""
        for dock, width in widths.items():
            self._wide[dock] = max(width, *(scrolled.needed_width for scrolled in dock.findChildren(Scrolled)))
        self.resize({dock: self._wide[dock] for dock in widths})

    def resize(self, widths: Mapping[QDockWidget, int]) -> None:
        """Give some docks other widths, pixels."""
        self._window.resizeDocks(list(widths), list(widths.values()), Qt.Orientation.Horizontal)

    def switches(self, keys: Mapping[str, str]) -> list[QAction]:
        """Return what shows and hides each dock, with keys by title; one that lies behind another is raised."""
        return [self._switch_of(title, dock, keys.get(title, "")) for title, dock in self._docks.items()]

    def _switch_of(self, title: str, dock: QDockWidget, key: str) -> QAction:
        switch = QAction(tr(title), dock)
        switch.setCheckable(True)
        switch.setChecked(not dock.isHidden())
        switch.setShortcut(key)
        dock.visibilityChanged.connect(switch.setChecked)
        switch.triggered.connect(lambda on: self.show(dock) if on else dock.hide())
        return switch

    def put_away(self) -> None:
        """Hide all docks until they are brought back."""
        laid_out = self._window.isVisible()
        shown = [dock for dock in self._docks.values() if not dock.isHidden()]
        self._in_front = [dock for dock in shown if not dock.visibleRegion().isEmpty()]
        self._away = {dock: dock.width() if laid_out and dock in self._in_front else 0 for dock in shown}
        for dock in self._docks.values():
            dock.hide()

    def bring_back(self) -> None:
        """Show those again that were seen when all were put away, as wide as they were."""
        away, self._away = self._away, {}
        for dock in away:
            dock.show()
        for dock in self._in_front:
            dock.raise_()
        known = {dock: width for dock, width in away.items() if width}
        if known:
            self.resize(known)
