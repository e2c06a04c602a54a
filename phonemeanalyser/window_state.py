"""What outlives the window: layout and choices, kept in the user's settings between two starts."""

import math
from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QByteArray, QSettings
from PySide6.QtWidgets import QAbstractButton, QMainWindow, QSplitter

from engine.settings import Channel
from phonemeanalyser.models.session import Session
from phonemeanalyser.views.time_view import TimeView

LAYOUT_VERSION = 1


class WindowState:
    """Keeps and restores the layout of a window, the session's choices, and what its switches say."""

    def __init__(
        self, window: QMainWindow, splitters: dict[str, QSplitter], switches: dict[str, QAbstractButton],
        settings: QSettings,
    ) -> None:  # fmt: skip
        self._settings = settings
        self._switches = switches
        self._savers: dict[str, Callable[[], QByteArray]] = {
            "geometry": window.saveGeometry,
            "layout": partial(window.saveState, LAYOUT_VERSION),
            **{name: splitter.saveState for name, splitter in splitters.items()},
        }
        self._restorers: dict[str, Callable[[QByteArray], object]] = {
            "geometry": window.restoreGeometry,
            "layout": partial(window.restoreState, version=LAYOUT_VERSION),
            **{name: splitter.restoreState for name, splitter in splitters.items()},
        }

    def save(self, session: Session, view: TimeView) -> None:
        """Keep everything for the next start."""
        keep = self._settings.setValue
        for name, save in self._savers.items():
            keep(name, save())
        for name, switch in self._switches.items():
            keep(name, int(switch.isChecked()))
        keep("volume", round(session.volume))
        keep("loop", int(session.loop))
        keep("channel", session.channel.value)
        keep("variable", view.variable.currentText())
        keep("colours", view.colours.currentText())
        keep("darkest", view.low.value())
        keep("brightest", view.high.value())

    def restore(self, session: Session, view: TimeView) -> None:
        """Take up everything of the last start; what was never kept stays as it is."""
        for name, restore in self._restorers.items():
            state = self._settings.value(name)
            if isinstance(state, QByteArray):
                restore(state)
        for name, switch in self._switches.items():
            switch.setChecked(self._kept(name, int(switch.isChecked())) == "1")
        session.set_volume(self._kept_number("volume", session.volume))
        session.set_loop(self._kept("loop", int(session.loop)) == "1")
        channels = {channel.value: channel for channel in Channel}
        session.set_channel(channels.get(self._kept("channel", session.channel.value), session.channel))
        view.variable.setCurrentText(self._kept("variable", view.variable.currentText()))
        view.colours.setCurrentText(self._kept("colours", view.colours.currentText()))
        view.low.setValue(round(self._kept_number("darkest", view.low.value())))
        view.high.setValue(round(self._kept_number("brightest", view.high.value())))

    def _kept_number(self, name: str, default: float) -> float:
        try:
            kept = float(self._kept(name, default))
        except ValueError:  # somebody edited the file
            return default
        return kept if math.isfinite(kept) else default

    def _kept(self, name: str, default: Any) -> str:
        return str(self._settings.value(name, default))
