"""Presets: what was saved is what is loaded, and the old PhonemeData files come in and go out."""

import stat
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import PresetError, SettingsError
from phonemeengine.features.variables import BUILT_IN_NAMES, Kind, Spectrum, Variable
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.document import preset_from_toml, preset_to_toml
from phonemeengine.presets.files import load_preset, preset_entries, save_preset
from phonemeengine.presets.preset import Judgement, Preset
from phonemeengine.recognition.rules import PhonemeData, Thresholds
from phonemeengine.settings import BIN_WIDTH, PARAMETERS, RANGES, AnalysisSettings, Decimation, Filter, WindowFunction
from tests.disks import refused

COUNTING = "0.5,0.25,3,4,0.125\n6,7,8,9\n10,11\n12,13,14,15\n16,17\n18,19,20,21\n"
ROUND_HERTZ = ("high_pass_start", "high_pass_end")


@st.composite
def all_settings(draw) -> AnalysisSettings:
    values = {name: draw(st.floats(of.low, of.high)) for name, of in PARAMETERS.items() if not of.choices}
    values["mel_bands"] = int(values["mel_bands"])
    for name in ROUND_HERTZ:
        values[name] = round(values[name], 6)
    for lower, upper in RANGES:
        values[lower], values[upper] = sorted((values[lower], values[upper]))
    return AnalysisSettings(
        filters=draw(st.frozensets(st.sampled_from(Filter))),
        quantise=draw(st.sampled_from([1, 2, 4])),
        decimation=draw(st.sampled_from(Decimation)),
        window_function=draw(st.sampled_from(WindowFunction)),
        statistics=draw(st.booleans()),
        **values,
    )


@st.composite
def all_variables(draw) -> tuple[Variable, ...]:
    free = st.from_regex(r"[a-z][a-z0-9_]{0,12}", fullmatch=True).filter(lambda name: name not in BUILT_IN_NAMES)
    names = draw(st.lists(free, max_size=5, unique=True))
    ranges = [sorted(draw(st.tuples(*[st.floats(0, 22_050)] * 2))) for _ in names]
    kinds = [(draw(st.sampled_from(Kind)), draw(st.sampled_from(Spectrum))) for _ in names]
    return tuple(Variable(n, *r, *k) for n, r, k in zip(names, ranges, kinds, strict=True))


finite = st.floats(-3e38, 3e38)
words = st.text(st.characters(exclude_categories=("Cs",), exclude_characters="\r"), max_size=60)
all_presets = st.builds(
    Preset,
    name=words,
    settings=all_settings(),
    thresholds=st.builds(Thresholds, **{f.name: finite for f in fields(Thresholds)}),
    variables=all_variables(),
    recogniser=st.just("thesis"),
    successors=st.fixed_dictionaries(dict.fromkeys(Phoneme, st.sampled_from(Phoneme))),
    notes=words,
)


@given(preset=all_presets)
def test_what_was_saved_is_what_is_loaded(preset: Preset):
    assert preset_from_toml(preset_to_toml(preset), Path()) == preset


@given(hertz=st.floats(0, 22_050))
def test_a_frequency_that_is_not_round_comes_back_to_fifteen_digits(hertz: float):
    preset = Preset(settings=AnalysisSettings(high_pass_start=hertz, high_pass_end=22_050))
    back = preset_from_toml(preset_to_toml(preset), Path())
    assert back.settings.high_pass_start == pytest.approx(hertz, rel=1e-14)
    assert preset_from_toml(preset_to_toml(back), Path()) == back


@pytest.mark.parametrize("suffix", [".toml", ".TOML"])
def test_a_preset_file_is_the_preset(tmp_path: Path, suffix: str):
    mine = Variable("mine", 100, 200, Kind.MEAN, Spectrum.RAW)
    preset = Preset("Grüße 👄", notes='two\nlines, "quoted" \\ and so on', variables=(mine,))
    path = tmp_path / f"mine{suffix}"
    save_preset(preset, path)
    assert load_preset(path) == preset
    assert "21.53" not in path.read_text(encoding="utf-8")


def test_a_toml_preset_with_a_byte_order_mark_and_crlf_is_read(tmp_path: Path):
    path = tmp_path / "windows.toml"
    path.write_bytes(b"\xef\xbb\xbf" + preset_to_toml(Preset()).replace("\n", "\r\n").encode())
    assert load_preset(path) == Preset()


def test_a_preset_names_all_twenty_one_numbers():
    text = preset_to_toml(Preset())
    assert all(f"\n{f.name} = " in text for f in fields(PhonemeData))


def test_phoneme_data_counts_the_high_pass_in_bins(tmp_path: Path):
    path = tmp_path / "old.phonemedata"
    path.write_text(COUNTING)
    preset = load_preset(path)
    assert preset.settings.high_pass_start == pytest.approx(3 * BIN_WIDTH)
    assert preset.settings.high_pass_end == pytest.approx(4 * BIN_WIDTH)
    assert preset.phoneme_data.high_pass_start == pytest.approx(3)


