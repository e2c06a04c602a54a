"""Any channel of a file can be chosen: in the window, and in every command that reads sound."""

import argparse
import csv
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import soundfile
from PySide6.QtCore import Qt

from phonemeanalyser.cli import listen as cli
from phonemeanalyser.cli.main import main
from phonemeengine.audio.files import SoundReader
from phonemeengine.calibration.scores.corpus import read_recordings
from phonemeengine.errors import AudioError
from phonemeengine.labels.files import write_labels
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE, Channel
from tests.conftest import SPEECH
from tests.desktop.hands import press, shown
from tests.sounds import silence, tone
from tests.tables import refused, rows_of

N = 8
SPOKEN = 5
"""The channel of eight in which somebody speaks; the others are silent."""


@pytest.fixture
def eight(tmp_path: Path) -> Path:
    """Eight channels, one of which speaks."""
    samples = np.zeros((len(SPEECH), N), np.float32)
    samples[:, SPOKEN - 1] = SPEECH
    (tmp_path / "desk").mkdir()
    soundfile.write(tmp_path / "desk" / "eight.wav", samples, SAMPLE_RATE, subtype="FLOAT")
    return tmp_path / "desk" / "eight.wav"


def heard(path: Path, *words: object) -> set[str]:
    out = path.parent / "out.csv"
    assert main(["analyse", str(path), "-o", str(out), "--overwrite", *(str(word) for word in words)]) == 0
    return {row["phoneme"] for row in rows_of(out.read_text())}


def test_each_channel_of_eight_says_what_is_in_it(eight: Path) -> None:
    for number in range(1, N + 1):
        assert (heard(eight, "--channel", number) == {"silence"}) == (number != SPOKEN)


def test_left_right_and_mix_are_the_first_the_second_and_all(sound: Path, stereo: Path) -> None:
    for one, other in (("left", 1), ("right", 2), ("mix", 0)):
        assert Channel(str(other)) is Channel(one)
        assert Channel(one).number == other
    assert heard(stereo, "--channel", "left") == heard(sound) == heard(sound, "--channel", "1") != {"silence"}
    assert heard(stereo, "--channel", "2") == {"silence"}


@pytest.mark.parametrize("text", ["", "0.5", "-1", "middle", "1025", "²", "1e9", "9" * 5000])
def test_what_is_no_channel_is_refused(text: str, sound: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["analyse", str(sound), f"--channel={text}"])
    assert "must be mix, left, right, or a number in 1..1024" in capsys.readouterr().err


def with_labels(path: Path) -> Path:
    write_labels((Label(0.1, 0.35, "a", Phoneme.A),), path.with_suffix(".csv"))
    with (path.parent / "manifest.csv").open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["corpus", "speaker", "wav", "labels"])
        rows.writerow(["made", "ann", path.name, f"{path.stem}.csv"])
    return path.parent


