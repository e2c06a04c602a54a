"""The file over time, with what is chosen of it."""

from functools import partial

from PySide6.QtWidgets import QLabel, QWidget

from phonemeanalyser.desktop.analyse.lanes.file_view import FileView
from phonemeanalyser.desktop.analyse.lanes.sonagram_choices import SonagramChoices
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.courses import Courses
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import Wrapping, column, row, toggle_button, tool_button
from phonemeanalyser.desktop.widgets.labels import ElidedLabel
from phonemeengine.inspection.whole_sound import FrameRange
from phonemeengine.settings import FRAME_PERIOD


class FilePanel(QWidget):
    """The view of the file, and choices above it.

    Attributes
    ----------
    view : what is painted.
    follow : whether the view goes along with what is playing.
    heading : whether that is a file, or a microphone's recording.
    live : a button that goes back to the live view of the microphone.
    whole, selection : buttons that show all of it, and what is selected.
    differs : the share of what is seen in which two presets differ.
    """

    def __init__(self, session: Session, courses: Courses, choices: SonagramChoices, theme: Theme) -> None:
        super().__init__()
        self._session = session
        self.view = FileView(session, courses, theme)
        self.follow = toggle_button(tr("Follow"), tr("Scroll on by a page when playback leaves the view"))
        self.whole = tool_button(tr("Fit All"), tr("Zoom to the whole file (Shift+A)"))
        self.selection = tool_button(tr("Fit Selection"), tr("Zoom to the selection (Shift+Z); Shift+drag selects"))
        self.live = tool_button(tr("Live"), tr("Return to the live signal of the microphone (Ctrl+B)"))
        self.heading = QLabel(tr("<b>File</b>"))
        self.differs = ElidedLabel()
        self._lay_out(choices)
        self._connect()
        self._show_state()

    def refresh(self) -> None:
        """Go along with what is playing."""
        if self._session.source.playing and not self._session.seen.looks_back:
            self._session.view.follow(self._session.source.position)
            self.view.update()

    def _lay_out(self, choices: SonagramChoices) -> None:
        buttons = (self.live, self.follow, self.whole, self.selection)
        above = Wrapping(
            row(self.heading, (self.differs, 1), *buttons, spacing=8),
            row(1, *choices.buttons(), spacing=8),
            (6, 3, 6, 1),
        )
        column(above, (self.view, 1), on=self, spacing=2)

    def _connect(self) -> None:
        view = self._session.view
        self.follow.toggled.connect(partial(setattr, view, "follows"))
        self.whole.clicked.connect(lambda _checked: view.show_all())
        self.live.clicked.connect(lambda _checked: self._session.look_back(False))
        self._session.seen.looked_back.connect(self._show_state)
        self.selection.clicked.connect(lambda _checked: self._show_selection())
        self.view.sought.connect(self._session.seek)
        view.selected.connect(self._show_state)
        second = self._session.second
        for signal in (self._session.whole.changed, second.whole.changed, second.changed, view.moved):
            signal.connect(self._show_difference)
        self._session.sought.connect(lambda: view.follow(self._session.source.position))
        self._session.sought.connect(self.view.update)

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
