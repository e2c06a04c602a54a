"""Recording by mouse and keyboard: what is written, what is said, and what is offered."""

import shutil
import subprocess
import sys
from collections.abc import Callable
from datetime import datetime
from pathlib import Path

import numpy as np
import pytest
import soundfile
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor

from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeengine.settings import HOP
from tests.desktop.hands import CARDS, DEMO, FileAnswers, click, drop, press
from tests.desktop.session.test_microphone import CUT_OFF
from tests.desktop.studio import DESK, Booth
from tests.fakes.microphones import HandDrivenMicrophone
from tests.fakes.recorders import samples_in, samples_of_16_bits

Open = Callable[..., Booth]


def known(first: int, n_hops: int) -> np.ndarray:
    """Samples of 16 bits, shape (n,)."""
    return samples_of_16_bits(first * HOP, n_hops * HOP)[:, 0]


def recorded(booth: Booth, mic: HandDrivenMicrophone, n_hops: int, end: Callable[[], object]) -> Path:
    """Record some hops with R, end that, wait for the offer, and give the file."""
    booth.record()
    booth.feed(mic, known(0, n_hops))
    end()
    booth.until(lambda: booth.banner.startswith(f"Recorded {n_hops / 100:.1f} s to "))
    assert not booth.studio.model.recording
    return booth.studio.take


def test_key_button_and_menu_record_and_the_averaged_spectrum_begins_anew(booth: Booth, mic: HandDrivenMicrophone):
    window, averages = booth.window, booth.desktop.session.averages
    by_button = lambda: click(window.transport.record, 12)  # noqa: E731
    by_menu = window.menus.actions["Record"].trigger
    booth.feed(mic, known(0, 30))
    assert (averages.n_frames, averages.since) == (len(booth.frames), "Play at 0.00 s of Microphone")
    for begin, end, suffix in ((by_button, by_menu, ".wav"), (by_menu, booth.record, ".flac")):
        kinds, phonemes = window.transport.record.kinds, window.transport.record.phonemes
        kinds[suffix].trigger()
        n_before = len(booth.frames)
        begin()
        assert window.transport.record.isChecked()
        booth.feed(mic, known(30, 60))
        assert averages.n_frames == len(booth.frames) - n_before
        assert averages.since == f"Record at {n_before / 100:.2f} s of Microphone"
        end()
        assert not window.transport.record.isChecked()
        booth.until(lambda: booth.banner.startswith("Recorded 0.6 s to "))
        take = booth.studio.take
        assert take.suffix == suffix
        np.testing.assert_array_equal(samples_in(take)[:, 0], known(30, 60))
        begun = datetime.strptime(take.stem, "%Y-%m-%d %H-%M-%S")
        assert abs((datetime.now() - begun).total_seconds()) < 100
        if suffix == ".wav":
            assert booth.studio.files == [take.name]
            phonemes.trigger()
            take.unlink()
            click(window.banner.dismiss)
    rows = take.with_suffix(".csv").read_text().splitlines()
    assert rows[0].startswith("start")
    assert len(rows) > 1
    window.transport.record.menu().aboutToShow.emit()
    assert (kinds[".flac"].isChecked(), phonemes.isChecked()) == (True, True)


def test_r_makes_room_for_the_microphone_whatever_was_in_use(open_booth: Open, mic: HandDrivenMicrophone):
    booth = open_booth(mic)
    press(booth.window, Qt.Key.Key_Space)
    booth.record()
    booth.feed(mic, known(0, 40))
    assert booth.desktop.session.source.kind is SourceKind.MICROPHONE
    booth.record()
    booth.until(lambda: booth.banner.startswith("Recorded 0.4 s"))
    assert booth.desktop.session.source.playing  # it goes on listening


