"""The file over time, with what is chosen of it."""

from dataclasses import replace
from functools import partial

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFormLayout, QLabel, QMenu, QWidget, QWidgetAction

from phonemeanalyser.desktop.analyse.lanes.file_view import FileView
from phonemeanalyser.desktop.analyse.lanes.sonagram import add_colour_maps, colours_of
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.courses import Courses
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import (
    Wrapping,
    choice,
    column,
    open_at_once,
    row,
    toggle_button,
    tool_button,
)
from phonemeanalyser.desktop.widgets.labels import ElidedLabel
from phonemeengine.dsp.sonagram import LEVELS, NARROW_BAND, WIDE_BAND, FrequencyAxis
from phonemeengine.inspection.whole_sound import FrameRange
from phonemeengine.settings import FRAME_PERIOD

OVERLAYS = {
    "formants": tr_noop("Formants (red dots, Burg's method, as in Praat)"),
    "pitch": tr_noop("Pitch (blue line, 0 to 500 Hz from bottom to top)"),
    "level": tr_noop("Level (yellow line, peaks from −80 to 0 dB)"),
    "words": tr_noop("Words, if known (lanes below: words, syllables or letters, phones, units)"),
}
"""What may be drawn over the sonagram or below it, by the names of `FileLayout`, and how the menu says so."""
WINDOWS = (WIDE_BAND, 0.01, 0.02, NARROW_BAND, 0.05)
"""Seconds of windows that are offered."""
RANGES = ((-70.0, 0.0), (-80.0, -10.0), LEVELS, (-100.0, -30.0), (-110.0, -40.0), (-70.0, -20.0), (-110.0, -10.0))
"""Levels of the darkest and the brightest colour that are offered, dB."""


