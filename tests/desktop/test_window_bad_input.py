"""Files and labels as nobody wants them: one sentence, and what was there stays."""

import resource
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtTest import QTest

from phonemeanalyser.desktop.analyse.lanes.label_dialogs import TiersDialog
from phonemeanalyser.desktop.export_dialog import ExportDialog
from phonemeanalyser.desktop.session.exports import ExportState
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.inspection.whole_sound import FrameState
from phonemeengine.labels.textgrid import Tier
from phonemeengine.labels.tiers import read_tiers, write_tiers
from phonemeengine.labels.utterance import RawLabel
from tests.desktop.hands import CARDS, DEMO, LEFT, shown, wav
from tests.sounds import noise

SECONDS = 2.0


@pytest.fixture
def sound(tmp_path: Path) -> Path:
    return wav(tmp_path, noise(SECONDS, 0.1))


def cut_off(path: Path) -> None:
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 3])


def made_shorter(path: Path) -> None:
    wav(path.parent, noise(0.3, 0.1))


def made_longer(path: Path) -> None:
    wav(path.parent, noise(9.0, 0.1))


def emptied(path: Path) -> None:
    path.write_bytes(b"")


def made_a_text(path: Path) -> None:
    path.write_text("no sound any more\n" * 999)


def deleted(path: Path) -> None:
    path.unlink()


@pytest.mark.parametrize(
    "change",
    [
        cut_off,
        deleted,
        *(
            pytest.param(change, marks=pytest.mark.long)
            for change in (made_longer, made_shorter, emptied, made_a_text)
        ),
    ],
)
def test_a_file_that_changes_while_it_is_open_leaves_the_window_as_it_was(
    desktop, qtbot, sound, change: Callable[[Path], object]
):
    window, session, errors = shown(desktop, qtbot, sound), desktop.session, []
    session.error.connect(errors.append)
    qtbot.waitUntil(lambda: not session.busy)
    known, duration = session.whole.tracks.phonemes.copy(), session.source.duration
    change(sound)
    session.view.show(TimeSpan(0.7, 0.8))  # finer than what is measured of the sonagram
    window.analysis.sonagram.overlays["formants"].setChecked(True)
    session.view.select(TimeSpan(1.5, 1.9))
    for act in (window.selection.measure, window.dialogs.curves.add_selection):
        act()
    desktop.preset.set_setting("minimum_hold", 0.05)
    session.seek(1.5)
    session.play()
    qtbot.waitUntil(lambda: bool(errors) or session.source.position > 1.6 or not session.source.playing)
    session.stop()
    qtbot.waitUntil(lambda: not session.busy and not window.selection._work.busy)
    window.analysis.file.view.repaint()
    assert all(error.count("\n") == 0 and "sound.wav" in error for error in errors)
    assert len(set(errors)) <= 6
    assert errors or change is made_longer
    assert session.source.duration == duration
    assert len(session.whole.tracks.phonemes) == len(known)
    window.dialogs.open_sound(CARDS)  # and another one is as good as ever
    qtbot.waitUntil(lambda: not session.busy)
    assert (session.whole.tracks.states == FrameState.KNOWN).all()


def test_a_chip_says_that_another_program_changed_the_file_and_opens_it_again(desktop, qtbot, sound):
    chips = shown(desktop, qtbot, sound).status.chips
    qtbot.waitUntil(lambda: not desktop.session.busy)
    assert chips.words() == ""
    made_longer(sound)
    qtbot.waitUntil(lambda: chips.words() == "changed on disk")
    assert "sound.wav" in chips.changed.toolTip()
    QTest.mouseClick(chips.changed, LEFT)
    assert desktop.session.source.duration == 9.0
    assert chips.words() == ""
    sound.unlink()
    qtbot.waitUntil(lambda: chips.words() == "missing on disk")
    assert desktop.session.source.duration == 9.0


def labels_until(end: float) -> tuple[Tier, ...]:
    times = np.arange(0.0, end, 0.25).tolist()
    return (Tier("phones", tuple(RawLabel(t, t + 0.25, "s" if k % 2 else "a", "") for k, t in enumerate(times))),)


def test_labels_longer_than_the_sound_or_that_overlap_are_one_sentence_and_stay_in_their_file(
    desktop, qtbot, sound, tmp_path
):
    grid, other = sound.with_suffix(".TextGrid"), wav(tmp_path, noise(SECONDS, 0.1), "other.wav")
    write_tiers(labels_until(60.0), grid, duration=60.0)
    other.with_suffix(".txt").write_text("0.0\t0.8\ta\n0.5\t1.0\ts\n")
    window, session = shown(desktop, qtbot, sound), desktop.session
    assert "sound.TextGrid" in window.banner.label.text()
    assert session.source.duration == SECONDS
    assert session.labels.tiers == ()
    assert read_tiers(grid)[0].raw_labels[-1].end == 60.0
    session.open(other)
    assert session.source.duration == SECONDS
    assert session.labels.tiers == ()
    assert "must not overlap" in window.banner.label.text()