def test_the_label_shows_how_much_is_on_the_disk_or_that_nothing_comes(booth: Booth, mic: HandDrivenMicrophone):
    said: list[str] = []
    booth.desktop.session.microphone.error.connect(said.append)
    time = booth.window.transport.time
    booth.record()
    assert time.text() == "waiting 0:00.0"
    booth.feed(mic, known(0, 130))
    booth.until(lambda: time.text() >= "● 0:01.3", mic)
    assert time.palette().color(time.foregroundRole()) == QColor(booth.window.theme.bad)
    booth.until(lambda: time.text().startswith("waiting "))
    booth.until(lambda: "the recording continues once the signal is back" in booth.banner)
    booth.until(lambda: "no signal from Desk · ALSA for 2 s" in booth.status)
    assert len(said) == 1, "the status line counts the seconds, the banner does not"
    booth.record()
    assert "●" not in time.text()


def test_to_stop_listening_ends_the_recording_and_the_offer_opens_it(booth: Booth, mic: HandDrivenMicrophone):
    take = recorded(booth, mic, 50, lambda: press(booth.window, Qt.Key.Key_Escape))
    action = booth.window.banner.action
    assert (action.text(), action.isVisible()) == ("Open", True)
    click(action)
    assert booth.desktop.session.path == take
    assert booth.desktop.session.source.kind is SourceKind.FILE
    assert booth.desktop.session.source.duration == pytest.approx(0.5)
    assert booth.banner == ""
    assert booth.window.dialogs.recent_sounds()[0] == take.resolve()


def test_no_sound_and_a_folder_that_takes_nothing_are_one_sentence_and_nothing_claims_to_record(
    booth: Booth, mic: HandDrivenMicrophone, tmp_path: Path
):
    booth.record()
    booth.record()
    nothing = "Nothing was recorded, since the microphone sent no signal. Check the microphone."
    booth.until(lambda: booth.banner == nothing)
    assert booth.studio.files == []
    (tmp_path / "file").write_text("in the way")
    booth.studio.model.folder = tmp_path / "file" / "takes"
    booth.record()
    booth.give(mic, known(0, 50))
    booth.until(lambda: "cannot be made" in booth.banner, mic)
    assert booth.banner.startswith("takes: this folder for recordings cannot be made (")
    assert not booth.window.transport.record.isChecked()
    assert "●" not in booth.window.transport.time.text()
    assert "waiting" not in booth.window.transport.time.text()


@pytest.mark.usefixtures("open_own_booth")
@pytest.mark.skipif(sys.platform == "win32", reason="Windows keeps folders of open files")
def test_a_folder_that_vanishes_is_one_sentence_and_what_was_recorded_is_kept(
    booth: Booth, mic: HandDrivenMicrophone, tmp_path: Path
):
    booth.studio.model.folder = tmp_path / "stick"
    booth.record()
    booth.feed(mic, known(0, 60))
    booth.until(lambda: booth.studio.model.recorded_seconds > 0.5, mic)
    shutil.rmtree(tmp_path / "stick")
    booth.until(lambda: "has gone" in booth.banner, mic)
    assert booth.banner.count(". ") == 0
    assert not booth.window.transport.record.isChecked()
    assert "●" not in booth.window.transport.time.text()
    np.testing.assert_array_equal(samples_in(booth.studio.take)[: 60 * HOP, 0], known(0, 60))


def test_a_dropped_file_ends_the_recording_and_its_offer_still_comes(booth: Booth, mic: HandDrivenMicrophone):
    booth.record()
    booth.feed(mic, known(0, 50))
    assert drop(booth.window, DEMO)
    assert (booth.desktop.session.path, booth.desktop.session.source.kind) == (DEMO, SourceKind.FILE)
    booth.until(lambda: booth.banner.startswith("Recorded 0.5 s to "))
    np.testing.assert_array_equal(samples_in(booth.studio.take)[:, 0], known(0, 50))
    assert not booth.window.transport.record.isChecked()
    booth.until(mic.closed.is_set)


