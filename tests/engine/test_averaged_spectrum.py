"""Averaged spectra: means that are known, files that come back, shapes that are compared."""

from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.analyser import analyse_blocks
from phonemeengine.errors import CurveError
from phonemeengine.inspection.averaged_spectrum import (
    AveragedSpectrum,
    SoundPart,
    SpectrumAverage,
    check_comparable,
    distance_of,
    format_distances,
    format_spectra,
    load_averaged_spectrum,
    save_averaged_spectrum,
)
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import BIN_WIDTH, AnalysisSettings, Channel, Decimation, Filter, WindowFunction
from tests.disks import refused
from tests.sounds import Sound, noise, tone, vowel

COARSE = AnalysisSettings(filters=frozenset({Filter.QUANTISE}), quantise=4, decimation=Decimation.ANTI_ALIASED)
FINE = AnalysisSettings(filters=frozenset())
SPEECH = np.concatenate((vowel((700, 1200, 2500), 0.5), vowel((310, 800, 2300), 0.4, f0=210), noise(0.4, 0.05)))


def spectra(*rows: list[float]) -> np.ndarray:
    return np.array(rows, np.float32)


def curve_of(sound: Sound, settings: AnalysisSettings, name: str = "sound") -> AveragedSpectrum:
    average = SpectrumAverage()
    for analysis in analyse_blocks([sound], Preset(settings=settings)):
        average.add(analysis.spectra)
    return average.curve(name, settings.front_end())


def refusal_of(path: Path) -> str:
    with pytest.raises(CurveError) as refusal:
        load_averaged_spectrum(path)
    message = str(refusal.value)
    assert message.startswith(f"{path.name}: ")
    assert message.isprintable()
    assert len(message) < 250
    return message


# -- the mean -------------------------------------------------------------------------------------------------


def test_the_average_of_known_spectra_is_their_mean() -> None:
    average = SpectrumAverage()
    average.add(spectra([0, 1, 2, 3], [2, 1, 0, 1]))
    average.add(spectra([1, 4, 1, 2]))
    curve = average.curve("three", "quantise off")
    assert curve.amplitudes.tolist() == [1, 2, 1, 2]
    assert curve.frequencies.tolist() == [0, BIN_WIDTH, 2 * BIN_WIDTH, 3 * BIN_WIDTH]
    assert (curve.name, curve.front_end, curve.n_frames, average.n_frames) == ("three", "quantise off", 3, 3)


def test_an_hour_of_equal_spectra_averages_to_that_spectrum() -> None:
    average = SpectrumAverage()
    row = np.float32([0.1, 1e-6, 0.7])
    for _ in range(360):
        average.add(np.tile(row, (1000, 1)))
    np.testing.assert_allclose(average.curve("", "").amplitudes, row, rtol=1e-9)


@given(cuts=st.lists(st.integers(0, 40), max_size=6))
def test_the_average_does_not_depend_on_how_the_frames_came(cuts: list[int]) -> None:
    rows = np.random.default_rng(0).random((40, 5), np.float32)
    average = SpectrumAverage()
    for block in np.split(rows, np.sort(cuts).astype(int)):
        average.add(block)
    assert average.n_frames == 40
    np.testing.assert_allclose(average.curve("", "").amplitudes, rows.mean(axis=0), rtol=1e-6)


def test_clearing_forgets_everything() -> None:
    average = SpectrumAverage()
    average.add(spectra([5, 5]))
    average.clear()
    assert average.n_frames == 0
    average.add(spectra([1, 2]))
    assert average.curve("", "").amplitudes.tolist() == [1, 2]


def test_spectra_of_another_size_begin_the_average_anew() -> None:
    average = SpectrumAverage()
    average.add(spectra([5, 5], [5, 5]))
    average.add(spectra([1, 2, 3]))
    assert average.n_frames == 1
    assert average.curve("", "").amplitudes.tolist() == [1, 2, 3]


# -- one axis for all front ends ------------------------------------------------------------------------------


def test_curves_of_two_front_ends_agree_where_both_hear() -> None:
    coarse, fine = curve_of(SPEECH, COARSE), curve_of(SPEECH, FINE)
    assert (len(coarse.frequencies), len(fine.frequencies)) == (256, 1024)
    below = fine.frequencies[(fine.frequencies > 100) & (fine.frequencies < 5000)]
    difference = 20 * np.log10(coarse.at(below) / fine.at(below))
    assert np.abs(difference).max() < 1.0
    assert np.abs(difference).mean() < 0.2


def test_the_distance_of_one_sound_through_two_front_ends_is_less_than_that_of_two_sounds() -> None:
    coarse, fine = curve_of(SPEECH, COARSE), curve_of(SPEECH, FINE)
    other = curve_of(vowel((280, 2200, 3000), 1.0), COARSE)
    assert distance_of(coarse, fine) < 1.5
    assert distance_of(fine, other) > 5


