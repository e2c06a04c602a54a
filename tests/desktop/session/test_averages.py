"""The averaged spectrum, and the curves beside it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from phonemeanalyser.desktop.session.averages import AveragesModel
from phonemeengine.analyser import Analyser, Analysis, analyse_blocks
from phonemeengine.errors import CurveError
from phonemeengine.inspection.averaged_spectrum import load_averaged_spectrum
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import AnalysisSettings, Filter
from tests.sounds import Sound, noise, tone, vowel

SETTINGS = AnalysisSettings(filters=frozenset({Filter.QUANTISE}))
VOWEL = vowel((700, 1200, 2500), 0.3)


def found(sound: Sound, settings: AnalysisSettings = SETTINGS) -> list[Analysis]:
    return list(analyse_blocks([sound], Preset(settings=settings)))


@pytest.fixture
def averages(qapp: QApplication) -> AveragesModel:
    averages = AveragesModel()
    for analysis in found(VOWEL):
        averages.add(analysis)
    return averages


def test_it_averages_what_it_is_given(averages: AveragesModel) -> None:
    (whole,) = found(VOWEL)[:1]
    assert averages.n_frames == 30
    assert averages.current("now").n_frames == 30
    assert len(averages.current().amplitudes) == 256
    assert np.isfinite(averages.current().amplitudes).all()
    assert averages.current().amplitudes.max() <= whole.spectra.max()


def test_clearing_begins_anew_and_leaves_the_curves(averages: AveragesModel, tmp_path: Path) -> None:
    averages.save(tmp_path / "a.csv")
    averages.begin("Clear", "sound")
    assert averages.n_frames == 0
    assert [curve.name for curve in averages.curves] == ["a"]
    assert np.isnan(averages.distances()).tolist() == [True]


def test_what_is_saved_is_kept_and_can_be_loaded(averages: AveragesModel, tmp_path: Path, qtbot: QtBot) -> None:
    with qtbot.waitSignal(averages.curves_changed):
        averages.save(tmp_path / "speaker a.csv")
    (kept,) = averages.curves
    read = load_averaged_spectrum(tmp_path / "speaker a.csv")
    assert (read.name, read.front_end, read.n_frames) == ("speaker a", "quantise 4 plain", 30)
    np.testing.assert_allclose(read.amplitudes, kept.amplitudes, rtol=1e-8)
    with qtbot.waitSignal(averages.curves_changed):
        averages.load(tmp_path / "speaker a.csv")
    assert [curve.name for curve in averages.curves] == ["speaker a", "speaker a"]
    assert averages.distances() == pytest.approx([0, 0], abs=1e-4)


def test_a_change_of_the_filters_begins_a_new_mean_and_the_header_says_so(
    averages: AveragesModel, tmp_path: Path
) -> None:
    averages.begin("Play", "voice.wav")
    analyser = Analyser(Preset(settings=SETTINGS))
    averages.add(analyser.push(VOWEL))
    assert averages.since == "Play at 0.00 s of voice.wav"
    n_before = averages.n_frames
    analyser.set_preset(Preset(settings=replace(SETTINGS, statistics=False)))
    averages.add(analyser.push(VOWEL[:4410]))
    assert averages.n_frames == n_before + 10  # what does not shape a spectrum begins nothing
    louder = replace(SETTINGS, filters=frozenset({Filter.QUANTISE, Filter.HIGH_PASS}), high_pass_end=300)
    analyser.set_preset(Preset(settings=louder))
    averages.add(analyser.finish())
    averages.save(tmp_path / "a.csv")
    read = load_averaged_spectrum(tmp_path / "a.csv")
    assert read.front_end == "quantise 4 plain, high_pass 100-300 Hz"
    assert read.since.startswith("change of the filters at 0.3")
    assert read.since.endswith(" s of voice.wav")
    assert read.n_frames < 10


def test_distances_tell_sounds_apart(averages: AveragesModel, tmp_path: Path) -> None:
    averages.save(tmp_path / "a.csv")
    for sound, name in ((noise(0.3), "noise"), (tone(1000, 0.3), "tone")):
        averages.begin("Clear", "sound")
        for analysis in found(sound):
            averages.add(analysis)
        averages.save(tmp_path / f"{name}.csv")
    averages.begin("Clear", "sound")
    for analysis in found(VOWEL * np.float32(0.25)):
        averages.add(analysis)
    same, other, third = averages.distances()
    assert same < 1
    assert min(other, third) > 3


def test_a_curve_of_another_front_end_can_be_compared(averages: AveragesModel, tmp_path: Path) -> None:
    averages.save(tmp_path / "coarse.csv")
    for analysis in found(VOWEL, AnalysisSettings(filters=frozenset())):
        averages.add(analysis)
    assert len(averages.current().amplitudes) == 1024
    assert np.isfinite(averages.distances()).all()


def test_a_curve_can_be_taken_away(averages: AveragesModel, tmp_path: Path, qtbot: QtBot) -> None:
    for name in "abc":
        averages.save(tmp_path / f"{name}.csv")
    with qtbot.waitSignal(averages.curves_changed):
        averages.remove(1)
    assert [curve.name for curve in averages.curves] == ["a", "c"]


def test_a_file_that_is_no_curve_leaves_everything(averages: AveragesModel, tmp_path: Path) -> None:
    averages.save(tmp_path / "a.csv")
    (tmp_path / "bad.csv").write_text("start_s,end_s\n")
    changes: list[None] = []
    averages.curves_changed.connect(lambda: changes.append(None))
    with pytest.raises(CurveError, match=r"^bad\.csv: "):
        averages.load(tmp_path / "bad.csv")
    with pytest.raises(CurveError, match=r"^b\.csv: cannot be written"):
        averages.save(tmp_path / "nowhere" / "b.csv")
    assert [curve.name for curve in averages.curves] == ["a"]
    assert not changes
