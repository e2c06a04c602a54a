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
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QColor, QDropEvent
from PySide6.QtTest import QTest

from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeengine.settings import HOP
from tests.desktop.hands import CARDS, DEMO, FileAnswers, click, press
from tests.desktop.session.test_microphone import CUT_OFF
from tests.desktop.studio import DESK, Booth
from tests.fakes.microphones import HandDrivenMicrophone
from tests.fakes.recorders import samples_in, samples_of_16_bits

Open = Callable[..., Booth]


def known(first: int, n_hops: int) -> np.ndarray:
    """Samples of 16 bits, shape (n,)."""
    return samples_of_16_bits(first * HOP, n_hops * HOP)[:, 0]


def recorded(booth: Booth, mic: HandDrivenMicrophone, n_hops: int = 50) -> Path:
    """Record some hops with R, wait for the offer, and give the file."""
    booth.record()
    booth.hear(mic, known(0, n_hops))
    booth.record()
    booth.until(lambda: booth.banner.startswith("Recorded "))
    return booth.studio.take


@pytest.mark.parametrize("way", ["key", "button", "menu"])
def test_key_button_and_menu_record(booth: Booth, mic: HandDrivenMicrophone, way: str):
    window = booth.window
    acts = {
        "key": booth.record,
        "button": lambda: click(window.transport.record, 12),
        "menu": window.menus.actions["Record"].trigger,
    }
    booth.hear(mic, known(0, 30))
    acts[way]()
    assert window.transport.record.isChecked()
    booth.hear(mic, known(30, 60))
    acts[way]()
    assert not window.transport.record.isChecked()
    booth.until(lambda: booth.banner.startswith("Recorded 0.6 s to "))
    np.testing.assert_array_equal(samples_in(booth.studio.take)[:, 0], known(30, 60))
    assert booth.studio.files == [booth.studio.take.name]
    begun = datetime.strptime(booth.studio.take.stem, "%Y-%m-%d %H-%M-%S")
    assert abs((datetime.now() - begun).total_seconds()) < 100


def test_the_averaged_spectrum_begins_anew_with_a_recording(booth: Booth, mic: HandDrivenMicrophone):
    averages = booth.desktop.session.averages
    booth.hear(mic, known(0, 30))
    assert (averages.n_frames, averages.since) == (len(booth.frames), "Play at 0.00 s of Microphone")
    n_before = len(booth.frames)
    booth.record()
    booth.hear(mic, known(30, 20))
    assert averages.n_frames == len(booth.frames) - n_before
    assert averages.since == f"Record at {n_before / 100:.2f} s of Microphone"


def test_r_makes_room_for_the_microphone_whatever_was_in_use(open_booth: Open, mic: HandDrivenMicrophone):
    booth = open_booth(mic)
    press(booth.window, Qt.Key.Key_Space)
    booth.record()
    booth.hear(mic, known(0, 40))
    assert booth.desktop.session.source.kind is SourceKind.MICROPHONE
    booth.record()
    booth.until(lambda: booth.banner.startswith("Recorded 0.4 s"))
    assert booth.desktop.session.source.playing  # it goes on listening


def test_flac_and_phonemes_are_chosen_in_the_menu(booth: Booth, mic: HandDrivenMicrophone):
    record = booth.window.transport.record
    record.kinds[".flac"].trigger()
    record.phonemes.trigger()
    take = recorded(booth, mic)
    assert take.suffix == ".flac"
    np.testing.assert_array_equal(samples_in(take)[:, 0], known(0, 50))
    rows = take.with_suffix(".csv").read_text().splitlines()
    assert rows[0].startswith("start")
    assert len(rows) > 1
    record.menu().aboutToShow.emit()
    assert (record.kinds[".flac"].isChecked(), record.phonemes.isChecked()) == (True, True)
    record.kinds[".wav"].trigger()
    assert booth.studio.model.suffix == ".wav"


def test_the_label_shows_how_much_is_on_the_disk(booth: Booth, mic: HandDrivenMicrophone):
    booth.record()
    time = booth.window.transport.time
    booth.hear(mic, known(0, 130))
    booth.until(lambda: time.text() >= "● 0:01.3", mic)
    assert time.palette().color(time.foregroundRole()) == QColor(booth.window.theme.bad)
    booth.record()
    assert "●" not in time.text()


def test_nothing_claims_to_record_while_nothing_comes(booth: Booth, mic: HandDrivenMicrophone):
    said: list[str] = []
    booth.desktop.session.microphone.error.connect(said.append)
    booth.record()
    assert booth.window.transport.time.text() == "waiting 0:00.0"
    booth.hear(mic, known(0, 50))
    booth.until(lambda: booth.window.transport.time.text().startswith("● "), mic)
    booth.until(lambda: booth.window.transport.time.text().startswith("waiting "))
    booth.until(lambda: "the recording continues once the signal is back" in booth.banner)
    booth.until(lambda: "no signal from Desk · ALSA for 2 s" in booth.status)
    assert len(said) == 1, "the status line counts the seconds, the banner does not"


def test_the_offer_opens_the_recording(booth: Booth, mic: HandDrivenMicrophone):
    take = recorded(booth, mic)
    action = booth.window.banner.action
    assert (action.text(), action.isVisible()) == ("Open", True)
    click(action)
    assert booth.desktop.session.path == take
    assert booth.desktop.session.source.kind is SourceKind.FILE
    assert booth.desktop.session.source.duration == pytest.approx(0.5)
    assert booth.banner == ""
    assert booth.window.dialogs.recent_sounds()[0] == take.resolve()