@pytest.mark.usefixtures("open_own_booth")
def test_another_theme_records_on_and_closing_the_window_finishes_it(booth: Booth, mic: HandDrivenMicrophone):
    booth.record()
    booth.feed(mic, known(0, 30))
    booth.desktop.set_theme("dark" if booth.window.theme.name == "light" else "light")
    assert booth.window.transport.record.isChecked()
    booth.feed(mic, known(30, 30))
    assert booth.window.close()
    booth.desktop.session.close()
    np.testing.assert_array_equal(samples_in(booth.studio.take)[:, 0], known(0, 60))
    assert booth.studio.model.interrupted_recordings() == []


def test_the_recordings_folder_is_chosen_shown_and_kept(booth: Booth, mic: HandDrivenMicrophone, tmp_path: Path):
    chosen = tmp_path / "mine"
    booth.window.files.show = FileAnswers(chosen)
    record = booth.window.transport.record
    record.folder.trigger()
    record.menu().aboutToShow.emit()
    assert str(chosen) in record.folder.text()
    assert str(chosen) in record.toolTip()
    booth.record()
    booth.feed(mic, known(0, 30))
    press(booth.window, Qt.Key.Key_Space)  # to stop listening ends it
    booth.until(lambda: str(chosen) in booth.banner)
    booth.window.save_state()
    assert booth.settings.value("recordings") == str(chosen)


# -- recordings of a killed process -------------------------------------------------------------------


@pytest.fixture
def cut_off(open_booth: Open, tmp_path: Path) -> tuple[Booth, Path]:
    """A window at its start, after a process died while it recorded."""
    booth = open_booth()
    booth.studio.takes.mkdir(exist_ok=True)
    words = [sys.executable, "-c", CUT_OFF, str(booth.studio.takes / "cut off.wav"), str(booth.studio.journal)]
    assert subprocess.run(words, check=False).returncode == 9
    booth.window.dialogs.offer_unfinished()
    return booth, booth.studio.take


def test_an_unfinished_recording_is_offered_beside_other_messages_and_opened(
    cut_off: tuple[Booth, Path], tmp_path: Path
):
    booth, take = cut_off
    assert booth.banner.startswith("The program quit during a recording; 1.0 s from ")
    assert str(take) in booth.banner
    booth.window.dialogs.open_sound(tmp_path / "nothing.wav")
    assert "there is no such file" in booth.banner
    booth.window.dialogs.open_sound(CARDS)
    assert booth.banner.startswith("The program quit during a recording")
    click(booth.window.banner.action)
    assert booth.banner == ""
    assert booth.desktop.session.path == take
    assert booth.desktop.session.source.duration == pytest.approx(1.0, abs=0.2)


def test_it_is_offered_once_and_dismissed_for_good(cut_off: tuple[Booth, Path]):
    booth, take = cut_off
    click(booth.window.banner.dismiss)
    assert booth.banner == ""
    booth.window.dialogs.offer_unfinished()
    assert booth.banner == ""
    assert take.exists()


def test_a_microphone_that_comes_back_at_another_rate_goes_into_a_file_of_its_own(open_booth: Open):
    first, second = HandDrivenMicrophone(name=DESK.label), HandDrivenMicrophone(rate=48_000, name=DESK.label)
    booth = open_booth(first)
    booth.listen()
    booth.record()
    booth.feed(first, known(0, 50))
    first.lost = True
    booth.studio.openers.waiting.append(second)
    booth.until(lambda: len(booth.studio.files) == 2 and booth.studio.model.recorded_seconds > 0, second)
    booth.record()
    booth.until(
        lambda: booth.banner.startswith("The format of the microphone changed during the recording; the part before")
    )
    first_file = min(booth.studio.files, key=lambda name: (len(name), name))
    assert booth.banner.endswith(f"{first_file}.")
    click(booth.window.banner.dismiss)
    booth.until(lambda: booth.banner.startswith("Recorded "))
    rates = [soundfile.info(booth.studio.takes / name).samplerate for name in booth.studio.files]
    assert sorted(rates) == [44_100, 48_000]
