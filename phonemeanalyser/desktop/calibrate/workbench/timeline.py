"""What was said, and what was recognised, one above the other over all recordings."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtGui import QColor

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.lanes import Lane, lane_of_frames
from phonemeanalyser.desktop.widgets.plot_menu import PlotMenu, table_of
from phonemeanalyser.desktop.widgets.timeline import Chapter, Timeline, TimelineView
from phonemeengine.calibration.scores.confusion import Confusion
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

NAMES = (tr_noop("said"), tr_noop("recognised"))
LABELS = [phoneme.label for phoneme in Phoneme]


class ConfusionLanes(Timeline):
    """Paints labels above answers, of recordings that stand one after the other."""

    def __init__(self, theme: Theme) -> None:
        super().__init__(theme)
        self.confusion: Confusion | None = None
        self.names: list[str] = []
        self._colours = np.array([QColor(PHONEME_COLOURS[p]).rgb() for p in Phoneme], np.uint32)
        self.show_lanes([Lane(tr(name)) for name in NAMES], 0.0)

    def lanes_of(self, confusion: Confusion) -> list[Lane]:
        """Return both lanes."""
        lines = (confusion.labels.phonemes, confusion.predicted)
        return [
            lane_of_frames(tr(name), codes, LABELS, self._colours, breaks=confusion.edges[:-1].tolist())
            for name, codes in zip(NAMES, lines, strict=True)
        ]


class ConfusionTimeline(TimelineView):
    """The lanes with their scroll bar.

    Signals
    -------
    chosen : recording, start and end (seconds) of the stretch that was clicked.
    """

    chosen = Signal(int, float, float)
    lanes: ConfusionLanes

    def __init__(self, theme: Theme) -> None:
        super().__init__(ConfusionLanes(theme))
        self.menu = PlotMenu(
            self.lanes, "said and recognised", lambda _at: table_of(self._columns()), self.show_whole
        )
        self.setToolTip(tr("Click a stretch to hear it; the wheel zooms at the pointer, a drag scrolls"))
        self.setAccessibleName(tr("said and recognised"))
        self.span_clicked.connect(self._choose)

    def show_confusion(self, confusion: Confusion | None, names: list[str]) -> None:
        """Show the answers to these recordings."""
        self.lanes.confusion, self.lanes.names = confusion, names
        if confusion is None:
            self.show_lanes([Lane(tr(name)) for name in NAMES], 0.0)
            return
        starts = (confusion.edges[:-1] * FRAME_PERIOD).tolist()
        chapters = [Chapter(start, name) for start, name in zip(starts, names, strict=True)]
        self.show_lanes(self.lanes.lanes_of(confusion), len(confusion.predicted) * FRAME_PERIOD, chapters)

    def show_frame(self, recording: int, seconds: float) -> None:
        """Scroll to a place in a recording."""
        if self.lanes.confusion is not None:
            self.show_time(int(self.lanes.confusion.edges[recording]) * FRAME_PERIOD + seconds)

    def _choose(self, number: int, span: int) -> None:
        """Choose the labelled stretch, or the recognised one."""
        confusion, lane = self.lanes.confusion, self.lanes.lanes[number]
        if confusion is None:
            return
        start, end = (round(float(times[span]) / FRAME_PERIOD) for times in (lane.starts, lane.ends))
        recording = int(np.searchsorted(confusion.edges, start, side="right")) - 1
        edge = int(confusion.edges[recording])
        self.chosen.emit(recording, (start - edge) * FRAME_PERIOD, (end - edge) * FRAME_PERIOD)

    def _columns(self) -> dict[str, Sequence[object]]:
        """Return what is seen as columns, each under its name and unit."""
        confusion = self.lanes.confusion
        if confusion is None:
            return {}
        frames = np.arange(int(self.lanes.first), min(int(self.lanes.first + self.lanes.n_seen), self.lanes.n_frames))
        recordings = np.searchsorted(confusion.edges, frames, side="right") - 1
        return {
            "recording": [self.lanes.names[k] for k in recordings.tolist()],
            "time (s)": ((frames - confusion.edges[recordings]) * FRAME_PERIOD).tolist(),
            "said": [Phoneme(code).label for code in confusion.labels.phonemes[frames].tolist()],
            "recognised": [Phoneme(code).label for code in confusion.predicted[frames].tolist()],
        }
