"""The averaged spectrum, and the curves beside it."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from engine.analyser import Analysis, analyses_of
from engine.curves import load_curve
from engine.errors import CurveError
from engine.presets.preset import Preset
from engine.settings import AnalysisSettings, Filter
from phonemeanalyser.models.averages import AveragesModel
from tests.sounds import Sound, noise, tone, vowel

SETTINGS = AnalysisSettings(filters=frozenset({Filter.QUANTISE}))
VOWEL = vowel((700, 1200, 2500), 0.3)


def found(sound: Sound, settings: AnalysisSettings = SETTINGS) -> list[Analysis]:
    return list(analyses_of([sound], Preset(settings=settings)))


@pytest.fixture
def averages(qapp: QApplication) -> AveragesModel:
    averages = AveragesModel()
    for analysis in found(VOWEL):
        averages.add(analysis)
    return averages


def test_it_averages_what_it_is_given(averages: AveragesModel) -> None:
    (whole,) = found(VOWEL)[:1]
    assert averages.n_frames == 30
    assert averages.current("now", "mine").n_frames == 30
    assert len(averages.current().amplitudes) == 256
    assert np.isfinite(averages.current().amplitudes).all()
    assert averages.current().amplitudes.max() <= whole.spectra.max()


def test_clearing_begins_anew_and_leaves_the_curves(averages: AveragesModel, tmp_path: Path) -> None:
    averages.save(tmp_path / "a.csv", "front")
    averages.clear()
    assert averages.n_frames == 0
    assert [curve.name for curve in averages.curves] == ["a"]
    assert np.isnan(averages.distances()).tolist() == [True]


def test_what_is_saved_is_kept_and_can_be_loaded(averages: AveragesModel, tmp_path: Path, qtbot: QtBot) -> None:
    with qtbot.waitSignal(averages.curves_changed):
        averages.save(tmp_path / "speaker a.csv", SETTINGS.front_end())
    (kept,) = averages.curves
    read = load_curve(tmp_path / "speaker a.csv")
    assert (read.name, read.front_end, read.n_frames) == ("speaker a", "quantise 4 plain", 30)
    np.testing.assert_allclose(read.amplitudes, kept.amplitudes, rtol=1e-8)
    with qtbot.waitSignal(averages.curves_changed):
        averages.load(tmp_path / "speaker a.csv")
    assert [curve.name for curve in averages.curves] == ["speaker a", "speaker a"]
    assert averages.distances() == pytest.approx([0, 0], abs=1e-4)


def test_distances_tell_sounds_apart(averages: AveragesModel, tmp_path: Path) -> None:
    averages.save(tmp_path / "a.csv", "front")
    for sound, name in ((noise(0.3), "noise"), (tone(1000, 0.3), "tone")):
        averages.clear()
        for analysis in found(sound):
            averages.add(analysis)
        averages.save(tmp_path / f"{name}.csv", "front")
    averages.clear()
    for analysis in found(VOWEL * np.float32(0.25)):
        averages.add(analysis)
    same, other, third = averages.distances()
    assert same < 1
    assert min(other, third) > 3


def test_a_curve_of_another_front_end_can_be_compared(averages: AveragesModel, tmp_path: Path) -> None:
    averages.save(tmp_path / "coarse.csv", "front")
    for analysis in found(VOWEL, AnalysisSettings(filters=frozenset())):
        averages.add(analysis)
    assert len(averages.current().amplitudes) == 1024
    assert np.isfinite(averages.distances()).all()


def test_a_curve_can_be_taken_away(averages: AveragesModel, tmp_path: Path, qtbot: QtBot) -> None:
    for name in "abc":
        averages.save(tmp_path / f"{name}.csv", "front")
    with qtbot.waitSignal(averages.curves_changed):
        averages.remove(1)
    assert [curve.name for curve in averages.curves] == ["a", "c"]


def test_a_file_that_is_no_curve_leaves_everything(averages: AveragesModel, tmp_path: Path) -> None:
    averages.save(tmp_path / "a.csv", "front")
    (tmp_path / "bad.csv").write_text("start_s,end_s\n")
    changes: list[None] = []
    averages.curves_changed.connect(lambda: changes.append(None))
    with pytest.raises(CurveError, match=r"^bad\.csv: "):
        averages.load(tmp_path / "bad.csv")
    with pytest.raises(CurveError, match=r"^b\.csv: cannot be written"):
        averages.save(tmp_path / "nowhere" / "b.csv", "front")
    assert [curve.name for curve in averages.curves] == ["a"]
    assert not changes
