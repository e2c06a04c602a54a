"""A file that is opened in the window: until it is seen, until it is known, scrolled, tuned, and its memory."""

import json
import statistics
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from math import sin
from pathlib import Path

from PySide6.QtWidgets import QApplication

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.label_tiers import LabelState
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.audio.files import SoundReader
from phonemeengine.inspection.whole_sound import FrameState
from phonemeengine.labels.files import read_raw_labels
from phonemeengine.labels.phone_sets import PhonemeMap
from phonemeengine.labels.textgrid import Tier
from phonemeengine.presets.files import THESIS_PRESET, preset_path
from tools.bench.desktop import live_for, shown_desktop, written_speech
from tools.bench.figures import DEMO, Absolute, Figure, answer_of
from tools.bench.memory import Highest, resident_megabytes
from tools.bench.speed import scaled_work

TEN_MINUTES, HOUR = 600.0, 3600.0
FIRST, WHOLE, SHARE, LANE, COURSE, MOST_MB = 0.3, 4.0, 0.3, 0.05, 0.03, 150
N_STEPS = 25
"""Of a drag."""
PICTURES = 60
"""A second."""
PATIENCE = 600.0
"""Seconds."""


def figures() -> list[Figure]:
    """Measure in a process of its own."""
    found = answer_of("opened_file")
    times = (
        ("10 minutes opened while they play, first picture", found["first"], FIRST),
        ("10 minutes, all known", found["whole"], WHOLE),
    )
    drags = (
        ("an hour, threshold of the thesis dragged, lane redrawn", found["lane"], LANE),
        ("an hour, the same, courses of its rule redrawn", found["course"], COURSE),
        ("an hour of labelled file, the same, score redrawn", found["score"], LANE),
        ("an hour of labelled file, extended rules dragged, score redrawn", found["score_extended"], LANE),
    )
    above = found["highest"] - found["empty"]
    return [
        *(
            Figure(name, f"{seconds:.3f} s", f"{limit:g} s", seconds / limit, 1.0, absolute=Absolute.TIME)
            for name, seconds, limit in times
        ),
        *(
            Figure(name, f"{1e3 * seconds:.0f} ms, scaled", f"{1e3 * limit:g} ms", seconds / limit, 1.0)
            for name, seconds, limit in drags
        ),
        Figure(
            "an hour scrolled and zoomed at 60 fps",
            f"{found['share']:.1%} of a core, {found['pictures']:.0f} fps",
            f"{SHARE:.0%}",
            found["share"] / SHARE,
            1.0,
            absolute=Absolute.WORK,
        ),
        Figure("an hour, above the empty window", f"{above:.0f} MB", f"{MOST_MB} MB", above / MOST_MB, 1.0),
    ]


