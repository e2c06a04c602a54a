"""Takes by mouse and keyboard: recorded, marked, trimmed, relabelled, excluded, deleted, and all that undone."""

from collections.abc import Callable

import numpy as np
import pytest
import soundfile
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDockWidget

from phonemeanalyser.desktop.calibrate.takes.takes_model import AROUND
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.widgets.keyboard import KEYS
from phonemeengine.analyser import Analysis
from phonemeengine.calibration.scores.corpus import read_corpus
from phonemeengine.labels.utterance import CORE
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import DEFAULT_PRESET
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE
from tests.desktop.calibrate.calibrating import CONTROL, Calibrator, in_room, said
from tests.desktop.conftest import begin
from tests.desktop.hands import DEMO, LEFT, answer, choose, click, copied, drag, edits, press, settle
from tests.desktop.studio import Booth
from tests.fakes.microphones import HandDrivenMicrophone
from tests.sounds import silence

Open = Callable[..., Booth]
A = in_room(np.concatenate((silence(0.2), said(Phoneme.A, 0.6), silence(0.2))))


@pytest.fixture
def calibrator(open_booth: Open, mic: HandDrivenMicrophone) -> Calibrator:
    return Calibrator(open_booth(mic), mic)


@pytest.fixture
def listening(calibrator: Calibrator) -> Calibrator:
    calibrator.listen()
    return calibrator


def verdicts(calibrator: Calibrator) -> list[str]:
    table = calibrator.page.takes.list
    return [table.item(row, 4).text() for row in range(table.rowCount())]


# -- the page -----------------------------------------------------------------------------------------


def test_keys_and_buttons_show_the_pages_and_each_has_its_docks(open_booth: Open, mic: HandDrivenMicrophone):
    window = open_booth(mic).window
    docks = {d.objectName(): (d.isVisible(), d.width()) for d in window.findChildren(QDockWidget)}
    press(window, Qt.Key.Key_2, CONTROL)
    assert window.calibration.isVisible()
    assert not any(d.isVisible() for d in window.findChildren(QDockWidget))
    click(window.switch.buttons[0])
    assert not window.calibration.isVisible()
    settle()
    assert {d.objectName(): (d.isVisible(), d.width()) for d in window.findChildren(QDockWidget)} == docks
    click(window.switch.buttons[1])
    assert window.calibration.isVisible()
    press(window, Qt.Key.Key_1, CONTROL)
    assert not window.calibration.isVisible()


@pytest.mark.long
@pytest.mark.usefixtures("open_own_booth")
def test_the_page_survives_another_theme_with_its_takes(calibrator: Calibrator):
    calibrator.keep(Phoneme.A)
    calibrator.booth.desktop.set_theme("dark")
    assert calibrator.page.isVisible()
    assert verdicts(calibrator) == ["good"]
    click(calibrator.booth.window.switch.buttons[0])
    seen = {d.objectName() for d in calibrator.booth.window.findChildren(QDockWidget) if d.isVisible()}
    assert seen == {"Filters", "Spectra", "Phoneme", "Variable", "Thresholds", "Rules"}


# -- recording ----------------------------------------------------------------------------------------


def test_what_is_heard_while_a_key_or_a_button_is_held_becomes_a_take(listening: Calibrator):
    panel, heard = listening.page.takes, listening.model.capture
    panel.speaker.setText("")
    click(panel.speaker)
    QTest.keyClicks(panel.speaker, "Maesh")
    assert listening.model.phoneme is None  # letters of a name record nothing
    press(listening.booth.window, Qt.Key.Key_Return)  # leaves the field
    listening.say(Qt.Key.Key_A, A)
    (take,) = listening.takes
    assert (take.speaker, take.phoneme) == ("Maesh", Phoneme.A)
    samples, rate = soundfile.read(listening.model.takes.path_of(take), dtype="float32")
    assert (rate, len(samples)) == (SAMPLE_RATE, len(A))
    np.testing.assert_allclose(samples, A, atol=2**-15)
    assert take.start == pytest.approx(0.2, abs=0.07)
    assert take.end == pytest.approx(0.8, abs=0.07)
    assert verdicts(listening) == ["good"]
    (utterance,) = read_corpus(listening.model.takes.folder)
    assert Phoneme.A in {label.phoneme for label in utterance.labels}
    button = panel.record.buttons[Phoneme.I]
    QTest.mousePress(button, LEFT)
    listening.booth.give(listening.mic, in_room(said(Phoneme.I, 0.7)))
    listening.until(lambda: heard.seconds >= 0.7)
    QTest.mouseRelease(button, LEFT)
    listening.settle()
    assert [take.phoneme for take in listening.takes] == [Phoneme.A, Phoneme.I]
    QTest.keyPress(panel.list, Qt.Key.Key_A)
    listening.booth.give(listening.mic, A)
    listening.until(lambda: heard.seconds >= 0.9)
    QCoreApplication.sendEvent(listening.booth.window, QEvent(QEvent.Type.WindowDeactivate))  # loses the keyboard
    listening.settle()
    assert len(listening.takes) == 3


