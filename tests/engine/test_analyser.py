"""The whole way of a sound: the result never depends on how the sound was cut."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from phonemeengine.analyser import Analyser, Analysis, analyse_blocks
from phonemeengine.features.variables import Kind, Spectrum, Variable
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import Thresholds
from phonemeengine.recognition.segments import intensities_of
from phonemeengine.settings import BIN_WIDTH, WINDOW, AnalysisSettings, Decimation, Filter, WindowFunction
from tests.sounds import Sound, noise, silence, tone, vowel

EVERYTHING = AnalysisSettings(
    filters=frozenset(Filter),
    decimation=Decimation.ANTI_ALIASED,
    window_function=WindowFunction.BLACKMAN_HARRIS,
    frequency_smooth=0.4,
    time_smooth=0.5,
    denoise_threshold=1e-4,
    minimum_hold=0.05,
)
MINE = (Variable("mine", 300, 900, Kind.MEAN, Spectrum.MEL), Variable("more", 300, 3000, Kind.MAX, Spectrum.RAW))
THESIS = Preset()
SMOOTH = Preset(settings=AnalysisSettings(time_smooth=0.7, frequency_smooth=0.5))
FULL = Preset(settings=EVERYTHING, variables=MINE)
BARE = Preset(settings=AnalysisSettings(filters=frozenset(), statistics=False))
FRONT_ENDS = {"thesis": THESIS, "smooth": SMOOTH, "everything": FULL, "bare": BARE}
SPEECH = np.concatenate(
    (
        noise(0.05, 1e-4),
        vowel((700, 1200, 2500), 0.15),
        silence(0.5),
        noise(0.1, 0.2, seed=1),
        vowel((310, 800, 2300), 0.17, f0=210),
        tone(3000, 0.0312, 0.8),
    )
)


def joined(analyses: list[Analysis]) -> dict[str, Sound]:
    """Put the blocks of one sound together, as arrays by name."""
    kept = [a for a in analyses if len(a)]
    assert [a.start for a in kept] == np.cumsum([0, *(len(a) for a in kept)])[:-1].tolist()
    parts = {"spectra": [a.spectra for a in kept], "features": [a.features.values for a in kept]}
    parts |= {name: [getattr(a, name) for a in kept] for name in ("recognised", "phonemes", "intensities", "times")}
    parts |= {"mel": [a.mel for a in kept]} if kept[0].mel is not None else {}
    return {name: np.concatenate(blocks) for name, blocks in parts.items()}


def analysed(blocks: list[Sound], preset: Preset, *, pitch: bool = False) -> dict[str, Sound]:
    analyser = Analyser(preset, pitch=pitch)
    return joined([*(analyser.push(block) for block in blocks), analyser.finish()])


def equal_up_to_rounding(found: dict[str, Sound], expected: dict[str, Sound]) -> None:
    assert found.keys() == expected.keys()
    for name in ("recognised", "phonemes"):
        np.testing.assert_array_equal(found[name], expected[name])
    for name in found.keys() - {"recognised", "phonemes"}:
        np.testing.assert_allclose(found[name], expected[name], rtol=1e-3, atol=1e-4, err_msg=name)


few_cuts = st.lists(st.integers(0, len(SPEECH)), max_size=10)
many_small = st.lists(st.sampled_from([0, 1, 1, 2, 64, 440, 441, 442, 2048, 20_000]), min_size=1, max_size=60)


@pytest.mark.parametrize("preset", FRONT_ENDS.values(), ids=FRONT_ENDS)
@settings(max_examples=12)
@given(cuts=st.one_of(few_cuts, many_small.map(np.cumsum)))
def test_frames_do_not_depend_on_how_the_sound_was_cut(preset: Preset, cuts: list[int]):
    blocks = np.split(SPEECH, np.sort(np.minimum(cuts, len(SPEECH))))
    equal_up_to_rounding(analysed(blocks, preset, pitch=True), analysed([SPEECH], preset, pitch=True))


@pytest.mark.parametrize("preset", FRONT_ENDS.values(), ids=FRONT_ENDS)
def test_live_blocks_of_ten_milliseconds_give_what_the_whole_file_gives(preset: Preset):
    sound = np.tile(SPEECH, 6)  # more frames than are worked on at once
    live = analysed([sound[k : k + 441] for k in range(0, len(sound), 441)], preset)
    equal_up_to_rounding(live, analysed([sound], preset))


@pytest.mark.parametrize("preset", FRONT_ENDS.values(), ids=FRONT_ENDS)
@settings(max_examples=20)
@given(n=st.integers(0, 6000))
def test_a_sound_has_one_frame_for_every_ten_milliseconds_begun(preset: Preset, n: int):
    assert sum(len(a) for a in analyse_blocks([SPEECH[:n]], preset)) == -(-n // 441)


def test_an_empty_sound_has_no_frames():
    assert list(analyse_blocks([], THESIS)) == []
    assert list(analyse_blocks([silence(0)] * 3, THESIS)) == []
    nothing = Analyser(FULL).push(silence(0))
    assert len(nothing) == 0
    assert nothing.spectra.shape == (0, 256)
    assert nothing.mel.shape == (0, 40)
    assert nothing.features.values.shape == (0, len(nothing.features.names))
    assert len(nothing.times) == 0


def test_a_sound_of_one_sample_has_one_frame():
    (analysis,) = analyse_blocks([np.array([0.5], np.float32)], THESIS)
    assert len(analysis) == 1
    assert analysis.features["volume"][0] == 0.5
    assert analysis.times.tolist() == pytest.approx([0.005])


@pytest.mark.parametrize("k", [0, 2, 29])
def test_a_frame_is_centred_on_the_middle_of_its_ten_milliseconds(k: int):
    click = silence(0.3)
    click[441 * k + 220] = 1
    weights = AnalysisSettings(filters=frozenset({Filter.WINDOW_FUNCTION}), window_function=WindowFunction.BARTLETT)
    analyser = Analyser(Preset(settings=weights))
    analysis = analyser.push(click)
    energies = np.concatenate((analysis.features["energy"], analyser.finish().features["energy"]))
    assert energies.argmax() == k
    for other in range(1, min(k, 29 - k, 2) + 1):
        assert energies[k - other] == pytest.approx(energies[k + other], rel=0.01)


@pytest.mark.parametrize("k", [0, 3, 10])
def test_a_frame_hears_its_window_and_nothing_else(k: int):
    first, beyond = 441 * k + 220 - 1024, 441 * k + 220 + 1024
    for sample, heard in ((first - 1, False), (first, True), (beyond - 1, True), (beyond, False)):
        if sample >= 0:
            click = silence(0.3)
            click[sample] = 1
            assert (analysed([click], THESIS)["features"][k, 1] == 1) == heard


def test_the_waveform_is_the_newest_window_with_its_middle_in_the_middle():
    click = silence(0.1)
    click[220] = 1
    analysis = Analyser(BARE).push(click[: 220 + 1024])
    assert len(analysis) == 1
    assert analysis.waveforms.shape == (1, 2048)
    assert analysis.waveforms[0].argmax() == 1024


def test_times_are_the_middles_of_the_frames():
    analyser = Analyser(THESIS)
    times = np.concatenate(
        [analyser.push(silence(0.5)).times, analyser.push(silence(0.5)).times, analyser.finish().times]
    )
    np.testing.assert_allclose(times, 0.005 + 0.01 * np.arange(100))


def test_with_all_filters_off_the_raw_spectrum_has_1024_bins():
    sound = noise(0.2)
    spectra = analysed([sound], BARE)["spectra"]
    padded = np.concatenate((np.zeros(WINDOW), sound, np.zeros(WINDOW)))
    starts = WINDOW + 441 * np.arange(20) + 220 - 1024
    expected = np.abs(np.fft.rfft([padded[s : s + WINDOW] for s in starts], axis=1))[:, :1024] / 1024
    expected[:, 0] /= 2
    np.testing.assert_allclose(spectra, expected, atol=1e-6)


@pytest.mark.parametrize("step", [1, 4])
def test_a_tone_reads_its_amplitude_at_its_frequency_in_every_quantisation(step: int):
    preset = Preset(settings=AnalysisSettings(filters=frozenset({Filter.QUANTISE}), quantise=step))
    spectrum = analysed([tone(100 * BIN_WIDTH, 0.3, 0.5)], preset)["spectra"][15]
    assert len(spectrum) == 1024 // step
    assert spectrum.argmax() == 100
    assert spectrum[100] == pytest.approx(0.5, rel=1e-3)


def test_silence_is_recognised_as_silence():
    assert set(analysed([silence(0.3)], THESIS)["phonemes"].tolist()) == {Phoneme.SILENCE}
    assert analysed([silence(0.3)], THESIS)["intensities"].max() == 0


@pytest.mark.parametrize("statistics", [True, False])
def test_what_is_silence_has_no_intensity_however_loud_it_is(statistics: bool):
    deaf = Thresholds(silence_zero_crossings=300, silence_energy=1e6, silence_max_energy=1e6, silence_szsch1=1e6)
    preset = Preset(settings=AnalysisSettings(statistics=statistics), thresholds=deaf)
    found = analysed([np.concatenate((tone(441, 0.3, 0.5), noise(0.3, 0.5)))], preset)
    quiet = found["phonemes"] == Phoneme.SILENCE
    assert 20 < np.count_nonzero(quiet) < 40
    assert not found["intensities"][quiet].any()
    assert (found["intensities"][~quiet] > 0.5).all()


def test_intensity_rises_from_the_low_level_to_the_high_one():
    levels = (10 ** (np.array([-90, -45, -25.5, -6, 0]) / 20)).astype(np.float32)
    np.testing.assert_allclose(intensities_of(levels, -45, -6), [0, 0, 0.5, 1, 1], atol=1e-5)
    assert intensities_of(np.zeros(1, np.float32), -45, -6)[0] == 0


def test_intensity_of_a_range_of_no_width_is_a_step():
    levels = np.array([0.05, 0.2], np.float32)
    np.testing.assert_array_equal(intensities_of(levels, -20, -20), [0, 1])


@pytest.mark.parametrize(("decibels", "intensity"), [(-60, 0), (-40, 0), (-30, 0.5), (-20, 1), (0, 1)])
def test_a_tone_has_the_intensity_of_its_level(decibels: float, intensity: float):
    preset = Preset(settings=AnalysisSettings(intensity_low=-40, intensity_high=-20))
    found = analysed([tone(441, 0.2, 10 ** (decibels / 20))], preset)["intensities"]
    np.testing.assert_allclose(found, intensity, atol=1e-3)


@pytest.mark.parametrize("next_preset", [BARE, FULL, Preset(thresholds=Thresholds(ae_ae1=0.9))])
@pytest.mark.parametrize("cut", [3000, 20_000])
def test_another_preset_acts_on_the_next_frame_and_on_no_earlier_one(next_preset: Preset, cut: int):
    without = replace(next_preset, settings=replace(next_preset.settings, time_smooth=0, statistics=False))
    analyser = Analyser(replace(THESIS, settings=replace(THESIS.settings, statistics=False)))
    before = analyser.push(SPEECH[:cut])
    analyser.set_preset(without)
    after = [analyser.push(SPEECH[cut:]), analyser.finish()]
    n = len(before)
    assert after[0].start == n
    assert analyser.preset is without
    for name, expected in (("before", analysed([SPEECH], THESIS)), ("after", analysed([SPEECH], without))):
        found = [before] if name == "before" else after
        frames = slice(0, n) if name == "before" else slice(n, None)
        for what in ("recognised", "spectra"):
            values = np.concatenate([getattr(a, what) for a in found])
            np.testing.assert_allclose(values, expected[what][frames], rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize(
    "change",
    [
        {"thresholds": Thresholds(ae_ae1=0.9)},
        {"variables": MINE},
        {"settings": replace(SMOOTH.settings, intensity_low=-50)},
    ],
)
def test_what_does_not_concern_the_smoothing_leaves_its_memory_alone(change: dict[str, object]):
    analyser = Analyser(SMOOTH)
    parts = [analyser.push(SPEECH[:8000])]
    analyser.set_preset(replace(SMOOTH, **change))
    parts += [analyser.push(SPEECH[8000:]), analyser.finish()]
    spectra = np.concatenate([part.spectra for part in parts])
    np.testing.assert_allclose(spectra, analysed([SPEECH], SMOOTH)["spectra"], rtol=1e-3, atol=1e-4)


def test_smoothing_that_was_off_for_a_while_forgets_what_was_before():
    smooth = AnalysisSettings(filters=frozenset({Filter.TIME_SMOOTH, Filter.QUANTISE}), time_smooth=0.9)
    plain = replace(smooth, filters=frozenset({Filter.QUANTISE}))
    analyser = Analyser(Preset(settings=smooth))
    analyser.push(tone(1000, 1))
    analyser.set_preset(Preset(settings=plain))
    analyser.push(silence(1))
    analyser.set_preset(Preset(settings=smooth))
    assert analyser.push(silence(0.1)).spectra.max() == 0


def test_what_was_found_cannot_change_when_more_sound_comes():
    analyser = Analyser(FULL)
    first = analyser.push(SPEECH[:10_000])
    copies = first.spectra.copy(), first.features.values.copy(), first.phonemes.copy()
    analyser.push(SPEECH[10_000:])
    for now, then in zip((first.spectra, first.features.values, first.phonemes), copies, strict=True):
        np.testing.assert_array_equal(now, then)


def test_a_part_of_an_analysis_is_an_analysis():
    whole = Analyser(FULL).push(SPEECH)
    part = whole.part(slice(3, 7))
    assert (part.start, len(part)) == (3, 4)
    np.testing.assert_array_equal(part.features["mine"], whole.features["mine"][3:7])
    np.testing.assert_allclose(part.times, whole.times[3:7])


def test_a_part_of_a_block_is_what_those_frames_would_be_alone():
    sound = noise(0.4)
    whole = Analyser(BARE).push(sound)
    part = whole.part(slice(5, 20))
    assert (part.start, len(part)) == (5, 15)
    for name in ("spectra", "waveforms", "recognised", "phonemes", "intensities"):
        np.testing.assert_array_equal(getattr(part, name), getattr(whole, name)[5:20])
    np.testing.assert_array_equal(part.features.values, whole.features.values[5:20])
    np.testing.assert_array_equal(part.times, whole.times[5:20])
