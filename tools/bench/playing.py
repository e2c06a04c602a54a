"""The whole window at 60 frames a second while a file plays: processor time of all threads, and what is missed."""

import json
import tempfile
import time
from dataclasses import asdict, dataclass
from pathlib import Path

from PySide6.QtCore import QEvent, QObject

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.session import Session
from phonemeengine.analyser import Analyser, Analysis
from phonemeengine.live.player import PART
from phonemeengine.settings import FRAME_PERIOD, HOP
from tools.bench.desktop import live_for, shown_desktop, written_speech
from tools.bench.figures import Absolute, Figure, answer_of, speech

WARM_UP, MEASURED = 2.0, 10.0
"""Seconds."""
SOONER, LATER = 1, 30
"""Simulated minutes after which it is measured."""
LIMIT, GROWTH = 0.28, 1.10
"""Most share of one core, and what is still no growth: two measurements differ by some percent."""
UNDECIDED = 3
"""Frames between what the clock says and what has been shown: a block is shown when its last frame plays."""


@dataclass(frozen=True)
class Cost:
    """What some seconds of playing took: the share of one core, pictures a second, and frames never shown."""

    share: float
    pictures: float
    missed: int


class Painted(QObject):
    """Counts how often a widget is painted."""

    n = 0

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Count, and let the event pass."""
        self.n += event.type() == QEvent.Type.Paint
        return False


def figures() -> list[Figure]:
    """Measure after one and after thirty simulated minutes, in a process of its own."""
    answer = answer_of("playing")
    sooner, later = Cost(**answer["sooner"]), Cost(**answer["later"])
    found = [
        Figure(
            f"window at 60 fps, after {minutes} min",
            f"{cost.share:.1%} of a core, {cost.pictures:.0f} fps, {cost.missed} missed",
            "one busy core",
            cost.share,
            limit=LIMIT,
            absolute=Absolute.WORK,
        )
        for minutes, cost in ((SOONER, sooner), (LATER, later))
    ]
    missed = sooner.missed + later.missed
    return [
        *found,
        Figure("its growth", f"{later.share:.1%}", f"{sooner.share:.1%}", later.share / sooner.share, limit=GROWTH),
        Figure("analyses missed", f"{missed} frames", "none", float(missed), limit=0.0),
    ]


def main() -> None:
    """Measure, and print the two costs as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        desktop = shown_desktop(Path(folder))
        desktop.window.dialogs.open_sound(written_speech(Path(folder), 2 * (WARM_UP + MEASURED) + 10))
        blocks = _live_blocks(desktop.session)
        _gather(desktop.session, blocks, SOONER)
        sooner = _measured(desktop)
        _gather(desktop.session, blocks, LATER - SOONER)
        later = _measured(desktop)
        desktop.close()
    print(json.dumps({"sooner": asdict(sooner), "later": asdict(later)}))


def _live_blocks(session: Session) -> list[Analysis]:
    """Give twelve seconds of analyses as they come while a file plays, two frames each."""
    sound, analyser, size = speech(12), Analyser(session.preset.in_force, pitch=True), PART * HOP
    return [analyser.push(sound[k : k + size]) for k in range(0, len(sound), size)]


def _gather(session: Session, blocks: list[Analysis], minutes: float) -> None:
    for _ in range(round(minutes * 60 / 12)):
        for block in blocks:
            if len(block):
                session.results.add(block)


def _measured(desktop: Desktop) -> Cost:
    session, viewport = desktop.session, desktop.window.analysis.spectrum.graphics.viewport()
    painted = Painted()
    session.play()
    live_for(WARM_UP)
    viewport.installEventFilter(painted)
    n_frames, position = session.history.n, session.source.position
    wall, processor = time.perf_counter(), time.process_time()
    live_for(MEASURED)
    processor, wall = time.process_time() - processor, time.perf_counter() - wall
    session.poll()
    due = round((session.source.position - position) / FRAME_PERIOD)
    late = due - (session.history.n - n_frames)
    viewport.removeEventFilter(painted)
    session.pause()
    return Cost(processor / wall, painted.n / wall, session.source.player.n_dropped + max(0, late - UNDECIDED))


if __name__ == "__main__":
    main()
