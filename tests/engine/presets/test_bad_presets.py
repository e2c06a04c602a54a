"""Broken preset files are refused in one sentence that says what is wrong."""

from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import PresetError
from phonemeengine.features.variables import Variable
from phonemeengine.presets.document import preset_from_toml, preset_to_toml
from phonemeengine.presets.files import load_preset
from phonemeengine.presets.preset import Preset

GOOD = preset_to_toml(Preset(variables=(Variable("mine", 100.0, 200.0),)))

# name: (what stands in the file, what is put there instead, what the refusal says)
CHANGES = {
    "unknown key": (
        "quantise = 4",
        "quantise = 4\nquantize = 4",
        r"\[front_end\] cannot have an entry 'quantize'; did you mean quantise",
    ),
    "unknown key at the top": (
        "notes = ",
        "author = 'me'\nnotes = ",
        "a preset cannot have an entry 'author'; remove it",
    ),
    "missing key": ("quantise = 4", "", r"\[front_end\] lacks quantise; add it"),
    "missing table": ("[intensity]", "[intensities]", "intensit"),
    "number as text": ("sz_s1 = 15.0", "sz_s1 = '15'", "sz_s1 must be a number within ±3.4e38, found '15'"),
    "switch as text": ("statistics = true", "statistics = 'yes'", "statistics must be true or false, found 'yes'"),
    "broken quantisation": ("quantise = 4", "quantise = 4.0", "quantise must be a whole .* found 4.0; correct it"),
    "impossible quantisation": ("quantise = 4", "quantise = 3", "quantise must be one of 1, 2, 4, got 3"),
    "too many bands": ("mel_bands = 40", "mel_bands = 400", r"mel_bands must lie in 4\.\.80 bands, got 400"),
    "bad choice": ('"plain"', '"folded"', "decimation must be one of plain, anti_aliased, found 'folded'"),
    "bad window": ('"hamming"', '"hammock"', "window_function must be one of rectangle, .*, found 'hammock'"),
    "bad filter": ('"high_pass"', '"de-noise"', "filters must be one of quantise, .*, found 'de-noise'"),
    "out of range": ("minimum_hold = 0.02", "minimum_hold = 3", r"minimum_hold must lie in 0\.\.1 s, got 3"),
    "not a number": ("minimum_hold = 0.02", "minimum_hold = nan", "minimum_hold must be a number .* found nan"),
    "too large": ("sz_s1 = 15.0", "sz_s1 = 1e39", r"sz_s1 must be a number within .*, found 1e\+39"),
    "deep": ("notes = ", "deep = " + "[" * 100_000 + "\n#", "this is no TOML file"),
    "wrong order": ("intensity_low = -45.0", "intensity_low = -1", "intensity_low must not exceed intensity_high"),
    "name as number": ("name = ", "name = 7\n# ", "name must be text, found 7"),
    "unknown recogniser": ('recogniser = "thesis"', 'recogniser = "magic"', "no recogniser named 'magic'"),
    "unknown successor": (
        '[successors]\nsilence = "',
        '[successors]\nsilence = "x',
        r"\[successors\] silence must be one of silence, .*, found 'x",
    ),
    "variable of a built-in name": ('name = "mine"', 'name = "energy"', "energy exists already"),
    "variable with a bad name": ('name = "mine"', 'name = "Mine!"', "name must be lower-case .*, got 'Mine!'"),
    "variable without a range": ("low = 100.0,", "", r"\[variables\] lacks low"),
    "variable with an upside-down range": ("low = 100.0", "low = 300", r"mine must range .* got 300\.\.200 Hz"),
    "variable of a bad kind": (
        'kind = "sum"',
        'kind = "median"',
        "kind must be one of sum, max, mean, found 'median'",
    ),
    "variable of a bad source": ('source = "normalised"', 'source = "x"', "source must be one of raw, .*, found 'x'"),
    "wrong format": ("preset 2", "preset 99", "begins with format = 'phonemeanalyser preset 2', found .* 99"),
    "no format": ("format = ", "# format = ", "begins with format = 'phonemeanalyser preset 2', found none"),
}


@pytest.mark.parametrize(("old", "new", "said"), CHANGES.values(), ids=CHANGES)
def test_a_wrong_preset_is_refused_with_what_is_wrong(old: str, new: str, said: str):
    assert old in GOOD
    with pytest.raises(PresetError, match=said) as refusal:
        preset_from_toml(GOOD.replace(old, new, 1), Path())
    assert len(str(refusal.value)) < 300


def test_two_variables_of_one_name_are_refused():
    twins = """variables = [
    { name = "twin", low = 1, high = 2, kind = "sum", source = "raw" },
    { name = "twin", low = 3, high = 4, kind = "max", source = "mel" },
]
"""
    with pytest.raises(PresetError, match="twin exists already"):
        preset_from_toml(twins + preset_to_toml(Preset()).replace("variables = []", ""), Path())


@given(text=st.text(max_size=100))
def test_any_text_is_refused_as_a_preset_and_never_crashes(text: str):
    with pytest.raises(PresetError):
        preset_from_toml(text, Path())


@given(where=st.integers(0, len(GOOD)), length=st.integers(1, 30), new=st.text("09.-\"'[]=\nax", max_size=6))
def test_a_damaged_preset_is_read_or_refused(where: int, length: int, new: str):
    with suppress(PresetError):
        read = preset_from_toml(GOOD[:where] + new + GOOD[where + length :], Path())
        assert preset_from_toml(preset_to_toml(read), Path()) == read


@pytest.mark.parametrize("suffix", [".toml", ""])
class TestFilesThatAreNone:
    def refusal(self, path: Path) -> str:
        with pytest.raises(PresetError) as refusal:
            load_preset(path)
        assert str(refusal.value).startswith(f"{path.name}: ")
        return str(refusal.value)

    def test_a_missing_file(self, tmp_path: Path, suffix: str):
        assert "there is no such file; check its name and folder" in self.refusal(tmp_path / f"x{suffix}")

    def test_a_folder(self, tmp_path: Path, suffix: str):
        (tmp_path / f"x{suffix}").mkdir()
        assert "this is a folder; choose a file in it" in self.refusal(tmp_path / f"x{suffix}")

    def test_a_binary_file(self, tmp_path: Path, suffix: str):
        path = tmp_path / f"x{suffix}"
        path.write_bytes(bytes(range(256)))
        assert "no text file; choose a .toml or .phonemedata file" in self.refusal(path)

    def test_an_empty_file(self, tmp_path: Path, suffix: str):
        path = tmp_path / f"x{suffix}"
        path.touch()
        assert "found" in self.refusal(path)

    def test_a_huge_file_is_refused_before_it_is_read(self, tmp_path: Path, suffix: str):
        path = tmp_path / f"x{suffix}"
        with path.open("wb") as file:
            file.truncate(10**12)
        assert "has at most 1 MB" in self.refusal(path)


def test_a_broken_phoneme_data_file_says_where(tmp_path: Path):
    path = tmp_path / "mine.phonemedata"
    path.write_text("0,0,5,7\nzero")
    with pytest.raises(
        PresetError, match=r"^mine\.phonemedata: line 2: denoise_threshold must be a number, found 'zero'"
    ):
        load_preset(path)


def test_phoneme_data_with_an_impossible_filter_is_refused(tmp_path: Path):
    path = tmp_path / "mine.phonemedata"
    path.write_text("2,0,5,7,0\n" + "1," * 16)
    with pytest.raises(PresetError, match=r"^mine\.phonemedata: time_smooth must lie in 0\.\.1, got 2"):
        load_preset(path)
