"""Stretches of sounds are measured as Praat and a calculator measure them."""

from pathlib import Path

import numpy as np
import parselmouth
import pytest
import soundfile

from phonemeengine import AudioError, EngineError, Phoneme, SoundReader, load_preset, measure
from phonemeengine.inspection.measurement import format_measurement, frames_between, measure_stretch, save_stretch
from phonemeengine.inspection.speaker_spectra import average_spectrum
from phonemeengine.inspection.whole_sound import tracks_of
from phonemeengine.settings import SAMPLE_RATE

PRESET = load_preset("learned")


@pytest.fixture(scope="module")
def demo() -> Path:
    import phonemeanalyser

    return Path(phonemeanalyser.__file__).parent / "demo" / "demo.flac"


def written(folder: Path, samples: np.ndarray, rate: int = SAMPLE_RATE) -> Path:
    path = folder / "sound.wav"
    soundfile.write(path, samples, rate, subtype="FLOAT")
    return path


def test_a_tone_is_as_loud_as_it_is(tmp_path: Path) -> None:
    t = np.arange(2 * SAMPLE_RATE) / SAMPLE_RATE
    path = written(tmp_path, np.where(t < 1, 0.5 * np.sin(2 * np.pi * 200 * t), 0))
    found = measure(path, 0.0, 1.0, PRESET)
    assert found.level == pytest.approx(20 * np.log10(0.5 / np.sqrt(2)), abs=0.01)
    assert found.peak == pytest.approx(20 * np.log10(0.5), abs=0.01)
    assert found.statistics["f0"].mean == pytest.approx(200, rel=0.01)
    assert measure(path, 0.0, 2.0, PRESET).level == pytest.approx(found.level - 3.01, abs=0.02)
    silent = measure(path, 1.2, 2.0, PRESET)
    assert silent.shares == {Phoneme.SILENCE: 1.0}
    assert not {"f0", "F1"} & set(silent.statistics)


def test_pitch_and_formants_are_those_that_praat_finds(demo: Path) -> None:
    start, end = 0.0, 3.0
    found = measure(demo, start, end, PRESET)
    sound = parselmouth.Sound(str(demo))
    pitch = sound.to_pitch(0.01)
    formants = sound.to_formant_burg(0.01, 5, 5500.0, 0.025, 50.0)
    times = [t for t in pitch.xs() if start <= t < end and pitch.get_value_at_time(t) > 0]
    praat = np.mean([pitch.get_value_at_time(t) for t in times])
    assert found.statistics["f0"].mean == pytest.approx(praat, rel=0.05)
    for k in (1, 2):
        praat = np.nanmean([formants.get_value_at_time(k, t) for t in times])
        assert found.statistics[f"F{k}"].mean == pytest.approx(praat, rel=0.06), k
    assert sum(found.shares.values()) == pytest.approx(1)


def test_a_long_stretch_is_measured_in_parts_as_a_short_one_at_once(demo: Path, tmp_path: Path) -> None:
    second = soundfile.read(demo, SAMPLE_RATE, start=SAMPLE_RATE, dtype="float32")[0]
    path = written(tmp_path, np.tile(second, 65))
    short, long = measure(path, 1.0, 4.0, PRESET), measure(path, 1.0, 64.0, PRESET)
    assert (long.level, long.peak) == pytest.approx((short.level, short.peak), abs=1e-4)
    assert long.statistics["F1"].mean == pytest.approx(short.statistics["F1"].mean, rel=0.002)


def test_what_is_not_analysed_is_not_measured(demo: Path) -> None:
    with SoundReader(demo) as reader:
        tracks = tracks_of(reader)
    with pytest.raises(EngineError, match="still being analysed"):
        measure_stretch(lambda: SoundReader(demo), tracks, 0.5, 1.0)


@pytest.mark.parametrize(("start", "end"), [(2.0, 1.0), (1.0, 1.0), (1e6, 2e6), (-3.0, -1.0), (float("nan"), 1.0)])
def test_no_stretch_is_one_sentence(demo: Path, tmp_path: Path, start: float, end: float) -> None:
    for ask in (
        lambda: measure(demo, start, end, PRESET),
        lambda: average_spectrum(demo, start, end, PRESET, "x"),
        lambda: save_stretch(demo, start, end, tmp_path / "x.wav"),
    ):
        with pytest.raises(AudioError, match="there is no sound from"):
            ask()
    assert not list(tmp_path.iterdir())


def test_frames_are_those_whose_middles_lie_within() -> None:
    assert frames_between(0.0, 0.01, 100) == (0, 1)
    assert frames_between(0.004, 0.026, 100) == (0, 3)
    assert frames_between(0.006, 0.014, 100) == (1, 2)  # none has its middle there
    assert frames_between(-5.0, 99.0, 100) == (0, 100)


def test_a_stretch_is_saved_as_it_sounds(tmp_path: Path) -> None:
    generator = np.random.default_rng(1)
    stereo = generator.uniform(-0.5, 0.5, (SAMPLE_RATE, 2))
    path = written(tmp_path, stereo)
    save_stretch(path, 0.25, 0.5, tmp_path / "part.wav")
    part, rate = soundfile.read(tmp_path / "part.wav")
    assert (rate, part.shape) == (SAMPLE_RATE, (round(0.25 * SAMPLE_RATE), 2))
    assert np.allclose(part, stereo[11025:22050], atol=1e-6)
    with pytest.raises(AudioError, match="cannot be written"):
        save_stretch(path, 0.25, 0.5, tmp_path / "no such folder" / "part.wav")


def test_the_averaged_spectrum_of_a_stretch_is_that_of_its_frames(tmp_path: Path) -> None:
    t = np.arange(2 * SAMPLE_RATE) / SAMPLE_RATE
    path = written(tmp_path, 0.3 * np.sin(2 * np.pi * np.where(t < 1, 500, 2000) * t))
    low, high = (average_spectrum(path, a, b, PRESET, "x") for a, b in ((0.1, 0.9), (1.1, 1.9)))
    assert low.n_frames == high.n_frames == 80
    assert abs(low.frequencies[low.amplitudes.argmax()] - 500) < 25
    assert abs(high.frequencies[high.amplitudes.argmax()] - 2000) < 25


def test_the_table_names_what_it_holds(demo: Path) -> None:
    lines = format_measurement(measure(demo, 0.0, 2.0, PRESET)).splitlines()
    assert lines[0] == "measure,unit,mean,min,max"
    assert lines[1].startswith("duration,s,2.000")
    assert {line.split(",")[0] for line in lines} > {"level", "f0", "F1", "F2", "F3", "energy"}
