"""What the user is asked for files, and what of it and of other choices is kept: endings, folders, lists, numbers."""

from pathlib import Path

import pytest
from PySide6.QtCore import QSettings

from phonemeanalyser.desktop.settings import keep, read, read_paths
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeengine.settings import Channel
from tests.desktop.hands import FileAnswers

PICTURES = "PNG image (*.png);;SVG drawing (*.svg)"


@pytest.mark.parametrize(
    ("name", "chosen", "others", "written"),
    [
        ("a", "", False, "a.png"),
        ("a", "Lines (*.svg)", False, "a.svg"),
        ("a.SVG", "", False, "a.SVG"),
        ("a.b", "Pixels (*.png)", False, "a.b.png"),
        ("a.mp3", "", True, "a.mp3"),
        ("demo 0.10-0.25", "", True, "demo 0.10-0.25.png"),
    ],
)
def test_a_name_without_an_ending_gets_that_of_the_chosen_filter(settings, tmp_path, name, chosen, others, written):
    asker = FileAsker(settings, FileAnswers(tmp_path / name, chosen=chosen))
    target = asker.ask_target("Save", tmp_path / "suggested.png", PICTURES, other_endings=others)
    assert target == tmp_path / written


def test_the_next_question_begins_where_the_last_one_of_its_kind_ended(settings, tmp_path):
    answers = FileAnswers(tmp_path / "here" / "a.toml")
    asker = FileAsker(settings, answers)
    assert asker.ask_file("Load", "Presets (*.toml)", "preset", Path("/before")) == tmp_path / "here" / "a.toml"
    asker.ask_files("Load", "Presets (*.toml)", "preset")
    asker.ask_file("Load", "Curves (*.csv)", "curve", Path("/curves"))
    assert answers.suggested == [Path("/before"), tmp_path / "here", Path("/curves")]


def test_who_cancels_changes_nothing(settings, tmp_path):
    asker = FileAsker(settings, FileAnswers())
    assert asker.ask_file("Load", "Presets (*.toml)", "preset", tmp_path) is None
    assert asker.ask_files("Load", "Presets (*.toml)", "preset") == []
    assert asker.ask_folder("Folder", tmp_path) is None
    assert asker.ask_target("Save", tmp_path / "a.toml", "Presets (*.toml)", "preset") is None
    assert asker.folder_of("preset", Path("/before")) == Path("/before")


@pytest.mark.parametrize("value", [True, False, 7, -60.0, 0.08, "ä, b", Channel.LEFT, Path("/x/y.wav")])
def test_what_is_kept_comes_back_as_what_it_was(settings, value):
    keep(settings, "key", value)
    settings.sync()
    kept = read(QSettings(settings.fileName(), QSettings.Format.IniFormat), "key", value)
    assert (kept, type(kept)) == (value, type(value))


@pytest.mark.parametrize(("text", "default"), [("x", 7), ("inf", 7), ("nan", 0.5), ("no channel", Channel.MIX)])
def test_what_somebody_wrote_that_does_not_fit_is_the_default(settings, text, default):
    settings.setValue("key", text)
    assert read(settings, "key", default) == default


@pytest.mark.parametrize("names", [[], ["/a.wav"], ["/a.wav", "/b.wav"]])
def test_lists_of_paths_are_kept_however_short(settings, names):
    settings.setValue("recent", names)
    settings.sync()
    again = QSettings(settings.fileName(), QSettings.Format.IniFormat)
    assert read_paths(again, "recent") == [Path(name) for name in names]
