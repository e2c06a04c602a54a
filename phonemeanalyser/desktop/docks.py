"""The docks of the window, which are seen beside its first page only."""

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDockWidget, QMainWindow, QVBoxLayout, QWidget

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.scrolled import Scrolled


class Docks:
    """Adds docks to a window, and puts them away while a page is seen that has none."""

    def __init__(self, window: QMainWindow) -> None:
        self._window = window
        self._docks: dict[str, QDockWidget] = {}
        self._away: dict[QDockWidget, int] = {}
        self._in_front: list[QDockWidget] = []

    def add(self, title: str, area: Qt.DockWidgetArea, *views: QWidget) -> QDockWidget:
        """Add a dock of a title, in English, with views one below the other."""
        dock = self._docks[title] = QDockWidget(tr(title), self._window)
        dock.setObjectName(title)
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        for view in views:
            column.addWidget(view)
        scrolled = Scrolled(body)
        scrolled.setSizePolicy(views[-1].sizePolicy())
        dock.setWidget(scrolled)
        self._window.addDockWidget(area, dock)
        return dock

    def stack(self, dock: QDockWidget, on: QDockWidget) -> None:
        """Put a dock behind another one, where both are in the window."""
        if dock.isHidden() or dock.isFloating() or on.isHidden() or on.isFloating():
            return
        self._window.tabifyDockWidget(on, dock)
        on.raise_()

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
