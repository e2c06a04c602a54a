"""The timeline with the bar above it: what is known, which words fit badly, and how much is seen."""

from functools import partial

from PySide6.QtWidgets import QMenu, QWidget

from phonemeanalyser.desktop.language import tr, tr_count
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.talk.words.time_line import SpeechTimeline
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import ElidedLabel, column, open_without_arrow, row, spoken_button

MOST_LISTED = 30
"""Words of those that fit badly that are listed at once."""


class LanesPanel(QWidget):
    """The timeline and its bar.

    Attributes
    ----------
    line : the timeline.
    summary : what is known of the sound.
    poor : lists the words that fit badly; `previous` and `next` go to the one before and after.
    whole : shows all of the sound.
    """

    def __init__(self, talking: TalkModel, theme: Theme) -> None:
        super().__init__()
        self._texts, self._theme = talking.text, theme
        self.line = SpeechTimeline(talking, theme)
        self.summary = ElidedLabel()
        self._list = QMenu(self)
        self.previous = spoken_button(
            "◂", tr("Go to the previous poor match"), partial(self._texts.edits.show_poor, -1)
        )
        self.poor = spoken_button("", tr("Words that fit the recording badly; choose one to play it"))
        self.next = spoken_button("▸", tr("Go to the next poor match"), partial(self._texts.edits.show_poor, 1))
        self.whole = spoken_button(tr("Fit All"), tr("Zoom to the whole length"), self._show_whole)
        open_without_arrow(self.poor, self._list)
        bar = row((self.summary, 1), self.previous, self.poor, self.next, self.whole, spacing=4)
        bar.setContentsMargins(8, 0, 8, 0)
        column(bar, (self.line, 1), on=self, margins=(0, 2, 0, 0), spacing=2)
        self._list.aboutToShow.connect(self._fill_list)
        for signal in (self._texts.changed, self._texts.text_changed):
            signal.connect(self._show_state)
        for view in (talking.session.view, self._texts.speech_view):
            view.moved.connect(self._allow_whole)
        self._show_state()

    def refresh(self) -> None:
        """Go along with what is playing."""
        self.line.refresh()

    def _show_whole(self) -> None:
        self._texts.view.show_all()

    def _show_state(self) -> None:
        self.summary.setText(self._summary())
        self.summary.setStyleSheet(f"color: {self._theme.bad if self._texts.stale else self._theme.text}")
        n = len(self._texts.edits.poor)
        self.poor.setText(tr_count("{n} poor match", "{n} poor matches", n) + " ▾")
        for button in (self.previous, self.poor, self.next):
            button.setVisible(n > 0)
        self._allow_whole()

    def _allow_whole(self) -> None:
        self.whole.setEnabled(self._texts.view.duration > 0)

    def _summary(self) -> str:
        """Return what is known, in words."""
        utterance = self._texts.utterance
        if utterance is None:
            return ""
        if self._texts.stale:
            return self._texts.stale
        said = tr_count("{n} word", "{n} words", len(utterance.words))
        return said if self._texts.editable else tr("{said}; boundaries fixed by the voice").format(said=said)

    def _fill_list(self) -> None:
        self._list.clear()
        poor = self._texts.edits.poor
        for word in poor[:MOST_LISTED]:
            words = tr("{seconds:.2f} s: {word}").format(seconds=word.start, word=word.text).replace("&", "&&")
            self._list.addAction(words, partial(self._texts.edits.show, word))
        if len(poor) > MOST_LISTED:
            self._list.addAction(tr("{n} more").format(n=len(poor) - MOST_LISTED)).setEnabled(False)
