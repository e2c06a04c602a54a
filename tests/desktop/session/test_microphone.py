"""The microphone's model: which one, what it does, and what is told of it."""

import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.audio.stream import Device, InputChoice
from phonemeengine.settings import HOP
from tests.desktop.studio import DESK, HEADSET, Studio
from tests.fakes.microphones import HandDrivenMicrophone, offline
from tests.fakes.players import PRESET, SPEECH, joined
from tests.fakes.recorders import hops_of_16_bits as known
from tests.fakes.recorders import samples_in
from tests.sounds import noise

HEARD = SPEECH[: len(SPEECH) // HOP * HOP]
CUT_OFF = """
import os, sys
from pathlib import Path
import numpy as np
from phonemeengine.audio.recording import Recording
from tests.waiting import wait_for
take, journal = map(Path, sys.argv[1:])
recording = Recording(take, 44_100, 1, journal=journal, rescue=take.parent)
recording.write(np.full((44_100, 1), 0.25, np.float32))
wait_for(lambda: recording.seconds >= 0.9)
os._exit(9)
"""


# -- listening ----------------------------------------------------------------------------------------


def test_what_is_heard_is_what_the_analysis_of_a_file_finds(studio: Studio, mic: HandDrivenMicrophone) -> None:
    studio.feed(mic, HEARD)
    found = joined(studio.taken)
    expected = offline(HEARD).part(slice(0, len(found)))
    np.testing.assert_array_equal(found.phonemes, expected.phonemes)
    np.testing.assert_allclose(found.features.values, expected.features.values, rtol=1e-3, atol=1e-4)
    assert len(np.unique(found.phonemes)) > 3
    assert studio.model.listener.seconds == pytest.approx(len(HEARD) / 44_100)
    assert (studio.told, studio.failed) == ([], [])


def test_a_microphone_is_opened_only_to_listen(open_studio: Callable[..., Studio], mic: HandDrivenMicrophone) -> None:
    studio = open_studio(mic)
    studio.model.choose(InputChoice("Headset"))
    studio.model.refresh_devices()
    studio.model.begin_recording()
    studio.until(lambda: studio.model.devices)
    assert studio.openers.asked == []
    assert not studio.model.recording
    assert studio.model.words == "not listening"


def test_another_choice_lets_the_old_microphone_go_and_is_no_trouble(
    open_studio: Callable[..., Studio], mic: HandDrivenMicrophone
) -> None:
    other = HandDrivenMicrophone(rate=48_000, name="Headset · ALSA")
    studio = open_studio(mic, other)
    studio.model.listen(PRESET)
    studio.feed(mic, noise(0.2))
    studio.model.choose(InputChoice("Headset", rate=48_000))
    other.give(noise(0.2))
    studio.until(lambda: studio.model.words.startswith("Headset"))
    assert mic.closed.is_set()
    assert studio.model.words == "Headset · ALSA, 48 000 Hz"
    assert [choice.label for choice in studio.openers.asked] == ["", "Headset"]
    assert (studio.told, studio.failed) == ([], [])
    assert studio.model.listener.lost_seconds == 0


def test_stopping_lets_the_microphone_go(studio: Studio, mic: HandDrivenMicrophone) -> None:
    studio.feed(mic, noise(0.2))
    studio.model.stop()
    assert not studio.model.active
    assert mic.closed.wait(60)
    assert studio.model.listener.take_analyses() == []
    assert studio.model.listener.level.peak == 0


# -- the list of devices ------------------------------------------------------------------------------


def test_the_list_has_the_default_first_and_is_made_anew_when_asked(studio: Studio) -> None:
    changes: list[int] = []
    studio.model.devices_changed.connect(lambda: changes.append(len(studio.model.devices)))
    studio.model.refresh_devices()
    studio.until(lambda: changes)
    assert studio.model.devices == [DESK, HEADSET]
    studio.devices.append(Device("Interface", "JACK", 4, 4, 96_000, is_default=False))
    studio.model.refresh_devices()
    studio.until(lambda: changes == [2, 3])


def test_neither_listening_nor_recording_is_interrupted_for_the_list(
    studio: Studio, mic: HandDrivenMicrophone
) -> None:
    studio.model.begin_recording()
    studio.feed(mic, known(0, 20)[:, 0])
    studio.model.refresh_devices()
    studio.until(lambda: studio.model.devices)
    studio.feed(mic, known(20, 20)[:, 0])
    studio.model.end_recording()
    studio.until(lambda: studio.recorded)
    np.testing.assert_array_equal(samples_in(studio.take), known(0, 40))
    assert len(studio.openers.asked) == 1
    assert (studio.told, studio.failed) == ([], [])


def test_a_sound_system_that_does_not_answer_gives_an_empty_list(open_studio: Callable[..., Studio]) -> None:
    studio = open_studio()
    studio.model.refresh_devices()
    studio.until(lambda: studio.model.devices)
    studio.refusal = "the sound system does not answer"
    studio.model.refresh_devices()
    studio.until(lambda: studio.model.devices == [])


# -- recording ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [".wav", ".flac"])
def test_a_recording_holds_exactly_what_was_heard_while_it_ran(
    studio: Studio, mic: HandDrivenMicrophone, suffix: str
) -> None:
    studio.model.suffix, studio.model.with_phonemes = suffix, True
    studio.feed(mic, known(0, 30)[:, 0])
    studio.model.begin_recording()
    studio.feed(mic, known(30, 50)[:, 0])
    studio.until(lambda: studio.model.recorded_seconds > 0.3)
    studio.model.end_recording()
    studio.feed(mic, known(80, 10)[:, 0])
    studio.until(lambda: studio.recorded)
    assert studio.recorded == [(str(studio.take), pytest.approx(0.5))]
    assert studio.take.suffix == suffix
    np.testing.assert_array_equal(samples_in(studio.take), known(30, 50))
    assert studio.files == sorted((studio.take.name, studio.take.with_suffix(".csv").name))
    assert list(studio.journal.iterdir()) == []


def test_a_recording_of_nothing_says_so_and_leaves_no_file(studio: Studio) -> None:
    studio.model.begin_recording()
    studio.model.end_recording()
    studio.until(lambda: studio.failed)
    assert studio.failed == ["Nothing was recorded, since the microphone sent no signal. Check the microphone."]
    assert studio.files == []


def test_a_folder_that_cannot_be_made_ends_the_recording_with_one_sentence(
    studio: Studio, mic: HandDrivenMicrophone, tmp_path: Path
) -> None:
    (tmp_path / "file").write_text("no folder")
    studio.model.folder = tmp_path / "file" / "takes"
    studio.model.begin_recording()
    studio.feed(mic, noise(0.2))
    studio.until(lambda: studio.failed)
    assert len(studio.failed) == 1
    assert "this folder for recordings cannot be made" in studio.failed[0]
    assert not studio.model.recording
    assert studio.recorded == []


@pytest.mark.skipif(sys.platform == "win32", reason="Windows keeps folders of open files")
def test_a_folder_that_vanishes_ends_the_recording_and_what_is_there_is_saved_elsewhere(
    studio: Studio, mic: HandDrivenMicrophone, tmp_path: Path
) -> None:
    studio.model.folder = tmp_path / "stick"
    studio.model.begin_recording()
    studio.feed(mic, known(0, 60)[:, 0])
    studio.until(lambda: studio.model.recorded_seconds > 0.5)
    shutil.rmtree(tmp_path / "stick")
    studio.until(lambda: studio.failed)
    assert "has gone, so the recording stopped after 0.6 s" in studio.failed[0]
    assert (len(studio.failed), studio.recorded) == (1, [])
    assert not studio.model.recording
    assert studio.model.active
    np.testing.assert_array_equal(samples_in(studio.take), known(0, 60))


def test_closing_finishes_the_recording(studio: Studio, mic: HandDrivenMicrophone) -> None:
    studio.model.begin_recording()
    studio.feed(mic, known(0, 40)[:, 0])
    studio.model.close()
    np.testing.assert_array_equal(samples_in(studio.take), known(0, 40))
    assert studio.model.interrupted_recordings() == []


def test_what_a_dead_process_left_is_found_until_it_is_forgotten(studio: Studio, tmp_path: Path) -> None:
    words = [sys.executable, "-c", CUT_OFF, str(tmp_path / "cut off.wav"), str(studio.journal)]
    assert subprocess.run(words, check=False).returncode == 9
    (found,) = studio.model.interrupted_recordings()
    assert found.path == tmp_path / "cut off.wav"
    assert found.seconds >= 0.9
    found.forget()
    assert studio.model.interrupted_recordings() == []
    assert (samples_in(found.path) == 0.25).all()
