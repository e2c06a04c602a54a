"""The dock of averaged spectra: what a user adds, renames, hides, compares and saves there."""

import numpy as np
import pytest
import soundfile
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QDockWidget

from phonemeanalyser.desktop.analyse.spectra.curve_panel import FILTERS, LEVEL, NAME, SECONDS
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeengine.inspection.averaged_spectrum import load_averaged_spectrum
from phonemeengine.inspection.speaker_spectra import Grouping
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.desktop.hands import CARDS, FileAnswers, button, press, shown
from tests.labelled import recordings
from tests.sounds import tone


@pytest.fixture
def window(desktop, qtbot):
    window = shown(desktop, qtbot, CARDS)
    window.findChild(QDockWidget, "Spectra").raise_()
    qtbot.waitUntil(window.curves.isVisible)
    return window


@pytest.fixture
def curves(desktop):
    return desktop.session.curves


def choose(window, menu: str, entry: str) -> None:
    """Choose an entry of a menu of the panel."""
    actions = button(window.curves, menu).menu().actions()
    next(action for action in actions if action.text() == entry).trigger()


def cell(window, row: int, column: int) -> str:
    return window.curves.list.item(row, column).text()


def added(window, curves, qtbot, n: int) -> None:
    qtbot.waitUntil(lambda: len(curves.curves) == n and not curves.work.busy)


def labelled_folder(folder):
    """Write four labelled recordings of two speakers, each in a folder of its name."""
    for utterance in recordings(folder):
        place = folder / "corpus" / utterance.speaker
        place.mkdir(parents=True, exist_ok=True)
        sound = utterance.path.rename(place / utterance.path.name)
        rows = [f"{lab.start},{lab.end},{lab.phone},{lab.phoneme.label},core" for lab in utterance.labels]
        sound.with_suffix(".csv").write_text("\n".join(["start_s,end_s,phone,class,certainty", *rows]))
    return folder / "corpus"


def test_file_and_selection_are_rows_of_the_table_renamed_in_place_and_hidden_by_their_box(
    desktop, window, curves, qtbot
):
    table, drawn = window.curves.list, window.analysis.averaged
    choose(window, "Add", "This File")
    desktop.session.view.select(TimeSpan(0.5, 1.25))
    choose(window, "Add", "Selection")
    added(window, curves, qtbot, 2)
    assert [cell(window, row, NAME) for row in range(2)] == ["cards", "cards 0.50-1.25 s"]
    assert table.columnWidth(NAME) >= table.sizeHintForColumn(NAME)  # none is cut
    assert cell(window, 1, SECONDS) == "0.8"
    assert float(cell(window, 1, LEVEL)) == pytest.approx(curves.curves[1].level, abs=0.05)
    assert cell(window, 1, FILTERS) == "5.5 kHz, High-pass, Normalise"
    assert "75 frames" in table.item(1, NAME).toolTip()
    assert drawn.is_empty is False
    assert len(drawn.item.curves) == 3
    table.item(0, NAME).setText("Mara")
    assert curves.curves[0].name == "Mara"
    table.item(0, NAME).setText("")
    assert cell(window, 0, NAME) == "Mara"
    table.item(0, NAME).setCheckState(Qt.CheckState.Unchecked)
    assert curves.curves[0].hidden
    assert len(drawn.item.curves) == 2
    table.item(0, NAME).setCheckState(Qt.CheckState.Checked)
    assert not curves.curves[0].hidden


def test_the_average_of_a_selection_is_saved_without_any_playing(desktop, window, curves, qtbot, tmp_path):
    desktop.session.clear()
    desktop.session.view.select(TimeSpan(0.5, 1.25))
    window.menus.actions["Average Spectrum"].trigger()
    added(window, curves, qtbot, 1)
    window.files.show = answers = FileAnswers(as_suggested=True)
    window.files.remember("curve", tmp_path)
    window.menus.actions["Save Curve…"].trigger()
    assert answers.suggested == [tmp_path / "cards 0.50-1.25 s.csv"]
    assert load_averaged_spectrum(tmp_path / "cards 0.50-1.25 s.csv").is_same(curves.curves[0])


def test_the_matrix_shows_how_the_curves_differ_and_several_are_hidden_and_removed_at_a_time(
    desktop, window, curves, qtbot, tmp_path
):
    for name, hertz in (("a", 500), ("b", 1000), ("c", 2000)):
        soundfile.write(tmp_path / f"{name}.wav", tone(hertz, 0.3, 0.5), SAMPLE_RATE)
        window.dialogs.open_sound(tmp_path / f"{name}.wav")
        choose(window, "Add", "This File")
    added(window, curves, qtbot, 3)
    matrix, expected = window.curves.matrix, curves.differences(curves.curves)
    for k, other in ((0, 1), (0, 2), (1, 2)):
        for row, column in ((k, other), (other, k)):
            assert matrix.item(row, column).text() == f"{expected[k][other].decibels:.1f}"
    assert [matrix.item(k, k).text() for k in range(3)] == [""] * 3
    assert expected[0][1].words in matrix.item(0, 1).toolTip()
    assert "Gray and Markel" in matrix.toolTip()
    icon = matrix.horizontalHeaderItem(1).icon().pixmap(12).toImage()
    assert icon.pixelColor(6, 6) == QColor(curves.curves[1].colour)
    window.curves.list.choose([0, 2])
    window.curves.list.item(2, NAME).setCheckState(Qt.CheckState.Unchecked)
    assert [curve.hidden for curve in curves.curves] == [True, False, True]
    assert not matrix.isVisible()
    window.curves.list.setFocus()
    press(window.curves.list, Qt.Key.Key_Delete)
    assert [curve.name for curve in curves.curves] == ["b"]
    desktop.preset.undo_stack.undo()
    assert [curve.name for curve in curves.curves] == ["a", "b", "c"]


