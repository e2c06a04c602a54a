"""The running averaged spectrum."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.desktop.session.curves import RunningAverage
from phonemeengine.analyser import Analyser, Analysis, analyse_blocks
from phonemeengine.errors import CurveError
from phonemeengine.inspection.averaged_spectrum import load_averaged_spectrum
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import AnalysisSettings, Filter
from tests.sounds import Sound, vowel

SETTINGS = AnalysisSettings(filters=frozenset({Filter.QUANTISE}))
VOWEL = vowel((700, 1200, 2500), 0.3)


def found(sound: Sound, settings: AnalysisSettings = SETTINGS) -> list[Analysis]:
    return list(analyse_blocks([sound], Preset(settings=settings)))


@pytest.fixture
def averages() -> RunningAverage:
    averages = RunningAverage()
    for analysis in found(VOWEL):
        averages.add(analysis)
    return averages


def test_it_averages_what_it_is_given(averages: RunningAverage) -> None:
    (whole,) = found(VOWEL)[:1]
    assert averages.n_frames == 30
    assert averages.current("now").n_frames == 30
    assert len(averages.current().amplitudes) == 256
    assert np.isfinite(averages.current().amplitudes).all()
    assert averages.current().amplitudes.max() <= whole.spectra.max()


def test_clearing_begins_anew(averages: RunningAverage) -> None:
    averages.begin("Clear", "sound")
    assert averages.n_frames == 0


def test_what_is_saved_is_what_is_seen(averages: RunningAverage, tmp_path: Path) -> None:
    saved = averages.save(tmp_path / "speaker a.csv")
    read = load_averaged_spectrum(tmp_path / "speaker a.csv")
    assert (read.name, read.front_end, read.n_frames) == ("speaker a", "quantise 4 plain", 30)
    assert read.is_same(saved)
    assert saved.level == pytest.approx(20 * np.log10(np.sqrt(np.mean(VOWEL**2))), abs=0.5)


def test_a_place_that_cannot_be_written_is_refused(averages: RunningAverage, tmp_path: Path) -> None:
    with pytest.raises(CurveError, match=r"^b\.csv: cannot be written"):
        averages.save(tmp_path / "nowhere" / "b.csv")


def test_a_change_of_the_filters_begins_a_new_mean_and_the_header_says_so(
    averages: RunningAverage, tmp_path: Path
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
