"""Which seconds of a file are seen, and which are selected."""

from enum import StrEnum
from typing import NamedTuple

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr_noop
from phonemeengine.settings import FRAME_PERIOD

SHORTEST = 0.005
"""Seconds that are seen at least."""
USUAL = 10.0
"""Seconds of a longer file that are seen at first."""
LEAST_SELECTED = FRAME_PERIOD
"""Seconds; a drag over less selects nothing."""
AROUND = 0.5
"""Seconds that are seen at least on either side of what is revealed."""
AHEAD = 0.1
"""Share of what is seen that lies before the playhead, when the view turns a page."""


class Scope(StrEnum):
    """Of what figures are: of a part of the sound, of all of it, or of all that is loaded in Calibrate, too."""

    SEEN = "seen"
    SELECTION = "selection"
    WHOLE = "whole"
    LOADED = "loaded"


SCOPES = {
    Scope.SEEN: tr_noop("In view"),
    Scope.SELECTION: tr_noop("Selection"),
    Scope.WHOLE: tr_noop("Whole recording"),
    Scope.LOADED: tr_noop("Everything loaded"),
}
"""How the window names them."""


class TimeSpan(NamedTuple):
    """An interval of time, seconds from the file's beginning."""

    start: float
    end: float

    @property
    def seconds(self) -> float:
        """How long it is."""
        return self.end - self.start


class TimeView(QObject):
    """The part of a file that is seen; always within it, and never of no length.

    Signals
    -------
    moved : another part is seen.
    selected : something else is selected, or nothing.

    Attributes
    ----------
    duration : of the file, seconds; 0 where there is none.
    seen : the part.
    selection : what is selected; None for nothing.
    follows : whether the view follows the playhead.
    """

    moved = Signal()
    selected = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.duration = 0.0
        self.seen = TimeSpan(0.0, 0.0)
        self.selection: TimeSpan | None = None
        self.follows = True

    def open(self, duration: float) -> None:
        """See the beginning of another file, or all of a short one; nothing of it is selected."""
        self.duration = max(0.0, duration)
        self.select(None)
        self._show(0.0, min(USUAL, self.duration))

    def grow(self, duration: float) -> None:
        """Have the sound become longer while it is made; all of a short one is seen, else what was seen before."""
        sees_all = self.seen.seconds >= self.duration
        self.duration = duration
        if sees_all:
            self._show(self.seen.start, min(USUAL, duration))

    def show_all(self) -> None:
        """See the whole file."""
        self._show(0.0, self.duration)

    def show_end(self) -> None:
        """See the last seconds."""
        self._show(self.duration, min(USUAL, self.duration))

    def show(self, span: TimeSpan) -> None:
        """See a part, such as what is selected."""
        self._show(span.start, span.seconds)

    def reveal(self, span: TimeSpan) -> None:
        """See a part with what is around it, unless all of it is seen already."""
        if not (self.seen.start <= span.start and span.end <= self.seen.end):
            half = max(self.seen.seconds / 2, span.seconds + AROUND)
            middle = (span.start + span.end) / 2
            self._show(middle - half, 2 * half)

    def zoom(self, at: float, factor: float) -> None:
        """Change the zoom by a factor around a time, which stays where it is on the screen."""
        seconds = self._length(self.seen.seconds * factor)
        share = (at - self.seen.start) / self.seen.seconds if self.seen.seconds else 0.5
        self._show(at - share * seconds, seconds)

    def scroll(self, seconds: float) -> None:
        """See later (positive) or earlier seconds, as many as now."""
        self._show(self.seen.start + seconds, self.seen.seconds)

    def follow(self, position: float) -> None:
        """Turn the page where the playhead lies beyond what is seen, if the view follows it."""
        if self.follows and not self.seen.start <= position < self.seen.end:
            self._show(position - AHEAD * self.seen.seconds, self.seen.seconds)

    def select(self, span: TimeSpan | None) -> None:
        """Select a part, given from either end; too short a one, or None, selects nothing."""
        if span is not None:
            start, end = sorted(min(max(time, 0.0), self.duration) for time in span)
            span = TimeSpan(start, end) if end - start >= LEAST_SELECTED else None
        if span != self.selection:
            self.selection = span
            self.selected.emit()

    def _length(self, seconds: float) -> float:
        return min(max(seconds, SHORTEST), self.duration)

    def _show(self, start: float, seconds: float) -> None:
        seconds = self._length(seconds)
        start = min(max(start, 0.0), self.duration - seconds)
        seen = TimeSpan(start, start + seconds)
        if seen != self.seen:
            self.seen = seen
            self.moved.emit()
