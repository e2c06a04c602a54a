"""Where things lie in the view of a file: its rows from above, and times from left to right."""

from collections.abc import Mapping

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.analyse.lanes.feeling_lane import FEELING_HEIGHT
from phonemeanalyser.desktop.analyse.lanes.sonagram import side_width
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.lanes import TIME_HEIGHT, Lane, TimeAxis
from phonemeengine.labels.files import TIER_NAMES
from phonemeengine.labels.textgrid import Tier
from phonemeengine.labels.tiers import SHORTEST
from phonemeengine.labels.timed_words import SYLLABLE_TIER, WORD_TIER

LEFT, GAP = 52, 3
LANE_HEIGHT, LABEL_HEIGHT = 22, 19
LANE = 1
"""Number of the row of what is recognised."""
MOST_LANES = 0.4
"""Of the height, that lanes of labels take at most."""
WAVE_SHARE, COURSE_SHARE = 0.16, 0.22
"""Of the height that the lane and the axis leave."""
FURTHER_SHARE, MOST_COURSE_SHARE = 0.07, 0.6
"""The same for each further course, and for all courses at most."""


SHOWN_BY = {
    tr_noop("Words"): (WORD_TIER,),
    tr_noop("Syllables"): (SYLLABLE_TIER, WORD_TIER),
    tr_noop("Phones"): TIER_NAMES,
}
"""The lanes of what is said, and what the names of tiers begin with that stand for them: syllables that a file with
words does not have would be invented."""
CERTAINTIES = (tr_noop("ambiguous"), tr_noop("diphthong"), tr_noop("affricate"))
"""Why labels are in doubt; other words of a file are shown as they stand there."""