def test_a_curve_says_nothing_beyond_its_end() -> None:
    curve = curve_of(SPEECH, COARSE)
    assert np.isnan(curve.at(np.array([5600.0]))).all()
    assert curve.at(curve.frequencies).tolist() == curve.amplitudes.tolist()


def test_a_curve_is_linear_between_its_bins() -> None:
    curve = AveragedSpectrum("", np.array([0.0, 10, 20]), np.array([1.0, 3, 0]), 1, "")
    assert curve.at(np.array([5.0, 12.5])).tolist() == [2.0, 2.25]


@pytest.mark.parametrize("settings", [COARSE, FINE])
def test_a_curve_has_no_distance_from_itself_however_loud(settings: AnalysisSettings) -> None:
    curve = curve_of(SPEECH, settings)
    assert distance_of(curve, curve) == 0
    assert distance_of(curve, replace(curve, amplitudes=curve.amplitudes * 2)) == pytest.approx(0, abs=0.01)


def test_a_distance_is_the_same_both_ways() -> None:
    one, other = curve_of(SPEECH, COARSE), curve_of(tone(1000, 0.5), FINE)
    assert distance_of(one, other) == distance_of(other, one)


def test_a_known_difference_in_shape_is_its_distance() -> None:
    flat = AveragedSpectrum("", np.arange(4.0), np.full(4, 0.1), 1, "")
    stepped = replace(flat, amplitudes=np.array([0.1, 0.1, 0.01, 0.01]))  # 0 dB and -20 dB: ±10 dB about the mean
    assert distance_of(flat, stepped) == pytest.approx(10)


def test_the_spread_is_the_standard_deviation_of_the_levels() -> None:
    average = SpectrumAverage()
    average.add(spectra([0.1, 0.5, 0], [0.001, 0.5, 0]))  # -20 and -60 dB, twice -6 dB, twice less than the least
    curve = average.curve("two", "")
    assert curve.spread is not None
    assert curve.spread == pytest.approx([20, 0, 0], abs=1e-3)


def test_the_level_is_that_of_the_samples_whatever_the_filters_do() -> None:
    average = SpectrumAverage()
    for analysis in analyse_blocks([tone(1000, 1.0, 0.5)], Preset()):
        middle = analysis.part(slice(10, 90))
        average.add(middle.linear_spectra, middle.frames.windows)
    assert average.curve("tone", "").level == pytest.approx(20 * np.log10(0.5 / np.sqrt(2)), abs=0.05)


def test_what_went_through_other_filters_is_not_compared() -> None:
    coarse, fine = curve_of(SPEECH, COARSE, "coarse"), curve_of(SPEECH, FINE, "fine")
    check_comparable(coarse, replace(coarse, name="again"))
    with pytest.raises(CurveError) as refusal:
        check_comparable(coarse, fine)
    assert str(refusal.value) == (
        "coarse and fine went through different filters (quantise 4 anti_aliased against quantise off); measure them "
        "again with the same ones"
    )
    more = replace(coarse, name="more", front_end=f"{coarse.front_end}, normalise")
    with pytest.raises(CurveError, match=r"filters \(no normalise against normalise\)"):
        check_comparable(coarse, more)
    with pytest.raises(CurveError, match="have different frequencies"):
        check_comparable(coarse, replace(coarse, frequencies=coarse.frequencies * 2))


def test_differences_are_a_table_with_gaps_where_filters_differ() -> None:
    flat = AveragedSpectrum("flat", np.arange(4.0), np.full(4, 0.1), 1, "bare")
    stepped = replace(flat, name="stepped", amplitudes=np.array([0.1, 0.1, 0.01, 0.01]))
    other = replace(flat, name="other", front_end="normalise")
    assert format_distances([flat, stepped, other]).splitlines() == [
        "difference_db,flat,stepped,other",
        "flat,0,10,",
        "stepped,10,0,",
        "other,,,0",
    ]


def test_levels_are_a_table_on_the_axis_of_the_finest_curve() -> None:
    long = AveragedSpectrum("a", np.arange(3.0), np.array([1, 0.1, 0]), 1, "", spread=np.array([1.0, 2, 3]))
    short = AveragedSpectrum("a", np.arange(2.0), np.ones(2), 1, "")
    assert format_spectra([long, short]).splitlines() == [
        "frequency_hz,a (1) level_db,a (1) spread_db,a (2) level_db,a (2) spread_db",
        "0,0,1,0,",
        "1,-20,2,0,",
        "2,-100,3,,",
    ]


def test_curves_without_a_common_frequency_have_no_distance() -> None:
    low = AveragedSpectrum("", np.array([0.0, 10]), np.ones(2), 1, "")
    high = AveragedSpectrum("", np.array([20.0, 30, 40]), np.ones(3), 1, "")
    assert np.isnan(distance_of(low, high))