def test_a_thousand_tiers_leave_the_sonagram_its_room(desktop, qtbot, sound):
    tiers = tuple(Tier(f"tier {k}", labels_until(SECONDS)[0].raw_labels) for k in range(1000))
    write_tiers(tiers, sound.with_suffix(".TextGrid"), duration=SECONDS)
    window, labels = shown(desktop, qtbot, sound), desktop.session.labels
    assert len(labels.tiers) == 1000
    view = window.analysis.file.view
    dialog = TiersDialog(labels, window)
    qtbot.addWidget(dialog)
    labels.show(range(1000), 0)
    qtbot.waitUntil(lambda: not desktop.session.busy)
    view.repaint()
    sonagram = view.file_layout.rows()[0]
    assert sonagram.height() >= view.height() / 5
    assert sonagram.bottom() < view.height()
    assert max(row.bottom() for row in view.file_layout.label_rows().values()) < view.height()
    QTest.mouseClick(view, LEFT, pos=QPoint(view.width() // 2, view.height() // 2))


def test_a_selection_of_nothing_is_one_sentence(desktop, qtbot, sound):
    window, session, told = shown(desktop, qtbot, sound), desktop.session, []
    qtbot.waitUntil(lambda: not session.busy)
    window.selection.error.connect(told.append)
    window.selection.info.connect(told.append)
    for span in ((1.0, 1.0), (1.0, 1.000001), (5.0, 6.0), (-3.0, -1.0)):
        told.clear()
        session.view.select(TimeSpan(*span))
        for act in (
            window.selection.measure,
            window.dialogs.curves.add_selection,
            window.selection.play,
            window.selection.zoom,
        ):
            act()
        window.selection_dialogs.copy_frames()
        qtbot.waitUntil(lambda: not window.selection._work.busy)
        assert told, span
        assert all(sentence.count("\n") == 0 for sentence in told)
        assert session.view.seen.seconds > 0


@pytest.fixture
def exporting(desktop, qtbot, tmp_path: Path) -> ExportDialog:
    window = shown(desktop, qtbot, None)
    for name in ("one.flac", "two.flac"):
        shutil.copy(DEMO, tmp_path / name)
    window.dialogs.show_export([tmp_path])
    (dialog,) = (d for d in window.findChildren(ExportDialog) if d.isVisible())
    dialog.choices.kind.setCurrentIndex(dialog.choices.kind.findData("frames-csv"))
    return dialog


def test_an_export_where_nobody_may_write_is_one_sentence_each(exporting, qtbot):
    exporting.write_into(Path("/proc/nowhere"))
    with qtbot.waitSignal(exporting.queue.finished):
        QTest.mouseClick(exporting.start, LEFT)
    assert [job.state for job in exporting.queue.jobs] == [ExportState.FAILED] * 2
    assert all("\n" not in job.words and job.words for job in exporting.queue.jobs)


def test_an_export_to_a_full_disk_is_one_sentence_and_leaves_what_was_there(exporting, qtbot, tmp_path):
    """A limit to the size of files takes the disk's place."""
    before = tmp_path / "one.csv"
    before.write_text("somebody's own\n")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, limits[1]))
    try:
        with qtbot.waitSignal(exporting.queue.finished):
            QTest.mouseClick(exporting.start, LEFT)
            QTest.mouseClick(exporting.replace, LEFT)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert [job.state for job in exporting.queue.jobs] == [ExportState.FAILED] * 2
    assert all("cannot be written" in job.words for job in exporting.queue.jobs)
    assert before.read_text() == "somebody's own\n"
    assert {path.name for path in tmp_path.glob("*.csv*")} == {"one.csv"}


def test_a_batch_that_is_cancelled_keeps_what_is_complete(exporting, qtbot, tmp_path):
    queue = exporting.queue
    with qtbot.waitSignal(queue.finished):
        QTest.mouseClick(exporting.start, LEFT)
        qtbot.waitUntil(lambda: queue.jobs[0].state is ExportState.DONE)
        QTest.mouseClick(exporting.cancel, LEFT)
    states = [job.state for job in queue.jobs]
    assert states[0] is ExportState.DONE
    qtbot.waitUntil(lambda: not queue.busy)
    assert ExportState.WORKING not in {job.state for job in queue.jobs}
    assert "running" not in exporting.told.text()
    whole = {job.target.name for job in queue.jobs if job.state is ExportState.DONE}
    qtbot.waitUntil(lambda: {path.name for path in tmp_path.glob("*.csv*")} == whole)
