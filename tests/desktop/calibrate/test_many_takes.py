"""A folder of many takes: opening it shows how far it is, and can be cancelled."""

from pathlib import Path
from threading import Event

import numpy as np
import pytest

from phonemeanalyser.desktop.calibrate.takes.takes_model import TakesModel
from phonemeengine.calibration.takes.project import TakeProject
from phonemeengine.phonemes import Phoneme
from tests.desktop.calibrate.calibrating import Calibrator, said


class SlowFolder(type(Path())):
    """A folder on a disk that answers when a test says so."""

    answers = Event()

    def mkdir(self, *words, **options):
        self.answers.wait(10)
        super().mkdir(*words, **options)


def filled(folder, n):
    with TakeProject(folder) as project:
        for _ in range(n):
            project.add(said(Phoneme.A, 0.4), "ann", Phoneme.A)
    return folder


def test_opening_is_cancelled_and_whatever_else_was_asked_is_done(qtbot, tmp_path):
    own, many, go_on = tmp_path / "own", filled(tmp_path / "many", 2), Event()

    def default_folder():
        go_on.wait(10)
        return own

    takes, seen = TakesModel(default_folder), []
    takes.opening_changed.connect(lambda: seen.append(takes.opening))
    takes.add(said(Phoneme.I, 0.5)[:, np.newaxis], 44100, Phoneme.I, "Desk")
    takes.open(many)
    takes.cancel_opening()
    go_on.set()
    qtbot.waitUntil(lambda: not takes.busy)
    assert takes.folder == own
    assert [take.phoneme for take in takes.now.takes] == [Phoneme.I]
    assert seen[0] == 0
    assert seen[-1] is None
    takes.open(many)  # nobody holds it
    qtbot.waitUntil(lambda: not takes.busy)
    assert takes.folder == many
    assert len(takes.now.takes) == 2
    assert len(takes.now.reports) == 2
    takes.close()


@pytest.mark.usefixtures("open_own_booth")  # no folder is open yet
def test_the_panel_shows_how_far_it_is_beside_a_button_that_cancels(open_booth, mic, tmp_path):
    calibrator = Calibrator(open_booth(mic), mic)
    panel, takes, many = calibrator.page.takes, calibrator.model.takes, filled(tmp_path / "many", 1)
    takes.open(SlowFolder(many))
    assert panel.project.text().endswith("0 %")
    assert panel.stop.isVisible()
    SlowFolder.answers.set()
    calibrator.settle()
    assert panel.project.text().endswith("many")
    assert not panel.stop.isVisible()
