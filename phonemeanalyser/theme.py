"""Colours, light and dark: one table for Qt's widgets and the plots."""

from dataclasses import dataclass

import pyqtgraph as pg
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

from engine.phonemes import Phoneme


@dataclass(frozen=True)
class Theme:
    """The colours of one look, as #rrggbb."""

    name: str
    window: str
    base: str
    field: str
    raised: str
    text: str
    faint: str
    line: str
    accent: str
    signal: str
    good: str
    bad: str

    @property
    def on_colour(self) -> str:
        """The colour of text that stands on `bad` or `accent`."""
        return "#ffffff" if self.name == "light" else self.base


LIGHT = Theme(
    name="light", window="#f3f4f6", base="#ffffff", field="#ffffff",
    raised="#e6e8ec", text="#1c2128", faint="#656d78",
    line="#c3c8d0", accent="#2563c9", signal="#1a5fb4", good="#1d8348", bad="#c0392b",
)  # fmt: skip
DARK = Theme(
    name="dark", window="#1f2228", base="#15171c", field="#343a45",
    raised="#2c3038", text="#e4e7ec", faint="#98a1ae",
    line="#434954", accent="#5b9bf5", signal="#7cc4ff", good="#58c98a", bad="#ff7b6b",
)  # fmt: skip

PHONEME_COLOURS: dict[Phoneme, str] = {
    Phoneme.SILENCE: "#7a828e",
    Phoneme.UNIDENTIFIED: "#4d525b",
    Phoneme.SZ: "#e6c229",
    Phoneme.SCH: "#f0883e",
    Phoneme.M: "#a371f7",
    Phoneme.P: "#db61a2",
    Phoneme.I: "#39c5cf",
    Phoneme.A: "#f85149",
    Phoneme.E: "#3fb950",
    Phoneme.U: "#3f6fd8",
    Phoneme.O: "#58a6ff",
}

CURVE_COLOURS = ("#f0883e", "#3fb950", "#db61a2", "#39c5cf", "#e6c229", "#a371f7", "#f85149")


def system_theme() -> Theme:
    """Give the look that the desktop asks for."""
    return DARK if QGuiApplication.styleHints().colorScheme() is Qt.ColorScheme.Dark else LIGHT


def apply_theme(app: QApplication, theme: Theme) -> None:
    """Dress the application and all plots made from now on."""
    app.setStyle("Fusion")
    palette = QPalette()
    roles = {
        QPalette.ColorRole.Window: theme.window,
        QPalette.ColorRole.WindowText: theme.text,
        QPalette.ColorRole.Base: theme.field,
        QPalette.ColorRole.AlternateBase: theme.raised,
        QPalette.ColorRole.Text: theme.text,
        QPalette.ColorRole.PlaceholderText: theme.faint,
        QPalette.ColorRole.Button: theme.raised,
        QPalette.ColorRole.ButtonText: theme.text,
        QPalette.ColorRole.BrightText: theme.bad,
        QPalette.ColorRole.ToolTipBase: theme.raised,
        QPalette.ColorRole.ToolTipText: theme.text,
        QPalette.ColorRole.Highlight: theme.accent,
        QPalette.ColorRole.HighlightedText: "#ffffff",
        QPalette.ColorRole.Link: theme.accent,
        QPalette.ColorRole.Mid: theme.line,
        QPalette.ColorRole.Accent: theme.accent,
    }
    for role, colour in roles.items():
        palette.setColor(role, QColor(colour))
    for role in (QPalette.ColorRole.Text, QPalette.ColorRole.ButtonText, QPalette.ColorRole.WindowText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(theme.faint))
    app.setPalette(palette)
    app.setStyleSheet(
        f"QToolTip {{ color: {theme.text}; background: {theme.raised}; border: 1px solid {theme.line} }}"
        f"QToolButton[checkable=true] {{ color: {theme.text}; background: {theme.raised}; padding: 1px 4px;"
        f" border: 1px solid {theme.line}; border-radius: 3px }}"
        f"QToolButton[checkable=true]:checked {{ color: white; background: {theme.accent} }}"
        f"QToolButton[checkable=true]:hover {{ border-color: {theme.accent} }}"
    )
    pg.setConfigOptions(background=theme.base, foreground=theme.text, antialias=False)
