"""The file over time, with what is chosen of it."""

from dataclasses import replace
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QComboBox, QLabel, QMenu, QWidget

from phonemeanalyser.desktop.analyse.lanes.file_view import FileView
from phonemeanalyser.desktop.analyse.lanes.sonagram import add_colour_maps, colours_of
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import USUAL_VARIABLE, PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import (
    choice,
    column,
    offer,
    open_at_once,
    row,
    silent,
    toggle_button,
    tool_button,
)
from phonemeanalyser.desktop.widgets.labels import ElidedLabel
from phonemeengine.dsp.sonagram import FrequencyAxis
from phonemeengine.inspection.whole_sound import FrameRange
from phonemeengine.settings import FRAME_PERIOD

OVERLAYS = {
    tr_noop("formants"): tr_noop("red dots, by Burg's method, as Praat measures them"),
    tr_noop("pitch"): tr_noop("a blue line, 0 to 500 Hz from the lower edge to the upper"),
    tr_noop("level"): tr_noop("a yellow line, peaks of -80 to 0 dB"),
    tr_noop("words"): tr_noop("lanes below, where the words are known: words, syllables or letters, phones, units"),
}
"""What may be drawn over the sonagram, and how."""


class FilePanel(QWidget):
    """The view of the file, and a row of choices above it.

    Attributes
    ----------
    view : what is painted.
    follow : whether the view goes along with what is heard.
    filtered : whether the sonagram is that after the filters.
    heading : whether that is a file, or what a microphone heard.
    live : a button that goes back to what the microphone hears now.
    whole, selection : buttons that show all of it, and what is selected.
    over : a menu with the `overlays`, the switches for what is drawn over the sonagram.
    axis, colours, variable : choices.
    differs : in how much of what is seen two presets hear two things.
    """

    def __init__(self, session: Session, preset: PresetModel, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self._preset = preset
        self.view = FileView(session, theme)
        self.follow = toggle_button(tr("follow"), tr("Turn the page where what is heard leaves it"))
        self.filtered = toggle_button(
            tr("filtered", "a button"), tr("The sonagram after all filters that are on, as recognisers see it")
        )
        self.whole = tool_button(tr("all"), tr("See the whole file"))
        self.selection = tool_button(tr("selection"), tr("See what is selected (Shift+drag selects)"))
        self.live = tool_button(tr("live"), tr("Back to what the microphone hears now (Ctrl+B)"))
        self.heading = QLabel(tr("<b>File</b>"))
        self.over = tool_button(
            tr("over it"), tr("What is drawn over the sonagram, and below it: formants, pitch, level, words")
        )
        self.overlays = {name: QAction(f"{tr(name)}: {tr(what)}", self) for name, what in OVERLAYS.items()}
        self.axis = choice(
            ((tr(axis.value), axis.value) for axis in FrequencyAxis),
            tr("frequency axis"),
            tr("How frequencies are spread over the sonagram"),
        )
        self.colours = choice((), tr("colour map"), tr("Colour map"))
        self.variable = choice((), tr("variable"), tr("The variable whose course is shown"))
        self.differs = ElidedLabel()
        self._lay_out()
        self._connect()
        self._list_variables()
        self._show_state()

    def refresh(self) -> None:
        """Go along with what is heard."""
        if self._session.source.playing and not self._session.seen.looks_back:
            self._session.view.follow(self._session.source.position)
            self.view.update()

    def _lay_out(self) -> None:
        menu = QMenu(self.over)
        menu.addActions([*self.overlays.values()])
        open_at_once(self.over, menu)
        add_colour_maps(self.colours)
        for box in (self.axis, self.colours, self.variable):
            box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
            box.setMinimumContentsLength(5)
            box.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        buttons = (self.live, self.follow, self.filtered, self.whole, self.selection, self.over)
        above = row(
            self.heading,
            (self.differs, 1),
            *buttons,
            self.axis,
            self.colours,
            self.variable,
            margins=(6, 3, 6, 1),
            spacing=8,
        )
        column(above, (self.view, 1), on=self, spacing=2)

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
        self.colours.currentIndexChanged.connect(lambda _k: self._show_colours())
        self.variable.currentTextChanged.connect(self.view.show_variable)
        self.view.sought.connect(self._session.seek)
        self._preset.changed.connect(self._list_variables)
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
            self.differs.setText(tr("{share:.1f} % differ").format(share=100 * share))
            self.differs.setToolTip(
                tr("{first} and {second} differ in {share:.1f} % of what is seen").format(
                    first=first, second=second, share=100 * share
                )
            )

    def _show_selection(self) -> None:
        if self._session.view.selection is not None:
            self._session.view.show(self._session.view.selection)

    def _list_variables(self) -> None:
        chosen = self.variable.currentText() or self.view.variable
        with silent(self.variable):
            offer(self.variable, self._preset.variable_names, chosen, usual=USUAL_VARIABLE)
        if self.variable.currentText() != self.view.variable:
            self.view.show_variable(self.variable.currentText())

    def _show_state(self) -> None:
        self.live.setVisible(self._session.seen.looks_back)
        self.follow.setVisible(not self._session.seen.looks_back)
        self.heading.setText(tr("<b>Heard</b>") if self._session.seen.looks_back else tr("<b>File</b>"))
        self.follow.setChecked(self._session.view.follows)
        self.selection.setEnabled(self._session.view.selection is not None)
