"""What is chosen of the sonagram, of files and of live sound: filters, overlays, frequencies, window and colours."""

from dataclasses import replace

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction, QShowEvent
from PySide6.QtWidgets import QFormLayout, QMenu, QToolButton, QWidget, QWidgetAction
from typing_extensions import override

from phonemeanalyser.desktop.analyse.lanes.sonagram import add_colour_maps
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.widgets.builders import choice, label, leave_wheel, named, open_at_once, row, tool_button
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeengine.dsp.sonagram import NARROW_BAND, WIDE_BAND, FrequencyAxis
from phonemeengine.settings import SAMPLE_RATE

OVERLAYS = {
    "formants": tr_noop("Formants (red dots, Burg's method, as in Praat)"),
    "pitch": tr_noop("Pitch (blue line, 0 to 500 Hz from bottom to top)"),
    "level": tr_noop("Level (yellow line, peaks from −80 to 0 dB)"),
    "feeling": tr_noop("Feeling in the voice (lane below: activation, pleasantness, standard errors)"),
    "words": tr_noop("Words, if known (lanes below: words, syllables or letters, phones, units)"),
}
"""What may be drawn over the sonagram or below it, by the names of `SonagramTiles`, and how the menu says so."""
WINDOWS = (WIDE_BAND, 0.01, 0.02, NARROW_BAND, 0.05)
"""Seconds of windows that are offered."""
TOPS = (4000.0, 5500.0, 8000.0, 11_000.0, SAMPLE_RATE / 2)
"""Highest frequencies that are offered, Hz."""
LOWEST = -120
"""dBFS, of a level that can be chosen."""


class _Fields(QWidget):
    """Fields in a menu: Down and Tab lead from it to the first of them, and Tab goes from one to the next."""

    def __init__(self, *fields: QWidget) -> None:
        super().__init__()
        self._fields = fields
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # else the menu leaves it out
        self.setFocusProxy(fields[0])

    @override
    def focusNextPrevChild(self, forwards: bool) -> bool:
        """Give the focus to the next field or the one before; a menu would give it to its lines."""
        now = self.window().focusWidget()
        at = next((k for k, field in enumerate(self._fields) if field is now), 0)
        field = self._fields[(at + (1 if forwards else -1)) % len(self._fields)]
        field.setFocus(Qt.FocusReason.TabFocusReason)
        return True

    @override
    def showEvent(self, event: QShowEvent) -> None:
        """Open without the field that had the focus last, which Down would change; it leads to the first."""
        if (before := self.window().focusWidget()) is not None:
            before.clearFocus()
        super().showEvent(event)


class SonagramChoices(QObject):
    """The switches and menus of the sonagram; several views have buttons for them.

    Attributes
    ----------
    filtered : whether the sonagram is that after the filters.
    overlays : the switches for what is drawn over the sonagram, or below it.
    axis, top, window_length, colours : choices.
    low, high : the levels of the darkest and the brightest colour, dBFS.
    """

    def __init__(self, session: Session, parent: QWidget) -> None:
        super().__init__(parent)
        self._session = session
        self.filtered = QAction(tr("After Filters"), self, checkable=True)
        self.filtered.setToolTip(
            tr("Show the sonagram after all active filters, as recognisers that use the filters see it")
        )
        self.overlays = {name: QAction(tr(what), self, checkable=True) for name, what in OVERLAYS.items()}
        self.axis = choice(
            ((tr(axis.value), axis.value) for axis in FrequencyAxis),
            tr("Frequency axis"),
            tr("Spacing of the frequencies in the sonagram: linear, mel or logarithmic"),
        )
        self.top = choice(
            ((f"{top:.0f} Hz", top) for top in TOPS), tr("Highest frequency"), tr("Upper edge of the sonagram")
        )
        self.window_length = choice(
            ((f"{1000 * seconds:g} ms", seconds) for seconds in WINDOWS),
            tr("Window"),
            tr(
                "Length of the sonagram's window: a short one (wide band, 6 ms) shows single pulses of the voice, a "
                "long one (narrow band, 30 ms) its harmonics"
            ),
        )
        self.low = named(
            NumberField(LOWEST, 0, unit=" dB"),
            tr("Level of the darkest colour"),
            tr("Level of the darkest colour, dBFS, the same for every sound"),
        )
        self.high = named(
            NumberField(LOWEST, 0, unit=" dB"),
            tr("Level of the brightest colour"),
            tr("Level of the brightest colour, dBFS, the same for every sound"),
        )
        self.colours = choice((), tr("Colour map"), tr("Colours of the levels in the sonagram"))
        self._over, self._looks = QMenu(parent), QMenu(parent)
        self._fill_menus()
        self._connect()

    def buttons(self) -> tuple[QToolButton, QToolButton, QToolButton]:
        """Make buttons for all choices: filters, overlays, and what the sonagram looks like."""
        filtered = QToolButton()
        filtered.setDefaultAction(self.filtered)
        over = tool_button(
            tr("Overlays"),
            tr("Curves drawn over the sonagram, and lanes below it: formants, pitch, level, feeling, words"),
        )
        looks = tool_button(tr("Sonagram"), tr("Frequencies, window, levels and colour map of the sonagram"))
        open_at_once(over, self._over)
        open_at_once(looks, self._looks)
        return filtered, over, looks

    def _fill_menus(self) -> None:
        """Put the choices into the menu of one button: a row of them is wider than a small screen."""
        sonagram = self._session.sonagram
        self._over.addActions([*self.overlays.values()])
        add_colour_maps(self.colours)
        self.top.setCurrentIndex(TOPS.index(sonagram.settings.high))
        self.window_length.setCurrentIndex(WINDOWS.index(sonagram.settings.window))
        for field, level in zip((self.low, self.high), sonagram.level_range, strict=True):
            field.setValue(level)
        form = QFormLayout(
            looks := _Fields(self.axis, self.top, self.window_length, self.low, self.high, self.colours)
        )
        for box in (self.axis, self.top, self.window_length):
            form.addRow(box.accessibleName(), box)
        form.addRow(tr("Colours from"), row(self.low, label(tr("to")), self.high, spacing=6))
        form.addRow(self.colours.accessibleName(), self.colours)
        leave_wheel(looks)
        action = QWidgetAction(self)
        action.setDefaultWidget(looks)
        self._looks.addAction(action)

    def _connect(self) -> None:
        sonagram = self._session.sonagram
        self.filtered.toggled.connect(self._session.seen.show_filtered)
        for name, action in self.overlays.items():
            action.toggled.connect(lambda on, name=name: sonagram.show_over(name, on=on))
        self.overlays["words"].setChecked(True)
        for box in (self.axis, self.top, self.window_length):
            box.currentIndexChanged.connect(lambda _k: self._measure())
        for field in (self.low, self.high):
            field.valueChanged.connect(lambda _level: self._show_levels())
        self.colours.currentIndexChanged.connect(lambda _k: sonagram.show_colours(self.colours.currentData()))

    def _measure(self) -> None:
        sonagram = self._session.sonagram
        sonagram.use(
            replace(
                sonagram.settings,
                axis=list(FrequencyAxis)[self.axis.currentIndex()],
                high=self.top.currentData(),
                window=self.window_length.currentData(),
            )
        )

    def _show_levels(self) -> None:
        self._session.sonagram.show_levels(*sorted((self.low.value(), self.high.value())))
