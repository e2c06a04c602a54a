"""Sounds that are turned into files: as the commands do it, whole or not at all."""

import shutil
from pathlib import Path

import pytest

import phonemeanalyser
from phonemeanalyser.__main__ import main
from phonemeengine import (
    FORMATS,
    AudioError,
    Cancelled,
    ExportError,
    ExportOptions,
    MouthError,
    convert,
    convert_all,
    load_preset,
    words_of,
)
from phonemeengine.conversion.work import CONVERSIONS, check_options, targets_of

DEMO = Path(phonemeanalyser.__file__).parent / "demo" / "demo.flac"
PRESET = load_preset("thesis")


@pytest.mark.parametrize(
    ("kind", "command"),
    [
        ("phonemes-csv", ["analyse", "--format", "csv"]),
        ("phonemes-textgrid", ["analyse", "--format", "textgrid"]),
        ("frames-json", ["analyse", "--format", "json", "--features"]),
        ("rhubarb-json", ["export", "--format", "rhubarb-json"]),
        ("livelink-csv", ["export", "--format", "livelink-csv"]),
    ],
)
def test_it_is_what_the_command_writes(tmp_path: Path, kind: str, command: list[str]) -> None:
    ending = CONVERSIONS[kind].ending
    convert(DEMO, tmp_path / f"api{ending}", kind, PRESET)
    name, *options = command
    assert main([name, str(DEMO), *options, "--preset", "thesis", "-o", str(tmp_path / f"cli{ending}")]) == 0
    assert (tmp_path / f"api{ending}").read_bytes() == (tmp_path / f"cli{ending}").read_bytes()


@pytest.mark.parametrize("name", ["livelink-csv", "textgrid"])
def test_a_text_says_the_same_to_the_command(tmp_path: Path, name: str) -> None:
    text, api, cli = "hello world", tmp_path / "api", tmp_path / "cli"
    convert(DEMO, api, name, PRESET, script=words_of(text, "en-us"))
    words = ["--format", name, "--text", text, "--language", "en-us", "--preset", "thesis"]
    assert main(["export", str(DEMO), *words, "-o", str(cli / DEMO.with_suffix(FORMATS[name].full_ending).name)]) == 0
    assert [path.read_bytes() for path in cli.iterdir()] == [api.read_bytes()]


def test_a_table_of_frames_takes_no_words(tmp_path: Path) -> None:
    with pytest.raises(ExportError, match="no place for words"):
        convert(DEMO, tmp_path / "x.csv", "frames-csv", PRESET, script=words_of("hello", "en-us"))


def test_what_a_program_made_in_a_folder_the_command_does_not_make_again(tmp_path: Path, sound: Path) -> None:
    sounds, out = tmp_path / "sounds", tmp_path / "out"
    sounds.mkdir()
    copy = shutil.copy(sound, sounds)
    assert convert_all([copy], out, "rhubarb-json", PRESET) == {}
    (made,) = out.glob("*.json")
    before = made.stat().st_mtime_ns
    words = ["export", str(sounds), "--format", "rhubarb-json", "-o", str(out)]
    assert main([*words, "--preset", "thesis"]) == 0
    assert made.stat().st_mtime_ns == before
    assert main([*words, "--preset", "extended"]) == 1  # it is other work's


def test_all_kinds_are_told_apart() -> None:
    assert {"phonemes-csv", "frames-csv", "rhubarb-tsv", "gltf"} <= set(CONVERSIONS)
    assert len({(c.words, c.ending) for c in CONVERSIONS.values()}) == len(CONVERSIONS)


def test_a_folder_is_made_and_our_own_file_is_replaced(tmp_path: Path) -> None:
    target = tmp_path / "deep" / "er" / "x.csv"
    convert(DEMO, target, "phonemes-csv", PRESET)
    first = target.read_bytes()
    convert(DEMO, target, "phonemes-csv", PRESET)
    assert target.read_bytes() == first


@pytest.mark.parametrize("kind", CONVERSIONS)
def test_a_file_of_others_or_with_other_settings_stays_in_every_format(
    kind: str, sound: Path, tmp_path: Path
) -> None:
    target = tmp_path / f"x{CONVERSIONS[kind].ending}"
    target.write_text("a diary")
    with pytest.raises(ExportError, match="is left alone"):
        convert(sound, target, kind, PRESET)
    assert target.read_text() == "a diary"
    convert(sound, target, kind, PRESET, overwrite=True)
    ours = target.read_bytes()
    convert(sound, target, kind, PRESET)
    with pytest.raises(ExportError, match="is left alone"):
        convert(sound, target, kind, load_preset("extended"))
    assert target.read_bytes() == ours


def test_what_is_refused_leaves_what_was_there(tmp_path: Path) -> None:
    target = tmp_path / "mine.csv"
    target.write_text("a diary")
    with pytest.raises(ExportError, match="made in another way, so it is left alone"):
        convert(DEMO, target, "phonemes-csv", PRESET)
    convert(DEMO, tmp_path / "ours.csv", "phonemes-csv", PRESET)
    with pytest.raises(Cancelled):
        convert(DEMO, tmp_path / "ours.csv", "phonemes-csv", PRESET, progress=lambda _: False)
    with pytest.raises(AudioError):
        convert(tmp_path / "no.wav", tmp_path / "no.csv", "phonemes-csv", PRESET)
    with pytest.raises(ExportError, match=r"cannot be written .*; choose another place"):
        convert(DEMO, target / "x.csv", "phonemes-csv", PRESET)
    assert target.read_text() == "a diary"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["mine.csv", "ours.csv"]
    convert(DEMO, target, "phonemes-csv", PRESET, overwrite=True)
    assert target.read_text().startswith("start_s")


def test_impossible_options_are_refused_before_any_sound_is_heard() -> None:
    with pytest.raises(ExportError, match="no kind of file"):
        check_options("mp3", None)
    with pytest.raises(MouthError):
        check_options("rhubarb-json", ExportOptions(table="no such table"))
    check_options("frames-csv", ExportOptions(table="no such table"))  # is not asked


def test_equal_names_are_told_apart(tmp_path: Path) -> None:
    sounds = [tmp_path / "a" / "x.wav", tmp_path / "b" / "x.wav", tmp_path / "b" / "y.wav"]
    names = [target.name for target in targets_of(sounds, tmp_path, ".rhubarb.json").values()]
    assert names == [f"{name}.rhubarb.json" for name in ("x", "x-2", "y")]
    assert targets_of(sounds, None, ".csv")[sounds[1]] == tmp_path / "b" / "x.csv"
