"""The docks of the window, which are seen beside its first page only."""

import math
from collections.abc import Mapping

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDockWidget, QMainWindow, QWidget

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.builders import Scrolled, column


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

    def laid_out_for(self, width: float, *, stacked: bool) -> None:
        """Take docks as they are for laid out for a window of so many pixels."""
        self._fitted_for, self.stacked = width, stacked

    def fit(self, dock: QDockWidget, on: QDockWidget) -> None:
        """Put a dock behind one at the other side when the window becomes narrow, and back when it becomes wide."""
        before, width = self._fitted_for, self._window.width()
        self._fitted_for, self._fits = width, True
        if before >= self._narrow > width:
            self._stack(dock, on)
        elif self._narrow <= width and before < width:
            if self.stacked:
                self.stacked = False
                self._window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, dock)
            self.resize({seen: w for seen, w in self._wide.items() if not seen.isHidden() and not seen.isFloating()})
        self._fits = False

    def _stack(self, dock: QDockWidget, on: QDockWidget) -> None:
        left, right = Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea
        sides = self._window.dockWidgetArea(dock), self._window.dockWidgetArea(on)
        if sides != (left, right) or any(d.isHidden() or d.isFloating() for d in (dock, on)):
            return
        self.stacked = True
        self._window.tabifyDockWidget(on, dock)
        on.raise_()
        self.resize({on: self._wide.get(on, on.width())})

    def eventFilter(self, dock: QObject, event: QEvent) -> bool:
        """Note how wide the user has a dock while there is room for all; while the window grows, that is not he."""
        by_user = self._narrow <= self._window.width() == self._fitted_for and not self._fits
        if event.type() == QEvent.Type.Resize and isinstance(dock, QDockWidget) and by_user and not dock.isFloating():
            self._wide[dock] = dock.width()
        return False

    def end(self) -> None:
        """Look no more: the window closes, and lays its docks out once more while it is destroyed."""
        for dock in self._docks.values():
            dock.removeEventFilter(self)

    def prefer(self, widths: Mapping[QDockWidget, int]) -> None:
        """Give some docks other widths, pixels, or what all of them needs; they get these whenever there is room."""
        for dock, width in widths.items():
            self._wide[dock] = max(width, *(scrolled.needed_width for scrolled in dock.findChildren(Scrolled)))
        self.resize({dock: self._wide[dock] for dock in widths})

    def resize(self, widths: Mapping[QDockWidget, int]) -> None:
        """Give some docks other widths, pixels."""
        self._window.resizeDocks(list(widths), list(widths.values()), Qt.Orientation.Horizontal)

    def switches(self, keys: Mapping[str, str]) -> list[QAction]:
        """Return what shows and hides each dock, with the keys by the docks' titles."""
        actions = {title: dock.toggleViewAction() for title, dock in self._docks.items()}
        for title, action in actions.items():
            action.setShortcut(keys.get(title, ""))
        return list(actions.values())

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
