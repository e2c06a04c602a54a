"""The tone generator gives what its numbers say, without a click and however it is read."""

import math
import threading
from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import parselmouth
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.analyser import analyse_blocks
from phonemeengine.audio.tone import (
    FADE,
    NOISE_SAMPLES,
    VOWEL_FORMANTS,
    Formant,
    Tone,
    ToneKind,
    ToneReader,
    vowel_of,
)
from phonemeengine.errors import SettingsError
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import BIN_WIDTH, SAMPLE_RATE, AnalysisSettings
from tests.sounds import Sound

RAW = Preset(settings=AnalysisSettings(filters=frozenset()))
VOWEL = Tone(ToneKind.VOWEL)
EVERY_KIND = [Tone(kind, level=0.0) for kind in ToneKind]


def heard(tone: Tone, n: int, start: int = 0) -> Sound:
    reader = ToneReader(tone)
    reader.seek(start)
    return reader.read(n)[:, 0]


def changed(first: Tone, then: Tone, at: int = 5000, n: int = 10_000) -> Sound:
    reader = ToneReader(first)
    before = reader.read(at)
    reader.set_tone(then)
    return np.concatenate((before, reader.read(n - at)))[:, 0]


def levels_of(wave: Sound, frequencies: Iterable[float]) -> Sound:
    """Amplitudes in dB at frequencies, each of which goes round a whole number of times in the wave."""
    spectrum = 2 * np.abs(np.fft.rfft(wave.astype(float))) / len(wave)
    bins = np.array([f * len(wave) / SAMPLE_RATE for f in frequencies])
    np.testing.assert_allclose(bins, np.rint(bins))
    return 20 * np.log10(spectrum[np.rint(bins).astype(int)])