class FileLayout:
    """The places of rows, lanes and times on a widget, as they are now.

    Parameters
    ----------
    session : what is seen of the file, and its labels.
    widget : what is painted on.
    theme : the colours of labels.

    Attributes
    ----------
    spoken : lanes of what is said.
    n_courses : how many variables are drawn.
    """

    def __init__(self, session: Session, widget: QWidget, theme: Theme) -> None:
        self._session, self._widget, self._theme = session, widget, theme
        self.spoken: list[Lane] = []
        self.n_courses = 1
        self._lanes: dict[int, tuple[Tier, tuple[int | None, bool], Lane]] = {}

    @property
    def width(self) -> int:
        """Pixels between the axis at the left and the right edge."""
        return max(1, self._widget.width() - LEFT - side_width(self._session.sonagram))

    def rows(self) -> tuple[QRectF, QRectF, QRectF, QRectF]:
        """Return where sonagram, lane, waveform and courses lie, from above."""
        lanes = (len(self.tiers_shown()) + len(self.spoken_shown())) * (LABEL_HEIGHT + 1)
        lanes += LANE_HEIGHT + 1 if self._session.second.is_there else 0
        lanes += FEELING_HEIGHT + 1 if self.shows_feeling else 0
        room = max(0, self._widget.height() - LANE_HEIGHT - lanes - TIME_HEIGHT - 3 * GAP)
        share = min(COURSE_SHARE + (self.n_courses - 1) * FURTHER_SHARE, MOST_COURSE_SHARE)
        wave, course = WAVE_SHARE * room, share * room
        heights = (room - wave - course, LANE_HEIGHT, wave, course)
        rows, top = [], 0.0
        for k, height in enumerate(heights):
            rows.append(QRectF(LEFT, top, self.width, height))
            top += height + GAP + (lanes if k == LANE else 0)
        return rows[0], rows[1], rows[2], rows[3]

    @property
    def shows_feeling(self) -> bool:
        """Whether the feeling in the voice has a lane."""
        return "feeling" in self._session.sonagram.overlays

    def feeling_row(self) -> QRectF | None:
        """Return where the feeling in the voice lies, under all other lanes; None where it is not shown."""
        wave = self.rows()[2]
        place = QRectF(LEFT, wave.top() - GAP - FEELING_HEIGHT, self.width, FEELING_HEIGHT)
        return place if self.shows_feeling else None

    def second_row(self) -> QRectF | None:
        """Return where the lane of preset B lies; None without one."""
        if not self._session.second.is_there:
            return None
        first = self.rows()[LANE]
        return first.translated(0, first.height() + 1)

    def label_rows(self) -> dict[int, QRectF]:
        """Return where the tiers that are shown lie, under the lane of what is recognised."""
        second = self.second_row()
        top = (self.rows()[LANE] if second is None else second).bottom() + 1
        step = LABEL_HEIGHT + 1
        return {
            tier: QRectF(LEFT, top + k * step, self.width, LABEL_HEIGHT) for k, tier in enumerate(self.tiers_shown())
        }

    def label_lanes(self) -> list[tuple[QRectF, Lane]]:
        """Return the tiers that are shown as lanes, whose boundaries can be dragged, and where they lie."""
        return [(row, self._lane_of(tier)) for tier, row in self.label_rows().items()]

    def _lane_of(self, number: int) -> Lane:
        state, chosen = self._session.labels.state, self._session.labels.chosen
        tier = state.tiers[number]
        mark = chosen.label if chosen is not None and chosen.tier == number else None
        said = number == state.said
        known = self._lanes.get(number)
        if known is None or known[0] is not tier or known[1] != (mark, said):  # tiers are long: never compare them
            doubts = self._session.labels.doubts(number)
            lane = _lane_of_tier(tier, mark, doubts, self._theme, duration=self._session.labels.duration, said=said)
            known = self._lanes[number] = tier, (mark, said), lane
        return known[2]

    def tiers_shown(self) -> tuple[int, ...]:
        """Return the tiers that are shown, as many as leave the sonagram room; a microphone's recording has none."""
        most = max(1, int(MOST_LANES * self._widget.height()) // (LABEL_HEIGHT + 1))
        return () if self._session.seen.looks_back else self._session.labels.state.shown[:most]

    def spoken_shown(self) -> list[Lane]:
        """Return the lanes of what is said of which no tier is there already, shown or not."""
        if self._session.seen.looks_back or "words" not in self._session.sonagram.overlays:
            return []
        names = [tier.name.lower() for tier in self._session.labels.tiers if not tier.points]
        tiers = {tr(name) for name, begins in SHOWN_BY.items() if any(tier.startswith(begins) for tier in names)}
        return [lane for lane in self.spoken if lane.name not in tiers]

    def spoken_rows(self) -> list[tuple[QRectF, Lane]]:
        """Return where the lanes of what is said lie, under the labels."""
        labels, second = self.label_rows(), self.second_row()
        above = max([row.bottom() for row in labels.values()], default=0.0)
        top = above or (self.rows()[LANE] if second is None else second).bottom()
        step = LABEL_HEIGHT + 1
        return [
            (QRectF(LEFT, top + 1 + k * step, self.width, LABEL_HEIGHT), lane)
            for k, lane in enumerate(self.spoken_shown())
        ]

    @property
    def axis(self) -> TimeAxis:
        """Where times lie."""
        seen = self._session.view.seen
        return TimeAxis(LEFT, self.width, seen.start, max(seen.seconds, 1e-9))

    def x_of(self, seconds: float) -> float:
        """Return where a time lies, pixels from the left."""
        return self.axis.x_of(seconds)

    def time_at(self, x: float) -> float:
        """Return the time at a number of pixels from the left, seconds."""
        return self.axis.time_at(x)


def _lane_of_tier(
    tier: Tier, chosen: int | None, doubts: Mapping[int, str], theme: Theme, *, duration: float, said: bool
) -> Lane:
    """Return a tier as a lane; a point reaches to the next one, and those of what is said stand out."""
    tip = tr("{name}: {certainty}. It isn't compared with the recognised phoneme, and is never an error.")
    starts, ends = (np.array([getattr(raw, edge) for raw in tier.raw_labels], float) for edge in ("start", "end"))
    colours = np.full(len(starts), QColor(theme.field).rgb(), np.uint32)
    if chosen is not None:
        colours[chosen : chosen + 1] = QColor(theme.accent).rgb()
    return Lane(
        tier.name,
        starts,
        np.append(starts[1:], max(duration, starts[-1])) if tier.points and len(starts) else ends,
        [raw.name for raw in tier.raw_labels],
        colours,
        doubtful=frozenset(doubts),
        tips=[
            tip.format(name=raw.name, certainty=tr(doubts[k])) if k in doubts else ""
            for k, raw in enumerate(tier.raw_labels if doubts else ())
        ],
        movable=not tier.points,
        outline=theme.faint if said else theme.line,
        are_points=tier.points,
        least=SHORTEST,
    )