COMMANDS: dict[str, Callable[[Path, Path], list[object]]] = {
    "analyse": lambda sound, out: [sound, "-o", out / "t.csv"],
    "export": lambda sound, out: [sound, "--format", "anno", "-o", out / "t.anno"],
    "preview": lambda sound, out: [sound, "-o", out / "t.gif"],
    "score": lambda sound, out: [with_labels(sound), "-o", out / "t.json"],
    "adapt": lambda sound, out: [with_labels(sound), "-o", out / "t.toml"],
    "train": lambda sound, out: [with_labels(sound), "-o", out / "t.npz"],
    "screenshot": lambda sound, out: [sound, "-o", out / "t.png"],
}


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_says_in_a_sentence_which_channel_a_file_lacks(
    command: str, eight: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    words = COMMANDS[command](eight, out)
    assert main([command, *(str(word) for word in words), "--channel", "9"]) == 1
    sentence = capsys.readouterr().err.splitlines()[0].removeprefix("phonemeanalyser: ")
    assert sentence == "eight.wav: it has 8 channels and so no channel 9; choose one of 1 to 8, or the mix"
    assert not out.exists()


def test_one_channel_is_no_second(sound: Path, capsys: pytest.CaptureFixture[str]) -> None:
    said = "speech.wav: it has only one channel and so no channel 2; choose the mix"
    assert refused(capsys, "analyse", sound, "--channel", "2") == said
    assert refused(capsys, "export", sound, "--format", "anno", "--channel", "right") == said


def test_labelled_recordings_are_heard_on_their_channel(eight: Path) -> None:
    folder = with_labels(eight)
    for manifest in (True, False):
        (found,) = read_recordings(folder, channel=Channel(str(SPOKEN)))
        with found.opened() as reader:
            np.testing.assert_array_equal(np.concatenate(list(reader.blocks(1 << 20))), SPEECH)
        if manifest:
            (folder / "manifest.csv").unlink()


def test_a_microphone_takes_words_and_numbers() -> None:
    parser = argparse.ArgumentParser()
    cli.add_input(parser)
    asked = ([], ["--channel", "mix"], ["--channel", "0"], ["--channel", "right"], ["--channel", "7"])
    assert [cli.input_of(parser.parse_args(words)).channel for words in asked] == [1, 0, 0, 2, 7]


# -- the window ---------------------------------------------------------------------------------------


def entries(window) -> list[str]:
    box = window.transport.channel
    return [box.itemText(k) for k in range(box.count())]


def choose(window, text: str) -> None:
    box = window.transport.channel
    box.setCurrentIndex(box.findText(text))
    box.activated.emit(box.currentIndex())


def test_the_window_offers_the_channels_that_the_file_has(desktop, qtbot, eight, sound, stereo):
    window = shown(desktop, qtbot, eight)
    assert entries(window) == ["Mix", "1", "2", "3", "4", "5", "6", "7", "8"]
    window.dialogs.open_sound(stereo)
    assert entries(window) == ["Mix", "Left", "Right"]
    window.dialogs.open_sound(sound)
    assert entries(window) == ["Mono"]
    assert not window.transport.channel.isEnabled()


def test_the_chosen_one_of_eight_is_analysed_and_said_to_be(desktop, qtbot, eight):
    window = shown(desktop, qtbot, eight)
    choose(window, "4")
    desktop.session.analyse_until(0.8)
    assert desktop.session.history.extremes("volume")[0] == 0
    choose(window, str(SPOKEN))
    desktop.session.clear()
    desktop.session.analyse_until(0.8)
    assert desktop.session.history.extremes("volume")[0] > 0.1
    assert "44 100 Hz, 8 channels, only channel 5 of 8 is used" in window.status.left.text()


def test_a_file_without_the_channel_is_mixed_and_the_choice_comes_back(desktop, qtbot, eight, stereo):
    window = shown(desktop, qtbot, eight)
    choose(window, "5")
    window.dialogs.open_sound(stereo)
    assert desktop.session.channel is Channel.MIX
    assert window.transport.channel.currentText() == "Mix"
    window.dialogs.open_sound(eight)
    assert window.transport.channel.currentText() == "5"


@pytest.mark.long
@pytest.mark.usefixtures("own_desktop")
def test_the_choice_is_there_after_another_start(desktop, qtbot, eight):
    window = shown(desktop, qtbot, eight)
    choose(window, "7")
    desktop.set_theme("dark")  # makes another window, from what the first one kept
    desktop.session.set_channel(Channel.MIX)
    desktop.window.state.restore(desktop.session, desktop.window.analysis)
    assert desktop.window.transport.channel.currentText() == "7"


def test_a_channel_that_the_file_lacks_is_said_and_changes_nothing(desktop, qtbot, stereo):
    window = shown(desktop, qtbot, stereo)
    desktop.session.set_channel(Channel("3"))
    assert "it has 2 channels and so no channel 3" in window.banner.label.text()
    assert desktop.session.channel is desktop.session.wanted_channel is Channel.MIX


def test_the_box_is_walked_with_the_arrow_keys(desktop, qtbot, eight):
    window = shown(desktop, qtbot, eight)
    window.transport.channel.setFocus()
    for number in range(1, N + 1):
        press(window, Qt.Key.Key_Down)
        assert desktop.session.channel is Channel(str(number))


def test_a_reader_takes_no_channel_that_is_not_there(tmp_path: Path) -> None:
    path = tmp_path / "two.wav"
    soundfile.write(path, np.stack((tone(440, 0.1), silence(0.1)), axis=1), SAMPLE_RATE)
    with SoundReader(path) as reader, pytest.raises(AudioError, match="no channel 3"):
        reader.choose(Channel("3"))
