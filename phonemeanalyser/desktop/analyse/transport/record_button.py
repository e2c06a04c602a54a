"""The button that records, and how it does so."""

from collections.abc import Callable, Mapping
from typing import TypeVar

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QColor, QIcon, QPainter, QPixmap
from PySide6.QtWidgets import QMenu, QToolButton

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import silent

Key = TypeVar("Key")

KINDS = {".wav": tr_noop("WAV, RF64 beyond 4 GB"), ".flac": tr_noop("FLAC, half the size")}
BUFFERS = {
    0.04: tr_noop("Short Buffer: Blocks of 10 ms, the Least Latency"),
    0.08: tr_noop("Medium Buffer: Blocks of 20 ms"),
    0.2: tr_noop("Long Buffer: Blocks of 50 ms, for a Busy Machine"),
}
"""What is asked of the microphone, seconds, and how that is called."""


class RecordButton(QToolButton):
    """Begins and ends a recording; its menu says where to, and in which form.

    Signals
    -------
    folder_asked : the user wants to choose where recordings go.
    """

    folder_asked = Signal()

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._microphone = session.microphone
        self._theme = theme
        self.setIconSize(QSize(20, 20))
        self.setStyleSheet(f"QToolButton[checkable=true]:checked {{ background: {theme.bad} }}")
        self.setCheckable(True)
        self.setFixedWidth(46)
        self.setAccessibleName(tr("record"))
        self.setPopupMode(QToolButton.ToolButtonPopupMode.MenuButtonPopup)
        menu = QMenu(self)
        self.folder = QAction(self)
        self.folder.triggered.connect(self.folder_asked)
        menu.addAction(self.folder)
        menu.addSeparator()
        self.kinds = self._add_choices(menu, KINDS, self._set_kind)
        menu.addSeparator()
        self.buffers = self._add_choices(menu, BUFFERS, self._microphone.set_latency)
        menu.addSeparator()
        self.phonemes = self._add_switch(menu, tr("Write the Phonemes Beside It (.csv)"))
        self.phonemes.toggled.connect(self._set_phonemes)
        self.gaps = self._add_switch(menu, tr("Fill Gaps with Silence, Besides Marking Them"))
        self.gaps.toggled.connect(self._set_fill_gaps)
        self.else_default = self._add_switch(menu, tr("Go On with the Default Microphone if It Vanishes"))
        self.else_default.toggled.connect(self._microphone.set_else_default)
        menu.aboutToShow.connect(self.show_state)
        self.setMenu(menu)

    def show_state(self) -> None:
        """Show whether it records, and how it would."""
        microphone = self._microphone
        recording = microphone.recording
        self.setChecked(recording)
        self.setIcon(_dot(self._theme, recording))
        self.setToolTip(
            tr("End the recording (R)")
            if recording
            else tr("Record the microphone into {folder} (R)").format(folder=microphone.folder)
        )
        self.folder.setText(tr("Recordings Go to {folder}…").format(folder=microphone.folder))
        for suffix, action in self.kinds.items():
            action.setChecked(suffix == microphone.suffix)
        for latency, action in self.buffers.items():
            action.setChecked(latency == microphone.choice.latency)
        with silent(self.phonemes, self.gaps, self.else_default):
            self.phonemes.setChecked(microphone.with_phonemes)
            self.gaps.setChecked(microphone.fill_gaps)
            self.else_default.setChecked(microphone.choice.else_default)

    def _add_choices(
        self, menu: QMenu, choices: Mapping[Key, str], act: Callable[[Key], object]
    ) -> dict[Key, QAction]:
        """Add entries of which one at a time is chosen; `act` is given what was chosen."""
        group, actions = QActionGroup(self), {}
        for key, words in choices.items():
            action = actions[key] = QAction(tr(words), self, checkable=True)
            action.triggered.connect(lambda _checked, key=key: act(key))
            group.addAction(action)
            menu.addAction(action)
        return actions

    def _add_switch(self, menu: QMenu, text: str) -> QAction:
        action = QAction(text, self, checkable=True)
        menu.addAction(action)
        return action

    def _set_kind(self, suffix: str) -> None:
        self._microphone.suffix = suffix

    def _set_phonemes(self, on: bool) -> None:
        self._microphone.with_phonemes = on

    def _set_fill_gaps(self, on: bool) -> None:
        self._microphone.fill_gaps = on


def _dot(theme: Theme, recording: bool) -> QIcon:
    pixmap = QPixmap(20, 20)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(theme.on_colour if recording else theme.bad))
    if recording:
        painter.drawRoundedRect(4, 4, 12, 12, 2, 2)
    else:
        painter.drawEllipse(3, 3, 14, 14)
    painter.end()
    return QIcon(pixmap)
