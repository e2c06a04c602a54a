"""What was said, and what it was taken for: as a matrix, and as lanes over all recordings."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QHelpEvent, QKeyEvent, QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import AT_RIGHT, CENTRED, PHONEME_COLOURS, Theme, draw_text, letters_on
from phonemeanalyser.desktop.widgets.lanes import Lane, lane_of_frames, names_in_lanes
from phonemeanalyser.desktop.widgets.plot import PlotMenu, table_of
from phonemeanalyser.desktop.widgets.timeline import Chapter, Timeline, TimelineView
from phonemeengine.arrays import Int64Array
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES, Confusion
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

LEFT, TOP = 62, 34
SAID, TAKEN = SCORED_PHONEMES, (*SCORED_PHONEMES, Phoneme.UNIDENTIFIED)
WIDE, TALL = 58, 27
"""Pixels from which on a cell has room for the count beside the percentage, or below it; else its tip tells it."""


class ConfusionView(QWidget):
    """A row for each sound that was said, a column for what it was taken for, in percent of the row.

    Signals
    -------
    chosen : what was said, and what it was taken for.
    """

    chosen = Signal(int, int)

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.counts: Int64Array | None = None
        self.difference: Int64Array | None = None
        self.cell: tuple[int, int] | None = None
        self.setMinimumSize(LEFT + 11 * 25, TOP + 10 * 17)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(tr("Confusion matrix"))
        self.menu = PlotMenu(self, "confusion matrix", lambda _at: table_of(self._columns()))

    def show_counts(self, counts: Int64Array | None, against: Int64Array | None = None) -> None:
        """Show frames by label (row) and answer (column); with others, how much more of each row these are."""
        self.counts, self.difference = counts, against
        self.update()

    def share(self, row: int, column: int) -> float:
        """Return what a cell shows: percent of its row, or how many more than those it is compared with."""
        other = _share(self.difference, row, column) if self.difference is not None else 0.0
        return _share(self.counts, row, column) - other

    def cell_rect(self, row: int, column: int) -> QRectF:
        """Return where a cell lies."""
        width, height = (self.width() - LEFT - 2) / len(TAKEN), (self.height() - TOP - 2) / len(SAID)
        return QRectF(LEFT + column * width, TOP + row * height, width, height)

    @override
    def paintEvent(self, _event: Any) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        draw_text(
            painter, QRectF(LEFT, 1, self.width() - LEFT, 15), tr("Recognised as →"), self._theme.faint, 10, CENTRED
        )
        draw_text(
            painter, QRectF(6, TOP - 17, LEFT, 15), tr("Label ↓"), self._theme.faint, 10, Qt.AlignmentFlag.AlignLeft
        )
        short = names_in_lanes()
        for column, phoneme in enumerate(TAKEN):
            box = self.cell_rect(0, column)
            heading = QRectF(box.left(), TOP - 18, box.width(), 16)
            draw_text(painter, heading, short[phoneme], self._theme.text, 12, CENTRED)
        for row, phoneme in enumerate(SAID):
            box = self.cell_rect(row, 0)
            place = QRectF(6, box.top(), LEFT - 10, box.height())
            draw_text(painter, place, sound_name(phoneme), self._theme.text, 12)
            for column in range(len(TAKEN)):
                self._paint_cell(painter, row, column)
        if self.cell is not None:
            painter.setPen(QPen(QColor(self._theme.text), 2))
            painter.drawRect(self.cell_rect(*self.cell).adjusted(1, 1, -1, -1))

    def _columns(self) -> dict[str, Sequence[object]]:
        """Return the frames by what was said (row) and what they were taken for (column)."""
        if self.counts is None:
            return {}
        counts = self.counts
        answers: dict[str, Sequence[object]] = {
            f"recognised as {p.label} (frames of 10 ms)": [int(counts[said, p]) for said in SAID] for p in TAKEN
        }
        return {"said": [said.label for said in SAID], **answers}

    def _paint_cell(self, painter: QPainter, row: int, column: int) -> None:
        box = self.cell_rect(row, column).adjusted(0.5, 0.5, -0.5, -0.5)
        if self.counts is None or not self.counts[SAID[row]].sum():
            painter.fillRect(box, QColor(self._theme.window))
            return
        share, right = self.share(row, column), SAID[row] is TAKEN[column]
        good = right if self.difference is None else (share > 0) == right
        strength = min(1.0, abs(share) if self.difference is None else 2 * abs(share))
        fill = _blend(self._theme.raised, self._theme.good if good else self._theme.bad, strength**0.6 * 0.85)
        painter.fillRect(box, fill)
        count = int(self.counts[SAID[row], TAKEN[column]])
        if not count and abs(share) < 0.0005:
            return
        colour = letters_on(fill.name())
        percent = f"{100 * share:.0f}" if self.difference is None else f"{100 * share:+.0f}"
        if self.difference is None and box.height() >= TALL:
            upper, lower = box.adjusted(0, 1, 0, -box.height() / 2 + 3), box.adjusted(0, box.height() / 2 - 2, 0, 0)
            draw_text(painter, upper, f"{percent} %", colour, 12, CENTRED)
            draw_text(painter, lower, str(count), colour, 9, CENTRED)
        elif self.difference is None and box.width() >= WIDE:
            draw_text(painter, box.adjusted(4, 0, 0, 0), f"{percent} %", colour, 11)
            draw_text(painter, box.adjusted(0, 0, -3, 0), str(count), colour, 8, AT_RIGHT)
        else:
            draw_text(painter, box, percent if percent not in {"0", "+0", "-0"} else "·", colour, 11, CENTRED)

    # -- choosing -----------------------------------------------------------------------------------------

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        found = self._cell_at(event.position().x(), event.position().y())
        if found is not None and event.button() == Qt.MouseButton.LeftButton:
            self._choose(*found)

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        steps = {Qt.Key.Key_Left: (0, -1), Qt.Key.Key_Right: (0, 1), Qt.Key.Key_Up: (-1, 0), Qt.Key.Key_Down: (1, 0)}
        if event.key() not in steps:
            super().keyPressEvent(event)
            return
        row, column = self.cell or (0, 0)
        down, right = steps[Qt.Key(event.key())]
        self._choose(min(max(row + down, 0), len(SAID) - 1), min(max(column + right, 0), len(TAKEN) - 1))

    @override
    def event(self, event: Any) -> bool:
        if isinstance(event, QHelpEvent):
            found = self._cell_at(event.pos().x(), event.pos().y())
            if found is not None and self.counts is not None:
                QToolTip.showText(event.globalPos(), self.words_of(*found), self)
                return True
        return super().event(event)

    def phonemes_of(self, cell: tuple[int, int]) -> tuple[Phoneme, Phoneme]:
        """Return what was said and what it was taken for."""
        return SAID[cell[0]], TAKEN[cell[1]]

    def words_of(self, row: int, column: int) -> str:
        """Return what a cell holds."""
        count = int(self.counts[SAID[row], TAKEN[column]]) if self.counts is not None else 0
        share = _share(self.counts, row, column)
        said, taken = sound_name(SAID[row]), sound_name(TAKEN[column])
        return tr("{said} recognised as {taken}: {count} frames of 10 ms, {share:.1%} of {said}").format(
            said=said, taken=taken, count=count, share=share
        )

    def _choose(self, row: int, column: int) -> None:
        self.cell = row, column
        self.update()
        self.chosen.emit(int(SAID[row]), int(TAKEN[column]))

    def _cell_at(self, x: float, y: float) -> tuple[int, int] | None:
        for row in range(len(SAID)):
            for column in range(len(TAKEN)):
                if self.cell_rect(row, column).contains(x, y):
                    return row, column
        return None


def _share(counts: Int64Array | None, row: int, column: int) -> float:
    if counts is None:
        return 0.0
    of_row = counts[SAID[row]]
    return float(of_row[TAKEN[column]] / max(1, int(np.sum(of_row))))


def _blend(one: str, other: str, share: float) -> QColor:
    a, b = QColor(one), QColor(other)
    pairs = ((a.red(), b.red()), (a.green(), b.green()), (a.blue(), b.blue()))
    return QColor(*(round(p + share * (q - p)) for p, q in pairs))


NAMES = (tr_noop("Label"), tr_noop("Recognised"))


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
        sounds = list(map(sound_name, Phoneme))
        lines = (confusion.labels.phonemes, confusion.predicted)
        return [
            lane_of_frames(tr(name), codes, sounds, self._colours, breaks=confusion.edges[:-1].tolist())
            for name, codes in zip(NAMES, lines, strict=True)
        ]


class ConfusionTimeline(TimelineView):
    """The lanes with their scroll bar.

    Signals
    -------
    chosen : recording, start and end (seconds) of the segment that was clicked.
    """

    chosen = Signal(int, float, float)
    lanes: ConfusionLanes

    def __init__(self, theme: Theme) -> None:
        super().__init__(ConfusionLanes(theme))
        self.menu = PlotMenu(
            self.lanes, "said and recognised", lambda _at: table_of(self._columns()), self.show_whole
        )
        self.setToolTip(tr("Click a segment to play it; scroll the wheel to zoom, drag to pan"))
        self.setAccessibleName(tr("Labels and recognised phonemes"))
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
        """Choose the labelled segment, or the recognised one."""
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