# -- files ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("settings", [COARSE, FINE])
def test_a_saved_curve_comes_back(settings: AnalysisSettings, tmp_path: Path) -> None:
    curve = curve_of(SPEECH, settings, "Frau Müller, a: laut")
    save_averaged_spectrum(curve, tmp_path / "curve.csv")
    back = load_averaged_spectrum(tmp_path / "curve.csv")
    assert (back.name, back.front_end, back.n_frames) == (curve.name, curve.front_end, curve.n_frames)
    np.testing.assert_allclose(back.frequencies, curve.frequencies, rtol=1e-8)
    np.testing.assert_allclose(back.amplitudes, curve.amplitudes, rtol=1e-8)
    assert list(tmp_path.iterdir()) == [tmp_path / "curve.csv"]


def test_a_saved_curve_describes_itself(tmp_path: Path) -> None:
    save_averaged_spectrum(curve_of(SPEECH, COARSE, "two\nlines"), tmp_path / "curve.csv")
    lines = (tmp_path / "curve.csv").read_text(encoding="utf-8").splitlines()
    assert lines[:6] == [
        "# phonemeanalyser curve 1",
        "# name: two lines",
        "# front end: quantise 4 anti_aliased",
        "# bins: 256",
        "# frames: 130",
        "frequency_hz,amplitude,spread_db",
    ]
    assert len(lines) == 6 + 256


@given(name=st.text(max_size=20))
def test_any_name_survives_its_file(name: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    name = name.encode("utf-8", "replace").decode()
    path = tmp_path_factory.getbasetemp() / "named.csv"
    save_averaged_spectrum(AveragedSpectrum(name, np.array([0.0, 1]), np.ones(2), 1, "bare"), path)
    back = load_averaged_spectrum(path)
    assert back.name == " ".join(name.split())
    assert back.front_end == "bare"


def test_a_file_from_an_editor_on_windows_is_read(tmp_path: Path) -> None:
    path = tmp_path / "curve.csv"
    save_averaged_spectrum(curve_of(SPEECH, COARSE), path)
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes().replace(b"\n", b"\r\n"))
    assert load_averaged_spectrum(path).n_frames == 130


def test_all_that_belongs_to_a_curve_comes_back(tmp_path: Path) -> None:
    parts = (
        SoundPart(Path("two  blanks.wav"), Channel.LEFT, ((0.5, 1.25), (2.0, 2.5))),
        SoundPart(Path("b.wav"), Channel.MIX, ((0.0, 1.0),)),
    )
    curve = replace(curve_of(SPEECH, COARSE), parts=parts, colour="#3fb950", hidden=True, level=-23.5)
    save_averaged_spectrum(curve, tmp_path / "a.csv")
    back = load_averaged_spectrum(tmp_path / "a.csv")
    assert (back.parts, back.colour, back.hidden, back.level) == (parts, "#3fb950", True, -23.5)
    assert back.is_same(curve)
    assert curve.spread is not None
    assert back.spread == pytest.approx(curve.spread, rel=1e-8)


def test_a_curve_of_an_older_release_has_no_spread_and_no_sound(tmp_path: Path) -> None:
    (tmp_path / "old.csv").write_text(GOOD)
    old = load_averaged_spectrum(tmp_path / "old.csv")
    assert (old.spread, old.parts, old.hidden) == (None, (), False)
    assert np.isnan(old.level)


