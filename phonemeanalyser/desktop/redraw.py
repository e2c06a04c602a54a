"""When what is drawn: 60 pictures a second, of what is seen and new."""

import time

from PySide6.QtCore import QObject, Qt, QTimer

from phonemeanalyser.desktop import calibrate, talk
from phonemeanalyser.desktop.analyse.page import AnalysisPage
from phonemeanalyser.desktop.analyse.recognition.filter_column import LookAheadSlider
from phonemeanalyser.desktop.analyse.status_line import StatusLine
from phonemeanalyser.desktop.analyse.transport.transport import Transport
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.widgets.pages import LazyPage, PageStack

FRAME_MS = 16
"""Between two pictures: 60 a second."""
SLOW = 4
"""Numbers and what changes slowly are drawn at every fourth picture."""


class RedrawLoop(QObject):
    """Takes what is new and draws it: fast views each time, slow ones each fourth time.

    Attributes
    ----------
    frozen : whether the views are held still while sound goes on.
    dirty : whether the analysis must be drawn anew though nothing has arrived.
    n_ticks : pictures so far.
    heads : are moved; None before there are any.
    """

    def __init__(
        self,
        parent: QObject,
        session: Session,
        pages: PageStack,
        analysis: AnalysisPage,
        calibration: "LazyPage[calibrate.CalibrationPage]",
        transport: Transport,
        status: StatusLine,
        look_ahead: LookAheadSlider,
    ) -> None:
        super().__init__(parent)
        self.frozen = False
        self.dirty = True
        self.n_ticks = 0
        self._session = session
        self._pages = pages
        self._analysis = analysis
        self._calibration = calibration
        self.heads: talk.Heads | None = None
        self._transport = transport
        self._status = status
        self._look_ahead = look_ahead
        self.timer = QTimer(self)
        self.timer.setTimerType(Qt.TimerType.PreciseTimer)
        self.timer.timeout.connect(self.tick)
        self.timer.start(FRAME_MS)

    def tick(self) -> None:
        """Draw the next picture."""
        known_at = None
        if self._session.poll():
            self.dirty = True
            known_at = time.monotonic() - self._session.microphone.listener.known_for
        self._move_heads()
        self.n_ticks += 1
        slow = self.n_ticks % SLOW == 0
        self.dirty |= self._session.microphone.silent != self._analysis.phoneme.input_silent
        if slow and (self._session.source.playing or self._session.microphone.recording):
            self._transport.refresh()
            self.refresh_status()
        if self._pages.currentWidget() is self._analysis:
            if self.dirty and not self.frozen:
                self._draw_analysis(slow=slow, known_at=known_at)
        elif self._calibration.made is not None and self._calibration.made.isVisible():
            self._calibration.made.refresh()

    def refresh_all(self) -> None:
        """Draw everything as it is now."""
        self._move_heads()
        self._transport.refresh()
        self._analysis.refresh_fast()
        self._analysis.refresh_slow()

    def refresh_status(self) -> None:
        """Draw the status line, and the latency of the microphone."""
        self._status.refresh(frozen=self.frozen)
        self._look_ahead.show_latency(self._status.without_look_ahead)

    def _move_heads(self) -> None:
        if self.heads is not None:
            self.heads.move(frozen=self.frozen)

    def _draw_analysis(self, *, slow: bool, known_at: float | None) -> None:
        self._analysis.refresh_fast()
        if slow:
            self._analysis.refresh_slow()
            self.dirty = False
        if known_at is not None and self._session.source.kind is SourceKind.MICROPHONE:
            QTimer.singleShot(0, lambda: self._status.note_display(time.monotonic() - known_at))
