"""Colours, light and dark: one table dresses Qt's widgets and the plots."""

import pyqtgraph as pg
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

from phonemeanalyser.colours import CURVE_COLOURS, DARK, LIGHT, PHONEME_COLOURS, Theme

BOX = 11
"""Pixels of an unchecked box within its frame, which Fusion draws dark on dark."""
__all__ = ["CURVE_COLOURS", "DARK", "LIGHT", "PHONEME_COLOURS", "Theme", "apply_theme", "style_sheet", "system_theme"]


def system_theme() -> Theme:
    """Return the look that the desktop asks for."""
    return DARK if QGuiApplication.styleHints().colorScheme() is Qt.ColorScheme.Dark else LIGHT


def style_sheet(theme: Theme) -> str:
    """Return the style sheet of a window, for when its parts are there: Qt styles a part at each new parent."""
    return (
        f"QToolTip {{ color: {theme.text}; background: {theme.raised}; border: 1px solid {theme.line} }}"
        f"QToolButton[checkable=true] {{ color: {theme.text}; background: {theme.raised}; padding: 1px 3px;"
        f" border: 1px solid {theme.line}; border-radius: 3px }}"
        f"QToolButton[checkable=true]:checked {{ color: {theme.on_colour}; background: {theme.accent} }}"
        f"QToolButton[checkable=true]:hover {{ border-color: {theme.accent} }}"
        f"QCheckBox::indicator:unchecked, QGroupBox::indicator:unchecked, QAbstractItemView::indicator:unchecked"
        f" {{ border: 1px solid {theme.faint}; border-radius: 2px; background: {theme.field};"
        f" width: {BOX}px; height: {BOX}px }}"
        f"QAbstractItemView:focus {{ border: 1px solid {theme.accent} }}"  # which no line shows where there is none
        "QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0 }"  # which are black, on dark buttons, too
        f"QSlider::groove:horizontal {{ height: 4px; border-radius: 2px; background: {theme.line} }}"
        f"QSlider::sub-page:horizontal {{ border-radius: 2px; background: {theme.accent} }}"
        "QSlider::handle:horizontal { width: 10px; margin: -5px 0; border-radius: 5px;"
        f" border: 1px solid {theme.base}; background: {theme.text} }}"
        f"QSlider::handle:horizontal:focus {{ border: 2px solid {theme.accent}; background: {theme.base} }}"
        f"QSlider::handle:horizontal:disabled {{ background: {theme.faint} }}"
        f"QSlider::sub-page:horizontal:disabled {{ background: {theme.line} }}"
    )


def apply_theme(app: QApplication, theme: Theme) -> None:
    """Give the application, and all plots made from now on, the colours of a theme; see `style_sheet` for windows."""
    if app.style().name() != "fusion":  # else Qt would polish every widget once more
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
        QPalette.ColorRole.HighlightedText: theme.on_colour,
        QPalette.ColorRole.Link: theme.accent,
        QPalette.ColorRole.Mid: theme.line,
        QPalette.ColorRole.Light: theme.line,
        QPalette.ColorRole.Accent: theme.accent,
    }
    for role, colour in roles.items():
        palette.setColor(role, QColor(colour))
    for role in (QPalette.ColorRole.Text, QPalette.ColorRole.ButtonText, QPalette.ColorRole.WindowText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(theme.faint))
    if palette != app.palette():
        app.setPalette(palette)
    pg.setConfigOptions(background=theme.base, foreground=theme.text, antialias=False)