@pytest.mark.parametrize("level", [0.0, -12.0, -60.0])
@pytest.mark.parametrize("k", [2, 46, 900])
def test_a_sine_on_a_bin_reads_its_level(k: int, level: float):
    wave = heard(Tone(frequency=k * BIN_WIDTH, level=level), SAMPLE_RATE // 5)
    spectra = np.concatenate([a.spectra for a in analyse_blocks([wave], RAW)])
    np.testing.assert_allclose(spectra[5:-5, k], 10 ** (level / 20), rtol=1e-4)
    assert (spectra[5:-5].argmax(axis=1) == k).all()


def test_a_sine_of_1_khz_crosses_zero_2000_times_a_second():
    wave = heard(Tone(frequency=1000.0), SAMPLE_RATE + 1, start=1)
    assert np.count_nonzero(np.diff(wave >= 0)) == pytest.approx(2000, abs=1)


def test_after_an_hour_the_phase_is_still_right():
    hour, samples = 3600 * SAMPLE_RATE, np.arange(1000)
    expected = np.sin(2 * np.pi * (0.3 * 3600 + 1234.3 * samples / SAMPLE_RATE))
    np.testing.assert_allclose(heard(Tone(frequency=1234.3, level=0.0), 1000, hour), expected, atol=1e-6)


@pytest.mark.parametrize("tone", EVERY_KIND, ids=lambda tone: tone.kind)
def test_no_kind_exceeds_its_level_and_every_kind_reaches_it(tone: Tone):
    wave = heard(tone, NOISE_SAMPLES)
    assert 0.995 < np.abs(wave).max() <= 1.0
    np.testing.assert_allclose(heard(replace(tone, level=-20.0), NOISE_SAMPLES), wave / 10, atol=1e-7)


def test_white_noise_is_flat_and_gaussian():
    wave = heard(Tone(ToneKind.WHITE_NOISE), NOISE_SAMPLES).astype(float)
    power = np.abs(np.fft.rfft(wave))[1:-1] ** 2
    bands = power[: len(power) // 16 * 16].reshape(16, -1).mean(axis=1)
    np.testing.assert_allclose(bands / bands.mean(), 1.0, atol=5 / math.sqrt(len(power) / 16))
    assert np.mean(np.abs(wave) < wave.std()) == pytest.approx(math.erf(1 / math.sqrt(2)), abs=0.003)


def test_pink_noise_falls_by_3_db_an_octave():
    wave = heard(Tone(ToneKind.PINK_NOISE), NOISE_SAMPLES).astype(float)
    power = np.abs(np.fft.rfft(wave)) ** 2
    frequencies = np.fft.rfftfreq(NOISE_SAMPLES, 1 / SAMPLE_RATE)
    octaves = [power[(frequencies >= f) & (frequencies < 2 * f)].mean() for f in 40 * 2.0 ** np.arange(9)]
    np.testing.assert_allclose(np.diff(10 * np.log10(octaves[2:])), 10 * math.log10(0.5), atol=0.3)
    assert power[frequencies < 19].max() < 1e-6 * power.max()


def test_a_sweep_passes_the_same_interval_in_the_same_time():
    tone = Tone(ToneKind.SWEEP, low=100.0, high=6400.0, sweep_seconds=6.0)
    for octave in range(6):
        wave = heard(tone, 4410, round((octave + 0.5) * SAMPLE_RATE) - 2205)
        crossings = np.flatnonzero(np.diff(wave >= 0))
        mid = 100.0 * 2 ** (octave + 0.5)
        rounds = (len(crossings) - 1) / 2
        measured = rounds * SAMPLE_RATE / (crossings[-1] - crossings[0])
        assert measured == pytest.approx(mid, rel=0.02)


def test_a_sweep_begins_again_without_a_click():
    tone = Tone(ToneKind.SWEEP, level=0.0, low=50.0, high=2000.0, sweep_seconds=1.0)
    wave = heard(tone, 3 * SAMPLE_RATE)
    np.testing.assert_allclose(wave[:SAMPLE_RATE], wave[SAMPLE_RATE : 2 * SAMPLE_RATE], atol=1e-6)
    assert np.abs(np.diff(wave)).max() <= 2 * math.pi * 2000 / SAMPLE_RATE
    seam = wave[SAMPLE_RATE - 30 : SAMPLE_RATE + 30]
    assert np.abs(np.diff(seam, 2)).max() < 0.01


def test_a_vowel_has_partials_at_multiples_of_f0_only():
    wave = heard(replace(VOWEL, f0=100.0), SAMPLE_RATE)
    spectrum = np.abs(np.fft.rfft(wave))
    partials = spectrum[100:10_001:100].copy()
    spectrum[100:10_001:100] = 0
    assert spectrum.max() < 1e-4 * partials.max()
    assert (partials[:60] > spectrum.max()).all()


def test_one_formant_weighs_the_partials_by_its_formula():
    formant = Formant(1000.0, 80.0)
    wave = heard(Tone(ToneKind.VOWEL, f0=100.0, formants=(formant,)), SAMPLE_RATE)
    frequencies = np.arange(100.0, 5001.0, 100.0)
    numerator = formant.frequency**2 + (formant.bandwidth / 2) ** 2
    gain = numerator / np.abs((40 + 1j * (frequencies - 1000)) * (40 + 1j * (frequencies + 1000)))
    expected = 20 * np.log10(gain / frequencies)
    measured = levels_of(wave, frequencies)
    np.testing.assert_allclose(measured - measured[9], expected - expected[9], atol=0.05)


@pytest.mark.parametrize("name", VOWEL_FORMANTS)
def test_the_spectrum_of_a_vowel_peaks_at_its_formants(name: str):
    wave = heard(Tone(ToneKind.VOWEL, f0=50.0, formants=VOWEL_FORMANTS[name]), SAMPLE_RATE)
    frequencies = np.arange(50.0, 5001.0, 50.0)
    flat = levels_of(wave, frequencies) + 20 * np.log10(frequencies)  # less the source
    peaks = [frequencies[k] for k in range(1, len(flat) - 1) if flat[k - 1] < flat[k] > flat[k + 1]]
    for formant in VOWEL_FORMANTS[name][:3]:
        assert min(abs(peak - formant.frequency) for peak in peaks) <= 50


def test_the_vowels_are_the_means_of_fifty_men():
    table = parselmouth.praat.call("Create formant table (Pols & Van Nierop 1973)")
    n_rows = int(parselmouth.praat.call(table, "Get number of rows"))
    rows = [
        {c: parselmouth.praat.call(table, "Get value", row, c) for c in ("Sex", "Vowel", "F1", "F2", "F3")}
        for row in range(1, n_rows + 1)
    ]
    for name, dutch in {"a": "aa", "e": "ee", "i": "ie", "o": "oo", "u": "oe"}.items():
        men = [row for row in rows if row["Sex"] == "m" and row["Vowel"] == dutch]
        means = [np.mean([float(row[f]) for row in men]) for f in ("F1", "F2", "F3")]
        np.testing.assert_allclose([f.frequency for f in VOWEL_FORMANTS[name][:3]], means, atol=0.51)


CHANGES = {
    "frequency": (Tone(frequency=300.0), Tone(frequency=700.0)),
    "level": (Tone(frequency=300.0, level=0.0), Tone(frequency=300.0, level=-80.0)),
    "kind": (Tone(frequency=300.0), replace(VOWEL, f0=200.0)),
    "formants": (VOWEL, replace(VOWEL, formants=VOWEL_FORMANTS["u"])),
    "f0": (replace(VOWEL, f0=100.0), replace(VOWEL, f0=200.0)),
    "sweep": (
        Tone(ToneKind.SWEEP, low=50.0, high=800.0, sweep_seconds=1.0),
        Tone(ToneKind.SWEEP, low=50.0, high=1500.0, sweep_seconds=1.3),
    ),
}


@pytest.mark.parametrize("name", CHANGES)
@pytest.mark.parametrize("at", [4801, 5037])
def test_a_change_makes_no_click(name: str, at: int):
    before, after = CHANGES[name]
    steps = np.abs(np.diff(changed(before, after, at)))
    usual = max(np.abs(np.diff(heard(tone, SAMPLE_RATE))).max() for tone in (before, after))
    assert steps[at - 2 : at + FADE + 2].max() <= 1.1 * usual


def test_a_change_is_over_after_5_ms():
    wave = changed(Tone(frequency=300.0, level=0.0), Tone(ToneKind.VOWEL), 5000)
    np.testing.assert_array_equal(wave[5000 + FADE :], heard(VOWEL, 5000)[FADE:])


def test_a_sine_keeps_its_amplitude_while_its_frequency_glides():
    wave = changed(Tone(frequency=2000.0, level=0.0), Tone(frequency=2400.0, level=0.0))
    peaks = np.abs(wave[4980 : 5000 + FADE + 20])
    tops = [peaks[k : k + 22].max() for k in range(len(peaks) - 22)]  # each stretch holds two half waves
    assert min(tops) > 0.95


def test_the_phase_runs_on_through_a_change_of_level():
    wave = changed(Tone(frequency=440.0, level=0.0), Tone(frequency=440.0, level=-6.0))
    np.testing.assert_allclose(wave[6000:], heard(Tone(frequency=440.0, level=-6.0), 10_000)[6000:], atol=1e-6)


def test_changes_that_follow_faster_than_the_fade_end_at_the_last():
    reader = ToneReader(Tone(frequency=200.0))
    blocks = []
    for k in range(200):
        reader.set_tone(Tone(frequency=200.0 + k))
        blocks.append(reader.read(10))
    blocks.append(reader.read(2 * FADE))
    wave = np.concatenate(blocks)[:, 0]
    assert np.abs(np.diff(wave)).max() <= 1.05 * 10 ** (-12 / 20) * 2 * math.pi * 400 / SAMPLE_RATE
    last = reader.read(SAMPLE_RATE)[:, 0]
    assert np.count_nonzero(np.diff(last >= 0)) == pytest.approx(2 * 399, abs=1)


@pytest.mark.parametrize("tone", EVERY_KIND, ids=lambda tone: tone.kind)
@given(cuts=st.lists(st.integers(0, 700), min_size=1, max_size=12), start=st.integers(0, 1 << 40))
def test_a_tone_does_not_depend_on_how_it_was_cut(tone: Tone, cuts: list[int], start: int):
    reader = ToneReader(tone)
    reader.seek(start)
    parts = np.concatenate([reader.read(n) for n in cuts])
    np.testing.assert_array_equal(parts[:, 0], heard(tone, sum(cuts), start))


def test_a_change_does_not_depend_on_how_it_was_cut():
    pieces = []
    reader = ToneReader(Tone(frequency=500.0))
    pieces.append(reader.read(1000))
    reader.set_tone(VOWEL)
    pieces += [reader.read(n) for n in (1, 7, 100, 200, 692)]
    np.testing.assert_array_equal(
        np.concatenate(pieces)[:, 0], changed(Tone(frequency=500.0), VOWEL, at=1000, n=2000)
    )


def test_the_stream_ends_where_it_says():
    reader = ToneReader(Tone())
    reader.seek(reader.n_samples - 100)
    assert reader.read(882).shape == (100, 1)
    assert reader.read(882).shape == (0, 1)
    assert reader.position == reader.n_samples == reader.duration * SAMPLE_RATE
    reader.seek(-5)
    assert reader.position == 0


def test_a_tone_may_be_changed_from_another_thread():
    reader = ToneReader(Tone(frequency=100.0, level=0.0))
    done = threading.Event()

    def drag() -> None:
        while not done.is_set():
            for k in range(50):
                reader.set_tone(Tone(frequency=100.0 + 10 * k, level=0.0))

    hand = threading.Thread(target=drag)
    hand.start()
    wave = np.concatenate([reader.read(882) for _ in range(300)])[:, 0]
    done.set()
    hand.join()
    assert np.abs(np.diff(wave)).max() <= 1.05 * 2 * math.pi * 600 / SAMPLE_RATE
    assert np.abs(wave).max() <= 1.0


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        ({"frequency": 0.0}, r"frequency must lie in 20\.\.20000 Hz, got 0"),
        ({"frequency": math.nan}, r"frequency must lie in 20\.\.20000 Hz, got nan"),
        ({"level": 3.0}, r"level must lie in -80\.\.0 dB, got 3"),
        ({"f0": 20.0}, r"f0 must lie in 50\.\.500 Hz, got 20"),
        ({"sweep_seconds": 0.0}, r"sweep_seconds must lie in 0\.2\.\.120 s, got 0"),
        ({"low": 500.0, "high": 400.0}, "a sweep must rise, got low 500 Hz and high 400 Hz"),
        ({"formants": ()}, r"the number of formants must lie in 1\.\.5, got 0"),
    ],
)
def test_an_impossible_tone_is_refused_in_one_sentence(wrong: dict[str, float], sentence: str):
    with pytest.raises(SettingsError, match=sentence):
        replace(Tone(), **wrong)


def test_an_impossible_formant_is_refused_in_one_sentence():
    with pytest.raises(SettingsError, match=r"a formant's frequency must lie in 100\.\.8000 Hz, got 9000"):
        Formant(9000.0)
    with pytest.raises(SettingsError, match=r"a formant's bandwidth must lie in 20\.\.1000 Hz, got 0"):
        Formant(500.0, 0.0)


def test_a_vowel_is_known_by_its_formants():
    assert vowel_of(VOWEL_FORMANTS["e"]) == "e"
    assert vowel_of((Formant(500.0),)) is None