def test_recording_no_sound_says_so(booth: Booth, mic: HandDrivenMicrophone):
    booth.record()
    booth.record()
    booth.until(
        lambda: booth.banner == "Nothing was recorded, since the microphone sent no signal. Check the microphone."
    )
    assert booth.studio.files == []


def test_a_folder_that_takes_nothing_is_one_sentence_and_nothing_claims_to_record(
    booth: Booth, mic: HandDrivenMicrophone, tmp_path: Path
):
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
    booth.hear(mic, known(0, 60))
    booth.until(lambda: booth.studio.model.recorded_seconds > 0.5, mic)
    shutil.rmtree(tmp_path / "stick")
    booth.until(lambda: "has gone" in booth.banner, mic)
    assert booth.banner.count(". ") == 0
    assert not booth.window.transport.record.isChecked()
    assert "●" not in booth.window.transport.time.text()
    np.testing.assert_array_equal(samples_in(booth.studio.take)[: 60 * HOP, 0], known(0, 60))


def test_a_dropped_file_ends_the_recording_and_its_offer_still_comes(booth: Booth, mic: HandDrivenMicrophone):
    booth.record()
    booth.hear(mic, known(0, 50))
    mime = QMimeData()
    mime.setUrls([QUrl.fromLocalFile(str(DEMO))])
    copy, left, no_key = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    booth.window.dropEvent(QDropEvent(QPointF(300, 300), copy, mime, left, no_key))
    assert (booth.desktop.session.path, booth.desktop.session.source.kind) == (DEMO, SourceKind.FILE)
    booth.until(lambda: booth.banner.startswith("Recorded 0.5 s to "))
    np.testing.assert_array_equal(samples_in(booth.studio.take)[:, 0], known(0, 50))
    assert not booth.window.transport.record.isChecked()
    booth.until(mic.closed.is_set)


@pytest.mark.parametrize("key", [Qt.Key.Key_Space, Qt.Key.Key_Escape])
def test_to_stop_listening_ends_the_recording(booth: Booth, mic: HandDrivenMicrophone, key: Qt.Key):
    booth.record()
    booth.hear(mic, known(0, 50))
    press(booth.window, key)
    booth.until(lambda: booth.banner.startswith("Recorded 0.5 s to "))
    assert not booth.studio.model.recording


@pytest.mark.usefixtures("open_own_booth")
def test_another_theme_records_on(booth: Booth, mic: HandDrivenMicrophone):
    booth.record()
    booth.hear(mic, known(0, 30))
    booth.desktop.set_theme("dark" if booth.window.theme.name == "light" else "light")
    assert booth.window.transport.record.isChecked()
    booth.hear(mic, known(30, 30))
    booth.record()
    booth.until(lambda: booth.banner.startswith("Recorded 0.6 s to "))
    np.testing.assert_array_equal(samples_in(booth.studio.take)[:, 0], known(0, 60))


@pytest.mark.usefixtures("open_own_booth")
def test_closing_the_window_finishes_the_recording(booth: Booth, mic: HandDrivenMicrophone):
    booth.record()
    booth.hear(mic, known(0, 50))
    assert booth.window.close()
    booth.desktop.session.close()
    np.testing.assert_array_equal(samples_in(booth.studio.take)[:, 0], known(0, 50))
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
    booth.hear(mic, known(0, 30))
    booth.record()
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


def test_an_unfinished_recording_is_offered_and_opened(cut_off: tuple[Booth, Path]):
    booth, take = cut_off
    assert booth.banner.startswith("The program quit during a recording; 1.0 s from ")
    assert str(take) in booth.banner
    click(booth.window.banner.action)
    assert booth.desktop.session.path == take
    assert booth.desktop.session.source.duration == pytest.approx(1.0, abs=0.2)
    assert booth.banner == ""


def test_it_is_offered_once_and_dismissed_for_good(cut_off: tuple[Booth, Path]):
    booth, take = cut_off
    dismiss = next(b for b in booth.window.banner.findChildren(type(booth.window.banner.action)) if b.text() == "✕")
    QTest.mouseClick(dismiss, Qt.MouseButton.LeftButton)
    assert booth.banner == ""
    booth.window.dialogs.offer_unfinished()
    assert booth.banner == ""
    assert take.exists()


def test_an_offer_outlasts_other_messages(cut_off: tuple[Booth, Path], tmp_path: Path):
    booth, take = cut_off
    booth.window.dialogs.open_sound(tmp_path / "nothing.wav")
    assert "there is no such file" in booth.banner
    booth.window.dialogs.open_sound(CARDS)
    assert booth.banner.startswith("The program quit during a recording")
    click(booth.window.banner.action)
    assert booth.desktop.session.path == take


def test_a_microphone_that_comes_back_at_another_rate_goes_into_a_file_of_its_own(open_booth: Open):
    first, second = HandDrivenMicrophone(name=DESK.label), HandDrivenMicrophone(rate=48_000, name=DESK.label)
    booth = open_booth(first)
    booth.listen()
    booth.record()
    booth.hear(first, known(0, 50))
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
