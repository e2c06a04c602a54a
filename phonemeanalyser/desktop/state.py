"""What outlives the window: layout and choices, kept in the user's settings between two starts."""

import math
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QByteArray, QSettings
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QComboBox, QMainWindow, QSplitter

from phonemeanalyser.desktop.analyse.scroll_view import ScrollView
from phonemeanalyser.desktop.session.microphone import SUFFIXES, Microphone
from phonemeanalyser.desktop.session.session import Session
from phonemeengine.audio.devices import InputChoice
from phonemeengine.errors import SettingsError
from phonemeengine.settings import Channel

LAYOUT_VERSION = 1


class WindowState:
    """Keeps and restores the layout of a window, the session's choices, and what its switches say."""

    def __init__(
        self, window: QMainWindow, splitters: dict[str, QSplitter],
        switches: dict[str, QAbstractButton | QAction], choices: dict[str, QComboBox], settings: QSettings,
    ) -> None:  # fmt: skip
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
        """Lay out docks, bars and splitters as they were when nobody had moved them."""
        for name, state in self._untouched.items():
            self._restorers[name](state)
        self._settings.remove("layout_width")

    def save_docks(self, *, stacked: bool) -> None:
        """Keep where docks and bars are, while they are seen, and how wide the window is that they are in.

        `stacked` says whether one lies behind another only since the window is narrow.
        """
        self._settings.setValue("layout", self._window.saveState(LAYOUT_VERSION))
        self._settings.setValue("layout_width", self._window.width())
        self._settings.setValue("layout_stacked", int(stacked))

    def docks_stacked(self) -> bool:
        """Return whether a dock was behind another one only since the window was narrow."""
        return self._kept("layout_stacked", 0) == "1"

    def docks_width(self) -> float:
        """Return the width of the window for which docks were laid out, pixels; infinite where they never were."""
        kept = self._kept_number("layout_width", 0)
        return kept if kept > 0 else math.inf

    def save_page(self, number: int) -> None:
        """Keep which page is seen."""
        self._settings.setValue("page", number)

    def page(self) -> int:
        """Return the number of the page that was seen last."""
        return round(self._kept_number("page", 0))

    def save(self, session: Session, view: ScrollView) -> None:
        """Keep everything else for the next start."""
        keep = self._settings.setValue
        for name, save in self._savers.items():
            keep(name, save())
        for name, switch in self._switches.items():
            keep(name, int(switch.isChecked()))
        for name, choice in self._choices.items():
            keep(name, _chosen(choice))
        keep("volume", round(session.volume))
        keep("loop", int(session.loop))
        keep("output", session.loudspeaker.label)
        keep("channel", session.wanted_channel.value)
        microphone = session.microphone
        keep("microphone", microphone.choice.label)
        keep("microphone_channel", microphone.choice.channel)
        keep("microphone_rate", microphone.choice.rate)
        keep("microphone_latency", microphone.choice.latency)
        keep("microphone_else_default", int(microphone.choice.else_default))
        keep("recordings", str(microphone.folder))
        keep("recording_kind", microphone.suffix)
        keep("recording_phonemes", int(microphone.with_phonemes))
        keep("recording_fills_gaps", int(microphone.fill_gaps))
        keep("variable", view.variable.currentText())
        keep("colours", _chosen(view.colours))
        keep("darkest", view.low.value())
        keep("brightest", view.high.value())

    def restore(self, session: Session, view: ScrollView) -> None:
        """Take up everything of the last start; what was never kept stays as it is."""
        self._untouched = {name: save() for name, save in self._savers.items() if name != "geometry"}
        self._untouched["layout"] = self._window.saveState(LAYOUT_VERSION)
        for name, restore in self._restorers.items():
            state = self._settings.value(name)
            if isinstance(state, QByteArray):
                restore(state)
        for name, switch in self._switches.items():
            switch.setChecked(self._kept(name, int(switch.isChecked())) == "1")
        for name, choice in self._choices.items():
            _choose(choice, self._kept(name, _chosen(choice)))
        session.set_volume(self._kept_number("volume", session.volume))
        session.loudspeaker.choose(self._kept("output", session.loudspeaker.label))
        session.set_loop(self._kept("loop", int(session.loop)) == "1")
        with suppress(ValueError):  # somebody edited the file
            session.set_channel(Channel(self._kept("channel", session.wanted_channel.value)))
        self._restore_microphone(session.microphone)
        view.variable.setCurrentText(self._kept("variable", view.variable.currentText()))
        _choose(view.colours, self._kept("colours", _chosen(view.colours)))
        view.low.setValue(round(self._kept_number("darkest", view.low.value())))
        view.high.setValue(round(self._kept_number("brightest", view.high.value())))

    def _restore_microphone(self, microphone: Microphone) -> None:
        choice = microphone.choice
        label = self._kept("microphone", choice.label)
        channel = round(self._kept_number("microphone_channel", choice.channel))
        rate = round(self._kept_number("microphone_rate", choice.rate))
        latency = self._kept_number("microphone_latency", choice.latency)
        else_default = self._kept("microphone_else_default", int(choice.else_default)) == "1"
        with suppress(SettingsError):  # somebody edited the file
            microphone.choose(InputChoice(label, channel, rate, else_default, latency))
        microphone.folder = Path(self._kept("recordings", str(microphone.folder)))
        suffix = self._kept("recording_kind", microphone.suffix)
        microphone.suffix = suffix if suffix in SUFFIXES else microphone.suffix
        microphone.with_phonemes = self._kept("recording_phonemes", int(microphone.with_phonemes)) == "1"
        microphone.fill_gaps = self._kept("recording_fills_gaps", int(microphone.fill_gaps)) == "1"

    def _kept_number(self, name: str, default: float) -> float:
        try:
            kept = float(self._kept(name, default))
        except ValueError:  # somebody edited the file
            return default
        return kept if math.isfinite(kept) else default

    def _kept(self, name: str, default: Any) -> str:
        return str(self._settings.value(name, default))


def _chosen(box: QComboBox) -> str:
    """Return what is chosen, by a name that is the same in all languages where there is one."""
    return str(box.currentData() or box.currentText())


def _choose(box: QComboBox, name: str) -> None:
    """Choose what has a name; nothing where it is not there any more."""
    place = next((place for place in (box.findData(name), box.findText(name)) if place >= 0), box.currentIndex())
    box.setCurrentIndex(place)