def test_vowels_of_the_speakers_of_a_folder_are_chosen_and_exported(window, curves, qtbot, hand, tmp_path):
    folder = labelled_folder(tmp_path)

    def choose_ada(dialog) -> None:
        assert [item.text() for item in dialog.items()] == ["ada", "bob"]
        assert {p for p, b in dialog.phonemes.items() if b.isChecked()} == {
            Phoneme.A,
            Phoneme.E,
            Phoneme.I,
            Phoneme.O,
            Phoneme.U,
        }
        assert not dialog.phonemes[Phoneme.SCH].isEnabled()
        assert list(dialog.groups()) == ["ada (vowels)", "bob (vowels)"]
        dialog.by.setCurrentIndex(dialog.by.findData(Grouping.SPEAKER_PHONEME))
        dialog.speakers.item(1).setCheckState(Qt.CheckState.Unchecked)
        for phoneme in (Phoneme.E, Phoneme.O, Phoneme.U):
            dialog.phonemes[phoneme].click()
        assert "2 curves of 1.2 s of sound" in dialog.told.text()
        dialog.accept()

    hand.act = choose_ada
    window.files.show = FileAnswers(folder)
    choose(window, "Add", "Folder…")
    added(window, curves, qtbot, 2)
    assert [curve.name for curve in curves.curves] == ["ada a", "ada i"]
    assert curves.chosen == (0, 1)  # what came together is chosen together
    window.curves.list.choose([1])
    window.files.show = FileAnswers(tmp_path / "levels.csv")
    choose(window, "Save", "Export Levels as CSV…")
    table = np.genfromtxt(tmp_path / "levels.csv", delimiter=",", names=True)
    assert table.dtype.names == ("frequency_hz", "ada_i_level_db", "ada_i_spread_db")  # the one that is selected
    window.curves.list.clearSelection()
    window.files.show = FileAnswers(tmp_path / "differences.csv")
    choose(window, "Save", "Export Differences as CSV…")
    assert (tmp_path / "differences.csv").read_text().startswith("difference_db,ada a,ada i\nada a,0,")
    window.files.show = FileAnswers(tmp_path / "picture.png")
    choose(window, "Save", "Save Picture…")
    assert (tmp_path / "picture.png").stat().st_size > 1000


@pytest.fixture
def in_workbench(window, tmp_path):
    """Four recordings of two speakers, as if the workbench had loaded them."""
    before, found = window.dialogs.curves.loaded, recordings(tmp_path)
    window.dialogs.curves.loaded = lambda: found
    yield
    window.dialogs.curves.loaded = before


@pytest.mark.usefixtures("in_workbench")
def test_labels_of_the_file_and_of_the_workbench_are_offered(window, curves, qtbot, hand):
    def choose_file(dialog) -> None:
        assert [dialog.source.itemText(k) for k in range(2)] == ["This file: cards.flac", "Calibrate: 4 recordings"]
        assert [item.text() for item in dialog.items()] == ["cards"]
        dialog.source.setCurrentIndex(1)
        assert [item.text() for item in dialog.items()] == ["ada", "bob"]
        button(dialog, "None").click()
        assert dialog.groups() == {}
        assert "Choose at least one speaker" in dialog.told.text()
        assert not dialog.add.isEnabled()
        dialog.source.setCurrentIndex(0)
        dialog.by.setCurrentIndex(dialog.by.findData(Grouping.PHONEME))
        dialog.accept()

    hand.act = choose_file
    choose(window, "Add", "By Phoneme…")
    qtbot.waitUntil(lambda: len(curves.curves) > 1 and not curves.work.busy)
    assert {curve.name for curve in curves.curves} <= set("aeiou")


def test_what_is_not_there_is_one_sentence(desktop, window, curves, tmp_path):
    soundfile.write(tmp_path / "a.wav", tone(500, 0.3, 0.5), SAMPLE_RATE)
    window.dialogs.open_sound(tmp_path / "a.wav")
    desktop.session.clear()
    for menu, entry, said in (
        ("Add", "Selection", "Nothing is selected"),
        ("Add", "Microphone Since Clear", "The microphone has recorded nothing since Clear"),
        ("Add", "By Phoneme…", "There are no labels yet"),
        ("Save", "Save Curve…", "There is no averaged spectrum yet"),
        ("Save", "Export Levels as CSV…", "There is no averaged spectrum to export yet"),
    ):
        choose(window, menu, entry)
        assert window.banner.label.text().startswith(said)
    assert curves.curves == ()


def test_its_key_and_the_menu_of_the_plot_raise_the_table(window, qtbot):
    spectra, filters = (window.findChild(QDockWidget, name) for name in ("Spectra", "Filters"))
    filters.raise_()
    qtbot.waitUntil(lambda: not filters.visibleRegion().isEmpty() and spectra.visibleRegion().isEmpty())
    press(window, Qt.Key.Key_F8)
    qtbot.waitUntil(lambda: not spectra.visibleRegion().isEmpty())
    press(window, Qt.Key.Key_F8)
    assert spectra.isHidden()
    choose_in_plot = button(window.analysis.averaged, "Curves").menu().actions()
    next(action for action in choose_in_plot if action.text() == "Show Table").trigger()
    qtbot.waitUntil(lambda: not window.curves.visibleRegion().isEmpty())