def test_each_sound_has_a_key_of_its_own_which_begins_to_listen_and_holds_its_button_down(calibrator: Calibrator):
    assert calibrator.booth.desktop.session.source.kind is SourceKind.FILE
    calibrator.say(Qt.Key.Key_A, A)
    assert calibrator.booth.desktop.session.source.kind is SourceKind.MICROPHONE
    assert len(calibrator.takes) == 1
    for phoneme, letter in KEYS.items():
        key = getattr(Qt.Key, f"Key_{letter}")
        QTest.keyPress(calibrator.page.takes.list, key)
        assert calibrator.model.phoneme is phoneme
        assert calibrator.page.takes.record.buttons[phoneme].isDown()
        calibrator.let_go(key)
        assert calibrator.model.phoneme is None


def test_a_key_that_a_busy_system_repeats_as_presses_and_releases_is_one_take(listening: Calibrator):
    takes, heard = listening.page.takes.list, listening.model.capture
    QTest.keyPress(takes, Qt.Key.Key_A)
    part = A[: len(A) // 2205 * 441]
    for n in range(1, 4):
        listening.booth.give(listening.mic, part)
        listening.until(lambda n=n: heard.seconds >= n * len(part) / SAMPLE_RATE - 1e-9)
        QTest.keyRelease(takes, Qt.Key.Key_A)
        QTest.keyPress(takes, Qt.Key.Key_A)
        assert not listening.page.keys.settling.isActive()
    listening.let_go(Qt.Key.Key_A)
    listening.settle()
    (take,) = listening.takes
    assert take.duration == pytest.approx(3 * len(part) / SAMPLE_RATE, abs=0.011)  # a frame of 10 ms
    QTest.keyPress(takes, Qt.Key.Key_A)
    QTest.keyRelease(takes, Qt.Key.Key_A)
    QTest.keyPress(takes, Qt.Key.Key_I)  # another key at once begins another take
    assert listening.model.phoneme is Phoneme.I
    listening.let_go(Qt.Key.Key_I)
    assert listening.model.phoneme is None


def test_a_take_that_is_too_short_or_silent_counts_for_nothing_until_the_user_says_so(listening: Calibrator):
    booth = listening.booth
    listening.say(Qt.Key.Key_A, A[: 441 * 15])  # a tap: the key counts as held until it has settled
    assert listening.takes == ()
    assert "Hold a for as long as you say the sound" in booth.banner
    listening.say(Qt.Key.Key_A, A[: 441 * 30])  # 0.2 s of quiet, and 0.1 s of an a
    assert verdicts(listening) == ["too short"]
    assert booth.banner.startswith("a-1 is excluded: The sound lasted only")
    listening.say(Qt.Key.Key_A, in_room(silence(0.8)))
    assert verdicts(listening) == ["too short", "silent"]
    assert [take.excluded for take in listening.takes] == [True, True]
    assert listening.model.workbench.utterances == ()
    listening.say(Qt.Key.Key_A, np.clip(5 * A, -1, 1))
    assert verdicts(listening)[2] == "clipped"
    assert "The recording is clipped" in booth.banner
    assert "excluded" not in booth.banner  # what was wrong with the take before is no longer news
    click_row(listening, 2)
    press(booth.window, Qt.Key.Key_Delete)
    listening.settle()
    click_row(listening, 0)
    press(booth.window, Qt.Key.Key_X)
    listening.settle()
    assert [take.excluded for take in listening.takes] == [False, True]
    assert len(listening.model.workbench.utterances) == 1


def test_takes_are_excluded_or_deleted_one_or_several_at_a_time_and_brought_back(calibrator: Calibrator):
    for phoneme in (Phoneme.A, Phoneme.E, Phoneme.I):
        calibrator.keep(phoneme)
    window, takes = calibrator.booth.window, calibrator.page.takes
    click_row(calibrator, 0)
    for exclude, verdict, n in (
        (lambda: press(window, Qt.Key.Key_X), "excluded", 2),
        (lambda: click(takes.exclude), "good", 3),
    ):
        exclude()
        calibrator.settle()
        assert verdicts(calibrator) == [verdict, "good", "good"]
        assert len(calibrator.model.workbench.utterances) == n
    QTest.keyClick(takes.list, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    press(window, Qt.Key.Key_X)
    calibrator.settle()
    assert [take.excluded for take in calibrator.takes] == [True, True, False]
    assert edits(window) == ["Undo exclude 2 takes"]
    click(takes.delete)
    calibrator.settle()
    assert [take.name for take in calibrator.takes] == ["i-3"]
    assert edits(window) == ["Undo delete 2 takes"]
    press(window, Qt.Key.Key_Z, CONTROL)
    calibrator.settle()
    assert [take.name for take in calibrator.takes] == ["a-1", "e-2", "i-3"]
    takes.list.selectAll()
    press(takes.list, Qt.Key.Key_Delete)
    calibrator.settle()
    assert calibrator.takes == ()


# -- takes of a file ----------------------------------------------------------------------------------


def test_a_marked_stretch_of_the_file_becomes_a_take_at_a_key_and_so_does_what_is_played_meanwhile(
    calibrator: Calibrator,
):
    session = calibrator.booth.desktop.session
    session.open(DEMO)
    press(calibrator.booth.window, Qt.Key.Key_Space)
    calibrator.until(lambda: session.source.position > 0.2)
    QTest.keyPress(calibrator.page.takes.list, Qt.Key.Key_E)
    began = session.source.position
    calibrator.until(lambda: session.source.position > began + 0.4)
    calibrator.let_go(Qt.Key.Key_E)
    ended = session.source.position
    calibrator.settle()
    (take,) = calibrator.takes
    assert take.duration == pytest.approx(ended - began + AROUND + min(began, AROUND), abs=0.1)
    assert take.phoneme is Phoneme.E
    press(calibrator.booth.window, Qt.Key.Key_Space)
    session.seek(1.0)
    press(calibrator.booth.window, Qt.Key.Key_BracketLeft)
    session.seek(1.6)
    press(calibrator.booth.window, Qt.Key.Key_BracketRight)
    assert calibrator.model.selection == pytest.approx((1.0, 1.6), abs=0.011)
    press(calibrator.booth.window, Qt.Key.Key_O)
    calibrator.settle()
    _, take = calibrator.takes
    assert (take.phoneme, take.device) == (Phoneme.O, "demo.flac")
    assert take.duration == pytest.approx(0.6 + 2 * AROUND, abs=0.011)
    assert AROUND <= take.start < take.end <= AROUND + 0.611
    assert {label.phoneme for label in take.to_labels() if label.certainty == CORE} == {Phoneme.O}
    heard, _ = soundfile.read(calibrator.model.takes.path_of(take), dtype="float32")
    whole, rate = soundfile.read(DEMO, dtype="float32")
    first = start_of(heard, whole, rate)
    np.testing.assert_allclose(heard, whole[first : first + len(heard)], atol=2**-14)
    calibrator.listen()
    calibrator.model.mark(end=False)
    assert "Open one to mark a range" in calibrator.booth.banner


def start_of(heard: np.ndarray, whole: np.ndarray, rate: int) -> int:
    """Find where a stretch lies in a sound, a little before 1 s."""
    around = range(round((0.98 - AROUND) * rate), round((1.02 - AROUND) * rate))
    return min(around, key=lambda k: float(np.abs(whole[k : k + 2000] - heard[:2000]).sum()))


# -- what is done with takes --------------------------------------------------------------------------


def test_deleted_takes_are_removed_for_ever_if_the_user_says_so_once_more(calibrator: Calibrator):
    window, panel = calibrator.booth.window, calibrator.page.takes
    calibrator.keep(Phoneme.A)
    click_row(calibrator, 0)
    press(window, Qt.Key.Key_Delete)
    calibrator.settle()
    sounds = list(calibrator.model.takes.folder.rglob("*.flac"))
    for button, left in (("Cancel", sounds), ("Remove", [])):
        asked = answer(button)
        choose(panel.open.menu(), "Remove Deleted Takes…")
        calibrator.settle()
        assert asked == [
            "Permanently remove the deleted take from disk? Earlier changes to takes can then no longer be undone."
        ]
        assert list(calibrator.model.takes.folder.rglob("*.flac")) == left
    assert calibrator.booth.banner == "1 deleted take removed from the disk."
    press(window, Qt.Key.Key_Z, CONTROL)
    calibrator.settle()
    assert not calibrator.takes
    choose(panel.open.menu(), "Remove Deleted Takes…")
    assert calibrator.booth.banner == "There are no deleted takes."


def test_undo_takes_back_what_changed_last_be_it_a_take_or_a_threshold(calibrator: Calibrator):
    preset = calibrator.booth.desktop.preset
    calibrator.keep(Phoneme.A)
    before = preset.preset.thresholds
    preset.tune("sz_s1", 3.0)
    calibrator.keep(Phoneme.I)
    window = calibrator.booth.window
    assert edits(window) == ["Undo add i-2"]
    for n_takes, tuned in ((1, True), (1, False), (0, False)):
        press(window, Qt.Key.Key_Z, CONTROL)
        calibrator.settle()
        assert len(calibrator.takes) == n_takes
        assert (preset.preset.thresholds.sz_s1 == 3.0) is tuned
    assert preset.preset.thresholds == before
    for _ in range(3):
        press(window, Qt.Key.Key_Y, CONTROL)
        calibrator.settle()
    assert len(calibrator.takes) == 2
    assert preset.preset.thresholds.sz_s1 == 3.0
    preset.load(DEFAULT_PRESET)  # its edits are gone, those of the takes are not
    assert edits(window) == ["Undo add i-2"]
    press(window, Qt.Key.Key_Z, CONTROL)
    calibrator.settle()
    assert [take.phoneme for take in calibrator.takes] == [Phoneme.A]
    assert edits(window) == ["Undo add a-1", "Redo add i-2"]


def test_a_take_in_place_of_another_is_two_changes_and_that_one_may_not_be_kept_yet(calibrator: Calibrator):
    takes, numbers = calibrator.model.takes, list[int]()
    calibrator.keep(Phoneme.A)
    samples = in_room(said(Phoneme.A, 0.8))[:, np.newaxis]
    takes.add(samples, SAMPLE_RATE, Phoneme.A, "Desk", instead_of=lambda: 1)
    calibrator.settle()
    assert [take.name for take in calibrator.takes] == ["a-2"]
    for names in (["a-1", "a-2"], ["a-1"]):
        press(calibrator.booth.window, Qt.Key.Key_Z, CONTROL)
        calibrator.settle()
        assert [take.name for take in calibrator.takes] == names
    takes.added.connect(numbers.append)
    for _ in range(2):
        takes.add(samples, SAMPLE_RATE, Phoneme.A, "Desk", instead_of=lambda: numbers[-1] if numbers else None)
    calibrator.settle()
    assert [take.number for take in calibrator.takes] == [1, numbers[-1]]


def test_what_was_done_in_one_project_is_not_undone_in_another_which_can_be_opened(calibrator: Calibrator, tmp_path):
    window = calibrator.booth.window
    calibrator.keep(Phoneme.A)
    (tmp_path / "file").write_text("no folder", encoding="utf-8")
    calibrator.model.takes.open(tmp_path / "file")
    calibrator.settle()
    assert ("file" in calibrator.booth.banner, len(calibrator.takes)) == (True, 1)
    calibrator.keep(Phoneme.I)
    assert len(calibrator.takes) == 2
    calibrator.model.takes.open(tmp_path / "other")
    calibrator.settle()
    assert edits(window) == []
    calibrator.keep(Phoneme.I)
    assert edits(window) == ["Undo add i-1"]


def test_a_take_is_played_copied_relabelled_and_its_ends_are_dragged(calibrator: Calibrator):
    calibrator.keep(Phoneme.A)
    click_row(calibrator, 0)
    window, wave, (take,) = calibrator.booth.window, calibrator.page.takes.wave, calibrator.takes
    session, heard = calibrator.booth.desktop.session, list[Analysis]()
    session.analysed.connect(heard.extend)
    press(window, Qt.Key.Key_Return)
    assert session.path == calibrator.model.takes.path_of(take)
    assert session.source.playing
    calibrator.until(lambda: not session.source.playing)  # at the end of what counts
    assert (heard[-1].start + len(heard[-1])) * FRAME_PERIOD == pytest.approx(take.end, abs=0.02)
    assert session.source.position == pytest.approx(take.start, abs=0.02)
    QTest.mousePress(wave, Qt.MouseButton.RightButton, pos=QPoint(round(wave.axis.x_of(take.start)), 30))
    QTest.mouseMove(wave, QPoint(wave.width() // 2, 30))
    QTest.mouseRelease(wave, Qt.MouseButton.RightButton, pos=QPoint(wave.width() // 2, 30))
    calibrator.settle()
    assert calibrator.takes == (take,)  # its ends stay
    rows = copied(wave.menu, QPoint(9, 9))
    assert rows[0] == ["time (s)", "amplitude"]
    assert len(rows) == 1 + round(take.duration * SAMPLE_RATE)
    assert [action.text() for action in wave.menu.actions()] == ["Copy Values", "Copy Picture", "Save Picture…"]
    start, end = (wave.axis.x_of(seconds) for seconds in (take.start, take.end))
    drag(wave, start, (start + end) / 2)
    calibrator.settle()
    (trimmed,) = calibrator.takes
    assert trimmed.start == pytest.approx((take.start + take.end) / 2, abs=0.02)
    assert trimmed.end == take.end
    wave.setFocus()
    QTest.keyClick(wave, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    calibrator.settle()
    assert calibrator.takes[0].end == pytest.approx(take.end - 0.01, abs=1e-6)
    press(window, Qt.Key.Key_Z, CONTROL)
    press(window, Qt.Key.Key_Z, CONTROL)
    calibrator.settle()
    assert calibrator.takes == (take,)
    box = calibrator.page.takes.phoneme
    box.setFocus()
    QTest.keyClick(box, Qt.Key.Key_Down)  # a is followed by e
    calibrator.settle()
    assert [take.phoneme for take in calibrator.takes] == [Phoneme.E]


# -- the project --------------------------------------------------------------------------------------


@pytest.mark.usefixtures("open_own_booth")
def test_project_and_speaker_are_there_again_at_the_next_start(calibrator: Calibrator, qapp, tmp_path):
    calibrator.model.takes.open(tmp_path / "my voice")
    calibrator.settle()
    calibrator.model.takes.speaker = "Mara"
    calibrator.keep(Phoneme.A)
    booth, settings = calibrator.booth, calibrator.booth.settings
    booth.desktop.save()
    calibrator.model.takes.close()
    again = Booth(begin(qapp, settings, booth.studio.model), settings, booth.studio, booth.qtbot)
    try:
        again.qtbot.waitUntil(lambda: len(again.desktop.calibration.takes.now.takes) == 1)
        kept = again.desktop.calibration.takes.folder, again.window.calibration.takes.speaker.text()
        assert kept == (tmp_path / "my voice", "Mara")
    finally:
        again.desktop.close()


def click_row(calibrator: Calibrator, row: int) -> None:
    table = calibrator.page.takes.list
    QTest.mouseClick(table.viewport(), LEFT, pos=table.visualItemRect(table.item(row, 1)).center())
    table.setFocus()
    calibrator.settle()