def main() -> None:
    """Measure, and print all as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        desktop = shown_desktop(Path(folder))
        desktop.preset.load(THESIS_PRESET)
        (Path(folder) / "hour").mkdir()
        ten, hour = written_speech(Path(folder), TEN_MINUTES), written_speech(Path(folder) / "hour", HOUR)
        first, whole = _opened(desktop, ten)
        desktop.session.stop()
        empty, highest = resident_megabytes(), Highest()
        desktop.window.dialogs.open_sound(hour)
        _until(lambda: not desktop.session.busy)
        desktop.session.view.show_all()
        _until(lambda: not desktop.session.busy)
        lane, course = _tuned(desktop), _drawn(desktop)
        share, pictures = _scrolled(desktop)
        most = highest.megabytes
        score, score_extended = (_scored(desktop, preset) for preset in (THESIS_PRESET, preset_path("extended")))
        found = {
            "first": first,
            "whole": whole,
            "lane": lane,
            "course": course,
            "score": score,
            "score_extended": score_extended,
            "share": share,
            "pictures": pictures,
            "empty": empty,
            "highest": most,
        }
        desktop.close()
    print(json.dumps(found))


def _opened(desktop: Desktop, path: Path) -> tuple[float, float]:
    """Open and play a file; the seconds until what is in view is drawn, and until all of it is known."""
    session, view = desktop.session, desktop.window.analysis.file.view
    began = time.perf_counter()
    desktop.window.dialogs.open_sound(path)
    session.play()

    def seen() -> bool:
        tracks, last = session.whole.tracks, int(100 * session.view.seen.end) - 1
        known = tracks is not None and tracks.states[last] == FrameState.KNOWN
        return known and bool(session.sonagram.tiles_for(session.view.seen, view.width()))

    _until(seen)
    view.repaint()
    first = time.perf_counter() - began
    _until(lambda: not session.whole.busy)
    return first, time.perf_counter() - began


def _tuned(desktop: Desktop) -> float:
    """Drag a threshold with the whole hour in view; what it takes until the lane is drawn anew."""
    preset, view = desktop.preset, desktop.window.analysis.file.view

    def move(k: int) -> None:
        thresholds = replace(preset.preset.thresholds, silence_energy=0.2 + 0.01 * k)
        preset.edit(replace(preset.preset, thresholds=thresholds), "bench")
        assert not desktop.session.whole.busy, "the hour is analysed anew"
        view.repaint()

    return _work_of(move)


def _drawn(desktop: Desktop) -> float:
    """Drag a threshold with the whole hour in view; what it takes until its courses are drawn anew."""
    analysis, view = desktop.window.analysis, desktop.window.analysis.file.view
    analysis.courses.touch("silence_energy")
    view.repaint()

    def move(k: int) -> None:
        analysis.courses.lines.move("silence_energy", 0.2 + 0.01 * k)
        rows = [*view.course_rows().values()]
        view.repaint(rows[0].united(rows[-1]).toAlignedRect())

    taken = _work_of(move)
    analysis.courses.lines.end_move()
    return taken


def _scored(desktop: Desktop, preset: Path) -> float:
    """Drag a control over the hour, which is labelled; what it takes until all that shows it is drawn anew."""
    model, session = desktop.preset, desktop.session
    model.load(preset)
    with SoundReader(DEMO) as reader:
        length = reader.duration
    raw = read_raw_labels(DEMO.with_suffix(".csv"), PhonemeMap(), duration=length)
    again = (
        replace(r, start=r.start + k * length, end=r.end + k * length) for k in range(int(HOUR / length)) for r in raw
    )
    session.labels.put(LabelState((Tier("phones", tuple(again)),), (0,), 0))
    _until(lambda: not session.busy and not session.score.busy)
    controls = [control for control in model.controls.values() if control.variable]
    control = max(controls, key=lambda control: len(control.places))
    strip, value = desktop.window.analysis.score, control.read(model.preset)

    def move(k: int) -> None:
        model.tune(control.name, value * (1.02 + 0.001 * k))
        _until(lambda: not session.score.busy)
        strip.repaint()

    return _work_of(move)


def _work_of(move: Callable[[int], None]) -> float:
    """Return the seconds of the processor that a step of a drag takes, scaled: the median of many."""
    move(0)  # the first one begins the drag
    return statistics.median(scaled_work(partial(move, k)) for k in range(1, N_STEPS + 1))


def _scrolled(desktop: Desktop) -> tuple[float, float]:
    """Scroll and zoom for some seconds; the share of a core, and the pictures a second."""
    session = desktop.session
    live_for(1.0)
    began, worked, n = time.perf_counter(), time.process_time(), 0
    while time.perf_counter() - began < 8.0:
        at = time.perf_counter() - began
        seconds = 20 * 4 ** (1.5 * sin(at))
        middle = HOUR / 2 + 600 * sin(at / 2)
        session.view.show(TimeSpan(middle - seconds / 2, middle + seconds / 2))
        n += 1
        live_for(max(0.0, (n / PICTURES) - (time.perf_counter() - began)))
    elapsed = time.perf_counter() - began
    return (time.process_time() - worked) / elapsed, n / elapsed


def _until(done: Callable[[], bool]) -> None:
    """Let the window live until something is so."""
    deadline = time.monotonic() + PATIENCE
    while not done():
        assert time.monotonic() < deadline, "the window did not come to an end"
        QApplication.processEvents()
        time.sleep(0.002)


if __name__ == "__main__":
    main()