@pytest.mark.parametrize("words", ["{", '["a", "middle", []]', "[" * 99999])
def test_a_sound_that_cannot_be_is_refused(words: str, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(GOOD.replace("# name", f"# sound: {words}\n# name", 1))
    assert "'sound' in the header must be" in refusal_of(tmp_path / "a.csv")


GOOD = """# phonemeanalyser curve 1
# name: mine
# front end: quantise off
# bins: 3
# frames: 7
frequency_hz,amplitude
0,1
10,2
20,0.5
"""

# name: (what stands in the file, what is put there instead, what the refusal says)
CHANGES = {
    "another format": ("curve 1", "curve 2", "begins with the line '# phonemeanalyser curve 1'"),
    "no name": ("# name: mine\n", "", "the header lacks 'name'"),
    "no frames": ("# frames: 7\n", "", "the header lacks 'frames'"),
    "frames as a fraction": ("frames: 7", "frames: 7.5", "'frames' in the header must be a whole number"),
    "endless frames": ("frames: 7", "frames: " + "9" * 9000, "'frames' in the header must be a whole number"),
    "a bin too few": ("20,0.5\n", "", "announces 3 bins .* found 2"),
    "a bin too many": ("20,0.5\n", "20,0.5\n30,1\n", "announces 3 bins .* found 4"),
    "other columns": ("frequency_hz", "hertz", "columns must be frequency_hz,amplitude, found 'hertz,amplitude'"),
    "a word": ("10,2", "10,loud", "row 2 must hold 2 numbers, found '10,loud'"),
    "one number": ("10,2", "10", "row 2 must hold 2 numbers, found '10'"),
    "not a number": ("10,2", "10,nan", "row 2 must hold finite numbers"),
    "less than nothing": ("10,2", "10,-2", "row 2 must hold finite numbers of 0 or more"),
    "frequencies that fall": ("20,0.5", "5,0.5", "frequencies must rise"),
}


def test_the_good_file_is_good(tmp_path: Path) -> None:
    (tmp_path / "good.csv").write_text(GOOD)
    assert load_averaged_spectrum(tmp_path / "good.csv").amplitudes.tolist() == [1, 2, 0.5]


@pytest.mark.parametrize(("old", "new", "said"), CHANGES.values(), ids=CHANGES)
def test_a_wrong_curve_is_refused_with_what_is_wrong(old: str, new: str, said: str, tmp_path: Path) -> None:
    assert old in GOOD
    path = tmp_path / "wrong.csv"
    path.write_text(GOOD.replace(old, new, 1))
    with pytest.raises(CurveError, match=said):
        load_averaged_spectrum(path)
    refusal_of(path)


@pytest.mark.parametrize(
    "content", [b"", b"\n", b"start_s,end_s\n0,1\n", b"# phonemeanalyser curve 1\n", b"\xff\xfe\0"]
)
def test_what_is_no_curve_is_refused(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "none.csv"
    path.write_bytes(content)
    refusal_of(path)


def test_a_missing_file_a_folder_and_an_endless_file_are_refused(tmp_path: Path) -> None:
    (tmp_path / "folder.csv").mkdir()
    with (tmp_path / "endless.csv").open("wb") as file:
        file.truncate(5 << 20)
    assert "there is no such file" in refusal_of(tmp_path / "missing.csv")
    assert "this is a folder" in refusal_of(tmp_path / "folder.csv")
    assert "has at most 4 MB" in refusal_of(tmp_path / "endless.csv")


@given(where=st.integers(0, len(GOOD)), length=st.integers(0, 9), new=st.text("09.-,:#\nenaf ", max_size=6))
def test_a_damaged_curve_is_read_or_refused(
    where: int, length: int, new: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    path = tmp_path_factory.getbasetemp() / "damaged.csv"
    path.write_text(GOOD[:where] + new + GOOD[where + length :])
    with suppress(CurveError):
        curve = load_averaged_spectrum(path)
        assert len(curve.frequencies) == len(curve.amplitudes) >= 1


def test_a_place_that_cannot_be_written_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CurveError, match=r"^curve\.csv: cannot be written \(.*\); choose another folder$"):
        save_averaged_spectrum(curve_of(SPEECH, COARSE), tmp_path / "nowhere" / "curve.csv")


def test_an_old_curve_stays_until_the_new_one_is_complete(tmp_path: Path) -> None:
    path = tmp_path / "curve.csv"
    save_averaged_spectrum(curve_of(SPEECH, COARSE, "old"), path)
    with refused(tmp_path, events={"os.rename"}), pytest.raises(CurveError, match="No space left on device"):
        save_averaged_spectrum(curve_of(SPEECH, COARSE, "new"), path)
    assert load_averaged_spectrum(path).name == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_curve_says_since_when_it_was_averaged(tmp_path: Path) -> None:
    average = SpectrumAverage()
    average.add(spectra([1, 2]))
    save_averaged_spectrum(average.curve("a", "bare", "Record at 0.00 s of microphone"), tmp_path / "a.csv")
    assert load_averaged_spectrum(tmp_path / "a.csv").since == "Record at 0.00 s of microphone"
    save_averaged_spectrum(average.curve("a", "bare"), tmp_path / "old.csv")
    assert load_averaged_spectrum(tmp_path / "old.csv").since == ""


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"high_pass_end": 151.0}, "high_pass 100-151 Hz"),
        ({"window_function": WindowFunction.HANN}, "window hann"),
        ({"time_smooth": 0.5}, "time_smooth 0.5"),
        ({"denoise_threshold": 1e-4}, "denoise 0.0001"),
        ({"mel_bands": 24}, "mel 24 bands"),
        ({"pre_emphasis": 0.9}, "pre_emphasis 0.9"),
    ],
)
def test_a_front_end_is_described_with_all_that_shapes_a_spectrum(change: dict[str, object], words: str) -> None:
    everything = AnalysisSettings(filters=frozenset(Filter))
    changed = replace(everything, **change)
    assert words in changed.front_end().split(", ")
    assert changed.front_end() != everything.front_end()
    without = frozenset(f for f in Filter if words.split(maxsplit=1)[0] not in f.value)
    assert words not in replace(changed, filters=without).front_end()
