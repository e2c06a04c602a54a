"""The phonemes of the opened file, saved from the File menu for Praat, Audacity and the corpus."""

import threading
from pathlib import Path

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QLineEdit

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeengine.audio.files import SoundReader
from phonemeengine.labels.files import read_labels
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import THESIS_PRESET
from phonemeengine.settings import Channel
from tests.desktop.hands import CARDS, FileAnswers, press, shown
from tests.tables import analysed

CONTROL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def window(desktop, qtbot, sound):
    return shown(desktop, qtbot, sound)


def said(window) -> str:
    return window.banner.label.text() if window.banner.isVisible() else ""


def save(window, qtbot) -> None:
    """Press the key, and wait until all is written."""
    press(window, Qt.Key.Key_E, CONTROL)
    qtbot.waitUntil(lambda: "Recognising" not in said(window))


@pytest.fixture
def answer(window):
    """Answers the question for a file."""

    def answer(*paths: Path, chosen: str = "") -> FileAnswers:
        window.files.show = FileAnswers(*paths, chosen=chosen)
        return window.files.show

    return answer


def heard(path: Path) -> list[tuple[float, float, Phoneme]]:
    return [(label.start, label.end, label.phoneme) for label in read_labels(path)]


def test_the_key_the_dialog_and_return_save_a_textgrid_beside_the_sound(window, qtbot, sound):
    asked: list[str] = []

    def accept() -> None:
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, QFileDialog)
        field = dialog.findChild(QLineEdit, "fileNameEdit")
        asked.append(field.text())
        QTest.keyClick(field, Qt.Key.Key_Return)

    QTimer.singleShot(300, accept)
    save(window, qtbot)
    assert asked == ["speech.TextGrid"]
    target = sound.with_suffix(".TextGrid")
    assert said(window).startswith(f"Phonemes of speech.wav saved as {target}. Model: ")
    assert len(heard(target)) > 2


def test_the_ending_chooses_the_format_and_all_say_what_the_command_says(window, qtbot, sound, answer):
    reference = sound.with_name("reference.TextGrid")
    analysed(sound, "--preset", THESIS_PRESET, "-o", reference)
    for suffix in (".TextGrid", ".txt", ".csv"):
        files = answer(sound.with_name(f"mine{suffix}"))
        save(window, qtbot)
        assert files.suggested == [sound.with_suffix(".TextGrid")]
        qtbot.waitUntil(sound.with_name(f"mine{suffix}").exists)
        assert heard(sound.with_name(f"mine{suffix}")) == heard(reference)
    assert sound.with_name("mine.TextGrid").read_bytes() == reference.read_bytes()


def test_a_name_without_a_known_ending_is_given_one_and_replaces_nothing(window, qtbot, tmp_path, answer):
    for chosen, written in (("", "my.words.TextGrid"), ("Audacity labels (*.txt)", "my.words.txt")):
        answer(tmp_path / "my.words", chosen=chosen)
        path = tmp_path / written
        save(window, qtbot)
        first = path.read_bytes()
        path.write_bytes(b"by hand")
        save(window, qtbot)
        assert path.read_bytes() == b"by hand"
        assert path.with_name(f"{path.stem} (2){path.suffix}").read_bytes() == first


def test_the_preset_in_force_and_the_channel_decide(desktop, window, qtbot, stereo, tmp_path, answer):
    window.dialogs.open_sound(stereo)
    desktop.session.set_channel(Channel.RIGHT)
    answer(tmp_path / "right.TextGrid")
    save(window, qtbot)
    assert [phoneme for *_, phoneme in heard(tmp_path / "right.TextGrid")] == [Phoneme.SILENCE]
    desktop.session.set_channel(Channel.LEFT)
    answer(tmp_path / "left.TextGrid")
    save(window, qtbot)
    assert len(heard(tmp_path / "left.TextGrid")) > 2
    for name in ("silence_zero_crossings", "silence_energy", "silence_max_energy", "silence_szsch1"):
        desktop.preset.tune(name, 1e6)
    answer(tmp_path / "deaf.TextGrid")
    save(window, qtbot)
    assert {phoneme for *_, phoneme in heard(tmp_path / "deaf.TextGrid")} == {Phoneme.SILENCE}


def test_who_names_no_file_changes_nothing_and_without_a_sound_it_says_what_to_do(
    desktop, window, qtbot, tmp_path, answer
):
    assert ("Save Phonemes…", "Ctrl+E") in window.menus.keys()["File"]
    answer()
    before = set(tmp_path.iterdir())
    save(window, qtbot)
    assert set(tmp_path.iterdir()) == before
    assert said(window) == ""
    answer(tmp_path / "gone" / "mine.TextGrid")
    save(window, qtbot)
    assert said(window).startswith("mine.TextGrid: cannot be written (No such file or directory)")
    desktop.session.set_source(SourceKind.TONE)
    save(window, qtbot)
    assert said(window) == "No audio file is open. Open the one whose phonemes you want to save."


def test_a_sound_that_was_cut_off_meanwhile_leaves_the_old_labels(window, qtbot, sound, tmp_path, answer):
    (tmp_path / "mine.TextGrid").write_text("old")
    sound.write_bytes(b"no sound any more")
    answer(tmp_path / "mine.TextGrid")
    save(window, qtbot)
    assert said(window).startswith("speech.wav: ")
    assert (tmp_path / "mine.TextGrid").read_text() == "old"


@pytest.fixture
def held():
    """Lets a writer that waits for it go on."""
    go_on = threading.Event()
    yield go_on
    go_on.set()


def wait_behind(held: threading.Event, desktop: Desktop, sound: Path) -> None:
    """Have the writer be at another sound, which gives nothing yet."""
    writer, target = desktop.session.writer, sound.with_name("another.csv")
    writer.write("another", lambda: held.wait(60) and SoundReader(sound), desktop.preset.preset, target)


@pytest.mark.usefixtures("own_desktop")
@pytest.mark.long
def test_the_window_goes_on_meanwhile_and_another_theme_loses_nothing(desktop, window, qtbot, sound, answer, held):
    answer(sound.with_suffix(".TextGrid"))
    wait_behind(held, desktop, sound)
    press(window, Qt.Key.Key_E, CONTROL)
    assert said(window) == "Recognising the phonemes of speech.wav and saving them as speech.TextGrid…"
    window.dialogs.open_sound(CARDS)
    press(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: desktop.session.source.position > 0.1)
    assert desktop.session.writer.busy
    desktop.set_theme("dark")
    held.set()
    qtbot.waitUntil(lambda: "Phonemes of speech.wav saved" in said(desktop.window))
    assert len(heard(sound.with_suffix(".TextGrid"))) > 2


def test_what_was_asked_for_is_written_before_the_program_ends(own_desktop, qtbot, sound, held):
    own_desktop.files.show = FileAnswers(sound.with_suffix(".csv"))
    wait_behind(held, own_desktop, sound)
    press(shown(own_desktop, qtbot, sound), Qt.Key.Key_E, CONTROL)
    threading.Timer(0.2, held.set).start()
    own_desktop.session.close()
    assert len(heard(sound.with_suffix(".csv"))) > 2
