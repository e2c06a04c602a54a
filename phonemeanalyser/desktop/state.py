"""What outlives the window: layout and choices, kept in the user's settings between two starts."""

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import Any

from PySide6.QtCore import QByteArray, QSettings
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QComboBox, QMainWindow, QSplitter

from phonemeanalyser.desktop.analyse.page import AnalysisPage
from phonemeanalyser.desktop.session.microphone import SUFFIXES, Microphone
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.settings import Kept, keep, read
from phonemeengine.errors import SettingsError

LAYOUT_VERSION = 2
OF_MICROPHONE = {
    "microphone": "label",
    "microphone_channel": "channel",
    "microphone_rate": "rate",
    "microphone_latency": "latency",
    "microphone_else_default": "else_default",
}
"""Under which key which field of an `InputChoice` is kept."""


class WindowState:
    """Keeps and restores the layout of a window, the session's choices, and what its switches say."""

    def __init__(
        self,
        window: QMainWindow,
        splitters: dict[str, QSplitter],
        switches: dict[str, QAbstractButton | QAction],
        choices: dict[str, QComboBox],
        settings: QSettings,
    ) -> None:
        self._window = window
        self._settings = settings
        self._switches, self._choices = switches, choices
        self._savers: dict[str, Callable[[], QByteArray]] = {
            "geometry": window.saveGeometry,
            **{name: splitter.saveState for name, splitter in splitters.items()},
        }
        self._restorers: dict[str, Callable[[QByteArray], object]] = {
            "geometry": window.restoreGeometry,
            "layout": partial(window.restoreState, version=LAYOUT_VERSION),
            **{name: splitter.restoreState for name, splitter in splitters.items()},
        }
        self._untouched: dict[str, QByteArray] = {}

    def reset(self) -> None:
        """Lay out docks, bars and splitters as they were before they were moved."""
        for name, state in self._untouched.items():
            self._restorers[name](state)
        self._settings.remove("layout_width")

    def save_docks(self, *, stacked: bool) -> None:
        """Keep where docks and bars are, while they are seen, and how wide the window is that they are in.

        `stacked` says whether one lies behind another only since the window is narrow.
        """
        self._settings.setValue("layout", self._window.saveState(LAYOUT_VERSION))
        keep(self._settings, "layout_width", self._window.width())
        keep(self._settings, "layout_stacked", stacked)

    def docks_stacked(self) -> bool:
        """Return whether a dock was behind another one only since the window was narrow."""
        return read(self._settings, "layout_stacked", False)

    def docks_width(self) -> float:
        """Return the width of the window for which docks were laid out, pixels; infinite where they never were."""
        kept = read(self._settings, "layout_width", 0.0)
        return kept if kept > 0 else math.inf

    def save_page(self, number: int) -> None:
        """Keep which page is seen."""
        keep(self._settings, "page", number)

    def page(self) -> int:
        """Return the number of the page that was seen last."""
        return read(self._settings, "page", 0)

    def save(self, session: Session, page: AnalysisPage) -> None:
        """Keep everything else for the next start."""
        for name, save in self._savers.items():
            self._settings.setValue(name, save())
        for choice in self._kept(session, page):
            choice.save(self._settings)
        for key, field in OF_MICROPHONE.items():
            keep(self._settings, key, getattr(session.microphone.choice, field))

    def restore(self, session: Session, page: AnalysisPage) -> None:
        """Take up everything of the last start; what was never kept stays as it is."""
        self._untouched = {name: save() for name, save in self._savers.items() if name != "geometry"}
        self._untouched["layout"] = self._window.saveState(LAYOUT_VERSION)
        for name, restore in self._restorers.items():
            state = self._settings.value(name)
            if isinstance(state, QByteArray):
                restore(state)
        for choice in self._kept(session, page):
            choice.restore(self._settings)
        chosen = session.microphone.choice
        kept = {field: read(self._settings, key, getattr(chosen, field)) for key, field in OF_MICROPHONE.items()}
        with suppress(SettingsError):  # the file was edited by hand
            session.microphone.choose(replace(chosen, **kept))

    def _kept(self, session: Session, page: AnalysisPage) -> tuple[Kept[Any], ...]:
        microphone = session.microphone
        return (
            *(Kept(name, switch.isChecked, switch.setChecked) for name, switch in self._switches.items()),
            *(_kept_choice(name, box) for name, box in self._choices.items()),
            Kept("volume", lambda: round(session.playback.volume), session.playback.set_volume),
            Kept("output", lambda: session.playback.device, session.playback.choose_device),
            Kept("loop", lambda: session.playback.loop, session.playback.set_loop),
            Kept("channel", lambda: session.wanted_channel, session.set_channel),
            _kept_attribute("recordings", microphone, "folder"),
            Kept("recording_kind", lambda: microphone.suffix, partial(_set_kind, microphone)),
            _kept_attribute("recording_phonemes", microphone, "with_phonemes"),
            _kept_attribute("recording_fills_gaps", microphone, "fill_gaps"),
            Kept("variable", lambda: page.courses.chosen, page.courses.choose),
            Kept("darkest", page.sonagram.low.value, page.sonagram.low.setValue),
            Kept("brightest", page.sonagram.high.value, page.sonagram.high.setValue),
        )


def _set_kind(microphone: Microphone, suffix: str) -> None:
    if suffix in SUFFIXES:
        microphone.suffix = suffix


def _kept_attribute(key: str, owner: object, name: str) -> Kept[Any]:
    return Kept(key, partial(getattr, owner, name), partial(setattr, owner, name))


def _kept_choice(name: str, box: QComboBox) -> Kept[str]:
    return Kept(name, partial(_chosen, box), partial(_choose, box))


def _chosen(box: QComboBox) -> str:
    """Return what is chosen, by a name that is the same in all languages where there is one."""
    return str(box.currentData() or box.currentText())


def _choose(box: QComboBox, name: str) -> None:
    """Choose what has a name; nothing where it is not there any more."""
    place = next((place for place in (box.findData(name), box.findText(name)) if place >= 0), box.currentIndex())
    box.setCurrentIndex(place)