def test_phoneme_data_was_tuned_with_the_front_end_of_the_thesis(tmp_path: Path):
    """Quantise 4 without a filter before it; both blurs and denoise act where their numbers are above 0."""
    path = tmp_path / "old.phonemedata"
    path.write_text(COUNTING)
    preset = load_preset(path)
    settings = preset.settings
    assert (settings.step, settings.decimation, settings.n_bins) == (4, Decimation.PLAIN, 256)
    assert settings.window_in_force is WindowFunction.RECTANGLE
    assert settings.filters == AnalysisSettings().filters | {
        Filter.TIME_SMOOTH,
        Filter.FREQUENCY_SMOOTH,
        Filter.DENOISE,
    }
    assert (settings.minimum_hold, settings.hysteresis, preset.variables) == (0.02, 0.0, ())
    assert (settings.time_smooth, settings.frequency_smooth, settings.denoise_threshold) == (0.5, 0.25, 0.125)
    assert preset.name == "old"
    assert [getattr(preset.thresholds, f.name) for f in fields(Thresholds)] == list(range(6, 22))


def test_phoneme_data_goes_in_and_out_unchanged(tmp_path: Path):
    for name in ("old.phonemedata", "old.txt"):
        path = tmp_path / name
        path.write_text(COUNTING)
        save_preset(load_preset(path), path)
        assert path.read_text() == COUNTING


bins = st.floats(0, 1024, width=32)


@given(bounds=st.tuples(bins, bins))
def test_bins_come_back_bit_by_bit_at_float_precision(bounds: tuple[float, float]):
    start, end = sorted(bounds)
    data = PhonemeData(high_pass_start=start, high_pass_end=end)
    back = Preset().with_phoneme_data(data).phoneme_data
    assert np.float32(back.high_pass_start) == np.float32(start)
    assert np.float32(back.high_pass_end) == np.float32(end)


def test_a_file_that_cannot_be_written_leaves_the_old_one(tmp_path: Path):
    path = tmp_path / "mine.toml"
    save_preset(Preset("old"), path)
    refusal = pytest.raises(PresetError, match=r"mine\.toml: cannot be written \(No space left on device\)")
    with refused(tmp_path, events={"os.rename"}), refusal:
        save_preset(Preset("new"), path)
    assert load_preset(path).name == "old"
    assert [p.name for p in tmp_path.iterdir()] == ["mine.toml"]


def test_a_preset_saved_where_no_folder_is_is_refused(tmp_path: Path):
    with pytest.raises(PresetError, match=r"x\.toml: cannot be written"):
        save_preset(Preset(), tmp_path / "nowhere" / "x.toml")


def test_a_preset_is_never_saved_over_a_folder(tmp_path: Path):
    (tmp_path / "x.toml").mkdir()
    with pytest.raises(PresetError, match=r"x\.toml: cannot be written"):
        save_preset(Preset(), tmp_path / "x.toml")
    assert [p.name for p in tmp_path.iterdir()] == ["x.toml"]


def test_others_may_read_a_saved_preset_as_any_file(tmp_path: Path):
    save_preset(Preset(), tmp_path / "preset.toml")
    (tmp_path / "any.txt").write_text("any")
    modes = {stat.S_IMODE(p.stat().st_mode) for p in tmp_path.iterdir()}
    assert len(modes) == 1


def test_a_name_from_a_badly_encoded_file_can_be_saved(tmp_path: Path):
    save_preset(Preset("caf\udce9"), tmp_path / "x.toml")
    assert load_preset(tmp_path / "x.toml").name == "caf?"


@pytest.mark.parametrize("change", [{"recogniser": "magic"}, {"variables": (Variable("energy", 0, 1),)}])
def test_an_impossible_preset_cannot_be_made(change: dict[str, object]):
    with pytest.raises((PresetError, SettingsError)):
        replace(Preset(), **change)


JUDGED = Judgement("Learned", "2026-11-25", 4.25, False, (0.71, 0.76), (0.625, 0.7))


def test_what_a_preset_was_judged_by_is_saved_and_shown_in_lists(tmp_path: Path):
    path = tmp_path / "mine.toml"
    save_preset(Preset("mine", judged=JUDGED, notes="Of the factory."), path)
    preset = load_preset(path)
    assert preset.judged == JUDGED
    said = "Learned, own voice, 2026-11-25: mouth shapes 71 to 76 % on held-out speech"
    assert preset.summary == said
    assert [entry.summary for entry in preset_entries([path])] == [said]
    save_preset(replace(preset, judged=replace(JUDGED, changed=True)), path)
    assert load_preset(path).summary == f"{said}, changed since"


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('day = "2026-11-25"', 'day = "yesterday"', "day is a date such as 2026-11-25, found 'yesterday'"),
        ("seconds = 4.25", "seconds = []", r"\[judged\] seconds must be a number"),
        ("seconds = 4.25", "", r"\[judged\] lacks seconds"),
        ("0.76", "76", r"\[judged\] mouth_shapes must be two shares 0..1"),
    ],
)
def test_a_damaged_judgement_is_refused_and_left_out_of_lists(tmp_path: Path, old: str, new: str, said: str):
    path = tmp_path / "mine.toml"
    save_preset(Preset("mine", judged=JUDGED, notes="My notes."), path)
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))
    with pytest.raises(PresetError, match=said):
        load_preset(path)
    assert [entry.summary for entry in preset_entries([path])] == ["My notes."]