class FilePanel(QWidget):
    """The view of the file, and choices above it.

    Attributes
    ----------
    view : what is painted.
    follow : whether the view goes along with what is playing.
    filtered : whether the sonagram is that after the filters.
    heading : whether that is a file, or a microphone's recording.
    live : a button that goes back to the live view of the microphone.
    whole, selection : buttons that show all of it, and what is selected.
    over : a menu with the `overlays`, the switches for what is drawn over the sonagram.
    looks : a button with the choices of the sonagram: axis, window, levels, colours.
    axis, window_length, levels, colours : choices.
    differs : the share of what is seen in which two presets differ.
    """

    def __init__(self, session: Session, courses: Courses, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self.view = FileView(session, courses, theme)
        self.follow = toggle_button(tr("Follow"), tr("Scroll on by a page when playback leaves the view"))
        self.filtered = toggle_button(
            tr("After filters"),
            tr("Show the sonagram after all active filters, as recognisers that use the filters see it"),
        )
        self.whole = tool_button(tr("Fit all"), tr("Zoom to the whole file (Shift+A)"))
        self.selection = tool_button(tr("Fit selection"), tr("Zoom to the selection (Shift+Z); Shift+drag selects"))
        self.live = tool_button(tr("Live"), tr("Return to the live signal of the microphone (Ctrl+B)"))
        self.heading = QLabel(tr("<b>File</b>"))
        self.over = tool_button(
            tr("Overlays"), tr("Curves drawn over the sonagram, and lanes below it: formants, pitch, level, words")
        )
        self.overlays = {name: QAction(tr(what), self) for name, what in OVERLAYS.items()}
        self.looks = tool_button(
            tr("Sonagram"), tr("Frequency axis, window, levels and colour map of the sonagram of files")
        )
        self.axis = choice(
            ((tr(axis.value), axis.value) for axis in FrequencyAxis),
            tr("Frequency axis"),
            tr("Spacing of the frequencies in the sonagram: linear, mel or logarithmic"),
        )
        self.window_length = choice(
            ((f"{1000 * seconds:g} ms", seconds) for seconds in WINDOWS),
            tr("Window"),
            tr(
                "Length of the sonagram's window: a short one (wide band, 6 ms) shows single pulses of the voice, a "
                "long one (narrow band, 30 ms) its harmonics"
            ),
        )
        self.levels = choice(
            ((tr("{low:.0f} to {high:.0f} dB").format(low=low, high=high), f"{low} {high}") for low, high in RANGES),
            tr("Levels"),
            tr("Levels of the darkest and the brightest colour, dBFS, the same for every sound"),
        )
        self.colours = choice((), tr("Colour map"), tr("Colours of the levels in the sonagram"))
        self.differs = ElidedLabel()
        self._lay_out()
        self._connect()
        self._show_state()

    def refresh(self) -> None:
        """Go along with what is playing."""
        if self._session.source.playing and not self._session.seen.looks_back:
            self._session.view.follow(self._session.source.position)
            self.view.update()

    def _lay_out(self) -> None:
        menu = QMenu(self.over)
        menu.addActions([*self.overlays.values()])
        open_at_once(self.over, menu)
        add_colour_maps(self.colours)
        self._fill_looks()
        fields = row(1, self.looks)
        buttons = (self.live, self.follow, self.filtered, self.whole, self.selection, self.over)
        above = Wrapping(row(self.heading, (self.differs, 1), *buttons, spacing=8), fields, (6, 3, 6, 1))
        column(above, (self.view, 1), on=self, spacing=2)

    def _fill_looks(self) -> None:
        """Put the choices of the sonagram into the menu of one button: a row of them is wider than a small screen."""
        form = QFormLayout(looks := QWidget(self))
        for box in (self.axis, self.window_length, self.levels, self.colours):
            form.addRow(box.accessibleName(), box)
        action = QWidgetAction(self)
        action.setDefaultWidget(looks)
        menu = QMenu(self.looks)
        menu.addAction(action)
        open_at_once(self.looks, menu)

    def _connect(self) -> None:
        view, sonagram = self._session.view, self._session.sonagram
        self.follow.toggled.connect(partial(setattr, view, "follows"))
        self.filtered.toggled.connect(self._session.seen.show_filtered)
        for name, action in self.overlays.items():
            action.setCheckable(True)
            action.toggled.connect(lambda on, name=name: self.view.show_over(name, on=on))
        self.overlays["words"].setChecked(True)
        self.whole.clicked.connect(lambda _checked: view.show_all())
        self.live.clicked.connect(lambda _checked: self._session.look_back(False))
        self._session.seen.looked_back.connect(self._show_state)
        self.selection.clicked.connect(lambda _checked: self._show_selection())
        self.axis.currentIndexChanged.connect(
            lambda k: sonagram.use(replace(sonagram.settings, axis=list(FrequencyAxis)[k]))
        )
        self.window_length.currentIndexChanged.connect(
            lambda _k: sonagram.use(replace(sonagram.settings, window=self.window_length.currentData()))
        )
        self.levels.currentIndexChanged.connect(
            lambda _k: sonagram.show_levels(*map(float, self.levels.currentData().split()))
        )
        self.window_length.setCurrentIndex(WINDOWS.index(sonagram.settings.window))
        self.levels.setCurrentIndex(RANGES.index(LEVELS))
        self.colours.currentIndexChanged.connect(lambda _k: self._show_colours())
        self.view.sought.connect(self._session.seek)
        view.selected.connect(self._show_state)
        second = self._session.second
        for signal in (self._session.whole.changed, second.whole.changed, second.changed, view.moved):
            signal.connect(self._show_difference)
        self._session.sought.connect(lambda: view.follow(self._session.source.position))
        self._session.sought.connect(self.view.update)
        self._show_colours()

    def _show_colours(self) -> None:
        self.view.set_colours(colours_of(self.colours.currentData()))

    def _show_difference(self) -> None:
        seen = self._session.view.seen
        frames = FrameRange(int(seen.start / FRAME_PERIOD), int(seen.end / FRAME_PERIOD) + 1)
        share = self._session.second.share_of_difference(frames)
        self.differs.setVisible(share is not None)
        if share is not None:
            first, second = self._session.second.names
            self.differs.setText(tr("{share:.1f} % different").format(share=100 * share))
            self.differs.setToolTip(
                tr("{first} and {second} recognise different phonemes in {share:.1f} % of the visible frames").format(
                    first=first, second=second, share=100 * share
                )
            )

    def _show_selection(self) -> None:
        if self._session.view.selection is not None:
            self._session.view.show(self._session.view.selection)

    def _show_state(self) -> None:
        self.live.setVisible(self._session.seen.looks_back)
        self.follow.setVisible(not self._session.seen.looks_back)
        self.heading.setText(tr("<b>History</b>") if self._session.seen.looks_back else tr("<b>File</b>"))
        self.follow.setChecked(self._session.view.follows)
        self.selection.setEnabled(self._session.view.selection is not None)
