"""How things look: colours, light and dark, which dress Qt's widgets and the plots, and letters on a painter."""

import math
from functools import cache

import pyqtgraph as pg
from PySide6.QtCore import QRect, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetrics, QGuiApplication, QPainter, QPalette
from PySide6.QtWidgets import QApplication

from phonemeanalyser.colours import CURVE_COLOURS, DARK, LIGHT, PHONEME_COLOURS, Theme

BOX = 11
"""Pixels of an unchecked box within its frame, which Fusion draws dark on dark."""
__all__ = ["CURVE_COLOURS", "DARK", "LIGHT", "PHONEME_COLOURS", "Theme", "apply_theme", "style_sheet", "system_theme"]
__all__ += ["AT_LEFT", "AT_RIGHT", "CENTRED", "draw_text", "format_clock", "letters_on", "mixed", "set_size"]
__all__ += ["shortened", "size_that_fills"]


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


AT_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
AT_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
READABLE = 0.179
"""The luminance at which black and white stand out from a colour alike."""
CENTRED = Qt.AlignmentFlag.AlignCenter


def set_size(painter: QPainter, size: int) -> None:
    """Have letters be so high from now on, pixels."""
    font = painter.font()
    if font.pixelSize() != size:
        font.setPixelSize(size)
        painter.setFont(font)


def draw_text(
    painter: QPainter,
    box: QRectF | QRect,
    text: str,
    colour: str | QColor,
    size: int,
    align: Qt.AlignmentFlag = AT_LEFT,
) -> None:
    """Write one line into a box; words that have no room are shortened by `shortened`.

    Parameters
    ----------
    size : of the letters, pixels.
    """
    set_size(painter, size)
    painter.setPen(QColor(colour))
    if size * len(text) > box.width():  # no letter is wider than high
        text = shortened(painter.fontMetrics(), text, math.floor(box.width()))
    painter.drawText(box, align, text)


def shortened(metrics: QFontMetrics, text: str, width: int) -> str:
    """Return as much of a line as has room, pixels, with three dots at its end; nothing where these have none.

    A single letter is whole or not there, and no word is shortened to its first letter: it would read as another.
    """
    short = metrics.elidedText(text, Qt.TextElideMode.ElideRight, width)
    whole_or_told = short == text or len(text) > 1
    has_room = whole_or_told and metrics.horizontalAdvance(short) <= width  # Qt gives one letter uncut
    return short if has_room else ""


def mixed(colour: QColor, other: QColor, share: float) -> QColor:
    """Return a colour of which so much is the first one, 0..1, and the rest the other."""
    parts = ((one.red(), one.green(), one.blue()) for one in (colour, other))
    return QColor(*(round(share * a + (1 - share) * b) for a, b in zip(*parts, strict=True)))


@cache
def letters_on(colour: str) -> str:
    """Return black or white, whichever is read better on a colour, #rrggbb, by the luminance of WCAG 2.2."""
    return "#000000" if _luminance(QColor(colour)) > READABLE else "#ffffff"


def _luminance(colour: QColor) -> float:
    shares = (colour.redF(), colour.greenF(), colour.blueF())
    red, green, blue = (s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4 for s in shares)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def size_that_fills(painter: QPainter, text: str, width: float, smallest: int, largest: int) -> int:
    """Return the size in which a text is as wide as that, pixels, within limits."""
    set_size(painter, 100)
    wide = max(1, painter.fontMetrics().horizontalAdvance(text))
    return max(smallest, min(largest, math.floor(100 * width / wide)))


def format_clock(seconds: float, fine: bool) -> str:
    """Write seconds as 1:02:03.4, without hours where there are none."""
    minutes, rest = divmod(seconds, 60)
    hours, minutes = divmod(int(minutes), 60)
    tail = f"{int(rest * 10) / 10:04.1f}" if fine else f"{int(rest):02d}"
    return f"{hours}:{minutes:02d}:{tail}" if hours else f"{minutes}:{tail}"
