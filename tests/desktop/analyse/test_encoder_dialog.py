"""Where the speech encoder's model is, in the window: found, chosen, forgotten, fetched."""

import sys
from types import SimpleNamespace

import pytest
from PySide6.QtWidgets import QApplication, QLabel, QWidget

from phonemeanalyser.desktop.analyse.recognition.preset_choice import EncoderDialog
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from tests.desktop.hands import FileAnswers


@pytest.fixture
def files(settings) -> FileAsker:
    return FileAsker(settings)


@pytest.fixture
def dialog(qtbot, home, files):
    parent = QWidget()
    qtbot.addWidget(parent)
    dialog = EncoderDialog(files, parent)
    dialog.show()
    yield dialog
    dialog.close()


def said(dialog, qtbot) -> str:
    qtbot.waitUntil(dialog.buttons[0].isEnabled)
    return dialog.state.text()


def test_without_a_model_it_says_how_to_get_one(dialog, qtbot):
    assert said(dialog, qtbot) == "No model is installed: download it, or choose the folder of one that you have."
    assert not dialog.buttons[1].isEnabled()  # there is nothing to forget


def test_all_that_it_says_has_room(dialog, qtbot):
    said(dialog, qtbot)
    for words in ("No.", "There is no such folder; " * 12):
        dialog._refuse(words)
        QApplication.processEvents()
        for label in dialog.findChildren(QLabel):
            assert label.height() >= label.heightForWidth(label.width())
            assert dialog.rect().contains(label.geometry())


def test_a_chosen_folder_is_used_and_forgotten(dialog, files, qtbot, whisper_folder):
    said(dialog, qtbot)
    files.show = FileAnswers(whisper_folder)
    with qtbot.waitSignal(dialog.model_changed):
        dialog.buttons[0].click()
    wanted = f"In use: Whisper base, multilingual, by OpenAI, MIT licence; chosen: {whisper_folder}."
    assert said(dialog, qtbot) == wanted
    dialog.buttons[1].click()
    assert said(dialog, qtbot).startswith("No model is installed")


def test_a_folder_without_a_model_is_refused(dialog, files, qtbot, tmp_path):
    said(dialog, qtbot)
    files.show = FileAnswers(tmp_path)
    dialog.buttons[0].click()
    assert said(dialog, qtbot) == (
        f"{tmp_path}: there is no Whisper model, model.bin is missing; choose its folder, or fetch it."
    )


def test_fetching_is_told_and_so_is_its_failure(dialog, qtbot, monkeypatch):
    def refuse(*_arguments, **_options) -> None:
        raise OSError("no network")

    said(dialog, qtbot)
    monkeypatch.setitem(sys.modules, "huggingface_hub", SimpleNamespace(snapshot_download=refuse))
    dialog.buttons[2].click()
    assert dialog.state.text() == "Downloading the model (145 MB)…"
    assert not dialog.buttons[2].isEnabled()
    assert said(dialog, qtbot).startswith("Whisper base cannot be fetched (no network)")


def test_the_menu_shows_it(desktop, qtbot, hand, whisper):
    shown = []

    def look(dialog) -> None:
        shown.append(said(dialog, qtbot))
        dialog.reject()

    hand.act = look
    desktop.window.menus.actions["Speech Encoder…"].trigger()
    assert shown[0].startswith("In use: Whisper base")
