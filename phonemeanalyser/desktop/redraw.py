"""When what is drawn: 60 pictures a second, of what is seen and new."""

import time

from PySide6.QtCore import QObject, Qt, QTimer

from phonemeanalyser.desktop.analyse.page import AnalysisPage
from phonemeanalyser.desktop.analyse.phoneme_view import PhonemeView
from phonemeanalyser.desktop.analyse.threshold_view import ThresholdView
from phonemeanalyser.desktop.analyse.transport import Transport
from phonemeanalyser.desktop.calibrate.page import CalibrationPage
from phonemeanalyser.desktop.heads import Heads
from phonemeanalyser.desktop.session.session import Session, SoundSource
from phonemeanalyser.desktop.session.status_line import StatusLine
from phonemeanalyser.desktop.widgets.pages import LazyPage, PageStack

FRAME_MS = 16
"""Between two pictures: 60 a second."""
SLOW = 4
"""Numbers and what changes slowly are drawn at every fourth picture."""


class RedrawLoop(QObject):
    """Gathers what is new and draws it: fast views each time, slow ones each fourth time.

    Attributes
    ----------
    frozen : whether the views are held still while sound goes on.
    stale : whether the analysis must be drawn anew though nothing was heard.
    n_ticks : pictures so far.
    """

    def __init__(
        self, parent: QObject, session: Session, pages: PageStack, analysis: AnalysisPage,
        calibrating: LazyPage[CalibrationPage], heads: Heads, phoneme: PhonemeView, thresholds: ThresholdView,
        transport: Transport, status: StatusLine,
    ) -> None:  # fmt: skip
        super().__init__(parent)
        self.frozen = False
        self.stale = True
        self.n_ticks = 0
        self._session = session
        self._pages = pages
        self._analysis = analysis
        self._calibrating = calibrating
        self._heads = heads
        self._phoneme = phoneme
        self._thresholds = thresholds
        self._transport = transport
        self._status = status
        self.timer = QTimer(self)
        self.timer.setTimerType(Qt.TimerType.PreciseTimer)
        self.timer.timeout.connect(self.tick)
        self.timer.start(FRAME_MS)

    def tick(self) -> None:
        """Draw the next picture."""
        known_at = None
        if self._session.poll():
            self.stale = True
            known_at = time.monotonic() - self._session.microphone.known_for
        self._heads.move(frozen=self.frozen)
        self.n_ticks += 1
        slow = self.n_ticks % SLOW == 0
        self.stale |= self._session.input_silent != self._phoneme.input_silent
        if slow and (self._session.playing or self._session.microphone.recording):
            self._transport.refresh()
            self.refresh_status()
        if self._pages.currentWidget() is self._analysis:
            if self.stale and not self.frozen:
                self._draw_analysis(slow=slow, known_at=known_at)
        elif self._calibrating.made is self._pages.currentWidget():
            self._calibrating.get().refresh()

    def refresh_all(self) -> None:
        """Draw everything as it is now."""
        self._heads.move(frozen=self.frozen)
        self._transport.refresh()
        self._analysis.refresh_fast()
        self._refresh_slow()

    def refresh_status(self) -> None:
        """Draw the status line."""
        self._status.refresh(frozen=self.frozen)

    def _draw_analysis(self, *, slow: bool, known_at: float | None) -> None:
        self._analysis.refresh_fast()
        if slow:
            self._refresh_slow()
            self.stale = False
        elif self._phoneme.is_outdated:
            self._phoneme.refresh()
        if known_at is not None and self._session.source is SoundSource.MICROPHONE:
            QTimer.singleShot(0, lambda: self._status.note_display(time.monotonic() - known_at))

    def _refresh_slow(self) -> None:
        self._analysis.refresh_slow()
        self._phoneme.refresh()
        self._thresholds.refresh()
