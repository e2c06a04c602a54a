"""Labels of takes for Praat and Audacity, written from the menu beside the project."""

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

from phonemeengine.labels.files import read_labels
from phonemeengine.phonemes import Phoneme
from tests.desktop.calibrate.calibrating import Calibrator
from tests.desktop.hands import FileAnswers, click

pops_up = pytest.mark.qt_log_ignore("This plugin does not support")
"""Without a display, menus cannot be raised above other windows, and say so."""


@pytest.fixture
def calibrator(open_booth, mic):
    return Calibrator(open_booth(mic), mic)


def choose(calibrator: Calibrator, number: int) -> None:
    """Open the menu of the project with the mouse, and choose an entry with the keys."""

    def act() -> None:
        menu = QApplication.activePopupWidget()
        assert isinstance(menu, QMenu)
        for _ in range(number):
            QTest.keyClick(menu, Qt.Key.Key_Down)
        QTest.keyClick(menu, Qt.Key.Key_Return)

    QTimer.singleShot(200, act)
    click(calibrator.page.takes.open)
    calibrator.settle()


@pops_up
@pytest.mark.parametrize(("number", "suffix", "program"), [(2, ".TextGrid", "Praat"), (3, ".txt", "Audacity")])
def test_a_label_file_lies_beside_every_take_and_their_number_is_said(calibrator, number, suffix, program):
    calibrator.keep(Phoneme.A)
    calibrator.keep(Phoneme.I)
    choose(calibrator, number)
    folder = calibrator.model.takes.folder / "takes"
    assert calibrator.booth.banner == f"2 label files for {program} written to {folder}."
    for take in calibrator.takes:
        path = calibrator.model.takes.path_of(take).with_suffix(suffix)
        assert [x.phoneme for x in read_labels(path)] == [x.phoneme for x in take.to_labels()]
        assert read_labels(path)[-1].end == pytest.approx(take.duration, abs=1e-6)


@pops_up
def test_a_relabelled_take_has_its_textgrid_under_its_new_name(calibrator):
    calibrator.keep(Phoneme.A)
    choose(calibrator, 2)
    (take,) = calibrator.takes
    before = calibrator.model.takes.path_of(take)
    calibrator.model.takes.relabel(take.number, Phoneme.E)
    calibrator.settle()
    (take,) = calibrator.takes
    labels = read_labels(calibrator.model.takes.path_of(take).with_suffix(".TextGrid"))
    assert Phoneme.E in {x.phoneme for x in labels}
    assert not before.with_suffix(".TextGrid").exists()
    assert calibrator.model.workbench.utterances[0].labels == take.to_labels()


@pops_up
def test_without_a_take_it_says_what_to_do(calibrator):
    choose(calibrator, 2)
    assert calibrator.booth.banner == "There are no takes to write labels for. Record one first."


@pops_up
def test_what_somebody_put_there_is_kept_and_said(calibrator):
    calibrator.keep(Phoneme.A)
    (take,) = calibrator.takes
    path = calibrator.model.takes.path_of(take).with_suffix(".TextGrid")
    path.write_text("mine")
    choose(calibrator, 2)
    assert calibrator.booth.banner.endswith(
        "Files that were changed were kept under another name, such as a-1 (2).TextGrid."
    )
    assert path.with_name("a-1 (2).TextGrid").read_text() == "mine"


@pops_up
def test_the_folder_is_chosen_in_the_same_menu(calibrator, tmp_path):
    calibrator.booth.window.files.show = FileAnswers(tmp_path / "other")
    choose(calibrator, 1)
    assert calibrator.model.takes.folder == tmp_path / "other"
